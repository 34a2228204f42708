"""``strainwave fit``: what it prints, writes and refuses."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from strainwave import analyze, load
from tests.cli.command import run
from tests.designs import CASE_STUDY
from tests.imports.files import drawing, in_gear_frame, pieces_file, point_file, points

DESIGN = CASE_STUDY / "cosine-calibrated.toml"


def test_a_drawing_becomes_a_design(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, out = drawing(tmp_path, "flexspline", whole=True), tmp_path / "drawn.toml"
    found = run(capsys, "fit", path, "--design", DESIGN, "--spline", "flexspline", "--out", out)
    assert (found.code, found.err) == (0, "")
    assert "tooth.dxf: a whole tooth in mm, origin on the pitch circle" in found.out
    assert "4 arcs and lines, those of the file; addendum 0.9000, dedendum 1.2120" in found.out
    assert f"next: strainwave analyze {out}" in found.out
    written = load(out)
    assert written.flexspline.profile.kind == "pieces"
    assert written.circular_spline == load(DESIGN).circular_spline
    assert analyze(written).min_in_motion_um == pytest.approx(analyze(load(DESIGN)).min_in_motion_um, abs=1e-3)
    again = run(capsys, "fit", path, "--design", DESIGN, "--spline", "flexspline", "--out", out)
    assert again.code == 2
    assert "--force overwrites" in again.err


def test_the_record(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Its keys are those of the page, and nothing but the record is printed."""
    path = point_file(tmp_path, in_gear_frame(points("circular_spline", whole=True), "circular_spline", 0.4) / 25.4)
    found = run(
        capsys,
        "fit",
        path,
        "--design",
        DESIGN,
        "--spline",
        "circular-spline",
        "--units",
        "inch",
        "--noise",
        0,
        "--json",
    )
    assert found.code == 0
    record = json.loads(found.out)
    assert (record["schema_version"], record["kind"], record["unit"]) == (1, "points", "inch")
    assert (record["extent"], record["frame"], record["spline"]) == ("tooth", "gear", "circular_spline")
    assert record["scatter"]["noise_um"] == 0.0
    assert record["scatter"]["greatest_um"] < 0.06
    assert record["pieces"] == len(record["profile"]["pieces"])
    page = (Path(__file__).parents[2] / "docs" / "commands" / "fit.md").read_text(encoding="utf-8")
    for key in [*record, *record["scatter"]]:
        assert f"`{key}`" in page, key


def test_every_option_reaches_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    places = in_gear_frame(points("flexspline", whole=False), "flexspline", 0.5)
    path, out = point_file(tmp_path, places), tmp_path / "out.toml"
    options = ["--center", "0,0", "--axis", 28.64788975654116, "--addendum", 0.8, "--dedendum", 1.1, "--tolerance", 0.5]
    found = run(capsys, "fit", path, "--design", DESIGN, "--spline", "flexspline", "--out", out, *options)
    assert found.code == 0
    profile = load(out).flexspline.profile
    assert profile.addendum == pytest.approx(0.8, abs=1e-9)
    assert profile.dedendum == pytest.approx(1.1, abs=1e-8)
    assert "centre as given" in found.out
    pieces = pieces_file(tmp_path, "flexspline", "mm")
    assert run(capsys, "fit", pieces, "--design", DESIGN, "--spline", "flexspline").code == 0


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        (["none.dxf", "--design", DESIGN, "--spline", "flexspline"], "none.dxf: there is no such file"),
        (["none.dxf", "--design", "none.toml", "--spline", "flexspline"], "none.toml: there is no such file"),
        (["x.csv", "--design", DESIGN, "--spline", "rim"], "Invalid value for '--spline'"),
        (["x.csv", "--design", DESIGN], "Missing option '--spline'"),
        (["x.csv", "--design", DESIGN, "--spline", "flexspline", "--center", "1"], "must be two numbers, such as"),
        (["x.csv", "--design", DESIGN, "--spline", "flexspline", "--units", "ell"], "'ell' is no unit of length"),
        (["x.csv", "--design", DESIGN, "--spline", "flexspline", "--noise", "-1"], "noise_um must be a positive"),
        (
            ["x.csv", "--design", DESIGN, "--spline", "flexspline", "--tolerance", "0"],
            "tolerance_um must be a positive",
        ),
        (["x.csv", "--design", DESIGN, "--spline", "flexspline", "--axis", "nan"], "must be finite numbers"),
    ],
)
def test_what_cannot_be_exits_2_with_one_message(
    arguments: list[object], problem: str, capsys: pytest.CaptureFixture[str]
) -> None:
    found = run(capsys, "fit", *arguments)
    assert found.code == 2
    assert found.out == ""
    assert problem in found.err
    assert found.err.count("\n") == 1
    assert "Traceback" not in found.err


@pytest.mark.parametrize(
    ("kind", "options", "problem"),
    [
        ("drawing", ["--noise", 1], "tooth.dxf: holds no measured points; leave out the noise (--noise)"),
        ("pieces", ["--noise", 0], "flank.json: holds no measured points"),
        ("pieces", ["--layer", "tooth"], "flank.json: is no drawing (.dxf) and has no layers; leave out the layer"),
        ("points", ["--layer", "tooth"], "tooth.csv: is no drawing (.dxf) and has no layers"),
        ("drawing", ["--dedendum", 1.25], "to 1.2120 modules at most, short of the dedendum of 1.25 modules; ask for"),
        ("points", ["--addendum", 3], "continued by up to 0.25 modules of 0.8 mm: choose the addendum (--addendum)"),
    ],
)
def test_an_option_that_cannot_be_obeyed_is_refused(
    kind: str, options: list[str], problem: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """None is passed over in silence."""
    path = {
        "drawing": lambda: drawing(tmp_path, "flexspline", whole=True),
        "pieces": lambda: pieces_file(tmp_path, "flexspline"),
        "points": lambda: point_file(tmp_path, points("flexspline", whole=True)),
    }[kind]()
    found = run(capsys, "fit", path, "--design", DESIGN, "--spline", "flexspline", *options)
    assert (found.code, found.out) == (2, "")
    assert problem in found.err


def test_a_flank_that_makes_no_tooth_names_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The other gear's tooth, too thick for this one."""
    path, out = drawing(tmp_path, "flexspline", whole=True), tmp_path / "out.toml"
    wide = tmp_path / "wide.json"
    wide.write_text('{"start": [0.9, 0.89], "pieces": [{"to": [1.7, -1.2]}]}', encoding="utf-8")
    found = run(capsys, "fit", wide, "--design", DESIGN, "--spline", "flexspline", "--out", out)
    assert found.code == 2
    assert f"{wide}, as flexspline: flexspline.profile.dedendum" in found.err
    assert not out.exists()
    assert path.exists()
