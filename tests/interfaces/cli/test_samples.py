# SPDX-License-Identifier: GPL-3.0-or-later
"""decide --samples, beside shares that are known in closed form and the binomial distribution in exact fractions. A contact
pressed with W = 10 holds a push H across its normal iff H <= mu W: of friction from 4/10 to 6/10 a half holds H = 5."""

import json
import math
import os
import unittest
from fractions import Fraction as F

from test_cli import DONE, FIG1, SANITIZED, Case, checkers, run, stickslip

HALF = {"friction": {"min": "2/5", "max": "3/5"}}


def pressed(in_space=False, push=5):
    contact = {"position": [0, 0], "normal": [0, 1], **HALF}
    if in_space:
        contact = {"position": [0, 0, 0], "normal": [0, 0, 1], **HALF}
    # In space the push is 3, 4, 0 times a fifth of it.
    wrench = [F(3, 5) * push, F(4, 5) * push, -10, 0, 0, 0] if in_space else [push, -10, 0]
    return {"format": "stickslip-grasp/2", "contacts": [contact], "wrench": [str(w) for w in wrench]}


def tail(count, least, p):
    """How likely it is that of `count` grasps `least` or more hold."""
    return sum(math.comb(count, k) * p ** k * (1 - p) ** (count - k) for k in range(least, count + 1))


class Samples(Case):
    def samples(self, file, count, *words):
        answer = self.json("decide", file, "--samples", count, *words)
        self.assertEqual(answer["verdict"], "fragile")
        found = answer["samples"]
        self.assertEqual(found["count"], count)
        self.assertEqual(found["stable"] + found["unstable"] + found["undecided"], count)
        return found

    @unittest.skipIf(SANITIZED, "for its answers")
    def test_the_share_is_the_one_known_as_often_as_is_said(self):
        for in_space in (False, True):
            file = self.write("half.json", pressed(in_space))
            shares = []
            for seed in range(1, 21):
                found = self.samples(file, 40, "--seed", seed)
                self.assertEqual(found["undecided"], 0)
                shares.append(F(found["share"]["low"]) <= F(1, 2) <= F(found["share"]["high"]))
            self.assertGreaterEqual(sum(shares), 18)
            self.assertEqual(self.samples(file, 40, "--seed", 3), self.samples(file, 40, "--seed", 3))

    def test_the_ends_are_those_of_clopper_and_pearson(self):
        step = F(2, 10 ** 6)  # ends are rounded to a millionth
        for push, count in (("4.02", 30), ("4.5", 40), ("5.9", 50), ("5.99", 20)):
            found = self.samples(self.write("g.json", pressed(push=F(push))), count)
            holds, share = found["stable"], found["share"]
            for end, error in (("low", F(1, 40)), ("at_least", F(1, 20))):
                p = F(share[end])
                if holds > 0:
                    self.assertLessEqual(tail(count, holds, p), error)
                    self.assertGreater(tail(count, holds, p + step), error)
                else:
                    self.assertEqual(p, 0)
            p = 1 - F(share["high"])
            fails = count - holds
            if fails > 0:
                self.assertLessEqual(tail(count, fails, p), F(1, 40))
                self.assertGreater(tail(count, fails, p + step), F(1, 40))

    def test_every_failure_is_kept_with_its_proof(self):
        file = self.write("half.json", pressed())
        found = self.samples(file, 30, "--examples", self.path("kept"))
        kept = sorted(os.listdir(self.path("kept")))
        grasps = [name for name in kept if name.startswith("sample") and ".certificate" not in name]
        self.assertEqual(len(grasps), found["unstable"])
        self.assertEqual(len(kept), 2 * (found["unstable"] + 2))  # and two examples
        for name in grasps:
            grasp = self.path(os.path.join("kept", name))
            with open(grasp, encoding="utf-8") as text:
                contact = json.load(text)["contacts"][0]
            self.assertLess(F(contact["friction"]), F(1, 2))
            self.assertGreaterEqual(F(contact["friction"]), F(2, 5))
            for checker in checkers(name):
                code, out, _ = run(*checker, grasp, grasp.replace(".json", ".certificate.json"))
                self.assertEqual((code, "unstable" in out), (DONE, True))

    def test_draws_are_in_the_box(self):
        # Three legs under a weight of 10 and a push of 1: about a half of the frictions hold.
        legs = [(1, 0, 0), (F(-1, 2), F(4, 5), 0), (F(-1, 2), F(-4, 5), 0)]
        contacts = [{"position": [str(x) for x in leg], "normal": {"direction": [0, 0, 1], "slope": "1/100"},
                     "friction": {"min": 0, "max": "1/5"}, "stiffness": {"min": 1, "max": 2}} for leg in legs]
        file = self.write("g.json", {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": [1, 0, -10, 0, 0, 0]})
        self.samples(file, 20, "--uncertain", "position=1/100,wrench=1/50", "--examples", self.path("kept"))
        kept = [name for name in os.listdir(self.path("kept")) if name.startswith("sample") and ".cert" not in name]
        self.assertGreater(len(kept), 4)
        slopes = []
        for name in kept:
            with open(self.path(os.path.join("kept", name)), encoding="utf-8") as text:
                drawn = json.load(text)
            for leg, c in zip(legs, drawn["contacts"]):
                n = [F(x) for x in c["normal"]]
                slopes.append((n[0] ** 2 + n[1] ** 2) / n[2] ** 2)
                self.assertLessEqual(slopes[-1], F(1, 10000))
                self.assertTrue(1 <= F(c["stiffness"]) <= 2 and 0 <= F(c["friction"]) <= F(1, 5))
                self.assertTrue(all(abs(F(x) - F(y)) <= F(1, 100) for x, y in zip(c["position"], leg)))
            self.assertLessEqual(abs(F(drawn["wrench"][0]) - 1), F(1, 50))
        # Uniform in the disc: half of all squared slopes are above half of the largest.
        self.assertTrue(0.3 < sum(slope > F(1, 20000) for slope in slopes) / len(slopes) < 0.7)

    def test_a_box_with_one_verdict_needs_none(self):
        code, out, err = stickslip("decide", FIG1, "--uncertain", "friction=1%", "--samples", 10)
        self.assertEqual(code, DONE)
        self.assertNotIn("Samples", out)
        self.assertEqual(err, "stickslip: --samples drew nothing: the verdict is proved for every grasp in the box\n")
        code, out, err = stickslip("decide", FIG1, "--samples", 10)
        self.assertEqual((code, out), (2, ""))
        self.assertIn("--samples: the question is about one grasp", err)

    def test_words(self):
        _, out, err = stickslip("decide", self.write("half.json", pressed()), "--samples", 40)
        self.assertEqual(err, "")
        self.assertRegex(out, r"Samples: 40 grasps drawn from the box, each number uniform in its interval \(seed 1\)")
        self.assertRegex(out, r"With a confidence of 95 % between [\d.]+ % and [\d.]+ % of the grasps")


if __name__ == "__main__":
    unittest.main()
