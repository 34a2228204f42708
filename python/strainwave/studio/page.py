"""The page: the form on the left, the gear in the middle, its figures on the right, and a tab for each study."""

from __future__ import annotations

import asyncio
from importlib import resources

from nicegui import ui

from strainwave.design import Design
from strainwave.studio.figures.figures import figures_panel
from strainwave.studio.form.form import design_form
from strainwave.studio.gear.gear_view import gear_tab
from strainwave.studio.header.address import title_of
from strainwave.studio.header.design_file import DesignFile
from strainwave.studio.header.header import header
from strainwave.studio.header.theme import EARLY_THEME
from strainwave.studio.session import Session
from strainwave.studio.start import started
from strainwave.studio.tabs.assembly_3d import assembly_3d_tab
from strainwave.studio.tabs.comparison import comparison_tab
from strainwave.studio.tabs.exporting import exporting_tab
from strainwave.studio.tabs.optimizer import optimizer_tab
from strainwave.studio.tabs.reporting import reporting_tab
from strainwave.studio.tabs.strip import Strip, Tab
from strainwave.studio.tabs.tolerance import tolerance_tab
from strainwave.studio.tabs.tuner import tuner_tab

STYLES = (
    "studio.css",
    "form/form.css",
    "gear/gear.css",
    "header/header.css",
    "figures/figures.css",
    "tabs/tabs.css",
    "tabs/studies.css",
)
TABS = (
    Tab("gear", "Gear", gear_tab),
    Tab("w0", "w0", tuner_tab),
    Tab("generators", "Generators", comparison_tab),
    Tab("tolerance", "Tolerance", tolerance_tab),
    Tab("optimize", "Optimise", optimizer_tab),
    Tab("assembly", "3D", assembly_3d_tab),
    Tab("export", "Export", exporting_tab),
    Tab("report", "Report", reporting_tab),
)


async def build_page(design: Design, file: DesignFile | None = None) -> Session:
    """Everything on one page, for a session of its own: the design of the page's address, or `design`, of that file."""
    session, broken_link = await asyncio.to_thread(started, design, ui.context.client.request.query_params)
    ui.context.client.on_delete(session.close)
    ui.page_title(title_of(session))
    ui.add_head_html(EARLY_THEME)
    for style in STYLES:
        ui.add_css(resources.files("strainwave.studio").joinpath(style).read_text(encoding="utf-8"))
    with ui.element("header").classes("studio-header"):
        header(session, file, broken_link)
    with ui.element("div").classes("studio"):
        with ui.element("section").classes("studio-form").props('aria-label="Design"') as form:
            design_form(session)
        with ui.element("section").classes("studio-centre").props('aria-label="Gear and studies"') as centre:
            Strip(session, TABS)
        with ui.element("aside").classes("studio-figures").props('aria-label="Key figures"') as figures:
            figures_panel(session)
    for words, target in (("To the design", form), ("To the gear", centre), ("To the key figures", figures)):
        ui.skip_link(words, target=target)
    return session
