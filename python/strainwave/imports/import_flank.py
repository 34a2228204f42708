"""From a file to the profile of a design."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.geometry import Geometry
from strainwave.imports.drawn_chain import DrawnChain
from strainwave.imports.drawn_flank import SAMPLES, DrawnFlank
from strainwave.imports.dxf_file import read_dxf
from strainwave.imports.import_hints import ImportHints
from strainwave.imports.imported_flank import ImportedFlank, Kind, Scatter, Spline
from strainwave.imports.length_unit import mm_of
from strainwave.imports.measured_flank import MeasuredFlank
from strainwave.imports.pieces_file import read_pieces
from strainwave.imports.placement import Placement
from strainwave.imports.points_file import read_points
from strainwave.imports.reach import reaching
from strainwave.profiles import Gear, pieces_table
from strainwave.units import MICROMETRES_PER_MM

CURVE_TOLERANCE_UM = 0.01
POINTS_TOLERANCE_UM = 0.05
GREATEST_ASYMMETRY_UM = 10.0
ROUNDING_MM = 1e-5
# A fillet is tangent to the root circle, and rounding may part the two; so much of it (modules) is left off.
TANGENCY = 1e-9
# So far (modules) a number may be from that of a report, which gives four places.
PRINTED = 1e-4
NOTHING_GIVEN = ImportHints()


def import_flank(
    file: str | os.PathLike[str], design: Design, spline: Spline, hints: ImportHints = NOTHING_GIVEN
) -> ImportedFlank:
    """The flank or tooth in a CSV file of points, a DXF drawing or a JSON file of pieces, as a profile of a design.

    The design gives the module and the numbers of teeth, and with them the pitch circle. The profile replaces the
    design's whole table: its fillet, if any, is among the pieces, and its offset is 0. StrainwaveError or DesignError
    says why a file gives no profile.
    """
    path = Path(file)
    teeth = getattr(design, spline).teeth
    gear = Gear.of(design.module, teeth, internal=spline == "circular_spline")
    kind = _kind_of(path)
    _check_apply(hints, path, kind)
    tolerance_um = hints.tolerance_um or (POINTS_TOLERANCE_UM if kind == "points" else CURVE_TOLERANCE_UM)
    source, unit = _read(path, kind, hints, tolerance_um / MICROMETRES_PER_MM, design.module)
    try:
        found = _found(source, gear, hints, tolerance_um / MICROMETRES_PER_MM)
        table = _table(found, hints, design.module)
    except StrainwaveError as error:
        raise StrainwaveError(f"{path}: {error}") from None
    try:
        changed = design.replace(f"{spline}.profile", table)
        Geometry.of(changed)
    except DesignError as error:
        raise DesignError(error.faults, f"{path}, as {spline}") from None
    return ImportedFlank(
        changed,
        spline,
        path.name,
        kind,
        unit,
        found.extent,
        found.placement.frame,
        found.chain.deviation * MICROMETRES_PER_MM,
        None if found.asymmetry_mm is None else found.asymmetry_mm * MICROMETRES_PER_MM,
        _scatter(found) if kind == "points" and isinstance(found, MeasuredFlank) else None,
    )


def _kind_of(path: Path) -> Kind:
    kinds: dict[str, Kind] = {".dxf": "drawing", ".json": "pieces"}
    return kinds.get(path.suffix.lower(), "points")


def _check_apply(hints: ImportHints, path: Path, kind: Kind) -> None:
    """A hint that says nothing of the file is a mistake."""
    if hints.layer is not None and kind != "drawing":
        raise StrainwaveError(f"{path}: is no drawing (.dxf) and has no layers; leave out the layer (--layer)")
    if hints.noise_um is not None and kind != "points":
        raise StrainwaveError(f"{path}: holds no measured points; leave out the noise (--noise)")


def _read(
    path: Path, kind: Kind, hints: ImportHints, tolerance_mm: float, module: float
) -> tuple[DrawnChain | Floats, str]:
    """What a file holds, in mm, and its unit."""
    if kind == "points":
        unit = hints.unit or "mm"
        return read_points(path) * mm_of(unit, module), unit
    if kind == "pieces":
        chain, own_unit = read_pieces(path)
        unit = hints.unit or own_unit
    else:
        chain, unit = read_dxf(path, layer=hints.layer, unit=hints.unit, tolerance_mm=tolerance_mm, module=module)
    return chain.scaled(mm_of(unit, module)), unit


def _found(
    source: DrawnChain | Floats, gear: Gear, hints: ImportHints, tolerance_mm: float
) -> DrawnFlank | MeasuredFlank:
    """The flank, with the axis found, of a drawing or of points."""
    is_drawn = isinstance(source, DrawnChain)
    points = source.sampled(SAMPLES) if isinstance(source, DrawnChain) else source
    placement = Placement.of(points, gear, center=hints.center_mm, axis_deg=hints.axis_deg)
    axis_given = hints.axis_deg is not None
    noise_mm = None if hints.noise_um is None else hints.noise_um / MICROMETRES_PER_MM
    found: DrawnFlank | MeasuredFlank
    if isinstance(source, DrawnChain):
        found = DrawnFlank.of(source, placement, axis_given=axis_given)
    else:
        found = MeasuredFlank.of(points, placement, axis_given=axis_given, noise_mm=noise_mm, tolerance_mm=tolerance_mm)
    asymmetry_um = (found.asymmetry_mm or 0.0) * MICROMETRES_PER_MM
    if asymmetry_um > GREATEST_ASYMMETRY_UM:
        raise StrainwaveError(
            f"has flanks that differ by {asymmetry_um:.3g} µm; the flanks of a tooth are alike within "
            f"{GREATEST_ASYMMETRY_UM:g} µm. Keep one flank, or name the axis (--axis)"
        )
    if is_drawn and asymmetry_um > ROUNDING_MM * MICROMETRES_PER_MM:
        # Both flanks count: the smooth curve between them.
        between = 0.5 * asymmetry_um / MICROMETRES_PER_MM
        return MeasuredFlank.of(points, placement, axis_given=axis_given, noise_mm=between, tolerance_mm=tolerance_mm)
    return found


def _table(found: DrawnFlank | MeasuredFlank, hints: ImportHints, module: float) -> dict[str, object]:
    """The table of the profile, cut or continued to its circles."""
    heights = found.placement.heights_in_tooth(found.chain.points)
    tip, root = heights[[0, -1]]
    if isinstance(found, MeasuredFlank):
        tip = tip if found.tip_height_mm is None else found.tip_height_mm
        root = root if found.root_height_mm is None else found.root_height_mm
    tip = tip if hints.addendum is None else hints.addendum * module
    root = root if hints.dedendum is None else -hints.dedendum * module
    chain = reaching(found.chain, found.placement, tip_height=float(tip), root_height=float(root))
    addendum, dedendum = (found.placement.heights_in_tooth(chain.points[[0, -1]]) / module * [1.0, -1.0]).tolist()
    _check_reached("addendum", hints.addendum, addendum)
    _check_reached("dedendum", hints.dedendum, dedendum)
    return pieces_table(chain.segments, module, addendum=addendum, dedendum=dedendum - TANGENCY)


def _check_reached(name: str, asked: float | None, reached: float) -> None:
    if asked is not None and asked - reached > PRINTED:
        raise StrainwaveError(
            f"has a flank that leads to {reached:.4f} modules at most, short of the {name} of {asked:g} modules; ask "
            f"for no more (--{name}), or leave it out"
        )


def _scatter(found: MeasuredFlank) -> Scatter:
    residuals = found.residuals_mm * MICROMETRES_PER_MM
    return Scatter(
        found.points,
        found.left_out,
        found.noise_mm * MICROMETRES_PER_MM,
        float(np.sqrt(np.mean(residuals**2))),
        float(residuals.max()),
    )
