"""The tab of the gear in space: the verdict along the face, the gear to turn, and the map of its face."""

from __future__ import annotations

from nicegui import context, ui

from strainwave.analysis.verdict import Level
from strainwave.errors import StrainwaveError
from strainwave.studio.jobs import CancelledError, Jobs, Limits
from strainwave.studio.parcels import Parcels
from strainwave.studio.picture import Picture
from strainwave.studio.session import Session
from strainwave.studio.space.renewal import Renewal
from strainwave.studio.space.space_view import DETAILS, NoSpaceView, SpaceRequest, SpaceView, space_view
from strainwave.studio.space.turnable import Turnable
from strainwave.studio.tabs.strip import Refresh

WORKING = "Bending the cup …"
LIMITS = Limits(seconds=120.0, threads=1)


def assembly_3d_tab(session: Session) -> Refresh:
    """The gear in space, computed when it is seen."""
    return _Space(session).refresh


class _Space:
    """Widgets over the last view that could be made."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._parcels = Parcels(context.client)
        self._views = Jobs(LIMITS)
        """Of its own, so that the gear can be looked at while a study runs."""
        context.client.on_delete(self._views.close)
        self._renewal = Renewal(self._renew)
        with ui.element("div").classes("space is-empty") as self._root:
            with ui.element("div").classes("space-words").props('role="status"'):
                self._sentence = ui.label().classes("space-verdict")
                self._along_face = ui.label().classes("space-along")
            with ui.element("div").classes("space-tools"):
                self._detail = ui.toggle(
                    {detail: detail.capitalize() for detail in DETAILS}, value="normal", on_change=self._redraw
                ).props('dense no-caps unelevated size=sm aria-label="Detail of the picture"')
                self._again = ui.button("Try again", on_click=self._redraw).props("dense outline no-caps")
                self._again.visible = False
                with ui.element("div").classes("space-working") as self._working:
                    ui.spinner(size="1.2em")
                    ui.label(WORKING)
            self._gear = Turnable("The gear in space, its teeth coloured by their clearance").classes("space-gear")
            ui.label("Backlash along the face, from the diaphragm’s side up to the open end").classes("space-title")
            self._map = Picture("Backlash of every tooth in every section along the face").classes("space-map")
        self._renewal.want(at_once=True)

    def refresh(self) -> None:
        """The design has changed."""
        self._show_state(working=True)
        self._views.cancel()
        self._renewal.want()

    def _redraw(self) -> None:
        self._show_state(working=True)
        self._views.cancel()
        self._renewal.want(at_once=True)

    async def _renew(self) -> None:
        if self._root.is_deleted:
            return
        request = SpaceRequest(self._session.design, self._session.threshold_um, str(self._detail.value))
        try:
            view = await self._views.run("view in space", space_view, request, lambda share, words: None)
        except CancelledError:
            return  # the next one is wanted already, or the page is gone
        except StrainwaveError as error:
            self._refuse(f"The picture could not be made now: {error}", level="undecided", again=True)
            return
        if isinstance(view, NoSpaceView):
            self._refuse("This design has no picture in space.", view.why, level="interference")
        else:
            self._show(view)

    def _show(self, view: SpaceView) -> None:
        if self._root.is_deleted:
            return
        self._sentence.text, self._along_face.text = view.sentence, view.along_face
        self._sentence.classes(replace=f"space-verdict is-{view.level}")
        self._gear.show(self._parcels.put("gear", view.gear))
        self._map.show(view.face_figure)
        self._root.classes(remove="is-empty")
        self._show_state(working=False)

    def _refuse(self, sentence: str, why: str = "", *, level: Level, again: bool = False) -> None:
        if self._root.is_deleted:
            return
        self._sentence.text, self._along_face.text = sentence, why
        self._sentence.classes(replace=f"space-verdict is-{level}")
        self._show_state(working=False, refused=True, again=again)

    def _show_state(self, *, working: bool, refused: bool = False, again: bool = False) -> None:
        """While the next view is made the last one is dimmed; one that cannot be made leaves it so."""
        self._working.visible, self._again.visible = working, again
        states = {"is-stale": working, "is-refused": refused}
        self._root.classes(
            add=" ".join(name for name, holds in states.items() if holds),
            remove=" ".join(name for name, holds in states.items() if not holds),
        )
