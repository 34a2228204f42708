"""A real scheduler and real workers, each a process of its own on the loopback address, and studies to run on them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

from tests.designs import CASE_STUDY

COMMAND = Path(sys.executable).with_name("strainwave")
DESIGN = CASE_STUDY / "cosine-calibrated.toml"
SPACE = CASE_STUDY.parent / "spaces" / "tip-arcs.toml"
HERE = ["--host", "127.0.0.1", "--no-dashboard"]
PATIENCE_S = 180.0  # on a machine that has other things to do


@dataclass
class Cluster:
    """Processes that can be killed one by one."""

    folder: Path
    scheduler: subprocess.Popen[bytes] | None = None
    workers: list[subprocess.Popen[bytes]] = field(default_factory=list)

    @property
    def address(self) -> str:
        """Where the scheduler listens."""
        found: str = json.loads(self._file.read_text(encoding="utf-8"))["address"]
        assert found.startswith("tcp://127.0.0.1:")
        return found

    def start_scheduler(self) -> None:
        self._file.unlink(missing_ok=True)
        arguments = ["--scheduler-file", str(self._file), "--port", "0", *HERE]
        self.scheduler = self._start("distributed.cli.dask_scheduler", arguments, {})
        wait_until(self._is_listening)

    def start_worker(self, environment: dict[str, str] | None = None) -> None:
        arguments = [self.address, "--nthreads", "1", "--no-nanny", "--local-directory", str(self.folder), *HERE]
        self.workers.append(self._start("distributed.cli.dask_worker", arguments, environment or {}))

    def kill_worker(self) -> None:
        kill(self.workers.pop())

    def kill_scheduler(self) -> None:
        assert self.scheduler is not None
        kill(self.scheduler)

    def kill_all(self) -> None:
        for process in (self.scheduler, *self.workers):
            if process is not None:
                kill(process)
        self.workers.clear()

    @property
    def _file(self) -> Path:
        return self.folder / "scheduler.json"

    def _is_listening(self) -> bool:
        with suppress(OSError, ValueError, KeyError):
            return bool(self.address)
        return False

    def _start(self, module: str, arguments: list[str], environment: dict[str, str]) -> subprocess.Popen[bytes]:
        with (self.folder / "cluster.log").open("ab") as log:
            return subprocess.Popen(
                [sys.executable, "-m", module, *arguments], stdout=log, stderr=log, env={**os.environ, **environment}
            )


@contextmanager
def cluster(folder: Path, workers: int) -> Iterator[Cluster]:
    """A scheduler with workers, none of which outlives the block."""
    folder.mkdir()
    found = Cluster(folder)
    try:
        found.start_scheduler()
        for _ in range(workers):
            found.start_worker()
        yield found
    finally:
        found.kill_all()


def arguments(out: Path, samples: int, *options: object, chunk_rows: int = 64) -> list[str]:
    """The command of a study with many small chunks."""
    return [
        *(str(COMMAND), "explore", str(DESIGN), str(SPACE), "--samples", str(samples), "--out", str(out)),
        *("--chunk-rows", str(chunk_rows), "--in-motion", "--json", *map(str, options)),
    ]


def started(command: list[str]) -> subprocess.Popen[str]:
    """The command as a process of its own."""
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finished(folder: Path) -> int:
    """How many chunks are there."""
    return len(list(folder.glob("chunks/chunk-*.parquet")))


def wait_for_chunks(folder: Path, more: int) -> None:
    """Wait until so many more chunks are there than are there now."""
    before = finished(folder)
    wait_until(lambda: finished(folder) >= before + more)


def content(folder: Path) -> dict[str, bytes]:
    """Every file of a study by name, drafts too."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def kill(process: subprocess.Popen[str] | subprocess.Popen[bytes]) -> None:
    """As the system does it when memory runs out: without a word to the process."""
    process.kill()
    process.communicate()


def wait_until(reached: Callable[[], bool], patience_s: float = PATIENCE_S) -> None:
    """Wait for something that takes a while."""
    end = time.monotonic() + patience_s
    while not reached():
        assert time.monotonic() < end, "it does not happen"
        time.sleep(0.01)
