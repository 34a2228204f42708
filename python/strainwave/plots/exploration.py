"""An exploration in pictures: parameters and figures against each other, and each design as a line over them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from strainwave.batch import metrics as metric
from strainwave.columns import Floats
from strainwave.plots.style import BLUE, GREEN, GREY, INK, ORANGE, PALE, PURPLE, SKY, VERMILION, house_style
from strainwave.studies.exploration.rows import SAMPLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    from strainwave.studies.exploration import Selection, Summary

POINTS_SHOWN = 1500
LINES_SHOWN = 200
MOST_VARIABLES = 7
ABSENT_HEIGHT = -0.14
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, SKY)


def scatter_matrix_figure(found: Summary) -> Figure:
    """Every parameter against every other one and the figures that decide, a colour for each wave generator.

    The points are the first of the sequence, which are spread as evenly as all; those that are not wanted are pale.
    """
    from matplotlib.figure import Figure

    exploration = found.exploration
    every = type(exploration)(exploration.place, exploration.finished).first(POINTS_SHOWN)
    wanted = _among(every, exploration.first(POINTS_SHOWN))
    names = _variables(found)
    with house_style():
        side = 1.0 + 1.2 * len(names)
        figure = Figure(figsize=(side, side), layout="constrained")
        panels = figure.subplots(len(names), len(names), squeeze=False)
        for row, across in enumerate(names):
            for column, name in enumerate(names):
                axes = panels[row, column]
                if column > row:
                    axes.set_axis_off()
                elif column == row:
                    _histogram(axes, every, wanted, name)
                else:
                    _points(axes, found, every, wanted, name, across)
                _label(axes, name, across, column == 0 and row > 0, row == len(names) - 1)
        _title(figure, found, f"the first {len(every)} designs, and the best")
        figure.legend(handles=_handles(found), loc="outside lower center", ncols=5)
        return figure


def parallel_coordinates_figure(found: Summary) -> Figure:
    """Each wanted design as a line over its parameters and figures, the best ones on top."""
    from matplotlib.figure import Figure

    wanted = found.exploration.first(LINES_SHOWN)
    names = _variables(found)
    ends = {name: _ends(found, name) for name in names}
    with house_style():
        figure = Figure(figsize=(1.4 + 1.2 * len(names), 4.4), layout="constrained")
        axes = figure.add_subplot()
        colours = _colours(found)
        for generator, heights in zip(wanted.generators, _heights(wanted, names, ends), strict=True):
            axes.plot(heights, color=colours[generator], lw=0.5, alpha=0.35)
        for heights in _heights(found.best, names, ends):
            axes.plot(heights, color=VERMILION, lw=1.3)
        axes.set_xticks(range(len(names)), [_name(name) for name in names])
        axes.set_xlim(-0.2, len(names) - 0.8)
        axes.set_yticks([])
        axes.grid(visible=False)
        axes.spines[["left", "bottom"]].set_visible(False)
        axes.set_ylim(ABSENT_HEIGHT - 0.1, 1.1)
        axes.tick_params(axis="x", length=0)
        for place, name in enumerate(names):
            axes.plot([place, place], [0.0, 1.0], color=INK, lw=0.8)
            for height, value, align in ((-0.02, ends[name][0], "top"), (1.02, ends[name][1], "bottom")):
                axes.text(place, height, f"{value:.4g}".replace("-", "−"), ha="center", va=align)
            if np.isnan(wanted.column(name)).any():
                axes.text(place, ABSENT_HEIGHT - 0.02, "has none", ha="center", va="top", color=GREY)
        _title(figure, found, f"the first {len(wanted)} designs that meet all")
        figure.legend(handles=_handles(found)[1:], loc="outside lower center", ncols=4)
        return figure


def _among(every: Selection, wanted: Selection) -> Selection:
    """Those that are wanted of the first ones; both are in the order of the sequence."""
    last = every.column(SAMPLE).max(initial=-1.0)
    return replace(wanted, table=wanted.table.slice(0, int((wanted.column(SAMPLE) <= last).sum())))


def _variables(found: Summary) -> list[str]:
    """The objective, the least backlash and the parameters, as many as find room."""
    plan = found.exploration.plan
    least = "min_in_motion_um" if plan.in_motion else "min_backlash_um"
    names = dict.fromkeys((*plan.keys, least, found.objective.partition("=")[0]))
    figures = [name for name in names if name not in plan.keys]
    return [*plan.keys[: MOST_VARIABLES - len(figures)], *figures]


def _points(axes: Axes, found: Summary, every: Selection, wanted: Selection, name: str, across: str) -> None:
    axes.plot(every.column(name), every.column(across), ".", ms=2.0, color=PALE, rasterized=True)
    colours = _colours(found)
    of_points = [colours[label] for label in wanted.generators]  # in one call, or one colour would hide another
    axes.scatter(wanted.column(name), wanted.column(across), 4.0, of_points, lw=0.0, zorder=2.5, rasterized=True)
    axes.plot(found.best.column(name), found.best.column(across), "o", ms=3.5, mfc="none", mec=VERMILION, zorder=3)


def _histogram(axes: Axes, every: Selection, wanted: Selection, name: str) -> None:
    """How many of all and of the wanted have which value."""
    values = every.column(name)
    there = values[np.isfinite(values)]
    bins = np.histogram_bin_edges(there, 24).tolist()
    axes.hist(there, bins, color=PALE)
    axes.hist(wanted.column(name), bins, histtype="step", color=INK, lw=0.9)
    axes.set_yticks([])


def _label(axes: Axes, name: str, across: str, left: bool, below: bool) -> None:
    axes.tick_params(labelsize=7, labelleft=left, labelbottom=below)
    axes.locator_params(nbins=3)
    if left:
        axes.set_ylabel(_name(across), fontsize=8)
    if below:
        axes.set_xlabel(_name(name), fontsize=8)


def _heights(chosen: Selection, names: list[str], ends: dict[str, tuple[float, float]]) -> list[Floats]:
    """Each design's places on the axes, from 0 to 1, or below them where it has no such number; (names,) each."""
    columns = [(chosen.column(name) - ends[name][0]) / (ends[name][1] - ends[name][0]) for name in names]
    return list(np.nan_to_num(np.stack(columns, axis=1), nan=ABSENT_HEIGHT))


