"""The design files of the case study, which an installed package holds too."""

from __future__ import annotations

from importlib.resources import files

from strainwave.design import Design, decode


def case_study_design(stem: str) -> Design:
    """The design in ``designs/case-study/<stem>.toml``."""
    return decode(case_study_file(stem), f"{stem}.toml")


def case_study_file(stem: str) -> bytes:
    """The bytes of ``designs/case-study/<stem>.toml``; the package holds links to the files there."""
    return files("strainwave.analysis.case_study").joinpath("designs", f"{stem}.toml").read_bytes()
