"""Design files, CSV and JSON of an optimization."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from strainwave.design import load, loads
from strainwave.errors import StrainwaveError
from strainwave.studies.optimization import optimize
from strainwave.studies.optimization.design_files import design_files
from strainwave.studies.optimization.record import csv_text
from tests.designs import case
from tests.studies.optimization.runs import VARY, WITHIN, front, single


def test_design_files_hold_the_designs_and_say_where_they_come_from() -> None:
    ((name, text),) = design_files(single()).items()
    assert name == "best.toml"
    assert loads(text) == single().best
    header = "".join(line for line in text.splitlines(keepends=True) if line.startswith("#"))
    for said in ("Case study, cosine cam", "greatest teeth-below", "minimum-backlash 0.5 to 3 µm", "seed 1",
                 "generation 15 of 15", "from 0.848"):  # fmt: skip
        assert said in header


def test_a_front_is_a_file_for_each_design_in_its_order(tmp_path: Path) -> None:
    paths = front().save(tmp_path / "front")
    assert [load(path) for path in paths] == list(front().designs)
    assert sorted(tmp_path.rglob("*")) == sorted([tmp_path / "front", *paths])
    with pytest.raises(StrainwaveError, match="holds files already"):
        front().save(tmp_path / "front")


def test_one_answer_after_another_may_take_a_folder_but_none_that_holds_more(tmp_path: Path) -> None:
    front().save(tmp_path / "found")
    single().save(tmp_path / "found", overwrite=True)
    assert [path.name for path in (tmp_path / "found").iterdir()] == ["best.toml"]
    front().save(tmp_path / "found", overwrite=True)
    (tmp_path / "found" / "my-gear.toml").write_text("mine")
    for found in (single(), front()):
        with pytest.raises(StrainwaveError, match=r"holds my-gear\.toml, which would be lost"):
            found.save(tmp_path / "found", overwrite=True)
    assert len(list((tmp_path / "found").iterdir())) == len(front()) + 1


def test_no_name_of_a_design_can_leave_the_header() -> None:
    hostile = case().replace("name", "gear\nmodule = 7\r# \x1b[2J")
    found = optimize(hostile, VARY, require=WITHIN, generations=5)
    (text,) = design_files(found).values()
    assert loads(text) == found.best


def test_json_and_csv_hold_the_same_numbers() -> None:
    found = front()
    record = json.loads(found.to_json())
    rows = list(csv.DictReader(io.StringIO(csv_text(found))))
    assert len(rows) == len(record["designs"]) == len(found)
    for row, entry, values in zip(rows, record["designs"], found.values, strict=True):
        assert list(entry["parameters"].values()) == values.tolist()
        for key, value in (entry["parameters"] | entry["figures"]).items():
            assert row[key] == "" if value is None else float(row[key]) == value
    assert record["search"] == {
        "method": "NSGA-II", "seed": 1, "population": 64, "generations": 15, "generations_asked": 15,
        "evaluations": 960, "interrupted": False,
    }  # fmt: skip
    assert record["requirements"][0] == {
        "figure": "minimum-backlash",
        "key": "min_in_motion_um",
        "low": 0.0,
        "high": None,
    }
    assert type(record["designs"][0]["figures"]["teeth_below_per_side"]) is int


def test_a_parameter_that_the_start_leaves_out_has_not_moved_from_anywhere() -> None:
    vary = {"flexspline.neutral_radius": (79.82, 79.84), "flexspline.profile.offset": (-0.02, 0.0)}
    found = optimize(case(), vary, generations=5)
    assert found.moved()["flexspline.neutral_radius"] is None
    assert found.as_dict()["parameters"][0]["start"] is None
    (text,) = design_files(found).values()
    assert "not given before" in text
