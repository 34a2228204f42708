"""Quasi-random samples of a design with tolerances, and what they say."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.studies.progress import Progress
from strainwave.studies.tolerance.responses import Responses
from strainwave.studies.tolerance.toleranced import Toleranced, sampled

ROWS_AT_ONCE = 2048
CONFIDENCE = 0.95
PERCENTILES = (0.1, 1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 99.9)


@dataclass(frozen=True)
class Yield:
    """The probability of no interference in motion."""

    share: float
    low: float
    """Lower end of Wilson's interval at ``confidence``."""
    high: float
    confidence: float
    passed: int
    """How many samples have no interference."""
    samples: int

    @classmethod
    def of(cls, responses: Responses) -> Self:
        """The share of samples without interference; what is no gear has not passed."""
        from scipy.stats import binomtest

        passed, samples = int(np.sum(responses.min_in_motion_um >= 0.0)), len(responses)
        interval = binomtest(passed, samples).proportion_ci(CONFIDENCE, method="wilson")
        return cls(passed / samples, float(interval.low), float(interval.high), CONFIDENCE, passed, samples)


@dataclass(frozen=True, eq=False)
class MonteCarlo:
    """Points of a scrambled Sobol' sequence (A. B. Owen, 1995) and their responses."""

    parameters: tuple[Toleranced, ...]
    seed: int
    asked: int
    """How many samples were asked for; Ctrl-C leaves fewer."""
    values: Floats
    """Values of the parameters, (samples, parameters)."""
    responses: Responses
    interrupted: bool
    """Whether Ctrl-C ended the sampling."""

    @classmethod
    def run(
        cls,
        design: Design,
        parameters: Sequence[Toleranced],
        samples: int,
        seed: int,
        *,
        threads: int,
        progress: Progress,
    ) -> Self:
        """Evaluate ``samples`` points, a power of two. Ctrl-C keeps what is done, which is again such a sequence."""
        from scipy.stats import qmc

        sequence = qmc.Sobol(len(parameters), rng=np.random.default_rng(seed))
        values: list[Floats] = []
        parts: list[Responses] = []
        interrupted = False
        try:
            for start in range(0, samples, ROWS_AT_ONCE):
                rows = sampled(parameters, sequence.random(min(ROWS_AT_ONCE, samples)))
                parts.append(Responses.of(design, parameters, rows, threads))
                values.append(rows)
                progress(min(start + ROWS_AT_ONCE, samples), samples)
        except KeyboardInterrupt:
            if not values:
                raise
            interrupted = True
        responses = Responses.joined(parts[: len(values)])
        return cls(tuple(parameters), seed, samples, np.concatenate(values), responses, interrupted)

    @property
    def impossible(self) -> int:
        """How many samples are no gear."""
        return int(np.isnan(self.responses.min_in_motion_um).sum())

    @property
    def without_play(self) -> int:
        """How many samples have no play: those that are no gear, or whose teeth no turn frees."""
        return int(np.isnan(self.responses.play_um).sum())


def percentiles(values: Floats) -> dict[float, float]:
    """The ``PERCENTILES`` of the values that are there; nan where there is none."""
    there = values[~np.isnan(values)]
    found = np.percentile(there, PERCENTILES) if len(there) else np.full(len(PERCENTILES), np.nan)
    return dict(zip(PERCENTILES, found.tolist(), strict=True))
