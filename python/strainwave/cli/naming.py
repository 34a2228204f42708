"""Faults of a design file name the file, also those that only its geometry shows, and those of an option the option."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from strainwave.errors import DesignError


@contextmanager
def naming(source: Path | str) -> Iterator[None]:
    """Put the name of the file or option in front of a design error raised inside the block."""
    try:
        yield
    except DesignError as error:
        raise DesignError(error.faults, error.source or str(source)) from None
