"""``strainwave fit``: a profile from a file of points, a drawing or pieces."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from strainwave.cli.options import AsJson, Force


def fit(
    file: Annotated[
        Path,
        typer.Argument(metavar="FILE", help="Points (.csv), drawing (.dxf) or pieces (.json).", show_default=False),
    ],
    design: Annotated[
        Path,
        typer.Option(
            "--design", metavar="DESIGN", help="Design file whose gear it is: its module and numbers of teeth."
        ),
    ],
    spline: Annotated[
        Literal["flexspline", "circular-spline"], typer.Option("--spline", help="Whose profile the file holds.")
    ],
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="Write the design with that profile to FILE.")
    ] = None,
    units: Annotated[
        str | None,
        typer.Option(
            "--units", metavar="UNIT", help="Unit of the file: mm, um, cm, m, inch or modules; else as the file says."
        ),
    ] = None,
    layer: Annotated[
        str | None, typer.Option("--layer", metavar="NAME", help="Read this layer of a drawing only.")
    ] = None,
    center: Annotated[
        str | None, typer.Option("--center", metavar="X,Y", help="The gear's centre in the file, in mm; else found.")
    ] = None,
    axis: Annotated[
        float | None,
        typer.Option("--axis", metavar="DEG", help="Direction of the tooth from there, clockwise from +y; else found."),
    ] = None,
    addendum: Annotated[
        float | None,
        typer.Option("--addendum", metavar="MODULES", help="Cut or continue the flank to this height; else as found."),
    ] = None,
    dedendum: Annotated[
        float | None,
        typer.Option("--dedendum", metavar="MODULES", help="Cut or continue it to this depth; else as found."),
    ] = None,
    noise: Annotated[
        float | None,
        typer.Option("--noise", metavar="UM", help="Standard deviation of measured points in µm; else estimated."),
    ] = None,
    tolerance: Annotated[
        float | None,
        typer.Option(
            "--tolerance", metavar="UM", help="Greatest distance of arcs from the curve; else 0.01, points 0.05."
        ),
    ] = None,
    as_json: AsJson = False,
    force: Force = False,
) -> None:
    """Read a tooth or a flank from a file as arcs and lines, and put it into a design."""
    from strainwave.cli.naming import naming
    from strainwave.design import load, save
    from strainwave.imports import ImportHints, import_flank
    from strainwave.whole_file import check_free

    if out is not None:
        check_free(out, overwrite=force)
    hints = ImportHints(units, layer, _point(center), axis, addendum, dedendum, noise, tolerance)
    with naming(design):
        base = load(design)
    found = import_flank(file, base, "flexspline" if spline == "flexspline" else "circular_spline", hints)
    if out is not None:
        save(found.design, out, overwrite=force)
    if as_json:
        typer.echo(found.to_json())
        return
    from strainwave.cli.console import say
    from strainwave.cli.tables.imported import imported_table

    say(imported_table(found))
    if out is not None:
        typer.echo(f"{out}: the design with this profile; next: strainwave analyze {out}")


def _point(text: str | None) -> tuple[float, float] | None:
    if text is None:
        return None
    try:
        x, y = (float(part) for part in text.split(","))
    except ValueError:
        raise typer.BadParameter(f"{text!r} must be two numbers, such as 0,-81.6", param_hint="--center") from None
    return x, y
