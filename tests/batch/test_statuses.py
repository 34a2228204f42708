"""Every status, and the fault of a design that it stands for."""

from __future__ import annotations

import re
from typing import Any

import pytest

from strainwave import Design, evaluate_batch
from strainwave.batch import STATUSES
from strainwave.design.design_rows import REFUSALS
from strainwave.geometry import CURVE_FAULTS, PROFILE_FAULTS
from tests.batch.variations import varied_design
from tests.designs import case

FLEXSPLINE, CIRCULAR_SPLINE = "flexspline.profile", "circular_spline.profile"
PIECES = f"{CIRCULAR_SPLINE}.pieces"
CORNERED = {
    "kind": "pieces",
    "addendum": 0.9,
    "dedendum": 1.15,
    "start": [0.4, 0.90078],
    "pieces": [{"to": [0.5, 0.0]}, {"to": [0.55, 0.0], "corner": True}, {"to": [0.8, -1.14689], "corner": True}],
}
TALL = {"kind": "table", "w0": 0.5, "fourier": [0.1, 1.5, -0.6]}

# For each status a design, numbers that bring it about, and words of the fault that it stands for.
CASES: list[tuple[str, Design, dict[str, float], str]] = [
    ("out-of-range", case(), {"wave_generator.w0": -1.0}, "must be a number from 0.0001"),
    ("out-of-range", case(), {f"{FLEXSPLINE}.flank_angle": 90.0}, "below 90 degrees"),
    ("out-of-range", case(), {f"{FLEXSPLINE}.tip_arc_center[1]": float("nan")}, "must be a number from -10000"),
    ("wall-too-thick", case(), {"flexspline.wall_thickness": 81.0}, "below the flexspline's root radius"),
    ("neutral-circle-too-large", case(), {"flexspline.neutral_radius": 83.0}, "below the flexspline's tip radius"),
    (
        "disk-radius-out-of-reach",
        varied_design("disk-radius"),
        {"wave_generator.disk_radius": 79.0},
        "must lie from 76.2",
    ),
    ("cam-too-large", varied_design("ellipse"), {"wave_generator.cam_to_neutral": 80.0}, "the cam lies inside"),
    ("piece-impossible", varied_design("cosine", "pieces"), {f"{PIECES}[0].radius": 0.1}, "no arc of radius 0.1"),
    ("piece-impossible", varied_design("cosine", "pieces"), {f"{PIECES}[0].radius": 0.0}, "no arc of radius 0 "),
    ("join-not-tangent", varied_design("cosine", "pieces"), {f"{PIECES}[0].radius": 3.0}, "a tangent join turns"),
    ("chain-off-circle", varied_design("cosine", "line"), {f"{FLEXSPLINE}.addendum": 0.51}, "on the addendum circle"),
    ("chain-off-circle", varied_design("cosine", "line"), {f"{FLEXSPLINE}.pieces[0].to[1]": -0.61}, "the root circle"),
    ("no-involute", varied_design("cosine", "involute"), {f"{FLEXSPLINE}.pressure_angle": 3.0}, "the base circle"),
    ("no-involute", varied_design("cosine", "involute"), {f"{CIRCULAR_SPLINE}.addendum": 13.0}, "the base circle"),
    ("no-involute", varied_design("cosine", "involute"), {f"{FLEXSPLINE}.root_fillet_radius": 3.0}, "leaves no flank"),
    ("shape-not-one", varied_design("samples"), {"wave_generator.samples[0]": 1.1}, "its first value is w(0)/w0"),
    ("shape-not-one", varied_design("fourier"), {"wave_generator.fourier[2]": 0.1}, "the sum of its coefficients"),
    ("no-room-in-cup", case(), {"flexspline.face_width": 80.0}, "leaves no smooth wall"),
    ("no-room-in-cup", case().replace("flexspline.cup_length", 60.0), {"module": 2.0}, "leaves no smooth wall"),
    ("boss-too-wide", case(), {"flexspline.boss_diameter": 158.1}, "below the cup's bore of 158.061 mm"),
    ("ring-too-thin", case(), {"circular_spline.outer_diameter": 166.6}, "above 166.64 mm"),
    ("tip-not-reached", case(), {f"{FLEXSPLINE}.addendum": 2.5}, "does not reach the addendum circle"),
    ("tip-pointed", case(), {f"{FLEXSPLINE}.tip_arc_center[0]": -0.9}, "no tip land is left"),
    ("not-positive", case(), {f"{CIRCULAR_SPLINE}.addendum": 103.5}, "tip radius is -0.4000 mm"),
    (
        "arc-too-long",
        case(),
        {f"{FLEXSPLINE}.tip_arc_center[1]": 1.7, f"{FLEXSPLINE}.flank_angle": 0.5},
        "must sweep less than 180",
    ),
    (
        "root-not-reached",
        case(),
        {f"{FLEXSPLINE}.dedendum": 60.0, f"{FLEXSPLINE}.root_fillet_radius": 0.0},
        "does not reach the root circle",
    ),
    ("space-too-narrow", case(), {f"{CIRCULAR_SPLINE}.tip_arc_center[0]": 0.2}, "beyond mid-space"),
    ("fillet-does-not-fit", case(), {f"{FLEXSPLINE}.root_fillet_radius": 2.0}, "does not fit"),
    ("radius-vanishes", case(), {f"{FLEXSPLINE}.offset": 2.0}, "inside out"),
    (
        "offset-opens-join",
        case().replace(CIRCULAR_SPLINE, CORNERED),
        {f"{CIRCULAR_SPLINE}.offset": 0.08},
        "no longer meets the piece before it",
    ),
    (
        "self-crossing",
        case().replace(CIRCULAR_SPLINE, CORNERED),
        {f"{PIECES}[0].to[1]": 0.0, f"{PIECES}[1].to[0]": -0.4, f"{PIECES}[1].to[1]": -0.2},
        "cross",
    ),
    ("curve-not-simple", case(), {"wave_generator.w0": 30.0}, "not a convex loop"),
    ("no-such-ellipse", varied_design("ellipse"), {"wave_generator.w0": 60.0}, "no ellipse has the semi-axis"),
    ("perimeter-not-kept", case().replace("wave_generator", TALL), {"wave_generator.w0": 5.0}, "cannot be kept"),
]


