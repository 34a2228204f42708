"""Yield and scatter against a brute count, an eccentric ring against one that is moved, and what the seed decides."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.geometry import Geometry
from strainwave.studies.tolerance import (
    ECCENTRICITY,
    Normal,
    Responses,
    Tolerances,
    Uniform,
    Yield,
    analyze_tolerance,
)
from strainwave.studies.tolerance.monte_carlo import PERCENTILES, ROWS_AT_ONCE, percentiles
from strainwave.studies.tolerance.record import csv_text
from tests.designs import case
from tests.studies.tolerance.runs import ANGLE, OFFSET, THREE, W0, analysis

DESIGN = case("cosine-calibrated")
BRUTE_SAMPLES = 500


def brute_least_um(design: Design) -> float:
    """The least of the gap curve at 521 places: no more than 0.02 µm above the least of all, with 8 µm/index² of it."""
    index = np.linspace(0.0, 51.0, 521)
    return float(Geometry.of(design).engagement.clearances(index).gap.min()) * 1e3


def brute_samples() -> Floats:
    """Least backlash of random designs drawn without any of the program's distributions or sequences."""
    rng = np.random.default_rng(7)
    found: list[float] = []
    while len(found) < BRUTE_SAMPLES:
        offset = rng.normal(0.0005, 0.0015)
        if not -0.003 <= offset <= 0.002:  # inspection rejects it
            continue
        changes = {
            W0: DESIGN.wave_generator.w0 + rng.normal(0.0, 0.001),
            OFFSET: DESIGN.flexspline.profile.offset + offset,
            ANGLE: 7.0 + 30.5 / 60.0 + rng.uniform(-0.05, 0.1),
        }
        found.append(brute_least_um(DESIGN.replace(changes)) - 1e3 * abs(rng.uniform(-0.001, 0.001)))
    return np.array(found)


def test_yield_and_percentiles_agree_with_a_brute_count() -> None:
    """Within three standard errors of the count; so does the share of samples below the program's percentiles."""
    found, brute = analysis(), brute_samples()
    error = math.sqrt(found.yield_.share * (1.0 - found.yield_.share) / BRUTE_SAMPLES)
    assert 0.01 < error < 0.025
    assert abs((brute >= 0.0).mean() - found.yield_.share) < 3.0 * error
    for percent, value in found.min_in_motion_percentiles_um.items():
        share = percent / 100.0
        error = math.sqrt(share * (1.0 - share) / BRUTE_SAMPLES)
        assert abs((brute < value).mean() - share) < 3.0 * error + 1.0 / BRUTE_SAMPLES


def test_samples_are_the_designs_that_they_say() -> None:
    found = analysis().monte_carlo
    keys = [parameter.key for parameter in found.parameters]
    for row in (0, 1, 2, 777):
        numbers = dict(zip(keys, found.values[row].tolist(), strict=True))
        eccentricity_um = abs(numbers.pop(ECCENTRICITY)) * 1e3
        result = analyze(DESIGN.replace(numbers))
        assert found.responses.min_in_motion_um[row] == result.min_in_motion_um - eccentricity_um
        assert found.responses.play_um[row] == result.play.circumferential_um


def test_an_eccentric_ring_takes_its_eccentricity_off_the_least_gap_over_a_turn() -> None:
    """Brute force: the tooth at its closest index in each of the 206 spaces of a ring that is really displaced."""
    geometry = Geometry.of(DESIGN)
    closest = geometry.engagement.minimum_in_motion(1e-9)
    eccentricity = 0.0005
    pose = geometry.engagement.relative_poses(np.array([closest.index]))
    turn = 2.0 * math.pi * np.arange(206) / 206
    poses = np.repeat(pose, 206, axis=0)
    poses[:, 0] -= eccentricity * np.sin(turn)
    poses[:, 1] -= eccentricity * np.cos(turn)
    least = geometry.engagement.clearances_at(poses).gap.min()
    assert least == pytest.approx(closest.gap - eccentricity, abs=1e-3 * eccentricity)
    assert least >= closest.gap - eccentricity - 1e-12  # never by more


