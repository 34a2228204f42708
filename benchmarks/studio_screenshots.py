"""Take the documentation's pictures of the studio, as a window without a screen shows it; written into docs/pictures.

The studio runs as its users run it. Each tab is opened and waited for; studies are run to their end. Look at the
pictures before you commit them.
"""

from __future__ import annotations

import io
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT))  # the studio is driven as the tests drive it

from tests.browser.chromium import found_command, launched  # noqa: E402
from tests.browser.studio_page import StudioPage  # noqa: E402
from tests.browser.studio_server import StudioServer  # noqa: E402

PICTURES = ROOT / "docs" / "pictures"
DESIGN = ROOT / "designs" / "case-study" / "cosine-calibrated.toml"
LARGEST_BYTES = 200_000
COLOURS = 128
# What works can be cancelled, or says what it does with an ellipsis.
QUIET = """[...document.querySelectorAll(".studio-centre *")].every((seen) => seen.children.length > 0
  || !seen.checkVisibility({ visibilityProperty: true }) || !/^(Cancel|.*…)$/.test(seen.textContent.trim()))"""


@dataclass(frozen=True)
class Shot:
    """A picture: what is done before it is taken, in a window of which size and colours."""

    name: str
    act: Callable[[StudioPage], None]
    width: int = 1280
    height: int = 720
    dark: bool = False


def gear(studio: StudioPage) -> None:
    """The first tab, with a reference, a tooth pointed at and another w0."""
    studio.page.get_by_role("button", name="Pin", exact=True).click()
    entry = studio.page.locator('input[inputmode][data-key="wave_generator.w0"]')
    studio.redrawn_after(lambda: entry.fill("0.852"))
    chart = studio.page.locator(".gear-chart")
    box = chart.bounding_box()
    assert box is not None
    studio.page.mouse.move(box["x"] + 0.7 * box["width"], box["y"] + 0.5 * box["height"])
    studio.page.wait_for_timeout(600)


def tab(name: str, button: str | None = None) -> Callable[[StudioPage], None]:
    """Another tab, with its study run to the end where it has a button for that."""

    def act(studio: StudioPage) -> None:
        studio.page.get_by_role("tab", name=name, exact=True).click()
        studio.page.wait_for_timeout(800)
        if button:
            studio.page.get_by_role("button", name=button, exact=True).click()
            studio.page.wait_for_timeout(800)
        studio.wait_for(QUIET)
        studio.page.wait_for_timeout(2500)

    return act


SHOTS = (
    Shot("studio", gear),
    Shot("studio-dark", gear, dark=True),
    Shot("studio-tablet", gear, width=768, height=1024),
    Shot("studio-w0", tab("w0")),
    Shot("studio-generators", tab("Generators", "Compare")),
    Shot("studio-tolerance", tab("Tolerance", "Run")),
    Shot("studio-optimise", tab("Optimise", "Optimise")),
    Shot("studio-3d", tab("3D")),
    Shot("studio-export", tab("Export")),
    Shot("studio-report", tab("Report", "Make the report")),
)


def small(shown: bytes) -> bytes:
    """The picture in a few colours, which lines and letters do not need more of."""
    file = io.BytesIO()
    few = Image.open(io.BytesIO(shown)).convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
    few.save(file, "PNG", optimize=True)
    assert len(file.getvalue()) < LARGEST_BYTES
    return file.getvalue()


def main() -> None:
    """Take those that are named, or all."""
    from playwright.sync_api import sync_playwright

    if found_command() is None:
        print("  no Chromium here: no picture is taken")
        return
    asked = sys.argv[1:] or [shot.name for shot in SHOTS]
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        server, browser = StudioServer.started(Path(folder) / "log.txt", DESIGN), launched(playwright)
        try:
            for shot in SHOTS:
                if shot.name in asked:
                    size = {"width": shot.width, "height": shot.height}
                    context = browser.new_context(viewport=size, color_scheme="dark" if shot.dark else "light")
                    studio = StudioPage.entered(context, server.address, server.address)
                    studio.wait_for("document.documentElement.dataset.drawn")
                    shot.act(studio)
                    (PICTURES / f"{shot.name}.png").write_bytes(small(studio.page.screenshot()))
                    assert studio.complaints == [], studio.complaints
                    print(f"  docs/pictures/{shot.name}.png", flush=True)
                    context.close()
        finally:
            browser.close()
            server.ended()


if __name__ == "__main__":
    main()
