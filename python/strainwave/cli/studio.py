"""``strainwave studio``: the gear in the browser, live."""

from __future__ import annotations

from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Annotated

import typer

from strainwave.errors import StrainwaveError

if TYPE_CHECKING:
    from strainwave.studio.header.design_file import DesignFile

EXAMPLE = "cosine-calibrated"
OPEN_TO_OTHERS = (
    "warning: {host} can be reached from other machines. Only the token in the address lets them in; it and all that "
    "the studio shows pass unencrypted, so use it in a network that you trust, or through an ssh tunnel."
)


def studio(
    design: Annotated[
        Path | None,
        typer.Argument(
            metavar="DESIGN", help="Design file (TOML); without one an example is open.", show_default=False
        ),
    ] = None,
    port: Annotated[
        int | None,
        typer.Option(
            "--port",
            metavar="N",
            min=0,
            max=65535,
            help="Listen on this port, 0 for any free one. Without it: 8080, or the next that is free.",
            show_default=False,
        ),
    ] = None,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Only print the address.")] = False,
    host: Annotated[
        str,
        typer.Option("--host", metavar="ADDRESS", help="Listen here, also for other machines: they need the token."),
    ] = "127.0.0.1",
    token: Annotated[
        str | None,
        typer.Option(
            "--token",
            metavar="TEXT",
            help="Ask for this token, of 16 characters or more. Without it one is made where --host needs it.",
            show_default=False,
        ),
    ] = None,
) -> None:
    """Design in the browser: change any number and see backlash, mesh and verdict at once."""
    opened = _opened(design)
    try:
        from strainwave.studio.guard.access import is_loopback
        from strainwave.studio.server import run_studio
    except ImportError as error:
        raise StrainwaveError(f"the studio needs nicegui ({error}): pip install 'strainwave[studio]'") from None

    def tell(address: str) -> None:
        if not is_loopback(host):
            typer.echo(OPEN_TO_OTHERS.format(host=host), err=True)
        typer.echo(f"The studio is at {address} (Ctrl-C ends it).")
        if not no_browser:
            # Some browsers keep whoever opens them waiting until they are closed.
            Thread(target=typer.launch, args=(address,), daemon=True).start()

    run_studio(opened.design, file=opened, host=host, port=port, token=token, started=tell)


def _opened(file: Path | None) -> DesignFile:
    """The file to begin with; its design has a geometry."""
    from strainwave.analysis.case_study.design_files import case_study_file
    from strainwave.cli.naming import naming
    from strainwave.geometry import Geometry
    from strainwave.studio.header.design_file import DesignFile

    if file is None:
        return DesignFile.opened(f"{EXAMPLE}.toml", case_study_file(EXAMPLE))
    with naming(file):
        opened = DesignFile.read(file)
        Geometry.of(opened.design)
    return opened
