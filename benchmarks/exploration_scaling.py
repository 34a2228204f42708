"""Measure what an exploration costs beyond the kernel, and what follows for a cluster; written into docs/cluster.md.

Blocks between ``<!-- NAME:begin -->`` and ``<!-- NAME:end -->`` hold what is measured here. Sides of one comparison
run interleaved, each in a process of its own, so that a slow moment of the machine hits all of them. Times differ from
run to run and from machine to machine, so no test looks at them. Takes about four minutes on two quiet cores; with
``--quick`` a fifth of the designs, to see that it works.
"""

from __future__ import annotations

import sys

from measurement import machine
from measurement.blocks import fill
from measurement.exploration import Run, Scale, measured, sides, task_seconds
from measurement.exploration_model import TABLES

FULL = Scale(designs=1_000_000, few=10_000, rounds=1, tasks=5_000)
QUICK = Scale(designs=200_000, few=10_000, rounds=1, tasks=1_000)


def blocks(scale: Scale) -> dict[str, str]:
    """What the page holds, by the name of the block."""
    runs: dict[str, list[Run]] = measured(sides(scale), scale.rounds)
    task_s = task_seconds(scale.tasks)
    found = {name: table(runs, task_s, scale) for name, table in TABLES.items()}
    return found | {"cluster-machine": f"{machine.description()}.\n"}


def main() -> None:
    """Measure, and write the page."""
    fill("docs/cluster.md", blocks(QUICK if "--quick" in sys.argv[1:] else FULL))


if __name__ == "__main__":
    main()
