"""From a design and a space to a dataset of designs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from strainwave.batch.evaluate import check_numbers
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studies.exploration.dask_cluster import check_cluster, run_on_cluster
from strainwave.studies.exploration.exploration import Exploration
from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.plan import Plan
from strainwave.studies.exploration.space import Space
from strainwave.studies.exploration.study_folder import StudyFolder
from strainwave.studies.exploration.threads import run_in_threads
from strainwave.studies.progress import Progress, silent


def explore(
    design: Design,
    space: Space,
    samples: int,
    folder: str | Path,
    *,
    seed: int = 1,
    metrics: Sequence[str] | None = None,
    in_motion: bool = False,
    threshold_um: float = 10.0,
    chunk_rows: int | None = None,
    threads: int = 0,
    dask: str | None = None,
    progress: Progress = silent,
) -> Exploration:
    """Designs spread evenly over a space, and the figures of each, in a Parquet dataset of any size.

    ``samples`` points of a scrambled Sobol' sequence (best a power of two) are evaluated in chunks of ``chunk_rows`` (a
    power of two) and written into ``folder``. ``metrics`` are those of ``evaluate_batch``; left out, all but the play.
    ``in_motion`` adds the certified least backlash over all generator angles to designs that do not interfere at angle
    0. Chunks are computed in ``threads`` of this process (0: all cores), or on the cluster that ``dask`` names:
    "local:N" starts N worker processes here, anything else is the address of a scheduler whose workers share the
    folder. The same plan and ``seed`` give the same rows wherever they are computed.

    Called again, also after a crash, it goes on with the chunks that are missing. Ctrl-C keeps what is finished and
    marks the result as interrupted. Raises ``DesignError`` where the space does not fit the design, and
    ``StrainwaveError`` where a number is wrong, the folder holds anything else or cannot be written, or a worker is not
    fit for the study; finished chunks are kept.
    """
    arrow()
    check_numbers(threshold_um, threads)
    if dask is not None:
        check_cluster(dask)
    plan = Plan.of(
        design,
        space,
        samples,
        seed=seed,
        metrics=metrics,
        in_motion=in_motion,
        threshold_um=threshold_um,
        chunk_rows=chunk_rows,
    )
    place = StudyFolder.begun(Path(folder), plan)
    finished = set(place.finished())
    try:
        _compute(place, finished, threads, dask, progress)
        place.clear_drafts()
    except KeyboardInterrupt:
        pass  # what is missing says that it was interrupted
    except StrainwaveError as error:
        kept = f"{len(finished)} of {plan.chunks} chunks are finished and kept; the same command goes on from there"
        raise StrainwaveError(f"{error}; {kept}") from None
    return Exploration.opened(place)


def _compute(place: StudyFolder, finished: set[int], threads: int, dask: str | None, progress: Progress) -> None:
    """Compute what is not finished, and put it there."""
    plan = place.plan
    missing = iter([chunk for chunk in range(plan.chunks) if chunk not in finished])
    done = sum(len(plan.rows_of(chunk)) for chunk in finished)
    progress(done, plan.samples)

    def report(chunk: int) -> None:
        nonlocal done
        finished.add(chunk)
        done += len(plan.rows_of(chunk))
        progress(done, plan.samples)

    if dask is None:
        run_in_threads(place, missing, threads, report)
    else:
        run_on_cluster(place, missing, dask, report)
