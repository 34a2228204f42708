"""A page that needs nothing else, says what the verdict says, and shows a user's words as they are."""

from __future__ import annotations

import base64
import gzip
import re
from dataclasses import replace

import numpy as np
import pytest

from strainwave import dumps
from strainwave.analysis.verdict import Verdict
from strainwave.errors import StrainwaveError
from strainwave.report import Chapter, Document, Provenance
from strainwave.report.html import _single_precision
from strainwave.report.provenance import design_hash
from tests.designs import case
from tests.report.documents import HOSTILE, Tags, analysis, brief, face


@pytest.fixture(scope="module")
def page() -> str:
    return brief().to_html()


def test_the_same_document_gives_the_same_page(page: str) -> None:
    assert brief().to_html() == page


def test_a_date_is_printed_where_it_is_given_and_nowhere_else(page: str) -> None:
    dated = replace(brief(), provenance=Provenance("1.2.3", date="On a rainy day"))
    assert "On a rainy day" in Tags(dated.to_html()).text
    assert not re.search(r"20\d\d-\d\d-\d\d", Tags(page).text)


def test_nothing_is_fetched_from_anywhere(page: str) -> None:
    addresses = [
        value for _, attributes in Tags(page).tags for name, value in attributes.items() if name in ("src", "href")
    ]
    assert addresses
    assert all(address is not None and address.startswith(("data:", "#")) for address in addresses)
    styles = re.findall(r"<style>(.*?)</style>", page, re.DOTALL)
    assert not re.search(r"url\(|@import", "".join(styles))


def test_plotly_is_in_it_once() -> None:
    two = brief(chapters=2).to_html()
    packed = [tag for tag in Tags(two).named("script") if tag.get("id") == "plotly"]
    assert len(packed) == 1
    scripts = re.findall(r'<script type="application/gzip"[^>]*>([^<]*)</script>', two)
    unpacked = [gzip.decompress(base64.b64decode(each)).decode() for each in scripts]
    assert sum("plotly.js v" in each[:200] for each in unpacked) == 1
    assert sum(each.startswith('{"data"') for each in unpacked) == 2


def test_verdict_reasons_warnings_and_provenance_are_in_words(page: str) -> None:
    text = " ".join(Tags(page).text.split())
    verdict = Verdict.of(analysis(), face())
    for sentence in (verdict.sentence, *(reason.sentence for reason in verdict.reasons), *analysis().warnings):
        assert sentence in text
    assert "strainwave report 'a b.toml' --out r.html" in text
    assert "1.2.3" in text
    assert design_hash(analysis().design) in text


def test_the_design_file_can_be_taken_out_again() -> None:
    tags = Tags(brief().to_html())
    assert dumps(analysis().design) in tags.text


def test_hostile_names_are_words_and_nothing_more() -> None:
    plain, hostile = Tags(brief().to_html()), Tags(brief(HOSTILE).to_html())
    assert [tag for tag, _ in hostile.tags] == [tag for tag, _ in plain.tags]
    assert not any("onload" in attributes for _, attributes in hostile.tags)
    assert analysis(HOSTILE).design.title in hostile.text
    # Nothing that a template or a terminal would obey.
    assert "{{ 7 * 7 }}" in hostile.text
    assert "\x1b" not in hostile.text


def test_a_hostile_title_command_and_date_are_words_too() -> None:
    provenance = Provenance(HOSTILE, HOSTILE, HOSTILE)
    hostile = Tags(Document(HOSTILE, (), brief().chapters, provenance).to_html())
    assert len(hostile.tags) == len(Tags(brief().to_html()).tags) + 3  # the row of the date
    assert hostile.text.count("boom('&amp;')") >= 4


def test_the_hash_is_that_of_what_the_file_says() -> None:
    design = case()
    assert design_hash(design) == design_hash(type(design).from_dict(design.to_dict()))
    assert design_hash(design) != design_hash(design.replace("wave_generator.w0", 0.8480001))


def test_several_designs_are_set_side_by_side() -> None:
    document = Document.of([Chapter.of(analysis(), face()), Chapter.brief(analysis("Other"), face())])
    assert [table.title for table in document.introduction if hasattr(table, "rows")] == ["Overview"]
    assert document.title == "Case study, cosine cam, calibrated, Other"
    with pytest.raises(StrainwaveError, match="at least one design"):
        Document.of([])


def test_single_precision_keeps_values_gaps_and_whole_numbers() -> None:
    values = np.array([81.6, -1.25e-3, np.nan])
    packed = {"x": {"dtype": "f8", "bdata": base64.b64encode(values.tobytes()).decode(), "shape": "3"}, "n": [1, "f8"]}
    found = _single_precision(packed)
    kept = np.frombuffer(base64.b64decode(found["x"]["bdata"]), dtype=found["x"]["dtype"])
    np.testing.assert_allclose(kept, values, rtol=6e-8)
    assert found["x"]["shape"] == "3"
    assert found["n"] == [1, "f8"]
