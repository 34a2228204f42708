"""The page's address and title, which follow the design."""

from __future__ import annotations

from nicegui.element import Element

from strainwave.studio.link import design_code
from strainwave.studio.session import Session

PRODUCT = "strainwave"


def title_of(session: Session) -> str:
    """What the browser's tab is called."""
    return f"{session.design.title} – {PRODUCT}"


def parameters_of(session: Session) -> dict[str, str | None]:
    """What a link needs to show the same; None where there is nothing, or too much for a link."""
    return {
        "design": design_code(session.design),
        "reference": design_code(session.pinned.design) if session.pinned else None,
    }


class Address(Element, component="address.js"):
    """Keeps the address bar and the title."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._follow()
        session.followed.connect(self._follow)
        session.repinned.connect(self._follow)

    def _follow(self) -> None:
        self.props.update(parameters=parameters_of(self._session), title=title_of(self._session))

    def copy(self) -> None:
        """Put the link to the present design into the clipboard; "copied" brings "", or what to copy by hand."""
        self.run_method("copy", parameters_of(self._session))
