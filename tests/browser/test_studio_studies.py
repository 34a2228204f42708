"""The studies in a live page: pointing, running, ending and taking over."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.cli.tables.number import fixed
from strainwave.design import Design, load
from strainwave.plots.tolerance import yield_text
from strainwave.studies import compare, tune
from strainwave.studies.optimization import optimize
from strainwave.studies.tolerance import analyze_tolerance, load_tolerances
from tests.browser.conftest import OpenStudio
from tests.browser.studio_page import StudioPage
from tests.designs import CASE_STUDY

if TYPE_CHECKING:
    from playwright.sync_api import Position

W0 = "wave_generator.w0"
TOLERANCES = CASE_STUDY.parent / "tolerances" / "series.toml"
LONGEST_MS = 120_000
# A search that ends at once.
SMALL = {"Generations": "4", "Population": "16", "from": "0.84", "to": "0.9"}


def served() -> Design:
    """What every window begins with."""
    return load(CASE_STUDY / "cosine-calibrated.toml")


def opened(open_studio: OpenStudio, tab: str, **options: object) -> StudioPage:
    studio = open_studio(**options)
    studio.page.set_default_timeout(LONGEST_MS)
    studio.page.get_by_role("tab", name=tab, exact=True).click()
    return studio


def chart(studio: StudioPage) -> None:
    """Wait until it is drawn."""
    studio.wait_for("document.querySelector('.q-tab-panel:not([style*=none]) .picture .nsewdrag') !== null")


def shows(studio: StudioPage, words: str) -> None:
    studio.page.get_by_text(words).first.wait_for()


def key_figure(studio: StudioPage, analysis: Analysis) -> None:
    """Wait until the key figures are those of an analysis."""
    least = fixed(analysis.min_in_motion_um, 3)
    studio.wait_for(f"document.querySelector('.studio-figures').innerText.includes('{least}')")


def press(studio: StudioPage, name: str) -> Callable[[], None]:
    return lambda: studio.page.get_by_role("button", name=name, exact=True).click()


def fill(studio: StudioPage, **values: str) -> None:
    """Type numbers, which are sent a moment after the last key, by label with "_" for a space."""
    for label, value in values.items():
        studio.page.get_by_label(label.replace("_", " "), exact=True).fill(value)
    studio.page.wait_for_timeout(600)


def choose(studio: StudioPage, figure: str, direction: str) -> None:
    """Make a figure an objective, or none."""
    studio.choose(f"Objective: {figure}", direction)


def drawn(studio: StudioPage, script: str) -> Any:
    """Something of the chart that is seen."""
    return studio.run(
        f"(() => {{ const plot = document.querySelector('.picture.js-plotly-plot'); return {script}; }})()"
    )


def test_a_click_into_the_chart_takes_that_w0(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "w0")
    chart(studio)
    shows(studio, tune(served()).verdict)
    box = studio.page.locator(".picture .nsewdrag").bounding_box()
    assert box is not None
    at: Position = {"x": 0.55 * box["width"], "y": 0.8 * box["height"]}
    low, high = drawn(studio, "plot._fullLayout.xaxis.range")
    wanted = round(low + 0.55 * (high - low), 3)
    studio.page.locator(".picture .nsewdrag").click(position=at)
    studio.wait_for("document.querySelector('.picture').data.find((each) => each.meta === 'own').x[0] !== 0.848")
    taken = drawn(studio, "plot.data.find((each) => each.meta === 'own').x[0]")
    assert taken == pytest.approx(wanted, abs=1.001e-3)  # the pixel that is pointed at
    assert taken == round(float(str(taken)), 3)
    key_figure(studio, analyze(served().replace(W0, taken)))
    studio.page.keyboard.press("Control+z")
    key_figure(studio, analyze(served()))


def test_a_goal_s_button_takes_its_exact_w0(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "w0")
    best = tune(served()).best["precision"]
    press(studio, f"Take w0 {fixed(best.w0_mm, 6)} mm: {best.why}")()
    key_figure(studio, best.analysis)


def test_the_chart_follows_the_theme(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "w0")
    chart(studio)
    assert drawn(studio, "plot._fullLayout.paper_bgcolor") in ("white", "#ffffff")
    studio.run("document.body.classList.replace('body--light', 'body--dark')")
    surface = studio.run("getComputedStyle(document.body).getPropertyValue('--surface').trim()")
    studio.wait_for(f"document.querySelector('.picture')._fullLayout.paper_bgcolor === '{surface}'")
    assert drawn(studio, "plot._fullLayout.font.color") != "#222222"


def test_a_generator_is_compared_and_taken(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "Generators")
    for kind in ("ellipse", "two-roller", "dual-disk"):
        studio.page.get_by_role("checkbox", name=kind).click()
    press(studio, "Compare")()
    (_, found) = compare(served(), ["four-roller"]).at("tuned")
    assert found.analysis is not None
    press(studio, f"Take four-roller 19.5° with w0 {fixed(found.analysis.design.wave_generator.w0, 4)} mm")()
    key_figure(studio, found.analysis)
    studio.page.get_by_text("four-roller 19.5° (the design's own)").wait_for()


def test_a_tolerance_file_is_run_and_saved_again(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = opened(open_studio, "Tolerance")
    with studio.page.expect_file_chooser() as chooser:
        press(studio, "Open file")()
    chooser.value.set_files(TOLERANCES)
    shows(studio, "circular_spline.eccentricity")
    fill(studio, **{"Samples": "256", "Sobol' samples": "64", "Seed": "3"})
    press(studio, "Run")()
    tolerances = load_tolerances(TOLERANCES)
    alone = analyze_tolerance(served(), tolerances, samples=256, sobol_samples=64, seed=3)
    shows(studio, f"Yield {yield_text(alone.yield_)}")
    chart(studio)
    name, content = studio.downloaded(press(studio, "Save file"))
    again = tmp_path / name
    again.write_bytes(content)
    assert load_tolerances(again) == tolerances


def test_a_file_that_holds_no_tolerances_is_one_message(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = opened(open_studio, "Tolerance")
    file = tmp_path / "wrong.toml"
    file.write_text('name = "<img src=x onerror=alert(1)>"\ntolerances = 3\n', encoding="utf-8")
    with studio.page.expect_file_chooser() as chooser:
        press(studio, "Open file")()
    chooser.value.set_files(file)
    shows(studio, "wrong.toml: tolerances = 3")
    assert studio.page.locator("img[src=x]").count() == 0


def test_an_optimisation_is_run_and_cancelled(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "Optimise")
    page = studio.page
    fill(studio, Generations="1000", Population="1000")
    press(studio, "Optimise")()
    page.get_by_text(re.compile(r"generation \d+ of 1000; best so far: teeth-below \d+")).wait_for()
    press(studio, "Cancel")()
    page.get_by_text("The optimisation was cancelled.").wait_for()
    assert page.get_by_role("button", name="Optimise", exact=True).is_enabled()
    assert page.locator(".study-run:visible").count() == 0


def test_an_optimisation_is_run_to_its_end_and_taken(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "Optimise")
    fill(studio, **SMALL)
    choose(studio, "evenness", "least")
    press(studio, "Optimise")()
    alone = optimize(served(), {W0: (0.84, 0.9)}, ["teeth-below", "evenness"], population=16, generations=4)
    shows(studio, f"{len(alone)} designs on the Pareto front")
    chart(studio)
    press(studio, f"Take design {len(alone)} over")()
    key_figure(studio, analyze(alone.designs[-1]))


def test_a_point_of_the_front_is_taken_with_a_click(open_studio: OpenStudio) -> None:
    studio = opened(open_studio, "Optimise")
    fill(studio, **SMALL)
    for figure, direction in (("teeth-below", "none"), ("evenness", "least"), ("play", "greatest")):
        choose(studio, figure, direction)
    press(studio, "Optimise")()
    alone = optimize(served(), {W0: (0.84, 0.9)}, ["evenness", "play=max"], population=16, generations=4)
    chart(studio)
    place = len(alone) // 2
    x, y = drawn(
        studio,
        f"""(([axes, at]) => [axes._fullLayout.xaxis.d2p(at[0]) + axes._fullLayout.xaxis._offset,
        axes._fullLayout.yaxis.d2p(at[1]) + axes._fullLayout.yaxis._offset])(
        [plot, [{alone.figures["evenness"][place]}, {alone.figures["play"][place]}]])""",
    )
    studio.page.locator(".picture").scroll_into_view_if_needed()
    studio.page.locator(".picture").click(position={"x": x, "y": y})
    key_figure(studio, analyze(alone.designs[place]))
