"""Results as JSON, CSV and HTML."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.errors import StrainwaveError
from tests.designs import case

STABLE_KEYS: dict[str, type | tuple[type, ...]] = {
    "schema_version": int,
    "name": str,
    "generator_angle_deg": float,
    "min_backlash_um": float,
    "min_tooth": int,
    "min_in_motion_um": float,
    "min_in_motion_index": float,
    "certified_to_um": float,
    "interference": bool,
    "interfering_teeth": list,
    "first_interfering_tooth": (int, type(None)),
    "teeth_below": dict,
    "play": dict,
    "tip_clearance_um": float,
    "root_clearance_um": float,
    "teeth": list,
}
STABLE_TOOTH_KEYS = ["tooth", "phi_deg", "left_um", "right_um", "backlash_um"]


@pytest.mark.parametrize("name", ["cosine-calibrated", "dual-disk-0848"])
def test_json_has_the_stable_keys_with_plain_values(name: str) -> None:
    record = json.loads(analyze(case(name)).to_json())
    for key, kind in STABLE_KEYS.items():
        assert isinstance(record[key], kind), key
    assert set(record["teeth_below"]) == {"threshold_um", "per_side", "lobe", "drive"}
    assert set(record["play"]) == {"normal_um", "circumferential_um", "angular_arcsec"}
    assert [tooth["tooth"] for tooth in record["teeth"]] == list(range(-51, 52))
    assert all(isinstance(tooth[key], int | float) for tooth in record["teeth"] for key in STABLE_TOOTH_KEYS)


def test_json_says_what_the_result_says() -> None:
    result = analyze(case("dual-disk-0848"))
    record = json.loads(result.to_json())
    assert record["min_in_motion_um"] == result.min_in_motion_um
    assert record["interfering_teeth"] == result.interfering_teeth.tolist()
    assert record["teeth_below"]["drive"] == result.teeth_below.drive
    assert record["certificate"]["lower_bound_um"] == result.in_motion.lower_bound_um
    np.testing.assert_array_equal([tooth["left_um"] for tooth in record["teeth"]], result.teeth.left_um)
    assert record["teeth"][51]["flexspline_piece"] == "convex arc"


def test_what_does_not_exist_is_null() -> None:
    """No turn within half a pitch brings a tooth near the minor axis into contact."""

    def refuse(name: str) -> Any:
        raise AssertionError(f"{name} is not JSON")

    record = json.loads(analyze(case()).to_json(), parse_constant=refuse)
    assert record["teeth"][0]["circumferential_left_um"] is None
    assert record["teeth"][51]["circumferential_left_um"] is not None


def test_csv_holds_every_tooth_to_the_last_bit(tmp_path: Path) -> None:
    result = analyze(case())
    result.to_csv(tmp_path / "teeth.csv")
    with (tmp_path / "teeth.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [int(row["tooth"]) for row in rows] == result.teeth.tooth.tolist()
    assert [float(row["backlash_um"]) for row in rows] == result.teeth.backlash_um.tolist()
    assert rows[0]["circumferential_left_um"] == ""
    assert math.isnan(result.teeth.circumferential_left_um[0])


def test_an_existing_csv_is_kept_unless_told_otherwise(tmp_path: Path) -> None:
    target = tmp_path / "teeth.csv"
    target.write_text("mine")
    result = analyze(case())
    with pytest.raises(StrainwaveError, match="is there already"):
        result.to_csv(target)
    assert target.read_text() == "mine"
    result.to_csv(target, overwrite=True)
    assert target.read_text().startswith("tooth,index,phi_deg")


def test_a_notebook_shows_the_verdict_and_a_picture_and_escapes_the_name() -> None:
    html = analyze(case().replace("name", "<script>"))._repr_html_()
    assert "INTERFERENCE in motion, 5.71 µm deep" in html
    assert "&lt;script&gt;" in html
    assert "<script>" not in html
    assert "data:image/png;base64,iVBOR" in html


def test_the_text_form_is_one_line_with_the_verdict() -> None:
    text = repr(analyze(case("cosine-calibrated")))
    assert "no interference" in text
    assert "\n" not in text
