"""One piece of long work in a process of its own."""

from __future__ import annotations

import asyncio
import logging
import multiprocessing
import os
import signal
import threading
from contextlib import suppress
from functools import cache
from multiprocessing.connection import wait
from multiprocessing.context import ForkServerContext
from typing import Any

from strainwave.errors import StrainwaveError
from strainwave.studio.jobs.limits import Limits
from strainwave.studio.jobs.main_module import nowhere_main
from strainwave.studio.jobs.worker import STOP, Message, Report, Task, work

# What jobs need, imported once by the process from which theirs are copied.
PRELOADED = ("strainwave.studio.jobs.preloaded",)
# multiprocessing looks after all processes whenever one is started, which no two threads may do at once.
_ONE_AT_A_TIME = threading.Lock()
_log = logging.getLogger(__name__)


class CancelledError(StrainwaveError):
    """The job was called off."""


class _Attendant(threading.Thread):
    """The thread of a job."""


def _attendants() -> list[_Attendant]:
    return [thread for thread in threading.enumerate() if isinstance(thread, _Attendant)]


def running_jobs() -> int:
    """How many there are in all windows, those included that are just ending."""
    return len(_attendants())


def wait_for_ended_jobs(seconds: float) -> None:
    """Let jobs that were called off leave nothing behind: for the end of a server, which multiprocessing tidies too."""
    for thread in _attendants():
        thread.join(seconds)


class Job:
    """A task in a process of its own, from its start to its answer. Used on the event loop only.

    A thread starts the process and listens to it, for both can block.
    """

    def __init__(self, what: str, task: Task, request: Any, limits: Limits, report: Report) -> None:
        """`what` names it in messages; `report` is called on the event loop."""
        self.what = what
        self._limits = limits
        self._report = report
        self._loop = asyncio.get_running_loop()
        self._answer: asyncio.Future[Any] = self._loop.create_future()
        self._ours, self._its = _context().Pipe()
        self._process = _context().Process(target=work, args=(self._its, task, request, limits), daemon=True)
        self._lock = threading.Lock()
        self._called_off = False
        self._pid: int | None = None
        """Of the process while it may be killed; this and the last one are guarded by the lock."""
        self._timer = self._loop.call_later(limits.seconds, self._overdue)
        self._thread = _Attendant(target=self._run, name=what, daemon=True)
        self._thread.start()

    async def result(self) -> Any:
        """What the task gives. StrainwaveError where it fails, CancelledError where it was called off."""
        return await asyncio.shield(self._answer)

    def cancel(self) -> None:
        """End it now, without an answer."""
        self._fail(CancelledError(f"the {self.what} was cancelled"))

    def stop(self) -> None:
        """Ask it for what it has so far, as Ctrl-C does on the command line."""
        with suppress(OSError):  # it has ended meanwhile
            self._ours.send(STOP)

    def _overdue(self) -> None:
        self._fail(StrainwaveError(f"the {self.what} took more than {self._limits.time} and was ended; ask for less"))

    def _fail(self, error: StrainwaveError) -> None:
        """Give this error instead of an answer, and see to it that nothing goes on."""
        self._timer.cancel()
        if not self._answer.done():
            self._answer.set_exception(error)
            self._answer.exception()  # which nobody need look at
        with self._lock:
            self._called_off = True
            self._kill()

    def _kill(self) -> None:
        """End the process and all that it has started, where there is any; under the lock."""
        if self._pid is not None:
            for kill in (os.killpg, os.kill):  # it becomes a group of its own a little after its start
                with suppress(ProcessLookupError):
                    kill(self._pid, signal.SIGKILL)

    def _hear(self, message: Message) -> None:
        if self._answer.done():
            return
        match message.kind:
            case "progress":
                self._report(*message.value)
            case "done":
                self._timer.cancel()
                self._answer.set_result(message.value)
            case "stopped":
                self._fail(CancelledError(f"the {self.what} was stopped before it had found anything"))
            case "failed":
                self._fail(StrainwaveError(message.value))
            case "died":
                self._fail(StrainwaveError(f"the {self.what} ended without an answer: it was killed, or ran out of "
                                           f"memory, of which it may have {self._limits.memory}"))  # fmt: skip
            case "broke":
                _log.error("the %s broke:\n%s", self.what, message.value)
                why = message.value.strip().rpartition("\n")[2]
                self._fail(StrainwaveError(f"the {self.what} broke, which it should not: {why}"))

    # All below runs in the job's thread.

    def _run(self) -> None:
        try:
            self._start()
            self._listen()
        except OSError as error:
            self._tell(Message("failed", f"the {self.what} could not be started: {error}"))
        finally:
            self._its.close()
            self._bury()
            self._ours.close()

    def _start(self) -> None:
        """Start the process, outside the lock for it takes its time; end it if the job was called off meanwhile."""
        with _ONE_AT_A_TIME, nowhere_main():
            self._process.start()
        self._its.close()
        with self._lock:
            self._pid = self._process.pid
            if self._called_off:
                self._kill()

    def _listen(self) -> None:
        message = Message("progress")
        try:
            while message.kind == "progress":
                message = self._ours.recv()
                self._tell(message)
        except (EOFError, OSError):
            self._tell(Message("died"))

    def _tell(self, message: Message) -> None:
        with suppress(RuntimeError):  # the event loop is closed: the server ends
            self._loop.call_soon_threadsafe(self._hear, message)

    def _bury(self) -> None:
        """Wait for the end of the process and leave nothing of it."""
        if self._pid is None:
            return
        wait([self._process.sentinel])
        with self._lock:
            self._pid = None
        with _ONE_AT_A_TIME:
            self._process.join()
            self._process.close()


@cache
def _context() -> ForkServerContext:
    """Processes are copied from one that has imported what they need, and has neither threads nor a page."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(list(PRELOADED))
    return context
