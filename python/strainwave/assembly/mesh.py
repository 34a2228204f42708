"""A closed surface of triangles."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats

Indices = NDArray[np.int64]

NO_TOOTH = -(2**31)  # teeth left of the major axis have negative numbers


@dataclass(frozen=True, eq=False, repr=False)
class Mesh:
    """Triangles whose normals, by the right-hand rule, point out of the body.

    x and y as in the section, z along the axis from the diaphragm's outer face towards the cup's open end, mm. Several
    bodies may be one mesh.
    """

    vertices_mm: Floats
    """Shape ``(n, 3)``."""
    triangles: Indices
    """Vertices of each triangle, ``(m, 3)``."""
    tooth: Indices
    """Number of the tooth that each triangle belongs to, ``(m,)``; `NO_TOOTH` on rim, floors and all else."""
    chord_error_mm: float
    """No point of the exact surface lies further from the mesh, nor one of the mesh further from the surface."""

    @property
    def corners_mm(self) -> Floats:
        """The corners of each triangle, ``(m, 3, 3)``."""
        return self.vertices_mm[self.triangles]

    @property
    def volume_mm3(self) -> float:
        """What the mesh encloses, by the divergence theorem."""
        first, second, third = np.moveaxis(self.corners_mm, 1, 0)
        return float((first * np.cross(second, third)).sum() / 6.0)

    def turned(self, angle_rad: float) -> Self:
        """The mesh turned about the axis by an angle, clockwise seen from the open end."""
        cosine, sine = math.cos(angle_rad), math.sin(angle_rad)
        x, y, z = self.vertices_mm.T
        vertices = np.stack([cosine * x + sine * y, cosine * y - sine * x, z], axis=-1)
        return replace(self, vertices_mm=vertices)

    def only(self, chosen: NDArray[np.bool_]) -> Self:
        """Some of the triangles, with the vertices that they need: a surface to look at, no longer closed."""
        used, numbered = np.unique(self.triangles[chosen], return_inverse=True)
        return replace(
            self,
            vertices_mm=self.vertices_mm[used],
            triangles=numbered.reshape(-1, 3).astype(np.int64),
            tooth=self.tooth[chosen],
        )

    def __repr__(self) -> str:
        return f"<Mesh of {len(self.triangles)} triangles, chord error {self.chord_error_mm:g} mm>"
