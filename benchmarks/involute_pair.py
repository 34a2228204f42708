"""Find the involute pair that shares its load best: what docs/involute.md sets against the double circular arc.

Of pairs with the case study's module, teeth, wall and cosine cam, and with the least backlash in motion of its
calibrated design, the one with the most teeth below 10 um. Pressure angle, both addenda and w0 are searched on a grid
and then on a finer one about the best; the flank clearance is what gives the least backlash. Writes
designs/involute/cosine.toml.
"""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from strainwave import Design, analyze, dumps, evaluate_batch, load

ROOT = Path(__file__).parent.parent
CASE = ROOT / "designs" / "case-study" / "cosine-calibrated.toml"
OUT = ROOT / "designs" / "involute" / "cosine.toml"
TIP_CLEARANCE = 0.25  # modules between a tip and the other gear's root circle, as in common racks
OFFSET = "flexspline.profile.offset"
KEYS = [
    *(f"{spline}.profile.pressure_angle" for spline in ("flexspline", "circular_spline")),
    *(
        f"{spline}.profile.{height}"
        for height in ("addendum", "dedendum")
        for spline in ("flexspline", "circular_spline")
    ),
    "wave_generator.w0",
    OFFSET,
]
ROUNDS = 3
KEPT = 40

Floats = NDArray[np.float64]


def involute(**keys: float) -> dict[str, object]:
    """The table of an involute profile."""
    return {"kind": "involute", "pressure_angle": 20.0, "addendum": 0.5, "dedendum": 0.75, **keys}


def rows_of(angles: Floats, addenda: list[tuple[float, float]], w0: Floats) -> Floats:
    """Every pair of these, without flank clearance."""
    return np.array(
        [
            [angle, angle, flex, circular, circular + TIP_CLEARANCE, flex + TIP_CLEARANCE, displacement, 0.0]
            for angle, (flex, circular), displacement in product(angles, addenda, w0)
        ]
    )


def with_clearance(
    base: Design, rows: Floats, least_um: float, *, in_motion: bool
) -> tuple[Floats, NDArray[np.float64]]:
    """Rows whose offset leaves the least backlash asked for, and their teeth below 10 um; -1 where it could not be."""
    rows = rows.copy()
    for _ in range(ROUNDS):
        batch = evaluate_batch(base, KEYS, rows, in_motion=in_motion)
        least = batch.min_in_motion_um if in_motion else batch.min_backlash_um
        rows[:, -1] += np.nan_to_num(least - least_um) / 1e3
    batch = evaluate_batch(base, KEYS, rows, in_motion=in_motion)
    least = batch.min_in_motion_um if in_motion else batch.min_backlash_um
    reached = np.abs(least - least_um) < 0.05
    return rows, np.where(reached, batch.teeth_below_per_side, -1.0)


def main() -> None:
    """Search, print the best, write it."""
    case = load(CASE)
    least_um = analyze(case).min_in_motion_um
    base = case.replace({"flexspline.profile": involute(), "circular_spline.profile": involute()})
    heights = [0.3, 0.45, 0.6, 0.75, 0.9]
    angles = np.array([10.0, 14.5, 17.0, 20.0, 22.5, 25.0, 27.0, 28.6, 31.0, 34.0])
    coarse = rows_of(angles, list(product(heights, heights)), np.arange(0.5, 1.05, 0.02))
    rows, teeth = with_clearance(base, coarse, least_um, in_motion=False)
    print(f"{len(rows)} pairs; per pressure angle the most teeth below 10 um per side:")
    for angle in angles:
        print(f"  {angle:g} degrees: {teeth[rows[:, 0] == angle].max():.0f}")
    fine = []
    for row in rows[np.argsort(-teeth, kind="stable")[:KEPT]]:
        addenda = [(row[2] + a, row[3] + b) for a in (-0.05, 0.0, 0.05) for b in (-0.05, 0.0, 0.05)]
        fine.append(rows_of(row[0] + np.array([-0.5, 0.0, 0.5]), addenda, row[6] + np.arange(-0.012, 0.013, 0.004)))
    rows, teeth = with_clearance(base, np.unique(np.concatenate(fine).round(6), axis=0), least_um, in_motion=True)
    best = rows[int(teeth.argmax())]
    print(f"{len(rows)} pairs about the best: {teeth.max():.0f}")
    print(", ".join(f"{key} = {value:.6g}" for key, value in zip(KEYS, best, strict=True)))
    design = base.replace(dict(zip(KEYS, best.round(7).tolist(), strict=True)) | {"name": "Involute, cosine cam"})
    OUT.parent.mkdir(exist_ok=True)
    OUT.write_text(
        "# Found by benchmarks/involute_pair.py; docs/involute.md says how.\n" + dumps(design), encoding="utf-8"
    )
    print(analyze(design))


if __name__ == "__main__":
    main()
