"""The animation in a browser: it opens without a complaint, plays, steps, and its parts turn the right way."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from strainwave.analysis import analyze
from strainwave.animation import animate
from strainwave.plots.clearance_colours import OVERLAP
from strainwave.plots.style import GREEN
from tests.browser.conftest import OpenPage
from tests.browser.local_page import LocalPage, Pixels
from tests.designs import case


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The page by the spline that is held; 12 frames of one turn."""
    folder, result = tmp_path_factory.mktemp("pages"), analyze(case("dual-disk-0848-calibrated"))
    written = {}
    for fixed in ("circular-spline", "flexspline"):
        written[fixed] = folder / f"{fixed}.html"
        animate(result, written[fixed], frames=12, fixed=fixed)
    return written


def shown(page: LocalPage, frame: int, canvas: str) -> Pixels:
    page.run(f"(setPlaying(false), show({frame}))")
    return page.pixels(canvas)


def marks(pixels: Pixels) -> tuple[float, float]:
    """Where space 0 and tooth 0 are marked across the magnified view: the upper, the lower, in pixels."""
    rows, columns = np.nonzero(np.abs(pixels / 255.0 - to_rgb(GREEN)).max(axis=-1) < 0.03)
    upper = rows < 0.5 * (rows.min() + rows.max())
    return float(columns[upper].mean()), float(columns[~upper].mean())


@pytest.mark.parametrize(("fixed", "ring", "tooth"), [("circular-spline", 0, -1), ("flexspline", 1, 0)])
def test_the_splines_turn_the_right_way(
    pages: dict[str, Path], open_page: OpenPage, fixed: str, ring: int, tooth: int
) -> None:
    """At frame 6 the generator has turned by half a turn clockwise, and what is not held by one pitch."""
    page = open_page(pages[fixed], width=700)
    (ring_before, tooth_before), (ring_after, tooth_after) = (marks(shown(page, frame, "#near")) for frame in (0, 6))
    pitch = page.run("document.getElementById('near').clientWidth") / 5.8  # the view is 5.8 pitches wide
    assert ring_after - ring_before == pytest.approx(ring * pitch, abs=0.06 * pitch)
    assert tooth_after - tooth_before == pytest.approx(tooth * pitch, abs=0.06 * pitch)
    assert page.complaints == []


def test_it_plays_and_steps_without_a_complaint(pages: dict[str, Path], open_page: OpenPage) -> None:
    page = open_page(pages["circular-spline"], width=500)
    page.wait_for("frame > 2")  # it plays by itself
    page.page.click("#play")
    before = page.run("frame")
    first = page.pixels("#whole")
    page.page.click("#on")
    assert page.run("frame") == (before + 1) % 12
    assert (page.pixels("#whole") != first).any(axis=-1).mean() > 1e-3
    page.page.click("#back")
    np.testing.assert_array_equal(page.pixels("#whole"), first)
    assert page.run("document.getElementById('verdict').textContent").startswith("32 of 204 teeth INTERFERE")
    assert page.complaints == []


def test_interference_is_seen_and_other_teeth_are_not_taken_for_it(
    pages: dict[str, Path], open_page: OpenPage, tmp_path: Path
) -> None:
    """At 60 degrees interfering teeth pass the top: filled in the magnified view, crossed in that of the whole gear."""
    clear = tmp_path / "clear.html"
    animate(analyze(case("cosine-calibrated")), clear, frames=6)
    shares = []
    for file, frame in ((pages["circular-spline"], 2), (clear, 1)):
        page = open_page(file, width=700)
        pixels: tuple[Any, ...] = tuple(shown(page, frame, canvas) for canvas in ("#near", "#whole"))
        shares.append([(np.abs(each / 255.0 - to_rgb(OVERLAP)).max(axis=-1) < 0.03).mean() for each in pixels])
    assert shares[0][0] > 0.01
    assert shares[0][1] > 1e-3
    assert shares[1] == [0.0, 0.0]


def test_a_narrow_window_holds_the_whole_page(pages: dict[str, Path], open_page: OpenPage) -> None:
    page = open_page(pages["flexspline"], width=420, height=900)
    assert page.run("document.documentElement.scrollWidth <= innerWidth")
    assert page.complaints == []
