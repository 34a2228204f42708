"""A gear as the content of a file in one of the formats, and the file."""

from __future__ import annotations

import os
from collections.abc import Callable

from strainwave.design import Design
from strainwave.export.choice import ExportChoice
from strainwave.export.drawing import Drawing
from strainwave.export.dxf import drawing_dxf
from strainwave.export.format import Format, checked_chord_error
from strainwave.export.pieces import drawing_json
from strainwave.export.points_csv import drawing_csv
from strainwave.export.solid import gear_step
from strainwave.export.surface import gear_glb, gear_stl
from strainwave.export.svg import drawing_svg
from strainwave.whole_file import check_free, write_whole

WRITERS: dict[Format, Callable[[Drawing], str | bytes]] = {
    "dxf": drawing_dxf,
    "svg": drawing_svg,
    "json": drawing_json,
    "step": gear_step,
}


def export_gear(
    design: Design,
    path: str | os.PathLike[str],
    format: Format,
    choice: ExportChoice | None = None,
    *,
    chord_error_mm: float | None = None,
    overwrite: bool = False,
) -> None:
    """Write a gear to a file, whole or not at all.

    `choice` says which parts, as made or as assembled; of none, all as made. `chord_error_mm` is for the formats that
    have chords for arcs; else it is as `CHORD_ERRORS_MODULES` says. StrainwaveError where the choice makes no sense, a
    library is missing, or the file cannot be written or is there already.
    """
    check_free(path, overwrite=overwrite)
    write_whole(path, gear_file(design, format, choice, chord_error_mm=chord_error_mm), overwrite=overwrite)


def gear_file(
    design: Design, format: Format, choice: ExportChoice | None = None, *, chord_error_mm: float | None = None
) -> str | bytes:
    """The content of such a file; see `export_gear`."""
    choice = choice or ExportChoice()
    error = checked_chord_error(format, chord_error_mm, design)
    if format in ("stl", "glb"):
        return (gear_stl if format == "stl" else gear_glb)(design, choice, error)
    drawing = Drawing.of(design, choice)
    if format == "csv":
        return drawing_csv(drawing, chord_error_mm=error)
    return WRITERS[format](drawing)
