"""A report on A4."""

from __future__ import annotations

import io
import itertools
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainwave.errors import StrainwaveError
from strainwave.plots.picture import picture_bytes
from strainwave.plots.style import GREEN, GREY, INK, ORANGE, PALE, VERMILION
from strainwave.report.block import Block, Listing, Notes, Plate, Table
from strainwave.report.wording import LEVEL_WORDS
from strainwave.studies.progress import Progress, silent

if TYPE_CHECKING:
    from fpdf import FPDF

    from strainwave.analysis.verdict import Level, Verdict
    from strainwave.report.chapter import Chapter
    from strainwave.report.document import Document

FONT, MONO = "DejaVu", "DejaVuMono"
# Points and mm.
TITLE, HEADING, SUBHEADING, TEXT, SMALL = 17.0, 13.0, 10.5, 9.0, 7.5
MARGIN = 16.0
LINE = 1.35 * 0.3528  # mm of line for a point of type
HIGHEST_PICTURE = 205.0
LEVEL_COLOURS: dict[Level, str] = {
    "interference": VERMILION,
    "along-face": ORANGE,
    "undecided": ORANGE,
    "clear": GREEN,
}
LONGEST_LISTING = 400
"""Lines; a tooth of a thousand pieces would fill twenty pages."""


def pdf_of(document: Document, progress: Progress = silent) -> bytes:
    """The report, the same bytes for the same document."""
    paper = _paper(document)
    paper.add_page()
    _text(paper, document.title, TITLE, bold=True)
    paper.ln(2.0)
    drawn = itertools.count(1)

    def add(block: Block) -> None:
        _block(paper, block)
        if isinstance(block, Plate):
            progress(next(drawn), len(document.plates))

    for block in document.introduction:
        add(block)
    for number, chapter in enumerate(document.chapters):
        if number or document.introduction:
            paper.add_page()
        _open_chapter(paper, chapter, titled=len(document.chapters) > 1)
        for block in chapter.blocks:
            add(block)
    add(document.origin)
    return bytes(paper.output())


def _paper(document: Document) -> FPDF:
    """Empty paper with the page number below, the fonts in it, and no date in the file."""
    try:
        import fpdf
    except ImportError as error:
        raise StrainwaveError(f"reports in PDF need fpdf2 ({error}): pip install 'strainwave[report]'") from None
    import matplotlib

    class Paper(fpdf.FPDF):
        def footer(self) -> None:
            self.set_y(-MARGIN + 4.0)
            self.set_font(FONT, "", SMALL)
            self.set_text_color(GREY)
            origin = f"strainwave {document.provenance.version}"
            self.cell(0, 4.0, origin)
            self.set_x(MARGIN)
            self.cell(0, 4.0, f"{self.page_no()} / {{nb}}", align="R")

    paper = Paper(format="A4")
    paper.set_margins(MARGIN, MARGIN, MARGIN)
    paper.set_auto_page_break(True, margin=MARGIN + 3.0)
    fonts = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
    for family, style, name in ((FONT, "", "DejaVuSans"), (FONT, "B", "DejaVuSans-Bold"), (MONO, "", "DejaVuSansMono")):
        paper.add_font(family, style, fonts / f"{name}.ttf")
    paper.set_title(document.title)
    paper.set_creator(f"strainwave {document.provenance.version}")
    # A file must have a date; the time at which it was written would make each another file.
    paper.set_creation_date(datetime(1970, 1, 1, tzinfo=UTC))
    return paper


def _text(paper: FPDF, text: str, size: float, *, bold: bool = False, colour: str = INK, font: str = FONT) -> None:
    paper.set_font(font, "B" if bold else "", size)
    paper.set_text_color(colour)
    paper.multi_cell(0, size * LINE, text, align="L", new_x="LMARGIN", new_y="NEXT")


def _heading(paper: FPDF, text: str, room: float) -> None:
    """A heading that is not left alone at the foot of a page: ``room`` mm must fit below it."""
    if paper.will_page_break(room + 8.0):
        paper.add_page()
    else:
        paper.ln(4.0)
    _text(paper, text, SUBHEADING, bold=True)
    paper.ln(1.0)


