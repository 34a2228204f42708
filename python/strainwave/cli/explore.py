"""``strainwave explore``: designs spread evenly over a space, as many as a dataset holds."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.cli.options import AsJson, Threads, Threshold

if TYPE_CHECKING:
    from collections.abc import Collection

    from strainwave.studies.ends import Ends
    from strainwave.studies.exploration import Exploration


# What defines a study or says how it is computed: of no use where one that is there is read.
OF_A_STUDY = ("design", "space", "samples", "out", "seed", "metric", "in_motion", "threshold", "chunk_rows", "threads",
              "dask")  # fmt: skip


def explore(
    context: typer.Context,
    design: Annotated[
        Path | None, typer.Argument(metavar="DESIGN", help="Design file (TOML).", show_default=False)
    ] = None,
    space: Annotated[
        Path | None, typer.Argument(metavar="SPACE", help="Space file (TOML).", show_default=False)
    ] = None,
    samples: Annotated[
        int | None, typer.Option("--samples", metavar="N", help="How many designs, best a power of two.")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FOLDER", help="Write the dataset there, or go on with the one that is there."),
    ] = None,
    summary: Annotated[
        Path | None, typer.Option("--summary", metavar="FOLDER", help="Read the dataset there and compute nothing.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", help="The same seed gives the same rows.")] = 1,
    metric: Annotated[
        list[str] | None,
        typer.Option(
            "--metric",
            metavar="COLUMN",
            help="A figure of each design. Repeat it for more. Default: all but play_circumferential_um, which takes "
            "several times as long as all others.",
        ),
    ] = None,
    in_motion: Annotated[
        bool,
        typer.Option(
            "--in-motion", help="Also the least backlash over all generator angles, where angle 0 has no interference."
        ),
    ] = False,
    threshold: Threshold = 10.0,
    chunk_rows: Annotated[
        int | None,
        typer.Option("--chunk-rows", metavar="N", help="Designs in a file, a power of two. Default: up to 32768."),
    ] = None,
    threads: Threads = 0,
    dask: Annotated[
        str | None,
        typer.Option(
            "--dask",
            metavar="ADDRESS",
            help="Compute on the Dask cluster of this scheduler, whose workers share FOLDER; local:N starts N workers "
            "here.",
        ),
    ] = None,
    require: Annotated[
        list[str] | None,
        typer.Option(
            "--require",
            metavar="COLUMN=LOW:HIGH",
            help="Report designs in this range only; an end may be left out. generator=KIND,… chooses generators. "
            "Default: no interference and tips clear of roots, whose 0 holds unless another lower end is given (-inf: "
            "for none).",
        ),
    ] = None,
    objective: Annotated[
        str | None,
        typer.Option(
            "--objective",
            metavar="COLUMN",
            help="What the best designs are best in; COLUMN=min or =max turns it. Default: teeth_below_per_side.",
        ),
    ] = None,
    best: Annotated[int, typer.Option("--best", metavar="N", min=0, max=10_000, help="So many best designs.")] = 10,
    as_json: AsJson = False,
    csv: Annotated[Path | None, typer.Option("--csv", metavar="FILE", help="Write the best designs' rows.")] = None,
    plot: Annotated[
        Path | None, typer.Option("--plot", metavar="FILE", help="Draw a scatter matrix: FILE.png, .svg or .pdf.")
    ] = None,
    parallel: Annotated[
        Path | None,
        typer.Option("--parallel", metavar="FILE", help="Draw parallel coordinates: FILE.png, .svg or .pdf."),
    ] = None,
    designs: Annotated[
        Path | None,
        typer.Option("--designs", metavar="FOLDER", help="Write the best designs' files into the new FOLDER."),
    ] = None,
    force: Annotated[
        bool,
        typer.Option(
            "--force",
            help="Overwrite files that exist, and replace the FOLDER of --designs if it holds only design-N.toml.",
        ),
    ] = False,
) -> None:
    """Compute up to a hundred million designs of a space into a dataset, on this machine or a cluster, and read it."""
    from functools import partial

    from strainwave.cli.delivery import check_outputs, deliver
    from strainwave.cli.naming import naming
    from strainwave.cli.pictures import write_picture
    from strainwave.cli.progress import paced, watched
    from strainwave.cli.tables.exploration import exploration_report
    from strainwave.design import load
    from strainwave.studies.exploration import Plan, load_exploration, load_space
    from strainwave.studies.exploration import explore as run
    from strainwave.studies.exploration.design_files import OWN_NAMES
    from strainwave.studies.exploration.requirements import check_report
    from strainwave.whole_folder import check_folder_free

    check_outputs([plot, parallel], [csv], overwrite=force)
    if designs is not None:
        check_folder_free(designs, OWN_NAMES, overwrite=force)
    wanted = _wanted(require or [])
    if summary is not None:
        if given := _given(context, OF_A_STUDY):
            raise typer.BadParameter(
                f"reads a study that is there; it goes without {', '.join(given)}", param_hint="--summary"
            )
        found = load_exploration(summary)
    else:
        if design is None or space is None or samples is None or out is None:
            raise typer.BadParameter("DESIGN, SPACE, --samples and --out are all needed, or else --summary FOLDER")
        with naming(design):
            loaded = load(design)
        with naming(space), paced("designs") as progress:
            loaded_space = load_space(space)
            plan = Plan.of(
                loaded,
                loaded_space,
                samples,
                seed=seed,
                metrics=metric,
                in_motion=in_motion,
                threshold_um=threshold,
                chunk_rows=chunk_rows,
            )
            check_report(plan, wanted, objective)  # before hours of work for it
            found = run(
                loaded,
                loaded_space,
                samples,
                out,
                seed=seed,
                metrics=metric,
                in_motion=in_motion,
                threshold_um=threshold,
                chunk_rows=chunk_rows,
                threads=threads,
                dask=dask,
                progress=progress,
            )
        if found.interrupted:
            typer.echo(_interrupted(found), err=True)
            raise KeyboardInterrupt
    with watched("reading") as progress:
        report = found.viable.where(wanted).summary(best, objective, progress=progress)
    deliver(
        report,
        exploration_report,
        [
            (designs, report.save),
            (csv, report.to_csv),
            (plot, partial(write_picture, report)),
            (parallel, partial(write_picture, report.lines)),
        ],
        as_json=as_json,
        overwrite=force,
    )


def _given(context: typer.Context, names: Collection[str]) -> list[str]:
    """How the help calls those of some parameters that were given on the command line, also where it makes no odds."""
    flags = {parameter.name: parameter.opts[0] for parameter in context.command.params}
    sources = {name: context.get_parameter_source(name) for name in names}
    return [
        flags[name] if flags[name].startswith("-") else name.upper()
        for name, source in sources.items()
        if source is not None and source.name == "COMMANDLINE"
    ]


def _wanted(texts: list[str]) -> dict[str, Ends | list[str]]:
    """Ranges by column, and the generators by label."""
    from strainwave.cli.ranges import open_ranges

    start = "generator="
    ranges = open_ranges("--require", [text for text in texts if not text.startswith(start)])
    chosen = [label.strip() for text in texts if text.startswith(start) for label in text[len(start) :].split(",")]
    return {**ranges, "generator": chosen} if chosen else {**ranges}


def _interrupted(found: Exploration) -> str:
    return (
        f"{len(found.finished)} of {found.plan.chunks} chunks are finished and kept in {found.place.path}; "
        "the same command goes on from there"
    )
