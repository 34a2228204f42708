"""The whole gear at one angle of its generator: every tooth of both splines, the rim and what bends it."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import Clearances
from strainwave.analysis import Analysis
from strainwave.analysis.lobe import drive_teeth, tooth_index, within_lobe
from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.outlines.generator import bore_inset
from strainwave.scene.generator import generator_shapes
from strainwave.scene.outlines import circle, even_angles, placed, tooth_outline, turned
from strainwave.scene.scene import Scene
from strainwave.scene.shape import Shape
from strainwave.scene.turning import Fixed, Turning
from strainwave.units import MICROMETRES_PER_MM
from strainwave.wave_generators.parts import inside

CHORD_ERROR_MODULES = 1e-3
"""A pixel of a picture of the whole gear is some hundred times as large."""
# Marks that turn with the splines, by which their turning is seen: their radius, and how far they stand beyond the
# circular spline's teeth and inside the flexspline's wall, in modules.
MARK_RADIUS, MARK_BEYOND = 0.9, 1.4


def assembly_scene(
    analysis: Analysis,
    *,
    generator_angle_deg: float = 0.0,
    chord_error_mm: float | None = None,
    fixed: Fixed = "circular-spline",
) -> Scene:
    """Every tooth of both splines with its clearance, the rim, the neutral curve and the generator's parts to size.

    The generator stands at `generator_angle_deg`, clockwise; `fixed` says which spline does not turn with it. Chords of
    all outlines lie within `chord_error_mm` (0.001 modules unless given) of the curves. DesignError where the
    generator's parts do not go into the flexspline.
    """
    design, module = analysis.design, analysis.design.module
    error = CHORD_ERROR_MODULES * module if chord_error_mm is None else chord_error_mm
    if not 0.0 < error < module:
        raise StrainwaveError(f"the chord error must lie between 0 and the module of {module:g} mm, not {error:g} mm")
    turning = Turning.of(design, generator_angle_deg, fixed)
    relative = turning.relative_rad
    index = tooth_index(drive_teeth(design.flexspline.teeth), design, relative)
    moving = (
        *_flexspline(analysis, index, error),
        *generator_shapes(design, analysis.geometry, error),
        *_marks(analysis, index, relative, error),
    )
    shapes = (_circular_spline(analysis, error), *(shape.turned(relative) for shape in moving))
    ring_stands_still = Scene(title=design.title, turning=turning, chord_error_mm=error, shapes=shapes)
    return ring_stands_still.turned(math.radians(turning.circular_spline_deg))


def _circular_spline(analysis: Analysis, error: float) -> Shape:
    """The ring with its teeth."""
    design = analysis.design
    poses = analysis.geometry.engagement.circular_spline_poses(np.arange(design.circular_spline.teeth))
    # In its own frame, tip inwards, a tooth runs clockwise about its tip: against the ring's own sense.
    teeth = placed(tooth_outline(analysis.geometry.circular_spline, error)[::-1], poses)
    return Shape(
        role="circular spline",
        outline_mm=circle(0.5 * design.circular_spline_outer_diameter_mm, error),
        hole_mm=_chain(teeth),
        label="circular spline",
        hover=f"circular spline, {design.circular_spline.teeth} teeth",
    )


def _flexspline(analysis: Analysis, index: Floats, error: float) -> Iterator[Shape]:
    """Rim and teeth in the generator's frame, where each tooth stands at its index."""
    design, geometry = analysis.design, analysis.geometry
    number = drive_teeth(design.flexspline.teeth)
    teeth = placed(tooth_outline(geometry.flexspline, error), geometry.engagement.flexspline_poses(index))
    phi = even_angles(geometry.neutral_curve.radius + geometry.neutral_curve.w0, error)
    bore = inside(geometry.neutral_curve, phi, bore_inset(design))
    words = f"flexspline, {design.flexspline.teeth} teeth"
    yield Shape(role="flexspline", outline_mm=_chain(teeth), hole_mm=bore, label="flexspline", hover=words)
    clearances = geometry.engagement.clearances(index)
    places = within_lobe(index, design.flexspline.teeth)
    yield from _teeth(number, places, teeth, clearances.gap * MICROMETRES_PER_MM)
    yield from _overlaps(number, clearances)


def _marks(analysis: Analysis, index: Floats, relative: float, error: float) -> Iterator[Shape]:
    """A mark below tooth 0, and one beyond the space in which it stands at generator angle 0."""
    design, module = analysis.design, analysis.design.module
    spline, ring = design.flexspline, design.circular_spline
    below = -(spline.profile.dedendum + MARK_BEYOND) * module - spline.wall_thickness
    pose = analysis.geometry.engagement.flexspline_poses(index[:1])
    mark = placed(circle(MARK_RADIUS * module, error, (0.0, below)), pose)[0]
    yield Shape(role="mark", outline_mm=mark, label="tooth 0 and its space", hover="tooth 0")
    beyond = design.circular_spline_pitch_radius_mm + (ring.profile.dedendum + MARK_BEYOND) * module
    # In the generator's frame the circular spline turns backwards.
    mark = turned(circle(MARK_RADIUS * module, error, (0.0, beyond)), -relative)
    yield Shape(role="mark", outline_mm=mark, label="tooth 0 and its space", hover="space of tooth 0")


def _teeth(number: NDArray[np.int64], index: Floats, teeth: Floats, flanks_um: Floats) -> Iterator[Shape]:
    """Each tooth with its clearance, the lesser of its two flanks'."""
    for tooth, place, outline, (left, right) in zip(
        number.tolist(), index.tolist(), teeth, flanks_um.tolist(), strict=True
    ):
        yield Shape(
            role="flexspline tooth",
            outline_mm=outline,
            tooth=tooth,
            clearance_um=min(left, right),
            label=str(tooth).replace("-", "−"),
            hover=f"tooth {tooth} at index {place:.2f}\nleft flank {left:.3f} µm\nright flank {right:.3f} µm",
        )


def _overlaps(number: NDArray[np.int64], clearances: Clearances) -> Iterator[Shape]:
    """The deepest place of each tooth that overlaps the circular spline."""
    flank = clearances.gap.argmin(axis=-1)
    for place in np.flatnonzero(clearances.gap.min(axis=-1) < 0.0).tolist():
        least = float(clearances.gap[place, flank[place]]) * MICROMETRES_PER_MM
        yield Shape(
            role="witness",
            outline_mm=clearances.flexspline_point[place, flank[place]][None],
            closed=False,
            tooth=int(number[place]),
            clearance_um=least,
            label=f"{least:.2f} µm".replace("-", "−"),
            hover=f"tooth {number[place]} overlaps the circular spline\n{-least:.3f} µm deep",
        )


def _chain(teeth: Floats) -> Floats:
    """The outline of a whole gear of its teeth (z, n, 2): clockwise, each tooth's last point left to the next one."""
    return np.concatenate(list(teeth))
