"""Real schedulers and workers: killed in the middle, the dataset is that of an undisturbed run."""

from __future__ import annotations

import os
import re
import signal
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest

from strainwave import __version__
from strainwave.errors import StrainwaveError
from strainwave.studies.exploration.dask_cluster import _check, check_cluster
from strainwave.studies.exploration.worker import compute_remotely
from tests.studies.exploration.clusters import arguments, cluster, content, finished, kill, started, wait_for_chunks

SAMPLES = 8192

OTHER_VERSION = """
import importlib.metadata as metadata
there = metadata.version
metadata.version = lambda name: "9.9.9" if name == "strainwave" else there(name)
"""


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """Every file of a study that threads of one process computed from beginning to end."""
    out = tmp_path_factory.mktemp("undisturbed") / "study"
    subprocess.run(arguments(out, SAMPLES), check=True, capture_output=True)
    return content(out)


def test_killed_workers_clients_and_schedulers_cost_no_row(tmp_path: Path, undisturbed: dict[str, bytes]) -> None:
    with cluster(tmp_path / "cluster", workers=2) as running:
        out = tmp_path / "study"
        command = arguments(out, SAMPLES, "--dask", running.address)

        client = started(command)
        wait_for_chunks(out, 5)
        running.kill_worker()
        wait_for_chunks(out, 5)
        kill(client)
        assert 10 <= finished(out) < 128

        client = started(command)
        wait_for_chunks(out, 5)
        running.kill_scheduler()
        _, complaint = client.communicate(timeout=60)
        assert client.returncode == 2
        assert re.fullmatch(
            r"strainwave: dask: the scheduler at tcp://\S+ went away; \d+ of 128 chunks are finished and kept; "
            r"the same command goes on from there",
            complaint.splitlines()[-1],  # a slow machine writes lines of progress before
        )
        assert finished(out) < 128

        running.kill_all()
        running.start_scheduler()
        running.start_worker()
        command = arguments(out, SAMPLES, "--dask", running.address)
        assert subprocess.run(command, capture_output=True, check=False).returncode == 0
    assert content(out) == undisturbed


def test_a_worker_of_another_version_is_one_error(tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "sitecustomize.py").write_text(OTHER_VERSION, encoding="utf-8")
    with cluster(tmp_path / "cluster", workers=0) as running:
        running.start_worker({"PYTHONPATH": str(tmp_path / "other")})
        outcome = subprocess.run(
            arguments(tmp_path / "study", SAMPLES, "--dask", running.address),
            capture_output=True,
            text=True,
            check=False,
        )
    assert outcome.returncode == 2
    assert re.fullmatch(
        rf"strainwave: the worker tcp://127\.0\.0\.1:\d+ has strainwave 9\.9\.9 and the study is of {__version__}: "
        r"install the same version on every worker; 0 of 128 chunks are finished and kept; .*\n",
        outcome.stderr,
    )


def test_workers_started_here_give_the_same_dataset_also_after_ctrl_c(
    tmp_path: Path, undisturbed: dict[str, bytes]
) -> None:
    out = tmp_path / "study"
    command = arguments(out, SAMPLES, "--dask", "local:2")
    # In a session of its own, so that Ctrl-C reaches the workers too, as in a terminal.
    client = subprocess.Popen(
        ["env", "--default-signal=INT", *command],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    wait_for_chunks(out, 5)
    os.killpg(client.pid, signal.SIGINT)
    _, complaint = client.communicate(timeout=60)
    assert client.returncode == 130
    kept, interrupted = complaint.splitlines()[-2:]
    assert re.fullmatch(r"\d+ of 128 chunks are finished and kept in .*; the same command goes on from there", kept)
    assert interrupted == "strainwave: interrupted"
    assert subprocess.run(command, capture_output=True, check=False).returncode == 0
    assert content(out) == undisturbed


def test_no_scheduler_is_one_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from strainwave.studies.exploration import dask_cluster, explore
    from tests.designs import case
    from tests.studies.exploration.runs import space_of

    monkeypatch.setattr(dask_cluster, "PATIENCE_S", 1)
    with pytest.raises(
        StrainwaveError, match=r"there is no scheduler to reach at tcp://127\.0\.0\.1:9: .*0 of 1 chunks"
    ):
        explore(case(), space_of(), 100, tmp_path / "study", dask="tcp://127.0.0.1:9")


@pytest.mark.parametrize("text", ["local:0", "local:5000", "local:two", "localhost", "", "tcp://", "here/there:1"])
def test_an_address_that_is_none_is_refused_before_anything_starts(text: str) -> None:
    with pytest.raises(StrainwaveError, match=r"^dask: "):
        check_cluster(text)


def test_a_worker_without_the_folder_says_so(tmp_path: Path) -> None:
    with pytest.raises(StrainwaveError, match=r"does not see the study in .* on a file system that all share"):
        compute_remotely(__version__, str(tmp_path), "0123456789abcdef", 0)


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (type("KilledWorker", (Exception,), {})("x"), "each time its worker died"),
        (ModuleNotFoundError("No module named 'strainwave'"), "cannot run strainwave .* install it there"),
        (MemoryError("too much"), "a worker failed: MemoryError: too much"),
        (StrainwaveError("its own words"), "^its own words$"),
    ],
)
def test_whatever_happens_to_a_worker_is_one_error(error: Exception, message: str) -> None:
    with pytest.raises(StrainwaveError, match=message):
        _check(SimpleNamespace(status="error", exception=lambda: error))
