"""How each part of a scene looks, in static and interactive pictures alike."""

from __future__ import annotations

from dataclasses import dataclass

from strainwave.plots.style import GREEN, GREY, INK, PURPLE
from strainwave.scene import Role

# Paler than the house's colours, so that teeth coloured by clearance stand out from them.
PALE_ORANGE = "#F7E2B5"
PALER_GREY = "#ECECEC"
PALE_BLUE = "#F3F7FB"
PALE_GREEN = "#DCEBE3"
MIDDLE_GREY = "#C9C9C9"


@dataclass(frozen=True)
class Look:
    """Colours of the face and the edge, the edge's width in points and its dashes; without a face a line only."""

    face: str | None
    edge: str
    width: float
    dashes: tuple[float, ...] = ()


LOOKS: dict[Role, Look] = {
    "circular spline": Look(PALE_ORANGE, INK, 0.5),
    "flexspline": Look(PALE_BLUE, INK, 0.5),
    "flexspline tooth": Look(None, INK, 0.5),
    "bearing": Look(PALE_GREEN, GREY, 0.6),
    "wave generator": Look(PALER_GREY, GREY, 0.8),
    "neutral curve": Look(None, PURPLE, 1.2, (6.0, 2.0, 1.5, 2.0)),
    "major axis": Look(MIDDLE_GREY, INK, 0.9),
    "mark": Look(GREEN, INK, 0.6),
    "witness": Look(None, INK, 1.0),
}
