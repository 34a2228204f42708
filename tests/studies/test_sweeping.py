"""Sweeps: every row has the figures of its own analysis, and the boundary of interference lies where it is."""

from __future__ import annotations

import csv
import io
import json
import sys
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.contour import QuadContourSet

from strainwave import Batch, DesignError, StrainwaveError, analyze, evaluate_batch
from strainwave.batch.metrics import COLUMNS
from strainwave.plots.sweep import WORDS, boundaries
from strainwave.studies import Sweep, sweep, tune
from strainwave.studies.sweeping import Axis
from tests.designs import case

W0 = "wave_generator.w0"
OFFSET = "flexspline.profile.offset"
DUAL_DISK = "dual-disk-0848-calibrated"
W0_MM = np.arange(840, 911, 5) / 1000
OFFSETS_MM = [-0.01, -0.0072, -0.004]


@cache
def line() -> Sweep:
    return sweep(case(DUAL_DISK), {W0: W0_MM})


@cache
def plane() -> Sweep:
    return sweep(case(DUAL_DISK), {OFFSET: OFFSETS_MM, W0: W0_MM}, metric="teeth_below_per_side", threshold_um=8.0)


def test_a_line_has_the_figures_of_each_design() -> None:
    found = line()
    assert found.shape == (len(W0_MM),)
    for row, w0 in enumerate(W0_MM):
        expected = analyze(case(DUAL_DISK).replace(W0, float(w0)))
        assert found.values[row] == expected.min_in_motion_um
        assert found.columns["min_backlash_um"][row] == expected.min_backlash_um
        assert found.columns["teeth_below_per_side"][row] == expected.teeth_below.per_side
        assert found.interference[row] == expected.interference


def test_a_map_has_the_figures_of_each_design() -> None:
    found = plane()
    assert found.shape == (len(OFFSETS_MM), len(W0_MM))
    for place in [(0, 0), (0, 14), (1, 7), (2, 3), (2, 14)]:
        changes = {OFFSET: OFFSETS_MM[place[0]], W0: float(W0_MM[place[1]])}
        expected = analyze(case(DUAL_DISK).replace(changes), threshold_um=8.0)
        assert found.values[place] == expected.teeth_below.per_side
        assert found.grid(found.interference)[place] == expected.interference


def test_interference_is_known_also_where_the_minimum_in_motion_was_left_out() -> None:
    values = np.stack([grid.ravel() for grid in np.meshgrid(OFFSETS_MM, W0_MM, indexing="ij")], axis=-1)
    motion = evaluate_batch(case(DUAL_DISK), [OFFSET, W0], values, in_motion=True).min_in_motion_um
    found = plane()
    assert found.interference.tolist() == (motion < 0.0).tolist()
    asked = ~np.isnan(found.columns["min_in_motion_um"])
    assert 0 < asked.sum() < len(found)
    assert found.columns["min_in_motion_um"][asked].tolist() == motion[asked].tolist()


def test_interference_between_whole_teeth_is_found_whatever_the_metric() -> None:
    """Just outside the window of the four rollers, whose tightest place lies between two teeth."""
    found = sweep(case("four-roller-calibrated"), {W0: [0.845, 0.8454]}, metric="teeth_below_per_side")
    assert found.columns["min_backlash_um"].min() > 0.0
    assert found.interference.tolist() == [True, False]


def test_the_boundary_of_a_line_lies_at_the_ends_of_the_tuned_window() -> None:
    """Linear interpolation over 5 um of w0, on a curve that bends by about 0.01 um there."""
    (window,) = tune(case(DUAL_DISK)).windows
    np.testing.assert_allclose(boundaries(line()), [window.from_mm, window.to_mm], rtol=0, atol=2e-4)


