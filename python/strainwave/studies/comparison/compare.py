"""Comparing wave generators."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from strainwave.analysis import Analysis, analyze
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.studies.comparison.comparison import Comparison
from strainwave.studies.comparison.contender import Contender
from strainwave.studies.comparison.generators import DEFAULT_PARAMETERS, Generator, with_generator
from strainwave.studies.comparison.labels import labels_of
from strainwave.studies.comparison.suggestion import suggestions
from strainwave.studies.progress import Progress, silent
from strainwave.studies.tuning import GOALS, Goal, tune
from strainwave.studies.tuning.w0_scan import W0, NoGearError


def compare(
    design: Design,
    generators: Sequence[Generator] = (),
    *,
    w0_mm: float | None = None,
    goal: Goal = "balanced",
    threshold_um: float = 10.0,
    margin_um: float = 0.1,
    threads: int = 0,
    progress: Progress = silent,
) -> Comparison:
    """One pair of splines under its own wave generator and others, at a common w0 and each at the w0 tuned for it.

    ``generators`` are kinds by name, tables without w0, generators, or designs whose generator is meant; left out,
    every kind with ``DEFAULT_PARAMETERS``. ``w0_mm`` is the common w0, by default the design's own; that of a generator
    or of another design does not count. ``goal``, ``margin_um`` and ``threads`` are those of ``tune``. Ctrl-C keeps the
    generators that are finished and marks the result as interrupted. Raises ``DesignError`` where a profile or a
    generator's table cannot be; a generator that makes no gear has rows that say why.
    """
    if goal not in GOALS:
        raise StrainwaveError(f"the goal must be one of {', '.join(GOALS)}, not {goal!r}")
    base = design if w0_mm is None else design.replace(W0, w0_mm)
    designs = _distinct([base, *(with_generator(base, each) for each in generators or DEFAULT_PARAMETERS)])
    labels = labels_of([each.wave_generator for each in designs])
    found: list[Contender] = []
    interrupted = False
    try:
        for done, (label, each) in enumerate(zip(labels, designs, strict=True)):
            found += list(_contenders(label, each, goal, threshold_um, margin_um, threads))
            progress(done + 1, len(designs))
    except KeyboardInterrupt:
        if not found:
            raise
        interrupted = True
    found.sort(key=lambda each: each.setting)  # "common" before "tuned", generators in their order
    rated = tuple(replace(each, suggestion=use) for each, use in zip(found, suggestions(found), strict=True))
    return Comparison(base, goal, threshold_um, margin_um, rated, interrupted)


def _distinct(designs: Sequence[Design]) -> list[Design]:
    """The designs without repetitions, in their order."""
    return [each for place, each in enumerate(designs) if each not in designs[:place]]


def _contenders(
    label: str, design: Design, goal: Goal, threshold_um: float, margin_um: float, threads: int
) -> Iterator[Contender]:
    kind = design.wave_generator.kind
    try:
        tuning = tune(design, threshold_um=threshold_um, margin_um=margin_um, threads=threads)
    except NoGearError as error:
        yield Contender(label, kind, "common", None, str(error))
        yield Contender(label, kind, "tuned", None, str(error))
        return
    problem = "" if tuning.own else _problem(design)
    yield Contender(label, kind, "common", tuning.own, problem)
    best = tuning.best.get(goal)
    tuned: Analysis | None = best.analysis if best else None
    yield Contender(label, kind, "tuned", tuned, "" if best else f"no w0 keeps {margin_um:g} µm in motion")


def _problem(design: Design) -> str:
    try:
        analyze(design)
    except DesignError as error:
        return str(error)
    raise AssertionError("tuning found no gear at the design's own w0, yet there is one")
