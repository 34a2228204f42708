"""``strainwave sweep``: what it prints, writes and refuses."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from strainwave import Batch, evaluate_batch
from strainwave.design import load
from strainwave.studies import sweep
from tests.cli.command import run
from tests.designs import CASE_STUDY

DUAL_DISK = CASE_STUDY / "dual-disk-0848-calibrated.toml"
W0 = "wave_generator.w0"


def test_a_line_is_a_table_with_interfering_rows_marked(capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, "sweep", DUAL_DISK, "--vary", f"{W0}=0.86:0.9:5").out.splitlines()
    found = sweep(load(DUAL_DISK), {W0: [0.86, 0.87, 0.88, 0.89, 0.9]})
    assert lines[2] == "4 of 5 without interference in motion"
    rows = [line.split() for line in lines if line.startswith("0.")]
    assert [row[0] for row in rows] == ["0.86", "0.87", "0.88", "0.89", "0.9"]
    expected = [f"{value:.2f}".replace("-", "−") + ("×" if value < 0.0 else "") for value in found.values]
    assert [row[1] for row in rows] == expected


def test_a_map_is_a_table_of_both_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["--vary", "wave_generator.wrap_angle=5:15:2", "--vary", f"{W0}=0.86:0.88:3"]
    out = run(capsys, "sweep", DUAL_DISK, *arguments, "--metric", "teeth_below_per_side").out
    found = sweep(
        load(DUAL_DISK), {"wave_generator.wrap_angle": [5, 15], W0: [0.86, 0.87, 0.88]}, metric="teeth_below_per_side"
    )
    rows = [line.split() for line in out.splitlines() if line.startswith(("5 ", "15 "))]
    overlap = found.grid(found.interference)
    assert [row[1:] for row in rows] == [
        [f"{value:.0f}{'×' if overlap[i, k] else ''}" for k, value in enumerate(values)]
        for i, values in enumerate(found.values)
    ]


def test_of_many_rows_some_are_shown_and_all_are_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "rows.csv"
    arguments = ["--vary", f"{W0}=0.84:0.91:71", "--metric", "min_backlash_um", "--csv", table]
    out = run(capsys, "sweep", DUAL_DISK, *arguments).out
    assert sum(line.startswith("0.") for line in out.splitlines()) == 25
    assert "some of the rows are shown" in out
    assert table.read_text(encoding="utf-8").count("\n") == 72


def test_json_and_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plot = tmp_path / "sweep.svg"
    outcome = run(capsys, "sweep", DUAL_DISK, "--vary", f"{W0}=0.86:0.88:3", "--threshold", 7, "--json", "--plot", plot)
    assert (outcome.code, outcome.err) == (0, "")
    expected = sweep(load(DUAL_DISK), {W0: [0.86, 0.87, 0.88]}, threshold_um=7.0)
    assert json.loads(outcome.out) == json.loads(expected.to_json())
    assert plot.read_text(encoding="utf-8").startswith("<?xml")


def test_an_interrupt_keeps_what_is_finished(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    sweep(load(DUAL_DISK), {W0: [0.88]})  # so that the module is there
    module = sys.modules["strainwave.studies.sweeping.sweep"]
    monkeypatch.setattr(module, "ROWS_IN_MOTION_AT_ONCE", 2)

    def interrupted_at_last(*arguments: Any, **options: Any) -> Batch:
        if np.max(arguments[2]) > 0.895:
            raise KeyboardInterrupt
        return evaluate_batch(*arguments, **options)

    monkeypatch.setattr(module, "evaluate_batch", interrupted_at_last)
    table, plot = tmp_path / "rows.csv", tmp_path / "sweep.svg"
    outcome = run(capsys, "sweep", DUAL_DISK, "--vary", f"{W0}=0.86:0.9:5", "--csv", table, "--plot", plot)
    assert (outcome.code, outcome.err) == (130, "strainwave: interrupted\n")
    assert "interrupted: 4 of 5 rows are finished; the others have no value" in outcome.out
    rows = [line.split(",")[1] for line in table.read_text(encoding="utf-8").splitlines()[1:]]
    assert rows == ["ok"] * 4 + ["not-computed"]
    assert plot.exists()


def test_a_full_disk_loses_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    full = tmp_path / "full.csv"
    full.symlink_to("/dev/full")
    outcome = run(capsys, "sweep", DUAL_DISK, "--vary", f"{W0}=0.86:0.9:5", "--csv", full)
    assert (outcome.code, outcome.err) == (2, f"strainwave: {full}: cannot be written: No space left on device\n")
    assert "4 of 5 without interference in motion" in outcome.out
    assert [path.name for path in tmp_path.iterdir()] == ["full.csv"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "Missing option '--vary'"),
        (["--vary", W0], "must have the form KEY=START:STOP:COUNT"),
        (["--vary", f"{W0}=0.8:0.9"], "must have the form KEY=START:STOP:COUNT"),
        (["--vary", f"{W0}=0.8:0.9:x"], "must have the form KEY=START:STOP:COUNT"),
        (["--vary", f"{W0}=0.8:much:3"], f'{W0} = "much": must be a number from'),
        (["--vary", f"{W0}=0.9:0.8:3"], f"{W0} = 0.9 mm: must be below the other end of its range, 0.8"),
        (["--vary", f"{W0}=0.8:2000000:3"], f"{W0} = 2000000.0 mm: must be a number from"),
        (["--vary", f"{W0}=0.8:0.9:0"], "the number of values must be from 1"),
        (["--vary", "wave_generator.w1=0.8:0.9:3"], "wave_generator.w1"),
        (["--vary", f"{W0}=0.8:0.9:3", "--vary", f"{W0}=0.8:0.9:3"], "one number of the design, or two"),
        (["--vary", f"{W0}=0.8:0.9:3", "--metric", "backlash"], "the metric must be one of"),
        (["--vary", f"{W0}=0.8:0.9:3", "--csv", "/no/such/place/a.csv"], "there is no directory /no/such/place"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "sweep", DUAL_DISK, *arguments)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err
