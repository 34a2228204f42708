"""What a notebook shows for an analysis: the verdict, its key figures and the backlash distribution."""

from __future__ import annotations

import base64
import io
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from strainwave.analysis.analysis import Analysis


def analysis_html(analysis: Analysis) -> str:
    """A self-contained fragment of HTML with a table and a picture."""
    below, motion = analysis.teeth_below, analysis.in_motion
    rows = {
        "Least gap in motion": f"{motion.gap_um:.3f} µm at index ±{motion.index:.2f}, "
        f"certified to {motion.certified_to_um:g} µm",
        f"Least backlash at {analysis.generator_angle_deg:g}°": f"{analysis.min_backlash_um:.3f} µm, "
        f"tooth {analysis.min_tooth}",
        f"Teeth with 0 ≤ gap < {analysis.threshold_um:g} µm": f"{below.per_side} per side, {below.lobe} per lobe, "
        f"{below.drive} in the drive",
        "Interfering teeth": f"{analysis.teeth_interfering.per_side} per side",
        "Play in motion": f"{analysis.play_in_motion.circumferential_um:.2f} µm, "
        f"{analysis.play_in_motion.angular_arcsec:.1f}″",
    }
    body = "".join(f"<tr><th style='text-align:left'>{key}</th><td>{value}</td></tr>" for key, value in rows.items())
    return (
        f"<div><b>{escape(analysis.design.title)}</b>: {analysis.verdict}<table>{body}</table>"
        f"<img alt='Backlash over tooth index' src='data:image/png;base64,{_picture(analysis)}'></div>"
    )


def _picture(analysis: Analysis) -> str:
    file = io.BytesIO()
    analysis.plot().savefig(file, format="png", dpi=96)
    return base64.b64encode(file.getvalue()).decode()
