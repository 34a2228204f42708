"""A design space says what it means for a design, and everything that is wrong with it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.studies.exploration import Plan, Space, load_space
from tests.designs import case
from tests.studies.exploration.runs import OFFSET, ROLLER, SPACE_FILE, W0, space_of


def plan(space: Space, design: Design | None = None, **changes: Any) -> Plan:
    question = {"seed": 1, "metrics": None, "in_motion": False, "threshold_um": 10.0, "chunk_rows": None, **changes}
    return Plan.of(design or case("cosine-calibrated"), space, 1000, **question)


def faults(space: Space, design: Design | None = None) -> list[str]:
    with pytest.raises(DesignError) as caught:
        plan(space, design)
    return [str(fault) for fault in caught.value.faults]


def test_each_generator_is_a_base_design_with_the_parameters_it_has() -> None:
    cosine, four_roller, dual_disk = plan(load_space(SPACE_FILE)).categories
    assert [each.label for each in (cosine, four_roller, dual_disk)] == ["cosine", "four-roller", "dual-disk"]
    assert cosine.design == case("cosine-calibrated")  # the design's own, as it is there
    assert cosine.places == dual_disk.places == (0, 1, 2, 3)
    assert four_roller.places == (0, 1, 2, 3, 4)
    generator = dual_disk.design.to_dict()["wave_generator"]
    assert generator == {"kind": "dual-disk", "w0": 0.848, "wrap_angle": 13.0, "neutral_curve": "first-order"}
    assert dual_disk.design.replace("wave_generator", cosine.design.to_dict()["wave_generator"]) == cosine.design


def test_without_generators_the_designs_own_is_the_only_one() -> None:
    (only,) = plan(space_of(wave_generator__roller_angle=(15, 25)), case("four-roller")).categories
    assert (only.label, only.design) == ("four-roller", case("four-roller"))


def test_generators_of_one_kind_are_told_apart() -> None:
    table = {"kind": "table", "fourier": [0.0, 1.0]}
    space = space_of(
        {"kind": "four-roller", "roller_angle": 15.0}, {"kind": "four-roller", "roller_angle": 25.0}, {"kind": "cosine"}
    )
    assert [each.label for each in plan(space).categories] == ["four-roller 15°", "four-roller 25°", "cosine"]
    space = space_of(table, {"kind": "table", "fourier": [0.0, 0.95, 0.05]})
    assert [each.label for each in plan(space).categories] == ["table 1", "table 2"]
    space = space_of({"kind": "cosine", "neutral_curve": "inextensible"}, {"kind": "cosine"})
    assert [each.label for each in plan(space).categories] == ["cosine inextensible", "cosine first-order"]


def test_ranges_are_in_the_units_of_the_design_file() -> None:
    space = space_of(flexspline__profile__flank_angle=("7°30'", "8.5"))
    (parameter,) = plan(space).parameters
    assert (parameter.low, parameter.high, parameter.unit) == (7.5, 8.5, "degrees")


def test_every_fault_of_a_space_is_named_at_once() -> None:
    space = Space.from_dict(
        {
            "parameters": [
                {"parameter": "wave_generator.w1", "low": 1, "high": 2},
                {"parameter": OFFSET, "low": 0.01, "high": -0.01},
                {"parameter": W0, "low": 0.8, "high": 0.9},
                {"parameter": W0, "low": 0.8, "high": 0.9},
                {"parameter": ROLLER, "low": 10, "high": 20},
                {"parameter": "flexspline.teeth", "low": 200, "high": 210},
            ]
        }
    )
    wrong_key, wrong_order, twice, of_no_generator, teeth = faults(space)
    assert wrong_key.startswith("parameters[0]: wave_generator.w1")
    assert wrong_order.startswith("parameters[1]: flexspline.profile.offset = 0.01 mm: must be below the upper end")
    assert twice == 'parameters[3] = "wave_generator.w0": is given twice'
    assert of_no_generator.startswith("parameters[4]: wave_generator.roller_angle")
    assert teeth.startswith("parameters[5]: flexspline.teeth: cannot vary in a batch")


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ({"kind": "cosine", "w0": 0.9}, "generators[1].w0 = 0.9 mm: is shared by all generators. Leave it out"),
        ({"kind": "four-roller", "roller_angle": 95}, "generators[1].roller_angle = 95 degrees: must be"),
        ({"kind": "six-roller"}, "generators[1]: there is no wave generator of kind"),
        ({"roller_angle": 15}, "generators[1].kind: is missing"),
        ({"kind": "two-roller"}, "generators[1]: is there twice"),
    ],
)
def test_a_generator_that_cannot_be_is_named(table: dict[str, Any], message: str) -> None:
    (fault,) = faults(space_of({"kind": "two-roller"}, table))
    assert fault.startswith(message)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is empty: it holds no design space"),
        ("parameters = []", "parameters: must hold at least one table"),
        ('[[parameters]]\nparameter = "wave_generator.w0"\nlow = 1', "parameters[0].high: is missing"),
        (
            '[[parameters]]\nparameter = "a"\nlow = true\nhigh = 1',
            "parameters[0].low = true: must be a number, or text",
        ),
        ('generator = ["cosine"]\n[[parameters]]\nparameter = "a"\nlow = 0\nhigh = 1', "generator: is not a key of"),
    ],
)
def test_a_file_that_is_no_space_says_why(text: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "space.toml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(DesignError) as caught:
        load_space(file)
    assert str(caught.value).startswith(f"{file}: {message}")


def test_a_plan_in_words_is_the_same_plan() -> None:
    asked = plan(load_space(SPACE_FILE), metrics=["min_backlash_um"], in_motion=True, seed=3)
    again = Plan.from_dict(asked.as_dict())
    assert again == asked
    assert again.study == asked.study != plan(load_space(SPACE_FILE), seed=4).study


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"chunk_rows": 1000}, "chunk_rows must be a power of two, not 1000; the next is 1024"),
        ({"chunk_rows": 2}, "chunk_rows must be a whole number from 64 to 1048576, not 2"),
        ({"seed": -1}, "seed must be a whole number from 0 to"),
        ({"metrics": ["backlash"]}, "metrics must be a list of min_backlash_um"),
        ({"threshold_um": 0.0}, "the threshold must be a positive number"),
    ],
)
def test_numbers_that_cannot_be_are_refused(change: dict[str, Any], message: str) -> None:
    with pytest.raises(StrainwaveError, match=message.replace("(", r"\(")):
        plan(load_space(SPACE_FILE), **change)
