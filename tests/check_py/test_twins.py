# SPDX-License-Identifier: MIT
"""The checker against the plain twins of naive.py, on random and on exhausted small worlds."""

import itertools
import random
import unittest
from fractions import Fraction

import naive
import test_check
from test_check import check


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


class ConeTest(unittest.TestCase):
    def compare(self, conditions):
        lines, rays = naive.generators(conditions, 4)
        cone = check.Cone([tuple(int(j == k) for k in range(4)) for j in range(4)], [], 0)
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
            width = rng.randint(1, 4)  # fewer: more lines
            conditions = [(tuple(rng.randint(-bound, bound) if j < width else 0 for j in range(4)),
                           rng.random() < 0.15) for _ in range(size)]
            self.compare(conditions)

    def test_order_does_not_matter(self):
        rng = random.Random(2)
        cube = [((1, 0, 0, 1), False), ((-1, 0, 0, 1), False), ((0, 1, 0, 1), False),
                ((0, -1, 0, 1), False), ((0, 0, 1, 1), False), ((0, 0, -1, 1), False)]
        for extra in ([], [((1, 1, 0, 0), False)], [((1, 1, 1, 1), False), ((1, -1, 0, 0), True)]):
            for _ in range(5):
                conditions = cube + extra
                rng.shuffle(conditions)
                self.compare(conditions)

    def test_all_small_pairs(self):
        vectors = list(itertools.product((-1, 0, 1), repeat=4))[::5]
        for a, b in itertools.product(vectors, repeat=2):
            self.compare([((0, 0, 0, 1), False), (a, False), (b, False)])


class RegionTest(unittest.TestCase):
    """Region and check_leaf against Place and leaf_holds, down random paths."""

    def test_random_paths(self):
        rng = random.Random(3)
        tally = {True: 0, False: 0}
        for _ in range(60):
            model = random_model(rng, rng.randint(1, 3))
            question, table = pose(model)
            terms = check.Terms(table, question.wrench)
            region, place = check.Region(None, ("root", -1), "", ()), naive.root(model)
            splits = [["slip", i] for i in range(model.m)]
            if model.law == "unilateral":
                splits += [["separation", i] for i in range(model.m)]
            splits += [["plane", *(rng.randint(-1, 1) for _ in range(3)), rng.choice([0, 0, 1])]
                       for _ in range(2)]
            splits = [s for s in splits if s[0] != "plane" or any(s[1:])]
            rng.shuffle(splits)
            while True:
                region.open(terms, model.m, model.law)
                region.look(terms)
                self.compare(rng, model, terms, region, place, tally)
                if not splits:
                    break
                node = splits.pop()
                ours = check.children(region, parse(node), model.m, terms, model.law)
                theirs = place.children(model, node)
                self.assertEqual(len(ours), len(theirs))
                k = rng.randrange(len(ours))
                region, place = ours[k], theirs[k]
        self.assertGreater(min(tally.values()), 60, tally)

    def test_ranges_of_loads(self):
        rng = random.Random(8)
        tally = {True: 0, False: 0}
        for _ in range(90):
            model = random_model(rng, rng.randint(0, 2))
            question, table = pose(model)
            direction = tuple(Fraction(rng.randint(-2, 2), 2) for _ in range(3))
            terms = check.Terms(table, question.wrench, direction)
            region, place = check.Region(None, ("root", -1), "", ()), naive.root(model)
            splits = [["slip", i] for i in range(model.m)]
            splits += [["plane", *(rng.randint(-1, 1) for _ in range(3)), 1]]
            rng.shuffle(splits)
            while True:
                region.open(terms, model.m, model.law)
                region.look(terms)
                self.compare_range(rng, model, direction, terms, region, place, tally)
                if not splits:
                    break
                node = splits.pop()
                k = rng.randrange(2)
                region = check.children(region, parse(node), model.m, terms, model.law)[k]
                place = place.children(model, node)[k]
        self.assertGreater(min(tally.values()), 200, tally)

    def compare_range(self, rng, model, direction, terms, region, place, tally):
        """The gaps of random intervals: the lifted generators, void and leaves."""
        ends = sorted(rng.sample([Fraction(k, 2) for k in range(6)], 4))
        intervals = [(ends[0], ends[1]), (ends[2], rng.choice([ends[3], None]))][:rng.randint(0, 2)]
        expected = [(high, low, False) for (_, high), (low, _) in zip(intervals, intervals[1:])]
        if not intervals or intervals[0][0] > 0:
            expected.insert(0, (Fraction(0), intervals[0][0] if intervals else None, True))
        if intervals and intervals[-1][1] is not None:
            expected.append((intervals[-1][1], None, False))
        gaps = check.gaps(intervals)
        self.assertEqual(len(gaps), len(expected))
        for loads, gap in zip(gaps, expected):
            lifted = naive.Lifted(place, *gap)
            held = self.holds(check.check_void, region, loads)
            self.assertEqual(held, lifted.barred(lifted.rays))
            for _ in range(6):
                y = tuple(Fraction(rng.randint(-1, 1)) for _ in range(3))
                thetas = [(i, Fraction(1)) for i in range(model.m) if rng.random() < 0.3]
                held = self.holds(check.check_leaf, region, check.Node("leaf", -1, y, thetas),
                                  model.m, terms, loads)
                self.assertEqual(held, naive.lifted_leaf_holds(model, direction, place, lifted, y,
                                                               thetas), (gap, y))
                tally[held] += 1

    def holds(self, rule, *arguments):
        try:
            rule(*arguments)
            return True
        except check.Rejected as failure:
            self.assertIn(failure.rule, ("leaf-bound", "void-region"))
            return False

    def compare(self, rng, model, terms, region, place, tally):
        void = place.barred(place.rays)
        self.assertEqual(region.bars(region.cone.generators), void)
        if not void:
            sides = {"closed": 1, "open": -1, "mixed": 0}
            self.assertEqual(region.side, [sides[naive.side(model, place, i)]
                                           for i in range(model.m)])
            self.assertEqual(region.sign, [naive.sign(model, place, i) for i in range(model.m)])
        for _ in range(6):
            y = tuple(Fraction(rng.randint(-2, 2), rng.randint(1, 2)) for _ in range(3))
            if rng.random() < 0.5:
                y = rng.choice(naive.EASY)
            thetas = [(i, rng.choice([Fraction(1), Fraction(1, 2)])) for i in range(model.m)
                      if rng.random() < 0.3]
            try:
                check.check_leaf(region, check.Node("leaf", -1, tuple(map(Fraction, y)), thetas),
                                 model.m, terms)
                held = True
            except check.Rejected as failure:
                self.assertEqual(failure.rule, "leaf-bound")
                held = False
            self.assertEqual(held, naive.leaf_holds(model, place, y, thetas))
            tally[held] += 1


