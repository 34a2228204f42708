"""A conjugate profile as plain data: stable, versioned keys with units in their names."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from strainwave.conjugation.conjugate import Conjugate

SCHEMA_VERSION = 1


def conjugate_record(conjugate: Conjugate) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    least, greatest = conjugate.gap_in_zones_um
    motion = conjugate.in_motion
    return {
        "schema_version": SCHEMA_VERSION,
        "name": conjugate.design.name,
        "of": conjugate.of,
        "pieces": conjugate.pieces,
        "deviation_um": conjugate.deviation_um,
        "offset_mm": conjugate.offset_mm,
        "root_fillet_radius_mm": conjugate.root_fillet_radius_mm,
        "zones": [asdict(zone) for zone in conjugate.zones],
        "double_contact_index": [list(span) for span in conjugate.double_contact],
        "branches": [asdict(branch) for branch in conjugate.branches],
        "gap_in_zones_um": {"least": least, "greatest": greatest},
        "min_in_motion_um": motion.gap_um,
        "min_in_motion_index": motion.index,
        "certified_to_um": motion.certified_to_um,
        "design": conjugate.design.to_dict(),
    }
