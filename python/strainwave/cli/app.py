"""The verbs of the command line."""

from __future__ import annotations

from typing import Annotated

import typer

from strainwave.cli.analyze import analyze
from strainwave.cli.animate import animate
from strainwave.cli.case_study import case_study
from strainwave.cli.compare import compare
from strainwave.cli.conjugate import conjugate
from strainwave.cli.explore import explore
from strainwave.cli.export import export
from strainwave.cli.fit import fit
from strainwave.cli.new import new
from strainwave.cli.optimize import optimize
from strainwave.cli.plot import plot
from strainwave.cli.report import report
from strainwave.cli.studio import studio
from strainwave.cli.sweep import sweep
from strainwave.cli.tolerance import tolerance
from strainwave.cli.tune import tune
from strainwave.cli.validate import validate

app = typer.Typer(
    invoke_without_command=True,
    add_completion=False,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog="Lengths are in mm, clearances in µm (a gap is positive, the depth of an interference negative), angles in "
    "degrees.",
)


def _print_version(asked: bool) -> None:
    if asked:
        from strainwave import __version__

        typer.echo(f"strainwave {__version__}")
        raise typer.Exit


@app.callback()
def strainwave(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Backlash and interference of strain wave gears, of every tooth pair, exactly."""
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())


def _example(text: str) -> str:
    return f"[dim]Example:[/dim]  {text}"


app.command(epilog=_example("strainwave new --out my-gear.toml"))(new)
app.command(epilog=_example("strainwave validate my-gear.toml"))(validate)
app.command(epilog=_example("strainwave analyze my-gear.toml --check --plot backlash.png"))(analyze)
app.command(name="case-study", epilog=_example("strainwave case-study --plot case-study.png"))(case_study)
app.command(epilog=_example("strainwave compare my-gear.toml --with four-roller --with dual-disk --plot compared.png"))(
    compare
)
app.command(epilog=_example("strainwave sweep my-gear.toml --vary wave_generator.w0=0.84:0.91:71 --plot sweep.png"))(
    sweep
)
app.command(epilog=_example("strainwave tune my-gear.toml --plot windows.png --goal power --out tuned.toml"))(tune)
app.command(epilog=_example("strainwave optimize my-gear.toml --vary wave_generator.w0=0.80:0.90 --out optimized/"))(
    optimize
)
app.command(
    epilog=_example("strainwave explore my-gear.toml space.toml --samples 1048576 --out study --plot explored.png")
)(explore)
app.command(epilog=_example("strainwave conjugate my-gear.toml --out conjugate.toml --plot conjugate.png"))(conjugate)
app.command(epilog=_example("strainwave fit tooth.dxf --design my-gear.toml --spline flexspline --out drawn.toml"))(fit)
app.command(epilog=_example("strainwave export step my-gear.toml --part flexspline --out flexspline.step"))(export)
app.command(epilog=_example("strainwave tolerance my-gear.toml tolerances.toml --plot scatter.png"))(tolerance)
app.command(epilog=_example("strainwave plot assembly my-gear.toml --teeth 30:40 --out teeth.png"))(plot)
app.command(epilog=_example("strainwave animate my-gear.toml --fixed flexspline --out turning.html"))(animate)
app.command(epilog=_example("strainwave report my-gear.toml --out report.html"))(report)
app.command(epilog=_example("strainwave studio my-gear.toml"))(studio)
