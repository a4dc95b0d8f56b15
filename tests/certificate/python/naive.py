# SPDX-License-Identifier: MIT
"""Slow, plain twins for the tests of certificate/python/check.py.

Nothing here is taken from the checker: generators by brute force over subsets of conditions, §4's
leaf rules on Fractions without inheritance, and a producer of certificates, complete for small grasps.
References "§" are to certificate/FORMAT.md.
"""

from fractions import Fraction
from itertools import combinations, product
from math import gcd, lcm


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


# ---- Linear algebra ---------------------------------------------------------------------------


def integers(row):
    """The positive multiple that is integer and has no common factor."""
    common = lcm(*(c.denominator for c in row))
    row = [c.numerator * (common // c.denominator) for c in row]
    factor = gcd(*row) or 1
    return [c // factor for c in row]


def row_echelon(rows):
    """The reduced row echelon form but for multiples of its rows: a list of (pivot column, row)."""

    def without(row, pivot, other):
        return integers([other[pivot] * c - row[pivot] * e for c, e in zip(row, other)])

    result = []
    for row in map(integers, rows):
        for pivot, other in result:
            row = without(row, pivot, other)
        pivot = next((j for j, c in enumerate(row) if c), None)
        if pivot is None:
            continue
        result = [(p, without(other, pivot, row)) for p, other in result]
        result.append((pivot, row))
    return result


def rank(rows):
    return len(row_echelon(rows))


def null_space(rows, n):
    """A basis of {x in Q^n : row·x = 0 for all rows}."""
    echelon = row_echelon(rows)
    pivots = {p for p, _ in echelon}
    basis = []
    for free in (j for j in range(n) if j not in pivots):
        x = [Fraction(0)] * n
        x[free] = Fraction(1)
        for pivot, row in echelon:
            x[pivot] = Fraction(-row[free], row[pivot])
        basis.append(tuple(integers(x)))
    return basis


def generators(conditions, n):
    """Lines and rays of {x : a·x >= 0 for (a, False), a·x = 0 for (a, True)}, by brute force.

    An extreme ray is, modulo the lines, the only direction in which its tight conditions leave
    freedom; so every set of conditions of rank one less than all of them proposes a pair ±x.
    """
    rows = [integers(a) for a, _ in conditions]
    lines = null_space(rows, n)
    full = n - len(lines)
    rays = {}
    for chosen in combinations(rows, full - 1) if full else ():
        free = null_space([*chosen, *lines], n)
        for x in free if len(free) == 1 else ():
            for ray in (x, tuple(-c for c in x)):
                if all(dot(a, ray) == 0 if equality else dot(a, ray) >= 0
                       for a, (_, equality) in zip(rows, conditions)):
                    rays[frozenset(k for k, a in enumerate(rows) if dot(a, ray) == 0)] = ray
    return lines, rays


# ---- The model (§1) -----------------------------------------------------------------------------


class Model:
    """Contacts are (px, py, nx, ny, mu, k, P), with |n| rational wherever P > 0 or `growth`, P^u,
    is not 0. Points are (d, h, l); of one verdict, with l = 0."""

    def __init__(self, contacts, wrench, law="unilateral", direction=(0, 0, 0), growth=None):
        self.m, self.law = len(contacts), law
        self.direction = tuple(map(Fraction, direction))
        self.growth = [Fraction(0)] * self.m if growth is None else list(map(Fraction, growth))
        self.contacts = [tuple(map(Fraction, c)) for c in contacts]
        self.wrench = tuple(map(Fraction, wrench))
        self.N, self.T, self.mu, self.v, self.tau = [], [], [], [], []
        for (px, py, nx, ny, mu, k, preload), grown in zip(self.contacts, self.growth):
            square = nx * nx + ny * ny
            length = 1
            if preload or grown:
                length = next(Fraction(a, b) for a in range(1, 200) for b in range(1, 20)
                              if Fraction(a, b) ** 2 == square)
            n, t = (nx, ny, px * ny - py * nx), (-ny, nx, px * nx + py * ny)
            self.N.append(n)
            self.T.append(t)
            self.mu.append(mu)
            self.v.append(tuple(-k / square * c for c in n) + (preload / length, grown / length))
            self.tau.append(t + (Fraction(0), Fraction(0)))

    def force(self, i, sigma):
        """N_i + sigma mu_i T_i."""
        return tuple(n + sigma * self.mu[i] * t for n, t in zip(self.N[i], self.T[i]))

    def load(self, x):
        return tuple(w * x[3] + u * x[4] for w, u in zip(self.wrench, self.direction))

    def grasp_file(self):
        keys = ("friction", "stiffness", "preload")
        return {"format": "stickslip-grasp/1",
                "contacts": [{"position": [str(c[0]), str(c[1])], "normal": [str(c[2]), str(c[3])],
                              **{key: str(x) for key, x in zip(keys, c[4:])}}
                             for c in self.contacts],
                "wrench": [str(c) for c in self.wrench]}

    def certificate(self, **evidence):
        return {"format": "stickslip-certificate/2",
                "question": {"contacts": self.m, "wrench": [str(c) for c in self.wrench],
                             "normal_law": self.law},
                "verdict": "unstable" if "tree" in evidence else "stable", **evidence}


# ---- Regions and leaves (§4) --------------------------------------------------------------------


class Place:
    """A region by its conditions, with its strict functions."""

    def __init__(self, conditions, strict):
        self.conditions, self.strict = conditions, strict
        lines, rays = generators(conditions, 5)
        self.rays = list(rays.values()) + lines + [tuple(-c for c in x) for x in lines]

    def barred(self, rays):
        return any(all(dot(s, r) == 0 for r in rays) for s in self.strict)

    def children(self, model, node):
        """The table of nodes."""
        kind = node[0]
        row = (model.tau[node[1]] if kind == "slip" else
               model.v[node[1]] if kind == "separation" else node[1:])
        row = tuple(row) + (Fraction(0),) * (5 - len(row))
        below = tuple(-c for c in row)

        def child(condition, strict):
            return Place(self.conditions + [condition], self.strict + [row] * strict)

        if kind == "slip":
            return [child((row, False), 1), child((row, True), 0), child((below, False), 1)]
        return [child((row, False), 0), child((below, False), 1)]


def root(model, low=0, high=0, contains_low=True, contains_high=True):
    """The λ from low to high, or from low on if that is None."""
    above, below = (0, 0, 0, -low, 1), None if high is None else (0, 0, 0, high, -1)
    conditions = [((0, 0, 0, 1, 0), False)] + [(a, False) for a in (above, below) if a]
    if model.law == "bilateral":
        conditions += [(v, False) for v in model.v]
    strict = [(0, 0, 0, 1, 0)]
    strict += [a for a in (None if contains_low else above, None if contains_high else below) if a]
    return Place(conditions, strict)


def side(model, place, i):
    """One of: closed, open, mixed."""
    values = [dot(model.v[i], r) for r in place.rays]
    return ("closed" if all(v >= 0 for v in values) else
            "open" if all(v <= 0 for v in values) else "mixed")


def sign(model, place, i):
    """+1, -1, or 0 for none."""
    values = [dot(model.tau[i], r) for r in place.rays]
    if not place.barred([r for r, t in zip(place.rays, values) if t == 0]):
        return 0
    return 1 if all(t >= 0 for t in values) else -1 if all(t <= 0 for t in values) else 0


def leaf_holds(model, place, y):
    """`leaf-bound`, word for word."""
    if place.barred(place.rays):
        return True
    g = [dot(y, model.load(r)) for r in place.rays]
    for i in range(model.m):
        s, closed = sign(model, place, i), side(model, place, i) == "closed"
        alpha = max(dot(y, model.force(i, sigma)) for sigma in ([-s] if s else [-1, 1]))
        for k, r in enumerate(place.rays):
            v = dot(model.v[i], r)
            g[k] += alpha * v if closed else max(0, alpha) * max(0, v)
    return (all(value <= 0 for value in g)
            and place.barred([r for r, value in zip(place.rays, g) if value == 0]))


# ---- A producer ---------------------------------------------------------------------------------


def columns(model, place):
    """(ray, friction directions, wrench) for each ray and each extreme choice of friction, where
    all contacts are closed or open: the wrenches of §5 are their nonnegative combinations."""
    sides = [side(model, place, i) for i in range(model.m)]
    ends = [[0] if sides[i] == "open" or not model.mu[i] else
            [-s] if (s := sign(model, place, i)) else [-1, 1] for i in range(model.m)]
    for r in place.rays:
        for sigmas in product(*ends):
            total = list(model.load(r))
            for i, sigma in enumerate(sigmas):
                if sides[i] == "closed":
                    v = dot(model.v[i], r)
                    total = [c + v * f for c, f in zip(total, model.force(i, sigma))]
            yield r, sigmas, tuple(total)


def find_y(model, place):
    """A y that refutes the region if one does and all contacts are closed or open: g is then linear,
    and the sum of the generators of {y : g <= 0} is < 0 wherever any y is."""
    rows = {tuple(-c for c in w) for _, _, w in columns(model, place)} - {(0, 0, 0)}
    _, rays = generators([(row, False) for row in rows], 3)
    return tuple(sum(c) for c in zip((0, 0, 0), *rays.values()))


def solve(a, b):
    """Some x >= 0 with a x = b, or None: phase one of the simplex method with Bland's rule."""
    rows = [[Fraction(c) for c in row] + [Fraction(rhs)] for row, rhs in zip(a, b)]
    rows = [[-c for c in row] if row[-1] < 0 else row for row in rows]
    n = len(a[0])
    basis = [n + k for k in range(len(rows))]  # artificial, never to come back
    while True:
        cost = [sum(row[j] for row, base in zip(rows, basis) if base >= n) for j in range(n + 1)]
        enter = next((j for j in range(n) if cost[j] > 0), None)
        if enter is None:
            break
        leave = min((k for k, row in enumerate(rows) if row[enter] > 0),
                    key=lambda k: (rows[k][-1] / rows[k][enter], basis[k]))
        pivot = [c / rows[leave][enter] for c in rows[leave]]
        rows = [pivot if k == leave else [c - row[enter] * e for c, e in zip(row, pivot)]
                for k, row in enumerate(rows)]
        basis[leave] = enter
    if cost[n] != 0:
        return None
    x = [Fraction(0)] * n
    for base, row in zip(basis, rows):
        if base < n:
            x[base] = row[-1]
    return x


def find_witness(model, place):
    """An equilibrium in the closure of the region, if all contacts are closed or open there."""
    found = list(columns(model, place))
    if not found:
        return None
    weights = solve([[w[j] for _, _, w in found] for j in range(3)] + [[r[3] for r, _, _ in found]],
                    [0, 0, 0, 1])
    if weights is None:
        return None
    d = [sum(x * r[j] for x, (r, _, _) in zip(weights, found)) for j in range(3)]
    shares = []
    for i in range(model.m):
        if side(model, place, i) != "closed" or dot(model.tau[i], d) or not model.mu[i]:
            continue
        pairs = [(x * dot(model.v[i], r), s[i]) for x, (r, s, _) in zip(weights, found)]
        a, b = sum(a for a, _ in pairs), sum(a * sigma for a, sigma in pairs)
        if b:
            shares.append([i, str(b / a)])
    return {"twist": [str(c) for c in d], "shares": shares}


def decide(model, rng=None):
    """Evidence for one verdict, by splitting at every contact: {"tree": …} or a witness."""
    tree = []

    def visit(place, splits):
        for y in [(0, 0, 0)] * place.barred(place.rays) + EASY:
            if leaf_holds(model, place, y):
                tree.append(["leaf", *y])
                return None
        if splits:
            node = splits[0]
            tree.append(node)
            for child in place.children(model, node):
                witness = visit(child, splits[1:])
                if witness:
                    return witness
            return None
        y = find_y(model, place)
        if leaf_holds(model, place, y):
            tree.append(["leaf", *map(str, y)])
            return None
        return find_witness(model, place)

    splits = [["slip", i] for i in range(model.m)]
    if model.law == "unilateral":
        splits += [["separation", i] for i in range(model.m)]
    if rng:
        rng.shuffle(splits)
    return visit(root(model), splits) or {"tree": tree}


EASY = [y for y in product((-1, 0, 1), repeat=3) if any(y)]
