"""What a worker does, in a thread of this process or anywhere else: one chunk from the plan to its file."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from strainwave.errors import StrainwaveError
from strainwave.studies.exploration.rows import table_of
from strainwave.studies.exploration.study_folder import StudyFolder


def compute(folder: StudyFolder, chunk: int) -> int:
    """Compute a chunk and write it; returns its number."""
    folder.write(chunk, table_of(folder.plan, chunk))
    return chunk


def compute_remotely(version: str, path: str, study: str, chunk: int) -> int:
    """The same on a worker that knows nothing but where the study's folder is.

    ``StrainwaveError`` where the worker is not fit for the study. The arguments stay what they are in later versions,
    so that a worker of another version can say so.
    """
    from strainwave import __version__

    if __version__ != version:
        raise StrainwaveError(
            f"the worker {_name()} has strainwave {__version__} and the study is of {version}: "
            "install the same version on every worker"
        )
    return compute(_folder(path, study), chunk)


@lru_cache(maxsize=4)
def _folder(path: str, study: str) -> StudyFolder:
    try:
        folder = StudyFolder.opened(Path(path))
        same = folder.plan.study == study
    except StrainwaveError:
        same = False
    if not same:
        raise StrainwaveError(
            f"the worker {_name()} does not see the study in {path}: workers need the folder at the same path, on a "
            "file system that all share"
        )
    return folder


def _name() -> str:
    """The worker's address in its cluster."""
    from distributed import get_worker

    try:
        return str(get_worker().address)
    except ValueError:
        return "here"
