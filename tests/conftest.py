"""What all tests need."""

from __future__ import annotations

import signal

from hypothesis import settings

# What lands is judged by the same examples everywhere, however slow the machine is; `make soak` draws others.
settings.register_profile("same everywhere", derandomize=True, deadline=None)
settings.register_profile("soak", max_examples=2000, deadline=None)
settings.load_profile("same everywhere")


def pytest_configure() -> None:
    """Hear Ctrl-C, as must the commands that tests start: a shell that runs tests in the background has it ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
