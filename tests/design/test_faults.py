"""Every fault of a design file at once, each with key, value, unit, what is allowed and what to do."""

from __future__ import annotations

from typing import Any

import pytest

from strainwave.design import Design, loads
from strainwave.errors import DesignError
from tests.designs import case, circular_spline_as_pieces

REMOVED = object()


def tree(**changes: Any) -> dict[str, Any]:
    """The case study's cosine cam with dotted keys (with __ for the dot) set, or taken out, unchecked."""
    result = case().to_dict()
    for key, value in changes.items():
        *parents, last = key.split("__")
        holder = result
        for part in parents:
            holder = holder[part]
        if value is REMOVED:
            del holder[last]
        else:
            holder[last] = value
    return result


def faults(source: dict[str, Any]) -> dict[str, str]:
    with pytest.raises(DesignError) as caught:
        Design.from_dict(source)
    return {fault.key: str(fault) for fault in caught.value.faults}


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            {"module": -0.8},
            "module = -0.8 mm: must be a number from 0.001 to 1000 mm. "
            "Write for example module = 0.8 (Module, pitch diameter over number of teeth)",
        ),
        ({"module": "0.8"}, 'module = "0.8": must be a number from 0.001 to 1000 mm'),
        ({"module": True}, "module = true: must be a number"),
        ({"module": [0.8]}, "module = [0.8]: must be a number"),
        ({"module": 1e308}, "module = 1e+308 mm: must be a number from 0.001 to 1000 mm"),
        ({"module": float("inf")}, "module = inf mm: must be a number"),
        ({"module": float("nan")}, "module = nan mm: must be a number"),
        ({"module": 10**400}, "module = 1000"),
        ({"module": REMOVED}, "module: is missing. Add for example module = 0.8 (Module"),
        ({"name": 3}, "name = 3: must be text"),
        ({"name": "x" * 201}, "must be text of at most 200 characters"),
        ({"flexspline__teeth": 204.0}, "flexspline.teeth = 204.0 teeth: must be a whole number from 10 to 100000"),
        ({"flexspline__teeth": 8}, "flexspline.teeth = 8 teeth: must be a whole number from 10"),
        ({"flexspline__wall_thickness": 0}, "flexspline.wall_thickness = 0 mm: must be a number from 0.0001"),
        ({"flexspline__wall_thickness": 81.0}, "must be below the flexspline's root radius of 80.6304 mm"),
        ({"flexspline__neutral_radius": 82.4}, "must be below the flexspline's tip radius of 82.32 mm"),
        ({"flexspline": REMOVED}, "flexspline: is missing. Add the table [flexspline] (Elastic external gear)"),
        ({"flexspline": 204}, "flexspline = 204: must be a table"),
        ({"flexspline__profile": []}, "flexspline.profile: must be a table"),
        ({"flexspline__profile__kind": REMOVED}, "flexspline.profile.kind: is missing. Add kind, one of"),
        ({"circular_spline__profile__kind": "arcline"}, '"pieces". Did you mean "arc-line"?'),
        ({"flexspline__profile__kind": 7}, "flexspline.profile.kind = 7: must be one of"),
        ({"flexspline__profile__tip_arc_center": [1]}, "flexspline.profile.tip_arc_center[1]: is missing"),
        ({"flexspline__profile__tip_arc_center": [1, 2, 3]}, "flexspline.profile.tip_arc_center: must hold at most 2"),
        ({"flexspline__profile__tip_arc_center": [1, "2"]}, 'tip_arc_center[1] = "2": must be a number'),
        ({"flexspline__profile__tip_arc_center": 0.5}, "tip_arc_center = 0.5: must be an array"),
        ({"flexspline__profile__flank_angle": "7.5"}, 'flank_angle = "7.5": must be a number of degrees or text'),
        ({"flexspline__profile__flank_angle": 90}, "flank_angle = 90 degrees: must be an angle"),
        ({"flexspline__profile__offset": 1e9}, "offset = 1000000000.0 mm: must be a number from -1000 to 1000 mm"),
        ({"circular_spline__teeth": 205}, "must exceed flexspline.teeth = 204 by 2 or another even number"),
        ({"circular_spline__teeth": 204}, "the difference is 0. Usual is 206"),
        ({"circular_spline__teeth": 202}, "the difference is -2. Usual is 206"),
        ({"wave_generator__w0": 0.0}, "wave_generator.w0 = 0.0 mm: must be a number from 0.0001"),
        ({"wave_generator__neutral_curve": "exact"}, "must be \"inextensible\", \"shifted\" or \"first-order\""),
        ({"tetth": 3}, "tetth: is not a key of the top of the file"),
        ({"Module": 0.8}, "Module: is not a key of the top of the file. Did you mean module?"),
        ({"w0": 0.8}, "w0: is not a key of the top of the file. w0 belongs to [wave_generator]"),
        ({"flexspline__module": 0.8}, "is not a key of [flexspline]. Write it above the first table"),
        ({"flexspline__tetth": 3}, "flexspline.tetth: is not a key of [flexspline]. Did you mean teeth?"),
        ({"flexspline__profile__x": 3}, "Known there: kind, addendum, dedendum"),
        ({"wave_generator__a\nb": 3}, '"a\\nb": is not a key of [wave_generator]'),
        (
            {"wave_generator": {"kind": "dual-disk", "w0": 0.848, "disk_radius": 70.0}},
            "disk_radius = 70.0 mm: must lie from 76.2018",
        ),
        (
            {"wave_generator": {"kind": "ellipse", "w0": 0.848, "cam_to_neutral": 79.9}},
            "cam_to_neutral = 79.9 mm: must be below the neutral radius of 79.8304 mm",
        ),
    ],
)  # fmt: skip
def test_one_fault_is_named_in_full(changes: dict[str, Any], expected: str) -> None:
    found = faults(tree(**changes))
    assert len(found) == 1
    assert expected in next(iter(found.values()))


