"""What must hold between the tables of a design.

The rules look at single values, so that a fault elsewhere in the file does not hide what they find.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from strainwave.columns import Floats, Numbers
from strainwave.design.bodies import Bodies
from strainwave.design.bodies_rule import bodies_faults
from strainwave.design.involute_rule import involute_faults
from strainwave.design.keys import leaves
from strainwave.elementwise import hypot
from strainwave.errors import Fault
from strainwave.quantities import MM, MODULES
from strainwave.wave_generators.dual_disk import disk_radius_range, wrappable

N = TypeVar("N", float, Floats)

# A user's chain is cut or extended to the circle where it does not quite end there.
CHAIN_END_TOLERANCE = 1e-3  # modules


def faults_between(tree: Mapping[str, Any], faulty_keys: set[str]) -> list[Fault]:
    """Faults between the values of a design's tree, leaving out the keys already found faulty."""
    known = {key: value for key, value in leaves(tree) if value is not None and key not in faulty_keys}
    return [
        *_tooth_difference(known),
        *_rim(known),
        *_neutral_circle(known),
        *_disk_radius(known),
        *_cam_to_neutral(known),
        *bodies_faults(known, faulty_keys, _bodies(known)),
        *_chain_ends(known, "flexspline", internal=False),
        *_chain_ends(known, "circular_spline", internal=True),
        *involute_faults(known, "flexspline", internal=False),
        *involute_faults(known, "circular_spline", internal=True),
    ]


def neutral_radius(module: N, teeth: int, dedendum: N, wall_thickness: N) -> N:
    """Radius (mm) of the middle of the wall: m z / 2 - h_f* m - wall / 2; a number, or arrays over rows."""
    return root_radius(module, teeth, dedendum) - 0.5 * wall_thickness


def root_radius(module: N, teeth: int, dedendum: N) -> N:
    """Radius (mm) of the flexspline's root circle."""
    return module * (0.5 * teeth - dedendum)


def tip_radius(module: N, teeth: int, addendum: N) -> N:
    """Radius (mm) of the flexspline's tip circle."""
    return module * (0.5 * teeth + addendum)


def ring_root_radius(module: N, teeth: int, dedendum: N) -> N:
    """Radius (mm) of the circular spline's root circle."""
    return module * (0.5 * teeth + dedendum)


def chain_start_distance(x: Numbers, y: Numbers, teeth: int, addendum: Numbers, *, internal: bool) -> Floats:
    """How far (modules) a point of a tooth frame lies above the addendum circle, towards the tooth's tip."""
    return _distance(x, y, teeth, addendum, internal)


def chain_end_distance(x: Numbers, y: Numbers, teeth: int, dedendum: Numbers, *, internal: bool) -> Floats:
    """How far (modules) a point of a tooth frame lies above the root circle, towards the tooth's tip."""
    return _distance(x, y, teeth, -dedendum, internal)


def _distance(x: Numbers, y: Numbers, teeth: int, height: Numbers, internal: bool) -> Floats:
    # y points away from the gear's centre on the flexspline, towards it on the circular spline.
    outward = -1.0 if internal else 1.0
    pitch_radius = 0.5 * teeth
    return outward * (hypot(x, pitch_radius + outward * y) - (pitch_radius + outward * height))


def _numbers(known: Mapping[str, Any], *keys: str) -> list[Any] | None:
    """The values of `keys`, or None unless all are known numbers."""
    values = [known.get(key) for key in keys]
    return values if all(type(value) in (int, float) for value in values) else None


def _tooth_difference(known: Mapping[str, Any]) -> list[Fault]:
    teeth = _numbers(known, "flexspline.teeth", "circular_spline.teeth")
    if teeth is None:
        return []
    flexspline, circular_spline = teeth
    difference = circular_spline - flexspline
    if difference >= 2 and difference % 2 == 0:
        return []
    problem = (
        f"must exceed flexspline.teeth = {flexspline} by 2 or another even number (the wave generator has two lobes); "
        f"the difference is {difference}"
    )
    return [Fault("circular_spline.teeth", circular_spline, "teeth", problem, f"Usual is {flexspline + 2}")]


def _rim_numbers(known: Mapping[str, Any]) -> list[Any] | None:
    return _numbers(known, "module", "flexspline.teeth", "flexspline.profile.dedendum", "flexspline.wall_thickness")


