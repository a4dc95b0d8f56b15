# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of scenes in space, as families.py has them in the plane."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import List, Tuple

import families
from families import PRESS, Scene, share
from scene import Point as Flat
from scene import cross as area_of
from scene import dot as flat_dot
from scene import turned, unit
from solid import Body, Obstacle, Point, Wrench, plus, wrench_of

F = Fraction


def prism(vertices: Tuple[Flat, ...], depth: Fraction) -> Body:
    """Extruded to both sides along z, with the moments of a uniform body, about x and y their mean."""
    edges = [(a, b, area_of(a, b)) for a, b in zip(vertices, vertices[1:] + vertices[:1])]
    polar = sum(c * (flat_dot(a, a) + flat_dot(a, b) + flat_dot(b, b)) for a, b, c in edges) / (
        6 * sum(c for _, _, c in edges))
    return Body(tuple((v[0], v[1], z) for v in vertices for z in (-depth, depth)),
                (polar / 2 + depth * depth / 3,) * 2 + (polar,))


def lifted(wrench: Tuple[Fraction, ...]) -> Wrench:
    return (wrench[0], wrench[1], F(0), F(0), F(0), wrench[2])


def extruded(family):
    def made(random: Random) -> Scene:
        """A scene of the plane, which must do the same when it is extruded."""
        flat = family(random)
        obstacles = [Obstacle((*o.point, F(0)), (*o.normal, F(0)), o.friction) for o in flat.obstacles]
        return Scene(prism(flat.body.vertices, share(random, 4, 12)), obstacles, lifted(flat.settle),
                     lifted(flat.direction))
    return made


def heading(random: Random) -> Point:
    """A horizontal unit vector."""
    x, y = unit(share(random, -16, 16))
    return (x, y, F(0)) if random.random() < 0.5 else (-x, y, F(0))


def scaled(a: Point, factor: Fraction) -> Point:
    return tuple(factor * c for c in a)


def block(random: Random) -> Tuple[Body, List[Obstacle]]:
    """A flat one on the ground."""
    a, b, h = share(random, 7, 16), share(random, 7, 16), share(random, 2, 5)
    ground = Obstacle((F(0), F(0), -h), (F(0), F(0), F(1)), share(random, 3, 12))
    return prism(((-a, -b), (a, -b), (a, b), (-a, b)), h), [ground]


DOWN = (F(0), F(0), -PRESS)


def yawed(random: Random) -> Scene:
    """A block on a ramp, turned about the ramp's normal: all friction points one way."""
    body, ground = block(random)
    return Scene(body, ground, wrench_of(DOWN), wrench_of(scaled(heading(random), PRESS)))


def spun(random: Random) -> Scene:
    """A block that is turned on the ground, or pushed off its middle."""
    body, ground = block(random)
    a, b, h = body.vertices[5]
    at = (a * share(random, -16, 16), b * share(random, -16, 16), h * share(random, -16, 8))
    push = wrench_of(scaled(heading(random), PRESS * share(random, 0, 8)), at)
    twist = (F(0),) * 5 + (PRESS * a * share(random, 4, 16) * random.choice([-1, 1]),)
    return Scene(body, ground, wrench_of(DOWN), plus(push, twist))


def wedge(random: Random) -> Scene:
    """A bar that lies with two edges in a V, pressed down, and pushed along the V and across."""
    width, height, depth = share(random, 8, 14), share(random, 4, 10), share(random, 8, 16)
    body = prism(((-width, -height), (width, -height), (width, height), (-width, height)), depth)
    obstacles = []
    for x, side in ((-width, 1), (width, -1)):
        along = unit(share(random, 4, 9))
        obstacles.append(Obstacle((x, -height, F(0)), (side * along[1], along[0], F(0)), share(random, 4, 12)))
    across = share(random, -6, 6)
    at = (width * share(random, -8, 8), height * share(random, -16, 8), depth * share(random, -8, 8))
    return Scene(body, obstacles, wrench_of((F(0), -PRESS, F(0))),
                 wrench_of((across * PRESS, F(0), random.choice([-1, 1]) * PRESS), at))


def triangle(random: Random) -> List[Flat]:
    """Near an equilateral one, with its centre in the origin."""
    corners = [(share(random, 11, 16), share(random, -3, 3)), (-share(random, 6, 9), share(random, 10, 14)),
               (-share(random, 6, 9), -share(random, 10, 14))]
    centre = tuple(sum(c[k] for c in corners) / 3 for k in range(2))
    return [(c[0] - centre[0], c[1] - centre[1]) for c in corners]


def tripod(random: Random) -> Scene:
    """Three feet on a table, pushed and turned."""
    feet, height = triangle(random), share(random, 4, 10)
    table = Obstacle((F(0), F(0), -height), (F(0), F(0), F(1)), share(random, 3, 12))
    at = (share(random, -6, 6), share(random, -6, 6), height * share(random, -16, 12))
    twist = (F(0),) * 5 + (PRESS * share(random, -6, 6),)
    return Scene(prism(tuple(feet), height), [table], wrench_of(DOWN),
                 plus(wrench_of(scaled(heading(random), PRESS), at), twist))


# What touches with eight corners is left out: its class takes minutes to find.
FAMILIES = {
    **{f"extruded-{name}": extruded(families.FAMILIES[name]) for name in ("ramp", "tipping", "ladder")},
    "yawed": yawed, "spun": spun, "wedge": wedge, "tripod": tripod}
