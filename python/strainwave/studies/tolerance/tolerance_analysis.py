"""What the tolerances of a design mean for its backlash."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainwave.design import Design
from strainwave.studies.tolerance.monte_carlo import MonteCarlo, Yield, percentiles
from strainwave.studies.tolerance.responses import Responses
from strainwave.studies.tolerance.sensitivity import Sensitivity
from strainwave.studies.tolerance.sobol_indices import SobolIndices
from strainwave.studies.tolerance.tolerances import Tolerances
from strainwave.studies.tolerance.witness_point import Witness

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class ToleranceAnalysis:
    """Yield, percentiles, Sobol' indices and local sensitivities of a design with tolerances."""

    design: Design
    tolerances: Tolerances
    nominal: Responses
    """The design itself, one row."""
    monte_carlo: MonteCarlo
    yield_: Yield
    """The probability of no interference in motion."""
    witness: Witness
    """Where the design's teeth are closest in motion, which the sensitivities hold for."""
    sensitivities: tuple[Sensitivity, ...]
    sobol_samples: int
    sobol: Mapping[str, SobolIndices | None] | None
    """Indices by response, ``min_in_motion_um`` and ``play_circumferential_um``: None for a response that some sample
    does not have, and altogether where Ctrl-C came first."""

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C ended the study before its end."""
        return self.sobol is None

    @property
    def min_in_motion_percentiles_um(self) -> dict[float, float]:
        """Percentiles of the least backlash in motion; below -5 um upper bounds (the least at angle 0)."""
        return percentiles(self.monte_carlo.responses.min_in_motion_um)

    @property
    def play_percentiles_um(self) -> dict[float, float]:
        """Percentiles of the circumferential play at generator angle 0, the circular spline centred."""
        return percentiles(self.monte_carlo.responses.play_um)

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; None where a value is absent."""
        from strainwave.studies.tolerance.record import tolerance_record

        return tolerance_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row per sample, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.studies.tolerance.record import csv_text
        from strainwave.whole_file import write_whole

        write_whole(Path(path), csv_text(self), overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw the distribution of the least backlash in motion, and what causes it."""
        from strainwave.plots.tolerance import tolerance_figure

        return tolerance_figure(self)

    def __repr__(self) -> str:
        return f"<ToleranceAnalysis of {self.design.name!r}: yield {self.yield_.share:.2%}>"
