"""A shape of the user's own, sampled or as a Fourier series."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, ValidationInfo, field_validator

from strainwave.errors import Fault, FaultError
from strainwave.quantities import Quantity
from strainwave.wave_generators.shape import HarmonicShape
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator

GREATEST_COUNT = 1025
PEAK_TOLERANCE = 1e-6  # how far w(0)/w0 may be from 1

Ratios = tuple[Annotated[float, Quantity("", -1e3, 1e3)], ...]


def cosine_coefficients(samples: NDArray[np.float64]) -> NDArray[np.float64]:
    """Coefficients c[n] of the series in cos(2 n phi) through samples at evenly spaced angles from 0 to 90 degrees.

    Trigonometric interpolation (DCT-I): exact for a series of no more terms than samples.
    """
    count = len(samples) - 1
    coefficients = np.fft.rfft(np.concatenate([samples, samples[-2:0:-1]])).real / count
    coefficients[[0, -1]] /= 2.0
    return coefficients


class Table(ShapedWaveGenerator):
    """w/w0 as samples at evenly spaced angles, or as Fourier coefficients."""

    kind: Literal["table"] = "table"
    samples: Annotated[
        Ratios | None,
        Field(
            max_length=GREATEST_COUNT,
            description="w/w0 at evenly spaced angles from 0 to 90 degrees, both included; the first is 1",
            examples=[[1.0, 0.0, -1.0]],
        ),
    ] = None
    fourier: Annotated[
        Ratios | None,
        Field(
            validate_default=True,
            max_length=GREATEST_COUNT,
            description="Coefficients a0, a2, a4, … of w/w0 = a0 + a2 cos 2 phi + a4 cos 4 phi + …; their sum is 1",
            examples=[[0.0, 1.0]],
        ),
    ] = None

    @classmethod
    def of(cls, w: Callable[[float], float], *, count: int = 181, **keys: Any) -> Table:
        """The table of a function: w(phi) in mm, phi in rad from the major axis, sampled at `count` angles.

        w0 is w(0). `keys` are the table's other keys, such as neutral_curve. ValueError if w(0) is not above 0.
        """
        values = np.array([float(w(float(phi))) for phi in np.linspace(0.0, np.pi / 2.0, count)])
        w0 = float(values[0])
        if not w0 > 0.0:
            raise ValueError(f"w(0) must be above 0, and is {w0:g} mm")
        return cls(w0=w0, samples=tuple((values / w0).tolist()), **keys)

    @field_validator("samples")
    @classmethod
    def _starts_at_one(cls, samples: Ratios | None) -> Ratios | None:
        if samples is not None:
            _check_least(samples, least=3)
            _check_peak(samples[0], "its first value is w(0)/w0")
        return samples

    @field_validator("fourier")
    @classmethod
    def _adds_up_to_one(cls, fourier: Ratios | None, info: ValidationInfo) -> Ratios | None:
        samples_given = info.data.get("samples", "faulty") is not None
        if samples_given == (fourier is not None):
            problem = "is given together with samples" if samples_given else "is missing, and so is samples"
            raise FaultError([Fault("", None, "", problem, "Give one of samples and fourier")])
        if fourier is not None:
            _check_least(fourier, least=2)
            _check_peak(math.fsum(fourier), "the sum of its coefficients is w(0)/w0")
        return fourier

    def shape(self, radius: float) -> HarmonicShape:
        """The cosine series, whatever the radius; see `ShapedWaveGenerator.shape`."""
        if self.fourier is not None:
            return HarmonicShape(np.array(self.fourier))
        return HarmonicShape(cosine_coefficients(np.array(self.samples)))


def _check_least(values: Ratios, least: int) -> None:
    if len(values) < least:
        problem = f"must hold at least {least} numbers, and holds {len(values)}"
        raise FaultError([Fault("", None, "", problem)])


def _check_peak(value: float, what: str) -> None:
    if abs(value - 1.0) > PEAK_TOLERANCE:
        remedy = "Divide all of them by it, and multiply w0 by it"
        raise FaultError([Fault("", value, "", f"must be 1 within {PEAK_TOLERANCE:g}: {what}", remedy)])
