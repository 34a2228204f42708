"""Design files in."""

from __future__ import annotations

import os

from strainwave.design.design import Design
from strainwave.toml_file import LARGEST_FILE_BYTES, TomlFile

__all__ = ["LARGEST_FILE_BYTES", "decode", "load", "loads"]

_FILE = TomlFile("design file", "design", "Start from the template that `strainwave new` writes")


def load(path: str | os.PathLike[str]) -> Design:
    """The design in a TOML file. DesignError names every fault in it, or why it cannot be read."""
    source = os.fspath(path)
    return loads(_FILE.text(source), source)


def decode(content: bytes, source: str) -> Design:
    """The design in the bytes of a TOML file that came without a path. DesignError names every fault, and `source`."""
    return loads(_FILE.decoded(content, source), source)


def loads(text: str, source: str | None = None) -> Design:
    """The design in TOML text. DesignError names every fault in it, and `source`."""
    return Design.from_dict(_FILE.tree(text, source), source)
