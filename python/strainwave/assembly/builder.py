"""Vertices and triangles of a mesh in the making."""

from __future__ import annotations

import numpy as np

from strainwave.assembly.mesh import NO_TOOTH, Indices, Mesh
from strainwave.columns import Floats


class Builder:
    """Collects vertices, and triangles between rings of them that run clockwise about the axis, seen from +z."""

    def __init__(self) -> None:
        self._count = 0
        self._vertices: list[Floats] = []
        self._triangles: list[Indices] = []
        self._teeth: list[Indices] = []

    def add(self, points: Floats) -> Indices:
        """Numbers of new vertices at points (..., 3), in their shape (...)."""
        shape = points.shape[:-1]
        first, self._count = self._count, self._count + int(np.prod(shape, dtype=np.int64))
        self._vertices.append(points.reshape(-1, 3))
        return np.arange(first, self._count).reshape(shape)

    def strip(self, first: Indices, second: Indices, teeth: Indices | None = None) -> None:
        """The closed band from one ring to another of as many vertices; `teeth` names that of each quadrangle.

        Its normal is (second - first) x clockwise: outward on the way up.
        """
        first, second = first.ravel(), second.ravel()
        first_next, second_next = np.roll(first, -1), np.roll(second, -1)
        one = np.stack([first, second, second_next], axis=-1)
        other = np.stack([first, second_next, first_next], axis=-1)
        self._add_triangles(one, teeth)
        self._add_triangles(other, teeth)

    def fan(self, centre: Indices, ring: Indices, *, up: bool) -> None:
        """The disk between a ring and a vertex inside it, looking up or down the axis."""
        ring = ring.ravel()
        ends = (np.roll(ring, -1), ring) if up else (ring, np.roll(ring, -1))
        self._add_triangles(np.stack([np.broadcast_to(centre, ring.shape), *ends], axis=-1), None)

    def faces(self, triangles: Indices, teeth: Indices) -> None:
        """Triangles of the teeth named, (z, m, 3) and (z,)."""
        self._add_triangles(triangles.reshape(-1, 3), np.repeat(teeth, triangles.shape[1]))

    def mesh(self, chord_error_mm: float) -> Mesh:
        """What was collected."""
        return Mesh(
            np.concatenate(self._vertices),
            np.concatenate(self._triangles),
            np.concatenate(self._teeth),
            chord_error_mm,
        )

    def _add_triangles(self, triangles: Indices, teeth: Indices | None) -> None:
        self._triangles.append(triangles)
        self._teeth.append(np.full(len(triangles), NO_TOOTH) if teeth is None else teeth)
