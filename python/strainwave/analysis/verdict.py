"""What an analysis means for the design, in words: a level, a sentence, and the reasons with their numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, get_args

from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from strainwave.analysis.analysis import Analysis
    from strainwave.analysis.face import FaceMap

Level = Literal["interference", "along-face", "undecided", "clear"]
"""``interference``: teeth overlap at mid-face at some generator angle. ``along-face``: not there, but in other sections
of the coned cup. ``undecided``: they do not, but the least gap is no larger than what the model leaves open. ``clear``:
they do not, by more than that."""

LEVELS: tuple[Level, ...] = get_args(Level)


@dataclass(frozen=True)
class Reason:
    """One finding that the verdict rests on."""

    key: str
    """A stable name in kebab-case."""
    sentence: str
    numbers: dict[str, float]
    """The figures in the sentence, units in their names."""
    adverse: bool
    """Whether it speaks against the design."""


@dataclass(frozen=True)
class Verdict:
    """Whether a design's teeth run clear of each other, and why."""

    level: Level
    sentence: str
    reasons: tuple[Reason, ...]

    @classmethod
    def of(cls, analysis: Analysis, face: FaceMap | None = None) -> Verdict:
        """Judge an analysis by its figures in motion, which hold at every generator angle, and the map along the face
        where there is one."""
        left_open_um = model_error_um(analysis)
        level = _level(analysis, face, left_open_um)
        reasons = tuple(_reasons(analysis, face, left_open_um))
        return cls(level, _sentence(level, analysis, face, left_open_um), reasons)

    def as_dict(self) -> dict[str, Any]:
        """The verdict as plain data under stable keys."""
        reasons = [
            {"key": each.key, "sentence": each.sentence, "adverse": each.adverse, **each.numbers}
            for each in self.reasons
        ]
        return {"level": self.level, "sentence": self.sentence, "reasons": reasons}


def model_error_um(analysis: Analysis) -> float:
    """How far the gaps may be off by what is known to be left out: the certificate, and the order w0²/R of the linear
    thin ring's error where the neutral curve comes from one (docs/theory.md, "The rim")."""
    ring_um = analysis.figures.neutral_curve.ring_theory_error_um or 0.0
    return max(analysis.in_motion.certified_to_um, ring_um)


def _level(analysis: Analysis, face: FaceMap | None, left_open_um: float) -> Level:
    gap_um = analysis.min_in_motion_um
    if gap_um < 0.0:
        return "interference"
    if face is not None and face.interference:
        return "along-face"
    return "undecided" if gap_um <= left_open_um else "clear"


def _sentence(level: Level, analysis: Analysis, face: FaceMap | None, left_open_um: float) -> str:
    gap_um = analysis.min_in_motion_um
    if level == "interference":
        within = ", within what the model leaves open" if -gap_um <= left_open_um else ""
        return f"Teeth interfere in motion, up to {_um(-gap_um)} deep{within}."
    if level == "along-face" and face is not None:
        return (
            f"At mid-face teeth do not interfere, with a least gap of {_um(gap_um)} in motion; where the coned cup is "
            f"bent more or less than there they do, up to {_um(-face.worst_in_motion_um)} deep."
        )
    if level == "undecided":
        return (
            f"No teeth interfere as computed, but the least gap of {_um(gap_um)} is no larger than the "
            f"{_um(left_open_um)} that the model leaves open."
        )
    return f"Teeth run clear of each other at every generator angle, by at least {_um(gap_um)}."


def _reasons(analysis: Analysis, face: FaceMap | None, left_open_um: float) -> Iterator[Reason]:
    """In the order in which a designer asks."""
    yield _least(analysis)
    if analysis.teeth_interfering.drive:
        yield _interfering(analysis)
    yield _model(analysis, left_open_um)
    if face is not None:
        yield _along_face(face)
    yield from _radial(analysis)
    yield _contact(analysis)
    yield from _play(analysis)


def _least(analysis: Analysis) -> Reason:
    motion, witness = analysis.in_motion, analysis.witness_in_motion
    flank = witness.closer_flank[0]
    return Reason(
        "least-gap",
        f"The {'least gap' if motion.gap_um >= 0.0 else 'greatest depth'} of all teeth at every generator angle is "
        f"{_um(abs(motion.gap_um))} at tooth index ±{motion.index:.1f}, between the "
        f"{witness.flexspline_piece[0, flank]} of the flexspline and the {witness.circular_spline_piece[0, flank]} of "
        f"the circular spline; certified to {motion.certified_to_um:g} µm.",
        {"min_in_motion_um": motion.gap_um, "index": motion.index, "certified_to_um": motion.certified_to_um},
        adverse=motion.gap_um < 0.0,
    )


