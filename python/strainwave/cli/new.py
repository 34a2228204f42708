"""``strainwave new``: a design file to start from, commented or made for a ratio and a size."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import Force

if TYPE_CHECKING:
    from strainwave.studies.wizard import Proposal


def new(
    design: Annotated[
        Path | None, typer.Argument(metavar="DESIGN", help="The same as --out DESIGN.", show_default=False)
    ] = None,
    ratio: Annotated[
        float | None,
        typer.Option("--ratio", metavar="R", help="Design for this ratio, 30 to 200, circular spline fixed."),
    ] = None,
    pitch_diameter: Annotated[
        float | None,
        typer.Option(
            "--pitch-diameter", metavar="MM", help="… and this pitch diameter of the flexspline, 20 to 200 mm."
        ),
    ] = None,
    generator: Annotated[
        str | None,
        typer.Option(
            "--generator",
            metavar="KIND",
            help="cosine, ellipse, two-roller, four-roller or dual-disk; else what suits the use.",
        ),
    ] = None,
    profile: Annotated[
        str | None,
        typer.Option("--profile", metavar="KIND", help="double-circular-arc (the article's), arc-line or involute."),
    ] = None,
    use: Annotated[
        str | None, typer.Option("--use", metavar="USE", help="power (most teeth share the load) or precision.")
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Write it to FILE; else print it.")] = None,
    force: Force = False,
) -> None:
    """Write a design file: a commented one to start from or, with a ratio and a pitch diameter (mm), a tuned one."""
    from strainwave.whole_file import check_free, write_whole

    if design is not None and out is not None:
        raise typer.BadParameter(f"{out} and {design}: name one file", param_hint="--out")
    file = out or design
    if file is not None:
        check_free(file, overwrite=force)
    proposal = _proposal(ratio, pitch_diameter, generator, profile, use)
    text = _template() if proposal is None else proposal.toml()
    if file is None:
        typer.echo(text, nl=False)
        return
    write_whole(file, text, overwrite=force)
    if proposal is not None:
        from strainwave.cli.console import say
        from strainwave.cli.tables.proposal import proposal_report

        say(*proposal_report(proposal))
    typer.echo(f"{file}: a design to start from; next: strainwave analyze {file}")


def _template() -> str:
    from strainwave.design import template

    return template()


def _proposal(
    ratio: float | None, pitch_diameter: float | None, generator: str | None, profile: str | None, use: str | None
) -> Proposal | None:
    """The proposed design, or None where none of its options is given."""
    if ratio is None or pitch_diameter is None:
        others = {"--generator": generator, "--profile": profile, "--use": use}
        given = [name for name, value in others.items() if value is not None]
        if ratio is not None or pitch_diameter is not None or given:
            raise typer.BadParameter("give both --ratio and --pitch-diameter", param_hint="--ratio")
        return None
    from strainwave.studies.wizard import propose

    return propose(ratio, pitch_diameter, generator=generator, profile=profile, use=use or "power")
