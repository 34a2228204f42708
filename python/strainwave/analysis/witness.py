"""Where two teeth are closest: points, pieces and kind of contact, for every tooth and both flanks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import CONTACT_KINDS, Clearances, Profile
from strainwave.geometry import Geometry
from strainwave.units import MICROMETRES_PER_MM

_, FLEXSPLINE_CORNER, CIRCULAR_SPLINE_CORNER, CORNER_ON_CORNER, _ = CONTACT_KINDS


@dataclass(frozen=True, eq=False, repr=False)
class Witnesses:
    """The closest (or deepest) points of tooth pairs; every array has the shape (teeth, 2): left flank, right flank.

    Points and normals have one axis more for x and y, in mm, in the global frame with the generator at angle 0. The
    normal points out of the flexspline. Arc lengths run from the tip along one half of the profile.
    """

    gap_um: NDArray[np.float64]
    kind: NDArray[np.str_]
    flexspline_piece: NDArray[np.str_]
    circular_spline_piece: NDArray[np.str_]
    circular_spline_tooth: NDArray[np.int64]
    flexspline_u_mm: NDArray[np.float64]
    circular_spline_u_mm: NDArray[np.float64]
    flexspline_point_mm: NDArray[np.float64]
    circular_spline_point_mm: NDArray[np.float64]
    normal: NDArray[np.float64]

    @classmethod
    def of(cls, clearances: Clearances, geometry: Geometry) -> Witnesses:
        """Name the pieces and the kinds of the kernel's numbered witnesses."""
        kind = np.array(CONTACT_KINDS)[clearances.kind]
        on_corner = kind == CORNER_ON_CORNER
        return cls(
            gap_um=clearances.gap * MICROMETRES_PER_MM,
            kind=kind,
            flexspline_piece=_touching_names(
                geometry.flexspline,
                clearances.flexspline_segment,
                clearances.flexspline_u,
                on_corner | (kind == FLEXSPLINE_CORNER),
            ),
            circular_spline_piece=_touching_names(
                geometry.circular_spline,
                clearances.circular_spline_segment,
                clearances.circular_spline_u,
                on_corner | (kind == CIRCULAR_SPLINE_CORNER),
            ),
            circular_spline_tooth=clearances.circular_spline_tooth,
            flexspline_u_mm=clearances.flexspline_u,
            circular_spline_u_mm=clearances.circular_spline_u,
            flexspline_point_mm=clearances.flexspline_point,
            circular_spline_point_mm=clearances.circular_spline_point,
            normal=clearances.normal,
        )

    @property
    def closer_flank(self) -> NDArray[np.int64]:
        """Which flank is closer, 0 left or 1 right, shape ``(teeth,)``; right where both are equal."""
        return np.where(self.gap_um[:, 0] < self.gap_um[:, 1], 0, 1)


def piece_names(profile: Profile) -> NDArray[np.str_]:
    """What a designer calls each segment of a profile, from the tip to the root, shape ``(segments,)``."""
    curvature = profile.segments[:, 3]
    return np.array([_piece_name(role, bend) for role, bend in zip(profile.roles, curvature, strict=True)])


def _touching_names(
    profile: Profile, segment: NDArray[np.int64], u: NDArray[np.float64], on_corner: NDArray[np.bool_]
) -> NDArray[np.str_]:
    """Names of the touching pieces, or of the corner between two where the witness is one."""
    nearest_knot = np.abs(u[..., None] - profile.knots).argmin(axis=-1)
    corner = np.where(nearest_knot == 1, "tip corner", "corner")
    return np.where(on_corner, corner, piece_names(profile)[segment])


def _piece_name(role: str, curvature: float) -> str:
    if role != "flank":
        return role
    if curvature == 0.0:
        return "flank line"
    return "convex arc" if curvature > 0.0 else "concave arc"
