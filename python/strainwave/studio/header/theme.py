"""Light and dark."""

from __future__ import annotations

from nicegui.element import Element

# Before the first paint, so that a dark page does not start with a white flash.
EARLY_THEME = """<script>
  try {
    const theme = localStorage.getItem("strainwave:theme");
    const dark = theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
    document.documentElement.style.background = dark ? "#16191c" : "#ffffff";
  } catch {}
</script>"""


class ThemeButton(Element, component="theme.js"):
    """Goes from the system's choice to light, dark and back; the browser remembers."""
