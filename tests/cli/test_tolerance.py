"""``strainwave tolerance``: what it prints and writes, and how it stops."""

from __future__ import annotations

import json
import os
import pty
import re
import select
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.cli.command import run
from tests.designs import CASE_STUDY
from tests.studies.tolerance.runs import FILE

DESIGN = CASE_STUDY / "cosine-calibrated.toml"
COMMAND = Path(sys.executable).with_name("strainwave")
QUICK = ["--samples", "256", "--sobol-samples", "64"]
PAGE = (CASE_STUDY.parent.parent / "docs" / "commands" / "tolerance.md").read_text(encoding="utf-8")


def test_the_report_begins_with_the_yield(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "tolerance", DESIGN, FILE, *QUICK, "--csv", tmp_path / "samples.csv")
    assert (outcome.code, outcome.err) == (0, "")
    lines = outcome.out.splitlines()
    assert lines[0] == "Case study, cosine cam, calibrated; Series production"
    assert re.match(r"YIELD \d\d\.\d\d % without interference in motion \(95 % interval ", lines[1])
    rows = (tmp_path / "samples.csv").read_text().splitlines()
    assert len(rows) == 257
    least = [float(row.split(",")[-2]) for row in rows[1:]]
    passed = sum(value >= 0.0 for value in least)
    assert f"samples  {passed} of 256 without interference, seed 1" in outcome.out
    assert f"YIELD {100 * passed / 256:.2f} %" in outcome.out
    assert re.search(r"flexspline.profile.offset +−1.000 +µm per µm +0.440", outcome.out)


def test_json_has_documented_keys(capsys: pytest.CaptureFixture[str]) -> None:
    record = json.loads(run(capsys, "tolerance", DESIGN, FILE, *QUICK, "--json").out)
    keys = [*record, *record["samples"], *record["parameters"][0], *record["yield"], *record["min_in_motion_um"]]
    keys += [*record["contact"], *record["sensitivities"][0], *record["sobol"], *record["sobol"]["min_in_motion_um"][0]]
    for key in keys:
        assert f"`{key}`" in PAGE, key
    assert record["min_in_motion_um"]["nominal"] == pytest.approx(1.491, abs=1e-3)
    assert list(record["min_in_motion_um"]["percentiles"])[:3] == ["0.1", "1", "5"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([DESIGN], "Missing argument 'TOLERANCES'"),
        ([DESIGN, "none.toml"], "none.toml: there is no such file"),
        (["none.toml", FILE], "none.toml: there is no such file"),
        ([DESIGN, DESIGN], "cosine-calibrated.toml: "),
        ([DESIGN, FILE, "--samples", "1"], "samples must be a whole number from 64"),
        ([DESIGN, FILE, "--plot", "a.gif"], "must end in .png, .svg or .pdf"),
        ([DESIGN, FILE, "--csv", "/no/such/place/a"], "there is no directory"),
    ],
)
def test_wrong_usage(arguments: list[object], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "tolerance", *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err
    assert "Traceback" not in outcome.err


def test_a_tolerance_of_nothing_names_the_tolerance_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "bad.toml"
    file.write_text('[[tolerances]]\nparameter = "wave_generator.w1"\nkind = "normal"\nsigma = 1\n')
    outcome = run(capsys, "tolerance", DESIGN, file)
    assert outcome.code == 2
    assert outcome.err.startswith(f"strainwave: {file}: tolerances[0].parameter = ")
    assert outcome.err.count("\n") == 1


def test_a_design_without_geometry_names_the_design_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bad = tmp_path / "bad.toml"
    bad.write_text(DESIGN.read_text(encoding="utf-8").replace("w0 = 0.848", "w0 = 30.0"), encoding="utf-8")
    outcome = run(capsys, "tolerance", bad, FILE)
    assert outcome.code == 2
    assert outcome.err.startswith(f"strainwave: {bad}: wave_generator.w0 = 30")


def test_ctrl_c_keeps_the_samples_in_report_and_file(tmp_path: Path) -> None:
    """Sent from the terminal once the bar shows samples."""
    ours, theirs = pty.openpty()
    arguments = ["--samples", "300000", "--csv", "kept.csv"]
    with subprocess.Popen(
        # A shell that runs the tests in the background has them, and what they start, ignore the interrupt.
        ["env", "--default-signal=INT", COMMAND, "tolerance", DESIGN, FILE, *arguments],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=theirs,
        text=True,
    ) as running:
        os.close(theirs)
        shown = read_until(ours, re.compile(r"[1-9]%"))
        running.send_signal(signal.SIGINT)
        shown += read_until(ours, re.compile("interrupted"))
        if "interrupted" not in shown:
            running.kill()
        assert running.stdout is not None
        out = running.stdout.read()
    os.close(ours)
    assert running.returncode == 130
    assert "strainwave: interrupted" in shown
    assert "Traceback" not in shown
    done = re.search(r"interrupted after (\d+) of 524288 samples, which are kept", out)
    assert done is not None
    assert (tmp_path / "kept.csv").read_text().count("\n") == int(done[1]) + 1
    assert [path.name for path in tmp_path.iterdir()] == ["kept.csv"]


def read_until(terminal: int, text: re.Pattern[str], patience_s: float = 60.0) -> str:
    """What a terminal shows until it has shown the text."""
    shown, end = "", time.monotonic() + patience_s
    while not text.search(shown) and time.monotonic() < end:
        if select.select([terminal], [], [], 0.1)[0]:
            try:
                shown += os.read(terminal, 4096).decode(errors="replace")
            except OSError:  # the other end is closed
                break
    return shown


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_full_disk_costs_neither_the_report_nor_the_other_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    outcome = run(capsys, "tolerance", DESIGN, FILE, *QUICK, "--csv", "/dev/full", "--plot", tmp_path / "a.png")
    assert outcome.code == 2
    assert outcome.err == "strainwave: /dev/full: cannot be written: No space left on device\n"
    assert "YIELD" in outcome.out
    assert [path.name for path in tmp_path.iterdir()] == ["a.png"]


def test_the_report_says_where_percentiles_are_bounds(capsys: pytest.CaptureFixture[str]) -> None:
    deep = run(capsys, "tolerance", CASE_STUDY / "dual-disk-0848.toml", FILE, *QUICK).out
    assert deep.splitlines()[1].startswith("YIELD 0.00 %")
    assert "percentiles of the least backlash below −5 µm are upper bounds" in deep
    assert "upper bounds" not in run(capsys, "tolerance", DESIGN, FILE, *QUICK).out
