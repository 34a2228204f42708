"""The gear as it turns: GIF, MP4, or a page of its own."""

from strainwave.animation.animate import (
    ANIMATION_FORMATS,
    animate,
    animation_bytes,
    animation_format,
    check_speed,
    write_film,
)
from strainwave.animation.film import Film

__all__ = ["ANIMATION_FORMATS", "Film", "animate", "animation_bytes", "animation_format", "check_speed", "write_film"]
