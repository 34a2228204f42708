"""What the design takes for a size that is left out."""

from __future__ import annotations

import math

from strainwave.design import Design
from strainwave.studio.form.field import Field
from strainwave.studio.form.typed import number_text
from strainwave.wave_generators import DualDisk
from strainwave.wave_generators.dual_disk import disk_radius_of, wrap_angle_of

# Of these the design gives one; giving the other takes it out.
ALTERNATIVES = (
    ("wave_generator.disk_radius", "wave_generator.wrap_angle"),
    ("wave_generator.samples", "wave_generator.fourier"),
)


def usual(field: Field, design: Design) -> float | None:
    """The number that a left-out key comes to in `design`; None where nothing takes its place.

    A design has it under the key's name with its unit, and the table's name before it where two tables have one.
    """
    if field.quantity is None or field.default is not None:
        return None if field.quantity is None else float(field.default)
    table, _, name = field.key.rpartition(".")
    for attribute in (f"{table}_{name}_mm", f"{name}_mm"):
        found = getattr(design, attribute, None)
        if isinstance(found, float):
            return found
    return _of_disks(field.key, design)


def usual_text(field: Field, design: Design) -> str:
    """The same as an empty entry shows it."""
    number = usual(field, design)
    return "" if number is None else number_text(float(f"{number:.6g}"))


def alternatives(key: str) -> tuple[str, ...]:
    """The keys that cannot be given together with this one."""
    return tuple(other for group in ALTERNATIVES if key in group for other in group if other != key)


def _of_disks(key: str, design: Design) -> float | None:
    """Wrap angle and disk radius follow from each other."""
    generator, radius = design.wave_generator, design.neutral_radius_mm
    if not isinstance(generator, DualDisk):
        return None
    if key == "wave_generator.disk_radius" and generator.wrap_angle is not None:
        return float(disk_radius_of(math.radians(generator.wrap_angle), radius, generator.w0))
    if key == "wave_generator.wrap_angle" and generator.disk_radius is not None:
        return math.degrees(float(wrap_angle_of(generator.disk_radius, radius, generator.w0)))
    return None
