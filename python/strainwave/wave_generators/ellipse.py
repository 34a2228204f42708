"""The true elliptical cam."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from pydantic import Field

from strainwave.columns import Columns, Floats, column
from strainwave.quantities import EquidistantInMm
from strainwave.wave_generators.wave_generator import WaveGenerator

if TYPE_CHECKING:
    from strainwave._kernel import BatchCurves, NeutralCurve


class Ellipse(WaveGenerator):
    """A neutral curve that is an ellipse, or the equidistant of the cam's ellipse, with semi-axis R + w0 and the exact
    perimeter of the neutral circle. It has no choice of neutral-curve model, for it keeps both by construction."""

    kind: Literal["ellipse"] = "ellipse"
    cam_to_neutral: Annotated[
        EquidistantInMm,
        Field(
            description="Distance from the cam's ellipse out to the neutral curve (bearing and half the wall); "
            "0 makes the neutral curve itself the ellipse",
            examples=[12.8],
        ),
    ] = 0.0

    def curve(self, radius: float) -> NeutralCurve:
        """The equidistant ellipse; see `WaveGenerator.curve`."""
        from strainwave._kernel import NeutralCurve

        return NeutralCurve.ellipse(radius, self.w0, self.cam_to_neutral)

    def curves(self, radius: Floats, varied: Columns) -> BatchCurves:
        """The equidistant ellipses of the rows of a batch; see `WaveGenerator.curves`."""
        from strainwave._kernel import BatchCurves

        equidistant = column(varied, "cam_to_neutral", self.cam_to_neutral)
        return BatchCurves.ellipse(radius, column(varied, "w0", self.w0), equidistant)

    def section(self, radius: float, w0: float) -> NeutralCurve:
        """An ellipse with semi-axis R + w0: its w differs from the scaled one by the order of w0²/R, as any curve's
        does that keeps its perimeter; see `WaveGenerator.section`."""
        from strainwave._kernel import NeutralCurve

        return NeutralCurve.ellipse(radius, w0, self.cam_to_neutral)

    def sections(self, radius: float, w0: Floats) -> BatchCurves:
        """See `WaveGenerator.sections`."""
        from strainwave._kernel import BatchCurves

        return BatchCurves.ellipse(np.array([radius]), w0, np.array([self.cam_to_neutral]))
