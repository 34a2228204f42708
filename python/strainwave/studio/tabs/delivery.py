"""From an order to a file in the reader's hands: button, progress, cancel, and the file or what went wrong."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import context, ui

from strainwave.errors import StrainwaveError
from strainwave.studio.orders import Order, Product, in_words, made
from strainwave.studio.parcels import Parcels
from strainwave.studio.session import Session
from strainwave.studio.tabs.runner import Runner

OF_BEFORE = "of the design before its last change"


class Delivery:
    """Makes one file at a time as a job of the session, and keeps the last one for as long as the page is open."""

    def __init__(
        self,
        session: Session,
        what: str,
        order: Callable[[], Order],
        *,
        save: bool = True,
        done: Callable[[Order, str], None] = lambda order, address: None,
    ) -> None:
        """`what` names the work, as "export"; `order` says what is wanted when the button is pressed. `save` hands the
        file to the browser at once, else it can be opened too; `done` hears the address of the file."""
        self._session, self._what, self._order, self._save, self._done = session, what, order, save, done
        self._parcels = Parcels(context.client)
        self._product: Product | None = None
        self._fault = ""
        with ui.element("div").classes("delivery") as self._root:
            with ui.element("div").classes("delivery-row"):
                self._button = ui.button(on_click=self._start).props("dense no-caps unelevated color=primary")
                self._offer = ui.label().classes("delivery-offer").props('role="status"')
            self._runner = Runner(session, what)
            with ui.element("div").classes("delivery-row") as self._result:
                self._link = ui.link().classes("delivery-link").props("download")
                self._opener = ui.link("Open in a new tab", new_tab=True)
                self._size = ui.label().classes("delivery-size")
        self._opener.visible = not save
        self._result.visible = False
        session.jobs.changed.connect(self._show_state)

    def offer(self, label: str, words: str, fault: str = "") -> None:
        """What the button would make, or why it cannot."""
        self._button.text, self._offer.text, self._fault = label, fault or words, fault
        self._offer.classes(add="is-bad" if fault else "", remove="" if fault else "is-bad")
        self._show_state()

    def age(self) -> None:
        """The design has changed: a file that is there is of the one before."""
        if self._product is not None:
            self._size.text = f"{in_words(self._product.size)}, {OF_BEFORE}"

    async def _start(self) -> None:
        try:
            order = self._order()
        except StrainwaveError as error:
            self._runner.say(str(error), bad=True)
            return
        self._forget()
        design = self._session.design
        product = await self._runner.run(made, order)
        if product is None:
            return
        self._show(order, product)
        if self._session.design is not design:
            self.age()

    def _show_state(self) -> None:
        """After a job, of whatever tab, has begun or ended, or the offer has changed."""
        if not self._root.is_deleted:
            self._button.set_enabled(not self._session.jobs.running and not self._fault)

    def _show(self, order: Order, product: Product) -> None:
        self._product = product
        address = self._parcels.put(self._what, product, save=self._save)
        self._link.text = product.file_name
        self._link.props["href"] = self._opener.props["href"] = address
        self._size.text = in_words(product.size)
        self._result.visible = True
        with self._root:
            if self._save:
                ui.download.from_url(address, product.file_name, product.media_type)
            self._done(order, address)

    def _forget(self) -> None:
        self._product = None
        self._parcels.remove(self._what)
        self._result.visible = False
