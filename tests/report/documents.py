"""Reports for tests."""

from __future__ import annotations

from functools import cache
from html.parser import HTMLParser

from strainwave.analysis import Analysis, FaceMap, analyze, face_map
from strainwave.design import load
from strainwave.report import Chapter, Document, Provenance
from tests.designs import CASE_STUDY

# What would leave its place in HTML, in a script, in an attribute, in an address and in a formula.
HOSTILE = "</script><script>boom('&amp;')</script>\"' onload=boom() $\\frac{1}{$ {{ 7 * 7 }} <!-- ]]> é\u202e\x1b[31m"


@cache
def analysis(name: str | None = None) -> Analysis:
    """The calibrated cosine cam, under another name."""
    design = load(CASE_STUDY / "cosine-calibrated.toml")
    return analyze(design if name is None else design.replace("name", name))


@cache
def face() -> FaceMap:
    """Its sections."""
    return face_map(analysis(), sections=3)


def brief(name: str | None = None, *, chapters: int = 1) -> Document:
    """A report with one picture a chapter, quickly made."""
    chapter = Chapter.brief(analysis(name), face())
    provenance = Provenance("1.2.3", "strainwave report 'a b.toml' --out r.html")
    return Document(chapter.title, (), (chapter,) * chapters, provenance)


class Tags(HTMLParser):
    """Tags with their attributes, and all text outside scripts and styles."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self._open = ""
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        self._open = tag

    def handle_data(self, data: str) -> None:
        if self._open not in ("script", "style"):
            self.text += data

    def named(self, tag: str) -> list[dict[str, str | None]]:
        """The attributes of all tags of one name."""
        return [attributes for name, attributes in self.tags if name == tag]
