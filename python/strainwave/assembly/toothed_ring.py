"""The vertices of a toothed ring in one plane, and how its faces join them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave.assembly.builder import Builder
from strainwave.assembly.mesh import NO_TOOTH, Indices
from strainwave.assembly.tooth_section import ToothSection


@dataclass(frozen=True, eq=False)
class ToothedRing:
    """Numbers of the vertices of all z teeth in one section, tooth by tooth, clockwise."""

    section: ToothSection
    teeth: Indices
    """Numbers of the teeth, (z,)."""
    outline: Indices
    """Points of the outline without each tooth's last, which is the next one's first: (z, n - 1)."""
    under: Indices
    """Points of the root circle under the teeth, (z, q); only where a face needs them."""

    @property
    def root(self) -> Indices:
        """The points at the stations on the root circle, without each tooth's last: (z, m - 1)."""
        floor = self.section.floor
        whole = self._closed
        ends = (whole[:, : floor + 1], self.under, whole[:, whole.shape[1] - 1 - floor : -1])
        return np.concatenate(ends, axis=1)

    def faces(self, builder: Builder, *, up: bool) -> None:
        """The end faces of all teeth, looking up or down the axis."""
        points = np.concatenate([self._closed[:, self.section.above], self.under], axis=1)
        triangles = points[:, self.section.face]
        looks_up = self.section.root_radius > float(np.hypot(*self.section.outline[len(self.section.outline) // 2]))
        builder.faces(triangles if looks_up == up else triangles[..., ::-1], self.teeth)

    @property
    def quadrangle_teeth(self) -> Indices:
        """The tooth of each chord of the outline, floors apart: (z (n - 1),)."""
        above = np.full(self.outline.shape, NO_TOOTH)
        above[:, self.section.floor : self.outline.shape[1] - self.section.floor] = self.teeth[:, None]
        return above.ravel()

    @property
    def _closed(self) -> Indices:
        """The outline of each tooth with its last point, (z, n)."""
        return np.concatenate([self.outline, np.roll(self.outline[:, :1], -1, axis=0)], axis=1)
