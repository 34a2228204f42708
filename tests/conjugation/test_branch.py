"""Branches of contact: against analytic envelopes of simple motions, and against n · v = 0 from the kernel's poses."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.conjugation.branch import Branch, branches_of
from strainwave.conjugation.contact_pieces import ContactPieces, Contacts
from strainwave.conjugation.mesh_motion import MeshMotion
from strainwave.conjugation.motion import Frames, Motion, Plane
from strainwave.geometry import Geometry
from tests.conjugation.meshes import DESIGNS, REACH, STEP, Floats, derivative

ARC_RADIUS, HOLLOW_RADIUS = 1.3, 2.0
DIFFERENCE_ERROR = 2e-12  # mm per index: rounding of positions about 80 mm away, over the step


def direction(angle: float) -> complex:
    return complex(np.sin(angle), np.cos(angle))


def bulge() -> Floats:
    """A convex arc about the origin, from straight up to straight right."""
    return np.array([[0.0, ARC_RADIUS, 0.0, 1.0 / ARC_RADIUS, 0.5 * np.pi * ARC_RADIUS]])


def hollow() -> Floats:
    """A concave arc about (2, 2), from below it to the left of it."""
    return np.array([[2.0, 0.0, 0.0, -1.0 / HOLLOW_RADIUS, 0.25 * np.pi * HOLLOW_RADIUS]])


def wedge() -> Floats:
    """Two lines that meet at the corner (1, 0): one falls to it from the left, one falls away from it steeply."""
    slope = 0.3
    start = 1.0 - direction(slope + 0.5 * np.pi)
    return np.array([[start.real, start.imag, slope, 0.0, 1.0], [1.0, 0.0, 1.2, 0.0, 1.0]])


def translation(towards: float, last: float = 3.0) -> Motion:
    """Along a direction, an angle clockwise from y."""

    def at(parameter: Floats) -> Frames:
        along, still = np.full(parameter.shape, direction(towards)), np.zeros_like(parameter)
        return Frames(parameter * along, still, along, still)

    return Motion(0.0, last, at)


def rotation(center: complex, last: float = 1.0) -> Motion:
    """Clockwise about a point."""

    def at(parameter: Floats) -> Frames:
        turn = np.exp(-1j * parameter)
        return Frames(center - center * turn, parameter, 1j * center * turn, np.ones_like(parameter))

    return Motion(0.0, last, at)


def only(profile: Floats, motion: Motion, *, corner: bool = False) -> Branch:
    found = [
        branch
        for branch in branches_of(ContactPieces.of(profile), motion)
        if branch.pieces.is_corner[branch.piece] == corner
    ]
    assert len(found) == 1
    return found[0]


def test_a_translated_arc_leaves_the_tangent_in_the_direction_of_travel() -> None:
    """The envelope of a circle is the line a radius beside its centre's path."""
    towards = 2.0
    branch = only(bulge(), translation(towards))
    assert (branch.first, branch.last) == (0.0, 3.0)
    parameter = np.linspace(0.0, 3.0, 7)
    contacts = branch.contacts(parameter)
    beside = ARC_RADIUS * direction(towards - 0.5 * np.pi)
    assert np.allclose(contacts.points, beside + parameter * direction(towards), atol=1e-15)
    assert np.allclose(contacts.u, ARC_RADIUS * (towards - 0.5 * np.pi), atol=1e-15)


def test_a_translated_hollow_does_too() -> None:
    towards = 0.5 * np.pi - 0.4
    branch = only(hollow(), translation(towards))
    contacts = branch.contacts(np.array([0.0, 2.0]))
    touching = 2.0 + 2.0j - HOLLOW_RADIUS * direction(towards - 0.5 * np.pi)
    assert np.allclose(contacts.points, [touching, touching + 2.0 * direction(towards)], atol=1e-15)


