"""Folders of files that are written all together or not at all."""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping
from pathlib import Path

from strainwave.errors import StrainwaveError
from strainwave.whole_file import unwritable


def write_whole_folder(path: Path, contents: Mapping[str, str], *, overwrite: bool = False) -> tuple[Path, ...]:
    """Write files by name into a folder beside its place and move it there when all are complete; returns their paths.

    StrainwaveError if that cannot be, or where `check_folder_free` has something against it.
    """
    check_folder_free(path, overwrite=overwrite)
    target = Path(path).resolve()
    draft, old = (target.with_name(f".{target.name}.{os.getpid()}.{end}") for end in ("part", "old"))
    try:
        try:
            draft.mkdir()
            for name, content in contents.items():
                (draft / name).write_text(content, encoding="utf-8")
            if target.exists():
                target.rename(old)
            draft.rename(target)
        finally:
            if old.exists() and not target.exists():
                old.rename(target)
            for leftover in (draft, old):
                shutil.rmtree(leftover, ignore_errors=True)
    except OSError as error:
        raise unwritable(path, error) from None
    return tuple(Path(path) / name for name in contents)


def check_folder_free(path: Path, *, overwrite: bool) -> None:
    """StrainwaveError if no folder can be written at `path`; for a look before long work is done for it.

    With `overwrite` a folder of design files is replaced, but none that holds anything else.
    """
    try:
        if path.exists() and not path.is_dir():
            raise StrainwaveError(f"{path}: is a file, not a folder; nothing was written")
        held = sorted(path.iterdir()) if path.is_dir() else []
        others = [file.name for file in held if file.suffix != ".toml" or not file.is_file()]
        if others:
            raise StrainwaveError(f"{path}: holds more than design files ({others[0]}); nothing was written")
        if held and not overwrite:
            raise StrainwaveError(f"{path}: holds files already; nothing was written (--force overwrites)")
        if not path.resolve().parent.is_dir():
            raise StrainwaveError(f"{path}: cannot be written: there is no directory {path.parent}")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        raise unwritable(path, error) from None
