"""The mesh's colours on a light page are those of the pictures."""

from __future__ import annotations

import re
from importlib import resources

from strainwave.plots.looks import LOOKS
from strainwave.plots.style import INK

STYLES = resources.files("strainwave.studio").joinpath("gear/gear.css").read_text(encoding="utf-8")


def colours(theme: str) -> dict[str, str]:
    found = re.search(rf"body\.body--{theme} \{{(?P<inner>.*?)\}}", STYLES, re.DOTALL)
    assert found is not None
    return dict(re.findall(r"--gear-([\w-]+): (#\w{6});", found["inner"]))


def test_faces_on_a_light_page_are_those_of_the_pictures() -> None:
    light = colours("light")
    faces = {
        role: look.face or look.edge
        for role, look in LOOKS.items()
        if role not in ("flexspline tooth", "witness", "mark")
    }
    assert {name: colour.upper() for name, colour in light.items() if name.replace("-", " ") in faces} == {
        role.replace(" ", "-"): face.upper() for role, face in faces.items()
    }
    assert light["edge"].upper() == INK


def test_a_dark_page_has_a_colour_for_each() -> None:
    assert colours("dark").keys() == colours("light").keys()
