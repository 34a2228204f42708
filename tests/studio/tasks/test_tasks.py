"""The studies as tasks give what the studies give, as plain data that another process can send."""

from __future__ import annotations

import json
import math
import pickle
from typing import Any

import pytest

from strainwave.errors import DesignError, StrainwaveError
from strainwave.studies import compare, tune
from strainwave.studies.optimization import optimize
from strainwave.studies.tolerance import Tolerances, analyze_tolerance
from strainwave.studio.jobs import Limits
from strainwave.studio.tasks.comparison import ComparisonRequest, find_comparison
from strainwave.studio.tasks.optimization import OptimizationRequest, find_optimum
from strainwave.studio.tasks.tolerance import ToleranceRequest, find_tolerance
from strainwave.studio.tasks.tuning import TuningRequest, find_tuning
from tests.studies.small import small

W0 = "wave_generator.w0"
TREE = small().to_dict()
TOLERANCES: dict[str, Any] = {"tolerances": [{"parameter": W0, "kind": "normal", "three_sigma": 0.0005}]}
OPTIMUM = OptimizationRequest(TREE, {W0: (0.205, 0.222)}, ("evenness=min",), {}, 10.0, 8, 3, 1)


def heard() -> tuple[list[float], Any]:
    shares: list[float] = []
    return shares, lambda share, words: shares.append(share)


def check_progress(shares: list[float]) -> None:
    assert shares == sorted(shares)
    assert 0.0 < shares[0] <= shares[-1] == 1.0


def test_tuning_is_that_of_the_api() -> None:
    shares, report = heard()
    found = find_tuning(TuningRequest(TREE, 8.0, 0.2), Limits(), report)
    alone = tune(small(), threshold_um=8.0, margin_um=0.2)
    assert found.record == alone.as_dict()
    assert found.verdict == alone.verdict
    assert json.loads(found.figure)["data"]
    check_progress(shares)
    pickle.dumps(found)


def test_tuning_does_not_depend_on_the_own_w0_nor_on_the_name() -> None:
    other = small().replace({W0: 0.23, "name": "another"})
    one, two = TuningRequest(TREE, 10.0, 0.1), TuningRequest(other.to_dict(), 10.0, 0.1)
    assert one.key == two.key
    records = [find_tuning(each, Limits(), lambda share, words: None).record for each in (one, two)]
    for record in records:
        del record["own"], record["name"]
    assert records[0] == records[1]


@pytest.mark.parametrize("changes", [{"module": 0.21}, {"flexspline.profile.offset": -0.001}])
def test_tuning_depends_on_the_rest(changes: dict[str, Any]) -> None:
    other = small().replace(changes).to_dict()
    assert TuningRequest(TREE, 10.0, 0.1).key != TuningRequest(other, 10.0, 0.1).key
    assert TuningRequest(TREE, 10.0, 0.1).key != TuningRequest(TREE, 10.0, 0.2).key


def test_comparison_is_that_of_the_api() -> None:
    shares, report = heard()
    tables = ({"kind": "four-roller", "roller_angle": 25.0},)
    found = find_comparison(ComparisonRequest(TREE, tables, 0.215, "power", 10.0, 0.1), Limits(), report)
    alone = compare(small(), tables, w0_mm=0.215, goal="power")
    assert found.record == alone.as_dict()
    for table, contender in zip(found.tables, alone.contenders, strict=True):
        assert contender.analysis is not None
        assert table == contender.analysis.design.to_dict()["wave_generator"]
    check_progress(shares)
    pickle.dumps(found)


def test_without_another_generator_the_own_one_is_alone() -> None:
    request = ComparisonRequest(TREE, (), 0.212, "power", 10.0, 0.1)
    found = find_comparison(request, Limits(), lambda share, words: None)
    assert [row["label"] for row in found.record["rows"]] == ["cosine", "cosine"]


def test_tolerance_is_that_of_the_api() -> None:
    shares, report = heard()
    found = find_tolerance(ToleranceRequest(TREE, TOLERANCES, 128, 64, 7), Limits(), report)
    alone = analyze_tolerance(small(), Tolerances.from_dict(TOLERANCES), samples=128, sobol_samples=64, seed=7)
    assert found.record == alone.as_dict()
    assert f"{100.0 * alone.yield_.share:.2f} %" in found.yield_words
    check_progress(shares)
    pickle.dumps(found)


def test_optimum_is_that_of_the_api() -> None:
    shares, report = heard()
    found = find_optimum(OPTIMUM, Limits(), report)
    alone = optimize(small(), {W0: (0.205, 0.222)}, ["evenness=min"], population=8, generations=3)
    assert found.record == alone.as_dict()
    assert [*found.designs] == [design.to_dict() for design in alone.designs]
    check_progress(shares)
    pickle.dumps(found)


def test_progress_of_a_search_says_the_best_so_far() -> None:
    words: list[str] = []
    find_optimum(OPTIMUM, Limits(), lambda share, said: words.append(said))
    assert words[-1].startswith("generation 3 of 3; best so far: evenness ")


@pytest.mark.parametrize(
    ("change", "error"),
    [
        ({"vary": {}}, "nothing may vary"),
        ({"vary": {W0: (0.22, 0.21)}}, "must be below the upper end"),
        ({"vary": {"no.such": (0.0, 1.0)}}, "no is not there"),
        ({"objectives": ()}, "objectives must be a list"),
        ({"require": {"play": (2.0, 1.0)}}, "which nothing does"),
        ({"population": 7}, "population must be"),
        ({"generations": 0}, "generations must be"),
    ],
)
def test_a_wrong_question_is_seen_before_the_search(change: dict[str, Any], error: str) -> None:
    OPTIMUM.check()
    with pytest.raises((StrainwaveError, DesignError)) as raised:
        OptimizationRequest(**{**vars(OPTIMUM), **change}).check()
    assert error in str(raised.value).replace("no.such: is", "no is")


def test_infinite_numbers_do_not_cross() -> None:
    with pytest.raises(DesignError):
        OptimizationRequest(**{**vars(OPTIMUM), "vary": {W0: (0.2, math.inf)}}).check()