def _interfering(analysis: Analysis) -> Reason:
    count, teeth = analysis.teeth_interfering, analysis.design.flexspline.teeth
    return Reason(
        "interfering-teeth",
        f"{count.drive} of {teeth} teeth overlap with the wave generator at 0°, {count.per_side} on each side of a "
        f"major axis.",
        {"per_side": count.per_side, "drive": count.drive, "teeth": teeth},
        adverse=True,
    )


def _model(analysis: Analysis, left_open_um: float) -> Reason:
    curve, gap_um = analysis.figures.neutral_curve, analysis.min_in_motion_um
    numbers = {"model_error_um": left_open_um, "min_in_motion_um": gap_um}
    if curve.ring_theory_error_um is None:
        sentence = f"The {curve.model} neutral curve is taken as it is; how far a rim departs from it is not known."
        return Reason("model-error", sentence, numbers, adverse=False)
    decided = abs(gap_um) > left_open_um
    return Reason(
        "model-error",
        f"The rim's shape is that of a linear thin ring, good to the order of w0²/R = {_um(left_open_um)}: "
        f"{'less' if decided else 'no less'} than the {'gap' if gap_um >= 0.0 else 'depth'}, so its sign "
        f"{'stands' if decided else 'rests on the model'}.",
        numbers,
        adverse=not decided,
    )


def _along_face(face: FaceMap) -> Reason:
    worst_um, z_mm = face.worst_in_motion_um, float(face.z_mm[face.worst])
    count = len(face.interfering_sections)
    least = f"{_um(-worst_um)} deep" if face.interference else f"{_um(worst_um)} apart"
    return Reason(
        "along-face",
        f"With straight teeth on a cup that is bent in proportion to the distance from its diaphragm, teeth overlap in "
        f"{count} of {len(face)} sections along the face; the worst, {least}, lies {z_mm:.1f} mm from the diaphragm, "
        f"where w0 is {face.w0_mm[face.worst]:.3f} mm.",
        {"sections": len(face), "interfering_sections": count, "worst_in_motion_um": worst_um, "z_mm": z_mm},
        adverse=face.interference,
    )


def _radial(analysis: Analysis) -> Iterator[Reason]:
    """Tips in roots: the designer's usual allowance is in modules, so the figures are given in both."""
    module_um = analysis.design.module * MICROMETRES_PER_MM
    for key, where, value_um in (
        ("tip-clearance", "flexspline's tips and the circular spline's root circle", analysis.tip_clearance_um),
        ("root-clearance", "circular spline's tips and the flexspline's root circle", analysis.root_clearance_um),
    ):
        amount = f"{_um(abs(value_um))} ({abs(value_um) / module_um:.3f} modules)"
        yield Reason(
            key,
            f"The {where} {f'overlap by {amount}' if value_um < 0.0 else f'stay at least {amount} apart'}.",
            {f"{key.replace('-', '_')}_um": value_um},
            adverse=value_um < 0.0,
        )


def _contact(analysis: Analysis) -> Reason:
    below, teeth = analysis.teeth_below, analysis.design.flexspline.teeth
    return Reason(
        "teeth-below",
        f"{below.drive} of {teeth} teeth ({100.0 * below.drive / teeth:.0f} %) have between 0 and "
        f"{analysis.threshold_um:g} µm of backlash, {below.per_side} on each side of a major axis.",
        {"threshold_um": analysis.threshold_um, "per_side": below.per_side, "drive": below.drive},
        adverse=False,
    )


def _play(analysis: Analysis) -> Iterator[Reason]:
    play = analysis.play_in_motion
    if not math.isnan(play.circumferential_um) and play.circumferential_um >= 0.0:
        yield Reason(
            "play",
            f"The output turns freely by at least {_um(play.circumferential_um)} at the pitch circle, "
            f"{play.angular_arcsec:.1f}″, in each direction before a tooth touches.",
            {"circumferential_um": play.circumferential_um, "angular_arcsec": play.angular_arcsec},
            adverse=False,
        )


def _um(value: float) -> str:
    """A length to the hundredth of a micrometre, or whole micrometres where it is many."""
    return _minus(f"{value:.2f} µm" if abs(value) < 100.0 else f"{value:.0f} µm")


def _minus(text: str) -> str:
    return text.replace("-", "−")
