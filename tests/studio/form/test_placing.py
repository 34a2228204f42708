"""Where faults stand."""

from __future__ import annotations

import pytest

from strainwave.design import Design
from strainwave.errors import DesignError, Fault
from strainwave.geometry import PROFILE_FAULTS
from strainwave.studio.form.group import groups_of
from strainwave.studio.form.placing import placed, words_beside
from tests.designs import case, circular_spline_as_pieces

RING = "circular_spline.profile"


@pytest.mark.parametrize(
    ("key", "field"),
    [
        ("wave_generator.w0", "wave_generator.w0"),
        (f"{RING}.tip_arc_center[1]", f"{RING}.tip_arc_center[1]"),
        ("flexspline.teeth", "flexspline.teeth"),
    ],
)
def test_a_fault_stands_beside_its_field(key: str, field: str) -> None:
    fault = Fault(key, problem="is wrong")
    found = placed([fault], groups_of(case().to_dict()))
    assert found.fields == {field: [fault]}
    assert not found.groups
    assert not found.loose


def test_a_fault_within_an_array_stands_beside_the_array() -> None:
    design = case().replace(RING, circular_spline_as_pieces())
    fault = Fault(f"{RING}.pieces[1].radius", problem="is wrong")
    assert placed([fault], groups_of(design.to_dict())).fields == {f"{RING}.pieces": [fault]}


def test_a_fault_of_a_table_stands_at_its_group_and_others_on_top() -> None:
    faults = [Fault(RING), Fault(f"{RING}.of_another_kind"), Fault("flexspline"), Fault(""), Fault("name")]
    found = placed(faults, groups_of(case().to_dict()))
    assert found.groups == {RING: faults[:2]}
    assert found.loose == faults[2:]


def test_every_fault_that_geometry_finds_has_a_place_beside_something() -> None:
    groups = groups_of(case().to_dict())
    for name, _, _ in PROFILE_FAULTS.values():
        assert not placed([Fault(f"circular_spline.{name}")], groups).loose


def test_the_points_faults_of_a_chain_stand_beside_its_points() -> None:
    tree = case().replace(RING, circular_spline_as_pieces()).to_dict()
    tree["circular_spline"]["profile"]["start"] = [0.4, 0.5]
    with pytest.raises(DesignError) as raised:
        Design.from_dict(tree)
    found = placed(raised.value.faults, groups_of(tree))
    assert f"{RING}.start[0]" in found.fields
    assert not found.loose


def test_words_say_what_is_wrong_and_where_within() -> None:
    fault = Fault(f"{RING}.pieces[1].to", problem="must be an array", remedy="Write one")
    assert words_beside([fault], f"{RING}.pieces") == "[1].to: must be an array. Write one."
    assert words_beside([Fault("module", 3, "mm", "must be less")], "module") == "Must be less."
    assert words_beside([Fault(f"{RING}.start", problem="is off")], f"{RING}.start[0]") == "Is off."
    assert words_beside([], "module") == ""


def test_of_many_faults_the_first_are_said() -> None:
    faults = [Fault(f"wave_generator.samples[{place}]", problem="is wrong") for place in range(10)]
    words = words_beside(faults, "wave_generator.samples")
    assert words == "[0]: is wrong. [1]: is wrong. [2]: is wrong. [3]: is wrong. And 6 more."
