# SPDX-License-Identifier: GPL-3.0-or-later
"""A body against obstacles that do not move, in rational coordinates, and the contacts between them.

The body is convex, a polygon (vertices counterclockwise) or a disc. Its centre of mass is the
origin of all coordinates, which are those of the world before it moves. An obstacle touches it
along one normal: a half-plane, or the tip of a wedge that opens away from the body.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Dict, List, NamedTuple, Tuple

Point = Tuple[Fraction, Fraction]
Wrench = Tuple[Fraction, Fraction, Fraction]

WIDTH = 12  # of a half-plane to each side of its point, where engines need an end
DEPTH = 4


class Obstacle(NamedTuple):
    """Where it is, its unit normal towards the body, and whether it is a tip."""

    point: Point
    normal: Point
    friction: Fraction
    tip: bool = False


class Body(NamedTuple):
    """Vertices, or none and a radius; mass 1, with a radius of gyration about the origin."""

    vertices: Tuple[Point, ...]
    radius: Fraction
    gyration: Fraction


class Contact(NamedTuple):
    position: Point
    normal: Point
    friction: Fraction


def dot(a: Point, b: Point) -> Fraction:
    return a[0] * b[0] + a[1] * b[1]


def turned(a: Point) -> Point:
    """By +90 degrees."""
    return (-a[1], a[0])


def plus(a: Point, b: Point, factor: Fraction = Fraction(1)) -> Point:
    return (a[0] + factor * b[0], a[1] + factor * b[1])


def cross(a: Point, b: Point) -> Fraction:
    return a[0] * b[1] - a[1] * b[0]


def unit(t: Fraction) -> Point:
    """The unit vector at an angle of 2 atan t: rational in both coordinates."""
    return ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))


def rational_root(value: Fraction) -> Fraction:
    """Near the square root, in 64ths."""
    return Fraction(max(1, round(math.sqrt(value) * 64)), 64)


def disc(radius: Fraction) -> Body:
    return Body((), radius, rational_root(radius * radius / 2))


def polygon(vertices: List[Point]) -> Tuple[Body, Point]:
    """The uniform body about its centre of mass, and where that was."""
    edges = [(a, b, cross(a, b)) for a, b in zip(vertices, vertices[1:] + vertices[:1])]
    area = sum(c for _, _, c in edges) / 2
    centre = (sum((a[0] + b[0]) * c for a, b, c in edges) / (6 * area),
              sum((a[1] + b[1]) * c for a, b, c in edges) / (6 * area))
    polar = sum(c * (dot(a, a) + dot(a, b) + dot(b, b)) for a, b, c in edges) / (12 * area)
    return Body(tuple(plus(v, centre, Fraction(-1)) for v in vertices), Fraction(0),
                rational_root(polar - dot(centre, centre))), centre


def size(body: Body) -> float:
    """The diameter."""
    if not body.vertices:
        return float(2 * body.radius)
    return max(math.dist(a, b) for a in body.vertices for b in body.vertices)


def placed(body: Body, pose: Tuple[float, float, float]) -> Body:
    """The body moved: turned about the origin, then shifted. Doubles are exact numbers; the
    sine and the cosine are those nearest."""
    x, y, angle = pose
    c, s = Fraction(math.cos(angle)), Fraction(math.sin(angle))
    return body._replace(vertices=tuple(
        (c * v[0] - s * v[1] + Fraction(x), s * v[0] + c * v[1] + Fraction(y)) for v in body.vertices))


def contacts(body: Body, obstacles: List[Obstacle], within: Fraction = Fraction(0),
             centre: Point = (Fraction(0), Fraction(0))) -> List[Contact]:
    """Where they touch: gaps of at most `within`. `centre` is that of a disc."""
    found = []
    for obstacle in obstacles:
        point, normal, friction, tip = obstacle
        if not body.vertices:
            towards = plus(point, centre, Fraction(-1))
            gap = (-dot(normal, towards)) - body.radius
            if abs(gap) <= within:
                found.append(Contact(plus(centre, normal, -body.radius), normal, friction))
        elif tip:
            edges = list(zip(body.vertices, body.vertices[1:] + body.vertices[:1]))
            inside = [(cross(plus(b, a, Fraction(-1)), plus(point, a, Fraction(-1))), a, b) for a, b in edges]
            depth, a, b = min(inside, key=lambda e: float(e[0]) / math.dist(e[1], e[2]))
            if float(abs(depth)) <= float(within) * math.dist(a, b):
                found.append(Contact(point, turned(plus(b, a, Fraction(-1))), friction))
        else:
            found += [Contact(v, normal, friction) for v in body.vertices
                      if abs(dot(normal, plus(v, point, Fraction(-1)))) <= within]
    return found


def shape(obstacle: Obstacle) -> List[Point]:
    """A convex polygon for engines, counterclockwise: the half-plane with an end, or the wedge."""
    point, normal, _, tip = obstacle
    along = turned(normal)
    if tip:
        return [point, plus(plus(point, normal, Fraction(-DEPTH)), along, Fraction(1)),
                plus(plus(point, normal, Fraction(-DEPTH)), along, Fraction(-1))]
    left, right = plus(point, along, Fraction(WIDTH)), plus(point, along, Fraction(-WIDTH))
    return [left, plus(left, normal, Fraction(-DEPTH)), plus(right, normal, Fraction(-DEPTH)), right]


def moved(contact: Contact, along: Fraction, across: Fraction) -> Contact:
    """Along the normal, and across it."""
    return contact._replace(position=plus(plus(contact.position, turned(contact.normal), across),
                                          contact.normal, along))


def inertia(body: Body) -> str:
    """As `stickslip compare --inertia` takes it."""
    return f"0,0,{body.gyration ** 2}"


def wrench_of(force: Point, at: Point = (Fraction(0), Fraction(0))) -> Wrench:
    return (force[0], force[1], cross(at, force))


def grasp_file(name: str, body: Body, touching: List[Contact], wrench: Wrench) -> Dict[str, object]:
    """The grasp as docs/grasp_file.md has it."""
    grasp: Dict[str, object] = {"format": "stickslip-grasp/2", "name": name}
    if body.vertices:
        grasp["outline"] = [[spelled(c) for c in v] for v in body.vertices]
    grasp["contacts"] = [{"position": [spelled(c) for c in contact.position],
                          "normal": [spelled(c) for c in contact.normal],
                          "friction": spelled(contact.friction)} for contact in touching]
    grasp["wrench"] = [spelled(c) for c in wrench]
    return grasp


def spelled(value: Fraction) -> object:
    return value.numerator if value.denominator == 1 else str(value)


def read(value: object) -> Fraction:
    return Fraction(str(value))


def written(scene) -> Dict[str, object]:
    """What a line of cases/ says of a Scene of families.py, besides the grasp."""
    found: Dict[str, object] = {
        "gyration": spelled(scene.body.gyration), "settle": [spelled(c) for c in scene.settle],
        "obstacles": [{"point": [spelled(c) for c in o.point], "normal": [spelled(c) for c in o.normal],
                       "friction": spelled(o.friction), **({"tip": True} if o.tip else {})} for o in scene.obstacles]}
    if scene.body.radius:
        found["radius"] = spelled(scene.body.radius)
    return found


def scene_of(case: Dict[str, object]) -> Tuple[Body, List[Obstacle]]:
    """What a line of cases/ says."""
    point = lambda pair: (read(pair[0]), read(pair[1]))
    body = Body(tuple(point(v) for v in case["grasp"].get("outline", [])), read(case.get("radius", 0)),
                read(case["gyration"]))
    return body, [Obstacle(point(o["point"]), point(o["normal"]), read(o["friction"]), o.get("tip", False))
                  for o in case["obstacles"]]
