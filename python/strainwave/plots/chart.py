"""Charts drawn with matplotlib."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from strainwave.plots.charts.chart import Area, Band, Chart, Level, Line, Panel, Points
from strainwave.plots.style import INK, VERMILION, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

DASHES = {"solid": "-", "dash": (0.0, (5.0, 3.0)), "dot": (0.0, (1.0, 2.0))}
SYMBOLS = {"circle": "o", "diamond": "D", "x": "X", "square": "s"}
# Inches: where title and verdict begin below the upper edge, what both need, and a second line of the verdict; an entry
# of the legend, a letter and one of the title.
TITLE, VERDICT, HEAD, LINE = 0.10, 0.30, 0.54, 0.15
HANDLE, LETTER, BOLD_LETTER = 0.62, 0.075, 0.1
LEFT = 0.012
MOST_TICKS = 6


def chart_figure(chart: Chart) -> Figure:
    """A chart as a static picture."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=chart.size_inches, layout="constrained")
        widths = chart.widths or (1.0,) * chart.columns
        grid = figure.subplots(chart.rows, chart.columns, squeeze=False, width_ratios=widths)
        for axes, panel in zip(grid.flat, chart.panels, strict=False):
            _draw_panel(axes, panel)
        for axes in grid.flat[len(chart.panels) :]:
            axes.set_axis_off()
        _titles(figure, chart)
        _legend(figure)
    return figure


def _titles(figure: Figure, chart: Chart) -> None:
    """Title and verdict as two lines over all panels."""
    width, height = figure.get_size_inches()
    verdict = textwrap.wrap(chart.verdict, int(width / LETTER))
    longest = int(width / BOLD_LETTER)
    shown = chart.title if len(chart.title) <= longest else f"{chart.title[: longest - 1]}…"
    colour = VERMILION if chart.warns else INK
    figure.text(LEFT, 1.0 - TITLE / height, shown, size=10.0, weight="bold", va="top", parse_math=False)
    figure.text(LEFT, 1.0 - VERDICT / height, "\n".join(verdict), color=colour, va="top", parse_math=False)
    head = HEAD + LINE * (len(verdict) - 1)
    figure.set_layout_engine("constrained", rect=(0.0, 0.0, 1.0, 1.0 - head / height))


def _draw_panel(axes: Axes, panel: Panel) -> None:
    for element in panel.elements:
        name = element.name or None
        match element:
            case Line():
                axes.plot(element.x, element.y, color=element.colour, lw=element.width, ls=DASHES[element.dashes],
                          alpha=element.opacity, label=name)  # fmt: skip
            case Points():
                _draw_points(axes, element, name)
            case Area():
                axes.fill(*element.outline.T, fc=element.colour, alpha=element.opacity, ec="none", label=name)
            case Level():
                draw = axes.axhline if element.axis == "y" else axes.axvline
                draw(element.at, color=element.colour, lw=1.0, ls=DASHES[element.dashes], label=name)
            case Band():
                shade = axes.axhspan if element.axis == "y" else axes.axvspan
                shade(element.low, element.high, color=element.colour, alpha=element.opacity, lw=0, label=name)
    set_title(axes, panel.title)
    axes.set_xlabel(panel.x)
    axes.set_ylabel(panel.y)
    if panel.x_range is not None:
        axes.set_xlim(*panel.x_range)
    if panel.y_range is not None:
        axes.set_ylim(*panel.y_range)
    if panel.equal:
        axes.set_aspect("equal", anchor="N")
    axes.locator_params(nbins=MOST_TICKS)


def _draw_points(axes: Axes, points: Points, name: str | None) -> None:
    edge, face = (points.colour, "white") if points.hollow else ("white", points.colour)
    axes.plot(points.x, points.y, SYMBOLS[points.symbol], ms=points.size, mec=edge, mfc=face, ls="none", label=name,
              mew=0.9 if points.hollow else 0.5, zorder=4)  # fmt: skip
    for x, y, note in zip(points.x, points.y, points.notes, strict=False):
        axes.annotate(note, (x, y), (0, -8), textcoords="offset points", ha="center", va="top", weight="bold")


def _legend(figure: Figure) -> None:
    """One entry for each name, whatever the number of panels that show it; as many columns as have room."""
    entries: dict[str, Artist] = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            entries.setdefault(label, handle)
    column = HANDLE + LETTER * max(map(len, entries))
    columns = min(len(entries), max(1, int(figure.get_size_inches()[0] / column)))
    figure.legend(entries.values(), entries.keys(), loc="outside lower center", ncols=columns)
