"""``strainwave optimize``: what it prints and writes, and how it stops."""

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

from strainwave.analysis import analyze
from strainwave.design import load
from tests.cli.command import run
from tests.designs import CASE_STUDY

COSINE = CASE_STUDY / "cosine.toml"
COMMAND = Path(sys.executable).with_name("strainwave")
VARY = ["--vary", "wave_generator.w0=0.80:0.90", "--vary", "flexspline.profile.offset=-0.02:0"]
QUICK = [*VARY, "--require", "minimum-backlash=0.5:3", "--generations", "10"]
PAGE = (CASE_STUDY.parent.parent / "docs" / "commands" / "optimize.md").read_text(encoding="utf-8")


def test_the_report_says_what_was_found_and_what_moved(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "optimize", COSINE, *QUICK, "--out", tmp_path / "found", "--csv", tmp_path / "found.csv")
    assert (outcome.code, outcome.err) == (0, "")
    lines = outcome.out.splitlines()
    assert lines[0] == "Case study, cosine cam"
    assert lines[1] == "teeth-below 39 teeth"
    best = load(tmp_path / "found" / "best.toml")
    moved = next(line.split() for line in lines if line.startswith("wave_generator.w0"))
    assert float(moved[2]) == pytest.approx(best.wave_generator.w0, abs=1e-7)
    assert float(moved[3].replace("−", "-")) == pytest.approx(best.wave_generator.w0 - 0.848, abs=1e-7)
    assert re.search(rf"minimum-backlash +−5.71 +{analyze(best).min_in_motion_um:.2f} +µm", outcome.out)
    assert (tmp_path / "found.csv").read_text().count("\n") == 2


def test_a_front_lists_its_designs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    goals = ["--objective", "minimum-backlash=max", "--objective", "teeth-below"]
    outcome = run(capsys, "optimize", COSINE, *VARY, *goals, "--generations", "10", "--out", tmp_path / "front")
    assert "designs on the Pareto front; the first is the best in minimum-backlash" in outcome.out
    assert load(tmp_path / "front" / "front-01.toml").module == 0.8


def test_json_has_documented_keys_and_the_same_answer(capsys: pytest.CaptureFixture[str]) -> None:
    record = json.loads(run(capsys, "optimize", COSINE, *QUICK, "--json").out)
    (design,) = record["designs"]
    assert record["schema_version"] == 1
    assert 0.5 <= design["figures"]["min_in_motion_um"] <= 3.0
    keys = [*record, *record["search"], *record["parameters"][0], *record["objectives"][0], *record["requirements"][0]]
    for key in [*keys, *design, *design["figures"]]:
        assert f"`{key}`" in PAGE, key


@pytest.mark.parametrize(("range_", "ends"), [(":3", (0.0, 3.0)), ("-inf:3", (None, 3.0)), (":", (0.0, None))])
def test_only_an_explicit_end_replaces_that_of_no_interference(
    range_: str, ends: tuple[float | None, float | None], capsys: pytest.CaptureFixture[str]
) -> None:
    required = ["--require", f"minimum-backlash={range_}", "--generations", "1"]
    (backlash, tips) = json.loads(run(capsys, "optimize", COSINE, *VARY, *required, "--json").out)["requirements"]
    assert (backlash["figure"], backlash["low"], backlash["high"]) == ("minimum-backlash", *ends)
    assert (tips["figure"], tips["low"], tips["high"]) == ("tip-clearance", 0.0, None)


