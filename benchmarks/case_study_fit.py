"""Redo the three-number fit of the case study, and print its residuals.

The article prints neither a flank clearance, nor the rollers' place, nor the disks' radius. Three numbers are fitted by
least squares to nine published figures: the four least backlashes in um (the depth of 14.8 with half weight), the three
counts of teeth below 10 um per side, the first interfering tooth, and the tooth of the last case's least backlash
("very close to the major axis", taken as tooth 0), all teeth over two.

Counts are whole numbers, so the sum of squares has steps and no gradient: a grid is searched, then a finer one about
its best point. The clearance is common to all cases but an angle matters to its own wave generator only, so for each
clearance the two angles are sought apart. The valley is flat: the rounded numbers of the design files lie in it too.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from strainwave.analysis.case_study import CASES, Case, design_of, inferred_numbers
from strainwave.analysis.counts import nearly_touching
from strainwave.analysis.gap_curve import GapCurve
from strainwave.analysis.lobe import lobe_teeth
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.units import MICROMETRES_PER_MM

COSINE, FOUR_ROLLER, *DUAL_DISK = CASES
THRESHOLD_UM = 10.0
PER_TOOTH = 0.5


@dataclass(frozen=True)
class Residual:
    """One published figure, the computed one, and the weight of their difference in the fit."""

    case: str
    figure: str
    published: float
    computed: float
    weight: float

    @property
    def square(self) -> float:
        """What the figure adds to the sum of squares."""
        return (self.weight * (self.computed - self.published)) ** 2


@dataclass(frozen=True)
class Numbers:
    """The three numbers that the article does not print."""

    clearance_um: float
    roller_angle_deg: float
    wrap_angle_deg: float

    def residuals(self) -> list[Residual]:
        """All nine, case by case."""
        angles = {COSINE: None, FOUR_ROLLER: self.roller_angle_deg}
        return [
            residual
            for case in CASES
            for residual in residuals(case, self.clearance_um, angles.get(case, self.wrap_angle_deg))
        ]

    def sum_of_squares(self) -> float:
        """What the fit makes least."""
        return sum(residual.square for residual in self.residuals())

    def __str__(self) -> str:
        return (
            f"flank clearance {self.clearance_um:.2f} um, roller half angle {self.roller_angle_deg:.1f} deg, "
            f"wrap half angle {self.wrap_angle_deg:.1f} deg"
        )


def committed() -> Numbers:
    """The numbers in the design files."""
    offset_mm, roller_angle_deg, wrap_angle_deg = (number.value for number in inferred_numbers() if number.fitted)
    return Numbers(-offset_mm * MICROMETRES_PER_MM, roller_angle_deg, wrap_angle_deg)


def residuals(case: Case, clearance_um: float, angle_deg: float | None) -> list[Residual]:
    """Every published figure of one case beside the figure computed with these numbers."""
    design = _design(case, clearance_um, angle_deg)
    teeth = lobe_teeth(design.flexspline.teeth)
    side = teeth[teeth >= 0]
    gap_um = GapCurve(Geometry.of(design).engagement, design.flexspline.teeth).gap_um(side)
    published = case.published
    weight = 0.5 if published.interference else 1.0
    found = [Residual(case.title, "least backlash, um", published.min_backlash_um, float(gap_um.min()), weight)]
    counted = {
        "teeth < 10 um per side": (
            published.teeth_below_per_side,
            int(nearly_touching(gap_um, THRESHOLD_UM)[1:].sum()),
        ),
        "first interfering tooth": (published.first_interfering_tooth, int(np.argmax(gap_um < 0.0))),
        "tooth of the least backlash": (0 if case is DUAL_DISK[-1] else None, int(gap_um.argmin())),
    }
    for figure, (printed, computed) in counted.items():
        if printed is not None:
            found.append(Residual(case.title, figure, printed, computed, PER_TOOTH))
    return found


def fit(near: Numbers, reach: Numbers, step: Numbers) -> Numbers:
    """The best numbers on a grid about ``near``."""
    rollers = _grid(near.roller_angle_deg, reach.roller_angle_deg, step.roller_angle_deg)
    wraps = _grid(near.wrap_angle_deg, reach.wrap_angle_deg, step.wrap_angle_deg)
    best = [
        Numbers(
            clearance_um, _best_angle([FOUR_ROLLER], clearance_um, rollers), _best_angle(DUAL_DISK, clearance_um, wraps)
        )
        for clearance_um in _grid(near.clearance_um, reach.clearance_um, step.clearance_um)
    ]
    return min(best, key=Numbers.sum_of_squares)


def fitted() -> Numbers:
    """The best numbers, sought coarsely over everything plausible and then finely."""
    coarse = fit(Numbers(6.0, 20.0, 14.0), Numbers(6.0, 15.0, 10.0), Numbers(0.5, 1.0, 1.0))
    return fit(coarse, Numbers(1.0, 1.5, 1.5), Numbers(0.05, 0.1, 0.1))


def _best_angle(cases: list[Case], clearance_um: float, angles_deg: list[float]) -> float:
    def sum_of_squares(angle_deg: float) -> float:
        return sum(residual.square for case in cases for residual in residuals(case, clearance_um, angle_deg))

    return min(angles_deg, key=sum_of_squares)


def _design(case: Case, clearance_um: float, angle_deg: float | None) -> Design:
    changes = {"flexspline.profile.offset": -clearance_um / MICROMETRES_PER_MM}
    if angle_deg is not None:
        changes[f"wave_generator.{'roller_angle' if case is FOUR_ROLLER else 'wrap_angle'}"] = angle_deg
    return _printed(case).replace(changes)


@cache
def _printed(case: Case) -> Design:
    return design_of(case, "as-printed")


def _grid(near: float, reach: float, step: float) -> list[float]:
    places = round(reach / step)
    return [round(near + place * step, 6) for place in range(-places, places + 1)]


def report(title: str, numbers: Numbers) -> None:
    """Print the residuals of one set of numbers."""
    print(f"\n{title}: {numbers}")
    print(f"  {'case':<36} {'figure':<28} {'published':>9} {'computed':>9} {'residual':>9}")
    for row in numbers.residuals():
        difference = row.computed - row.published
        print(f"  {row.case:<36} {row.figure:<28} {row.published:>9.3g} {row.computed:>9.4g} {difference:>+9.2f}")
    print(f"  weighted sum of squares {numbers.sum_of_squares():.2f}")


if __name__ == "__main__":
    report("Least squares", fitted())
    report("In the design files", committed())
