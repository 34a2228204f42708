"""Pictures of tuning and comparison show what their results say."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from matplotlib.axes import Axes

from strainwave.plots.comparison import comparison_figure
from strainwave.plots.tuning import tuning_figure
from strainwave.studies import Comparison, Tuning, compare, tune
from tests.studies.small import small


@cache
def tuned(name: str = "dual-disk-0848-calibrated") -> Tuning:
    return tune(small(name))


@cache
def compared() -> Comparison:
    return compare(small(), ["two-roller"])


def spans(axes: Axes) -> list[tuple[float, float]]:
    found = [patch.get_extents().transformed(axes.transData.inverted()) for patch in axes.patches]
    return [(span.x0, span.x1) for span in found]


def test_windows_are_shaded_where_they_are_in_both_panels() -> None:
    figure = tuning_figure(tuned())
    windows = [(window.from_mm, window.to_mm) for window in tuned().windows]
    assert len(windows) == 1
    for axes in figure.axes:
        np.testing.assert_allclose(spans(axes), windows, rtol=0, atol=1e-9)
    assert figure.axes[0].get_xlim() == (0.1, 0.3)


def test_the_line_is_the_minimum_in_motion_of_the_scan() -> None:
    line = next(each for each in tuning_figure(tuned()).axes[1].get_lines() if each.get_label() == "minimum in motion")
    scan = tuned().scan
    known = np.isfinite(scan.min_in_motion_um)
    np.testing.assert_array_equal(line.get_xydata(), np.stack([scan.w0_mm, scan.min_in_motion_um], axis=-1)[known])


def test_the_best_w0_of_each_goal_is_marked_and_the_own_one_too() -> None:
    axes = tuning_figure(tuned()).axes[1]
    labels = {str(each.get_label()): each for each in axes.get_lines()}
    for goal, choice in tuned().best.items():
        label = next(label for label in labels if label.startswith(goal))
        place = (choice.w0_mm, choice.analysis.min_in_motion_um)
        np.testing.assert_array_equal(labels[label].get_xydata(), [place])
        assert f"w0 {choice.w0_mm:.4f} mm" in label
    own = labels["its own w0, 0.212 mm"]
    assert set(np.asarray(own.get_xdata())) == {0.212}


def test_without_a_window_the_neighbourhood_of_the_greatest_minimum_is_shown() -> None:
    axes = tuning_figure(tuned("cosine")).axes[1]
    scan = tuned("cosine").scan
    assert len(axes.patches) == 0
    greatest_at = scan.w0_mm[int(np.nanargmax(scan.min_in_motion_um))]
    assert axes.get_xlim() == pytest.approx((greatest_at - 0.01, greatest_at + 0.01))


def test_each_generator_has_a_curve_in_each_panel_with_its_minimum_marked() -> None:
    panels = comparison_figure(compared()).axes
    assert [axes.get_title("left") for axes in panels] == ["all at w0 0.212 mm", "each at its own w0, balanced"]
    for axes, setting in zip(panels, ("common", "tuned"), strict=True):
        contenders = compared().at("common" if setting == "common" else "tuned")
        curves = [each for each in axes.get_lines() if ":" in str(each.get_label())]
        marks = [each for each in axes.get_lines() if each.get_marker() == "D"]
        assert len(curves) == len(marks) == len(contenders) == 2
        for contender, curve, mark in zip(contenders, curves, marks, strict=True):
            found = contender.analysis
            assert found is not None
            assert str(curve.get_label()).startswith(f"{contender.label}: {found.design.wave_generator.w0:.4f}, ")
            index, gap_um = np.asarray(curve.get_xydata()).T
            np.testing.assert_allclose(gap_um, found.gap_curve.gap_um(index))
            np.testing.assert_array_equal(mark.get_xydata(), [(found.min_in_motion_index, found.min_in_motion_um)])


def test_generators_of_one_name_have_curves_of_their_own_and_room_for_their_labels() -> None:
    wrapped = {"kind": "dual-disk", "wrap_angle": 13.0}
    figure = comparison_figure(compare(small(), [wrapped, {**wrapped, "neutral_curve": "inextensible"}]))
    figure.draw_without_rendering()
    for axes in figure.axes:
        legend = axes.get_legend()
        assert legend is not None
        assert legend.get_window_extent().width < axes.get_window_extent().width
        curves = [each for each in axes.get_lines() if ":" in str(each.get_label())]
        assert [str(each.get_label()).partition(":")[0] for each in curves] == [
            "cosine", "dual-disk 13° first-order", "dual-disk 13° inextensible",
        ]  # fmt: skip
        assert len({(each.get_color(), each.get_linestyle()) for each in curves}) == 3
