"""One number of a design and the values that it takes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design, parameters_of
from strainwave.errors import DesignError, Fault, StrainwaveError

MOST_VALUES = 100_000
DECIMALS = 12  # so that 0.85 is written as 0.85


@dataclass(frozen=True, eq=False)
class Axis:
    """A dotted key, its unit in the design file, and the values that it takes, (values,)."""

    key: str
    unit: str
    values: Floats

    @classmethod
    def of(cls, design: Design, key: str, values: object) -> Self:
        """The axis of a number of the design. ``DesignError`` where the key leads to none, ``StrainwaveError`` where
        the values are no list of rising numbers."""
        (parameter,) = parameters_of(design, (key,))
        try:
            numbers = np.array(values, dtype=np.float64)
        except (TypeError, ValueError):
            numbers = np.empty(0)
        rising = numbers.ndim == 1 and np.isfinite(numbers).all() and np.all(np.diff(numbers) > 0.0)
        if not (rising and 1 <= numbers.size <= MOST_VALUES):
            raise StrainwaveError(f"{key}: its values must be a list of 1 to {MOST_VALUES} finite numbers that rise")
        return cls(parameter.key, parameter.quantity.unit, numbers)

    @classmethod
    def between(cls, design: Design, key: str, first: str | float, last: str | float, count: int) -> Self:
        """``count`` evenly spaced values with both ends; an angle may be text, such as 7°30'."""
        (parameter,) = parameters_of(design, (key,))
        ends: list[float] = []
        for value in map(_number_or_angle, (first, last)):
            try:
                ends.append(parameter.quantity.read(value))
            except ValueError as error:
                problem = f"{error}, as an end of its range"
                raise DesignError([Fault(key, value, parameter.quantity.unit, problem)]) from None
        if not 1 <= count <= MOST_VALUES:
            raise StrainwaveError(f"{key}: the number of values must be from 1 to {MOST_VALUES}, not {count}")
        if count > 1 and not ends[0] < ends[1]:
            problem = f"must be below the other end of its range, {ends[1]:g}"
            raise DesignError([Fault(key, ends[0], parameter.quantity.unit, problem)])
        return cls.of(design, key, np.round(np.linspace(ends[0], ends[1], count), DECIMALS))

    @property
    def label(self) -> str:
        """The key with its unit."""
        return f"{self.key}, {self.unit}" if self.unit else self.key


def _number_or_angle(value: str | float) -> str | float:
    try:
        return float(value)
    except ValueError:
        return value
