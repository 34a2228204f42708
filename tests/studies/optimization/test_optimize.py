"""What is found meets its requirements, is as good as a grid has it, and is found again."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.batch import evaluate_batch
from strainwave.errors import DesignError, StrainwaveError
from strainwave.studies.optimization import Generation, Optimization, optimize
from tests.designs import case
from tests.studies.optimization.runs import VARY, WITHIN, front, single

WALL = {"wave_generator.w0": (0.80, 0.90), "flexspline.wall_thickness": (1.2, 2.0)}
MANY = {"teeth-below": (30.0, None)}  # the evenness of two teeth is no achievement
ANYTHING = {"minimum-backlash": (-math.inf, None), "tip-clearance": (-math.inf, None)}


def test_the_case_study_as_printed_becomes_what_the_article_describes() -> None:
    """0.5 to 3 µm in motion and at least 39 teeth a side below 10 µm, by the analysis of the design that is found."""
    found = single()
    result = analyze(found.best)
    assert not result.interference
    assert 0.5 <= result.min_in_motion_um <= 3.0
    assert result.teeth_below.per_side >= 39
    assert analyze(case()).interference  # as it began
    w0, offset = found.moved().values()
    assert w0 == found.best.wave_generator.w0 - 0.848
    assert offset == found.best.flexspline.profile.offset


@pytest.mark.parametrize(
    "vary",
    [
        {"wave_generator.w0": (0.8, 0.9), "circular_spline.profile.offset": (-0.02, 0.0)},
        {
            "wave_generator.w0": (0.8, 0.9),
            "flexspline.profile.tip_arc_radius": (1.05, 1.11),
            "flexspline.profile.tip_arc_center[0]": (-0.42, -0.36),
            "flexspline.profile.flank_angle": ("7°", "8°"),
            "circular_spline.profile.flank_angle": (8.0, 9.0),
        },
    ],
    ids=["ring", "profile"],
)
def test_so_it_does_by_other_parameters(vary: dict[str, tuple[float | str, float | str]]) -> None:
    found = optimize(case(), vary, require=WITHIN, seed=3)
    result = analyze(found.best)
    assert 0.5 <= result.min_in_motion_um <= 3.0
    assert result.teeth_below.per_side >= 39
    assert set(found.moved()) == set(vary)
    assert found.generations == 60  # equal counts of teeth in all of a population do not end the search


@pytest.mark.parametrize("search", [single, front])
def test_the_same_seed_finds_the_same_on_one_thread_and_on_two(search: Callable[..., Optimization]) -> None:
    one, two, other = search(threads=1), search(threads=2), search(threads=2, seed=2)
    np.testing.assert_array_equal(one.values, two.values)
    assert one.to_json() == two.to_json()
    assert one.values.tolist() != other.values.tolist()


def test_so_it_does_where_every_digit_counts() -> None:
    one, two, other = (
        optimize(case(), VARY, ["evenness"], MANY, generations=5, seed=seed, threads=threads)
        for seed, threads in ((1, 1), (1, 2), (2, 2))
    )
    np.testing.assert_array_equal(one.values, two.values)
    assert one.values.tolist() != other.values.tolist()


def test_the_best_so_far_gets_no_worse_and_is_the_answer_in_the_end() -> None:
    seen: list[Generation] = []
    found = optimize(case(), VARY, ["evenness"], MANY, generations=12, report=seen.append)
    assert [generation.number for generation in seen] == list(range(1, 13))
    costs = [float(generation.best.costs[0, 0]) for generation in seen if generation.best.feasible[0]]
    assert costs == sorted(costs, reverse=True)
    assert len(set(costs)) > 3
    assert found.figures["evenness"][0] == costs[-1]
    assert seen[-1].best_so_far == f"evenness {costs[-1]:.4g}"
    most = optimize(case(), VARY, ["evenness=max"], MANY, generations=2, report=seen.append)
    assert seen[-1].best_so_far == f"evenness {most.figures['evenness'][0]:.4g}"


def test_a_narrow_requirement_is_found_by_how_much_it_is_missed() -> None:
    """A range of 0.01 ppm, one part in 27,000 of what w0 sweeps over, in 960 designs."""
    narrow = ANYTHING | {"rim-strain": (325.0, 325.01)}
    found = optimize(case(), {"wave_generator.w0": (0.5, 1.2)}, ["rim-strain"], narrow, population=16, seed=5)
    assert 325.0 <= found.figures["rim-strain"][0] <= 325.01


def test_a_front_meets_a_narrow_requirement_in_all_its_designs() -> None:
    seen: list[Generation] = []
    narrow = ANYTHING | {"rim-strain": (325.0, 325.1)}
    vary = {"wave_generator.w0": (0.5, 1.2), "flexspline.wall_thickness": (1.2, 2.0)}
    found = optimize(case(), vary, ["rim-strain", "tip-clearance"], narrow, population=16, seed=5, report=seen.append)
    assert seen[-1].best.feasible.all()
    assert ((found.figures["rim-strain"] >= 325.0) & (found.figures["rim-strain"] <= 325.1)).all()


def test_no_design_of_a_front_is_better_than_another_in_everything() -> None:
    costs = -np.stack([front().figures["teeth-below"], front().figures["minimum-backlash"]], axis=1)
    assert len(costs) > 5
    for one in costs:
        beaten = (costs <= one).all(axis=1) & (costs < one).any(axis=1)
        assert not beaten.any()
    assert (np.diff(costs[:, 0]) >= 0.0).all()  # sorted by the first objective


def test_a_grid_of_the_ranges_has_little_that_beats_a_front() -> None:
    """Brute force: of 41 x 41 designs, in steps of 2.5 µm of w0 and 0.5 µm of offset, none is better than the front by
    more than a tooth and 0.3 µm together; nor is the front better by a tooth and 0.5 µm than all of them."""
    found = optimize(case(), VARY, ["teeth-below", "minimum-backlash=max"], seed=1)
    w0, offset = np.meshgrid(np.linspace(0.80, 0.90, 41), np.linspace(-0.02, 0.0, 41))
    values = np.stack([w0.ravel(), offset.ravel()], axis=1)
    at_angle_0 = evaluate_batch(case(), list(VARY), values)
    values = values[at_angle_0.min_backlash_um >= 0.0]
    grid = evaluate_batch(case(), list(VARY), values, in_motion=True)
    teeth, minimum = found.figures["teeth-below"], found.figures["minimum-backlash"]
    for row in np.flatnonzero(grid.min_in_motion_um >= 0.0):
        as_good = teeth >= grid.teeth_below_per_side[row] - 1
        assert minimum[as_good].max(initial=-np.inf) >= grid.min_in_motion_um[row] - 0.3
    best = grid.min_in_motion_um[grid.teeth_below_per_side >= teeth.max() - 1].max()
    assert minimum[teeth >= teeth.max() - 1].max() <= best + 0.5


def test_a_smooth_objective_is_driven_to_its_known_optimum() -> None:
    """The rim's strain grows with w0 and with the wall, so the least lies in the corner of both ranges."""
    found = optimize(case(), WALL, ["rim-strain"], ANYTHING, generations=60)
    assert found.values[0] == pytest.approx([0.80, 1.2], abs=1e-4)
    most = optimize(case(), WALL, ["rim-strain=max"], ANYTHING, generations=60)
    assert most.values[0] == pytest.approx([0.90, 2.0], abs=1e-4)


