"""The form's sections, walked out of the design's schema."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from inspect import cleandoc
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from strainwave.design import Design
from strainwave.design.bodies import KEYS as SIZES
from strainwave.design.faults import tables_of
from strainwave.design.keys import joined, parts_of
from strainwave.design.parameters import plain_annotation
from strainwave.quantities import Quantity
from strainwave.spec import Spec
from strainwave.studio.form.field import Field, label_of, value_at

SHARED = "gear"
CUP = "sizes"
TITLES = {SHARED: "Module and teeth", CUP: "Cup and ring sizes"}
# What one tunes most comes first; groups that are not named here follow.
ORDER = ("wave_generator", SHARED, "flexspline.profile", "circular_spline.profile", CUP)
CLOSED = (CUP,)
# The name stands in the page's header.
ELSEWHERE = ("name",)


@dataclass(frozen=True)
class Kind:
    """A kind of wave generator or tooth profile."""

    name: str
    description: str


@dataclass(frozen=True)
class Group:
    """A section: the numbers that one table, or several without a kind, hold."""

    name: str
    """The dotted key of its table, or `SHARED` or `CUP`."""
    title: str
    fields: tuple[Field, ...]
    kinds: tuple[Kind, ...] = ()
    """Those that the table may have; none where it has no kind."""
    kind: str = ""
    is_open: bool = True

    @property
    def kind_key(self) -> str:
        """The key that says which kind the table is."""
        return joined(self.name, "kind")


def groups_of(draft: Mapping[str, Any], root: type[Spec] = Design) -> tuple[Group, ...]:
    """The sections of the form for a draft: of tables with a kind, the fields of the kind that the draft has."""
    keys = [key for key, tables in _tables(root) if "" not in tables]
    return _groups(root, tuple((key, str(value_at(draft, joined(key, "kind")))) for key in keys))


@lru_cache(maxsize=256)
def fields_of(key: str, kind: str, root: type[Spec] = Design) -> tuple[Field, ...]:
    """The fields of the table at `key` where it is of `kind`; none where there is no such kind."""
    table = dict(_tables(root))[key].get(kind)
    return tuple(_fields(table, key)) if table else ()


@lru_cache(maxsize=256)
def _groups(root: type[Spec], kinds: tuple[tuple[str, str], ...]) -> tuple[Group, ...]:
    tables = dict(_tables(root))
    groups = [_table_group(key, tables[key], kind, fields_of(key, kind, root)) for key, kind in kinds]
    plain = [field for key, classes in tables.items() if "" in classes for field in _fields(classes[""], key)]
    seen_twice = {name for name in map(_last_name, plain) if [*map(_last_name, plain)].count(name) > 1}
    plain = [_prefixed(field) if _last_name(field) in seen_twice else field for field in plain]
    for name in (SHARED, CUP):
        fields = tuple(field for field in plain if field.key not in ELSEWHERE and (field.key in SIZES) == (name == CUP))
        groups.append(Group(name, TITLES[name], fields, is_open=name not in CLOSED))
    ranks = {name: rank for rank, name in enumerate(ORDER)}
    return tuple(sorted(groups, key=lambda group: ranks.get(group.name, len(ranks))))


def _tables(table: type[Spec], key: str = "") -> Iterator[tuple[str, dict[str, type[Spec]]]]:
    """Every table of the design with the classes that it may be, by kind; without a kind it is "" alone."""
    yield key, {"": table}
    for name, info in table.model_fields.items():
        inner = tables_of(info.annotation) if not _is_array(info) else {}
        if "" in inner:
            yield from _tables(inner[""], joined(key, name))
        elif inner:
            yield joined(key, name), inner


def _table_group(key: str, tables: dict[str, type[Spec]], kind: str, fields: tuple[Field, ...]) -> Group:
    kinds = tuple(Kind(name, cleandoc(table.__doc__ or "").split("\n\n")[0]) for name, table in tables.items())
    title = key.replace(".", " ").replace("_", " ").capitalize()
    return Group(key, title, fields, kinds, kind, is_open=key not in CLOSED)


def _fields(table: type[Spec], key: str) -> Iterator[Field]:
    """The leaves of a table: needed ones first, then those with a default, then those that may be left out; of these
    what the kind has of its own comes before what all kinds have."""
    own = table.__annotations__

    def rank(name: str) -> tuple[int, bool]:
        info = table.model_fields[name]
        place = 0 if info.is_required() else 1 if info.default is not None else 2
        return place, place == 2 and name not in own

    for name in sorted(table.model_fields, key=rank):
        info = table.model_fields[name]
        if name != "kind" and (_is_array(info) or not tables_of(info.annotation)):
            yield from _entries(joined(key, name), info)


def _entries(key: str, info: FieldInfo) -> Iterator[Field]:
    annotation, metadata = plain_annotation(info.annotation, info.metadata)
    example = info.examples[0] if info.examples else None

    def entry(key: str, entry: Any, **more: Any) -> Field:
        default = None if info.is_required() else info.default
        label = label_of(parts_of(key))
        return Field(key, label, info.description or "", entry, default=default, is_required=info.is_required(), **more)

    items = get_args(annotation)
    if quantity := _quantity(metadata):
        yield entry(key, "number", quantity=quantity, example=example)
    elif get_origin(annotation) is tuple and items[-1] is not Ellipsis:
        for place, item in enumerate(items):
            quantity = _quantity(plain_annotation(item, ())[1])
            yield entry(joined(key, place), "number", quantity=quantity, example=example[place] if example else None)
    elif get_origin(annotation) is tuple:
        yield entry(key, "array", example=example)
    elif get_origin(annotation) is Literal:
        yield entry(key, "choice", choices=tuple(map(str, items)), example=example)
    else:
        yield entry(key, "text", example=example)


def _is_array(info: FieldInfo) -> bool:
    return get_origin(plain_annotation(info.annotation, ())[0]) is tuple


def _quantity(metadata: Any) -> Quantity | None:
    return next((item for item in metadata if isinstance(item, Quantity)), None)


def _last_name(field: Field) -> str:
    return field.key.rpartition(".")[2]


def _prefixed(field: Field) -> Field:
    """With its table's name before its own, as another table has one of the same name."""
    table = field.key.rpartition(".")[0]
    return replace(field, label=label_of(parts_of(field.key), prefix=table))
