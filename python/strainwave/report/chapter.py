"""One design in a report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

from strainwave.analysis import face_map
from strainwave.analysis.verdict import Verdict
from strainwave.report.block import Block, Listing, Notes
from strainwave.report.key_figures import along_the_face, counts, key_figures, rim
from strainwave.report.parameters import parameters
from strainwave.report.plates import detail_plates, distribution_plate, face_plate, sketch_plate, space_plate
from strainwave.report.provenance import design_hash

if TYPE_CHECKING:
    from strainwave.analysis import Analysis, FaceMap


@dataclass(frozen=True)
class Chapter:
    """A design with its verdict and all that it rests on."""

    title: str
    analysis: Analysis
    verdict: Verdict
    summary: str
    """The design in one line."""
    blocks: tuple[Block, ...]
    design_hash: str

    @classmethod
    def of(cls, analysis: Analysis, face: FaceMap | None = None, *, title: str = "") -> Self:
        """All that is known about a design. DesignError where its cup cannot be bent as far as its open end is."""
        face = face_map(analysis) if face is None else face
        blocks = (
            key_figures(analysis),
            counts(analysis),
            along_the_face(face),
            *_warnings(analysis),
            sketch_plate(analysis),
            distribution_plate(analysis),
            space_plate(analysis),
            face_plate(face),
            *detail_plates(analysis),
            parameters(analysis.design),
            rim(analysis),
            _design_file(analysis),
        )
        return cls._with(analysis, face, title, blocks)

    @classmethod
    def brief(cls, analysis: Analysis, face: FaceMap | None = None, *, title: str = "") -> Self:
        """Verdict, key figures and distribution; otherwise as `of`."""
        face = face_map(analysis) if face is None else face
        blocks = (
            key_figures(analysis),
            counts(analysis),
            *_warnings(analysis),
            distribution_plate(analysis),
            _design_file(analysis),
        )
        return cls._with(analysis, face, title, blocks)

    @classmethod
    def _with(cls, analysis: Analysis, face: FaceMap, title: str, blocks: tuple[Block, ...]) -> Self:
        design = analysis.design
        return cls(
            title=title or design.title,
            analysis=analysis,
            verdict=Verdict.of(analysis, face),
            summary=summary_of(analysis),
            blocks=blocks,
            design_hash=design_hash(design),
        )


def summary_of(analysis: Analysis) -> str:
    """Generator, size and ratio in one line."""
    design, generator = analysis.design, analysis.design.wave_generator
    flexspline, circular_spline = design.flexspline, design.circular_spline
    return (
        f"{generator.kind} wave generator, w0 {generator.w0:g} mm (w0* {generator.w0 / design.module:.4g}), "
        f"{analysis.figures.neutral_curve.model} neutral curve; module {design.module:g} mm, {flexspline.teeth} and "
        f"{circular_spline.teeth} teeth, {flexspline.profile.kind} and {circular_spline.profile.kind} profiles, "
        f"ratio {design.ratio:.6g}"
    ).replace("ratio -", "ratio −")


def _warnings(analysis: Analysis) -> tuple[Block, ...]:
    return (Notes("Warnings", analysis.warnings),) if analysis.warnings else ()


def _design_file(analysis: Analysis) -> Block:
    """What it takes to compute all of it again."""
    from strainwave.design import dumps

    return Listing("Design file", dumps(analysis.design))
