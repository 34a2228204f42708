"""The gear in space, exports and reports of the studio in a browser."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import ezdxf
import numpy as np
import pytest
from ezdxf.entities.lwpolyline import LWPolyline

from strainwave.export import gear_file
from strainwave.studio.link import design_code
from tests.browser.conftest import OpenStudio
from tests.browser.hues import CLOSE, INTERFERENCE, RING, share
from tests.browser.local_page import LONGEST_WAIT_MS, Pixels
from tests.browser.studio_page import StudioPage
from tests.designs import case
from tests.export.gears import small_gear

if TYPE_CHECKING:
    from playwright.sync_api import FrameLocator

START = case("cosine-calibrated")
HOSTILE = """../<script>boom = 1</script><img src=x onerror="boom = 2">'"`{{ boom }}"""
SIZES = [(1280, 720), (1024, 768)]


def opened(studio: StudioPage, tab: str) -> None:
    studio.page.set_default_timeout(LONGEST_WAIT_MS)  # jobs step behind all else
    studio.page.get_by_role("tab", name=tab, exact=True).click()


def outlines(dxf: str) -> list[Any]:
    """What is drawn, without the file's own times and ids."""
    document = ezdxf.read(io.StringIO(dxf))  # type: ignore[attr-defined]
    return [
        ("LWPOLYLINE", shape.dxf.layer, shape.is_closed, np.array(shape.get_points("xyb")).tolist())
        if isinstance(shape, LWPolyline)
        else (shape.dxftype(), shape.dxf.layer, shape.dxf.radius, tuple(shape.dxf.center))
        for shape in document.modelspace()
    ]


def test_a_dxf_drawing_is_what_the_command_writes_and_closed(open_studio: OpenStudio) -> None:
    studio = open_studio()
    opened(studio, "Export")
    name, content = studio.downloaded(studio.page.get_by_role("button", name="Export DXF drawing").click)
    assert name == "Case-study-cosine-cam-calibrated.dxf"
    drawn = outlines(content.decode())
    assert {layer for _, layer, *_ in drawn} == {"FLEXSPLINE", "CIRCULAR_SPLINE", "WAVE_GENERATOR"}
    assert all(is_closed for kind, _, is_closed, _ in drawn if kind == "LWPOLYLINE")
    command = gear_file(START, "dxf")
    assert isinstance(command, str)
    assert drawn == outlines(command)
    again = studio.downloaded(studio.page.get_by_role("link", name=name).click)
    assert again == (name, content)


def test_nothing_that_is_typed_gets_anywhere(open_studio: OpenStudio) -> None:
    """A hostile name, in the page, the file's name and the report."""
    studio = open_studio(f"?design={design_code(small_gear().replace('name', HOSTILE))}", webgl=True)
    opened(studio, "Export")
    studio.choose("Kind of file", "TOML design file")
    name, content = studio.downloaded(studio.page.get_by_role("button", name="Export TOML design file").click)
    assert name == "script-boom-1-script-img-src-x-onerror-boom-2-boom.toml"
    assert b"<script>" in content
    opened(studio, "3D")
    studio.wait_for("document.querySelector('.space-picture[data-drawn]') !== null")
    assert studio.run("typeof boom") == "undefined"


def drawn_gear(studio: StudioPage) -> None:
    studio.wait_for("document.querySelector('.space-picture[data-drawn]') !== null")
    studio.page.wait_for_timeout(1500)  # SwiftShader draws some frames later


def seen(studio: StudioPage) -> Pixels:
    """The gear, without the scale of colours on its right."""
    pixels = studio.pixels(".space-picture")
    return pixels[:, : int(0.75 * pixels.shape[1])]


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_gear_is_seen_turned_and_taken_apart(open_studio: OpenStudio, width: int, height: int) -> None:
    studio = open_studio(width=width, height=height, dark=width == SIZES[1][0], webgl=True)
    opened(studio, "3D")
    drawn_gear(studio)
    studio.page.get_by_text("At mid-face teeth do not interfere").wait_for()
    before = seen(studio)
    assert share(before, RING) > 0.05
    assert share(before, INTERFERENCE) > 0.001
    box = studio.page.locator(".space-picture").bounding_box()
    assert box is not None
    x, y = box["x"] + 0.4 * box["width"], box["y"] + 0.5 * box["height"]
    studio.page.mouse.move(x, y)
    studio.page.mouse.down()
    studio.page.mouse.move(x + 90, y - 30, steps=2)
    studio.page.mouse.up()
    studio.page.wait_for_timeout(1000)
    turned = seen(studio)
    assert (np.abs(turned.astype(int) - before).max(axis=-1) > 40).mean() > 0.05
    studio.page.get_by_label("circular spline, a quarter cut away").uncheck()
    studio.page.get_by_label("wave generator", exact=True).uncheck()
    studio.page.wait_for_timeout(1000)
    apart = seen(studio)
    assert share(apart, RING) < 0.3 * share(turned, RING)
    assert share(apart, CLOSE) > 0


