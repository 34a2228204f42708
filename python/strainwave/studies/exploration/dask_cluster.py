"""Chunks on a dask.distributed cluster: one that runs somewhere, or one of processes here."""

from __future__ import annotations

import logging
import re
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager
from itertools import islice
from multiprocessing import resource_tracker
from typing import Any

from strainwave.errors import StrainwaveError
from strainwave.studies.exploration.libraries import cluster_module
from strainwave.studies.exploration.study_folder import StudyFolder
from strainwave.studies.exploration.worker import compute_remotely

# Chunks that the scheduler holds at once: enough for thousands of workers, and the same for a study of any size.
CHUNKS_AHEAD = 10_000
PATIENCE_S = 10
_LOCAL = re.compile(r"local:(?P<workers>\d+)")
GREATEST_WORKERS = 1024


def check_cluster(cluster: str) -> None:
    """``StrainwaveError`` where text neither asks for workers here nor can be the address of a scheduler."""
    local = _LOCAL.fullmatch(cluster)
    if local and not 1 <= int(local["workers"]) <= GREATEST_WORKERS:
        raise StrainwaveError(f"dask: local:N starts 1 to {GREATEST_WORKERS} workers, not {local['workers']}")
    if not local and (cluster.startswith("local") or not re.fullmatch(r"(\w+://)?[^\s/]+:\d+", cluster)):
        raise StrainwaveError(f"dask: {cluster!r} is neither local:N nor an address such as tcp://192.0.2.1:8786")


def run_on_cluster(folder: StudyFolder, chunks: Iterator[int], cluster: str, report: Callable[[int], None]) -> None:
    """Compute chunks on the workers and report each. The first error, or Ctrl-C, takes back what is not begun.

    Tasks and answers are a few numbers: a worker reads the plan from the folder and writes its rows there.
    """
    distributed = cluster_module("distributed")
    plan, path = folder.plan, str(folder.path.resolve())
    with _quiet(), _client(distributed, cluster) as client:
        chunk_of: dict[Any, int] = {}

        def submitted(chunk: int) -> Any:
            # Not pure: a task of a client that was killed may still be running under a name of its own.
            future = client.submit(compute_remotely, plan.version, path, plan.study, chunk, pure=False)
            chunk_of[future.key] = chunk
            return future

        try:
            first = [submitted(chunk) for chunk in islice(chunks, CHUNKS_AHEAD)]
            running = distributed.as_completed(first, loop=client.loop)
            del first  # so that what is done is forgotten
            for future in running:
                _check(future)
                report(chunk_of.pop(future.key))
                for chunk in islice(chunks, 1):
                    running.add(submitted(chunk))
        except (OSError, CancelledError):
            raise StrainwaveError(f"dask: the scheduler at {cluster} went away") from None


def _check(future: Any) -> None:
    """``StrainwaveError`` in the place of whatever kept a worker from finishing."""
    if future.status == "finished":
        return
    if future.status != "error":
        raise CancelledError
    error = future.exception()
    if isinstance(error, StrainwaveError):
        raise error
    if type(error).__name__ == "KilledWorker":
        raise StrainwaveError(
            "dask: a chunk was begun several times and each time its worker died; did the workers run out of memory?"
        )
    if isinstance(error, ImportError | AttributeError):
        raise StrainwaveError(
            f"dask: a worker cannot run strainwave ({error}): install it there with its extra cluster"
        )
    raise StrainwaveError(f"dask: a worker failed: {type(error).__name__}: {error}")


@contextmanager
def _client(distributed: Any, cluster: str) -> Iterator[Any]:
    local = _LOCAL.fullmatch(cluster)
    if local is not None:
        with (
            _workers_here(distributed, int(local["workers"])) as workers,
            distributed.Client(workers, set_as_default=False) as client,
        ):
            yield client
        return
    try:
        client = distributed.Client(cluster, timeout=PATIENCE_S, set_as_default=False)
    except (OSError, ValueError) as error:
        raise StrainwaveError(f"dask: there is no scheduler to reach at {cluster}: {error}") from None
    try:
        yield client
    finally:
        client.close(timeout=PATIENCE_S)


def _workers_here(distributed: Any, count: int) -> Any:
    """Worker processes that listen on the loopback address only and end with this process, however it ends."""
    # Ctrl-C goes to every process of the terminal and is for this one. What a thread blocks, its children block too,
    # unless the tracker of their resources is still to be started, which unblocks it.
    resource_tracker.ensure_running()
    blocked = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        return distributed.LocalCluster(
            n_workers=count,
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address="127.0.0.1:0",
            worker_dashboard_address=None,
            silence_logs=logging.CRITICAL,
        )
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, blocked)


@contextmanager
def _quiet() -> Iterator[None]:
    """Nothing from Dask's loggers: what matters is said in one error."""
    loggers = [logging.getLogger(name) for name in logging.root.manager.loggerDict if name.startswith("distributed")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)
