"""The deformed neutral curve over the angle from the major axis."""

from __future__ import annotations

import numpy as np

from strainwave.analysis import Analysis
from strainwave.columns import Floats
from strainwave.plots.charts.chart import Chart, Element, Level, Line, Panel
from strainwave.plots.charts.words import generator_words
from strainwave.plots.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE
from strainwave.wave_generators.dual_disk import DualDisk, wrap_angle_of
from strainwave.wave_generators.four_roller import FourRoller

SAMPLES = 1441
PHI = "φ from the major axis, °"


def neutral_curve_chart(analysis: Analysis) -> Chart:
    """w, v, ψ and the curvature of one lobe, the undeformed circle beside each."""
    phi = np.linspace(-90.0, 90.0, SAMPLES)
    rim, radius = analysis.rim(phi), analysis.geometry.neutral_curve.radius
    circle = "undeformed circle"
    places = tuple(_places(analysis))
    figures = analysis.figures.neutral_curve
    growth = f"{figures.perimeter_growth:.1e}".replace("-", "−")
    panels = (
        _panel(phi, rim.w_mm, BLUE, "radial displacement w", "w, mm", 0.0, circle, places),
        _panel(phi, rim.tangential_mm, GREEN, "tangential displacement v", "v, mm", 0.0, circle, places),
        _panel(phi, rim.psi_deg, PURPLE, "turn of the normal ψ", "ψ, °", 0.0, circle, places),
        _panel(phi, rim.curvature_per_mm, ORANGE, "curvature κ", "κ, 1/mm", 1.0 / radius, circle, places),
    )
    return Chart(
        title=analysis.design.title,
        verdict=f"{generator_words(analysis)}; radius {radius:.5g} mm, perimeter grows by a share of {growth}",
        panels=panels,
        columns=2,
        size_inches=(10.0, 6.4),
    )


def _panel(
    phi: Floats, values: Floats, colour: str, name: str, y: str, undeformed: float, circle: str,
    places: tuple[Element, ...],
) -> Panel:  # fmt: skip
    reference = Level(at=undeformed, colour=GREY, name=circle)
    curve = Line(x=phi, y=values, colour=colour, width=1.6, name=name, hover=True)
    title = name[0].upper() + name[1:]
    return Panel(title=title, x=PHI, y=y, x_range=(-90.0, 90.0), elements=(reference, *places, curve))


def _places(analysis: Analysis) -> list[Element]:
    """Where a generator that touches the rim in places touches it, or leaves it."""
    generator = analysis.design.wave_generator
    if isinstance(generator, FourRoller):
        angle, name = generator.roller_angle, f"rollers at ±{generator.roller_angle:g}°"
    elif isinstance(generator, DualDisk):
        angle = _wrap_angle_deg(generator, analysis)
        name = f"ends of the wrap at ±{angle:.4g}°"
    else:
        return []
    return [Level(at=side * angle, colour=INK, axis="x", dashes="dot", name=name) for side in (-1.0, 1.0)]


def _wrap_angle_deg(generator: DualDisk, analysis: Analysis) -> float:
    if generator.wrap_angle is not None:
        return generator.wrap_angle
    assert generator.disk_radius is not None
    curve = analysis.geometry.neutral_curve
    return float(np.degrees(wrap_angle_of(generator.disk_radius, curve.radius, curve.w0)))
