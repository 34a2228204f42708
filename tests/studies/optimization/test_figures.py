"""Every figure is the one that the analysis of the same design has, and requirements are missed by what they say."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.studies.optimization import FIGURES, Optimization, Requirement
from strainwave.studies.optimization.goals import UNKNOWN_STEPS
from strainwave.studies.optimization.measure import measure
from tests.designs import CASES, case
from tests.studies.optimization.runs import VARY, front, single

W0 = ["wave_generator.w0"]


@pytest.mark.parametrize("name", [*CASES, "cosine-calibrated"])
def test_figures_are_those_of_the_analysis(name: str) -> None:
    found = measure(case(name), W0, np.array([[0.84], [0.86]]), FIGURES, threshold_um=8.0, threads=0)
    assert list(found) == list(FIGURES)
    for row, w0 in enumerate((0.84, 0.86)):
        result = analyze(case(name).replace("wave_generator.w0", w0), threshold_um=8.0)
        assert found["minimum-backlash"][row] == result.min_in_motion_um
        assert found["teeth-below"][row] == result.teeth_below.per_side
        assert found["play"][row] == result.play.circumferential_um
        assert found["tip-clearance"][row] == result.tip_clearance_um
        assert found["root-clearance"][row] == result.root_clearance_um
        lands = result.figures.flexspline.tip_land_mm, result.figures.circular_spline.tip_land_mm
        assert found["tip-land"][row] == min(lands)
        gap = result.teeth.backlash_um
        close = gap[(gap >= 0.0) & (gap < 8.0)]
        assert found["evenness"][row] == pytest.approx(math.sqrt(((close - close.mean()) ** 2).mean()), rel=1e-9)
        bend = abs(
            result.rim(np.linspace(0.0, 90.0, 20_001)).curvature_per_mm - 1 / result.figures.neutral_curve.radius_mm
        )
        assert found["rim-strain"][row] == pytest.approx(
            0.5 * 1.6 * bend.max() * 1e6, rel=2e-5
        )  # a kink between two samples


@pytest.mark.parametrize("search", [single, front])
def test_the_figures_of_an_answer_are_those_of_its_designs(search: Callable[[], Optimization]) -> None:
    found = search()
    for place, design in enumerate(found.designs[:3]):
        result = analyze(design)
        assert found.figures["minimum-backlash"][place] == result.min_in_motion_um
        assert found.figures["teeth-below"][place] == result.teeth_below.per_side
    assert found.start_figures["minimum-backlash"] == analyze(case()).min_in_motion_um


def test_rows_below_the_required_minimum_are_not_pursued() -> None:
    """Their backlash is then that at angle 0, which is no smaller; the rows above are the same."""
    values = np.stack([np.linspace(0.83, 0.87, 9), np.full(9, -0.005)], axis=1)
    whole = measure(case(), list(VARY), values, FIGURES, threshold_um=10.0, threads=0)
    some = measure(case(), list(VARY), values, FIGURES, threshold_um=10.0, threads=0, least_um=0.0)
    above = whole["minimum-backlash"] >= 0.0
    assert above.any()
    assert not above.all()
    for name in FIGURES:
        np.testing.assert_array_equal(whole[name][above], some[name][above])
    assert np.isnan(some["evenness"][~above]).all()
    assert (some["minimum-backlash"][~above] >= whole["minimum-backlash"][~above]).all()
    assert (some["minimum-backlash"][~above] < 0.0).all()


def test_rows_that_only_motion_brings_below_the_required_minimum_are_not_pursued_either() -> None:
    """0.43 µm at angle 0 and 0.41 in motion (the case study's table in the README)."""
    design = case("dual-disk-0900-calibrated")
    found = measure(design, W0, np.array([[0.9]]), FIGURES, threshold_um=10.0, threads=0, least_um=0.42)
    assert 0.40 < found["minimum-backlash"][0] < 0.42
    assert np.isnan(found["evenness"][0])


def test_what_is_no_gear_has_no_figures() -> None:
    found = measure(case(), W0, np.array([[30.0], [-1.0]]), FIGURES, threshold_um=10.0, threads=0)
    assert all(np.isnan(values).all() for values in found.values())


def test_a_requirement_is_missed_by_its_distance_in_steps() -> None:
    requirement = Requirement(FIGURES["tip-land"], 0.2, 0.3)
    missed = requirement.missed_steps({"tip-land": np.array([0.2, 0.3, 0.18, 0.35, np.nan, -np.inf])})
    assert missed == pytest.approx([0.0, 0.0, 2.0, 5.0, UNKNOWN_STEPS, UNKNOWN_STEPS])
    assert str(requirement) == "tip-land 0.2 to 0.3 mm"
    assert str(Requirement(FIGURES["play"], -math.inf, 3.0)) == "play at most 3 µm"


def test_an_end_as_far_away_as_numbers_reach_is_missed_by_as_much_as_any() -> None:
    for low, high in [(1e308, math.inf), (-math.inf, -1e308)]:
        missed = Requirement(FIGURES["tip-land"], low, high).missed_steps({"tip-land": np.array([0.2])})
        assert missed == pytest.approx(UNKNOWN_STEPS)