def test_every_fault_of_a_file_is_reported_at_once_also_between_tables() -> None:
    """Unknown, missing, mistyped and impossible keys, an unknown kind, and an odd difference of teeth."""
    bad = tree(
        module=-0.8,
        modul=0.8,
        name=REMOVED,
        flexspline__teeth=203,
        flexspline__colour="red",
        flexspline__wall_thickness=REMOVED,
        flexspline__profile__addendum="high",
        flexspline__profile__tip_arc_center=[0.0, float("nan")],
        circular_spline__profile__kind="arc-lin",
        circular_spline__profile__dedendum=-1.0,
        wave_generator={"kind": "spline", "w0": -1},
    )
    assert set(faults(bad)) == {
        "module",
        "modul",
        "flexspline.colour",
        "flexspline.wall_thickness",
        "flexspline.profile.addendum",
        "flexspline.profile.tip_arc_center[1]",
        "circular_spline.profile.kind",
        "circular_spline.profile.dedendum",
        "circular_spline.teeth",
        "wave_generator.kind",
        "wave_generator.w0",
    }


def test_a_misspelt_kind_does_not_hide_the_faults_of_the_table_that_was_meant() -> None:
    found = faults(tree(wave_generator={"kind": "dual-disc", "w0": 0.8, "wrap_angle": 99, "disc_radius": 1}))
    assert set(found) == {"wave_generator.kind", "wave_generator.wrap_angle", "wave_generator.disc_radius"}
    assert "from 0 to 80 degrees" in found["wave_generator.wrap_angle"]
    assert "Did you mean disk_radius?" in found["wave_generator.disc_radius"]


def test_of_a_table_of_unknown_kind_only_what_is_wrong_in_every_kind_is_reported() -> None:
    found = faults(tree(wave_generator={"kind": "magic", "w0": -1, "roller_angle": 19.5, "spell": 3}))
    assert set(found) == {"wave_generator.kind", "wave_generator.w0", "wave_generator.spell"}


def test_a_faulty_value_is_not_judged_twice() -> None:
    """A tooth number that is no number says so, and nothing about the difference."""
    assert set(faults(tree(flexspline__teeth="many"))) == {"flexspline.teeth"}
    assert set(faults(tree(circular_spline__teeth=-206))) == {"circular_spline.teeth"}


def test_the_file_is_named_with_its_faults() -> None:
    with pytest.raises(DesignError, match=r"^gear\.toml: 4 faults\n  - module: is missing"):
        loads('name = "x"', "gear.toml")


def pieces(**changes: Any) -> dict[str, Any]:
    return tree(circular_spline__profile=circular_spline_as_pieces() | changes)


def test_a_chain_begins_on_the_addendum_circle_and_ends_on_the_root_circle() -> None:
    """On the internal gear y grows inwards: raising the start by 0.002 modules lifts it above the addendum circle."""
    assert Design.from_dict(pieces()).circular_spline.profile.kind == "pieces"
    x, y = circular_spline_as_pieces()["start"]
    found = faults(pieces(start=[x, y + 0.002], pieces=[{**piece, "corner": True} for piece in pieces_list()]))
    assert set(found) == {"circular_spline.profile.start"}
    assert (
        "must lie on the addendum circle within 0.001 modules, and lies 0.002" in found["circular_spline.profile.start"]
    )
    assert "above it" in found["circular_spline.profile.start"]


def pieces_list() -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = circular_spline_as_pieces()["pieces"]
    return found


def test_a_chain_that_ends_short_of_the_root_circle_says_by_how_much() -> None:
    found = faults(pieces(dedendum=1.16))
    assert set(found) == {"circular_spline.profile.pieces[1].to"}
    assert "lies 0.010" in found["circular_spline.profile.pieces[1].to"]
    assert "above it" in found["circular_spline.profile.pieces[1].to"]


def test_a_chain_on_the_flexspline_is_measured_from_inside() -> None:
    """The circles of the flexspline bend the other way, so the circular spline's chain misses both by its sagitta."""
    chain = circular_spline_as_pieces()
    found = faults(tree(flexspline__profile=chain))
    x = chain["start"][0]
    lift = x**2 / 204.0 + x**2 / 206.0  # parabolas of both circles
    assert f"lies {lift:.3f}" in found["flexspline.profile.start"]
    assert "above it" in found["flexspline.profile.start"]


def test_joins_are_named_with_their_piece() -> None:
    chain = pieces_list()
    chain[1]["to"][0] += 0.01
    found = faults(pieces(pieces=chain))
    assert "turns by" in found["circular_spline.profile.pieces[1]"]
    assert "corner = true" in found["circular_spline.profile.pieces[1]"]


def test_a_faulty_piece_is_named_with_its_place() -> None:
    chain = pieces_list()
    chain[0]["radios"] = 1.0
    chain[1]["to"] = [0.0]
    assert set(faults(pieces(pieces=chain))) == {
        "circular_spline.profile.pieces[0].radios",
        "circular_spline.profile.pieces[1].to[1]",
    }
