"""The results of a batch as a table."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from strainwave import Batch, StrainwaveError, evaluate_batch
from strainwave.batch.metrics import COLUMNS
from tests.designs import case

KEYS = ["wave_generator.w0", "flexspline.profile.offset"]
VALUES = [[0.848, -0.0072], [-1.0, 0.0], [0.848, 0.0], [0.848, 2.0]]


@pytest.fixture(scope="module")
def batch() -> Batch:
    return evaluate_batch(case(), KEYS, VALUES, in_motion=True)


def test_columns_have_a_value_for_each_row(batch: Batch) -> None:
    assert len(batch) == 4
    assert batch.parameters == tuple(KEYS)
    assert batch.values.tolist() == VALUES
    assert batch.ok.tolist() == [True, False, True, False]
    for name, column in batch.columns.items():
        assert column is getattr(batch, name)
        assert column.shape == (4,)
        if name != "first_interfering_tooth":
            assert np.isnan(column).tolist() == [False, True, False, True]


def test_every_column_is_a_property() -> None:
    assert all(isinstance(getattr(Batch, name), property) for name in COLUMNS)


def test_the_interfering_teeth_of_the_design_as_printed(batch: Batch) -> None:
    assert np.isnan(batch.first_interfering_tooth[0])
    assert batch.interfering_per_side[0] == 0
    assert batch.interfering_per_side[2] > 0
    assert batch.min_in_motion_lower_bound_um[2] <= batch.min_in_motion_um[2] <= batch.min_backlash_um[2]


@pytest.mark.parametrize(
    ("name", "option"),
    [("play_circumferential_um", r"metrics=\[…, 'play_circumferential_um'\]"), ("min_in_motion_um", "in_motion=True")],
)
def test_a_column_that_was_not_asked_for_says_how_to_ask(name: str, option: str) -> None:
    alone = evaluate_batch(case(), KEYS, VALUES[:1], metrics=["min_backlash_um"])
    assert list(alone.columns) == ["min_backlash_um"]
    with pytest.raises(StrainwaveError, match=f"{name} was not asked for.*{option}"):
        getattr(alone, name)


def test_the_record_is_plain_and_strict_json(batch: Batch) -> None:
    record = batch.to_dict()
    assert json.loads(json.dumps(record, allow_nan=False)) == record
    assert list(record) == ["parameters", "status", *batch.columns]
    assert record["parameters"] == dict(zip(KEYS, map(list, zip(*VALUES, strict=True)), strict=True))
    assert record["min_tooth"][:2] == [36, None]
    assert type(record["min_tooth"][0]) is int


def test_the_csv_holds_every_row_with_its_reason(batch: Batch, tmp_path: Path) -> None:
    path = tmp_path / "batch.csv"
    batch.to_csv(path)
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["status"] for row in rows] == ["ok", "out-of-range", "ok", "radius-vanishes"]
    assert [float(row["wave_generator.w0"]) for row in rows] == [0.848, -1.0, 0.848, 0.848]
    assert float(rows[0]["min_backlash_um"]) == batch.min_backlash_um[0]
    assert rows[0]["min_tooth"] == "36"
    assert rows[1]["min_backlash_um"] == ""
    assert [row["reason"] for row in rows] == [batch.reason(row) or "" for row in range(4)]
    assert "must be a number from 0.0001 to 1000000 mm" in rows[1]["reason"]
    with pytest.raises(StrainwaveError, match="is there already"):
        batch.to_csv(path)
    batch.to_csv(path, overwrite=True)


def test_a_row_as_a_design(batch: Batch) -> None:
    assert batch.design_of(2) == case().replace({"wave_generator.w0": 0.848, "flexspline.profile.offset": 0.0})
    with pytest.raises(IndexError):
        batch.design_of(4)


def test_what_it_prints(batch: Batch) -> None:
    assert repr(batch) == "<Batch of 'Case study, cosine cam': 4 rows, 2 possible>"
