"""``strainwave analyze --sections``: the table, the files and the gate."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.command import run
from tests.designs import CASE_STUDY

CALIBRATED = CASE_STUDY / "cosine-calibrated.toml"


def test_the_table_lists_sections_from_the_open_end_down(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "analyze", CALIBRATED, "--sections", 5)
    assert outcome.code == 0
    lines = outcome.out.split("section, z mm")[1].splitlines()
    assert [line.split()[0] for line in lines[2:7]] == ["81.60", "74.80", "68.00", "61.20", "54.40"]
    assert lines[4].split() == ["68.00", "mid-face", "0.8480", "1.49", "1.49", "36.0", "free"]
    assert "interferes" in lines[2]
    assert lines[7] == "INTERFERENCE along the face, 127.54 µm deep at z = 54.40 mm"
    text = " ".join(outcome.out.split())
    assert "w0 is 0.8480 mm at mid-face, 1.0228 mm at the open end (+20.6 %)" in text
    assert "NO INTERFERENCE in motion, least gap 1.49 µm" in text


def test_without_sections_the_report_is_that_of_mid_face(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "analyze", CALIBRATED)
    assert "section, z mm" not in outcome.out
    assert "face" not in json.loads(run(capsys, "analyze", CALIBRATED, "--json").out)


def test_json_holds_the_map(capsys: pytest.CaptureFixture[str]) -> None:
    record = json.loads(run(capsys, "analyze", CALIBRATED, "--sections", 3, "--json").out)
    assert len(record["face"]["sections"]) == 3
    assert record["face"]["sections"][1]["min_in_motion_um"] == pytest.approx(record["min_in_motion_um"], abs=1e-9)


def test_files_of_the_sections_alone_ask_for_the_usual_number(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    table, picture = tmp_path / "face.csv", tmp_path / "face.svg"
    outcome = run(capsys, "analyze", CALIBRATED, "--face-csv", table, "--face-plot", picture)
    assert outcome.code == 0
    assert len(table.read_text().splitlines()) == 1 + 11 * 103
    assert picture.read_text().startswith("<?xml")
    again = run(capsys, "analyze", CALIBRATED, "--face-csv", table)
    assert (again.code, again.out) == (2, "")
    assert "is there already" in again.err


def test_the_gate_counts_every_section_that_was_asked_for(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert run(capsys, "analyze", CALIBRATED, "--check").code == 0
    assert run(capsys, "analyze", CALIBRATED, "--check", "--sections", 3).code == 1
    long_cup = tmp_path / "long.toml"
    sizes = "cup_length = 5000.0\nface_width = 2.0\n"
    long_cup.write_text(CALIBRATED.read_text().replace("[flexspline]\n", f"[flexspline]\n{sizes}"))
    outcome = run(capsys, "analyze", long_cup, "--check", "--sections", 3)
    assert outcome.code == 0
    assert "NO INTERFERENCE along the face" in outcome.out


@pytest.mark.parametrize("count", ["4", "1", "-3", "10003"])
def test_a_number_of_sections_that_cannot_be(count: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "analyze", CALIBRATED, "--sections", count)
    assert outcome.code == 2
    assert "sections must be an odd whole number from 3 to 10001" in outcome.err


def test_a_cup_that_cannot_be_bent_so_far_is_one_message(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    short = tmp_path / "short.toml"
    sizes = "cup_length = 40.0\nface_width = 37.0\n"
    text = CALIBRATED.read_text().replace("[flexspline]\n", f"[flexspline]\n{sizes}").replace("w0 = 0.848", "w0 = 10.0")
    short.write_text(text)
    outcome = run(capsys, "analyze", short, "--sections", 3)
    assert outcome.code == 2
    assert "mm of the section 40 mm from the diaphragm's outer face" in outcome.err
    assert "Traceback" not in outcome.err
