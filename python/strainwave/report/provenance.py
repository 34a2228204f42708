"""Where a report comes from, so that it can be made again: the same design and command give the same bytes."""

from __future__ import annotations

import hashlib
import shlex
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from strainwave.design import Design


@dataclass(frozen=True)
class Provenance:
    """The program's version, the command as it was given, and a date where the user gives one."""

    version: str
    command: str = ""
    date: str = ""

    @classmethod
    def of(cls, arguments: Sequence[str] = (), date: str = "") -> Provenance:
        """The provenance of a report that is made now by the command with these arguments, or from Python."""
        from strainwave import __version__

        return cls(__version__, shlex.join(["strainwave", *arguments]) if arguments else "", date)

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """What is known, by name."""
        known = (("strainwave", self.version), ("command", self.command), ("date", self.date))
        return tuple((name, value) for name, value in known if value)


def design_hash(design: Design) -> str:
    """SHA-256 of the design's canonical text: the same for design files that say the same."""
    from strainwave.design import dumps

    return hashlib.sha256(dumps(design).encode()).hexdigest()
