"""What was made of a file: a profile in a design, and how well it follows the file."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Literal

from strainwave.design import Design
from strainwave.imports.extent import Extent
from strainwave.imports.placement import Frame

SCHEMA_VERSION = 1

Spline = Literal["flexspline", "circular_spline"]
Kind = Literal["points", "drawing", "pieces"]


@dataclass(frozen=True)
class Scatter:
    """How the points of a file lie about the flank made of them; lengths in µm."""

    points: int
    """How many belong to the flank, or to both flanks of a tooth."""
    left_out: int
    """How many of them were too far off to be taken into account."""
    noise_um: float
    """Standard deviation, as given or estimated; 0 where the points were taken as exact."""
    rms_um: float
    """Root mean square of the distances of the others from the arcs."""
    greatest_um: float
    """Greatest of these distances."""


@dataclass(frozen=True, eq=False)
class ImportedFlank:
    """A flank from a file as the profile of a design."""

    design: Design
    """The design with the profile put in."""
    spline: Spline
    file: str
    kind: Kind
    unit: str
    """Of the file's lengths."""
    extent: Extent
    """One flank, or a whole tooth, whose flanks were compared."""
    frame: Frame
    """Where the file's origin is: on the pitch circle and the tooth's axis, in the gear's centre, or elsewhere."""
    fit_deviation_um: float
    """Greatest distance of the arcs from the curve that they follow; 0 where they are the file's own."""
    asymmetry_um: float | None
    """Greatest distance between both flanks of a whole tooth, one of them mirrored."""
    scatter: Scatter | None
    """Of a file of points."""

    @property
    def profile(self) -> dict[str, Any]:
        """The table of the new profile."""
        profile: dict[str, Any] = self.design.to_dict()[self.spline]["profile"]
        return profile

    def as_dict(self) -> dict[str, Any]:
        """Plain data with stable keys, versioned."""
        profile = self.profile
        return {
            "schema_version": SCHEMA_VERSION,
            "name": self.design.name,
            "file": self.file,
            "kind": self.kind,
            "spline": self.spline,
            "unit": self.unit,
            "extent": self.extent,
            "frame": self.frame,
            "pieces": len(profile["pieces"]),
            "addendum_modules": profile["addendum"],
            "dedendum_modules": profile["dedendum"],
            "fit_deviation_um": self.fit_deviation_um,
            "asymmetry_um": self.asymmetry_um,
            "scatter": None if self.scatter is None else vars(self.scatter),
            "profile": profile,
        }

    def to_json(self) -> str:
        """The same as JSON text."""
        return json.dumps(self.as_dict(), indent=2, ensure_ascii=False, allow_nan=False)
