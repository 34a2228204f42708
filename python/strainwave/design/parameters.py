"""The numbers of a design that can vary over the rows of a batch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import NoneType
from typing import Annotated, Any, get_args, get_origin

from pydantic import ValidationError

from strainwave.design.design import Design
from strainwave.design.faults import faults_of
from strainwave.design.keys import Part, joined, parts_of
from strainwave.errors import DesignError, Fault
from strainwave.quantities import Quantity, WholeNumber
from strainwave.spec import Spec


@dataclass(frozen=True)
class Parameter:
    """A number of a design: its dotted key, and its unit and limits."""

    key: str
    quantity: Quantity


@lru_cache(maxsize=64)  # an optimiser asks the same for every step
def parameters_of(design: Design, keys: tuple[str, ...]) -> tuple[Parameter, ...]:
    """The numbers of `design` at dotted keys. DesignError names every key that leads to none, or is there twice."""
    found: list[Parameter] = []
    faults: list[Fault] = []
    for key in keys:
        try:
            parameter = _parameter(design, key)
        except DesignError as error:
            faults.extend(error.faults)
            continue
        if any(parameter.key == other.key for other in found):
            faults.append(Fault(key, problem="is given twice"))
        found.append(parameter)
    if faults:
        raise DesignError(faults)
    return tuple(found)


def _parameter(design: Design, key: str) -> Parameter:
    try:
        parts = parts_of(key)
    except ValueError as error:
        raise DesignError([Fault(key, problem=str(error))]) from None
    value: Any = design
    annotation: Any = Design
    metadata: Sequence[Any] = ()
    canonical = holding_key = ""
    for part in parts:
        holder, holding_key = value, canonical
        try:
            value, annotation, metadata = _step(value, annotation, part)
        except LookupError:
            raise _nowhere(design, key) from None
        canonical = joined(canonical, part)
    quantity = next((item for item in metadata if isinstance(item, Quantity)), None)
    if quantity is None:
        raise DesignError([Fault(key, problem="is not a number, so it cannot vary in a batch")])
    if isinstance(quantity, WholeNumber):
        remedy = "Evaluate one batch for each number of teeth"
        raise DesignError([Fault(key, problem="cannot vary in a batch", remedy=remedy)])
    if value is None:
        _check_not_shut_out(holder, holding_key, {part: _typical(quantity)})
    return Parameter(canonical, quantity)


def _step(value: Any, annotation: Any, part: Part) -> tuple[Any, Any, Sequence[Any]]:
    """The value that `part` names in a table or an array, its annotation, and what that says about it."""
    if isinstance(value, Spec) and isinstance(part, str):
        field = type(value).model_fields[part]
        return getattr(value, part), *plain_annotation(field.annotation, field.metadata)
    if isinstance(value, tuple) and isinstance(part, int):
        items = get_args(annotation)
        return value[part], *plain_annotation(items[0] if items[-1] is Ellipsis else items[part], ())
    raise LookupError(part)


def plain_annotation(annotation: Any, metadata: Sequence[Any]) -> tuple[Any, Sequence[Any]]:
    """An annotation without `Annotated` and `None`, and the metadata found on the way."""
    if get_origin(annotation) is Annotated:
        inner, *more = get_args(annotation)
        return plain_annotation(inner, (*metadata, *more))
    others = [item for item in get_args(annotation) if item is not NoneType]
    if len(others) == 1 and len(get_args(annotation)) == 2 and get_origin(annotation) is not tuple:
        return plain_annotation(others[0], metadata)
    return annotation, metadata


def _nowhere(design: Design, key: str) -> DesignError:
    """What `replace` has to say about a key that leads nowhere."""
    try:
        design.replace(key, 1.0)
    except DesignError as error:
        return error
    return DesignError([Fault(key, problem="is not the dotted key of a number")])


def _check_not_shut_out(table: Spec, table_key: str, addition: dict[Part, float]) -> None:
    """DesignError where an optional key of a table cannot be given beside what the table has in its place."""
    try:
        type(table).model_validate({**table.model_dump(exclude_none=True), **addition})
    except ValidationError as error:
        raise DesignError(faults_of(error, type(table), table_key)) from None


def _typical(quantity: Quantity) -> float:
    return min(max(1.0, quantity.least), 0.5 * quantity.greatest)
