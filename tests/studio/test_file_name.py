"""Names of files come from what a user typed, and nothing of that can reach a path, a header or HTML."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from strainwave.studio.file_name import LONGEST, file_name


@pytest.mark.parametrize(
    ("title", "name"),
    [
        ("Case study, cosine cam", "Case-study-cosine-cam.dxf"),
        ("Größe 20 – Prüfstück", "Groe-20-Prufstuck.dxf"),
        ("../../etc/passwd", "etc-passwd.dxf"),
        ("..\\..\\x", "x.dxf"),
        ('"; rm -rf / #<script>', "rm-rf-script.dxf"),
        ("", "gear.dxf"),
        ("歯車", "gear.dxf"),
        (".bashrc", "bashrc.dxf"),
        ("-rf", "rf.dxf"),
        ("NUL", "gear-NUL.dxf"),
        ("com1", "gear-com1.dxf"),
        ("x" * 300, "x" * LONGEST + ".dxf"),
    ],
)
def test_only_plain_letters_are_left(title: str, name: str) -> None:
    assert file_name(title, ending=".dxf") == name


def test_the_program_adds_words_of_its_own() -> None:
    assert file_name("My gear", "flexspline", "tooth--3", ending=".csv") == "My-gear-flexspline-tooth--3.csv"


@given(st.text())
def test_any_title_gives_a_harmless_name(title: str) -> None:
    name = file_name(title, ending=".stl")
    assert re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_-]*\.stl", name)
    assert len(name) <= LONGEST + len(".stl")
