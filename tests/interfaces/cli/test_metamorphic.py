# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdicts do not change with the frame, the units of length and force, lengths of normals and the order of what is listed.

Exact changes leave the verdict as it is, but that it may be undecided: that is counted. Changes in doubles are for grasps that
rounding leaves as they are, and for the verdict about motions of the size of the problem. Proofs are judged elsewhere."""

import glob
import json
import math
import os
import random
import unittest
from fractions import Fraction as F

import test_space
from test_bodies import ROOT, random_assembly, stack, weight
from test_cli import DONE, UNDECIDED, Case, read, stickslip
from test_soft import pinch

# Of tests/support, which test_cli adds to the path.
from everyday import FAMILIES, FLAT, everyday, jaws_twisted, lifted, pinched, plain_verdict, rotation, twisted
from transformed import MIRROR, QUARTER, THREE_FOUR_FIVE, Change, by_quaternion, dimension_of, exact, questions

EACH = 3  # changes of a grasp, of the ten that there are, five in doubles
TURNS = {2: (QUARTER, THREE_FOUR_FIVE, MIRROR),
         3: (by_quaternion(1, 1, 0, 0), by_quaternion(2, 1, 0, 0), by_quaternion(1, 2, -3, 1), ((1, 0, 0), (0, 1, 0), (0, 0, -1)))}


def size_of(content):
    return max(abs(exact(x)) for c in content["contacts"] for x in c["position"]) or 1


def unit(dimension):
    return [[int(i == j) for i in range(dimension)] for j in range(dimension)]


def exact_changes(content, rng):
    dimension, size = dimension_of(content), size_of(content)

    def offset(length):
        return [rng.randint(-30, 30) * size * length / 7 for _ in range(dimension)]

    one = unit(dimension)
    yield from (Change(rows) for rows in TURNS[dimension])
    yield from (Change(one, offset(1)), Change(one), Change(one, length=F(1, 10**4)), Change(one, length=10**4))
    yield from (Change(one, force=F(1, 700)), Change(one, force=10**4))
    yield Change(rng.choice(TURNS[dimension]), offset(F(3, 700)), F(3, 700), F(50, 3), F(7, 2))


def changes_in_doubles(content, rng):
    dimension, size = dimension_of(content), float(size_of(content))
    a = rng.uniform(0, 7)
    rows = rotation(rng).tolist() if dimension == 3 else [[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]]
    length, force = (10 ** rng.uniform(-4, 4) for _ in range(2))
    offset = [rng.uniform(-3, 3) * size for _ in range(dimension)]
    yield Change(rows, number=float)
    yield Change(rows, [length * x for x in offset], length, force, number=float)
    yield Change([[-x for x in rows[0]], *rows[1:]], offset, number=float)
    yield Change(unit(dimension), length=length, number=float)
    yield Change(unit(dimension), force=force, number=float)


class Metamorphic(Case):
    def ask(self, content, words):
        code, out, err = stickslip("decide", self.write("g.json", content), "--json", "--no-warnings", *words)
        self.assertIn(code, (DONE, UNDECIDED), err + json.dumps(content))
        return json.loads(out)

    def assert_unchanged(self, grasps, seed, in_doubles=False, undecided=0):
        """Of (grasp, words) each; how many verdicts of changed grasps may be undecided where that of the grasp is not, or the
        other way round. In doubles the plain verdicts are compared, of which none may be."""
        rng, verdicts, lost = random.Random(seed), set(), 0
        verdict_of = plain_verdict if in_doubles else lambda answer: answer["verdict"]
        for content, words in grasps:
            was = self.ask(content, words)
            verdicts.add(plain_verdict(was))
            changes = list((changes_in_doubles if in_doubles else exact_changes)(content, rng))
            for change in rng.sample(changes, min(EACH, len(changes))):
                changed = change(content, rng)
                now = self.ask(changed, words)
                both = {verdict_of(was), verdict_of(now)}
                lost += len(both) > 1 and "undecided" in both and not in_doubles
                self.assertTrue(len(both) == 1 or ("undecided" in both and not in_doubles), (both, json.dumps([content, changed]), words))
        self.assertLessEqual(lost, undecided)
        return verdicts


class OfEveryday(Metamorphic):
    def families(self, flat, shares, rng, *words, without=()):
        for family in FLAT if flat else FAMILIES:
            for share in shares:
                if family not in without:
                    yield everyday(family, share, rng, flat=flat), words

    def test_in_space(self):
        rng = random.Random(1)
        self.assertEqual(self.assert_unchanged(self.families(False, (0.6, 2), rng), 2, undecided=1), {"stable", "unstable"})
        self.assertEqual(self.assert_unchanged(self.families(False, (0.6, 2), rng), 3, in_doubles=True), {"stable", "unstable"})

    def test_in_the_plane(self):
        rng = random.Random(4)
        self.assertEqual(self.assert_unchanged(self.families(True, (0.6, 2), rng), 5, undecided=1), {"stable", "unstable"})
        self.assertEqual(self.assert_unchanged(self.families(True, (0.6, 2), rng), 6, in_doubles=True), {"stable", "unstable"})

    def test_of_boxes(self):
        rng = random.Random(7)
        words = ("--uncertain", "friction=5%")
        grasps = [*self.families(False, (0.7,), rng, *words, without=(pinched,)),
                  *self.families(False, (1.5,), rng, *words, without=(lifted, twisted, jaws_twisted, pinched))]
        self.assert_unchanged(grasps, 8)
        self.assert_unchanged(grasps, 9, in_doubles=True)


def random_in_the_plane(rng):
    contacts = []
    for _ in range(rng.randint(2, 6)):
        n = rng.choice(((3, 4), (-4, 3), (1, 0), (0, 1), (-1, 0), (0, -1), (5, 12), (-12, -5), (4, -3)))
        p = [-F(x) / math.isqrt(n[0] ** 2 + n[1] ** 2) + F(rng.randint(-4, 4), 8) for x in n]
        contacts.append(test_space.contact(p, n, friction=F(rng.randint(0, 16), 20), stiffness=F(rng.randint(2, 6), 4),
                                           preload=F(rng.randint(0, 8), 4)))
    return test_space.grasp(contacts, [F(rng.randint(-8, 8), 8) for _ in range(3)])


class OfRandom(Metamorphic):
    def test_in_the_plane(self):
        rng = random.Random(1)
        grasps = [(random_in_the_plane(rng), ()) for _ in range(20)]
        self.assertEqual(self.assert_unchanged(grasps, 2), {"stable", "unstable"})
        self.assertEqual(self.assert_unchanged(grasps[:10], 3, in_doubles=True), {"stable", "unstable"})

    def test_in_space(self):
        rng = random.Random(5)
        grasps = [(test_space.written(*test_space.random_grasp(rng, 3 + k % 3, F(1, 2))), ()) for k in range(12)]
        self.assertEqual(self.assert_unchanged(grasps, 6, undecided=2), {"stable", "unstable"})

    def test_of_several_bodies(self):
        rng = random.Random(9)
        grasps = [(random_assembly(rng, dimension), ()) for dimension in (2, 2, 3) for _ in range(5)]
        self.assertGreaterEqual(self.assert_unchanged(grasps, 10), {"stable", "unstable"})


class OfOthers(Metamorphic):
    def test_stacks(self):
        grasps = [(stack((2, 1, 1), (1, 1, 2), (F(1, 2), F(2, 5), F(3, 5)), (3, 2, 1), push, F(5, 2))[1], ()) for push in (F(1, 4), 2)]
        self.assertEqual(self.assert_unchanged(grasps, 1), {"stable", "unstable"})
        self.assertEqual(self.assert_unchanged(grasps, 2, in_doubles=True), {"stable", "unstable"})

    def test_soft_fingers(self):
        grasps = [(pinch([weight("cap", 6, (0, y, 0))], 1), ()) for y in (F(1, 2), 1, F(9, 5), 3)]
        self.assertEqual(self.assert_unchanged(grasps, 3), {"stable", "unstable"})
        self.assertEqual(self.assert_unchanged(grasps, 4, in_doubles=True), {"stable", "unstable"})
        words = ("--uncertain", "friction=5%,preload=1%")
        self.assertEqual(self.assert_unchanged([(content, words) for content, _ in grasps[:1]], 5), {"stable"})

    def test_files(self):
        """Every other one of those whose contacts are given by places."""
        grasps = []
        for pattern in ("examples/grasps/*.json", "tests/corpus/grasps/good/*.json", "tests/corpus/space/*.grasp.json"):
            for file in sorted(glob.glob(os.path.join(ROOT, *pattern.split("/")))):
                content = json.loads(read(file).lstrip("\ufeff"))
                if content["contacts"] and not any("on" in c for c in content["contacts"]) and '"min"' not in json.dumps(content):
                    grasps += [(one, ()) for one in questions(content)]
        self.assertGreater(len(grasps), 30)
        self.assertEqual(self.assert_unchanged(grasps[::2], 6, undecided=0), {"stable", "unstable"})


if __name__ == "__main__":
    unittest.main()
