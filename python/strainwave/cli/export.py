"""``strainwave export``: a gear for drawing, machining, printing and CAD."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from strainwave.cli.options import DesignFile, Force


def export(
    format: Annotated[
        Literal["dxf", "svg", "csv", "json", "step", "stl", "glb"],
        typer.Argument(metavar="FORMAT", help="dxf, svg, csv, json, step, stl or glb.", show_default=False),
    ],
    design: DesignFile,
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="Write to FILE.", show_default=False)],
    part: Annotated[
        Literal["all", "flexspline", "circular-spline", "wave-generator"],
        typer.Option("--part", metavar="PART", help="flexspline, circular-spline, wave-generator or all."),
    ] = "all",
    tooth: Annotated[
        int | None, typer.Option("--tooth", metavar="N", help="Only tooth N of each spline, 0 at the top.")
    ] = None,
    angle: Annotated[
        str | None,
        typer.Option(
            "--angle",
            metavar="DEG",
            help="Assembled and deformed, the wave generator at this angle, clockwise; else as made.",
        ),
    ] = None,
    printing_clearance: Annotated[
        float,
        typer.Option(
            "--printing-clearance",
            metavar="MM",
            help="Set the teeth's outlines back by this, for a printer or the kerf of a wire; no part of the design.",
        ),
    ] = 0.0,
    chord_error: Annotated[
        float | None,
        typer.Option(
            "--chord-error",
            metavar="MM",
            help="How far chords may lie from their arcs (csv, stl, glb); else 0.001 modules, stl and glb 0.01.",
        ),
    ] = None,
    force: Force = False,
) -> None:
    """Write the parts as drawing, points, pieces, solids or meshes; arcs stay arcs where the format has them."""
    from strainwave.cli.angle import degrees
    from strainwave.cli.naming import naming
    from strainwave.cli.progress import watched
    from strainwave.design import load
    from strainwave.export import ExportChoice, export_gear
    from strainwave.whole_file import check_free

    check_free(out, overwrite=force)
    choice = ExportChoice(
        only=() if part == "all" else (part,),
        tooth=tooth,
        generator_angle_deg=None if angle is None else degrees(angle),
        printing_clearance_mm=printing_clearance,
    )
    with naming(design):
        gear = load(design)
        with watched(format):
            export_gear(gear, out, format, choice, chord_error_mm=chord_error, overwrite=force)
    typer.echo(f"{out}: {choice}")
