"""The film: angles, words, and what cannot be filmed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.animation import Film
from strainwave.errors import StrainwaveError
from strainwave.scene.outlines import placed, tooth_outline
from strainwave.scene.poses import tooth_poses
from tests.designs import case

USUAL: dict[str, Any] = {"frames": 8, "turns": 1.0, "fixed": "circular-spline", "frames_per_s": 20.0}


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyze(case("cosine-calibrated"))


def test_frames_are_evenly_spaced_and_do_not_repeat_the_first(analysis: Analysis) -> None:
    assert Film.of(analysis, **USUAL).generator_deg.tolist() == [45.0 * frame for frame in range(8)]
    back = Film.of(analysis, **(USUAL | {"turns": -0.5, "frames": 4}))
    assert back.generator_deg.tolist() == [0.0, -45.0, -90.0, -135.0]


def test_the_words_say_ratio_and_direction(analysis: Analysis) -> None:
    assert Film.of(analysis, **USUAL).words == (
        "circular spline fixed; ratio of generator to flexspline −204/2 = −102: they turn opposite ways"
    )
    assert Film.of(analysis, **(USUAL | {"fixed": "flexspline"})).words == (
        "flexspline fixed; ratio of generator to circular spline 206/2 = 103: they turn the same way"
    )


@pytest.mark.parametrize("fixed", ["circular-spline", "flexspline"])
def test_poses_place_the_teeth_where_the_scene_has_them(analysis: Analysis, fixed: Any) -> None:
    film = Film.of(analysis, **(USUAL | {"fixed": fixed}))
    outline = tooth_outline(analysis.geometry.flexspline, 1e-3)
    for frame, scene in enumerate(film.scenes(1e-3)):
        there = placed(outline, tooth_poses(analysis, film.turning(frame)))
        np.testing.assert_allclose(there, np.stack([tooth.outline_mm for tooth in scene.teeth]), atol=1e-9)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"frames": 1}, "an animation has from 2 to 2000 frames, not 1"),
        ({"frames": 2001}, "an animation has from 2 to 2000 frames, not 2001"),
        ({"turns": 0.0}, "and not by 0"),
        ({"turns": float("nan")}, "and not by nan"),
        ({"turns": -1e9}, r"at most 1000 turns either way"),
        ({"frames_per_s": 0.0}, "frames per second must be from 1 to 60, not 0"),
        ({"frames_per_s": float("inf")}, "frames per second must be from 1 to 60, not inf"),
        ({"fixed": "wave-generator"}, "the spline held fixed is"),
    ],
)
def test_what_cannot_be_is_refused(analysis: Analysis, change: dict[str, Any], said: str) -> None:
    with pytest.raises(StrainwaveError, match=said):
        Film.of(analysis, **(USUAL | change))