def _ends(found: Summary, name: str) -> tuple[float, float]:
    """The range of a parameter, and what the wanted designs have of a figure."""
    for parameter in found.exploration.plan.parameters:
        if parameter.key == name:
            return parameter.low, parameter.high
    spread = found.spreads[name]
    if not spread.count:
        return 0.0, 1.0
    return spread.least, spread.greatest if spread.greatest > spread.least else spread.least + 1.0


def _name(name: str) -> str:
    """A column's name on two lines."""
    if name in metric.COLUMNS:
        figure, unit = (name.removesuffix("_um"), ", µm") if name.endswith("_um") else (name, "")
        words = figure.replace("_per_side", "").replace("_", " ")
        return f"{words}{unit}"
    table, _, key = name.rpartition(".")
    return f"{key.replace('_', ' ')}\n{table.partition('.')[0].replace('_', ' ')}"


def _colours(found: Summary) -> dict[str, str]:
    """A colour for each wave generator; they repeat where there are more of them than colours."""
    labels = [category.label for category in found.exploration.plan.categories]
    return {label: COLOURS[place % len(COLOURS)] for place, label in enumerate(labels)}


def _handles(found: Summary) -> list[Line2D]:
    from matplotlib.lines import Line2D

    handles = [Line2D([], [], color=PALE, marker="o", ls="", ms=4, label="misses a requirement")]
    handles += [
        Line2D([], [], color=colour, marker="o", ls="", ms=4, label=label) for label, colour in _colours(found).items()
    ]
    best = f"best {len(found.best)} in {found.objective}"
    return [*handles, Line2D([], [], color=VERMILION, marker="o", mfc="none", ls="", ms=5, label=best)]


def _title(figure: Figure, found: Summary, shown: str) -> None:
    plan = found.exploration.plan
    title = plan.design.title + (f"; {plan.space.name}" if plan.space.name else "")
    figure.suptitle(f"{title}: {shown}", x=0.01, ha="left", fontsize=10.0, fontweight="bold", parse_math=False)
