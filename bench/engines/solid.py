# SPDX-License-Identifier: GPL-3.0-or-later
"""The same as scene.py in space: a convex body with corners against half-spaces.

The body's axes are those of the world before it moves, and its tensor of gyration is diagonal in
them, so that every engine takes it as it is.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Dict, List, NamedTuple, Tuple

from scene import read, spelled

Point = Tuple[Fraction, Fraction, Fraction]
Wrench = Tuple[Fraction, ...]  # force and torque about the origin

WIDTH = 8  # of a half-space to each side of its point, where engines need an end
DEPTH = 4


class Obstacle(NamedTuple):
    """A half-space: a point of its border, its unit normal towards the body."""

    point: Point
    normal: Point
    friction: Fraction


class Body(NamedTuple):
    """Corners; mass 1, with squared radii of gyration about the axes."""

    vertices: Tuple[Point, ...]
    gyration: Point


class Contact(NamedTuple):
    position: Point
    normal: Point
    friction: Fraction


def dot(a: Point, b: Point) -> Fraction:
    return sum(x * y for x, y in zip(a, b))


def plus(a: Point, b: Point, factor: Fraction = Fraction(1)) -> Point:
    return tuple(x + factor * y for x, y in zip(a, b))


def cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def size(body: Body) -> float:
    """The diameter."""
    return max(math.dist(a, b) for a in body.vertices for b in body.vertices)


def contacts(body: Body, obstacles: List[Obstacle]) -> List[Contact]:
    """The corners that touch."""
    return [Contact(v, o.normal, o.friction) for o in obstacles for v in body.vertices
            if dot(o.normal, plus(v, o.point, Fraction(-1))) == 0]


def moved(contact: Contact, along: Fraction, across: Fraction) -> Contact:
    """Along the normal, and across it."""
    least = min(range(3), key=lambda k: abs(contact.normal[k]))
    tangent = cross(contact.normal, tuple(Fraction(int(k == least)) for k in range(3)))
    unit = Fraction(1 / math.sqrt(dot(tangent, tangent))).limit_denominator(64)
    return contact._replace(position=plus(plus(contact.position, tangent, across * unit), contact.normal, along))


def shape(obstacle: Obstacle) -> List[List[float]]:
    """A slab for engines."""
    n = [float(c) for c in obstacle.normal]
    least = min(range(3), key=lambda k: abs(n[k]))
    t = cross(n, [float(k == least) for k in range(3)])
    t = [c / math.hypot(*t) for c in t]
    s = cross(n, t)
    return [[float(p) + a * WIDTH * x + b * WIDTH * y - depth * z for p, x, y, z in zip(obstacle.point, t, s, n)]
            for a in (-1, 1) for b in (-1, 1) for depth in (0, DEPTH)]


def wrench_of(force: Point, at: Point = (Fraction(0),) * 3) -> Wrench:
    return (*force, *cross(at, force))


def inertia(body: Body) -> str:
    """As `stickslip compare --inertia` takes it."""
    return "0,0,0," + ",".join(map(str, body.gyration))


def grasp_file(name: str, body: Body, touching: List[Contact], wrench: Wrench) -> Dict[str, object]:
    """The grasp as docs/grasp_file.md has it."""
    return {"format": "stickslip-grasp/2", "name": name,
            "contacts": [{"position": [spelled(c) for c in contact.position],
                          "normal": [spelled(c) for c in contact.normal],
                          "friction": spelled(contact.friction)} for contact in touching],
            "wrench": [spelled(c) for c in wrench]}


def written(scene) -> Dict[str, object]:
    """What a line of cases/space says of a Scene, besides the grasp."""
    return {"gyration": [spelled(c) for c in scene.body.gyration], "settle": [spelled(c) for c in scene.settle],
            "vertices": [[spelled(c) for c in v] for v in scene.body.vertices],
            "obstacles": [{"point": [spelled(c) for c in o.point], "normal": [spelled(c) for c in o.normal],
                           "friction": spelled(o.friction)} for o in scene.obstacles]}


def scene_of(case: Dict[str, object]) -> Tuple[Body, List[Obstacle]]:
    """What a line of cases/space says."""
    point = lambda numbers: tuple(map(read, numbers))
    return (Body(tuple(map(point, case["vertices"])), point(case["gyration"])),
            [Obstacle(point(o["point"]), point(o["normal"]), read(o["friction"])) for o in case["obstacles"]])
