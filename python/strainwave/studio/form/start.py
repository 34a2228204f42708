"""Where a design starts that is given another kind of wave generator or tooth profile."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import numpy as np

from strainwave.design import Design, loads, template
from strainwave.errors import StrainwaveError
from strainwave.geometry import Geometry
from strainwave.profiles import pieces_table
from strainwave.studies.comparison.generators import DEFAULT_PARAMETERS
from strainwave.studio.form.field import value_at
from strainwave.studio.form.group import fields_of
from strainwave.wave_generators import ShapedWaveGenerator

Tree = dict[str, Any]

GENERATOR = "wave_generator"
# What all kinds of generator but the ellipse have: how far it deforms the rim, not how it does.
MOTION = tuple(ShapedWaveGenerator.model_fields)
# A root fillet that does not fit is tried at these shares of it.
FILLET_SHARES = (1.0, 0.5, 0.25, 0.0)
# A shape as a table: w/w0 at every 5 degrees, to the millionth.
SAMPLES = 19
SAMPLE_DIGITS = 6


def start_table(
    design: Design,
    key: str,
    kind: str,
    *,
    typed: Mapping[str, Any] | None = None,
    seen: Mapping[str, Any] | None = None,
) -> Tree:
    """A table of another `kind` in place of the one at `key`, such that `design` with it has a geometry.

    `typed` is what the kind's table held before, and is taken again if it can be. Else what the present table has in
    common with the kind is kept, what it lacks is as `seen` in tables before it, and the rest is usual. DesignError
    says what the last of the tables that were tried lacks.
    """
    tables = _generators if key == GENERATOR else _profiles
    names = {field.key.removeprefix(f"{key}.").partition("[")[0] for field in fields_of(key, kind)}
    own = _at(design, key)
    kept = {name: value for name, value in own.items() if name in names}
    known = {name: value for name, value in (seen or {}).items() if name in names}
    error: StrainwaveError | None = None
    for table in tables(design, key, kind, dict(typed or {}), kept, known):
        try:
            Geometry.of(design.replace(key, {**table, "kind": kind}))
        except StrainwaveError as found:
            error = found
        else:
            return {**table, "kind": kind}
    assert error is not None
    raise error


def _generators(design: Design, key: str, kind: str, typed: Tree, kept: Tree, seen: Tree) -> Iterator[Tree]:
    if typed:
        yield typed | {name: value for name, value in kept.items() if name in MOTION}
    usual = _samples(design) if kind == "table" else DEFAULT_PARAMETERS[kind]
    yield seen | usual | kept
    yield usual | kept


def _samples(design: Design) -> Tree:
    """The present shape; of an ellipse, which has none, the one harmonic that is nearest to it."""
    generator = design.wave_generator
    if not isinstance(generator, ShapedWaveGenerator):
        return {"fourier": [0.0, 1.0]}
    angles = np.linspace(0.0, 0.5 * np.pi, SAMPLES)
    w = generator.shape(design.neutral_radius_mm).displacement(angles)[:, 0]
    return {"samples": (w.round(SAMPLE_DIGITS) + 0.0).tolist()}


def _profiles(design: Design, key: str, kind: str, typed: Tree, kept: Tree, seen: Tree) -> Iterator[Tree]:
    if typed:
        yield typed
    if kind == "pieces":
        yield _as_pieces(design, key)
        return
    table = _usual(key, kind) | seen | kept
    fillet = table.get("root_fillet_radius", 0.0)
    for share in FILLET_SHARES:
        yield table | {"root_fillet_radius": share * fillet}
    yield table | {"root_fillet_radius": 0.0, "offset": 0.0}
    yield _usual(key, kind)


def _as_pieces(design: Design, key: str) -> Tree:
    """The same flank as a chain; the fillet and the offset stay numbers of their own."""
    own = _at(design, key)
    sharp = design.replace({f"{key}.root_fillet_radius": 0.0, f"{key}.offset": 0.0})
    profile = getattr(Geometry.of(sharp), key.partition(".")[0])
    flank = profile.segments[np.array(profile.roles) == "flank"]
    heights = {name: own[name] for name in ("addendum", "dedendum", "root_fillet_radius", "offset")}
    return pieces_table(flank, design.module, **heights)


def _usual(key: str, kind: str) -> Tree:
    """The needed numbers of a kind as the template has them, on this spline or else on the other, or as the schema's
    examples."""
    here, elsewhere = (
        _at(_template(), f"{spline}.profile")
        for spline in sorted(("flexspline", "circular_spline"), key=lambda spline: not key.startswith(spline))
    )
    table: Tree = {}
    for field in fields_of(key, kind):
        name, is_point, _ = field.key.removeprefix(f"{key}.").partition("[")
        if not field.is_required:
            continue
        given = here.get(name, elsewhere.get(name))
        if given is not None:
            table[name] = given
        elif is_point:
            table.setdefault(name, []).append(field.example)
        else:
            table[name] = field.example
    return table


@cache
def _template() -> Design:
    return loads(template())


def _at(design: Design, key: str) -> Tree:
    table: Tree = value_at(design.to_dict(), key)
    return table