def test_small_tolerances_scatter_as_the_slopes_say() -> None:
    """Two ways to the same standard deviation: samples, and the contact of the one design. Within 2 %."""
    small = Tolerances(
        tolerances=(
            Normal(parameter=W0, sigma=1e-4),
            Normal(parameter=OFFSET, sigma=5e-5),
            Uniform(parameter="flexspline.profile.tip_arc_center[1]", lower=-2e-4, upper=2e-4),
        )
    )
    found = analyze_tolerance(DESIGN, small, samples=1024, sobol_samples=256)
    parts = np.array([each.scatter_um for each in found.sensitivities], dtype=np.float64)
    scatter = found.monte_carlo.responses.min_in_motion_um.std()
    assert scatter == pytest.approx(math.sqrt((parts**2).sum()), rel=0.02)
    assert found.sobol is not None
    indices = found.sobol["min_in_motion_um"]
    assert indices is not None
    assert indices.first == pytest.approx(parts**2 / (parts**2).sum(), abs=0.03)


def test_the_same_seed_gives_the_same_on_one_thread_and_on_two() -> None:
    one, two, other = (
        analyze_tolerance(DESIGN, THREE, samples=512, sobol_samples=64, seed=seed, threads=threads)
        for seed, threads in ((1, 1), (1, 2), (2, 2))
    )
    assert one.to_json() == two.to_json()
    assert csv_text(one) == csv_text(two)
    assert one.to_json() != other.to_json()
    assert other.yield_.share == pytest.approx(one.yield_.share, abs=0.05)


def test_wilsons_interval() -> None:
    """E. B. Wilson, 1927: (p + z²/2n ± z √(p(1−p)/n + z²/4n²)) / (1 + z²/n), z = 1.959964 for 95 %."""
    least = np.array([1.0] * 90 + [-1.0] * 8 + [np.nan] * 2)
    found = Yield.of(Responses(least, least))
    z, p, n = 1.959963984540054, 0.9, 100
    half = z * math.sqrt(p * (1 - p) / n + z**2 / (4 * n**2))
    ends = [(p + z**2 / (2 * n) + sign * half) / (1 + z**2 / n) for sign in (-1, 1)]
    assert (found.share, found.passed, found.samples) == (0.9, 90, 100)
    assert [found.low, found.high] == pytest.approx(ends, rel=1e-12)


def test_a_sample_that_is_no_gear_has_failed_and_is_counted() -> None:
    wild = Tolerances(tolerances=(Uniform(parameter="flexspline.profile.flank_angle", lower=-20.0, upper=0.0),))
    found = analyze_tolerance(DESIGN, wild, samples=64, sobol_samples=64)
    possible = found.monte_carlo.values[:, 0] >= 0.0
    assert 0 < found.monte_carlo.impossible < 64
    assert not np.isnan(found.monte_carlo.responses.min_in_motion_um[possible]).all()
    assert np.isnan(found.monte_carlo.responses.min_in_motion_um[~possible]).all()
    assert found.yield_.passed <= possible.sum()
    assert found.sobol == {"min_in_motion_um": None, "play_circumferential_um": None}
    record = json.loads(found.to_json())
    assert record["samples"]["impossible"] == found.monte_carlo.impossible
    assert "" in {row["min_in_motion_um"] for row in csv.DictReader(io.StringIO(csv_text(found)))}


def test_deep_interference_has_the_minimum_at_angle_0() -> None:
    """-21.8 µm as printed (the README's table): an upper bound of that in motion, found without a long search."""
    parameters = Tolerances(tolerances=(Normal(parameter="wave_generator.w0", sigma=1e-3),)).of(case("dual-disk-0848"))
    found = Responses.of(case("dual-disk-0848"), parameters, np.array([[0.848]]), 0)
    result = analyze(case("dual-disk-0848"))
    assert found.min_in_motion_um[0] == result.min_backlash_um
    assert result.min_in_motion_um <= result.min_backlash_um < -5.0


