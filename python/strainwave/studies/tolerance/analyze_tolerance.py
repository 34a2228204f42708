"""From a design and its tolerances to yield, scatter and its causes."""

from __future__ import annotations

import numpy as np

from strainwave.batch.evaluate import check_numbers
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studies.progress import Progress, silent
from strainwave.studies.tolerance.monte_carlo import ROWS_AT_ONCE, MonteCarlo, Yield
from strainwave.studies.tolerance.responses import Responses
from strainwave.studies.tolerance.sensitivity import sensitivities
from strainwave.studies.tolerance.sobol_indices import SobolIndices
from strainwave.studies.tolerance.tolerance_analysis import ToleranceAnalysis
from strainwave.studies.tolerance.toleranced import Toleranced, sampled
from strainwave.studies.tolerance.tolerances import Tolerances

LEAST_SAMPLES = 64
GREATEST_SAMPLES = 2**22
GREATEST_BASE = 2**18
RESPONSES = ("min_in_motion_um", "play_circumferential_um")


def analyze_tolerance(
    design: Design,
    tolerances: Tolerances,
    *,
    samples: int = 16384,
    sobol_samples: int = 1024,
    seed: int = 1,
    threads: int = 0,
    progress: Progress = silent,
) -> ToleranceAnalysis:
    """Yield, percentiles, Sobol' indices and local sensitivities of a design whose numbers scatter.

    ``samples`` quasi-random designs give yield and percentiles; ``sobol_samples`` (parameters + 2) more give the Sobol'
    indices; both are rounded up to powers of two. The same ``seed`` gives the same result on any number of ``threads``
    (0: all cores). Ctrl-C ends the study and keeps the samples that are done.

    Raises ``DesignError`` where a tolerance is of no number of the design, or the design has no geometry, and
    ``StrainwaveError`` where a number is wrong.
    """
    check_numbers(1.0, threads)
    samples = _power_of_two("samples", samples, GREATEST_SAMPLES)
    base = _power_of_two("sobol_samples", sobol_samples, GREATEST_BASE)
    if type(seed) is not int or seed < 0:
        raise StrainwaveError(f"seed must be a whole number from 0, not {seed}")
    parameters = tolerances.of(design)
    witness, slopes = sensitivities(design, parameters)
    total = samples + base * (len(parameters) + 2)
    monte_carlo = MonteCarlo.run(
        design, parameters, samples, seed, threads=threads, progress=lambda done, _: progress(done, total)
    )

    def respond(points: Floats) -> Floats:
        values, parts = sampled(parameters, points), []
        for start in range(0, len(values), ROWS_AT_ONCE):
            parts.append(Responses.of(design, parameters, values[start : start + ROWS_AT_ONCE], threads))
            progress(min(samples + start + ROWS_AT_ONCE, total), total)
        found = Responses.joined(parts)
        return np.stack([found.min_in_motion_um, found.play_um])

    sobol = None
    if not monte_carlo.interrupted:
        try:
            # Another seed, so that the indices do not rest on the same points as the yield.
            indices = SobolIndices.of(respond, len(parameters), base, seed + 1)
            sobol = dict(zip(RESPONSES, indices, strict=True))
        except KeyboardInterrupt:
            pass
    return ToleranceAnalysis(
        design=design,
        tolerances=tolerances,
        nominal=_nominal(design, parameters, threads),
        monte_carlo=monte_carlo,
        yield_=Yield.of(monte_carlo.responses),
        witness=witness,
        sensitivities=slopes,
        sobol_samples=base,
        sobol=sobol,
    )


def _nominal(design: Design, parameters: tuple[Toleranced, ...], threads: int) -> Responses:
    values = np.array([[parameter.nominal for parameter in parameters]])
    # Of one row the minimum in motion is sought however deep it is.
    return Responses.of(design, parameters, values, threads, deep_um=np.inf)


def _power_of_two(name: str, count: int, greatest: int) -> int:
    if type(count) is not int or not LEAST_SAMPLES <= count <= greatest:
        raise StrainwaveError(f"{name} must be a whole number from {LEAST_SAMPLES} to {greatest}, not {count}")
    return 1 << (count - 1).bit_length()
