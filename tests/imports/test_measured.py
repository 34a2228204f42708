"""Measured points: smoothed with a reported deviation, averaged over both flanks, refused with a reason."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from strainwave import analyze
from strainwave.errors import StrainwaveError
from strainwave.imports import ImportHints, import_flank
from strainwave.imports.measured_flank import MeasuredFlank
from strainwave.imports.placement import Placement
from strainwave.profiles import Gear
from tests.imports.files import CALIBRATED, SPLINES, Floats, Spline, in_gear_frame, outline, point_file, points
from tests.imports.flank_distance import greatest_distance


def measured(spline: Spline, noise_mm: float, seed: int, *, whole: bool = True) -> Floats:
    """A scan with a point every 2 um, as a coordinate measuring machine makes, with normal noise in x and y."""
    exact = points(spline, whole=whole, chord_error_mm=1.0, longest_mm=0.002)
    return exact + np.random.default_rng(seed).normal(0.0, noise_mm, exact.shape)


@pytest.mark.parametrize("noise_um", [0.3, 1.0, 3.0])
@pytest.mark.parametrize("spline", SPLINES)
def test_noise_is_found_and_averaged_out(tmp_path: Path, spline: Spline, noise_um: float) -> None:
    """The noise within a tenth, and the flank at 10,000 points within one standard deviation, where the points
    themselves are up to five off: most where the curvature jumps, for a smooth spline rounds that off."""
    path = point_file(tmp_path, in_gear_frame(measured(spline, noise_um * 1e-3, seed=1), spline, 0.7))
    found = import_flank(path, CALIBRATED, spline)
    assert found.scatter is not None
    assert found.scatter.noise_um == pytest.approx(noise_um, rel=0.1)
    assert found.scatter.rms_um == pytest.approx(noise_um, rel=0.1)
    assert noise_um * 2.5 < found.scatter.greatest_um < noise_um * 5.5
    assert found.asymmetry_um is not None
    assert found.asymmetry_um < 2.0 * noise_um
    distance = greatest_distance(found.design, outline(spline, whole=False), spline)
    assert distance < 0.05 + noise_um
    assert found.profile["addendum"] == pytest.approx(0.9, abs=2e-3)
    difference = analyze(found.design).min_in_motion_um - analyze(CALIBRATED).min_in_motion_um
    assert abs(difference) < 0.05 + 0.6 * noise_um


def test_the_deviation_shrinks_with_the_root_of_the_number_of_points(tmp_path: Path) -> None:
    """Convergence: sixteen times the points, about a quarter of the root mean square deviation over many scans."""
    rms = []
    for longest in (0.016, 0.001):
        exact = points("circular_spline", whole=False, chord_error_mm=1.0, longest_mm=longest)
        deviations = []
        for seed in range(6):
            noisy = exact + np.random.default_rng(seed).normal(0.0, 2e-3, exact.shape)
            path = point_file(tmp_path, noisy)
            found = import_flank(path, CALIBRATED, "circular_spline", ImportHints(noise_um=2.0))
            deviations.append(
                greatest_distance(found.design, outline("circular_spline", whole=False), "circular_spline")
            )
        rms.append(float(np.sqrt(np.mean(np.square(deviations)))))
    assert 2.0 < rms[0] / rms[1] < 8.0


@pytest.mark.parametrize(
    ("spline", "addendum", "dedendum"), [("flexspline", 0.9, 1.212), ("circular_spline", 0.899, 1.15)]
)
def test_land_and_floor_lie_amid_their_points(spline: Spline, addendum: float, dedendum: float) -> None:
    """The mean over scans with a noise of 5 um is right within 0.8 um, though the flexspline's floor ends in a fillet
    and the land in a corner whose points lie as near to it as the noise: those would move it by 3 and 1.5 um."""
    gear = Gear.of(0.8, getattr(CALIBRATED, spline).teeth, internal=spline == "circular_spline")
    levels = []
    for seed in range(6):
        scan = measured(spline, 5e-3, seed)
        placement = Placement.of(scan, gear, center=None, axis_deg=None)
        found = MeasuredFlank.of(scan, placement, axis_given=True, noise_mm=5e-3, tolerance_mm=5e-5)
        assert found.tip_height_mm is not None
        assert found.root_height_mm is not None
        levels.append([found.tip_height_mm, found.root_height_mm])
    tip, root = np.mean(levels, axis=0)
    assert tip == pytest.approx(0.8 * addendum, abs=8e-4)
    assert root == pytest.approx(-0.8 * dedendum, abs=8e-4)


def test_points_far_off_are_left_out(tmp_path: Path) -> None:
    places = measured("flexspline", 5e-4, seed=3)
    places[[200, 700, 1800]] += [[0.05, 0.0], [0.0, 0.04], [-0.03, 0.0]]
    found = import_flank(point_file(tmp_path, places), CALIBRATED, "flexspline")
    assert found.scatter is not None
    assert found.scatter.left_out == 3
    assert greatest_distance(found.design, outline("flexspline", whole=False), "flexspline") < 0.4


def test_both_flanks_of_a_crooked_tooth_are_averaged(tmp_path: Path) -> None:
    """The left flank 3 um thicker than the right: the profile lies halfway, 1.5 um out, and the axis turns with it."""
    places = points("circular_spline", whole=True)
    crooked = places.copy()
    crooked[places[:, 0] < -0.1, 0] -= 0.003
    found = import_flank(point_file(tmp_path, crooked), CALIBRATED, "circular_spline", ImportHints(axis_deg=180.0))
    assert found.asymmetry_um == pytest.approx(3.0, abs=0.15)
    turned = import_flank(point_file(tmp_path, crooked), CALIBRATED, "circular_spline")
    assert turned.asymmetry_um is not None
    assert turned.asymmetry_um < 0.3
    halfway = outline("circular_spline", whole=False) + np.array([0.0015, 0.0, 0.0, 0.0, 0.0])
    assert greatest_distance(turned.design, halfway, "circular_spline") < 0.2


@pytest.mark.parametrize(
    ("places", "hints", "problem"),
    [
        (points("flexspline", whole=True)[::2] * [1.0, 0.1], ImportHints(), "0.3 to 6 modules"),
        (points("flexspline", whole=True) / 25.4, ImportHints(), "Check the unit"),
        (points("flexspline", whole=True) * 1e3, ImportHints(), r"Check the unit \(--units\)"),
        (in_gear_frame(points("flexspline", whole=True), "flexspline", 0.1) / 25.4, ImportHints(), "Check the unit"),
        (
            in_gear_frame(points("flexspline", whole=True), "flexspline", 0.1) * 2,
            ImportHints(),
            r"lies 161\.2\d+ to 164",
        ),
        (points("flexspline", whole=True) * [1.0, -1.0], ImportHints(), "from tip to tip"),
        (
            np.concatenate(
                [points("flexspline", whole=True), points("flexspline", whole=True) + np.array([2.52, 0.0])]
            ),
            ImportHints(),
            "more than one tooth",
        ),
        (np.random.default_rng(1).uniform(-0.8, 0.8, (400, 2)), ImportHints(), "more than one tooth|from tip to tip"),
        (points("flexspline", whole=False)[[0, 20, -1, 5, 9, 30, 40, 50]], ImportHints(), "tooth|turns|back"),
    ],
    ids=["flat", "inches", "um", "gear in inches", "gear of another module", "space", "two teeth", "cloud", "shuffled"],
)
def test_what_is_not_one_simple_flank_is_refused(
    tmp_path: Path, places: Floats, hints: ImportHints, problem: str
) -> None:
    with pytest.raises(StrainwaveError, match=problem) as caught:
        import_flank(point_file(tmp_path, places), CALIBRATED, "flexspline", hints)
    assert str(caught.value).startswith(str(tmp_path))
    assert "\n" not in str(caught.value)


def test_a_flank_that_crosses_itself_is_refused(tmp_path: Path) -> None:
    """A loop in the middle of the right flank."""
    flank = points("flexspline", whole=False, longest_mm=0.01)
    middle = len(flank) // 2
    angle = np.linspace(0.0, 2 * np.pi, 40)[1:-1]
    loop = flank[middle] + 0.05 * np.stack([np.sin(angle), 1 - np.cos(angle)], axis=-1)
    path = point_file(tmp_path, np.concatenate([flank[:middle], loop, flank[middle:]]))
    with pytest.raises(StrainwaveError, match=r"turns back at|turns by"):
        import_flank(path, CALIBRATED, "flexspline")


def test_a_corner_in_the_flank_is_refused(tmp_path: Path) -> None:
    flank = points("flexspline", whole=False)
    bent = np.where(flank[:, 1:] < 0.0, flank + np.stack([-0.8 * flank[:, 1], 0 * flank[:, 1]], axis=-1), flank)
    with pytest.raises(StrainwaveError, match=r"turns by .* degrees at"):
        import_flank(point_file(tmp_path, bent), CALIBRATED, "flexspline", ImportHints(noise_um=0.0))


def test_flanks_that_differ_are_refused(tmp_path: Path) -> None:
    places = points("circular_spline", whole=True)
    places[places[:, 0] < -0.1] -= [0.03, 0.0]
    with pytest.raises(StrainwaveError, match="flanks that differ by"):
        import_flank(point_file(tmp_path, places), CALIBRATED, "circular_spline", ImportHints(axis_deg=180.0))
