"""A shape of the user's own, sampled or as a Fourier series."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, ValidationInfo, field_validator

from strainwave.columns import Columns, Floats, Mask, Refusals, array
from strainwave.errors import Fault, FaultError
from strainwave.quantities import Quantity
from strainwave.wave_generators.shape import HarmonicShapes
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator

GREATEST_COUNT = 1025
PEAK_TOLERANCE = 1e-6  # how far w(0)/w0 may be from 1

Ratios = tuple[Annotated[float, Quantity("", -1e3, 1e3)], ...]


def cosine_coefficients(samples: Floats) -> Floats:
    """Coefficients c[n] of the series in cos(2 n phi) through samples at evenly spaced angles from 0 to 90 degrees.

    Both run along the last axis. Trigonometric interpolation (DCT-I): exact for a series of no more terms than samples.
    """
    count = samples.shape[-1] - 1
    coefficients: Floats = np.fft.rfft(np.concatenate([samples, samples[..., -2:0:-1]], axis=-1)).real / count
    coefficients[..., [0, -1]] /= 2.0
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
            _check_peak(peak_of_samples(np.array([samples])), "its first value is w(0)/w0")
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
            _check_peak(peak_of_series(np.array([fourier])), "the sum of its coefficients is w(0)/w0")
        return fourier

    def shapes(self, radius: Floats, varied: Columns) -> HarmonicShapes:
        """The cosine series, whatever the radius; see `ShapedWaveGenerator.shapes`."""
        name, values = self._values(varied)
        return HarmonicShapes(values if name == "fourier" else cosine_coefficients(values))

    def refusals(self, varied: Columns) -> Refusals:
        """Rows in which w(0)/w0 is not 1; see `WaveGenerator.refusals`."""
        name, values = self._values(varied)
        yield "shape-not-one", off_peak(peak_of_series(values) if name == "fourier" else peak_of_samples(values))

    def _values(self, varied: Columns) -> tuple[str, Floats]:
        """Which of the two arrays is given, and its values, (rows, n) or (1, n)."""
        name, same = ("fourier", self.fourier) if self.fourier is not None else ("samples", self.samples)
        assert same is not None
        return name, array(varied, {f"{name}[{place}]": place for place in range(len(same))}, same)


def peak_of_samples(samples: Floats) -> Floats:
    """w(0)/w0 of samples along the last axis."""
    return samples[..., 0]


def peak_of_series(coefficients: Floats) -> Floats:
    """w(0)/w0 of cosine series along the last of two axes."""
    return np.fromiter(map(math.fsum, coefficients.tolist()), np.float64, len(coefficients))


def off_peak(peak: Floats) -> Mask:
    """Where w(0)/w0 is not 1."""
    return np.asarray(np.abs(peak - 1.0) > PEAK_TOLERANCE)


def _check_least(values: Ratios, least: int) -> None:
    if len(values) < least:
        problem = f"must hold at least {least} numbers, and holds {len(values)}"
        raise FaultError([Fault("", None, "", problem)])


def _check_peak(peak: Floats, what: str) -> None:
    if off_peak(peak)[0]:
        remedy = "Divide all of them by it, and multiply w0 by it"
        raise FaultError([Fault("", float(peak[0]), "", f"must be 1 within {PEAK_TOLERANCE:g}: {what}", remedy)])
