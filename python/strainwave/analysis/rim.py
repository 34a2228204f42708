"""How the rim is bent: displacements, slope and bending moment of the neutral curve, from the curve itself."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from strainwave._kernel import NeutralCurve

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Rim:
    """The deformed neutral curve at polar angles from the major axis; every array has the shape of ``phi_deg``.

    All of it holds for the curve in its neutral-curve model, not for the linear ring that it may have come from.
    """

    phi_deg: Floats
    w_mm: Floats
    """Radial displacement r(phi) - R, outward."""
    w_slope_mm: Floats
    """dw/dphi, per radian."""
    w_bend_mm: Floats
    """Second derivative of w by phi, per square radian."""
    curvature_per_mm: Floats
    psi_deg: Floats
    """-arctan(r'/r): how far the curve's normal, and so a tooth, is turned from the radius."""
    tangential_mm: Floats
    """Shift v of the material point now at phi, towards +phi, from equal-arc-length placement."""
    moment: Floats
    """Bending moment EI (curvature - 1/R) in units of EI w0/R^2, > 0 where the rim is bent more than its circle was
    (Timoshenko, Strength of Materials II, thin circular rings)."""

    @classmethod
    def at(cls, curve: NeutralCurve, phi_deg: ArrayLike) -> Rim:
        """The rim at angles of any shape."""
        degrees = np.asarray(phi_deg, dtype=np.float64)
        phi = np.radians(degrees)
        displacement, curvature = curve.displacement(phi), curve.curvature(phi)
        return cls(
            phi_deg=degrees,
            w_mm=displacement[..., 0],
            w_slope_mm=displacement[..., 1],
            w_bend_mm=displacement[..., 2],
            curvature_per_mm=curvature,
            psi_deg=np.degrees(curve.psi(phi)),
            tangential_mm=curve.tangential_displacement(phi),
            moment=(curvature - 1.0 / curve.radius) * curve.radius**2 / curve.w0,
        )
