"""The tab of the report: made on demand, looked at here, opened by itself, or saved."""

from __future__ import annotations

from typing import cast

from nicegui import ui

from strainwave.studio.orders import Order, ReportOrder
from strainwave.studio.orders.report_order import ReportFormat
from strainwave.studio.session import Session
from strainwave.studio.tabs.delivery import Delivery
from strainwave.studio.tabs.strip import Refresh

FORMATS: dict[ReportFormat, str] = {"html": "Page (HTML)", "pdf": "Paper (PDF)"}
LONGEST_TITLE, LONGEST_DATE = 120, 40


def reporting_tab(session: Session) -> Refresh:
    """The report of the design as it is."""
    return _Reporting(session).refresh


class _Reporting:
    """What is asked of the report, and the last one."""

    def __init__(self, session: Session) -> None:
        self._session = session
        with ui.element("div").classes("report"):
            with ui.element("div").classes("report-fields"):
                self._format = ui.select(FORMATS, label="Report as", value="html", on_change=self.refresh)
                self._title = ui.input("Title, else the design's name").props(f"maxlength={LONGEST_TITLE}")
                self._date = ui.input("Date to print, else none").props(f"maxlength={LONGEST_DATE}")
                for field in (self._format, self._title, self._date):
                    field.props("dense outlined options-dense hide-bottom-space")
            self._delivery = Delivery(session, "report", self._order, save=False, done=self._show)
            self._page = ui.element("iframe").classes("report-page")
            # Without the page's own origin: the report's script sees nothing of the studio.
            self._page.props('sandbox="allow-scripts allow-downloads allow-modals" title="Report"')
        self._page.visible = False
        self.refresh()

    def refresh(self) -> None:
        """The design or the form has changed."""
        self._delivery.age()
        self._delivery.offer("Make the report", self._order().words(self._session.analysis))

    def _order(self) -> Order:
        return ReportOrder(
            design=self._session.design,
            format=cast(ReportFormat, self._format.value),
            threshold_um=self._session.threshold_um,
            title=str(self._title.value or "")[:LONGEST_TITLE].strip(),
            date=str(self._date.value or "")[:LONGEST_DATE].strip(),
        )

    def _show(self, order: Order, address: str) -> None:
        """A page is looked at here; a browser shows paper in a window of its own."""
        is_page = isinstance(order, ReportOrder) and order.format == "html"
        self._page.visible = is_page
        if is_page:
            self._page.props["src"] = address
            self._page.update()
