"""What a job may take."""

from __future__ import annotations

import os
import resource
from dataclasses import dataclass

# Politeness to the page: its analyses come before those of a study.
NICENESS = 10
GIB = 2**30


@dataclass(frozen=True)
class Limits:
    """Bounds of one job."""

    seconds: float = 600.0
    memory_bytes: int = 3 * GIB
    threads: int = max(1, (os.cpu_count() or 1) - 1)
    """Cores that the kernel may use, so that one is left for the page."""

    def apply(self) -> None:
        """Bound this process's memory and step behind the page's own work.

        The limit is on what a process can write to (since Linux 4.7 every private mapping), not on its addresses, of
        which the allocators of many threads reserve far more than they use.
        """
        _, hard = resource.getrlimit(resource.RLIMIT_DATA)
        bound = self.memory_bytes if hard == resource.RLIM_INFINITY else min(self.memory_bytes, hard)
        resource.setrlimit(resource.RLIMIT_DATA, (bound, bound))
        os.nice(NICENESS)

    @property
    def memory(self) -> str:
        """The bound of the memory in words."""
        return f"{self.memory_bytes / GIB:.3g} GiB"

    @property
    def time(self) -> str:
        """The bound of the time in words."""
        return f"{self.seconds / 60.0:.3g} minutes" if self.seconds >= 60.0 else f"{self.seconds:.3g} s"
