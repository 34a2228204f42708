"""Words that several charts have under their titles."""

from __future__ import annotations

from strainwave.analysis import Analysis


def generator_words(analysis: Analysis) -> str:
    """Kind of generator, w0 and neutral curve."""
    generator = analysis.design.wave_generator
    return f"{generator.kind}, w0 {generator.w0:g} mm, {analysis.figures.neutral_curve.model} neutral curve"


def micrometres(value_um: float, decimals: int = 2) -> str:
    """A clearance with its unit, and a minus that is as wide as a plus."""
    return f"{value_um:.{decimals}f} µm".replace("-", "−")
