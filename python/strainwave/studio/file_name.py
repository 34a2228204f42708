"""Names of files that are handed to the browser."""

from __future__ import annotations

import re
import unicodedata

LONGEST = 60
FALLBACK = "gear"
# Names that Windows keeps for devices, whatever their ending.
DEVICES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)", re.IGNORECASE)


def file_name(title: str, *words: str, ending: str) -> str:
    """A file's name from a design's title, with the program's own words and the ending behind it.

    Of the title only the letters A to Z, digits, "_" and "-" are kept, without accents: no separator of paths, no dot
    in front, nothing that a shell, a header or HTML would read.
    """
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode()
    stem = re.sub(r"[^A-Za-z0-9_]+", "-", plain).strip("-")[:LONGEST].strip("-")
    if not stem or DEVICES.fullmatch(stem):
        stem = "-".join(filter(None, (FALLBACK, stem)))
    return "-".join((stem, *words)) + ending
