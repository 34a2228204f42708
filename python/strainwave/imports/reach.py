"""A flank's chain cut or continued to the tip circle and the root circle."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.imports.drawn_chain import DrawnChain
from strainwave.imports.placement import Placement

FARTHEST = 0.25  # modules; a flank that ends farther from its circle is not continued to it
CHOSEN_BY = {"tip": "the addendum (--addendum)", "root": "the dedendum (--dedendum)"}
STEPS = 80
PLACES = 2001


def reaching(chain: DrawnChain, placement: Placement, *, tip_height: float, root_height: float) -> DrawnChain:
    """A chain from tip to root, in the tooth's frame, ended at two heights over the pitch circle (mm).

    StrainwaveError where it turns back on its way, or ends too far from a height to be continued to it.
    """
    _check_falls(chain, placement)
    chain = _ended(chain, placement, root_height, "root")
    # The tip is the end of the reversed chain.
    return _ended(chain.reversed(), placement, tip_height, "tip").reversed()


def _check_falls(chain: DrawnChain, placement: Placement) -> None:
    points = chain.sampled(16)
    rises = np.diff(placement.heights_in_tooth(points))
    highest = int(rises.argmax())
    if rises[highest] > 1e-6 * float(placement.gear.module[0]):
        x, y = points[highest]
        raise StrainwaveError(
            f"turns back at ({x:.6g}, {y:.6g}) mm in the tooth's frame: it is not one simple flank that falls from the "
            "tip to the root"
        )


def _ended(chain: DrawnChain, placement: Placement, height: float, circle: str) -> DrawnChain:
    """The chain with its last point moved along its last piece, or the one that passes the height."""
    heights = placement.heights_in_tooth(chain.points)
    sign = -1.0 if circle == "root" else 1.0
    beyond = sign * (heights - height)
    past = np.flatnonzero(beyond[1:] >= 0.0)
    last = int(past[0]) if len(past) else len(chain) - 1
    module = float(placement.gear.module[0])
    if beyond[0] >= 0.0 or -beyond[last + 1] > FARTHEST * module:
        high, low = max(heights[0], heights[-1]), min(heights[0], heights[-1])
        raise StrainwaveError(
            f"has a flank from {high:.6g} to {low:.6g} mm over the pitch circle, and its {circle} circle is to lie at "
            f"{height:.6g} mm. It is cut, or continued by up to {FARTHEST:g} modules of {module:g} mm: choose "
            f"{CHOSEN_BY[circle]} accordingly"
        )
    return _moved_end(chain.part(0, last + 1), placement, height, sign)


def _moved_end(chain: DrawnChain, placement: Placement, height: float, sign: float) -> DrawnChain:
    """By bisection along the last piece's own line or circle."""
    segment = chain.segments[-1]

    def beyond(along: float) -> float:
        return sign * (float(placement.heights_in_tooth(_on(segment, along)[None, :])[0]) - height)

    low, high = 0.0, float(segment[4])
    if beyond(high) < 0.0:
        turn = abs(float(segment[3]))
        farthest = min(high + 4.0 * FARTHEST * float(placement.gear.module[0]), 3.0 / turn if turn else math.inf)
        places = np.linspace(high, max(high, farthest), PLACES)
        reached = sign * placement.heights_in_tooth(np.array([_on(segment, place) for place in places]))
        # As far as the circle, or where the piece runs level short of it, as a fillet does at the root circle.
        high = float(places[np.argmax(np.minimum(reached, sign * height))])
    for _ in range(STEPS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if beyond(middle) < 0.0 else (low, middle)
    points = chain.points.copy()
    points[-1] = _on(segment, high)
    return replace(chain, points=points)


def _on(segment: Floats, along: float) -> Floats:
    x, y, angle, curvature, _ = segment
    half_turn = 0.5 * curvature * along
    chord = along * np.sinc(half_turn / np.pi)
    return np.array([x + chord * np.cos(angle + half_turn), y - chord * np.sin(angle + half_turn)])
