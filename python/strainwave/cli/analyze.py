"""``strainwave analyze``: backlash and interference of one design."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import AsJson, DesignFile, Force, Plot

if TYPE_CHECKING:
    from strainwave.analysis import Analysis, FaceMap

INTERFERENCE = 1


def analyze(
    design: DesignFile,
    threshold: Annotated[
        float, typer.Option("--threshold", metavar="UM", help="Count teeth with less backlash than this, in µm.")
    ] = 10.0,
    angle: Annotated[
        str,
        typer.Option("--angle", metavar="DEG", help="Wave generator's angle, clockwise: degrees, or text as 7°30'."),
    ] = "0",
    all_teeth: Annotated[bool, typer.Option("--teeth", help="List every tooth instead of zones.")] = False,
    sections: Annotated[
        int | None,
        typer.Option("--sections", metavar="N", help="Also compute N sections along the face of the coned cup (odd)."),
    ] = None,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write one row per tooth to FILE.")] = None,
    face_csv: Annotated[
        Path | None, typer.Option("--face-csv", metavar="FILE", help="Write one row per section and tooth to FILE.")
    ] = None,
    plot: Plot = None,
    face_plot: Annotated[
        Path | None,
        typer.Option("--face-plot", metavar="FILE", help="Draw the sections: FILE.png, FILE.svg or FILE.pdf."),
    ] = None,
    check: Annotated[
        bool, typer.Option("--check", help="Exit 1 where teeth interfere at any generator angle, or in any section.")
    ] = False,
    force: Force = False,
) -> None:
    """Backlash (µm) of every tooth at one generator angle, and its certified minimum over all angles."""
    from strainwave.analysis import analyze as compute
    from strainwave.analysis import face_map
    from strainwave.cli.angle import degrees
    from strainwave.cli.delivery import check_outputs
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.design import load

    check_outputs([plot, face_plot], [csv, face_csv], overwrite=force)
    count = _section_count(sections, asked_for=face_csv is not None or face_plot is not None)
    with naming(design):
        result = compute(load(design), threshold_um=threshold, generator_angle_deg=degrees(angle))
        face = face_map(result, count) if count is not None else None
    if csv is not None:
        result.to_csv(csv, overwrite=force)
    write_picture(result, plot, overwrite=force)
    if face is not None:
        if face_csv is not None:
            face.to_csv(face_csv, overwrite=force)
        write_picture(face, face_plot, overwrite=force)
    if as_json:
        typer.echo((result if face is None else face).to_json())
    else:
        _print(result, face, all_teeth)
    if check and (result.interference or (face is not None and face.interference)):
        raise typer.Exit(INTERFERENCE)


def _section_count(sections: int | None, *, asked_for: bool) -> int | None:
    """How many sections to compute: as given, or the usual number where a file of them is asked for."""
    from strainwave.analysis.sections import SECTIONS, check_sections

    if sections is None:
        return SECTIONS if asked_for else None
    check_sections(sections)
    return sections


def _print(result: Analysis, face: FaceMap | None, all_teeth: bool) -> None:
    from strainwave.cli.console import say
    from strainwave.cli.tables.analysis import analysis_report
    from strainwave.cli.tables.face import face_report

    say(*analysis_report(result, all_teeth=all_teeth), *(() if face is None else face_report(face)))
