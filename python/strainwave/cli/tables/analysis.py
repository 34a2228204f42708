"""The report of ``strainwave analyze``: the verdict first, then what it rests on."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.cli.tables.geometry import geometry_table
from strainwave.cli.tables.grid import grid, key_values
from strainwave.cli.tables.number import fixed, general, span, whole
from strainwave.cli.tables.zones import STATES, zones

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table
    from rich.text import Text

    from strainwave.analysis import Analysis

COLOURS = dict(zip(STATES, ("bold red", "yellow", ""), strict=True))


def analysis_report(analysis: Analysis, *, all_teeth: bool) -> Iterator[RenderableType]:
    """Everything that a designer acts on, in the order in which it is asked."""
    from rich.padding import Padding
    from rich.text import Text

    yield from _verdict(analysis)
    tables = (
        _tightest(analysis),
        _counts(analysis),
        _play(analysis),
        _every_tooth(analysis) if all_teeth else _zones(analysis),
        geometry_table(analysis.design, analysis.figures),
    )
    for table in tables:
        yield Padding(table, (1, 0, 0, 0))
    for warning in analysis.warnings:
        yield Text(f"note: {warning}", "dim")


def _verdict(analysis: Analysis) -> Iterator[Text]:
    from rich.text import Text

    design = analysis.design
    generator = design.wave_generator
    yield Text(design.title, "bold")
    yield Text(
        f"{generator.kind}, w0 {generator.w0:g} mm (w0* {generator.w0 / design.module:.4g}), "
        f"{analysis.figures.neutral_curve.model} neutral curve, module {design.module:g} mm, "
        f"ratio {fixed(design.ratio, 0 if design.ratio.is_integer() else 3)}"
    )
    colour = "bold red" if analysis.interference else "bold green"
    yield Text.assemble((analysis.verdict, colour), f" (certified to {analysis.in_motion.certified_to_um:g} µm)")


def _tightest(analysis: Analysis) -> Table:
    motion, witness = analysis.in_motion, analysis.witness_in_motion
    flank = witness.closer_flank[0]
    table = key_values()
    table.add_row(
        "least in motion",
        f"{fixed(motion.gap_um, 3)} µm at tooth index ±{fixed(motion.index)}, on the "
        f"flank {('towards', 'away from')[flank]} the major axis",
    )
    table.add_row(
        "between",
        f"{witness.flexspline_piece[0, flank]} of the flexspline and {witness.circular_spline_piece[0, flank]} of the "
        f"circular spline",
    )
    table.add_row(
        f"least at {general(analysis.generator_angle_deg)}°",
        f"{fixed(analysis.min_backlash_um, 3)} µm at tooth {whole(analysis.min_tooth)}",
    )
    if analysis.first_interfering_tooth is not None:
        table.add_row("first interfering", f"tooth {whole(analysis.first_interfering_tooth)}")
    table.add_row(
        "radial clearance",
        f"tip {fixed(analysis.tip_clearance_um, 1)} µm, root {fixed(analysis.root_clearance_um, 1)} µm",
    )
    return table


def _counts(analysis: Analysis) -> Table:
    table = grid("teeth at 0°", "per side", "per lobe", "drive")
    for name, count in (
        (f"0 ≤ backlash < {analysis.threshold_um:g} µm", analysis.teeth_below),
        ("interfering", analysis.teeth_interfering),
    ):
        table.add_row(name, whole(count.per_side), whole(count.lobe), whole(count.drive))
    return table


def _play(analysis: Analysis) -> Table:
    table = grid("play, one direction", "normal µm", "circumferential µm", "angular ″")
    for name, play in (
        (f"at {general(analysis.generator_angle_deg)}°", analysis.play),
        ("in motion", analysis.play_in_motion),
    ):
        table.add_row(name, fixed(play.normal_um), fixed(play.circumferential_um), fixed(play.angular_arcsec))
    return table


def _zones(analysis: Analysis) -> Table:
    teeth = analysis.teeth
    symmetric = analysis.generator_angle_deg == 0.0
    places = np.flatnonzero(teeth.index >= 0.0) if symmetric else np.arange(len(teeth))
    table = grid("teeth ±" if symmetric else "teeth", "from axis °", "backlash µm")
    table.add_column("state")
    table.add_column("closest: flexspline – circular spline")
    for state, pieces, run in zones(teeth, analysis.threshold_um, places):
        ends, gap_um = run[[0, -1]], teeth.backlash_um[run]
        table.add_row(
            span(*teeth.tooth[ends], digits=0),
            span(*teeth.phi_deg[ends], digits=1),
            span(gap_um.min(), gap_um.max()),
            state,
            pieces,
            style=COLOURS[state],
        )
    return table


def _every_tooth(analysis: Analysis) -> Table:
    teeth = analysis.teeth
    sides = ("left µm", "right µm")
    table = grid(
        "tooth",
        "from\naxis °",
        *(f"normal\n{side}" for side in sides),
        *(f"circumf.\n{side}" for side in sides),
        "radial\ntip µm",
        "radial\nroot µm",
    )
    for state, _, run in zones(teeth, analysis.threshold_um, np.arange(len(teeth))):
        for place in run:
            table.add_row(
                whole(teeth.tooth[place]),
                fixed(teeth.phi_deg[place], 1),
                fixed(teeth.left_um[place]),
                fixed(teeth.right_um[place]),
                fixed(teeth.circumferential_left_um[place]),
                fixed(teeth.circumferential_right_um[place]),
                fixed(teeth.tip_clearance_um[place], 1),
                fixed(teeth.root_clearance_um[place], 1),
                style=COLOURS[state],
            )
    return table
