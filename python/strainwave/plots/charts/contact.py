"""Where on their profiles the teeth come closest."""

from __future__ import annotations

import numpy as np

from strainwave._kernel import Profile
from strainwave.analysis import Analysis
from strainwave.analysis.witness import piece_names
from strainwave.columns import Floats, Mask
from strainwave.outlines import flank_points
from strainwave.plots.charts.chart import Area, Chart, Element, Level, Line, Panel, Points
from strainwave.plots.charts.words import generator_words
from strainwave.plots.style import BLUE, GREY, INK, ORANGE, SKY, VERMILION

CHORD_ERROR_MODULES = 2e-4
# A join of pieces is named in the picture where both pieces are longer than this, in modules.
BESIDE = 0.15


def contact_chart(analysis: Analysis) -> Chart:
    """Both profiles with the closest point of every tooth of the lobe, and its arc length over the tooth index.

    Of each tooth the closer flank counts; left flanks are shown on the right half, for profiles are symmetric.
    """
    teeth, witnesses = analysis.teeth, analysis.teeth.witnesses
    rows, closer = np.arange(len(teeth)), witnesses.closer_flank
    flexspline_u = witnesses.flexspline_u_mm[rows, closer]
    ring_u = witnesses.circular_spline_u_mm[rows, closer]
    geometry = analysis.geometry
    nearly = "closest" if not analysis.interference else "closest or deepest"
    return Chart(
        title=analysis.design.title,
        verdict=f"{nearly} points of the teeth at generator angle {analysis.generator_angle_deg:g}°; "
        f"{generator_words(analysis)}",
        panels=(
            _profile_panel(analysis, geometry.flexspline, flexspline_u, "Flexspline tooth", SKY),
            _profile_panel(analysis, geometry.circular_spline, ring_u, "Circular-spline tooth", ORANGE),
            _index_panel(analysis, flexspline_u, ring_u),
        ),
        columns=3,
        widths=(1.0, 1.0, 1.3),
        size_inches=(11.4, 5.4),
    )


def _profile_panel(analysis: Analysis, profile: Profile, u: Floats, title: str, colour: str) -> Panel:
    outline = flank_points(profile.segments, chord_error_mm=CHORD_ERROR_MODULES * analysis.design.module)
    below = outline[-1, 1] - BESIDE * analysis.design.module
    material = np.concatenate([outline, [[outline[-1, 0], below], [0.0, below]]])
    joins = profile.position(profile.knots[1:-1])
    elements: list[Element] = [
        Area(outline=material, colour=colour, opacity=0.3),
        Line(x=outline[:, 0], y=outline[:, 1], colour=INK, width=1.0),
        Points(x=joins[:, 0], y=joins[:, 1], colour=GREY, symbol="square", size=3.0, name="joins of the pieces",
               words=tuple(map(" · ".join, zip(*_neighbours(profile), strict=True)))),
    ]  # fmt: skip
    return Panel(
        title=title,
        x="from the tooth's axis, mm",
        y="above the pitch circle, towards the tip, mm",
        equal=True,
        elements=(*elements, *_of_teeth(analysis, *profile.position(u).T)),
    )


def _neighbours(profile: Profile) -> tuple[list[str], list[str]]:
    names = [str(name) for name in piece_names(profile)]
    return names[:-1], names[1:]


def _index_panel(analysis: Analysis, flexspline_u: Floats, ring_u: Floats) -> Panel:
    tip = Level(at=float(analysis.geometry.flexspline.knots[1]), colour=GREY, name="flexspline's tip corner")
    index = analysis.teeth.index
    lines = (
        Line(x=index, y=flexspline_u, colour=SKY, width=5.0, opacity=0.6, name="on the flexspline"),
        Line(x=index, y=ring_u, colour=ORANGE, width=5.0, opacity=0.6, name="on the circular spline"),
    )
    return Panel(
        title="From tip to root",
        x="tooth index from the major axis",
        y="arc length from the middle of the tip, mm",
        elements=(tip, *lines, *_of_teeth(analysis, index, flexspline_u), *_of_teeth(analysis, index, ring_u)),
    )


def _of_teeth(analysis: Analysis, x: Floats, y: Floats) -> tuple[Points, ...]:
    """One mark a tooth, by how close it is."""
    gap, threshold = analysis.teeth.backlash_um, analysis.threshold_um
    words = np.array(
        [
            f"tooth {tooth} at index {index:.2f}<br>{least:.3f} µm"
            for tooth, index, least in zip(analysis.teeth.tooth, analysis.teeth.index, gap, strict=True)
        ],
        dtype=object,
    )

    def marks(where: Mask, name: str, **look: object) -> Points:
        return Points(x=x[where], y=y[where], name=name, words=tuple(words[where]), **look)  # type: ignore[arg-type]

    groups = [
        marks(gap >= threshold, f"teeth {threshold:g} µm apart or more", colour=GREY, hollow=True, size=3.0),
        marks((gap >= 0.0) & (gap < threshold), f"teeth less than {threshold:g} µm apart", colour=BLUE, size=4.5),
        marks(gap < 0.0, "interfering teeth", colour=VERMILION, symbol="x", size=6.5),
    ]
    return tuple(group for group in groups if len(group.x))
