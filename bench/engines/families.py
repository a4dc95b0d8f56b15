# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of scenes, with their numbers drawn at random.

Each gives a scene whose `settle` presses the body onto its obstacles, and a direction in which the
load goes on from there until the body must move.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt
from random import Random
from typing import List, NamedTuple

from scene import (Body, Obstacle, Point, Wrench, cross, disc, dot, plus, polygon, turned, unit, wrench_of)

F = Fraction
PRESS = F(10)  # the size of loads: a weight, in the units of engines


class Scene(NamedTuple):
    body: Body
    obstacles: List[Obstacle]
    settle: Wrench
    direction: Wrench


def share(random: Random, low: int, high: int, of: int = 16) -> Fraction:
    return F(random.randint(low, high), of)


def scaled(a: Point, factor: Fraction) -> Point:
    return (a[0] * factor, a[1] * factor)


def turn(a: Point, by: Point) -> Point:
    """Complex product: a turned by the angle of the unit vector `by`."""
    return (a[0] * by[0] - a[1] * by[1], a[0] * by[1] + a[1] * by[0])


def box(half_width: Fraction, half_height: Fraction, by: Point = (F(1), F(0))) -> List[Point]:
    corners = [(-half_width, -half_height), (half_width, -half_height), (half_width, half_height),
               (-half_width, half_height)]
    return [turn(c, by) for c in corners]


def slope(random: Random) -> Point:
    """Along a slope of 7 to 41 degrees, either way."""
    return unit(random.choice([1, -1]) * share(random, 1, 6))


def ramp(random: Random) -> Scene:
    """A box that slides down before it tips."""
    along = slope(random)
    width, height = share(random, 11, 16), share(random, 4, 8)
    body, _ = polygon(box(width, height, along))
    normal = turned(along)
    floor = Obstacle(scaled(normal, -height), normal, share(random, 3, 14))
    way = scaled(along, -PRESS if along[1] > 0 else PRESS)
    return Scene(body, [floor], wrench_of(scaled(normal, -PRESS)), wrench_of(way))


def tipping(random: Random) -> Scene:
    """A tall box, pushed where it may tip or slide."""
    along = slope(random)
    width, height = share(random, 4, 8), share(random, 11, 16)
    body, _ = polygon(box(width, height, along))
    normal = turned(along)
    floor = Obstacle(scaled(normal, -height), normal, share(random, 6, 15))
    at = scaled(normal, height * share(random, -8, 16))
    return Scene(body, [floor], wrench_of(scaled(normal, -PRESS)),
                 wrench_of(scaled(along, random.choice([-PRESS, PRESS])), at))


def groove(random: Random) -> Scene:
    """A disc in a V, turned or pushed."""
    radius = share(random, 8, 16)
    slopes = [unit(share(random, 3, 9)), unit(-share(random, 3, 9))]
    obstacles = [Obstacle(scaled(turned(s), -radius), turned(s), share(random, 2, 9)) for s in slopes]
    torque = random.choice([-1, 1]) * PRESS * radius
    side = share(random, -8, 8)
    return Scene(disc(radius), obstacles, wrench_of((F(0), -PRESS)), (side * PRESS, F(0), torque))


def corner(random: Random) -> Scene:
    """A box between a floor and a wall, lifted, turned or pulled out."""
    width, height = share(random, 6, 16), share(random, 6, 16)
    by = slope(random) if random.random() < 0.5 else (F(1), F(0))
    body, _ = polygon(box(width, height, by))
    floor, wall = turned(by), by
    obstacles = [Obstacle(scaled(floor, -height), floor, share(random, 3, 14)),
                 Obstacle(scaled(wall, -width), wall, share(random, 3, 14))]
    settle = plus(scaled(floor, -PRESS), wall, -PRESS * share(random, 4, 16))
    force = turn((share(random, -4, 16) * PRESS, share(random, -4, 16) * PRESS), by)
    at = turn((width * share(random, -16, 16), height * share(random, -16, 16)), by)
    return Scene(body, obstacles, wrench_of(settle), wrench_of(force, at))


def ladder(random: Random) -> Scene:
    """A bar that leans at a wall; the weight climbs, or the foot is pulled."""
    length, thickness = F(1), share(random, 1, 3)
    by = unit(-share(random, 7, 12))  # 47 to 74 degrees downwards to the right
    body, _ = polygon(box(length, thickness, by))
    foot = min(body.vertices, key=lambda v: v[1])
    top = min(body.vertices, key=lambda v: v[0])
    obstacles = [Obstacle(foot, (F(0), F(1)), share(random, 4, 12)),
                 Obstacle(top, (F(1), F(0)), share(random, 2, 10))]
    low, high = (scaled(by, length * share(random, 6, 15)), scaled(by, -length * share(random, 4, 15)))
    settle = wrench_of((F(0), -PRESS), low)
    climbing = wrench_of((F(0), -PRESS), high)
    if random.random() < 0.6:
        direction = tuple(b - a for a, b in zip(settle, climbing))
    else:
        direction = wrench_of((PRESS, F(0)), foot)
    return Scene(body, obstacles, settle, direction)


