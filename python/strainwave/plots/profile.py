"""Both tooth profiles with their dimensions: what each number of the design file means."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.geometry import Geometry
from strainwave.plots.dimension import Dimension
from strainwave.plots.dimension_drawing import BROUGHT_OUT, DIMMED, FONT_SIZE, PLAIN, draw_strokes, draw_words
from strainwave.plots.profile_dimensions import neutral_height, profile_dimensions, rim_dimensions
from strainwave.plots.style import GREY, INK, ORANGE, SKY, house_style
from strainwave.plots.tooth_sketch import ToothSketch

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.design import Design

# Inches.
SIZE = (11.0, 4.7)
TITLE_HEIGHT = 0.72
LEGEND_HEIGHT = 0.3
COLUMN_WIDTH = 1.68
# Modules: what is drawn below the root of a body without a thickness, and left free around the teeth.
BODY_BELOW_ROOT = 0.35
ABOVE_TIP = 0.4
BELOW = 0.05
LONGEST_TITLE = 90
# A rim thicker than this, in whole depths of the tooth, is drawn so thick and said to be.
THICKEST_RIM = 1.0


@dataclass(frozen=True)
class ToothSide:
    """One spline of the picture: its table in the design file, its tooth, and the rim drawn below it in modules."""

    table: str
    sketch: ToothSketch
    rim: float
    colour: str

    def dimensions(self, design: Design, highlight: str) -> list[Dimension]:
        """All that are shown of this spline; ``highlight``, a key of the design, is among them if it can be."""
        found = list(profile_dimensions(self.sketch, self.own(highlight)))
        return [*found, *rim_dimensions(design, self.rim, self.sketch)] if self.rim else found

    def own(self, key: str) -> str:
        """The part of a key below the table; nothing where it is a key of another."""
        return key.removeprefix(f"{self.table}.") if key.startswith(f"{self.table}.") else ""


def profile_figure(design: Design, *, highlight: str = "") -> Figure:
    """Both teeth in their own frames, dimensioned; ``highlight`` is the dotted key of one number to bring out.

    A key that the sketch does not show brings nothing out. DesignError where the design has no geometry.
    """
    from matplotlib.figure import Figure

    sides = sides_of(design)
    window = _Window.around(sides)
    dimensions = [side.dimensions(design, highlight) for side in sides]
    others = DIMMED if any(
        each.shows(side.own(highlight)) for side, found in zip(sides, dimensions, strict=True) for each in found
    ) else PLAIN  # fmt: skip
    with house_style():
        figure = Figure(figsize=SIZE)
        for place, (side, found) in enumerate(zip(sides, dimensions, strict=True)):
            axes = figure.add_axes((0.5 * place, LEGEND_HEIGHT / SIZE[1], 0.5, _height() / SIZE[1]))
            window.frame(axes)
            _draw_tooth(axes, design, side)
            looks = [(each, BROUGHT_OUT if each.shows(side.own(highlight)) else others) for each in found]
            for each, look in looks:
                draw_strokes(axes, each, look)
            for sign, name in ((-1.0, "left"), (1.0, "right")):
                words = [(each, look) for each, look in looks if each.side == name]
                draw_words(axes, words, sign * window.column, window.inch)
        _write_titles(figure, design)
        figure.legend(*figure.axes[0].get_legend_handles_labels(), loc="lower center", ncols=4, fontsize=FONT_SIZE)
    return figure


def sides_of(design: Design) -> tuple[ToothSide, ToothSide]:
    """Flexspline and circular spline. DesignError where the design has no geometry."""
    geometry = Geometry.of(design)
    flexspline = ToothSketch(design.flexspline.profile, geometry.flexspline, design.module)
    circular_spline = ToothSketch(design.circular_spline.profile, geometry.circular_spline, design.module)
    rim = min(design.flexspline.wall_thickness / design.module, THICKEST_RIM * flexspline.depth)
    return ToothSide("flexspline", flexspline, rim, SKY), ToothSide("circular_spline", circular_spline, 0.0, ORANGE)


def _height() -> float:
    return SIZE[1] - TITLE_HEIGHT - LEGEND_HEIGHT


@dataclass(frozen=True)
class _Window:
    """What both panels show, in modules, at one scale, so that the pitch circles stand level."""

    inch: float
    middle: float

    @classmethod
    def around(cls, sides: tuple[ToothSide, ...]) -> _Window:
        outlines = np.concatenate([side.sketch.outline for side in sides])
        low = min(side.sketch.outline[:, 1].min() - (side.rim or BODY_BELOW_ROOT) for side in sides) - BELOW
        high = outlines[:, 1].max() + ABOVE_TIP
        across = 2.5 * max(side.sketch.half_pitch for side in sides)
        inch = max((high - low) / _height(), across / (0.5 * SIZE[0] - 2.0 * COLUMN_WIDTH))
        return cls(float(inch), float(0.5 * (low + high)))

    @property
    def column(self) -> float:
        """Distance of the columns of words from the tooth's axis."""
        return (0.25 * SIZE[0] - COLUMN_WIDTH) * self.inch

    def frame(self, axes: Axes) -> None:
        half = 0.5 * _height() * self.inch
        axes.set_xlim(-0.25 * SIZE[0] * self.inch, 0.25 * SIZE[0] * self.inch)
        axes.set_ylim(self.middle - half, self.middle + half)
        axes.axis("off")


