"""What runs in a job's process."""

from __future__ import annotations

import os
import signal
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any, Literal

from strainwave.errors import StrainwaveError
from strainwave.studio.jobs.limits import Limits

Report = Callable[[float, str], None]
"""Called with the share that is done, from 0 to 1, and with words about it."""
Task = Callable[[Any, Limits, Report], Any]
"""A function of a module; what it takes and gives is plain data."""

SECONDS_BETWEEN_REPORTS = 0.1
STOP = "stop"


@dataclass(frozen=True)
class Message:
    """What a job's process tells the page's."""

    kind: Literal["progress", "done", "stopped", "failed", "broke", "died"]
    value: Any = None


def work(connection: Connection, task: Task, request: Any, limits: Limits) -> None:
    """Do the task and send what comes of it."""
    os.setsid()  # Ctrl-C in the server's terminal is for the server, and whatever the job starts ends with it
    interruption = _Interruption()
    signal.signal(signal.SIGINT, interruption.ask)
    limits.apply()
    threading.Thread(target=_obey, args=(connection,), daemon=True).start()
    connection.send(_outcome(task, request, limits, _Reporter(connection, interruption)))


def _outcome(task: Task, request: Any, limits: Limits, reporter: _Reporter) -> Message:
    try:
        reporter.interruption.allow(True)
        found = task(request, limits, reporter)
        reporter.interruption.allow(False)
        return Message("done", found)
    except KeyboardInterrupt:
        return Message("stopped")
    except StrainwaveError as error:
        return Message("failed", str(error))
    except MemoryError:
        return Message("failed", f"more than {limits.memory} of memory would be needed, and no study here may have it")
    except Exception:
        return Message("broke", traceback.format_exc())


def _obey(connection: Connection) -> None:
    """Wait for the word to stop early; without a page at the other end there is nobody to work for."""
    try:
        while connection.recv() == STOP:
            os.kill(os.getpid(), signal.SIGINT)
    except (EOFError, OSError):
        os._exit(1)


class _Interruption:
    """Ctrl-C that comes once, while the task works, and never in the middle of a message."""

    def __init__(self) -> None:
        self._is_asked = self._is_allowed = self._has_come = False

    def ask(self, *_: object) -> None:
        """The signal's handler."""
        self._is_asked = True
        self._come()

    def allow(self, now: bool) -> None:
        """Whether it may come from now on; one that has been asked for meanwhile comes at once."""
        self._is_allowed = now
        self._come()

    def _come(self) -> None:
        if self._is_asked and self._is_allowed and not self._has_come:
            self._has_come = True
            raise KeyboardInterrupt


class _Reporter:
    """Sends how far the work is, but not more often than somebody reads."""

    def __init__(self, connection: Connection, interruption: _Interruption) -> None:
        self.interruption = interruption
        self._connection = connection
        self._last = 0.0

    def __call__(self, share: float, words: str) -> None:
        now = time.monotonic()
        if now - self._last >= SECONDS_BETWEEN_REPORTS:
            self._last = now
            self.interruption.allow(False)
            self._connection.send(Message("progress", (share, words)))
            self.interruption.allow(True)
