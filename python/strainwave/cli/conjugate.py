"""``strainwave conjugate``: the profile that one spline generates on the other."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from strainwave.cli.options import AsJson, DesignFile, Force

if TYPE_CHECKING:
    from strainwave.conjugation import Conjugate


def conjugate(
    design: DesignFile,
    of: Annotated[
        Literal["circular-spline", "flexspline"],
        typer.Option(
            "--of",
            metavar="SPLINE",
            help="Whose profile is sought, circular-spline or flexspline; the other generates it.",
        ),
    ] = "circular-spline",
    tolerance: Annotated[
        float, typer.Option("--tolerance", metavar="UM", help="How far arcs may lie from the envelope, in µm.")
    ] = 0.01,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="Write the design with the new profile to FILE.")
    ] = None,
    as_json: AsJson = False,
    plot: Annotated[
        Path | None,
        typer.Option("--plot", metavar="FILE", help="Draw envelope and zones: FILE.png, FILE.svg or FILE.pdf."),
    ] = None,
    force: Force = False,
) -> None:
    """The profile (arcs and lines) that one spline generates on the other, without backlash where they touch."""
    from functools import partial

    from strainwave.cli.delivery import write_all
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import check_picture, write_picture
    from strainwave.conjugation import conjugate as compute
    from strainwave.design import load, save
    from strainwave.whole_file import check_free

    check_picture(plot, overwrite=force)
    if out is not None:
        check_free(out, overwrite=force)
    with naming(design):
        result = compute(load(design), of=of, tolerance_um=tolerance)
    writers: list[Callable[[], None]] = [partial(write_picture, result, plot, overwrite=force)]
    if out is not None:
        writers.append(partial(save, result.design, out, overwrite=force))
    try:
        _print(result, as_json)
    finally:  # a reader who goes away, or a full output, costs no file
        write_all(writers)


def _print(result: Conjugate, as_json: bool) -> None:
    if as_json:
        typer.echo(result.to_json())
        return
    from strainwave.cli.console import say
    from strainwave.cli.tables.conjugate import conjugate_report

    say(*conjugate_report(result))
