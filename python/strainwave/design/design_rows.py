"""One design in which some numbers differ from row to row."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from strainwave.columns import Columns, Floats, Mask, Refusals, array, below, column
from strainwave.design import rules
from strainwave.design.bodies import KEYS, Bodies
from strainwave.design.bodies_rule import bodies_refusals
from strainwave.design.design import Design
from strainwave.profiles import Gear, Involute, Pieces
from strainwave.profiles.involute import reaches
from strainwave.wave_generators import DualDisk, Ellipse
from strainwave.wave_generators.dual_disk import wrappable

# What a row may violate although each of its numbers lies within its limits: the rules between the tables of a design
# and those within one table, by status code.
REFUSALS = {
    "wall-too-thick": "the wall is as thick as the root circle's radius",
    "neutral-circle-too-large": "the neutral circle lies outside the flexspline's tip circle",
    "disk-radius-out-of-reach": "no wrap angle gives the disk radius",
    "cam-too-large": "the cam's distance from the neutral curve is as large as the neutral radius",
    "piece-impossible": "no line, or no arc of that radius and less than half a turn, leads to a piece's end",
    "join-not-tangent": "a join of pieces turns without being declared a corner",
    "chain-off-circle": "a chain of pieces does not begin on the addendum circle or end on the root circle",
    "no-involute": "no involute leads from the tip circle to the root circle or its fillet",
    "shape-not-one": "w(0)/w0 is not 1",
    "no-room-in-cup": "the teeth and the diaphragm are together as long as the cup",
    "boss-too-wide": "the boss is as wide as the cup's bore",
    "ring-too-thin": "the circular spline is no wider than its root circle",
}


@dataclass(frozen=True, eq=False)
class DesignRows:
    """A design and its varied numbers by dotted key, each of shape (rows,) and within the limits of its key."""

    design: Design
    varied: Columns

    def chosen(self, rows: Mask) -> DesignRows:
        """Some of the rows."""
        return DesignRows(self.design, {key: values[rows] for key, values in self.varied.items()})

    @cached_property
    def module(self) -> Floats:
        """Module in mm, (rows,) or (1,)."""
        return column(self.varied, "module", self.design.module)

    @cached_property
    def wave_generator(self) -> Columns:
        """The varied numbers of the wave generator."""
        return below(self.varied, "wave_generator")

    def profile(self, spline: str) -> Columns:
        """The varied numbers of the profile of "flexspline" or "circular_spline"."""
        return below(self.varied, f"{spline}.profile")

    @cached_property
    def neutral_radius_mm(self) -> Floats:
        """As `Design.neutral_radius_mm`, (rows,) or (1,)."""
        key, flexspline = "flexspline.neutral_radius", self.design.flexspline
        if key in self.varied:
            return self.varied[key]
        if flexspline.neutral_radius is not None:
            return column(self.varied, key, flexspline.neutral_radius)
        dedendum = column(self.varied, "flexspline.profile.dedendum", flexspline.profile.dedendum)
        return rules.neutral_radius(self.module, flexspline.teeth, dedendum, self._wall)

    @property
    def _wall(self) -> Floats:
        return column(self.varied, "flexspline.wall_thickness", self.design.flexspline.wall_thickness)

    def refusals(self) -> Refusals:
        """Which rows are no design, by what they violate; see `REFUSALS`."""
        if self.varied.keys() & {"module", "flexspline.wall_thickness", "flexspline.profile.dedendum"}:
            yield from self._rim()
        yield from self._neutral_circle()
        yield from self._wave_generator()
        for spline in ("flexspline", "circular_spline"):
            varied = self.profile(spline)
            if varied:
                yield from getattr(self.design, spline).profile.refusals(varied)
                yield from self._chain_ends(spline, varied)
            if varied or "module" in self.varied:
                yield from self._involute(spline, varied)
        yield from self._bodies()

    def _rim(self) -> Refusals:
        flexspline = self.design.flexspline
        dedendum = column(self.varied, "flexspline.profile.dedendum", flexspline.profile.dedendum)
        yield "wall-too-thick", self._wall >= rules.root_radius(self.module, flexspline.teeth, dedendum)

    def _neutral_circle(self) -> Refusals:
        flexspline = self.design.flexspline
        if flexspline.neutral_radius is not None or "flexspline.neutral_radius" in self.varied:
            addendum = column(self.varied, "flexspline.profile.addendum", flexspline.profile.addendum)
            tip_radius = rules.tip_radius(self.module, flexspline.teeth, addendum)
            yield "neutral-circle-too-large", self.neutral_radius_mm >= tip_radius

    def _wave_generator(self) -> Refusals:
        generator, varied = self.design.wave_generator, self.wave_generator
        if varied:
            yield from generator.refusals(varied)
        if isinstance(generator, DualDisk) and generator.disk_radius is not None:
            disk_radius = column(varied, "disk_radius", generator.disk_radius)
            w0 = column(varied, "w0", generator.w0)
            yield "disk-radius-out-of-reach", ~wrappable(disk_radius, self.neutral_radius_mm, w0)
        if isinstance(generator, Ellipse):
            cam_to_neutral = column(varied, "cam_to_neutral", generator.cam_to_neutral)
            yield "cam-too-large", cam_to_neutral >= self.neutral_radius_mm

    def _involute(self, spline: str, varied: Columns) -> Refusals:
        toothed, internal = getattr(self.design, spline), spline == "circular_spline"
        profile = toothed.profile
        if isinstance(profile, Involute):
            tip_roll, root_roll = profile.roll_angles(Gear(self.module, toothed.teeth, internal), varied)
            yield "no-involute", ~reaches(tip_roll, root_roll, internal=internal)

    def _bodies(self) -> Refusals:
        given = {key: self._given(key) for key in KEYS}
        if all(size is None for size in given.values()):
            return  # the usual proportions always go together
        flexspline, ring = self.design.flexspline, self.design.circular_spline
        dedendum = column(self.varied, "flexspline.profile.dedendum", flexspline.profile.dedendum)
        ring_dedendum = column(self.varied, "circular_spline.profile.dedendum", ring.profile.dedendum)
        yield from bodies_refusals(
            Bodies.of(
                given.get,
                pitch_diameter=self.module * flexspline.teeth,
                root_radius=rules.root_radius(self.module, flexspline.teeth, dedendum),
                wall=self._wall,
                ring_root_radius=rules.ring_root_radius(self.module, ring.teeth, ring_dedendum),
            )
        )

    def _given(self, key: str) -> Floats | None:
        """An optional length of one of the splines, (rows,) or (1,)."""
        spline, name = key.split(".")
        size = getattr(getattr(self.design, spline), name)
        return column(self.varied, key, size) if key in self.varied or size is not None else None

    def _chain_ends(self, spline: str, varied: Columns) -> Refusals:
        toothed = getattr(self.design, spline)
        profile = toothed.profile
        if not isinstance(profile, Pieces):
            return
        last = len(profile.pieces) - 1
        internal = spline == "circular_spline"
        start = array(varied, {"start[0]": 0, "start[1]": 1}, profile.start)
        end = array(varied, {f"pieces[{last}].to[0]": 0, f"pieces[{last}].to[1]": 1}, profile.pieces[last].to)
        addendum = column(varied, "addendum", profile.addendum)
        dedendum = column(varied, "dedendum", profile.dedendum)
        for distance in (
            rules.chain_start_distance(start[:, 0], start[:, 1], toothed.teeth, addendum, internal=internal),
            rules.chain_end_distance(end[:, 0], end[:, 1], toothed.teeth, dedendum, internal=internal),
        ):
            yield "chain-off-circle", abs(distance) > rules.CHAIN_END_TOLERANCE
