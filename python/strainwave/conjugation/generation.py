"""One spline's tooth generating the other: who is who, and in what motion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Self

import numpy as np

from strainwave._kernel import Profile
from strainwave.conjugation.boundary import Boundary
from strainwave.conjugation.branch import Branch, branches_of
from strainwave.conjugation.contact_pieces import ContactPieces
from strainwave.conjugation.flank import Flank
from strainwave.conjugation.gear_circles import GearCircles
from strainwave.conjugation.mesh_motion import MeshMotion
from strainwave.conjugation.motion import Motion
from strainwave.conjugation.stretch import Stretch
from strainwave.conjugation.zone import ConjugateZone
from strainwave.design import CircularSpline, Design, Flexspline
from strainwave.errors import DesignError, Fault
from strainwave.geometry import Geometry
from strainwave.quantities import MODULES

# Share of half a pitch.
FLOOR_BEYOND = 0.5

Spline = Literal["circular-spline", "flexspline"]


@dataclass(frozen=True, eq=False)
class Generation:
    """Both splines of a design by the part that they play here."""

    table: str
    """Key of the sought spline's table."""
    spline: Flexspline | CircularSpline
    """The sought one as the design has it."""
    gear: GearCircles
    """Its circles."""
    mate: Profile
    mate_name: str
    motion: MeshMotion
    motions: list[Motion]
    """The mate's, seen from the sought spline's tooth."""
    module: float

    @classmethod
    def of(cls, design: Design, of: Spline) -> Self:
        """Those of a design with geometry, else DesignError."""
        geometry = Geometry.of(design)
        motion = MeshMotion(geometry)
        if of == "flexspline":
            spline: Flexspline | CircularSpline = design.flexspline
            own, mate, motions = geometry.flexspline, geometry.circular_spline, motion.circular_spline()
        else:
            spline = design.circular_spline
            own, mate, motions = geometry.circular_spline, geometry.flexspline, motion.flexspline()
        gear = GearCircles(
            own.teeth,
            own.pitch_radius,
            own.internal,
            spline.profile.addendum * design.module,
            spline.profile.dedendum * design.module,
        )
        mate_name = "circular spline" if of == "flexspline" else "flexspline"
        return cls(of.replace("-", "_"), spline, gear, mate, mate_name, motion, motions, design.module)

    def branches(self) -> list[Branch]:
        """Every contact of the mate's tooth with what it sweeps."""
        segments = self.mate.segments.copy()
        # The root floor goes on beyond the middle of the space, where this half of the tooth ends.
        segments[-1, 4] += FLOOR_BEYOND * np.pi * self.mate.pitch_radius / self.mate.teeth
        pieces = ContactPieces.of(segments)
        return [branch for motion in self.motions for branch in branches_of(pieces, motion)]

    def flank(self, branches: list[Branch]) -> Flank:
        """The flank along the boundary; DesignError where the sought spline's circles leave no room for one."""
        boundary = Boundary.of(branches, self.gear)
        if boundary.free_height <= self.gear.addendum:
            raise self._no_room(
                "addendum",
                f"the {self.mate_name}'s tooth sweeps all material that is {boundary.free_height / self.module:.4f} "
                "modules or more above the pitch circle",
                "Reduce it to less",
            )
        if not boundary.stretches:
            raise self._no_room(
                "addendum", f"the {self.mate_name}'s tooth never comes below the tip circle", "Enlarge it"
            )
        reach = min(float(stretch.heights.min()) for stretch in boundary.stretches)
        if reach <= -self.gear.dedendum:
            raise self._no_room(
                "dedendum",
                f"the {self.mate_name}'s tip comes {-reach / self.module:.4f} modules below the pitch circle",
                "Enlarge it to more",
            )
        floor = 0.5 * self.mate.tip_land_width / abs(self.gear.signed_radius(-self.gear.dedendum))
        flank = Flank.along(boundary.stretches, self.gear, floor)
        if flank is None:
            raise self._no_room(
                "dedendum",
                "no tangent of the conjugate flank leads to the root circle clear of the mate, and to a root floor",
                f"Reduce it; the {self.mate_name}'s tip comes {-reach / self.module:.4f} below the pitch circle",
            )
        return flank

    def zone(self, part: Branch | Stretch) -> ConjugateZone:
        """A branch or a stretch of one in words and numbers."""
        return ConjugateZone.of(part, self.mate, self.gear, self.motion)

    def _no_room(self, name: str, problem: str, remedy: str) -> DesignError:
        key = f"{self.table}.profile.{name}"
        return DesignError([Fault(key, getattr(self.spline.profile, name), MODULES, problem, remedy)])
