"""Any block of a scrambled Sobol' sequence, without the points before it."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats

BITS = 30
"""Binary digits of a coordinate, and of the number of points that a sequence has."""

_Words = NDArray[np.uint32]


class SobolPoints:
    """The sequence that SciPy's ``qmc.Sobol`` draws from a seed, to the last bit (A. B. Owen's scrambling, 1995).

    In Gray-code order a point is the bitwise difference of the direction numbers that its index selects, so that the
    map from index to point is linear over the binary digits (I. A. Antonov and V. M. Saleev, 1979; scrambling keeps
    it so but for a common shift). The points 0 and 2^b are therefore enough to know all. SciPy offers no way to them
    but to run through the sequence, once for a process, which takes 0.3 s for 10^8 points.
    """

    def __init__(self, dimensions: int, seed: int, points: int) -> None:
        from scipy.stats import qmc

        engine = qmc.Sobol(dimensions, bits=BITS, rng=np.random.default_rng(seed))
        self._shift = _words(engine.random(1))
        directions = []
        for digit in range((points - 1).bit_length()):
            engine.fast_forward(2**digit - engine.num_generated)
            directions.append(_words(engine.random(1)) ^ self._shift)
        self._directions = directions

    @classmethod
    @lru_cache(maxsize=4)  # the chunks of a study ask for the same one
    def of(cls, dimensions: int, seed: int, points: int) -> SobolPoints:
        """The sequence up to its first ``points`` points."""
        return cls(dimensions, seed, points)

    def block(self, start: int, count: int) -> Floats:
        """Points ``start`` and on in [0, 1), (count, dimensions).

        ``start`` is a multiple of a power of two that is not less than ``count``.
        """
        words = np.empty((1 << (count - 1).bit_length(), self._shift.shape[1]), dtype=np.uint32)
        words[0] = self._shift
        for digit, direction in enumerate(self._directions):
            if start >> digit & 1:
                words[0] ^= direction[0]
        filled = 1
        for direction in self._directions:
            if filled >= count:
                break
            words[filled : 2 * filled] = words[:filled] ^ direction
            filled *= 2
        return words[:count].astype(np.float64) * 2.0**-BITS


def _words(points: Floats) -> _Words:
    """Coordinates as whole numbers of ``BITS`` binary digits, which they are exactly."""
    return (points * 2.0**BITS).astype(np.uint32)
