"""The studio's gear in a browser: drawn where the kernel says, and what is said of it is what the API says."""

from __future__ import annotations

import json
import math
from itertools import pairwise, product
from typing import Any, get_args

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from strainwave.analysis import Analysis, analyze
from strainwave.columns import Floats
from strainwave.outlines import placed
from strainwave.plots.clearance_colours import OVERLAP
from strainwave.plots.looks import PALE_ORANGE
from strainwave.plots.style import VERMILION
from strainwave.scene.poses import tooth_poses
from strainwave.scene.turning import Fixed, Turning
from strainwave.studio.gear.gear_message import gear_message
from strainwave.studio.link import design_code
from tests.browser.conftest import OpenStudio
from tests.browser.local_page import Pixels
from tests.browser.studio_page import StudioPage
from tests.designs import case
from tests.scene.gears import gear

MESH, CHART = ".gear-mesh", ".gear-chart"
AROUND = 6.0  # modules about the circular spline's pitch circle in the view of the whole gear
CASE = "cosine-calibrated"


@pytest.fixture
def studio(open_studio: OpenStudio) -> StudioPage:
    """A window in which the gear has been drawn."""
    return drawn(open_studio())


def drawn(page: StudioPage) -> StudioPage:
    page.wait_for("Number(document.documentElement.dataset.drawn ?? 0) > 0")
    return page


def asked(page: StudioPage, script: str, *given: Any) -> Any:
    """What a function over the gear's modules gives."""
    return page.page.evaluate(script, [json.loads(json.dumps(each)) for each in given])


def angle_of(page: StudioPage) -> float:
    return float(page.page.locator(".gear-controls input[type=number]").input_value())


def turn_to(page: StudioPage, angle: float | str) -> None:
    field = page.page.locator(".gear-controls input[type=number]")
    field.fill(str(angle))
    field.press("Enter")


def card(page: StudioPage) -> dict[str, str]:
    """What is said of the tooth that is pointed at, once it is of the tooth as it stands."""
    page.wait_for("document.querySelector('.gear-card:not(.gear-late) [data-of=tooth]') !== null")
    found = page.page.locator(".gear-card [data-of]")
    return {each.get_attribute("data-of") or "": each.inner_text() for each in found.all()}


def expected(analysis: Analysis, tooth: int) -> dict[str, str]:
    """The same from the analysis at its angle."""
    teeth = analysis.teeth
    place = teeth.tooth.tolist().index(tooth)
    numbers = {
        "tooth": f"{tooth}",
        "index": f"{teeth.index[place]:.2f}",
        "left": f"{teeth.left_um[place]:.3f} µm",
        "right": f"{teeth.right_um[place]:.3f} µm",
    }
    return {key: words.replace("-", "−") for key, words in numbers.items()}


def share(pixels: Pixels, colour: str, *, within: float = 0.03) -> float:
    return float((np.abs(pixels / 255.0 - to_rgb(colour)).max(axis=-1) < within).mean())


def mesh_place(page: StudioPage, polar: float, radius: float) -> tuple[float, float]:
    """Where a point about the gear's axis is seen in the view of the whole gear: clockwise from the top, mm."""
    box = page.page.locator(MESH).bounding_box()
    assert box is not None
    design = case(CASE)
    scale = 0.5 * min(box["width"], box["height"]) / (design.circular_spline_pitch_radius_mm + AROUND * design.module)
    x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
    return x + scale * radius * math.sin(polar), y - scale * radius * math.cos(polar)


# ---- drawn where the kernel says ----

STANDING = """async ([message, questions]) => {
  const { Mesh } = await import("strainwave-gear/mesh.js");
  const mesh = new Mesh(message);
  return questions.map(([number, angle, fixed]) => {
    const { x, y, angle: turned, gap } = mesh.toothAt(number, angle, fixed);
    return [x, y, turned, gap];
  });
}"""


def test_teeth_stand_where_the_kernel_says(studio: StudioPage) -> None:
    """Of every kind of curve, few and many teeth, either spline held; gaps are interpolated, so off at their kinks."""
    for name, fixed in product(["cosine", "dual-disk", "51/53", "24/26", "100/104"], get_args(Fixed)):
        assert_teeth_stand(studio, gear(name), fixed)


