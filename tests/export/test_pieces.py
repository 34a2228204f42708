"""Pieces as JSON."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from strainwave.export import Drawing, ExportChoice, gear_file
from strainwave.outlines import NO_TOOTH
from tests.designs import case
from tests.export.gears import GEAR

PAGE = Path(__file__).parent.parent.parent / "docs" / "commands" / "export.md"


def record(choice: ExportChoice, name: str = "cosine-calibrated") -> dict[str, Any]:
    found: dict[str, Any] = json.loads(gear_file(case(name), "json", choice))
    return found


@pytest.mark.parametrize("choice", [ExportChoice(tooth=2), ExportChoice(), ExportChoice(generator_angle_deg=12.0)])
def test_the_pieces_are_those_of_the_outlines(choice: ExportChoice) -> None:
    found, outlines = record(choice), Drawing.of(GEAR, choice).outlines
    assert found["schema_version"] == 1
    assert found["name"] == GEAR.name
    assert found["generator_angle_deg"] == choice.generator_angle_deg
    assert found["printing_clearance_mm"] == 0.0
    assert len(found["outlines"]) == len(outlines)
    for written, outline in zip(found["outlines"], outlines, strict=True):
        assert (written["part"], written["closed"]) == (outline.part, outline.closed)
        pieces = written["pieces"]
        assert tuple(piece["role"] for piece in pieces) == outline.roles
        assert [NO_TOOTH if piece["tooth"] is None else piece["tooth"] for piece in pieces] == outline.teeth.tolist()
        if outline.is_circle:
            assert [piece["kind"] for piece in pieces] == ["circle"]
            continue
        assert [piece["start_mm"] for piece in pieces] == outline.segments[:, :2].tolist()
        assert [piece["end_mm"] for piece in pieces] == outline.ends.tolist()


def test_an_arc_has_its_centre_as_far_from_its_ends_as_its_radius_says() -> None:
    (outline,) = record(ExportChoice(only=("flexspline",), tooth=0))["outlines"]
    arcs = [piece for piece in outline["pieces"] if piece["kind"] == "arc"]
    assert len(arcs) == 10
    for arc in arcs:
        away = np.array([arc["start_mm"], arc["end_mm"]]) - arc["center_mm"]
        assert np.abs(np.hypot(*away.T) - arc["radius_mm"]).max() < 1e-12 * arc["radius_mm"] + 1e-13
        turned_left = away[0, 0] * away[1, 1] > away[1, 0] * away[0, 1]
        assert arc["clockwise"] == (not turned_left)


def test_every_key_is_documented() -> None:
    page = PAGE.read_text(encoding="utf-8")
    found = record(ExportChoice(), "four-roller")
    pieces = [piece for outline in found["outlines"] for piece in outline["pieces"]]
    for key in {*found, *found["outlines"][0], *(key for piece in pieces for key in piece)}:
        assert f"`{key}`" in page, key
    for role in {piece["role"] for piece in pieces}:
        assert role in page, role
