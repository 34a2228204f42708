"""SVG pictures, read back by the rules of the format."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray

from strainwave.export import Drawing, ExportChoice, gear_file
from strainwave.outlines import Outline, flank_points
from tests.designs import case
from tests.export.gears import GEAR
from tests.fitting.deviation import of_the_curve_from_the_chain

SVG = "{http://www.w3.org/2000/svg}"
STEP = re.compile(r"([MLAZ])([^MLAZ]*)")
ROUNDED_MM = 2e-9
Place = NDArray[np.float64]


def picture(choice: ExportChoice, name: str = "cosine-calibrated") -> ElementTree.Element:
    text = gear_file(case(name), "svg", choice)
    assert isinstance(text, str)
    return ElementTree.fromstring(text)


def middle_of_arc(start: Place, end: Place, radius: float, *, clockwise: bool) -> Place:
    """The middle of a small arc of a picture, whose y points down (SVG 2, 9.3.8): a sagitta off that of the chord."""
    chord = end - start
    half = 0.5 * math.hypot(*chord)
    sagitta = radius - math.sqrt(max(radius**2 - half**2, 0.0))
    left_as_seen = np.array([chord[1], -chord[0]]) / (2.0 * half)
    return np.asarray(0.5 * (start + end) + (sagitta if clockwise else -sagitta) * left_as_seen)


def assert_drawn(path: ElementTree.Element, outline: Outline) -> None:
    """Ends and middles of every piece lie on the outline; y is turned back up."""
    up = np.array([1.0, -1.0])
    if outline.is_circle:
        assert path.tag == f"{SVG}circle"
        circle = [float(path.attrib[key]) for key in ("cx", "cy", "r")]
        expected = [*(outline.centers[0] * up), 1.0 / abs(outline.segments[0, 3])]
        assert circle == pytest.approx(expected, abs=ROUNDED_MM)
        return
    steps = [(kind, [float(n) for n in numbers.split()]) for kind, numbers in STEP.findall(path.attrib["d"])]
    assert (steps[-1][0] == "Z") == outline.closed
    here, drawn = np.array(steps[0][1]), 0
    for (kind, numbers), segment, end in zip(steps[1:], outline.segments, outline.ends, strict=False):
        there = np.array(numbers[-2:])
        assert there * up == pytest.approx(end, abs=ROUNDED_MM)
        if kind == "A":
            assert numbers[0] == numbers[1] == pytest.approx(1.0 / abs(segment[3]), abs=ROUNDED_MM)
            assert numbers[2:4] == [0.0, 0.0]
            middle = middle_of_arc(here, there, numbers[0], clockwise=numbers[4] == 1.0)
            assert of_the_curve_from_the_chain(segment[None], (middle * up)[None]) < 1e-6
        here, drawn = there, drawn + 1
    assert drawn == len(outline.segments)


@pytest.mark.parametrize(
    "choice", [ExportChoice(tooth=0), ExportChoice(tooth=0, generator_angle_deg=10.0)], ids=["made", "bent"]
)
def test_the_arcs_of_the_picture_are_those_of_the_outlines(choice: ExportChoice) -> None:
    drawn = picture(choice)
    for group in drawn.iter(f"{SVG}g"):
        outlines = [outline for outline in Drawing.of(GEAR, choice).outlines if outline.part == group.attrib["id"]]
        for path, outline in zip(group, outlines, strict=True):
            assert_drawn(path, outline)
    assert [group.attrib["id"] for group in drawn.iter(f"{SVG}g")] == ["flexspline", "circular-spline"]


def test_a_whole_gear_is_in_true_size() -> None:
    """Its size in mm is that of the view, and the view holds every outline."""
    drawn = picture(ExportChoice(), "four-roller")
    left, top, width, height = (float(number) for number in drawn.attrib["viewBox"].split())
    assert drawn.attrib["width"] == f"{width:g}mm"
    assert drawn.attrib["height"] == f"{height:g}mm"
    assert width == pytest.approx(case("four-roller").circular_spline_outer_diameter_mm + 4.0, abs=0.05)
    for outline in Drawing.of(case("four-roller")).outlines:
        x, y = flank_points(outline.segments, chord_error_mm=1e-4).T
        assert (x > left).all()
        assert (x < left + width).all()
        assert (-y > top).all()
        assert (-y < top + height).all()
    assert len(list(drawn.iter(f"{SVG}circle"))) == 6
    title = drawn.find(f"{SVG}title")
    assert title is not None
    assert title.text == case("four-roller").title


def test_a_name_with_signs_of_the_format_does_no_harm() -> None:
    text = gear_file(GEAR.replace("name", 'a < b & "c" ]]>'), "svg", ExportChoice(tooth=0))
    title = ElementTree.fromstring(text).find(f"{SVG}title")
    assert title is not None
    assert title.text == 'a < b & "c" ]]>'
