"""Windows of w0 against a brute scan that shares nothing with the certificate; goals against their definitions."""

from __future__ import annotations

import csv
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.typing import NDArray

from strainwave import DesignError, StrainwaveError, analyze
from strainwave.design import Design, load
from strainwave.geometry import Geometry
from strainwave.studies import Tuning, tune
from strainwave.studies.tuning import GOALS
from strainwave.studies.tuning.window import windows_of
from tests.designs import CASE_STUDY, case
from tests.studies.small import WILD, small

W0 = "wave_generator.w0"
CALIBRATED = ["cosine-calibrated", "four-roller-calibrated", "dual-disk-0848-calibrated"]
FRACTIONAL_TEETH = 2000
END_MM = 1e-6


@cache
def tuned(name: str) -> Tuning:
    return tune(case(name))


def sampled_minimum_um(design: Design, w0: float, index: NDArray[np.float64]) -> tuple[float, float]:
    """The least gap at some tooth indices, and the index that has it; no certificate takes part."""
    gap = Geometry.of(design.replace(W0, w0)).engagement.clearances(index).gap.min(axis=-1)
    return float(gap.min()) * 1e3, float(index[gap.argmin()])


def close_minimum_um(design: Design, w0: float) -> float:
    """The same, sampled again about the least, down to 1e-7 of a tooth: good to 1e-5 um also where it is a corner of
    the curve, with 100 um per tooth beside it."""
    quarter = design.flexspline.teeth / 4
    least, place = sampled_minimum_um(design, w0, np.linspace(0.0, quarter, FRACTIONAL_TEETH))
    for around in (0.1, 1e-3, 1e-5):
        near = np.clip(place + np.linspace(-around, around, 201), 0.0, quarter)
        least, place = sampled_minimum_um(design, w0, near)
    return least


@pytest.mark.parametrize("name", [*CALIBRATED, "cosine"])
def test_windows_agree_with_a_brute_scan(name: str) -> None:
    """w0 in steps of 1 um, 2,000 fractional teeth. Between two of them the gap is at most 0.001 um less.

    Where one in forty of the teeth shows interference, the others are not asked.
    """
    design, found = case(name), tuned(name)
    index = np.linspace(0.0, 51.0, FRACTIONAL_TEETH)
    for w0 in np.arange(400, 1201) / 1000:
        minimum, _ = sampled_minimum_um(design, float(w0), index[::40])
        if minimum >= -0.001:
            minimum, _ = sampled_minimum_um(design, float(w0), index)
        inside = any(w0 in window for window in found.windows)
        assert inside == (minimum >= 0.0) or abs(minimum) < 0.001, w0
    assert bool(found.windows) == (name != "cosine")


@pytest.mark.parametrize("name", CALIBRATED)
def test_the_sign_of_the_minimum_changes_at_each_end(name: str) -> None:
    for window in tuned(name).windows:
        assert (window.from_is_limit, window.to_is_limit) == (False, False)
        for end, outwards in ((window.from_mm, -1.0), (window.to_mm, 1.0)):
            assert close_minimum_um(case(name), end) >= 0.0
            assert close_minimum_um(case(name), end - outwards * END_MM) > 0.0
            assert close_minimum_um(case(name), end + outwards * END_MM) < 0.0


def test_the_sign_changes_also_at_a_corner_of_the_gap_curve() -> None:
    """Involute flanks: at the lower end the minimum is a corner of the gap curve, where one contact takes over."""
    design = load(CASE_STUDY.parent / "involute" / "cosine.toml")
    (window,) = tune(design).windows
    for end, outwards in ((window.from_mm, -1.0), (window.to_mm, 1.0)):
        assert close_minimum_um(design, end) >= 0.0
        assert close_minimum_um(design, end + outwards * END_MM) < 0.0


def test_the_dual_disk_that_interferes_becomes_viable_by_w0_alone() -> None:
    """The article's finding: interference at 0.848 mm, none at 0.9 mm."""
    found = tuned("dual-disk-0848-calibrated")
    assert found.own is not None
    assert found.own.interference
    (window,) = found.windows
    assert 0.848 not in window
    assert 0.9 in window
    for goal in GOALS:
        assert not analyze(found.design_for(goal)).interference


