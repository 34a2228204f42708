"""``strainwave export``: its files, what it says, and its messages."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.command import run
from tests.designs import CASE_STUDY

DESIGN = CASE_STUDY / "cosine-calibrated.toml"


@pytest.mark.parametrize(
    ("format", "options", "says", "begins"),
    [
        ("dxf", [], "flexspline, circular spline and wave generator, as made", b"  0\nSECTION"),
        ("svg", ["--part", "flexspline"], "flexspline, as made", b"<svg xmlns"),
        (
            "csv",
            ["--tooth", "3", "--angle", "7°30'"],
            "assembled, the wave generator at 7.5°",
            b"outline,part,tooth,piece",
        ),
        (
            "json",
            ["--tooth", "0"],
            "tooth 0 of the flexspline and of the circular spline, as made",
            b'{"schema_version":1',
        ),
        ("step", ["--part", "circular-spline", "--tooth", "5"], "tooth 5 of the circular spline", b"ISO-10303-21;"),
        ("stl", ["--part", "circular-spline", "--chord-error", "0.1"], "circular spline, as made", b"\0"),
        ("glb", ["--printing-clearance", "0.1", "--chord-error", "0.1"], "the teeth 0.1 mm thinner all round", b"glTF"),
    ],
)
def test_each_format_is_written(
    format: str, options: list[str], says: str, begins: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / f"gear.{format}"
    outcome = run(capsys, "export", format, DESIGN, "--out", out, *options)
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.startswith(f"{out}: ")
    assert says in outcome.out
    assert out.read_bytes().startswith(begins)


def test_the_options_reach_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "gear.json"
    options = ["--part", "flexspline", "--tooth", "-2", "--angle", "30", "--printing-clearance", "0.04"]
    assert run(capsys, "export", "json", DESIGN, "--out", out, *options).code == 0
    record = json.loads(out.read_text(encoding="utf-8"))
    assert (record["generator_angle_deg"], record["printing_clearance_mm"]) == (30.0, 0.04)
    assert [outline["part"] for outline in record["outlines"]] == ["flexspline"]
    assert {piece["tooth"] for piece in record["outlines"][0]["pieces"]} == {202}


@pytest.mark.parametrize(
    ("format", "options", "problem"),
    [
        ("pdf", [], "'pdf' is not one of 'dxf', 'svg'"),
        ("dxf", ["--angle", "up"], "'up' must be a number of degrees"),
        ("dxf", ["--chord-error", "0.1"], "leave out the chord error (--chord-error)"),
        ("csv", ["--tooth", "206"], "tooth 206 is not there"),
        ("step", ["--angle", "0"], "leave out the generator's angle (--angle)"),
        ("stl", ["--tooth", "0"], "leave out the tooth (--tooth)"),
        ("svg", ["--printing-clearance", "2"], "from -0.8 to 0.8 mm (one module), not 2 mm"),
        (
            "svg",
            ["--part", "wave-generator", "--printing-clearance", "0.05"],
            "the wave generator has no teeth to set back; leave out the printing clearance (--printing-clearance)",
        ),
    ],
)
def test_what_cannot_be_exits_2_with_one_message(
    format: str, options: list[str], problem: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "gear.file"
    outcome = run(capsys, "export", format, DESIGN, "--out", out, *options)
    assert (outcome.code, outcome.out) == (2, "")
    assert problem in outcome.err
    assert outcome.err.count("\n") == 1
    assert not out.exists()


def test_a_file_that_is_there_stays(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "gear.svg"
    out.write_text("mine")
    outcome = run(capsys, "export", "svg", DESIGN, "--out", out)
    assert outcome.code == 2
    assert "is there already" in outcome.err
    assert out.read_text() == "mine"
    assert run(capsys, "export", "svg", DESIGN, "--out", out, "--force").code == 0


def test_a_faulty_design_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Also where only the geometry of its wave generator shows the fault."""
    file, out = tmp_path / "design.toml", tmp_path / "gear.dxf"
    file.write_text(DESIGN.read_text(encoding="utf-8").replace("w0 = 0.848", "w0 = 0.848\nbearing_height = 79.0"))
    outcome = run(capsys, "export", "dxf", file, "--out", out)
    assert outcome.code == 2
    assert outcome.err.startswith(f"strainwave: {file}: wave_generator.bearing_height = 79.0 mm: ")
    assert not out.exists()
