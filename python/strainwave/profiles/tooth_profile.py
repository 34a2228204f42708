"""What every tooth profile has, whatever its flank."""

from __future__ import annotations

from abc import abstractmethod
from typing import Annotated

from pydantic import Field

from strainwave.columns import NOTHING_VARIED, Columns, Floats, Refusals
from strainwave.profiles.gear import Gear
from strainwave.quantities import FilletRadius, LengthInModules, OffsetInMm
from strainwave.spec import Spec


class ToothProfile(Spec):
    """One half (x >= 0) of a symmetric tooth, in its own frame: y along the tooth's axis towards its tip, y = 0 on the
    pitch circle. Lengths are in modules, the offset in mm."""

    kind: str
    addendum: Annotated[LengthInModules, Field(description="Height of the tip above the pitch circle", examples=[0.9])]
    dedendum: Annotated[LengthInModules, Field(description="Depth of the root below the pitch circle", examples=[1.15])]
    root_fillet_radius: Annotated[
        FilletRadius, Field(description="Radius between flank and root circle; 0 for a sharp corner", examples=[0.55])
    ] = 0.0
    offset: Annotated[
        OffsetInMm,
        Field(
            description="Shift of the flank along its outward normal, tip and root circles kept; "
            "negative removes material",
            examples=[-0.0072],
        ),
    ] = 0.0

    def flank(self, gear: Gear) -> Floats:
        """The nominal flank from tip to root, in mm, on one gear.

        Returns (n, 5): x and y of a segment's start (mm), angle of its outward normal there, clockwise from y (rad),
        curvature (1/mm, > 0 convex), length (mm). Tip land, fillet and root floor are the kernel's, which also cuts or
        extends the first segment to the addendum circle and the last to the root circle or the fillet.
        """
        flank: Floats = self.flanks(gear, NOTHING_VARIED)[0]
        return flank

    @abstractmethod
    def flanks(self, gear: Gear, varied: Columns) -> Floats:
        """The flanks of the rows of a batch, (rows, n, 5) or, where all are the same, (1, n, 5); see `flank`.

        The columns lie within the limits of their keys.
        """

    def refusals(self, varied: Columns) -> Refusals:
        """Which rows this table refuses, though each of their numbers lies within its limits."""
        yield from ()
