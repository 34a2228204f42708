"""From an analysis to a file that moves: the one function behind every face."""

from __future__ import annotations

from pathlib import Path

from strainwave.analysis import Analysis
from strainwave.animation.film import Film
from strainwave.errors import StrainwaveError
from strainwave.scene import Fixed
from strainwave.studies.progress import Progress, silent
from strainwave.whole_file import check_free, write_whole

ANIMATION_FORMATS = ("gif", "mp4", "html")


def animate(
    analysis: Analysis,
    path: str | Path,
    *,
    frames: int = 120,
    turns: float = 1.0,
    fixed: Fixed = "circular-spline",
    frames_per_s: float = 20.0,
    overwrite: bool = False,
    progress: Progress = silent,
) -> None:
    """Write the gear as its wave generator turns clockwise, as .gif, .mp4 or .html by the file's name.

    Teeth are coloured by their clearance in each frame. Either spline is held fixed, and the other turns as it does in
    the gear. The page needs nothing but itself. A film has up to 60 frames per second, a .gif up to 50.
    StrainwaveError where a number is out of range, the file cannot be written, or .mp4 is asked for without the extra
    ``video``.
    """
    film = Film.of(analysis, frames=frames, turns=turns, fixed=fixed, frames_per_s=frames_per_s)
    write_film(film, path, overwrite=overwrite, progress=progress)


def write_film(film: Film, path: str | Path, *, overwrite: bool = False, progress: Progress = silent) -> None:
    """Write a film in the format that the file's name asks for, whole or not at all."""
    kind, target = animation_format(path), Path(path)
    check_free(target, overwrite=overwrite)
    write_whole(target, animation_bytes(film, kind, progress), overwrite=overwrite)


def animation_format(path: str | Path) -> str:
    """The format that the file's name asks for; StrainwaveError where it is none of gif, mp4, html."""
    asked = Path(path).suffix.lower().removeprefix(".")
    if asked not in ANIMATION_FORMATS:
        raise StrainwaveError(f"{path}: an animation's name must end in .gif, .mp4 or .html")
    return asked


def check_speed(film: Film, kind: str) -> None:
    """StrainwaveError where a format cannot show a film as fast as it is."""
    from strainwave.animation.gif import FASTEST_PER_S

    if kind == "gif" and film.frames_per_s > FASTEST_PER_S:
        raise StrainwaveError(
            f"a GIF shows at most {FASTEST_PER_S:g} frames per second, not {film.frames_per_s:g}: take fewer, "
            "or write .mp4 or .html"
        )


def animation_bytes(film: Film, kind: str, progress: Progress = silent) -> bytes:
    """A film as gif, mp4 or html. StrainwaveError where that cannot be, before anything is drawn."""
    check_speed(film, kind)
    if kind == "html":
        from strainwave.animation.page import page

        return page(film, progress).encode()
    from strainwave.animation.stage import pictures

    frames = pictures(film, progress)
    if kind == "mp4":
        from strainwave.animation.mp4 import mp4_bytes

        return mp4_bytes(frames, film.frames_per_s)
    from strainwave.animation.gif import gif_bytes

    return gif_bytes(frames, len(film), film.frames_per_s)
