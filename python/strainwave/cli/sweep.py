"""``strainwave sweep``: a figure of a design over one or two of its numbers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import AsJson, DesignFile, Force, Threads, Threshold

if TYPE_CHECKING:
    from strainwave.design import Design
    from strainwave.studies.sweeping import Axis

FORM = "KEY=START:STOP:COUNT"


def sweep(
    design: DesignFile,
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary",
            metavar=FORM,
            help="A number by its dotted key, in its unit in the design file, from START to STOP with COUNT values. "
            "Give one for a line, two for a map.",
        ),
    ],
    metric: Annotated[
        str,
        typer.Option(
            "--metric",
            metavar="NAME",
            help="min_in_motion_um, min_in_motion_index, min_in_motion_lower_bound_um, min_backlash_um, min_tooth, "
            "teeth_below_per_side, interfering_per_side, first_interfering_tooth, play_circumferential_um, "
            "tip_clearance_um or root_clearance_um.",
        ),
    ] = "min_in_motion_um",
    threshold: Threshold = 10.0,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write one row per value to FILE.")] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FILE", help="Draw it: FILE.png, FILE.svg or FILE.pdf.")
    ] = None,
    threads: Threads = 0,
    force: Force = False,
) -> None:
    """A figure (µm, teeth) over one or two numbers of a design, and where teeth interfere in motion."""
    from functools import partial

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.progress import watched
    from strainwave.cli.tables.sweep import sweep_report
    from strainwave.design import load
    from strainwave.studies import sweep as compute

    check_outputs([plot], [csv], overwrite=force)
    with naming(design), watched("rows") as progress:
        base = load(design)
        axes = [_axis(base, text) for text in vary]
        result = compute(base, axes, metric=metric, threshold_um=threshold, threads=threads, progress=progress)
    deliver(
        result,
        sweep_report,
        [(csv, result.to_csv), (plot, partial(write_picture, result))],
        as_json=as_json,
        overwrite=force,
    )


def _axis(design: Design, text: str) -> Axis:
    from strainwave.studies.sweeping import Axis

    key, equals, span = text.partition("=")
    parts = [part.strip() for part in span.split(":")]
    if not (key.strip() and equals and len(parts) == 3 and parts[2].isdecimal() and len(parts[2]) < 10):
        raise typer.BadParameter(f"{text!r} must have the form {FORM}", param_hint="--vary")
    return Axis.between(design, key.strip(), parts[0], parts[1], int(parts[2]))
