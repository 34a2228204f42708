"""From the fields of the form to the order that they mean."""

from __future__ import annotations

from typing import Any

import pytest

from strainwave.errors import StrainwaveError
from strainwave.export import FORMATS, ExportChoice
from strainwave.studio.orders import DesignOrder, FilmOrder, GearOrder, Order
from strainwave.studio.orders.kinds import FIELDS, KINDS
from strainwave.studio.orders.wishes import Wishes
from tests.designs import case

GEAR = case("cosine-calibrated")
FILLED: dict[str, Any] = {
    "part": "flexspline",
    "assembled": True,
    "generator_angle_deg": 30.0,
    "one_tooth": True,
    "tooth": -3.0,
    "printing_clearance_mm": 0.05,
    "chord_error_mm": 0.02,
}


def ordered(**fields: Any) -> Order:
    return Wishes(**fields).order(GEAR, 10.0)


@pytest.mark.parametrize("format", FORMATS)
def test_a_form_left_alone_is_the_command_without_options(format: str) -> None:
    assert ordered(kind=format) == GearOrder(GEAR, format, ExportChoice(), None)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("format", "tooth", "angle", "chord_error"),
    [
        ("dxf", -3, 30.0, None),
        ("svg", -3, 30.0, None),
        ("json", -3, 30.0, None),
        ("csv", -3, 30.0, 0.02),
        ("step", -3, None, None),
        ("stl", None, 30.0, 0.02),
        ("glb", None, 30.0, 0.02),
    ],
)
def test_only_what_applies_to_the_format_is_read(
    format: str, tooth: int | None, angle: float | None, chord_error: float | None
) -> None:
    choice = ExportChoice(("flexspline",), tooth, angle, 0.05)
    assert ordered(kind=format, **FILLED) == GearOrder(GEAR, format, choice, chord_error)  # type: ignore[arg-type]


def test_the_wave_generator_has_no_teeth_to_choose_from_or_to_set_back() -> None:
    order = ordered(kind="dxf", **FILLED | {"part": "wave-generator"})
    assert isinstance(order, GearOrder)
    assert order.choice == ExportChoice(("wave-generator",), None, 30.0, 0.0)


def test_films_and_the_design() -> None:
    film = ordered(kind="film-gif", frames=24.0, turns=-0.5, fixed="flexspline", frames_per_s=10.0)
    assert film == FilmOrder(GEAR, "gif", 24, -0.5, "flexspline", 10.0, 10.0)
    assert ordered(kind="toml") == DesignOrder(GEAR)


def test_every_field_belongs_to_some_kind_and_none_to_the_design() -> None:
    assert set().union(*(kind.fields for kind in KINDS.values())) == set(FIELDS)
    assert KINDS["toml"].fields == frozenset()


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"assembled": True, "generator_angle_deg": None}, "wave generator's angle: there is no number"),
        ({"assembled": True, "generator_angle_deg": "much"}, "wave generator's angle: there is no number"),
        ({"one_tooth": True, "tooth": 1.5}, "tooth: must be a whole number, not 1.5"),
        ({"one_tooth": True, "tooth": float("inf")}, "tooth: must be a finite number"),
        ({"printing_clearance_mm": None}, "printing clearance: there is no number"),
        ({"kind": "csv", "chord_error_mm": float("nan")}, "chord error: must be a finite number"),
        ({"kind": "film-mp4", "frames": None}, "frames: there is no number"),
    ],
)
def test_a_field_that_says_nothing_gets_one_clear_message(fields: dict[str, Any], message: str) -> None:
    with pytest.raises(StrainwaveError, match=f"^{message}$"):
        ordered(**fields)
