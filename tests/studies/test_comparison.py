"""Comparisons of wave generators: the figures of `analyze`, and suggestions by the documented rule."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest

from strainwave import DesignError, StrainwaveError, analyze
from strainwave.studies import Comparison, Tuning, compare, tune
from strainwave.studies.comparison import DEFAULT_PARAMETERS, with_generator
from strainwave.studies.comparison.labels import labels_of
from strainwave.studies.comparison.suggestion import suggestions
from strainwave.wave_generators import Cosine, DualDisk, FourRoller, Table
from tests.designs import case
from tests.studies.small import WILD, small

W0 = "wave_generator.w0"
MODULE = sys.modules["strainwave.studies.comparison.compare"]  # the package gives the function of that name
ARTICLE = ["four-roller-calibrated", "dual-disk-0848-calibrated"]


@cache
def article() -> Comparison:
    """The article's generators, tuned as it tunes the dual disk."""
    return compare(case("cosine-calibrated"), [case(name) for name in ARTICLE], goal="precision")


def test_the_article_s_summary_table() -> None:
    """Quad-roller general purpose, elliptical cam power transmission, dual-disk at 0.848 mm not viable, and at its own
    w0 (the article's 0.9 mm) precision positioning."""
    found = {(each.kind, each.setting): each for each in article().contenders}
    assert found["cosine", "common"].suggestion == "power transmission"
    assert found["four-roller", "common"].suggestion == "general purpose"
    assert found["dual-disk", "common"].suggestion == "not viable"
    assert found["dual-disk", "tuned"].suggestion == "precision positioning"
    tuned = found["dual-disk", "tuned"].analysis
    assert tuned is not None
    assert tuned.design.wave_generator.w0 == pytest.approx(0.9, abs=0.002)


def test_every_row_has_the_figures_of_its_own_analysis() -> None:
    comparison = article()
    designs = [case("cosine-calibrated"), *map(case, ARTICLE)]
    for contender, design in zip(comparison.at("common"), designs, strict=True):
        assert contender.analysis is not None
        assert contender.analysis.as_dict()["teeth"] == analyze(design).as_dict()["teeth"]
    for contender, design in zip(comparison.at("tuned"), designs, strict=True):
        assert contender.analysis is not None
        assert contender.analysis.design.wave_generator == tune(design).best["precision"].design.wave_generator


def test_left_out_every_kind_with_its_usual_parameters_is_compared() -> None:
    found = compare(small())
    assert [each.kind for each in found.at("common")] == list(DEFAULT_PARAMETERS)
    assert [each.kind for each in found.at("tuned")] == list(DEFAULT_PARAMETERS)
    labels = [each.label for each in found.at("common")]
    assert labels == ["cosine", "ellipse", "two-roller", "four-roller 19.5°", "dual-disk 13°"]
    calibrated = [small("four-roller-calibrated"), small("dual-disk-0848-calibrated")]
    for contender, design in zip(found.at("common")[3:], calibrated, strict=True):
        assert contender.analysis is not None
        assert contender.analysis.design.wave_generator == design.wave_generator


def test_the_common_w0_is_that_of_the_design_or_as_asked() -> None:
    assert article().w0_mm == 0.848
    found = compare(small(), ["two-roller"], w0_mm=0.22)
    used = [each.analysis.design.wave_generator.w0 for each in found.at("common") if each.analysis]
    assert used == [0.22, 0.22]


def test_a_generator_given_twice_is_compared_once() -> None:
    found = compare(small(), ["cosine", case("dual-disk-0848-calibrated"), "dual-disk"])
    assert [each.kind for each in found.at("common")] == ["cosine", "dual-disk"]


def test_what_a_generator_leaves_open_is_as_the_design_has_it() -> None:
    design = case()
    own = with_generator(design, {"kind": "dual-disk", "wrap_angle": 20.0}).wave_generator
    assert own == DualDisk(wrap_angle=20.0, w0=0.848, neutral_curve="first-order")
    assert with_generator(design, "cosine") == design
    shifted = with_generator(design, Cosine(w0=0.9, neutral_curve="shifted")).wave_generator
    assert shifted == Cosine(w0=0.848, neutral_curve="shifted")
    assert with_generator(with_generator(design, "ellipse"), "cosine").wave_generator == Cosine(w0=0.848)


def test_an_unknown_kind_names_those_that_are_known() -> None:
    with pytest.raises(StrainwaveError, match=r'"wheel" with known parameters: cosine, ellipse, two-roller'):
        compare(case(), ["wheel"])
    with pytest.raises(StrainwaveError, match="one of power, precision, balanced"):
        compare(case(), goal="speed")  # type: ignore[arg-type]