@pytest.mark.parametrize(("normal", "touches"), [(0.29, False), (0.31, True), (1.19, True), (1.21, False)])
def test_a_translated_corner_bounds_what_it_sweeps_within_its_cone_of_normals(normal: float, touches: bool) -> None:
    towards = normal + 0.5 * np.pi
    found = branches_of(ContactPieces.of(wedge()), translation(towards))
    assert [branch.pieces.is_corner[branch.piece] for branch in found] == [True] * touches
    for branch in found:
        parameter = np.linspace(0.0, 3.0, 5)
        contacts = branch.contacts(parameter)
        assert np.allclose(contacts.points, 1.0 + parameter * direction(towards), atol=1e-15)
        assert np.allclose(contacts.normals, direction(normal), atol=1e-15)


@pytest.mark.parametrize(("edge", "inwards"), [(0.3, 1.0), (1.2, -1.0)])
def test_a_contact_much_shorter_than_the_steps_of_the_search_is_found(edge: float, inwards: float) -> None:
    """The corner's path turns into its cone of normals and out again within a ten-thousandth of the motion."""
    middle, half = 0.3, 5e-5

    def at(parameter: Floats) -> Frames:
        normal = edge + inwards * 2.0 * (half**2 - (parameter - middle) ** 2)
        still = np.zeros_like(parameter)
        return Frames(still.astype(np.complex128), still, np.exp(-1j * normal), still)

    found = branches_of(ContactPieces.of(wedge()), Motion(0.0, 1.0, at))
    corners = [branch for branch in found if branch.pieces.is_corner[branch.piece]]
    assert len(corners) == 1
    assert corners[0].first == pytest.approx(middle - half, abs=1e-9)
    assert corners[0].last == pytest.approx(middle + half, abs=1e-9)


def test_a_hollow_corner_never_touches() -> None:
    dent = wedge()[:, :]
    dent[:, 2] = [1.2, 0.3]
    assert not ContactPieces.of(dent).is_corner.any()


@pytest.mark.parametrize(
    ("profile", "arc_center", "radius", "normal"),
    [(bulge(), 0.0, ARC_RADIUS, 0.3), (hollow(), 2.0 + 2.0j, -HOLLOW_RADIUS, -0.4)],
    ids=["convex", "concave"],
)
def test_a_rotated_arc_leaves_a_circle_about_the_centre_of_rotation(
    profile: Floats, arc_center: complex, radius: float, normal: float
) -> None:
    """The normal of contact passes through that centre, so the circle touches the arc in line with both centres."""
    center = arc_center - 5.0 * direction(normal)
    contacts = only(profile, rotation(center)).contacts(np.linspace(0.0, 1.0, 9))
    from_center = contacts.points - center
    assert np.allclose(np.abs(from_center), 5.0 + radius, atol=1e-14)
    assert np.allclose(contacts.normals, from_center / np.abs(from_center), atol=1e-14)
    assert np.allclose(contacts.u, radius * normal, atol=1e-14)


def test_a_rotated_line_touches_at_the_foot_of_the_perpendicular() -> None:
    line = np.array([[-1.0, 0.5, 0.0, 0.0, 2.0]])
    center = 0.2 - 3.0j
    contacts = only(line, rotation(center)).contacts(np.linspace(0.0, 1.0, 9))
    assert np.allclose(contacts.u, 1.2, atol=1e-15)
    assert np.allclose(np.abs(contacts.points - center), 3.5, atol=1e-14)


def test_a_rotated_line_whose_foot_lies_beyond_its_end_touches_with_its_corner() -> None:
    center = 1.0 - 4.0 * direction(0.7)
    found = branches_of(ContactPieces.of(wedge()), rotation(center))
    assert [branch.pieces.is_corner[branch.piece] for branch in found] == [True]
    contacts = found[0].contacts(np.linspace(0.0, 1.0, 9))
    assert np.allclose(np.abs(contacts.points - center), 4.0, atol=1e-14)


