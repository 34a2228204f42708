"""What was made of a profile from a file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import key_values
from strainwave.cli.tables.number import fixed

if TYPE_CHECKING:
    from rich.table import Table

    from strainwave.imports import ImportedFlank

FRAMES = {
    "tooth": "origin on the pitch circle, y along the tooth",
    "gear": "origin in the gear's centre",
    "given": "centre as given",
}


def imported_table(found: ImportedFlank) -> Table:
    """How the file was read, and how well the profile follows it."""
    table = key_values()
    what = "one flank" if found.extent == "flank" else "a whole tooth"
    table.add_row("read", f"{found.file}: {what} in {found.unit}, {FRAMES[found.frame]}")
    if found.asymmetry_um is not None:
        table.add_row("symmetry", f"flanks alike within {fixed(found.asymmetry_um, 3)} µm")
    if found.scatter is not None:
        table.add_row("points", _scatter(found))
    profile = found.profile
    deviation = found.fit_deviation_um
    fitted = f"within {fixed(deviation, 3)} µm of the curve" if deviation else "those of the file"
    table.add_row(
        "profile",
        f"{found.spline.replace('_', ' ')}, {len(profile['pieces'])} arcs and lines, {fitted}; "
        f"addendum {fixed(profile['addendum'], 4)}, dedendum {fixed(profile['dedendum'], 4)} modules",
    )
    return table


def _scatter(found: ImportedFlank) -> str:
    scatter = found.scatter
    assert scatter is not None
    noise = f"noise {fixed(scatter.noise_um, 3)} µm" if scatter.noise_um else "taken as exact"
    left_out = f", {scatter.left_out} left out" if scatter.left_out else ""
    return (
        f"{scatter.points}{left_out}, {noise}; from the profile {fixed(scatter.rms_um, 3)} µm root mean square, "
        f"{fixed(scatter.greatest_um, 3)} µm at most"
    )
