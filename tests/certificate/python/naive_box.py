# SPDX-License-Identifier: MIT
"""A slow, plain twin of the rules about boxes (certificate/FORMAT.md, section 6), on Fractions:
polynomials by their coefficients, extremes over all corners, nothing shared or skipped.
"""

from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import comb, isqrt

from naive import Place, dot

NAMES = ("x", "y", "turn", "friction", "preload", "stiffness")


def inverse_length(square, bits):
    """An enclosure of 1/sqrt(square), found by trying one s after the other and halving."""
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    if root * root == square:
        return 1 / root, 1 / root
    unit = Fraction(1, 2 ** bits)
    while (unit * 2 ** bits) ** 2 * square <= 1:
        unit *= 2
    while (unit * 2 ** (bits - 1)) ** 2 * square > 1:
        unit /= 2
    low, high = 2 ** (bits - 1), 2 ** bits
    while high - low > 1:
        middle = (low + high) // 2
        if (unit * middle) ** 2 * square <= 1:
            low = middle
        else:
            high = middle
    return unit * low, unit * (low + 1)


class Contact:
    """(normal, slope) and intervals of p_x, p_y, friction, stiffness and preload as in the file."""

    def __init__(self, normal, slope, x, y, friction, stiffness, preload, bits=128):
        self.given = dict(x=x, y=y, friction=friction, stiffness=stiffness, preload=preload)
        self.normal, self.slope = tuple(map(Fraction, normal)), Fraction(slope)
        square = dot(self.normal, self.normal)
        below, above = inverse_length(square, bits) if preload[1] else (1, 1)
        turned = self.slope ** 2
        self.ends = {"x": x, "y": y, "turn": (-self.slope, self.slope), "friction": friction,
                     "preload": (preload[0] * (1 - turned / 2) * below, preload[1] * above),
                     "stiffness": (stiffness[0] * (1 - turned) / square, stiffness[1] / square)}
        self.ends = {name: tuple(map(Fraction, ends)) for name, ends in self.ends.items()}

    def cut(self, name, low, high):
        other = object.__new__(Contact)
        other.__dict__ = {**self.__dict__, "ends": {**self.ends, name: (low, high)}}
        return other

    def rows(self, x, y, e):
        """N and T."""
        (a, b) = self.normal
        n = (a - e * b, b + e * a)
        t = (-n[1], n[0])
        return (*n, x * n[1] - y * n[0]), (*t, x * t[1] - y * t[0])

    def v(self, q, r):
        n, _ = self.rows(q["x"], q["y"], q["turn"])
        return q["preload"] * r[3] - q["stiffness"] * dot(n, r[:3])

    def tau(self, q, r):
        return dot(self.rows(q["x"], q["y"], q["turn"])[1], r[:3])

    def alpha(self, q, s, y):
        n, t = self.rows(q["x"], q["y"], q["turn"])
        return dot(y, n) + s * dot(y, t)

    def corners(self, names=NAMES):
        for ends in product(*(sorted(set(self.ends[name])) for name in names)):
            yield dict(zip(names, ends))

    def certain(self, function):
        """Is function(q, unit vector) the same up to a positive factor at all corners?"""
        units = [tuple(int(j == k) for k in range(5)) for j in range(4)]
        rows = [tuple(function(q, unit) for unit in units) for q in self.corners()]
        first = rows[0]
        return all(all(a * d == b * c for (a, b), (c, d) in product(zip(first, row), repeat=2))
                   and dot(first, row) > 0 for row in rows)

    def greatest(self, s, y, r):
        """U_s(r): the largest Bernstein coefficient, from the coefficients of the powers."""
        geometry = ("x", "y", "turn")

        def at(function, bits, **rest):
            return function({**{name: self.ends[name][bit] for name, bit in zip(geometry, bits)},
                             **rest})

        alpha = powers(lambda bits: at(lambda q: self.alpha(q, s, y), bits))
        found = []
        for preload, stiffness in product(set(self.ends["preload"]), set(self.ends["stiffness"])):
            v = powers(lambda bits: at(lambda q: self.v(q, r), bits, preload=preload,
                                       stiffness=stiffness))
            both = {}
            for (i, a), (j, b) in product(alpha.items(), v.items()):
                k = tuple(p + q for p, q in zip(i, j))
                both[k] = both.get(k, 0) + a * b
            for k in product((0, 1, 2), repeat=3):
                found.append(sum(a * factor(i, k) for i, a in both.items()
                                 if a and all(p <= q for p, q in zip(i, k))))
        return max(found)