def test_a_rolling_rack_generates_an_involute() -> None:
    """The flank of a rack of pressure angle alpha envelops the involute of the circle r cos alpha (Litvin and Fuentes
    2004, chapter 10), here in the frame of a gear of pitch radius r."""
    radius, alpha = 10.0, np.radians(20.0)

    def at(roll: Floats) -> Frames:
        # The rack's pitch line y = 0 rolls on the circle about (0, -r): its frame slides back and turns with the gear.
        turn = np.exp(-1j * roll)
        return Frames((1j - roll) * radius * turn, roll, 1j * roll * radius * turn, np.ones_like(roll))

    parameter = np.linspace(-0.3, 0.3, 7)
    step = 1e-6
    slope = (at(parameter + step).origin - at(parameter - step).origin) / (2.0 * step)
    assert np.allclose(at(parameter).velocity, slope, atol=1e-8)  # the motion itself is right
    flank = np.array([[-2.0 * np.tan(alpha), 2.0, 0.5 * np.pi - alpha, 0.0, 4.0 / np.cos(alpha)]])
    branch = only(flank, Motion(-0.3, 0.3, at))
    points = branch.contacts(np.linspace(branch.first, branch.last, 50)).points
    base = radius * np.cos(alpha)
    pressure = np.arccos(base / np.abs(points))
    angle = np.arctan2(points.real, points.imag) + np.tan(pressure) - pressure
    assert np.ptp(angle) < 1e-13
    assert np.abs(points).max() - np.abs(points).min() > 0.5


def _across(contacts: Contacts, velocity: Plane) -> Floats:
    return np.asarray((np.conj(contacts.normals) * velocity).real)


@pytest.mark.parametrize("name", DESIGNS)
def test_contacts_slide_along_the_flank(name: str) -> None:
    """n · v = 0 within 1e-9 of |v|, with v from the derivatives and from differences of the kernel's poses."""
    geometry = Geometry.of(DESIGNS[name])
    mesh = MeshMotion(geometry)
    touched = 0
    for profile, motions in (
        (geometry.flexspline, mesh.flexspline()),
        (geometry.circular_spline, mesh.circular_spline()),
    ):
        for motion in motions:
            for branch in branches_of(ContactPieces.of(profile.segments), motion):
                first, last = max(branch.first, motion.first + REACH), min(branch.last, motion.last - REACH)
                if last <= first:
                    continue
                index = np.linspace(first, last, 33)
                contacts = branch.contacts(index)
                # The profile's own point that touches, carried along.
                own = profile.position(contacts.u)
                paths = [motion.at(index + j * STEP).points(own[:, 0] + 1j * own[:, 1]) for j in range(-4, 5)]
                velocity = derivative([path.real for path in paths]) + 1j * derivative([path.imag for path in paths])
                assert np.abs(paths[4] - contacts.points).max() < 1e-12
                assert (np.abs(_across(contacts, velocity)) < 1e-9 * np.abs(velocity) + DIFFERENCE_ERROR).all()
                exact = motion.at(index).velocities(contacts.points)
                assert (np.abs(_across(contacts, exact)) < 1e-9 * np.abs(exact)).all()
                touched += len(index)
    assert touched > 400


def test_contact_passes_on_from_piece_to_piece_without_a_break() -> None:
    """Two branches meet wherever one ends, but for the ends of the profile and of the motion."""
    geometry = Geometry.of(DESIGNS["cosine"])
    (motion,) = MeshMotion(geometry).flexspline()
    found = branches_of(ContactPieces.of(geometry.flexspline.segments), motion)
    ends = [
        (index, branch.contacts(np.array([index])).points[0])
        for branch in found
        for index in (branch.first, branch.last)
        if abs(index) < 51.0 and 1e-9 < branch.contacts(np.array([index])).u[0] < geometry.flexspline.length - 1e-9
    ]
    for index, point in ends:
        partners = [other for other, at in ends if abs(other - index) < 1e-9 and abs(at - point) < 1e-8]
        assert len(partners) == 2
