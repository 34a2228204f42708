"""What can be chosen, and the clearance for printing."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.export import Drawing, ExportChoice, Format, export_gear, gear_file
from strainwave.geometry import Geometry
from strainwave.outlines import flank_points
from strainwave.outlines.toothed import all_teeth
from tests.designs import circular_spline_as_pieces
from tests.export.gears import GEAR, small_gear
from tests.fitting.deviation import of_the_curve_from_the_chain
from tests.outlines.area import enclosed

DESIGNS = {
    "arcs": GEAR,
    "pieces": GEAR.replace("circular_spline.profile", circular_spline_as_pieces()),
}


@pytest.mark.parametrize("clearance_mm", [0.1, 0.02, -0.05])
@pytest.mark.parametrize("spline", ["flexspline", "circular_spline"])
@pytest.mark.parametrize("name", DESIGNS)
def test_the_printing_clearance_sets_the_whole_outline_back(name: str, spline: str, clearance_mm: float) -> None:
    """Every point of the smooth pieces moves by it along the normal, and lies on the new outline; lands and floors stay
    circles about the gear's centre."""
    design = DESIGNS[name]
    before = getattr(Geometry.of(design), spline)
    after = getattr(ExportChoice(printing_clearance_mm=clearance_mm).geometry(design), spline)
    knots = before.knots
    inner = np.concatenate([np.linspace(*pair, 12)[1:-1] for pair in pairwise(knots)])
    moved = before.position(inner) - clearance_mm * before.normal(inner)
    away = np.array([of_the_curve_from_the_chain(after.segments, point[None]) for point in moved])
    # Next to a corner the moved piece is cut off, or the new one is longer: by less than the clearance.
    assert np.median(away) < 1e-12
    assert float((away > 1e-12).mean()) < 0.12
    assert away.max() < 1.5 * abs(clearance_mm)
    towards_centre = 1.0 if before.internal else -1.0
    for piece in (0, -1):
        radii = [abs(1.0 / profile.segments[piece, 3]) for profile in (before, after)]
        assert radii[1] - radii[0] == pytest.approx(towards_centre * clearance_mm, abs=1e-9)


def test_the_area_shrinks_by_the_length_of_the_outline() -> None:
    """Steiner's formula for parallel curves, to first order in the clearance; the error is of second order."""
    exact = all_teeth(Geometry.of(GEAR).flexspline, "flexspline")
    length = float(exact.segments[:, 4].sum())
    errors = []
    for clearance in (0.02, 0.01):
        moved = all_teeth(ExportChoice(printing_clearance_mm=clearance).geometry(GEAR).flexspline, "flexspline")
        errors.append((enclosed(exact) - enclosed(moved)) / clearance - length)
    assert abs(errors[0]) < 0.05 * length
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.05)


def test_it_is_neither_the_designs_offset_nor_part_of_the_design() -> None:
    """The design's own offset stands, and moves flanks only; the clearance comes on top in the file alone."""
    text = gear_file(GEAR, "json", ExportChoice(tooth=0, printing_clearance_mm=0.05))
    assert isinstance(text, str)
    assert '"printing_clearance_mm":0.05' in text
    offset = GEAR.replace("flexspline.profile.offset", GEAR.flexspline.profile.offset - 0.05)
    by_offset = Geometry.of(offset).flexspline
    by_clearance = ExportChoice(printing_clearance_mm=0.05).geometry(GEAR).flexspline
    own = Geometry.of(GEAR).flexspline
    assert by_offset.position(0.0)[1] == own.position(0.0)[1]
    assert by_clearance.position(0.0)[1] == pytest.approx(own.position(0.0)[1] - 0.05, abs=1e-12)


def test_teeth_with_clearance_have_twice_as_much_backlash_more() -> None:
    """Both flanks of a gap are set back, each by the clearance; corners that face flanks gain a little less or more."""
    before = Geometry.of(GEAR).engagement.clearances(np.arange(-40.0, 41.0)).gap
    after = ExportChoice(printing_clearance_mm=0.05).geometry(GEAR).engagement.clearances(np.arange(-40.0, 41.0)).gap
    gain = np.min(after, axis=-1) - np.min(before, axis=-1)
    assert 0.09 < float(np.median(gain)) < 0.11


