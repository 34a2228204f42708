"""Chunks in threads of this process. The kernel and pyarrow hold no lock of Python's, so that they fill all cores."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice

from strainwave.studies.exploration.study_folder import StudyFolder
from strainwave.studies.exploration.worker import compute

# Chunks that are handed out for each thread: one in work, one to go on with.
CHUNKS_AHEAD = 2


def run_in_threads(folder: StudyFolder, chunks: Iterator[int], threads: int, report: Callable[[int], None]) -> None:
    """Compute chunks and report each; 0 threads are all cores. After an error or Ctrl-C those in work are finished."""
    count = threads or _cores()
    pool = ThreadPoolExecutor(count, thread_name_prefix="strainwave-chunk")
    try:
        running = {pool.submit(compute, folder, chunk) for chunk in islice(chunks, CHUNKS_AHEAD * count)}
        while running:
            done, running = wait(running, return_when=FIRST_COMPLETED)
            _report_all(done, report)
            running |= {pool.submit(compute, folder, chunk) for chunk in islice(chunks, len(done))}
    finally:
        pool.shutdown(cancel_futures=True)


def _cores() -> int:
    """How many cores this process may use, which a batch system may limit."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _report_all(done: set[Future[int]], report: Callable[[int], None]) -> None:
    """Report what is finished before raising the error of what is not."""
    for future in done:
        if future.exception() is None:
            report(future.result())
    for future in done:
        future.result()
