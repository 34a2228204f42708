"""Arguments and options that several verbs share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

DesignFile = Annotated[Path, typer.Argument(metavar="DESIGN", help="Design file (TOML).", show_default=False)]
AsJson = Annotated[bool, typer.Option("--json", help="Print the result as JSON, with units in the keys.")]
Force = Annotated[bool, typer.Option("--force", help="Overwrite files that exist.")]
Plot = Annotated[
    Path | None,
    typer.Option("--plot", metavar="FILE", help="Draw the backlash distribution: FILE.png, FILE.svg or FILE.pdf."),
]
Threshold = Annotated[
    float, typer.Option("--threshold", metavar="UM", help="Count teeth with less backlash than this, in µm.")
]
Threads = Annotated[
    int, typer.Option("--threads", metavar="N", help="Use so many cores; 0 takes all. Results do not depend on it.")
]
