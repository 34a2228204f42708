"""A chain of segments written as the table of a "pieces" profile."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from strainwave.columns import Floats
from strainwave.fitting import ends
from strainwave.profiles.pieces import GREATEST_TANGENT_TURN_DEG
from strainwave.quantities import GREATEST_RADIUS

_SMOOTH = math.radians(GREATEST_TANGENT_TURN_DEG)


def pieces_table(segments: Floats, module: float, *, addendum: float, dedendum: float, **keys: float) -> dict[str, Any]:
    """The table of a "pieces" profile whose flank is a chain of segments (n, 5), mm, as `ToothProfile.flank` has them.

    `module` in mm; `addendum` and `dedendum` (modules) of the circles on which the chain begins and ends; more keys as
    the profile has them. The table goes into a design: `design.replace("flexspline.profile", table)`.
    """
    points = (np.concatenate([segments[:1, :2], ends(segments)]) / module).tolist()
    turns = np.diff(segments[:, 2]) - segments[:-1, 3] * segments[:-1, 4]
    is_corner = np.abs([0.0, *(math.remainder(turn, math.tau) for turn in turns)]) > _SMOOTH
    pieces: list[dict[str, Any]] = []
    for point, curvature, corner in zip(points[1:], (segments[:, 3] * module).tolist(), is_corner, strict=True):
        piece: dict[str, Any] = {"to": point}
        if abs(curvature) * GREATEST_RADIUS > 1.0:
            piece["radius"] = 1.0 / curvature
        if corner:
            piece["corner"] = True
        pieces.append(piece)
    return {"kind": "pieces", "addendum": addendum, "dedendum": dedendum, **keys, "start": points[0], "pieces": pieces}
