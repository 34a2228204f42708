"""Folders written whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.errors import StrainwaveError
from strainwave.whole_folder import write_whole_folder

FILES = {"best.toml": "one\n", "front-01.toml": "7°\n"}
OLD = {"front-123.toml": "old"}
OWN = ("best.toml", "front-N.toml")


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_new_folder_holds_all_files_and_leaves_no_draft(tmp_path: Path) -> None:
    paths = write_whole_folder(tmp_path / "new", FILES, OWN)
    assert [path.read_text(encoding="utf-8") for path in paths] == list(FILES.values())
    assert names(tmp_path) == ["new"]


def test_an_empty_folder_is_filled(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    write_whole_folder(tmp_path / "empty", FILES, OWN)
    assert names(tmp_path / "empty") == list(FILES)
    assert names(tmp_path) == ["empty"]


def test_a_folder_of_its_own_files_is_replaced_only_on_request(tmp_path: Path) -> None:
    write_whole_folder(tmp_path / "old", OLD, OWN)
    with pytest.raises(StrainwaveError, match="holds files already; nothing was written"):
        write_whole_folder(tmp_path / "old", FILES, OWN)
    assert names(tmp_path / "old") == list(OLD)
    write_whole_folder(tmp_path / "old", FILES, OWN, overwrite=True)
    assert names(tmp_path / "old") == list(FILES)
    assert names(tmp_path) == ["old"]


@pytest.mark.parametrize(
    "other",
    ["my-gear.toml", "notes.txt", "front-1.toml", "front-01-mine.toml", "my-front-01.toml", "front-N.toml", "besttoml"],
)
@pytest.mark.parametrize("overwrite", [False, True])
def test_a_folder_with_a_file_of_another_name_is_never_replaced(other: str, overwrite: bool, tmp_path: Path) -> None:
    """That a file is a design file is not enough: it may be the one that is read, and the only one of its kind."""
    write_whole_folder(tmp_path / "mine", OLD, OWN)
    (tmp_path / "mine" / other).write_text("mine")
    with pytest.raises(
        StrainwaveError, match=f"holds {other}, which .* a new folder, or .* best.toml and front-N.toml"
    ):
        write_whole_folder(tmp_path / "mine", FILES, OWN, overwrite=overwrite)
    assert (tmp_path / "mine" / other).read_text() == "mine"
    assert names(tmp_path / "mine") == sorted([*OLD, other])
    assert names(tmp_path) == ["mine"]


def test_what_would_be_lost_is_counted(tmp_path: Path) -> None:
    for name in ("b.toml", "a.toml", "best.toml", "c.csv"):
        (tmp_path / name).write_text("mine")
    with pytest.raises(StrainwaveError, match=r"holds a\.toml and 2 more, which would be lost; nothing was written"):
        write_whole_folder(tmp_path, FILES, OWN, overwrite=True)


def test_a_folder_of_that_name_is_no_file_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "mine" / "best.toml").mkdir(parents=True)
    with pytest.raises(StrainwaveError, match=r"holds best\.toml, which would be lost"):
        write_whole_folder(tmp_path / "mine", FILES, OWN, overwrite=True)
    assert names(tmp_path / "mine") == ["best.toml"]


def test_the_current_folder_is_not_taken_away_from_under_whoever_is_in_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is moved to its place is another folder: other files of the same command would be written into none."""
    monkeypatch.chdir(tmp_path)
    for place in (Path(), tmp_path):
        with pytest.raises(
            StrainwaveError, match="is the current folder, which cannot be replaced; nothing was written"
        ):
            write_whole_folder(place, FILES, OWN, overwrite=True)
    assert names(tmp_path) == []
    write_whole_folder(Path("new"), FILES, OWN)
    assert names(tmp_path) == ["new"]


@pytest.mark.parametrize("failing", ["write_text", "rename"])
def test_what_was_there_stays_if_writing_fails(failing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_whole_folder(tmp_path / "old", OLD, OWN)
    really = getattr(Path, failing)

    def full(path: Path, *arguments: object, **options: object) -> object:
        if path.name == "front-01.toml" or path.name.endswith(".part"):
            raise OSError(28, "No space left on device")
        return really(path, *arguments, **options)

    monkeypatch.setattr(Path, failing, full)
    with pytest.raises(StrainwaveError, match="No space left on device"):
        write_whole_folder(tmp_path / "old", FILES, OWN, overwrite=True)
    monkeypatch.undo()
    assert names(tmp_path / "old") == list(OLD)
    assert names(tmp_path) == ["old"]


@pytest.mark.parametrize(
    ("name", "said"), [("no/such/place", "no directory"), ("file", "is a file"), ("a\0b", "cannot be")]
)
def test_an_impossible_place_is_one_clear_error(name: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    with pytest.raises(StrainwaveError, match=said):
        write_whole_folder(tmp_path / name, FILES, OWN)
