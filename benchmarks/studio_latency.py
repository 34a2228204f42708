"""Measure how long the studio lets its users wait, and write it into docs/commands/studio.md.

The studio runs as its users run it, and Chromium without a window shows it; the keys that change a value are pressed
there, and the page itself says when the drawing has followed. Then the same with seven more windows open, which keep
changing w0. Times differ from run to run and from machine to machine, so no test looks at them. Takes about two
minutes; nothing else should run meanwhile, for browser, studio and the other windows share the machine's cores.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from measurement import machine
from measurement.blocks import ROOT, fill

sys.path.insert(0, str(ROOT))  # the studio is driven as the tests drive it

from measurement import studio_window as window

from tests.browser.chromium import found_command, launched
from tests.browser.studio_page import StudioPage
from tests.browser.studio_server import StudioServer

DESIGN = ROOT / "designs" / "case-study" / "cosine-calibrated.toml"
CHANGES = 200
PLAYED_S = 6.0
OTHERS = 7
CROWDED_S = 40.0
SIZE = {"width": 1280, "height": 720}


def tables() -> dict[str, str]:
    """The blocks of the page."""
    with studio() as (server, page):
        alone = {way.name: window.waits_ms(page, way, CHANGES) for way in window.WAYS}
        mean, slowest = window.frames_per_second(page, PLAYED_S)
        crowd = [sys.executable, "-m", "benchmarks.measurement.studio_crowd", server.address, OTHERS, CROWDED_S]
        with subprocess.Popen([str(part) for part in crowd], stdout=subprocess.PIPE, cwd=ROOT, text=True) as others:
            assert others.stdout is not None
            others.stdout.readline()
            crowded = window.waits_ms(page, window.WAYS[0], CHANGES)
            theirs = json.loads(others.stdout.readline())
    waits = _table(
        {f"{name}": found for name, found in alone.items()}
        | {
            f"{window.WAYS[0].name}, with {OTHERS} more windows": crowded,
            f"w0 in one of these {OTHERS}, to the data of its drawing": theirs,
        }
    )
    frames = f"While the mesh plays, {mean:.0f} frames a second are drawn, 99 of 100 at {slowest:.0f} or faster."
    return {"studio-latency": waits, "studio-frames": f"{frames}\n", "studio-machine": f"{machine.description()}.\n"}


@contextmanager
def studio() -> Iterator[tuple[StudioServer, StudioPage]]:
    """A studio with the case study, and one window of it."""
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        server, browser = StudioServer.started(Path(folder) / "log.txt", DESIGN), launched(playwright, webgl=False)
        try:
            context = browser.new_context(viewport=SIZE)
            page = StudioPage.entered(context, server.address, server.address)
            page.wait_for("document.documentElement.dataset.drawn")
            yield server, page
        finally:
            browser.close()
            server.ended()


def _table(waits: dict[str, list[float]]) -> str:
    rows = ["| what is changed | changes | median | 95 of 100 within | 99 of 100 within |", "|---|--:|--:|--:|--:|"]
    for name, found in waits.items():
        middle, most, nearly_all = np.percentile(found, [50, 95, 99])
        rows.append(f"| {name} | {len(found)} | {middle:.0f} ms | {most:.0f} ms | {nearly_all:.0f} ms |")
    return "".join(f"{row}\n" for row in rows)


def main() -> None:
    """Measure, and write the page."""
    if found_command() is None:
        print("  no Chromium here: the studio is not measured")
        return
    found = tables()
    print(*found.values(), sep="\n")
    fill("docs/commands/studio.md", found)


if __name__ == "__main__":
    main()
