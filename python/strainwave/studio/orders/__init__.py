"""The files that a designer asks for: plain data that says what is wanted, made into bytes in another process."""

from strainwave.studio.orders.design_order import DesignOrder
from strainwave.studio.orders.film_order import FilmOrder
from strainwave.studio.orders.gear_order import GearOrder
from strainwave.studio.orders.order import MOST_BYTES, Order, Product, in_words, made
from strainwave.studio.orders.report_order import ReportOrder

__all__ = ["MOST_BYTES", "DesignOrder", "FilmOrder", "GearOrder", "Order", "Product", "ReportOrder", "in_words", "made"]
