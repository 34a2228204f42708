"""Designs of every profile kind and every generator kind, and random rows of their numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from strainwave.design import Design
from strainwave.design.keys import leaves
from tests.designs import case, circular_spline_as_pieces

# One line on the flexspline, as far as a chain can be from the built-in kinds.
LINE = {
    "kind": "pieces",
    "addendum": 0.5,
    "dedendum": 0.6,
    "start": [0.6, 0.4982],
    "pieces": [{"to": [0.8, -0.6032]}],
}
GENERATORS: dict[str, dict[str, Any]] = {
    "cosine": {"kind": "cosine", "neutral_curve": "first-order"},
    "ellipse": {"kind": "ellipse", "cam_to_neutral": 12.8},
    "two-roller": {"kind": "two-roller", "neutral_curve": "shifted"},
    "four-roller": {"kind": "four-roller", "roller_angle": 19.5},
    "wrap-angle": {"kind": "dual-disk", "wrap_angle": 13.0},
    "disk-radius": {"kind": "dual-disk", "disk_radius": 77.2},
    "samples": {"kind": "table", "samples": [1.0, 0.7, 0.02, -0.71, -1.01]},
    "fourier": {"kind": "table", "fourier": [0.01, 0.98, 0.02, -0.01]},
}
INVOLUTE = {"kind": "involute", "addendum": 0.5, "dedendum": 0.7, "pressure_angle": 28.0, "root_fillet_radius": 0.1}
PROFILES: dict[str, dict[str, Any]] = {
    "arcs": {},
    "pieces": {"circular_spline.profile": circular_spline_as_pieces()},
    "involute": {
        "flexspline.profile": INVOLUTE | {"offset": -0.01},
        "circular_spline.profile": INVOLUTE | {"profile_shift": 0.05},
        "flexspline.neutral_radius": 79.83,
    },
    "line": {
        "flexspline.profile": LINE,
        "flexspline.neutral_radius": 79.83,
        "flexspline.face_width": 20.0,
        "flexspline.cup_length": 60.0,
        "flexspline.diaphragm_thickness": 2.0,
        "flexspline.boss_diameter": 90.0,
        "circular_spline.face_width": 18.0,
        "circular_spline.outer_diameter": 200.0,
    },
}
WILD = (np.nan, np.inf, -np.inf, 0.0, -1.0, 1e-5, 0.3, 5.0, 40.0, 79.0, 90.0, 1e7)


def varied_design(generator: str, profile: str = "arcs") -> Design:
    """A design whose wave generator and profiles are of the kinds named."""
    keys = GENERATORS[generator] | {"w0": 0.848}
    return case().replace(PROFILES[profile] | {"wave_generator": keys})


def number_keys(design: Design) -> list[str]:
    """Every number of a design but those of teeth."""
    return [key for key, value in leaves(design.to_dict()) if type(value) is float]


def random_rows(design: Design, keys: list[str], seed: int, *, rows: int) -> NDArray[np.float64]:
    """Rows near the design, every third of them with one number far off."""
    rng = np.random.default_rng(seed)
    known = dict(leaves(design.to_dict()))
    base = np.array([known[key] for key in keys], dtype=np.float64)
    values = base + rng.normal(0.0, 1.0, (rows, len(keys))) * [_spread(key) for key in keys]
    fillets = [key.endswith("root_fillet_radius") for key in keys]
    values[:, fillets] = abs(values[:, fillets])
    for row in range(0, rows, 3):
        values[row, rng.integers(len(keys))] = rng.choice(WILD)
    return values


def _spread(key: str) -> float:
    """How far numbers near a design scatter: little where its rules leave little room."""
    if "fourier" in key or key.endswith("samples[0]"):
        return 0.0
    if ".pieces[" in key or ".start[" in key:
        return 3e-5
    return 2e-4 if key.endswith("dendum") else 1e-3