@pytest.mark.parametrize("name", ["cosine-calibrated", "dual-disk-0848-calibrated"])
def test_the_design_itself_has_its_certified_minimum_however_deep(name: str) -> None:
    """1.49 and -14.62 µm in motion (docs/commands/analyze.md); at angle 0 the second has -14.57 µm."""
    around = Tolerances(tolerances=(Uniform(parameter=W0, lower=-0.001, upper=0.001),))
    found = analyze_tolerance(case(name), around, samples=64, sobol_samples=64)
    result = analyze(case(name))
    assert found.nominal.min_in_motion_um[0] == result.min_in_motion_um
    assert found.nominal.play_um[0] == result.play.circumferential_um
    record = json.loads(found.to_json())
    assert record["min_in_motion_um"]["nominal"] == pytest.approx(record["contact"]["gap_um"], abs=1e-3)


def test_percentiles_leave_out_what_is_absent() -> None:
    found = percentiles(np.append(np.linspace(0.0, 100.0, 1001), np.nan))
    assert list(found) == list(PERCENTILES)
    assert found == pytest.approx({percent: percent for percent in PERCENTILES})
    assert all(math.isnan(value) for value in percentiles(np.array([np.nan])).values())


def interrupting(after: int) -> Callable[[int, int], None]:
    """Ctrl-C, once."""
    pending = [KeyboardInterrupt()]

    def progress(done: int, total: int) -> None:
        if done >= after and pending:
            raise pending.pop()

    return progress


def test_ctrl_c_keeps_the_samples_that_are_done() -> None:
    stopped = analyze_tolerance(DESIGN, THREE, samples=8192, progress=interrupting(ROWS_AT_ONCE))
    kept = analysis().monte_carlo
    assert stopped.interrupted
    assert stopped.monte_carlo.interrupted
    assert stopped.sobol is None
    assert (len(stopped.monte_carlo.responses), stopped.monte_carlo.asked) == (ROWS_AT_ONCE, 8192)
    np.testing.assert_array_equal(stopped.monte_carlo.values, kept.values)  # the beginning of the same sequence
    np.testing.assert_array_equal(stopped.monte_carlo.responses.min_in_motion_um, kept.responses.min_in_motion_um)
    assert stopped.yield_ == analysis().yield_
    assert json.loads(stopped.to_json())["sobol"] is None


def test_ctrl_c_among_the_samples_of_the_indices_keeps_all_others() -> None:
    stopped = analyze_tolerance(DESIGN, THREE, samples=64, sobol_samples=512, progress=interrupting(65))
    assert stopped.interrupted
    assert not stopped.monte_carlo.interrupted
    assert stopped.yield_.samples == 64


def test_ctrl_c_with_the_last_sample_ends_the_study_too() -> None:
    stopped = analyze_tolerance(DESIGN, THREE, samples=64, sobol_samples=64, progress=interrupting(64))
    assert stopped.yield_.samples == 64
    assert stopped.sobol is None


def test_ctrl_c_before_anything_is_done_is_an_interrupt(monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(*_: object) -> Responses:
        raise KeyboardInterrupt

    monkeypatch.setattr(Responses, "of", stop)
    with pytest.raises(KeyboardInterrupt):
        analyze_tolerance(DESIGN, THREE, samples=64)


def test_progress_runs_to_its_end() -> None:
    seen: list[tuple[int, int]] = []
    analyze_tolerance(DESIGN, THREE, samples=70, sobol_samples=64, progress=lambda *done: seen.append(done))
    total = 128 + 64 * 6  # 70 rounded up, and four parameters
    assert seen[0] == (128, total)
    assert seen[-1] == (total, total)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"samples": 0}, "samples must be a whole number from 64"),
        ({"samples": 1e5}, "samples must be a whole number from 64"),
        ({"sobol_samples": 2**30}, "sobol_samples must be a whole number from 64"),
        ({"seed": -1}, "seed must be a whole number from 0"),
        ({"threads": -1}, "threads must be"),
    ],
)
def test_a_wrong_number_is_one_clear_error(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(StrainwaveError, match=said):
        analyze_tolerance(DESIGN, THREE, **changes)