def test_the_answer_is_never_worse_than_the_start() -> None:
    start = case("cosine-calibrated")
    vary = {"module": (0.7, 0.9), "wave_generator.w0": (0.5, 1.2)}  # hardly anything in these ranges is free
    found = optimize(start, vary, ["play"], population=8, generations=1)
    assert found.values.tolist() == [[0.8, 0.848]]
    assert found.start_meets_all


def test_an_answer_that_no_design_in_the_ranges_has_is_refused_with_what_the_nearest_lacks() -> None:
    with pytest.raises(
        StrainwaveError,
        match=r"none of 512 designs .* lacks: minimum-backlash at least 400 µm, not -?[0-9.]+ µm\. Widen",
    ):
        optimize(case(), VARY, require={"minimum-backlash": (400.0, None)}, generations=8)


def test_the_evenness_of_no_teeth_is_no_answer() -> None:
    vary = {"flexspline.profile.offset": (-0.05, -0.04)}  # all teeth clear the threshold
    with pytest.raises(StrainwaveError, match="lacks: evenness, which it does not have"):
        optimize(case(), vary, ["evenness"], generations=1)


def interrupting(after: int) -> Callable[[Generation], None]:
    def report(generation: Generation) -> None:
        if generation.number == after:
            raise KeyboardInterrupt

    return report


