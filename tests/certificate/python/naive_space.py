# SPDX-License-Identifier: MIT
"""A slow, plain twin of the rules in space (certificate/FORMAT.md, section 7), on Fractions: slips at
all corners, cones by pairs of generators, roots by halving.
"""

from fractions import Fraction
from functools import lru_cache
from itertools import combinations, product
from math import isqrt

from naive import dot
from naive_box import inverse_length

GEOMETRY = ("x", "y", "z", "turn_u", "turn_v")
NAMES = (*GEOMETRY, "friction", "preload", "stiffness")
H = (0, 0, 0, 0, 0, 0, 1, 0)
LOAD = (0, 0, 0, 0, 0, 0, 0, 1)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a):
    return tuple(-x for x in a)


def velocity(d, p):
    """Of the point p under the twist d."""
    return plus(d[:3], cross(d[3:6], p))


def slip(n, p, d, straight=None):
    """The velocity without a part along n, so that it is across n, or across a straight normal."""
    u = velocity(d, p)
    straight = straight or n
    along = Fraction(dot(straight, u)) / dot(straight, n)
    return tuple(c - along * e for c, e in zip(u, n))


def turned(n, e_u, e_v):
    """n + e_u U + e_v V."""
    sizes = [abs(c) for c in n]
    axis = [0, 0, 0]
    axis[sizes.index(min(sizes))] = 1
    first = cross(n, axis)
    second = cross(n, first)
    return tuple(a + e_u * b + e_v * c for a, b, c in zip(n, first, second))


def turn_bounds(n, slope):
    """E_u and E_v."""
    first, second = (tuple(a - b for a, b in zip(turned(n, *e), n)) for e in ((1, 0), (0, 1)))
    return [root_above(Fraction(slope) ** 2 * dot(n, n) / dot(way, way)) for way in (first, second)]


def along(s, t, gamma=0):
    """The product of two slips; with torsion there is a fourth number."""
    return dot(s[:3], t[:3]) + gamma * dot(s[3:], t[3:])


def determinant(m):
    return sum((-1) ** j * x * determinant([row[:j] + row[j + 1:] for row in m[1:]]) for j, x in enumerate(m[0])) if m else 1


def projected(w, chosen, gamma):
    """The point of the span of the chosen, which are linearly independent, nearest to w, if it is a sum of multiples >= 0: by Cramer's rule."""
    gram = [[along(a, b, gamma) for b in chosen] for a in chosen]
    heights, whole = [along(a, w, gamma) for a in chosen], determinant(gram)
    multiples = [Fraction(determinant(gram[:j] + [heights] + gram[j + 1:])) / whole for j in range(len(chosen))] if whole else [-1]
    return tuple(dot(multiples, numbers) for numbers in zip(*chosen)) if min(multiples) >= 0 else (Fraction(0),) * len(w)


def nearest(w, generators, gamma):
    """The sum of generators with multiples >= 0 that is nearest to w: no generator leads from it towards w, and w - it is across it. Those
    that do are taken in, one by one; two of a plane are enough, and with torsion three."""
    found, chosen = (Fraction(0),) * len(w), ()
    while True:
        left = plus(w, minus(found))
        assert along(left, found, gamma) == 0
        best = max(generators, key=lambda s: along(left, s, gamma), default=found)
        if along(left, best, gamma) <= 0:
            return found
        some = (*chosen, best)
        sets = [one for count in range(1, len(w)) for one in combinations(some, count)]
        chosen = max(sets, key=lambda one: along(w, projected(w, one, gamma), gamma))
        found = projected(w, chosen, gamma)


def in_cone(w, generators, gamma=0):
    return nearest(w, generators, gamma) == tuple(w)


def directions(vectors):
    """One for each, up to positive multiples."""
    found = set()
    for v in vectors:
        if any(v):
            size = next(abs(c) for c in v if c)
            found.add(tuple(c / size for c in v))
    return sorted(found)


def root_above(q):
    """A bound of the root of q, or of minus that of -q."""
    if q == 0:
        return Fraction(0)
    low, high = inverse_length(1 / Fraction(abs(q)), 64)
    return high if q > 0 else -low


