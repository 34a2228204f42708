"""A chunk's rows as the bytes of a Parquet file."""

from __future__ import annotations

from typing import Any

from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.rows import GENERATOR, STATUS


def parquet_bytes(table: Any) -> bytes:
    """A table as a Parquet file: the same bytes for the same rows.

    Values of a number over a space begin alike and end at random, so that bytes of equal weight stand together.
    """
    floats = [field.name for field in table.schema if field.type == arrow().float64()]
    sink = arrow().BufferOutputStream()
    arrow("parquet").write_table(
        table,
        sink,
        compression="zstd",
        compression_level=1,
        use_dictionary=[GENERATOR, STATUS],
        use_byte_stream_split=floats,
        write_statistics=False,
    )
    found: bytes = sink.getvalue().to_pybytes()
    return found
