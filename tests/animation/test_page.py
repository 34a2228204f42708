"""What the page holds: the engagement's own poses and clearances, and nothing from elsewhere."""

from __future__ import annotations

import base64
import json
import re
from typing import Any

import numpy as np
import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.animation import Film
from strainwave.animation.page import page
from strainwave.columns import Floats
from strainwave.scene.poses import tooth_poses
from tests.designs import case

DATA = re.compile(r"^const film = (?P<data>\{.*\});$", re.MULTILINE)


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyze(case("dual-disk-0848-calibrated"))


def data_of(text: str) -> dict[str, Any]:
    found = DATA.search(text)
    assert found is not None
    data: dict[str, Any] = json.loads(found["data"])
    return data


def unpacked(text: str) -> Floats:
    return np.frombuffer(base64.b64decode(text), dtype="<f4").astype(np.float64)


@pytest.mark.parametrize("fixed", ["circular-spline", "flexspline"])
def test_poses_clearances_and_angles_are_those_of_every_frame(analysis: Analysis, fixed: Any) -> None:
    film = Film.of(analysis, frames=5, turns=1.0, fixed=fixed, frames_per_s=20.0)
    data = data_of(page(film))
    poses, gaps = unpacked(data["poses"]).reshape(5, 204, 3), unpacked(data["gaps_um"]).reshape(5, 204)
    for frame, scene in enumerate(film.scenes(1e-2)):
        np.testing.assert_allclose(poses[frame], tooth_poses(analysis, film.turning(frame)), atol=1e-5)
        shown = np.array([tooth.clearance_um for tooth in scene.teeth], dtype=np.float64)
        np.testing.assert_allclose(gaps[frame], shown, rtol=1e-6, atol=1e-6)
        assert data["numbers"] == [tooth.tooth for tooth in scene.teeth]
        assert data["verdicts"][frame] == scene.verdict
        assert data["circular_spline_deg"][frame] == film.turning(frame).circular_spline_deg
        assert data["generator_deg"][frame] == film.generator_deg[frame]


def test_every_part_but_the_teeth_is_there_and_moves_with_what_it_is_part_of(analysis: Analysis) -> None:
    data = data_of(page(Film.of(analysis, frames=2, turns=1.0, fixed="flexspline", frames_per_s=20.0)))
    moves = {part["name"]: part["moves"] for part in data["parts"] if part["name"] != "tooth 0 and its space"}
    assert moves["circular spline"] == "circular spline"
    assert {moves[name] for name in ("flexspline", "disks", "neutral curve", "major axis")} == {"generator"}
    assert [part["moves"] for part in data["parts"] if part["name"] == "tooth 0 and its space"] == [
        "tooth 0",
        "circular spline",
    ]


def test_a_name_cannot_leave_its_place(analysis: Analysis) -> None:
    named = analyze(analysis.design.replace("name", "</script><script>alert(1)</script> $words {x}"))
    text = page(Film.of(named, frames=2, turns=1.0, fixed="flexspline", frames_per_s=20.0))
    assert "<script>alert" not in text
    assert text.count("</script>") == 1
    assert "&lt;script&gt;alert(1)&lt;/script&gt; $words {x}" in text


def test_nothing_comes_from_elsewhere(analysis: Analysis) -> None:
    text = page(Film.of(analysis, frames=2, turns=1.0, fixed="flexspline", frames_per_s=20.0))
    assert "http" not in text
    assert "url(" not in text
    assert len(text) < 600_000