def _draw_tooth(axes: Axes, design: Design, side: ToothSide) -> None:
    """The tooth with the body below it, and the circles that its heights are counted from."""
    sketch, spec = side.sketch, side.sketch.spec
    inner, outer = (np.linspace(share, -share, 129) * sketch.half_pitch for share in (1.0, 1.12))
    below = sketch.circle(-spec.dedendum - (side.rim or BODY_BELOW_ROOT), inner)
    axes.fill(*np.concatenate([sketch.outline, below]).T, facecolor=side.colour, alpha=0.3, lw=0)
    axes.plot(*sketch.outline.T, color=INK, lw=1.3)
    thin: dict[str, Any] = {"color": GREY, "lw": 0.7}
    axes.plot(*sketch.circle(0.0, outer).T, ls=(0, (8, 2, 1.5, 2)), label="pitch circle", **thin)
    for height, label in ((spec.addendum, "addendum and dedendum circles"), (-spec.dedendum, None)):
        axes.plot(*sketch.circle(height, outer).T, ls=(0, (4, 3)), label=label, **thin)
    axes.plot([0.0, 0.0], [-spec.dedendum, spec.addendum + 0.2], ls=(0, (12, 3)), label="tooth's axis", **thin)
    if side.rim:
        axes.plot(*below.T, color=INK, lw=1.3)
        neutral = sketch.circle(neutral_height(design, side.rim), inner)
        axes.plot(*neutral.T, ls=(0, (1, 1.5)), label="neutral circle", **thin)


def _write_titles(figure: Figure, design: Design) -> None:
    title = design.title if len(design.title) <= LONGEST_TITLE else f"{design.title[: LONGEST_TITLE - 1]}…"
    words: dict[str, Any] = {"va": "top", "color": INK}
    figure.text(0.012, 0.985, title, weight="bold", fontsize=10, parse_math=False, **words)
    figure.text(
        0.012, 0.94, f"module m = {design.module:g} mm; each tooth in its own frame, y towards its tip", **words
    )
    flexspline, circular_spline = design.flexspline, design.circular_spline
    for place, text in enumerate((
        f"flexspline: {flexspline.teeth} teeth, {flexspline.profile.kind}",
        f"circular spline: {circular_spline.teeth} teeth, {circular_spline.profile.kind}",
    )):  # fmt: skip
        figure.text(0.25 + 0.5 * place, 0.88, text, ha="center", weight="bold", **words)
