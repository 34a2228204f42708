"""Frames as an animated GIF, which every program shows."""

from __future__ import annotations

import io
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from strainwave.animation.stage import Pixels
from strainwave.plots.clearance_colours import STEPS, mixed, step_colour
from strainwave.plots.looks import LOOKS

if TYPE_CHECKING:
    from PIL.Image import Image

WHITE, BLACK = "#FFFFFF", "#222222"
FASTEST_PER_S = 50.0  # what lasts less than two hundredths of a second, most programs show much longer
HUNDREDTHS = 100  # of a second, in which the format counts
# Each colour also part way to the black of the outlines and of letters, where their edges blend into it.
TOWARDS_BLACK = (0.0, 0.25, 0.5, 0.75)


def gif_bytes(frames: Iterable[Pixels], count: int, frames_per_s: float) -> bytes:
    """An endless loop of `count` frames in the pictures' own colours.

    Without dithering: areas stay plain and the file small.
    """
    from PIL import Image

    colours = _palette()
    shown = (Image.fromarray(pixels).quantize(palette=colours, dither=Image.Dither.NONE) for pixels in frames)
    file = io.BytesIO()
    durations = durations_ms(count, frames_per_s)
    next(shown).save(file, format="GIF", save_all=True, append_images=shown, duration=durations, loop=0)
    return file.getvalue()


def durations_ms(count: int, frames_per_s: float) -> list[int]:
    """How long each frame lasts: whole hundredths of a second, so spread that the whole film keeps its time."""
    ends = np.rint(HUNDREDTHS * np.arange(count + 1) / frames_per_s).astype(np.int64)
    durations: list[int] = (np.diff(ends) * (1000 // HUNDREDTHS)).tolist()
    return durations


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
