"""What is asked of the wizard, and what can be."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

from strainwave.errors import StrainwaveError
from strainwave.studies.comparison import DEFAULT_PARAMETERS
from strainwave.studies.wizard.proportions import PROFILES, TOOTH_DIFFERENCE

Use = Literal["power", "precision"]
USES: tuple[Use, ...] = get_args(Use)

LEAST_RATIO, GREATEST_RATIO = 30.0, 200.0
LEAST_DIAMETER_MM, GREATEST_DIAMETER_MM = 20.0, 200.0
# The article finds the elliptical cam best for power transmission, and the dual disk for precision positioning.
USUAL_GENERATORS: dict[Use, str] = {"power": "cosine", "precision": "dual-disk"}


@dataclass(frozen=True)
class Request:
    """A ratio with the circular spline fixed, without its sign, and the flexspline's pitch diameter in mm."""

    ratio: float
    pitch_diameter_mm: float
    generator: str
    profile: str
    use: Use

    @classmethod
    def of(
        cls, ratio: float, pitch_diameter_mm: float, generator: str | None = None, profile: str | None = None,
        use: str = "power",
    ) -> Request:  # fmt: skip
        """The request, what is left out filled in. ``StrainwaveError`` says what cannot be and the nearest that can."""
        faults = [*_names(generator, profile, use), *_numbers(ratio, pitch_diameter_mm)]
        nearest = _nearest(ratio, pitch_diameter_mm)
        if faults and nearest and not _names(generator, profile, use):
            faults.append(f"the nearest possible is ratio {nearest[0]:g} and pitch diameter {nearest[1]:g} mm")
        if faults:
            raise StrainwaveError("; ".join(faults))
        chosen: Use = "precision" if use == "precision" else "power"
        return cls(
            float(ratio),
            float(pitch_diameter_mm),
            generator or USUAL_GENERATORS[chosen],
            profile or next(iter(PROFILES)),
            chosen,
        )

    @property
    def flexspline_teeth(self) -> int:
        """z_f, from the ratio -z_f / (z_c - z_f)."""
        return round(TOOTH_DIFFERENCE * self.ratio)

    @property
    def module_mm(self) -> float:
        """Pitch diameter over number of teeth."""
        return self.pitch_diameter_mm / self.flexspline_teeth


def _names(generator: str | None, profile: str | None, use: str) -> list[str]:
    chosen = (
        ("wave generator", generator, tuple(DEFAULT_PARAMETERS)),
        ("profile", profile, tuple(PROFILES)),
        ("use", use, USES),
    )
    return [
        f'the {what} must be one of {", ".join(known)}, not "{name}"'
        for what, name, known in chosen
        if name is not None and name not in known
    ]


def _numbers(ratio: float, diameter: float) -> list[str]:
    faults = []
    if not LEAST_RATIO <= ratio <= GREATEST_RATIO:
        faults.append(f"the ratio must be from {LEAST_RATIO:g} to {GREATEST_RATIO:g}, not {ratio:g}")
    elif TOOTH_DIFFERENCE * ratio % 1.0:
        faults.append(f"the ratio {ratio:g} would need {TOOTH_DIFFERENCE * ratio:g} teeth, which is no whole number")
    if not LEAST_DIAMETER_MM <= diameter <= GREATEST_DIAMETER_MM:
        faults.append(
            f"the pitch diameter must be from {LEAST_DIAMETER_MM:g} to {GREATEST_DIAMETER_MM:g} mm, not {diameter:g}"
        )
    return faults


def _nearest(ratio: float, diameter: float) -> tuple[float, float] | None:
    """The nearest possible numbers; a ratio with its sign, -100, is near to one without."""
    if not (math.isfinite(ratio) and math.isfinite(diameter)):
        return None
    whole = round(TOOTH_DIFFERENCE * min(max(abs(ratio), LEAST_RATIO), GREATEST_RATIO)) / TOOTH_DIFFERENCE
    return whole, min(max(diameter, LEAST_DIAMETER_MM), GREATEST_DIAMETER_MM)
