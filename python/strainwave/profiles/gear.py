"""What a tooth profile must know of the gear that has it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats


@dataclass(frozen=True, eq=False)
class Gear:
    """The gear of a profile, in every row of a batch."""

    module: Floats
    """mm, (rows,) or, where it is the same in all, (1,)."""
    teeth: int
    internal: bool
    """Whether it is the circular spline, whose teeth point inwards."""

    @property
    def side(self) -> float:
        """Where a tooth's tip lies: 1 outwards, -1 inwards."""
        return -1.0 if self.internal else 1.0

    @classmethod
    def of(cls, module: float, teeth: int, *, internal: bool) -> Self:
        """The gear of one design, its module in mm."""
        return cls(np.array([module], dtype=np.float64), teeth, internal)
