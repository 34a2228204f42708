"""What the table of formats says is what their files obey."""

from __future__ import annotations

import pytest

from strainwave.errors import StrainwaveError
from strainwave.export import FORMATS, TRAITS, ExportChoice, Format, gear_file
from strainwave.outlines.part import Part
from tests.export.gears import small_gear

RING: Part = "circular-spline"


def is_obeyed(format: Format, choice: ExportChoice, chord_error_mm: float | None = None) -> bool:
    try:
        content = gear_file(small_gear(), format, choice, chord_error_mm=chord_error_mm)
    except StrainwaveError:
        return False
    return len(content) > 0


@pytest.mark.parametrize("format", FORMATS)
def test_the_traits_are_those_of_the_files(format: Format) -> None:
    traits = TRAITS[format]
    assert traits.is_deformable == is_obeyed(format, ExportChoice(only=(RING,), generator_angle_deg=10.0))
    assert traits.has_single_teeth == is_obeyed(format, ExportChoice(only=(RING,), tooth=1))
    asked = is_obeyed(format, ExportChoice(only=(RING,)), chord_error_mm=0.05)
    assert (traits.chord_error_modules is not None) == asked


def test_each_format_says_what_it_holds() -> None:
    assert all(traits.holds.endswith(".") and "\n" not in traits.holds for traits in TRAITS.values())
    assert len({traits.holds for traits in TRAITS.values()}) == len(FORMATS)
