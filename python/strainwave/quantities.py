"""The kinds of number in a design, each with its unit and the range that is allowed.

Ranges are generous: they shut out slips of the decimal point and numbers that would overflow, not unusual gears.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Annotated, Any, overload

from pydantic import GetJsonSchemaHandler
from pydantic_core import CoreSchema, core_schema

from strainwave.columns import Floats, Mask, Numbers
from strainwave.errors import Fault, FaultError
from strainwave.units import parse_angle


@dataclass(frozen=True)
class Quantity:
    """A number in `unit` from `least` to `greatest`; `open_end` shuts out `greatest` itself."""

    unit: str
    least: float
    greatest: float
    open_end: bool = False

    _noun = "a number"

    @property
    def allowed(self) -> str:
        """What may be written, as the end of a sentence: "a number from 0.001 to 1000 mm"."""
        below = "below " if self.open_end else ""
        return f"{self._noun} from {self.least:.12g} to {below}{self.greatest:.12g} {self.unit}".rstrip()

    def read(self, value: object) -> float:
        """`value` as a plain float (or int) in range; ValueError says what is allowed."""
        number = self._number(value)
        if not self.holds(number):
            raise ValueError(f"must be {self.allowed}")
        return number

    @overload
    def holds(self, number: float) -> bool: ...
    @overload
    def holds(self, number: Floats) -> Mask: ...
    def holds(self, number: Numbers) -> bool | Mask:
        """Whether a number lies in range, or each of an array does; nan never does."""
        below = number < self.greatest if self.open_end else number <= self.greatest
        return (number >= self.least) & below

    def _number(self, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, Real):
            raise ValueError(f"must be {self.allowed}")
        try:
            return float(value)
        except OverflowError:
            return math.inf

    def _check(self, value: object) -> float:
        try:
            return self.read(value)
        except ValueError as error:
            raise FaultError([Fault("", value, self.unit, str(error))]) from None

    def __get_pydantic_core_schema__(self, _source: Any, _handler: Any) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self._check)

    def __get_pydantic_json_schema__(self, _schema: CoreSchema, _handler: GetJsonSchemaHandler) -> dict[str, Any]:
        end = "exclusiveMaximum" if self.open_end else "maximum"
        return {"type": "number", "minimum": self.least, end: self.greatest, "unit": self.unit}


@dataclass(frozen=True)
class WholeNumber(Quantity):
    """A whole number, written without a decimal point."""

    _noun = "a whole number"

    def _number(self, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, Integral):
            raise ValueError(f"must be {self.allowed}")
        return int(value)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return super().__get_pydantic_json_schema__(schema, handler) | {"type": "integer"}


@dataclass(frozen=True)
class Angle(Quantity):
    """An angle: a number of degrees, or text such as 7°30'30"."""

    _noun = 'an angle (degrees, or text such as "7°30\'30\\"")'

    def _number(self, value: object) -> float:
        return parse_angle(value) if isinstance(value, str) else super()._number(value)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        number = super().__get_pydantic_json_schema__(schema, handler)
        return {"anyOf": [number, {"type": "string", "examples": ["7°30'30\""]}], "unit": self.unit}


MODULES = "modules"
MM = "mm"
DEGREES = "degrees"

ModuleSize = Annotated[float, Quantity(MM, 1e-3, 1e3)]
Teeth = Annotated[int, WholeNumber("teeth", 10, 100_000)]
LengthInModules = Annotated[float, Quantity(MODULES, 1e-4, 1e4)]
FilletRadius = Annotated[float, Quantity(MODULES, 0.0, 1e4)]
CoordinateInModules = Annotated[float, Quantity(MODULES, -1e4, 1e4)]
GREATEST_RADIUS = 1e8  # modules; fitted arcs may be almost lines
SignedRadius = Annotated[float, Quantity(MODULES, -GREATEST_RADIUS, GREATEST_RADIUS)]
LengthInMm = Annotated[float, Quantity(MM, 1e-4, 1e6)]
OffsetInMm = Annotated[float, Quantity(MM, -1e3, 1e3)]
FlankAngle = Annotated[float, Angle(DEGREES, 0.0, 90.0, open_end=True)]
PressureAngle = Annotated[float, Angle(DEGREES, 1.0, 60.0)]
ProfileShift = Annotated[float, Quantity(MODULES, -100.0, 100.0)]
EquidistantInMm = Annotated[float, Quantity(MM, 0.0, 1e6)]
