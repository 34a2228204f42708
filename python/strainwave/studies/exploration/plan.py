"""What an exploration is to compute: the question, whole and without a word about who answers it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Self

import numpy as np

from strainwave.batch import metrics as metric
from strainwave.batch.evaluate import check_numbers
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import DesignError, Fault, StrainwaveError
from strainwave.studies.exploration.category import Category, base_designs, places_of
from strainwave.studies.exploration.sobol_points import BITS, SobolPoints
from strainwave.studies.exploration.space import Range, Space
from strainwave.studies.optimization.free_parameter import FreeParameter, free_parameters

DEFAULT_METRICS = (*metric.ALWAYS, *metric.RADIAL)
GREATEST_SAMPLES = 2**BITS
LEAST_CHUNK_ROWS, GREATEST_CHUNK_ROWS = 64, 2**20
# A large study's chunk is a second or more of one core and a Parquet file of some MB; a small study falls into so many
# chunks that workers finish at about the same time, but none so small that its file costs more than its rows.
DEFAULT_CHUNK_ROWS = 2**10, 2**15
USUAL_CHUNKS = 64


@dataclass(frozen=True)
class Plan:
    """Rows 0 .. samples of a scrambled Sobol' sequence over a space. Equal plans give equal datasets."""

    version: str
    """The version of strainwave, on which the numbers may depend."""
    design: Design
    space: Space
    samples: int
    seed: int
    metrics: tuple[str, ...]
    """Columns of the batch to keep."""
    in_motion: bool
    """Whether designs without interference at angle 0 also get their certified least backlash in motion."""
    threshold_um: float
    chunk_rows: int
    """Rows of a chunk, a power of two; the last chunk may have fewer."""
    study: str = ""
    """A name that this question has and no other one."""

    @classmethod
    def of(
        cls,
        design: Design,
        space: Space,
        samples: int,
        *,
        seed: int,
        metrics: Sequence[str] | None,
        in_motion: bool,
        threshold_um: float,
        chunk_rows: int | None,
    ) -> Self:
        """A plan that can be computed; ``StrainwaveError`` or ``DesignError`` say what cannot be."""
        from strainwave import __version__

        check_numbers(threshold_um, 0)
        _check_whole("samples", samples, 1, GREATEST_SAMPLES)
        _check_whole("seed", seed, 0, 2**63 - 1)
        rows = default_chunk_rows(samples) if chunk_rows is None else chunk_rows
        _check_whole("chunk_rows", rows, LEAST_CHUNK_ROWS, GREATEST_CHUNK_ROWS)
        if rows & (rows - 1):
            raise StrainwaveError(f"chunk_rows must be a power of two, not {rows}; the next is {_power_of_two(rows)}")
        names = metric.asked(DEFAULT_METRICS if metrics is None else metrics, False)
        names = names if "min_backlash_um" in names else ("min_backlash_um", *names)
        plan = cls(__version__, design, space, samples, seed, names, in_motion, threshold_um, rows)
        _ = plan.categories, plan.parameters  # so that what is wrong with them is said here
        return replace(plan, study=study_of(plan.as_dict()))

    def as_dict(self) -> dict[str, Any]:
        """The question as plain data."""
        return {
            "strainwave_version": self.version,
            "design": self.design.to_dict(),
            "space": self.space.to_dict(),
            "samples": self.samples,
            "seed": self.seed,
            "metrics": list(self.metrics),
            "in_motion": self.in_motion,
            "threshold_um": self.threshold_um,
            "chunk_rows": self.chunk_rows,
        }

    @classmethod
    def from_dict(cls, tree: dict[str, Any]) -> Self:
        """The plan of what `as_dict` gives; raises the errors of reading it, of whatever kind."""
        return cls(
            tree["strainwave_version"],
            Design.from_dict(tree["design"]),
            Space.from_dict(tree["space"]),
            tree["samples"],
            tree["seed"],
            tuple(tree["metrics"]),
            tree["in_motion"],
            tree["threshold_um"],
            tree["chunk_rows"],
            study_of(tree),  # as it was asked, also where a later version's designs have more keys
        )

    @cached_property
    def categories(self) -> tuple[Category, ...]:
        """The wave generators, in the order of the space."""
        keys = [each.parameter for each in self.space.parameters]
        designs = base_designs(self.design, self.space.generators)
        return tuple(Category(label, design, places_of(design, keys)) for label, design in designs.items())

    @cached_property
    def parameters(self) -> tuple[FreeParameter, ...]:
        """The numbers that vary, in the order of the space. ``DesignError`` holds every range that cannot be."""
        faults: list[Fault] = []
        found: dict[str, FreeParameter] = {}
        for place, wanted in enumerate(self.space.parameters):
            where = f"parameters[{place}]"
            try:
                free = self._free(place, wanted)
            except DesignError as error:
                faults.extend(
                    Fault(f"{where}: {fault.key}", fault.value, fault.unit, fault.problem, fault.remedy)
                    for fault in error.faults
                )
                continue
            if free.key in found:
                faults.append(Fault(where, free.key, "", "is given twice"))
            found[free.key] = free
        if faults:
            raise DesignError(faults)
        return tuple(found.values())

    @property
    def keys(self) -> tuple[str, ...]:
        """Dotted keys of the numbers that vary."""
        return tuple(parameter.key for parameter in self.parameters)

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the figures of every row."""
        return (*self.metrics, *metric.IN_MOTION) if self.in_motion else self.metrics

    @property
    def chunks(self) -> int:
        """How many chunks there are."""
        return -(-self.samples // self.chunk_rows)

    def rows_of(self, chunk: int) -> range:
        """Which rows a chunk holds."""
        return range(chunk * self.chunk_rows, min((chunk + 1) * self.chunk_rows, self.samples))

    def sampled(self, rows: range) -> tuple[Floats, np.ndarray[Any, np.dtype[np.intp]]]:
        """Values of the parameters, (rows, parameters), and the place of each row's category, of rows of one chunk."""
        several = len(self.categories) > 1
        points = SobolPoints.of(len(self.parameters) + several, self.seed, self.samples)
        cube = points.block(rows.start, len(rows))
        low = np.array([parameter.low for parameter in self.parameters])
        high = np.array([parameter.high for parameter in self.parameters])
        values = low + cube[:, : len(low)] * (high - low)
        if not several:
            return values, np.zeros(len(rows), dtype=np.intp)
        return values, (cube[:, -1] * len(self.categories)).astype(np.intp)

    def _free(self, place: int, wanted: Range) -> FreeParameter:
        """The parameter in the first category that has it; what is wrong with it where none has."""
        design = next((each.design for each in self.categories if place in each.places), self.design)
        (free,) = free_parameters(design, {wanted.parameter: (wanted.low, wanted.high)})
        return free


def study_of(tree: dict[str, Any]) -> str:
    """The name of a question in plain data."""
    text = json.dumps(tree, sort_keys=True, ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def default_chunk_rows(samples: int) -> int:
    """Rows of a chunk where nobody says otherwise; the same for the same study."""
    least, greatest = DEFAULT_CHUNK_ROWS
    return min(max(_power_of_two(samples // USUAL_CHUNKS), least), greatest)


def _power_of_two(least: int) -> int:
    return 1 << max(least - 1, 0).bit_length()


def _check_whole(name: str, value: object, least: int, greatest: int) -> None:
    if type(value) is not int or not least <= value <= greatest:
        raise StrainwaveError(f"{name} must be a whole number from {least} to {greatest}, not {value}")
