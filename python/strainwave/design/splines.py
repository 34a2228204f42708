"""The two toothed parts."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from strainwave.profiles import AnyProfile
from strainwave.quantities import LengthInMm, Teeth
from strainwave.spec import Spec


class Flexspline(Spec):
    """The elastic external gear."""

    teeth: Annotated[Teeth, Field(description="Number of teeth of the flexspline", examples=[204])]
    wall_thickness: Annotated[LengthInMm, Field(description="Thickness of the rim under the teeth", examples=[1.6])]
    neutral_radius: Annotated[
        LengthInMm | None,
        Field(
            description="Radius of the undeformed neutral circle; left out, it lies in the middle of the wall "
            "(root radius - wall_thickness / 2)",
            examples=[79.8304],
        ),
    ] = None
    profile: Annotated[AnyProfile, Field(description="Tooth profile of the flexspline")]


class CircularSpline(Spec):
    """The rigid internal gear; its tooth frame points inwards, towards the tooth's tip."""

    teeth: Annotated[Teeth, Field(description="Number of teeth of the circular spline", examples=[206])]
    profile: Annotated[AnyProfile, Field(description="Tooth profile of the circular spline")]
