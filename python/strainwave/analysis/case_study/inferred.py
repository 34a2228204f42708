"""Numbers of the case study that the article does not print."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from strainwave.analysis.case_study.design_files import case_study_design
from strainwave.design import Design
from strainwave.design.keys import parts_of


@dataclass(frozen=True)
class InferredNumber:
    """A number of the design files that was inferred, and why it is needed."""

    name: str
    key: str
    """Dotted key of the design files."""
    value: float
    unit: str
    fitted: bool
    """Whether it was fitted to the published figures."""
    why: str


def inferred_numbers() -> tuple[InferredNumber, ...]:
    """All of them, with the values that the design files hold; the three fitted ones first."""
    printed, calibrated = case_study_design("cosine"), case_study_design("cosine-calibrated")
    four_roller, dual_disk = case_study_design("four-roller"), case_study_design("dual-disk-0848")
    return (
        _fitted(calibrated, "flexspline.profile.offset", "mm", "flank offset",
                "no clearance between the flanks is printed; calibrated reading only"),
        _fitted(four_roller, "wave_generator.roller_angle", "deg", "roller half angle",
                "the place of the rollers is not printed"),
        _fitted(dual_disk, "wave_generator.wrap_angle", "deg", "wrap half angle",
                "the radius of the disks is not printed"),
        InferredNumber("neutral radius", "flexspline.neutral_radius", printed.neutral_radius_mm, "mm", False,
                       "the printed 81.6 mm is the pitch radius; the middle of the wall is taken"),
        _read(printed, "circular_spline.profile.addendum", "modules", "circular spline's addendum",
              "the printed 0.9 is taken as the height at which its tip arc ends"),
        _read(printed, "flexspline.profile.tip_arc_center[1]", "modules", "flexspline's tip arc centre, y",
              "the one printed value, −0.366, fits the circular spline only"),
        _read(printed, "flexspline.profile.flank_length", "modules", "flexspline's straight flank",
              "not printed; any length from 0.2 to 0.85 gives the same backlash"),
    )  # fmt: skip


def _fitted(design: Design, key: str, unit: str, name: str, why: str) -> InferredNumber:
    return InferredNumber(name, key, _value(design, key), unit, True, why)


def _read(design: Design, key: str, unit: str, name: str, why: str) -> InferredNumber:
    return InferredNumber(name, key, _value(design, key), unit, False, why)


def _value(design: Design, key: str) -> float:
    found: Any = design.to_dict()
    for part in parts_of(key):
        found = found[part]
    return float(found)
