"""What more cores bring: threads of one process, beside processes with nothing in common: the limit of the machine."""

from __future__ import annotations

import multiprocessing
from collections.abc import Mapping
from contextlib import suppress
from multiprocessing.connection import Connection

from measurement.engine import batch
from measurement.interleaved import Work
from measurement.tables import shown
from strainwave import Design

KINDS = {
    "w0 varies": ("w0", False),
    "the profile varies": ("profile", False),
    "w0 varies, with the minimum in motion": ("w0", True),
    "the profile varies, with the minimum in motion": ("profile", True),
}
SIDES = ("1 thread", "2 threads", "2 processes")


def by_cores(design: Design, rows: int) -> dict[str, Work]:
    """Each kind of batch on one thread, on two, and in two processes at once."""
    works = {}
    for kind, (varied, in_motion) in KINDS.items():
        for threads in (1, 2):
            works[f"{kind}: {SIDES[threads - 1]}"] = batch(design, varied, rows, threads=threads, in_motion=in_motion)
        works[f"{kind}: {SIDES[2]}"] = _beside_another(design, varied, rows, in_motion)
    return works


def table(seconds: Mapping[str, float]) -> str:
    """Time for one design, and how many times as fast as one thread."""
    rows = ["| batch | 1 thread | 2 threads | | 2 processes | |", "|---|--:|--:|--:|--:|--:|"]
    for kind in KINDS:
        alone, threads, processes = (seconds[f"{kind}: {side}"] for side in SIDES)
        gains = [f"{shown(both)} | {alone / both:.2f} times" for both in (threads, processes)]
        rows.append(f"| {kind} | {shown(alone)} | {' | '.join(gains)} |")
    return "".join(f"{row}\n" for row in rows)


def _beside_another(design: Design, varied: str, rows: int, in_motion: bool) -> Work:
    """A batch on one thread while another process does the same."""
    own = batch(design, varied, rows, in_motion=in_motion)
    context = multiprocessing.get_context("spawn")
    ours, its = context.Pipe()
    context.Process(target=_serve, args=(its, design, varied, rows, in_motion), daemon=True).start()

    def run() -> None:
        ours.send("go")
        own.run()
        ours.recv()

    return Work(run, 2 * rows)


def _serve(connection: Connection, design: Design, varied: str, rows: int, in_motion: bool) -> None:
    """Do the batch each time the other end asks for it."""
    work = batch(design, varied, rows, in_motion=in_motion)
    with suppress(EOFError):  # there is no other end any more
        while connection.recv() == "go":
            work.run()
            connection.send("done")
