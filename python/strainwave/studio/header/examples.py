"""Designs to start from, which an installed package holds too."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from strainwave.analysis.case_study import CASES
from strainwave.analysis.case_study.design_files import case_study_file
from strainwave.studio.header.design_file import DesignFile

INVOLUTE = "involute-cosine"


@cache
def examples() -> tuple[DesignFile, ...]:
    """The case study as calibrated and as printed, and an involute pair."""
    stems = [f"{case.key}{ending}" for ending in ("-calibrated", "") for case in CASES]
    involute = files("strainwave.studio.header").joinpath("examples", f"{INVOLUTE}.toml").read_bytes()
    return (
        *(DesignFile.opened(f"{stem}.toml", case_study_file(stem)) for stem in stems),
        DesignFile.opened(f"{INVOLUTE}.toml", involute),
    )
