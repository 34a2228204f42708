"""The geometry of a design: both tooth profiles, the neutral curve, and how the teeth stand in each other."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Self

from strainwave._kernel import Engagement, GeometryError, NeutralCurve, Profile
from strainwave.design import CircularSpline, Design, Flexspline
from strainwave.errors import DesignError, Fault, StrainwaveError
from strainwave.profiles import Gear
from strainwave.quantities import MM, MODULES

# For each code of the kernel that a design can cause: the key to blame, below the spline's table or the wave
# generator's, its unit, and what to do.
PROFILE_FAULTS = {
    "not-finite": ("profile", "", "Bring its lengths to the size of the others"),
    "not-positive": ("profile.addendum", MODULES, "Reduce it, or raise the number of teeth"),
    "bad-segment": ("profile", "", "Lengthen the piece, or leave it out"),
    "arc-too-long": ("profile", "", "Move the arc's centre or change its radius, or make the tooth lower"),
    "radius-vanishes": ("profile.offset", MM, "Bring it nearer to 0, or enlarge the arc's radius"),
    "offset-opens-join": ("profile.offset", MM, "Bring it nearer to 0, or lengthen the pieces at that join"),
    "tip-not-reached": ("profile.addendum", MODULES, "Reduce it, or move the tip arc's centre towards the tip"),
    "tip-pointed": ("profile.addendum", MODULES, "Reduce it, or make the tooth thicker"),
    "root-not-reached": ("profile.dedendum", MODULES, "Reduce it, or choose a larger flank angle or arc radius"),
    "fillet-does-not-fit": ("profile.root_fillet_radius", MODULES, "Reduce it, or shorten the flank above it"),
    "space-too-narrow": (
        "profile.dedendum",
        MODULES,
        "Make the tooth thinner, or the flank steeper, or the fillet smaller",
    ),
    "self-crossing": ("profile", "", "Change the pieces so that they do not meet again"),
}
CURVE_FAULTS = {
    "not-finite": ("w0", MM, "Bring it to the size of the gear"),
    "curve-not-simple": ("w0", MM, "Reduce it (usual is about one module for a tooth difference of 2)"),
    "no-such-ellipse": ("w0", MM, "Reduce it, or cam_to_neutral, or correct the neutral radius"),
    "perimeter-not-kept": ("w0", MM, "Reduce it (usual is about one module for a tooth difference of 2)"),
}
# Faults that an offset may have brought about, though the key to blame is another.
BY_OFFSET = {"tip-not-reached", "tip-pointed", "root-not-reached", "fillet-does-not-fit", "space-too-narrow"}
# Codes that no design causes, because the spec has ruled them out: empty or gaping chains, arcs as flat as no tooth has
# them, teeth as low, malformed ring shapes, teeth that are too few or do not mesh. Meeting one is a bug.
RULED_OUT = {
    "empty-chain",
    "join-gap",
    "radius-too-large",
    "teeth-too-low",
    "bad-shape",
    "too-few-teeth",
    "teeth-do-not-mesh",
}


@dataclass(frozen=True)
class Geometry:
    """What the kernel makes of a design; lengths in mm, angles in radians."""

    flexspline: Profile
    circular_spline: Profile
    neutral_curve: NeutralCurve
    engagement: Engagement

    @classmethod
    def of(cls, design: Design) -> Self:
        """The geometry of `design`. DesignError holds every fault of both profiles and the neutral curve at once."""
        faults: list[Fault] = []
        with _blaming(faults, design, "flexspline", PROFILE_FAULTS):
            flexspline = spline_profile(design.module, design.flexspline, internal=False)
        with _blaming(faults, design, "circular_spline", PROFILE_FAULTS):
            circular_spline = spline_profile(design.module, design.circular_spline, internal=True)
        with _blaming(faults, design, "wave_generator", CURVE_FAULTS):
            curve = design.wave_generator.curve(design.neutral_radius_mm)
        if faults:
            raise DesignError(faults)
        return cls(flexspline, circular_spline, curve, Engagement(flexspline, circular_spline, curve))


def spline_profile(
    module: float, spline: Flexspline | CircularSpline, *, internal: bool, set_back_mm: float = 0.0
) -> Profile:
    """The profile of a spline; with `set_back_mm` its whole outline, tip and root too, lies so much deeper.

    Raises the kernel's GeometryError.
    """
    spec = spline.profile
    fillet_radius = spec.root_fillet_radius * module
    return Profile(
        spec.flank(Gear.of(module, spline.teeth, internal=internal)),
        teeth=spline.teeth,
        pitch_radius=0.5 * module * spline.teeth,
        internal=internal,
        addendum=spec.addendum * module - set_back_mm,
        dedendum=spec.dedendum * module + set_back_mm,
        offset=spec.offset - set_back_mm,
        fillet_radius=max(fillet_radius + set_back_mm, 0.0),  # the parallel of a fillet, and of a sharp corner
    )


@contextmanager
def _blaming(
    faults: list[Fault], design: Design, table: str, catalogue: dict[str, tuple[str, str, str]]
) -> Iterator[None]:
    """Turns the kernel's error, if there is one, into a fault of the key in `table` that the catalogue blames."""
    try:
        yield
    except GeometryError as error:
        if error.code not in catalogue:
            raise StrainwaveError(f"{table}: {error} ({error.code}); this is a bug of strainwave") from error
        name, unit, remedy = catalogue[error.code]
        value: object = getattr(design, table)
        for part in name.split("."):
            value = getattr(value, part)
        offset = getattr(design, table).profile.offset if error.code in BY_OFFSET else 0.0
        if offset:
            remedy += f", or bring {table}.profile.offset = {offset:g} {MM} nearer to 0"
        faults.append(Fault(f"{table}.{name}", value if unit else None, unit, str(error), remedy))
