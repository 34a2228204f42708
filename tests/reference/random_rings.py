"""Random neutral curves of every kind of wave generator, from the thin-ring solutions w(φ)/w0.

w is the inextensible thin ring under the given load (Timoshenko, Strength of Materials II, thin rings): rollers at ±β
about the major axis, or a rim that lies on a circular disk over |φ| ≤ β.
"""

from __future__ import annotations

import numpy as np

from strainwave._kernel import NeutralCurve
from tests.reference.outline import Floats

MODELS = ("first-order", "shifted", "inextensible")


def random_curve(rng: np.random.Generator, radius: float, w0: float) -> NeutralCurve:
    """A neutral curve of a random kind and model; radius and w0 in mm. Raises GeometryError where there is none."""
    kind = rng.choice(["cosine", "ellipse", "two-roller", "four-roller", "dual-disk", "table"])
    model = str(rng.choice(MODELS))
    if kind == "ellipse":
        return NeutralCurve.ellipse(radius, w0, rng.uniform(0.0, 0.05) * radius * rng.integers(2))
    if kind == "cosine":
        return NeutralCurve.harmonics(radius, w0, model, [0.0, 1.0])
    if kind == "table":
        overtones = rng.normal(0.0, [0.04, 0.01])
        return NeutralCurve.harmonics(radius, w0, model, [0.0, float(1.0 - overtones.sum()), *overtones.tolist()])
    if kind == "dual-disk":
        return NeutralCurve.ring(radius, w0, model, dual_disk_pieces(np.radians(rng.uniform(5.0, 40.0))))
    roller_angle = 0.0 if kind == "two-roller" else np.radians(rng.uniform(3.0, 38.0))
    return NeutralCurve.ring(radius, w0, model, roller_pieces(roller_angle))


def roller_pieces(beta: float) -> Floats:
    """Rows (end of φ, p, c, c_φ, s, s_φ) of w/w0 for rollers at ±β, rad; two rollers are β = 0."""
    sin, cos = np.sin(beta), np.cos(beta)
    at_roller = sin + (0.5 * np.pi - beta) * cos
    k = 1.0 / (at_roller - 4.0 / np.pi)
    mean = -4.0 * k / np.pi
    outside = [0.5 * np.pi, mean, 0.5 * np.pi * k * cos, -k * cos, k * (cos + beta * sin), 0.0]
    if beta == 0.0:
        return np.array([outside])
    return np.array([[beta, mean, k * at_roller, 0.0, 0.0, k * sin], outside])


def dual_disk_pieces(beta: float) -> Floats:
    """Rows (end of φ, p, c, c_φ, s, s_φ) of w/w0 for a disk with wrap half angle β, rad."""
    sin, cos = np.sin(beta), np.cos(beta)
    free = np.pi * (np.pi - 2.0 * beta - np.sin(2.0 * beta))
    scale = free - 8.0 * cos - 8.0 * beta * sin + 4.0 * np.pi * sin
    disk_offset, disk_growth = free / scale, 4.0 * (np.pi * sin - 2.0 * beta * sin - 2.0 * cos) / scale
    mean, q = -8.0 * (cos + beta * sin) / scale, 2.0 * np.pi / scale
    tail = 2.0 * np.pi * (1.0 + sin**2) / scale
    return np.array(
        [
            [beta, disk_growth, disk_offset, 0.0, 0.0, 0.0],
            [0.5 * np.pi, mean, 0.5 * np.pi * q, -q, tail, 0.0],
        ]
    )
