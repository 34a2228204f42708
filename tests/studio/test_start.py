"""How a window starts."""

from __future__ import annotations

from strainwave.studio.link import design_code
from strainwave.studio.start import started
from tests.designs import case


def code(name: str) -> str:
    found = design_code(case(name))
    assert found is not None
    return found


def test_without_a_link_it_starts_with_the_studios_design() -> None:
    session, problem = started(case(), {"unknown": "x"})
    assert (session.design, session.pinned, problem) == (case(), None, None)


def test_a_link_brings_its_design_and_its_reference() -> None:
    query = {"design": code("four-roller"), "reference": code("dual-disk-0848")}
    session, problem = started(case(), query)
    assert problem is None
    assert session.design == case("four-roller")
    assert session.pinned is not None
    assert session.pinned.design == case("dual-disk-0848")
    assert session.pinned.threshold_um == session.analysis.threshold_um


def test_a_broken_link_brings_the_studios_design_and_says_why() -> None:
    broken = (
        {"design": "garbage"},
        {"design": code("four-roller"), "reference": "garbage"},
        {"design": code("four-roller")[:-5]},
    )
    for query in broken:
        session, problem = started(case(), query)
        assert (session.design, session.pinned) == (case(), None)
        assert problem is not None
        assert str(problem)


def test_a_link_to_a_gear_that_cannot_be_built_is_broken_too() -> None:
    impossible = design_code(case().replace("flexspline.profile.offset", 2.0))
    assert impossible is not None
    session, problem = started(case(), {"design": impossible})
    assert session.design == case()
    assert problem is not None
