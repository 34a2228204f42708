"""What is read lazily from a dataset is what all of it in memory says."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from strainwave import load
from strainwave.errors import StrainwaveError
from strainwave.studies.exploration import load_exploration
from tests.studies.exploration.runs import ROLLER, W0, explored


def test_the_best_are_the_best_of_all_rows_in_memory() -> None:
    rows = explored().first(3000).rows
    viable = [row for row in rows if row["min_in_motion_um"] is not None and row["min_in_motion_um"] >= 0.0]
    by_teeth = sorted(viable, key=lambda row: (-row["teeth_below_per_side"], row["sample"]))
    assert explored().viable.best(25).rows == by_teeth[:25]
    by_backlash = sorted(viable, key=lambda row: row["min_in_motion_um"])
    assert explored().viable.best(25, "min_in_motion_um").rows == by_backlash[:25]
    assert explored().viable.best(3, "min_in_motion_um=max").rows == by_backlash[: -3 - 1 : -1]


def test_requirements_keep_what_meets_them_and_replace_each_other() -> None:
    rows = explored().first(3000).rows
    chosen = explored().where({W0: (0.85, 0.86), "generator": ["four-roller", "dual-disk"]})
    expected = [row for row in rows if 0.85 <= row[W0] <= 0.86 and row["generator"] != "cosine"]
    assert 0 < len(expected) < 600
    assert chosen.first(3000).rows == expected
    wider = [row for row in rows if row[W0] <= 0.87 and row["generator"] != "cosine"]
    assert chosen.where({W0: (-math.inf, 0.87)}).first(3000).rows == wider
    # An end that is left out stays as it was.
    assert chosen.where({W0: (None, 0.87)}).first(3000).rows == [row for row in wider if row[W0] >= 0.85]
    assert chosen.where({W0: (None, None)}).first(3000).rows == expected
    # A row without the number does not meet a range of it.
    assert set(explored().where({ROLLER: (0.0, None)}).first(3000).generators) == {"four-roller"}


def test_at_most_so_much_backlash_is_no_leave_to_interfere() -> None:
    rows = explored().first(3000).rows
    within = [row for row in rows if row["min_in_motion_um"] is not None and 0.0 <= row["min_in_motion_um"] <= 5.0]
    assert 0 < len(within) < len(explored().viable.first(3000))
    assert explored().viable.where({"min_in_motion_um": (None, 5.0)}).first(3000).rows == within


def test_an_infinite_end_is_none_also_for_rows_without_a_number() -> None:
    """Those that interfere at angle 0 have no backlash in motion, and are wanted where none is required."""
    assert None in [row["min_in_motion_um"] for row in explored().first(3000).rows]
    anything = explored().where({"min_in_motion_um": (-math.inf, math.inf)})
    assert len(anything.first(3000)) == 3000
    again = explored().viable.where(dict.fromkeys(explored().viable.wanted, (-math.inf, None)))
    assert len(again.first(3000)) == 3000


def test_the_record_has_nothing_for_an_end_that_there_is_not() -> None:
    chosen = explored().where({
        "min_in_motion_um": (0, math.inf), W0: (-math.inf, 0.86), "min_tooth": (None, None), "generator": ["cosine"]
    })  # fmt: skip
    assert json.loads(chosen.summary(1).to_json())["wanted"] == {
        "min_in_motion_um": [0.0, None], W0: [None, 0.86], "min_tooth": [None, None], "generator": ["cosine"]
    }  # fmt: skip


def test_the_first_of_many_are_the_beginning_of_the_sequence() -> None:
    assert explored().first(300).column("sample").tolist() == list(range(300))
    assert explored().first(10**6).column("sample").tolist() == list(range(3000))
    assert len(explored().first(0)) == 0


def test_the_summary_counts_and_spreads_what_is_wanted() -> None:
    rows = explored().first(3000).rows
    viable = [row for row in rows if row["min_in_motion_um"] is not None and row["min_in_motion_um"] >= 0.0]
    summary = explored().viable.summary(4)
    for label in ("cosine", "four-roller", "dual-disk"):
        assert summary.statuses[label] == {"ok": sum(row["generator"] == label for row in rows)}
        assert summary.wanted[label] == sum(row["generator"] == label for row in viable)
    for name in (W0, ROLLER, "min_in_motion_um", "teeth_below_per_side"):
        values = [row[name] for row in viable if row[name] is not None]
        spread = summary.spreads[name]
        assert (spread.least, spread.greatest, spread.count) == (min(values), max(values), len(values))
        assert spread.mean == pytest.approx(np.mean(values), rel=1e-12)
    assert summary.spreads["first_interfering_tooth"].count == 0
    assert summary.best.rows == explored().viable.best(4).rows


def test_the_best_come_as_ready_design_files(tmp_path: Path) -> None:
    best = explored().viable.best(12)
    paths = best.save(tmp_path / "best")
    assert [path.name for path in paths] == [f"design-{place:02}.toml" for place in range(1, 13)]
    for path, design, row in zip(paths, best.designs, best.rows, strict=True):
        assert load(path) == design
        text = path.read_text(encoding="utf-8")
        assert f"(sample {row['sample']} of 3000, seed 1, study {explored().plan.study}, {row['generator']})" in text
        assert f"#   teeth_below_per_side {row['teeth_below_per_side']}\n" in text
        assert ("roller_angle to" in text) == (row["generator"] == "four-roller")


def test_ready_design_files_take_the_place_of_others_of_their_kind_only(tmp_path: Path) -> None:
    explored().viable.best(3).save(tmp_path / "best")
    explored().viable.best(2).save(tmp_path / "best", overwrite=True)
    assert sorted(path.name for path in (tmp_path / "best").iterdir()) == ["design-01.toml", "design-02.toml"]
    (tmp_path / "best" / "best.toml").write_text("mine")
    with pytest.raises(StrainwaveError, match=r"holds best.toml, which would be lost.*only design-N.toml"):
        explored().viable.summary(1).save(tmp_path / "best", overwrite=True)
    assert (tmp_path / "best" / "best.toml").read_text() == "mine"


def test_the_best_come_as_a_table(tmp_path: Path) -> None:
    best = explored().viable.best(3)
    best.to_csv(tmp_path / "best.csv")
    head, *lines = (tmp_path / "best.csv").read_text(encoding="utf-8").splitlines()
    assert head.split(",") == list(best.rows[0])
    assert [line.split(",")[0] for line in lines] == [str(row["sample"]) for row in best.rows]
    with pytest.raises(StrainwaveError, match="is there already"):
        best.to_csv(tmp_path / "best.csv")


def test_a_dataset_that_is_read_again_is_the_same() -> None:
    again = load_exploration(explored().place.path)
    assert again.plan == explored().plan
    assert again.dataset.count_rows() == 3000
    assert again.first(100).rows == explored().first(100).rows


@pytest.mark.parametrize(
    ("wanted", "message"),
    [
        ({"backlash": (0.0, None)}, "'backlash' is no column of numbers of the study: choose from sample, wave_gen"),
        ({"status": ("ok", None)}, "'status' is no column of numbers"),
        ({W0: (0.9, 0.8)}, "must lie from 0.9 to 0.8, which nothing does"),
        ({W0: (math.inf, None)}, "must lie from inf to inf, which nothing does"),
        ({"generator": ["ellipse"]}, "must be among cosine, four-roller, dual-disk"),
        ({"generator": "cosine"}, "must be among cosine"),
    ],
)
def test_what_cannot_be_wanted_is_refused(wanted: dict[str, tuple[float, float]], message: str) -> None:
    with pytest.raises(StrainwaveError, match=message):
        explored().where(wanted)


def test_what_cannot_be_with_what_was_wanted_before_is_refused() -> None:
    with pytest.raises(StrainwaveError, match=r"min_in_motion_um must lie from 0 to -3.*its lower end stays 0"):
        explored().viable.where({"min_in_motion_um": (None, -3.0)})


@pytest.mark.parametrize("objective", ["min_tooth", "teeth_below_per_side=most", "teeth", W0])
def test_an_objective_needs_a_column_and_a_direction(objective: str) -> None:
    with pytest.raises(StrainwaveError, match=r"say which is better|is no column"):
        explored().best(1, objective)
