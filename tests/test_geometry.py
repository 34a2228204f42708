"""From a design to the kernel, and the kernel's errors as faults of the design."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from strainwave.errors import DesignError, Fault
from strainwave.geometry import CURVE_FAULTS, PROFILE_FAULTS, RULED_OUT, Geometry
from tests.designs import CASES, case, circular_spline_as_pieces

KERNEL_ERRORS = Path(__file__).parent.parent / "crates" / "kernel" / "src" / "error.rs"


@pytest.mark.parametrize("name", [case_name + reading for case_name in CASES for reading in ("", "-calibrated")])
def test_every_case_of_the_case_study_has_a_geometry(name: str) -> None:
    geometry = Geometry.of(case(name))
    roles = ["tip land", "flank", "flank", "flank", "fillet", "root floor"]
    assert geometry.flexspline.roles == roles
    assert geometry.circular_spline.roles == ["tip land", "flank", "flank", "root floor"]


def test_lengths_reach_the_kernel_in_mm() -> None:
    """The tip lies an addendum above the pitch circle, the root a dedendum below, the flank offset by the given mm."""
    design = case("cosine-calibrated")
    geometry = Geometry.of(design)
    profile = geometry.flexspline
    pitch_radius = 0.8 * 204 / 2
    center = np.array([0.0, -pitch_radius])
    tip = np.linalg.norm(profile.position(0.0) - center)
    root = np.linalg.norm(profile.position(profile.length) - center)
    assert tip == pytest.approx(pitch_radius + 0.9 * 0.8, abs=1e-12)
    assert root == pytest.approx(pitch_radius - 1.212 * 0.8, abs=1e-12)
    assert 1.0 / profile.segments[1, 3] == pytest.approx(1.0802 * 0.8 - 0.0072, abs=1e-12)
    ring = geometry.circular_spline.position(0.0) - (0.0, 0.8 * 206 / 2)
    assert np.linalg.norm(ring) == pytest.approx(0.8 * (206 / 2 - design.circular_spline.profile.addendum), abs=1e-12)
    assert -1.0 / profile.segments[4, 3] == pytest.approx(0.55 * 0.8, abs=1e-12)
    assert geometry.neutral_curve.radius == pytest.approx(79.8304, abs=1e-12)
    assert geometry.neutral_curve.displacement(0.0)[0] == pytest.approx(0.848, abs=1e-12)


def test_the_same_outline_as_pieces_is_the_same_geometry() -> None:
    """The circular spline's arc and line, written as a chain, give the clearances of the built-in kind."""
    built_in = case().replace("circular_spline.profile.addendum", 0.9)
    pieces = case().replace("circular_spline.profile", circular_spline_as_pieces())
    index = np.linspace(0.0, 51.0, 103)
    expected = Geometry.of(built_in).engagement.clearances(index).gap
    assert Geometry.of(pieces).engagement.clearances(index).gap == pytest.approx(expected, abs=1e-9)


FLEXSPLINE, CIRCULAR_SPLINE = "flexspline.profile", "circular_spline.profile"
TALL = {"kind": "table", "w0": 5.0, "fourier": [0.1, 1.5, -0.6]}
# From the tip corner straight down, out to the left across the axis, and to the root.
ZIGZAG: list[dict[str, Any]] = [
    {"to": [0.4, 0.0]},
    {"to": [-0.4, -0.2], "corner": True},
    {"to": [0.8, -1.14689], "corner": True},
]
# A ledge 0.05 modules wide, which an offset of 0.1 modules swallows.
LEDGE: list[dict[str, Any]] = [
    {"to": [0.5, 0.0]},
    {"to": [0.55, 0.0], "corner": True},
    {"to": [0.8, -1.14689], "corner": True},
]


def chain(pieces: list[dict[str, Any]], offset: float = 0.0) -> dict[str, Any]:
    start = [0.4, 0.90078]
    keys = {"addendum": 0.9, "dedendum": 1.15, "start": start, "pieces": pieces, "offset": offset}
    return {CIRCULAR_SPLINE: {"kind": "pieces"} | keys}


