"""The proportions of a proposed design, each with its source."""

from __future__ import annotations

from typing import Any

# Two lobes and two teeth of difference: the least that the lobes allow, and with it the ratio -z_f / 2.
TOOTH_DIFFERENCE = 2

ARTICLE = "the article's table of profile parameters"
CASE_STUDY = "the case study's reading of what the article does not print"

# The article's wall of 1.6 mm under teeth of 163.2 mm pitch diameter. In proportion to the diameter and not to the
# module: the rim's bending strain goes with wall times w0 over diameter squared, and w0 with the module already.
WALL_TO_DIAMETER = 1.6 / 163.2

_TIP_ARC = {
    "addendum": 0.9,
    "tip_arc_radius": 1.0802,
    "tip_arc_center": [-0.3927, 0.0],
    "flank_angle": 7.0 + 30.0 / 60.0 + 30.0 / 3600.0,
    "dedendum": 1.212,
}
_CIRCULAR_SPLINE = {
    "kind": "arc-line",
    "addendum": 0.9,
    "dedendum": 1.15,
    "tip_arc_radius": 2.0528,
    "tip_arc_center": [-1.1560, -0.366],
    "flank_angle": 8.4,
}

# Tooth profiles by the name of the flexspline's: the tables of both splines, and where their numbers come from.
PROFILES: dict[str, dict[str, Any]] = {
    "double-circular-arc": {
        "flexspline": {
            "kind": "double-circular-arc",
            **_TIP_ARC,
            "flank_length": 0.5,
            "flank_arc_radius": 2.0528,
            "root_fillet_radius": 0.55,
        },
        "circular_spline": _CIRCULAR_SPLINE,
        "source": f"{ARTICLE}; straight flank 0.5 modules and tip arc's height from {CASE_STUDY}",
    },
    "arc-line": {
        "flexspline": {"kind": "arc-line", **_TIP_ARC, "root_fillet_radius": 0.3},
        "circular_spline": _CIRCULAR_SPLINE,
        "source": f"{ARTICLE}, the flexspline's straight flank led down to the root in place of its concave arc",
    },
    "involute": {
        "flexspline": {
            "kind": "involute",
            "pressure_angle": 20.0,
            "addendum": 0.5,
            "dedendum": 1.0,
            "root_fillet_radius": 0.2,
        },
        "circular_spline": {"kind": "involute", "pressure_angle": 20.0, "addendum": 0.5, "dedendum": 1.0},
        "source": "the pressure angle of ISO 53; half its addendum, for with a difference of two teeth full tips would "
        "strike each other beside the zone of contact",
    },
}

# w0 in modules. At one module the flexspline's pitch curve reaches out to the circular spline's pitch circle; the usual
# range lies about it.
LEAST_W0, GREATEST_W0 = 0.9, 1.3

# The least backlash in motion that is aimed at: 2.5 um for each mm of module, and within these limits; half of it for
# precision. It lies inside the 0.5 to 5 um that every proposal keeps.
TARGET_UM_PER_MODULE = 2.5
LEAST_TARGET_UM, GREATEST_TARGET_UM = 0.7, 2.0
# A tooth counts as sharing the load within so much of the tightest, for each mm of module: 8 um at the article's
# 0.8 mm, which with a target of 2 um is its threshold of 10 um.
SHARING_UM_PER_MODULE = 10.0
