"""Faults of a design file name the file, also those that only its geometry shows."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from strainwave.errors import DesignError


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Put the file's name in front of a design error raised inside the block."""
    try:
        yield
    except DesignError as error:
        raise DesignError(error.faults, error.source or str(path)) from None
