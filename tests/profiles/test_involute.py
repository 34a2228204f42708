"""Involute flanks against the involute as the end of an unwinding thread."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from strainwave.design import Design
from strainwave.errors import DesignError
from strainwave.geometry import Geometry
from strainwave.profiles import Gear, Involute
from tests.designs import case
from tests.fitting.deviation import joins, of_the_curve_from_the_chain, on

Floats = NDArray[np.float64]

PROFILES = {
    "usual": {"pressure_angle": 20.0, "addendum": 0.9, "dedendum": 1.2},
    "steep": {"pressure_angle": 30.0, "addendum": 0.6, "dedendum": 0.8, "profile_shift": 0.2},
    "filleted": {"pressure_angle": 20.0, "addendum": 0.9, "dedendum": 1.2, "root_fillet_radius": 0.3},
    "shifted": {"pressure_angle": 20.0, "addendum": 2.9, "dedendum": 0.1, "profile_shift": 1.0},
    "near the base circle": {"pressure_angle": 14.5, "addendum": 0.9, "dedendum": 1.2},
}
TEETH = [72, 100, 204, 1000]
CASES = [
    (name, teeth, internal)
    for name in PROFILES
    for teeth in TEETH
    for internal in (False, True)
    if (teeth > 80 or name != "near the base circle") and not (name == "shifted" and internal)
]


def profile(name: str) -> Involute:
    return Involute.model_validate({"kind": "involute"} | PROFILES[name])


def thread_end(spec: Involute, gear: Gear, radii: Floats) -> Floats:
    """Points of the right flank in the tooth's frame (mm) at radii from the gear's centre.

    The thread leaves the base circle at angle a and is as long as the arc from where the flank starts on that circle;
    the flank is turned so that at the pitch circle it lies half a tooth's thickness from the axis.
    """
    module, pitch = gear.module[0], 0.5 * gear.module[0] * gear.teeth
    base = pitch * math.cos(math.radians(spec.pressure_angle))

    def unwound(radius: Floats | float) -> Floats:
        length = np.sqrt(np.asarray(radius) ** 2 - base**2)
        angle = length / base
        ends = base * np.stack([np.cos(angle), np.sin(angle)], -1) + length[..., None] * np.stack(
            [np.sin(angle), -np.cos(angle)], -1
        )
        angles: Floats = np.arctan2(ends[..., 1], ends[..., 0])
        return angles

    sign = -1.0 if gear.internal else 1.0
    thickness = module * (math.pi / 2 + sign * 2 * spec.profile_shift * math.tan(math.radians(spec.pressure_angle)))
    from_axis = thickness / 2 / pitch - sign * (unwound(radii) - unwound(pitch))
    return np.stack([radii * np.sin(from_axis), sign * (radii * np.cos(from_axis) - pitch)], -1)


@pytest.mark.parametrize(("name", "teeth", "internal"), CASES)
def test_the_arcs_follow_the_involute(name: str, teeth: int, internal: bool) -> None:
    """At 10,000 points each way within 1e-5 modules, which is 0.01 um in a module of 1 mm."""
    spec, gear = profile(name), Gear.of(0.8, teeth, internal=internal)
    rows = spec.flank(gear)
    center = np.array([0.0, 0.4 * teeth if internal else -0.4 * teeth])
    reached = np.hypot(*(on(rows, 2) - center).T)
    involute = thread_end(spec, gear, np.linspace(reached[0], reached[1], 10_000))
    assert of_the_curve_from_the_chain(rows, involute) < 0.8e-5
    chain = on(rows, 10_000)
    feet = thread_end(spec, gear, np.hypot(*(chain - center).T))
    assert np.hypot(*(chain - feet).T).max() < 1.5e-5  # along the pitch circle, so a little more than the distance
    gap, turn = joins(rows)
    assert gap < 1e-12
    assert turn < 1e-10


@pytest.mark.parametrize("teeth", [100, 204, 1000])
@pytest.mark.parametrize("internal", [False, True])
def test_the_deviation_is_that_of_joins_that_lean(internal: bool, teeth: int) -> None:
    """An arc over a step d of the roll angle deviates by r_b d^3 / (72 sqrt 3), where a biarc with the involute's own
    tangents deviates by three times as much; a biarc's joint lies only near the best place, which costs a little."""
    spec, gear = profile("usual"), Gear.of(1.0, teeth, internal=internal)
    rows = spec.flank(gear)
    sign = -1.0 if internal else 1.0
    radii = 0.5 * teeth + sign * np.array([0.9, -1.2])
    base = 0.5 * teeth * math.cos(math.radians(20.0))
    step = abs(float(np.diff(np.sqrt(radii**2 - base**2))[0])) / base / len(rows)
    found = of_the_curve_from_the_chain(rows, thread_end(spec, gear, np.linspace(radii[0], radii[1], 10_000)))
    law = base * step**3 / (72 * math.sqrt(3))
    assert law < found < 1.5 * law