def test_where_no_w0_serves_the_tuned_row_says_so() -> None:
    found = compare(small("cosine"), ["cosine"])
    cosine = next(each for each in found.at("tuned") if each.kind == "cosine")
    assert (cosine.analysis, cosine.suggestion) == (None, "not viable")
    assert cosine.problem == "no w0 keeps 0.1 µm in motion"


def test_a_common_w0_that_makes_no_gear_says_why() -> None:
    found = compare(small(), ["cosine"], w0_mm=10.0)
    (common,) = found.at("common")
    assert common.analysis is None
    assert common.problem.startswith("wave_generator.w0 = 10.0 mm: the neutral curve is not a convex loop")
    assert found.at("tuned")[0].suggestion == "power transmission"


@pytest.mark.parametrize(
    ("generator", "w0_mm", "label", "status"),
    [
        # the common w0 lies below the range, and the disk's radius can be wrapped there only
        ({"kind": "dual-disk", "disk_radius": 19.8}, 0.07, "dual-disk R 19.8 mm", "disk-radius-out-of-reach"),
        (WILD, 0.212, "table", "perimeter-not-kept"),
    ],
    ids=["outside the range", "inside the range"],
)
def test_a_generator_that_makes_no_gear_at_any_w0_does_not_stop_the_others(
    generator: dict[str, Any], w0_mm: float, label: str, status: str
) -> None:
    found = compare(small(), [{"neutral_curve": "inextensible", **generator}, "four-roller"], w0_mm=w0_mm)
    (_, common, other), (_, tuned, other_tuned) = (found.at(setting) for setting in ("common", "tuned"))
    assert (common.label, common.suggestion, tuned.suggestion) == (label, "not viable", "not viable")
    assert common.analysis is tuned.analysis is None
    assert common.problem == tuned.problem
    assert common.problem.startswith(f"no w0 from 0.1 to 0.3 mm makes a gear ({status})")
    assert (other.kind, other_tuned.kind) == ("four-roller", "four-roller")
    assert other.analysis is not None
    assert other_tuned.analysis is not None


def test_the_design_s_own_generator_that_makes_no_gear_does_not_stop_the_others() -> None:
    own = small().replace("wave_generator", {**WILD, "w0": 0.212})
    table, cosine = compare(own, ["cosine"]).at("tuned")
    assert table.problem.startswith("no w0 from 0.1 to 0.3 mm makes a gear (perimeter-not-kept)")
    assert cosine.analysis is not None


def test_a_profile_that_cannot_be_stops_all() -> None:
    """Also where the generator, too, makes no gear."""
    pointed = small().replace("flexspline.profile.addendum", 5.0)
    for generator in ("four-roller", WILD):
        with pytest.raises(DesignError, match=r"flexspline\.profile\.addendum = 5\.0 modules: "):
            compare(pointed.replace("wave_generator", with_generator(small(), generator).wave_generator), ["cosine"])


def test_generators_of_one_name_are_told_apart_by_what_differs() -> None:
    disks = [DualDisk(wrap_angle=13.0, w0=1.0, neutral_curve=model) for model in ("first-order", "inextensible")]
    shapes = [Table(fourier=(0.0, 1.0 - last, last), w0=1.0) for last in (0.0, 0.1)]
    named = [*disks, DualDisk(wrap_angle=14.0, w0=1.0), *shapes, Cosine(w0=1.0)]
    assert labels_of(named) == [
        "dual-disk 13° first-order", "dual-disk 13° inextensible", "dual-disk 14°", "table 1", "table 2", "cosine",
    ]  # fmt: skip
    with_bearing = disks[1].model_copy(update={"bearing_height": 12.0})
    assert labels_of([*disks, with_bearing]) == [
        "dual-disk 13° first-order", "dual-disk 13° inextensible 1", "dual-disk 13° inextensible 2",
    ]  # fmt: skip


def test_every_row_has_a_label_of_its_own() -> None:
    wrapped = {"kind": "dual-disk", "wrap_angle": 13.0}
    found = compare(small(), [wrapped, {**wrapped, "neutral_curve": "inextensible"}])
    for setting in ("common", "tuned"):
        labels = [each.label for each in found.at(setting)]
        assert labels == ["cosine", "dual-disk 13° first-order", "dual-disk 13° inextensible"]


def test_a_table_s_own_w0_is_refused() -> None:
    """All are compared at one; the w0 of a design or a generator is passed over, for it must have one."""
    table = {"kind": "four-roller", "roller_angle": 25.0, "w0": 0.22}
    with pytest.raises(
        DesignError, match=r"^wave_generator\.w0 = 0\.22 mm: is shared by all generators\. Leave it out"
    ):
        compare(small(), [table])
    same = with_generator(small(), FourRoller(roller_angle=25.0, w0=0.22, neutral_curve="first-order"))
    assert same == with_generator(small(), {"kind": "four-roller", "roller_angle": 25.0})


