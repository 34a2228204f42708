"""The cup along its axis: where its sections are, and how far each is bent."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave import _kernel
from strainwave.batch.parts import profiles
from strainwave.columns import NOTHING_VARIED
from strainwave.cup import Cup
from strainwave.design import Design, DesignRows
from strainwave.geometry import Geometry
from tests.batch.variations import GENERATORS, varied_design
from tests.designs import case

PHI = np.linspace(0.0, np.pi / 2.0, 91)


def test_places_along_the_axis() -> None:
    """Half, a sixth and 0.0125 of the pitch diameter of 163.2 mm."""
    cup = Cup.of(case())
    places = cup.diaphragm_mm, cup.face_start_mm, cup.mid_face_mm, cup.length_mm
    assert places == pytest.approx((2.04, 54.4, 68.0, 81.6))
    assert cup.boss_mm == pytest.approx(6.12)
    assert (cup.half_ring_mm, cup.half_engaged_mm) == pytest.approx((13.6, 13.6))


def test_the_boss_ends_halfway_to_the_teeth_of_a_shallow_cup() -> None:
    cup = Cup.of(case().replace({"flexspline.diaphragm_thickness": 20.0}))
    assert cup.boss_mm == pytest.approx(20.0 + 0.5 * (54.4 - 20.0))


@pytest.mark.parametrize(("ring", "half"), [(10.0, 5.0), (40.0, 13.6)])
def test_teeth_meet_where_both_splines_have_some(ring: float, half: float) -> None:
    cup = Cup.of(case().replace("circular_spline.face_width", ring))
    assert cup.engaged_mm(3) == pytest.approx([68.0 - half, 68.0, 68.0 + half])
    assert cup.half_ring_mm == 0.5 * ring


def test_the_displacement_grows_from_the_diaphragm_in_proportion_to_z() -> None:
    cup = Cup.of(case())
    assert cup.w0_mm([0.0, 1.0, cup.diaphragm_mm]).tolist() == [0.0, 0.0, 0.0]
    assert cup.w0_mm(cup.mid_face_mm) == 0.848  # to the last bit: the section of the plane results
    assert cup.w0_mm(cup.length_mm) == pytest.approx(0.848 * (81.6 - 2.04) / (68.0 - 2.04))
    assert np.diff(cup.w0_mm([10.0, 30.0, 50.0, 70.0])) == pytest.approx([20.0 * cup.slope] * 3)
    assert cup.engaged_mm(11)[5] == cup.mid_face_mm


@pytest.mark.parametrize("name", GENERATORS)
def test_the_section_at_mid_face_is_the_generator_s_own_curve(name: str) -> None:
    design = varied_design(name)
    own, section = Geometry.of(design).neutral_curve, Cup.of(design).curve(0.848)
    assert np.array_equal(section.displacement(PHI), own.displacement(PHI))
    assert section.perimeter == own.perimeter


@pytest.mark.parametrize("name", [name for name in GENERATORS if name != "ellipse"])
def test_every_section_has_the_shape_of_mid_face(name: str) -> None:
    """In the first-order model r - R is w itself, so that sections are in proportion."""
    design = varied_design(name).replace("wave_generator.neutral_curve", "first-order")
    cup = Cup.of(design)
    mid_face, further = cup.curve(0.848), cup.curve(1.06)
    assert further.displacement(PHI) == pytest.approx(1.25 * mid_face.displacement(PHI), abs=1e-12)


def test_disks_of_a_given_radius_keep_their_wrap_angle_along_the_cup() -> None:
    """Their own shape depends on w0: as a generator of its own, one of another w0 would wrap another angle."""
    design = varied_design("disk-radius").replace("wave_generator.neutral_curve", "first-order")
    cup, elsewhere = Cup.of(design), design.replace("wave_generator.w0", 0.9)
    other = Geometry.of(elsewhere).neutral_curve.displacement(PHI)
    assert np.abs(cup.curve(0.9).displacement(PHI) - other).max() > 1e-3


def test_sections_of_an_ellipse_are_in_proportion_to_the_second_order() -> None:
    """An ellipse of the circle's perimeter departs from its first harmonic by the order of w0²/R: halving w0 quarters
    how far its sections are from being in proportion."""
    departures = []
    for w0 in (0.848, 0.424):
        cup = Cup.of(varied_design("ellipse").replace("wave_generator.w0", w0))
        mid_face, further = cup.curve(w0).displacement(PHI)[:, 0], cup.curve(1.25 * w0).displacement(PHI)[:, 0]
        departures.append(np.abs(further - 1.25 * mid_face).max())
    assert departures[0] < 0.848**2 / 79.83
    assert departures[0] / departures[1] == pytest.approx(4.0, rel=0.02)


@pytest.mark.parametrize("name", GENERATORS)
def test_sections_of_a_batch_are_those_of_one(name: str) -> None:
    design = varied_design(name)
    cup, w0 = Cup.of(design), np.array([0.7, 0.848, 1.0])
    found = _least_gaps(design, cup.curves(w0))
    geometry = Geometry.of(design)
    index = np.arange(design.flexspline.teeth // 4 + 1)
    for gap, value in zip(found.tolist(), w0.tolist(), strict=True):
        engagement = _kernel.Engagement(geometry.flexspline, geometry.circular_spline, cup.curve(value))
        assert engagement.clearances(index).gap.min() == pytest.approx(gap, abs=1e-12)


def _least_gaps(design: Design, curves: _kernel.BatchCurves) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    rows = DesignRows(design, NOTHING_VARIED)
    return _kernel.evaluate_batch(
        profiles(rows, "flexspline"),
        profiles(rows, "circular_spline"),
        curves,
        threshold=0.01,
        play=False,
        radial=False,
    ).min_gap
