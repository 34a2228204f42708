"""The assembled gear at one generator angle: the whole of it, or chosen teeth."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.clearance_colours import HATCH, OVERLAP, STEPS, THRESHOLDS, clearance_colours, step_colour
from strainwave.plots.looks import LOOKS
from strainwave.plots.style import INK, VERMILION, house_style, set_title
from strainwave.scene import Shape, View, assembly_scene

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.path import Path

    from strainwave.analysis import Analysis
    from strainwave.columns import Floats

# Chord errors in modules; chosen teeth are magnified.
WHOLE_ERROR, TEETH_ERROR = 1e-3, 1e-4
# So many chosen teeth have room for their clearances, and so many for their numbers.
CLEARANCES_FIT, NUMBERS_FIT = 16, 40
# Outlines of teeth in a view of the whole gear, against those of chosen teeth.
WHOLE_STRENGTH = 0.5
TOOTHED = ("circular spline", "flexspline", "flexspline tooth")
# Where crosses and words stand in a view of the whole gear, in shares of half its width.
CROSSES_AT, WORDS_AT = 0.955, 0.72
# Width of the pictures, and what stands above and below them, in inches.
WHOLE_WIDTH, TEETH_WIDTH, BESIDE = 8.0, 9.6, 2.3
# Parts that the legend names; those far from the teeth in a view of the whole gear only.
FAR = ("major axis", "mark")
NAMED = ("circular spline", "flexspline", "bearing", "wave generator", "neutral curve", "major axis", "mark")


def assembly_figure(
    analysis: Analysis, *, generator_angle_deg: float = 0.0, teeth: tuple[int, int] | None = None
) -> Figure:
    """Both splines and the generator to size, teeth coloured by clearance and hatched where they interfere.

    ``teeth`` chooses those from the first clockwise to the last, by number, and shows them magnified. StrainwaveError
    where there is no such tooth.
    """
    from matplotlib.figure import Figure

    view = assembly_view(analysis, generator_angle_deg, teeth, WHOLE_ERROR if teeth is None else TEETH_ERROR)
    with house_style():
        figure = Figure(figsize=_size(view), layout="compressed")
        axes = figure.add_subplot()
        draw_scene(axes, view.scene.shapes, analysis.threshold_um, strength=WHOLE_STRENGTH if teeth is None else 1.0)
        (_note_interference if teeth is None else _note_teeth)(axes, view)
        axes.set_xlim(*view.x_mm)
        axes.set_ylim(*view.y_mm)
        axes.set_aspect("equal")
        axes.grid(visible=False)
        _titles(axes, analysis, view)
        draw_scale(figure, axes, analysis.threshold_um)
        figure.legend(
            handles=legend_handles(view, interference=bool(view.scene.overlapping)), loc="outside lower center", ncols=4
        )
    return figure


def _size(view: View) -> tuple[float, float]:
    """As high as the window needs."""
    width = TEETH_WIDTH if view.teeth else WHOLE_WIDTH
    (left, right), (bottom, top) = view.x_mm, view.y_mm
    return width, (width - 0.6) * (top - bottom) / (right - left) + BESIDE


def assembly_view(
    analysis: Analysis, generator_angle_deg: float, teeth: tuple[int, int] | None, chord_error_modules: float
) -> View:
    """The assembly as both kinds of pictures show it."""
    module = analysis.design.module
    error = chord_error_modules * module
    scene = assembly_scene(analysis, generator_angle_deg=generator_angle_deg, chord_error_mm=error)
    return View.of_whole(scene, module) if teeth is None else View.of_teeth(scene, module, *teeth)


def window_words(view: View) -> str:
    """The unit, and that the gear is not seen upright."""
    turned = f"{view.turned_deg:.1f}".replace("-", "−")
    return f"mm    (the gear turned by {turned}°)" if view.teeth else "mm"


def draw_scene(axes: Axes, shapes: Iterable[Shape], threshold_um: float, *, strength: float = 1.0) -> list[Artist]:
    """Every shape of a scene in its order; ``strength`` makes the outlines of teeth stronger or finer.

    Gives what was drawn, also in its order. The window is left as it is.
    """
    from matplotlib.patches import PathPatch

    drawn: list[Artist] = []
    for role, alike in groupby(shapes, key=lambda shape: shape.role):
        look = LOOKS[role]
        width = look.width * (strength if role in TOOTHED else 1.0)
        if role == "flexspline tooth":
            drawn += _draw_teeth(axes, tuple(alike), threshold_um, width)
        elif role != "witness":
            for shape in alike:
                face = (look.face if shape.closed else None) or "none"
                line = (0.0, look.dashes) if look.dashes else "-"
                patch = PathPatch(_path(shape), fc=face, ec=look.edge, lw=width, ls=line)
                drawn.append(axes.add_artist(patch))
    return drawn


def _draw_teeth(axes: Axes, teeth: Sequence[Shape], threshold_um: float, width: float) -> list[Artist]:
    """All at once, for speed; those that interfere have a hatch, which is seen in grey too."""
    from matplotlib.collections import PolyCollection

    look = LOOKS["flexspline tooth"]
    clearance = np.array([tooth.clearance_um for tooth in teeth])
    outlines = np.stack([tooth.outline_mm for tooth in teeth])
    drawn: list[Artist] = []
    for chosen, hatch in ((clearance >= 0.0, None), (clearance < 0.0, HATCH)):
        if chosen.any():
            colours = clearance_colours(clearance[chosen], threshold_um)
            filled = PolyCollection(list(outlines[chosen]), fc=colours, ec=look.edge, lw=width, hatch=hatch)
            drawn.append(axes.add_collection(filled, autolim=False))
    return drawn


def _path(shape: Shape) -> Path:
    from matplotlib.path import Path

    if not shape.closed:
        return Path(shape.outline_mm)
    loops = [shape.outline_mm] if shape.hole_mm is None else [shape.outline_mm, shape.hole_mm[::-1]]
    return Path.make_compound_path(*(Path(np.concatenate([loop, loop[:1]]), closed=True) for loop in loops))


def _note_interference(axes: Axes, view: View) -> None:
    """A cross beyond every tooth that interferes, and the depth beside each run of them."""
    for run in view.scene.overlapping:
        out = np.stack([outward(tooth) for tooth in run])
        axes.plot(*(out * CROSSES_AT * view.x_mm[1]).T, "X", ms=7, mfc=VERMILION, mec=INK, mew=0.6, ls="none", zorder=5)
        worst = min(run, key=lambda tooth: tooth.clearance_um or 0.0)
        x, y = outward(run[len(run) // 2]) * WORDS_AT * view.x_mm[1]
        words = f"teeth {run[0].label} … {run[-1].label}" if len(run) > 1 else f"tooth {worst.label}"
        axes.text(x, y, f"{words}\n{_signed(worst)} µm", ha="center", va="center", weight="bold", size=8.0, color=INK,
                  bbox={"fc": "white", "ec": VERMILION, "lw": 1.2, "boxstyle": "round,pad=0.3"}, zorder=6)  # fmt: skip


def _note_teeth(axes: Axes, view: View) -> None:
    """Number and clearance in the rim under each chosen tooth, and a ring around every overlap."""
    if len(view.teeth) <= NUMBERS_FIT:
        for tooth in view.teeth:
            overlaps = (tooth.clearance_um or 0.0) < 0.0
            words = tooth.label if len(view.teeth) > CLEARANCES_FIT else f"{tooth.label}\n{_signed(tooth)}"
            x, y = 0.5 * (tooth.outline_mm[0] + tooth.outline_mm[-1])
            axes.annotate(
                words, (x, y), (0.0, -3.0), textcoords="offset points", ha="center", va="top", size=7.5, color=INK,
                weight="bold" if overlaps else "normal",
                bbox={"fc": "white", "ec": VERMILION if overlaps else "none", "lw": 1.0, "pad": 1.0},
            )  # fmt: skip
    shown = {tooth.tooth for tooth in view.teeth}
    points = [witness.outline_mm[0] for witness in view.scene.of_role("witness") if witness.tooth in shown]
    if points:
        axes.plot(*np.stack(points).T, "o", ms=11, mfc="none", mec=VERMILION, mew=2.0, ls="none", zorder=5)


def outward(tooth: Shape) -> Floats:
    """Unit vector from the gear's axis towards a tooth."""
    middle = tooth.outline_mm.mean(axis=0)
    return np.asarray(middle / np.hypot(*middle))


