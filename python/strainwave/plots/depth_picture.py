"""Triangles as pixels, each with the colour of what is nearest there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats

FINER = 2  # pixels are drawn so many times finer both ways, and averaged, so that edges are smooth


@dataclass(frozen=True, eq=False)
class DepthPicture:
    """Red, green, blue and cover of each pixel, ``(height, width, 4)`` in 0 .. 1, and what it spans in mm."""

    pixels: Floats
    left: float
    right: float
    bottom: float
    top: float

    @classmethod
    def of(cls, corners: Floats, colours: Floats, *, pixels_per_mm: float, margin_mm: float = 1.0) -> DepthPicture:
        """Triangles at ``corners``, (m, 3, 3): right, up and towards the reader, in mm; ``colours`` (m, 3)."""
        scale = pixels_per_mm * FINER
        low = corners[..., :2].min(axis=(0, 1)) - margin_mm
        size = np.ceil((corners[..., :2].max(axis=(0, 1)) + margin_mm - low) * pixels_per_mm).astype(np.int64)
        width, height = (size * FINER).tolist()
        at = np.concatenate([(corners[..., :2] - low) * scale, corners[..., 2:]], axis=-1)
        pixel, depth, triangle = _fragments(at, width)
        nearest = np.full(height * width, -np.inf)
        np.maximum.at(nearest, pixel, depth)
        seen = depth == nearest[pixel]
        picture = np.zeros((height * width, 4))
        picture[pixel[seen]] = np.concatenate([colours, np.ones((len(colours), 1))], axis=1)[triangle[seen]]
        fine = picture.reshape(height // FINER, FINER, width // FINER, FINER, 4)
        cover = fine[..., 3:].mean(axis=(1, 3))
        shown = fine[..., :3].mean(axis=(1, 3)) / np.where(cover > 0.0, cover, 1.0)
        right, top = low + size / pixels_per_mm
        return cls(np.concatenate([shown, cover], axis=-1), float(low[0]), float(right), float(low[1]), float(top))


def _fragments(at: Floats, width: int) -> tuple[NDArray[np.int64], Floats, NDArray[np.int64]]:
    """Every pixel centre in every triangle: its number, the depth there and the triangle; corners in pixels."""
    triangle, row = _spread(np.ceil(at[..., 1].min(axis=1) - 0.5), np.ceil(at[..., 1].max(axis=1) - 0.5))
    y: Floats = row.astype(np.float64) + 0.5
    crossings = np.stack([_crossing(at[triangle, i], at[triangle, (i + 1) % 3], y) for i in range(3)])
    line, column = _spread(
        np.ceil(np.nan_to_num(np.fmin.reduce(crossings)) - 0.5), np.ceil(np.nan_to_num(np.fmax.reduce(crossings)) - 0.5)
    )
    owner = triangle[line]
    first = at[owner, 0]
    u, v = at[owner, 1] - first, at[owner, 2] - first
    normal_z = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    dx, dy = column + 0.5 - first[:, 0], y[line] - first[:, 1]
    along_u, along_v = dx * v[:, 1] - dy * v[:, 0], dy * u[:, 0] - dx * u[:, 1]
    depth = first[:, 2] + (along_u * u[:, 2] + along_v * v[:, 2]) / np.where(normal_z == 0.0, np.inf, normal_z)
    return row[line] * width + column, depth, owner


def _spread(first: Floats, end: Floats) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """For each range of whole numbers from first to below end: its own number, and the numbers in it."""
    low = first.astype(np.int64)
    count = np.maximum(end.astype(np.int64) - low, 0)
    owner = np.repeat(np.arange(len(low)), count)
    return owner, low[owner] + np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)


def _crossing(start: Floats, end: Floats, y: Floats) -> Floats:
    """Where an edge crosses the height y; nan where it does not."""
    rise = end[:, 1] - start[:, 1]
    share = np.divide(y - start[:, 1], rise, out=np.full_like(y, np.nan), where=rise != 0.0)
    x = start[:, 0] + share * (end[:, 0] - start[:, 0])
    return np.where((share >= 0.0) & (share <= 1.0), x, np.nan)
