"""The numbers of a design file, each with its unit and what it means."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, get_args

from strainwave.errors import shown_text
from strainwave.quantities import Angle, Quantity
from strainwave.report.block import Table
from strainwave.spec import Spec
from strainwave.units import format_angle

if TYPE_CHECKING:
    from strainwave.design import Design

# Coefficients and samples beyond this are counted.
MOST_ITEMS = 6


def parameters(design: Design) -> Table:
    """Every number that the design file gives, and the sizes that follow from what it leaves out."""
    rows = (*_rows(design, ""), *_following(design))
    return Table("Design", ("number", "value", "unit", "what it is"), rows, numeric=False)


def _rows(table: Spec, prefix: str) -> Iterator[tuple[str, ...]]:
    """A table's own numbers, then those of the tables in it."""
    inner = []
    for name, field in type(table).model_fields.items():
        value = getattr(table, name)
        if isinstance(value, Spec):
            inner.append((name, value))
        elif value is not None and name != "name":
            quantity = _quantity(field.annotation, field.metadata)
            unit = quantity.unit if quantity is not None else ""
            yield f"{prefix}{name}", _shown(value, quantity), unit, field.description or ""
    for name, value in inner:
        yield from _rows(value, f"{prefix}{name}.")


def _following(design: Design) -> Iterator[tuple[str, ...]]:
    """What is taken where the design file says nothing, and what follows from the numbers of teeth."""
    yield "ratio", f"{design.ratio:.6g}".replace("-", "−"), "", "Input over output speed, circular spline fixed"
    yield "pitch radius, flexspline", f"{design.flexspline_pitch_radius_mm:.6g}", "mm", "m z / 2"
    yield "pitch radius, circular spline", f"{design.circular_spline_pitch_radius_mm:.6g}", "mm", "m z / 2"
    if design.flexspline.neutral_radius is None:
        yield "neutral radius", f"{design.neutral_radius_mm:.6g}", "mm", "The middle of the wall"
    for key, value, meaning in (
        ("flexspline.face_width", design.flexspline_face_width_mm, "Length of the flexspline's teeth"),
        ("flexspline.cup_length", design.cup_length_mm, "From the diaphragm's outer face to the open end"),
        ("flexspline.diaphragm_thickness", design.diaphragm_thickness_mm, "Thickness of the cup's bottom"),
        ("flexspline.boss_diameter", design.boss_diameter_mm, "Boss in the middle of the diaphragm"),
        ("circular_spline.face_width", design.circular_spline_face_width_mm, "Length of the circular spline"),
        ("circular_spline.outer_diameter", design.circular_spline_outer_diameter_mm, "Outer diameter of the ring"),
    ):
        table, name = key.split(".")
        if getattr(getattr(design, table), name) is None:
            yield f"{key} (usual)", f"{value:.4g}", "mm", meaning


def _shown(value: Any, quantity: Quantity | None) -> str:
    if isinstance(value, tuple):
        if len(value) > MOST_ITEMS or any(isinstance(item, Spec) for item in value):
            return f"{len(value)} of them"
        return f"[{', '.join(_shown(item, quantity) for item in value)}]"
    if isinstance(quantity, Angle):
        text = format_angle(value)
        return text if "'" in text else f"{value:g}"
    if isinstance(value, float | int) and not isinstance(value, bool):
        return f"{value:.10g}".replace("-", "−")
    return shown_text(str(value))


def _quantity(annotation: Any, metadata: Any) -> Quantity | None:
    """The kind of number that a field holds, also inside arrays and where it may be left out."""
    for item in (*metadata, *getattr(annotation, "__metadata__", ())):
        if isinstance(item, Quantity):
            return item
    return next(filter(None, (_quantity(inner, ()) for inner in get_args(annotation))), None)
