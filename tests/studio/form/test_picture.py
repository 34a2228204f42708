"""The sketches below the form as paths."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from strainwave.design import Design, load
from strainwave.plots.profile import sides_of
from strainwave.studio.form.field import Field
from strainwave.studio.form.group import groups_of
from strainwave.studio.form.picture import generator_picture, tooth_pictures
from strainwave.studio.form.sheet import HEIGHT, WIDTH
from strainwave.studio.form.start import start_table
from tests.designs import case
from tests.studio.form.test_group import READY

NUMBER = r"-?[0-9]+\.[0-9]"


def _points(path: str) -> np.ndarray:
    return np.array([[float(x), float(y)] for x, y in re.findall(rf"({NUMBER}) ({NUMBER})", path)])


def _is_shown(field: Field, keys: set[str]) -> bool:
    return any(field.key == key or field.is_part_of(key) or key.startswith(f"{field.key}[") for key in keys)


def _profile_kinds() -> list[Design]:
    return [
        case().replace(f"{spline}.profile", start_table(case(), f"{spline}.profile", kind))
        for spline in ("flexspline", "circular_spline")
        for kind in ("double-circular-arc", "arc-line", "involute", "pieces")
        if getattr(case(), spline).profile.kind != kind
    ]


@pytest.mark.parametrize("design", [*map(load, READY), *_profile_kinds()])
def test_every_number_of_a_profile_has_its_stroke(design: Design) -> None:
    """But where one thing shows all that there is to see, as an involute's many arcs do, nothing is missing."""
    keys = {stroke.key for picture in tooth_pictures(design) for stroke in picture.strokes}
    for group in groups_of(design.to_dict()):
        if group.name.endswith(".profile"):
            assert [field.key for field in group.fields if not _is_shown(field, keys)] == []
    assert "flexspline.wall_thickness" in keys
    assert "wave_generator.w0" not in keys


@pytest.mark.parametrize("file", READY)
def test_the_teeth_lie_in_the_picture_at_one_scale(file: Path) -> None:
    design = load(file)
    scales = []
    for picture, side in zip(tooth_pictures(design), sides_of(design), strict=True):
        assert re.fullmatch(rf"(?:[ML]{NUMBER} {NUMBER}|Z)+", picture.body + picture.circles + picture.outline)
        drawn = _points(picture.body)
        assert drawn.min() >= 0.0
        assert drawn[:, 0].max() <= WIDTH
        assert drawn[:, 1].max() <= HEIGHT
        scales.append(np.ptp(_points(picture.outline)[:, 0]) / np.ptp(side.sketch.outline[:, 0]))
        assert np.ptp(_points(picture.outline)[:, 1]) == pytest.approx(
            scales[-1] * np.ptp(side.sketch.outline[:, 1]), abs=1.0
        )
    assert scales[0] == pytest.approx(scales[1], rel=5e-3)


def test_a_name_is_no_part_of_the_picture() -> None:
    named = case().replace("name", '"><script>alert(1)</script>')
    assert tooth_pictures(named) == tooth_pictures(case())


def test_a_generators_numbers_have_their_strokes() -> None:
    """Of every kind those that the design gives, but for a table's shape, which is no length."""
    design = case().replace({"wave_generator.bearing_height": 4.0})
    for kind in [kind.name for kind in groups_of(design.to_dict())[0].kinds]:
        table = design.wave_generator.model_dump(exclude_none=True)
        if kind != "cosine":
            table = start_table(design, "wave_generator", kind)
        if kind.endswith("roller"):
            table["roller_diameter"] = 20.0
        if kind == "ellipse":
            table["cam_to_neutral"] = 5.0
        picture = generator_picture(design.replace("wave_generator", table))
        keys = {stroke.key.removeprefix("wave_generator.") for stroke in picture.strokes}
        assert keys == table.keys() - {"kind", "neutral_curve", "samples", "fourier"}
        assert picture.body
        assert _points(picture.circles + picture.outline).min() >= 0.0
        assert _points(picture.circles + picture.outline)[:, 1].max() <= HEIGHT
