"""Teeth in mesh where they are closest, and the closest points under the magnifying glass."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from strainwave.plots.outline import placed, tooth_outline
from strainwave.plots.style import BLUE, GREY, INK, ORANGE, SKY, VERMILION, house_style, set_title
from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.analysis import Analysis

Points = NDArray[np.float64]

TEETH_EACH_SIDE = 4
# Half the magnified window in gaps, and at least so wide that both outlines are seen where teeth all but touch.
GAPS_SHOWN = 5.0
NARROWEST_WINDOW_UM = 8.0


def mesh_figure(analysis: Analysis) -> Figure:
    """The teeth about the certified minimum in motion, and its closest points magnified beside them."""
    from matplotlib.figure import Figure

    view = _UprightView(analysis)
    with house_style():
        figure = Figure(figsize=(9.0, 3.7), layout="constrained")
        wide, close = figure.subplots(1, 2, width_ratios=[1.7, 1.0])
        for axes in (wide, close):
            view.draw_teeth(axes)
            axes.grid(visible=False)
            # Anchored at the top, so that the titles stand on one line.
            axes.set_aspect("equal", anchor="N")
        _frame_wide(wide, analysis, view)
        _frame_close(close, analysis, view)
    return figure


class _UprightView:
    """The teeth about one index, turned until the tooth space there points up, with the witness as origin, in mm."""

    def __init__(self, analysis: Analysis) -> None:
        witness = analysis.witness_in_motion
        flank = witness.closer_flank[0]
        self.angle = analysis.in_motion.index * 2 * np.pi / analysis.design.circular_spline.teeth
        self.origin = witness.flexspline_point_mm[0, flank]
        self.analysis = analysis
        self.touching = self.seen(witness.circular_spline_point_mm[0, flank])

    def seen(self, points: Points) -> Points:
        return placed(points - self.origin, np.array([0.0, 0.0, -self.angle]))

    def draw_teeth(self, axes: Axes) -> None:
        geometry, index = self.analysis.geometry, self.analysis.in_motion.index
        engagement = geometry.engagement
        near = np.arange(-TEETH_EACH_SIDE, TEETH_EACH_SIDE + 1)
        flexspline = self._row(tooth_outline(geometry.flexspline), engagement.flexspline_poses(index + near))
        ring_poses = engagement.circular_spline_poses(index + near)
        ring = self._row(tooth_outline(geometry.circular_spline)[::-1], ring_poses)
        # Each body is filled away from the mesh, far enough for any window.
        for outline, colour, side in ((flexspline, SKY, -1.0), (ring, ORANGE, 1.0)):
            beyond = outline[[-1, 0]] + (0.0, side * 10.0 * self.analysis.design.module)
            axes.fill(*np.concatenate([outline, beyond]).T, facecolor=colour, alpha=0.35, lw=0)
            axes.plot(*outline.T, color=INK, lw=0.9)

    def _row(self, outline: Points, poses: Points) -> Points:
        return self.seen(np.concatenate([placed(outline, pose) for pose in poses]))


def _frame_wide(axes: Axes, analysis: Analysis, view: _UprightView) -> None:
    module = analysis.design.module
    axes.set_xlim(-6.0 * module, 6.0 * module)
    axes.set_ylim(-3.4 * module, 3.4 * module)
    axes.plot(0.0, 0.0, "o", ms=9, mfc="none", mec=VERMILION, mew=1.4)
    axes.text(0.0, -3.1 * module, "flexspline", ha="center", color=BLUE)
    axes.text(0.0, 2.9 * module, "circular spline", ha="center", color=INK)
    set_title(axes, analysis.design.title, longest=50)
    axes.set_xlabel(f"mm    (about tooth index {analysis.in_motion.index:.1f})")


def _frame_close(axes: Axes, analysis: Analysis, view: _UprightView) -> None:
    gap_um = analysis.in_motion.gap_um
    half_mm = max(GAPS_SHOWN * abs(gap_um), NARROWEST_WINDOW_UM) / MICROMETRES_PER_MM
    axes.set_xlim(-half_mm, half_mm)
    axes.set_ylim(-half_mm, half_mm)
    axes.plot(*np.stack([np.zeros(2), view.touching]).T, "o-", color=VERMILION, ms=4, lw=1.6)
    witness, flank = analysis.witness_in_motion, analysis.witness_in_motion.closer_flank[0]
    pieces = f"{witness.flexspline_piece[0, flank]} · {witness.circular_spline_piece[0, flank]}"
    axes.set_title(f"{'gap' if gap_um >= 0.0 else 'depth'} {abs(gap_um):.2f} µm")
    axes.set_xlabel(f"µm    ({pieces})")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(lambda value, _: f"{value * MICROMETRES_PER_MM:.0f}".replace("-", "−"))
        axis.set_tick_params(color=GREY)
