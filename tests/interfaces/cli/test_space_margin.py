# SPDX-License-Identifier: GPL-3.0-or-later
"""Margins in space: every certificate through both checkers, ends in closed form, and verdicts at
multiples inside what is claimed."""

import json
import random
import sys
import unittest
from fractions import Fraction as F

from test_cli import CHECK, CHECK_PY, DONE, run, stickslip
from test_space import EXAMPLES, Space, contact, grasp

PART = F(1, 1000)  # that may stay undecided at an end: the default of --accuracy


def numbers(interval):
    return [None if end is None else F(end) for end in interval]


def spelled(vector):
    return ",".join(str(F(x)) for x in vector)


def pinch(weight=0, **laws):
    hands = [contact((side * 2, 0, 0), (-side, 0, 0), **{"friction": "3/10", "preload": 4, **laws})
             for side in (-1, 1)]
    return grasp(hands, (0, 0, -weight, 0, 0, 0))


def feet(friction, preload=0):
    return [contact((x, y, 0), (0, 0, 1), friction=friction, preload=preload)
            for x, y in ((3, 2), (3, -2), (-3, 1))]


class Margins(Space):
    def margin(self, content, *words):
        """Lists of what is resisted and refuted, after both checkers have said the same."""
        file, proof = self.write("g.json", content), self.path("c.json")
        code, out, err = stickslip("margin", file, "--json", "--certificate", proof, *words)
        self.assertEqual(code, DONE, err)
        answer = json.loads(out)
        words = [w for w in words if not w.startswith(("--accuracy", "--node-limit"))]
        said = []
        for checker in ([CHECK], [sys.executable, "-B", CHECK_PY]):
            code, out, err = run(*checker, file, proof, *words)
            self.assertEqual(code, 0, out + err)
            said.append(out)
        self.assertEqual(*said)
        return ([numbers(i) for i in answer["resisted"]], [numbers(i) for i in answer["refuted"]])

    def assert_resisted_up_to(self, end, content, *words, part=PART):
        resisted, refuted = self.margin(content, *words)
        [(low, high)] = resisted
        [(above, without_end)] = refuted
        self.assertEqual(low, 0)
        self.assertIsNone(without_end)
        self.assertLessEqual(high, end)
        self.assertLessEqual(end, above)
        self.assertLess(above - high, 3 * part * end)

    def test_ends_in_closed_form(self):
        self.assert_resisted_up_to(F(12, 5), pinch(), "--direction", "0,0,-1,0,0,0")
        hands = [contact((side * 2, y, z), (-side, 0, 0), friction="1/4", preload=2)
                 for side, y, z in ((-1, 3, 4), (-1, -3, -4), (1, 3, 4), (1, -3, -4))]
        self.assert_resisted_up_to(10, grasp(hands, [0] * 6), "--direction", "0,0,0,1,0,0")
        # On a table, under a weight of 6: pulled where it is, and turned.
        weight = ("--wrench", "0,0,-6,0,0,0")
        self.assert_resisted_up_to(3, grasp(feet("1/2"), [0] * 6), *weight, "--direction", "3/5,4/5,0,0,0,0")

    def test_accuracy_is_a_choice(self):
        self.assert_resisted_up_to(F(12, 5), pinch(), "--direction", "0,0,-1,0,0,0", "--accuracy=1/50",
                                   part=F(1, 50))
        resisted, _ = self.margin(pinch(), "--direction", "0,0,-1,0,0,0", "--accuracy=1/50")
        finer, _ = self.margin(pinch(), "--direction", "0,0,-1,0,0,0", "--accuracy=1/100000")
        self.assertLess(resisted[0][1], finer[0][1])
        self.assertLess(F(12, 5) - finer[0][1], F(12, 5) / 10000)

    def test_preloads_that_grow(self):
        # A weight of 3 needs 2 (3/10) P = 3.
        for words in (("--preload-direction", "scale", "--preload", "1"),
                      ("--preload-direction", "1,1", "--preload", "0")):
            [(low, high)], [(zero, below)] = self.margin(pinch(weight=3), *words)
            self.assertEqual(zero, 0)
            self.assertLessEqual(below, 5)
            self.assertLessEqual(5, low)
            self.assertLess(low - below, F(5, 300))
            self.assertGreater(high, 1000)

    def test_without_preload_and_wrench_there_is_one_verdict(self):
        feet_only = grasp(feet("1/2"), [0] * 6)
        self.assertEqual(self.margin(feet_only, "--direction", "1/5,0,-1,0,0,0"), ([[0, None]], []))
        self.assertEqual(self.margin(feet_only, "--direction", "3/5,0,-1,0,0,0"), ([], [[0, None]]))

    def test_lengths_of_normals_change_nothing_irrational_ones_neither(self):
        def hands(n):
            length = sum(x * x for x in n)
            return [contact([-side * 2 * x for x in n], [side * x for x in n], friction="3/10",
                            preload=4) for side in (-1, 1)]
        # Along a direction across the normal the pinch holds 2 mu P, whatever the normal is.
        along = ("--direction", "0,0,1,0,0,0")
        self.assert_resisted_up_to(F(12, 5), grasp(hands((2, 0, 0)), [0] * 6), *along)
        # With irrational lengths there is no witness: the proof is by degree, and leaves out the turn
        # about the line through the two.
        self.assert_resisted_up_to(F(12, 5), grasp(hands((1, 2, 0)), [0] * 6), *along)

    def test_bilateral(self):
        self.assert_resisted_up_to(F(12, 5), pinch(), "--direction", "0,0,-1,0,0,0",
                                   "--normal-law", "bilateral")

    def test_verdicts_inside_what_is_claimed(self):
        source = random.Random(3)
        seen = {"stable": 0, "unstable": 0}
        for _ in range(4):
            contacts = []
            for _ in range(4):
                axis, side = source.randrange(3), source.choice((-1, 1))
                position = [F(source.randint(-8, 8), 8) for _ in range(3)]
                position[axis] = F(side)
                normal = [0, 0, 0]
                normal[axis] = -side
                contacts.append(contact(position, normal, friction=F(source.randint(4, 18), 20),
                                        preload=F(source.randint(0, 8), 4)))
            direction = [F(source.randint(-8, 8), 8) for _ in range(6)]
            content = grasp(contacts, [0] * 6)
            resisted, refuted = self.margin(content, "--direction", spelled(direction), "--node-limit=300")
            for verdict, intervals in (("stable", resisted), ("unstable", refuted)):
                for low, high in intervals:
                    high = 2 * low + 1 if high is None else high
                    for part in (F(1, 100), F(1, 2), F(99, 100)):
                        multiple = low + part * (high - low)
                        wrench = spelled(multiple * u for u in direction)
                        found = self.verdict(content, "--wrench", wrench)
                        self.assertIn(found, (verdict, "undecided"))
                        seen[found] = seen.get(found, 0) + 1
        self.assertGreater(seen["stable"], 5)
        self.assertGreater(seen["unstable"], 5)

    def test_words_and_errors(self):
        file = f"{EXAMPLES}/space-cup.json"
        code, out, _ = stickslip("margin", file, "--direction", "0,0,-1,0,0,0")
        self.assertEqual(code, DONE)
        self.assertRegex(out, r"Resisted: l = \[0, ~2[.]666[0-9]+\]\nNot resisted: l between ~2[.]66[0-9]+ and")
        code, out, _ = stickslip("margin", file, "--direction", "0,0,-1,0,0,0", "--least")
        self.assertEqual((code, out), (DONE, "0\n"))
        for words, said in ((("--direction", "0,0,-1"), "--direction"),
                            (("--direction", "0,0,0,0,0,0"), "--direction"),
                            (("--preload-direction", "1,1"), "--preload-direction"),
                            (("--direction", "0,0,-1,0,0,0", "--accuracy", "0"), "--accuracy"),
                            ((), "no direction is given")):
            code, out, err = stickslip("margin", file, *words)
            self.assertEqual((code, out), (2, ""), words)
            self.assertIn(said, err)


if __name__ == "__main__":
    unittest.main()
