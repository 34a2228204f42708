"""The gear in space in a browser: it is drawn, in its colours, and turns."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from strainwave.analysis import analyze, face_map
from strainwave.plots.interactive import assembly_3d_figure, face_figure, interactive_page
from tests.browser.conftest import OpenPage
from tests.browser.hues import CLOSE, INTERFERENCE, RING, share
from tests.browser.local_page import LocalPage, Pixels
from tests.designs import case

WIDTH = 560


@pytest.fixture(scope="module")
def page_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("space") / "gear.html"
    file.write_text(interactive_page(assembly_3d_figure(analyze(case("four-roller-calibrated")))), encoding="utf-8")
    return file


def drawn(page: LocalPage) -> Pixels:
    """The view once it is there, without the scale of colours on its right."""
    page.wait_for("document.querySelector('#picture canvas') !== null")
    page.page.wait_for_timeout(1500)
    return page.pixels()[:, : int(0.8 * WIDTH)]


def test_the_gear_is_drawn_and_turns_without_a_complaint(page_file: Path, open_page: OpenPage) -> None:
    page = open_page(page_file, width=WIDTH, height=440)
    before = drawn(page)
    assert share(before, RING) > 0.05
    assert share(before, INTERFERENCE) > 0.002
    assert share(before, CLOSE) > 0.0004
    page.page.mouse.move(200, 220)
    page.page.mouse.down()
    page.page.mouse.move(330, 180, steps=2)
    page.page.mouse.up()
    after = drawn(page)
    assert (np.abs(after.astype(int) - before).max(axis=-1) > 40).mean() > 0.05
    assert share(after, RING) > 0.03
    assert page.complaints == []


def test_the_page_is_light_enough_to_be_embedded(page_file: Path) -> None:
    """The gear itself beside plotly, which takes 5 MB."""
    assert page_file.stat().st_size < 9e6
    assert len(assembly_3d_figure(analyze(case())).to_json()) < 4e6


def test_the_map_of_the_face_is_drawn_without_a_complaint(open_page: OpenPage, tmp_path: Path) -> None:
    file = tmp_path / "face.html"
    file.write_text(interactive_page(face_figure(face_map(analyze(case("cosine-calibrated")), 5))), encoding="utf-8")
    page = open_page(file)
    page.wait_for("document.querySelector('#picture .heatmaplayer image') !== null")
    page.page.wait_for_timeout(300)
    pixels = page.pixels()
    assert share(pixels, INTERFERENCE) > 0.05
    assert share(pixels, CLOSE) > 0.02
    assert page.complaints == []