class Contact:
    """A normal, and intervals of the parameters of section 6 by name; in a margin also P and P^u,
    whose multiples by 1/L, in an interval, are the preloads."""

    def __init__(self, normal, ends, loads=None, inverse=None, torsion=0):
        self.normal, self.torsion = tuple(map(Fraction, normal)), Fraction(torsion)
        self.ends = {name: tuple(map(Fraction, ends.get(name, (0, 0)))) for name in NAMES}
        self.loads, self.inverse = loads, inverse
        self.square = dot(self.normal, self.normal)
        self.gamma = self.torsion ** 2 / self.square

    @classmethod
    def of_file(cls, normal, p, friction, preload, stiffness, bits=128, slope=0, torsion=0):
        """Intervals as in the grasp file; the normal has the length L."""
        square = sum(Fraction(c) ** 2 for c in normal)
        low, high = inverse_length(square, bits) if preload[1] else (1, 1)
        turns = [(-e, e) for e in turn_bounds(normal, slope)]
        cosine, its_square = 1 - Fraction(slope) ** 2 / 2, 1 - Fraction(slope) ** 2  # at least
        return cls(normal, {**dict(zip(NAMES, [*p, *turns])), "friction": friction,
                            "preload": (preload[0] * low * cosine, preload[1] * high),
                            "stiffness": (stiffness[0] * its_square / square, stiffness[1] / square)}, torsion=torsion)

    @classmethod
    def of_margin(cls, normal, p, friction, loads, stiffness, bits=128):
        """Numbers."""
        square = sum(Fraction(c) ** 2 for c in normal)
        inverse = inverse_length(square, bits) if any(loads) else (1, 1)
        numbers = {**dict(zip(NAMES, p)), "friction": friction, "preload": 0,
                   "stiffness": stiffness / square}
        return cls(normal, {name: (c, c) for name, c in numbers.items()}, loads, inverse)

    def cut(self, name, low, high):
        return Contact(self.normal, {**self.ends, name: (low, high)}, self.loads, self.inverse, self.torsion)

    def corners(self, names):
        for ends in product(*(sorted(set(self.ends[name])) for name in names)):
            yield dict(zip(names, ends))

    @lru_cache(maxsize=None)
    def places(self):
        """Positions, with normals."""
        return [(tuple(q[name] for name in "xyz"), turned(self.normal, q["turn_u"], q["turn_v"]))
                for q in self.corners(GEOMETRY)]

    def positions(self):
        return [p for p, _ in self.places()]

    def v(self, r):
        """At all corners."""
        if self.loads:
            p = tuple(self.ends[name][0] for name in "xyz")
            pull = self.ends["stiffness"][0] * dot(self.normal, velocity(r, p))
            return [dot(self.loads, r[6:]) * c - pull for c in self.inverse]
        return [q["preload"] * r[6]
                - q["stiffness"] * dot(turned(self.normal, q["turn_u"], q["turn_v"]),
                                       velocity(r, (q["x"], q["y"], q["z"])))
                for q in self.corners((*GEOMETRY, "preload", "stiffness"))]

    def slip(self, n, p, d):
        """Section 1: with torsion the turn about the normal, too."""
        return slip(n, p, d, self.normal) + ((dot(n, d[3:6]),) if self.torsion else ())

    @lru_cache(maxsize=None)
    def slips(self, r):
        """At all places."""
        return [self.slip(n, p, r) for p, n in self.places()]

    @lru_cache(maxsize=None)
    def alpha(self, y, rays, moves):
        cone = directions(s for r in rays for s in self.slips(r))
        tilt = max(dot(n, n) for _, n in self.places()) / self.square - 1
        found = []
        for (p, n), mu in product(self.places(), self.ends["friction"]):
            z = self.slip(n, p, y)
            signed = along(z, z, self.gamma)
            if moves:
                point = nearest(minus(z), cone, self.gamma)
                # If the nearest is 0, none is nearer in angle than the rays' own.
                signed = along(point, point, self.gamma) or max(-along(s, z, self.gamma) * abs(along(s, z, self.gamma)) / along(s, s, self.gamma) for s in cone)
            found.append(dot(n, velocity(y, p)) + root_above(mu * mu * self.square * signed)
                         + 3 * tilt / 2 * root_above(mu * mu * self.square * dot(z, z)))
        return max(found)


class Region:
    """By its rays, with lines as two rays each; strict functions are rows, or contacts that slip."""

    def __init__(self, contacts, wrench, growth, rays, strict, slips):
        self.contacts, self.wrench, self.growth, self.rays = contacts, wrench, growth, tuple(rays)
        self.strict, self.slips = strict, slips

    def barred(self, rays):
        return (any(all(dot(a, r) == 0 for r in rays) for a in self.strict)
                or any(all(not any(s) for r in rays for s in self.contacts[i].slips(r))
                       for i in self.slips))

    @lru_cache(maxsize=None)
    def moves(self, i):
        if i in self.slips:
            return True
        contact = self.contacts[i]
        cone = directions(s for r in self.rays for s in contact.slips(r))
        return all(self.barred([r for r in self.rays
                                if in_cone(minus(contact.slip(n, p, r)), cone, contact.gamma)])
                   for p, n in contact.places())

    def leaf_holds(self, y):
        """`leaf-bound`, word for word."""
        if self.barred(self.rays):
            return True
        g = [r[6] * sum(max(c * end for end in ends) for c, ends in zip(y, self.wrench))
             + r[7] * dot(y, self.growth) for r in self.rays]
        for i, contact in enumerate(self.contacts):
            v = [contact.v(r) for r in self.rays]
            closed = all(min(values) >= 0 for values in v)
            if not closed and all(max(values) <= 0 for values in v):
                continue
            alpha = contact.alpha(y, self.rays, self.moves(i))
            for k, values in enumerate(v):
                g[k] += (max(alpha * value for value in values) if closed else
                         max(0, alpha) * max(0, *values))
        return (all(value <= 0 for value in g)
                and self.barred([r for r, value in zip(self.rays, g) if value == 0]))


def root_of(square):
    """The root, if it is rational."""
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    return root if root * root == square else None
