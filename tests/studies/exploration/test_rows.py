"""Rows are the designs of the sequence with the figures that `analyze` has for each, however they are computed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.studies.exploration import Space, explore
from tests.designs import case
from tests.studies.exploration.clusters import content
from tests.studies.exploration.runs import OFFSET, ROLLER, W0, explored, space_of


def test_every_row_has_the_figures_that_analyze_has_for_its_design() -> None:
    chosen = explored().first(60)
    assert set(chosen.generators) == {"cosine", "four-roller", "dual-disk"}
    for row, design in zip(chosen.rows, chosen.designs, strict=True):
        assert design.wave_generator.kind == row["generator"]
        assert design.wave_generator.w0 == row[W0]
        assert design.to_dict()["wave_generator"].get("roller_angle") == row[ROLLER]
        found = analyze(design)
        assert row["status"] == "ok"
        assert row["min_backlash_um"] == found.min_backlash_um
        assert row["min_tooth"] == found.min_tooth
        assert row["teeth_below_per_side"] == found.teeth_below.per_side
        assert row["first_interfering_tooth"] == found.first_interfering_tooth
        assert row["tip_clearance_um"] == found.tip_clearance_um
        if found.min_backlash_um >= 0.0:
            assert row["min_in_motion_um"] == pytest.approx(found.min_in_motion_um, rel=0, abs=1e-3)  # the certificate
        else:
            assert row["min_in_motion_um"] is None


def test_rows_are_numbered_evenly_spread_and_in_their_ranges() -> None:
    whole = explored().first(3000)
    np.testing.assert_array_equal(whole.column("sample"), np.arange(3000))
    for key, low, high in [(W0, 0.83, 0.9), (OFFSET, -0.015, -0.003)]:
        # 2048 points of a Sobol' sequence have exactly one in each 2048th of every axis.
        cells = np.floor((whole.column(key)[:2048] - low) / (high - low) * 2048)
        np.testing.assert_array_equal(np.sort(cells), np.arange(2048))
    counts = [whole.generators.count(label) for label in ("cosine", "four-roller", "dual-disk")]
    assert max(counts) - min(counts) <= 8


def test_chunks_and_threads_change_no_row(tmp_path: Path) -> None:
    plan = explored().plan
    other = explore(plan.design, plan.space, 3000, tmp_path / "other", chunk_rows=1024, in_motion=True, threads=1)
    assert len(other.finished) == 3
    assert other.first(3000).rows == explored().first(3000).rows


def test_threads_change_no_byte(tmp_path: Path) -> None:
    space = space_of()
    first, second = (
        content(explore(case(), space, 1000, tmp_path / name, chunk_rows=64, threads=threads).place.path)
        for name, threads in (("a", 1), ("b", 3))
    )
    assert len(first) == 17
    assert first == second


def test_designs_that_cannot_be_have_a_status_and_stop_nothing(tmp_path: Path) -> None:
    space = space_of(flexspline__wall_thickness=(1.0, 200.0), wave_generator__w0=(0.8, 40.0))
    found = explore(case(), space, 256, tmp_path / "wide", chunk_rows=64, in_motion=True)
    rows = found.first(256).rows
    refused = [row for row in rows if row["status"] != "ok"]
    assert {"wall-too-thick"} < {row["status"] for row in refused}
    assert all(row["min_backlash_um"] is None and row["min_in_motion_um"] is None for row in refused)
    assert all(row[W0] is not None for row in refused)
    counts = found.summary().statuses["cosine"]
    assert sum(counts.values()) == 256
    assert counts["wall-too-thick"] == sum(row["status"] == "wall-too-thick" for row in refused)


def test_a_space_without_a_single_gear_is_a_dataset_too(tmp_path: Path) -> None:
    found = explore(case(), space_of(wave_generator__w0=(50.0, 60.0)), 100, tmp_path / "none")
    summary = found.viable.summary()
    assert (summary.possible, len(summary.best), found.evaluated) == (0, 0, 100)
    assert summary.as_dict()["spreads"]["min_backlash_um"]["least"] is None


def test_a_generator_without_any_of_the_parameters_has_rows_of_its_own_design(tmp_path: Path) -> None:
    space = space_of({"kind": "cosine"}, {"kind": "four-roller"}, wave_generator__roller_angle=(15, 30))
    found = explore(case("cosine-calibrated"), space, 64, tmp_path / "study", in_motion=True).first(64)
    backlash = {row["min_backlash_um"] for row in found.rows if row["generator"] == "cosine"}
    assert backlash == {analyze(case("cosine-calibrated")).min_backlash_um}
    assert len({row["min_backlash_um"] for row in found.rows if row["generator"] == "four-roller"}) == 32


def test_another_seed_gives_other_designs() -> None:
    plan = explored().plan
    values, places = plan.sampled(plan.rows_of(0))
    other = type(plan).from_dict({**plan.as_dict(), "seed": 2})
    assert not np.array_equal(values, other.sampled(other.rows_of(0))[0])
    assert isinstance(other.space, Space)
    assert set(places) == {0, 1, 2}
