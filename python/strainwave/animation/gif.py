"""Frames as an animated GIF, which every program shows."""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from strainwave.animation.stage import Pixels
from strainwave.plots.clearance_colours import STEPS, mixed, step_colour
from strainwave.plots.looks import LOOKS

if TYPE_CHECKING:
    from PIL.Image import Image

WHITE, BLACK = "#FFFFFF", "#222222"
# Each colour also part way to the black of the outlines and of letters, where their edges blend into it.
TOWARDS_BLACK = (0.0, 0.25, 0.5, 0.75)
MILLISECONDS = 1000.0


def gif_bytes(frames: Iterable[Pixels], frames_per_s: float) -> bytes:
    """An endless loop in the pictures' own colours, without dithering: areas stay plain and the file small."""
    from PIL import Image

    colours = _palette()
    shown = (Image.fromarray(pixels).quantize(palette=colours, dither=Image.Dither.NONE) for pixels in frames)
    file = io.BytesIO()
    duration = round(MILLISECONDS / frames_per_s)
    next(shown).save(file, format="GIF", save_all=True, append_images=shown, duration=duration, loop=0)
    return file.getvalue()


def _palette() -> Image:
    """An image that has the colours of the pictures."""
    from PIL import Image
    from PIL.ImageColor import getrgb

    colours = list(dict.fromkeys(_colours()))
    image = Image.new("P", (1, 1))
    image.putpalette([channel for colour in colours for channel in getrgb(colour)])
    return image


def _colours() -> Iterator[str]:
    faces = [look.face for look in LOOKS.values() if look.face not in (None, "white")]
    edges = [look.edge for look in LOOKS.values()]
    for colour in (WHITE, *faces, *edges, *(step_colour(step) for step in range(-1, STEPS))):
        if colour is not None:
            yield from (mixed(colour, BLACK, share) for share in TOWARDS_BLACK)
