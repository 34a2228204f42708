"""What is exported in the plane: the outlines of the parts, as made or as assembled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.design import Design
from strainwave.export.choice import ExportChoice
from strainwave.geometry import Geometry
from strainwave.outlines.generator import bent_bore, generator_outlines
from strainwave.outlines.outline import Outline, placed
from strainwave.outlines.tooth import tooth_roles, tooth_segments
from strainwave.outlines.toothed import all_teeth, one_tooth


@dataclass(frozen=True, eq=False)
class Drawing:
    """Outlines about the gear's centre, mm, the generator's major axis at its angle clockwise from +y."""

    design: Design
    choice: ExportChoice
    outlines: tuple[Outline, ...]

    @classmethod
    def of(cls, design: Design, choice: ExportChoice | None = None) -> Self:
        """The outlines of what is chosen. StrainwaveError where that cannot be."""
        choice = choice or ExportChoice()
        geometry = choice.geometry(design)
        outlines: list[Outline] = []
        if "circular-spline" in choice.parts:
            outlines += _circular_spline(design, geometry, choice)
        if "flexspline" in choice.parts:
            outlines += (
                _deformed(geometry, design, choice) if choice.is_deformed else _as_made(geometry, design, choice)
            )
        if "wave-generator" in choice.parts:
            outlines += generator_outlines(design, geometry, angle=choice.generator_angle)
        return cls(design, choice, tuple(outlines))


def _circular_spline(design: Design, geometry: Geometry, choice: ExportChoice) -> list[Outline]:
    radius = 0.5 * design.circular_spline_outer_diameter_mm
    if choice.tooth is not None:
        return [one_tooth(geometry.circular_spline, "circular-spline", choice.tooth, radius)]
    rim = Outline.circle("circular-spline", "rim", radius, hole=False)
    return [rim, all_teeth(geometry.circular_spline, "circular-spline")]


def _as_made(geometry: Geometry, design: Design, choice: ExportChoice) -> list[Outline]:
    radius = 0.5 * design.bodies.bore
    if choice.tooth is not None:
        return [one_tooth(geometry.flexspline, "flexspline", choice.tooth, radius)]
    bore = Outline.circle("flexspline", "bore", radius, hole=True)
    return [all_teeth(geometry.flexspline, "flexspline"), bore]


def _deformed(geometry: Geometry, design: Design, choice: ExportChoice) -> list[Outline]:
    """Each tooth on its own, from mid-space to mid-space, for it moves as a rigid body; and the bore."""
    profile = geometry.flexspline
    teeth = np.arange(profile.teeth) if choice.tooth is None else np.array([choice.tooth])
    one, roles = tooth_segments(profile, whole=True), tooth_roles(profile)
    found = [
        Outline("flexspline", placed(one, pose), roles, np.full(len(one), tooth % profile.teeth), closed=False)
        for tooth, pose in zip(teeth, geometry.engagement.flexspline_poses(teeth, choice.generator_angle), strict=True)
    ]
    if choice.tooth is None:
        found.append(bent_bore(design, geometry, angle=choice.generator_angle))
    return found
