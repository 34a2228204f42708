"""The design of one strain wave gear."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Self

from pydantic import Field, StrictStr, ValidationError, model_validator

from strainwave.design import rules
from strainwave.design.bodies import Bodies
from strainwave.design.faults import faults_of
from strainwave.design.replacement import replaced
from strainwave.design.splines import CircularSpline, Flexspline
from strainwave.errors import DesignError, FaultError, shown_text
from strainwave.quantities import ModuleSize
from strainwave.spec import Spec
from strainwave.wave_generators import AnyWaveGenerator


class Design(Spec):
    """A strain wave gear as its designer describes it: profile lengths in modules, all else in mm and degrees."""

    name: Annotated[
        StrictStr, Field(max_length=200, description="Name of the design, for titles", examples=["Case study"])
    ] = ""
    module: Annotated[ModuleSize, Field(description="Module, pitch diameter over number of teeth", examples=[0.8])]
    flexspline: Annotated[Flexspline, Field(description="Elastic external gear")]
    circular_spline: Annotated[CircularSpline, Field(description="Rigid internal gear")]
    wave_generator: Annotated[AnyWaveGenerator, Field(description="Wave generator")]

    @classmethod
    def from_dict(cls, tree: Mapping[str, Any], source: str | None = None) -> Self:
        """The design of a tree of tables, as TOML gives it. DesignError holds every fault, and names `source`."""
        try:
            return cls.model_validate(tree)
        except ValidationError as error:
            faults = faults_of(error, cls)
        faulty_keys = {fault.key for fault in faults}
        # Where no table has a fault of its own, the faults found are those between the tables already.
        between = [fault for fault in rules.faults_between(tree, faulty_keys) if fault.key not in faulty_keys]
        raise DesignError([*faults, *between], source)

    def to_dict(self) -> dict[str, Any]:
        """The tree of tables that `from_dict` reads, defaults included; keys left out are left out."""
        return self.model_dump(exclude_none=True)

    def replace(self, key: str | Mapping[str, Any], value: Any = None) -> Self:
        """A design with one value changed: replace("wave_generator.w0", 0.9); or several at once, as a mapping.

        A value may be a whole table; None takes an optional key out. DesignError where a key or the result cannot be.
        """
        changes = key if isinstance(key, Mapping) else {key: value}
        return type(self).from_dict(replaced(self.to_dict(), changes))

    @property
    def title(self) -> str:
        """The name as reports and pictures show it: on one line, with nothing in it that a terminal would obey."""
        return shown_text(self.name) or "unnamed design"

    @property
    def neutral_radius_mm(self) -> float:
        """Radius of the undeformed neutral circle: as given, or the middle of the wall."""
        flexspline = self.flexspline
        if flexspline.neutral_radius is not None:
            return flexspline.neutral_radius
        return rules.neutral_radius(
            self.module, flexspline.teeth, flexspline.profile.dedendum, flexspline.wall_thickness
        )

    @property
    def flexspline_pitch_radius_mm(self) -> float:
        """m z_f / 2."""
        return 0.5 * self.module * self.flexspline.teeth

    @property
    def circular_spline_pitch_radius_mm(self) -> float:
        """m z_c / 2."""
        return 0.5 * self.module * self.circular_spline.teeth

    @property
    def ratio(self) -> float:
        """Input over output speed with the circular spline fixed: -z_f / (z_c - z_f)."""
        return -self.flexspline.teeth / (self.circular_spline.teeth - self.flexspline.teeth)

    @property
    def bodies(self) -> Bodies[float]:
        """Sizes (mm) of the cup along its axis and of the ring around the teeth, given or usual."""

        def given(key: str) -> float | None:
            table, name = key.split(".")
            size: float | None = getattr(getattr(self, table), name)
            return size

        flexspline, circular_spline = self.flexspline, self.circular_spline
        return Bodies.of(
            given,
            pitch_diameter=self.module * flexspline.teeth,
            root_radius=rules.root_radius(self.module, flexspline.teeth, flexspline.profile.dedendum),
            wall=flexspline.wall_thickness,
            ring_root_radius=rules.ring_root_radius(
                self.module, circular_spline.teeth, circular_spline.profile.dedendum
            ),
        )

    @property
    def flexspline_face_width_mm(self) -> float:
        """Length of the flexspline's teeth, which end at the cup's open end."""
        return self.bodies.face_width

    @property
    def cup_length_mm(self) -> float:
        """From the diaphragm's outer face to the open end."""
        return self.bodies.cup_length

    @property
    def diaphragm_thickness_mm(self) -> float:
        """Thickness of the cup's bottom."""
        return self.bodies.diaphragm_thickness

    @property
    def boss_diameter_mm(self) -> float:
        """Diameter of the boss in the middle of the diaphragm."""
        return self.bodies.boss_diameter

    @property
    def circular_spline_face_width_mm(self) -> float:
        """Length of the circular spline, in the middle of the flexspline's teeth."""
        return self.bodies.ring_face_width

    @property
    def circular_spline_outer_diameter_mm(self) -> float:
        """Outer diameter of the ring."""
        return self.bodies.outer_diameter

    @model_validator(mode="after")
    def _tables_agree(self) -> Self:
        faults = rules.faults_between(self.to_dict(), set())
        if faults:
            raise FaultError(faults)
        return self
