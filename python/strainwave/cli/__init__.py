"""The command ``strainwave``: design files in, tables, JSON and pictures out."""

from strainwave.cli.main import main

__all__ = ["main"]
