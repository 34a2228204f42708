"""A folder holds one study; what is missing or broken is computed anew, and what is another's is left alone."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from strainwave.errors import StrainwaveError
from strainwave.studies.exploration import Exploration, explore, load_exploration
from strainwave.studies.exploration.plan import study_of
from strainwave.studies.exploration.rows import table_of
from tests.cli.command import run
from tests.designs import case
from tests.studies.exploration.clusters import arguments, content, finished
from tests.studies.exploration.runs import space_of

SPACE = space_of()


def study(folder: Path, **changes: object) -> Exploration:
    question = {"design": case(), "space": SPACE, "samples": 1000, "folder": folder, "chunk_rows": 64, **changes}
    return explore(**question)  # type: ignore[arg-type]


def shortened(file: Path) -> None:
    file.write_bytes(file.read_bytes()[:-100])


def emptied(file: Path) -> None:
    file.write_bytes(b"")


def replaced(file: Path) -> None:
    """By a chunk of the same study with other rows."""
    file.write_bytes(
        (file.parent / ("chunk-000015" if "000003" in file.name else "chunk-000002"))
        .with_suffix(".parquet")
        .read_bytes()
    )


@pytest.mark.parametrize("harm", [Path.unlink, shortened, emptied, replaced])
def test_a_chunk_that_is_missing_or_broken_is_computed_anew(harm: Callable[[Path], None], tmp_path: Path) -> None:
    whole = content(study(tmp_path / "study").place.path)
    for chunk in (3, 15):
        harm(tmp_path / "study" / "chunks" / f"chunk-{chunk:06d}.parquet")
    (tmp_path / "study" / "chunks" / ".chunk-000003.parquet.1234.part").write_bytes(b"left by a killed worker")
    before = load_exploration(tmp_path / "study")
    assert before.interrupted
    assert (len(before.finished), before.evaluated) == (14, 1000 - 64 - 40)
    told: list[int] = []
    after = study(tmp_path / "study", progress=lambda done, _: told.append(done))
    assert not after.interrupted
    assert told[0] == 896  # what is finished counts from the beginning
    assert told[-1] == 1000
    assert len(told) == 3
    assert content(tmp_path / "study") == whole


def test_a_draft_that_another_client_cleared_is_no_error_if_its_chunk_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = study(tmp_path / "study").place
    whole = content(place.path)
    monkeypatch.setattr("os.fsync", lambda _: place.clear_drafts())
    place.write(3, table_of(place.plan, 3))
    assert content(place.path) == whole
    place.file_of(3).unlink()
    with pytest.raises(StrainwaveError, match=r"chunk-000003\.parquet: cannot be written"):
        place.write(3, table_of(place.plan, 3))


def test_a_chunk_that_is_broken_inside_names_itself(tmp_path: Path) -> None:
    found = study(tmp_path / "study")
    file = found.place.file_of(7)
    data = bytearray(file.read_bytes())
    data[50:450] = bytes(400)  # the footer is as it was
    file.write_bytes(data)
    with pytest.raises(StrainwaveError, match=r"chunk-000007\.parquet: cannot be read; remove it and repeat"):
        found.summary()


def test_a_finished_study_computes_nothing_again(tmp_path: Path) -> None:
    study(tmp_path / "study")
    times = {path: path.stat().st_mtime_ns for path in (tmp_path / "study").rglob("*.*")}
    study(tmp_path / "study")
    assert {path: path.stat().st_mtime_ns for path in (tmp_path / "study").rglob("*.*")} == times


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"seed": 2}, "seed is 1 there and 2 here"),
        ({"samples": 2000}, "samples is 1000 there and 2000 here"),
        ({"design": case("cosine-calibrated")}, "design.name is"),
        ({"space": space_of(wave_generator__w0=(0.83, 0.91))}, "space.parameters[0].high is 0.9 there and 0.91 here"),
        ({"metrics": ["min_backlash_um"]}, "metrics[1] is "),
        ({"in_motion": True}, "in_motion is false there and true here"),
    ],
)
def test_another_study_in_the_folder_is_left_alone(change: dict[str, object], message: str, tmp_path: Path) -> None:
    study(tmp_path / "study")
    before = content(tmp_path / "study")
    with pytest.raises(StrainwaveError) as caught:
        study(tmp_path / "study", **change)
    assert str(caught.value).startswith(f"{tmp_path / 'study'}: holds another study: ")
    assert message in str(caught.value)
    assert content(tmp_path / "study") == before


def test_a_study_of_another_version_is_left_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    study(tmp_path / "study")
    monkeypatch.setattr("importlib.metadata.version", lambda _: "9.9.9")
    with pytest.raises(StrainwaveError, match=r'strainwave_version is "[0-9.]+" there and "9.9.9" here'):
        study(tmp_path / "study")


def test_a_chunk_of_another_study_is_left_alone(tmp_path: Path) -> None:
    study(tmp_path / "one")
    other = study(tmp_path / "two", seed=2).place.file_of(5)
    moved = tmp_path / "one" / "chunks" / other.name
    moved.write_bytes(other.read_bytes())
    with pytest.raises(StrainwaveError, match=r"chunk-000005\.parquet: belongs to another study; move it elsewhere"):
        study(tmp_path / "one")


def test_a_folder_of_other_things_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "photo.jpg").write_bytes(b"")
    with pytest.raises(StrainwaveError, match=r"holds something else than a study \(photo.jpg\)"):
        study(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["photo.jpg"]


def test_an_empty_folder_and_one_whose_manifest_was_never_finished_are_good(tmp_path: Path) -> None:
    (tmp_path / ".manifest.json.77.part").write_text("{", encoding="utf-8")
    assert not study(tmp_path).interrupted


def test_a_folder_that_cannot_be_is_one_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(StrainwaveError, match="is a file, not a folder"):
        study(tmp_path / "file")
    with pytest.raises(StrainwaveError, match="cannot be written: No such file or directory"):
        study(tmp_path / "not" / "there")
    with pytest.raises(StrainwaveError, match="cannot be written"):
        study(Path("/proc/study"))  # also root may write nothing there


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (None, "is no folder of an exploration: there is no manifest.json"),
        ("{", "cannot be read"),
        ("[]", "is not the manifest of an exploration"),
        ('{"kind": "strainwave exploration", "plan": {}}', "is damaged"),
    ],
)
def test_a_manifest_that_is_none_says_so(text: str | None, message: str, tmp_path: Path) -> None:
    if text is not None:
        (tmp_path / "manifest.json").write_text(text, encoding="utf-8")
    with pytest.raises(StrainwaveError, match=message):
        load_exploration(tmp_path)


def test_a_manifest_that_was_changed_is_refused(tmp_path: Path) -> None:
    study(tmp_path / "study")
    manifest = tmp_path / "study" / "manifest.json"
    record = json.loads(manifest.read_text(encoding="utf-8"))
    record["plan"]["seed"] = 2
    manifest.write_text(json.dumps(record), encoding="utf-8")
    with pytest.raises(StrainwaveError, match="was changed after the study began"):
        load_exploration(tmp_path / "study")


def test_a_study_of_a_version_whose_designs_had_fewer_keys_can_be_read(tmp_path: Path) -> None:
    """A key that later versions add has a default, which an old manifest does not hold."""
    found = study(tmp_path / "study", samples=64)
    manifest = tmp_path / "study" / "manifest.json"
    record = json.loads(manifest.read_text(encoding="utf-8"))
    del record["plan"]["design"]["circular_spline"]["profile"]["offset"]
    record["study"] = study_of(record["plan"])
    manifest.write_text(json.dumps(record), encoding="utf-8")
    opened = load_exploration_of(tmp_path / "study", found.place.plan.study, record["study"])
    assert opened.evaluated == 64


def load_exploration_of(folder: Path, named: str, renamed: str) -> Exploration:
    """The exploration after its chunk was given the other study's name, of the same length."""
    chunk = folder / "chunks" / "chunk-000000.parquet"
    chunk.write_bytes(chunk.read_bytes().replace(named.encode(), renamed.encode()))
    return load_exploration(folder)


