"""The studio's header in a browser: files, steps, the link, the look, the keys."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.design import Design, dumps, loads
from strainwave.studio.history import SAME_STEP_S
from strainwave.studio.link import coded_design, design_code
from strainwave.toml_file import LARGEST_FILE_BYTES
from tests.browser.conftest import OpenStudio
from tests.browser.studio_page import StudioPage
from tests.designs import CASE_STUDY, case

START = case("cosine-calibrated")
HOSTILE = """<script>boom = 1</script><img src=x onerror="boom = 2">'"`${boom}` {{ boom }} &lt;b&gt; é 🚀"""
SIZES = [(1280, 720), (1024, 768), (768, 1024)]


def titled(studio: StudioPage, design: Design) -> None:
    """Wait until the window shows a design, by its name."""
    studio.page.wait_for_function("(title) => document.title.startsWith(title)", arg=f"{design.title} – ")


def chosen(studio: StudioPage, *files: str | dict[str, object]) -> None:
    """Open a file as a user does."""
    with studio.page.expect_file_chooser() as chooser:
        studio.page.get_by_role("button", name="Open a design file").click()
    chooser.value.set_files(*files)  # type: ignore[arg-type]


def dropped(studio: StudioPage, name: str, content: str) -> None:
    """Drag a file over the middle of the page, see that it may be dropped, and drop it."""
    file = studio.page.evaluate_handle(
        """([name, content]) => {
            const dragged = new DataTransfer();
            dragged.items.add(new File([content], name));
            return dragged;
        }""",
        [name, content],
    )
    studio.page.dispatch_event(".studio-centre", "dragenter", {"dataTransfer": file})
    studio.page.get_by_text("Drop a design file to open it").wait_for(state="visible")
    studio.page.dispatch_event(".studio-centre", "dragover", {"dataTransfer": file})
    studio.page.dispatch_event(".studio-centre", "drop", {"dataTransfer": file})
    studio.page.get_by_text("Drop a design file to open it").wait_for(state="hidden")


def saved(studio: StudioPage) -> tuple[str, bytes]:
    return studio.downloaded(studio.page.get_by_role("button", name="Save the design file").click)


def named(studio: StudioPage, name: str) -> None:
    """Give the design another name."""
    studio.page.get_by_label("Design name").fill(name)
    studio.page.get_by_label("Design name").press("Enter")


def linked(studio: StudioPage) -> Design:
    """The design in the address bar."""
    code = studio.run("new URL(location.href).searchParams.get('design')")
    assert isinstance(code, str)
    return coded_design(code)


def code_of(design: Design) -> str:
    code = design_code(design)
    assert code is not None
    return code


def problem(studio: StudioPage) -> str:
    """What the dialog says; closes it."""
    text = studio.page.locator(".header-problem")
    text.wait_for(state="visible")
    said = text.inner_text()
    studio.page.get_by_role("button", name="Close").click()
    text.wait_for(state="hidden")
    return said


def test_a_file_that_is_opened_and_saved_is_the_same_file(open_studio: OpenStudio) -> None:
    """To the last byte with its comments; and what the studio itself has written it writes again."""
    studio = open_studio()
    chosen(studio, str(CASE_STUDY / "four-roller.toml"))
    titled(studio, case("four-roller"))
    assert saved(studio) == ("four-roller.toml", (CASE_STUDY / "four-roller.toml").read_bytes())
    changed = case("four-roller").replace("name", "Changed")
    named(studio, "Changed")
    titled(studio, changed)
    name, first = saved(studio)
    assert loads(first.decode()) == changed
    assert first == dumps(changed).encode()
    chosen(studio, str(CASE_STUDY / "cosine.toml"))
    titled(studio, case())
    chosen(studio, {"name": name, "mimeType": "application/toml", "buffer": first})
    titled(studio, changed)
    assert saved(studio) == (name, first)


def test_a_file_is_dropped_anywhere(open_studio: OpenStudio) -> None:
    studio = open_studio()
    content = (CASE_STUDY / "dual-disk-0900.toml").read_text(encoding="utf-8")
    dropped(studio, "my gear.toml", content)
    titled(studio, case("dual-disk-0900"))
    assert saved(studio) == ("my gear.toml", content.encode())


