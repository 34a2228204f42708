"""Who wants to know when something of a session has changed."""

from __future__ import annotations

from collections.abc import Callable


class Signal:
    """Callbacks without arguments, called in the order in which they came."""

    def __init__(self) -> None:
        self._callbacks: list[Callable[[], None]] = []

    def connect(self, callback: Callable[[], None]) -> None:
        """Call it at every `emit` from now on."""
        self._callbacks.append(callback)

    def emit(self) -> None:
        """Call everyone."""
        for callback in self._callbacks:
            callback()

    def silence(self) -> None:
        """Call nobody any more."""
        self._callbacks.clear()