def assert_teeth_stand(studio: StudioPage, analysis: Analysis, fixed: Fixed) -> None:
    for angle in (0.0, 71.3, -1234.5):
        turning = Turning.of(analysis.design, angle, fixed)
        exact = tooth_poses(analysis, turning)[::5]
        numbers = [*range(0, analysis.design.flexspline.teeth, 5)]
        questions = [[number, angle, fixed] for number in numbers]
        shown = np.array(asked(studio, STANDING, gear_message(analysis, 1), questions))
        np.testing.assert_allclose(shown[:, :2], exact[:, :2], atol=2e-5)
        difference = shown[:, 2] - exact[:, 2]
        np.testing.assert_allclose(np.sin(difference), 0.0, atol=1e-5)
        np.testing.assert_allclose(np.cos(difference), 1.0, atol=1e-9)
        index = np.array(numbers) - turning.relative_rad * analysis.design.circular_spline.teeth / math.tau
        gap_um = analysis.gap_curve.gap_um(index)
        assert np.median(np.abs(shown[:, 3] - gap_um)) < 1e-3
        assert np.abs(shown[:, 3] - gap_um).max() < 2.0


TRACED = """async ([segments, pose]) => {
  const { trace } = await import("strainwave-gear/paths.js"), calls = [];
  const note = (name) => (...given) => calls.push([name, ...given.map(Number)]);
  trace({ moveTo: note("move"), lineTo: note("line"), arc: note("arc") }, segments, ...pose);
  return calls;
}"""


def test_outlines_are_the_exact_profiles(studio: StudioPage) -> None:
    """Every point of the profile lies on one of the arcs and lines, to a picometre, and they are one chain."""
    for spline, pose in product(("flexspline", "circular_spline"), ((0.0, 0.0, 0.0), (30.0, -70.0, 2.5))):
        assert_outline(studio, spline, pose)


def assert_outline(studio: StudioPage, spline: str, pose: tuple[float, float, float]) -> None:
    segments = gear_message(gear("cosine"), 1)["tooth" if spline == "flexspline" else "ring_tooth"]
    chain: list[tuple[complex, complex, complex | None]] = []  # of every piece both ends, and the centre of an arc
    at = complex(math.nan)
    for name, *numbers in asked(studio, TRACED, segments, pose):
        begin = at
        if name == "arc":
            x, y, radius, first, last, against = numbers
            begin, at = (complex(x, y) + radius * np.exp(1j * turn) for turn in (first, last))
            assert (last < first) == bool(against)
            chain.append((begin, at, complex(x, y)))
        else:
            at = complex(*numbers)
            if name == "line":
                chain.append((begin, at, None))
    for (_, end, _), (begin, _, _) in pairwise(chain):
        assert abs(end - begin) < 1e-9
    points = on_profile(gear("cosine"), spline, pose)
    for point in points @ (1.0, 1j):
        assert min(distance(point, *piece) for piece in chain) < 1e-9


def distance(point: complex, begin: complex, end: complex, center: complex | None) -> float:
    """From a piece of a chain, or infinite where the point is not beside it."""
    along = ((point - begin) / (end - begin)).real
    if not -1e-6 < along < 1.0 + 1e-6:
        return math.inf
    if center is None:
        return abs(((point - begin) / (end - begin)).imag) * abs(end - begin)
    return abs(abs(point - center) - abs(begin - center))


def on_profile(analysis: Analysis, spline: str, pose: tuple[float, ...], beside_mm: float = 0.0) -> Floats:
    """Points of both halves of a tooth that stands at a pose, moved off its profile."""
    profile = getattr(analysis.geometry, spline)
    u = np.linspace(0.0, profile.length, 60)[1:-1]
    right = profile.position(u) + beside_mm * profile.normal(u)
    points = np.concatenate([right, right * (-1.0, 1.0)])
    return placed(np.column_stack([points, np.zeros((len(points), 3))]), np.array(pose))[:, :2]


