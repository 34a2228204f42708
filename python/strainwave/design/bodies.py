"""The sizes of the parts beyond their tooth profiles: the cup along its axis, the ring around the teeth.

A design may leave all of them out. The proportions in their place are rounded from

- EP 1 628 045 (Kiyosawa, Takizawa: Wave gear device): a diaphragm of thickness A/r² with A about 0.002 D³ out to
  r = 0.4 D, D the pitch diameter, which is 0.0125 D thick there;
- the bolt circles in the engineering data of the CSD-2A component sets of sizes 14 to 50, D in tenths of an inch:
  0.45 to 0.50 D on the flexspline's boss, which must be larger, and 1.18 to 1.25 D on the circular spline;
- Chinese Journal of Mechanical Engineering 34 (2021), doi 10.1186/s10033-021-00621-z, table 4: a face of D/6;
- the short cups that component sets have today, about half as long as wide.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Self, TypeVar

from strainwave.columns import Floats

N = TypeVar("N", float, Floats)

FACE_WIDTHS = 1.0 / 6.0  # of the pitch diameter
CUP_LENGTHS = 0.5  # of the pitch diameter
DIAPHRAGM_THICKNESSES = 0.0125  # of the pitch diameter
BOSS_DIAMETERS = 0.6  # of the cup's bore
OUTER_DIAMETERS = 1.33  # of the circular spline's root circle

KEYS = (
    "flexspline.face_width",
    "flexspline.cup_length",
    "flexspline.diaphragm_thickness",
    "flexspline.boss_diameter",
    "circular_spline.face_width",
    "circular_spline.outer_diameter",
)


@dataclass(frozen=True)
class Bodies(Generic[N]):
    """Sizes in mm: numbers of one design, or arrays over the rows of a batch."""

    face_width: N
    """Length of the flexspline's teeth; they end at the cup's open end."""
    cup_length: N
    """From the diaphragm's outer face to the open end."""
    diaphragm_thickness: N
    boss_diameter: N
    bore: N
    """Inner diameter of the undeformed cup."""
    ring_face_width: N
    """Length of the circular spline, in the middle of the flexspline's teeth."""
    outer_diameter: N
    """Of the circular spline."""
    ring_root_diameter: N
    """Of the circular spline's root circle."""

    @classmethod
    def of(
        cls, given: Callable[[str], N | None], pitch_diameter: N, root_radius: N, wall: N, ring_root_radius: N
    ) -> Self:
        """What is `given` under its dotted key, and the usual proportions for what is not."""

        def size(key: str, usual: N) -> N:
            value = given(key)
            return usual if value is None else value

        face_width = size("flexspline.face_width", FACE_WIDTHS * pitch_diameter)
        bore = 2.0 * (root_radius - wall)
        ring_root_diameter = 2.0 * ring_root_radius
        return cls(
            face_width=face_width,
            cup_length=size("flexspline.cup_length", CUP_LENGTHS * pitch_diameter),
            diaphragm_thickness=size("flexspline.diaphragm_thickness", DIAPHRAGM_THICKNESSES * pitch_diameter),
            boss_diameter=size("flexspline.boss_diameter", BOSS_DIAMETERS * bore),
            bore=bore,
            ring_face_width=size("circular_spline.face_width", face_width),
            outer_diameter=size("circular_spline.outer_diameter", OUTER_DIAMETERS * ring_root_diameter),
            ring_root_diameter=ring_root_diameter,
        )

    @property
    def barrel_length(self) -> N:
        """The smooth wall between diaphragm and teeth: above 0 where the teeth have room in the cup."""
        return self.cup_length - self.diaphragm_thickness - self.face_width

    @property
    def diaphragm_width(self) -> N:
        """Twice the diaphragm's free width between boss and wall: above 0 where the boss has room."""
        return self.bore - self.boss_diameter

    @property
    def ring_thickness(self) -> N:
        """Twice the circular spline's thickness outside its teeth."""
        return self.outer_diameter - self.ring_root_diameter
