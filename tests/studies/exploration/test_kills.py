"""Killed at random moments, clients, workers and schedulers lose no row and leave none twice."""

from __future__ import annotations

import subprocess
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from tests.studies.exploration.clusters import (
    PATIENCE_S,
    Cluster,
    arguments,
    cluster,
    content,
    finished,
    kill,
    started,
    wait_until,
)

SAMPLES = 4096
CHUNKS = 64
# A victim lives until so many more chunks are finished at most, and a moment longer.
MOST_CHUNKS = 16
LONGEST_MOMENT_S = 0.3
VICTIMS = ("client", "client in threads", "client of local workers", "worker", "scheduler")


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """With --soak a hundred kills."""
    if "kills" in metafunc.fixturenames:
        metafunc.parametrize("kills", [100 if metafunc.config.getoption("--soak", default=False) else 2])


def test_no_kill_costs_a_row(kills: int, tmp_path: Path) -> None:
    subprocess.run(arguments(tmp_path / "undisturbed", SAMPLES), check=True, capture_output=True)
    undisturbed = content(tmp_path / "undisturbed")
    chance = np.random.default_rng(kills)
    done: Counter[str] = Counter()
    studies = 0
    with cluster(tmp_path / "cluster", workers=2) as running:
        while done.total() < kills:
            out = tmp_path / f"study-{studies}"
            while done.total() < kills and finished(out) < CHUNKS:
                victim = kill_one(out, running, chance)
                done.update([victim] if victim else [])
            # In threads if the last one killed was not the end of it: the cluster is only starting again.
            assert subprocess.run(arguments(out, SAMPLES), capture_output=True, check=False).returncode == 0
            assert content(out) == undisturbed
            studies += 1
            print(f"{done.total()} kills, {studies} studies whole: {dict(done)}", flush=True)


def kill_one(out: Path, running: Cluster, chance: np.random.Generator) -> str:
    """Start or resume the study and kill something at a random moment; returns what, "" where the study was done."""
    victim = VICTIMS[int(chance.integers(len(VICTIMS)))]
    where = {"client in threads": [], "client of local workers": ["--dask", "local:2"]}
    client = started(arguments(out, SAMPLES, *where.get(victim, ["--dask", running.address])))
    try:
        return killed(victim, client, out, running, chance)
    finally:
        kill(client)


def killed(victim: str, client: subprocess.Popen[str], out: Path, running: Cluster, chance: np.random.Generator) -> str:
    """Wait for the moment and kill the victim; a client is left to be killed by whoever started it."""
    enough = finished(out) + int(chance.integers(MOST_CHUNKS))
    wait_until(lambda: finished(out) >= enough or client.poll() is not None)
    time.sleep(float(chance.uniform(0.0, LONGEST_MOMENT_S)))
    if client.poll() is not None:
        _, complaint = client.communicate()
        assert client.returncode == 0, complaint
        return ""
    at_work = 0 < finished(out) < CHUNKS
    if victim == "worker":
        running.kill_worker()
        running.start_worker()
        time.sleep(float(chance.uniform(0.0, LONGEST_MOMENT_S)))
    if victim == "scheduler":
        running.kill_all()
        running.start_scheduler()
        for _ in range(2):
            running.start_worker()
        _, complaint = client.communicate(timeout=PATIENCE_S)
        assert client.returncode in (0, 2)
        assert "Traceback" not in complaint
    return f"{victim}, {'at work' if at_work else 'before or after'}"
