"""A hovered tooth's numbers against those of the analysis at that angle."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.studio.gear.tooth_probe import tooth_probe
from tests.scene.gears import NAMES, gear


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("angle", [0.0, 37.3, -2000.0])
def test_numbers_are_those_of_the_analysis_at_that_angle(name: str, angle: float) -> None:
    analysis = gear(name)
    teeth = analyze(analysis.design, generator_angle_deg=angle).teeth
    for place in range(0, len(teeth), 7):
        probe = tooth_probe(analysis, int(teeth.tooth[place]), angle)
        assert probe is not None
        left, right, index = float(teeth.left_um[place]), float(teeth.right_um[place]), float(teeth.index[place])
        assert probe["gaps_um"] == pytest.approx([left, right], abs=1e-6)
        assert probe["words"]["left"] == f"{left:.3f} µm".replace("-", "−")
        assert probe["words"]["right"] == f"{right:.3f} µm".replace("-", "−")
        # The analysis counts on beyond the minor axis, by half a tooth at most; the page is in the other lobe there.
        if abs(index) < analysis.gap_curve.last_index - 1e-6:
            assert float(probe["words"]["index"].replace("−", "-")) == pytest.approx(index, abs=0.00501)
        if abs(left - right) > 1e-6:
            assert probe["gaps_um"][probe["closer"]] == min(probe["gaps_um"])


@pytest.mark.parametrize("name", ["cosine", "51/53"])
def test_its_points_are_as_far_apart_as_its_gaps(name: str) -> None:
    for tooth in (0, 3, -5, 12):
        probe = tooth_probe(gear(name), tooth, 11.0)
        assert probe is not None
        ends = np.array(probe["points_mm"])
        np.testing.assert_allclose(np.hypot(*(ends[:, 0] - ends[:, 1]).T) * 1e3, np.abs(probe["gaps_um"]), atol=1e-6)


def test_it_says_which_pieces_are_closest() -> None:
    analysis = gear("cosine")
    tooth = int(analysis.min_tooth)
    probe = tooth_probe(analysis, tooth, 0.0)
    assert probe is not None
    place = analysis.teeth.tooth.tolist().index(tooth)
    flank = int(analysis.teeth.witnesses.closer_flank[place])
    names = (analysis.teeth.witnesses.flexspline_piece, analysis.teeth.witnesses.circular_spline_piece)
    own, other = (str(each[place, flank]) for each in names)
    assert probe["words"]["closer"] == f"{('left', 'right')[flank]} flank closer: {own} · {other}"


@pytest.mark.parametrize(("tooth", "angle"), [(103, 0.0), (-102, 0.0), (0, math.nan), (0, math.inf), (0, 2e6)])
def test_what_there_is_not_has_no_numbers(tooth: int, angle: float) -> None:
    assert tooth_probe(gear("cosine"), tooth, angle) is None
