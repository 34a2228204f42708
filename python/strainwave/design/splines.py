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
    face_width: Annotated[
        LengthInMm | None,
        Field(
            description="Length of the teeth along the axis, up to the cup's open end; left out, a sixth of the pitch "
            "diameter",
            examples=[27.2],
        ),
    ] = None
    cup_length: Annotated[
        LengthInMm | None,
        Field(
            description="Length of the cup, diaphragm included; left out, half the pitch diameter",
            examples=[81.6],
        ),
    ] = None
    diaphragm_thickness: Annotated[
        LengthInMm | None,
        Field(
            description="Thickness of the cup's bottom; left out, 0.0125 pitch diameters",
            examples=[2.04],
        ),
    ] = None
    boss_diameter: Annotated[
        LengthInMm | None,
        Field(
            description="Diameter of the boss in the middle of the diaphragm; left out, 0.6 bores of the cup",
            examples=[94.8],
        ),
    ] = None
    profile: Annotated[AnyProfile, Field(description="Tooth profile of the flexspline")]


class CircularSpline(Spec):
    """The rigid internal gear; its tooth frame points inwards, towards the tooth's tip."""

    teeth: Annotated[Teeth, Field(description="Number of teeth of the circular spline", examples=[206])]
    face_width: Annotated[
        LengthInMm | None,
        Field(
            description="Length along the axis, in the middle of the flexspline's teeth; left out, that of the "
            "flexspline's teeth",
            examples=[27.2],
        ),
    ] = None
    outer_diameter: Annotated[
        LengthInMm | None,
        Field(
            description="Outer diameter of the ring; left out, 1.33 diameters of its root circle",
            examples=[221.6],
        ),
    ] = None
    profile: Annotated[AnyProfile, Field(description="Tooth profile of the circular spline")]
