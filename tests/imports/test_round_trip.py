"""A profile written to a file and read back gives the same analysis."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from strainwave import analyze, dumps, loads
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.imports import ImportHints, import_flank
from tests.designs import case
from tests.imports.files import (
    CALIBRATED,
    SPLINES,
    Spline,
    drawing,
    in_gear_frame,
    outline,
    pieces_file,
    point_file,
    points,
)

BACKLASH = analyze(CALIBRATED)


def difference_um(design: Design) -> float:
    """Greatest difference to the case study's backlash over all teeth and in motion, and of the radial clearances."""
    found = analyze(design)
    radial = [
        found.tip_clearance_um - BACKLASH.tip_clearance_um,
        found.root_clearance_um - BACKLASH.root_clearance_um,
        found.min_in_motion_um - BACKLASH.min_in_motion_um,
    ]
    gaps = [
        np.nanmax(np.abs(found.teeth.left_um - BACKLASH.teeth.left_um)),
        np.nanmax(np.abs(found.teeth.right_um - BACKLASH.teeth.right_um)),
    ]
    return max(*map(abs, radial), *map(float, gaps))


@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("spline", SPLINES)
def test_a_drawing(tmp_path: Path, spline: Spline, whole: bool) -> None:
    """Its arcs are taken as they are: the same pieces, and the same analysis but for rounding."""
    found = import_flank(drawing(tmp_path, spline, whole=whole), CALIBRATED, spline)
    assert found.extent == ("tooth" if whole else "flank")
    assert found.fit_deviation_um == 0.0
    assert len(found.profile["pieces"]) == len(outline(spline, whole=False)) - 2  # without land and floor
    assert difference_um(found.design) < 1e-4


@pytest.mark.parametrize("spline", SPLINES)
@pytest.mark.parametrize("unit", ["modules", "mm"])
def test_pieces(tmp_path: Path, spline: Spline, unit: str) -> None:
    found = import_flank(pieces_file(tmp_path, spline, unit), CALIBRATED, spline)
    assert found.unit == unit
    assert difference_um(found.design) < 1e-4
    assert difference_um(loads(dumps(found.design))) < 1e-4


@pytest.mark.parametrize("whole", [False, True])
@pytest.mark.parametrize("chord_error_mm", [5e-4, 1e-4])
@pytest.mark.parametrize("spline", SPLINES)
def test_points(tmp_path: Path, spline: Spline, chord_error_mm: float, whole: bool) -> None:
    """Within the chord error stated; the curve through the points is much nearer than their chords."""
    path = point_file(tmp_path, points(spline, whole=whole, chord_error_mm=chord_error_mm))
    found = import_flank(path, CALIBRATED, spline)
    assert difference_um(found.design) < 1e3 * chord_error_mm
    assert found.scatter is not None
    assert found.scatter.noise_um == 0.0


@pytest.mark.parametrize("unit", ["inch", "um", "modules"])
@pytest.mark.parametrize("angle", [0.0, 0.3, 2.9, -1.4])
@pytest.mark.parametrize("spline", SPLINES)
def test_points_of_a_whole_tooth_anywhere_about_the_gear(
    tmp_path: Path, spline: Spline, angle: float, unit: str
) -> None:
    """The axis is found by symmetry, whichever way the points run."""
    mm = {"inch": 25.4, "um": 1e-3, "modules": 0.8}[unit]
    places = in_gear_frame(points(spline, whole=True), spline, angle) / mm
    forwards = import_flank(point_file(tmp_path, places), CALIBRATED, spline, ImportHints(unit=unit))
    backwards = import_flank(point_file(tmp_path, places[::-1]), CALIBRATED, spline, ImportHints(unit=unit))
    assert forwards.frame == "gear"
    assert difference_um(forwards.design) < 0.2
    assert backwards.profile["addendum"] == pytest.approx(forwards.profile["addendum"], abs=1e-12)


def test_the_axis_and_the_centre_may_be_given(tmp_path: Path) -> None:
    """One flank, the gear's centre at (3, -4) mm, the tooth at 40 degrees."""
    angle = math.radians(40.0)
    places = in_gear_frame(points("flexspline", whole=False), "flexspline", angle) + np.array([3.0, -4.0])
    found = import_flank(
        point_file(tmp_path, places), CALIBRATED, "flexspline", ImportHints(center_mm=(3.0, -4.0), axis_deg=40.0)
    )
    assert (found.frame, found.extent) == ("given", "flank")
    assert difference_um(found.design) < 0.2


def test_the_flank_is_cut_and_continued_to_the_circles_asked_for(tmp_path: Path) -> None:
    path = drawing(tmp_path, "circular_spline", whole=True)
    found = import_flank(path, CALIBRATED, "circular_spline", ImportHints(addendum=0.7, dedendum=1.2))
    assert found.profile["addendum"] == pytest.approx(0.7, abs=1e-9)
    assert found.profile["dedendum"] == pytest.approx(1.2, abs=1e-8)
    expected = CALIBRATED.replace({"circular_spline.profile.addendum": 0.7, "circular_spline.profile.dedendum": 1.2})
    assert analyze(found.design).teeth.backlash_um == pytest.approx(
        analyze(expected).teeth.backlash_um, abs=1e-4, nan_ok=True
    )


def test_a_circle_that_a_report_names_can_be_asked_for(tmp_path: Path) -> None:
    """The fillet runs level at 1.212 modules, and a report rounds to 1e-4."""
    path = drawing(tmp_path, "flexspline", whole=True)
    found = import_flank(path, CALIBRATED, "flexspline", ImportHints(addendum=0.9, dedendum=1.21205))
    assert found.profile["dedendum"] == pytest.approx(1.212, abs=1e-6)
    with pytest.raises(StrainwaveError, match=r"at most, short of the dedendum of 1.2122 modules"):
        import_flank(path, CALIBRATED, "flexspline", ImportHints(dedendum=1.2122))


def test_a_mixed_pair(tmp_path: Path) -> None:
    """An imported flexspline in the article's circular spline, under another generator: the numbers of the original."""
    other = case("four-roller-calibrated")
    found = import_flank(drawing(tmp_path, "flexspline", whole=True), other, "flexspline")
    assert found.design.circular_spline.profile.kind == "arc-line"
    assert found.design.flexspline.profile.kind == "pieces"
    assert analyze(found.design).min_in_motion_um == pytest.approx(analyze(other).min_in_motion_um, abs=1e-3)