ON_RING = """async ([message, points, some]) => {
  const { Painter } = await import("strainwave-gear/painter.js"), { Mesh } = await import("strainwave-gear/mesh.js");
  const painter = new Painter(document.createElement("canvas")), context = painter.context;
  painter.take(new Mesh(message));
  const path = some ? painter.someRing(57, 5) : painter.wholeRing();
  context.setTransform(1000, 0, 0, 1000, 0, 0);
  context.lineWidth = 0.02;
  return points.map(([x, y]) => context.isPointInStroke(path, 1000 * x, 1000 * y));
}"""


def test_the_circular_spline_is_where_the_kernel_says(studio: StudioPage) -> None:
    """All of it in the gear's frame, or the teeth in sight in that of tooth 57."""
    for some in (False, True):
        assert_ring(studio, some=some)


def assert_ring(studio: StudioPage, *, some: bool) -> None:
    analysis = gear("cosine")
    poses = analysis.geometry.engagement.circular_spline_poses(np.array([55.0, 57.0, 58.0]))
    middle = poses[1].copy()
    for beside_mm, there in ((0.0, True), (0.03, False)):
        for pose in poses:
            points = on_profile(analysis, "circular_spline", tuple(pose), beside_mm)
            if some:
                plane = (points @ (1.0, 1j) - complex(middle[0], middle[1])) * np.exp(1j * middle[2])
                points = np.column_stack([plane.real, plane.imag])
            found = asked(studio, ON_RING, gear_message(analysis, 1), points.tolist(), some)
            assert found == [there] * len(points)


LOOKED = """async ([given]) => {
  const { Camera } = await import("strainwave-gear/camera.js"), camera = new Camera();
  camera.resize(640, 340, 90);
  camera.look(0.7, 3, 81, 50);
  const there = camera.toWorld(...given), seen = [camera.toScreen(...there)];
  camera.zoom(37, ...given);
  seen.push(camera.toScreen(...there));
  camera.pan(0, 0);
  camera.grow(2); // a gear of twice the size
  seen.push(camera.toScreen(2 * there[0], 2 * there[1]));
  camera.zoom(1e9);
  return [seen, camera.scale, camera.toScreen(...camera.toWorld(...given))];
}"""


def test_what_is_looked_at_stays_where_it_is(studio: StudioPage) -> None:
    """Under the pointer while zooming, and as a gear grows, to a millionth of a pixel; zoomed in most, to a tenth."""
    for pixel in ([200.0, 30.0], [320.0, 170.0]):
        seen, scale, finest = asked(studio, LOOKED, pixel)
        np.testing.assert_allclose(seen, [pixel] * 3, atol=1e-6)
        assert scale == 1e6  # pixels of a nanometre
        np.testing.assert_allclose(finest, pixel, atol=0.1)


# ---- what is seen and said ----


def test_the_distribution_tells_the_least_gap(studio: StudioPage) -> None:
    least = analyze(case(CASE)).min_in_motion_um
    assert f"least in motion {least:.2f} µm" in (studio.page.locator(CHART).get_attribute("aria-label") or "")


def test_another_w0_is_redrawn_with_the_numbers_of_the_api(studio: StudioPage) -> None:
    before = studio.pixels(CHART)
    field = studio.page.locator("input[data-key='wave_generator.w0']").first
    field.fill("0.86")
    studio.redrawn_after(lambda: field.press("Enter"))
    analysis = analyze(case(CASE).replace("wave_generator.w0", 0.86))
    words = f"least in motion {analysis.min_in_motion_um:.2f} µm".replace("-", "−")
    assert words in (studio.page.locator(CHART).get_attribute("aria-label") or "")
    assert (studio.pixels(CHART) != before).any(axis=-1).mean() > 1e-3
    studio.page.locator(CHART).focus()
    studio.page.keyboard.press("ArrowRight")
    shown = card(studio)
    assert shown.items() >= expected(analysis, int(shown["tooth"].replace("−", "-"))).items()


def test_the_tooth_under_the_pointer_shows_the_numbers_of_the_api(studio: StudioPage) -> None:
    turn_to(studio, 33.0)
    analysis = analyze(case(CASE), generator_angle_deg=33.0)
    radius = analysis.design.circular_spline_pitch_radius_mm
    for tooth in (20, -9):
        polar = (tooth + 0.5 - 0.5) * math.tau / 206  # its space: the circular spline stands still
        studio.page.mouse.move(*mesh_place(studio, polar, radius))
        studio.wait_for(f"document.querySelector('[data-of=tooth]')?.textContent === '{tooth}'.replace('-', '−')")
        assert card(studio).items() >= expected(analysis, tooth).items()
    studio.page.mouse.move(*mesh_place(studio, 0.0, 0.0))
    studio.wait_for("document.querySelector('[data-of=tooth]') === null")


