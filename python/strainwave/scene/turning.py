"""How far each part has turned, as one of the two splines is held."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, Self, get_args

from strainwave.analysis.analyze import GREATEST_ANGLE_DEG
from strainwave.design import Design
from strainwave.errors import StrainwaveError

Fixed = Literal["circular-spline", "flexspline"]


@dataclass(frozen=True)
class Turning:
    """Angles clockwise from the position in which tooth 0 stands on the major axis, which is +Y; degrees.

    While the generator turns once against the circular spline, the flexspline falls back by the difference of the tooth
    numbers: the ratio is -z_f / (z_c - z_f) with the circular spline fixed and z_c / (z_c - z_f) with the flexspline
    fixed (C. W. Musser, US patent 2,906,143, 1959).
    """

    generator_deg: float
    circular_spline_deg: float
    flexspline_deg: float
    """Of its teeth on average; each also moves with its rim."""

    @classmethod
    def of(cls, design: Design, generator_angle_deg: float, fixed: Fixed) -> Self:
        """Where a generator at this angle brings the spline that is free to turn.

        StrainwaveError where the angle is beyond 1e6 degrees or no such spline is held.
        """
        if fixed not in get_args(Fixed):
            raise StrainwaveError(f'the spline held fixed is "circular-spline" or "flexspline", not {fixed!r}')
        if not abs(generator_angle_deg) <= GREATEST_ANGLE_DEG:
            allowed = f"from -{GREATEST_ANGLE_DEG:.0f} to {GREATEST_ANGLE_DEG:.0f} degrees"
            raise StrainwaveError(f"the generator angle must be {allowed}, not {generator_angle_deg:g}")
        flexspline, ring = design.flexspline.teeth, design.circular_spline.teeth
        if fixed == "flexspline":
            return cls(generator_angle_deg, generator_angle_deg * (ring - flexspline) / ring, 0.0)
        return cls(generator_angle_deg, 0.0, generator_angle_deg / design.ratio + 0.0)

    @property
    def relative_rad(self) -> float:
        """The generator's angle against the circular spline, on which all engagement depends; radians."""
        return math.radians(self.generator_deg - self.circular_spline_deg)
