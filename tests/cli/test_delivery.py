"""Reports and files of the studies: whatever goes wrong with one costs no other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

import pytest
import typer

from strainwave.cli import pictures
from strainwave.cli.delivery import check_outputs, deliver
from strainwave.design import save
from strainwave.errors import StrainwaveError
from tests.cli.command import run
from tests.studies.small import small
from tests.studies.tolerance.runs import FILE

VARY = ["--vary", "wave_generator.w0=0.212:0.2125"]
VERBS: dict[str, list[object]] = {
    "compare": ["--with", "cosine"],
    "optimize": [*VARY, "--population", 8, "--generations", 2],
    "sweep": ["--vary", "wave_generator.w0=0.212:0.214:2"],
    "tolerance": [FILE, "--samples", 64, "--sobol-samples", 64],
    "tune": [],
}


@dataclass
class Found:
    """A result that is quickly found."""

    interrupted: bool = False

    def to_json(self) -> str:
        return "{}"


def report(_: Found) -> Iterator[str]:
    yield "the report"


def full(_: Found) -> Iterator[str]:
    raise OSError("No space left on device")
    yield ""


def touch(path: Path, *, overwrite: bool) -> None:
    path.write_text(f"overwrite={overwrite}")


def refuse(path: Path, *, overwrite: bool) -> NoReturn:
    raise StrainwaveError(f"{path}: cannot be written")


def test_files_that_are_asked_for_are_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    deliver(Found(), report, [(tmp_path / "a", touch), (None, refuse)], as_json=False, overwrite=True)
    assert capsys.readouterr().out == "the report\n"
    assert (tmp_path / "a").read_text() == "overwrite=True"


def test_json_takes_the_place_of_the_report(capsys: pytest.CaptureFixture[str]) -> None:
    deliver(Found(), full, [], as_json=True, overwrite=False)
    assert capsys.readouterr().out == "{}\n"


def test_a_full_output_costs_no_file(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="No space left"):
        deliver(Found(), full, [(tmp_path / "a", touch), (tmp_path / "b", touch)], as_json=False, overwrite=False)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b"]


def test_a_file_that_cannot_be_written_costs_no_other(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = [(tmp_path / "a", refuse), (tmp_path / "b", touch), (tmp_path / "c", refuse)]
    with pytest.raises(StrainwaveError, match=r"a: cannot be written; .*c: cannot be written"):
        deliver(Found(), report, files, as_json=False, overwrite=False)
    assert [path.name for path in tmp_path.iterdir()] == ["b"]
    assert capsys.readouterr().out == "the report\n"


def test_an_interrupted_study_is_delivered_and_exits_130(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit) as stop:
        deliver(Found(interrupted=True), report, [(tmp_path / "a", touch)], as_json=False, overwrite=False)
    assert stop.value.exit_code == 130
    assert (tmp_path / "a").exists()
    assert capsys.readouterr().out == "the report\n"


@pytest.mark.parametrize("verb", [*VERBS, "analyze"])
def test_two_outputs_in_one_file_are_refused(verb: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    save(small(), tmp_path / "small.toml")
    (tmp_path / "link").symlink_to(tmp_path)
    outputs = ["--csv", tmp_path / "a.png", "--plot", tmp_path / "link" / "a.png", "--force"]
    outcome = run(capsys, verb, tmp_path / "small.toml", *VERBS.get(verb, []), *outputs)
    assert (outcome.code, outcome.out) == (2, "")
    assert "a.png: is named for two outputs" in outcome.err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["link", "small.toml"]


def test_a_device_takes_two_outputs() -> None:
    check_outputs([], [Path("/dev/null"), Path("/dev/null")], overwrite=False)


@pytest.mark.parametrize("verb", VERBS)
def test_ctrl_c_while_a_picture_is_drawn_costs_nothing_else(
    verb: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Drawing is what takes time in the end, so a second Ctrl-C comes there."""

    def interrupted(*_: object, **__: object) -> NoReturn:
        raise KeyboardInterrupt

    monkeypatch.setattr(pictures, "write_picture", interrupted)
    save(small(), tmp_path / "small.toml")
    arguments = ["--csv", tmp_path / "a.csv", "--plot", tmp_path / "a.png"]
    design, *others = tmp_path / "small.toml", *VERBS[verb]
    outcome = run(capsys, verb, design, *others, *arguments)
    assert (outcome.code, outcome.err) == (130, "strainwave: interrupted\n")
    assert outcome.out
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv", "small.toml"]
