"""The positions of a gear while its wave generator turns."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.analysis import Analysis
from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.scene import Fixed, Scene, assembly_scene
from strainwave.scene.turning import Turning

MOST_FRAMES = 2000
MOST_TURNS = 1000.0
FASTEST_PER_S = 60.0


@dataclass(frozen=True, eq=False)
class Film:
    """A gear at evenly spaced angles of its generator, from 0 up to, but not including, where it ends."""

    analysis: Analysis
    generator_deg: Floats
    """Of every frame, clockwise, (frames,)."""
    fixed: Fixed
    frames_per_s: float

    @classmethod
    def of(cls, analysis: Analysis, *, frames: int, turns: float, fixed: Fixed, frames_per_s: float) -> Self:
        """`turns` of the generator, clockwise, negative ones the other way. StrainwaveError for what cannot be."""
        Turning.of(analysis.design, 0.0, fixed)  # refuses a spline that there is not
        if not 2 <= frames <= MOST_FRAMES:
            raise StrainwaveError(f"an animation has from 2 to {MOST_FRAMES} frames, not {frames}")
        if not 0.0 < abs(turns) <= MOST_TURNS:
            raise StrainwaveError(
                f"the generator turns by at most {MOST_TURNS:g} turns either way, and not by {turns:g}"
            )
        if not 1.0 <= frames_per_s <= FASTEST_PER_S:
            raise StrainwaveError(f"frames per second must be from 1 to {FASTEST_PER_S:g}, not {frames_per_s:g}")
        return cls(analysis, 360.0 * turns * np.arange(frames) / frames, fixed, frames_per_s)

    def __len__(self) -> int:
        return len(self.generator_deg)

    def turning(self, frame: int) -> Turning:
        """How far each part has turned in a frame."""
        return Turning.of(self.analysis.design, float(self.generator_deg[frame]), self.fixed)

    def scenes(self, chord_error_mm: float) -> Iterator[Scene]:
        """What is to be seen in each frame."""
        for angle in self.generator_deg.tolist():
            yield assembly_scene(
                self.analysis, generator_angle_deg=angle, chord_error_mm=chord_error_mm, fixed=self.fixed
            )

    @property
    def words(self) -> str:
        """Which spline stands still and how the other turns against the generator."""
        design = self.analysis.design
        flexspline, ring = design.flexspline.teeth, design.circular_spline.teeth
        if self.fixed == "flexspline":
            share = f"{ring}/{ring - flexspline} = {ring / (ring - flexspline):g}"
            return f"flexspline fixed; ratio of generator to circular spline {share}: they turn the same way"
        share = f"−{flexspline}/{ring - flexspline} = −{-design.ratio:g}"
        return f"circular spline fixed; ratio of generator to flexspline {share}: they turn opposite ways"
