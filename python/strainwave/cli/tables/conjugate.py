"""The report of ``strainwave conjugate``: how well the pair touches, then where."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import grid, key_values
from strainwave.cli.tables.number import fixed, general, span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.conjugation import Conjugate


def conjugate_report(conjugate: Conjugate) -> Iterator[RenderableType]:
    """The profile, what the engine says of it, and its zones."""
    from rich.padding import Padding
    from rich.text import Text

    generator = conjugate.given.wave_generator
    yield Text(conjugate.given.title, "bold")
    yield Text(
        f"{conjugate.words} conjugate to the {conjugate.generation.mate_name}: {generator.kind}, w0 {generator.w0:g} mm"
    )
    yield Padding(_profile(conjugate), (1, 0, 0, 0))
    yield Padding(_zones(conjugate), (1, 0, 0, 0))
    yield from (Text(f"note: {note}", "dim") for note in _notes(conjugate))


def _profile(conjugate: Conjugate) -> Table:
    motion, fillet_mm = conjugate.in_motion, conjugate.root_fillet_radius_mm
    fillet = f"root fillet {fixed(fillet_mm, 4)} mm" if fillet_mm else "no root fillet"
    table = key_values()
    table.add_row(
        "profile",
        f"{conjugate.pieces} arcs and lines within {fixed(conjugate.deviation_um, 4)} µm of the envelope, {fillet}",
    )
    table.add_row("gap in the zones", f"{span(*conjugate.gap_in_zones_um, digits=4)} µm")
    table.add_row(
        "least in motion",
        f"{fixed(motion.gap_um, 4)} µm at tooth index ±{fixed(motion.index)} "
        f"(certified to {motion.certified_to_um:g} µm)",
    )
    table.add_row("double contact", _double(conjugate))
    return table


def _double(conjugate: Conjugate) -> str:
    spans = ", ".join(span(*each) for each in conjugate.double_contact)
    return f"at tooth index {spans}" if spans else "nowhere"


def _zones(conjugate: Conjugate) -> Table:
    mate, new = conjugate.generation.mate_name, conjugate.words
    table = grid("zone", "tooth index", "from axis °", f"{mate}:\nfrom mid-tip mm", f"{new}:\nabove pitch circle mm")
    for zone in conjugate.zones:
        table.add_row(
            zone.piece,
            span(*zone.index),
            span(*zone.phi_deg, digits=1),
            span(*zone.given_u_mm, digits=3),
            span(*zone.height_mm, digits=3),
        )
    return table


def _notes(conjugate: Conjugate) -> Iterator[str]:
    mate, key = conjugate.generation.mate_name, f"{conjugate.generation.table}.profile.offset"
    wanted_mm = conjugate.wanted_fillet_radius_mm
    yield f"zones are pieces of the {mate} that touch the right flank; the left one touches at the opposite index."
    yield f"{key} is {general(conjugate.offset_mm)} mm, what the arcs deviate; make it lower for clearance."
    if conjugate.root_fillet_radius_mm < wanted_mm:
        yield f"the root fillet of {wanted_mm:.4f} mm is reduced to what the {mate}'s tip leaves room for."
