"""The design file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from strainwave.analysis import Analysis
from strainwave.design import Design, dumps
from strainwave.studies.progress import Progress
from strainwave.studio.file_name import file_name


@dataclass(frozen=True)
class DesignOrder:
    """The design as the command reads it."""

    design: Design
    media_type: ClassVar[str] = "application/toml"
    unit: ClassVar[str] = ""

    @property
    def file_name(self) -> str:
        """See `Order.file_name`."""
        return file_name(self.design.name, ending=".toml")

    def words(self, analysis: Analysis) -> str:
        """See `Order.words`."""
        return "the design"

    def content(self, progress: Progress) -> str:
        """See `Order.content`."""
        return dumps(self.design)
