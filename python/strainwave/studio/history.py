"""Steps back and forth."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from strainwave.design import Design

MOST_STEPS = 200
# Changes of one number that follow each other as fast as a slider's are one step.
SAME_STEP_S = 0.8


@dataclass
class _Step:
    design: Design
    what: str
    at_s: float


class History:
    """The designs of a session in the order in which they were shown, and which of them is."""

    def __init__(self, design: Design, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._steps = [_Step(design, "", clock())]
        self._place = 0

    @property
    def design(self) -> Design:
        """The one in which the session stands."""
        return self._steps[self._place].design

    @property
    def can_undo(self) -> bool:
        """Whether there is one before it."""
        return self._place > 0

    @property
    def can_redo(self) -> bool:
        """Whether there is one after it."""
        return self._place + 1 < len(self._steps)

    def add(self, design: Design, what: str) -> None:
        """A new design after the present one; `what` has changed, and is "" for what is a step of its own."""
        if design == self.design:
            return
        now, last = self._clock(), self._steps[self._place]
        del self._steps[self._place + 1 :]
        if what and what == last.what and now - last.at_s < SAME_STEP_S:
            last.design, last.at_s = design, now
            return
        self._steps = [*self._steps, _Step(design, what, now)][-MOST_STEPS:]
        self._place = len(self._steps) - 1

    def undo(self) -> Design:
        """The design before, where there is one."""
        self._place = max(self._place - 1, 0)
        self._steps[self._place].what = ""
        return self.design

    def redo(self) -> Design:
        """The design after, where there is one."""
        self._place = min(self._place + 1, len(self._steps) - 1)
        return self.design
