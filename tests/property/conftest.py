"""How long the random tests run."""

from __future__ import annotations

import pytest

SOAK_FACTOR = 20


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--soak", action="store_true", help=f"run the random tests at {SOAK_FACTOR} times their length")


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """A test with an argument `block` runs once per block of seeds, as many as its `BLOCKS` says."""
    if "block" in metafunc.fixturenames:
        soak = metafunc.config.getoption("--soak", default=False)
        metafunc.parametrize("block", range(metafunc.module.BLOCKS * (SOAK_FACTOR if soak else 1)))
