"""Design files that cannot be read: one clear error each."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest

from strainwave.design import load, loads, template
from strainwave.design.reader import LARGEST_FILE_BYTES
from strainwave.errors import DesignError
from tests.designs import CASE_STUDY, case


def fault(path: str | Path) -> str:
    with pytest.raises(DesignError) as caught:
        load(path)
    assert caught.value.source == os.fspath(path)
    assert caught.value.__suppress_context__ or caught.value.__context__ is None  # no second traceback behind it
    (only,) = caught.value.faults
    return str(only)


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"", "is empty: it holds no design. Start from the template that `strainwave new` writes"),
        (b"# only a comment\n", "is empty"),
        (b"\xef\xbb\xbf", "is empty"),  # a byte-order mark
        (b"\x7fELF\x00\x01", "is a binary file, not a design in TOML"),
        (b"name = 'x'\nname2 = '\xff'", "line 2: is not UTF-8 text"),
        (b"module = ", "the end of the file: is not TOML"),
        (b"a = 1\nmodule 0.8\n", "line 2, column 8: is not TOML"),
        (b"a = 1\r\nb = 2\r\nmodule 0.8\r\n", "line 3, column 8: is not TOML"),
        (b"module = 0.8\nmodule = 0.9\n", "Cannot overwrite a value. The line reads: module = 0.9"),
        (b"a = " + b"[" * 50_000, "nests arrays or tables too deeply to read"),
        (b"module = " + b"9" * 5000, "holds a number of thousands of digits"),
        (b" " * (LARGEST_FILE_BYTES + 1), "is larger than 1 MB"),
    ],
)
def test_a_file_that_is_no_design(tmp_path: Path, content: bytes, expected: str) -> None:
    path = tmp_path / "gear.toml"
    path.write_bytes(content)
    assert expected in fault(path)


def test_a_place_that_is_no_file(tmp_path: Path) -> None:
    assert fault(tmp_path) == "is a directory, not a design file"
    assert fault(tmp_path / "none.toml") == "there is no such file"
    assert "cannot be read" in fault("a\0b")
    assert "cannot be read" in fault(tmp_path / ("x" * 300))


def test_a_file_that_may_not_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def denied(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", denied)  # a root user may read everything, so the mode alone proves nothing
    assert fault(tmp_path / "gear.toml") == "may not be read: permission denied"


def test_an_endless_file_is_not_read_to_its_end() -> None:
    assert "is larger than 1 MB" in fault("/dev/zero")


def test_a_design_comes_through_a_pipe(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    writer = threading.Thread(target=pipe.write_text, args=[template()])
    writer.start()
    assert load(pipe) == loads(template())
    writer.join()


def test_a_byte_order_mark_and_windows_line_ends_are_read(tmp_path: Path) -> None:
    text = (CASE_STUDY / "cosine.toml").read_text(encoding="utf-8")
    path = tmp_path / "gear.toml"
    path.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert load(path) == case()


def test_keys_nested_thousands_deep_are_one_unknown_key() -> None:
    with pytest.raises(DesignError) as caught:
        loads(".".join("a" * 3_000) + " = 1")
    assert "a: is not a key of the top of the file" in str(caught.value)


def test_a_table_nested_thousands_deep_in_place_of_a_number_is_one_fault() -> None:
    with pytest.raises(DesignError, match="module = a table: must be a number"):
        loads("module" + ".a" * 3_000 + " = 1")


def test_hexadecimal_numbers_of_any_length_are_refused() -> None:
    with pytest.raises(DesignError, match="module = a number of thousands of digits"):
        loads("module = 0x" + "f" * 6000)
