"""What wave generators are called where there are several."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence

from strainwave.wave_generators import DualDisk, FourRoller, ShapedWaveGenerator, WaveGenerator


def label_of(generator: WaveGenerator) -> str:
    """The kind, with what tells it from others of its kind."""
    if isinstance(generator, FourRoller):
        return f"{generator.kind} {generator.roller_angle:g}°"
    if isinstance(generator, DualDisk):
        return (
            f"{generator.kind} {generator.wrap_angle:g}°"
            if generator.disk_radius is None
            else f"{generator.kind} R {generator.disk_radius:g} mm"
        )
    return generator.kind


def labels_of(generators: Sequence[WaveGenerator], *, brief: bool = False) -> list[str]:
    """A label for each, no two the same: that of `label_of`, or the bare kind (`brief`), and as much more as is needed.

    That is the neutral-curve model, and where it is the same or there is none, a number.
    """
    full = [label_of(each) for each in generators]
    labels = _told_apart([each.kind for each in generators], full) if brief else full
    labels = _told_apart(labels, [_with_model(each) for each in generators])
    counts, seen = Counter(labels), Counter[str]()
    for place, label in enumerate(labels):
        if counts[label] > 1:
            seen[label] += 1
            labels[place] = f"{label} {seen[label]}"
    return labels


def _told_apart(labels: Sequence[str], longer: Sequence[str]) -> list[str]:
    """The longer labels where the same label stands for generators whose longer ones differ."""
    behind = defaultdict(set)
    for label, long in zip(labels, longer, strict=True):
        behind[label].add(long)
    return [long if len(behind[label]) > 1 else label for label, long in zip(labels, longer, strict=True)]


def _with_model(generator: WaveGenerator) -> str:
    name = label_of(generator)
    return f"{name} {generator.neutral_curve}" if isinstance(generator, ShapedWaveGenerator) else name
