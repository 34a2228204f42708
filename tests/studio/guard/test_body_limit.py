"""How much may be sent at once."""

from __future__ import annotations

from collections.abc import AsyncIterator

import pytest

from strainwave.studio.guard.body_limit import LARGEST_BODY_BYTES, TOO_LARGE
from strainwave.toml_file import LARGEST_FILE_BYTES
from tests.studio.guard.asking import HOME, asked


@pytest.mark.parametrize("size", [0, 1, LARGEST_FILE_BYTES, LARGEST_BODY_BYTES])
def test_a_design_file_comes_through_whole(size: int) -> None:
    assert asked(HOME, "/said", "POST", content=b"x" * size).text == f"None {size}"


def test_the_largest_file_fits_with_its_form() -> None:
    answer = asked(HOME, "/said", "POST", files={"file": ("n" * 200, b"x" * LARGEST_FILE_BYTES)})
    assert answer.status_code == 200


@pytest.mark.parametrize("size", [LARGEST_BODY_BYTES + 1, 20_000_000])
@pytest.mark.parametrize("is_declared", [True, False])
def test_more_is_refused_in_words(size: int, is_declared: bool) -> None:
    async def chunks() -> AsyncIterator[bytes]:
        for _ in range(size // 100_000):
            yield b"x" * 100_000
        yield b"x" * (size % 100_000)

    content = b"x" * size if is_declared else chunks()
    answer = asked(HOME, "/said", "POST", content=content)
    assert (answer.status_code, answer.text) == (413, TOO_LARGE)


def test_what_is_declared_is_not_waited_for() -> None:
    async def never() -> AsyncIterator[bytes]:
        raise AssertionError("the body was read")
        yield b""

    answer = asked(HOME, "/said", "POST", content=never(), headers={"content-length": "99999999"})
    assert answer.status_code == 413