def test_hidden_bodies_and_the_eye_stay_while_the_detail_changes(open_studio: OpenStudio) -> None:
    studio = open_studio(webgl=True)
    opened(studio, "3D")
    drawn_gear(studio)
    with_ring = share(seen(studio), RING)
    studio.page.get_by_label("circular spline, a quarter cut away").uncheck()
    first = studio.run("document.querySelector('.space-picture').dataset.drawn")
    studio.page.get_by_role("button", name="Coarse").click()
    studio.wait_for(f"document.querySelector('.space-picture').dataset.drawn !== '{first}'")
    studio.page.wait_for_timeout(1500)
    assert share(seen(studio), RING) < 0.3 * with_ring
    assert not studio.page.get_by_label("circular spline, a quarter cut away").is_checked()


def test_a_picture_that_was_lost_is_there_again_with_the_tab(open_studio: OpenStudio) -> None:
    """A context is lost as where too many are open, or the graphics card is reset."""
    studio = open_studio(webgl=True)
    opened(studio, "3D")
    drawn_gear(studio)
    before = share(seen(studio), RING)
    lose = "document.querySelector('.space-picture canvas').getContext('webgl').getExtension('WEBGL_lose_context')"
    studio.run(f"{lose}.loseContext()")
    problem = studio.page.get_by_text("The browser has taken the picture's memory away")
    problem.wait_for()
    # Plotly, which waits for the context to come back, stumbles when its picture is taken away.
    studio.page.wait_for_timeout(1000)
    studio.complaints[:] = [each for each in studio.complaints if "reading 'gl'" not in each]
    assert not studio.page.locator(".space-picture").is_visible()
    opened(studio, "Gear")
    problem.wait_for(state="hidden")
    opened(studio, "3D")
    studio.page.locator(".space-picture canvas").wait_for()
    studio.page.wait_for_timeout(1500)  # SwiftShader draws some frames later
    assert problem.count() == 0
    assert share(seen(studio), RING) == pytest.approx(before, rel=0.05)


def test_without_webgl_a_sentence_stands_in_the_picture_s_place(open_studio: OpenStudio) -> None:
    studio = open_studio(webgl=True)
    studio.run("""() => {
        const own = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
            return kind.startsWith("webgl") ? null : own.call(this, kind, ...rest);
        };
    }""")
    opened(studio, "3D")
    studio.page.get_by_text("WebGL is switched off or missing").wait_for()
    studio.page.get_by_text("At mid-face teeth do not interfere").wait_for()
    assert not studio.page.locator(".space-picture").is_visible()


def report_of(studio: StudioPage) -> FrameLocator:
    """Have the report made, and give the frame in which it is shown."""
    opened(studio, "Report")
    studio.page.get_by_role("button", name="Make the report").click()
    studio.page.locator("iframe.report-page").wait_for(state="visible")
    return studio.page.frame_locator("iframe.report-page")


def test_the_report_is_shown_alone_and_saved(open_studio: OpenStudio) -> None:
    """It opens without a complaint and without a request to anywhere, which the fixture sees to; it knows nothing of
    the studio around it, and its gear in space is drawn."""
    studio = open_studio(f"?design={design_code(small_gear().replace('name', HOSTILE))}", webgl=True)
    frame = report_of(studio)
    frame.locator("h1").wait_for()
    assert frame.locator("h1").inner_text() == HOSTILE
    assert frame.locator("body").evaluate("() => window.origin") == "null"
    assert frame.locator("body").evaluate("() => typeof boom") == "undefined"
    gear = frame.locator("figure.turnable")
    gear.scroll_into_view_if_needed()
    gear.locator(".live canvas").first.wait_for()
    name, content = studio.downloaded(studio.page.locator(".delivery-link").click)
    assert name.endswith("-report.html")
    assert b"Provenance" in content
    with studio.page.context.expect_page() as beside:
        studio.page.get_by_role("link", name="Open in a new tab").click()
    beside.value.locator("h1").wait_for()
    assert beside.value.evaluate("window.origin") == "null"
