"""The boundary against an independent one: the union, by shapely, of whole teeth as polygons in steps of the motion.

Such a union lies inside the swept region. Between two steps the region reaches beyond it by the square of the step
where a smooth piece touches, and by the step itself along the trajectory of a corner. Errors of the polygons' chords
are far below.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import shapely

from strainwave.conjugation import Spline, conjugate
from strainwave.conjugation.generation import Generation
from strainwave.conjugation.stretch import Stretch
from tests.conjugation.meshes import Floats
from tests.designs import case

POINTS_A_PIECE = 400
CHORDS_UM = 1e-3  # what the chords of an arc of 0.9 mm radius and 0.8 mm length deviate
LAST_INDEX = 45.0  # beyond it teeth are far from each other


@cache
def union(of: Spline, step: float) -> shapely.Geometry:
    """What the mate's whole tooth sweeps in steps of tooth index, in the sought tooth's frame."""
    generation = Generation.of(case(), of)
    u = np.unique(np.concatenate([np.linspace(*ends, POINTS_A_PIECE) for ends in pairwise(generation.mate.knots)]))
    half = generation.mate.position(u)
    tooth = np.concatenate([half[:0:-1] * (-1.0, 1.0), half, half[[-1, -1]] * [(1.0, 3.0), (-1.0, 3.0)]])
    (motion,) = generation.motions
    placed = motion.at(np.arange(-LAST_INDEX, LAST_INDEX + step, step)).placed(tooth[:, 0] + 1j * tooth[:, 1])
    return shapely.union_all(shapely.polygons(np.stack([placed.real, placed.imag], axis=-1)))


def distances_um(stretch: Stretch, swept: shapely.Geometry) -> Floats:
    """How far points of the boundary lie outside a swept region."""
    points = stretch.places.points[4:-4:4]
    distances: Floats = shapely.distance(shapely.points(points.real, points.imag), swept) * 1e3
    return distances


def stretches(of: Spline, *, corners: bool) -> Iterator[Stretch]:
    for stretch in conjugate(case(), of=of).flank.stretches:
        if stretch.branch.pieces.is_corner[stretch.branch.piece] == corners:
            yield stretch


@pytest.mark.parametrize("of", ["circular-spline", "flexspline"])
def test_smooth_pieces_sweep_up_to_the_boundary_with_the_square_of_the_step(of: Spline) -> None:
    for stretch in stretches(of, corners=False):
        errors = [float(distances_um(stretch, union(of, step)).max()) for step in (1.0, 0.5, 0.25, 0.125)]
        assert errors[-1] < 5e-3
        # Sixteenfold from the second to the last, but for steps that are coarse beside the zone and for the chords.
        assert 6.0 < errors[1] / errors[3] < 32.0
        assert all(coarse / fine > 2.2 for coarse, fine in pairwise(errors[1:]))


def test_a_corner_sweeps_up_to_the_boundary_with_the_step() -> None:
    (stretch,) = stretches("flexspline", corners=True)
    errors = [float(distances_um(stretch, union("flexspline", step)).mean()) for step in (1.0, 0.5, 0.25, 0.125)]
    assert all(1.6 < coarse / fine < 2.5 for coarse, fine in pairwise(errors))
    assert errors[-1] < 0.5


@pytest.mark.parametrize("of", ["circular-spline", "flexspline"])
def test_nothing_is_swept_beyond_the_boundary(of: Spline) -> None:
    """No point of the flank, from tip to root, lies inside the union by more than chords and arcs deviate."""
    result = conjugate(case(), of=of)
    profile = result.geometry.circular_spline if of == "circular-spline" else result.geometry.flexspline
    flank = [number for number, role in enumerate(profile.roles) if role != "tip land"]
    u = np.linspace(profile.knots[flank[0]], profile.length, 2000)
    swept = union(of, 0.125)
    points = shapely.points(profile.position(u))
    depths = np.where(shapely.contains(swept, points), shapely.distance(points, shapely.boundary(swept)), 0.0) * 1e3
    assert depths.max() < CHORDS_UM
    # Two-sided: moved into the path by 0.1 um, it would be.
    moved = shapely.points(profile.position(u) + 1e-4 * profile.normal(u))
    depths = np.where(shapely.contains(swept, moved), shapely.distance(moved, shapely.boundary(swept)), 0.0) * 1e3
    assert depths.max() > 0.08