def test_the_manifest_lists_design_space_seed_version_and_chunks(tmp_path: Path) -> None:
    import strainwave

    study(tmp_path / "study")
    record = json.loads((tmp_path / "study" / "manifest.json").read_text(encoding="utf-8"))
    assert record["plan"]["strainwave_version"] == strainwave.__version__
    assert record["plan"]["seed"] == 1
    assert strainwave.Design.from_dict(record["plan"]["design"]) == case()
    assert record["plan"]["space"] == SPACE.to_dict()
    assert [chunk["rows"] for chunk in record["chunks"]] == [64] * 15 + [40]
    assert all((tmp_path / "study" / chunk["file"]).is_file() for chunk in record["chunks"])


FULL_DISK = """
import resource, signal, sys
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv.pop(1)),) * 2)
from strainwave.cli import main
main(sys.argv[1:])
"""


def test_a_disk_that_takes_no_more_costs_no_finished_chunk(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A limit on the size of files stands for the full disk: the system refuses to write in both cases."""
    command = arguments(tmp_path / "study", 1000)[1:]
    assert run(capsys, *command).code == 0
    whole = content(tmp_path / "study")
    for chunk in (2, 9, 14):
        (tmp_path / "study" / "chunks" / f"chunk-{chunk:06d}.parquet").unlink()
    full = subprocess.run(
        [sys.executable, "-c", FULL_DISK, "1000", *command], capture_output=True, text=True, check=False
    )
    assert full.returncode == 2
    assert full.stderr.startswith(f"strainwave: {tmp_path / 'study' / 'chunks'}/chunk-0000")
    assert full.stderr.endswith(
        "cannot be written: File too large; 13 of 16 chunks are finished and kept; "
        "the same command goes on from there\n"
    )
    assert full.stderr.count("\n") == 1
    assert finished(tmp_path / "study") == len(content(tmp_path / "study")) - 1 == 13  # no draft is left
    assert run(capsys, *command).code == 0
    assert content(tmp_path / "study") == whole
