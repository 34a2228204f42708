"""``strainwave optimize``: the best designs within ranges of their parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from strainwave.cli.options import AsJson, DesignFile, Threads, Threshold


def optimize(
    design: DesignFile,
    vary: Annotated[
        list[str],
        typer.Option(
            "--vary",
            metavar="KEY=LOW:HIGH",
            help="Free a number of the design file, in its unit there. Repeat it for more.",
        ),
    ],
    objective: Annotated[
        list[str] | None,
        typer.Option(
            "--objective",
            metavar="FIGURE",
            help="What to make best: teeth-below, tip-clearance, root-clearance, tip-land (greatest), "
            "minimum-backlash, evenness, play, rim-strain (least); FIGURE=min or FIGURE=max turns it. "
            "Several give a Pareto front. Default: teeth-below.",
        ),
    ] = None,
    require: Annotated[
        list[str] | None,
        typer.Option(
            "--require",
            metavar="FIGURE=LOW:HIGH",
            help="Keep a figure in a range: µm, teeth, mm (tip-land) or ppm (rim-strain); an end may be left out. "
            "Default: minimum-backlash=0: and tip-clearance=0:, whose 0 holds unless another lower end is given "
            "(-inf: for none).",
        ),
    ] = None,
    threshold: Threshold = 10.0,
    population: Annotated[int, typer.Option("--population", metavar="N", help="Designs in a generation.")] = 64,
    generations: Annotated[int, typer.Option("--generations", metavar="N", help="How many generations.")] = 60,
    seed: Annotated[int, typer.Option("--seed", metavar="N", help="The same seed finds the same designs.")] = 1,
    threads: Threads = 0,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write one row per design to FILE.")] = None,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot", metavar="FILE", help="Draw the best design or the front: FILE.png, FILE.svg or FILE.pdf."
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", metavar="FOLDER", help="Write each design's file into the new FOLDER.")
    ] = None,
    force: Annotated[
        bool,
        typer.Option(
            "--force",
            help="Overwrite files that exist, and replace FOLDER if it holds only best.toml or front-N.toml.",
        ),
    ] = False,
) -> None:
    """Search ranges of a design's numbers for the best design, or for the Pareto front of several objectives."""
    from functools import partial

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.progress import best_so_far
    from strainwave.cli.ranges import open_ranges, ranges
    from strainwave.cli.tables.optimization import optimization_report
    from strainwave.design import load
    from strainwave.studies.optimization import optimize as search
    from strainwave.studies.optimization.design_files import OWN_NAMES
    from strainwave.whole_folder import check_folder_free

    check_outputs([plot], [csv], overwrite=force)
    if out is not None:
        check_folder_free(out, OWN_NAMES, overwrite=force)
    free, required = ranges("--vary", vary), open_ranges("--require", require or [])
    with naming(design), best_so_far("generation") as report:
        found = search(
            load(design),
            free,
            objective or ["teeth-below"],
            required,
            threshold_um=threshold,
            population=population,
            generations=generations,
            seed=seed,
            threads=threads,
            report=report,
        )
    deliver(
        found,
        optimization_report,
        [(out, found.save), (csv, found.to_csv), (plot, partial(write_picture, found))],
        as_json=as_json,
        overwrite=force,
    )
