"""The pictures of a design, each with what is to be seen in it."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from strainwave.report.block import Plate

if TYPE_CHECKING:
    from strainwave.analysis import Analysis, FaceMap


def sketch_plate(analysis: Analysis) -> Plate:
    """What each number of the design file means."""
    from strainwave.plots.profile import profile_figure

    caption = "Both teeth with the numbers of the design file, in modules; radii that end in the picture are cut short."
    return Plate("Tooth profiles", caption, partial(profile_figure, analysis.design))


def distribution_plate(analysis: Analysis) -> Plate:
    """Backlash of every tooth."""
    from strainwave.plots.backlash import backlash_figure
    from strainwave.plots.interactive import backlash_figure as interactive

    caption = (
        "Backlash of every tooth over its place from the generator's major axis. All teeth at all generator angles lie "
        "on the curve; below zero they overlap."
    )
    return Plate("Backlash distribution", caption, partial(backlash_figure, analysis), partial(interactive, analysis))


def detail_plates(analysis: Analysis) -> tuple[Plate, ...]:
    """How the teeth stand, where they come closest, and what moves them."""
    from strainwave import plots
    from strainwave.plots import interactive

    return (
        Plate(
            "Assembly",
            "Every tooth with the generator's major axis up; teeth are coloured by their clearance.",
            partial(plots.assembly_figure, analysis),
            partial(interactive.assembly_figure, analysis),
            upright=True,
        ),
        Plate(
            "The least gap and its certificate",
            "The gap over continuous tooth index; no index has less than the certified bound.",
            partial(plots.gap_figure, analysis),
            partial(interactive.gap_figure, analysis),
        ),
        Plate(
            "Where the teeth are closest",
            "Closest points of every tooth pair on both profiles.",
            partial(plots.contact_figure, analysis),
            partial(interactive.contact_figure, analysis),
        ),
        Plate(
            "A tooth on its way through its space",
            "The flexspline's tooth in the frame of the space that it passes, and the outline of all it sweeps.",
            partial(plots.trajectory_figure, analysis),
            partial(interactive.trajectory_figure, analysis),
            upright=True,
        ),
        Plate(
            "The rim",
            "Displacements, slope and curvature of the neutral curve over the angle from the major axis.",
            partial(plots.neutral_curve_figure, analysis),
            partial(interactive.neutral_curve_figure, analysis),
        ),
    )


def space_plate(analysis: Analysis) -> Plate:
    """The gear in space."""
    from strainwave.plots.assembly_3d import assembly_3d_figure
    from strainwave.plots.interactive.assembly_3d import assembly_3d_figure as interactive

    caption = (
        "The gear with the cup bent and coned, its teeth coloured by their clearance. On a screen it can be turned."
    )
    return Plate(
        "Assembly in space",
        caption,
        partial(assembly_3d_figure, analysis),
        partial(interactive, analysis),
        turnable=True,
    )


def face_plate(face: FaceMap) -> Plate:
    """Backlash along the face."""
    from strainwave.plots.face import face_figure
    from strainwave.plots.interactive.face import face_figure as interactive

    caption = (
        "Every tooth in every section of the coned cup, which is bent in proportion to the distance from its "
        "diaphragm; the figures above hold at mid-face."
    )
    return Plate("Backlash along the face", caption, partial(face_figure, face), partial(interactive, face))
