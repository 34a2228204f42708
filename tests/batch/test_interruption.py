"""A batch ends soon once it is interrupted, in the middle of a row too, and other threads go on while it runs."""

from __future__ import annotations

import signal
import threading
import time
from typing import Any

import numpy as np
import pytest

from strainwave import Geometry, evaluate_batch
from strainwave._kernel import Profile
from strainwave.design import Design
from tests.batch.variations import varied_design
from tests.designs import case

SOON_S = 8.0  # far more than an idle machine needs, far less than a row of `slow_design`


class InterruptionError(Exception):
    """What Ctrl-C raises here, where KeyboardInterrupt would end the tests."""


def slow_design() -> Design:
    """Flanks of 200 arcs that overlap deeply: half a minute for the least backlash in motion."""
    design = case("cosine-calibrated").replace(
        {"flexspline.teeth": 50, "circular_spline.teeth": 52, "flexspline.profile.root_fillet_radius": 0.0}
    )
    geometry = Geometry.of(design)
    return design.replace(
        {
            "flexspline.profile": in_arcs(geometry.flexspline, design.flexspline.profile, design.module),
            "circular_spline.profile": in_arcs(geometry.circular_spline, design.circular_spline.profile, design.module),
            "flexspline.neutral_radius": design.neutral_radius_mm,
        }
    )


def in_arcs(profile: Profile, spec: Any, module: float) -> dict[str, Any]:
    """The flank as the keys of a chain, each of its two pieces in a hundred parts."""
    pieces = [number for number, role in enumerate(profile.roles) if role == "flank"]
    lengths = [np.linspace(profile.knots[number], profile.knots[number + 1], 101) for number in pieces]
    start = profile.position(lengths[0][0]) / module
    chain = [
        {"to": (profile.position(length) / module).tolist()}
        | ({"radius": 1.0 / (curvature * module)} if curvature else {})
        for number, along in zip(pieces, lengths, strict=True)
        for curvature in [float(profile.segments[number, 3])]
        for length in along[1:]
    ]
    depths = {"addendum": spec.addendum, "dedendum": spec.dedendum}
    return {"kind": "pieces", "start": start.tolist(), "pieces": chain} | depths


@pytest.mark.parametrize("rows", [1, 8, 9])
def test_a_slow_row_is_interrupted(rows: int) -> None:
    """Few rows are evaluated on the thread that asks, more on others."""

    def ring(*_: Any) -> None:
        raise InterruptionError

    design = slow_design()
    before = signal.signal(signal.SIGALRM, ring)
    begun = time.monotonic()
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with pytest.raises(InterruptionError):
            evaluate_batch(design, ["wave_generator.w0"], [[0.848]] * rows, in_motion=True)
        assert time.monotonic() - begun < SOON_S
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def test_other_threads_go_on() -> None:
    """While the curves of a batch are made, too: no other thread of Python waits for a good part of it."""
    design, ended, beats = varied_design("fourier"), threading.Event(), [time.monotonic()]

    def beat() -> None:
        while not ended.wait(0.002):
            beats.append(time.monotonic())

    other = threading.Thread(target=beat)
    other.start()
    begun = time.monotonic()
    evaluate_batch(design, ["wave_generator.fourier[2]"], np.full((20_000, 1), 0.02), threads=1)
    whole = time.monotonic() - begun
    ended.set()
    other.join()
    assert np.diff([*beats, begun + whole]).max() < 0.4 * whole
