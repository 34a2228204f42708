"""pyarrow, which holds the rows of an exploration and reads and writes them as Parquet; imported when used."""

from __future__ import annotations

import importlib
from typing import Any

from strainwave.errors import StrainwaveError


def arrow(module: str = "") -> Any:
    """pyarrow or a module of it; ``StrainwaveError`` where it is not installed."""
    return cluster_module(f"pyarrow.{module}" if module else "pyarrow")


def cluster_module(name: str) -> Any:
    """A module that the extra ``cluster`` brings; ``StrainwaveError`` where it is not installed."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        raise StrainwaveError(f"an exploration needs {package} ({error}): pip install 'strainwave[cluster]'") from None
