"""``strainwave compare``: what it prints, writes and refuses."""

from __future__ import annotations

import csv
import json
import sys
from pathlib import Path
from typing import Any

import pytest

from strainwave.design import load, save
from strainwave.studies import Tuning, compare, tune
from tests.cli.command import run
from tests.designs import CASE_STUDY
from tests.studies.small import WILD, small

COSINE = CASE_STUDY / "cosine-calibrated.toml"
DUAL_DISK = CASE_STUDY / "dual-disk-0848-calibrated.toml"


@pytest.fixture
def design(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A design that is quick to tune."""
    file = tmp_path_factory.mktemp("designs") / "small.toml"
    save(small(), file)
    return file


def test_the_report_is_the_article_s_table(capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, "compare", COSINE, "--with", "four-roller", "--with", DUAL_DISK, "--goal", "precision").out
    rows = [line.split("  ") for line in lines.splitlines() if line.startswith(("cosine ", "four-roller", "dual-disk"))]
    assert [row[-1].strip() for row in rows] == [
        "power transmission", "general purpose", "not viable",
        "general purpose", "general purpose", "precision positioning",
    ]  # fmt: skip
    assert [" ".join(row).split()[1] for row in rows if row[0] == "cosine"] == ["0.8480", "0.9006"]
    assert "yes" in " ".join(rows[2])
    assert "39 / 79" in " ".join(rows[0])
    assert "what interferes in motion is not viable" in " ".join(lines.split())


def test_json_csv_and_picture(design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, plot = tmp_path / "table.csv", tmp_path / "curves.pdf"
    outcome = run(
        capsys, "compare", design, "--with", "dual-disk:wrap_angle=20", "--w0", 0.215, "--threshold", 8, "--json",
        "--csv", table, "--plot", plot,
    )  # fmt: skip
    expected = compare(load(design), [{"kind": "dual-disk", "wrap_angle": 20.0}], w0_mm=0.215, threshold_um=8.0)
    assert (outcome.code, outcome.err) == (0, "")
    assert json.loads(outcome.out) == json.loads(expected.to_json())
    with table.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["label"] for row in rows] == ["cosine", "dual-disk 20°"] * 2
    assert float(rows[0]["min_in_motion_um"]) == expected.as_dict()["rows"][0]["min_in_motion_um"]
    assert plot.read_bytes().startswith(b"%PDF")


def test_a_generator_that_makes_no_gear_has_its_row(
    design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wild = tmp_path / "wild.toml"
    save(small().replace("wave_generator", {**WILD, "w0": 0.212}), wild)
    outcome = run(capsys, "compare", design, "--with", wild, "--with", "four-roller")
    assert (outcome.code, outcome.err) == (0, "")
    rows = [line.split("  ") for line in outcome.out.splitlines()]
    suggested = [(row[0], row[-1].strip()) for row in rows if row[0].startswith(("cosine", "table", "four-roller"))]
    assert suggested[1] == suggested[4] == ("table", "not viable")
    assert [label for label, _ in suggested] == ["cosine", "table", "four-roller 19.5°"] * 2
    words = " ".join(outcome.out.split())
    assert "note: table, common w0: no w0 from 0.1 to 0.3 mm makes a gear (perimeter-not-kept)" in words


def test_long_labels_cut_nothing_off(design: Path, capsys: pytest.CaptureFixture[str]) -> None:
    others = [f"dual-disk:wrap_angle=13,neutral_curve={model}" for model in ("first-order", "inextensible")]
    outcome = run(capsys, "compare", design, "--with", others[0], "--with", others[1])
    assert "…" not in outcome.out
    assert "dual-disk 13° first-order" in outcome.out
    assert "power transmission" in outcome.out


def test_an_interrupt_keeps_what_is_finished(
    design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    calls = 0

    def interrupted_at_the_second(*arguments: Any, **options: Any) -> Tuning:
        nonlocal calls
        calls += 1
        if calls == 2:
            raise KeyboardInterrupt
        return tune(*arguments, **options)

    monkeypatch.setattr(sys.modules["strainwave.studies.comparison.compare"], "tune", interrupted_at_the_second)
    table = tmp_path / "table.csv"
    outcome = run(capsys, "compare", design, "--csv", table)
    assert (outcome.code, outcome.err) == (130, "strainwave: interrupted\n")
    assert "interrupted: generators that were not finished are left out" in outcome.out
    assert [line.split(",")[0] for line in table.read_text(encoding="utf-8").splitlines()[1:]] == ["cosine"] * 2


def test_a_full_disk_loses_nothing(design: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    full = tmp_path / "full.csv"
    full.symlink_to("/dev/full")
    outcome = run(capsys, "compare", design, "--with", "cosine", "--csv", full, "--plot", tmp_path / "curves.svg")
    assert (outcome.code, outcome.err) == (2, f"strainwave: {full}: cannot be written: No space left on device\n")
    assert "power transmission" in outcome.out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["curves.svg", "full.csv"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--with", "wheel"], 'no wave generator of kind "wheel" with known parameters: cosine, ellipse'),
        (["--with", "four-roller:roller_angle"], "must have the form KIND:KEY=NUMBER"),
        (
            ["--with", "four-roller:roller_angle=50"],
            "--with four-roller:roller_angle=50: wave_generator.roller_angle = 50.0 degrees: must be",
        ),
        (
            ["--with", "four-roller:roller_angle=25,w0=0.9"],
            "--with four-roller:roller_angle=25,w0=0.9: wave_generator.w0 = 0.9 mm: is shared by all generators. Leave",
        ),
        (["--with", "none.toml"], "none.toml: there is no such file"),
        (["--w0", "-1"], "strainwave: --w0: wave_generator.w0 = -1.0 mm: must be"),
        (["--goal", "speed"], "'--goal': 'speed' is not one of 'power', 'precision', 'balanced'"),
        (["--csv", "/no/such/place/a.csv"], "there is no directory /no/such/place"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "compare", COSINE, *arguments)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err
