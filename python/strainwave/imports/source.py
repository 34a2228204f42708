"""Files that others wrote, read with a limit on their size."""

from __future__ import annotations

from pathlib import Path

from strainwave.errors import StrainwaveError

LARGEST_FILE_BYTES = 2_000_000


def read_text(path: Path) -> str:
    """The text of a file. StrainwaveError where it is too large, binary or cannot be read."""
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE_BYTES + 1)
    except IsADirectoryError:
        raise StrainwaveError(f"{path}: is a directory, not a profile") from None
    except FileNotFoundError:
        raise StrainwaveError(f"{path}: there is no such file") from None
    except (OSError, ValueError) as error:  # ValueError: a path with a null character
        reason = error.strerror if isinstance(error, OSError) else error
        raise StrainwaveError(f"{path}: cannot be read: {reason}") from None
    if len(content) > LARGEST_FILE_BYTES:
        raise StrainwaveError(
            f"{path}: is larger than {LARGEST_FILE_BYTES // 1_000_000} MB, more than one tooth needs; "
            "leave out what is not the tooth's outline"
        )
    if b"\0" in content:
        raise StrainwaveError(f"{path}: is a binary file; write the profile as text (CSV, ASCII DXF or JSON)")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")  # older CAD programs; only names and notes can hold such characters
