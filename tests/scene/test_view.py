"""The window on a scene."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.errors import StrainwaveError
from strainwave.scene import Scene, View, assembly_scene
from tests.designs import case

MODULE = 0.8


@pytest.fixture(scope="module")
def scene() -> Scene:
    return assembly_scene(analyze(case()))


@pytest.mark.parametrize(
    ("first", "last", "shown"),
    [(30, 33, [30, 31, 32, 33]), (101, -100, [101, 102, -101, -100]), (-1, 1, [-1, 0, 1]),
     (102, 102, [99, 100, 101, 102, -101, -100, -99])],
)  # fmt: skip
def test_the_chosen_teeth_are_all_in_the_window_and_upright(
    scene: Scene, first: int, last: int, shown: list[int]
) -> None:
    view = View.of_teeth(scene, MODULE, first, last)
    assert [tooth.tooth for tooth in view.teeth] == shown
    middles = np.stack([tooth.outline_mm.mean(axis=0) for tooth in view.teeth])
    assert np.all(np.diff(middles[:, 0]) > 2.0)  # from left to right, a pitch of 2.5 mm apart
    assert abs(middles[:, 0].mean()) < 0.1
    points = np.concatenate([tooth.outline_mm for tooth in view.teeth])
    for axis, (low, high) in enumerate((view.x_mm, view.y_mm)):
        assert low < points[:, axis].min() < points[:, axis].max() < high


def test_the_view_of_the_whole_has_every_tooth(scene: Scene) -> None:
    view = View.of_whole(scene, MODULE)
    points = np.concatenate([tooth.outline_mm for tooth in view.scene.teeth])
    assert view.x_mm[0] < points.min() < points.max() < view.x_mm[1]
    assert view.teeth == ()


@pytest.mark.parametrize("number", [103, -102, 9999])
def test_a_tooth_that_is_not_there_is_named(scene: Scene, number: int) -> None:
    with pytest.raises(StrainwaveError, match=rf"no tooth {number}: .* 204 teeth are numbered from -101 to 102"):
        View.of_teeth(scene, MODULE, 0, number)
