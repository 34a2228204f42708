"""Long work of the kernel ends soon once it is interrupted, and other threads go on while it runs."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any

import numpy as np
import pytest

from strainwave import Geometry, evaluate_batch
from strainwave.design import Design
from tests.batch.variations import varied_design
from tests.designs import case, in_pieces

SOON_S = 8.0  # far more than an idle machine needs, far less than `slow_design`


class InterruptionError(Exception):
    """What Ctrl-C raises here, where KeyboardInterrupt would end the tests."""


@contextmanager
def alarm(after_s: float) -> Iterator[None]:
    """Raises InterruptionError in this thread, as Ctrl-C does."""

    def ring(*_: Any) -> None:
        raise InterruptionError

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, after_s)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def slow_design() -> Design:
    """Flanks of 200 arcs that overlap deeply: half a minute for the least backlash in motion."""
    few_teeth = {"flexspline.teeth": 50, "circular_spline.teeth": 52, "flexspline.profile.root_fillet_radius": 0.0}
    return in_pieces(case("cosine-calibrated").replace(few_teeth), 200)


def in_batch(rows: int) -> Callable[[Design], object]:
    return partial(evaluate_batch, parameters=["wave_generator.w0"], values=[[0.848]] * rows, in_motion=True)


@pytest.mark.parametrize(
    "asked",
    [
        pytest.param(lambda design: Geometry.of(design).engagement.minimum_in_motion(1e-6), id="one design"),
        *(pytest.param(in_batch(rows), id=f"batch of {rows}") for rows in (1, 8, 9)),
    ],
)
def test_slow_work_is_interrupted(asked: Callable[[Design], object]) -> None:
    """A batch of few rows is evaluated on the thread that asks, one of more on others."""
    design = slow_design()
    begun = time.monotonic()
    with alarm(after_s=0.3), pytest.raises(InterruptionError):
        asked(design)
    assert time.monotonic() - begun < SOON_S


def test_other_threads_go_on() -> None:
    """While the curves of a batch are made, too: no other thread of Python waits for a good part of it."""
    design, ended, beats = varied_design("fourier"), threading.Event(), [time.monotonic()]

    def beat() -> None:
        while not ended.wait(0.002):
            beats.append(time.monotonic())

    other = threading.Thread(target=beat)
    other.start()
    begun = time.monotonic()
    evaluate_batch(design, ["wave_generator.fourier[2]"], np.full((40_000, 1), 0.02), threads=1)
    whole = time.monotonic() - begun
    ended.set()
    other.join()
    assert np.diff([*beats, begun + whole]).max() < 0.4 * whole
