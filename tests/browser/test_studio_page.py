"""The studio's page as a whole."""

from __future__ import annotations

from tests.browser.conftest import OpenStudio


def test_it_opens_quietly(open_studio: OpenStudio) -> None:
    page = open_studio()
    assert page.page.title().endswith("strainwave")
    for name in ("Gear", "w0", "Generators", "Tolerance", "Optimise", "3D", "Export", "Report"):
        assert page.page.get_by_role("tab", name=name, exact=True).is_visible()
