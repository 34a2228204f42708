"""The sections along the face in the report of ``strainwave analyze``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import grid
from strainwave.cli.tables.number import fixed

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table
    from rich.text import Text

    from strainwave.analysis import FaceMap


def face_report(face: FaceMap) -> Iterator[RenderableType]:
    """Every section of the face, and what the worst of them means."""
    from rich.padding import Padding
    from rich.text import Text

    yield Padding(_sections(face), (1, 0, 0, 0))
    yield _verdict(face)
    mid_face = float(face.w0_mm[face.mid_face])
    yield Text(
        f"note: the cup opens like a cone: w0 is {mid_face:.4f} mm at mid-face, {face.w0_open_end_mm:.4f} mm at the "
        f"open end ({100.0 * (face.w0_open_end_mm / mid_face - 1.0):+.1f} %). The teeth incline with it, which changes "
        f"no gap by more than {face.tilt_bound_um:.2f} µm.",
        "dim",
    )


def _sections(face: FaceMap) -> Table:
    analysis = face.analysis
    table = grid(
        "section, z mm", "w0 mm", f"least at {analysis.generator_angle_deg:g}° µm", "in motion µm", "at index ±"
    )
    table.add_column("state")
    for number in range(len(face))[::-1]:
        overlaps = bool(face.min_in_motion_um[number] < 0.0)
        name = fixed(face.z_mm[number])
        if number == face.mid_face:
            name += "  mid-face"
        table.add_row(
            name,
            fixed(face.w0_mm[number], 4),
            fixed(face.min_backlash_um[number]),
            fixed(face.min_in_motion_um[number]),
            fixed(face.min_in_motion_index[number], 1),
            "interferes" if overlaps else "free",
            style="bold red" if overlaps else "",
        )
    return table


def _verdict(face: FaceMap) -> Text:
    from rich.text import Text

    where = f"at z = {face.z_mm[face.worst]:.2f} mm"
    if face.interference:
        words = f"INTERFERENCE along the face, {-face.worst_in_motion_um:.2f} µm deep {where}"
        return Text(words, "bold red")
    words = f"NO INTERFERENCE along the face, least gap {face.worst_in_motion_um:.2f} µm {where}"
    return Text(words, "bold green")
