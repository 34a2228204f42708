"""``strainwave animate``: the gear as it turns."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from strainwave.cli.options import DesignFile, Force, Threshold


def animate(
    design: DesignFile,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            metavar="FILE",
            help="Write FILE.html, a page of its own that plays and steps, FILE.gif or FILE.mp4.",
            show_default=False,
        ),
    ],
    fixed: Annotated[
        Literal["circular-spline", "flexspline"],
        typer.Option("--fixed", metavar="SPLINE", help="Which one stands still, circular-spline or flexspline."),
    ] = "circular-spline",
    frames: Annotated[int, typer.Option("--frames", metavar="N", help="How many frames it has.")] = 120,
    turns: Annotated[
        float,
        typer.Option(
            "--turns", metavar="T", help="Turns of the wave generator in all, clockwise; the other way below 0."
        ),
    ] = 1.0,
    fps: Annotated[
        float, typer.Option("--fps", metavar="N", help="Frames per second, up to 60; of a GIF up to 50.")
    ] = 20.0,
    threshold: Threshold = 10.0,
    force: Force = False,
) -> None:
    """Let the wave generator turn: the mesh in motion, its teeth coloured by clearance, at the right ratio."""
    from strainwave.analysis import analyze
    from strainwave.animation import Film, animation_format, write_film
    from strainwave.cli.naming import naming
    from strainwave.cli.progress import watched
    from strainwave.design import load
    from strainwave.whole_file import check_free

    animation_format(out)
    check_free(out, overwrite=force)
    with naming(design):
        result = analyze(load(design), threshold_um=threshold)
        film = Film.of(result, frames=frames, turns=turns, fixed=fixed, frames_per_s=fps)
        with watched("frames") as progress:
            write_film(film, out, overwrite=force, progress=progress)
    typer.echo(f"{out}: {len(film)} frames; {film.words}")
    typer.echo(result.verdict)
