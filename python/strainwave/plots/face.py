"""Backlash along the face: every tooth in every section, and the least in motion of each section."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.plots.clearance_scale import scale, shown_um
from strainwave.plots.style import BLUE, GREY, INK, VERMILION, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.analysis import FaceMap


def face_figure(face: FaceMap) -> Figure:
    """A map over tooth index and the face, beside it the least backlash in motion and the displacement."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=(9.0, 4.8), layout="constrained")
        teeth, least = figure.subplots(1, 2, sharey=True, width_ratios=[2.4, 1.0])
        _draw_map(figure, teeth, face)
        _draw_least(least, face)
        set_title(teeth, face.analysis.design.title, longest=60, pad=20.0)
        teeth.annotate(
            face_verdict(face),
            (0.0, 1.0),
            (0.0, 6.0),
            xycoords="axes fraction",
            textcoords="offset points",
            color=VERMILION if face.interference else INK,
        )
        figure.legend(loc="outside lower center", ncols=4)
    return figure


def face_verdict(face: FaceMap) -> str:
    """Where along the face the teeth overlap or are closest, in words."""
    least, z = abs(face.worst_in_motion_um), face.z_mm[face.worst]
    count = len(face.interfering_sections)
    if face.interference:
        return f"INTERFERENCE in motion in {count} of {len(face)} sections, {least:.1f} µm deep at z = {z:.1f} mm"
    return f"no interference in motion in {len(face)} sections, least gap {least:.2f} µm at z = {z:.1f} mm"


def _draw_map(figure: Figure, axes: Axes, face: FaceMap) -> None:
    from matplotlib.colors import LinearSegmentedColormap

    low, high = shown_um(face)
    index, colours = face.analysis.teeth.index, LinearSegmentedColormap.from_list("clearance", scale(low, high))
    half_tooth, half_section = 0.5 * (index[1] - index[0]), 0.5 * (face.z_mm[1] - face.z_mm[0])
    mesh = axes.imshow(
        face.gap_um,
        cmap=colours,
        vmin=low,
        vmax=high,
        origin="lower",
        aspect="auto",
        extent=(
            index[0] - half_tooth,
            index[-1] + half_tooth,
            face.z_mm[0] - half_section,
            face.z_mm[-1] + half_section,
        ),
        # Of the clearances, not of their colours: those jump at contact.
        interpolation="bilinear",
        interpolation_stage="data",
    )
    figure.colorbar(mesh, cax=axes.inset_axes((1.02, 0.0, 0.03, 1.0)), label="normal backlash, µm", extend="max")
    axes.grid(visible=False)
    if face.gap_um.min() < 0.0 < face.gap_um.max():
        axes.contour(index, face.z_mm, face.gap_um, levels=[0.0], colors=INK, linewidths=1.1)
        axes.plot([], [], color=INK, lw=1.1, label="contact at this angle")
    axes.axhline(face.z_mm[face.mid_face], color=GREY, lw=1.0, ls=(0, (5, 3)))
    axes.set_xlim(index[0], index[-1])
    axes.set_ylim(face.z_mm[0], face.z_mm[-1])
    axes.set_xlabel(f"tooth index from the major axis, at {face.analysis.generator_angle_deg:g}°")
    axes.set_ylabel("z from the diaphragm, mm  (open end at the top)")


def _draw_least(axes: Axes, face: FaceMap) -> None:
    mid_face, low = face.mid_face, min(0.0, face.worst_in_motion_um)
    span = max(float(face.min_in_motion_um.max()), 0.0) - low
    axes.set_xlim(low - 0.08 * span - 1.0, max(float(face.min_in_motion_um.max()), 0.0) + 0.08 * span + 1.0)
    axes.axvspan(axes.get_xlim()[0], 0.0, color=VERMILION, alpha=0.12, lw=0, label="interference")
    axes.axvline(0.0, color=VERMILION, lw=1.0)
    label = f"mid-face: w0 {face.w0_mm[mid_face]:.3f} mm, the plane result"
    axes.axhline(face.z_mm[mid_face], color=GREY, lw=1.0, ls=(0, (5, 3)), label=label)
    axes.plot(
        face.min_in_motion_um, face.z_mm, "o-", color=BLUE, ms=3.2, mfc="white", label="least in motion", clip_on=False
    )
    axes.tick_params(labelleft=False)
    axes.set_xlabel("least backlash in motion, µm")
    w0 = axes.secondary_yaxis("right", functions=_z_to_w0(face))
    w0.set_ylabel("w0 of the section, mm")


def _z_to_w0(face: FaceMap) -> Any:
    """z to w0 and back: along the face both grow evenly."""
    z, w0 = face.z_mm[[0, -1]], face.w0_mm[[0, -1]]
    slope = (w0[1] - w0[0]) / (z[1] - z[0])
    return lambda at: w0[0] + (np.asarray(at) - z[0]) * slope, lambda at: z[0] + (np.asarray(at) - w0[0]) / slope
