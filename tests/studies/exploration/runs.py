"""Small explorations for tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from strainwave.studies.exploration import Exploration, Space, explore, load_space
from tests.designs import CASE_STUDY, case

SPACE_FILE: Path = CASE_STUDY.parent / "spaces" / "tip-arcs.toml"
W0, OFFSET, ROLLER = "wave_generator.w0", "flexspline.profile.offset", "wave_generator.roller_angle"
_FOLDER = TemporaryDirectory(prefix="strainwave-explored-")


def space_of(*generators: dict[str, Any], **ranges: tuple[object, object]) -> Space:
    """A space of w0, or of the parameters whose keys have __ for dots."""
    chosen = ranges or {"wave_generator__w0": (0.83, 0.9)}
    parameters = [
        {"parameter": key.replace("__", "."), "low": low, "high": high} for key, (low, high) in chosen.items()
    ]
    return Space.from_dict({"parameters": parameters, "generators": list(generators)})


@cache
def explored() -> Exploration:
    """3000 designs of the example's space in 12 chunks, in motion; to be read only."""
    return explore(
        case("cosine-calibrated"),
        load_space(SPACE_FILE),
        3000,
        Path(_FOLDER.name) / "study",
        chunk_rows=256,
        in_motion=True,
    )