def pose(model):
    contacts = [check.Contact(c[:2], c[2:4], *c[4:]) for c in model.contacts]
    question = check.Question(contacts, model.wrench, None, model.law, None)
    return question, check.rows(question, "")


def parse(node):
    if node[0] == "plane":
        return check.Node("plane", -1, tuple(Fraction(c) for c in node[1:]))
    return check.Node(node[0], node[1])


class VerdictTest(test_check.Case):
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

    def test_verdicts_do_not_depend_on_the_order_of_splits(self):
        rng = random.Random(5)
        for _ in range(8):
            model = random_model(rng, 2)
            self.assertEqual(len({self.verdict(model, naive.decide(model, rng))
                                  for _ in range(3)}), 1)

    def test_no_tree_is_accepted_for_a_stable_grasp(self):
        """Random complete trees with, in each leaf, void, or a y that holds there if a small one
        does: on a stable grasp at least one leaf of every tree must fail."""
        rng = random.Random(6)
        stable = 0
        while stable < 20:
            model = random_model(rng, rng.randint(1, 2))
            if "tree" in naive.decide(model, rng):
                continue
            stable += 1
            question, table = pose(model)
            terms = check.Terms(table, question.wrench)
            for _ in range(4):
                tree, refuted = random_tree(rng, model, terms)
                with self.assertRaises(check.Rejected) as caught:
                    check.check_tree(tree, question, table)
                self.assertFalse(refuted)
                self.assertIn(caught.exception.rule, ("leaf-bound", "void-region"))

    def test_mutated_trees_are_not_accepted_where_they_prove_nothing(self):
        """Trees of unstable questions, asked about stable ones on the same grasp."""
        rng = random.Random(7)
        pairs = 0
        while pairs < 8:
            model = random_model(rng, 2)
            evidence = naive.decide(model, rng)
            if "tree" not in evidence:
                continue
            other = naive.Model(model.contacts, [rng.choice([-1, 0, 1]) for _ in range(3)],
                                model.law)
            if "tree" in naive.decide(other, rng):
                continue
            pairs += 1
            code, out, _ = test_check.run(other.grasp_file(), other.certificate(**evidence),
                                          "--normal-law", other.law)
            self.assertEqual(code, 1, out)


def random_tree(rng, model, terms):
    """A complete tree, and whether all of its leaves hold."""
    tree, hold = [], []

    def holds(function, *arguments):
        try:
            function(*arguments)
            return True
        except check.Rejected:
            return False

    def visit(region, splits):
        region.open(terms, model.m, model.law)
        region.look(terms)
        if splits and rng.random() < 0.9:
            node = parse(splits[0])
            tree.append(node)
            for child in check.children(region, node, model.m, terms, model.law):
                visit(child, splits[1:])
            return
        for node in [check.Node("void")] + [check.Node("leaf", -1, tuple(map(Fraction, y)), thetas)
                                            for y in naive.EASY
                                            for thetas in ((), [(0, Fraction(1))])]:
            if (holds(check.check_void, region) if node.kind == "void" else
                    holds(check.check_leaf, region, node, model.m, terms)):
                tree.append(node)
                return
        hold.append(False)
        tree.append(node)

    splits = [["slip", i] for i in range(model.m)]
    if model.law == "unilateral":
        splits += [["separation", i] for i in range(model.m)]
    splits.append(["plane", rng.randint(-1, 1), rng.randint(-1, 1), 1, rng.randint(-1, 1)])
    rng.shuffle(splits)
    visit(check.Region(None, ("root", -1), "", ()), splits[:4])
    return tree, all(hold)


if __name__ == "__main__":
    unittest.main()
