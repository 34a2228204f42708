"""Zones in words and numbers."""

from __future__ import annotations

import pytest

from strainwave.conjugation.zone import ConjugateZone, Span, in_double_contact, merged


def zone(first: float, last: float, piece: str = "convex arc") -> ConjugateZone:
    return ConjugateZone(piece, (first, last), (2 * first, 2 * last), (0.1 * first, 0.1 * last), (-last, -first))


@pytest.mark.parametrize(
    ("spans", "double"),
    [
        ([(0.0, 1.0), (2.0, 3.0)], []),
        ([(0.0, 1.0), (1.0, 3.0)], []),
        ([(0.0, 2.0), (1.0, 3.0)], [(1.0, 2.0)]),
        ([(0.0, 5.0), (1.0, 2.0), (2.0, 4.0)], [(1.0, 4.0)]),
        ([(0.0, 2.0), (0.0, 1.0), (0.5, 2.0)], [(0.0, 2.0)]),
        ([(0.0, 1.0 + 1e-9), (1.0, 3.0)], []),  # rounding where contact passes on
        ([(0.0, 5.0), (1.0, 2.0 - 1e-9), (2.0, 4.0)], [(1.0, 4.0)]),
    ],
)
def test_double_contact_is_where_two_zones_share_indices(spans: list[Span], double: list[Span]) -> None:
    assert list(in_double_contact([zone(*span) for span in spans])) == double


def test_zones_that_pass_on_between_pieces_of_one_name_are_one() -> None:
    found = merged([zone(2.0, 3.0), zone(1.0, 2.0 + 1e-12), zone(0.5, 1.0, "flank line"), zone(0.0, 0.4, "flank line")])
    assert [(each.piece, each.index) for each in found] == [
        ("convex arc", (1.0, 3.0)),
        ("flank line", (0.5, 1.0)),
        ("flank line", (0.0, 0.4)),
    ]
    assert found[0].phi_deg == (2.0, 6.0)
    assert found[0].given_u_mm == pytest.approx((0.1, 0.3))
    assert found[0].height_mm == pytest.approx((-3.0, -1.0))
