"""A batch has the numbers of `analyze` for each of its rows, bit for bit, and refuses what it refuses."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave import Batch, DesignError, analyze, evaluate_batch
from strainwave.analysis import Analysis
from strainwave.batch import METRICS, STATUSES
from strainwave.batch.metrics import COLUMNS
from tests.batch.variations import GENERATORS, PROFILES, number_keys, random_rows, varied_design
from tests.designs import case

KINDS = [(generator, "arcs") for generator in GENERATORS] + [("cosine", name) for name in PROFILES if name != "arcs"]
ROWS = 9


def figures(analysis: Analysis) -> dict[str, float]:
    """The columns of a batch as an analysis has them, nan where it has none."""
    first = analysis.first_interfering_tooth
    return {
        "min_backlash_um": analysis.min_backlash_um,
        "min_tooth": analysis.min_tooth,
        "teeth_below_per_side": analysis.teeth_below.per_side,
        "interfering_per_side": analysis.teeth_interfering.per_side,
        "first_interfering_tooth": math.nan if first is None else first,
        "play_circumferential_um": analysis.play.circumferential_um,
        "tip_clearance_um": analysis.tip_clearance_um,
        "root_clearance_um": analysis.root_clearance_um,
        "min_in_motion_um": analysis.min_in_motion_um,
        "min_in_motion_index": analysis.min_in_motion_index,
        "min_in_motion_lower_bound_um": analysis.in_motion.lower_bound_um,
    }


def assert_row_is_its_design(batch: Batch, row: int) -> None:
    found = {name: float(column[row]) for name, column in batch.columns.items()}
    try:
        expected = figures(analyze(batch.design_of(row), threshold_um=batch.threshold_um))
        reason = None
    except DesignError as error:
        expected, reason = dict.fromkeys(COLUMNS, math.nan), str(error)
    assert batch.reason(row) == reason
    assert batch.status[row] in (STATUSES[1:] if reason else ["ok"])
    assert repr(found) == repr({name: float(expected[name]) for name in found})  # every bit, and nan is nan


@pytest.mark.parametrize(("generator", "profile"), KINDS)
def test_every_row_is_its_design(generator: str, profile: str) -> None:
    design = varied_design(generator, profile)
    keys = number_keys(design)
    values = random_rows(design, keys, seed=len(generator + profile), rows=ROWS)
    batch = evaluate_batch(design, keys, values, metrics=METRICS, in_motion=True, threshold_um=5.0)
    assert list(batch.columns) == list(COLUMNS)
    assert 0 < batch.ok.sum() < ROWS
    for row in range(ROWS):
        assert_row_is_its_design(batch, row)


@pytest.mark.parametrize("teeth", [(203, 205), (202, 206), (201, 203)])
def test_an_odd_number_of_teeth_and_a_larger_difference(teeth: tuple[int, int]) -> None:
    """With an odd number, teeth about the other end of the major axis stand at half indices."""
    keys = {"flexspline.teeth": teeth[0], "circular_spline.teeth": teeth[1]}
    design = case().replace(keys | {"wave_generator.w0": 0.42 * (teeth[1] - teeth[0])})
    values = [[0.0], [-0.01], [-0.03], [0.01]]
    batch = evaluate_batch(design, ["flexspline.profile.offset"], values, metrics=METRICS)
    for row in range(4):
        assert_row_is_its_design(batch, row)


@pytest.mark.parametrize(("generator", "profile"), KINDS)
def test_one_number_alone(generator: str, profile: str) -> None:
    """Where only one number varies the kernel builds the other parts once, and finds the same."""
    design = varied_design(generator, profile)
    for key in number_keys(design):
        value = random_rows(design, [key], seed=5, rows=2)[1]
        batch = evaluate_batch(design, [key], [value, value * 1.0001])
        for row in range(2):
            assert_row_is_its_design(batch, row)


@pytest.mark.parametrize(("generator", "profile"), KINDS)
def test_rows_do_not_see_each_other(generator: str, profile: str) -> None:
    """Alone, in another order, on one thread or many: the same bits."""
    design = varied_design(generator, profile)
    keys = number_keys(design)
    values = random_rows(design, keys, seed=2, rows=24)
    together = evaluate_batch(design, keys, values, metrics=METRICS, threads=1)
    for threads in (2, 3, 0):
        assert same(together, evaluate_batch(design, keys, values, metrics=METRICS, threads=threads))
    order = np.random.default_rng(3).permutation(24)
    assert same(together, evaluate_batch(design, keys, values[order], metrics=METRICS), order)
    for row in range(0, 24, 5):
        alone = evaluate_batch(design, keys, values[row : row + 1], metrics=METRICS)
        assert same(together, alone, np.array([row]))


def test_thousands_of_rows_are_built_like_a_few() -> None:
    """Many profiles are made on several threads, a few are not."""
    design, keys = case(), ["flexspline.profile.tip_arc_radius", "circular_spline.profile.flank_angle"]
    values = np.array([1.0802, 8.4]) * np.random.default_rng(7).uniform(0.99, 1.01, (1500, 2))
    together = evaluate_batch(design, keys, values, threads=2)
    assert same(together, evaluate_batch(design, keys, values, threads=1))
    for few in (slice(0, 40), slice(700, 740), slice(1460, 1500)):
        assert same(together, evaluate_batch(design, keys, values[few]), np.arange(1500)[few])


def same(batch: Batch, other: Batch, rows: np.ndarray | None = None) -> bool:
    chosen = np.arange(len(batch)) if rows is None else rows
    return np.array_equal(batch.status[chosen], other.status) and all(
        np.array_equal(column[chosen], other.columns[name], equal_nan=True) for name, column in batch.columns.items()
    )


def test_rows_that_differ_in_nothing_that_is_asked() -> None:
    """No part of the geometry varies, and every row still has its results."""
    design = case().replace("wave_generator.bearing_height", 12.0)
    batch = evaluate_batch(design, ["wave_generator.bearing_height"], [[10.0], [-1.0], [11.0]])
    least = analyze(design).min_backlash_um
    assert batch.min_backlash_um.tolist()[::2] == [least, least]
    assert batch.status.tolist() == ["ok", "out-of-range", "ok"]
    assert len(evaluate_batch(design, [], np.empty((2, 0)))) == 2


def test_an_optional_number_that_the_design_leaves_out_can_vary() -> None:
    batch = evaluate_batch(case(), ["flexspline.neutral_radius"], [[79.8], [79.9], [90.0]])
    assert batch.status.tolist() == ["ok", "ok", "neutral-circle-too-large"]
    for row in range(3):
        assert_row_is_its_design(batch, row)


@pytest.mark.parametrize("threshold_um", [0.1, 0.7, 3.0, 7.3, 10.0, 1e-5])
def test_the_threshold_is_compared_in_micrometres(threshold_um: float) -> None:
    """A gap that is the threshold itself does not count as below it; the next greater threshold counts it."""
    design = case("cosine-calibrated")
    gaps = analyze(design).teeth
    at = float(gaps.backlash_um[(gaps.tooth > 0) & (gaps.backlash_um > threshold_um)].min())
    for threshold in (at, math.nextafter(at, math.inf)):
        batch = evaluate_batch(design, ["wave_generator.w0"], [[0.848]], threshold_um=threshold)
        assert batch.teeth_below_per_side[0] == analyze(design, threshold_um=threshold).teeth_below.per_side


def test_no_rows() -> None:
    batch = evaluate_batch(case(), ["wave_generator.w0"], np.empty((0, 1)))
    assert len(batch) == 0
    assert batch.min_backlash_um.shape == (0,)


def test_a_batch_of_impossible_rows() -> None:
    batch = evaluate_batch(case(), ["wave_generator.w0"], [[-1.0], [np.nan]])
    assert batch.status.tolist() == ["out-of-range", "out-of-range"]
    assert np.isnan(batch.min_backlash_um).all()


def test_the_values_and_columns_cannot_be_changed() -> None:
    values = np.array([[0.848]])
    batch = evaluate_batch(case(), ["wave_generator.w0"], values)
    values[0, 0] = 1.0
    assert batch.values[0, 0] == 0.848
    with pytest.raises(ValueError, match="read-only"):
        batch.min_backlash_um[0] = 0.0
