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


def accuracy_figure(points: list[Point]) -> Figure:
    """Greatest error of any tooth's backlash against the time for one design, both on logarithmic axes."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 4.2), layout="constrained")
    axes = figure.subplots()
    for way, label in LABELS.items():
        chosen = [point for point in points if point.way == way]
        axes.plot([point.seconds for point in chosen], [point.error_um for point in chosen], "o-", label=label)
        last = chosen[-1]
        axes.annotate(f"{last.points} points", (last.seconds, last.error_um), (0, 8), textcoords="offset points")
    (engine,) = (point for point in points if point.way == "engine")
    axes.plot([engine.seconds], [engine.error_um], "k*", markersize=14, label="strainwave, a row of a batch")
    axes.set(xscale="log", yscale="log", xlabel="time for one design, s", ylabel="greatest error of a backlash, µm")
    axes.axhline(0.1, color="0.6", linestyle=":", linewidth=1.0)
    axes.grid(visible=True, which="major", alpha=0.3)
    axes.legend(loc="center left")
    return figure
