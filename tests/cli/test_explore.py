"""``strainwave explore``: what it prints and writes, and how it is used wrongly."""

from __future__ import annotations

import inspect
import json
import os
import pty
import re
import subprocess
from pathlib import Path

import pytest

from strainwave import load
from strainwave.cli.explore import explore
from tests.cli.command import run
from tests.designs import CASE_STUDY
from tests.studies.exploration.clusters import arguments
from tests.studies.exploration.runs import SPACE_FILE, explored

DESIGN = CASE_STUDY / "cosine-calibrated.toml"
PAGE = (CASE_STUDY.parent.parent / "docs" / "commands" / "explore.md").read_text(encoding="utf-8")


def test_the_report_answers_first_and_the_files_are_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    study, best, rows, matrix, lines = (tmp_path / name for name in ("study", "best", "best.csv", "a.png", "b.svg"))
    outcome = run(
        capsys,
        *("explore", DESIGN, SPACE_FILE, "--samples", 500, "--out", study, "--in-motion", "--best", 3),
        *("--designs", best, "--csv", rows, "--plot", matrix, "--parallel", lines),
    )
    assert (outcome.code, outcome.err) == (0, "")
    head, answer = outcome.out.splitlines()[:2]
    assert head == "Case study, cosine cam, calibrated; Tip arcs and wave generators"
    assert re.fullmatch(r"\d+ of 500 designs \(\d+\.\d\d %\) meet all", answer)
    assert [load(path).name for path in sorted(best.iterdir())] == ["Case study, cosine cam, calibrated"] * 3
    assert rows.read_text(encoding="utf-8").count("\n") == 4
    assert matrix.read_bytes().startswith(b"\x89PNG")
    assert lines.read_text(encoding="utf-8").startswith("<?xml")


def test_a_summary_says_what_the_run_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    first = run(capsys, "explore", DESIGN, SPACE_FILE, "--samples", 500, "--out", tmp_path / "study", "--json")
    again = run(capsys, "explore", "--summary", tmp_path / "study", "--json")
    assert (first.code, again.code) == (0, 0)
    assert again.out == first.out


def test_a_summary_of_an_unfinished_study_is_one_of_what_is_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    study = tmp_path / "study"
    run(capsys, "explore", DESIGN, SPACE_FILE, "--samples", 500, "--out", study, "--chunk-rows", 128, "--json")
    (study / "chunks" / "chunk-000001.parquet").unlink()
    outcome = run(capsys, "explore", "--summary", study)
    assert (outcome.code, outcome.err) == (0, "")
    assert re.match(r"\d+ of 372 designs .*\nso far: 3 of 4 chunks are finished\n", outcome.out.partition("\n")[2])


def test_requirements_and_objective_choose_what_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(
        capsys,
        *("explore", "--summary", explored().place.path, "--json", "--best", 5),
        *("--require", "generator=cosine, dual-disk", "--require", "wave_generator.w0=:0.86"),
        *("--require", "min_in_motion_um=2:4", "--objective", "min_in_motion_um"),
    )
    record = json.loads(outcome.out)
    assert record["wanted"]["min_in_motion_um"] == [2.0, 4.0]
    assert [each["wanted"] > 0 for each in record["generators"]] == [True, False, True]
    values = [row["min_in_motion_um"] for row in record["best"]]
    assert len(values) == 5
    assert values == sorted(values)
    assert 2.0 <= values[0] < 2.5
    assert all(row["wave_generator.w0"] <= 0.86 and row["generator"] != "four-roller" for row in record["best"])


def test_at_most_so_much_backlash_is_no_leave_to_interfere(capsys: pytest.CaptureFixture[str]) -> None:
    asked = ["explore", "--summary", explored().place.path, "--require", "min_in_motion_um=:5", "--json"]
    record = json.loads(run(capsys, *asked).out)
    assert record["wanted"]["min_in_motion_um"] == [0.0, 5.0]
    assert record["spreads"]["min_in_motion_um"]["least"] >= 0.0