@pytest.mark.parametrize(
    ("changes", "key", "problem"),
    [
        ({f"{FLEXSPLINE}.addendum": 2.5}, f"{FLEXSPLINE}.addendum", "does not reach the addendum circle"),
        ({f"{FLEXSPLINE}.tip_arc_center[0]": -0.9}, f"{FLEXSPLINE}.addendum", "no tip land is left"),
        ({f"{CIRCULAR_SPLINE}.addendum": 103.5}, f"{CIRCULAR_SPLINE}.addendum", "tip radius"),
        (
            {f"{FLEXSPLINE}.tip_arc_center[1]": 1.7, f"{FLEXSPLINE}.flank_angle": 0.5},
            FLEXSPLINE,
            "an arc must sweep less than 180",
        ),
        (
            {f"{FLEXSPLINE}.dedendum": 60.0, f"{FLEXSPLINE}.root_fillet_radius": 0.0},
            f"{FLEXSPLINE}.dedendum",
            "does not reach the root circle",
        ),
        ({f"{CIRCULAR_SPLINE}.tip_arc_center[0]": 0.2}, f"{CIRCULAR_SPLINE}.dedendum", "beyond mid-space"),
        ({f"{FLEXSPLINE}.root_fillet_radius": 2.0}, f"{FLEXSPLINE}.root_fillet_radius", "does not fit"),
        ({f"{FLEXSPLINE}.offset": -1.0}, f"{FLEXSPLINE}.offset", "inside out"),
        ({f"{FLEXSPLINE}.offset": 2.0}, f"{FLEXSPLINE}.offset", "inside out"),
        (chain(ZIGZAG), CIRCULAR_SPLINE, "cross"),
        (chain(LEDGE, offset=0.08), f"{CIRCULAR_SPLINE}.offset", "no longer meets the piece before it"),
        ({"wave_generator.w0": 30.0}, "wave_generator.w0", "not a convex loop"),
        ({"wave_generator": {"kind": "ellipse", "w0": 60.0}}, "wave_generator.w0", "no ellipse has the semi-axis"),
        ({"wave_generator": TALL}, "wave_generator.w0", "cannot be kept"),
    ],
)
def test_a_geometry_that_cannot_be_is_a_fault_of_the_key_to_change(
    changes: dict[str, Any], key: str, problem: str
) -> None:
    design = case().replace(changes)
    with pytest.raises(DesignError) as caught:
        Geometry.of(design)
    (fault,) = caught.value.faults
    assert fault.key == key
    assert problem in fault.problem
    assert fault.remedy


def test_a_fault_that_an_offset_may_have_caused_names_the_offset_too() -> None:
    with pytest.raises(DesignError) as caught:
        Geometry.of(case().replace({f"{FLEXSPLINE}.offset": -0.1, f"{CIRCULAR_SPLINE}.tip_arc_center[0]": 0.2}))
    thinned, thick = caught.value.faults
    assert thinned.remedy.endswith("or bring flexspline.profile.offset = -0.1 mm nearer to 0")
    assert "offset" not in thick.remedy


def test_faults_of_all_parts_come_at_once_with_the_values_of_the_design() -> None:
    design = case().replace(
        {
            "flexspline.profile.root_fillet_radius": 2.0,
            "circular_spline.profile.addendum": 103.5,
            "wave_generator.w0": 30.0,
        }
    )
    with pytest.raises(DesignError) as caught:
        Geometry.of(design)
    assert [(fault.key, fault.value, fault.unit) for fault in caught.value.faults] == [
        ("flexspline.profile.root_fillet_radius", 2.0, "modules"),
        ("circular_spline.profile.addendum", 103.5, "modules"),
        ("wave_generator.w0", 30.0, "mm"),
    ]


def test_the_catalogue_holds_exactly_the_codes_of_the_kernel() -> None:
    codes = set(re.findall(r'=> "([a-z-]+)"', KERNEL_ERRORS.read_text()))
    assert codes == {*PROFILE_FAULTS, *CURVE_FAULTS, *RULED_OUT}
    assert not RULED_OUT & {*PROFILE_FAULTS, *CURVE_FAULTS}


@pytest.mark.parametrize("catalogue", [PROFILE_FAULTS, CURVE_FAULTS])
def test_every_key_blamed_is_a_key_of_the_design(catalogue: dict[str, tuple[str, str, str]]) -> None:
    owner: Any = case().flexspline if catalogue is PROFILE_FAULTS else case().wave_generator
    for name, unit, remedy in catalogue.values():
        value = owner
        for part in name.split("."):
            value = getattr(value, part)
        assert isinstance(value, float | int) == bool(unit)
        assert "" not in {remedy, str(Fault(name, problem="is wrong", remedy=remedy))}
