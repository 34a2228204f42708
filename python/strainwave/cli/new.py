"""``strainwave new``: a commented design file to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from strainwave.cli.options import Force


def new(
    design: Annotated[
        Path | None, typer.Argument(metavar="DESIGN", help="The same as --out DESIGN.", show_default=False)
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Write it to FILE; else print it.")] = None,
    force: Force = False,
) -> None:
    """Write a commented design file to start from: module in mm, profile lengths in modules, angles in degrees."""
    from strainwave.design import template
    from strainwave.whole_file import write_whole

    if design is not None and out is not None:
        raise typer.BadParameter(f"{out} and {design}: name one file", param_hint="--out")
    file = out or design
    if file is None:
        typer.echo(template(), nl=False)
        return
    write_whole(file, template(), overwrite=force)
    typer.echo(f"{file}: a design to start from; next: strainwave analyze {file}")
