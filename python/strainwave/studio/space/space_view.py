"""What the tab of the gear in space shows of a design, made by a job."""

from __future__ import annotations

import gzip
from dataclasses import dataclass

from strainwave.analysis import analyze, face_map
from strainwave.analysis.verdict import Level, Verdict
from strainwave.design import Design
from strainwave.errors import DesignError
from strainwave.plots.gear_view import CHORD_ERROR_MODULES
from strainwave.studio.jobs import Limits, Report
from strainwave.studio.orders import Product

DETAILS: dict[str, float] = {
    "coarse": 3.0 * CHORD_ERROR_MODULES,
    "normal": CHORD_ERROR_MODULES,
    "fine": 0.25 * CHORD_ERROR_MODULES,
}
"""Chord errors to choose from, in modules."""
FACE_REASON = "along-face"
# Within one machine smaller is no sooner; this much costs nothing.
COMPRESSION = 1


@dataclass(frozen=True)
class SpaceRequest:
    """What is to be seen, and how fine."""

    design: Design
    threshold_um: float
    detail: str


@dataclass(frozen=True, kw_only=True)
class SpaceView:
    """Words and pictures of one design."""

    level: Level
    sentence: str
    """The verdict, mid-face against the sections along the face."""
    along_face: str
    """What the sections are, and the worst of them."""
    gear: Product
    """The figure of the gear as plotly's JSON text."""
    face_figure: str
    """The figure of the map as plotly's JSON text."""


@dataclass(frozen=True)
class NoSpaceView:
    """There is none of this design: its cup cannot be bent as far as its open end would be."""

    why: str


def space_view(request: SpaceRequest, limits: Limits, report: Report) -> SpaceView | NoSpaceView:
    """A task for a job: half a second, most of it in the kernel.

    What is wrong with the design is an answer; an error is that there is none now.
    """
    try:
        return _view(request, limits)
    except DesignError as error:
        return NoSpaceView(str(error))


def _view(request: SpaceRequest, limits: Limits) -> SpaceView:
    from strainwave.plots.interactive import assembly_3d_figure, face_figure

    analysis = analyze(request.design, threshold_um=request.threshold_um)
    face = face_map(analysis, threads=limits.threads)
    verdict = Verdict.of(analysis, face)
    gear = assembly_3d_figure(analysis, chord_error_mm=DETAILS[request.detail] * request.design.module, face=face)
    # The page says both, and names the bodies with what hides them.
    gear.update_layout(title=None, showlegend=False, margin={"l": 0, "r": 0, "t": 0, "b": 0})
    map_of_face = face_figure(face)
    map_of_face.update_layout(yaxis={"title": {"text": "z, mm"}})
    text = gear.to_json().encode()
    packed = gzip.compress(text, COMPRESSION, mtime=0)
    return SpaceView(
        level=verdict.level,
        sentence=verdict.sentence,
        along_face=next(reason.sentence for reason in verdict.reasons if reason.key == FACE_REASON),
        gear=Product("gear.json", "application/json", packed, len(text)),
        face_figure=map_of_face.to_json(),
    )
