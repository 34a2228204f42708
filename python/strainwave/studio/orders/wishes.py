"""What the export's form says, and the order that it means."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, cast

from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.export import FORMATS, ExportChoice, Format
from strainwave.outlines.part import Part
from strainwave.scene import Fixed
from strainwave.studio.orders.design_order import DesignOrder
from strainwave.studio.orders.film_order import FilmFormat, FilmOrder
from strainwave.studio.orders.gear_order import GearOrder
from strainwave.studio.orders.kinds import DESIGN, KINDS, Field
from strainwave.studio.orders.order import Order


@dataclass
class Wishes:
    """The form's fields; None where one is empty. What does not apply to a kind of file is not read for it."""

    kind: str = "dxf"
    part: Part | Literal["all"] = "all"
    assembled: bool = False
    generator_angle_deg: float | None = 0.0
    one_tooth: bool = False
    tooth: float | None = 0
    printing_clearance_mm: float | None = 0.0
    chord_error_mm: float | None = None
    """None means the format's own."""
    fixed: Fixed = "circular-spline"
    frames: float | None = 120
    turns: float | None = 1.0
    frames_per_s: float | None = 20.0

    def shows(self, field: Field) -> bool:
        """Whether the kind of file leaves this choice; the wave generator has no teeth to choose from."""
        has_field = field in KINDS[self.kind].fields
        return has_field and not (field in ("tooth", "clearance") and self.part == "wave-generator")

    def order(self, design: Design, threshold_um: float) -> Order:
        """What is asked for. StrainwaveError where a field that is needed is empty."""
        if self.kind == DESIGN:
            return DesignOrder(design)
        if self.kind in FORMATS:
            return self._gear(design, self.kind)
        return FilmOrder(
            design=design,
            format=cast(FilmFormat, self.kind.removeprefix("film-")),
            frames=_whole(self.frames, "frames"),
            turns=_given(self.turns, "turns"),
            fixed=self.fixed,
            frames_per_s=_given(self.frames_per_s, "frames per second"),
            threshold_um=threshold_um,
        )

    def _gear(self, design: Design, format: Format) -> GearOrder:
        choice = ExportChoice(
            only=() if self.part == "all" else (self.part,),
            tooth=_whole(self.tooth, "tooth") if self.one_tooth and self.shows("tooth") else None,
            generator_angle_deg=(
                _given(self.generator_angle_deg, "wave generator's angle")
                if self.assembled and self.shows("state")
                else None
            ),
            printing_clearance_mm=(
                _given(self.printing_clearance_mm, "printing clearance") if self.shows("clearance") else 0.0
            ),
        )
        is_own = self.chord_error_mm is None or not self.shows("chord-error")
        return GearOrder(design, format, choice, None if is_own else _given(self.chord_error_mm, "chord error"))


def _given(value: object, name: str) -> float:
    try:
        number = float(value)  # type: ignore[arg-type]  # whatever a browser sends
    except (TypeError, ValueError):
        raise StrainwaveError(f"{name}: there is no number") from None
    if not math.isfinite(number):
        raise StrainwaveError(f"{name}: must be a finite number")
    return number


def _whole(value: object, name: str) -> int:
    number = _given(value, name)
    if number != int(number):
        raise StrainwaveError(f"{name}: must be a whole number, not {number:g}")
    return int(number)
