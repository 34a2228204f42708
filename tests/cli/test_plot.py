"""``strainwave plot``: pictures by name, and what it refuses."""

from __future__ import annotations

import re
from pathlib import Path
from typing import get_args, get_type_hints

import pytest

from strainwave.cli.plot import plot
from strainwave.plots.kinds import KINDS
from tests.cli.command import run
from tests.designs import CASE_STUDY

DUAL_DISK = CASE_STUDY / "dual-disk-0848-calibrated.toml"


def test_the_command_knows_every_kind() -> None:
    kinds = get_args(get_type_hints(plot)["kind"])
    assert list(kinds) == list(KINDS)


def test_every_kind_is_documented() -> None:
    page = (Path(__file__).parents[2] / "docs" / "commands" / "plot.md").read_text(encoding="utf-8")
    listed = re.findall(r"^\| `(?P<kind>[\w-]+)` \|.*\| (?P<page>✓?) ?\|$", page, re.MULTILINE)
    assert dict(listed) == {kind.name: "✓" if kind.interactive else "" for kind in KINDS.values()}


@pytest.mark.parametrize(
    ("kind", "ending", "begins"),
    [
        ("assembly", "svg", b"<?xml"),
        ("gap", "pdf", b"%PDF"),
        ("mesh", "png", b"\x89PNG"),
        ("neutral-curve", "html", b"<"),
        ("contact", "html", b"<"),
    ],
)
def test_a_picture_is_drawn_or_written_as_a_page(
    kind: str, ending: str, begins: bytes, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / f"picture.{ending}"
    outcome = run(capsys, "plot", kind, DUAL_DISK, "--out", out)
    assert (outcome.code, outcome.err) == (0, "")
    assert outcome.out.splitlines() == [f"{out}: {KINDS[kind].shows}", "INTERFERENCE in motion, 14.62 µm deep"]
    assert out.read_bytes().startswith(begins)
    assert (b"Plotly.newPlot" in out.read_bytes()) == (ending == "html")


def test_angle_teeth_and_threshold_reach_the_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pictures: list[bytes] = []
    for options in (
        ["--teeth", "30:34"],
        ["--teeth", "32"],
        ["--teeth", "32", "--angle", "2"],
        ["--teeth", "32", "--threshold", "20"],
    ):
        out = tmp_path / f"{len(pictures)}.png"
        assert run(capsys, "plot", "assembly", DUAL_DISK, "--out", out, *options).code == 0
        pictures.append(out.read_bytes())
    assert len(set(pictures)) == len(pictures)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["gap", DUAL_DISK, "--out", "a.gif"], "a.gif: the name must end in .png, .svg or .pdf, or in .html for"),
        (["gap", DUAL_DISK, "--out", "a.svg", "--angle", "20"], "a picture of gap does not depend on an angle"),
        (["contact", DUAL_DISK, "--out", "a.svg", "--teeth", "3"], "a picture of contact does not depend on chosen"),
        (["mesh", DUAL_DISK, "--out", "a.html"], "mesh is a drawing, not a page"),
        (["assembly", DUAL_DISK, "--out", "a.svg", "--teeth", "1-3"], "'1-3' is neither A:B, such as 32:41, nor one"),
        (["assembly", DUAL_DISK, "--out", "a.svg", "--teeth", "99:103"], "there is no tooth 103"),
        (["assembly", DUAL_DISK, "--out", "a.svg", "--angle", "x"], "--angle"),
        (["shadow", DUAL_DISK, "--out", "a.svg"], "KIND"),
        (["gap", DUAL_DISK], "--out"),
        (["gap", DUAL_DISK, "--out", "/no/such/place/a.svg"], "there is no directory /no/such/place"),
    ],
)
def test_wrong_usage(
    arguments: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run(capsys, "plot", *arguments)
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err
    assert list(tmp_path.iterdir()) == []


def test_a_picture_is_not_overwritten_unasked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "a.svg"
    out.write_text("mine")
    assert "is there already" in run(capsys, "plot", "gap", DUAL_DISK, "--out", out).err
    assert out.read_text() == "mine"
    assert run(capsys, "plot", "gap", DUAL_DISK, "--out", out, "--force").code == 0
    assert out.read_text(encoding="utf-8").startswith("<?xml")
