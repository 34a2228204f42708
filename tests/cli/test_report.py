"""``strainwave report``: one file for one design or several, refused before anything is computed for it."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.design import load, save
from strainwave.report import Document
from tests.cli.command import run
from tests.designs import CASE_STUDY

DESIGN = CASE_STUDY / "cosine-calibrated.toml"


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> list[Document]:
    """The documents that are to be written, and a page that takes no time."""
    made: list[Document] = []

    def to_html(document: Document, progress: object) -> str:
        made.append(document)
        return "page"

    monkeypatch.setattr(Document, "to_html", to_html)
    return made


def test_a_report_is_written_and_its_verdict_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], quick: list[Document]
) -> None:
    out = tmp_path / "r.html"
    outcome = run(capsys, "report", DESIGN, "--out", out, "--date", "1 May", "--threshold", "8")
    assert outcome.code == 0, outcome.err
    assert out.read_text() == "page"
    assert "report of 1 design\n" in outcome.out
    assert "At mid-face teeth do not interfere" in outcome.out
    (document,) = quick
    assert document.provenance.date == "1 May"
    assert document.provenance.command == f"strainwave report {DESIGN} --out {out} --threshold 8"
    assert document.title == "Case study, cosine cam, calibrated"


def test_several_designs_and_a_title(tmp_path: Path, capsys: pytest.CaptureFixture[str], quick: list[Document]) -> None:
    other = CASE_STUDY / "dual-disk-0848.toml"
    outcome = run(capsys, "report", DESIGN, other, "--out", tmp_path / "r.html", "--title", "Two; of them")
    assert outcome.code == 0, outcome.err
    (document,) = quick
    assert document.title == "Two; of them"
    assert [chapter.verdict.level for chapter in document.chapters] == ["along-face", "interference"]
    assert document.provenance.command.endswith("--title 'Two; of them'")


def test_the_case_study_has_a_report_with_both_readings(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], quick: list[Document]
) -> None:
    out = tmp_path / "r.html"
    outcome = run(capsys, "case-study", "--report", out)
    assert outcome.code == 0, outcome.err
    (document,) = quick
    titles = [chapter.title for chapter in document.chapters]
    assert len(titles) == 8
    assert sum(title.endswith(", as printed") for title in titles) == 4
    assert sum(title.endswith(", calibrated") for title in titles) == 4
    table = next(block for block in document.introduction if block.title == "Published and computed")
    cells = [cell for row in getattr(table, "rows", ()) for cell in row]
    # Published, and computed as `strainwave case-study` says.
    assert {"1.97", "1.91", "−14.8", "0.096", "1.49 (−0.48)", "−14.57 (+0.23)"} <= set(cells)
    # The chapters hold the readings that their titles name: the least gap in motion as docs/case-study.md has it.
    least = {chapter.title: round(chapter.analysis.min_in_motion_um, 2) for chapter in document.chapters}
    assert least["elliptical cam (cosine), w0 0.848 mm, as printed"] == -5.71
    assert least["elliptical cam (cosine), w0 0.848 mm, calibrated"] == 1.49


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["report", DESIGN, "--out", "r.txt"], "a report's name must end in .html or .pdf"),
        (["case-study", "--report", "r.png"], "a report's name must end in .html or .pdf"),
        (["report", DESIGN, "--out", "nowhere/r.html"], "there is no directory nowhere"),
        (["report", "missing.toml", "--out", "r.html"], "missing.toml"),
        (["report", "--out", "r.html"], "Missing argument"),
    ],
)
def test_what_cannot_be_is_said_in_one_line(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    arguments: list[object],
    message: str,
) -> None:
    """Before anything is computed: that would be the end of this test."""
    monkeypatch.chdir(tmp_path)
    for work in ("strainwave.analysis.analyze", "strainwave.analysis.case_study.CaseStudy.compute"):
        monkeypatch.setattr(work, lambda *_, **__: pytest.fail("something was computed"))
    outcome = run(capsys, *arguments)
    assert outcome.code == 2
    assert message in outcome.err
    assert outcome.err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_is_there_is_kept(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], quick: list[Document]
) -> None:
    out = tmp_path / "r.html"
    out.write_text("mine")
    assert run(capsys, "report", DESIGN, "--out", out).code == 2
    assert out.read_text() == "mine"
    assert quick == []
    assert run(capsys, "report", DESIGN, "--out", out, "--force").code == 0
    assert out.read_text() == "page"


def test_a_cup_that_cannot_be_bent_names_the_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "long.toml"
    cup = {"flexspline.face_width": 60.0, "flexspline.cup_length": 66.0, "wave_generator.w0": 10.0}
    save(load(DESIGN).replace(cup), file)
    outcome = run(capsys, "report", DESIGN, file, "--out", tmp_path / "r.html")
    assert outcome.code == 2
    assert str(file) in outcome.err
    assert "60 mm from the diaphragm" in outcome.err


@pytest.mark.parametrize("missing", ["jinja2", "plotly"])
def test_a_missing_library_is_named_with_the_extra(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str], missing: str
) -> None:
    import sys

    from strainwave.report import html

    html._environment.cache_clear()
    for name in [each for each in sys.modules if each.split(".")[0] == missing]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, missing, None)
    outcome = run(capsys, "report", DESIGN, "--out", tmp_path / "r.html")
    assert outcome.code == 2
    assert "pip install 'strainwave[" in outcome.err


def test_help_lists_the_formats(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "report", "--help")
    assert outcome.code == 0
    assert "FILE.html or FILE.pdf" in " ".join(outcome.out.split())