def test_as_printed_no_w0_serves() -> None:
    found = tuned("cosine")
    assert (found.windows, dict(found.best)) == ((), {})
    assert found.verdict == "NO WINDOW: teeth interfere at every w0 from 0.4 to 1.2 mm"
    with pytest.raises(StrainwaveError, match=r"no w0 keeps a minimum of 0\.1 µm in motion: NO WINDOW"):
        found.design_for("power")


def test_without_a_window_the_nearest_row_is_known_in_motion() -> None:
    scan = tuned("cosine").scan
    nearest = int(np.nanargmax(scan.min_backlash_um))
    found = analyze(case("cosine").replace(W0, float(scan.w0_mm[nearest])))
    assert scan.min_in_motion_um[nearest] == pytest.approx(found.min_in_motion_um, abs=1.0)
    assert nearest == int(np.nanargmax(scan.min_in_motion_um))


@pytest.mark.parametrize("name", ["cosine-calibrated", "dual-disk-0848-calibrated"])
def test_each_goal_is_best_among_all_w0_with_the_margin(name: str) -> None:
    found = tuned(name)
    (window,) = found.windows
    rows = [analyze(case(name).replace(W0, w0)) for w0 in np.arange(400, 1201) / 1000 if w0 in window]
    rows = [row for row in rows if row.min_in_motion_um >= 0.1]
    close = [row.teeth.backlash_um[(row.teeth.backlash_um >= 0.0) & (row.teeth.backlash_um < 10.0)] for row in rows]

    power = found.best["power"]
    most = max(row.teeth_below.per_side for row in rows)
    assert power.analysis.teeth_below.per_side == most
    spreads = [gaps.std() for row, gaps in zip(rows, close, strict=True) if row.teeth_below.per_side == most]
    assert power.evenness_um <= min(spreads) + 1e-9

    precision = found.best["precision"].analysis
    assert 0.1 <= precision.min_in_motion_um < 0.101
    assert precision.min_in_motion_index < 3.0  # the other end of the window has it beyond 35

    balanced = found.best["balanced"].analysis
    product = balanced.min_in_motion_um * balanced.teeth_below.per_side
    assert product >= max(row.min_in_motion_um * row.teeth_below.per_side for row in rows) - 1e-9


def test_every_choice_keeps_the_margin() -> None:
    found = tune(small(), margin_um=1.25, threshold_um=2.0)
    for choice in found.best.values():
        assert choice.analysis.in_motion.lower_bound_um > 1.25 - 0.001
        assert choice.analysis.threshold_um == 2.0
    assert found.best["precision"].analysis.min_in_motion_um == pytest.approx(1.25, abs=0.002)
    assert dict(tune(small(), margin_um=1.75).best) == {}


def test_a_window_may_go_on_beyond_the_search() -> None:
    """Low teeth with flanks cut far back."""
    changes = {"flexspline.profile.addendum": 0.4, "circular_spline.profile.addendum": 0.4}
    loose = small().replace({**changes, "flexspline.profile.offset": -0.05, "circular_spline.profile.dedendum": 1.6})
    (window,) = tune(loose).windows
    assert (window.from_is_limit, window.to_is_limit) == (True, True)
    assert (window.from_mm, window.to_mm) == (0.1, 0.3)
    assert close_minimum_um(loose, 0.1) > 0.0


