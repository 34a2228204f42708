"""What of a gear is exported, and in which state."""

from __future__ import annotations

import math
from dataclasses import dataclass

from strainwave._kernel import Engagement, GeometryError, Profile
from strainwave.design import CircularSpline, Design, Flexspline
from strainwave.errors import StrainwaveError
from strainwave.geometry import Geometry, spline_profile
from strainwave.outlines.part import PARTS, Part

GREATEST_CLEARANCE_MODULES = 1.0


@dataclass(frozen=True)
class ExportChoice:
    """The parts, one tooth or all, as made or as assembled, with or without clearance for printing."""

    only: tuple[Part, ...] = ()
    """The parts; of none named, all, and of one tooth both splines."""
    tooth: int | None = None
    """The one tooth of each spline; None for whole gears."""
    generator_angle_deg: float | None = None
    """The wave generator's angle in the deformed assembly; None for the parts as they are made."""
    printing_clearance_mm: float = 0.0
    """How far the toothed outlines in the file are set back into the material, everywhere: flanks, tips and roots. For
    printers that print too thick and for the kerf of a wire; below 0 material is left on. Not a part of the design, as
    `offset` is, which moves flanks only, and on top of it; nor the backlash, which grows by twice as much."""

    @property
    def parts(self) -> tuple[Part, ...]:
        """The parts that are exported, in their usual order."""
        if self.only:
            return tuple(part for part in PARTS if part in self.only)
        return PARTS if self.tooth is None else PARTS[:2]

    @property
    def is_deformed(self) -> bool:
        """Whether the flexspline is shown as the wave generator deforms it."""
        return self.generator_angle_deg is not None

    @property
    def generator_angle(self) -> float:
        """The wave generator's angle, rad; 0 where the parts are as made."""
        return math.radians(self.generator_angle_deg or 0.0)

    def geometry(self, design: Design) -> Geometry:
        """The geometry of the design, its outlines set back by the printing clearance.

        StrainwaveError where the choice makes no sense or the teeth have no room for the clearance.
        """
        self.check(design)
        geometry = Geometry.of(design)
        if not self.printing_clearance_mm:
            return geometry
        flexspline = self._set_back(design, design.flexspline)
        circular_spline = self._set_back(design, design.circular_spline)
        curve = geometry.neutral_curve
        return Geometry(flexspline, circular_spline, curve, Engagement(flexspline, circular_spline, curve))

    def _set_back(self, design: Design, spline: Flexspline | CircularSpline) -> Profile:
        internal = spline is design.circular_spline
        try:
            return spline_profile(design.module, spline, internal=internal, set_back_mm=self.printing_clearance_mm)
        except GeometryError as error:
            raise StrainwaveError(
                f"the printing clearance of {self.printing_clearance_mm:g} mm leaves the "
                f"{'circular spline' if internal else 'flexspline'} no possible tooth: {error}. Bring it nearer to 0"
            ) from None

    def __str__(self) -> str:
        """What is exported, in words."""
        names = [part.replace("-", " ") for part in self.parts]
        words = " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
        words = words if self.tooth is None else f"tooth {self.tooth} of the {words.replace(' and ', ' and of the ')}"
        state = f"assembled, the wave generator at {self.generator_angle_deg:g}°" if self.is_deformed else "as made"
        moved = self.printing_clearance_mm
        clearance = f", the teeth {abs(moved):g} mm {'thinner' if moved > 0.0 else 'thicker'} all round for printing"
        return f"{words}, {state}{clearance if moved else ''}"

    def check(self, design: Design) -> None:
        """StrainwaveError where the choice makes no sense for the design; whether teeth have room shows later."""
        unknown = [part for part in self.only if part not in PARTS]
        if unknown:
            raise StrainwaveError(f"there is no part {unknown[0]!r}; the parts are {', '.join(PARTS)}")
        if self.generator_angle_deg is not None and not math.isfinite(self.generator_angle_deg):
            raise StrainwaveError("the wave generator's angle must be a finite number of degrees")
        greatest = GREATEST_CLEARANCE_MODULES * design.module
        if not abs(self.printing_clearance_mm) <= greatest:
            raise StrainwaveError(
                f"the printing clearance must be from {-greatest:g} to {greatest:g} mm (one module), "
                f"not {self.printing_clearance_mm:g} mm"
            )
        if self.printing_clearance_mm and self.parts == ("wave-generator",):
            raise StrainwaveError(
                "the wave generator has no teeth to set back; leave out the printing clearance (--printing-clearance)"
            )
        if self.tooth is not None:
            self._check_tooth(design, self.tooth)

    def _check_tooth(self, design: Design, tooth: int) -> None:
        if "wave-generator" in self.parts:
            raise StrainwaveError("one tooth can be exported of the splines only; the wave generator has none")
        for part, spline in (("flexspline", design.flexspline), ("circular-spline", design.circular_spline)):
            if part in self.parts and not -spline.teeth < tooth < spline.teeth:
                raise StrainwaveError(
                    f"tooth {tooth} is not there: the teeth of the {part.replace('-', ' ')} are numbered from 0 to "
                    f"{spline.teeth - 1} clockwise, or from -1 to {1 - spline.teeth} the other way"
                )
