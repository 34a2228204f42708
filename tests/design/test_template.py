"""The template that `strainwave new` writes: valid as it is, and in every alternative that its comments offer."""

from __future__ import annotations

import re

import pytest

from strainwave.design import loads, template
from strainwave.geometry import Geometry
from tests.designs import case

KINDS = {
    "ellipse": "cam_to_neutral = 12.8",
    "two-roller": "roller_diameter = 40.0",
    "four-roller": "roller_angle = 19.5",
    "dual-disk": "wrap_angle = 13.0",
    "table": "samples = [1.0, 0.71, 0.0, -0.71, -1.0]",
}


def test_the_template_is_a_design_that_meshes() -> None:
    design = loads(template())
    assert Geometry.of(design).engagement.clearances([0.0]).gap.shape == (1, 2)
    assert design.wave_generator.neutral_curve == "inextensible"  # type: ignore[union-attr]
    assert design.flexspline == case().flexspline


@pytest.mark.parametrize("kind", KINDS)
def test_the_wave_generators_in_its_comments_are_valid(kind: str) -> None:
    text = template()
    assert f'#   kind = "{kind}"' in text
    assert f"#   {KINDS[kind]}" in text
    text = text.replace('kind = "cosine"', f'kind = "{kind}"\n{KINDS[kind]}')
    if kind == "ellipse":
        text = re.sub("^neutral_curve", "# neutral_curve", text, flags=re.M)
    assert Geometry.of(loads(text)).neutral_curve.radius == pytest.approx(79.8304)


def test_the_fourier_series_in_its_comments_is_the_cosine() -> None:
    assert "#   fourier = [0.0, 1.0]" in template()
    by_series = loads(template().replace('kind = "cosine"', 'kind = "table"\nfourier = [0.0, 1.0]'))
    curve = Geometry.of(by_series).neutral_curve
    assert curve.displacement(0.3) == pytest.approx(Geometry.of(loads(template())).neutral_curve.displacement(0.3))


def test_the_optional_keys_in_its_comments_are_valid() -> None:
    design = loads(re.sub(r"^# (?=[a-z_]+ = )", "", template(), flags=re.M))
    assert design.flexspline.neutral_radius == 79.8304
    assert design.wave_generator.bearing_height == 12.0
    assert (design.flexspline.face_width, design.flexspline.cup_length) == (27.2, 81.6)
    assert (design.flexspline.diaphragm_thickness, design.flexspline.boss_diameter) == (2.0, 95.0)
    assert (design.circular_spline.face_width, design.circular_spline.outer_diameter) == (27.2, 220.0)


def test_the_chain_in_its_comments_is_valid() -> None:
    lines = template().splitlines()
    first = next(i for i, line in enumerate(lines) if line == '#   kind = "pieces"')
    last = next(i for i, line in enumerate(lines) if i > first and line == "#   ]")
    chain = "\n".join(line.removeprefix("#   ") for line in lines[first : last + 1])
    head, tail = template().split("[circular_spline.profile]\n")
    generator = tail[tail.index("[wave_generator]") :]
    text = f"{head}[circular_spline.profile]\n{chain}\n\n{generator}"
    assert Geometry.of(loads(text)).circular_spline.roles.count("flank") == 3
