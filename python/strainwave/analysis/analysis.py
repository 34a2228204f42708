"""Backlash and interference of one design, everything that was computed about it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from strainwave.analysis.counts import ToothCount
from strainwave.analysis.figures import GeometryFigures
from strainwave.analysis.gap_curve import CertifiedMinimum, GapCurve
from strainwave.analysis.lobe import drive_teeth, tooth_index, within_lobe
from strainwave.analysis.play import Play
from strainwave.analysis.rim import Rim
from strainwave.analysis.teeth import Teeth
from strainwave.analysis.warnings import neutral_curve_warnings, play_warnings
from strainwave.analysis.witness import Witnesses
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Analysis:
    """Backlash and interference of a design; clearances are signed, a gap is positive and a depth negative.

    ``teeth`` and the figures without "in motion" hold at ``generator_angle_deg``; counts hold at angle 0; the figures
    in motion hold for every angle.
    """

    design: Design
    geometry: Geometry
    generator_angle_deg: float
    threshold_um: float
    teeth: Teeth
    """The teeth of the lobe about the generator's major axis."""
    min_backlash_um: float
    """Least normal backlash over all z_f teeth."""
    min_tooth: int
    """The tooth that has it; of equal ones the nearest to the major axis, on its right."""
    in_motion: CertifiedMinimum
    """Least normal backlash over continuous tooth index: of all teeth at every generator angle."""
    witness_in_motion: Witnesses
    """Where the teeth are closest at ``in_motion.index``; arrays of shape ``(1, 2)``."""
    teeth_below: ToothCount
    """Teeth with 0 <= gap < ``threshold_um`` at generator angle 0."""
    teeth_interfering: ToothCount
    """Teeth with a negative gap at generator angle 0."""
    interfering_teeth: NDArray[np.int64]
    """Numbers of the teeth of the lobe in ``teeth`` that interfere."""
    first_interfering_tooth: int | None
    """The interfering tooth nearest to the major axis, on its right."""
    play: Play
    play_in_motion: Play
    """Play at the least favourable generator angle."""
    figures: GeometryFigures
    gap_curve: GapCurve

    @property
    def min_in_motion_um(self) -> float:
        """Least normal backlash of all teeth at every generator angle."""
        return self.in_motion.gap_um

    @property
    def min_in_motion_index(self) -> float:
        """Tooth index of that least backlash, 0 .. z_f / 4; its mirror image is as close."""
        return self.in_motion.index

    @property
    def interference(self) -> bool:
        """Whether teeth overlap at any generator angle."""
        return self.in_motion.gap_um < 0.0

    @property
    def verdict(self) -> str:
        """Whether teeth overlap at any generator angle and by how much, in words."""
        if self.interference:
            return f"INTERFERENCE in motion, {-self.min_in_motion_um:.2f} µm deep"
        return f"NO INTERFERENCE in motion, least gap {self.min_in_motion_um:.2f} µm"

    @property
    def tip_clearance_um(self) -> float:
        """Least radial clearance from a flexspline tip to the circular spline's root circle, of all teeth."""
        return float(self._radial_um[0])

    @property
    def root_clearance_um(self) -> float:
        """Least radial clearance from the circular spline's tip circle to a flexspline root, of all teeth."""
        return float(self._radial_um[1])

    @cached_property
    def _radial_um(self) -> NDArray[np.float64]:
        """The least tip and root clearance of all z_f teeth: with an odd number those of the lobe are but half."""
        teeth, angle_rad = self.design.flexspline.teeth, math.radians(self.generator_angle_deg)
        index = within_lobe(tooth_index(drive_teeth(teeth), self.design, angle_rad), teeth)
        least: NDArray[np.float64] = self.geometry.engagement.radial_clearances(abs(index)).min(axis=0)
        return least * MICROMETRES_PER_MM

    def rim(self, phi_deg: ArrayLike) -> Rim:
        """Displacements, slope and bending moment of the rim at polar angles from the major axis, of any shape."""
        return Rim.at(self.geometry.neutral_curve, phi_deg)

    @cached_property
    def warnings(self) -> tuple[str, ...]:
        """What to know about the neutral curve and the play before relying on the last micrometre."""
        return (*neutral_curve_warnings(self.figures.neutral_curve), *play_warnings(self.teeth))

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; ``None`` where a value is absent."""
        from strainwave.analysis.record import analysis_record

        return analysis_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row per tooth, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.analysis.record import csv_text
        from strainwave.whole_file import write_whole

        write_whole(Path(path), csv_text(self.teeth), overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw the backlash distribution over the tooth index."""
        from strainwave.plots import backlash_figure

        return backlash_figure(self)

    def __repr__(self) -> str:
        verdict = "interference" if self.interference else "no interference"
        return (
            f"<Analysis of {self.design.name!r}: {verdict}, {self.min_in_motion_um:.3f} µm in motion "
            f"at index {self.min_in_motion_index:.2f}>"
        )

    def _repr_html_(self) -> str:
        from strainwave.analysis.notebook import analysis_html

        return analysis_html(self)
