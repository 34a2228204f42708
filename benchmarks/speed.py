"""Measure how fast the engine answers beside every other way, and write what came out into the documents.

In README.md and docs/speed.md a block between ``<!-- NAME:begin -->`` and ``<!-- NAME:end -->`` holds what is measured
here; docs/pictures/accuracy.png is drawn anew. Times differ from run to run and from machine to machine, so no test
looks at them.
"""

from __future__ import annotations

import sys

from measurement.blocks import ROOT, fill

sys.path.insert(0, str(ROOT))  # for the oracle of the tests

from measurement import cores, costs, machine, tables
from measurement.accuracy import error_against_time
from measurement.engine import batch, loop
from measurement.interleaved import Work, seconds_a_design
from measurement.picture import accuracy_figure
from measurement.sampled import WAYS, SampledTeeth

from strainwave import Design, load
from strainwave.plots import picture_bytes

DESIGN = "designs/case-study/cosine-calibrated.toml"
ROUNDS, ROUNDS_OF_CORES = 5, 30
ROWS = 10_000
ROWS_OF_COSTS = 500
POINTS = 1000


def sides(design: Design) -> dict[str, Work]:
    """All sides of the main table."""
    teeth = SampledTeeth(design, POINTS)
    works = {way: Work(lambda run=run: run(teeth)) for way, run in WAYS.items()}
    works["loop"] = loop(design, 20)
    for varied in ("w0", "profile"):
        for threads in (1, 2):
            works[f"{varied}, {threads}"] = batch(design, varied, ROWS, threads=threads)
            works[f"{varied} in motion, {threads}"] = batch(design, varied, ROWS, threads=threads, in_motion=True)
    works["one row"] = repeated(batch(design, "w0", 1, threads=0), 200)
    return works


def repeated(work: Work, times: int) -> Work:
    """The same many times over: one alone is too short to time."""

    def run() -> None:
        for _ in range(times):
            work.run()

    return Work(run, work.designs * times)


def blocks(design: Design) -> dict[str, str]:
    """What the documents hold, by the name of the block."""
    seconds = seconds_a_design(sides(design), ROUNDS)
    points = error_against_time(design, ROUNDS)
    picture = picture_bytes(accuracy_figure(points), "png", description="greatest error of a backlash against time")
    (ROOT / "docs" / "pictures" / "accuracy.png").write_bytes(picture)
    return {
        "speed": tables.sides(seconds, tables.SHORT),
        "speed-sides": tables.sides(seconds),
        "speed-accuracy": tables.accuracy(points),
        "speed-cores": cores.table(seconds_a_design(cores.by_cores(design, ROWS), ROUNDS_OF_CORES, min)),
        "speed-teeth": tables.costs(
            seconds_a_design(costs.by_teeth(design, ROWS_OF_COSTS), ROUNDS), "teeth of the flexspline", costs.TEETH
        ),
        "speed-pieces": tables.costs(
            seconds_a_design(costs.by_pieces(design, ROWS_OF_COSTS), ROUNDS), "pieces in each flank", costs.PIECES
        ),
        "speed-machine": f"{machine.description()}.\n",
    }


def main() -> None:
    """Measure, and write the documents."""
    found = blocks(load(ROOT / DESIGN))
    for document in ("README.md", "docs/speed.md"):
        fill(document, found)


if __name__ == "__main__":
    main()
