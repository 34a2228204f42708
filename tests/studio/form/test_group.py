"""The form's fields against the JSON schema, which is another walk of the same models."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from strainwave.design import Design, json_schema, load
from strainwave.studio.form.field import Field, value_at
from strainwave.studio.form.group import CUP, ELSEWHERE, SHARED, Group, fields_of, groups_of
from tests.designs import CASE_STUDY, case

READY = [*CASE_STUDY.glob("*.toml"), *(CASE_STUDY.parent / "involute").glob("*.toml")]
SCHEMA = json_schema()


def _plain(schema: dict[str, Any]) -> dict[str, Any]:
    """A schema without its reference, and without the null of what may be left out."""
    if "$ref" in schema:
        schema = schema | SCHEMA["$defs"][schema["$ref"].rpartition("/")[2]]
    options = [option for option in schema.get("anyOf", []) if option.get("type") not in ("null", "string")]
    return (
        _plain({name: value for name, value in schema.items() if name != "anyOf"} | options[0]) if options else schema
    )


def _leaves(schema: dict[str, Any], kinds: dict[str, str], key: str = "") -> Iterator[tuple[str, dict[str, Any], bool]]:
    """Dotted key, schema and need of every value of a design whose tables have the given kinds."""
    for name, inner in schema["properties"].items():
        here = f"{key}.{name}" if key else name
        plain = _plain(inner)
        if mapping := plain.get("discriminator", {}).get("mapping"):
            plain = _plain({"$ref": mapping[kinds[here]]})
        if plain.get("type") == "object":
            yield from _leaves(plain, kinds, here)
        elif plain.get("prefixItems"):
            for place, item in enumerate(plain["prefixItems"]):
                yield f"{here}[{place}]", item, name in schema.get("required", [])
        elif name != "kind":
            yield here, plain, name in schema.get("required", [])


def _kinds(groups: tuple[Group, ...]) -> dict[str, str]:
    return {group.name: group.kind for group in groups if group.kinds}


def _every_kind() -> list[dict[str, Any]]:
    """Drafts that have, between them, every kind of every table."""
    tree = case().to_dict()
    drafts = []
    for group in groups_of(tree):
        for kind in group.kinds:
            draft = Design.from_dict(tree).to_dict()
            value_at(draft, group.name)["kind"] = kind.name
            drafts.append(draft)
    return drafts


@pytest.mark.parametrize("draft", [*(load(file).to_dict() for file in READY), *_every_kind()])
def test_every_value_of_a_design_is_a_field_as_the_schema_has_it(draft: dict[str, Any]) -> None:
    groups = groups_of(draft)
    fields = {field.key: field for group in groups for field in group.fields}
    leaves = {key: (schema, needed) for key, schema, needed in _leaves(SCHEMA, _kinds(groups)) if key not in ELSEWHERE}
    assert fields.keys() == leaves.keys()
    for key, (schema, needed) in leaves.items():
        field = fields[key]
        assert field.is_required == needed
        if schema.get("type") in ("number", "integer"):
            assert field.entry == "number"
            assert (field.unit_word, field.least) == (schema["unit"], schema["minimum"])
            assert field.greatest == pytest.approx(schema.get("maximum", schema.get("exclusiveMaximum")), rel=1e-3)
            assert ("exclusiveMaximum" in schema) == (field.greatest < schema.get("exclusiveMaximum", -1e9))
            assert field.is_whole == (schema["type"] == "integer")
        elif "enum" in schema:
            assert (field.entry, field.choices) == ("choice", tuple(schema["enum"]))
        else:
            assert (field.entry, schema["type"]) == ("array", "array")


def test_a_kind_shows_its_own_parameters_only() -> None:
    assert "wave_generator.roller_angle" in {field.key for field in fields_of("wave_generator", "four-roller")}
    assert "wave_generator.roller_angle" not in {field.key for field in fields_of("wave_generator", "two-roller")}
    assert "wave_generator.neutral_curve" not in {field.key for field in fields_of("wave_generator", "ellipse")}
    assert fields_of("wave_generator", "no such kind") == ()


def test_the_generator_comes_first_and_the_cups_sizes_are_closed() -> None:
    groups = groups_of(case().to_dict())
    assert [group.name for group in groups] == [
        "wave_generator", SHARED, "flexspline.profile", "circular_spline.profile", CUP,
    ]  # fmt: skip
    assert [group.name for group in groups if not group.is_open] == [CUP]
    assert groups[0].fields[0].key == "wave_generator.w0"
    assert [kind.name for kind in groups[0].kinds] == [
        "cosine", "ellipse", "two-roller", "four-roller", "dual-disk", "table",
    ]  # fmt: skip


def test_labels_tell_fields_of_one_section_apart() -> None:
    for draft in _every_kind():
        for group in groups_of(draft):
            labels = [field.label for field in group.fields]
            assert len(set(labels)) == len(labels)
            assert all(labels)


def _field(key: str) -> Field:
    return next(field for group in groups_of(case().to_dict()) for field in group.fields if field.key == key)


def test_labels_come_from_the_keys() -> None:
    assert _field("wave_generator.w0").label == "w0"
    assert _field("flexspline.profile.tip_arc_center[1]").label == "Tip arc centre\u00a0y"
    assert _field("circular_spline.teeth").label == "Circular spline teeth"
    assert _field("flexspline.wall_thickness").label == "Wall thickness"


def test_a_draft_of_an_unknown_kind_still_has_its_choice() -> None:
    draft = case().to_dict()
    draft["wave_generator"]["kind"] = 7
    group = groups_of(draft)[0]
    assert group.fields == ()
    assert len(group.kinds) == 6


def test_design_files_lie_where_they_are_looked_for() -> None:
    assert len(READY) == 9
    assert all(isinstance(file, Path) for file in READY)
