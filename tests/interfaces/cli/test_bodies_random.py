# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies at random: Z3 on small ones, and Newton's method from many starts; both are written from mechanics and
know no rows."""

import glob
import json
import os
import random
import unittest
from fractions import Fraction as F

import numpy as np
from bodies_newton import equilibria
from bodies_smt import smt
from test_bodies import ROOT, Bodies, contact, force, grasp, mirrored_assembly, random_assembly, stack, text, weight
from test_cli import run
from test_space import Z3


class AgainstZ3(Bodies):
    def test_small_random_ones(self):
        rng = random.Random(7)
        agreed = {"sat": 0, "unsat": 0}
        for _ in range(40):
            content = random_assembly(rng, 2)
            z3 = run(Z3, "-T:5", "-in", stdin=smt(content))[1].strip()
            self.assertIn(z3, ("sat", "unsat"))
            self.assertEqual(self.verdict(content), "stable" if z3 == "sat" else "unstable", json.dumps(content))
            agreed[z3] += 1
        self.assertGreaterEqual(min(agreed.values()), 8)


class AgainstNewton(Bodies):
    """Where a tree says unstable no start leads to an equilibrium, and where one is stable some does."""

    def ask(self, content, starts):
        verdict = self.verdict(content)
        if verdict == "undecided":
            return verdict, 0
        found, stay = equilibria(content, starts, np.random.default_rng(2))
        if verdict == "unstable":
            self.assertEqual(found, 0, f"{stay} of {found} are no ties: {json.dumps(content)}")
        return verdict, found

    def assert_sees(self, asked, least):
        """There are so many of either, and all that are stable are seen."""
        verdicts = [verdict for verdict, _ in asked]
        self.assertGreaterEqual(min(verdicts.count("stable"), verdicts.count("unstable")), least)
        self.assertEqual([one for one in asked if one[0] == "stable" and one[1] == 0], [])

    def test_random_ones_in_the_plane(self):
        rng = random.Random(3)
        self.assert_sees([self.ask(random_assembly(rng, 2), 40) for _ in range(30)], 10)

    def test_what_is_mirrored_is_decided(self):
        # (Newton's method looks at those that are unstable in verdict().)
        rng = random.Random(1)
        verdicts = [self.verdict(mirrored_assembly(rng)) for _ in range(30)]
        self.assertEqual(verdicts.count("stable") + verdicts.count("unstable"), len(verdicts))
        self.assertGreaterEqual(min(verdicts.count("stable"), verdicts.count("unstable")), 8)

    def test_random_ones_in_space(self):
        rng = random.Random(3)
        verdicts = [self.ask(random_assembly(rng, 3), 40)[0] for _ in range(20)]
        self.assertGreaterEqual(verdicts.count("unstable"), 10)
        self.assertGreaterEqual(verdicts.count("stable"), 2)
        self.assertNotIn("undecided", verdicts)

    def test_what_floats_beside_what_slips_in_space(self):
        """No equilibrium is by itself, and its numbers are irrational: some contacts are left out of the proof."""
        rng = random.Random(1)
        assemblies = [random_assembly(rng, 3) for _ in range(91)]
        for k in (7, 18, 32, 35, 51, 56, 69, 70, 90):
            with self.subTest(assembly=k):
                self.assertEqual(self.verdict(assemblies[k]), "stable")
                with open(self.path("c.json"), encoding="utf-8") as file:
                    self.assertTrue(json.load(file)["parts"][0]["open"])

    def test_examples_and_corpus(self):
        asked = []
        for file in sorted(glob.glob(os.path.join(ROOT, "examples", "grasps", "bodies-*.json")) +
                           glob.glob(os.path.join(ROOT, "tests", "corpus", "bodies", "*stable.grasp.json"))):
            with open(file, encoding="utf-8") as content:
                content = json.load(content)
            common = content.pop("loads", [])
            for case in content.pop("cases", [{"loads": []}]):
                one = {**content, **case, "loads": common + case.pop("loads")}
                if '"min"' not in json.dumps(one) and "wrench" not in one:
                    one.pop("name", None)
                    asked.append(self.ask(one, 60))
        self.assert_sees(asked, 4)

    def test_it_sees_what_is_near_a_threshold(self):
        def boxes(push):  # of weight 1; the upper one slides at 1/2
            contacts = [contact(of, (x, y, z), (0, 0, 1), by=by, friction=F(1, 2))
                        for of, by, z in (("low", None, 0), ("up", "low", 1)) for x in (-1, 1) for y in (-1, 1)]
            return grasp(["low", "up"], contacts, [weight("low", 1, (0, 0, 0)), weight("up", 1, (0, 0, 1)),
                                                   force("up", (3 * push / 5, 4 * push / 5, 0), (0, 0, 1))])
        def slope(friction):  # of 3 in 4
            return grasp(["b"], [contact("b", (x, 0), (0, 1), friction=1 / friction) for x in (-1, 1)],
                         [{**weight("b", 1, (0, F(1, 10))), "direction": text((3, -4))}])
        shape = ((1, F(3, 5)), (1, 1), (F(1, 2), F(1, 5)), (1, 2))
        for grasp_at, value in ((lambda f: stack(*shape, f, F(3, 2))[1], F(2, 5)), (boxes, F(1, 2)), (slope, F(4, 3))):
            for part, sees in ((F(999, 1000), True), (F(1001, 1000), False)):
                found, stay = equilibria(grasp_at(part * value), 40, np.random.default_rng(4))
                self.assertEqual((found > 0, stay > 0), (sees, sees))


if __name__ == "__main__":
    unittest.main()
