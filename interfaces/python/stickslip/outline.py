# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts by their places on the outline of a body. All comparisons are exact."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Iterator, List, NamedTuple, Sequence, Tuple

import numpy as np

from . import _core
from .arguments import as_list, as_number, as_outline, as_rows
from .errors import InputError
from .views import nearest_root

Point = Tuple[Fraction, Fraction]
Ring = List[Point]


class Placed(NamedTuple):
    """A point of the outline."""

    position: Point
    normal: Point  # into the body, as long as the edge
    polygon: int
    edge: int  # of the polygon, its outer ring first
    share: Fraction  # of the edge, from its start
    squared_distance: Fraction  # from the point that was asked for


def polygons_of(outline: Any) -> List[List[Ring]]:
    """Of each polygon its rings, the outer one first and counterclockwise, holes clockwise."""
    polygons = [[_oriented(ring, f"outline[{j}][{k}]", k > 0) for k, ring in enumerate(rings)]
                for j, rings in enumerate(as_outline(outline))]
    if not polygons:
        raise InputError("", "outline", "there is no polygon", "give at least three corners x, y")
    return polygons


def has_doubles(outline: Any) -> bool:
    """Whether corners were given as floats, as shapely always does."""
    if hasattr(outline, "geoms") or hasattr(outline, "exterior"):
        return True
    if isinstance(outline, (list, tuple, np.ndarray)):
        return any(has_doubles(part) for part in outline)
    return isinstance(outline, (float, np.floating))


def unit_if_rational(normal: Tuple[Fraction, ...]) -> Tuple[Fraction, ...]:
    squared = sum((x * x for x in normal), Fraction(0))
    length = Fraction(math.isqrt(squared.numerator), math.isqrt(squared.denominator))
    return tuple(x / length for x in normal) if length * length == squared else normal


def exact_points(values: Any, name: str) -> List[Point]:
    rows = as_list(values, name, (len(values), 2), "one row x, y for each point")
    return [(_core.exact(x, f"{name}[{i}, 0]"), _core.exact(y, f"{name}[{i}, 1]"))
            for i, (x, y) in enumerate(rows)]


def _oriented(ring: Any, name: str, hole: bool) -> Ring:
    corners = exact_points(ring, name)
    if len(corners) > 1 and corners[0] == corners[-1]:
        corners.pop()
    for i, corner in enumerate(corners):
        if corner == corners[i - 1]:
            raise InputError("", f"{name}[{i}]", "the corner repeats the one before it",
                             "leave it out")
    area = sum((a[0] * b[1] - a[1] * b[0] for a, b in _edges(corners)), Fraction(0))
    if area == 0:
        raise InputError("", name, "the ring encloses no area", "give at least three corners x, y")
    return corners if (area > 0) != hole else corners[::-1]


def _edges(ring: Sequence[Point]) -> Iterator[Tuple[Point, Point]]:
    return ((a, ring[(i + 1) % len(ring)]) for i, a in enumerate(ring))


def place(polygons: List[List[Ring]], points: Any, tolerance: Any) -> List[Placed]:
    """The nearest point of the outline for each of the points."""
    most = None if tolerance is None else _core.exact(as_number(tolerance, "tolerance"), "tolerance")
    asked = exact_points(as_rows(points), "points")
    result = []
    for i, point in enumerate(asked):
        on_edges = [_nearest(point, edge, j, e) for j, rings in enumerate(polygons)
                    for e, edge in enumerate(edge for ring in rings for edge in _edges(ring))]
        best = min(on_edges, key=lambda placed: placed.squared_distance)
        if best.share in (0, 1):
            raise InputError("", f"points[{i}]", "the nearest point of the outline is a corner, "
                             "where there is no normal", "move it along an edge")
        if best.squared_distance > 0:
            away = f"it is {nearest_root(best.squared_distance):.3g} from the outline"
            if most is None:
                raise InputError("", f"points[{i}]", away,
                                 "give a tolerance within which points are moved onto it")
            if best.squared_distance > most * most:
                raise InputError("", f"points[{i}]", away, f"the tolerance is {float(most):.3g}")
        result.append(best)
    return result


def _nearest(point: Point, edge: Tuple[Point, Point], polygon: int, index: int) -> Placed:
    (ax, ay), (bx, by) = edge
    dx, dy = bx - ax, by - ay
    share = ((point[0] - ax) * dx + (point[1] - ay) * dy) / (dx * dx + dy * dy)
    share = min(max(share, Fraction(0)), Fraction(1))
    x, y = ax + share * dx, ay + share * dy
    away = (x - point[0]) ** 2 + (y - point[1]) ** 2
    return Placed((x, y), (-dy, dx), polygon, index, share, away)