@pytest.mark.parametrize("objectives", [["teeth-below"], ["teeth-below", "evenness"]])
def test_an_interrupt_keeps_the_best_so_far(objectives: list[str]) -> None:
    stopped = optimize(case(), VARY, objectives, generations=30, report=interrupting(4))
    short = optimize(case(), VARY, objectives, generations=4)
    assert stopped.interrupted
    assert not short.interrupted
    assert (stopped.generations, stopped.evaluations) == (4, 256)
    np.testing.assert_array_equal(stopped.values, short.values)


def test_an_interrupt_before_anything_is_found_is_an_interrupt() -> None:
    hopeless = {"minimum-backlash": (400.0, None)}
    with pytest.raises(KeyboardInterrupt):
        optimize(case(), VARY, require=hopeless, report=interrupting(2))


def test_all_wrong_ranges_are_reported_together() -> None:
    vary: dict[str, tuple[float | str, float | str]] = {
        "wave_generator.w1": (0.8, 0.9),
        "module": (0.9, 0.8),
        "flexspline.teeth": (200, 210),
        "flexspline.wall_thickness": (-1.0, 2.0),
        "flexspline.profile.flank_angle": ("seven", 8.0),
    }
    with pytest.raises(DesignError) as caught:
        optimize(case(), vary)
    assert [fault.key for fault in caught.value.faults] == list(vary)
    said = str(caught.value)
    assert "module = 0.9 mm: must be below the upper end of its range, 0.8" in said
    assert 'flank_angle = "seven"' in said


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"vary": {}}, "nothing may vary"),
        ({"objectives": []}, "objectives must be a list"),
        ({"objectives": "play"}, "objectives must be a list"),
        ({"objectives": ["beauty"]}, "'beauty' is no figure"),
        ({"objectives": ["play=up"]}, "must end in =min or =max"),
        ({"objectives": ["play", "play=max"]}, "once only"),
        ({"require": {"beauty": (0.0, 1.0)}}, "'beauty' is no figure"),
        ({"require": {"play": (2.0, 1.0)}}, "play must lie from 2 to 1 µm, which nothing does"),
        ({"threshold_um": -1.0}, "positive number of micrometres"),
        ({"threads": -1}, "threads must be"),
        ({"population": 3}, "population must be a whole number from 8"),
        ({"generations": 0}, "generations must be a whole number from 1"),
        ({"seed": -1}, "seed must be a whole number from 0"),
    ],
)
def test_a_wrong_question_is_one_clear_error(changes: dict[str, object], said: str) -> None:
    question: dict[str, object] = {"vary": VARY, "objectives": ["play"]} | changes
    with pytest.raises(StrainwaveError, match=said):
        optimize(case(), **question)  # type: ignore[arg-type]


def test_without_pymoo_several_objectives_say_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pymoo.algorithms.moo.nsga2", None)
    with pytest.raises(StrainwaveError, match=r"need pymoo .* pip install 'strainwave\[opt\]'"):
        optimize(case(), VARY, ["play", "evenness"])
