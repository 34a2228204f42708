"""``strainwave conjugate``: its report, its files and its messages."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from strainwave.design import load
from tests.cli.command import run
from tests.designs import CASE_STUDY

ROOT = Path(__file__).parent.parent.parent
COSINE = CASE_STUDY / "cosine.toml"


def test_the_report_says_how_well_the_pair_touches_and_where(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "conjugate", COSINE)
    assert outcome.code == 0
    assert "circular spline conjugate to the flexspline: cosine, w0 0.848 mm" in outcome.out
    assert "arcs and lines within 0.00" in outcome.out
    assert "convex arc   11.25 … 36.17" in outcome.out
    assert "double contact    at tooth index 1.03 … 1.69" in outcome.out
    assert "no root fillet" in outcome.out
    assert all(len(line) <= 100 for line in outcome.out.splitlines())


def test_the_report_of_the_reverse(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "conjugate", COSINE, "--of", "flexspline")
    assert "flexspline conjugate to the circular spline" in outcome.out
    assert "tip corner   33.60 … 39.40" in outcome.out
    assert "the root fillet of 0.4400 mm is reduced" in outcome.out
    assert all(len(line) <= 100 for line in outcome.out.splitlines())


@pytest.mark.parametrize("of", ["circular-spline", "flexspline"])
def test_the_written_design_does_not_interfere(of: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "new.toml"
    assert run(capsys, "conjugate", COSINE, "--of", of, "--out", out).code == 0
    profile = getattr(load(out), of.replace("-", "_")).profile
    assert profile.kind == "pieces"
    checked = run(capsys, "analyze", out, "--check")
    assert checked.code == 0
    assert "NO INTERFERENCE in motion, least gap 0.00 µm" in checked.out


def test_json_has_stable_keys_and_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    record = json.loads(run(capsys, "conjugate", COSINE, "--json").out)
    assert list(record) == [
        "schema_version", "name", "of", "pieces", "deviation_um", "offset_mm", "root_fillet_radius_mm", "zones",
        "double_contact_index", "branches", "gap_in_zones_um", "min_in_motion_um", "min_in_motion_index",
        "certified_to_um", "design",
    ]  # fmt: skip
    assert list(record["zones"][0]) == ["piece", "index", "phi_deg", "given_u_mm", "height_mm"]
    assert len(record["branches"]) > len(record["zones"])
    assert record["deviation_um"] <= 0.01
    assert 0.0 <= record["gap_in_zones_um"]["least"] <= record["gap_in_zones_um"]["greatest"] < 0.05
    assert len(record["design"]["circular_spline"]["profile"]["pieces"]) == record["pieces"]
    page = (ROOT / "docs" / "commands" / "conjugate.md").read_text(encoding="utf-8")
    assert all(f"`{key}`" in page for key in [*record, *record["zones"][0], *record["gap_in_zones_um"]])
    # A quarter of the flexspline's teeth spans 90 degrees, a little unevenly.
    index, phi = (np.array([zone[key] for zone in record["zones"]]) for key in ("index", "phi_deg"))
    assert np.abs(phi - index * 90.0 / 51.0).max() < 1.0


def test_a_file_that_exists_stays(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "new.toml"
    out.write_text("mine")
    outcome = run(capsys, "conjugate", COSINE, "--out", out)
    assert outcome.code == 2
    assert "is there already" in outcome.err
    assert out.read_text() == "mine"
    assert run(capsys, "conjugate", COSINE, "--out", out, "--force").code == 0


def test_a_picture_is_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "zones.svg"
    assert run(capsys, "conjugate", COSINE, "--plot", picture).code == 0
    assert picture.read_bytes().startswith(b"<?xml")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("w0 = 0.848", "w0 = 0.7"), "flexspline.profile.addendum = 0.9 modules: the circular spline's tooth sweeps"),
        (("kind = \"cosine\"", "kind = \"cosin\""), "wave_generator.kind"),
    ],
)  # fmt: skip
def test_a_design_without_such_a_flank_gets_one_message(
    change: tuple[str, str], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, out = tmp_path / "design.toml", tmp_path / "new.toml"
    file.write_text(COSINE.read_text().replace(*change))
    outcome = run(capsys, "conjugate", file, "--of", "flexspline", "--out", out)
    assert outcome.code == 2
    assert message in outcome.err
    assert str(file) in outcome.err
    assert outcome.err.count("\n") == 1
    assert outcome.out == ""
    assert not out.exists()


def test_a_tolerance_out_of_range_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "conjugate", COSINE, "--tolerance", "0")
    assert outcome.code == 2
    assert "the tolerance must be from 0.0001 to 10 µm, not 0" in outcome.err
