"""Interactive pictures: one look, self-contained pages, and one clear error without plotly."""

from __future__ import annotations

import re
import sys
from functools import cache

import numpy as np
import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.errors import StrainwaveError
from strainwave.plots import interactive, style
from strainwave.plots.clearance_colours import OVERLAP
from strainwave.plots.interactive.house import house_figure, interactive_page
from strainwave.plots.kinds import KINDS
from strainwave.scene import assembly_scene
from tests.designs import case

ADDRESS = re.compile(r"""(?:src|href)\s*=\s*["']?(?:https?:)?//""")


@cache
def analysis() -> Analysis:
    return analyze(case("dual-disk-0848-calibrated"))


def test_teeth_of_the_page_are_those_of_the_scene() -> None:
    page = interactive.assembly_figure(analysis(), generator_angle_deg=7.0)
    scene = assembly_scene(analysis(), generator_angle_deg=7.0, chord_error_mm=2e-4 * 0.8)
    hatched = next(trace for trace in page.data if trace.name == "interfering tooth")
    assert hatched.fillcolor == OVERLAP
    assert hatched.fillpattern.shape == "x"
    overlapping = [tooth for run in scene.overlapping for tooth in run]
    # A closed outline and a break for each tooth.
    assert len(hatched.x) == sum(len(tooth.outline_mm) + 2 for tooth in overlapping)
    words = next(trace.text for trace in page.data if trace.marker.colorbar.title.text)
    assert len(words) == 204
    assert any(word.startswith("tooth 38 at index") and "left flank" in word for word in words)


def test_deepest_places_are_marked() -> None:
    page = interactive.assembly_figure(analysis(), teeth=(30, 36))
    marks = next(trace for trace in page.data if trace.name == "deepest place of an overlap")
    assert len(marks.x) == 32
    assert page.layout.xaxis.range[0] < -6.0 < 6.0 < page.layout.xaxis.range[1]
    assert page.layout.yaxis.scaleanchor == "x"


def test_the_backlash_has_every_tooth_and_its_minimum() -> None:
    page = interactive.backlash_figure(analysis())
    teeth = [trace for trace in page.data if trace.name in ("teeth at 0°", "interfering teeth")]
    assert sum(len(trace.x) for trace in teeth) == 103
    shown = dict(zip(np.concatenate([t.x for t in teeth]), np.concatenate([t.y for t in teeth]), strict=True))
    result = analysis().teeth
    np.testing.assert_array_equal([shown[index] for index in result.index], result.backlash_um)


@pytest.mark.parametrize("kind", [kind for kind in KINDS.values() if kind.interactive], ids=lambda kind: kind.name)
def test_every_interactive_picture_has_the_house_s_look_and_needs_no_network(kind: object) -> None:
    assert isinstance(kind, type(KINDS["gap"]))
    figure = kind.figure(analysis(), interactive=True)
    assert figure.layout.template.layout.font.family.startswith("DejaVu Sans")
    assert figure.layout.title.text == analysis().design.title
    assert figure.layout.title.subtitle.text
    page = interactive_page(figure)
    assert "Plotly.newPlot" in page
    head, _, rest = page.partition("<script")
    assert not ADDRESS.search(head)
    assert not ADDRESS.search(rest[rest.rfind("<script") :])
    assert "<title>Case study, dual disk" in page


def test_colours_are_those_of_the_static_pictures() -> None:
    house = {getattr(style, name) for name in ("BLUE", "ORANGE", "GREEN", "PURPLE", "SKY", "VERMILION", "GREY")}
    assert set(house_figure("t").layout.template.layout.colorway) == house


def test_a_name_is_text_on_the_page() -> None:
    page = interactive_page(house_figure('a <b>bold</b> & "quoted" name</title><script>alert(1)</script>'))
    assert "<script>alert(1)" not in page
    assert "a &lt;b>bold" in page


def test_without_plotly_one_message_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    house_figure.__globals__["_template"].cache_clear()
    monkeypatch.setitem(sys.modules, "plotly", None)
    monkeypatch.setitem(sys.modules, "plotly.graph_objects", None)
    with pytest.raises(StrainwaveError, match=r"interactive pictures need plotly .* pip install 'strainwave\[inter"):
        interactive.gap_figure(analysis())
