"""Shapes of a deformed thin ring: w/w0 in closed form, with its derivatives and linear bending moment."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from strainwave.columns import Floats, Numbers

if TYPE_CHECKING:
    from strainwave._kernel import BatchCurves, NeutralCurve
    from strainwave.wave_generators.wave_generator import NeutralCurveModel


class Shape(ABC):
    """w/w0 for any angle phi (rad) from the major axis; even about both axes."""

    @abstractmethod
    def displacement(self, phi: ArrayLike) -> Floats:
        """w/w0 and its first two derivatives by phi: shape of phi + (3,)."""

    @abstractmethod
    def curve(self, radius: float, w0: float, model: NeutralCurveModel) -> NeutralCurve:
        """The kernel's neutral curve, for a neutral circle of `radius` and a displacement `w0` (mm)."""

    def moment(self, phi: ArrayLike) -> Floats:
        """Linear bending moment -(w + w'')/w0 in EI w0/R², > 0 where the ring is bent more than its circle was.

        Thin inextensible ring, small displacement (Timoshenko, Strength of Materials II, thin circular rings)."""
        displacement = self.displacement(phi)
        return -(displacement[..., 0] + displacement[..., 2])


@dataclass(frozen=True, eq=False)
class HarmonicShape(Shape):
    """w/w0 = sum over n of coefficients[n] cos(2 n phi)."""

    coefficients: Floats

    def displacement(self, phi: ArrayLike) -> Floats:
        """See `Shape.displacement`."""
        order = 2.0 * np.arange(len(self.coefficients))
        angle = np.asarray(phi, dtype=np.float64)[..., None] * order
        w = np.cos(angle) @ self.coefficients
        slope = -np.sin(angle) @ (order * self.coefficients)
        bend = -np.cos(angle) @ (order**2 * self.coefficients)
        return np.stack([w, slope, bend], axis=-1)

    def curve(self, radius: float, w0: float, model: NeutralCurveModel) -> NeutralCurve:
        """See `Shape.curve`."""
        from strainwave._kernel import NeutralCurve

        return NeutralCurve.harmonics(radius, w0, model, self.coefficients.tolist())


@dataclass(frozen=True, eq=False)
class RingShape(Shape):
    """A ring held at points or along arcs: rows (phi_end, p, c, c_phi, s, s_phi) that follow each other from 0 to π/2.

    w/w0 = p + (c + c_phi φ) cos φ + (s + s_phi φ) sin φ, the even solutions for a free or evenly pressed thin ring.
    """

    rows: Floats

    def displacement(self, phi: ArrayLike) -> Floats:
        """See `Shape.displacement`."""
        angle = np.abs(np.remainder(np.asarray(phi, dtype=np.float64) + np.pi / 2.0, np.pi) - np.pi / 2.0)
        lower_half = np.remainder(np.asarray(phi, dtype=np.float64), np.pi) > np.pi / 2.0
        row = np.minimum(np.searchsorted(self.rows[:, 0], angle), len(self.rows) - 1)
        _, p, c, c_phi, s, s_phi = np.moveaxis(self.rows[row], -1, 0)
        cosine, sine = np.cos(angle), np.sin(angle)
        along_cosine, along_sine = c + c_phi * angle, s + s_phi * angle
        w = p + along_cosine * cosine + along_sine * sine
        slope = (c_phi + along_sine) * cosine + (s_phi - along_cosine) * sine
        bend = (2.0 * s_phi - along_cosine) * cosine - (2.0 * c_phi + along_sine) * sine
        return np.stack([w, np.where(lower_half, -slope, slope), bend], axis=-1)

    def curve(self, radius: float, w0: float, model: NeutralCurveModel) -> NeutralCurve:
        """See `Shape.curve`."""
        from strainwave._kernel import NeutralCurve

        return NeutralCurve.ring(radius, w0, model, self.rows)


class Shapes(ABC):
    """The shapes of the rows of a batch, or one for all of them."""

    @abstractmethod
    def __getitem__(self, row: int) -> Shape:
        """The shape of one row."""

    @abstractmethod
    def curves(self, radius: Floats, w0: Floats, model: NeutralCurveModel) -> BatchCurves:
        """The kernel's neutral curves; radius and w0 in mm, (rows,) or (1,)."""


@dataclass(frozen=True, eq=False)
class HarmonicShapes(Shapes):
    """Coefficients of `HarmonicShape`, (rows, n) or (1, n)."""

    coefficients: Floats

    def __getitem__(self, row: int) -> HarmonicShape:
        """See `Shapes`."""
        return HarmonicShape(self.coefficients[row])

    def curves(self, radius: Floats, w0: Floats, model: NeutralCurveModel) -> BatchCurves:
        """See `Shapes.curves`."""
        from strainwave._kernel import BatchCurves

        return BatchCurves.harmonics(radius, w0, model, self.coefficients)


@dataclass(frozen=True, eq=False)
class RingShapes(Shapes):
    """Rows of `RingShape`, (rows, n, 6) or (1, n, 6)."""

    rows: Floats

    def __getitem__(self, row: int) -> RingShape:
        """See `Shapes`."""
        return RingShape(self.rows[row])

    def curves(self, radius: Floats, w0: Floats, model: NeutralCurveModel) -> BatchCurves:
        """See `Shapes.curves`."""
        from strainwave._kernel import BatchCurves

        return BatchCurves.ring(radius, w0, model, self.rows)


def ring_rows(*stretches: tuple[Numbers, ...]) -> Floats:
    """Rows of `RingShape` from their numbers, of any common shape: that shape + (n, 6)."""
    numbers = np.broadcast_arrays(*(number for stretch in stretches for number in stretch))
    return np.stack(numbers, axis=-1).reshape(*numbers[0].shape, len(stretches), 6).astype(np.float64)
