"""The studio's form in a browser: what is typed and slid is what the session has, and nonsense does no harm."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import pytest

from strainwave.analysis import analyze
from tests.browser.conftest import OpenStudio
from tests.browser.studio_page import StudioPage
from tests.designs import case

if TYPE_CHECKING:
    from playwright.sync_api import Locator

W0, KIND = "wave_generator.w0", "wave_generator.kind"


@dataclass
class Form:
    """The form of one window."""

    window: StudioPage

    def entry(self, key: str) -> Locator:
        """Where a field is typed in, or chosen."""
        return self.window.page.locator(f":is(input.form-input, textarea, select)[data-key='{key}']")

    def slider(self, key: str) -> Locator:
        """Beside it."""
        return self.window.page.locator(f"input.form-slider[data-key='{key}']")

    def fault(self, key: str) -> str:
        """What is said beside a field."""
        return self.window.page.locator(f".form-row[data-key='{key}'] .form-fault").inner_text()

    def shows(self, key: str, text: str) -> None:
        """Wait until a field shows a text."""
        self.window.page.wait_for_function(
            "([key, text]) => document.querySelector(`:is(.form-input, .form-select, .form-area)[data-key='${key}']`)"
            "?.value === text",
            arg=[key, text],
        )

    def shows_fault(self, key: str, words: str) -> None:
        """Wait until words stand beside a field."""
        self.window.page.wait_for_function(
            "([key, words]) => document.querySelector(`.form-row[data-key='${key}'] .form-fault`)?.textContent"
            ".includes(words)",
            arg=[key, words],
        )

    def shows_backlash_of(self, changes: Mapping[str, Any]) -> None:
        """Wait until the page has the figure that the API gives for the design with changes."""
        least = analyze(case("cosine-calibrated").replace(changes)).min_backlash_um
        self.window.page.wait_for_function(
            "(text) => document.querySelector('.studio-figures').textContent.includes(text)",
            arg=f"{least:.3f}".replace("-", "−"),
        )


@pytest.fixture
def form(open_studio: OpenStudio) -> Form:
    opened = Form(open_studio())
    opened.shows(W0, "0.848")
    opened.shows_backlash_of({})
    return opened


def test_w0_typed_and_stepped_is_the_w0_of_the_figures(form: Form) -> None:
    form.entry(W0).fill("0.860")
    form.shows_backlash_of({W0: 0.86})
    slider = form.slider(W0)
    slider.focus()
    slider.press("ArrowRight")
    form.shows(W0, "0.861")
    slider.press("Shift+ArrowLeft")
    form.shows(W0, "0.851")
    slider.press("PageUp")
    slider.press("ArrowUp")
    form.shows(W0, "0.862")
    form.shows_backlash_of({W0: 0.862})
    form.entry(W0).press("PageDown")
    form.shows(W0, "0.852")
    form.shows_backlash_of({W0: 0.852})


def test_of_a_dragged_slider_the_last_change_arrives(form: Form) -> None:
    page = form.window.page
    # Faster than any hand: all in one frame.
    form.slider(W0).evaluate("""(slider) => {
      for (let step = 0; step <= 60; step++) {
        slider.value = 0.8 + 0.001 * step;
        slider.dispatchEvent(new Event("input"));
      }
    }""")
    form.shows_backlash_of({W0: 0.86})
    box = form.slider(W0).bounding_box()
    assert box is not None
    middle = box["y"] + 0.5 * box["height"]
    page.mouse.move(box["x"] + 0.5 * box["width"], middle)
    page.mouse.down()
    for step in range(20):
        page.mouse.move(box["x"] + (0.5 - 0.02 * step) * box["width"], middle)
    page.mouse.up()
    text = form.entry(W0).input_value()
    assert 0.748 <= float(text) < 0.8
    assert len(text) <= len("0.748")
    form.shows_backlash_of({W0: float(text)})
    # Let go near the end of its window, it gets another one.
    page.wait_for_function(
        "(number) => Math.abs(Number(document.querySelector('.form-slider[data-key=\"wave_generator.w0\"]').min)"
        " - (number - 0.1)) < 1e-6",
        arg=float(text),
    )


def test_nonsense_is_named_beside_its_field_and_a_good_value_heals_it(form: Form) -> None:
    form.entry(W0).fill("much <b>more</b>")
    form.entry(W0).press("Enter")
    form.shows_fault(W0, "Must be a number from 0.0001 to 1000000 mm. Write for example w0 = 0.848")
    assert form.entry(W0).get_attribute("aria-invalid") == "true"
    described = form.entry(W0).get_attribute("aria-describedby")
    assert described is not None
    words = [form.window.page.locator(f"[id='{name}']").inner_text() for name in described.split()]
    assert "Radial displacement" in words[0]
    assert words[1] == form.fault(W0)
    status = form.window.page.get_by_role("status").filter(has_text="last good design")
    assert "1 fault" in status.inner_text()
    form.shows_backlash_of({})
    form.window.page.get_by_role("button", name="Show", exact=True).click()
    assert form.window.run("document.activeElement.dataset.key") == W0
    form.entry(W0).fill("0.849")
    form.shows_backlash_of({W0: 0.849})
    form.window.page.wait_for_function("!document.querySelector('[aria-invalid=true]')")


def test_an_angle_goes_in_as_typed(form: Form) -> None:
    angle = "flexspline.profile.flank_angle"
    form.shows(angle, "7°30'30\"")
    form.entry(angle).fill("7°20'")
    form.entry(angle).blur()
    form.shows_backlash_of({angle: "7°20'"})
    assert form.entry(angle).input_value() == "7°20'"
    form.slider(angle).press("ArrowRight")
    form.shows(angle, str(round(7 + 1 / 3 + 0.01, 12)))


def test_a_generator_shows_its_own_parameters_and_they_come_back(form: Form) -> None:
    angle = "wave_generator.roller_angle"
    form.entry(KIND).select_option("four-roller")
    form.shows(angle, "19.5")
    kind = {"kind": "four-roller", "w0": 0.848, "neutral_curve": "first-order"}
    form.shows_backlash_of({"wave_generator": {**kind, "roller_angle": 19.5}})
    form.entry(angle).fill("25.5")
    form.shows_backlash_of({"wave_generator": {**kind, "roller_angle": 25.5}})
    form.entry(KIND).select_option("two-roller")
    form.entry(angle).wait_for(state="detached")
    form.entry(KIND).select_option("four-roller")
    form.shows(angle, "25.5")


def test_steps_back_are_shown(form: Form) -> None:
    page = form.window.page
    form.entry(W0).fill("0.9")
    form.entry(W0).press("Enter")
    form.shows_backlash_of({W0: 0.9})
    page.keyboard.press("Control+z")
    form.shows(W0, "0.848")
    form.shows_backlash_of({})
    page.keyboard.press("Control+Shift+z")
    form.shows(W0, "0.9")
    # While typing is not done with, it is the letters that are taken back.
    form.entry("module").press("End")
    page.keyboard.type("x")
    page.keyboard.press("Control+z")
    assert form.entry("module").input_value() == "0.8"
    assert form.entry(W0).input_value() == "0.9"


def test_what_is_being_typed_is_left_alone(form: Form) -> None:
    """Analyses of what was typed before come back meanwhile."""
    form.entry(W0).press("Control+a")
    form.window.page.keyboard.type("0")
    form.shows_fault(W0, "Must be a number")
    for letter in ".8561":
        form.window.page.keyboard.type(letter)
        form.window.page.wait_for_timeout(60)
    form.shows_backlash_of({W0: 0.8561})
    assert form.entry(W0).input_value() == "0.8561"


def test_the_field_in_focus_is_brought_out_in_the_sketch(form: Form) -> None:
    page = form.window.page
    assert page.locator(".sketch-stroke--out").count() == 0
    form.entry("flexspline.profile.tip_arc_center[1]").focus()
    out = page.locator(".sketch-stroke--out")
    assert [stroke.get_attribute("data-key") for stroke in out.all()] == ["flexspline.profile.tip_arc_center"]
    assert "Tip arc centre" in page.locator(".sketch-caption").inner_text()
    form.entry(W0).focus()
    assert [stroke.get_attribute("data-key") for stroke in out.all()] == [W0]
    assert "w0 0.848 mm" in page.locator(".sketch-caption").inner_text()
    form.entry("module").focus()
    assert out.count() == 0
    # And the other way round.
    page.locator(".sketch-stroke[data-key='circular_spline.profile.tip_arc_radius'] .sketch-hit").dispatch_event(
        "click"
    )
    assert form.window.run("document.activeElement.dataset.key") == "circular_spline.profile.tip_arc_radius"
    form.entry("circular_spline.profile.tip_arc_radius").fill("2.1")
    page.wait_for_function("document.querySelector('.sketch-caption').textContent.includes('2.1 m')")


def test_what_may_be_left_out_is_cleared(form: Form) -> None:
    radius = "flexspline.neutral_radius"
    assert form.entry(radius).get_attribute("placeholder") == "79.8304"
    form.entry(radius).fill("79.9")
    form.shows_backlash_of({radius: 79.9})
    form.window.page.get_by_role("button", name="Leave out Neutral radius").click()
    form.shows(radius, "")
    form.shows_backlash_of({})


@pytest.mark.parametrize(("width", "height", "dark"), [(1280, 720, False), (1024, 768, True), (768, 1024, False)])
def test_nothing_is_clipped(open_studio: OpenStudio, width: int, height: int, dark: bool) -> None:
    """No entry, label or slider sticks out of the panel, and none covers another."""
    form = Form(open_studio(width=width, height=height, dark=dark))
    form.shows(W0, "0.848")
    form.entry(KIND).select_option("dual-disk")
    form.shows("wave_generator.wrap_angle", "13")
    form.window.run("for (const group of document.querySelectorAll('.form-group')) group.open = true")
    wrong = form.window.run("""(() => {
      const panel = document.querySelector(".form-groups").getBoundingClientRect();
      const found = [];
      for (const row of document.querySelectorAll(".form-row")) {
        const parts = [...row.querySelectorAll(".form-label, .form-input, .form-select, .form-unit, .form-slider")];
        const boxes = parts.map((part) => part.getBoundingClientRect());
        boxes.forEach((box, place) => {
          const part = parts[place];
          if (box.right > panel.right + 0.5 || box.left < panel.left - 0.5) found.push([row.dataset.key, "sticks out"]);
          if (part.matches(".form-label, .form-unit") && part.scrollWidth > part.clientWidth + 1)
            found.push([row.dataset.key, part.className, "is clipped"]);
          for (const other of boxes.slice(place + 1))
            if (Math.min(box.right, other.right) - Math.max(box.left, other.left) > 0.5 &&
                Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top) > 0.5)
              found.push([row.dataset.key, "overlaps"]);
        });
      }
      return found;
    })()""")
    assert wrong == []
