"""Where tables are printed."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import RenderableType

COLUMNS_IN_A_FILE = 100


def say(*parts: RenderableType) -> None:
    """Print tables and text, coloured and as wide as the terminal, or plain where the output is a file or a pipe."""
    from rich.console import Console

    to_terminal = Console(highlight=False)
    console = to_terminal if to_terminal.is_terminal else Console(highlight=False, width=COLUMNS_IN_A_FILE)
    with console.capture() as captured:
        for part in parts:
            console.print(part)
    # Tables are padded to their full width; blanks at the end of a line are of no use to anyone.
    sys.stdout.writelines(f"{line.rstrip()}\n" for line in captured.get().splitlines())