def test_every_window_of_a_minimum_with_known_zeros(monkeypatch: pytest.MonkeyPatch) -> None:
    """A minimum of 2 sin(20 w0) um: zeros at multiples of pi / 20 = 0.15708 mm."""

    def minimum(w0: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(2.0 * np.sin(20.0 * w0))

    def motion_at(_design: Design, w0_mm: float, _certified_to_um: float) -> SimpleNamespace:
        return SimpleNamespace(lower_bound=float(minimum(np.asarray(w0_mm))) / 1e3)

    scan = tuned("cosine").scan
    known = replace(scan, min_in_motion_um=minimum(scan.w0_mm), lower_bound_um=minimum(scan.w0_mm) - 1e-3)
    monkeypatch.setattr("strainwave.studies.tuning.window.motion_at", motion_at)
    found = windows_of(known)
    zeros = np.arange(3, 8) * np.pi / 20.0
    ends = [(window.from_mm, window.to_mm) for window in found]
    np.testing.assert_allclose(ends, [(0.4, zeros[0]), (zeros[1], zeros[2]), (zeros[3], zeros[4])], rtol=0, atol=1e-6)
    assert [(window.from_is_limit, window.to_is_limit) for window in found] == [
        (True, False),
        (False, False),
        (False, False),
    ]
    for window in found:
        assert minimum(np.array([window.from_mm, window.to_mm])).min() >= 0.0
    assert found[1].greatest_um == pytest.approx(2.0, abs=1e-3)
    assert found[1].greatest_at_mm == pytest.approx(4.5 * np.pi / 20.0, abs=1e-3)


def test_rows_that_are_no_gear_belong_to_no_window() -> None:
    """The disk's radius can be wrapped at some w0 only."""
    design = small("dual-disk-0848-calibrated").replace(
        {"wave_generator.wrap_angle": None, "wave_generator.disk_radius": 77.8 / 4}
    )
    found = tune(design)
    assert set(found.scan.status.tolist()) == {"ok", "disk-radius-out-of-reach"}
    for window in found.windows:
        assert found.scan.possible[(found.scan.w0_mm >= window.from_mm) & (found.scan.w0_mm <= window.to_mm)].all()


def test_a_design_that_is_no_gear_whatever_its_w0() -> None:
    with pytest.raises(DesignError, match=r"flexspline\.profile\.addendum"):
        tune(case().replace("flexspline.profile.addendum", 5.0))


def test_a_range_without_a_gear() -> None:
    """The disk's radius can be wrapped at a w0 below the range only."""
    changes = {"wave_generator.wrap_angle": None, "wave_generator.disk_radius": 19.8, W0: 0.07}
    with pytest.raises(StrainwaveError, match=r"no w0 from 0\.1 to 0\.3 mm makes a gear \(disk-radius-out-of-reach\)"):
        tune(small("dual-disk-0848-calibrated").replace(changes))


def test_a_range_without_a_gear_about_the_own_w0() -> None:
    """No fault of the own w0 alone, so the message blames none."""
    with pytest.raises(StrainwaveError, match=r"^no w0 from 0\.1 to 0\.3 mm makes a gear \(perimeter-not-kept\)"):
        tune(small().replace("wave_generator", {**WILD, "w0": 0.212}))


def test_an_own_w0_that_makes_no_gear_does_not_stop_the_search() -> None:
    found = tune(case("cosine-calibrated").replace(W0, 30.0))
    assert found.own is None
    assert found.windows == tuned("cosine-calibrated").windows


@pytest.mark.parametrize(("option", "value"), [("margin_um", -0.1), ("margin_um", float("nan")), ("threshold_um", 0.0)])
def test_wrong_numbers(option: str, value: float) -> None:
    with pytest.raises(StrainwaveError, match="number of micrometres"):
        tune(case(), **{option: value})  # type: ignore[arg-type]


def test_the_goal_must_be_known() -> None:
    with pytest.raises(StrainwaveError, match="one of power, precision, balanced, not 'speed'"):
        tuned("cosine").design_for("speed")  # type: ignore[arg-type]


def test_one_thread_and_two_find_the_same() -> None:
    one, two = (tune(small("four-roller-calibrated"), threads=threads) for threads in (1, 2))
    assert one.to_json() == two.to_json()
    assert one.scan.csv_text() == two.scan.csv_text()


def test_intervals_above_a_level_lie_within_the_windows() -> None:
    found = tuned("cosine-calibrated")
    (window,), (higher,) = found.windows, windows_of(found.scan, 3.0)
    assert window.from_mm < higher.from_mm < higher.to_mm < window.to_mm
    for end in (higher.from_mm, higher.to_mm):
        assert close_minimum_um(found.design, end) == pytest.approx(3.0, abs=2e-3)


def test_the_scan_as_csv(tmp_path: Path) -> None:
    found = tuned("cosine-calibrated")
    found.to_csv(tmp_path / "scan.csv")
    with (tmp_path / "scan.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 801
    at = next(row for row in rows if row["w0_mm"] == "0.85")
    expected = analyze(case("cosine-calibrated").replace(W0, 0.85))
    assert float(at["min_in_motion_um"]) == expected.min_in_motion_um
    assert float(at["min_backlash_um"]) == expected.min_backlash_um
    assert float(at["teeth_below_per_side"]) == expected.teeth_below.per_side
    assert rows[1]["min_in_motion_um"] == ""  # whole teeth interfere there, so its sign is known


def test_progress_reaches_the_end() -> None:
    seen: list[tuple[int, int]] = []
    tune(small(), progress=lambda done, total: seen.append((done, total)))
    assert seen[-1] == (201, 201)
