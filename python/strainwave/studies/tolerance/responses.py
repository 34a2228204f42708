"""What samples of a design with tolerances turn out to be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.batch import evaluate_batch
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.studies.tolerance.toleranced import ECCENTRICITY, Toleranced
from strainwave.units import MICROMETRES_PER_MM

# Where whole teeth overlap by more than this at angle 0, the sample interferes and its minimum in motion is not sought,
# for with 15 to 22 um of interference that takes fifty times as long as without, and the whole study over four times.
DEEP_UM = 5.0


@dataclass(frozen=True, eq=False)
class Responses:
    """Columns of shape (rows,); nan where a sample is no gear."""

    min_in_motion_um: Floats
    """Least backlash at any generator angle, less the circular spline's eccentricity; in deep interference an upper
    bound, the least at angle 0."""
    play_um: Floats
    """Circumferential play at generator angle 0, the circular spline centred."""

    @classmethod
    def of(
        cls,
        design: Design,
        parameters: Sequence[Toleranced],
        values: Floats,
        threads: int,
        *,
        deep_um: float = DEEP_UM,
    ) -> Self:
        """The responses of samples with these values, (rows, parameters); interference above `deep_um` is deep."""
        of_design = [place for place, parameter in enumerate(parameters) if parameter.key != ECCENTRICITY]
        keys = [parameters[place].key for place in of_design]
        table = values[:, of_design]
        metrics = ["min_backlash_um", "play_circumferential_um"]
        batch = evaluate_batch(design, keys, table, metrics=metrics, threads=threads)
        least = np.array(batch.min_backlash_um)
        sought = least >= -deep_um
        if sought.any():
            motion = evaluate_batch(design, keys, table[sought], metrics=[], in_motion=True, threads=threads)
            least[sought] = motion.min_in_motion_um
        return cls(least - _eccentricity_um(parameters, values), batch.play_circumferential_um)

    @classmethod
    def joined(cls, parts: Sequence[Self]) -> Self:
        """The rows of all parts in their order."""
        return cls(
            np.concatenate([part.min_in_motion_um for part in parts]), np.concatenate([part.play_um for part in parts])
        )

    def __len__(self) -> int:
        return len(self.min_in_motion_um)


def _eccentricity_um(parameters: Sequence[Toleranced], values: Floats) -> Floats:
    """How much the eccentricity takes off the least gap over a turn of the wave generator, (rows,).

    A ring displaced by e lowers a gap by e times the cosine between its normal and the displacement; as the generator
    turns, the normal at the closest tooth meets every direction, so to first order the least over a turn is lower by e.
    It is never lower by more.
    """
    for place, parameter in enumerate(parameters):
        if parameter.key == ECCENTRICITY:
            return np.abs(values[:, place]) * MICROMETRES_PER_MM
    return np.zeros(len(values))