@pytest.mark.parametrize(("status", "design", "numbers", "problem"), CASES)
def test_a_row_has_the_fault_that_its_status_says(
    status: str, design: Design, numbers: dict[str, float], problem: str
) -> None:
    batch = evaluate_batch(design, list(numbers), [list(numbers.values())])
    assert batch.status.tolist() == [status]
    reason = batch.reason(0)
    assert reason is not None
    assert problem in reason
    assert next(iter(numbers)).split(".")[0] in reason or "module" in numbers


def test_every_status_is_tested_but_those_that_no_number_brings_about() -> None:
    """Numbers within their limits are finite and pieces that are possible have a length."""
    assert set(STATUSES) - {status for status, *_ in CASES} == {"ok", "not-finite", "bad-segment"}


def test_the_catalogue_is_closed() -> None:
    assert len(set(STATUSES)) == len(STATUSES)
    assert set(STATUSES) == {"ok", "out-of-range", *REFUSALS, *PROFILE_FAULTS, *CURVE_FAULTS}
    assert all(re.fullmatch("[a-z-]+", status) for status in STATUSES)


def test_the_first_fault_gives_the_status_and_the_reason_names_them_all() -> None:
    keys: dict[str, Any] = {
        "flexspline.profile.root_fillet_radius": 2.0,
        "circular_spline.profile.addendum": 103.5,
        "wave_generator.w0": 30.0,
    }
    batch = evaluate_batch(case(), list(keys), [list(keys.values())])
    assert batch.status[0] == "fillet-does-not-fit"
    reason = batch.reason(0)
    assert reason is not None
    assert all(key in reason for key in keys)
