"""Tasks for jobs to do, which a job's process imports from here."""

from __future__ import annotations

import os
import signal
import time
from typing import Any

import numpy as np

from strainwave.errors import StrainwaveError
from strainwave.studio.jobs import Limits, Report
from strainwave.studio.jobs.worker import SECONDS_BETWEEN_REPORTS

FOREVER_S = 600.0


def count(request: int, limits: Limits, report: Report) -> list[int]:
    """Count, telling every number."""
    for number in range(request):
        report(number / request, f"{number} of {request}")
        time.sleep(1.05 * SECONDS_BETWEEN_REPORTS)
    return list(range(request))


def chatter(request: int, limits: Limits, report: Report) -> None:
    """Tell more than anybody can read."""
    for number in range(request):
        report(number / request, "")


def who(request: Any, limits: Limits, report: Report) -> tuple[int, int]:
    """The process and the one from which it was copied."""
    return os.getpid(), os.getppid()


def last_forever(request: Any, limits: Limits, report: Report) -> None:
    """Tell who is at it, and never end."""
    report(0.0, str(os.getpid()))
    time.sleep(FOREVER_S)


def keep_what_there_is(request: Any, limits: Limits, report: Report) -> str:
    """What a study does that can be interrupted."""
    try:
        last_forever(request, limits, report)
    except KeyboardInterrupt:
        return "half"
    return "all"


def fail(request: str, limits: Limits, report: Report) -> None:
    """End with the study's own message."""
    raise StrainwaveError(request)


def break_down(request: Any, limits: Limits, report: Report) -> None:
    """End as no task should."""
    raise ZeroDivisionError("the number was 0")


def fill_memory(request: int, limits: Limits, report: Report) -> int:
    """Need so many bytes."""
    return int(np.ones(request, dtype=np.uint8).sum())


def crash(request: Any, limits: Limits, report: Report) -> None:
    """End as a process does in which memory runs out below Python."""
    os.kill(os.getpid(), signal.SIGABRT)


def politeness(request: Any, limits: Limits, report: Report) -> int:
    """How nice the process is."""
    return os.nice(0)
