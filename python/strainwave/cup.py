"""The flexspline's cup along its axis: where the parts lie, and how far the wave generator bends it there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import DesignError, Fault
from strainwave.quantities import MM

if TYPE_CHECKING:
    from strainwave._kernel import BatchCurves, NeutralCurve

BOSS_THICKNESSES = 3.0  # of the diaphragm, where the cup is deep enough
DEEPEST_BOSS = 0.5  # of the way from the diaphragm to the teeth


@dataclass(frozen=True)
class Cup:
    """Places along the axis in mm, from z = 0 on the diaphragm's outer face towards the open end.

    The diaphragm keeps its shape. From its inner face the displacement grows in proportion to z, and each section has
    the shape that the wave generator gives the section at mid-face, whose displacement at the major axis is w0. So does
    the wall of a cylinder that is bent without being stretched (Timoshenko and Woinowsky-Krieger, Theory of Plates and
    Shells, inextensional deformation of a circular cylindrical shell), and so does a strain wave gear (US 9,534,681:
    flexure "substantially proportional to a distance from the diaphragm").
    """

    design: Design
    diaphragm_mm: float
    """The diaphragm's inner face, where the wall begins."""
    boss_mm: float
    """The boss's inner face; its outer face is the diaphragm's."""
    face_start_mm: float
    """Where the teeth begin."""
    mid_face_mm: float
    """The section that the plane results hold for."""
    length_mm: float
    """The open end, where the teeth end."""
    half_engaged_mm: float
    """Half the length over which the teeth of both splines meet; its middle is mid-face."""
    half_ring_mm: float
    """Half the length of the circular spline, whose middle is mid-face too."""

    @classmethod
    def of(cls, design: Design) -> Self:
        """The cup of a design."""
        bodies = design.bodies
        diaphragm, face = bodies.diaphragm_thickness, bodies.face_width
        return cls(
            design=design,
            diaphragm_mm=diaphragm,
            boss_mm=min(BOSS_THICKNESSES * diaphragm, diaphragm + DEEPEST_BOSS * bodies.barrel_length),
            face_start_mm=bodies.cup_length - face,
            mid_face_mm=bodies.cup_length - 0.5 * face,
            length_mm=bodies.cup_length,
            half_engaged_mm=0.5 * min(face, bodies.ring_face_width),
            half_ring_mm=0.5 * bodies.ring_face_width,
        )

    @property
    def slope(self) -> float:
        """How much the displacement at the major axis grows along the wall, mm per mm."""
        return self.design.wave_generator.w0 / (self.mid_face_mm - self.diaphragm_mm)

    def w0_mm(self, z_mm: ArrayLike) -> Floats:
        """Displacement at the major axis of sections at `z_mm`, in its shape; 0 in the diaphragm."""
        beyond = np.maximum(np.asarray(z_mm, dtype=np.float64) - self.diaphragm_mm, 0.0)
        # The ratio first: at mid-face it is 1, and the section is that of the plane results to the last bit.
        return np.asarray(self.design.wave_generator.w0 * (beyond / (self.mid_face_mm - self.diaphragm_mm)))

    def engaged_mm(self, count: int) -> Floats:
        """`count` sections, evenly over the length on which the teeth meet, both ends included; shape ``(count,)``.

        Of an odd number the middle one is mid-face itself.
        """
        return self.mid_face_mm + self.half_engaged_mm * np.linspace(-1.0, 1.0, count)

    def curve(self, w0_mm: float) -> NeutralCurve:
        """Neutral curve of the section whose displacement is `w0_mm` > 0; DesignError where there is none."""
        from strainwave._kernel import GeometryError

        try:
            return self.design.wave_generator.section(self.design.neutral_radius_mm, w0_mm)
        except GeometryError as error:
            raise self.refusal(w0_mm, str(error)) from None

    def curves(self, w0_mm: Floats) -> BatchCurves:
        """The same for the rows of a batch, ``(rows,)``."""
        return self.design.wave_generator.sections(self.design.neutral_radius_mm, w0_mm)

    def refusal(self, w0_mm: float, reason: str | None) -> DesignError:
        """The rim may follow the generator at mid-face, and yet not where it is bent further: what is to be said."""
        z_mm = self.diaphragm_mm + w0_mm / self.slope
        problem = f"makes {w0_mm:.6g} mm of the section {z_mm:.6g} mm from the diaphragm's outer face, where {reason}"
        remedy = "Reduce it, or lengthen flexspline.cup_length, or shorten flexspline.face_width"
        return DesignError([Fault("wave_generator.w0", self.design.wave_generator.w0, MM, problem, remedy)])
