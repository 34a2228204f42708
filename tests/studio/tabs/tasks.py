"""Tasks that stand in for long ones."""

from __future__ import annotations

import gzip

from strainwave.studio.jobs import Limits, Report
from strainwave.studio.orders import Order, Product


def named(order: Order, limits: Limits, report: Report) -> Product:
    """A file that says only what was asked for."""
    text = repr(order).encode()
    return Product(order.file_name, order.media_type, gzip.compress(text), len(text))