def test_a_bar_under_the_pointer_shows_its_tooth_in_the_mesh(studio: StudioPage) -> None:
    before = studio.pixels(f"{MESH} canvas")
    box = studio.page.locator(CHART).bounding_box()
    assert box is not None
    studio.page.mouse.move(box["x"] + 0.75 * box["width"], box["y"] + 0.5 * box["height"])
    shown = card(studio)
    tooth = int(shown["tooth"].replace("−", "-"))
    assert 15 < tooth < 45
    assert shown.items() >= expected(analyze(case(CASE)), tooth).items()
    # The page says so to other views too, and the tooth is marked where it stands.
    x, y = mesh_place(studio, tooth * math.tau / 206, case(CASE).circular_spline_pitch_radius_mm)
    mesh = studio.page.locator(MESH).bounding_box()
    assert mesh is not None
    column, row = round(x - mesh["x"]), round(y - mesh["y"])
    near = np.s_[row - 8 : row + 9, column - 8 : column + 9]
    assert share(studio.pixels(f"{MESH} canvas")[near], VERMILION, within=0.15) > 0.02
    assert share(before[near], VERMILION, within=0.15) == 0.0
    # Once clicked it stays chosen, and its whole outline is seen nearby.
    studio.page.mouse.click(box["x"] + 0.75 * box["width"], box["y"] + 0.5 * box["height"])
    studio.page.get_by_role("button", name="Tooth", exact=True).click()
    studio.page.wait_for_timeout(200)
    assert card(studio)["tooth"] == shown["tooth"]
    assert share(studio.pixels(f"{MESH} canvas"), VERMILION) > 1e-3


def test_arrows_go_from_tooth_to_tooth(studio: StudioPage) -> None:
    studio.page.locator(CHART).focus()
    studio.page.keyboard.press("ArrowRight")
    first = int(card(studio)["tooth"].replace("−", "-"))
    analysis = analyze(case(CASE))
    assert abs(first) == analysis.min_tooth
    for key, tooth in (("ArrowRight", first + 1), ("ArrowLeft", first), ("ArrowLeft", first - 1)):
        studio.page.keyboard.press(key)
        studio.wait_for(f"document.querySelector('[data-of=tooth]')?.textContent === '{tooth}'.replace('-', '−')")
        assert card(studio).items() >= expected(analysis, tooth).items()
    studio.page.keyboard.press("Escape")
    studio.wait_for("document.querySelector('[data-of=tooth]') === null")


# ---- turning ----


def test_dragging_turns_the_generator_and_the_bars(studio: StudioPage) -> None:
    bars = studio.pixels(CHART)
    mesh = studio.pixels(f"{MESH} canvas")
    radius = 50.0
    studio.page.mouse.move(*mesh_place(studio, math.radians(10.0), radius))
    studio.page.mouse.down()
    for degrees in (40.0, 100.0, 145.0):
        studio.page.mouse.move(*mesh_place(studio, math.radians(degrees), radius), steps=4)
    studio.page.mouse.up()
    assert angle_of(studio) == pytest.approx(135.0, abs=1.0)
    assert (studio.pixels(CHART) != bars).any(axis=-1).mean() > 5e-3
    assert (studio.pixels(f"{MESH} canvas") != mesh).any(axis=-1).mean() > 5e-3


def test_dragging_elsewhere_moves_the_view_and_not_the_generator(studio: StudioPage) -> None:
    before = studio.pixels(f"{MESH} canvas")
    studio.page.mouse.move(*mesh_place(studio, 2.0, 100.0))
    studio.page.mouse.down()
    studio.page.mouse.move(*mesh_place(studio, 2.5, 90.0), steps=3)
    studio.page.mouse.up()
    assert angle_of(studio) == 0.0
    assert (studio.pixels(f"{MESH} canvas") != before).any(axis=-1).mean() > 0.01
    studio.page.get_by_role("button", name="Whole", exact=True).click()
    studio.page.mouse.move(2, 2)
    studio.page.wait_for_timeout(100)
    # The buttons above it, one of which has been pressed, are not quite as they were.
    differs = np.abs(studio.pixels(f"{MESH} canvas").astype(int) - before).max(axis=-1) > 8
    assert differs.mean() < 1e-3


