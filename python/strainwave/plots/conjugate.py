"""A conjugate profile: the trajectories that generate it with their envelope, and the conjugate zones."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from strainwave.analysis.witness import piece_names
from strainwave.plots.outline import half_profile
from strainwave.plots.style import BLUE, GREY, INK, ORANGE, SKY, VERMILION, house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave._kernel import Profile
    from strainwave.conjugation import Conjugate
    from strainwave.conjugation.branch import Branch
    from strainwave.conjugation.contact_pieces import Contacts
    from strainwave.geometry import Geometry

Floats = NDArray[np.float64]
View = Callable[[Floats, "Contacts"], tuple[Floats, Floats]]

SAMPLES = 257
# Room around the tooth, in modules.
MARGIN = 0.2
# Names of pieces with less arc length than this, in modules, would cover each other.
LEAST_NAMED = 0.12


def conjugate_figure(conjugate: Conjugate) -> Figure:
    """The sought tooth in its own frame among the trajectories of its mate, and where each part of the mate touches."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=(10.0, 5.4), layout="constrained")
        tooth, zones = figure.subplots(1, 2, width_ratios=[1.0, 1.25])
        _draw_tooth(tooth, conjugate)
        _draw_zones(zones, conjugate)
        handles, labels = tooth.get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=3)
        figure.suptitle(conjugate.given.title, x=0.01, ha="left", size=10.0, weight="bold", parse_math=False)
    return figure


def _draw_tooth(axes: Axes, conjugate: Conjugate) -> None:
    gear, module = conjugate.flank.gear, conjugate.given.module
    new = half_profile(_sought(conjugate, conjugate.geometry))
    old = half_profile(_sought(conjugate, conjugate.generation.motion.geometry))
    axes.fill_betweenx(new[:, 1], 0.0, new[:, 0], color=ORANGE, alpha=0.3, lw=0)
    _draw_trajectories(axes, conjugate)
    _draw_branches(axes, conjugate, lambda _, contacts: (contacts.points.real, contacts.points.imag))
    axes.plot(*old.T, color=GREY, lw=1.2, ls=(0, (2, 1.5)), label="profile of the given design")
    axes.plot(*new.T, color=INK, lw=0.9, label="conjugate profile")
    axes.set_xlim(-MARGIN * module, gear.pitch_radius * gear.half_pitch_angle + MARGIN * module)
    axes.set_ylim(-gear.dedendum - MARGIN * module, gear.addendum + 2.0 * MARGIN * module)
    axes.set_aspect("equal", anchor="N")
    axes.grid(visible=False)
    axes.set_title(f"{conjugate.words.capitalize()} tooth")
    axes.set_xlabel("from the tooth's axis, mm")
    axes.set_ylabel("above the pitch circle, towards the tip, mm")


def _draw_trajectories(axes: Axes, conjugate: Conjugate) -> None:
    """The mate's profile at every whole tooth index."""
    half = half_profile(conjugate.generation.mate)
    label: str | None = f"{conjugate.generation.mate_name} at every tooth index"
    for motion in conjugate.generation.motions:
        frames = motion.at(np.arange(np.ceil(motion.first), np.floor(motion.last) + 1.0))
        for points in frames.placed(half[:, 0] + 1j * half[:, 1]):
            axes.plot(points.real, points.imag, color=SKY, lw=0.5, alpha=0.6, label=label)
            label = None


def _draw_branches(axes: Axes, conjugate: Conjugate, view: View) -> None:
    """All branches of contact thin, what the profile keeps of them broad."""
    label: str | None = "envelope, all branches"
    for branch in conjugate.envelope:
        axes.plot(*_seen(branch, branch.first, branch.last, view), color=VERMILION, lw=0.9, label=label)
        label = None
    label = "kept: the conjugate zones"
    for stretch in conjugate.flank.stretches:
        curve = _seen(stretch.branch, stretch.first, stretch.last, view)
        axes.plot(*curve, color=BLUE, lw=3.0, alpha=0.75, label=label)
        label = None


def _seen(branch: Branch, first: float, last: float, view: View) -> tuple[Floats, Floats]:
    index = np.linspace(first, last, SAMPLES)
    return view(index, branch.contacts(index))


def _draw_zones(axes: Axes, conjugate: Conjugate) -> None:
    generation, module = conjugate.generation, conjugate.given.module
    _draw_branches(axes, conjugate, lambda index, contacts: (np.degrees(generation.motion.phi(index)), contacts.u))
    for name, begin, end in _named_spans(generation.mate):
        axes.axhline(end, color=GREY, lw=0.6, ls=(0, (1, 2)))
        if end - begin > LEAST_NAMED * module:
            axes.text(0.99, 0.5 * (begin + end), name, transform=axes.get_yaxis_transform(), ha="right", va="center",
                      color=GREY, size=8.0)  # fmt: skip
    axes.set_ylim(generation.mate.length, 0.0)
    axes.set_title("Conjugate zones of the right flank")
    axes.set_xlabel("tooth's angle from the generator's major axis, °")
    axes.set_ylabel(f"arc length on the {generation.mate_name} from the middle of its tip, mm")


def _named_spans(profile: Profile) -> list[tuple[str, float, float]]:
    """Names of a profile's pieces with the arc lengths from which to which they run, neighbours of one name as one."""
    names, knots = piece_names(profile), profile.knots
    starts = np.flatnonzero(np.concatenate([[True], names[1:] != names[:-1]]))
    return list(zip(names[starts].tolist(), knots[starts].tolist(), knots[[*starts[1:], -1]].tolist(), strict=True))


def _sought(conjugate: Conjugate, geometry: Geometry) -> Profile:
    return geometry.flexspline if conjugate.of == "flexspline" else geometry.circular_spline
