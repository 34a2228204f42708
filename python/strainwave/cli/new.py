"""``strainwave new``: a commented design file to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from strainwave.cli.options import Force


def new(
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Write it to FILE; else print it.")] = None,
    force: Force = False,
) -> None:
    """Write a commented design file to start from: module in mm, profile lengths in modules, angles in degrees."""
    from strainwave.design import template
    from strainwave.whole_file import write_whole

    if out is None:
        typer.echo(template(), nl=False)
        return
    write_whole(out, template(), overwrite=force)
    typer.echo(f"{out}: a design to start from; next: strainwave analyze {out}")
