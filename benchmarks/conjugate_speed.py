"""Measure how long a conjugate profile takes, and write it into docs/commands/conjugate.md.

Times differ from run to run and from machine to machine, so no test looks at them.
"""

from __future__ import annotations

from measurement import machine
from measurement.blocks import ROOT, fill
from measurement.interleaved import Work, seconds_a_design

from strainwave import Design, conjugate, load
from strainwave.conjugation.generation import Generation

DESIGN = "designs/case-study/cosine.toml"
PAGE = "docs/commands/conjugate.md"
ROUNDS = 30


def works(design: Design) -> dict[str, Work]:
    """Both directions, and the steps of one of them."""
    generation = Generation.of(design, "circular-spline")
    branches = generation.branches()
    flank = generation.flank(branches)
    return {
        "circular spline from the case study's flexspline, all of it": Work(lambda: conjugate(design)),
        "… branches of contact": Work(generation.branches),
        "… boundary and flank": Work(lambda: generation.flank(branches)),
        "… arcs and lines within 0.01 µm": Work(lambda: flank.fitted(1e-5)),
        "flexspline from the case study's circular spline": Work(lambda: conjugate(design, of="flexspline")),
    }


def block(design: Design) -> str:
    """The table of the page."""
    seconds = seconds_a_design(works(design), ROUNDS)
    rows = ["| | time |", "|---|--:|", *(f"| {name} | {found * 1e3:.1f} ms |" for name, found in seconds.items())]
    return "".join(f"{row}\n" for row in [*rows, "", f"Medians of {ROUNDS} runs on {machine.description()}."])


def main() -> None:
    """Measure, and write the page."""
    fill(PAGE, {"conjugate-speed": block(load(ROOT / DESIGN))})


if __name__ == "__main__":
    main()