def test_force_costs_no_design_but_those_of_an_earlier_search(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    gear, other, found = (tmp_path / name for name in ("my-gear.toml", "other.toml", "found"))
    for mine in (gear, other):
        mine.write_text(COSINE.read_text(encoding="utf-8"), encoding="utf-8")
    quick = ["optimize", gear, *QUICK, "--force"]
    monkeypatch.chdir(tmp_path)
    for place in (".", tmp_path):
        outcome = run(capsys, *quick, "--out", place)
        assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
        assert "holds my-gear.toml and 1 more, which would be lost; nothing was written." in outcome.err
    assert sorted(path.name for path in tmp_path.iterdir()) == [gear.name, other.name]
    assert [run(capsys, *quick, "--out", found).code for _ in range(2)] == [0, 0]
    assert [path.name for path in found.iterdir()] == ["best.toml"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "Missing option '--vary'"),
        (["--vary", "wave_generator.w0"], "must have the form NAME=LOW:HIGH"),
        (["--vary", "wave_generator.w0=1:2:3"], "must have the form NAME=LOW:HIGH"),
        (["--vary", "module=0.7:0.8", "--vary", "module=0.8:0.9"], "module is given twice"),
        (["--vary", "wave_generator.w1=0.8:0.9"], "wave_generator.w1"),
        (["--vary", "module=0.9:0.8"], "must be below the upper end"),
        ([*VARY, "--objective", "beauty"], "'beauty' is no figure"),
        ([*VARY, "--require", "play=a:b"], "play: 'a' must be a number"),
        ([*VARY, "--require", "play=nan:"], "play: 'nan' must be a number"),
        ([*VARY, "--population", "1"], "population must be a whole number from 8"),
        ([*VARY, "--plot", "a.gif"], "must end in .png, .svg or .pdf"),
        ([*VARY, "--out", "/no/such/place/a"], "there is no directory"),
        ([*VARY, "--require", "minimum-backlash=400:", "--generations", "2"], "none of 128 designs in the ranges"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "optimize", COSINE, *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err
    assert outcome.err.count("\n") == 1


@pytest.mark.parametrize("option", ["--csv", "--plot", "--out"])
def test_nothing_is_searched_where_the_answer_could_not_be_written(
    option: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("strainwave.studies.optimization.optimize", None)
    (tmp_path / "a.png").write_text("mine")
    outcome = run(capsys, "optimize", COSINE, *QUICK, option, tmp_path / "a.png")
    assert outcome.code == 2
    assert "nothing was written" in outcome.err
    assert (tmp_path / "a.png").read_text() == "mine"


def test_ctrl_c_keeps_the_best_so_far_in_report_and_files(tmp_path: Path) -> None:
    """Sent from the terminal once the bar says that there is something to keep."""
    ours, theirs = pty.openpty()
    arguments = [*VARY, "--generations", "100000", "--out", "kept", "--csv", "kept.csv"]
    with subprocess.Popen(
        # A shell that runs the tests in the background has them, and what they start, ignore the interrupt.
        ["env", "--default-signal=INT", COMMAND, "optimize", COSINE, *arguments],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=theirs,
        text=True,
    ) as running:
        os.close(theirs)
        shown = read_until(ours, "teeth-below")
        running.send_signal(signal.SIGINT)
        shown += read_until(ours, "interrupted")
        if "interrupted" not in shown:
            running.kill()
        assert running.stdout is not None
        out = running.stdout.read()
    os.close(ours)
    assert running.returncode == 130
    assert "strainwave: interrupted" in shown
    assert "Traceback" not in shown
    assert re.search(r"interrupted after generation \d+ of 100000: the best so far", out)
    assert not analyze(load(tmp_path / "kept" / "best.toml")).interference
    assert sorted(path.name for path in tmp_path.iterdir()) == ["kept", "kept.csv"]


def read_until(terminal: int, text: str, patience_s: float = 60.0) -> str:
    """What a terminal shows until it has shown the text."""
    shown, end = "", time.monotonic() + patience_s
    while text not in shown and time.monotonic() < end:
        if select.select([terminal], [], [], 0.1)[0]:
            try:
                shown += os.read(terminal, 4096).decode(errors="replace")
            except OSError:  # the other end is closed
                break
    return shown


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_full_output_costs_no_file(tmp_path: Path) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [COMMAND, "optimize", COSINE, *QUICK, "--out", "kept", "--csv", "kept.csv"],
            cwd=tmp_path, stdout=full, stderr=subprocess.PIPE, text=True, check=False,
        )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr == "strainwave: the output cannot be written: No space left on device\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["kept", "kept.csv"]


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_file_on_a_full_disk_costs_neither_the_report_nor_the_other_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    outcome = run(capsys, "optimize", COSINE, *QUICK, "--csv", "/dev/full", "--out", tmp_path / "kept")
    assert outcome.code == 2
    assert outcome.err == "strainwave: /dev/full: cannot be written: No space left on device\n"
    assert "teeth-below 39 teeth" in outcome.out
    assert not analyze(load(tmp_path / "kept" / "best.toml")).interference
