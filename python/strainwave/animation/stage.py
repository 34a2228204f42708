"""Frames as pictures: the whole gear, and beside it the teeth at the top magnified."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from strainwave.animation.film import Film
from strainwave.plots.assembly import CROSSES_AT, WHOLE_STRENGTH, draw_scale, draw_scene, legend_handles, outward
from strainwave.plots.style import INK, VERMILION, house_style, set_title
from strainwave.scene import Scene, Shape, View
from strainwave.studies.progress import Progress, silent

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

Pixels = NDArray[np.uint8]

# Inches and dots: 1120 × 620 pixels, even as video wants them.
SIZE, DOTS_PER_INCH = (11.2, 6.2), 100.0
CHORD_ERROR_MODULES = 2e-3


class Stage:
    """One figure for all frames of a film: what stands still is drawn once, the rest again for each frame."""

    def __init__(self, film: Film, first: Scene) -> None:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        self.film = film
        design = film.analysis.design
        self.whole = View.of_whole(first, design.module)
        self.top = View.of_top(first, design.module, design.circular_spline_pitch_radius_mm)
        with house_style():
            self.figure = Figure(figsize=SIZE, dpi=DOTS_PER_INCH, layout="constrained")
            canvas: Any = FigureCanvasAgg(self.figure)  # which matplotlib leaves untyped
            self.wide, self.near = self.figure.subplots(1, 2)
            self._frame()
            self.words = self.near.text(0.0, 1.02, "", transform=self.near.transAxes, va="bottom", clip_on=False)
            canvas.draw()
        self.canvas, self.background = canvas, canvas.copy_from_bbox(self.figure.bbox)

    def _frame(self) -> None:
        for axes, view in ((self.wide, self.whole), (self.near, self.top)):
            axes.set_xlim(*view.x_mm)
            axes.set_ylim(*view.y_mm)
            axes.set_aspect("equal", anchor="N")
            axes.grid(visible=False)
            axes.set_xlabel("mm")
        self.wide.set_ylabel("mm")
        self.near.set_title("\n\n\n")  # room for the words of each frame
        set_title(self.wide, self.film.analysis.design.title, longest=52, pad=18.0)
        self.wide.annotate(
            self.film.words, (0.0, 1.0), (0.0, 5.0), xycoords="axes fraction", textcoords="offset points", size=7.5
        )
        draw_scale(self.figure, self.near, self.film.analysis.threshold_um)
        handles = legend_handles(self.whole, interference=self.film.analysis.interference)
        self.figure.legend(handles=handles, loc="outside lower center", ncols=len(handles), fontsize=8.0)

    def picture(self, scene: Scene) -> Pixels:
        """A frame as RGB values, shape (height, width, 3)."""
        threshold = self.film.analysis.threshold_um
        with house_style():
            self.canvas.restore_region(self.background)
            drawn = draw_scene(self.wide, scene.shapes, threshold, strength=WHOLE_STRENGTH)
            drawn += _crosses(self.wide, scene, CROSSES_AT * self.whole.x_mm[1])
            self._draw(self.wide, drawn)
            self._draw(self.near, draw_scene(self.near, self._near(scene), threshold))
            self._say(scene)
        return np.asarray(self.canvas.buffer_rgba())[..., :3].copy()

    def _draw(self, axes: Axes, drawn: list[Artist]) -> None:
        for artist in drawn:
            axes.draw_artist(artist)
            artist.remove()

    def _near(self, scene: Scene) -> Iterator[Shape]:
        """What the magnified window shows: of the teeth only those in it, for speed."""
        reach = 2.0 * self.top.x_mm[1]
        for shape in scene.shapes:
            x, y = shape.outline_mm[0]
            if shape.role != "flexspline tooth" or (y > 0.0 and abs(x) < reach):
                yield shape

    def _say(self, scene: Scene) -> None:
        turning = scene.turning
        self.words.set_text(
            f"generator {turning.generator_deg:7.1f}°\n"
            f"flexspline {turning.flexspline_deg:+.3f}°   circular spline {turning.circular_spline_deg:+.3f}°\n"
            f"{scene.verdict}".replace("-", "−")
        )
        self.words.set_color(VERMILION if scene.overlapping else INK)
        self.near.draw_artist(self.words)


def _crosses(axes: Axes, scene: Scene, radius: float) -> list[Artist]:
    """A cross beyond every tooth that interferes."""
    teeth = [tooth for run in scene.overlapping for tooth in run]
    if not teeth:
        return []
    places = np.stack([outward(tooth) * radius for tooth in teeth])
    return list(axes.plot(*places.T, "X", ms=6, mfc=VERMILION, mec=INK, mew=0.5, ls="none"))


def pictures(film: Film, progress: Progress = silent) -> Iterator[Pixels]:
    """The frames of a film, one by one."""
    stage = None
    for place, scene in enumerate(film.scenes(CHORD_ERROR_MODULES * film.analysis.design.module)):
        stage = stage or Stage(film, scene)
        yield stage.picture(scene)
        progress(place + 1, len(film))