def _signed(tooth: Shape) -> str:
    return f"{tooth.clearance_um:.2f}".replace("-", "−")


def _titles(axes: Axes, analysis: Analysis, view: View) -> None:
    scene, generator = view.scene, analysis.design.wave_generator
    set_title(axes, scene.title, pad=34.0)
    axes.annotate(
        f"{scene.verdict}\n{generator.kind}, w0 {generator.w0:g} mm, generator at {scene.turning.generator_deg:g}°",
        (0.0, 1.0),
        (0.0, 6.0),
        xycoords="axes fraction",
        textcoords="offset points",
        color=VERMILION if scene.overlapping else INK,
    )
    axes.set_xlabel(window_words(view))
    axes.set_ylabel("mm")


def draw_scale(figure: Figure, axes: Axes, threshold_um: float) -> None:
    """What the colours of the teeth mean, below the axes."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import ListedColormap, Normalize

    colours = ListedColormap([step_colour(step) for step in range(STEPS)], under=OVERLAP)
    scale = ScalarMappable(Normalize(0.0, THRESHOLDS * threshold_um), colours)
    figure.colorbar(
        scale, ax=axes, location="bottom", extend="both", aspect=50, shrink=0.8, pad=0.02,
        label="normal backlash of the tooth, µm",
    )  # fmt: skip


def legend_handles(view: View, *, interference: bool) -> list[Artist]:
    """One entry for each kind of part that is there, and one for teeth that interfere."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    handles: dict[str, Artist] = {}
    for shape in view.scene.shapes:
        look = LOOKS[shape.role]
        named = shape.role in NAMED and not (view.teeth and shape.role in FAR)
        if named and shape.label and shape.label not in handles:
            if look.face is None or shape.role == "major axis":
                line = (0.0, look.dashes) if look.dashes else "-"
                handles[shape.label] = Line2D([], [], color=look.edge, lw=look.width, ls=line, label=shape.label)
            else:
                handles[shape.label] = Patch(fc=look.face, ec=look.edge, lw=look.width, label=shape.label)
    if interference:
        handles["interfering"] = Patch(fc=OVERLAP, ec=INK, hatch=HATCH, label="interfering tooth")
    return list(handles.values())
