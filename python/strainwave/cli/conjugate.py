"""``strainwave conjugate``: the profile that one spline generates on the other."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from strainwave.cli.options import AsJson, DesignFile, Force


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

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.tables.conjugate import conjugate_report
    from strainwave.conjugation import conjugate as compute
    from strainwave.design import load, save

    check_outputs([plot], [out], overwrite=force)
    with naming(design):
        result = compute(load(design), of=of, tolerance_um=tolerance)
    deliver(
        result,
        conjugate_report,
        [(out, partial(save, result.design)), (plot, partial(write_picture, result))],
        as_json=as_json,
        overwrite=force,
    )
