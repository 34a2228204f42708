"""Interactive pictures in a browser: they draw, and ask nobody for anything."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from strainwave.analysis import analyze
from strainwave.plots.clearance_colours import OVERLAP
from strainwave.plots.interactive import interactive_page, tolerance_figure
from strainwave.plots.kinds import KINDS
from tests.browser.conftest import OpenPage
from tests.designs import case
from tests.studies.tolerance.runs import AWAY, away


@pytest.mark.parametrize("kind", ["gap", "trajectory"])
def test_a_page_opens_and_draws_without_a_complaint(kind: str, tmp_path: Path, open_page: OpenPage) -> None:
    result = analyze(case("dual-disk-0848-calibrated"))
    file = tmp_path / f"{kind}.html"
    file.write_text(interactive_page(KINDS[kind].figure(result, interactive=True)), encoding="utf-8")
    page = open_page(file, width=800, height=600)
    page.wait_for("document.querySelectorAll('.trace').length > 1")
    assert (page.pixels() != 255).any(axis=-1).mean() > 0.02
    assert page.run("document.title") == result.design.title
    assert page.complaints == []


@pytest.mark.parametrize("where", AWAY)
def test_a_histogram_s_words_stand_in_it_side_by_side(where: str, tmp_path: Path, open_page: OpenPage) -> None:
    file = tmp_path / "tolerance.html"
    file.write_text(interactive_page(tolerance_figure(away(where))), encoding="utf-8")
    page = open_page(file, width=600, height=600)
    page.wait_for("document.querySelectorAll('.annotation').length === 4")
    boxes = page.run(WORDS_BOXES)
    assert len(boxes) == 4  # what lies beyond the axis is not drawn
    left, right = page.run(HISTOGRAM_ENDS)
    for place, (x0, x1, y0, y1) in enumerate(boxes):
        assert left - 1 <= x0 < x1 <= right + 1
        assert not any(x0 < x3 and x2 < x1 and y0 < y3 and y2 < y1 for x2, x3, y2, y3 in boxes[:place])
    assert page.complaints == []


WORDS_BOXES = """[...document.querySelectorAll(".annotation text")].map((words) => {
    const box = words.getBoundingClientRect();
    return [box.left, box.right, box.top, box.bottom];
})"""
HISTOGRAM_ENDS = """(() => {
    const { xaxis } = document.getElementById("picture")._fullLayout;
    return [xaxis._offset, xaxis._offset + xaxis._length];
})()"""


def test_the_assembly_shows_interference_and_what_is_pointed_at(tmp_path: Path, open_page: OpenPage) -> None:
    file = tmp_path / "assembly.html"
    result = analyze(case("dual-disk-0848-calibrated"))
    figure = KINDS["assembly"].figure(result, interactive=True, teeth=(36, 38))
    file.write_text(interactive_page(figure), encoding="utf-8")
    page = open_page(file, width=800, height=600)
    page.wait_for("document.querySelectorAll('.trace').length > 1")
    assert (np.abs(page.pixels() / 255.0 - to_rgb(OVERLAP)).max(axis=-1) < 0.03).mean() > 0.01
    page.page.mouse.move(*page.run(TOOTH_37))
    page.wait_for("document.querySelector('.hovertext') !== null")
    assert "tooth 37 at index 37.00" in page.run("document.querySelector('.hovertext').textContent")
    assert page.complaints == []


TOOTH_37 = """(() => {
    const { xaxis, yaxis } = document.getElementById("picture")._fullLayout;
    return [xaxis._offset + xaxis.l2p(0), yaxis._offset + yaxis.l2p(80.9)];
})()"""
"""Where the middle of that tooth is in the window: of three chosen ones the middle stands at the top."""
