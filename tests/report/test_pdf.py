"""The report on paper: the same every time, with all its pictures, and whatever a user's name holds."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from strainwave.report.block import Listing, Plate
from strainwave.report.pdf import LONGEST_LISTING
from tests.report.documents import HOSTILE, brief


@pytest.fixture(scope="module")
def paper() -> bytes:
    return brief().to_pdf()


def pages(paper: bytes) -> int:
    return len(re.findall(rb"/Type /Page\b", paper))


def test_the_same_document_gives_the_same_file(paper: bytes) -> None:
    assert brief().to_pdf() == paper
    assert paper.startswith(b"%PDF-")


def test_every_picture_is_in_it(paper: bytes) -> None:
    plates = sum(isinstance(block, Plate) for block in brief().chapters[0].blocks)
    assert len(re.findall(rb"/Subtype /Image\b", paper)) >= plates == 1
    twice = brief(chapters=2).to_pdf()
    assert pages(twice) > pages(paper)


def test_progress_counts_the_pictures() -> None:
    told: list[tuple[int, int]] = []
    brief(chapters=2).to_pdf(lambda done, total: told.append((done, total)))
    assert told == [(1, 2), (2, 2)]


def test_a_hostile_name_is_printed() -> None:
    assert pages(brief(HOSTILE).to_pdf()) >= 1


def test_an_endless_listing_is_cut() -> None:
    def with_lines(count: int) -> int:
        chapter = brief().chapters[0]
        blocks = (Listing("Design file", "x = 1\n" * count),)
        return pages(replace(brief(), chapters=(replace(chapter, blocks=blocks),)).to_pdf())

    assert with_lines(100 * LONGEST_LISTING) == with_lines(LONGEST_LISTING + 1) > with_lines(10)
