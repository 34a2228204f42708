"""Files that are written whole or not at all."""

from __future__ import annotations

import os
from pathlib import Path

from strainwave.errors import StrainwaveError


def write_whole(path: str | os.PathLike[str], content: str | bytes, *, overwrite: bool = False) -> None:
    """Write a file beside its place and move it there when it is complete.

    StrainwaveError if it cannot be written, or is there already and `overwrite` does not say otherwise.
    """
    check_free(path, overwrite=overwrite)
    data = content.encode() if isinstance(content, str) else content
    target = Path(path).resolve()  # through a symbolic link, so that the link stays one
    draft = target.with_name(f".{target.name}.{os.getpid()}.part")
    try:
        if target.exists() and not target.is_file():
            target.write_bytes(data)  # a device or a pipe cannot be replaced
            return
        try:
            draft.write_bytes(data)
            draft.replace(target)
        finally:
            draft.unlink(missing_ok=True)
    except OSError as error:
        raise unwritable(path, error) from None


def check_free(path: str | os.PathLike[str], *, overwrite: bool) -> None:
    """StrainwaveError if a file cannot be written at `path`; for a look before long work is done for it."""
    target = Path(path)
    try:
        if target.is_dir():
            raise StrainwaveError(f"{target}: is a directory; nothing was written")
        if target.is_file() and not overwrite:
            raise StrainwaveError(f"{target}: is there already; nothing was written (--force overwrites)")
        if not target.resolve().parent.is_dir():
            raise StrainwaveError(f"{target}: cannot be written: there is no directory {target.parent}")
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        raise unwritable(path, error) from None


def unwritable(path: str | os.PathLike[str], error: OSError | ValueError) -> StrainwaveError:
    """The error to raise where a file or folder at `path` cannot be written."""
    reason = error.strerror if isinstance(error, OSError) else error
    return StrainwaveError(f"{Path(path)}: cannot be written: {reason}")
