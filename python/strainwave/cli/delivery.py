"""What a study leaves behind: a report and files, none of which another costs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeVar

import typer

from strainwave.errors import StrainwaveError

if TYPE_CHECKING:
    from rich.console import RenderableType

INTERRUPTED = 130

Write = Callable[..., object]
"""Writes a file, called with its path and ``overwrite=``."""


class Result(Protocol):
    """What a study found."""

    def to_json(self) -> str: ...


Found = TypeVar("Found", bound=Result)


def check_outputs(pictures: Sequence[Path | None], files: Sequence[Path | None], *, overwrite: bool) -> None:
    """Refuse a picture or a file that could not be written, or would be lost, before anything is computed for it."""
    from strainwave.cli.pictures import check_picture
    from strainwave.whole_file import check_free

    for picture in pictures:
        check_picture(picture, overwrite=overwrite)
    for file in files:
        if file is not None:
            check_free(file, overwrite=overwrite)
    _check_apart([path for path in (*pictures, *files) if path is not None])


def _check_apart(paths: Iterable[Path]) -> None:
    """Refuse two outputs in one file, of which one would be lost; a device or a pipe takes them all."""
    seen = set()
    for path in paths:
        place = path.resolve()
        if place in seen and (place.is_file() or not place.exists()):
            raise StrainwaveError(f"{path}: is named for two outputs; give each a file of its own")
        seen.add(place)


def deliver(
    result: Found,
    report: Callable[[Found], Iterable[RenderableType]],
    files: Sequence[tuple[Path | None, Write]],
    *,
    as_json: bool,
    overwrite: bool,
) -> None:
    """Print the report, write the files that are asked for, in their order, and exit 130 after Ctrl-C.

    A reader who goes away, or a full output, costs no file, and a file that cannot be written no other.
    """
    try:
        _print(result, report, as_json)
    finally:
        _write_all([partial(write, path, overwrite=overwrite) for path, write in files if path is not None])
    if getattr(result, "interrupted", False):
        raise typer.Exit(INTERRUPTED)


def _write_all(writers: Sequence[Callable[[], object]]) -> None:
    """Write every file, also where another cannot be written; one ``StrainwaveError`` names those that were not."""
    failures = []
    for write in writers:
        try:
            write()
        except StrainwaveError as error:
            failures.append(str(error))
    if failures:
        raise StrainwaveError("; ".join(failures))


def _print(result: Found, report: Callable[[Found], Iterable[RenderableType]], as_json: bool) -> None:
    if as_json:
        typer.echo(result.to_json())
        return
    from strainwave.cli.console import say

    say(*report(result))
