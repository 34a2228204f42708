"""Another kind of generator or profile gives a design that can be, near the present one where that has a meaning."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from strainwave.analysis import analyze
from strainwave.design import Design, load
from strainwave.errors import StrainwaveError
from strainwave.studio.form.field import value_at
from strainwave.studio.form.group import groups_of
from strainwave.studio.form.start import start_table
from tests.designs import case
from tests.studio.form.test_group import READY

FLEXSPLINE, RING = "flexspline.profile", "circular_spline.profile"


def _kinds(design: Design) -> list[tuple[str, str]]:
    return [
        (group.name, kind.name)
        for group in groups_of(design.to_dict())
        for kind in group.kinds
        if kind.name != group.kind
    ]


@pytest.mark.parametrize("file", READY, ids=[f"{file.parent.name}/{file.stem}" for file in READY])
def test_every_kind_has_a_start_from_every_ready_design(file: Path) -> None:
    design = load(file)
    kinds = _kinds(design)
    assert len(kinds) == 5 + 3 + 3
    for key, kind in kinds:
        table = start_table(design, key, kind)
        analysis = analyze(design.replace(key, table))
        assert value_at(analysis.design.to_dict(), f"{key}.kind") == kind
        if key == "wave_generator":
            assert analysis.design.wave_generator.w0 == design.wave_generator.w0
            if kind != "ellipse":
                assert table["neutral_curve"] == value_at(design.to_dict(), f"{key}.neutral_curve")


@pytest.mark.parametrize("key", [FLEXSPLINE, RING])
@pytest.mark.parametrize("name", ["case-study/cosine-calibrated", "involute/cosine"])
def test_a_profile_as_pieces_is_the_same_flank(name: str, key: str) -> None:
    design = load(READY[0].parent.parent / f"{name}.toml")
    chained = design.replace(key, start_table(design, key, "pieces"))
    # Joins are tangent within rounding, and the chain ends on the circles; the rest of the design is as it was.
    before, after = analyze(design), analyze(chained)
    assert after.min_backlash_um == pytest.approx(before.min_backlash_um, abs=1e-3)


def test_a_generator_as_a_table_has_the_same_shape() -> None:
    design = case("four-roller")
    table = design.replace("wave_generator", start_table(design, "wave_generator", "table"))
    # A series of 19 terms through the samples follows rollers, whose curvature has corners, less closely than a cosine.
    assert analyze(table).min_backlash_um == pytest.approx(analyze(design).min_backlash_um, abs=0.1)


def test_an_ellipse_as_a_table_is_the_harmonic_nearest_to_it() -> None:
    design = case().replace("wave_generator", {"kind": "ellipse", "w0": 0.848})
    assert start_table(design, "wave_generator", "table")["fourier"] == [0.0, 1.0]


def test_what_the_kinds_have_in_common_is_kept() -> None:
    design = case().replace({"wave_generator.bearing_height": 12.0})
    table = start_table(design, "wave_generator", "four-roller")
    assert table == {
        "kind": "four-roller", "w0": 0.848, "bearing_height": 12.0, "neutral_curve": "first-order",
        "roller_angle": 19.5,
    }  # fmt: skip
    line = start_table(design, FLEXSPLINE, "arc-line")
    assert line["tip_arc_radius"] == design.flexspline.profile.model_dump()["tip_arc_radius"]
    assert line["root_fillet_radius"] == 0.55


def test_what_was_typed_comes_back_but_not_the_former_w0() -> None:
    typed = {"kind": "four-roller", "w0": 0.5, "roller_angle": 25.0, "neutral_curve": "shifted"}
    table = start_table(case(), "wave_generator", "four-roller", typed=typed)
    assert (table["roller_angle"], table["w0"], table["neutral_curve"]) == (25.0, 0.848, "first-order")
    profile = case().flexspline.profile.model_dump() | {"addendum": 0.85}
    involute = case().replace(FLEXSPLINE, start_table(case(), FLEXSPLINE, "involute"))
    assert start_table(involute, FLEXSPLINE, "double-circular-arc", typed=profile) == profile


@pytest.mark.parametrize("nonsense", [{"roller_angle": "much"}, {"roller_angle": 80.0}, {"no_such_key": 1}])
def test_what_was_typed_in_vain_does_not(nonsense: dict[str, Any]) -> None:
    table = start_table(case(), "wave_generator", "four-roller", typed={"kind": "four-roller", **nonsense})
    assert table["roller_angle"] == 19.5


def test_what_another_kind_had_before_comes_back() -> None:
    ellipse = case().replace("wave_generator", {"kind": "ellipse", "w0": 0.848})
    table = start_table(ellipse, "wave_generator", "cosine", seen={"neutral_curve": "shifted", "roller_angle": 20.0})
    assert table == {"kind": "cosine", "w0": 0.848, "neutral_curve": "shifted"}


def test_a_fillet_without_room_is_made_smaller() -> None:
    table = start_table(case("cosine-calibrated"), FLEXSPLINE, "involute")
    assert 0.0 <= table["root_fillet_radius"] < 0.55
    assert (table["dedendum"], table["offset"]) == (1.212, -0.0072)


def few_teeth() -> Design:
    """A flexspline of 20 teeth, whose root circle lies inside the base circle of an involute of 20 degrees."""
    teeth = {"flexspline.teeth": 20, "circular_spline.teeth": 22, "flexspline.profile.root_fillet_radius": 0.2}
    return case().replace({**teeth, "flexspline.wall_thickness": 0.3, "wave_generator.w0": 0.1})


def test_where_no_start_can_be_it_is_said() -> None:
    with pytest.raises(StrainwaveError, match=r"flexspline\.profile\.dedendum .* no involute"):
        start_table(few_teeth(), FLEXSPLINE, "involute")
