"""Steps back and forth, on a clock of the test's own."""

from __future__ import annotations

from strainwave.design import Design
from strainwave.studio.history import MOST_STEPS, SAME_STEP_S, History
from tests.designs import case


class Clock:
    """Time that passes when it is told to."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


def with_w0(w0: float) -> Design:
    return case().replace("wave_generator.w0", w0)


def begun() -> tuple[History, Clock]:
    clock = Clock()
    return History(case(), clock), clock


def back_to_the_start(history: History) -> list[Design]:
    """The designs on the way back, the present one first."""
    passed = [history.design]
    while history.can_undo:
        passed.append(history.undo())
    return passed


def test_it_starts_with_nowhere_to_go() -> None:
    history, _ = begun()
    assert (history.can_undo, history.can_redo) == (False, False)
    assert history.undo() == history.redo() == history.design == case()


def test_undo_and_redo_walk_through_what_was_shown() -> None:
    history, _ = begun()
    history.add(with_w0(0.85), "")
    history.add(with_w0(0.86), "")
    assert history.undo() == with_w0(0.85)
    assert history.undo() == case()
    assert not history.can_undo
    assert history.redo() == with_w0(0.85)
    assert history.redo() == with_w0(0.86)
    assert not history.can_redo


def test_a_change_after_undo_takes_the_place_of_what_was_undone() -> None:
    history, _ = begun()
    history.add(with_w0(0.85), "")
    history.undo()
    history.add(with_w0(0.87), "")
    assert not history.can_redo
    assert back_to_the_start(history) == [with_w0(0.87), case()]


def test_changes_of_one_number_in_quick_succession_are_one_step() -> None:
    history, clock = begun()
    for place in range(10):
        clock.now_s += 0.9 * SAME_STEP_S
        history.add(with_w0(0.85 + 0.001 * place), "wave_generator.w0")
    assert back_to_the_start(history) == [with_w0(0.85 + 0.009), case()]


def test_a_pause_another_number_and_a_step_of_its_own_begin_a_new_step() -> None:
    history, clock = begun()
    history.add(with_w0(0.85), "wave_generator.w0")
    clock.now_s += 1.1 * SAME_STEP_S
    history.add(with_w0(0.86), "wave_generator.w0")
    history.add(with_w0(0.86).replace("module", 0.81), "module")
    history.add(with_w0(0.87), "")
    history.add(with_w0(0.88), "")
    assert len(back_to_the_start(history)) == 6


def test_what_was_gone_back_to_is_not_overwritten_by_a_slider() -> None:
    history, _ = begun()
    history.add(with_w0(0.85), "wave_generator.w0")
    history.add(with_w0(0.86), "")
    history.undo()
    history.add(with_w0(0.87), "wave_generator.w0")
    assert back_to_the_start(history) == [with_w0(0.87), with_w0(0.85), case()]


def test_the_same_design_again_is_no_step() -> None:
    history, _ = begun()
    history.add(case(), "wave_generator.w0")
    assert not history.can_undo


def test_the_oldest_steps_are_forgotten() -> None:
    history, _ = begun()
    designs = [with_w0(0.8 + 0.0001 * place) for place in range(MOST_STEPS + 20)]
    for design in designs:
        history.add(design, "")
    assert back_to_the_start(history) == designs[: -MOST_STEPS - 1 : -1]
