"""What a user of the studio waits for, measured in the page itself."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from tests.browser.studio_page import StudioPage

W0 = "wave_generator.w0"
PROFILE = "flexspline.profile.tip_arc_radius"
# From the event that changes a value to the frame in which the distribution of its analysis is drawn.
WATCH = """() => {
  const isWatched = window.waits !== undefined;
  window.waits = [];
  if (isWatched) return;
  let began = null;
  const begin = (event) => { began ??= event.timeStamp; };
  for (const type of ["keydown", "input"]) window.addEventListener(type, begin, { capture: true });
  new MutationObserver(() => {
    if (began !== null) window.waits.push(performance.now() - began);
    began = null;
  }).observe(document.documentElement, { attributes: true, attributeFilter: ["data-drawn"] });
}"""
# The times between frames in which the generator stands elsewhere than in the frame before.
FRAMES = """(seconds) => new Promise((done) => {
  const turned = document.querySelector(".gear-turned"), times = [];
  let shown = "";
  const end = performance.now() + 1000 * seconds;
  const frame = (now) => {
    if (turned.textContent !== shown) { shown = turned.textContent; times.push(now); }
    if (now < end) requestAnimationFrame(frame); else done(times);
  };
  requestAnimationFrame(frame);
})"""


@dataclass(frozen=True)
class Way:
    """A way to change a value: the place that has the focus, and the keys that are pressed there in turn."""

    name: str
    place: str
    keys: tuple[str, ...]


# Up more than down and back again, so that no analysis is one that was asked for just before.
STEPS = ("ArrowUp", "ArrowUp", "ArrowUp", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowUp")
WAYS = (
    Way("w0, a step of the slider (1 µm)", f'input[type="range"][data-key="{W0}"]', STEPS),
    Way("w0, typed: each digit", f'input[inputmode][data-key="{W0}"]', ("Backspace", "7", "Backspace", "6")),
    Way("tip arc of the flexspline, a step of the slider", f'input[type="range"][data-key="{PROFILE}"]', STEPS),
)


def waits_ms(studio: StudioPage, way: Way, count: int) -> list[float]:
    """So many changes, each made when the one before is drawn; the first ones, which warm up, are left out."""
    place = studio.page.locator(way.place)
    place.scroll_into_view_if_needed()
    place.focus()
    warm = len(way.keys)
    for number in range(count + warm):
        if number == warm:
            studio.run(WATCH)
        studio.redrawn_after(lambda number=number: studio.page.keyboard.press(way.keys[number % warm]))
    return [float(wait) for wait in studio.run("window.waits")]


def frames_per_second(studio: StudioPage, seconds: float) -> tuple[float, float]:
    """While the mesh plays: the mean, and of the slowest frame in a hundred."""
    studio.page.get_by_role("button", name="Play").click()
    studio.page.wait_for_timeout(500)
    times = [float(time) for time in studio.page.evaluate(FRAMES, seconds)]
    studio.page.get_by_role("button", name="Pause").click()
    between = sorted(later - earlier for earlier, later in pairwise(times))
    return 1000.0 * len(between) / sum(between), 1000.0 / between[int(0.99 * (len(between) - 1))]
