"""Explorations and bare batches of the same designs, each in a process of its own: that of this file as a script."""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent.parent
DESIGN = ROOT / "designs" / "case-study" / "cosine-calibrated.toml"
# Ranges in which few designs interfere, so that a design costs the kernel as little as it can: 0.2 percent about the
# design's own numbers, as in the table of speeds.
RANGES = {
    "wave_generator.w0": (0.8463, 0.8497),
    "flexspline.profile.tip_arc_radius": (1.0780, 1.0824),
    "circular_spline.profile.tip_arc_radius": (2.0487, 2.0569),
}
CHUNK_ROWS = (1024, 4096, 16384, 32768)


@dataclass(frozen=True)
class Scale:
    """How much is measured."""

    designs: int
    few: int
    """For the memory of a small study."""
    rounds: int
    tasks: int
    """Tasks of no work, for the scheduler's own time."""


@dataclass(frozen=True)
class Side:
    """One way to evaluate designs: the bare kernel, threads, or workers started here."""

    way: str
    designs: int
    workers: int = 2
    chunk_rows: int | None = None


@dataclass(frozen=True)
class Run:
    """What one process needed."""

    seconds: float
    designs: int
    peak_mb: float
    bytes_on_disk: int
    """0 for the bare kernel."""

    @property
    def rate(self) -> float:
        """Designs a second."""
        return self.designs / self.seconds


def sides(scale: Scale) -> dict[str, Side]:
    """Everything that is compared, by name."""
    half = scale.designs // 2
    return {
        "kernel 1": Side("kernel", scale.designs, 1),
        "kernel 2": Side("kernel", scale.designs, 2),
        "threads 1": Side("threads", scale.designs, 1),
        "threads 2": Side("threads", scale.designs, 2),
        "dask 1": Side("dask", scale.designs, 1),
        "dask 2": Side("dask", scale.designs, 2),
        "few": Side("threads", scale.few, 2),
        **{f"rows {rows}": Side("threads", half, 2, rows) for rows in CHUNK_ROWS},
        **{f"dask rows {rows}": Side("dask", half, 2, rows) for rows in CHUNK_ROWS},
    }


def measured(compared: Mapping[str, Side], rounds: int) -> dict[str, list[Run]]:
    """Runs of every side, interleaved."""
    found: dict[str, list[Run]] = {name: [] for name in compared}
    for _ in range(rounds):
        for name, side in compared.items():
            command = [sys.executable, __file__, json.dumps(asdict(side))]
            output = subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True).stdout
            found[name].append(Run(**json.loads(output)))
            print(f"    {name}: {found[name][-1].rate:,.0f} designs/s", flush=True)
    return found


def task_seconds(tasks: int) -> float:
    """Time that a scheduler here takes for a task of no work, with two workers."""
    from distributed import Client, LocalCluster, as_completed

    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address="127.0.0.1:0", silence_logs=50
        ) as workers,
        Client(workers) as client,
    ):
        client.gather([client.submit(abs, number, pure=False) for number in range(100)])
        start = time.perf_counter()
        for _ in as_completed([client.submit(abs, number, pure=False) for number in range(tasks)]):
            pass
        return (time.perf_counter() - start) / tasks


def run(side: Side) -> Run:
    """Evaluate the designs of a side in this process."""
    from strainwave import load
    from strainwave.studies.exploration import Plan, Space

    design = load(DESIGN)
    space = Space.from_dict(
        {"parameters": [{"parameter": key, "low": low, "high": high} for key, (low, high) in RANGES.items()]}
    )
    question: dict[str, Any] = {"seed": 1, "metrics": None, "in_motion": False, "threshold_um": 10.0}
    if side.way == "kernel":
        return _bare(Plan.of(design, space, side.designs, **question, chunk_rows=None), side)
    return _explored(design, space, side)


def _bare(plan: Any, side: Side) -> Run:
    """All rows in one call of the batch, its threads sharing them, and nothing written."""
    import numpy as np

    from strainwave import evaluate_batch

    chunks = range(plan.chunks)
    values = np.concatenate([plan.sampled(plan.rows_of(chunk))[0] for chunk in chunks])
    evaluate_batch(plan.design, plan.keys, values[:1000], metrics=plan.metrics, threads=side.workers)  # warm
    start = time.perf_counter()
    evaluate_batch(plan.design, plan.keys, values, metrics=plan.metrics, threads=side.workers)
    return Run(time.perf_counter() - start, side.designs, _peak_mb(), 0)


def _explored(design: Any, space: Any, side: Side) -> Run:
    """A study into an empty folder, from its first chunk to its last: the start of a cluster is counted apart."""
    from strainwave.studies.exploration import explore

    times: list[float] = []
    with tempfile.TemporaryDirectory() as folder:
        explore(design, space, 1000, Path(folder) / "warm")
        explore(
            design,
            space,
            side.designs,
            Path(folder) / "study",
            chunk_rows=side.chunk_rows,
            threads=side.workers if side.way == "threads" else 0,
            dask=f"local:{side.workers}" if side.way == "dask" else None,
            progress=lambda *_: times.append(time.perf_counter()),
        )
        size = sum(path.stat().st_size for path in (Path(folder) / "study").rglob("*.parquet"))
    # A cluster takes seconds to start, whatever the study: of its run the time from the first chunk on counts, and
    # all chunks but those that were in work by then.
    if side.way == "dask":
        return _without_start(times, side, size)
    return Run(times[-1] - times[0], side.designs, _peak_mb(), size)


def _without_start(times: list[float], side: Side, size: int) -> Run:
    chunks = len(times) - 1
    counted = chunks - side.workers
    seconds = times[-1] - times[side.workers]
    return Run(seconds, round(side.designs * counted / chunks), _peak_mb(), round(size * counted / chunks))


def _peak_mb() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3


if __name__ == "__main__":
    print(json.dumps(asdict(run(Side(**json.loads(sys.argv[1]))))))