def _rim(known: Mapping[str, Any]) -> list[Fault]:
    numbers = _rim_numbers(known)
    if numbers is None:
        return []
    module, teeth, dedendum, wall = numbers
    greatest = root_radius(module, teeth, dedendum)
    if wall < greatest:
        return []
    problem = f"must be below the flexspline's root radius of {greatest:.6g} mm, for the wall lies under the teeth"
    remedy = "Reduce it, or correct module, flexspline.teeth or flexspline.profile.dedendum"
    return [Fault("flexspline.wall_thickness", wall, MM, problem, remedy)]


def _neutral_circle(known: Mapping[str, Any]) -> list[Fault]:
    keys = "flexspline.neutral_radius", "module", "flexspline.teeth", "flexspline.profile.addendum"
    numbers = _numbers(known, *keys)
    if numbers is None:
        return []
    radius, module, teeth, addendum = numbers
    greatest = tip_radius(module, teeth, addendum)
    if radius < greatest:
        return []
    problem = f"must be below the flexspline's tip radius of {greatest:.6g} mm"
    return [Fault(keys[0], radius, MM, problem, "Leave it out to have the neutral circle in the middle of the wall")]


def _neutral_radius(known: Mapping[str, Any]) -> float | None:
    """The neutral radius as given, or else as the rim has it; None where that cannot be said."""
    if "flexspline.neutral_radius" in known:
        given = _numbers(known, "flexspline.neutral_radius")
        return given[0] if given else None
    rim = _rim_numbers(known)
    return neutral_radius(*rim) if rim else None


def _disk_radius(known: Mapping[str, Any]) -> list[Fault]:
    numbers = _numbers(known, "wave_generator.disk_radius", "wave_generator.w0")
    radius = _neutral_radius(known)
    if known.get("wave_generator.kind") != "dual-disk" or numbers is None or radius is None:
        return []
    disk_radius, w0 = numbers
    if wrappable(disk_radius, radius, w0):
        return []
    least, greatest = disk_radius_range(radius, w0)
    problem = f"must lie from {least:.6f} to {greatest:.6f} mm for w0 = {w0:.12g} mm, R = {radius:.12g} mm"
    remedy = "Give a radius in that range, or wrap_angle in its place"
    return [Fault("wave_generator.disk_radius", disk_radius, MM, problem, remedy)]


def _cam_to_neutral(known: Mapping[str, Any]) -> list[Fault]:
    numbers = _numbers(known, "wave_generator.cam_to_neutral")
    radius = _neutral_radius(known)
    if known.get("wave_generator.kind") != "ellipse" or numbers is None or radius is None or numbers[0] < radius:
        return []
    problem = f"must be below the neutral radius of {radius:.6g} mm, for the cam lies inside the neutral curve"
    return [
        Fault("wave_generator.cam_to_neutral", numbers[0], MM, problem, "Give the bearing's height and half the wall")
    ]


def _bodies(known: Mapping[str, Any]) -> Bodies[float] | None:
    """The sizes of the parts, given or usual; None where that cannot be said."""
    rim = _rim_numbers(known)
    ring = _numbers(known, "circular_spline.teeth", "circular_spline.profile.dedendum")
    if rim is None or ring is None:
        return None
    module, teeth, dedendum, wall = rim
    return Bodies.of(
        known.get,
        pitch_diameter=module * teeth,
        root_radius=root_radius(module, teeth, dedendum),
        wall=wall,
        ring_root_radius=ring_root_radius(module, *ring),
    )


def _chain_ends(known: Mapping[str, Any], spline: str, internal: bool) -> list[Fault]:
    """Faults of a "pieces" profile that does not begin on its addendum circle or end on its root circle."""
    profile = f"{spline}.profile"
    if known.get(f"{profile}.kind") != "pieces":
        return []
    count = 1 + max((i for i in range(len(known)) if f"{profile}.pieces[{i}].to[0]" in known), default=-1)
    ends = [
        (f"{profile}.start", f"{profile}.addendum", "addendum", chain_start_distance),
        (f"{profile}.pieces[{count - 1}].to", f"{profile}.dedendum", "root", chain_end_distance),
    ]
    faults = []
    for key, height_key, circle, distance_of in ends:
        numbers = _numbers(known, f"{spline}.teeth", height_key, f"{key}[0]", f"{key}[1]")
        if numbers is None:
            continue
        teeth, height, x, y = numbers
        distance = float(distance_of(x, y, teeth, height, internal=internal))
        if abs(distance) > CHAIN_END_TOLERANCE:
            problem = (
                f"must lie on the {circle} circle within {CHAIN_END_TOLERANCE:g} {MODULES}, "
                f"and lies {abs(distance):.6f} {MODULES} {'above' if distance > 0 else 'below'} it"
            )
            faults.append(Fault(key, (x, y), MODULES, problem, f"Correct the point or {height_key}"))
    return faults
