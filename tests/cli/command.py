"""The command line, run inside the test's own process."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from strainwave.cli import main


@dataclass(frozen=True)
class Outcome:
    """What a run of the command left behind."""

    code: object
    out: str
    err: str


def run(capsys: pytest.CaptureFixture[str], *arguments: object) -> Outcome:
    """Run ``strainwave`` with these arguments."""
    with pytest.raises(SystemExit) as stop:
        main([str(argument) for argument in arguments])
    captured = capsys.readouterr()
    return Outcome(stop.value.code, captured.out, captured.err)
