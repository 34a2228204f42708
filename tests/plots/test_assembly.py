"""The picture of the assembled gear shows what the scene says, in print, on a screen, and without colours."""

from __future__ import annotations

import io

import matplotlib.image
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure

from strainwave.analysis import Analysis, analyze
from strainwave.plots import assembly_figure, picture_bytes
from strainwave.plots.clearance_colours import OVERLAP, STEPS, THRESHOLDS, clearance_colours, step_colour
from strainwave.plots.looks import LOOKS
from strainwave.scene import assembly_scene
from tests.designs import case


@pytest.fixture(scope="module")
def interfering() -> Analysis:
    return analyze(case("dual-disk-0848-calibrated"))


@pytest.fixture(scope="module")
def clear() -> Analysis:
    return analyze(case("cosine-calibrated"))


def teeth_of(figure: Figure) -> list[PolyCollection]:
    return [each for each in figure.axes[0].collections if isinstance(each, PolyCollection)]


def luminance(colour: str) -> float:
    """Of a colour on a screen from 0 to 1 (IEC 61966-2-1, ITU-R BT.709)."""
    channels = np.array(to_rgb(colour))
    linear = np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)
    return float(linear @ (0.2126, 0.7152, 0.0722))


def test_every_tooth_is_drawn_once_in_the_colour_of_its_clearance(interfering: Analysis) -> None:
    figure = assembly_figure(interfering, generator_angle_deg=12.0)
    scene = assembly_scene(interfering, generator_angle_deg=12.0)
    free, overlapping = teeth_of(figure)
    drawn = {}
    for collection in (free, overlapping):
        for path, colour in zip(collection.get_paths(), collection.get_facecolor(), strict=True):
            drawn[tuple(np.asarray(path.vertices)[0].round(6))] = to_hex(tuple(np.asarray(colour).tolist())).upper()
    assert len(drawn) == 204
    for tooth in scene.teeth:
        expected = clearance_colours(np.array([tooth.clearance_um]), interfering.threshold_um)[0]
        assert drawn[tuple(tooth.outline_mm[0].round(6))] == expected
    assert free.get_hatch() is None
    assert overlapping.get_hatch() is not None
    assert len(overlapping.get_paths()) == sum(map(len, scene.overlapping))


def test_closer_teeth_are_darker_in_grey_too_and_overlaps_have_a_hatch_of_their_own() -> None:
    grey = [luminance(step_colour(step)) for step in range(STEPS)]
    assert np.all(np.diff(grey) > 0.0)
    assert grey[-1] - grey[0] > 0.7
    threshold = 8.0
    edges = np.array([0.0, THRESHOLDS * threshold, 1e4])
    assert clearance_colours(edges, threshold) == [step_colour(0), step_colour(STEPS - 1), step_colour(STEPS - 1)]
    assert clearance_colours(np.array([-1e-9]), threshold) == [OVERLAP]


def test_interference_is_said_and_crossed_at_every_tooth(interfering: Analysis) -> None:
    axes = assembly_figure(interfering).axes[0]
    crosses = [np.asarray(line.get_xydata()) for line in axes.get_lines() if line.get_marker() == "X"]
    scene = assembly_scene(interfering)
    assert sum(map(len, crosses)) == sum(map(len, scene.overlapping)) == 32
    words = [text.get_text() for text in axes.texts]
    assert "teeth 33 … 40\n−14.57 µm" in words
    assert any("32 of 204 teeth INTERFERE" in each for each in words)


def test_without_interference_nothing_looks_like_it(clear: Analysis) -> None:
    figure = assembly_figure(clear)
    assert [line for line in figure.axes[0].get_lines() if line.get_marker() == "X"] == []
    assert [collection.get_hatch() for collection in teeth_of(figure)] == [None]
    assert any("no interference at this angle" in text.get_text() for text in figure.axes[0].texts)
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert "interfering tooth" not in labels
    assert {"circular spline", "flexspline", "cam with its bearing", "neutral curve", "major axis"} <= set(labels)


def test_chosen_teeth_are_numbered_with_their_clearances(interfering: Analysis) -> None:
    figure = assembly_figure(interfering, teeth=(31, 35))
    words = [text.get_text() for text in figure.axes[0].texts]
    gaps = dict(zip(interfering.teeth.tooth.tolist(), interfering.teeth.backlash_um.tolist(), strict=True))
    for tooth in range(31, 36):
        assert f"{tooth}\n{gaps[tooth]:.2f}".replace("-", "−") in words
    ringed = next(line for line in figure.axes[0].get_lines() if line.get_marker() == "o")
    assert len(np.asarray(ringed.get_xydata())) == 3  # 33, 34, 35
    assert figure.axes[0].get_xlabel().startswith("mm    (the gear turned by −58.")


def test_the_pixels_have_the_colours_of_the_parts(interfering: Analysis) -> None:
    picture = io.BytesIO(picture_bytes(assembly_figure(interfering), "png"))
    drawn = np.asarray(matplotlib.image.imread(picture))[..., :3]

    def share_of(colour: str | None) -> float:
        assert colour is not None
        return float((np.abs(drawn - to_rgb(colour)).max(axis=-1) < 0.02).mean())

    assert share_of(LOOKS["circular spline"].face) > 0.1
    assert share_of(LOOKS["wave generator"].face) > 0.3
    assert share_of(OVERLAP) > 1e-3


@pytest.mark.parametrize("kind", ["png", "svg", "pdf"])
def test_a_picture_is_the_same_bytes_each_time(kind: str, clear: Analysis) -> None:
    pictures = {picture_bytes(assembly_figure(clear, teeth=(0, 2)), kind) for _ in range(2)}
    assert len(pictures) == 1
