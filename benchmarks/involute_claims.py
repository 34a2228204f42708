"""What the article claims of involute teeth, in numbers: the tables of docs/involute.md.

Run, it tunes w0 anew and prints what it finds; the tables use the w0 kept here.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from strainwave import Analysis, Design, analyze, evaluate_batch, load, tune
from strainwave.analysis.counts import nearly_touching
from strainwave.analysis.evenness import evenness_um
from strainwave.cli.tables.number import fixed
from strainwave.units import MICROMETRES_PER_MM

DESIGNS = Path(__file__).parent.parent / "designs"
ARCS, INVOLUTE = "double circular arc", "involute"
PAIRS = {ARCS: "case-study/cosine-calibrated.toml", INVOLUTE: "involute/cosine.toml"}
GENERATORS: dict[str, dict[str, object]] = {
    "cosine": {"kind": "cosine"},
    "four-roller 19.5°": {"kind": "four-roller", "roller_angle": 19.5},
    "dual-disk 13°": {"kind": "dual-disk", "wrap_angle": 13.0},
    "two-roller": {"kind": "two-roller"},
}
THRESHOLD_UM = 10.0
MARGIN_UM = 1.49
"""Least backlash in motion of both pairs under the cosine cam, and of every tuned w0."""
STEP_UM = 0.5
# The w0 (mm) with the most teeth below 10 um and the margin in motion: `strainwave tune --goal power --margin 1.49`.
TUNED_W0_MM = {
    ARCS: (0.85, 0.84727, 0.874, 0.894),
    INVOLUTE: (0.587959, 0.579, 0.576175, 0.594),
}


@dataclass(frozen=True, eq=False)
class Row:
    """A pair under a generator at one w0."""

    pair: str
    generator: str
    analysis: Analysis

    @property
    def zone(self) -> str:
        """Teeth of one side with less than 10 um, as runs."""
        teeth = np.arange(self.analysis.design.flexspline.teeth // 4 + 1)
        close = teeth[nearly_touching(self.analysis.gap_curve.gap_um(teeth.astype(float)), THRESHOLD_UM)]
        runs = np.split(close, np.flatnonzero(np.diff(close) > 1) + 1)
        return ", ".join(f"{run[0]}…{run[-1]}" if len(run) > 1 else f"{run[0]}" for run in runs if len(run))

    @property
    def sensitivity(self) -> float:
        """Greatest change of the least backlash in motion with w0, um for um, to either side."""
        w0 = self.analysis.design.wave_generator.w0
        rows = w0 + np.array([[-1.0], [0.0], [1.0]]) * STEP_UM / MICROMETRES_PER_MM
        batch = evaluate_batch(self.analysis.design, ["wave_generator.w0"], rows, in_motion=True)
        return float(np.abs(np.diff(batch.min_in_motion_um)).max() / STEP_UM)


def design_of(pair: str, generator: str, w0_mm: float) -> Design:
    """A pair's splines under a wave generator, on the article's neutral curve."""
    common = {"w0": w0_mm, "neutral_curve": "first-order"}
    return load(DESIGNS / PAIRS[pair]).replace("wave_generator", GENERATORS[generator] | common)


@cache
def rows(setting: str) -> tuple[Row, ...]:
    """Every pair under every generator: "tuned" for it, or at the "common" w0, that of the cosine cam."""
    return tuple(
        Row(
            pair,
            generator,
            analyze(design_of(pair, generator, w0_of(pair, generator if setting == "tuned" else "cosine"))),
        )
        for generator in GENERATORS
        for pair in PAIRS
    )


def w0_of(pair: str, generator: str) -> float:
    """The tuned w0, mm."""
    return TUNED_W0_MM[pair][list(GENERATORS).index(generator)]


def tuned_table(_study: object) -> str:
    """Both pairs, each at the w0 tuned for the generator."""
    lines = [
        "| generator | pair | w0 mm | least in motion, µm @ index | teeth < 10 µm per side | these teeth "
        "| evenness, µm | play in motion, µm | d(least)/dw0 |",
        "|---|---|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for row in rows("tuned"):
        found = row.analysis
        cells = [
            row.generator,
            row.pair,
            fixed(found.design.wave_generator.w0, 4),
            f"{fixed(found.min_in_motion_um)} @ {fixed(found.min_in_motion_index, 1)}",
            str(found.teeth_below.per_side),
            row.zone,
            fixed(evenness_um(found.gap_curve, THRESHOLD_UM)),
            fixed(found.play_in_motion.circumferential_um),
            fixed(row.sensitivity),
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return "".join(f"{line}\n" for line in lines)


def common_table(_study: object) -> str:
    """Least backlash in motion of both pairs at one w0 under every generator, and its spread."""
    lines = [f"| pair | w0 mm | {' | '.join(GENERATORS)} | spread |", f"|---|--:|{'--:|' * (len(GENERATORS) + 1)}"]
    for pair in PAIRS:
        least = [row.analysis.min_in_motion_um for row in rows("common") if row.pair == pair]
        cells = [pair, fixed(w0_of(pair, "cosine"), 4), *map(fixed, least), fixed(max(least) - min(least))]
        lines.append(f"| {' | '.join(cells)} |")
    return "".join(f"{line}\n" for line in lines)


def main() -> None:
    """Tune every pair for every generator, and print the w0 to keep above, then the tables."""
    for pair, name in PAIRS.items():
        start = load(DESIGNS / name).wave_generator.w0
        found = [
            tune(design_of(pair, generator, start), margin_um=MARGIN_UM).design_for("power").wave_generator.w0
            for generator in GENERATORS
        ]
        print(f"{pair}: {', '.join(f'{w0:.6f}' for w0 in found)}")
    print(tuned_table(None), common_table(None), sep="\n")


if __name__ == "__main__":
    main()
