"""The gear as it turns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from strainwave.analysis import Analysis, analyze
from strainwave.animation import Film, animation_bytes, check_speed
from strainwave.design import Design
from strainwave.scene import Fixed
from strainwave.studies.progress import Progress
from strainwave.studio.file_name import file_name

FilmFormat = Literal["html", "gif", "mp4"]
MEDIA_TYPES: dict[FilmFormat, str] = {"html": "text/html; charset=utf-8", "gif": "image/gif", "mp4": "video/mp4"}


@dataclass(frozen=True)
class FilmOrder:
    """What ``strainwave animate`` writes."""

    design: Design
    format: FilmFormat
    frames: int
    turns: float
    fixed: Fixed
    frames_per_s: float
    threshold_um: float
    unit: ClassVar[str] = "frames"

    @property
    def file_name(self) -> str:
        """See `Order.file_name`."""
        return file_name(self.design.name, "turning", ending=f".{self.format}")

    @property
    def media_type(self) -> str:
        """See `Order.media_type`."""
        return MEDIA_TYPES[self.format]

    def words(self, analysis: Analysis) -> str:
        """See `Order.words`."""
        film = self._film(analysis)
        return f"{len(film)} frames; {film.words}"

    def content(self, progress: Progress) -> bytes:
        """See `Order.content`."""
        film = self._film(analyze(self.design, threshold_um=self.threshold_um))
        return animation_bytes(film, self.format, progress)

    def _film(self, analysis: Analysis) -> Film:
        film = Film.of(analysis, frames=self.frames, turns=self.turns, fixed=self.fixed, frames_per_s=self.frames_per_s)
        check_speed(film, self.format)
        return film
