"""The fixture itself: what a page does wrong is seen, and what it draws."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.browser.conftest import OpenPage

TRIANGLE = """
<canvas id=view width=200 height=200></canvas><script>
const gl = document.getElementById("view").getContext("webgl", {preserveDrawingBuffer: true});
gl.clearColor(0, 0.5, 1, 1); gl.clear(gl.COLOR_BUFFER_BIT);
</script>"""


def written(folder: Path, body: str) -> Path:
    file = folder / "page.html"
    file.write_text(f"<!doctype html><meta charset=utf-8><link rel=icon href='data:,'>{body}", encoding="utf-8")
    return file


def test_a_quiet_page_has_no_complaints(open_page: OpenPage, tmp_path: Path) -> None:
    page = open_page(written(tmp_path, "<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>"))
    assert page.complaints == []


@pytest.mark.parametrize(
    ("body", "complaint"),
    [
        ("<script>console.error('broken')</script>", "console: broken"),
        ("<script>undefined.x</script>", "exception: "),
        ("<img src='http://192.0.2.1/x.png'>", "request: http://192.0.2.1/x.png"),
    ],
)
def test_what_a_page_does_wrong_is_seen(open_page: OpenPage, tmp_path: Path, body: str, complaint: str) -> None:
    page = open_page(written(tmp_path, body))
    page.page.wait_for_timeout(100)
    assert any(each.startswith(complaint) for each in page.complaints), page.complaints


def test_webgl_draws(open_page: OpenPage, tmp_path: Path) -> None:
    pixels = open_page(written(tmp_path, TRIANGLE)).pixels("#view")
    assert np.abs(np.median(pixels, axis=(0, 1)) - (0, 128, 255)).max() <= 2


@pytest.mark.parametrize("dark", [False, True])
def test_a_page_is_told_the_readers_colours(open_page: OpenPage, tmp_path: Path, dark: bool) -> None:
    style = "<style>:root { color-scheme: light dark }</style>"
    assert bool(open_page(written(tmp_path, style), dark=dark).pixels().mean() < 128) is dark
