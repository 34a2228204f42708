"""Backlash along the face: the cup's coning gives every section of the teeth another displacement."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from strainwave.analysis.analysis import Analysis
from strainwave.columns import Floats

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class FaceMap:
    """Clearances in sections along the face, signed: a gap is positive, a depth negative.

    Each section is a plane gear with the displacement that the coned cup has there; the one at mid-face is that of
    ``analysis``. Sections run from the diaphragm's side to the open end; shapes ``(sections,)`` unless stated.
    """

    analysis: Analysis
    z_mm: Floats
    """Places of the sections along the axis, from the diaphragm's outer face."""
    w0_mm: Floats
    """Radial displacement of the neutral curve at the major axis."""
    gap_um: Floats
    """Normal backlash of the teeth of ``analysis.teeth`` in each section; shape ``(sections, teeth)``."""
    drive_gap_um: Floats
    """The same of all z_f teeth, in the order of ``drive_teeth``; shape ``(sections, z_f)``."""
    min_backlash_um: Floats
    """Least normal backlash of all z_f teeth, at the generator angle of ``analysis``."""
    min_in_motion_um: Floats
    """Least normal backlash over all generator angles, certified in each section as in ``analysis``."""
    min_in_motion_index: Floats
    w0_open_end_mm: float
    """Displacement at the cup's open end, whether teeth meet there or not."""
    tilt_bound_um: float
    """The teeth incline along the axis, so that a plane cuts them where their material sections are not; no gap in the
    cutting plane differs by more than this from that of the section."""

    def __len__(self) -> int:
        return len(self.z_mm)

    @property
    def mid_face(self) -> int:
        """Number of the section at mid-face."""
        return len(self) // 2

    @property
    def worst(self) -> int:
        """Number of the section with the least backlash in motion."""
        return int(self.min_in_motion_um.argmin())

    @property
    def worst_in_motion_um(self) -> float:
        """Least normal backlash over all sections and generator angles."""
        return float(self.min_in_motion_um[self.worst])

    @property
    def interference(self) -> bool:
        """Whether teeth overlap in any section at any generator angle."""
        return self.worst_in_motion_um < 0.0

    @property
    def interfering_sections(self) -> NDArray[np.int64]:
        """Numbers of the sections in which teeth overlap at some generator angle."""
        return np.flatnonzero(self.min_in_motion_um < 0.0)

    def as_dict(self) -> dict[str, Any]:
        """The map as plain numbers under stable keys."""
        from strainwave.analysis.face_record import face_record

        return face_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """The analysis as JSON text, with the map under the key "face"."""
        from strainwave.analysis.face_record import record_with_face
        from strainwave.analysis.record import json_text

        return json_text(record_with_face(self), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row per section and tooth, whole or not at all; an existing file is an error unless
        ``overwrite``."""
        from strainwave.analysis.face_record import face_csv_text
        from strainwave.whole_file import write_whole

        write_whole(Path(path), face_csv_text(self), overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw the backlash over tooth index and face."""
        from strainwave.plots.face import face_figure

        return face_figure(self)

    def __repr__(self) -> str:
        return (
            f"<FaceMap of {self.analysis.design.name!r}: {len(self)} sections, {self.worst_in_motion_um:.3f} µm in "
            f"motion at z = {self.z_mm[self.worst]:.2f} mm>"
        )
