"""The figures that the article prints, and nothing else.

Source: "Simulation and Analysis of Backlash and Interference in Strain Wave Gears with Circular-Arc Tooth Profiles",
the table of wave generators and the text before it. Its tables count every gap below 10 um.
"""

from __future__ import annotations

from dataclasses import dataclass

SOURCE = "Simulation and Analysis of Backlash and Interference in Strain Wave Gears with Circular-Arc Tooth Profiles"
THRESHOLD_UM = 10.0


@dataclass(frozen=True)
class PublishedFigures:
    """What the article says about one wave generator; None where it says nothing."""

    min_backlash_um: float
    min_location: str
    interference: bool
    teeth_below_per_side: int | None = None
    """Teeth with less than 10 um of backlash on one side of the major axis."""
    first_interfering_tooth: int | None = None
    """"Beyond approximately" this index the article's teeth interfere."""


@dataclass(frozen=True)
class Case:
    """One row of the article's table; ``key`` also names the design files."""

    key: str
    wave_generator: str
    w0_mm: float
    published: PublishedFigures

    @property
    def title(self) -> str:
        """The case in words, for tables and pictures."""
        return f"{self.wave_generator}, w0 {self.w0_mm:.3f} mm"


CASES = (
    Case("cosine", "elliptical cam (cosine)", 0.848, PublishedFigures(1.97, "at an offset", False, 41)),
    Case("four-roller", "four rollers", 0.848, PublishedFigures(1.91, "at an offset", False, 30)),
    Case(
        "dual-disk-0848",
        "dual disk",
        0.848,
        PublishedFigures(-14.8, "beyond about ±31", True, first_interfering_tooth=31),
    ),
    Case("dual-disk-0900", "dual disk", 0.900, PublishedFigures(0.096, "near the major axis", False, 6)),
)
