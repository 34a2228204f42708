"""``strainwave tolerance``: the yield of a design whose numbers scatter."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from strainwave.cli.options import AsJson, DesignFile, Force, Threads


def tolerance(
    design: DesignFile,
    tolerances: Annotated[
        Path, typer.Argument(metavar="TOLERANCES", help="Tolerance file (TOML).", show_default=False)
    ],
    samples: Annotated[
        int, typer.Option("--samples", metavar="N", help="Samples for the yield, rounded up to a power of two.")
    ] = 16384,
    sobol_samples: Annotated[
        int,
        typer.Option(
            "--sobol-samples", metavar="N", help="Base samples for the Sobol' indices, rounded up to a power of two."
        ),
    ] = 1024,
    seed: Annotated[int, typer.Option("--seed", metavar="N", help="The same seed gives the same result.")] = 1,
    threads: Threads = 0,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write one row per sample to FILE.")] = None,
    plot: Annotated[
        Path | None,
        typer.Option("--plot", metavar="FILE", help="Draw scatter and causes: FILE.png, FILE.svg or FILE.pdf."),
    ] = None,
    force: Force = False,
) -> None:
    """The probability of no interference in motion where numbers scatter, and what the backlash (µm) depends on."""
    from functools import partial

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.progress import watched
    from strainwave.cli.tables.tolerance import tolerance_report
    from strainwave.design import load
    from strainwave.geometry import Geometry
    from strainwave.studies.tolerance import analyze_tolerance, load_tolerances

    check_outputs([plot], [csv], overwrite=force)
    with naming(design):
        loaded = load(design)
        Geometry.of(loaded)
    with naming(tolerances), watched("samples") as progress:
        found = analyze_tolerance(
            loaded,
            load_tolerances(tolerances),
            samples=samples,
            sobol_samples=sobol_samples,
            seed=seed,
            threads=threads,
            progress=progress,
        )
    deliver(
        found,
        tolerance_report,
        [(csv, found.to_csv), (plot, partial(write_picture, found))],
        as_json=as_json,
        overwrite=force,
    )
