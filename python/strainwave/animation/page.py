"""The film as a page of its own: outlines once, poses and clearances of every frame, and the script that draws them."""

from __future__ import annotations

import base64
import html
import json
from collections.abc import Iterator
from importlib import resources
from string import Template
from typing import Any

import numpy as np

from strainwave.animation.film import Film
from strainwave.columns import Floats
from strainwave.outlines.generator import bore_inset
from strainwave.plots.assembly import CROSSES_AT, NAMED
from strainwave.plots.clearance_colours import OVERLAP, STEPS, THRESHOLDS, step_colour
from strainwave.plots.looks import LOOKS
from strainwave.plots.style import INK
from strainwave.scene import Scene, Shape, View, assembly_scene
from strainwave.scene.outlines import even_angles, tooth_outline
from strainwave.scene.poses import tooth_poses
from strainwave.studies.progress import Progress, silent
from strainwave.wave_generators.parts import inside

CHORD_ERROR_MODULES = 2e-3  # less than a tenth of a pixel in the magnified view
DECIMALS = 5  # of a millimetre, in outlines
# Where tooth numbers stand below the flexspline's pitch circle, in modules beyond the tooth's foot.
NUMBERS_BELOW = 0.75


def page(film: Film, progress: Progress = silent) -> str:
    """A page that opens without a network, plays, stops, and steps through the frames.

    All positions and clearances come from the engagement; the script only places and paints.
    """
    files = resources.files("strainwave.animation")
    template = Template(files.joinpath("page.html").read_text(encoding="utf-8"))
    drawing = files.joinpath("drawing", "index.js").read_text(encoding="utf-8")
    return template.substitute(
        title=html.escape(film.analysis.design.title),
        words=html.escape(film.words),
        drawing=drawing.replace("export ", ""),  # a page of one file has no modules
        data=json.dumps(_data(film, progress), separators=(",", ":"), ensure_ascii=False),
    )


def _data(film: Film, progress: Progress) -> dict[str, Any]:
    """Plain numbers and text for the script; mm, µm, degrees and, in poses, radians."""
    analysis, design = film.analysis, film.analysis.design
    error = CHORD_ERROR_MODULES * design.module
    first = assembly_scene(analysis, chord_error_mm=error)
    whole = View.of_whole(first, design.module)
    near = View.of_top(first, design.module, design.circular_spline_pitch_radius_mm)
    verdicts, gaps, poses = _frames(film, progress)
    turnings = [film.turning(frame) for frame in range(len(film))]
    return {
        "module": design.module,
        "frames_per_s": film.frames_per_s,
        "generator_deg": [turning.generator_deg for turning in turnings],
        "flexspline_deg": [turning.flexspline_deg for turning in turnings],
        "circular_spline_deg": [turning.circular_spline_deg for turning in turnings],
        "verdicts": verdicts,
        "numbers": [tooth.tooth for tooth in first.teeth],
        "labels": [tooth.label for tooth in first.teeth],
        "tooth": _points(tooth_outline(analysis.geometry.flexspline, error)),
        "poses": _packed(poses),
        "gaps_um": _packed(gaps),
        "parts": list(_parts(film, first, error)),
        "whole_mm": [*whole.x_mm, *whole.y_mm],
        "near_mm": [*near.x_mm, *near.y_mm],
        "crosses_at_mm": CROSSES_AT * whole.x_mm[1],
        "note_below_mm": (design.flexspline.profile.dedendum + NUMBERS_BELOW) * design.module,
        "colours": [step_colour(step) for step in range(STEPS)],
        "overlap_colour": OVERLAP,
        "far_um": THRESHOLDS * analysis.threshold_um,
        "ink": INK,
    }


def _frames(film: Film, progress: Progress) -> tuple[list[str], Floats, Floats]:
    """Of every frame the verdict, the teeth's clearances (frames, teeth) and their poses (frames, teeth, 3)."""
    verdicts, gaps, poses = [], [], []
    for frame, scene in enumerate(film.scenes(CHORD_ERROR_MODULES * film.analysis.design.module)):
        verdicts.append(scene.verdict)
        gaps.append([tooth.clearance_um for tooth in scene.teeth])
        poses.append(tooth_poses(film.analysis, scene.turning))
        progress(frame + 1, len(film))
    return verdicts, np.array(gaps, dtype=np.float64), np.array(poses)


def _parts(film: Film, first: Scene, error: float) -> Iterator[dict[str, Any]]:
    """All but the teeth, with what each moves with, in the order in which they are drawn, from a scene at angle 0."""
    marks = 0
    for shape in first.shapes:
        if shape.role == "circular spline":
            yield _part(shape, "circular spline", "below")
        elif shape.role == "flexspline":
            yield _part(shape, "generator", "below", outline=_foot(film, error))
        elif shape.role == "mark":
            # The first is that of tooth 0, whose frame stands upright on the major axis.
            marks += 1
            if marks == 1:
                origin = tooth_poses(film.analysis, first.turning)[0, :2]
                yield _part(shape, "tooth 0", "above", outline=shape.outline_mm - origin)
            else:
                yield _part(shape, "circular spline", "above")
        elif shape.role not in ("flexspline tooth", "witness"):
            yield _part(shape, "generator", "above")


def _foot(film: Film, error: float) -> Floats:
    """The rim's outer edge, below the teeth: it follows the neutral curve, and so turns with the generator."""
    design, curve = film.analysis.design, film.analysis.geometry.neutral_curve
    phi = even_angles(curve.radius + curve.w0, error)
    return inside(curve, phi, bore_inset(design) - design.flexspline.wall_thickness)


def _part(shape: Shape, moves: str, layer: str, outline: Floats | None = None) -> dict[str, Any]:
    look = LOOKS[shape.role]
    loops = [shape.outline_mm if outline is None else outline]
    if shape.hole_mm is not None:
        loops.append(shape.hole_mm)
    return {
        "moves": moves,
        "layer": layer,
        "name": shape.label if shape.role in NAMED else "",
        "face": look.face if shape.closed else None,
        "edge": look.edge,
        "width": look.width,
        "dashes": look.dashes,
        "loops": [{"points": _points(loop), "closed": shape.closed} for loop in loops],
    }


def _points(points: Floats) -> list[list[float]]:
    rounded: list[list[float]] = points.round(DECIMALS).tolist()
    return rounded


def _packed(numbers: Floats) -> str:
    """As the bytes of single precision, which is 10 nm at 100 mm."""
    return base64.b64encode(numbers.astype("<f4").tobytes()).decode()
