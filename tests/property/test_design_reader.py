"""Whatever a design file holds, it is a design or a DesignError, never another error."""

from __future__ import annotations

import copy
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from strainwave.design import Design, dumps, load, loads, template
from strainwave.design.keys import joined, leaves
from strainwave.errors import MOST_FAULTS_SHOWN, DesignError
from strainwave.geometry import Geometry
from tests.designs import CASES, case, circular_spline_as_pieces

DESIGNS = [
    *(case(name) for name in CASES),
    case().replace("circular_spline.profile", circular_spline_as_pieces()),
    case().replace("wave_generator", {"kind": "table", "w0": 0.8, "samples": [1.0, 0.1, -1.1]}),
    case().replace("wave_generator", {"kind": "dual-disk", "w0": 0.8, "disk_radius": 77.2}),
    case().replace("wave_generator", {"kind": "ellipse", "w0": 0.8, "cam_to_neutral": 12.8}),
]
SCALARS = st.one_of(
    st.integers(),
    st.integers(-(10**400), 10**400),
    st.floats(),
    st.booleans(),
    st.text(max_size=20),
    st.dates(),
    st.times(),
    st.datetimes(),
    st.sampled_from(["cosine", "dual-disk", "arc-line", "pieces", "7°30'", "7°60'", 0, -0.0, 5e-324, 1e308]),
)
KEYS = st.one_of(
    st.text(max_size=12), st.sampled_from(["kind", "teeth", "w0", "profile", "module", "radius", "samples"])
)
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(KEYS, inner, max_size=4)),
    max_leaves=8,
)


def places(tree: Any) -> list[tuple[Any, Any]]:
    """Every holder in a tree with each of its keys or indices."""
    if isinstance(tree, dict):
        return [place for key in tree for place in [(tree, key), *places(tree[key])]]
    if isinstance(tree, list):
        return [place for index in range(len(tree)) for place in [(tree, index), *places(tree[index])]]
    return []


def as_lists(tree: Any) -> Any:
    if isinstance(tree, dict):
        return {key: as_lists(value) for key, value in tree.items()}
    return [as_lists(value) for value in tree] if isinstance(tree, list | tuple) else tree


@st.composite
def mutated_trees(draw: st.DrawFn) -> dict[str, Any]:
    """The tree of a valid design with a few values replaced, taken out, renamed or added."""
    tree: dict[str, Any] = copy.deepcopy(as_lists(draw(st.sampled_from(DESIGNS)).to_dict()))
    for _ in range(draw(st.integers(1, 4))):
        holder, key = draw(st.sampled_from(places(tree))) if places(tree) else (tree, "module")
        change = draw(st.sampled_from(["replace", "replace", "take out", "add"]))
        if change == "replace":
            holder[key] = draw(VALUES)
        elif change == "take out" and key in (holder if isinstance(holder, dict) else range(len(holder))):
            del holder[key]
        elif isinstance(holder, dict):
            holder[draw(KEYS)] = draw(VALUES)
    return tree


def design_or_none(tree: dict[str, Any]) -> Design | None:
    try:
        return Design.from_dict(tree, "gear.toml")
    except DesignError as error:
        check(error)
        return None


def check(error: DesignError) -> None:
    """The error says something, on a line a fault, and nothing that a terminal would obey."""
    assert error.faults
    assert all(fault.problem for fault in error.faults)
    lines = str(error).splitlines()
    assert len(lines) == 1 or len(lines) >= len(error.faults[:MOST_FAULTS_SHOWN]) + 1
    assert all(line.isprintable() for line in lines)


@settings(max_examples=400)
@given(mutated_trees())
def test_a_mutated_tree_is_a_design_or_a_design_error(tree: dict[str, Any]) -> None:
    design = design_or_none(tree)
    if design is not None:
        assert loads(dumps(design)) == design
        try:
            Geometry.of(design)
        except DesignError as error:
            check(error)


@settings(max_examples=200)
@given(st.dictionaries(KEYS, VALUES, max_size=6))
def test_any_tree_is_a_design_or_a_design_error(tree: dict[str, Any]) -> None:
    assert design_or_none(tree) is None


@settings(max_examples=200)
@given(st.one_of(st.text(), st.text(alphabet="=[]{}\"'.,\n\\#0123456789abe_-+")))
def test_any_text_is_a_design_or_a_design_error(text: str) -> None:
    with pytest.raises(DesignError):
        loads(text)


@settings(max_examples=200)
@given(st.data())
def test_a_damaged_file_is_a_design_or_a_design_error(data: st.DataObject) -> None:
    text = template()
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, min(len(text), start + 40)))
    try:
        loads(text[:start] + data.draw(st.text(max_size=5)) + text[end:])
    except DesignError as error:
        check(error)


@settings(max_examples=100)
@given(content=st.binary(max_size=200))
def test_any_file_is_a_design_or_a_design_error(content: bytes, tmp_path_factory: pytest.TempPathFactory) -> None:
    path: Path = tmp_path_factory.mktemp("reader") / "gear.toml"
    path.write_bytes(content)
    with pytest.raises(DesignError):
        load(path)


@settings(max_examples=300)
@given(
    st.one_of(
        st.text(max_size=30),
        st.sampled_from([key for key, _ in leaves(DESIGNS[4].to_dict())]),
        st.lists(KEYS, min_size=1, max_size=4).map(".".join),
    ),
    st.one_of(st.none(), VALUES),
)
def test_replace_gives_a_design_or_a_design_error(key: str, value: Any) -> None:
    design = DESIGNS[4]
    try:
        changed = design.replace(key, value)
    except DesignError as error:
        check(error)
    else:
        assert loads(dumps(changed)) == changed


@given(st.sampled_from([key for key, _ in leaves(DESIGNS[4].to_dict())]))
def test_replacing_a_value_by_itself_changes_nothing(key: str) -> None:
    tree = dict(leaves(DESIGNS[4].to_dict()))
    assert DESIGNS[4].replace(key, tree[key]) == DESIGNS[4]


def test_the_leaves_of_a_design_are_named_as_replace_takes_them() -> None:
    names = dict(leaves(DESIGNS[4].to_dict()))
    assert names["circular_spline.profile.pieces[1].corner"] is False
    assert names["flexspline.profile.tip_arc_center[0]"] == -0.3927
    assert joined("a", "b c") == 'a."b c"'
