"""Which numbers of a design file describe a tooth profile, and how each is shown on the tooth."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from strainwave.design import Design
from strainwave.plots.dimension import Dimension, Points, Side, arc_between, both_ways, point, turned
from strainwave.plots.tooth_sketch import FlankPiece, ToothSketch
from strainwave.profiles import DoubleCircularArc, Involute, Pieces
from strainwave.profiles.tip_arc import TipArcProfile
from strainwave.units import format_angle

# Modules: how long the strokes are that have no length of their own.
ANGLE_ARM = 0.95
RADIUS_SHOWN = 0.75
OFFSET_SHOWN = 0.14
BESIDE = 0.16
# More joins than this could not be told apart.
PIECES_NAMED = 6
# Letters that a label has room for.
LONGEST_NUMBER = 7
LONGEST_ANGLE = 12


def profile_dimensions(sketch: ToothSketch, highlight: str = "") -> Iterator[Dimension]:
    """The dimensions of one tooth; ``highlight``, a key below the spline's table, is among them if it can be."""
    yield from _heights(sketch)
    spec = sketch.spec
    if isinstance(spec, TipArcProfile):
        yield from _tip_arc(spec, sketch)
    if isinstance(spec, DoubleCircularArc):
        yield from _double_arc(spec, sketch)
    if isinstance(spec, Involute):
        yield from _involute(spec, sketch)
    if isinstance(spec, Pieces):
        yield from _pieces(spec, sketch, highlight)
    yield _fillet(sketch)
    yield _offset(sketch)


def rim_dimensions(design: Design, drawn_wall: float, sketch: ToothSketch) -> Iterator[Dimension]:
    """The flexspline's rim under the teeth, ``drawn_wall`` modules of it."""
    x = 0.55 * sketch.half_pitch
    top = sketch.circle(-sketch.spec.dedendum, np.array([x]))[0]
    wall = design.flexspline.wall_thickness
    # A rim too thick for the picture is drawn thinner, and its neutral circle at the same share of it.
    shrunk = drawn_wall * design.module / wall
    note = "" if shrunk == 1.0 else ", not to scale"
    yield Dimension(
        "wall_thickness",
        f"{_short(wall)} mm{note}",
        top - (0.0, 0.25 * drawn_wall),
        "right",
        arrows=both_ways(top, top - (0.0, drawn_wall)),
    )
    neutral = neutral_height(design, drawn_wall)
    yield Dimension(
        "neutral_radius", f"{design.neutral_radius_mm:.6g} mm", point(-0.4 * sketch.half_pitch, neutral), "left"
    )


def neutral_height(design: Design, drawn_wall: float) -> float:
    """Height of the undeformed neutral circle in the sketch, modules over the pitch circle."""
    dedendum = design.flexspline.profile.dedendum
    below_root = design.flexspline_pitch_radius_mm - dedendum * design.module - design.neutral_radius_mm
    return -dedendum - below_root / design.flexspline.wall_thickness * drawn_wall


def _length(value: float, module: float) -> str:
    return f"{_short(value)} m = {value * module:.3g} mm"


def _short(value: float) -> str:
    """As the file says it, or as much of it as a label has room for."""
    text = f"{value:.6g}"
    return (text if len(text) <= LONGEST_NUMBER else f"{value:.4g}").replace("-", "−")


def _heights(sketch: ToothSketch) -> Iterator[Dimension]:
    """Addendum and dedendum, beside the tooth."""
    for name, sign in (("addendum", 1.0), ("dedendum", -1.0)):
        value = float(getattr(sketch.spec, name))
        x = np.array([-1.08 * sketch.half_pitch])
        pitch, end = sketch.circle(0.0, x)[0], sketch.circle(sign * value, x)[0]
        yield Dimension(
            f"profile.{name}", _length(value, sketch.module), 0.5 * (pitch + end), "left", arrows=both_ways(pitch, end)
        )


def _radius(key: str, radius: float, piece: FlankPiece, sketch: ToothSketch, side: Side) -> Dimension:
    """An arrow from the arc's centre, or from as near to it as the picture goes, to the arc."""
    center, window = piece.center, 1.05 * sketch.half_pitch
    seen = bool(np.abs(center[0]) <= window and np.abs(center[1]) <= 1.3 * window)
    along = np.sign(piece.curvature) * piece.normal
    tail = center if seen else piece.middle - min(radius, RADIUS_SHOWN) * along
    convex = piece.curvature > 0.0
    anchor = piece.middle if convex else 0.5 * (tail + piece.middle)
    return Dimension(
        f"profile.{key}",
        _length(radius, sketch.module),
        anchor,
        side,
        arrows=((tail, piece.middle),),
        marks=(center,) if seen else (),
    )


