# SPDX-License-Identifier: MIT
"""The checker against the plain twins of naive.py, on random and on exhausted small worlds."""

import itertools
import random
import unittest
from fractions import Fraction

import naive
from support import Case, check


def random_model(rng, m, law=None):
    normals = [(1, 0), (0, 1), (-1, 0), (0, -1), (3, 4), (-4, 3), (0, 2), (1, 1), (1, -2)]
    contacts = []
    for _ in range(m):
        normal = rng.choice(normals)
        rational = normal not in ((1, 1), (1, -2))
        contacts.append((rng.randint(-1, 1), rng.randint(-1, 1), *normal,
                         rng.choice([0, Fraction(1, 2), 1, Fraction(2, 3)]), rng.choice([1, 1, 2]),
                         rng.choice([0, 0, 1, Fraction(1, 3)]) if rational else 0))
    wrench = [rng.choice([-1, 0, 0, 1, Fraction(1, 2)]) for _ in range(3)]
    return naive.Model(contacts, wrench, law or rng.choice(check.LAWS))


def random_family(rng, m):
    """A model with directions of the load and of preloads."""
    model = random_model(rng, m)
    rational = [c[2] ** 2 + c[3] ** 2 not in (2, 5) for c in model.contacts]
    growth = [rng.choice([0, 0, 1, Fraction(1, 2)]) if good else 0 for good in rational]
    return naive.Model(model.contacts, model.wrench, model.law,
                       [Fraction(rng.randint(-2, 2), 2) for _ in range(3)], growth)


class ConeTest(unittest.TestCase):
    def compare(self, conditions):
        n = len(conditions[0][0])
        lines, rays = naive.generators(conditions, n)
        cone = check.Cone([tuple(int(j == k) for k in range(n)) for j in range(n)], [], 0)
        for a, equality in conditions:
            cone = cone.cut(a, equality)
        self.assertEqual(len(cone.lines), len(lines))
        self.assertEqual(naive.rank([*cone.lines, *lines]), len(lines))
        found = {frozenset(k for k in range(len(conditions)) if zero >> k & 1)
                 for _, zero in cone.rays}
        self.assertEqual(found, set(rays))
        self.assertEqual(len(found), len(cone.rays))
        for x, zero in cone.rays:
            self.assertEqual(check.math.gcd(*x), 1)
            for k, (a, equality) in enumerate(conditions):
                value = naive.dot(a, x)
                self.assertTrue(value == 0 if equality else value >= 0)
                self.assertEqual(value == 0, bool(zero >> k & 1))

    def test_random_systems(self):
        rng = random.Random(1)
        for _ in range(600):
            size = rng.randint(1, 7)
            bound = rng.choice([1, 1, 2, 9])
            width = rng.randint(1, 5)  # fewer: more lines
            conditions = [(tuple(rng.randint(-bound, bound) if j < width else 0 for j in range(5)),
                           rng.random() < 0.15) for _ in range(size)]
            self.compare(conditions)

    def test_all_small_pairs(self):
        vectors = list(itertools.product((-1, 0, 1), repeat=4))[::5]
        for a, b in itertools.product(vectors, repeat=2):
            self.compare([((0, 0, 0, 1), False), (a, False), (b, False)])


class RegionTest(unittest.TestCase):
    """Region and leaf_refusal against Place and leaf_holds, down random paths."""

    def test_random_paths(self):
        rng = random.Random(3)
        tally = {True: 0, False: 0}
        for k in range(30):
            model = random_model(rng, rng.randint(1, 3)) if k % 2 else random_family(
                rng, rng.randint(0, 2))
            ends = sorted(Fraction(rng.randint(0, 6), 2) for _ in range(2))
            loads = check.VERDICT if k % 2 else check.Range(
                ends[0], rng.choice([None, ends[1]]), rng.random() < 0.5, rng.random() < 0.5)
            question = pose(model)
            region, place = begin(question, loads), naive.root(model, *loads)
            splits = [["slip", i] for i in range(model.m)]
            splits += [["separation", i] for i in range(model.m)]
            splits += [["plane", *(rng.randint(-1, 1) for _ in range(3)), rng.choice([0, 0, 1]),
                        0 if k % 2 else rng.randint(-1, 1)] for _ in range(2)]
            rng.shuffle(splits)
            while True:
                self.compare(rng, model, region, place, tally)
                if not splits:
                    break
                node = splits.pop()
                ours = check.children(region, parse(node))
                theirs = place.children(model, node)
                self.assertEqual(len(ours), len(theirs))
                k_child = rng.randrange(len(ours))
                region, place = ours[k_child], theirs[k_child]
                region.open()
        self.assertGreater(min(tally.values()), 50, tally)

    def compare(self, rng, model, region, place, tally):
        self.assertEqual(region.bars(region.cone.generators), place.barred(place.rays))
        for _ in range(6):
            y = tuple(Fraction(rng.randint(-2, 2), rng.randint(1, 2)) for _ in range(3))
            if rng.random() < 0.5:
                y = tuple(map(Fraction, rng.choice(naive.EASY)))
            held = naive.leaf_holds(model, place, y)
            found = check.leaf_refusal(region, y, lambda x: x)
            self.assertEqual(found is None, held, found)
            tally[held] += 1
            # What is not smaller never makes a leaf hold that does not.
            more = check.leaf_refusal(region, y, lambda x: x + Fraction(1, 9))
            self.assertTrue(held or more)

    def test_short_numbers_are_above_and_close(self):
        rng = random.Random(9)
        for _ in range(300):
            digits = 10 ** rng.randint(0, 60)
            x = Fraction(rng.randint(-digits, digits), rng.randint(1, 10 ** rng.randint(0, 60)))
            short = check.short_above(x)
            self.assertGreaterEqual(short, x)
            self.assertLessEqual(short - x, abs(x) / 2**60)
            if x.denominator.bit_length() > 64:
                self.assertEqual(short.denominator & (short.denominator - 1), 0)


def pose(model):
    rows, contacts = [], []
    for (px, py, nx, ny, *values), growth in zip(model.contacts, model.growth):
        mu, k, preload = map(check.exactly, values)
        contacts.append(check.Contact(tuple(map(check.exactly, (px, py))), (nx, ny), Fraction(0), mu,
                                      k, preload))
        rows.append(check.make_row(contacts[-1], growth))
    wrench = tuple(map(check.exactly, model.wrench))
    return check.Question(check.Options(law=model.law), wrench, check.loads_within(wrench), (model.direction,), contacts,
                          tuple(model.growth), rows, False)


def roots(question, loads=check.VERDICT):
    return check.roots(question, check.enlarged(question, 128), [loads])


def begin(question, loads):
    return check.begin(roots(question, loads)[0])


def parse(node):
    if node[0] == "plane":
        return check.Node("plane", -1, tuple(Fraction(c) for c in node[1:]))
    return check.Node(node[0], node[1])


class VerdictTest(Case):
    """A producer that is complete for small grasps: its certificates are accepted; and where it
    proves a grasp stable, no tree is."""

    def verdict(self, model, evidence):
        options = ("--normal-law", model.law)
        self.accepts(model.grasp_file(), model.certificate(**evidence), *options)
        return "tree" in evidence

    def test_random_grasps(self):
        rng = random.Random(4)
        tally = {True: 0, False: 0}
        for k in range(60):
            model = random_model(rng, rng.randint(0, 2 if k % 6 else 3))
            evidence = naive.decide(model, rng)
            tally[self.verdict(model, evidence)] += 1
        self.assertGreater(min(tally.values()), 8, tally)


if __name__ == "__main__":
    unittest.main()
