"""Folders written whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.errors import StrainwaveError
from strainwave.whole_folder import write_whole_folder

FILES = {"a.toml": "one\n", "b.toml": "7°\n"}


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_a_new_folder_holds_all_files_and_leaves_no_draft(tmp_path: Path) -> None:
    paths = write_whole_folder(tmp_path / "new", FILES)
    assert [path.read_text(encoding="utf-8") for path in paths] == list(FILES.values())
    assert names(tmp_path) == ["new"]


def test_an_empty_folder_is_filled(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    write_whole_folder(tmp_path / "empty", FILES)
    assert names(tmp_path / "empty") == list(FILES)
    assert names(tmp_path) == ["empty"]


def test_a_folder_of_design_files_is_replaced_only_on_request(tmp_path: Path) -> None:
    write_whole_folder(tmp_path / "old", {"z.toml": "old"})
    with pytest.raises(StrainwaveError, match="holds files already; nothing was written"):
        write_whole_folder(tmp_path / "old", FILES)
    assert names(tmp_path / "old") == ["z.toml"]
    write_whole_folder(tmp_path / "old", FILES, overwrite=True)
    assert names(tmp_path / "old") == list(FILES)
    assert names(tmp_path) == ["old"]


@pytest.mark.parametrize("other", ["notes.txt", "folder.toml"])
def test_a_folder_with_anything_else_is_never_replaced(other: str, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    if other.endswith("txt"):
        (tmp_path / "mine" / other).write_text("mine")
    else:
        (tmp_path / "mine" / other).mkdir()
    with pytest.raises(StrainwaveError, match="holds more than design files"):
        write_whole_folder(tmp_path / "mine", FILES, overwrite=True)
    assert names(tmp_path / "mine") == [other]


@pytest.mark.parametrize("failing", ["write_text", "rename"])
def test_what_was_there_stays_if_writing_fails(failing: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_whole_folder(tmp_path / "old", {"z.toml": "old"})
    really = getattr(Path, failing)

    def full(path: Path, *arguments: object, **options: object) -> object:
        if path.name == "b.toml" or path.name.endswith(".part"):
            raise OSError(28, "No space left on device")
        return really(path, *arguments, **options)

    monkeypatch.setattr(Path, failing, full)
    with pytest.raises(StrainwaveError, match="No space left on device"):
        write_whole_folder(tmp_path / "old", FILES, overwrite=True)
    monkeypatch.undo()
    assert names(tmp_path / "old") == ["z.toml"]
    assert names(tmp_path) == ["old"]


@pytest.mark.parametrize(
    ("name", "said"), [("no/such/place", "no directory"), ("file", "is a file"), ("a\0b", "cannot be")]
)
def test_an_impossible_place_is_one_clear_error(name: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    with pytest.raises(StrainwaveError, match=said):
        write_whole_folder(tmp_path / name, FILES)
