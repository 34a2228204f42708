"""Design files as they come and go."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from strainwave.design import dumps, loads
from strainwave.errors import DesignError
from strainwave.studio.header.design_file import DesignFile, saved
from strainwave.studio.header.examples import examples
from strainwave.toml_file import LARGEST_FILE_BYTES
from tests.designs import CASE_STUDY, case

PRINTED = (CASE_STUDY / "cosine.toml").read_bytes()


def test_what_was_opened_and_not_changed_is_saved_to_the_last_byte() -> None:
    for content in (PRINTED, b"\xef\xbb\xbf" + PRINTED.replace(b"\n", b"\r\n")):
        opened = DesignFile.opened("my gear.toml", content)
        assert opened.design == case()
        assert saved(opened.design, opened) == DesignFile("my gear.toml", content, opened.design)


def test_a_file_of_this_machine_is_read_as_it_is(tmp_path: Path) -> None:
    """Also through a pipe, which gives its bytes only once, and with a name in another coding than UTF-8."""
    path = tmp_path / os.fsdecode(b"gear f\xfcr 1.toml")
    path.write_bytes(b"\xef\xbb\xbf" + PRINTED)
    assert DesignFile.read(path) == DesignFile("gear f\ufffdr 1.toml", b"\xef\xbb\xbf" + PRINTED, case())
    reading, writing = os.pipe()
    os.write(writing, PRINTED)
    os.close(writing)
    assert DesignFile.read(Path(f"/dev/fd/{reading}")) == DesignFile(str(reading), PRINTED, case())
    os.close(reading)


def test_a_file_that_cannot_be_read_is_named_with_its_path(tmp_path: Path) -> None:
    faulty = tmp_path / "faulty.toml"
    faulty.write_bytes(PRINTED.replace(b"module = 0.8", b"module = -0.8"))
    for path, said in ((tmp_path / "none.toml", "there is no such file"), (faulty, "module = -0.8")):
        with pytest.raises(DesignError) as error:
            DesignFile.read(path)
        assert str(error.value).startswith(f"{path}: {said}")


def test_what_was_changed_keeps_the_files_name_and_holds_the_change() -> None:
    opened = DesignFile.opened("my gear.toml", PRINTED)
    changed = case().replace("wave_generator.w0", 0.86)
    file = saved(changed, opened)
    assert file.name == "my gear.toml"
    assert loads(file.content.decode()) == file.design == changed


def test_another_name_is_another_file() -> None:
    opened = DesignFile.opened("my gear.toml", PRINTED)
    assert saved(case().replace("name", "Other gear"), opened).name == "Other-gear.toml"
    assert saved(case("four-roller"), None).name == "Case-study-four-rollers.toml"
    assert saved(case().replace("name", "../../etc/passwd"), None).name == "etc-passwd.toml"


@pytest.mark.parametrize("file", examples(), ids=lambda file: file.name)
def test_what_is_saved_is_saved_again_as_the_same_bytes(file: DesignFile) -> None:
    once = saved(file.design, None).content
    assert loads(once.decode()) == file.design
    assert saved(DesignFile.opened("a.toml", once).design, None).content == once == dumps(file.design).encode()


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"\xff\xfe", "is not UTF-8 text"),
        (b"PK\x03\x04\x00", "is a binary file"),
        (b"#" * (LARGEST_FILE_BYTES + 1), "is larger than 1 MB"),
        (b"import os; os.system('boom')", "is not TOML"),
        (PRINTED.replace(b"module = 0.8", b"module = -0.8"), "module = -0.8"),
        (b"", "is empty"),
    ],
)
def test_anything_else_is_one_error_that_names_the_file(content: bytes, said: str) -> None:
    with pytest.raises(DesignError, match=r"^<b>\.toml: .*") as error:
        DesignFile.opened("<b>.toml", content)
    assert said in str(error.value)
