"""The ways in which the article's table can be read, each a design for every case."""

from __future__ import annotations

from typing import Literal, get_args

from strainwave.analysis.case_study.design_files import case_study_design
from strainwave.analysis.case_study.published import Case
from strainwave.design import Design

Reading = Literal["as-printed", "calibrated", "shifted", "inextensible"]
"""``as-printed``: the table as it stands, on the article's first-order neutral curve. ``calibrated``: the same with an
inferred flank clearance. ``shifted`` and ``inextensible``: as printed, on that neutral curve."""

READINGS: tuple[Reading, ...] = get_args(Reading)


def design_of(case: Case, reading: Reading) -> Design:
    """The design of a case in one reading."""
    if reading == "calibrated":
        return case_study_design(f"{case.key}-calibrated")
    printed = case_study_design(case.key)
    return printed if reading == "as-printed" else printed.replace("wave_generator.neutral_curve", reading)
