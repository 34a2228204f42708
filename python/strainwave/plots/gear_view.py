"""The assembled gear to be looked at: its bodies with their colours, a part of the circular spline cut away."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from strainwave.analysis import FaceMap, face_map
from strainwave.analysis.lobe import drive_teeth
from strainwave.assembly import Mesh, circular_spline_mesh, flexspline_mesh, wave_generator_mesh
from strainwave.assembly.mesh import NO_TOOTH, Indices
from strainwave.columns import Floats, Mask

if TYPE_CHECKING:
    from strainwave.analysis import Analysis

CHORD_ERROR_MODULES = 0.04
# Triangles along the face; more make the page heavy and look the same.
STRIPS = 6
# What is cut away of the circular spline: from the major axis to the minor one, where teeth come out of mesh.
CUT_RAD = (0.0, 0.5 * math.pi)

FLEXSPLINE = "#B9C4CF"
CIRCULAR_SPLINE = "#F2D08A"
WAVE_GENERATOR = "#9A9A9A"


@dataclass(frozen=True, eq=False, kw_only=True)
class ViewedBody:
    """A surface to look at; it need not be closed."""

    name: str
    mesh: Mesh
    colour: str
    clearance_um: Floats | None = None
    """Of each triangle, where the body is coloured by it."""


@dataclass(frozen=True, eq=False, kw_only=True)
class GearView:
    """The bodies of a gear at the generator angle of its analysis."""

    face: FaceMap
    bodies: tuple[ViewedBody, ...]


def gear_view(analysis: Analysis, *, chord_error_mm: float | None = None, face: FaceMap | None = None) -> GearView:
    """The gear with the flexspline bent and its teeth coloured by their clearance along the face; `face` is the map of
    the same analysis where it is known already."""
    design, geometry, angle = analysis.design, analysis.geometry, analysis.generator_angle_deg
    error = CHORD_ERROR_MODULES * design.module if chord_error_mm is None else chord_error_mm
    face = face_map(analysis) if face is None else face
    cup = flexspline_mesh(
        geometry, design, deformed=True, chord_error_mm=error, generator_angle_deg=angle, face_strips=STRIPS
    )
    ring = circular_spline_mesh(geometry, design, chord_error_mm=error)
    generator = wave_generator_mesh(geometry, design, chord_error_mm=error, generator_angle_deg=angle)
    on_tooth = cup.tooth != NO_TOOTH
    teeth = cup.only(on_tooth)
    return GearView(
        face=face,
        bodies=(
            ViewedBody(name="wave generator", mesh=generator, colour=WAVE_GENERATOR),
            ViewedBody(name="flexspline", mesh=cup.only(~on_tooth), colour=FLEXSPLINE),
            ViewedBody(
                name="its teeth, by clearance",
                mesh=teeth,
                colour=FLEXSPLINE,
                clearance_um=_clearance(face, teeth),
            ),
            ViewedBody(
                name="circular spline, a quarter cut away",
                mesh=_cut(ring, design.circular_spline.teeth),
                colour=CIRCULAR_SPLINE,
            ),
        ),
    )


def _clearance(face: FaceMap, teeth: Mesh) -> Floats:
    """The backlash of each triangle's tooth in its section, in um; beyond the circular spline that of its edge."""
    numbers = drive_teeth(face.analysis.design.flexspline.teeth)
    columns = np.argsort(numbers)[np.searchsorted(np.sort(numbers), teeth.tooth)]
    z = teeth.corners_mm[:, :, 2].mean(axis=1)
    step = face.z_mm[1] - face.z_mm[0]
    place = np.clip((z - face.z_mm[0]) / step, 0.0, len(face) - 1.0)
    below = np.minimum(place.astype(np.int64), len(face) - 2)
    low, high = face.drive_gap_um[below, columns], face.drive_gap_um[below + 1, columns]
    return np.asarray(low + (place - below) * (high - low))


def _cut(ring: Mesh, teeth: int) -> Mesh:
    """The ring without the quarter, its two cuts closed: they lie in mid-spaces, where a section is a rectangle."""
    middle = ring.corners_mm.mean(axis=1)
    angle = np.arctan2(middle[:, 0], middle[:, 1]) % (2.0 * math.pi)
    first, last = (round(end * teeth / (2.0 * math.pi)) * 2.0 * math.pi / teeth for end in CUT_RAD)
    kept = ring.only((angle < first) | (angle > last))
    return Mesh(
        kept.vertices_mm,
        np.concatenate([kept.triangles, *(_rectangle(kept, end, up) for end, up in ((first, False), (last, True)))]),
        np.concatenate([kept.tooth, np.full(4, NO_TOOTH)]),
        kept.chord_error_mm,
    )


def _rectangle(ring: Mesh, angle: float, clockwise: bool) -> Indices:
    """Two triangles on the four corners of the section at an angle, which face clockwise or the other way."""
    x, y, z = ring.vertices_mm.T
    radius = np.hypot(x, y)
    there: Mask = abs(np.sin(0.5 * (np.arctan2(x, y) - angle))) < 1e-9
    corners = []
    for high in (False, True):
        level = there & ((z > z.mean()) == high)
        own = np.flatnonzero(level)
        corners.append((own[radius[own].argmin()], own[radius[own].argmax()]))
    (a, b), (d, c) = corners
    triangles = np.array([[a, b, c], [a, c, d]])
    return triangles[:, ::-1] if clockwise else triangles