@pytest.mark.parametrize(
    ("range_", "said", "recorded"),
    [
        ("0:inf", "min_in_motion_um at least 0;", [0.0, None]),
        ("-inf:5", "min_in_motion_um at most 5;", [None, 5.0]),
        ("-inf:inf", "any min_in_motion_um;", [None, None]),
    ],
)
def test_an_infinite_end_is_none(
    range_: str, said: str, recorded: list[float | None], capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["explore", "--summary", explored().place.path, "--require", f"min_in_motion_um={range_}"]
    assert said in run(capsys, *asked).out
    assert json.loads(run(capsys, *asked, "--json").out)["wanted"]["min_in_motion_um"] == recorded


# What defines or computes a study, each with what would be taken anyway where that can be.
OF_A_STUDY = {
    "--samples": 3000, "--out": "study", "--seed": 1, "--metric": "tip_clearance_um", "--in-motion": None,
    "--threshold": 10, "--chunk-rows": 256, "--threads": 0, "--dask": "local:2",
}  # fmt: skip


@pytest.mark.parametrize("option", OF_A_STUDY)
def test_a_summary_refuses_what_it_would_have_to_ignore(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    value = [] if OF_A_STUDY[option] is None else [OF_A_STUDY[option]]
    outcome = run(capsys, "explore", "--summary", explored().place.path, option, *value)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert f"--summary: reads a study that is there; it goes without {option} (" in outcome.err


def test_every_option_is_one_of_a_study_or_one_of_reading_it() -> None:
    reading = {"summary", "require", "objective", "best", "as_json", "csv", "plot", "parallel", "designs", "force"}
    of_a_study = {"design", "space", *(option.strip("-").replace("-", "_") for option in OF_A_STUDY)}
    assert set(inspect.signature(explore).parameters) == {"context"} | reading | of_a_study


def test_the_json_keys_are_all_documented() -> None:
    record = explored().viable.summary(1).as_dict()
    for key in [*record, *record["samples"], *record["chunks"], *record["parameters"][0], *record["generators"][0]]:
        assert f"`{key}`" in PAGE, key


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (["--samples", "10"], "DESIGN, SPACE, --samples and --out are all needed, or else --summary FOLDER"),
        ([DESIGN, SPACE_FILE, "--samples", "0", "--out", "x"], "samples must be a whole number from 1 to"),
        ([DESIGN, SPACE_FILE, "--samples", "9", "--out", "x", "--dask", "here"], "neither local:N nor an address"),
        ([DESIGN, SPACE_FILE, "--samples", "9", "--out", "x", "--metric", "backlash"], "metrics must be a list of"),
        ([DESIGN, SPACE_FILE, "--samples", "9", "--out", "x", "--require", "module=1:2"], "'module' is no column"),
        ([DESIGN, SPACE_FILE, "--samples", "9", "--out", "x", "--objective", "module"], "'module' is no column"),
        (["--summary", "nowhere"], "nowhere: is no folder of an exploration"),
        ([DESIGN, "--summary", "nowhere"], "it goes without DESIGN ("),
        ([DESIGN, "a", "--summary", "nowhere", "--seed", "1"], "it goes without DESIGN, SPACE, --seed ("),
        (["--summary", "nowhere", "--require", "min_tooth=nan:"], "'nan' must be a number"),
        ([DESIGN, SPACE_FILE, "--samples", "9", "--out", "x", "--require", "min_backlash_um=:-1"], "end stays 0 where"),
        (["--summary", "nowhere", "--require", "module"], "must have the form NAME=LOW:HIGH"),
        (["--summary", "nowhere", "--plot", "picture.txt"], "a picture's name must end in"),
    ],
)
def test_wrong_usage_is_one_message(
    wrong: list[object],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run(capsys, "explore", *wrong)
    assert (outcome.code, outcome.err.count("\n")) == (2, 1)
    assert message in outcome.err
    assert list(tmp_path.iterdir()) == []


def test_a_space_that_does_not_fit_names_its_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    space = tmp_path / "space.toml"
    space.write_text('[[parameters]]\nparameter = "wave_generator.w1"\nlow = 1\nhigh = 2\n', encoding="utf-8")
    outcome = run(capsys, "explore", DESIGN, space, "--samples", "10", "--out", tmp_path / "study")
    assert outcome.code == 2
    assert outcome.err.startswith(f"strainwave: {space}: parameters[0]: wave_generator.w1")
    assert not (tmp_path / "study").exists()


def test_without_pyarrow_the_error_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "pyarrow", None)
    outcome = run(capsys, "explore", DESIGN, SPACE_FILE, "--samples", "10", "--out", tmp_path / "study")
    assert outcome.code == 2
    assert "an exploration needs pyarrow" in outcome.err
    assert "pip install 'strainwave[cluster]'" in outcome.err


def test_a_terminal_shows_rate_and_time_left(tmp_path: Path) -> None:
    ours, theirs = pty.openpty()
    with subprocess.Popen(
        arguments(tmp_path / "study", 4096),
        stdout=subprocess.DEVNULL,
        stderr=theirs,
        env={**os.environ, "COLUMNS": "100"},
    ) as running:
        os.close(theirs)
        shown = b""
        while True:
            try:
                part = os.read(ours, 4096)
            except OSError:  # the other end is closed
                break
            shown += part
    os.close(ours)
    assert running.returncode == 0
    text = shown.decode(errors="replace")
    assert re.search(r"[1-9]\d*/4096", text)
    assert re.search(r"[\d,]+/s", text)
    assert re.search(r"\d:\d\d:\d\d", text)


def test_a_log_has_a_line_now_and_then(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    from strainwave.cli import progress

    now = [1000.0]
    monkeypatch.setattr("strainwave.cli.progress.time.monotonic", lambda: now[0])
    with progress.paced("designs") as show:
        for seconds, done in [(0, 40_000), (30, 50_000), (70, 60_000), (75, 70_000), (200, 100_000)]:
            now[0] = 1000.0 + seconds
            show(done, 400_000)
    # 40,000 were there already: 20,000 in 70 s, and 60,000 in 200 s.
    assert capsys.readouterr().err.splitlines() == [
        "60,000 of 400,000 designs, 286/s, 20 min left",
        "100,000 of 400,000 designs, 300/s, 17 min left",
    ]
