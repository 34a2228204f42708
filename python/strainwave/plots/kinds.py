"""The kinds of picture that the command draws of a design, by name."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from strainwave.errors import StrainwaveError

if TYPE_CHECKING:
    from strainwave.analysis import Analysis


@dataclass(frozen=True, kw_only=True)
class Kind:
    """A picture by the name of its function, the same in `strainwave.plots` and in `strainwave.plots.interactive`."""

    name: str
    shows: str
    function: str
    subject: Literal["analysis", "face", "design"] = "analysis"
    """What the function draws: an analysis, its map of the face, or the design alone."""
    at_angle: bool = False
    """Whether another angle of the generator makes another picture."""
    chooses_teeth: bool = False
    """Whether it can show chosen teeth."""
    along_face: bool = False
    """Whether it shows more of the face than its middle."""
    interactive: bool = True
    """Whether there is an interactive one beside the drawing."""

    def check(self, *, angle: bool, teeth: bool, interactive: bool) -> None:
        """StrainwaveError where what is asked for makes no difference to this picture, or there is none."""
        asked = {"an angle": angle and not self.at_angle, "chosen teeth": teeth and not self.chooses_teeth}
        for what, in_vain in asked.items():
            if in_vain:
                raise StrainwaveError(f"a picture of {self.name} does not depend on {what}; leave the option out")
        if interactive and not self.interactive:
            raise StrainwaveError(f"{self.name} is a drawing, not a page: name a .png, .svg or .pdf")

    def figure(self, analysis: Analysis, *, interactive: bool = False, teeth: tuple[int, int] | None = None) -> Any:
        """The picture of an analysis at its generator angle, of matplotlib or plotly."""
        home = importlib.import_module(f"strainwave.plots{'.interactive' if interactive else ''}")
        draw = getattr(home, self.function)
        if self.chooses_teeth:
            return draw(analysis, generator_angle_deg=analysis.generator_angle_deg, teeth=teeth)
        return draw(self._subject(analysis))

    def _subject(self, analysis: Analysis) -> Any:
        if self.subject == "face":
            from strainwave.analysis import face_map

            return face_map(analysis)
        return analysis.design if self.subject == "design" else analysis


_ALL = (
    Kind(
        name="assembly",
        shows="both splines and the wave generator to size, teeth coloured by clearance",
        function="assembly_figure",
        at_angle=True,
        chooses_teeth=True,
    ),
    Kind(
        name="backlash", shows="backlash of every tooth over the tooth index", function="backlash_figure", at_angle=True
    ),
    Kind(
        name="gap", shows="gap(k) at every generator angle, and the certificate of its minimum", function="gap_figure"
    ),
    Kind(name="neutral-curve", shows="w, v, ψ and the curvature of the rim over φ", function="neutral_curve_figure"),
    Kind(
        name="contact",
        shows="the closest points of the teeth on both profiles",
        function="contact_figure",
        at_angle=True,
    ),
    Kind(
        name="trajectory",
        shows="a tooth's way through its space, with the swept envelope",
        function="trajectory_figure",
    ),
    Kind(
        name="face",
        shows="backlash along the face of the coned cup, tooth by tooth and section by section",
        function="face_figure",
        subject="face",
        along_face=True,
        at_angle=True,
    ),
    Kind(
        name="assembly-3d",
        shows="the gear in space, the cup bent, teeth coloured by clearance",
        function="assembly_3d_figure",
        along_face=True,
        at_angle=True,
    ),
    Kind(
        name="profile",
        shows="both tooth profiles, dimensioned: what each number of the design file means",
        function="profile_figure",
        subject="design",
        interactive=False,
    ),
    Kind(
        name="mesh",
        shows="the tightest place of all, and its closest points magnified",
        function="mesh_figure",
        interactive=False,
    ),
)
KINDS = {kind.name: kind for kind in _ALL}
