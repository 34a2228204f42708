"""Slopes from the contact against central differences of the whole analysis."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.design import Design, parameters_of
from strainwave.design.keys import leaves
from strainwave.geometry import Geometry
from strainwave.quantities import DEGREES, MODULES
from strainwave.studies.tolerance import ECCENTRICITY, Normal, Toleranced, Witness
from strainwave.studies.tolerance.sensitivity import sensitivities
from tests.designs import case

CERTIFIED_TO_MM = 1e-9
ELLIPSE = {"wave_generator": {"kind": "ellipse", "w0": 0.848, "cam_to_neutral": 12.8}}
WIDER = {"circular_spline.teeth": 208, "wave_generator.w0": 1.7, "wave_generator.neutral_curve": "inextensible"}
DESIGNS = {
    "cosine": case("cosine-calibrated"),
    "interfering": case("cosine"),
    "smooth": case("dual-disk-0900-calibrated"),
    "four-roller": case("four-roller-calibrated"),
    "ellipse": case().replace(ELLIPSE),
    "four teeth fewer": case().replace(WIDER),
    "fillets": case("cosine-calibrated").replace("circular_spline.profile.root_fillet_radius", 0.2),
}


def numbers_of(design: Design) -> list[Toleranced]:
    """Every number of a design that may vary, with a tolerance."""
    found = []
    for key, value in leaves(design.to_dict()):
        if type(value) is float:
            (parameter,) = parameters_of(design, (key,))
            tolerance = Normal(parameter=key, sigma=1e-3)
            found.append(Toleranced(key, parameter.quantity.unit, value, tolerance))
    return found


def least_um(design: Design) -> float:
    return Geometry.of(design).engagement.minimum_in_motion(CERTIFIED_TO_MM).gap * 1e3


@pytest.mark.parametrize("name", DESIGNS)
def test_slopes_are_those_of_central_differences(name: str) -> None:
    """Within 1e-3 of the slope, and 1e-4 µm per step's unit where there is next to none."""
    design = DESIGNS[name]
    parameters = [each for each in numbers_of(design) if not each.key.endswith("cam_to_neutral")]
    _, found = sensitivities(design, parameters)
    steep = 0
    for parameter, sensitivity in zip(parameters, found, strict=True):
        if parameter.key.endswith("root_fillet_radius") and parameter.nominal == 0.0:
            assert sensitivity.slope_um is None  # a fillet is another piece
            continue
        assert sensitivity.slope_um is not None
        step = 1e-3 if parameter.unit == DEGREES else 1e-4
        low, high = (least_um(design.replace(parameter.key, parameter.nominal + sign * step)) for sign in (-1, 1))
        slope = (high - low) / (2.0 * step)
        if sensitivity.per == "um":
            slope /= 1e3 * (design.module if parameter.unit == MODULES else 1.0)
        assert sensitivity.slope_um == pytest.approx(slope, rel=1e-3, abs=1e-4), parameter.key
        steep += abs(slope) > 0.1
    assert steep >= 6


def test_units_and_scatter() -> None:
    """An offset takes as much off the gap as it adds to the tooth, whatever the unit it is shown in."""
    design = case("cosine-calibrated")
    chosen = {each.key: each for each in numbers_of(design)}
    _, (offset, radius, angle) = sensitivities(
        design,
        [chosen[f"flexspline.profile.{name}"] for name in ("offset", "tip_arc_radius", "flank_angle")],
    )
    assert (offset.per, radius.per, angle.per) == ("um", "um", "degree")
    assert offset.slope_um == pytest.approx(-1.0, abs=1e-6)
    assert radius.slope_um == pytest.approx(-1.0, abs=1e-6)
    assert offset.scatter_um == pytest.approx(1.0, abs=1e-6)  # sigma of 0.001 mm
    assert radius.scatter_um == pytest.approx(0.8, abs=1e-6)  # sigma of 0.001 modules
    assert angle.slope_um == pytest.approx(0.0, abs=1e-6)  # the line is not where the teeth touch


def test_an_eccentricity_takes_itself_off() -> None:
    eccentricity = Toleranced(ECCENTRICITY, "mm", 0.0, Normal(parameter=ECCENTRICITY, sigma=0.002))
    _, (found,) = sensitivities(case(), [eccentricity])
    assert (found.slope_um, found.per) == (-1.0, "um")
    assert found.scatter_um == pytest.approx(2.0)


@pytest.mark.parametrize("name", DESIGNS)
def test_a_witness_is_as_far_apart_as_its_gap(name: str) -> None:
    """Its two points, put together from the profiles and poses, at any index; an overlap is negative."""
    geometry = Geometry.of(DESIGNS[name])
    kinds = set()
    for index in np.random.default_rng(1).uniform(0.0, geometry.flexspline.teeth / 4, 60):
        witness = Witness.at(geometry, float(index))
        assert witness.gap_mm == pytest.approx(geometry.engagement.clearances(float(index)).gap.min(), abs=1e-11)
        if witness.kind != "bisector":
            assert witness.separation_mm(geometry) == pytest.approx(witness.gap_mm, abs=1e-11)
        kinds.add(witness.kind)
    assert len(kinds) > 1


def test_a_parameter_that_changes_the_pieces_has_no_slope() -> None:
    before = Geometry.of(case())
    witness = Witness.at(before, 36.0)
    assert witness.separation_mm(before) is not None
    after = Geometry.of(case().replace("circular_spline.profile.root_fillet_radius", 0.2))
    assert witness.separation_mm(after) is None
