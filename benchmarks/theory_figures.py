"""The figures of docs/theory.md: the definitions drawn on the case study's own teeth and rim."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from strainwave import Design, Geometry, analyze
from strainwave.plots.outline import half_profile, placed, tooth_outline
from strainwave.plots.style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, house_style
from strainwave.units import MICROMETRES_PER_MM
from strainwave.wave_generators import Cosine, DualDisk, FourRoller, TwoRoller

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Floats = NDArray[np.float64]

EXAGGERATION = 20.0
PIECE_COLOURS = (INK, BLUE, GREEN, ORANGE, PURPLE, VERMILION)
PIECE_NAMES = ("tip land", "tip arc", "line", "flank arc", "root fillet", "root floor")
ARROW: dict[str, Any] = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.0, "shrinkA": 0.0, "shrinkB": 0.0}


def theory_figures(design: Design) -> dict[str, Figure]:
    """The figures by name, of a design with a double circular arc and a root fillet on the flexspline."""
    return {
        "theory-tooth": _tooth(design),
        "theory-curve": _curve(design),
        "theory-generators": _generators(design),
        "theory-clearance": _clearance(design),
        "theory-certificate": _certificate(design),
    }


def _figure(width: float, height: float) -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def _at(point: Floats) -> tuple[float, float]:
    return float(point[0]), float(point[1])


def _bare(axes: Axes) -> None:
    axes.set_aspect("equal")
    axes.grid(visible=False)


def _tooth(design: Design) -> Figure:
    """Half a flexspline tooth piece by piece, with normal and tangent at one point."""
    profile = Geometry.of(design).flexspline
    with house_style():
        figure = _figure(6.4, 4.4)
        axes = figure.subplots()
        _bare(axes)
        outline = half_profile(profile)
        axes.fill_betweenx(outline[:, 1], 0.0, outline[:, 0], color=SKY, alpha=0.18, linewidth=0.0)
        for start, end, colour, name in zip(
            profile.knots[:-1], profile.knots[1:], PIECE_COLOURS, PIECE_NAMES, strict=True
        ):
            points = profile.position(np.linspace(start, end, 60))
            axes.plot(*points.T, color=colour, linewidth=2.4, label=name)
        u = 0.72 * profile.knots[1] + 0.28 * profile.knots[2] + 0.2
        point, normal, tangent = profile.position(u), profile.normal(u), profile.tangent(u)
        for direction, name in ((normal, "n = (sin τ, cos τ)"), (tangent, "t = (cos τ, −sin τ)")):
            tip = point + 0.42 * direction
            axes.annotate("", _at(tip), _at(point), arrowprops=ARROW)
            axes.annotate(name, _at(tip), xytext=(5, -3), textcoords="offset points", fontsize=9)
        axes.plot(*point, "o", color=INK, markersize=4)
        axes.annotate("X(u)", _at(point), xytext=(-30, -4), textcoords="offset points", fontsize=9)
        axes.axvline(0.0, color=GREY, linewidth=0.9, linestyle=(0, (8, 3, 2, 3)))
        axes.axhline(0.0, color=GREY, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate("pitch circle, y = 0", (1.34, 0.0), xytext=(0, 4), textcoords="offset points", fontsize=8.5)
        axes.annotate("axis of the tooth", (0.0, -0.9), xytext=(4, 0), textcoords="offset points", fontsize=8.5)
        axes.set(xlabel="x (mm)", ylabel="y (mm), towards the tip", title="Half a flexspline tooth by arc length")
        axes.set_xlim(-0.12, 2.15)
        axes.legend(loc="lower right", fontsize=8.5)
    return figure


def _curve(design: Design) -> Figure:
    """The neutral curve, its displacement exaggerated, with a tooth at arc length s."""
    curve = Geometry.of(design).neutral_curve
    radius = curve.radius

    def seen(phi: Floats) -> Floats:
        r = radius + EXAGGERATION * curve.displacement(phi)[..., 0]
        return np.stack([r * np.sin(phi), r * np.cos(phi)], axis=-1)

    with house_style():
        figure = _figure(5.6, 5.2)
        axes = figure.subplots()
        _bare(axes)
        phi = np.linspace(-0.25, 0.5 * np.pi + 0.25, 400)
        axes.plot(
            radius * np.sin(phi), radius * np.cos(phi), color=GREY, linestyle=(0, (4, 3)), label="circle, radius R"
        )
        axes.plot(*seen(phi).T, color=BLUE, linewidth=2.0, label=f"neutral curve, w × {EXAGGERATION:g}")
        at = np.array(0.62)
        along = seen(np.linspace(0.0, float(at), 60))
        axes.plot(*along.T, color=ORANGE, linewidth=4.0, alpha=0.75, label="arc length s = k L / z_f")
        foot, ray = seen(at), np.array([np.sin(at), np.cos(at)])
        slope = seen(at + 1e-5) - seen(at - 1e-5)
        normal = np.array([-slope[1], slope[0]]) / np.hypot(*slope)
        axes.plot([0.0, *(foot + 22.0 * ray)[:1]], [0.0, *(foot + 22.0 * ray)[1:]], color=INK, linewidth=0.9)
        axes.annotate(
            "", _at(foot + 30.0 * normal), _at(foot), arrowprops=ARROW | {"color": VERMILION, "linewidth": 1.6}
        )
        axes.annotate(
            "axis of tooth k,\nturned by ψ",
            _at(foot + 30.0 * normal),
            xytext=(4, -8),
            textcoords="offset points",
            color=VERMILION,
            fontsize=9,
        )
        axes.annotate("radius", _at(foot + 22.0 * ray), xytext=(-34, 2), textcoords="offset points", fontsize=9)
        arc = np.linspace(0.0, float(at), 40)
        axes.plot(26.0 * np.sin(arc), 26.0 * np.cos(arc), color=INK, linewidth=0.9)
        axes.annotate("φ", (26.0 * np.sin(0.5 * at) + 1.5, 26.0 * np.cos(0.5 * at) + 1.5), fontsize=11)
        on_circle = radius * ray
        axes.plot(*np.stack([on_circle, foot]).T, color=GREEN, linewidth=3.0)
        axes.annotate("w(φ)", _at(0.5 * (on_circle + foot)), xytext=(8, -10), textcoords="offset points", color=GREEN)
        axes.axvline(0.0, color=GREY, linewidth=0.9, linestyle=(0, (8, 3, 2, 3)))
        axes.annotate("major axis, +Y", (0.0, 118.0), xytext=(4, -6), textcoords="offset points", fontsize=8.5)
        axes.set(xlabel="x (mm)", ylabel="y (mm)", title="The rim's neutral curve")
        axes.set_xlim(-6.0, 96.0)
        axes.set_ylim(-6.0, 120.0)
        axes.legend(loc="lower left", fontsize=8.5, bbox_to_anchor=(0.02, 0.02))
    return figure


def _generators(design: Design) -> Figure:
    """Displacement and bending moment of the rim over one quadrant, by wave generator."""
    radius, w0 = design.neutral_radius_mm, 1e-3  # so small that the linear ring is seen
    kinds = {
        "cosine": Cosine(w0=w0),
        "two rollers": TwoRoller(w0=w0),
        "four rollers, 30°": FourRoller(w0=w0, roller_angle=30.0),
        "dual disk, 30°": DualDisk(w0=w0, wrap_angle=30.0),
    }
    phi = np.linspace(0.0, 0.5 * np.pi, 361)
    with house_style():
        figure = _figure(8.6, 3.6)
        left, right = figure.subplots(1, 2)
        for colour, style, (name, kind) in zip(
            (BLUE, VERMILION, GREEN, PURPLE), ("-", "--", "-.", ":"), kinds.items(), strict=True
        ):
            curve = kind.curve(radius)
            left.plot(np.degrees(phi), curve.displacement(phi)[:, 0] / w0, style, color=colour, label=name)
            moment = (curve.curvature(phi) - 1.0 / radius) * radius**2 / w0
            right.plot(np.degrees(phi), moment, style, color=colour, label=name)
        left.set(xlabel="φ from the major axis (°)", ylabel="w / w0", title="Radial displacement")
        right.set(xlabel="φ from the major axis (°)", ylabel="M in EI w0 / R²", title="Bending moment of the rim")
        for axes in (left, right):
            axes.set_xticks(np.arange(0, 91, 15))
        left.legend(fontsize=8.5)
    return figure


def _clearance(design: Design) -> Figure:
    """A tooth apart from the circular spline, and overlapping it, each with its witness."""
    geometry = Geometry.of(design)
    engagement = geometry.engagement
    pose = engagement.relative_poses(22.0)
    with house_style():
        figure = _figure(8.6, 4.2)
        for axes, shift, title in zip(
            figure.subplots(1, 2), (-0.09, 0.07), ("Apart: c > 0", "Overlapping: c < 0"), strict=True
        ):
            _bare(axes)
            moved = pose + np.array([shift, 0.0, 0.0])
            _draw_teeth(axes, geometry, moved, design.circular_spline_pitch_radius_mm)
            found = engagement.clearances_at(moved)
            first, second, gap = found.flexspline_point[1], found.circular_spline_point[1], float(found.gap[1])
            axes.plot(*np.stack([first, second]).T, color=VERMILION, linewidth=2.2, zorder=5)
            axes.plot(*np.stack([first, second]).T, "o", color=VERMILION, markersize=4, zorder=6)
            axes.annotate(
                f"c = {gap * MICROMETRES_PER_MM:+.0f} µm".replace("-", "−"),
                _at(0.5 * (first + second)),
                xytext=(26, -34 if gap > 0 else 26),
                textcoords="offset points",
                color=VERMILION,
                arrowprops={"arrowstyle": "-", "color": VERMILION, "linewidth": 0.8},
            )
            axes.set(xlabel="x (mm)", ylabel="y (mm)", title=title, xlim=(-0.35, 1.65), ylim=(-0.95, 0.95))
    return figure


def _draw_teeth(axes: Axes, geometry: Geometry, pose: Floats, pitch_radius: float) -> None:
    """The tooth A at its pose in the frame of a space, and the circular spline B on its right."""
    tooth = placed(tooth_outline(geometry.flexspline), pose)
    axes.fill(*np.concatenate([tooth, tooth[[-1, 0]] - (0.0, 2.0)]).T, facecolor=BLUE, alpha=0.18)
    axes.plot(*tooth.T, color=BLUE, linewidth=1.6)
    teeth = geometry.engagement.circular_spline_poses(np.array([0.0, -1.0]))
    for number in range(2):
        outline = placed(tooth_outline(geometry.circular_spline), teeth[number]) - (0.0, pitch_radius)
        axes.fill(*np.concatenate([outline, outline[[-1, 0]] + (0.0, 2.0)]).T, facecolor=ORANGE, alpha=0.18)
        axes.plot(*outline.T, color=ORANGE, linewidth=1.6)
    axes.annotate("A", (-0.12, -0.2), fontsize=13, color=BLUE)
    axes.annotate("B", (1.3, 0.45), fontsize=13, color=ORANGE)


def _certificate(design: Design) -> Figure:
    """The gap over continuous index with its minimum, and what is proved on one interval."""
    result = analyze(design)
    least = result.in_motion
    found = Geometry.of(design).engagement.minimum_in_motion(1e-6)
    with house_style():
        figure = _figure(8.6, 3.7)
        left, right = figure.subplots(1, 2)
        index, gap = result.gap_curve.sample(2001)
        left.plot(index, gap, color=BLUE)
        left.plot(least.index, least.gap_um, "o", color=VERMILION, label="least gap in motion")
        left.set(xlabel="tooth index k", ylabel="gap(k) (µm)", title="One curve holds every tooth at every angle")
        left.set_ylim(0.0, 60.0)
        left.legend(loc="upper left", fontsize=8.5)
        ends = np.array([35.0, 36.0])
        at = np.linspace(ends[0], ends[1], 201)
        g0, g1 = result.gap_curve.gap_um(ends)
        slope, bend = found.slope_bound * MICROMETRES_PER_MM, found.curvature_bound * MICROMETRES_PER_MM
        s = at - ends[0]
        right.plot(at, result.gap_curve.gap_um(at), color=BLUE, label="gap(k)")
        right.plot(
            at,
            (1 - s) * g0 + s * g1 - 0.5 * bend * s * (1 - s),
            color=GREEN,
            linestyle="--",
            label=f"parabola, gap″ ≤ M = {bend:.1f} µm",
        )
        right.plot(
            at,
            np.maximum(g0 - slope * s, g1 - slope * (1 - s)),
            color=VERMILION,
            linestyle="-.",
            label=f"cone, |gap′| ≤ L = {slope:.0f} µm",
        )
        right.plot(ends, [g0, g1], "o", color=INK, label="evaluated")
        right.set(xlabel="tooth index k", ylabel="µm", title="Two bounds on one interval", ylim=(-6.0, 3.2))
        right.legend(loc="lower center", fontsize=8.5)
    return figure
