"""The folder of an exploration: a manifest, and a Parquet file for each chunk that is finished."""

from __future__ import annotations

import os
import re
import uuid
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from strainwave.errors import StrainwaveError
from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.manifest import CHUNKS, MANIFEST, chunk_name, manifest_of, plan_in, what_differs
from strainwave.studies.exploration.parquet_file import parquet_bytes
from strainwave.studies.exploration.plan import Plan
from strainwave.studies.exploration.rows import STUDY_KEY
from strainwave.whole_file import unwritable, write_whole

DRAFT = ".part"
_CHUNK = re.compile(r"chunk-(?P<number>\d{6,})\.parquet")


@dataclass(frozen=True)
class StudyFolder:
    """A place for the chunks of a plan. A chunk is finished when its file has its name; drafts begin with a dot."""

    path: Path
    plan: Plan

    @classmethod
    def begun(cls, path: Path, plan: Plan) -> Self:
        """The folder made ready for a plan: a new one, an empty one, or one that holds the same study.

        ``StrainwaveError`` where it holds anything else or cannot be written.
        """
        folder = cls(Path(path), plan)
        try:
            if folder.path.exists() and not folder.path.is_dir():
                raise StrainwaveError(f"{path}: is a file, not a folder; nothing was written")
            if (folder.path / MANIFEST).exists():
                folder._check_same(plan_in(folder.path))
            else:
                folder._check_empty()
                folder.path.mkdir(exist_ok=True)
                write_whole(folder.path / MANIFEST, manifest_of(plan))
                _through_to_the_disk(folder.path / MANIFEST)
            folder.chunks_path.mkdir(exist_ok=True)
            folder._check_writable()
        except (OSError, ValueError) as error:  # ValueError: a path with a null character
            raise unwritable(path, error) from None
        return folder

    @classmethod
    def opened(cls, path: Path) -> Self:
        """The folder of a study as it is; ``StrainwaveError`` where it is none."""
        return cls(Path(path), plan_in(Path(path)))

    @property
    def chunks_path(self) -> Path:
        """Where the Parquet files are."""
        return self.path / CHUNKS

    def file_of(self, chunk: int) -> Path:
        """The file of a finished chunk."""
        return self.chunks_path / chunk_name(chunk)

    def finished(self) -> list[int]:
        """The chunks whose files are there and whole, by number.

        A file that is not whole, which a crash of the machine can leave, counts as not there. ``StrainwaveError``
        where a file belongs to another study.
        """
        return sorted(chunk for chunk in self._named() if self._is_whole(chunk))

    def write(self, chunk: int, table: Any) -> None:
        """Write a chunk beside its place, through to the disk, and move it there: whole or not at all."""
        target = self.file_of(chunk)
        # Another worker, on another machine even, may be writing the same chunk after a client was killed.
        draft = target.with_name(f".{target.name}.{uuid.uuid4().hex}{DRAFT}")
        try:
            try:
                draft.write_bytes(parquet_bytes(table))
                _through_to_the_disk(draft)
                draft.replace(target)
            finally:
                draft.unlink(missing_ok=True)
        except OSError as error:
            # Another client that has finished the study meanwhile has cleared what it took for a dead worker's draft.
            if not (isinstance(error, FileNotFoundError) and target.exists()):
                raise unwritable(target, error) from None

    def clear_drafts(self) -> None:
        """Remove what killed workers have left. Call it when no worker is at work."""
        for draft in self.chunks_path.glob(f".*{DRAFT}"):
            draft.unlink(missing_ok=True)

    def _named(self) -> list[int]:
        if not self.chunks_path.is_dir():
            return []
        names = (path.name for path in self.chunks_path.iterdir())
        found = [int(match["number"]) for name in names if (match := _CHUNK.fullmatch(name))]
        return [chunk for chunk in found if chunk < self.plan.chunks]

    def _is_whole(self, chunk: int) -> bool:
        parquet, path = arrow("parquet"), self.file_of(chunk)
        try:
            footer = parquet.read_metadata(path)
        except (OSError, arrow().ArrowInvalid):
            return False
        if (footer.metadata or {}).get(STUDY_KEY) != self.plan.study.encode():
            raise StrainwaveError(f"{path}: belongs to another study; move it elsewhere")
        return bool(footer.num_rows == len(self.plan.rows_of(chunk)))

    def _check_same(self, other: Plan) -> None:
        if other.study != self.plan.study:
            raise StrainwaveError(
                f"{self.path}: holds another study: {what_differs(other, self.plan)}; "
                "name another folder, or repeat the command of that study to go on with it"
            )

    def _check_empty(self) -> None:
        held = sorted(each.name for each in self.path.iterdir()) if self.path.is_dir() else []
        others = [name for name in held if not name.startswith(f".{MANIFEST}")]
        if others:
            raise StrainwaveError(f"{self.path}: holds something else than a study ({others[0]}); name another folder")

    def _check_writable(self) -> None:
        probe = self.chunks_path / f".{uuid.uuid4().hex}{DRAFT}"
        try:
            probe.write_bytes(b"")
        finally:
            probe.unlink(missing_ok=True)


def _through_to_the_disk(file: Path) -> None:
    """Wait until a file is where a power cut leaves it."""
    descriptor = os.open(file, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