def _open_chapter(paper: FPDF, chapter: Chapter, *, titled: bool) -> None:
    if titled:
        _text(paper, chapter.title, HEADING, bold=True)
        paper.ln(1.0)
    _text(paper, chapter.summary, TEXT, colour=GREY)
    paper.ln(3.0)
    _verdict(paper, chapter.verdict)


def _verdict(paper: FPDF, verdict: Verdict) -> None:
    """The call in words, with a bar in its colour beside it."""
    top, page, colour = paper.get_y(), paper.page_no(), LEVEL_COLOURS[verdict.level]
    paper.set_left_margin(MARGIN + 5.0)
    paper.set_x(MARGIN + 5.0)
    _text(paper, LEVEL_WORDS[verdict.level], HEADING, bold=True)
    _text(paper, verdict.sentence, TEXT + 1.0)
    paper.ln(1.5)
    for reason in verdict.reasons:
        _text(paper, f"{'▲' if reason.adverse else '·'}  {reason.sentence}", TEXT)
    paper.set_left_margin(MARGIN)
    paper.set_x(MARGIN)
    if paper.page_no() == page:
        with paper.local_context(fill_color=colour):
            paper.rect(MARGIN, top, 1.6, paper.get_y() - top, style="F")


def _block(paper: FPDF, block: Block) -> None:
    match block:
        case Table():
            _table(paper, block)
        case Notes():
            _heading(paper, block.title, 12.0)
            for sentence in block.sentences:
                _text(paper, f"·  {sentence}", TEXT)
        case Listing():
            _listing(paper, block)
        case Plate():
            _plate(paper, block)


def _table(paper: FPDF, table: Table) -> None:
    from fpdf.enums import TableBordersLayout
    from fpdf.fonts import FontFace

    _heading(paper, table.title, min(60.0, 6.0 * len(table.rows)))
    paper.set_font(FONT, "", SMALL + 0.5)
    paper.set_text_color(INK)
    paper.set_draw_color(PALE)
    rows = [table.header, *table.rows] if any(table.header) else list(table.rows)
    widths = _widths(paper, rows)
    figures = "RIGHT" if table.numeric else "LEFT"
    look: dict[str, Any] = {
        "col_widths": widths,
        "width": sum(widths),
        "align": "LEFT",
        "text_align": ("LEFT", *(figures for _ in widths[1:])),
        "first_row_as_headings": any(table.header),
        "headings_style": FontFace(color=GREY),
        "borders_layout": TableBordersLayout.HORIZONTAL_LINES,
        "line_height": (SMALL + 1.0) * LINE,
        "padding": 0.6,
    }
    with paper.table(**look) as lines:
        for row in rows:
            lines.row(row)
    if table.note:
        paper.ln(1.0)
        _text(paper, table.note, SMALL, colour=GREY)


def _widths(paper: FPDF, rows: list[tuple[str, ...]]) -> list[float]:
    """As wide as what stands in the columns; what is too much is taken from the widest."""
    room = paper.epw
    widths = [max(paper.get_string_width(cell) for cell in column) + 5.0 for column in zip(*rows, strict=True)]
    excess, widest = sum(widths) - room, max(widths)
    if excess > 0.0:
        widths[widths.index(widest)] = max(widest - excess, 0.25 * room)
    return [width * min(1.0, room / sum(widths)) for width in widths]


def _listing(paper: FPDF, listing: Listing) -> None:
    _heading(paper, listing.title, 30.0)
    lines = listing.text.splitlines()
    left_out = len(lines) - LONGEST_LISTING
    shown = lines if left_out <= 0 else [*lines[:LONGEST_LISTING], f"… and {left_out} lines more"]
    _text(paper, "\n".join(shown), SMALL, font=MONO)


def _plate(paper: FPDF, plate: Plate) -> None:
    """A picture across the page, or as wide as its height allows."""
    figure = plate.draw()
    across, up = figure.get_size_inches()
    width = min(paper.epw, HIGHEST_PICTURE * across / up)
    height = width * up / across
    _heading(paper, plate.title, height + 10.0)
    from fpdf.enums import Align

    paper.image(io.BytesIO(picture_bytes(figure, "png")), x=Align.C, w=width, alt_text=plate.title)
    _text(paper, plate.caption, SMALL, colour=GREY)
