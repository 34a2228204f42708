"""The commented design file that `strainwave new` writes."""

from importlib.resources import files


def template() -> str:
    """A complete design with every kind of profile and wave generator explained in comments."""
    return files("strainwave.design").joinpath("template.toml").read_text(encoding="utf-8")
