"""A flexspline tooth on its way through its space."""

from __future__ import annotations

import numpy as np

from strainwave.analysis import Analysis
from strainwave.columns import Floats
from strainwave.plots.charts.chart import NOWHERE, Area, Chart, Element, Line, Panel, Points
from strainwave.plots.charts.words import generator_words
from strainwave.plots.style import BLUE, GREEN, INK, ORANGE, SKY, VERMILION
from strainwave.scene.trajectory import Trajectory

# The tooth is drawn at every so many indices, and its place is marked at every so many.
TEETH_BETWEEN, MARKS_BETWEEN = 3, 10
# The window: half its width in pitches, and room above the teeth's tips in modules.
HALF_PITCHES, ABOVE, BELOW = 0.78, 1.5, 3.4


def trajectory_chart(analysis: Analysis) -> Chart:
    """The tooth at many indices, the path of its tip, and the envelope of its flanks beside the circular spline."""
    way = Trajectory.of(analysis)
    module = analysis.design.module
    half = HALF_PITCHES * np.pi * module
    panel = Panel(
        x="from the middle of the space, mm",
        y="above the circular spline's pitch circle, outward, mm",
        elements=tuple(_elements(way)),
        equal=True,
        x_range=(-half, half),
        y_range=(-BELOW * module, ABOVE * module),
    )
    return Chart(
        title=analysis.design.title,
        verdict=f"{analysis.verdict}; {generator_words(analysis)}",
        warns=analysis.interference,
        panels=(panel,),
        size_inches=(7.6, 8.2),
    )


def _elements(way: Trajectory) -> list[Element]:
    middle = len(way.index) // 2
    shown = way.teeth[middle % TEETH_BETWEEN :: TEETH_BETWEEN]
    marked = np.flatnonzero(way.path_index % MARKS_BETWEEN == 0.0)
    marks = way.path[marked]
    words = tuple(f"index {index:.0f}" for index in way.path_index[marked])
    name = "circular spline"
    return [
        *(Area(outline=ring, colour=ORANGE, opacity=0.35, name=name) for ring in way.ring),
        *(Line(x=ring[:, 0], y=ring[:, 1], colour=INK, width=1.1) for ring in way.ring),
        _broken(list(shown), SKY, f"flexspline tooth at every {TEETH_BETWEEN}rd index", 0.7),
        Area(outline=way.teeth[middle], colour=BLUE, opacity=0.25, name="flexspline tooth on the major axis"),
        _broken(_both(way.envelope), VERMILION, "envelope, all branches", 0.9),
        _broken(_both(way.swept), GREEN, "boundary of the swept region", 2.2),
        Line(x=way.path[:, 0], y=way.path[:, 1], colour=INK, width=1.3, dashes="dash", name="path of the tip"),
        Points(x=marks[:, 0], y=marks[:, 1], colour=INK, size=4.0, words=words,
               name=f"every {MARKS_BETWEEN}th index"),
    ]  # fmt: skip


def _both(curves: tuple[Floats, ...]) -> list[Floats]:
    """Curves beside the tooth on the right, and their mirror images beside the one on the left."""
    return [curve * (side, 1.0) for curve in curves for side in (1.0, -1.0)]


def _broken(curves: list[Floats], colour: str, name: str, width: float) -> Line:
    """Many curves as one line with breaks."""
    parts = [part for curve in curves for part in (curve, NOWHERE)] or [NOWHERE]
    points = np.concatenate(parts)
    return Line(x=points[:, 0], y=points[:, 1], colour=colour, name=name, width=width)
