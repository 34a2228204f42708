"""Measurements as tables of the documents."""

from __future__ import annotations

from collections.abc import Mapping

from measurement.accuracy import Point

NAMES = {
    "points": "every pair of 1000 × 1000 points a flank, as in the article (NumPy)",
    "shapely": "distance of 1000-point polylines (shapely)",
    "k-d tree": "k-d tree of 1000 points a flank (SciPy)",
    "loop": "`analyze` in a Python loop †",
    "w0, 1": "`evaluate_batch`, w0 varies, 1 thread",
    "w0, 2": "`evaluate_batch`, w0 varies, 2 threads",
    "profile, 1": "`evaluate_batch`, the profile varies, 1 thread",
    "profile, 2": "`evaluate_batch`, the profile varies, 2 threads",
    "w0 in motion, 1": "… with the certified minimum in motion, w0 varies, 1 thread",
    "w0 in motion, 2": "… with the certified minimum in motion, w0 varies, 2 threads",
    "profile in motion, 1": "… with the certified minimum in motion, the profile varies, 1 thread",
    "profile in motion, 2": "… with the certified minimum in motion, the profile varies, 2 threads",
    "one row": "`evaluate_batch` of a single row",
}
SHORT = ("points", "shapely", "k-d tree", "loop", "w0, 1", "profile, 1", "w0 in motion, 1", "w0, 2")
YARDSTICKS = ("w0, 1", "w0, 2")


def sides(seconds: Mapping[str, float], chosen: tuple[str, ...] = tuple(NAMES)) -> str:
    """Time for one design, a row for each side."""
    rows = [
        "| one design, all teeth, both flanks | time | times a row of a batch, 1 thread | 2 threads |",
        "|---|--:|--:|--:|",
    ]
    for name in chosen:
        ratios = " | ".join(_ratio(seconds[name] / seconds[yardstick]) for yardstick in YARDSTICKS)
        rows.append(f"| {NAMES[name]} | {shown(seconds[name])} | {ratios} |")
    return _text(rows)


def accuracy(points: list[Point]) -> str:
    """Error and time of every way, a row for each number of points."""
    rows = ["| way | points a flank | time for one design | greatest error |", "|---|--:|--:|--:|"]
    for point in points:
        count = "–" if point.points is None else f"{point.points}"
        rows.append(f"| {point.way} | {count} | {shown(point.seconds)} | {_micrometres(point.error_um)} |")
    return _text(rows)


def costs(seconds: Mapping[str, float], counted: str, counts: tuple[int, ...]) -> str:
    """Time for one design by a number of what is counted."""
    rows = [f"| {counted} | all teeth at angle 0 | with the minimum in motion |", "|--:|--:|--:|"]
    rows += [f"| {n} | {shown(seconds[f'at 0 {n}'])} | {shown(seconds[f'in motion {n}'])} |" for n in counts]
    return _text(rows)


def shown(seconds: float) -> str:
    """A time with three figures."""
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if seconds >= 0.9995 * size:  # which is 1 with three figures
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-6:.3g} µs"


def _ratio(ratio: float) -> str:
    return f"{ratio:,.0f}" if ratio >= 100.0 else f"{ratio:.2g}"


def _micrometres(error_um: float) -> str:
    return f"{error_um:.2g} µm" if error_um >= 1e-3 else f"{error_um:.0e} µm"


def _text(rows: list[str]) -> str:
    return "".join(f"{row}\n" for row in rows)