def test_the_boundary_of_a_map_is_its_contour() -> None:
    axes = plane().plot().axes[0]
    contour = next(each for each in axes.collections if isinstance(each, QuadContourSet) and not each.filled)
    points = np.concatenate([path.vertices for path in contour.get_paths()])
    for x, y in points[:: len(points) // 5]:
        least = analyze(case(DUAL_DISK).replace({OFFSET: float(y), W0: float(x)})).min_in_motion_um
        assert abs(least) < 0.35  # a cell is 3 um of offset high
    assert {"boundary of interference in motion", "interference in motion", "the design itself"} <= {
        text.get_text() for text in plane().plot().legends[0].get_texts()
    }


def test_a_line_is_shaded_where_teeth_interfere() -> None:
    axes = line().plot().axes[0]
    spans = [patch.get_extents().transformed(axes.transData.inverted()) for patch in axes.patches]
    ends = boundaries(line())
    found = [(span.x0, span.x1) for span in spans]
    np.testing.assert_allclose(found, [(0.84, ends[0]), (ends[1], 0.91)], rtol=0, atol=1e-9)


@pytest.mark.parametrize("metric", [name for name in COLUMNS if name not in ("min_in_motion_um", "min_backlash_um")])
def test_any_metric_of_a_batch(metric: str) -> None:
    values = [[0.86], [0.87]]
    in_motion = metric.startswith("min_in_motion")
    batch = evaluate_batch(case(DUAL_DISK), [W0], values, metrics=[] if in_motion else [metric], in_motion=in_motion)
    found = sweep(case(DUAL_DISK), {W0: [0.86, 0.87]}, metric=metric)
    np.testing.assert_array_equal(found.values, batch.columns[metric])
    assert metric in WORDS
    found.plot()


def test_rows_that_are_no_gear_have_no_value_and_are_not_counted_as_interference() -> None:
    found = sweep(case(DUAL_DISK), {W0: [0.88, 30.0]})
    assert found.status.tolist() == ["ok", "curve-not-simple"]
    assert found.interference.tolist() == [False, False]
    record = found.as_dict()["columns"]
    assert record["interference"] == [False, None]
    assert record["min_in_motion_um"][1] is None
    found.plot()


def test_json_and_csv_hold_every_row() -> None:
    found = plane()
    record = json.loads(found.to_json())
    assert [axis["key"] for axis in record["axes"]] == [OFFSET, W0]
    assert [axis["unit"] for axis in record["axes"]] == ["mm", "mm"]
    assert record["columns"]["teeth_below_per_side"] == [int(value) for value in found.values.ravel()]
    assert record["columns"]["status"] == ["ok"] * len(found)


def test_csv_rows_carry_their_parameters(tmp_path: Path) -> None:
    plane().to_csv(tmp_path / "rows.csv")
    rows = list(csv.DictReader(io.StringIO((tmp_path / "rows.csv").read_text(encoding="utf-8"))))
    assert len(rows) == len(plane())
    first, last = rows[0], rows[-1]
    assert (float(first[OFFSET]), float(first[W0])) == (-0.01, 0.84)
    assert (float(last[OFFSET]), float(last[W0])) == (-0.004, 0.91)
    assert int(last["teeth_below_per_side"]) == plane().values[-1, -1]


def test_one_thread_and_two_find_the_same() -> None:
    one, two = (sweep(case(DUAL_DISK), {W0: W0_MM}, threads=threads) for threads in (1, 2))
    assert one.to_json() == two.to_json()


@pytest.mark.parametrize("metric", ["min_in_motion_um", "min_backlash_um"])
def test_the_parts_in_which_rows_are_computed_do_not_show(metric: str, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = sweep(case(DUAL_DISK), {W0: W0_MM}, metric=metric)
    module = sys.modules["strainwave.studies.sweeping.sweep"]
    monkeypatch.setattr(module, "ROWS_AT_ONCE", 4)
    monkeypatch.setattr(module, "ROWS_IN_MOTION_AT_ONCE", 4)
    seen: list[tuple[int, int]] = []
    parts = sweep(case(DUAL_DISK), {W0: W0_MM}, metric=metric, progress=lambda *done: seen.append(done))
    assert parts.to_json() == whole.to_json()
    assert seen == [(4, 15), (8, 15), (12, 15), (15, 15)]


def test_ctrl_c_keeps_the_rows_that_are_finished(monkeypatch: pytest.MonkeyPatch) -> None:
    module = sys.modules["strainwave.studies.sweeping.sweep"]
    monkeypatch.setattr(module, "ROWS_IN_MOTION_AT_ONCE", 4)
    calls = 0

    def interrupted_at_the_third(*arguments: Any, **options: Any) -> Batch:
        nonlocal calls
        calls += 1
        if calls == 3:
            raise KeyboardInterrupt
        return evaluate_batch(*arguments, **options)

    monkeypatch.setattr(module, "evaluate_batch", interrupted_at_the_third)
    found = sweep(case(DUAL_DISK), {W0: W0_MM})
    assert found.interrupted
    assert found.status.tolist() == ["ok"] * 8 + ["not-computed"] * 7
    assert found.values[:8].tolist() == line().values[:8].tolist()
    assert np.isnan(found.values[8:]).all()
    found.plot()


def test_ctrl_c_before_anything_is_finished_is_an_interrupt(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any, **__: Any) -> Batch:
        raise KeyboardInterrupt

    monkeypatch.setattr(sys.modules["strainwave.studies.sweeping.sweep"], "evaluate_batch", interrupted)
    with pytest.raises(KeyboardInterrupt):
        sweep(case(), {W0: [0.848]})


@pytest.mark.parametrize(
    ("axes", "metric", "said"),
    [
        ({}, "min_backlash_um", "one number of the design, or two"),
        ({W0: [0.8], "module": [0.8], OFFSET: [0.0]}, "min_backlash_um", "one number of the design, or two"),
        ({W0: [0.8]}, "backlash", "the metric must be one of min_backlash_um"),
        ({W0: []}, "min_backlash_um", "finite numbers that rise"),
        ({W0: [0.9, 0.8]}, "min_backlash_um", "finite numbers that rise"),
        ({W0: [0.9, float("nan")]}, "min_backlash_um", "finite numbers that rise"),
        ({W0: "much"}, "min_backlash_um", "finite numbers that rise"),
        ({W0: np.arange(1, 1102), OFFSET: np.arange(1000)}, "min_backlash_um", "1101000 rows are more than 1000000"),
        ({W0: np.arange(100_000), OFFSET: np.arange(100_000)}, "min_backlash_um", "10000000000 rows are more"),
        ({"name": [1.0]}, "min_backlash_um", "is not a number"),
        ({"flexspline.teeth": [200]}, "min_backlash_um", "cannot vary in a batch"),
        ({"wave_generator.w1": [1.0]}, "min_backlash_um", "w1"),
    ],
)
def test_wrong_questions(axes: dict[str, Any], metric: str, said: str) -> None:
    with pytest.raises(StrainwaveError, match=said):
        sweep(case(), axes, metric=metric)


def test_words_name_the_threshold() -> None:
    assert plane().plot().axes[-1].get_ylabel() == "teeth per side below 8 µm"  # of the colour bar


def test_values_between_two_ends() -> None:
    axis = Axis.between(case(), W0, "0.84", "0.91", 71)
    assert axis.values.tolist() == [round(0.84 + 0.001 * step, 3) for step in range(71)]
    angle = Axis.between(case(), "flexspline.profile.flank_angle", "7°30'", 8.0, 3)
    assert angle.values.tolist() == [7.5, 7.75, 8.0]
    with pytest.raises(DesignError, match="must be a number from"):
        Axis.between(case(), W0, "low", "0.9", 3)
    with pytest.raises(DesignError, match=r"w0 = 2000000\.0 mm: must be a number from .* as an end of its range"):
        Axis.between(case(), W0, "0.8", "2e6", 3)
    with pytest.raises(DesignError, match=r"w0 = 0\.9 mm: must be below the other end of its range, 0\.8"):
        Axis.between(case(), W0, 0.9, 0.8, 3)
    with pytest.raises(StrainwaveError, match="from 1 to 100000, not 0"):
        Axis.between(case(), W0, "0.8", "0.9", 0)
