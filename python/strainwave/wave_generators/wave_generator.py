"""What every wave generator has."""

from __future__ import annotations

from abc import abstractmethod
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from pydantic import Field

from strainwave.columns import NOTHING_VARIED, Columns, Floats, Refusals, column
from strainwave.quantities import LengthInMm
from strainwave.spec import Spec

if TYPE_CHECKING:
    from strainwave._kernel import BatchCurves, NeutralCurve
    from strainwave.wave_generators.shape import Shape, Shapes

NeutralCurveModel = Literal["inextensible", "shifted", "first-order"]


class WaveGenerator(Spec):
    """A two-lobed wave generator; its major axis is +Y, and the flexspline stands out by `w0` there."""

    kind: str
    w0: Annotated[
        LengthInMm, Field(description="Radial displacement of the neutral curve at the major axis", examples=[0.848])
    ]
    bearing_height: Annotated[
        LengthInMm | None, Field(description="Radial height of the bearing, for drawings only", examples=[12.0])
    ] = None

    @abstractmethod
    def curve(self, radius: float) -> NeutralCurve:
        """The deformed neutral curve of a flexspline whose neutral circle has `radius` mm.

        Raises the kernel's GeometryError where there is no such simple curve.
        """

    @abstractmethod
    def curves(self, radius: Floats, varied: Columns) -> BatchCurves:
        """The neutral curves of the rows of a batch, for neutral circles of `radius` mm, (rows,) or (1,).

        The columns lie within the limits of their keys.
        """

    @abstractmethod
    def section(self, radius: float, w0: float) -> NeutralCurve:
        """The curve of a section of the cup that stands out by another `w0` (mm) than that of this generator.

        Its shape is the one that this generator gives the section at mid-face; with the generator's own w0 it is
        `curve`. Raises the kernel's GeometryError.
        """

    @abstractmethod
    def sections(self, radius: float, w0: Floats) -> BatchCurves:
        """The same for the rows of a batch, (rows,)."""

    def refusals(self, varied: Columns) -> Refusals:
        """Which rows this table refuses, though each of their numbers lies within its limits."""
        yield from ()


class ShapedWaveGenerator(WaveGenerator):
    """A generator whose neutral curve is w0 times a shape w/w0 on the neutral circle, its perimeter kept or not."""

    neutral_curve: Annotated[
        NeutralCurveModel,
        Field(
            description="How w is put on the neutral circle of radius R: first-order r = R + w, as in the article; "
            "shifted r = R + c + w, which keeps the perimeter; inextensible keeps the perimeter and r(0) = R + w0",
            examples=["inextensible"],
        ),
    ] = "inextensible"

    def shape(self, radius: float) -> Shape:
        """w/w0 over the angle from the major axis, for a neutral circle of `radius` mm."""
        return self.shapes(np.array([radius]), NOTHING_VARIED)[0]

    @abstractmethod
    def shapes(self, radius: Floats, varied: Columns) -> Shapes:
        """The shapes of the rows of a batch, or one where all are the same; see `shape` and `WaveGenerator.curves`."""

    def curve(self, radius: float) -> NeutralCurve:
        """The deformed neutral curve; see `WaveGenerator.curve`."""
        return self.shape(radius).curve(radius, self.w0, self.neutral_curve)

    def curves(self, radius: Floats, varied: Columns) -> BatchCurves:
        """The neutral curves of the rows of a batch; see `WaveGenerator.curves`."""
        return self.shapes(radius, varied).curves(radius, column(varied, "w0", self.w0), self.neutral_curve)

    def section(self, radius: float, w0: float) -> NeutralCurve:
        """This generator's shape, whatever its own w0 would be elsewhere; see `WaveGenerator.section`."""
        return self.shape(radius).curve(radius, w0, self.neutral_curve)

    def sections(self, radius: float, w0: Floats) -> BatchCurves:
        """See `WaveGenerator.sections`."""
        radii = np.array([radius])
        return self.shapes(radii, NOTHING_VARIED).curves(radii, w0, self.neutral_curve)
