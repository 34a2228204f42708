"""Functions of the C library on arrays, element by element.

NumPy takes some of its functions from vector libraries whose last bit may depend on how an array lies in memory. These
give each element what it would get alone, so that a row of a batch equals the same design by itself to the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def sin(angle: ArrayLike) -> Floats:
    """Sine of angles in rad."""
    return _each(math.sin, angle)


def cos(angle: ArrayLike) -> Floats:
    """Cosine of angles in rad."""
    return _each(math.cos, angle)


def tan(angle: ArrayLike) -> Floats:
    """Tangent of angles in rad."""
    return _each(math.tan, angle)


def arctan(ratio: ArrayLike) -> Floats:
    """Arctangent in rad."""
    return _each(math.atan, ratio)


def arcsin(ratio: ArrayLike) -> Floats:
    """Arcsine in rad; the ratios lie from -1 to 1."""
    return _each(math.asin, ratio)


def arctan2(y: ArrayLike, x: ArrayLike) -> Floats:
    """Angle in rad of the direction (x, y) from the x axis; arguments are broadcast."""
    return _each_pair(math.atan2, y, x)


def hypot(x: ArrayLike, y: ArrayLike) -> Floats:
    """Length of (x, y); arguments are broadcast."""
    return _each_pair(math.hypot, x, y)


def remainder(value: ArrayLike, period: float) -> Floats:
    """IEEE 754 remainder: what is left of each value to the nearest multiple of `period`."""
    return _each(lambda each: math.remainder(each, period), value)


def _each(function: Callable[[float], float], argument: ArrayLike) -> Floats:
    values = np.asarray(argument, dtype=np.float64)
    return np.fromiter(map(function, values.ravel().tolist()), np.float64, values.size).reshape(values.shape)


def _each_pair(function: Callable[[float, float], float], first: ArrayLike, second: ArrayLike) -> Floats:
    one, other = np.broadcast_arrays(np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64))
    pairs = map(function, one.ravel().tolist(), other.ravel().tolist())
    return np.fromiter(pairs, np.float64, one.size).reshape(one.shape)
