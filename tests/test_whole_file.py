"""Files written whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.errors import StrainwaveError
from strainwave.whole_file import write_whole


def test_a_new_file_holds_the_content_and_leaves_no_draft(tmp_path: Path) -> None:
    write_whole(tmp_path / "a", b"\x00\xff")
    assert (tmp_path / "a").read_bytes() == b"\x00\xff"
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


def test_text_is_written_as_utf_8(tmp_path: Path) -> None:
    write_whole(tmp_path / "a", "7°\n")
    assert (tmp_path / "a").read_bytes() == b"7\xc2\xb0\n"


def test_a_file_is_replaced_only_on_request(tmp_path: Path) -> None:
    target = tmp_path / "a"
    target.write_text("old")
    with pytest.raises(StrainwaveError, match="is there already; nothing was written"):
        write_whole(target, "new")
    assert target.read_text() == "old"
    write_whole(target, "new", overwrite=True)
    assert target.read_text() == "new"


def test_what_was_there_stays_if_writing_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "a"
    target.write_text("old")

    def full(path: Path, content: bytes) -> int:
        path.open("wb").close()
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(StrainwaveError, match="No space left on device"):
        write_whole(target, "new", overwrite=True)
    assert target.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["a"]


@pytest.mark.parametrize("name", ["no/such/directory/a", "a\0b", "", "x" * 300])
def test_an_impossible_place_is_one_clear_error(tmp_path: Path, name: str) -> None:
    with pytest.raises(StrainwaveError, match=r"cannot be written|is a directory"):
        write_whole(f"{tmp_path}/{name}", "")
