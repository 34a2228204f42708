"""``strainwave report``: a document for the review of designs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import Force, Threshold

if TYPE_CHECKING:
    from strainwave.report import Chapter, Document

DEFAULT_THRESHOLD_UM = 10.0


def report(
    designs: Annotated[
        list[Path],
        typer.Argument(metavar="DESIGN", help="Design files (TOML), one or several.", show_default=False),
    ],
    out: Annotated[
        Path,
        typer.Option("--out", metavar="FILE", help="Write FILE.html or FILE.pdf.", show_default=False),
    ],
    title: Annotated[
        str, typer.Option("--title", metavar="TEXT", help="Title; left out, the designs' names.", show_default=False)
    ] = "",
    date: Annotated[
        str,
        typer.Option(
            "--date",
            metavar="TEXT",
            help="Date to print; left out, none, and the file is the same every time.",
            show_default=False,
        ),
    ] = "",
    threshold: Threshold = DEFAULT_THRESHOLD_UM,
    force: Force = False,
) -> None:
    """Write a report with verdict, figures and pictures: one page that works offline (.html), or paper (.pdf)."""
    from strainwave.cli.progress import watched
    from strainwave.report import Document, Provenance, write_report
    from strainwave.report.report_file import check_report

    check_report(out, overwrite=force)
    document = Document.of(
        [_chapter(design, threshold) for design in designs],
        Provenance.of(_arguments(designs, out, title, threshold), date),
        title=title,
    )
    with watched("drawing") as progress:
        write_report(document, out, overwrite=force, progress=progress)
    _say(document, out)


def _say(document: Document, out: Path) -> None:
    """What was written, and each design's verdict."""
    from rich.text import Text

    from strainwave.cli.console import say

    count = len(document.chapters)
    say(Text(f"{out}: report of {count} {'design' if count == 1 else 'designs'}"))
    say(*(Text(f"{chapter.title}: {chapter.verdict.sentence}") for chapter in document.chapters))


def _chapter(design: Path, threshold: float) -> Chapter:
    from strainwave.analysis import analyze
    from strainwave.cli.naming import naming
    from strainwave.design import load
    from strainwave.report import Chapter

    with naming(design):
        return Chapter.of(analyze(load(design), threshold_um=threshold))


def _arguments(designs: list[Path], out: Path, title: str, threshold: float) -> list[str]:
    """The command as it could be given again; what has its default is left out."""
    options = [("--title", title)] if title else []
    if threshold != DEFAULT_THRESHOLD_UM:
        options.append(("--threshold", f"{threshold:g}"))
    return ["report", *map(str, designs), "--out", str(out), *(word for option in options for word in option)]