@pytest.mark.parametrize("internal", [False, True])
def test_the_flank_goes_from_the_tip_circle_to_the_root_circle(internal: bool) -> None:
    spec, gear = profile("usual"), Gear.of(0.8, 204, internal=internal)
    sign = -1.0 if internal else 1.0
    ends = on(spec.flank(gear), 2)
    radii = np.hypot(ends[:, 0], 81.6 + sign * ends[:, 1])
    assert radii == pytest.approx([81.6 + sign * 0.72, 81.6 - sign * 0.96], abs=1e-11)


@pytest.mark.parametrize("spline", ["flexspline", "circular_spline"])
@pytest.mark.parametrize("offset", [0.0, -0.03, 0.03])
def test_the_fillet_joins_where_the_flank_ends(spline: str, offset: float) -> None:
    """The kernel has to cut or extend the last arc by nothing, on either gear and with an offset."""
    keys = {"kind": "involute", "offset": offset} | PROFILES["filleted"]
    design = case().replace(f"{spline}.profile", keys)
    found = getattr(Geometry.of(design), spline)
    toothed = getattr(design, spline)
    last = found.roles.index("fillet") - 1
    nominal = toothed.profile.flank(Gear.of(0.8, toothed.teeth, internal=spline == "circular_spline"))[last - 1]
    length = nominal[4] * (1.0 + nominal[3] * offset)
    assert found.segments[last, 4] == pytest.approx(length, abs=2e-5)
    first = toothed.profile.flank(Gear.of(0.8, toothed.teeth, internal=spline == "circular_spline"))[0]
    assert found.segments[1, 4] == pytest.approx(first[4] * (1.0 + first[3] * offset), abs=1e-5)


def involute_pair(**keys: float) -> Design:
    shape = {"kind": "involute", "pressure_angle": 25.0, "addendum": 0.5, "dedendum": 0.7}
    changed = shape | keys
    return case().replace({"flexspline.profile": changed, "circular_spline.profile": shape})


@pytest.mark.parametrize(
    ("keys", "problem"),
    [
        ({"pressure_angle": 5.0}, r"flexspline.profile.dedendum = 0.7 modules: takes the flank to the base circle"),
        ({"root_fillet_radius": 3.0}, "flexspline.profile.root_fillet_radius = 3.0 modules: leaves no flank"),
        ({"pressure_angle": 90.0}, "pressure_angle = 90.0 degrees: must be an angle"),
        ({"profile_shift": 1e3}, "profile_shift = 1000.0 modules: must be a number from -100 to 100"),
    ],
)
def test_an_involute_that_cannot_be_is_refused(keys: dict[str, float], problem: str) -> None:
    with pytest.raises(DesignError, match=problem) as caught:
        involute_pair(**keys)
    assert len(caught.value.faults) == 1
