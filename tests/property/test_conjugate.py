"""Conjugate profiles of random designs: where there is one, the pair touches in its zones and overlaps nowhere."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from strainwave.conjugation import Spline, conjugate
from strainwave.design import Design
from strainwave.errors import DesignError
from strainwave.geometry import Geometry
from tests.designs import case

BLOCKS = 3
DESIGNS = 8
SPLINES: tuple[Spline, Spline] = ("circular-spline", "flexspline")
# Arcs deviate by 0.01 µm at most, and the flank stands back by as much; the rest is for crossings between samples.
DEEPEST_UM, WIDEST_UM = -0.005, 0.05


def test_conjugate_pairs_touch_and_do_not_overlap(block: int) -> None:
    checked = 0
    for seed in range(block * DESIGNS, (block + 1) * DESIGNS):
        design = random_design(seed)
        for of in SPLINES:
            try:
                result = conjugate(design, of=of)
            except DesignError:
                continue  # its circles leave no room for such a flank
            index = np.linspace(0.0, design.flexspline.teeth / 4, 2001)
            deepest = float(result.geometry.engagement.clearances(index).gap.min()) * 1e3
            least, widest = result.gap_in_zones_um
            assert result.deviation_um <= 0.01, (seed, of)
            assert min(deepest, least) > DEEPEST_UM, (seed, of)
            assert widest < WIDEST_UM, (seed, of)
            checked += 1
    assert checked > DESIGNS / 2


def test_a_root_that_sweeps_across_the_teeth_along_a_circle_leaves_none_there() -> None:
    """Found at random: the height of the root's envelope is the same over the tooth's whole width to 1e-7 of it."""
    with pytest.raises(DesignError, match="the circular spline's tooth sweeps all material"):
        conjugate(random_design(431), of="flexspline")


def random_design(seed: int) -> Design:
    """A design of geometry: both profiles, the generator and the neutral curve drawn; the impossible drawn again."""
    rng = np.random.default_rng([seed, 4])
    while True:
        try:
            design = case().replace(_changes(rng))
            Geometry.of(design)
        except DesignError:
            continue
        return design


def _changes(rng: np.random.Generator) -> dict[str, Any]:
    module, teeth, difference = rng.uniform(0.2, 1.5), int(rng.integers(40, 320)), int(rng.choice([2, 2, 2, 4, 6]))
    generator = _generator(rng) | {"w0": rng.uniform(0.8, 1.25) * module * difference / 2}
    changes: dict[str, Any] = {
        "module": module,
        "flexspline.teeth": teeth,
        "circular_spline.teeth": teeth + difference,
        "flexspline.wall_thickness": 2.0 * module,
        "wave_generator": generator,
        "circular_spline.profile.addendum": rng.uniform(0.6, 0.95),
        "circular_spline.profile.dedendum": rng.uniform(1.1, 1.4),
        "circular_spline.profile.flank_angle": rng.uniform(4.0, 16.0),
        "circular_spline.profile.tip_arc_radius": rng.uniform(1.6, 2.5),
        "flexspline.profile.dedendum": rng.uniform(1.1, 1.4),
        "flexspline.profile.addendum": rng.uniform(0.6, 0.95),
        "flexspline.profile.tip_arc_radius": rng.uniform(0.97, 1.4),
        "flexspline.profile.flank_angle": rng.uniform(4.0, 16.0),
        "flexspline.profile.offset": rng.uniform(-0.02, 0.0) * module,
        "flexspline.profile.root_fillet_radius": rng.choice([0.0, 0.2, 0.4]),
    }
    return {key: float(value) if isinstance(value, np.floating) else value for key, value in changes.items()}


def _generator(rng: np.random.Generator) -> dict[str, Any]:
    angle = float(rng.uniform(5.0, 35.0))
    kinds: list[dict[str, Any]] = [
        {"kind": "cosine"},
        {"kind": "four-roller", "roller_angle": angle},
        {"kind": "dual-disk", "wrap_angle": angle},
        {"kind": "two-roller"},
        {"kind": "ellipse"},
    ]
    generator = kinds[int(rng.integers(len(kinds)))]
    if generator["kind"] != "ellipse":
        generator["neutral_curve"] = str(rng.choice(["first-order", "shifted", "inextensible"]))
    return generator
