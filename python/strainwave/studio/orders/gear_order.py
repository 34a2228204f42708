"""The gear in one of the formats of other programs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from strainwave.analysis import Analysis
from strainwave.design import Design
from strainwave.export import ExportChoice, Format, gear_file
from strainwave.export.format import checked_chord_error
from strainwave.studies.progress import Progress
from strainwave.studio.file_name import file_name

MEDIA_TYPES: dict[Format, str] = {
    "dxf": "image/vnd.dxf",
    "svg": "image/svg+xml",
    "csv": "text/csv; charset=utf-8",
    "json": "application/json",
    "step": "model/step",
    "stl": "model/stl",
    "glb": "model/gltf-binary",
}


@dataclass(frozen=True)
class GearOrder:
    """What ``strainwave export`` writes."""

    design: Design
    format: Format
    choice: ExportChoice
    chord_error_mm: float | None = None
    unit: ClassVar[str] = ""

    @property
    def file_name(self) -> str:
        """See `Order.file_name`; names the part and the tooth too, so that several files stay apart."""
        words = self.choice.only if self.choice.tooth is None else (*self.choice.only, f"tooth-{self.choice.tooth}")
        return file_name(self.design.name, *words, ending=f".{self.format}")

    @property
    def media_type(self) -> str:
        """See `Order.media_type`."""
        return MEDIA_TYPES[self.format]

    def words(self, analysis: Analysis) -> str:
        """See `Order.words`."""
        self.choice.check(self.design)
        checked_chord_error(self.format, self.chord_error_mm, self.design)
        return str(self.choice)

    def content(self, progress: Progress) -> str | bytes:
        """See `Order.content`; how far it is, is not known."""
        return gear_file(self.design, self.format, self.choice, chord_error_mm=self.chord_error_mm)
