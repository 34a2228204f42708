"""What to take as given about a file that holds a profile."""

from __future__ import annotations

import math
from dataclasses import dataclass

from strainwave.errors import StrainwaveError
from strainwave.imports.length_unit import UNITS


@dataclass(frozen=True)
class ImportHints:
    """How to read a file, where it is not to be found out."""

    unit: str | None = None
    """One of `UNITS`; left out, what the file says, else modules in JSON and mm elsewhere."""
    layer: str | None = None
    """Layer of a DXF drawing; left out, all."""
    center_mm: tuple[float, float] | None = None
    """The gear's centre; left out, the origin, or a point of the y axis where the origin is on the pitch circle."""
    axis_deg: float | None = None
    """Direction from the centre to the tooth, clockwise from +y; left out, a tooth's symmetry or the y axis."""
    addendum: float | None = None
    """Height of the tip circle, modules; left out, that of the land or the flank's end."""
    dedendum: float | None = None
    """Depth of the root circle, modules; left out, that of the flank's end."""
    noise_um: float | None = None
    """Standard deviation of points; left out, it is estimated."""
    tolerance_um: float | None = None
    """Greatest distance of arcs from the curve that they follow; left out, 0.01 for curves and 0.05 for points."""

    def __post_init__(self) -> None:
        if self.unit is not None and self.unit not in UNITS:
            raise StrainwaveError(f"{self.unit!r} is no unit of length known here; known are {', '.join(UNITS)}")
        for name in ("addendum", "dedendum", "noise_um", "tolerance_um"):
            value = getattr(self, name)
            least = 0.0 if name == "noise_um" else math.ulp(0.0)
            if value is not None and not (math.isfinite(value) and value >= least):
                raise StrainwaveError(f"{name} must be a positive number, not {value:g}")
        numbers = [*(self.center_mm or ()), *([] if self.axis_deg is None else [self.axis_deg])]
        if not all(math.isfinite(number) for number in numbers):
            raise StrainwaveError("the centre and the axis must be finite numbers")
