"""An order makes the file that the command writes for the same choice, to the byte."""

from __future__ import annotations

import gzip
import pickle
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Literal

import ezdxf._options
import pytest

from strainwave.analysis import analyze
from strainwave.cli import report
from strainwave.design import dumps
from strainwave.errors import StrainwaveError
from strainwave.report import Chapter
from strainwave.studio.jobs import Limits
from strainwave.studio.orders import MOST_BYTES, DesignOrder, Order, Product, ReportOrder, in_words, made, order
from strainwave.studio.orders.wishes import Wishes
from tests.cli.command import run
from tests.export.gears import small_gear

GEAR = small_gear()
THRESHOLD_UM = 10.0
# The hour in a STEP file's head is that of its making, and its bodies are counted from the process's first file on.
STEP_MAKING = re.compile(rb"FILE_NAME\('[^']*','[^']*'|NEXT_ASSEMBLY_USAGE_OCCURRENCE\('\d+'")


@pytest.fixture
def design_file(tmp_path: Path) -> Path:
    file = tmp_path / "gear.toml"
    file.write_text(dumps(GEAR), encoding="utf-8")
    return file


@pytest.fixture(autouse=True)
def dxf_without_times() -> Iterator[None]:
    """Times and the ids made from them, which differ from run to run, are left out of DXF files."""
    options = ezdxf._options.options
    options.write_fixed_meta_data_for_testing = True
    yield
    options.write_fixed_meta_data_for_testing = False


def product_of(wanted: Order) -> Product:
    """What a job makes of it, after the way into another process."""
    return made(pickle.loads(pickle.dumps(wanted)), Limits(), lambda share, words: None)


def content_of(wanted: Order) -> bytes:
    product = product_of(wanted)
    content = gzip.decompress(product.packed)
    assert len(content) == product.size
    return content


@pytest.mark.parametrize(
    ("format", "fields", "options"),
    [
        ("dxf", {}, []),
        ("dxf", {"assembled": True, "generator_angle_deg": 30.0}, ["--angle", "30"]),
        ("svg", {"part": "flexspline", "printing_clearance_mm": 0.05}, ["--part", "flexspline",
                                                                        "--printing-clearance", "0.05"]),
        ("csv", {"one_tooth": True, "tooth": 3, "chord_error_mm": 0.01}, ["--tooth", "3", "--chord-error", "0.01"]),
        ("json", {"part": "wave-generator"}, ["--part", "wave-generator"]),
        ("step", {"part": "circular-spline", "one_tooth": True, "tooth": -2}, ["--part", "circular-spline",
                                                                               "--tooth", "-2"]),
        ("stl", {"chord_error_mm": 0.1}, ["--chord-error", "0.1"]),
        ("glb", {"assembled": True, "generator_angle_deg": 15.0}, ["--angle", "15"]),
    ],
)  # fmt: skip
def test_each_format_is_what_the_command_writes(
    format: str,
    fields: dict[str, Any],
    options: list[str],
    design_file: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    out = tmp_path / f"gear.{format}"
    assert run(capsys, "export", format, design_file, "--out", out, *options).code == 0
    ours = content_of(Wishes(kind=format, **fields).order(GEAR, THRESHOLD_UM))
    theirs = out.read_bytes()
    if format == "step":
        ours, theirs = (STEP_MAKING.sub(b"", content) for content in (ours, theirs))
    assert ours == theirs


@pytest.mark.parametrize("format", ["html", "gif"])
def test_a_film_is_what_the_command_writes(
    format: str, design_file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / f"turning.{format}"
    options = ["--frames", "3", "--turns", "0.5", "--fixed", "flexspline", "--fps", "10"]
    assert run(capsys, "animate", design_file, "--out", out, *options).code == 0
    wishes = Wishes(kind=f"film-{format}", frames=3, turns=0.5, fixed="flexspline", frames_per_s=10.0)
    assert content_of(wishes.order(GEAR, THRESHOLD_UM)) == out.read_bytes()


@pytest.fixture
def brief_reports(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reports with one picture, whoever makes them."""
    monkeypatch.setattr(Chapter, "of", Chapter.brief)


@pytest.mark.usefixtures("brief_reports")
@pytest.mark.parametrize("format", ["html", "pdf"])
def test_the_report_is_what_the_command_writes_but_for_the_command(
    format: Literal["html", "pdf"],
    design_file: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(report, "_arguments", lambda *options: ())
    out = tmp_path / f"report.{format}"
    options = ["--title", "For <review>", "--date", "today", "--threshold", "12"]
    assert run(capsys, "report", design_file, "--out", out, *options).code == 0
    assert content_of(ReportOrder(GEAR, format, 12.0, "For <review>", "today")) == out.read_bytes()


def test_the_design_file_is_the_one_that_the_command_reads(design_file: Path) -> None:
    assert content_of(DesignOrder(GEAR)) == design_file.read_bytes()


def test_names_say_which_part_and_which_tooth() -> None:
    assert Wishes(part="flexspline", one_tooth=True, tooth=3).order(GEAR, THRESHOLD_UM).file_name == (
        "Small-gear-32-flexspline-tooth-3.dxf"
    )
    assert Wishes(kind="film-mp4").order(GEAR, THRESHOLD_UM).file_name == "Small-gear-32-turning.mp4"
    assert ReportOrder(GEAR, "pdf", THRESHOLD_UM).file_name == "Small-gear-32-report.pdf"


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"one_tooth": True, "tooth": 999}, "tooth 999 is not there"),
        ({"printing_clearance_mm": 9.0}, "the printing clearance must be from -0.8 to 0.8 mm"),
        ({"kind": "csv", "chord_error_mm": 1e-9}, "the chord error must lie between"),
        ({"kind": "film-gif", "frames": 1}, "an animation has from 2 to 2000 frames"),
        ({"kind": "film-gif", "turns": 0.0}, "the generator turns by at most"),
        ({"kind": "film-gif", "frames_per_s": 60.0}, "a GIF shows at most 50 frames per second, not 60"),
    ],
)
def test_a_look_finds_what_cannot_be(fields: dict[str, Any], message: str) -> None:
    wanted = Wishes(**fields).order(GEAR, THRESHOLD_UM)
    with pytest.raises(StrainwaveError, match=message):
        wanted.words(analyze(GEAR))


def test_a_look_says_what_the_file_will_hold() -> None:
    analysis = analyze(GEAR)
    words = Wishes(part="flexspline", assembled=True, generator_angle_deg=15.0).order(GEAR, THRESHOLD_UM)
    assert words.words(analysis) == "flexspline, assembled, the wave generator at 15°"
    film = Wishes(kind="film-html", frames=12).order(GEAR, THRESHOLD_UM)
    assert film.words(analysis).startswith("12 frames; circular spline fixed; ratio of generator to flexspline −40/2")


def test_progress_is_counted() -> None:
    told: list[tuple[float, str]] = []
    wanted = Wishes(kind="film-html", frames=3).order(GEAR, THRESHOLD_UM)
    made(wanted, Limits(), lambda share, words: told.append((share, words)))
    assert told[0] == (0.0, "working …")
    assert told[-1] == (1.0, "3 of 3 frames")


def test_a_file_beyond_the_bound_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(order, "MOST_BYTES", 100)
    with pytest.raises(StrainwaveError, match=r"would have .* kB, more than the 0.1 kB that the studio hands out"):
        product_of(DesignOrder(GEAR))
    assert in_words(MOST_BYTES) == "150.0 MB"
