"""``strainwave tune``: what it prints, writes and refuses."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from strainwave.design import load, save
from strainwave.studies import tune
from tests.cli.command import run
from tests.designs import CASE_STUDY
from tests.studies.small import small

DUAL_DISK = CASE_STUDY / "dual-disk-0848-calibrated.toml"
COSINE = CASE_STUDY / "cosine.toml"


@pytest.fixture
def design(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A design that is quick to tune."""
    file = tmp_path_factory.mktemp("designs") / "small.toml"
    save(small("dual-disk-0848-calibrated"), file)
    return file


def test_the_report_says_what_w0_alone_can_do(capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, "tune", DUAL_DISK).out.splitlines()
    assert lines[1] == "dual-disk, its own w0 0.848 mm: INTERFERENCE in motion, 14.62 µm deep"
    assert lines[2].startswith("VIABLE with w0 from 0.8688")
    text = " ".join(" ".join(lines).split())
    assert "in steps of 1 µm; a window narrower than that may be missed" in text
    found = tune(load(DUAL_DISK))
    for goal, choice in found.best.items():
        row = next(line.split() for line in lines if line.startswith(goal))
        below = choice.analysis.teeth_below
        assert row[1] == f"{choice.w0_mm:.6f}"
        assert row[2] == f"{choice.analysis.min_in_motion_um:.2f}"
        assert row[4:7] == [f"{below.per_side}", "/", f"{below.lobe}"]


def test_without_a_window_it_says_how_near_one_is(capsys: pytest.CaptureFixture[str]) -> None:
    out = run(capsys, "tune", COSINE).out
    assert "NO WINDOW: teeth interfere at every w0 from 0.4 to 1.2 mm" in out
    assert "nearest to a window: about 0." in out
    assert "best for" not in out


def test_json_csv_picture_and_the_tuned_design(
    design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    csv, plot, tuned = tmp_path / "scan.csv", tmp_path / "w0.svg", tmp_path / "tuned.toml"
    outcome = run(
        capsys, "tune", design, "--json", "--csv", csv, "--plot", plot, "--goal", "power", "--out", tuned,
        "--margin", 0.2, "--threshold", 8,
    )  # fmt: skip
    found = tune(load(design), margin_um=0.2, threshold_um=8.0)
    assert (outcome.code, outcome.err) == (0, "")
    assert json.loads(outcome.out) == json.loads(found.to_json())
    assert csv.read_text(encoding="utf-8") == found.scan.csv_text()
    assert plot.read_text(encoding="utf-8").startswith("<?xml")
    assert load(tuned) == found.design_for("power")
    assert run(capsys, "analyze", tuned, "--check").code == 0


def test_a_design_that_cannot_be_tuned_is_reported_and_not_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    outcome = run(capsys, "tune", COSINE, "--out", tmp_path / "tuned.toml", "--csv", tmp_path / "scan.csv")
    assert outcome.code == 2
    assert "NO WINDOW" in outcome.out
    assert outcome.err.startswith("strainwave: no w0 keeps a minimum of 0.1 µm in motion")
    assert [path.name for path in tmp_path.iterdir()] == ["scan.csv"]


def test_a_full_disk_loses_nothing(design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The report is printed and the other files are written; the one that finds no room is named, and not there."""
    full, csv = tmp_path / "full.png", tmp_path / "scan.csv"
    full.symlink_to("/dev/full")
    outcome = run(capsys, "tune", design, "--plot", full, "--csv", csv)
    assert outcome.code == 2
    assert outcome.err == f"strainwave: {full}: cannot be written: No space left on device\n"
    assert "VIABLE with w0" in outcome.out
    assert csv.read_text(encoding="utf-8").count("\n") == 202
    assert sorted(path.name for path in tmp_path.iterdir()) == ["full.png", "scan.csv"]


def test_a_full_output_costs_no_file(design: Path, tmp_path: Path) -> None:
    command = Path(sys.executable).parent / "strainwave"
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [command, "tune", design, "--csv", tmp_path / "scan.csv"],
            stdout=full, stderr=subprocess.PIPE, text=True, check=False,
        )  # fmt: skip
    assert (done.returncode, done.stderr) == (2, "strainwave: the output cannot be written: No space left on device\n")
    assert (tmp_path / "scan.csv").read_text(encoding="utf-8").count("\n") == 202


def test_an_interrupt_leaves_no_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("strainwave.studies.tuning.window.motion_at", interrupted)
    outcome = run(capsys, "tune", DUAL_DISK, "--csv", tmp_path / "scan.csv", "--out", tmp_path / "tuned.toml")
    assert (outcome.code, outcome.out, outcome.err) == (130, "", "strainwave: interrupted\n")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--margin", "-1"], "the margin must be a number of micrometres from 0, not -1"),
        (["--threshold", "0"], "the threshold must be a positive number of micrometres, not 0"),
        (["--goal", "speed"], "'--goal'"),
        (["--threads", "-1"], "threads must be a whole number from 0"),
        (["--out", "/no/such/place/a.toml"], "there is no directory /no/such/place"),
        (["--csv", "/no/such/place/a.csv"], "there is no directory /no/such/place"),
        (["--plot", "a.gif"], "a picture's name must end in .png, .svg or .pdf"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "tune", DUAL_DISK, *arguments)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err
