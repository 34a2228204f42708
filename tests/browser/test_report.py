"""A whole report in a browser: quiet, drawn to the last picture, turnable, and on paper without a script's help."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.design import load
from strainwave.report import Chapter, Document, Provenance, write_report
from tests.browser.conftest import OpenPage
from tests.browser.local_page import LocalPage, Pixels
from tests.designs import CASE_STUDY
from tests.report.documents import HOSTILE

# The gear fills a good part of the view, in as many shades as its faces have directions.
LEAST_SHARE_DRAWN = 0.05
LEAST_SHADES = 100


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of a design whose name is a script that would be heard."""
    file = tmp_path_factory.mktemp("report") / "report.html"
    design = load(CASE_STUDY / "cosine-calibrated.toml").replace("name", f"<script>throw 1</script>{HOSTILE}"[:200])
    write_report(Document.of([Chapter.of(analyze(design))], Provenance("1.2.3")), file)
    return file


def drawn(page: LocalPage) -> int:
    """Bring every picture to the window, wait until it is drawn, and count them."""
    count = int(page.run("document.querySelectorAll('figure.interactive').length"))
    for number in range(count):
        figure = f"document.querySelectorAll('figure.interactive')[{number}]"
        page.run(f"{figure}.scrollIntoView()")
        page.wait_for(f"{figure}.classList.contains('drawn')")
    return count


def shows_a_body(pixels: Pixels) -> bool:
    """Whether the middle of a view holds a shaded body in colour before a background of one colour."""
    height, width, _ = pixels.shape
    middle = pixels[height // 5 : -height // 5, width // 5 : -width // 5].reshape(-1, 3).astype(int)
    coloured = np.ptp(middle, axis=1) > 24
    return bool(coloured.mean() > LEAST_SHARE_DRAWN and len(np.unique(middle[coloured], axis=0)) > LEAST_SHADES)


def test_the_report_is_quiet_and_every_picture_is_drawn(open_page: OpenPage, report: Path) -> None:
    page = open_page(report)
    assert drawn(page) >= 8
    assert page.complaints == []
    # What plotly draws is in the frames, not the static pictures, which stand there for paper.
    assert page.run("[...document.querySelectorAll('.interactive .live')].every((each) => each.querySelector('svg'))")
    assert not page.run("[...document.querySelectorAll('.interactive .static')].some((each) => each.checkVisibility())")


def test_the_gear_is_drawn_in_space_and_turns(open_page: OpenPage, report: Path) -> None:
    page = open_page(report, width=640, height=640)
    page.run("document.querySelector('.turnable').scrollIntoView()")
    page.wait_for("document.querySelector('.turnable').classList.contains('drawn')")
    view = ".turnable .live"
    page.page.wait_for_timeout(500)
    before = page.pixels(view)
    assert shows_a_body(before)
    box = page.page.locator(view).bounding_box()
    assert box is not None
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
    page.page.mouse.move(x, y)
    page.page.mouse.down()
    page.page.mouse.move(x + 120.0, y + 40.0, steps=5)
    page.page.mouse.up()
    page.page.wait_for_timeout(500)
    after = page.pixels(view)
    assert shows_a_body(after)
    assert (np.abs(after.astype(int) - before).max(axis=-1) > 16).mean() > LEAST_SHARE_DRAWN
    assert page.complaints == []


def test_an_empty_view_would_be_seen(open_page: OpenPage, report: Path) -> None:
    """The same look at the same page without the bodies, and without WebGL's canvas."""
    page = open_page(report, width=640, height=640)
    page.run("document.querySelector('.turnable').scrollIntoView()")
    page.wait_for("document.querySelector('.turnable').classList.contains('drawn')")
    page.run("Plotly.restyle(document.querySelector('.turnable .live'), {visible: false})")
    page.page.wait_for_timeout(500)
    assert not shows_a_body(page.pixels(".turnable .live"))
    page.run("Plotly.restyle(document.querySelector('.turnable .live'), {visible: true})")
    page.run("document.querySelectorAll('.turnable canvas').forEach((each) => each.remove())")
    page.page.wait_for_timeout(500)
    assert not shows_a_body(page.pixels(".turnable .live"))


def test_a_wheel_over_a_picture_moves_the_page(open_page: OpenPage, report: Path) -> None:
    page = open_page(report)
    page.run("document.querySelector('.interactive').scrollIntoView()")
    page.wait_for("document.querySelector('.interactive').classList.contains('drawn')")
    before = page.run("window.scrollY")
    page.page.mouse.move(550.0, 300.0)
    page.page.mouse.wheel(0.0, 200.0)
    page.wait_for(f"window.scrollY > {before} + 100")


def test_without_webgl_the_static_gear_stays(open_page: OpenPage, report: Path, tmp_path: Path) -> None:
    """The page of a browser that has none."""
    without = """<script>
    const own = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith("webgl") ? null : own.call(this, kind, ...rest);
    };
    </script></head>"""
    file = tmp_path / "without.html"
    file.write_text(report.read_text(encoding="utf-8").replace("</head>", without, 1), encoding="utf-8")
    page = open_page(file)
    page.run("document.querySelector('.turnable').scrollIntoView()")
    page.wait_for("!document.querySelector('.turnable').classList.contains('interactive')")
    assert page.page.locator(".turnable .static").is_visible()
    assert page.complaints == []


@pytest.mark.parametrize("dark", [False, True])
def test_light_and_dark(open_page: OpenPage, report: Path, dark: bool) -> None:
    """Most of a page is its paper; what is written on it stands out."""
    pixels = open_page(report, dark=dark).pixels().astype(float).mean(axis=-1)
    paper = np.median(pixels)
    assert bool(paper < 60.0) is dark
    assert np.abs(pixels - paper).max() > 150.0


def test_paper_has_the_static_pictures_and_all_that_is_folded_away(open_page: OpenPage, report: Path) -> None:
    page = open_page(report)
    page.page.emulate_media(media="print")
    assert page.run("[...document.querySelectorAll('.static')].every((each) => each.checkVisibility())")
    assert not page.run("[...document.querySelectorAll('.live')].some((each) => each.checkVisibility())")
    page.run("window.dispatchEvent(new Event('beforeprint'))")
    assert page.run("[...document.querySelectorAll('details')].every((each) => each.open)")
    # On paper it is light, also for a reader in the dark.
    page.page.emulate_media(media="print", color_scheme="dark")
    assert page.run("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert page.pdf().startswith(b"%PDF-")


def test_without_scripts_the_static_pictures_are_shown(chromium: object, report: Path) -> None:
    from playwright.sync_api import Browser

    assert isinstance(chromium, Browser)
    context = chromium.new_context(java_script_enabled=False)
    page = LocalPage.opened(context, report)
    assert page.page.locator(".interactive .static").first.is_visible()
    assert not page.page.locator(".interactive .live").first.is_visible()
    assert page.complaints == []
    context.close()
