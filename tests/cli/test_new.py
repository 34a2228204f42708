"""``strainwave new`` with a ratio and a size: the file it writes, what it says, what it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.design import load, loads
from strainwave.studies import propose
from tests.cli.command import run

ASKED = ["--ratio", "100", "--pitch-diameter", "60"]


def test_it_writes_a_design_that_has_no_interference_and_says_why(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "gear.toml"
    outcome = run(capsys, "new", *ASKED, "--out", file)
    expected = propose(100, 60)
    assert (outcome.code, outcome.err) == (0, "")
    assert file.read_text(encoding="utf-8") == expected.toml()
    assert outcome.out.splitlines()[1].startswith("NO INTERFERENCE in motion, least gap 0.7")
    said = " ".join(outcome.out.split())
    for reason in expected.reasons:
        assert f"{reason.what} {reason.chosen}" in said
    assert outcome.out.endswith(f"{file}: a design to start from; next: strainwave analyze {file}\n")
    assert run(capsys, "analyze", file, "--check").code == 0


def test_without_a_file_it_prints_the_design(capsys: pytest.CaptureFixture[str]) -> None:
    out = run(capsys, "new", *ASKED, "--generator", "two-roller", "--profile", "arc-line", "--use", "precision").out
    expected = propose(100, 60, generator="two-roller", profile="arc-line", use="precision")
    assert out == expected.toml()
    assert loads(out) == expected.design


def test_the_design_of_a_file_named_without_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "gear.toml"
    assert run(capsys, "new", file, *ASKED).code == 0
    assert load(file) == propose(100, 60).design


def test_an_existing_file_is_kept_unless_forced(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "gear.toml"
    file.write_text("mine")
    outcome = run(capsys, "new", *ASKED, "--out", file)
    assert outcome.code == 2
    assert "is there already" in outcome.err
    assert file.read_text() == "mine"
    assert run(capsys, "new", *ASKED, "--out", file, "--force").code == 0
    assert load(file) == propose(100, 60).design


def test_a_full_disk_leaves_one_message(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    full = tmp_path / "gear.toml"
    full.symlink_to("/dev/full")
    outcome = run(capsys, "new", *ASKED, "--out", full)
    assert (outcome.code, outcome.err) == (2, f"strainwave: {full}: cannot be written: No space left on device\n")
    assert [path.name for path in tmp_path.iterdir()] == ["gear.toml"]


def test_an_interrupt_leaves_no_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("strainwave.studies.wizard.search.evaluate_batch", interrupted)
    outcome = run(capsys, "new", *ASKED, "--out", tmp_path / "gear.toml")
    assert (outcome.code, outcome.out, outcome.err) == (130, "", "strainwave: interrupted\n")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--ratio", "100"], "give both --ratio and --pitch-diameter"),
        (["--pitch-diameter", "60"], "give both --ratio and --pitch-diameter"),
        (["--use", "power"], "give both --ratio and --pitch-diameter"),
        (["--ratio", "250", "--pitch-diameter", "60"], "the nearest possible is ratio 200 and pitch diameter 60 mm"),
        ([*ASKED, "--generator", "wheel"], "the wave generator must be one of cosine, ellipse"),
        ([*ASKED, "--profile", "pieces"], "the profile must be one of double-circular-arc"),
        ([*ASKED, "--use", "speed"], "the use must be one of power, precision"),
        ([*ASKED, "--ratio", "much"], "'--ratio'"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "new", *arguments)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err
