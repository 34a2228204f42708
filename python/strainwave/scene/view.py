"""From where a scene is looked at."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.errors import StrainwaveError
from strainwave.scene.scene import Scene
from strainwave.scene.shape import Shape

# Room about what is looked at, in modules: about chosen teeth sideways, below and above; about the whole gear.
BESIDE, BELOW, ABOVE = 1.2, 3.4, 2.6
AROUND = 9.0
# At the top: half the window, and how far it reaches below the circular spline's pitch circle, in pitches.
AT_TOP, TOP_BELOW = 2.9, 3.4
# Teeth seen on either side of one that is chosen alone.
NEIGHBOURS = 3


@dataclass(frozen=True, eq=False)
class View:
    """A scene, turned for the look, and the window on it, mm."""

    scene: Scene
    turned_deg: float
    """Clockwise turn of everything against the gear's own frame."""
    x_mm: tuple[float, float]
    y_mm: tuple[float, float]
    teeth: tuple[Shape, ...]
    """The chosen teeth, from left to right; none in a view of the whole gear."""

    @classmethod
    def of_whole(cls, scene: Scene, module: float) -> Self:
        """Everything up to some way beyond the teeth; the circular spline's body may go on beyond."""
        reach = max(float(np.hypot(*tooth.outline_mm.T).max()) for tooth in scene.teeth) + AROUND * module
        return cls(scene, 0.0, (-reach, reach), (-reach, reach), ())

    @classmethod
    def of_top(cls, scene: Scene, module: float, pitch_radius_mm: float) -> Self:
        """The place at the top through which the teeth pass as the gear turns."""
        half, pitch = AT_TOP * math.pi * module, math.pi * module
        bottom = pitch_radius_mm - TOP_BELOW * pitch
        return cls(scene, 0.0, (-half, half), (bottom, bottom + 2.0 * half), ())

    @classmethod
    def of_teeth(cls, scene: Scene, module: float, first: int, last: int) -> Self:
        """The teeth numbered from `first` clockwise to `last`, their middle at the top; of one, its neighbours too.

        StrainwaveError where the gear has no such tooth.
        """
        chosen = _between(scene, first, last)
        middle = sum(complex(*tooth.outline_mm.mean(axis=0)) for tooth in chosen)
        angle = math.atan2(middle.real, middle.imag)
        turned = scene.turned(-angle)
        teeth = _between(turned, first, last)
        points = np.concatenate([tooth.outline_mm for tooth in teeth])
        (left, bottom), (right, top) = points.min(axis=0), points.max(axis=0)
        x = float(left) - BESIDE * module, float(right) + BESIDE * module
        return cls(
            turned, -math.degrees(angle), x, (float(bottom) - BELOW * module, float(top) + ABOVE * module), teeth
        )


def _between(scene: Scene, first: int, last: int) -> tuple[Shape, ...]:
    teeth = {tooth.tooth: tooth for tooth in scene.teeth}
    for number in (first, last):
        if number not in teeth:
            numbers = sorted(key for key in teeth if key is not None)
            allowed = f"are numbered from {numbers[0]} to {numbers[-1]}, 0 on the major axis at generator angle 0"
            raise StrainwaveError(f"there is no tooth {number}: the flexspline's {len(teeth)} teeth {allowed}")
    count = (last - first) % len(teeth) + 1
    around = scene.teeth
    start = next(place for place, tooth in enumerate(around) if tooth.tooth == first)
    if count == 1:
        start, count = start - NEIGHBOURS, 2 * NEIGHBOURS + 1
    return tuple(around[(start + step) % len(around)] for step in range(count))
