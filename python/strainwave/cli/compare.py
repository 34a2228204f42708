"""``strainwave compare``: one pair of splines under several wave generators."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from strainwave.cli.options import AsJson, DesignFile, Force, Threads, Threshold
from strainwave.cli.tune import Margin

if TYPE_CHECKING:
    from strainwave.design import Design
    from strainwave.studies.comparison.generators import Generator


def compare(
    design: DesignFile,
    others: Annotated[
        list[str] | None,
        typer.Option(
            "--with",
            metavar="GENERATOR",
            help="A kind, with parameters where they differ from the usual (four-roller, four-roller:roller_angle=25), "
            "or a design file whose generator is meant. Repeat it for more. [default: every kind]",
        ),
    ] = None,
    w0: Annotated[
        float | None,
        typer.Option("--w0", metavar="MM", help="The common w0 in mm; else that of DESIGN.", show_default=False),
    ] = None,
    goal: Annotated[
        Literal["power", "precision", "balanced"], typer.Option("--goal", help="What each w0 is tuned for.")
    ] = "balanced",
    threshold: Threshold = 10.0,
    margin: Margin = 0.1,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write the table to FILE.")] = None,
    plot: Annotated[
        Path | None,
        typer.Option("--plot", metavar="FILE", help="Draw all backlash curves: FILE.png, FILE.svg or FILE.pdf."),
    ] = None,
    threads: Threads = 0,
    force: Force = False,
) -> None:
    """Compare wave generators on one pair of splines (µm), at a common w0 (mm) and each at the w0 tuned for it."""
    from functools import partial

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.progress import watched
    from strainwave.cli.tables.comparison import comparison_report
    from strainwave.design import load
    from strainwave.studies import compare as compute
    from strainwave.studies.tuning.w0_scan import W0

    check_outputs([plot], [csv], overwrite=force)
    with naming(design):
        base = load(design)
    if w0 is not None:
        with naming("--w0"):
            base = base.replace(W0, w0)
    generators = [_under(base, text) for text in others or []]
    with naming(design), watched("generator") as progress:
        result = compute(
            base,
            generators,
            goal=goal,
            threshold_um=threshold,
            margin_um=margin,
            threads=threads,
            progress=progress,
        )
    deliver(
        result,
        comparison_report,
        [(csv, result.to_csv), (plot, partial(write_picture, result))],
        as_json=as_json,
        overwrite=force,
    )


def _under(base: Design, text: str) -> Design:
    """The design under the generator that --with names."""
    from strainwave.cli.naming import naming
    from strainwave.studies.comparison import with_generator

    generator = _generator(text)
    with naming(f"--with {text}"):
        return with_generator(base, generator)


def _generator(text: str) -> Generator:
    """A design file's generator, a kind, or a kind with parameters: KIND:KEY=NUMBER,KEY=NUMBER."""
    from strainwave.design import load

    if text.endswith(".toml") or Path(text).is_file():
        return load(Path(text))
    kind, colon, parameters = text.partition(":")
    if not colon:
        return kind
    table: dict[str, Any] = {"kind": kind}
    for parameter in parameters.split(","):
        key, equals, value = parameter.partition("=")
        if not (key.strip() and equals):
            raise typer.BadParameter(f"{text!r} must have the form KIND:KEY=NUMBER", param_hint="--with")
        table[key.strip()] = _number(value)
    return table


def _number(value: str) -> float | str:
    """A number, or else the text as it stands: an angle or the name of a neutral curve."""
    try:
        return float(value)
    except ValueError:
        return value.strip()
