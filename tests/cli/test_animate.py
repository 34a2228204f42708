"""``strainwave animate``: what it writes, says and refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.command import run
from tests.designs import CASE_STUDY

COSINE = CASE_STUDY / "cosine-calibrated.toml"


@pytest.mark.parametrize(
    ("ending", "begins"), [("html", b"<!DOCTYPE html>"), ("gif", b"GIF89a"), ("mp4", b"\x00\x00\x00")]
)
def test_every_format_is_written(
    ending: str, begins: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / f"turning.{ending}"
    outcome = run(capsys, "animate", COSINE, "--out", out, "--frames", 3, "--fixed", "flexspline")
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.splitlines() == [
        f"{out}: 3 frames; flexspline fixed; ratio of generator to circular spline 206/2 = 103: they turn the same way",
        "NO INTERFERENCE in motion, least gap 1.49 µm",
    ]
    assert out.read_bytes().startswith(begins)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--out", "a.avi"], "a.avi: an animation's name must end in .gif, .mp4 or .html"),
        (["--out", "a.gif", "--frames", "1"], "an animation has from 2 to 2000 frames, not 1"),
        (["--out", "a.gif", "--turns", "0"], "the generator turns by at most 1000 turns either way, and not by 0"),
        (["--out", "a.gif", "--fps", "100"], "frames per second must be from 1 to 60, not 100"),
        (["--out", "a.gif", "--fps", "60"], "a GIF shows at most 50 frames per second, not 60"),
        (["--out", "a.gif", "--fixed", "housing"], "--fixed"),
        (["--out", "/no/such/place/a.gif"], "there is no directory /no/such/place"),
        ([], "--out"),
    ],
)
def test_wrong_usage(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run(capsys, "animate", COSINE, *arguments)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err
    assert list(tmp_path.iterdir()) == []
