"""How much of the scatter each parameter causes: Sobol' indices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from strainwave.columns import Floats


@dataclass(frozen=True, eq=False)
class SobolIndices:
    """Shares of a response's variance, (parameters,).

    Estimated as in A. Saltelli and others, Variance based sensitivity analysis of model output, 2010, table 2 (b), (f).
    """

    first: Floats
    """What a parameter causes by itself."""
    total: Floats
    """The same with all its interactions."""

    @classmethod
    def of(cls, respond: Callable[[Floats], Floats], dimensions: int, samples: int, seed: int) -> list[Self | None]:
        """The indices of each response over the unit cube, in ``samples`` (dimensions + 2) evaluations.

        ``respond`` takes points (rows, dimensions) and returns responses (responses, rows); ``samples`` is a power of
        two. None for a response that some point does not have.
        """
        from scipy.stats import qmc, sobol_indices

        points = qmc.Sobol(2 * dimensions, bits=64, rng=np.random.default_rng(seed)).random(samples)
        a, b = points[:, :dimensions], points[:, dimensions:]
        mixed = np.repeat(a[None], dimensions, axis=0)
        for place in range(dimensions):
            mixed[place, :, place] = b[:, place]
        found = respond(np.concatenate([a, b, mixed.reshape(-1, dimensions)]))
        # (responses, 2 + dimensions, samples): A, B, and A with one column of B after the other.
        return [
            cls._from(sobol_indices, each) if np.isfinite(each).all() else None
            for each in found.reshape(len(found), 2 + dimensions, samples)
        ]

    @classmethod
    def _from(cls, sobol_indices: Callable[..., Any], responses: Floats) -> Self:
        # Twice the same response: of one response to one parameter SciPy (1.17) makes a number, and fails on it.
        f_a, f_b = (np.stack([each, each]) for each in responses[:2])
        f_ab = np.stack([responses[2:], responses[2:]], axis=1)
        indices = sobol_indices(func={"f_A": f_a, "f_B": f_b, "f_AB": f_ab}, n=responses.shape[1])
        return cls(indices.first_order.reshape(2, -1)[0], indices.total_order.reshape(2, -1)[0])