def test_it_plays_until_it_is_stopped(studio: StudioPage) -> None:
    studio.page.get_by_role("button", name="Play", exact=True).click()
    studio.wait_for("Number(document.querySelector('.gear-controls input[type=number]').value) > 1")
    studio.page.get_by_role("button", name="Pause", exact=True).click()
    stopped = angle_of(studio)
    studio.page.wait_for_timeout(200)
    assert angle_of(studio) == stopped


def test_the_free_spline_turns_as_the_ratio_says(studio: StudioPage) -> None:
    """90 degrees of the generator are -2/204 or 2/206 of that for the free spline."""
    turn_to(studio, 90.0)
    for fixed, turned in (("flexspline", "circular spline at 0.874°"), ("circular-spline", "flexspline at −0.882°")):
        studio.page.get_by_label("Spline held fixed").select_option(fixed)
        assert studio.page.locator(".gear-turned").inner_text() == turned
    for typed, left_at in (("", 90.0), ("1e9", 0.0), ("-1e300", 0.0)):
        turn_to(studio, typed)
        assert angle_of(studio) == left_at


# ---- looking ----


def test_the_wheel_zooms_at_the_pointer(studio: StudioPage) -> None:
    """What is under the pointer stays there: the tooth at the top."""
    whole = studio.pixels(f"{MESH} canvas")
    studio.page.mouse.move(*mesh_place(studio, 0.0, case(CASE).circular_spline_pitch_radius_mm))
    for _ in range(12):
        studio.page.mouse.wheel(0, -300)
    studio.page.wait_for_timeout(200)
    assert card(studio)["tooth"] == "0"
    studio.page.locator(f"{MESH} canvas").focus()
    zoomed = studio.pixels(f"{MESH} canvas")
    assert (zoomed != whole).any(axis=-1).mean() > 0.4
    studio.page.keyboard.press("+")
    studio.page.wait_for_timeout(100)
    assert (studio.pixels(f"{MESH} canvas") != zoomed).any(axis=-1).mean() > 0.01


def test_at_its_gap_the_two_flanks_are_as_far_apart_as_they_are(studio: StudioPage) -> None:
    """A gap of 1.49 um fills 90 pixels: on its line the flexspline ends and the circular spline begins there."""
    analysis = analyze(case(CASE))
    studio.page.get_by_role("button", name="Gap", exact=True).click()
    shown = card(studio)
    tooth = int(shown["tooth"].replace("−", "-"))
    assert abs(tooth) == analysis.min_tooth
    studio.page.locator(CHART).focus()
    place = analysis.teeth.tooth.tolist().index(tooth)
    witness, flank = analysis.teeth.witnesses, int(analysis.teeth.witnesses.closer_flank[place])
    own, other = (each[place, flank] for each in (witness.flexspline_point_mm, witness.circular_spline_point_mm))
    pose = analysis.geometry.engagement.flexspline_poses(np.array([float(tooth)]))[0]
    polar = math.atan2(pose[0], pose[1])
    across = complex(*(other - own)) * np.exp(1j * polar)  # the tooth is seen upright
    direction = across / abs(across)
    studio.page.wait_for_timeout(300)
    box = studio.page.locator(MESH).bounding_box()
    assert box is not None
    pixels = studio.pixels(f"{MESH} canvas") / 255.0
    middle = 0.5 * complex(pixels.shape[1], pixels.shape[0])

    def seen(away: float, aside: float = 12.0) -> Floats:
        at = middle + (direction * (away + 1j * aside)).conjugate()
        return np.asarray(pixels[round(at.imag), round(at.real)])

    ring, surface = np.array(to_rgb(PALE_ORANGE)), np.ones(3)
    np.testing.assert_allclose(seen(-38.0), surface, atol=0.02)
    assert seen(-54.0)[2] > 0.3 > seen(-54.0)[0]  # the dark blue of a tooth that nearly touches
    # The circular spline touches with its corner, so it is met on the line itself, beyond the point that marks it.
    np.testing.assert_allclose(seen(60.0, 0.0), ring, atol=0.02)
    np.testing.assert_allclose(seen(25.0), surface, atol=0.02)


