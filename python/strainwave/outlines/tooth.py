"""The outline of one tooth, as files have it."""

from __future__ import annotations

import numpy as np

from strainwave._kernel import Profile
from strainwave.columns import Floats


def tooth_segments(profile: Profile, *, whole: bool = False) -> Floats:
    """Segments (n, 5), mm, of a tooth's right half from its axis to mid-space, or of the whole tooth from the left.

    In the tooth's frame, as in `ToothProfile.flank`; with land, fillet and floor, and with the profile's offset.
    """
    right = profile.segments
    if not whole:
        return right
    # The mirrored half, its pieces run the other way: they end where they began, and turn as before.
    ends = np.stack([*profile.position(profile.knots[1:]).T], axis=-1)
    turns = right[:, 3] * right[:, 4]
    left = np.stack([-ends[:, 0], ends[:, 1], -(right[:, 2] + turns), right[:, 3], right[:, 4]], axis=-1)[::-1]
    # Both halves of the land are one arc about the gear's centre.
    land = left[-1].copy()
    land[4] += right[0, 4]
    return np.concatenate([left[:-1], land[None, :], right[1:]])


def tooth_roles(profile: Profile) -> tuple[str, ...]:
    """What each segment of a whole tooth is."""
    right = profile.roles
    return (*right[:0:-1], *right)
