"""Write the files that docs/commands/fit.md reads: a drawing of a tooth, and points as a measuring machine gives them.

Both come from the case study's calibrated design, so that what is read back can be set beside it.
"""

from __future__ import annotations

import math
from pathlib import Path

import ezdxf
import numpy as np

from strainwave import load
from strainwave.export import flank_dxf, points_csv
from strainwave.geometry import Geometry
from strainwave.outlines import flank_points, tooth_segments

DESIGNS = Path(__file__).parent.parent / "designs"
NOISE_MM = 0.8e-3
SPACING_MM = 0.006


def main() -> None:
    """The flexspline's tooth in its own frame; the circular spline's about the gear's centre, at 25 degrees."""
    geometry = Geometry.of(load(DESIGNS / "case-study" / "cosine-calibrated.toml"))
    folder = DESIGNS / "teeth"
    folder.mkdir(exist_ok=True)
    drawn = tooth_segments(geometry.flexspline, whole=True)
    ezdxf.options.write_fixed_meta_data_for_testing = True  # no date, so that a second run writes the same
    (folder / "flexspline.dxf").write_text(flank_dxf(drawn), encoding="utf-8")
    circular = tooth_segments(geometry.circular_spline, whole=True)
    exact = flank_points(circular, chord_error_mm=math.inf, longest_mm=SPACING_MM)
    angle = math.radians(25.0)
    out = -np.array([math.sin(angle), math.cos(angle)])  # the tooth points inwards
    aside = np.array([out[1], -out[0]])
    about_center = exact[:, :1] * aside + (exact[:, 1:] - 0.5 * 0.8 * 206) * out
    measured = about_center + np.random.default_rng(1).normal(0.0, NOISE_MM, exact.shape)
    (folder / "circular-spline-measured.csv").write_text(points_csv(measured.round(5)), encoding="utf-8")


if __name__ == "__main__":
    main()
