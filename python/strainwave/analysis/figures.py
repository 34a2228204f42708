"""Figures of the geometry that a designer checks before reading any backlash."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave._kernel import NeutralCurve, Profile
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.units import MICROMETRES_PER_MM
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator

RING_THEORY_KINDS = ("cosine", "two-roller", "four-roller", "dual-disk")


@dataclass(frozen=True)
class ProfileFigures:
    """Figures of one tooth profile as it is cut, with its offset."""

    tip_land_mm: float
    """Width of the land at the addendum circle, both halves."""
    root_floor_mm: float
    """Width of the floor at the root circle, both halves."""
    blend_thickness_modules: float | None
    """S_l*: thickness where the first arc of the flank meets the next piece; none where the flank is one piece."""

    @classmethod
    def of(cls, profile: Profile, module: float) -> ProfileFigures:
        """Read the figures off a profile."""
        flank = [number for number, role in enumerate(profile.roles) if role == "flank"]
        blend = 2 * float(profile.segments[flank[1], 0]) / module if len(flank) > 1 else None
        return cls(profile.tip_land_width, profile.root_floor_width, blend)


@dataclass(frozen=True)
class NeutralCurveFigures:
    """Which neutral curve was used, and how far it is from a thin ring that keeps its length."""

    model: str
    radius_mm: float
    """Radius of the undeformed neutral circle."""
    w0_mm: float
    perimeter_mm: float
    perimeter_growth: float
    """Perimeter over that of the undeformed circle, less 1."""
    major_axis_mm: float
    """Radial displacement of the curve at the major axis."""
    minor_axis_mm: float
    """Radial displacement of the curve at the minor axis."""
    ring_theory_error_um: float | None
    """Order of the error of a linear thin ring, w0^2 / R; none for curves that do not come from ring theory."""

    @classmethod
    def of(cls, curve: NeutralCurve, design: Design) -> NeutralCurveFigures:
        """Read the figures off the neutral curve of a design."""
        generator = design.wave_generator
        major, minor = curve.displacement(np.array([0.0, np.pi / 2]))[:, 0]
        linear = generator.kind in RING_THEORY_KINDS
        return cls(
            model=generator.neutral_curve if isinstance(generator, ShapedWaveGenerator) else generator.kind,
            radius_mm=curve.radius,
            w0_mm=curve.w0,
            perimeter_mm=curve.perimeter,
            perimeter_growth=curve.perimeter / (2 * np.pi * curve.radius) - 1,
            major_axis_mm=float(major),
            minor_axis_mm=float(minor),
            ring_theory_error_um=curve.w0**2 / curve.radius * MICROMETRES_PER_MM if linear else None,
        )


@dataclass(frozen=True)
class GeometryFigures:
    """Figures of both profiles and of the neutral curve."""

    flexspline: ProfileFigures
    circular_spline: ProfileFigures
    neutral_curve: NeutralCurveFigures

    @classmethod
    def of(cls, geometry: Geometry, design: Design) -> GeometryFigures:
        """Read the figures off the geometry of a design."""
        return cls(
            flexspline=ProfileFigures.of(geometry.flexspline, design.module),
            circular_spline=ProfileFigures.of(geometry.circular_spline, design.module),
            neutral_curve=NeutralCurveFigures.of(geometry.neutral_curve, design),
        )
