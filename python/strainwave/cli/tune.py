"""``strainwave tune``: which w0 a wave generator can run with, and the best for a goal."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from strainwave.cli.options import AsJson, DesignFile, Force, Threads, Threshold

Margin = Annotated[
    float, typer.Option("--margin", metavar="UM", help="Least minimum in motion that a chosen w0 has, in µm.")
]


def tune(
    design: DesignFile,
    threshold: Threshold = 10.0,
    margin: Margin = 0.1,
    goal: Annotated[
        Literal["power", "precision", "balanced"], typer.Option("--goal", help="Whose w0 the design of --out has.")
    ] = "balanced",
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="Write the design with the goal's best w0 to FILE.")
    ] = None,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write one row per w0 to FILE.")] = None,
    plot: Annotated[
        Path | None,
        typer.Option("--plot", metavar="FILE", help="Draw the minimum over w0: FILE.png, FILE.svg or FILE.pdf."),
    ] = None,
    threads: Threads = 0,
    force: Force = False,
) -> None:
    """Every w0 (mm) without interference in motion, and the best w0 for power, precision and balanced use."""
    from functools import partial

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.progress import watched
    from strainwave.cli.tables.tuning import tuning_report
    from strainwave.design import load, save
    from strainwave.studies import tune as compute

    check_outputs([plot], [out, csv], overwrite=force)
    with naming(design), watched("w0") as progress:
        result = compute(load(design), threshold_um=threshold, margin_um=margin, threads=threads, progress=progress)

    def save_tuned(path: Path, *, overwrite: bool) -> None:
        save(result.design_for(goal), path, overwrite=overwrite)

    deliver(
        result,
        tuning_report,
        [(out, save_tuned), (csv, result.to_csv), (plot, partial(write_picture, result))],
        as_json=as_json,
        overwrite=force,
    )
