"""Sobol' indices against functions whose indices are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.columns import Floats
from strainwave.studies.tolerance import SobolIndices


def ishigami(points: Floats) -> Floats:
    """sin x1 + 7 sin² x2 + 0.1 x3⁴ sin x1 on (-π, π)³ (T. Ishigami and T. Homma, 1990)."""
    x, y, z = (math.pi * (2.0 * points - 1.0)).T
    found: Floats = np.sin(x) + 7.0 * np.sin(y) ** 2 + 0.1 * z**4 * np.sin(x)
    return found


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_ishigami(seed: int) -> None:
    """Its variances in closed form (I. M. Sobol' and Y. Levitan, 1999), within 0.02."""
    a, b, pi4 = 7.0, 0.1, math.pi**4
    alone = 0.5 * (1.0 + b * pi4 / 5.0) ** 2, a**2 / 8.0, 0.0
    together = b**2 * pi4**2 * (1.0 / 18.0 - 1.0 / 50.0)  # of x1 and x3
    variance = sum(alone) + together
    (found,) = SobolIndices.of(lambda points: ishigami(points)[None], 3, 4096, seed)
    assert found is not None
    assert found.first == pytest.approx(np.array(alone) / variance, abs=0.02)
    total = np.array([alone[0] + together, alone[1], together]) / variance
    assert found.total == pytest.approx(total, abs=0.02)


def test_each_response_has_its_own_indices_and_none_where_it_is_absent() -> None:
    """A sum has the shares of its terms' variances, 1 : 4; a product of centred numbers nothing but interaction."""

    def respond(points: Floats) -> Floats:
        x, y = (points - 0.5).T
        return np.stack([x + 2.0 * y, x * y, np.where(x > 0.49, np.nan, x), 0.0 * x + 3.0])

    total, product, absent, constant = SobolIndices.of(respond, 2, 2048, 1)
    assert total is not None
    assert total.first == pytest.approx([0.2, 0.8], abs=0.01)
    assert total.total == pytest.approx([0.2, 0.8], abs=0.01)
    assert product is not None
    assert product.first == pytest.approx([0.0, 0.0], abs=0.02)
    assert product.total == pytest.approx([1.0, 1.0], abs=0.02)
    assert absent is None
    assert constant is not None
    assert constant.first.tolist() == constant.total.tolist() == [0.0, 0.0]


def test_a_single_parameter_causes_everything() -> None:
    (found,) = SobolIndices.of(lambda points: np.exp(points.T), 1, 1024, 1)
    assert found is not None
    assert found.first == pytest.approx([1.0], abs=0.01)
    assert found.total == pytest.approx([1.0], abs=0.01)
