"""Folders of files that are written all together or not at all."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Mapping, Sequence
from pathlib import Path

from strainwave.errors import StrainwaveError
from strainwave.whole_file import unwritable


def write_whole_folder(
    path: Path, contents: Mapping[str, str], own: Sequence[str], *, overwrite: bool = False
) -> tuple[Path, ...]:
    """Write files by name into a folder beside its place and move it there when all are complete; returns their paths.

    StrainwaveError if that cannot be, or where `check_folder_free` has something against it.
    """
    check_folder_free(path, own, overwrite=overwrite)
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


def check_folder_free(path: Path, own: Sequence[str], *, overwrite: bool) -> None:
    """StrainwaveError if no folder can be written at `path`; for a look before long work is done for it.

    With `overwrite` a folder is replaced, but none that holds a file of a name that its writer does not give. `own` are
    those names, such as "front-N.toml", where N stands for a number of at least two digits.
    """
    names = re.compile("|".join(re.escape(name).replace("N", "[0-9]{2,}") for name in own))
    try:
        if path.exists() and not path.is_dir():
            raise StrainwaveError(f"{path}: is a file, not a folder; nothing was written")
        held = sorted(path.iterdir()) if path.is_dir() else []
        others = [file.name for file in held if not (names.fullmatch(file.name) and file.is_file())]
        if others:
            more = f" and {len(others) - 1} more" if others[1:] else ""
            raise StrainwaveError(
                f"{path}: holds {others[0]}{more}, which would be lost; nothing was written. Give a new folder, or one "
                f"that holds only {' and '.join(own)}"
            )
        if path.is_dir() and path.samefile("."):
            # Whoever is in it would stay in the old one, which is gone, and so would other files of the same command.
            said = "is the current folder, which cannot be replaced; nothing was written. Give a new folder"
            raise StrainwaveError(f"{path}: {said}")
        if held and not overwrite:
            raise StrainwaveError(f"{path}: holds files already; nothing was written (--force overwrites)")
        if not path.resolve().parent.is_dir():
            raise StrainwaveError(f"{path}: cannot be written: there is no directory {path.parent}")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        raise unwritable(path, error) from None