def test_a_double_click_follows_a_tooth(studio: StudioPage) -> None:
    whole = studio.pixels(f"{MESH} canvas")
    studio.page.mouse.dblclick(*mesh_place(studio, 0.5, case(CASE).circular_spline_pitch_radius_mm))
    tooth = card(studio)["tooth"]
    assert int(tooth) == round(0.5 * 206 / math.tau)
    assert (studio.pixels(f"{MESH} canvas") != whole).any(axis=-1).mean() > 0.4
    studio.page.get_by_role("button", name="Whole", exact=True).click()
    studio.page.wait_for_timeout(100)
    assert (studio.pixels(f"{MESH} canvas") != whole).any(axis=-1).mean() < 0.1  # but for the card and the highlight


# ---- other gears ----


def test_interference_is_seen(open_studio: OpenStudio) -> None:
    page = drawn(open_studio(f"?design={design_code(case('dual-disk-0848'))}"))
    assert share(page.pixels(f"{MESH} canvas"), OVERLAP) > 1e-3
    assert share(page.pixels(CHART), OVERLAP) > 0.01
    assert page.page.get_by_text("interferes", exact=True).is_visible()
    page.page.get_by_role("button", name="Tooth", exact=True).click()
    shown = card(page)
    assert "−" in shown["left"] + shown["right"]
    clear = drawn(open_studio())
    assert share(clear.pixels(f"{MESH} canvas"), OVERLAP) == 0.0


def test_parts_that_do_not_fit_are_left_out_in_words(open_studio: OpenStudio) -> None:
    roller = {"kind": "four-roller", "w0": 0.848, "roller_angle": 30.0, "roller_diameter": 90.0}
    page = drawn(open_studio(f"?design={design_code(case().replace('wave_generator', roller))}"))
    note = page.page.locator(".gear-note").inner_text()
    assert note == "The generator's parts are not drawn: rollers of more than 52.44 mm run into each other"


def test_a_pinned_design_is_a_second_curve(studio: StudioPage) -> None:
    studio.page.get_by_role("button", name="Pin", exact=True).click()
    studio.wait_for("document.querySelector('.gear-reference') !== null")
    field = studio.page.locator("input[data-key='wave_generator.w0']").first
    field.fill("0.86")
    studio.redrawn_after(lambda: field.press("Enter"))
    assert case(CASE).title in studio.page.locator(".gear-keys").inner_text()
    with_it = studio.pixels(CHART)
    studio.page.get_by_role("button", name="Unpin", exact=True).click()
    studio.wait_for("document.querySelector('.gear-reference') === null")
    studio.page.wait_for_timeout(100)
    assert (studio.pixels(CHART) != with_it).any(axis=-1).mean() > 1e-3


@pytest.mark.parametrize(("width", "height", "dark"), [(1280, 720, True), (1024, 768, False), (768, 1024, True)])
def test_it_fits_its_window_in_either_theme(open_studio: OpenStudio, width: int, height: int, dark: bool) -> None:
    page = drawn(open_studio(width=width, height=height, dark=dark))
    for part in (MESH, ".gear-controls", CHART):
        box = page.page.locator(part).bounding_box()
        assert box is not None
        assert box["width"] > 300
        assert box["x"] + box["width"] <= width
    assert page.run("document.documentElement.scrollWidth <= innerWidth")


def test_a_design_that_came_while_another_tab_was_open_is_drawn_on_return(studio: StudioPage) -> None:
    page = studio.page
    page.get_by_role("tab", name="Export", exact=True).click()
    field = page.locator("input[data-key='wave_generator.w0']").first
    field.fill("0.86")
    field.press("Enter")
    page.wait_for_timeout(300)
    studio.redrawn_after(lambda: page.get_by_role("tab", name="Gear", exact=True).click())
    least = analyze(case(CASE).replace("wave_generator.w0", 0.86)).min_in_motion_um
    words = f"least in motion {least:.2f} µm".replace("-", "−")
    assert words in (page.locator(CHART).get_attribute("aria-label") or "")
