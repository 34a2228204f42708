"""How a window starts: with the design and the reference of its address, or with the studio's own."""

from __future__ import annotations

from collections.abc import Mapping

from strainwave.analysis import analyze
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studio.link import coded_design
from strainwave.studio.session import Session


def started(design: Design, query: Mapping[str, str]) -> tuple[Session, StrainwaveError | None]:
    """A session, with what was wrong with the link; then it has the studio's own design and no reference."""
    try:
        session = Session(coded_design(query["design"]) if query.get("design") else design)
        if query.get("reference"):
            session.pinned = analyze(coded_design(query["reference"]), threshold_um=session.threshold_um)
        return session, None
    except StrainwaveError as error:
        return Session(design), error
