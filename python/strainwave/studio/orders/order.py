"""A file that is wanted, and what comes of it."""

from __future__ import annotations

import gzip
from dataclasses import dataclass
from typing import Protocol

from strainwave.analysis import Analysis
from strainwave.errors import StrainwaveError
from strainwave.studies.progress import Progress
from strainwave.studio.jobs import Limits, Report

MOST_BYTES = 150_000_000
"""Of one file that goes through the page; larger ones are for the command."""
BYTES_PER_KB, BYTES_PER_MB = 1e3, 1e6
# Nearly as small as with 9, in a fifth of the time.
COMPRESSION = 3


class Order(Protocol):
    """What is wanted: plain data, so that it can be sent to another process."""

    @property
    def file_name(self) -> str:
        """The name that the file gets, from safe characters only."""

    @property
    def unit(self) -> str:
        """What progress is counted in, in the plural; "" where it is not known."""

    @property
    def media_type(self) -> str:
        """Of the file, as browsers name it."""

    def words(self, analysis: Analysis) -> str:
        """What the file will hold of the design that was analysed; StrainwaveError where a look shows that it cannot
        be."""

    def content(self, progress: Progress) -> str | bytes:
        """The file's content, the same as the command writes; StrainwaveError where it cannot be made."""


@dataclass(frozen=True)
class Product:
    """A file that is ready to be fetched."""

    file_name: str
    media_type: str
    packed: bytes
    """Its content, packed by gzip, as browsers unpack it: what is packed here the server's loop need not pack."""
    size: int
    """Bytes of the content as it will be saved."""


def made(order: Order, limits: Limits, report: Report) -> Product:
    """Fulfil an order: a task for a job. StrainwaveError where that cannot be."""
    report(0.0, "working …")
    content = order.content(lambda done, total: report(done / total, f"{done} of {total} {order.unit}"))
    data = content.encode() if isinstance(content, str) else content
    if len(data) > MOST_BYTES:
        raise StrainwaveError(
            f"would have {in_words(len(data))}, more than the {in_words(MOST_BYTES)} that the studio hands out; choose "
            "coarser or less, or use the command"
        )
    return Product(order.file_name, order.media_type, gzip.compress(data, COMPRESSION, mtime=0), len(data))


def in_words(size: int) -> str:
    """Bytes in kB or MB."""
    return f"{size / BYTES_PER_MB:.1f} MB" if size >= BYTES_PER_MB else f"{size / BYTES_PER_KB:.1f} kB"
