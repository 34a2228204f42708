"""Running the command: one message and an exit code for everything that can go wrong, and never a traceback."""

from __future__ import annotations

import os
import sys
import traceback
from collections.abc import Sequence
from typing import Any, NoReturn, TextIO

ERROR = 2
INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run the command line and exit: 0 done, 1 interference found by ``--check``, 2 an error, 130 interrupted."""
    _open_what_is_closed()
    for stream in (sys.stdout, sys.stderr):
        _write_what_the_terminal_cannot_show_as_question_marks(stream)
    try:
        code = _run(arguments)
        sys.stdout.flush()
    except KeyboardInterrupt:
        code = _complain("interrupted", INTERRUPTED)
    except BrokenPipeError:
        code = ERROR
    except OSError as error:
        code = _complain(f"the output cannot be written: {error.strerror or error}")
    except Exception:
        traceback.print_exc()
        code = _complain("the above is a bug of strainwave, not of its input; please report it")
    _leave_nothing_to_flush()
    sys.exit(code)


def _run(arguments: Sequence[str] | None) -> int:
    import typer

    from strainwave.cli.app import app
    from strainwave.errors import StrainwaveError

    # Typer may bring a click of its own, so click's base class for wrong usage is reached through typer.
    wrong_usage: type[Exception] = typer.BadParameter.__bases__[0]
    try:
        code = int(app(arguments, prog_name="strainwave", standalone_mode=False) or 0)
    except wrong_usage as error:
        return _complain(_usage_message(error))
    except StrainwaveError as error:
        return _complain(str(error))
    except typer.Abort:
        raise KeyboardInterrupt from None
    except SystemExit:
        # Outside its standalone mode click exits from inside for one reason only: nobody reads the output any more.
        raise BrokenPipeError from None
    if code == INTERRUPTED:  # newer versions of typer return it instead of raising Abort
        raise KeyboardInterrupt
    return code


def _usage_message(error: Any) -> str:
    command = error.ctx.command_path if error.ctx else "strainwave"
    message = " ".join(error.format_message().split())  # a list of choices comes on several lines
    message = message.replace("Value error, ", "", 1)  # what typer's checks put before what they say
    return f"{message.rstrip('.')} (see: {command} --help)"


def _complain(message: str, code: int = ERROR) -> int:
    print(f"strainwave: {message}", file=sys.stderr)
    return code


def _open_what_is_closed() -> None:
    """A shell's `>&-` leaves Python without the stream; what is written to it goes nowhere then."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))


def _write_what_the_terminal_cannot_show_as_question_marks(stream: TextIO) -> None:
    if hasattr(stream, "reconfigure"):
        stream.reconfigure(errors="replace")


def _leave_nothing_to_flush() -> None:
    """Python flushes stdout once more on its way out, and would report a closed pipe there."""
    try:
        sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
