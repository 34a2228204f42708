"""The report of a design."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from strainwave.analysis import Analysis, analyze
from strainwave.design import Design
from strainwave.studies.progress import Progress
from strainwave.studio.file_name import file_name

ReportFormat = Literal["html", "pdf"]
MEDIA_TYPES: dict[ReportFormat, str] = {"html": "text/html; charset=utf-8", "pdf": "application/pdf"}


@dataclass(frozen=True)
class ReportOrder:
    """What ``strainwave report`` writes, but for the command in its provenance."""

    design: Design
    format: ReportFormat
    threshold_um: float
    title: str = ""
    date: str = ""
    unit: ClassVar[str] = "pictures"

    @property
    def file_name(self) -> str:
        """See `Order.file_name`."""
        return file_name(self.design.name, "report", ending=f".{self.format}")

    @property
    def media_type(self) -> str:
        """See `Order.media_type`."""
        return MEDIA_TYPES[self.format]

    def words(self, analysis: Analysis) -> str:
        """See `Order.words`."""
        return "verdict with its reasons, key figures, pictures, and the design itself"

    def content(self, progress: Progress) -> str | bytes:
        """See `Order.content`."""
        from strainwave.report import Chapter, Document, Provenance

        chapter = Chapter.of(analyze(self.design, threshold_um=self.threshold_um))
        document = Document.of([chapter], Provenance.of(date=self.date), title=self.title)
        return document.to_html(progress) if self.format == "html" else document.to_pdf(progress)
