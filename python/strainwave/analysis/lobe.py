"""Which teeth make up a lobe, and where a tooth of the drive stands in its lobe.

A strain wave gear with two lobes repeats itself after half a turn of the wave generator's axes: the pose of a tooth
relative to the circular spline depends on its fractional index k alone, with period z_f / 2.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from strainwave.design import Design


def lobe_teeth(flexspline_teeth: int) -> NDArray[np.int64]:
    """Tooth numbers of one lobe: 0 on the major axis, floor(z_f / 4) on either side of it."""
    side = flexspline_teeth // 4
    return np.arange(-side, side + 1, dtype=np.int64)


def drive_teeth(flexspline_teeth: int) -> NDArray[np.int64]:
    """Numbers of all z_f teeth, 0 on the major axis at generator angle 0, negative ones on the left of it."""
    return numbered_from_axis(np.arange(flexspline_teeth, dtype=np.int64), flexspline_teeth)


def tooth_index(tooth: NDArray[np.int64], design: Design, generator_angle_rad: float) -> NDArray[np.float64]:
    """Fractional index k = i - theta z_c / 2 pi of tooth i: its place relative to the generator's major axis."""
    return tooth.astype(np.float64) - generator_angle_rad * design.circular_spline.teeth / (2 * np.pi)


def within_lobe(index: NDArray[np.float64] | NDArray[np.int64], flexspline_teeth: int) -> NDArray[np.float64]:
    """The index in -z_f / 4 .. z_f / 4 that sees the same pose; its sign still tells the side of the major axis."""
    period = flexspline_teeth / 2
    return np.asarray(index - period * np.round(index / period))


def teeth_on_major_axis(design: Design, generator_angle_rad: float) -> NDArray[np.int64]:
    """The lobe's teeth about the generator's major axis at this angle, counted on without wrapping at z_f."""
    nearest = round(generator_angle_rad * design.circular_spline.teeth / (2 * np.pi))
    return lobe_teeth(design.flexspline.teeth) + nearest


def numbered_from_axis(tooth: NDArray[np.int64], flexspline_teeth: int) -> NDArray[np.int64]:
    """The same physical teeth with numbers between -z_f / 2 and z_f / 2."""
    half = (flexspline_teeth - 1) // 2
    return (tooth + half) % flexspline_teeth - half