@dataclass(frozen=True)
class Figures:
    """What the rule looks at."""

    teeth: int
    evenness_um: float
    minimum_um: float
    index: float


def contender(figures: Figures | None) -> Any:
    if figures is None:
        return SimpleNamespace(analysis=None, teeth_below_lobe=0, evenness_um=float("nan"))
    analysis = SimpleNamespace(
        interference=figures.minimum_um < 0.0,
        threshold_um=10.0,
        min_in_motion_um=figures.minimum_um,
        min_in_motion_index=figures.index,
        gap_curve=SimpleNamespace(last_index=51.0),
    )
    return SimpleNamespace(analysis=analysis, teeth_below_lobe=figures.teeth, evenness_um=figures.evenness_um)


POWER, PRECISION, GENERAL, NOT_VIABLE = (
    "power transmission",
    "precision positioning",
    "general purpose",
    "not viable",
)


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        # the widest zone, or all that are as wide
        ([Figures(60, 2.0, 1.0, 36), Figures(80, 2.0, 1.0, 36)], [GENERAL, POWER]),
        ([Figures(80, 2.0, 1.0, 36), Figures(80, 1.0, 1.0, 36)], [POWER, POWER]),
        # gaps spread further than evenly from 0 to 10 um (2.887) are no even zone
        ([Figures(80, 2.9, 1.0, 36), Figures(60, 2.8, 1.0, 36)], [GENERAL, POWER]),
        ([Figures(80, 2.9, 1.0, 2)], [GENERAL]),
        # interference, or no gear at all, comes first
        ([Figures(80, 1.0, -0.001, 36), None, Figures(20, 1.0, 0.0, 36)], [NOT_VIABLE, NOT_VIABLE, POWER]),
        # the smallest positive minimum, narrow and near the axis
        ([Figures(80, 1.0, 2.0, 36), Figures(40, 3.5, 0.5, 5), Figures(13, 3.0, 0.7, 2)], [POWER, PRECISION, GENERAL]),
        ([Figures(80, 1.0, 2.0, 36), Figures(41, 3.5, 0.5, 5), Figures(13, 3.0, 0.7, 2)], [POWER, GENERAL, GENERAL]),
        ([Figures(80, 1.0, 2.0, 36), Figures(13, 3.5, 0.5, 5.2)], [POWER, GENERAL]),
        ([Figures(80, 1.0, 0.3, 36), Figures(13, 3.5, 0.5, 2)], [POWER, GENERAL]),
        ([Figures(80, 1.0, -1.0, 36), Figures(80, 1.0, 2.0, 36), Figures(13, 3.5, 0.5, 2)],
         [NOT_VIABLE, POWER, PRECISION]),
        # equal within 0.01 um: the nearer to the axis
        ([Figures(80, 1.0, 2.0, 36), Figures(13, 3, 0.101, 2.2), Figures(13, 3, 0.102, 1.9)],
         [POWER, GENERAL, PRECISION]),
        ([Figures(80, 1.0, 2.0, 36), Figures(13, 3, 0.101, 2.2), Figures(13, 3, 0.112, 1.9)],
         [POWER, PRECISION, GENERAL]),
        ([], []),
    ],
)  # fmt: skip
def test_the_rule_of_the_suggestions(rows: list[Figures | None], expected: list[str]) -> None:
    assert suggestions([contender(row) for row in rows]) == expected


def test_one_thread_and_two_find_the_same() -> None:
    one, two = (compare(small(), ["four-roller"], threads=threads) for threads in (1, 2))
    assert one.to_json() == two.to_json()


def test_ctrl_c_keeps_the_generators_that_are_finished(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = 0

    def interrupted_at_the_third(*arguments: Any, **options: Any) -> Tuning:
        nonlocal calls
        calls += 1
        if calls == 3:
            raise KeyboardInterrupt
        return tune(*arguments, **options)

    monkeypatch.setattr(MODULE, "tune", interrupted_at_the_third)
    found = compare(small(), ["four-roller", "dual-disk"])
    assert found.interrupted
    assert [(each.kind, each.setting) for each in found.contenders] == [
        ("cosine", "common"), ("four-roller", "common"), ("cosine", "tuned"), ("four-roller", "tuned"),
    ]  # fmt: skip
    assert json.loads(found.to_json())["interrupted"] is True


def test_ctrl_c_before_anything_is_finished_is_an_interrupt(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any, **__: Any) -> Tuning:
        raise KeyboardInterrupt

    monkeypatch.setattr(MODULE, "tune", interrupted)
    with pytest.raises(KeyboardInterrupt):
        compare(case())


def test_a_contender_shows_what_it_is_good_for() -> None:
    shown = [repr(each) for each in article().contenders]
    assert shown[0] == "<cosine, common w0: power transmission>"
