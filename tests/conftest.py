"""What all tests need."""

from __future__ import annotations

import signal


def pytest_configure() -> None:
    """Hear Ctrl-C, as must the commands that tests start: a shell that runs tests in the background has it ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
