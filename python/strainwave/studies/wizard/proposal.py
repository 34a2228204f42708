"""A proposed design, with what was chosen and why."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from textwrap import wrap
from typing import Any

from strainwave.analysis import Analysis
from strainwave.analysis.rim_strain import peak_bending_strain
from strainwave.design import Design, dumps
from strainwave.studies.wizard.proportions import PROFILES, TOOTH_DIFFERENCE
from strainwave.studies.wizard.request import USUAL_GENERATORS, Request
from strainwave.studies.wizard.search import Aim
from strainwave.units import MICROMETRES_PER_MM

# The case study's own angles, which fit its published figures.
FITTED_ANGLES = {
    "four-roller": "roller angle 19.5°, fitted to the article's case study",
    "dual-disk": "wrap angle 13°, fitted to the article's case study",
}
COMMENT: dict[str, Any] = {"width": 118, "subsequent_indent": "#     ", "break_long_words": False}
PURPOSES = {"power": "power transmission", "precision": "precision positioning"}
WHY_USE = {
    "power": "most teeth close to the tightest, then the most even gaps",
    "precision": "the tightest tooth nearest to the major axis, then the most teeth close to it",
}


@dataclass(frozen=True)
class Reason:
    """One choice: what it is about, what was chosen, and why."""

    what: str
    chosen: str
    why: str


@dataclass(frozen=True, eq=False, repr=False)
class Proposal:
    """A design that answers a request."""

    request: Request
    analysis: Analysis
    aim: Aim

    @property
    def design(self) -> Design:
        """The proposed design."""
        return self.analysis.design

    @property
    def reasons(self) -> tuple[Reason, ...]:
        """What was chosen and why, in the order of the design file."""
        return tuple(self._reasons())

    def toml(self) -> str:
        """The design file, with what was chosen and why as comments in front."""
        lines = [f"{reason.what}: {reason.chosen} ({reason.why})" for reason in self.reasons]
        lines = [f"{self.design.name}: {self.analysis.verdict}", *lines]
        comments = [part for line in lines for part in wrap(line, initial_indent="# ", **COMMENT)]
        return "\n".join(comments) + "\n\n" + dumps(self.design)

    def _reasons(self) -> Iterator[Reason]:
        request, design, found = self.request, self.design, self.analysis
        flexspline, generator = design.flexspline, design.wave_generator
        strain = peak_bending_strain(found.geometry.neutral_curve, flexspline.wall_thickness)
        offset_um = flexspline.profile.offset * MICROMETRES_PER_MM
        yield Reason(
            "teeth",
            f"{flexspline.teeth} and {design.circular_spline.teeth}",
            f"ratio −{request.ratio:g} = −z_f / (z_c − z_f), difference {TOOTH_DIFFERENCE} for two lobes",
        )
        yield Reason("module", f"{design.module:.6g} mm", "pitch diameter over the flexspline's teeth")
        yield Reason(
            "wall",
            f"{flexspline.wall_thickness:g} mm",
            f"the article's share of the pitch diameter; greatest bending strain of the rim {1e6 * strain:.0f} ppm",
        )
        yield Reason("profiles", request.profile, str(PROFILES[request.profile]["source"]))
        yield Reason("wave generator", generator.kind, _why_generator(request))
        yield Reason(
            "neutral curve",
            found.figures.neutral_curve.model,
            "keeps the rim's length and w0; " + ("its own shape" if generator.kind == "ellipse" else "thin ring"),
        )
        yield Reason(
            "w0",
            f"{generator.w0:g} mm ({generator.w0 / design.module:.3f} modules)",
            f"tuned for {request.use}: {WHY_USE[request.use]}",
        )
        yield Reason(
            "flank offset",
            f"{offset_um:+.1f} µm on the flexspline".replace("-", "−"),
            f"tuned for a least backlash of {self.aim.target_um:.2g} µm in motion",
        )

    def __repr__(self) -> str:
        return f"<Proposal {self.design.name!r}: {self.analysis.verdict}>"


def _why_generator(request: Request) -> str:
    is_usual = request.generator == USUAL_GENERATORS[request.use]
    why = f"the article's choice for {PURPOSES[request.use]}" if is_usual else "as asked"
    fitted = FITTED_ANGLES.get(request.generator)
    return f"{why}; {fitted}" if fitted else why
