"""Error against time, a curve for each way."""

from __future__ import annotations

from typing import TYPE_CHECKING

from measurement.accuracy import Point

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LABELS = {
    "points": "all pairs of points (NumPy)",
    "k-d tree": "k-d tree of points (SciPy)",
    "shapely": "polylines (shapely)",
}
# Where the label stands beside the last point of each curve, in points of type: the curves end close together.
BESIDE = {"points": (9, 4, "left"), "k-d tree": (0, 9, "center"), "shapely": (0, -16, "center")}


def accuracy_figure(points: list[Point]) -> Figure:
    """Greatest error of any tooth's backlash against the time for one design, both on logarithmic axes."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 4.2), layout="constrained")
    axes = figure.subplots()
    for way, label in LABELS.items():
        chosen = [point for point in points if point.way == way]
        axes.plot([point.seconds for point in chosen], [point.error_um for point in chosen], "o-", label=label)
        last, (right, up, side) = chosen[-1], BESIDE[way]
        axes.annotate(
            f"{last.points:,} points",
            (last.seconds, last.error_um),
            (right, up),
            textcoords="offset points",
            horizontalalignment=side,
            fontsize="small",
        )
    (engine,) = (point for point in points if point.way == "engine")
    axes.plot([engine.seconds], [engine.error_um], "k*", markersize=14, label="strainwave, a row of a batch")
    axes.set(xscale="log", yscale="log", xlabel="time for one design, s", ylabel="greatest error of a backlash, µm")
    axes.margins(x=0.1)
    axes.grid(visible=True, which="major", alpha=0.3)
    axes.legend(loc="center left")
    return figure
