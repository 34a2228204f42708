"""All that can be exported, and which choices each kind of file leaves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from strainwave.export import FORMATS, TRAITS, Format
from strainwave.studio.orders.film_order import FilmFormat

Field = Literal["part", "state", "tooth", "clearance", "chord-error", "fixed", "frames", "turns", "speed"]
"""A choice: parts, as made or assembled, one tooth, printing clearance, chord error; of a film what stands still, how
many frames, how many turns, how fast."""

LABELS: dict[Format, str] = {
    "dxf": "DXF drawing",
    "svg": "SVG drawing",
    "csv": "CSV points",
    "json": "JSON lines and arcs",
    "step": "STEP solids",
    "stl": "STL meshes",
    "glb": "GLB meshes",
}
FILMS: dict[FilmFormat, tuple[str, str]] = {
    "html": ("HTML animation", "A page of its own that plays, stops and steps through the frames; opens everywhere."),
    "gif": ("GIF animation", "An endless loop for every program that shows pictures."),
    "mp4": ("MP4 animation", "A video for presentations (H.264)."),
}
DESIGN = "toml"


@dataclass(frozen=True)
class Kind:
    """A kind of file."""

    label: str
    holds: str
    fields: frozenset[Field]


def _kinds() -> dict[str, Kind]:
    found: dict[str, Kind] = {}
    for format in FORMATS:
        traits = TRAITS[format]
        fields: set[Field] = {"part", "clearance"}
        if traits.is_deformable:
            fields.add("state")
        if traits.has_single_teeth:
            fields.add("tooth")
        if traits.chord_error_modules is not None:
            fields.add("chord-error")
        found[format] = Kind(LABELS[format], traits.holds, frozenset(fields))
    for film, (label, holds) in FILMS.items():
        found[f"film-{film}"] = Kind(label, holds, frozenset({"fixed", "frames", "turns", "speed"}))
    found[DESIGN] = Kind("TOML design file", "The design as the command and this page read it.", frozenset())
    return found


KINDS: dict[str, Kind] = _kinds()
"""By the key under which a kind is chosen."""
FIELDS: tuple[Field, ...] = get_args(Field)
