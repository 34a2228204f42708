"""Several designs side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from strainwave.cli.tables.number import fixed, whole
from strainwave.report.block import Table
from strainwave.report.wording import LEVEL_WORDS

if TYPE_CHECKING:
    from strainwave.report.chapter import Chapter


def overview(chapters: Sequence[Chapter]) -> Table:
    """One row a design with what decides between them."""
    header = ("design", "verdict", "in motion, µm", "at index", "teeth below threshold", "play, ″")
    rows = tuple(
        (
            chapter.title,
            LEVEL_WORDS[chapter.verdict.level],
            fixed(chapter.analysis.min_in_motion_um),
            f"±{fixed(chapter.analysis.min_in_motion_index, 1)}",
            whole(chapter.analysis.teeth_below.drive),
            fixed(chapter.analysis.play_in_motion.angular_arcsec, 1),
        )
        for chapter in chapters
    )
    return Table("Overview", header, rows)