def test_what_is_no_design_is_said_as_text_and_changes_nothing(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = open_studio()
    titled(studio, START)
    dropped(studio, "<img src=x onerror='boom = 3'>.toml", HOSTILE)
    said = problem(studio)
    assert said.startswith("<img src=x onerror='boom = 3'>.toml: ")
    assert "is not TOML" in said
    large = tmp_path / "large.toml"
    large.write_bytes(b"#" * (LARGEST_FILE_BYTES + 1))
    chosen(studio, str(large))
    assert problem(studio) == "large.toml: is larger than 1 MB, so it is no design file"
    chosen(studio, {"name": "a.toml", "mimeType": "", "buffer": dumps(START.replace("name", "x")).encode() + b"\xff"})
    assert "is not UTF-8 text" in problem(studio)
    assert studio.run("typeof boom") == "undefined"
    # And the next good one is opened.
    chosen(studio, str(CASE_STUDY / "cosine.toml"))
    titled(studio, case())
    studio.page.keyboard.press("Control+z")
    titled(studio, START)


def test_a_link_reproduces_the_design_and_the_reference(open_studio: OpenStudio) -> None:
    studio = open_studio(f"?design={code_of(case('four-roller'))}&reference={code_of(case())}")
    titled(studio, case("four-roller"))
    assert studio.page.locator(".figures-reference-name").inner_text() == f"Against {case().title}"


def test_a_broken_link_is_said_and_the_start_design_shown(open_studio: OpenStudio) -> None:
    studio = open_studio("?design=<script>boom</script>")
    assert problem(studio).startswith("The link is damaged")
    titled(studio, START)
    studio.wait_for("location.search.includes('design=eN')")
    assert linked(studio) == START


def test_the_address_follows_the_design_without_a_longer_history(open_studio: OpenStudio) -> None:
    studio = open_studio()
    length = studio.run("history.length")
    for name in ("one", "two", HOSTILE):
        named(studio, name)
        titled(studio, START.replace("name", name))
    studio.page.get_by_role("button", name="Pin", exact=True).click()
    studio.wait_for("location.search.includes('reference=')")
    assert linked(studio) == START.replace("name", HOSTILE)
    studio.page.reload()
    titled(studio, START.replace("name", HOSTILE))
    assert studio.page.locator(".figures-reference-name").inner_text() == f"Against {HOSTILE}"
    assert studio.run("history.length") == length


def test_copy_link_gives_the_address(open_studio: OpenStudio) -> None:
    studio = open_studio()
    studio.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    named(studio, "Copied")
    studio.page.get_by_role("button", name="Copy a link").click()
    studio.page.get_by_text("Link copied").wait_for(state="visible")
    address = studio.run("navigator.clipboard.readText()")
    studio.page.goto(address)
    titled(studio, START.replace("name", "Copied"))


def test_a_hostile_name_is_text_everywhere(open_studio: OpenStudio) -> None:
    studio = open_studio()
    design = START.replace("name", HOSTILE)
    named(studio, HOSTILE)
    titled(studio, design)
    assert studio.page.get_by_label("Design name").input_value() == HOSTILE
    studio.page.get_by_role("button", name="Pin", exact=True).click()
    studio.wait_for("document.querySelector('.figures-reference-name').textContent.startsWith('Against <script>')")
    name, content = saved(studio)
    assert loads(content.decode()) == design
    assert name.isascii()
    for tab in ("w0", "Generators", "Tolerance", "Optimise", "3D", "Export", "Report", "Gear"):
        studio.page.get_by_role("tab", name=tab, exact=True).click()
        studio.page.wait_for_timeout(300)
    # In the page as it comes from the server, too.
    studio.page.reload()
    titled(studio, design)
    assert studio.run("typeof boom") == "undefined"
    assert studio.run("document.querySelectorAll('img[src=x]').length") == 0


def test_undo_and_redo_by_keys_but_not_in_unfinished_text(open_studio: OpenStudio) -> None:
    studio = open_studio()
    one, two = START.replace("name", "one"), START.replace("name", "two")
    for design in (one, two):
        studio.page.wait_for_timeout(1000.0 * SAME_STEP_S + 100.0)
        named(studio, design.name)
        titled(studio, design)
    # In the field, but with nothing unfinished in it.
    studio.page.keyboard.press("Control+z")
    titled(studio, one)
    studio.page.keyboard.press("Control+Shift+Z")
    titled(studio, two)
    # What is being typed is the field's own; the design stays.
    field = studio.page.get_by_label("Design name")
    field.press("End")
    field.press_sequentially("!!")
    studio.page.keyboard.press("Control+z")
    studio.page.wait_for_timeout(500)
    titled(studio, two)
    field.fill("three")
    field.press("Tab")
    titled(studio, START.replace("name", "three"))
    studio.page.get_by_role("button", name="Undo").click()
    titled(studio, two)
    studio.page.keyboard.press("Control+z")
    titled(studio, one)
    studio.page.keyboard.press("Control+y")
    titled(studio, two)


def test_save_by_key_takes_over_what_is_being_typed(open_studio: OpenStudio) -> None:
    studio = open_studio()
    studio.page.get_by_label("Design name").fill("Unfinished")
    _, content = studio.downloaded(lambda: studio.page.keyboard.press("Control+s"))
    assert loads(content.decode()) == START.replace("name", "Unfinished")


def test_a_ready_example_is_one_step(open_studio: OpenStudio) -> None:
    studio = open_studio()
    studio.page.get_by_role("button", name="Ready examples").click()
    studio.page.get_by_text("Involute, cosine cam", exact=True).click()
    studio.wait_for("document.title.startsWith('Involute')")
    studio.page.get_by_role("button", name="Undo").click()
    titled(studio, START)


def test_the_theme_is_the_systems_until_it_is_chosen_and_then_remembered(open_studio: OpenStudio) -> None:
    studio = open_studio(dark=True)
    studio.wait_for("document.body.classList.contains('body--dark')")
    studio.run("window.heard = []; addEventListener('strainwave:theme', (event) => heard.push(event.detail.dark))")
    button = studio.page.get_by_label("Theme:")
    button.click()
    studio.wait_for("document.body.classList.contains('body--light')")
    studio.page.reload()
    studio.wait_for("document.body.classList.contains('body--light')")
    studio.run("window.heard = []; addEventListener('strainwave:theme', (event) => heard.push(event.detail.dark))")
    button.click()
    studio.wait_for("document.body.classList.contains('body--dark')")
    button.click()
    studio.page.emulate_media(color_scheme="light")
    studio.wait_for("document.body.classList.contains('body--light')")
    assert studio.run("heard") == [True, True, False]


def test_everything_in_the_header_is_reached_by_tab(open_studio: OpenStudio) -> None:
    studio = open_studio()
    reached = []
    while "Keys and help" not in reached:
        studio.page.keyboard.press("Tab")
        assert studio.run("document.activeElement.matches(':focus-visible')")
        reached.append(str(studio.run("document.activeElement.ariaLabel ?? document.activeElement.innerText")))
        assert len(reached) < 20
        if reached[-1] == "Design name":
            studio.page.keyboard.type("Typed")
            studio.page.keyboard.press("Enter")
            titled(studio, START.replace("name", "Typed"))
    assert reached == [
        "To the design",
        "To the gear",
        "To the key figures",
        "Design name",
        "Undo",
        "Open a design file",
        "Save the design file",
        "Ready examples",
        "Copy a link to this design",
        "Theme: auto",
        "Keys and help",
    ]
    studio.page.keyboard.press("?")
    studio.page.get_by_text("save the design file", exact=True).wait_for(state="visible")
    studio.page.keyboard.press("Escape")
    studio.page.get_by_text("save the design file", exact=True).wait_for(state="hidden")


@pytest.mark.parametrize(("width", "height"), SIZES)
def test_the_page_fits_the_window(open_studio: OpenStudio, width: int, height: int) -> None:
    """Nothing is cut off at the side; on a wide window the panels scroll and the page does not."""
    studio = open_studio(width=width, height=height)
    assert studio.run("document.scrollingElement.scrollWidth <= innerWidth")
    if width >= 1024:
        assert studio.run("document.scrollingElement.scrollHeight <= innerHeight")
    buttons = "[...document.querySelectorAll('.studio-header button')]"
    assert studio.run(f"{buttons}.every((each) => each.getBoundingClientRect().right <= innerWidth)")


CONTRAST = """() => {
  const channel = (value) => (value /= 255) <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
  const parts = (colour) => colour.match(/[\\d.]+/g).map(Number);
  const ground = (element) => {
    for (let each = element; each; each = each.parentElement) {
      const colour = parts(getComputedStyle(each).backgroundColor);
      if (colour.length === 3 || colour[3] === 1) return colour;
    }
    return [255, 255, 255];
  };
  const faint = [];
  for (const element of document.querySelectorAll(".studio-header *, .studio-figures *, .studio-form *, .q-tab *")) {
    const text = [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
    if (!text || !element.checkVisibility() || element.closest("[disabled], .disabled, i, svg, option")) continue;
    const [one, other] = [luminance(parts(getComputedStyle(element).color)), luminance(ground(element))];
    const ratio = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
    if (ratio < 4.5) faint.push(`${element.className}: ${element.textContent.slice(0, 40)} ${ratio.toFixed(2)}`);
  }
  return faint;
}"""


@pytest.mark.parametrize("dark", [False, True])
def test_letters_stand_out_from_their_ground(open_studio: OpenStudio, dark: bool) -> None:
    studio = open_studio(f"?design={code_of(case('dual-disk-0848'))}&reference={code_of(START)}", dark=dark)
    studio.wait_for(f"document.body.classList.contains('body--{'dark' if dark else 'light'}')")
    studio.page.get_by_text("Reasons", exact=False).first.click()
    assert studio.run(f"({CONTRAST})()") == []
    # The look can fail.
    studio.page.add_style_tag(content=".figures-value { color: #777 !important; }")
    assert len(studio.run(f"({CONTRAST})()")) > 10
