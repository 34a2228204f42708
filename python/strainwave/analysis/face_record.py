"""A face map as plain data: stable keys with units in their names."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING, Any

from strainwave.analysis.record import analysis_record

if TYPE_CHECKING:
    from strainwave.analysis.face import FaceMap

SECTION_COLUMNS = ("z_mm", "w0_mm", "min_backlash_um", "min_in_motion_um", "min_in_motion_index")
TOOTH_COLUMNS = ("z_mm", "w0_mm", "tooth", "index", "backlash_um")


def face_record(face: FaceMap) -> dict[str, Any]:
    """The map under the keys that every face and later version keeps."""
    columns = [getattr(face, name).tolist() for name in SECTION_COLUMNS]
    sections = [dict(zip(SECTION_COLUMNS, row, strict=True)) for row in zip(*columns, strict=True)]
    for section, gaps in zip(sections, face.gap_um.tolist(), strict=True):
        section["backlash_um"] = gaps
    return {
        "min_in_motion_um": face.worst_in_motion_um,
        "interference": face.interference,
        "worst_section": face.worst,
        "mid_face_section": face.mid_face,
        "w0_mid_face_mm": float(face.w0_mm[face.mid_face]),
        "w0_open_end_mm": face.w0_open_end_mm,
        "tilt_bound_um": face.tilt_bound_um,
        "sections": sections,
    }


def record_with_face(face: FaceMap) -> dict[str, Any]:
    """The analysis with its map under the key "face"."""
    return {**analysis_record(face.analysis), "face": face_record(face)}


def face_csv_text(face: FaceMap) -> str:
    """One line per section and tooth, below one header line."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(TOOTH_COLUMNS)
    teeth = face.analysis.teeth
    for z, w0, gaps in zip(face.z_mm.tolist(), face.w0_mm.tolist(), face.gap_um.tolist(), strict=True):
        rows = zip(teeth.tooth.tolist(), teeth.index.tolist(), gaps, strict=True)
        writer.writerows((z, w0, *row) for row in rows)
    return text.getvalue()
