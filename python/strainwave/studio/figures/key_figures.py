"""The key figures of a design, in the order in which a designer asks."""

from __future__ import annotations

from strainwave.studio.figures.figure import Figure, depth, few

IN_MOTION = (
    Figure(
        "min-in-motion",
        "Least backlash",
        "µm",
        3,
        lambda found: found.min_in_motion_um,
        "Least normal backlash of all teeth at every generator angle; a gap is positive, the depth of an interference "
        "negative",
        depth,
    ),
    Figure(
        "certified",
        "certified to",
        "µm",
        3,
        lambda found: found.in_motion.certified_to_um,
        "How far below it the true least backlash may lie",
    ),
    Figure(
        "min-index",
        "at tooth index",
        "",
        1,
        lambda found: found.min_in_motion_index,
        "Where that is, in teeth from the major axis",
        mark="±",
    ),
    Figure(
        "play-in-motion-circumferential",
        "Play, circumf.",
        "µm",
        2,
        lambda found: found.play_in_motion.circumferential_um,
        "Arc at the circular spline's pitch circle that the output turns freely by, in one direction",
    ),
    Figure(
        "play-in-motion-angular",
        "Play, angular",
        "″",
        1,
        lambda found: found.play_in_motion.angular_arcsec,
        "The same as an angle about the gear axis",
    ),
)
AT_ANGLE_0 = (
    Figure(
        "min-backlash",
        "Least backlash",
        "µm",
        3,
        lambda found: found.min_backlash_um,
        "Least normal backlash of all teeth with the wave generator at 0°",
        depth,
    ),
    Figure("min-tooth", "at tooth", "", 0, lambda found: found.min_tooth),
    Figure(
        "play-circumferential",
        "Play, circumf.",
        "µm",
        2,
        lambda found: found.play.circumferential_um,
        "Arc at the circular spline's pitch circle that the output turns freely by, in one direction",
    ),
    Figure("play-angular", "Play, angular", "″", 1, lambda found: found.play.angular_arcsec),
    Figure(
        "interfering",
        "Interfering teeth",
        "",
        0,
        lambda found: found.teeth_interfering.drive,
        "Of all teeth of the flexspline, with the wave generator at 0°",
        few,
    ),
    Figure(
        "first-interfering",
        "first from axis",
        "",
        0,
        lambda found: found.first_interfering_tooth,
        "The interfering tooth nearest to the major axis",
    ),
)
TEETH_BELOW = (
    Figure("below-per-side", "per side", "", 0, lambda found: found.teeth_below.per_side, "On one side of an axis"),
    Figure("below-drive", "in the drive", "", 0, lambda found: found.teeth_below.drive, "Of all teeth"),
)
CLEARANCES = (
    Figure(
        "tip-clearance",
        "flexspline's tips",
        "µm",
        1,
        lambda found: found.tip_clearance_um,
        "Least radial clearance from the flexspline's tips to the circular spline's root circle",
        depth,
    ),
    Figure(
        "root-clearance",
        "flexspline's roots",
        "µm",
        1,
        lambda found: found.root_clearance_um,
        "Least radial clearance from the circular spline's tips to the flexspline's roots",
        depth,
    ),
)
TIP_LANDS = (
    Figure("tip-land-flexspline", "flexspline", "mm", 3, lambda found: found.figures.flexspline.tip_land_mm),
    Figure(
        "tip-land-circular-spline", "circular spline", "mm", 3, lambda found: found.figures.circular_spline.tip_land_mm
    ),
)
GEAR = (
    Figure("ratio", "Ratio", "", 2, lambda found: found.design.ratio, "Input over output speed, circular spline fixed"),
    Figure(
        "relative-w0",
        "w0* = w0 / module",
        "",
        4,
        lambda found: found.design.wave_generator.w0 / found.design.module,
    ),
    Figure(
        "neutral-radius",
        "Neutral radius",
        "mm",
        4,
        lambda found: found.figures.neutral_curve.radius_mm,
        "Radius of the undeformed neutral circle",
    ),
    Figure(
        "perimeter-growth",
        "Perimeter grows",
        "ppm",
        1,
        lambda found: found.figures.neutral_curve.perimeter_growth * 1e6,
        "Of the neutral curve, against the undeformed circle",
    ),
    Figure("major-axis", "w at major axis", "mm", 4, lambda found: found.figures.neutral_curve.major_axis_mm),
    Figure("minor-axis", "w at minor axis", "mm", 4, lambda found: found.figures.neutral_curve.minor_axis_mm),
    Figure(
        "ring-theory",
        "Ring theory off by",
        "µm",
        2,
        lambda found: found.figures.neutral_curve.ring_theory_error_um,
        "Order of the error of a linear thin ring, w0²/R",
    ),
)
