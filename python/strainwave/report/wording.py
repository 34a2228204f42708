"""What the levels of a verdict are called in a report."""

from __future__ import annotations

from strainwave.analysis.verdict import Level

LEVEL_WORDS: dict[Level, str] = {
    "interference": "Interference",
    "along-face": "Interference along the face",
    "undecided": "Too close to call",
    "clear": "No interference",
}
