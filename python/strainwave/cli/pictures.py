"""Writing the picture that ``--plot`` asks for."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Plottable(Protocol):
    """A result that can be drawn."""

    def plot(self) -> Figure: ...


def check_picture(path: Path | None, *, overwrite: bool) -> None:
    """Refuse a picture that could not be written, before anything is computed for it."""
    if path is not None:
        from strainwave.plots.picture import picture_format
        from strainwave.whole_file import check_free

        picture_format(path)
        check_free(path, overwrite=overwrite)


def write_picture(result: Plottable, path: Path | None, *, overwrite: bool) -> None:
    """Draw the result in the format that the file's name asks for."""
    if path is not None:
        from strainwave.plots.picture import picture_bytes, picture_format
        from strainwave.whole_file import write_whole

        write_whole(path, picture_bytes(result.plot(), picture_format(path)), overwrite=overwrite)
