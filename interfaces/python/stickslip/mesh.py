# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts by their places on a mesh of triangles. Doubles leave out triangles that are too far away;
all else is exact."""

from __future__ import annotations

import math
import operator
from fractions import Fraction
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from . import _core
from .arguments import as_array, as_list, as_number, found
from .contacts import cross, dot, exact_vector
from .errors import InputError
from .outline import unit_if_rational
from .views import FloatArray, nearest_double, nearest_root

Point = Tuple[Fraction, ...]
# A member of a grasp file holds 65,536 values (docs/grasp_file.md), of which "body" itself has 3.
MOST_OF_BODY = 65533
Triangle = Tuple[Point, Point, Point]


class OnMesh(NamedTuple):
    """A point of the mesh."""

    position: Point
    normal: Point  # into the body; a unit vector if that is rational, else whole
    face: int
    squared_distance: Fraction  # from the point that was asked for


class Mesh:
    """A closed surface, whose triangles run counterclockwise as seen from outside.

    Vertices at the same place are one; triangles without area are left out. Where triangles are parts of
    faces, ``numbers`` has of each the number of its face, for messages. A surface that ``may_be_open`` has
    in ``opening`` what is said of one that may not.
    """

    def __init__(self, mesh: Any, numbers: Optional[Sequence[int]] = None, may_be_open: bool = False) -> None:
        self._numbers = numbers
        self._may_be_open = may_be_open
        self.opening: Optional[InputError] = None
        vertices, faces = _parts(mesh)
        merged: Dict[Point, int] = {}
        rows = as_list(vertices, "vertices", (len(as_array(vertices, "vertices")), 3), "one row x, y, z "
                       "for each vertex")
        places = [merged.setdefault(tuple(_core.exact(x, f"vertices[{i}, {j}]")
                                          for j, x in enumerate(row)), i)
                  for i, row in enumerate(rows)]
        points = {i: point for point, i in merged.items()}
        self.faces: List[Tuple[int, ...]] = []  # by vertices that are at different places
        for f, face in enumerate(as_list(faces, "faces", (len(as_array(faces, "faces")), 3), "three "
                                         "vertices for each triangle")):
            self.faces.append(tuple(places[_index(v, f, len(places))] for v in face))
        if not self.faces:
            raise InputError("", "faces", "there is no triangle", "give at least four")
        self.triangles: List[Triangle] = [(points[a], points[b], points[c]) for a, b, c in self.faces]
        whole = [f for f, face in enumerate(self.faces) if len(set(face)) == 3]
        self._check_edges(whole)
        if self.opening is None:
            self._check_parts(whole, points)
        self._boxes = _Boxes(self.triangles)

    def body(self) -> Optional[Tuple[List[Point], List[List[int]]]]:
        """Vertices, in the order in which faces have them, and faces; none if it is too large for a file."""
        numbers: Dict[int, int] = {}
        points: Dict[int, Point] = {}
        faces = []
        for face, triangle in zip(self.faces, self.triangles):
            if len(set(face)) == 3:
                faces.append([numbers.setdefault(v, len(numbers)) for v in face])
                points.update(zip(face, triangle))
        vertices = [points[v] for v in numbers]
        return None if 4 * (len(vertices) + len(faces)) > MOST_OF_BODY else (vertices, faces)

    def _number(self, face: int) -> int:
        return face if self._numbers is None else self._numbers[face]

    def _check_edges(self, faces: Sequence[int]) -> None:
        """That each edge is run along as often one way as the other."""
        runs: Dict[Tuple[int, int], List[int]] = {}
        for f in faces:
            for edge in _edges(self.faces[f]):
                runs.setdefault(edge, []).append(f)
        for (a, b), along in runs.items():
            if len(along) <= len(runs.get((b, a), ())):
                continue
            named = f"the edge from vertex {a} to vertex {b}"
            if len(along) > 1:
                first, second = self._number(along[0]), self._number(along[1])
                raise InputError("", f"faces[{second}]", f"{named} runs the same way in faces {first} "
                                 f"and {second}", "turn one of the two around: seen from outside, all "
                                 "run counterclockwise")
            self.opening = InputError("", f"faces[{self._number(along[0])}]", f"{named} has no face on its other side",
                                      "close the mesh: each edge has two faces")
            if not self._may_be_open:
                raise self.opening

    def _check_parts(self, faces: Sequence[int], points: Dict[int, Point]) -> None:
        """That what is inside out can only be a hole within another part."""
        scale = math.lcm(*(x.denominator for point in points.values() for x in point))
        whole = {v: [int(x * scale) for x in point] for v, point in points.items()}
        parts: Dict[int, List[int]] = {}
        for f, part in zip(faces, _parts_of([self.faces[f] for f in faces])):
            parts.setdefault(part, []).append(f)
        boxes: List[Tuple[int, List[Tuple[int, int]], int]] = []  # six times the volume, sides, a face
        for own in parts.values():
            corners = [[whole[v] for v in self.faces[f]] for f in own]
            volume = sum(sum(x * y for x, y in zip(a, cross(b, c))) for a, b, c in corners)
            axes = list(zip(*(corner for three in corners for corner in three)))
            boxes.append((volume, [(min(axis), max(axis)) for axis in axes], own[0]))
        for volume, sides, f in boxes:
            if volume == 0:
                raise InputError("", f"faces[{self._number(f)}]", "the part of the mesh that it is of encloses no volume",
                                 "leave that part out")
            if volume < 0 and not any(larger > 0 and all(
                    low < own_low and own_high < high
                    for (low, high), (own_low, own_high) in zip(around, sides))
                    for larger, around, _ in boxes):
                raise InputError("", f"faces[{self._number(f)}]", "the part of the mesh that it is of is inside out",
                                 "turn its faces around, faces[:, ::-1]: seen from outside, all run "
                                 "counterclockwise")

    def nearest(self, point: Point) -> OnMesh:
        """The nearest point; of several the one of the face that comes first."""
        best = (Fraction(-1), -1, point)  # none yet
        for bound, f in self._boxes.outwards(point):
            if best[1] >= 0 and Fraction(bound) > best[0]:
                break
            if any(_normal(self.triangles[f])):
                q = nearest_of_triangle(point, self.triangles[f])
                away = [x - y for x, y in zip(q, point)]
                squared = dot(away, away)
                if best[1] < 0 or (squared, f) < best[:2]:
                    best = (squared, f, q)
        squared, f, q = best
        return OnMesh(q, _short([-x for x in _normal(self.triangles[f])]), f, squared)

    def place(self, points: Any, tolerance: Any) -> List[OnMesh]:
        """The nearest place for each of the points."""
        most = None if tolerance is None else _core.exact(as_number(tolerance, "tolerance"), "tolerance")
        rows = as_list(points, "points", (len(as_array(points, "points")), 3), "one row x, y, z for each point")
        result = []
        for i, row in enumerate(rows):
            one = self.nearest(tuple(exact_vector(row, f"points[{i}]")))
            if one.squared_distance > 0:
                away = f"it is {nearest_root(one.squared_distance):.3g} from the mesh"
                if most is None:
                    raise InputError("", f"points[{i}]", away,
                                     "give a tolerance within which points are moved onto it")
                if most < 0 or one.squared_distance > most * most:
                    raise InputError("", f"points[{i}]", away, f"the tolerance is {nearest_double(most):.3g}")
            result.append(one)
        return result


def as_body(body: Any) -> Optional[Tuple[List[List[Any]], List[List[int]]]]:
    """Of a Grasp: no more is known of it than that its faces name vertices."""
    if body is None:
        return None
    vertices, faces = _parts(body, "body")
    rows = as_list(vertices, "body.vertices", (len(as_array(vertices, "body.vertices")), 3),
                   "one row x, y, z for each vertex")
    numbers = []
    for f, face in enumerate(faces):
        if not hasattr(face, "__len__") or len(face) < 3:
            raise InputError("", f"body.faces[{f}]", f"this is {found(face)}",
                             "a face has three vertices or more")
        numbers.append([_index(v, f, len(rows), "body.faces") for v in face])
    if not numbers:
        raise InputError("", "body.faces", "there is no face", "give a face, or no body")
    return rows, numbers


def _parts(mesh: Any, name: str = "mesh") -> Tuple[Any, Any]:
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        raise InputError("", name, f"this is {found(mesh)}", "give a pair, vertices and faces, or an "
                         "object that has both, as of trimesh")
    return mesh[0], mesh[1]


def _index(vertex: Any, face: int, count: int, name: str = "faces") -> int:
    try:
        index = -1 if isinstance(vertex, bool) else operator.index(vertex)
    except TypeError:
        index = -1
    if not 0 <= index < count:
        raise InputError("", f"{name}[{face}]", f"{found(vertex)} is no vertex",
                         f"give numbers from 0 to {count - 1}")
    return index


def _edges(face: Sequence[int]) -> Iterator[Tuple[int, int]]:
    return ((face[i - 1], face[i]) for i in range(3))


def _parts_of(faces: Sequence[Sequence[int]]) -> List[int]:
    """Of each face a vertex that all faces share that hang together."""
    parent: Dict[int, int] = {}

    def root(v: int) -> int:
        while parent.setdefault(v, v) != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b, c in faces:
        parent[root(a)] = root(b)
        parent[root(b)] = root(c)
    return [root(face[0]) for face in faces]


def _minus(a: Point, b: Point) -> List[Fraction]:
    return [x - y for x, y in zip(a, b)]


def _normal(triangle: Triangle) -> Point:
    """Out of the body, twice as long as the area is large."""
    a, b, c = triangle
    return tuple(cross(_minus(b, a), _minus(c, a)))


def _short(normal: Sequence[Fraction]) -> Point:
    """Of the same direction: the unit vector if that is rational, else of whole numbers."""
    scale = Fraction(math.lcm(*(x.denominator for x in normal)))
    scale /= math.gcd(*(int(x * scale) for x in normal))
    return unit_if_rational(tuple(x * scale for x in normal))


def nearest_of_triangle(p: Point, triangle: Triangle) -> Point:
    """Of one with an area: the foot of the perpendicular, if that is inside, or a point of an edge."""
    a, b, c = triangle
    normal = _normal(triangle)
    sides = [(a, b), (b, c), (c, a)]
    outside = [(s, e) for s, e in sides if dot(cross(_minus(e, s), _minus(p, s)), normal) < 0]
    if not outside:
        share = dot(_minus(p, a), normal) / dot(normal, normal)
        return tuple(x - share * y for x, y in zip(p, normal))
    return min((_nearest_of_segment(p, *side) for side in outside),
               key=lambda q: dot(_minus(q, p), _minus(q, p)))


def _nearest_of_segment(p: Point, a: Point, b: Point) -> Point:
    along = _minus(b, a)
    share = min(max(dot(_minus(p, a), along) / dot(along, along), Fraction(0)), Fraction(1))
    return tuple(x + share * y for x, y in zip(a, along))


class _Boxes:
    """Boxes around triangles, in doubles: no triangle is nearer to a point than its box.

    A coordinate is off by at most u = 2^-53 of itself, and a difference by u of itself more: together
    less than 4 u of the largest coordinate, for which 2^-50 of it is taken. Squares and sums are off
    by less than 2^-50 of themselves, unless they are so small that they are taken as 0.
    """

    def __init__(self, triangles: Sequence[Triangle]) -> None:
        try:
            corners = np.array([[[float(x) for x in point] for point in triangle]
                                for triangle in triangles])
        except OverflowError:  # beyond the doubles: nothing is left out
            corners = np.zeros((len(triangles), 3, 3))
            self._slack = float("inf")
        else:
            self._slack = float(np.abs(corners).max()) * 2.0 ** -50
        self._low: FloatArray = corners.min(axis=1)
        self._high: FloatArray = corners.max(axis=1)

    def outwards(self, point: Point) -> Iterator[Tuple[float, int]]:
        """Each face, and what the square of its distance is at least; those first that may be near."""
        bounds = np.zeros(len(self._low))
        try:
            p = np.array([float(x) for x in point])
        except OverflowError:
            pass
        else:
            slack = self._slack + float(np.abs(p).max()) * 2.0 ** -50
            with np.errstate(over="ignore", under="ignore", invalid="ignore"):
                gaps = np.maximum(np.maximum(self._low - p, p - self._high) - slack, 0)
                bounds = np.minimum((gaps * gaps).sum(axis=1) * (1 - 2.0 ** -40), 1e300)
            bounds[~(bounds > 1e-290)] = 0
        for f in np.argsort(bounds, kind="stable").tolist():
            yield float(bounds[f]), f
