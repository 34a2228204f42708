"""The way of a file from the browser to the studio."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from weakref import WeakMethod

from nicegui import ui
from nicegui.events import UploadEventArguments

from strainwave.toml_file import LARGEST_FILE_BYTES


def uploader(receive: Callable[[UploadEventArguments], Awaitable[None]]) -> ui.upload:
    """Sends a file as soon as it is chosen to `receive`, a method of an object that something else of the page holds.

    FastAPI remembers thousands of uploaders; so they must not hold what a closed window's session hangs on.
    """
    held = WeakMethod(receive)
    return ui.upload(
        auto_upload=True,
        max_file_size=LARGEST_FILE_BYTES,
        on_upload=lambda event: received(event) if (received := held()) else None,
    )
