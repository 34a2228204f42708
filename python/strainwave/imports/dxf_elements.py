"""Entities of a DXF drawing as arcs and lines."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.fitting import fit_curve
from strainwave.imports.drawn_chain import DrawnChain

if TYPE_CHECKING:
    from ezdxf.entities.dxfgfx import DXFGraphic

MOST_CONTROL_POINTS = 5000


def elements_of(entity: DXFGraphic, tolerance: float) -> Iterator[DrawnChain]:
    """The pieces of one entity as chains, in the drawing's unit; curves that are no arcs fitted within a tolerance."""
    any_entity: Any = entity  # each kind of entity has attributes of its own
    kind = entity.dxftype()
    if kind in ("LWPOLYLINE", "POLYLINE"):
        for part in any_entity.virtual_entities():
            yield from elements_of(part, tolerance)
    elif kind == "LINE":
        yield from _line(any_entity)
    elif kind == "ARC":
        yield from _arc(any_entity)
    elif kind == "ELLIPSE":
        yield _ellipse(any_entity, tolerance)
    elif kind == "SPLINE":
        yield from _spline(any_entity, tolerance)
    else:  # the faces of a POLYLINE that is a mesh
        raise StrainwaveError(f"holds a {kind} where an outline of lines and curves is expected")


def _flat(points: Any) -> Floats:
    """x and y of points in space, (n, 2); they have to lie in one plane z = constant."""
    places = np.array([(point[0], point[1], point[2]) for point in points], dtype=np.float64)
    if not np.isfinite(places).all():
        raise StrainwaveError("holds coordinates that are no finite numbers")
    if np.ptp(places[:, 2]) > 1e-6 * max(1.0, float(np.abs(places).max())):
        raise StrainwaveError("is not flat: lay the outline into the plane of x and y")
    return places[:, :2]


def _line(entity: Any) -> Iterator[DrawnChain]:
    points = _flat([entity.dxf.start, entity.dxf.end])
    if (points[0] != points[1]).any():
        yield DrawnChain(points, np.array([np.inf]))


def _arc(entity: Any) -> Iterator[DrawnChain]:
    """In two halves where it turns by half a turn or more, so that a radius says which way it goes."""
    start = entity.dxf.start_angle
    turn = (entity.dxf.end_angle - start) % 360.0 or 360.0
    halves = 1 if turn < 179.0 else 2 if turn < 359.0 else 3
    points = _flat(entity.vertices([start + turn * step / (2 * halves) for step in range(2 * halves + 1)]))
    radius = abs(entity.dxf.radius)
    for place in range(0, 2 * halves, 2):
        first, middle, last = points[place : place + 3]
        chord, rise = last - first, middle - first
        leftwards = chord[0] * rise[1] - chord[1] * rise[0]
        if chord.any() and radius > 0.0:
            yield DrawnChain(np.array([first, last]), np.array([math.copysign(radius, leftwards)]))


def _ellipse(entity: Any, tolerance: float) -> DrawnChain:
    center, major, minor = (
        np.array([vector.x, vector.y]) for vector in (entity.dxf.center, entity.dxf.major_axis, entity.minor_axis)
    )
    _flat([entity.dxf.center, entity.start_point, entity.end_point])
    start = entity.dxf.start_param
    end = start + ((entity.dxf.end_param - start) % math.tau or math.tau)
    fit = fit_curve(
        lambda t: center + np.cos(t)[:, None] * major + np.sin(t)[:, None] * minor,
        lambda t: np.cos(t)[:, None] * minor - np.sin(t)[:, None] * major,
        start,
        end,
        tolerance_mm=tolerance,
    )
    return DrawnChain.of_fit(fit)


def _spline(entity: Any, tolerance: float) -> Iterator[DrawnChain]:
    """Non-uniform and perhaps rational; cut where a knot leaves a corner, with a join where it leaves the curvature
    free to jump."""
    from scipy.interpolate import BSpline

    if max(len(entity.control_points), len(entity.fit_points)) > MOST_CONTROL_POINTS:
        raise StrainwaveError(f"holds a spline of more than {MOST_CONTROL_POINTS} points")
    curve = entity.construction_tool()
    degree = curve.order - 1
    controls = _flat(curve.control_points)
    weights = np.array(curve.weights() or np.ones(len(controls)), dtype=np.float64)
    knots = np.array(curve.knots(), dtype=np.float64)
    homogeneous = BSpline(knots, np.column_stack([controls * weights[:, None], weights]), degree)
    slope = homogeneous.derivative()

    def position(t: Floats, limit: float) -> Floats:
        found = homogeneous(np.minimum(t, limit))
        places: Floats = found[:, :2] / found[:, 2:]
        return places

    def tangent(t: Floats, limit: float) -> Floats:
        # The direction of (N / W)' = (N' W - N W') / W^2.
        found, change = homogeneous(np.minimum(t, limit)), slope(np.minimum(t, limit))
        along: Floats = change[:, :2] * found[:, 2:] - found[:, :2] * change[:, 2:]
        return along

    values, counts = np.unique(knots, return_counts=True)
    inside = (values > knots[degree]) & (values < knots[-degree - 1])
    corners = values[inside & (counts >= degree)]
    jumps = values[inside & (counts == degree - 1)]
    for start, end in pairwise([knots[degree], *corners, knots[-degree - 1]]):
        limit = float(np.nextafter(end, start))  # at the corner itself the slope is the next span's
        fit = fit_curve(
            partial(position, limit=limit),
            partial(tangent, limit=limit),
            float(start),
            float(end),
            breaks=[float(jump) for jump in jumps if start < jump < end],
            tolerance_mm=tolerance,
        )
        yield DrawnChain.of_fit(fit)