def _tip_arc(spec: TipArcProfile, sketch: ToothSketch) -> Iterator[Dimension]:
    arc, line = sketch.pieces[0], sketch.pieces[1]
    yield _radius("tip_arc_radius", spec.tip_arc_radius, arc, sketch, "right")
    x, y = spec.tip_arc_center
    center, foot = point(x, y), point(x, 0.0)
    yield Dimension(
        "profile.tip_arc_center",
        f"[{_short(x)}, {_short(y)}] m",
        center,
        "left",
        lines=(np.array([point(0.0, 0.0), foot, center]),),
        marks=(center,),
    )
    up = line.first - line.last
    up /= np.hypot(*up)
    yield _angle("flank_angle", spec.flank_angle, line.first, up, point(0.0, 1.0))


def _angle(key: str, degrees: float, vertex: Points, flank: Points, reference: Points) -> Dimension:
    arc = arc_between(vertex, reference, flank, 0.85 * ANGLE_ARM)
    return Dimension(
        f"profile.{key}",
        format_angle(degrees) if len(format_angle(degrees)) < LONGEST_ANGLE else f"{degrees:g}°",
        arc[len(arc) // 2],
        "right",
        lines=(
            np.array([vertex, vertex + ANGLE_ARM * flank]),
            np.array([vertex, vertex + ANGLE_ARM * reference]),
            arc,
        ),
    )


def _double_arc(spec: DoubleCircularArc, sketch: ToothSketch) -> Iterator[Dimension]:
    line, arc = sketch.pieces[1], sketch.pieces[2]
    beside = BESIDE * line.normal
    yield Dimension(
        "profile.flank_length",
        _length(spec.flank_length, sketch.module),
        line.middle + beside,
        "right",
        lines=tuple(np.array([end, end + 1.3 * beside]) for end in (line.first, line.last)),
        arrows=both_ways(line.first + beside, line.last + beside),
    )
    yield _radius("flank_arc_radius", spec.flank_arc_radius, arc, sketch, "right")


def _involute(spec: Involute, sketch: ToothSketch) -> Iterator[Dimension]:
    at, normal = sketch.pitch_point()
    side = -1.0 if sketch.profile.internal else 1.0
    radial = at + point(0.0, side * sketch.profile.pitch_radius / sketch.module)
    radial *= side / np.hypot(*radial)
    yield _angle("pressure_angle", spec.pressure_angle, at, turned(normal, -0.5 * np.pi), radial)
    left = at * (-1.0, 1.0)
    yield Dimension(
        "profile.profile_shift",
        f"{_short(spec.profile_shift)}: the thickness",
        0.75 * left + 0.25 * at,
        "left",
        arrows=both_ways(left, at),
    )


def _pieces(spec: Pieces, sketch: ToothSketch, highlight: str) -> Iterator[Dimension]:
    """The first point and the pieces; of many those spread over the flank, and the highlighted one."""
    yield _join("start", f"[{spec.start[0]:.4g}, {spec.start[1]:.4g}] m", point(*spec.start))
    count = len(spec.pieces)
    named = {int(place) for place in np.linspace(0, count - 1, min(count, PIECES_NAMED)).round()}
    named |= {place for place in range(count) if f"{highlight}.".startswith(f"profile.pieces[{place}].")}
    joins = np.array([spec.start, *(piece.to for piece in spec.pieces)])
    for place in sorted(named):
        piece = spec.pieces[place]
        kind = ", line" if piece.radius is None else f", r {piece.radius:.3g} m"
        to = f"to [{piece.to[0]:.3g}, {piece.to[1]:.3g}] m"
        yield _join(f"pieces[{place}]", to, joins[place + 1], kind.replace("-", "−"))


def _join(name: str, value: str, at: Points, note: str = "") -> Dimension:
    return Dimension(f"profile.{name}", value.replace("-", "−"), at, "right", marks=(at,), note=note)


def _fillet(sketch: ToothSketch) -> Dimension:
    radius = sketch.spec.root_fillet_radius
    if sketch.fillet is not None:
        return _radius("root_fillet_radius", radius, sketch.fillet, sketch, "right")
    return Dimension(
        "profile.root_fillet_radius", f"{radius:g}: a sharp corner", sketch.root, "right", marks=(sketch.root,)
    )


def _offset(sketch: ToothSketch) -> Dimension:
    """The flank moved along its outward normal, much farther than it is; on the left, where there is room."""
    share = np.linspace(0.3, 0.75, 33)
    points, normals = sketch.flank_at(share)
    mirror = np.array([-1.0, 1.0])
    moved = (points + OFFSET_SHOWN * normals) * mirror
    middle = len(share) // 2
    offset = sketch.spec.offset
    return Dimension(
        "profile.offset",
        f"{_short(offset)} mm, enlarged" if offset else "0 mm: none",
        moved[middle],
        "left",
        lines=(moved,),
        arrows=((points[middle] * mirror, moved[middle]),),
    )
