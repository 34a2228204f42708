"""TOML files in, with one clear error for whatever is no TOML."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from strainwave.errors import LONGEST_TEXT_SHOWN, DesignError, Fault, shown_text

LARGEST_FILE_BYTES = 1_000_000

_POSITION = re.compile(r"^(?P<problem>.*) \(at (?:line (?P<line>\d+), column (?P<column>\d+)|end of document)\)$", re.S)


@dataclass(frozen=True)
class TomlFile:
    """A kind of file."""

    noun: str
    """What it is called."""
    holds: str
    """What it holds, without an article."""
    start: str
    """What to do about an empty one."""

    def text(self, source: str) -> str:
        """The text of the file at the path `source`. DesignError says why it cannot be read."""
        return self.decoded(self.content(source), source)

    def content(self, source: str) -> bytes:
        """The bytes of the file, or one more than are allowed. DesignError says why it cannot be read."""
        try:
            with Path(source).open("rb") as file:
                return file.read(LARGEST_FILE_BYTES + 1)
        except (OSError, ValueError) as error:  # ValueError: a path with a null character
            raise DesignError([Fault("", problem=self._why_unreadable(error))], source) from None

    def decoded(self, content: bytes, source: str) -> str:
        """The text in the bytes of a file. DesignError where it is too large, or no text."""
        if len(content) > LARGEST_FILE_BYTES:
            problem = f"is larger than {LARGEST_FILE_BYTES // 1_000_000} MB, so it is no {self.noun}"
            raise DesignError([Fault("", problem=problem)], source)
        try:
            text = content.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            line = content.count(b"\n", 0, error.start) + 1
            fault = Fault(f"line {line}", problem="is not UTF-8 text", remedy="Save the file as UTF-8 text in TOML")
            raise DesignError([fault], source) from None
        if "\0" in text:
            raise DesignError([Fault("", problem=f"is a binary file, not a {self.holds} in TOML")], source)
        return text

    def tree(self, text: str, source: str | None) -> dict[str, Any]:
        """The tree of tables in TOML text. DesignError names the place that is no TOML, and `source`."""
        try:
            tree = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            raise DesignError([_syntax_fault(text, str(error))], source) from None
        except RecursionError:
            raise DesignError([Fault("", problem="nests arrays or tables too deeply to read")], source) from None
        except ValueError:  # int() refuses a number of more than 4300 digits
            raise DesignError([Fault("", problem="holds a number of thousands of digits")], source) from None
        if not tree:
            raise DesignError([Fault("", problem=f"is empty: it holds no {self.holds}", remedy=self.start)], source)
        return tree

    def _why_unreadable(self, error: OSError | ValueError) -> str:
        if isinstance(error, IsADirectoryError):
            return f"is a directory, not a {self.noun}"
        if isinstance(error, FileNotFoundError):
            return "there is no such file"
        if isinstance(error, PermissionError):
            return "may not be read: permission denied"
        return f"cannot be read: {error.strerror if isinstance(error, OSError) else error}"


def _syntax_fault(text: str, message: str) -> Fault:
    """The parser's message with its place as the key and the line that it could not read."""
    match = _POSITION.match(message)
    if match is None:
        return Fault("", problem=f"is not TOML: {shown_text(message[:LONGEST_TEXT_SHOWN])}")
    problem = f"is not TOML: {shown_text(match['problem'][:LONGEST_TEXT_SHOWN])}"
    if match["line"] is None:
        return Fault("the end of the file", problem=problem, remedy="Close what is open there")
    line = int(match["line"])
    written = text.split("\n")[line - 1].strip()
    return Fault(
        f"line {line}, column {match['column']}",
        problem=problem,
        remedy=f"The line reads: {shown_text(written[:LONGEST_TEXT_SHOWN])}",
    )