def powers(value):
    """The coefficients, but those that are 0, of a function of degree 1 in each of three variables
    in [0, 1]."""
    values = {bits: value(bits) for bits in product((0, 1), repeat=3)}
    found = {i: sum((-1) ** (sum(i) - sum(bits)) * values[bits] for bits in values
                    if all(b <= c for b, c in zip(bits, i))) for i in values}
    return {i: coefficient for i, coefficient in found.items() if coefficient}


@lru_cache(maxsize=None)
def factor(i, k):
    """What x^i contributes to the Bernstein coefficient k of degree 2 in each variable."""
    result = Fraction(1)
    for p, q in zip(i, k):
        result *= Fraction(comb(q, p), comb(2, p))
    return result


class Box:
    def __init__(self, contacts, wrench, law="unilateral"):
        self.contacts, self.law = contacts, law
        self.wrench = [tuple(map(Fraction, ends)) for ends in wrench]

    def root(self):
        conditions = [((0, 0, 0, 1, 0), False), ((0, 0, 0, 0, 1), True)]
        if self.law == "bilateral":
            conditions += [(self.plane("separation", i), False) for i in range(len(self.contacts))
                           if self.plane("separation", i)]
        return Place(conditions, [(0, 0, 0, 1, 0)])

    def plane(self, kind, i):
        """What a node splits, or None where that is uncertain."""
        contact = self.contacts[i]
        function = contact.tau if kind == "slip" else contact.v
        if not contact.certain(function):
            return None
        units = [tuple(int(j == k) for k in range(5)) for j in range(4)]
        q = list(contact.corners())[-1]
        return tuple(function(q, unit) for unit in units) + (Fraction(0),)

    def cut(self, name, i, low, high):
        if name == "wrench":
            wrench = [(low, high) if j == i else ends for j, ends in enumerate(self.wrench)]
            return Box(self.contacts, wrench, self.law)
        contacts = [c.cut(name, low, high) if j == i else c for j, c in enumerate(self.contacts)]
        return Box(contacts, self.wrench, self.law)

    def leaf_holds(self, place, y, rays=None):
        """`leaf-bound`, word for word; of other rays that span the place, if there are some."""
        rays = place.rays if rays is None else rays
        if place.barred(rays):
            return True
        g = [r[3] * sum(max(c * end for end in ends) for c, ends in zip(y, self.wrench))
             for r in rays]
        for contact in self.contacts:
            v = [[contact.v(q, r) for q in contact.corners()] for r in rays]
            tau = [[contact.tau(q, r) for q in contact.corners()] for r in rays]
            closed = all(min(values) >= 0 for values in v)
            if not closed and all(max(values) <= 0 for values in v):
                continue
            low, high = contact.ends["friction"]
            ends = (-high, high)
            if (all(min(t) >= 0 for t in tau)
                    and all(place.barred([r for r, t in zip(rays, tau) if t[q] == 0])
                            for q in range(len(tau[0])))):
                ends = (-low, -high)
            elif (all(max(t) <= 0 for t in tau)
                    and all(place.barred([r for r, t in zip(rays, tau) if t[q] == 0])
                            for q in range(len(tau[0])))):
                ends = (low, high)
            for k, r in enumerate(rays):
                bounds = []
                for s in ends:
                    alpha = [contact.alpha(q, s, y) for q in contact.corners()]
                    if closed:
                        bounds.append(contact.greatest(s, y, r))
                    elif max(alpha) <= 0:
                        bounds.append(0)
                    elif min(alpha) >= 0:
                        bounds.append(max(0, contact.greatest(s, y, r)))
                    else:
                        bounds.append(max(alpha) * max(0, *v[k]))
                g[k] += max(bounds)
        return (all(value <= 0 for value in g)
                and place.barred([r for r, value in zip(rays, g) if value == 0]))
