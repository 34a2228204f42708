"""Reports in files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from strainwave.errors import StrainwaveError
from strainwave.report.document import Document
from strainwave.studies.progress import Progress, silent

REPORT_FORMATS = ("html", "pdf")


def report_format(path: Path) -> str:
    """The format that the file's name asks for; ``StrainwaveError`` where it is none of html, pdf."""
    asked = path.suffix.lower().removeprefix(".")
    if asked not in REPORT_FORMATS:
        raise StrainwaveError(f"{path}: a report's name must end in .html or .pdf")
    return asked


def check_report(path: Path, *, overwrite: bool) -> None:
    """Refuse a report that could not be written, before anything is computed for it."""
    from strainwave.whole_file import check_free

    report_format(path)
    check_free(path, overwrite=overwrite)


def write_report(document: Document, path: str | Path, *, overwrite: bool = False, progress: Progress = silent) -> None:
    """Write a report as the file's name asks, whole or not at all; StrainwaveError if it cannot be."""
    from strainwave.whole_file import write_whole

    make: dict[str, Callable[[Progress], str | bytes]] = {"html": document.to_html, "pdf": document.to_pdf}
    write_whole(path, make[report_format(Path(path))](progress), overwrite=overwrite)
