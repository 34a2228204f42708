"""The design files of the case study, which an installed package holds too."""

from __future__ import annotations

from importlib.resources import files

from strainwave.design import Design, loads


def case_study_design(stem: str) -> Design:
    """The design in ``designs/case-study/<stem>.toml``; the package holds links to the files there."""
    name = f"{stem}.toml"
    text = files("strainwave.analysis.case_study").joinpath("designs", name).read_text(encoding="utf-8")
    return loads(text, source=name)
