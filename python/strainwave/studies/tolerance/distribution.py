"""How a number scatters about what the design says: one class a kind, all in the number's own unit."""

from __future__ import annotations

import math
from abc import abstractmethod
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, StrictStr, ValidationInfo, field_validator

from strainwave.columns import Floats
from strainwave.errors import Fault, FaultError
from strainwave.quantities import Quantity
from strainwave.spec import Spec

GREATEST = 1e6
Spread = Annotated[float, Quantity("", 1e-12, GREATEST)]
Deviation = Annotated[float, Quantity("", -GREATEST, GREATEST)]

# Uniform samples are kept this far from 0 and 1, where a normal distribution has no value.
EDGE = 2.0**-53


class Tolerance(Spec):
    """The deviation of one parameter from the design's value."""

    parameter: Annotated[
        StrictStr,
        Field(
            max_length=200,
            description="Dotted key of a number of the design file, or circular_spline.eccentricity",
            examples=["wave_generator.w0"],
        ),
    ]
    kind: str

    def deviations(self, probability: Floats) -> Floats:
        """Deviations whose distribution function has these values between 0 and 1; any shape."""
        found: Floats = self._distribution().ppf(np.clip(probability, EDGE, 1.0 - EDGE))
        return found

    @property
    def mean(self) -> float:
        """Mean deviation."""
        return float(self._distribution().mean())

    @property
    def standard_deviation(self) -> float:
        """Standard deviation of the deviation."""
        return float(self._distribution().std())

    @property
    def ends(self) -> tuple[float, float]:
        """Least and greatest deviation, which may be infinite."""
        low, high = self._distribution().support()
        return float(low), float(high)

    @abstractmethod
    def _distribution(self) -> Any:
        """SciPy's distribution of the deviation."""


class Bell(Tolerance):
    """What the normal distribution and its truncation have in common: its width, and where its middle lies."""

    shift: Annotated[
        Deviation, Field(description="Deviation of the middle from the design's value", examples=[0.001])
    ] = 0.0
    sigma: Annotated[Spread | None, Field(description="Standard deviation of the whole bell", examples=[0.001])] = None
    three_sigma: Annotated[
        Spread | None,
        Field(validate_default=True, description="Three standard deviations, in place of sigma", examples=[0.003]),
    ] = None

    @field_validator("three_sigma")
    @classmethod
    def _one_of_two(cls, three_sigma: float | None, info: ValidationInfo) -> float | None:
        if "sigma" in info.data and (info.data["sigma"] is None) == (three_sigma is None):
            problem = "is missing, and so is sigma" if three_sigma is None else "is given together with sigma"
            raise FaultError([Fault("", three_sigma, "", problem, "Give one of sigma and three_sigma")])
        return three_sigma

    @property
    def width(self) -> float:
        """Standard deviation of the whole bell."""
        if self.sigma is not None:
            return self.sigma
        assert self.three_sigma is not None
        return self.three_sigma / 3.0


class Normal(Bell):
    """A normal distribution."""

    kind: Literal["normal"] = "normal"

    def _distribution(self) -> Any:
        from scipy.stats import norm

        return norm(self.shift, self.width)


class Limited(Tolerance):
    """What has a lower and an upper deviation, as a drawing has."""

    lower: Annotated[Deviation, Field(description="Lower deviation from the design's value", examples=[-0.002])]
    upper: Annotated[Deviation, Field(description="Upper deviation from the design's value", examples=[0.002])]

    @field_validator("upper")
    @classmethod
    def _above_lower(cls, upper: float, info: ValidationInfo) -> float:
        lower = info.data.get("lower", -math.inf)
        if not lower < upper:
            raise FaultError([Fault("", upper, "", f"must be greater than lower = {lower:g}")])
        return upper


class Uniform(Limited):
    """Every deviation between two limits is equally likely."""

    kind: Literal["uniform"] = "uniform"

    def _distribution(self) -> Any:
        from scipy.stats import uniform

        return uniform(self.lower, self.upper - self.lower)


class TruncatedNormal(Bell, Limited):
    """A normal distribution from which inspection has taken what lies outside two limits."""

    kind: Literal["truncated-normal"] = "truncated-normal"

    def _distribution(self) -> Any:
        from scipy.stats import truncnorm

        low, high = ((end - self.shift) / self.width for end in (self.lower, self.upper))
        return truncnorm(low, high, self.shift, self.width)


AnyTolerance = Annotated[Normal | Uniform | TruncatedNormal, Field(discriminator="kind")]
