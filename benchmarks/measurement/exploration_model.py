"""From what one machine does to what a cluster would do: tables for docs/cluster.md.

A study takes as long as the slowest of what its chunks pass through, all of which work at the same time: the cores of
all nodes, the one scheduler, the one file system; and at the end the last chunk, while other cores have none left.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from statistics import median

from measurement.exploration import CHUNK_ROWS, Run, Scale

# What is assumed of a cluster, for it cannot be measured here: common figures of a parallel file system and of nodes.
CORES_A_NODE = 32
DISK_BYTES_A_SECOND = 1e9
FILES_A_SECOND = 1000.0
DESIGNS = 1e10
ROWS = 2**15

Runs = Mapping[str, Sequence[Run]]


@dataclass(frozen=True)
class Cluster:
    """Nodes with what each core, the scheduler and the file system do."""

    nodes: int
    chunk_rows: int
    rate: float
    """Designs a second and core."""
    task_s: float
    """The scheduler's time for a chunk."""
    bytes_a_design: float

    def hours(self, designs: float) -> dict[str, float]:
        """How long each would be busy with a study."""
        chunks = designs / self.chunk_rows
        return {
            "cores": designs / (self.nodes * CORES_A_NODE * self.rate) / 3600.0,
            "scheduler": chunks * self.task_s / 3600.0,
            "disk": designs * self.bytes_a_design / DISK_BYTES_A_SECOND / 3600.0,
            "files": chunks / FILES_A_SECOND / 3600.0,
        }

    def total_hours(self, designs: float) -> float:
        """The slowest of them, and the last chunk."""
        return max(self.hours(designs).values()) + self.chunk_rows / self.rate / 3600.0


def throughput(runs: Runs, _task_s: float, scale: Scale) -> str:
    """Every way with one and two workers beside the bare kernel."""
    rows = []
    ways = {"kernel": "bare kernel, one call", "threads": "`explore`", "dask": "`explore --dask local:N`"}
    for way, name in ways.items():
        for workers in (1, 2):
            found, kernel = runs[f"{way} {workers}"], runs[f"kernel {workers}"]
            # Runs of one round are beside each other in time, so the ratio is taken within each.
            share = median(run.rate / bare.rate for run, bare in zip(found, kernel, strict=True))
            rate = median(run.rate for run in found)
            rows.append([name, f"{workers}", f"{rate:,.0f}", f"{share:.2f}"])
    head = [f"{scale.designs:,} designs", "threads or workers", "designs/s", "of the bare kernel"]
    return _table(head, rows)


def chunks(runs: Runs, _task_s: float, _scale: Scale) -> str:
    """Throughput and size by the rows of a chunk."""
    rows = []
    for count in CHUNK_ROWS:
        threads, dask = runs[f"rows {count}"], runs[f"dask rows {count}"]
        size = threads[0].bytes_on_disk / threads[0].designs
        rates = (f"{median(run.rate for run in found):,.0f}" for found in (threads, dask))
        rows.append([f"{count:,}", *rates, f"{size:.1f}", f"{size * count / 1e6:.2f}"])
    return _table(["designs a chunk", "2 threads, designs/s", "2 Dask workers", "bytes a design", "MB a file"], rows)


def memory(runs: Runs, _task_s: float, scale: Scale) -> str:
    """Peak memory of a small and a large study."""
    rows = []
    for name, designs in (("few", scale.few), ("threads 2", scale.designs)):
        rows.append([f"{designs:,}", f"{median(run.peak_mb for run in runs[name]):.0f} MB"])
    return _table(["designs, 2 threads", "peak memory of the process"], rows)


def scheduler(runs: Runs, task_s: float, _scale: Scale) -> str:
    """What one scheduler can feed."""
    rate = _core_rate(runs)
    rows = [
        [f"{count:,}", f"{count / rate:.2g} s", f"{count / task_s:,.0f}", f"{count / rate / task_s:,.0f}"]
        for count in (*CHUNK_ROWS, 2**18)
    ]
    head = ["designs a chunk", "time of a core", "designs/s that the scheduler hands out", "cores that it keeps busy"]
    return f"A task without work takes the scheduler {task_s * 1e3:.2f} ms.\n\n" + _table(head, rows)


def nodes(runs: Runs, task_s: float, _scale: Scale) -> str:
    """10^10 designs on more and more nodes."""
    clusters = (_cluster(runs, task_s, count, ROWS) for count in (1, 10, 100, 1000))
    return _scaled("nodes", lambda each: f"{each.nodes:,}", clusters)


def chunk_sizes(runs: Runs, task_s: float, _scale: Scale) -> str:
    """10^10 designs on 100 nodes in chunks of several sizes."""
    clusters = (_cluster(runs, task_s, 100, count) for count in (2**10, 2**12, 2**15, 2**18, 2**20))
    return _scaled("designs a chunk", lambda each: f"{each.chunk_rows:,}", clusters)


def _cluster(runs: Runs, task_s: float, count: int, rows: int) -> Cluster:
    sized = runs["threads 2"][0]
    return Cluster(count, rows, _core_rate(runs), task_s, sized.bytes_on_disk / sized.designs)


def _core_rate(runs: Runs) -> float:
    return median(run.rate for run in runs["dask 1"])


def _scaled(first: str, label: Callable[[Cluster], str], clusters: Iterable[Cluster]) -> str:
    rows = []
    for each in clusters:
        hours = each.hours(DESIGNS)
        slowest = max(hours, key=lambda name: hours[name])
        rows.append([label(each), *map(_time, hours.values()), f"**{_time(each.total_hours(DESIGNS))}**", slowest])
    return _table([first, "cores", "scheduler", "bytes to disk", "files", "in all", "limited by"], rows)


def _time(hours: float) -> str:
    if hours >= 48.0:
        return f"{hours / 24.0:.1f} d"
    return f"{hours:.1f} h" if hours >= 1.0 else f"{hours * 60.0:.1f} min"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---", *["--:"] * (len(head) - 1)], *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


TABLES: dict[str, Callable[[Runs, float, Scale], str]] = {
    "cluster-throughput": throughput,
    "cluster-chunks": chunks,
    "cluster-memory": memory,
    "cluster-scheduler": scheduler,
    "cluster-nodes": nodes,
    "cluster-chunk-sizes": chunk_sizes,
}
