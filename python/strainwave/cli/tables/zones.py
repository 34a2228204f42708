"""Runs of neighbouring teeth that are in the same state and touch with the same pieces."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from strainwave.analysis import Teeth

STATES = ("interferes", "close", "free")


def zones(teeth: Teeth, threshold_um: float, places: NDArray[np.int64]) -> Iterator[tuple[str, str, NDArray[np.int64]]]:
    """State, touching pieces and places of each run of the teeth at ``places``, in their order."""

    def kind(place: np.int64) -> tuple[str, str]:
        gap_um, flank = teeth.backlash_um[place], teeth.witnesses.closer_flank[place]
        state = STATES[0 if gap_um < 0.0 else 1 if gap_um < threshold_um else 2]
        pieces = (teeth.witnesses.flexspline_piece[place, flank], teeth.witnesses.circular_spline_piece[place, flank])
        return state, " – ".join(pieces)

    for (state, pieces), run in groupby(places, key=kind):
        yield state, pieces, np.array(list(run))