def jam(random: Random) -> Scene:
    """A keystone between two walls that lean outwards, pulled and turned."""
    left, right = unit(share(random, 9, 14)), unit(share(random, 9, 14))  # along the walls, upwards
    height = share(random, 12, 24)
    width = share(random, 6, 16)
    leaning = lambda way: height * way[0] / way[1]
    vertices = [(-width, F(0)), (width, F(0)), (width + leaning(right), height), (-width - leaning(left), height)]
    body, centre = polygon(vertices)
    origin = scaled(centre, F(-1))
    friction = share(random, 2, 9)
    obstacles = [Obstacle(plus((-width, F(0)), origin), (left[1], left[0]), friction),
                 Obstacle(plus((width, F(0)), origin), (-right[1], right[0]), friction)]
    force = (share(random, -16, 16) * PRESS, share(random, -2, 12) * PRESS)
    at = (width * share(random, -16, 16), height * share(random, -8, 8))
    return Scene(body, obstacles, wrench_of((F(0), -PRESS)), wrench_of(force, at))


def drawer(random: Random) -> Scene:
    """A box askew between two rails, which it touches with two corners; it is pulled out."""
    by = unit(random.choice([-1, 1]) * share(random, 1, 4, 32))
    body, _ = polygon(box(F(1), share(random, 6, 14), by))
    low, high = min(body.vertices, key=lambda v: v[1]), max(body.vertices, key=lambda v: v[1])
    friction = share(random, 3, 12)
    obstacles = [Obstacle(low, (F(0), F(1)), friction), Obstacle(high, (F(0), F(-1)), friction)]
    torque = PRESS * (1 if by[1] > 0 else -1)
    at = (F(0), share(random, -16, 16))
    return Scene(body, obstacles, (F(0), share(random, -8, 8) * PRESS / 4, torque * share(random, 12, 20)),
                 wrench_of((random.choice([-PRESS, PRESS]), share(random, -4, 4) * PRESS), at))


def hull(points: List[Point]) -> List[Point]:
    chain: List[Point] = []
    ordered = sorted(set(points))
    for half in (ordered, ordered[::-1]):
        start = len(chain)
        for p in half:
            while len(chain) - start >= 2 and cross(plus(chain[-1], chain[-2], F(-1)), plus(p, chain[-2], F(-1))) <= 0:
                chain.pop()
            chain.append(p)
        chain.pop()
    return chain


def anything(random: Random) -> Scene:
    """A polygon at random, against two to four half-planes and tips."""
    vertices: List[Point] = []
    while len(vertices) < 4:
        vertices = hull([(share(random, -8, 8, 8), share(random, -8, 8, 8)) for _ in range(7)])
    body, _ = polygon(vertices)
    edges = list(zip(body.vertices, body.vertices[1:] + body.vertices[:1]))
    obstacles, settle = [], [F(0)] * 3
    for _ in range(random.randint(2, 4)):
        friction = share(random, 3, 14)
        normal = unit(share(random, -15, 15))
        if random.random() < 0.5:
            normal = (-normal[0], normal[1])
        point = min(body.vertices, key=lambda v: dot(normal, v))
        tip = False
        rational = [e for e in edges if is_square(dot(plus(e[1], e[0], F(-1)), plus(e[1], e[0], F(-1))))]
        if rational and random.random() < 0.4:
            a, b = random.choice(rational)
            way = plus(b, a, F(-1))
            point, tip = plus(a, way, share(random, 4, 12)), True
            normal = scaled(turned(way), 1 / root(dot(way, way)))
        obstacles.append(Obstacle(point, normal, friction, tip))
        pressed = wrench_of(scaled(normal, -PRESS * share(random, 4, 16)), point)
        settle = [s + p for s, p in zip(settle, pressed)]
    direction = (share(random, -16, 16) * PRESS, share(random, -16, 16) * PRESS, share(random, -16, 16) * PRESS)
    return Scene(body, obstacles, (settle[0], settle[1], settle[2]), direction)


def root(square: Fraction) -> Fraction:
    return F(isqrt(square.numerator), isqrt(square.denominator))


def is_square(value: Fraction) -> bool:
    return root(value) ** 2 == value


FAMILIES = {"ramp": ramp, "tipping": tipping, "groove": groove, "corner": corner, "ladder": ladder, "jam": jam,
            "drawer": drawer, "random": anything}
