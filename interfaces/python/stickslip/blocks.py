# SPDX-License-Identifier: GPL-3.0-or-later
"""Blocks by their surfaces, where their faces lie on each other, and the assembly that they make.

Doubles only leave out what is too far away; all else is exact."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from . import _core, mesh_files
from .arguments import as_array, as_list, as_number, as_text, found
from .contacts import cross, dot, exact_vector
from .errors import InputError
from .mesh import MOST_OF_BODY, Mesh, Point, Triangle, _index, _minus, _parts, _short
from .outline import has_doubles

GROUND = "ground"
OPPOSED = Fraction(9997, 10000)
"""The square of the cosine of the angle, almost 1 degree, up to which two faces are parallel."""
SNAPPED_WITHIN = "1e-12"
"""How far a normal in doubles may move unasked, to be a rational unit vector."""

Plane = Tuple[Fraction, ...]  # a point in the plane, two coordinates


class Interface(NamedTuple):
    """Where two blocks touch, or one touches the ground."""

    of: str
    by: str
    normal: Point  # into the first
    corners: List[Point]


class Patch(NamedTuple):
    """Triangles of a block that lie in one plane, that of the largest, and hang together."""

    normal: Point  # out of the block
    origin: Point
    triangles: List[Triangle]
    unit: Tuple[float, ...]  # the normal, in doubles


class Block:
    """A surface, and if it is closed its volume and centre.

    Faces may have any number of vertices. They are cut into triangles, of which volume and centre are.
    """

    def __init__(self, vertices: Any, faces: Any, place: str, file: str = "", *, grid: Optional[Fraction] = None,
                 turn: bool = False) -> None:
        self.floats = has_doubles(vertices)
        rows = as_list(vertices, f"{place}.vertices", (len(as_array(vertices, f"{place}.vertices")), 3),
                       "one row x, y, z for each vertex")
        points = [tuple(rounded(_core.exact(x, f"{place}.vertices[{i}, {j}]"), grid) for j, x in enumerate(row))
                  for i, row in enumerate(rows)]
        triangles: List[Sequence[int]] = []
        numbers: List[int] = []
        for f, face in enumerate(faces):
            if not hasattr(face, "__len__") or len(face) < 3:
                raise InputError(file, f"{place}.faces[{f}]", f"this is {found(face)}",
                                 "a face has three vertices or more")
            own = [_index(v, f, len(points), f"{place}.faces") for v in face]
            cut = triangulated([points[v] for v in own])
            if cut is None:
                raise InputError(file, f"{place}.faces[{f}]", "the sides of the face cross each other",
                                 "split it into triangles")
            triangles += [[own[i] for i in three] for three in cut]
            numbers += [f] * len(cut)
        if turn and sum(dot(points[a], cross(points[b], points[c])) for a, b, c in triangles) < 0:
            triangles = [three[::-1] for three in triangles]
        try:
            self.mesh = Mesh((points, triangles), numbers, may_be_open=True)
        except InputError as error:
            raise InputError(file, f"{place}.{error.place}", error.problem, error.remedy) from None
        self._place, self._file = place, file
        self._patches: Dict[Fraction, List[Patch]] = {}

    def weighed(self) -> Tuple[Fraction, Point]:
        """Volume and centre, of a closed surface."""
        opening = self.mesh.opening
        if opening is not None:
            raise InputError(self._file, f"{self._place}.{opening.place}", opening.problem,
                             "close the mesh, as each edge of a body has two faces, or make it a support")
        scale, triangles = self._whole()
        six, moment = 0, [0, 0, 0]
        for a, b, c in triangles:
            part = _dot(a, cross(b, c))
            six += part
            moment = [x + part * (a[j] + b[j] + c[j]) for j, x in enumerate(moment)]
        return Fraction(six, 6 * scale**3), tuple(Fraction(x, 4 * six * scale) for x in moment)

    def _whole(self) -> Tuple[int, List[Sequence[List[int]]]]:
        """Triangles in whole numbers, and how many times larger they are."""
        scale = math.lcm(*(x.denominator for three in self.mesh.triangles for p in three for x in p))
        return scale, [[[x.numerator * (scale // x.denominator) for x in p] for p in three] for three in self.mesh.triangles]

    def patches(self, tolerance: Fraction) -> List[Patch]:
        """Largest triangles first; each takes neighbours whose vertices are no farther than the tolerance from its plane."""
        if tolerance not in self._patches:
            self._patches[tolerance] = self._merged(tolerance)
        return self._patches[tolerance]

    def _merged(self, tolerance: Fraction) -> List[Patch]:
        faces = self.mesh.faces
        scale, triangles = self._whole()
        normals = [cross(_difference(b, a), _difference(c, a)) for a, b, c in triangles]
        squares = [_dot(n, n) for n in normals]
        units = [_unit(n) for n in normals]
        within = tolerance * scale
        at: Dict[Tuple[int, int], List[int]] = {}
        for t, face in enumerate(faces):
            if squares[t] > 0:
                for i in range(3):
                    at.setdefault((face[i - 1], face[i]), []).append(t)
        taken = [square == 0 for square in squares]
        result = []
        for seed in sorted(range(len(faces)), key=lambda t: squares[t], reverse=True):
            if taken[seed]:
                continue
            n, origin, most = normals[seed], triangles[seed][0], within * within * squares[seed]
            taken[seed] = True
            own, waiting = [], [seed]
            while waiting:
                t = waiting.pop()
                own.append(self.mesh.triangles[t])
                for i in range(3):
                    for other in at.get((faces[t][i], faces[t][i - 1]), ()):
                        if not taken[other] and _near(units[seed], units[other]) and _parallel(
                                n, normals[other], squares[seed], squares[other]) and all(
                                _dot(n, _difference(p, origin))**2 <= most for p in triangles[other]):
                            taken[other] = True
                            waiting.append(other)
            result.append(Patch(tuple(map(Fraction, n)), self.mesh.triangles[seed][0], own, units[seed]))
        return result


def _dot(a: Sequence[int], b: Sequence[int]) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _difference(a: Sequence[int], b: Sequence[int]) -> List[int]:
    return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]


def _unit(n: Sequence[int]) -> Tuple[float, ...]:
    """In doubles."""
    most = max(abs(c) for c in n)
    if most == 0:
        return (0.0, 0.0, 0.0)
    x = [c / most for c in n]
    length = math.hypot(*x)
    return tuple(c / length for c in x)


def _near(n: Sequence[float], m: Sequence[float]) -> bool:
    """Whether two units may point the same way within a degree; doubles are off by far less than what is added."""
    return sum(x * y for x, y in zip(n, m)) > 0.999


def _parallel(n: Sequence[Any], m: Sequence[Any], nn: Any, mm: Any) -> bool:
    """Whether they point the same way, within a degree."""
    along = sum(x * y for x, y in zip(n, m))
    return bool(along > 0 and along * along >= OPPOSED * nn * mm)


def rounded(x: Fraction, grid: Optional[Fraction]) -> Fraction:
    return x if grid is None else round(x / grid) * grid


def _normal_of(polygon: Sequence[Point]) -> List[Fraction]:
    """Of twice its area: the sum over a fan."""
    fans = [cross(_minus(a, polygon[0]), _minus(b, polygon[0])) for a, b in zip(polygon[1:], polygon[2:])]
    return [sum((n[j] for n in fans), Fraction(0)) for j in range(3)]


def _turn(a: Plane, b: Plane, c: Plane) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _axes(n: Sequence[Fraction]) -> Tuple[int, int, int]:
    """The coordinate along which a plane is seen, and the two others, so that its front turns counterclockwise."""
    drop = max(range(3), key=lambda j: abs(n[j]))
    u, v = (drop + 1) % 3, (drop + 2) % 3
    return (drop, u, v) if n[drop] > 0 else (drop, v, u)


def triangulated(polygon: Sequence[Point]) -> Optional[List[Tuple[int, int, int]]]:
    """By numbers of corners; none if sides cross."""
    n = _normal_of(polygon)
    _, u, v = _axes(n)
    flat = [(p[u], p[v]) for p in polygon]
    fan = [(0, i, i + 1) for i in range(1, len(polygon) - 1)]
    if len(polygon) == 3 or not any(n) or (all(_turn(*(flat[i] for i in three)) >= 0 for three in fan) and all(
            _turn(flat[i - 2], flat[i - 1], p) >= 0 for i, p in enumerate(flat))):
        return fan  # without area, or convex
    if _cross(flat):
        return None
    left, result = list(range(len(flat))), []
    while len(left) > 3:
        for k, b in enumerate(left):
            a, c = left[k - 1], left[(k + 1) % len(left)]
            if _turn(flat[a], flat[b], flat[c]) > 0 and not any(
                    _within(flat[d], flat[a], flat[b], flat[c]) for d in left
                    if flat[d] not in (flat[a], flat[b], flat[c])):
                break
        else:
            k = 1  # no ear is left but on a line, or at a corner that touches a side
        result.append((left[k - 1], left[k], left[(k + 1) % len(left)]))
        del left[k]
    return result + [(left[0], left[1], left[2])]


def _cross(ring: Sequence[Plane]) -> bool:
    """Whether a side goes through another one."""
    sides = [(ring[i - 1], p) for i, p in enumerate(ring)]
    return any(_turn(a, b, c) * _turn(a, b, d) < 0 and _turn(c, d, a) * _turn(c, d, b) < 0
               for i, (a, b) in enumerate(sides) for c, d in sides[:i])


def _within(p: Plane, a: Plane, b: Plane, c: Plane) -> bool:
    return _turn(a, b, p) >= 0 and _turn(b, c, p) >= 0 and _turn(c, a, p) >= 0


def _clipped(polygon: List[Plane], a: Plane, b: Plane) -> List[Plane]:
    """What lies on the left of the line from a to b."""
    result: List[Plane] = []
    for i, q in enumerate(polygon):
        p = polygon[i - 1]
        s, t = _turn(a, b, p), _turn(a, b, q)
        if s * t < 0:
            result.append(tuple(x + (y - x) * s / (s - t) for x, y in zip(p, q)))
        if t >= 0:
            result.append(q)
    return result


def hull(points: Iterable[Plane]) -> List[Plane]:
    """Its corners, counterclockwise."""
    ordered = sorted(set(points))
    chains: List[List[Plane]] = []
    for run in (ordered, ordered[::-1]):
        chain: List[Plane] = []
        for p in run:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chains.append(chain[:-1])
    return chains[0] + chains[1]


def _counterclockwise(triangle: Sequence[Plane]) -> List[Plane]:
    return list(triangle) if _turn(*triangle) > 0 else list(triangle)[::-1]


def common_part(p: Patch, q: Patch, tolerance: Fraction) -> List[Point]:
    """The corners, in the plane of the first, of the convex hull of what two patches have in common as seen
    along a coordinate; none if they are not opposed, are apart, or have no more than a line in common. Corners
    that are no farther than the tolerance from the hull of the others are left out."""
    if not _near(p.unit, [-x for x in q.unit]):
        return []
    n, m = p.normal, q.normal
    size = dot(n, n)
    if not _parallel(n, [-x for x in m], size, dot(m, m)):
        return []
    drop, u, v = _axes(n)
    ours = [_counterclockwise([(c[u], c[v]) for c in triangle]) for triangle in p.triangles]
    theirs = [_counterclockwise([(c[u], c[v]) for c in triangle]) for triangle in q.triangles]
    parts: List[Plane] = []
    for one in ours:
        for other in theirs:
            part = other
            for i in range(3):
                part = _clipped(part, one[i - 1], one[i])
            parts += part
    corners = hull(parts)
    if len(corners) < 3:
        return []

    def lifted(corner: Plane, normal: Sequence[Fraction], origin: Point) -> Point:
        whole = [Fraction(0)] * 3
        whole[u], whole[v] = corner
        rest = normal[u] * (corner[0] - origin[u]) + normal[v] * (corner[1] - origin[v])
        whole[drop] = origin[drop] - rest / normal[drop]
        return tuple(whole)

    result = [lifted(corner, n, p.origin) for corner in corners]
    most = tolerance * tolerance * size
    for corner, here in zip(corners, result):
        if ((here[drop] - lifted(corner, m, q.origin)[drop]) * n[drop])**2 > most:
            return []
    area = sum((_turn(corners[0], a, b) for a, b in zip(corners[1:], corners[2:])), Fraction(0)) / 2
    longest = max(dot(away, away) for i, a in enumerate(result) for away in (_minus(b, a) for b in result[:i]))
    if area * area * size <= tolerance * tolerance * longest * n[drop]**2:
        return []
    return thinned(result, tolerance * tolerance) if tolerance > 0 else result


def thinned(ring: List[Point], most: Fraction) -> List[Point]:
    """Without corners of a convex polygon the square of whose distance from what remains is no more than this."""
    def between(run: List[Point]) -> List[Point]:
        a, b = run[0], run[-1]
        along = _minus(b, a)
        squares = [dot(away, away) for away in (cross(along, _minus(p, a)) for p in run[1:-1])]
        if not squares or max(squares) <= most * dot(along, along):
            return [a]
        far = squares.index(max(squares)) + 1
        return between(run[:far + 1]) + between(run[far:])

    i, j = max(((i, j) for j in range(len(ring)) for i in range(j)),
               key=lambda pair: dot(away := _minus(ring[pair[1]], ring[pair[0]]), away))
    return between(ring[i:j + 1]) + between(ring[j:] + ring[:i + 1])


def _boxes(patches: Sequence[Patch], tolerance: Fraction) -> Tuple[Any, Any]:
    """Around patches, in doubles, and wider by the tolerance and by what doubles round."""
    corners = [[[float(x) for x in point] for triangle in patch.triangles for point in triangle] for patch in patches]
    low = np.array([np.min(own, axis=0) for own in corners])
    high = np.array([np.max(own, axis=0) for own in corners])
    slack = 2 * float(tolerance) + (max(float(np.abs(low).max()), float(np.abs(high).max())) + float(tolerance)) * 2.0**-40
    return low - slack, high + slack


def touching(blocks: Mapping[str, Block], tolerance: Fraction) -> List[Interface]:
    """Where faces of two blocks lie on each other, on the face of the block that is named first."""
    names = list(blocks)
    patches = [blocks[name].patches(tolerance) for name in names]
    boxes = [_boxes(own, tolerance) for own in patches]
    lows = np.array([low.min(axis=0) for low, _ in boxes])
    highs = np.array([high.max(axis=0) for _, high in boxes])
    result = []
    for i, name in enumerate(names):
        near = np.nonzero(((lows[i] <= highs) & (lows <= highs[i])).all(axis=1))[0]
        for j in near[near > i].tolist():
            (low, high), (their_low, their_high) = boxes[i], boxes[j]
            both = ((low[:, None] <= their_high) & (their_low <= high[:, None])).all(axis=2)
            for k, other in np.argwhere(both).tolist():
                p = patches[i][k]
                corners = common_part(p, patches[j][other], tolerance)
                if corners:
                    result.append(Interface(name, names[j], tuple(-x for x in p.normal), corners))
    return result


def on_the_ground(blocks: Mapping[str, Block], height: Fraction, tolerance: Fraction) -> List[Interface]:
    """Where faces lie on the plane at this height: at the corners of the convex hull of each."""
    result = []
    for name, block in blocks.items():
        for patch in block.patches(tolerance):
            points = [point for triangle in patch.triangles for point in triangle]
            n = patch.normal
            if _parallel((Fraction(0), Fraction(0), Fraction(-1)), n, Fraction(1), dot(n, n)) and all(
                    abs(point[2] - height) <= tolerance for point in points):
                corners: List[Point] = [(x, y, height) for x, y in hull((point[0], point[1]) for point in points)]
                result.append(Interface(name, GROUND, (Fraction(0), Fraction(0), Fraction(1)),
                                        thinned(corners, tolerance * tolerance) if tolerance > 0 else corners))
    return result


def below(blocks: Mapping[str, Block], height: Fraction, tolerance: Fraction) -> Optional[str]:
    """A block of which a vertex is deeper than the tolerance under the plane at this height."""
    return next((name for name, block in blocks.items()
                 if any(point[2] < height - tolerance for triangle in block.mesh.triangles for point in triangle)), None)


def rational_units(normals: Sequence[Point]) -> List[Point]:
    """Of those that came as doubles; one whose length is rational stays in its direction."""
    if not normals:
        return []
    data = _core.SpatialGraspData([[0, 0, 0]] * len(normals), [list(n) for n in normals], 0, 1, 0, [0] * 6, "", True,
                                  [], [], None)
    snapped, _ = data.snap(SNAPPED_WITHIN)
    return [_short(n) if dot(n, n) != 1 else n for n in snapped.normals()]


def density_of(density: Any, names: Sequence[str], own: Mapping[str, Any]) -> Dict[str, Fraction]:
    """Of each block: one number, a mapping that names blocks, or what the file says of it."""
    result = {}
    if isinstance(density, Mapping):
        for key in density:
            if str(key) not in names:
                raise InputError("", f"density[{key!r}]", "there is no such block", "give one of " + listed(names))
    given = {str(key): value for key, value in density.items()} if isinstance(density, Mapping) else {}
    for name in names:
        place = f"density[{name!r}]" if name in given or isinstance(density, Mapping) else "density"
        value = given.get(name, own.get(name, 1 if isinstance(density, Mapping) else density))
        result[name] = _core.exact(as_number(value, place), place)
        if result[name] < 0:
            raise InputError("", place, f"the value is {_core.readable(result[name])}", "give a number, 0 or more")
    return result


def listed(names: Sequence[str]) -> str:
    return ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")


def as_supports(supports: Any, names: Sequence[str]) -> List[str]:
    if isinstance(supports, (str, bytes)) or not hasattr(supports, "__iter__"):
        raise InputError("", "supports", f"this is {found(supports)}", "give a list of names of blocks")
    result = []
    for i, key in enumerate(supports):
        if str(key) not in names:
            raise InputError("", f"supports[{i}]", f"there is no block {key!r}", "give one of " + listed(names))
        result.append(str(key))
    return result


def as_length(value: Any, name: str, least: str = "0 or more") -> Fraction:
    number = _core.exact(as_number(value, name), name)
    if number < 0 or (number == 0 and least != "0 or more"):
        raise InputError("", name, f"the value is {_core.readable(number)}", f"give a length {least}")
    return number


def read_blocks(meshes: Any, grid: Optional[Fraction]) -> Dict[str, Block]:
    """By names: pairs, objects with vertices and faces, or files; or the objects of one OBJ file."""
    if mesh_files.is_path(meshes):
        file = str(meshes)
        return {name: Block(*shape, f"objects[{name!r}]", file, grid=grid)
                for name, shape in mesh_files.read_objects(meshes, "meshes").items()}
    if not isinstance(meshes, Mapping):
        raise InputError("", "meshes", f"this is {found(meshes)}",
                         "give a mapping of names to meshes, or one OBJ file with an object for each block")
    if not meshes:
        raise InputError("", "meshes", "there is no block", "give a mesh for each block by its name")
    blocks = {}
    for key, mesh in meshes.items():
        name = as_text(key, "a name in meshes")
        place = f"meshes[{name!r}]"
        if not name or name == GROUND:
            raise InputError("", place, "no block has this name", "give it another one" if name else "give it a name")
        if mesh_files.is_path(mesh):
            shape, floats = mesh_files.read(mesh, place)
            blocks[name] = Block(*shape, place, str(mesh), grid=grid)
            blocks[name].floats = floats
        else:
            blocks[name] = Block(*_parts(mesh, place), place, grid=grid)
    return blocks


def content_of(blocks: Mapping[str, Block], interfaces: Sequence[Interface], supports: Sequence[str], friction: Any,
               stiffness: Any, densities: Mapping[str, Fraction], gravity: Any, name: str,
               units: Mapping[str, str], floats: bool) -> Dict[str, Any]:
    """What an Assembly takes: supports are the ground, and every other block is a body with its weight."""
    g = exact_vector(gravity, "gravity")
    free = [block for block in blocks if block not in supports]
    if not free:
        raise InputError("", "supports", "every block is a support", "leave out those that may move")
    kinds = list(dict.fromkeys(interface.normal for interface in interfaces))
    made = rational_units(kinds) if floats else [_short(n) for n in kinds]
    normals = dict(zip(kinds, made))
    contacts = []
    for one, two, direction, corners in interfaces:
        normal = normals[direction]
        if one in supports:
            one, two, normal = two, one, tuple(-x for x in normal)
        if one in supports or one == GROUND:
            continue
        by = {} if two in supports or two == GROUND else {"by": two}
        contacts += [{"of": one, **by, "position": p, "normal": normal} for p in corners]
    loads = []
    for key in free:
        volume, centre = blocks[key].weighed()
        loads.append({"body": key, "force": [x * densities[key] * volume for x in g], "at": centre})
    bodies: List[Dict[str, Any]] = [{"name": key} for key in free]
    room = MOST_OF_BODY
    for body in bodies:
        room -= 4
        shape = blocks[body["name"]].mesh.body()
        if shape is not None:
            size = 4 * (len(shape[0]) + len(shape[1])) + 3
            if size + 4 * len(bodies) < room:
                body["mesh"] = {"vertices": shape[0], "faces": shape[1]}
                room -= size
    defaults = {"friction": as_number(friction, "friction")}
    if stiffness is not None:
        defaults["stiffness"] = as_number(stiffness, "stiffness")
    content: Dict[str, Any] = {"bodies": bodies, "defaults": defaults, "contacts": contacts, "loads": loads}
    if name:
        content["name"] = name
    if units:
        content["units"] = dict(units)
    return content
