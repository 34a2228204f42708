"""The case study as computed by another program, which samples outlines at about 0.5 um.

It measures depth in two ways that agree with each other; its figures are good to 0.05 um. It read the article's table
as the design files in designs/case-study do.
"""

from __future__ import annotations

from typing import NamedTuple


class Least(NamedTuple):
    """Least backlash in um and the tooth (or index) where it is."""

    gap_um: float
    tooth: float


AS_PRINTED = {
    "cosine": Least(-5.71, 36),
    "four-roller": Least(-5.04, 37),
    "dual-disk-0848": Least(-21.77, 38),
    "dual-disk-0900": Least(-6.77, 2),
}
CALIBRATED = {
    "cosine": Least(1.49, 36),
    "four-roller": Least(2.16, 37),
    "dual-disk-0848": Least(-14.57, 38),
    "dual-disk-0900": Least(0.43, 2),
}
SHIFTED = {
    "cosine": Least(0.43, 36),
    "four-roller": Least(1.12, 36),
    "dual-disk-0848": Least(-15.31, 37),
    "dual-disk-0900": Least(-5.49, 2),
}
INEXTENSIBLE = {
    "cosine": Least(0.82, 1),
    "four-roller": Least(0.93, 0),
    "dual-disk-0848": Least(-9.15, 37),
    "dual-disk-0900": Least(-7.31, 2),
}
LEAST = {
    "as-printed": AS_PRINTED,
    "calibrated": CALIBRATED,
    "shifted": SHIFTED,
    "inextensible": INEXTENSIBLE,
}

# Calibrated, over continuous tooth index.
IN_MOTION = {
    "cosine": Least(1.49, 36),
    "four-roller": Least(2.00, 36.5),
    "dual-disk-0848": Least(-14.62, 38),
    "dual-disk-0900": Least(0.41, 2),
}
# Calibrated, teeth with 0 <= gap < 10 um on one side.
PER_SIDE = {"cosine": 39, "four-roller": 31, "dual-disk-0900": 6}
FIRST_INTERFERING = {("dual-disk-0848", "calibrated"): 33, ("dual-disk-0848", "shifted"): 31}
