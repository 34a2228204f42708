"""The long work of one page: one job at a time."""

from __future__ import annotations

from typing import Any

from strainwave.errors import StrainwaveError
from strainwave.studio.jobs.job import Job, running_jobs
from strainwave.studio.jobs.limits import Limits
from strainwave.studio.jobs.worker import Report, Task
from strainwave.studio.signal import Signal

# In all windows together: their memory adds up.
MOST_AT_ONCE = 4


class Jobs:
    """Runs one job at a time; knows no widgets."""

    def __init__(self, limits: Limits | None = None) -> None:
        """`limits` are those of each job."""
        self.limits = limits or Limits()
        self.changed = Signal()
        """A job has begun or ended."""
        self._job: Job | None = None
        self._closed = False

    @property
    def running(self) -> str:
        """What is running, in words; empty where nothing is."""
        return self._job.what if self._job else ""

    async def run(self, what: str, task: Task, request: Any, report: Report) -> Any:
        """The result of a task, which another process computes; `report` hears how far it is.

        `what` names it in messages, such as "tuning". StrainwaveError where another job is running, all windows have
        too many, or this one fails; CancelledError where it was called off.
        """
        if self._closed:
            raise StrainwaveError("the page of this study is closed")
        if self._job is not None:
            raise StrainwaveError(f"the {self.running} is still running; wait for its end, or cancel it")
        if running_jobs() >= MOST_AT_ONCE:
            # Among them are those of this window that are just ending.
            running = f"{MOST_AT_ONCE} studies are running in all windows together"
            raise StrainwaveError(f"{running}, and no more may; wait until one of them ends")
        job = self._job = Job(what, task, request, self.limits, report)
        self.changed.emit()
        try:
            return await job.result()
        finally:
            job.cancel()  # of no effect where it has ended
            self._job = None
            self.changed.emit()

    def cancel(self) -> None:
        """End the running job now."""
        if self._job is not None:
            self._job.cancel()

    def stop(self) -> None:
        """Ask the running job for what it has found so far."""
        if self._job is not None:
            self._job.stop()

    def close(self) -> None:
        """End the running job, and let no other begin: the page is gone."""
        self._closed = True
        self.cancel()