@pytest.mark.parametrize(
    ("choice", "words"),
    [
        (ExportChoice(), "flexspline, circular spline and wave generator, as made"),
        (ExportChoice(tooth=3), "tooth 3 of the flexspline and of the circular spline, as made"),
        (
            ExportChoice(only=("flexspline",), generator_angle_deg=7.5),
            "flexspline, assembled, the wave generator at 7.5°",
        ),
        (
            ExportChoice(only=("circular-spline",), printing_clearance_mm=0.1),
            "circular spline, as made, the teeth 0.1 mm thinner all round for printing",
        ),
        (
            ExportChoice(only=("circular-spline",), printing_clearance_mm=-0.1),
            "circular spline, as made, the teeth 0.1 mm thicker all round for printing",
        ),
    ],
)
def test_a_choice_says_what_it_is(choice: ExportChoice, words: str) -> None:
    assert str(choice) == words


@pytest.mark.parametrize(
    ("choice", "problem"),
    [
        (
            ExportChoice(tooth=205),
            "tooth 205 is not there: the teeth of the flexspline are numbered from 0 to 203 clockwise",
        ),
        (ExportChoice(tooth=-204, only=("flexspline",)), "tooth -204 is not there"),
        (ExportChoice(tooth=0, only=("wave-generator",)), "the wave generator has none"),
        (
            ExportChoice(only=("wave-generator",), printing_clearance_mm=0.05),
            "the wave generator has no teeth to set back",
        ),
        (ExportChoice(generator_angle_deg=math.nan), "angle must be a finite number"),
        (ExportChoice(generator_angle_deg=math.inf), "angle must be a finite number"),
        (ExportChoice(printing_clearance_mm=math.nan), "from -0.8 to 0.8 mm"),
        (ExportChoice(printing_clearance_mm=0.9), "from -0.8 to 0.8 mm"),
        (ExportChoice(printing_clearance_mm=0.7), "of 0.7 mm leaves the flexspline no possible tooth: "),
        (ExportChoice(printing_clearance_mm=-0.8), "no possible tooth: .*Bring it nearer to 0"),
        (
            ExportChoice(only=("rotor",)),  # type: ignore[arg-type]
            "there is no part 'rotor'; the parts are flexspline, circular-spline, wave-gen",
        ),
    ],
)
def test_a_choice_that_cannot_be_is_refused(choice: ExportChoice, problem: str) -> None:
    with pytest.raises(StrainwaveError, match=problem):
        Drawing.of(GEAR, choice)


@pytest.mark.parametrize(
    ("design", "format", "error", "problem"),
    [
        (GEAR, "dxf", 0.01, "dxf files hold arcs as arcs, without chords"),
        (GEAR, "step", 0.01, "step files hold arcs as arcs, without chords"),
        (GEAR, "csv", 0.0, "the chord error must lie between 8e-06 mm and"),
        (GEAR, "stl", math.nan, "the chord error must lie between 8e-06 mm and"),
        (GEAR, "pdf", None, "there is no format 'pdf'; the formats are dxf, svg, csv, json, step, stl, glb"),
    ],
)
def test_a_format_that_cannot_obey_says_so(design: Design, format: Any, error: float | None, problem: str) -> None:
    with pytest.raises(StrainwaveError, match=problem):
        gear_file(design, format, chord_error_mm=error)


@pytest.mark.parametrize("format", ["dxf", "svg", "csv", "json", "step", "stl", "glb"])
def test_a_file_is_written_whole_or_not_at_all(format: Format, tmp_path: Any) -> None:
    path = tmp_path / f"gear.{format}"
    export_gear(small_gear(), path, format)
    before = path.read_bytes()
    assert len(before) > 1000
    with pytest.raises(StrainwaveError, match="is there already"):
        export_gear(small_gear(), path, format)
    with pytest.raises(StrainwaveError, match="finite number"):
        export_gear(small_gear(), path, format, ExportChoice(generator_angle_deg=math.nan), overwrite=True)
    assert path.read_bytes() == before
    assert [kept.name for kept in tmp_path.iterdir()] == [path.name]


def test_points_of_every_outline_are_finite() -> None:
    for outline in Drawing.of(small_gear(), ExportChoice(generator_angle_deg=10.0)).outlines:
        assert np.isfinite(flank_points(outline.segments, chord_error_mm=0.01)).all()
