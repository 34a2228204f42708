"""The package's front: names on demand."""

from __future__ import annotations

import subprocess
import sys

import pytest

import strainwave


@pytest.mark.parametrize("name", [*strainwave.__all__, "__version__"])
def test_every_public_name_is_there(name: str) -> None:
    assert getattr(strainwave, name) is not None
    assert name in dir(strainwave)


def test_the_names_offered_are_the_names_known() -> None:
    assert sorted(strainwave.__all__) == sorted(strainwave._HOME_OF)


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="no attribute 'analyse'"):
        strainwave.analyse  # noqa: B018


def test_import_loads_nothing_heavy() -> None:
    code = "import sys, strainwave; print(*{name.split('.')[0] for name in sys.modules})"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"numpy", "scipy", "matplotlib", "pydantic", "rich"} & set(loaded)


def test_loading_a_design_needs_neither_scipy_nor_matplotlib_nor_the_kernel() -> None:
    code = (
        "import sys; from strainwave.design import loads, template; loads(template())\n"
        "print(*{name.split('.')[0] for name in sys.modules}, 'strainwave._kernel' in sys.modules)"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"scipy", "matplotlib", "rich", "True"} & set(loaded)
