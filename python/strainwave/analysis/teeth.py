"""Clearances of every tooth of a lobe, as arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import Engagement
from strainwave.analysis.witness import Witnesses
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.units import ARCSECONDS_PER_RADIAN, MICROMETRES_PER_MM


@dataclass(frozen=True, eq=False, repr=False)
class Teeth:
    """One entry per tooth, from the left of the generator's major axis to the right; shape ``(teeth,)``.

    ``left`` and ``right`` are the tooth's flanks, right on the clockwise side. Clearances are signed: positive is a
    gap, negative the depth of an interference. ``nan`` where no turn within half a pitch touches.
    """

    tooth: NDArray[np.int64]
    """Number of the physical tooth; tooth 0 is on the major axis at generator angle 0."""
    index: NDArray[np.float64]
    """Place relative to the major axis, in teeth: k = i - theta z_c / 2 pi."""
    phi_deg: NDArray[np.float64]
    """Angle of the tooth's point of the neutral curve from the major axis, clockwise."""
    circumferential_left_um: NDArray[np.float64]
    """Arc at the circular spline's pitch circle through which the tooth turns until its left flank touches."""
    circumferential_right_um: NDArray[np.float64]
    tip_clearance_um: NDArray[np.float64]
    """Flexspline tip to the circular spline's root circle, radially."""
    root_clearance_um: NDArray[np.float64]
    """Circular spline's tip circle to the flexspline's root, radially."""
    pitch_radius_mm: float
    """Pitch radius of the circular spline, where arcs become angles."""
    witnesses: Witnesses

    @classmethod
    def at(cls, tooth: NDArray[np.int64], index: NDArray[np.float64], geometry: Geometry, design: Design) -> Teeth:
        """Clearances of the teeth numbered ``tooth`` that stand at ``index``, both of shape ``(teeth,)``."""
        curve, engagement = geometry.neutral_curve, geometry.engagement
        left_um, right_um = _circumferential_um(engagement, index)
        radial_um = engagement.radial_clearances(index) * MICROMETRES_PER_MM
        return cls(
            tooth=tooth,
            index=index,
            phi_deg=np.degrees(curve.angle_at(index * curve.perimeter / design.flexspline.teeth)),
            circumferential_left_um=left_um,
            circumferential_right_um=right_um,
            tip_clearance_um=radial_um[:, 0],
            root_clearance_um=radial_um[:, 1],
            pitch_radius_mm=design.circular_spline_pitch_radius_mm,
            witnesses=Witnesses.of(engagement.clearances(index), geometry),
        )

    def __repr__(self) -> str:
        return f"<{len(self)} teeth at {self.index[0]:.2f} to {self.index[-1]:.2f}>"

    def __len__(self) -> int:
        return len(self.tooth)

    @property
    def left_um(self) -> NDArray[np.float64]:
        """Normal backlash of the left flank."""
        return self.witnesses.gap_um[:, 0]

    @property
    def right_um(self) -> NDArray[np.float64]:
        """Normal backlash of the right flank."""
        return self.witnesses.gap_um[:, 1]

    @property
    def backlash_um(self) -> NDArray[np.float64]:
        """Normal backlash of each tooth: the lesser of its two flanks."""
        return np.minimum(self.left_um, self.right_um)

    @property
    def circumferential_um(self) -> NDArray[np.float64]:
        """Circumferential backlash of each tooth: the lesser of its two flanks, ``nan`` where neither touches."""
        return np.fmin(self.circumferential_left_um, self.circumferential_right_um)

    @property
    def angular_left_arcsec(self) -> NDArray[np.float64]:
        """Angle through which the tooth turns about the gear axis until its left flank touches."""
        return self._angle_arcsec(self.circumferential_left_um)

    @property
    def angular_right_arcsec(self) -> NDArray[np.float64]:
        """Angle through which the tooth turns about the gear axis until its right flank touches."""
        return self._angle_arcsec(self.circumferential_right_um)

    def _angle_arcsec(self, arc_um: NDArray[np.float64]) -> NDArray[np.float64]:
        return arc_um / MICROMETRES_PER_MM / self.pitch_radius_mm * ARCSECONDS_PER_RADIAN


def _circumferential_um(
    engagement: Engagement, index: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Of the left and of the right flank; the left flank of a tooth is the right one of its mirror image."""
    once, place = np.unique(np.abs(index), return_inverse=True)
    left_um, right_um = (engagement.circumferential(once) * MICROMETRES_PER_MM)[place].T
    mirrored = index < 0.0
    return np.where(mirrored, right_um, left_um), np.where(mirrored, left_um, right_um)
