"""The case study in one picture: backlash over tooth index for the four cases, beside the published figures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.plots.backlash import (
    draw_gap,
    draw_threshold_and_interference,
    gap_on_both_sides,
    limit_to_contact,
)
from strainwave.plots.style import INK, ORANGE, house_style

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.analysis.case_study import CaseResult, CaseStudy, PublishedFigures

# Room above the curves for each panel's figures.
THRESHOLDS_SHOWN = 5.6


def case_study_figure(study: CaseStudy) -> Figure:
    """Four panels, one for each row of the article's table, over the tooth index -51 .. 51."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=(10.4, 7.2), layout="constrained")
        panels = figure.subplots(2, 2, sharex=True, sharey=True)
        calibrated = [result for result in study.results if result.reading == "calibrated"]
        limit_to_contact(panels[0, 0], *(each.analysis for each in study.results), thresholds_shown=THRESHOLDS_SHOWN)
        for axes, result in zip(panels.flat, calibrated, strict=True):
            _draw_case(axes, result, study.result(result.case.key, "as-printed"))
        for axes in panels[-1]:
            axes.set_xlabel("tooth index from the major axis")
        for axes in panels[:, 0]:
            axes.set_ylabel("normal backlash, µm")
        handles, labels = _one_of_each(panels.flat)
        figure.legend(handles, labels, loc="outside lower center", ncols=4)
    return figure


def _draw_case(axes: Axes, calibrated: CaseResult, printed: CaseResult) -> None:
    draw_threshold_and_interference(axes, calibrated.analysis)
    _draw_printed(axes, printed)
    draw_gap(axes, calibrated.analysis, "calibrated, ")
    _mark_published(axes, calibrated.case.published)
    axes.set_title(calibrated.case.title)
    axes.text(
        0.5,
        0.97,
        _figures_text(calibrated, printed),
        transform=axes.transAxes,
        ha="center",
        va="top",
        family="DejaVu Sans Mono",
        fontsize=7.5,
        color=INK,
        bbox={"fc": "white", "ec": "none", "pad": 1.5},
    )


def _draw_printed(axes: Axes, printed: CaseResult) -> None:
    curve = gap_on_both_sides(printed.analysis)
    axes.plot(*curve, color=INK, lw=1.1, ls=(0, (1, 1.2)), label="as printed, no flank clearance")


def _mark_published(axes: Axes, published: PublishedFigures) -> None:
    """The published minimum as a level, the published ends of a zone as ticks on it."""
    label = "published: least backlash, end of the zone"
    axes.axhline(published.min_backlash_um, color=ORANGE, lw=1.4, label=label)
    end = published.first_interfering_tooth or published.teeth_below_per_side
    if end is not None:
        level = 0.0 if published.interference else 10.0
        axes.plot([-end, end], [level, level], "|", color=ORANGE, ms=14, mew=2.0)


def _figures_text(calibrated: CaseResult, printed: CaseResult) -> str:
    """The figures of the panel as a small table in a font of even width."""
    published, computed = calibrated.case.published, (printed.analysis, calibrated.analysis)
    rows = [
        ("", "published", "as printed", "calibrated"),
        ("least, µm", f"{published.min_backlash_um:g}", *(f"{each.min_backlash_um:.2f}" for each in computed)),
        ("in motion, µm", "–", *(f"{each.min_in_motion_um:.2f}" for each in computed)),
    ]
    if published.teeth_below_per_side is not None:
        counts = (published.teeth_below_per_side, *(each.teeth_below.per_side for each in computed))
        rows.append(("< 10 µm per side", *(f"{count}" for count in counts)))
    if published.first_interfering_tooth is not None:
        firsts = (published.first_interfering_tooth, *(each.first_interfering_tooth for each in computed))
        rows.append(("interferes from", *(f"{first}" for first in firsts)))
    return "\n".join(f"{row[0]:<16}" + "".join(f"{cell:>12}" for cell in row[1:]) for row in rows).replace("-", "−")


def _one_of_each(panels: Iterable[Axes]) -> tuple[list[Artist], list[str]]:
    found: dict[str, Artist] = {}
    for axes in panels:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            found.setdefault(label, handle)
    return list(found.values()), list(found)
