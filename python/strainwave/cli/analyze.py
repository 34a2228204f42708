"""``strainwave analyze``: backlash and interference of one design."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import AsJson, DesignFile, Force, Plot

if TYPE_CHECKING:
    from strainwave.analysis import Analysis

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
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write one row per tooth to FILE.")] = None,
    plot: Plot = None,
    check: Annotated[
        bool, typer.Option("--check", help="Exit 1 where teeth interfere at any generator angle.")
    ] = False,
    force: Force = False,
) -> None:
    """Backlash (µm) of every tooth at one generator angle, and its certified minimum over all angles."""
    from strainwave.analysis import analyze as compute
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import check_picture, write_picture
    from strainwave.design import load
    from strainwave.whole_file import check_free

    check_picture(plot, overwrite=force)
    if csv is not None:
        check_free(csv, overwrite=force)
    with naming(design):
        result = compute(load(design), threshold_um=threshold, generator_angle_deg=_degrees(angle))
    if csv is not None:
        result.to_csv(csv, overwrite=force)
    write_picture(result, plot, overwrite=force)
    if as_json:
        typer.echo(result.to_json())
    else:
        _print(result, all_teeth)
    if check and result.interference:
        raise typer.Exit(INTERFERENCE)


def _print(result: Analysis, all_teeth: bool) -> None:
    from strainwave.cli.console import say
    from strainwave.cli.tables.analysis import analysis_report

    say(*analysis_report(result, all_teeth=all_teeth))


def _degrees(text: str) -> float:
    from strainwave.units import parse_angle

    try:
        return float(text)
    except ValueError:
        pass
    try:
        return parse_angle(text)
    except ValueError as error:
        raise typer.BadParameter(f"{text!r} {error}", param_hint="--angle") from None
