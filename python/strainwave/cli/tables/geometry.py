"""The geometry of a design: what to check before any backlash is read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import key_values
from strainwave.cli.tables.number import ABSENT, fixed, signed

if TYPE_CHECKING:
    from rich.table import Table

    from strainwave.analysis import GeometryFigures
    from strainwave.analysis.figures import ProfileFigures
    from strainwave.design import Design


def geometry_table(design: Design, figures: GeometryFigures) -> Table:
    """Profiles and neutral curve, one line each."""
    curve = figures.neutral_curve
    table = key_values()
    table.add_row("flexspline", _profile(design.flexspline.teeth, figures.flexspline))
    table.add_row("circular spline", _profile(design.circular_spline.teeth, figures.circular_spline))
    table.add_row(
        "neutral curve",
        f"{curve.model}, R {curve.radius_mm:.4f} mm, perimeter {curve.perimeter_mm:.4f} mm "
        f"({signed(curve.perimeter_growth * 1e6, 1)} ppm), "
        f"w {signed(curve.major_axis_mm, 4)} mm at the major axis, {signed(curve.minor_axis_mm, 4)} mm at the minor",
    )
    return table


def _profile(teeth: int, profile: ProfileFigures) -> str:
    blend = ABSENT if profile.blend_thickness_modules is None else fixed(profile.blend_thickness_modules, 4)
    return (
        f"{teeth} teeth, S_l* {blend}, tip land {fixed(profile.tip_land_mm, 4)} mm, "
        f"root floor {fixed(profile.root_floor_mm, 4)} mm"
    )
