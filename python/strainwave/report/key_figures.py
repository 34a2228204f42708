"""The figures that a review asks for, as tables."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.number import ABSENT, fixed, general, signed, whole
from strainwave.report.block import Table

if TYPE_CHECKING:
    from strainwave.analysis import Analysis, FaceMap


def key_figures(analysis: Analysis) -> Table:
    """Least backlash, clearances and play."""
    motion, play, moving = analysis.in_motion, analysis.play, analysis.play_in_motion
    at_angle = f"at {general(analysis.generator_angle_deg)}°"
    rows = (
        ("least backlash", fixed(analysis.min_backlash_um), fixed(motion.gap_um), "µm"),
        ("at tooth, at index", whole(analysis.min_tooth), f"±{fixed(motion.index, 1)}", ""),
        ("play, circumferential", fixed(play.circumferential_um), fixed(moving.circumferential_um), "µm"),
        ("play, angular", fixed(play.angular_arcsec), fixed(moving.angular_arcsec), "″"),
        ("tip clearance", fixed(analysis.tip_clearance_um, 1), ABSENT, "µm"),
        ("root clearance", fixed(analysis.root_clearance_um, 1), ABSENT, "µm"),
    )
    note = (
        f"A gap is positive, the depth of an interference negative. In motion: the least favourable generator angle, "
        f"certified to {general(motion.certified_to_um)} µm. Play: in one direction, from the centred position."
    )
    return Table("Key figures", ("", at_angle, "in motion", ""), rows, note)


def counts(analysis: Analysis) -> Table:
    """How many teeth are nearly in contact, and how many interfere."""
    rows = tuple(
        (name, whole(count.per_side), whole(count.lobe), whole(count.drive))
        for name, count in (
            (f"0 ≤ backlash < {analysis.threshold_um:g} µm", analysis.teeth_below),
            ("interfering", analysis.teeth_interfering),
        )
    )
    first = analysis.first_interfering_tooth
    note = "" if first is None else f"The interfering tooth nearest to the major axis is number {whole(first)}."
    return Table("Teeth at 0°", ("", "per side", "per lobe", "in the drive"), rows, note)


def along_the_face(face: FaceMap) -> Table:
    """The sections at the ends of the face, at its middle, and the worst."""
    named = {0: "nearest to the diaphragm", face.mid_face: "mid-face", len(face) - 1: "open end"}
    named[face.worst] = f"{named[face.worst]}, worst" if face.worst in named else "worst"
    rows = tuple(
        (named[place], fixed(face.z_mm[place]), fixed(face.w0_mm[place], 4), fixed(face.min_backlash_um[place]),
         fixed(face.min_in_motion_um[place]))
        for place in sorted(named)
    )  # fmt: skip
    note = (
        f"z from the diaphragm's outer face. Teeth incline along the axis: no gap in the plane of a section differs by "
        f"more than {face.tilt_bound_um:.2f} µm from that of the material section."
    )
    header = ("section", "z, mm", "w0, mm", "least backlash, µm", "in motion, µm")
    return Table("Along the face", header, rows, note)


def rim(analysis: Analysis) -> Table:
    """The neutral curve and both profiles, as they were built."""
    curve, figures = analysis.figures.neutral_curve, analysis.figures
    rows = [
        ("neutral curve", curve.model, ""),
        ("undeformed radius", fixed(curve.radius_mm, 4), "mm"),
        ("perimeter", fixed(curve.perimeter_mm, 4), "mm"),
        ("growth of the perimeter", signed(curve.perimeter_growth * 1e6, 1), "ppm"),
        ("w at the major axis", signed(curve.major_axis_mm, 4), "mm"),
        ("w at the minor axis", signed(curve.minor_axis_mm, 4), "mm"),
    ]
    for name, profile in (("flexspline", figures.flexspline), ("circular spline", figures.circular_spline)):
        rows.append((f"{name}: tip land", fixed(profile.tip_land_mm, 4), "mm"))
        rows.append((f"{name}: root floor", fixed(profile.root_floor_mm, 4), "mm"))
        if profile.blend_thickness_modules is not None:
            rows.append((f"{name}: S_l*", fixed(profile.blend_thickness_modules, 4), "modules"))
    return Table("Geometry as built", ("", "", ""), tuple(rows))
