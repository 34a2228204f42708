"""Key figures: what they read, and what their change means."""

from __future__ import annotations

import math

import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.studio.figures.figure import Figure, depth, few
from strainwave.studio.figures.key_figures import AT_ANGLE_0, CLEARANCES, GEAR, IN_MOTION, TEETH_BELOW, TIP_LANDS
from tests.designs import CASES, case

ALL = (*IN_MOTION, *AT_ANGLE_0, *TEETH_BELOW, *CLEARANCES, *TIP_LANDS, *GEAR)
FOUND = analyze(case())


def reading(*values: float | None) -> Figure:
    """A figure that reads these values, one after the other."""
    each = iter(values)
    return Figure("x", "x", "µm", 2, lambda _: next(each), merit=depth)


def in_record(found: Analysis) -> dict[str, float | None]:
    """The same figures under the keys of ``analyze --json``."""
    record = found.as_dict()
    curve = record["geometry"]["neutral_curve"]
    return {
        "min-in-motion": record["min_in_motion_um"],
        "certified": record["certified_to_um"],
        "min-index": record["min_in_motion_index"],
        "play-in-motion-circumferential": record["play_in_motion"]["circumferential_um"],
        "play-in-motion-angular": record["play_in_motion"]["angular_arcsec"],
        "min-backlash": record["min_backlash_um"],
        "min-tooth": record["min_tooth"],
        "play-circumferential": record["play"]["circumferential_um"],
        "play-angular": record["play"]["angular_arcsec"],
        "interfering": record["teeth_interfering"]["drive"],
        "first-interfering": record["first_interfering_tooth"],
        "below-per-side": record["teeth_below"]["per_side"],
        "below-drive": record["teeth_below"]["drive"],
        "tip-clearance": record["tip_clearance_um"],
        "root-clearance": record["root_clearance_um"],
        "tip-land-flexspline": record["geometry"]["flexspline"]["tip_land_mm"],
        "tip-land-circular-spline": record["geometry"]["circular_spline"]["tip_land_mm"],
        "ratio": -102.0,
        "relative-w0": found.design.wave_generator.w0 / 0.8,
        "neutral-radius": curve["radius_mm"],
        "perimeter-growth": curve["perimeter_growth"] * 1e6,
        "major-axis": curve["major_axis_mm"],
        "minor-axis": curve["minor_axis_mm"],
        "ring-theory": curve["ring_theory_error_um"],
    }


@pytest.mark.parametrize("name", CASES)
def test_every_figure_is_that_of_the_api(name: str) -> None:
    found = analyze(case(name))
    expected = in_record(found)
    assert {figure.name: figure.read(found) for figure in ALL} == expected
    assert len({figure.name for figure in ALL}) == len(ALL)
    for figure in ALL:
        value, text = expected[figure.name], figure.shown(found)
        if value is None:
            assert text == "–"
        else:
            shown = float(text.removeprefix(figure.mark).replace("−", "-"))
            assert shown == pytest.approx(value, abs=0.5000001 * 10.0**-figure.digits)
            assert "-" not in text


@pytest.mark.parametrize(
    ("now", "then", "change", "tone"),
    [
        (2.0, 1.0, "+1.00", ""),  # more of a gap is not clearly better: it is backlash
        (1.0, 2.0, "−1.00", ""),
        (1.0, -2.0, "+3.00", "better"),
        (-3.0, -2.0, "−1.00", "worse"),
        (-2.0, 5.0, "−7.00", "worse"),
        (-2.001, -2.002, "0.00", ""),  # what cannot be seen is no change
        (math.nan, 1.0, "", ""),
        (1.0, None, "", ""),
    ],
)
def test_the_change_of_a_clearance(now: float | None, then: float | None, change: str, tone: str) -> None:
    assert reading(now, then).change(FOUND, FOUND) == change
    assert reading(now, then).tone(FOUND, FOUND) == tone


def test_fewer_interfering_teeth_are_better() -> None:
    figure = next(each for each in ALL if each.name == "interfering")
    dual_disk = analyze(case("dual-disk-0848"))
    none = analyze(case("cosine-calibrated"))
    assert none.teeth_interfering.drive == 0 < dual_disk.teeth_interfering.drive
    assert figure.merit is few
    assert figure.tone(none, dual_disk) == "better"
    assert figure.tone(dual_disk, none) == "worse"
    assert figure.change(none, dual_disk) == f"−{dual_disk.teeth_interfering.drive}"
