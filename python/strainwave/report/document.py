"""A whole report: what comes before the designs, the designs, and where it comes from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from strainwave.errors import StrainwaveError
from strainwave.report.block import Block, Plate, Table
from strainwave.report.chapter import Chapter
from strainwave.report.overview import overview
from strainwave.report.provenance import Provenance
from strainwave.studies.progress import Progress, silent


@dataclass(frozen=True)
class Document:
    """A report, the same for a page and for paper."""

    title: str
    introduction: tuple[Block, ...]
    chapters: tuple[Chapter, ...]
    provenance: Provenance

    @classmethod
    def of(cls, chapters: Sequence[Chapter], provenance: Provenance | None = None, *, title: str = "") -> Self:
        """A report of one design, or of several with a table of all first. StrainwaveError where there is none."""
        if not chapters:
            raise StrainwaveError("a report needs at least one design")
        introduction = (overview(chapters),) if len(chapters) > 1 else ()
        names = ", ".join(chapter.title for chapter in chapters)
        return cls(title or names, introduction, tuple(chapters), provenance or Provenance.of())

    @property
    def origin(self) -> Table:
        """Where the report comes from, and the designs' hashes."""
        hashes = tuple((f"SHA-256 of {chapter.title}", chapter.design_hash) for chapter in self.chapters)
        return Table("Provenance", ("", ""), (*self.provenance.rows, *hashes), numeric=False)

    @property
    def plates(self) -> tuple[Plate, ...]:
        """All pictures, in their order."""
        blocks = (*self.introduction, *(block for chapter in self.chapters for block in chapter.blocks))
        return tuple(block for block in blocks if isinstance(block, Plate))

    def to_html(self, progress: Progress = silent) -> str:
        """One page that needs nothing else: pictures to zoom into and to turn, static ones in print.

        StrainwaveError where the extra ``report`` is missing. ``progress`` is told how many pictures are drawn.
        """
        from strainwave.report.html import html_of

        return html_of(self, progress)

    def to_pdf(self, progress: Progress = silent) -> bytes:
        """The same on A4, with the static pictures."""
        from strainwave.report.pdf import pdf_of

        return pdf_of(self, progress)
