"""The backlash of several wave generators over the tooth index: at a common w0, and each at its own."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.plots.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.studies.comparison import Comparison, Contender
    from strainwave.studies.comparison.contender import Setting

CURVE_SAMPLES = 1025
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, INK, SKY)
DASHES = ("-", (0, (5, 1.5)), (0, (1.5, 1.2)))
# The zone of near contact is what the picture is for: so many thresholds above zero, and at most so many below.
THRESHOLDS_ABOVE = 3.0
THRESHOLDS_BELOW = 4.0
LEGEND = "w0 in mm, least in motion in µm"
# Labels up to this length stand in two columns below a panel. For more rows than usual the picture grows.
LONGEST_BESIDE = 18
USUAL_ROWS = 3
ROW_INCHES = 0.16


def comparison_figure(comparison: Comparison) -> Figure:
    """Two panels with one curve for each generator, from the major axis to the minor one."""
    from matplotlib.figure import Figure

    with house_style():
        labels = list(dict.fromkeys(each.label for each in comparison.contenders))
        columns = 2 if max(map(len, labels)) <= LONGEST_BESIDE else 1
        more_rows = max(0, -(-len(labels) // columns) - USUAL_ROWS)
        figure = Figure(figsize=(9.6, 5.2 + ROW_INCHES * more_rows), layout="constrained")
        panels = figure.subplots(1, 2, sharex=True, sharey=True)
        for axes, (setting, title) in zip(panels, titles(comparison).items(), strict=True):
            _draw_levels(axes, comparison)
            for contender in comparison.at(setting):
                _draw(axes, contender, labels.index(contender.label))
            axes.set_title(title)
            axes.set_xlabel("tooth index from the major axis")
            # Below the panel: no corner of it is free of curves for certain.
            axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=columns, fontsize=7.5, title=LEGEND)
        figure.suptitle(comparison.design.title, x=0.01, ha="left", size=10.0, weight="bold", parse_math=False)
        _limit(panels[0], comparison)
        panels[0].set_ylabel("normal backlash, µm")
    return figure


def titles(comparison: Comparison) -> dict[Setting, str]:
    """What the contenders of each setting have in common."""
    return {
        "common": f"all at w0 {comparison.w0_mm:g} mm",
        "tuned": f"each at its own w0, {comparison.goal}",
    }


def _limit(axes: Axes, comparison: Comparison) -> None:
    axes.set_xlim(0.0, comparison.design.flexspline.teeth / 4)
    axes.set_ylim(*gap_range(comparison))


def gap_range(comparison: Comparison) -> tuple[float, float]:
    """From the deepest interference worth seeing to some thresholds above zero, um."""
    found = [each.analysis for each in comparison.contenders if each.analysis]
    threshold = comparison.threshold_um
    lowest = min([0.0, *(each.min_in_motion_um for each in found)])
    return max(lowest, -THRESHOLDS_BELOW * threshold) - 0.5 * threshold, THRESHOLDS_ABOVE * threshold


def _draw_levels(axes: Axes, comparison: Comparison) -> None:
    axes.axhspan(-1e6, 0.0, color=VERMILION, alpha=0.12, lw=0)
    axes.axhline(0.0, color=VERMILION, lw=1.0)
    axes.axhline(comparison.threshold_um, color=GREY, lw=1.0, ls=(0, (5, 3)))


def _draw(axes: Axes, contender: Contender, number: int) -> None:
    """One generator's curve of all generator angles; without a gear only its entry in the legend."""
    colour, dash = COLOURS[number % len(COLOURS)], DASHES[number // len(COLOURS) % len(DASHES)]
    found = contender.analysis
    if found is None:
        axes.plot([], [], color=colour, ls=dash, label=f"{contender.label}: none")
        return
    least = f"{found.min_in_motion_um:.2f}".replace("-", "−")
    label = f"{contender.label}: {found.design.wave_generator.w0:.4f}, {least}"
    axes.plot(*found.gap_curve.sample(CURVE_SAMPLES), color=colour, ls=dash, lw=1.4, label=label)
    axes.plot(
        found.min_in_motion_index, found.min_in_motion_um, "D", ms=4.5, mfc=colour, mec="white", mew=0.6, zorder=5
    )
