"""The parts of designs in rows as the kernel takes them."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

from strainwave._kernel import BatchCurves, BatchProfiles
from strainwave.columns import NOTHING_VARIED, column
from strainwave.design import Design, DesignRows
from strainwave.profiles import Gear

Spline = Literal["flexspline", "circular_spline"]


def profiles(rows: DesignRows, spline: Spline) -> BatchProfiles:
    """The profiles of one spline; the same numbers as `Geometry.of` takes for one design."""
    if rows.profile(spline) or "module" in rows.varied:
        return _built(rows, spline)
    return _same(rows.design, spline)


@lru_cache(maxsize=64)  # an optimiser that asks for a row at a time asks for the same parts each time
def _same(design: Design, spline: Spline) -> BatchProfiles:
    return _built(DesignRows(design, NOTHING_VARIED), spline)


def _built(rows: DesignRows, spline: Spline) -> BatchProfiles:
    toothed, varied, module = getattr(rows.design, spline), rows.profile(spline), rows.module
    spec, internal = toothed.profile, spline == "circular_spline"
    return BatchProfiles(
        spec.flanks(Gear(module, toothed.teeth, internal), varied),
        teeth=toothed.teeth,
        pitch_radius=0.5 * module * toothed.teeth,
        internal=internal,
        addendum=column(varied, "addendum", spec.addendum) * module,
        dedendum=column(varied, "dedendum", spec.dedendum) * module,
        offset=column(varied, "offset", spec.offset),
        fillet_radius=column(varied, "root_fillet_radius", spec.root_fillet_radius) * module,
    )


def curves(rows: DesignRows) -> BatchCurves:
    """The neutral curves."""
    return rows.design.wave_generator.curves(rows.neutral_radius_mm, rows.wave_generator)
