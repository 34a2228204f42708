"""Design files as they come and go: their name, their bytes and the design in them."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from strainwave.design import Design, decode, dumps
from strainwave.design.reader import read
from strainwave.studio.file_name import file_name

ENDING = ".toml"


@dataclass(frozen=True)
class DesignFile:
    """A file that was opened, or that is to be saved."""

    name: str
    content: bytes
    design: Design

    @classmethod
    def opened(cls, name: str, content: bytes) -> DesignFile:
        """Of a file's bytes. ``DesignError`` where they hold no design."""
        return cls(name, content, decode(content, name))

    @classmethod
    def read(cls, path: Path) -> DesignFile:
        """Of this machine. ``DesignError`` where it cannot be read, or holds no design."""
        content = read(path)
        # A name that is no UTF-8 text could not be sent to the page.
        name = os.fsencode(path.name).decode("utf-8", "replace")
        return cls(name, content, decode(content, str(path)))

    @classmethod
    def of(cls, design: Design) -> DesignFile:
        """A new file, named after the design."""
        return cls(file_name(design.name, ending=ENDING), dumps(design).encode(), design)


def saved(design: Design, opened: DesignFile | None) -> DesignFile:
    """The file of a design: the one that was opened, to the last byte, where it holds this design."""
    if opened is None or design.name != opened.design.name:
        return DesignFile.of(design)
    return opened if design == opened.design else DesignFile(opened.name, dumps(design).encode(), design)
