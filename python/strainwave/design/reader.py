"""Design files in."""

from __future__ import annotations

import os

from strainwave.design.design import Design
from strainwave.toml_file import LARGEST_FILE_BYTES, TomlFile

__all__ = ["LARGEST_FILE_BYTES", "decode", "load", "loads", "read"]

_FILE = TomlFile("design file", "design", "Start from the template that `strainwave new` writes")


def load(path: str | os.PathLike[str]) -> Design:
    """The design in a TOML file. DesignError names every fault in it, or why it cannot be read."""
    return decode(read(path), os.fspath(path))


def read(path: str | os.PathLike[str]) -> bytes:
    """The bytes of a TOML file, for `decode`. DesignError says why it cannot be read."""
    return _FILE.content(os.fspath(path))


def decode(content: bytes, source: str) -> Design:
    """The design in the bytes of a TOML file. DesignError names every fault, and `source`."""
    return loads(_FILE.decoded(content, source), source)


def loads(text: str, source: str | None = None) -> Design:
    """The design in TOML text. DesignError names every fault in it, and `source`."""
    return Design.from_dict(_FILE.tree(text, source), source)
