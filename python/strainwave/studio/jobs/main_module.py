"""The program that serves the studio, with which a job's process has no business."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType

MAIN = "__main__"


@contextmanager
def nowhere_main() -> Iterator[None]:
    """Let ``__main__`` seem to come from nowhere, as at a prompt, to processes that are started meanwhile.

    Else multiprocessing runs the user's script anew in each of them (in every Python so far, and without an official
    way not to), and a script that serves a studio opens another one there. Jobs are functions of modules and need
    nothing of it. Meanwhile other threads find in ``__main__`` what they always do.
    """
    main = sys.modules[MAIN]
    stand_in = ModuleType(MAIN)
    vars(stand_in).update({**vars(main), "__spec__": None, "__file__": None})
    sys.modules[MAIN] = stand_in
    try:
        yield
    finally:
        sys.modules[MAIN] = main
