# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps as people bring them, in doubles with all their digits: each answer as in closed form, each proof accepted by all that
have to judge it. Where rounding alone holds or breaks a grasp, what counts is the answer about motions, or a load, of the size of
the problem (`within`)."""

import json
import os
import random
import unittest
from fractions import Fraction

import numpy as np
from test_cli import DONE, HERE, UNDECIDED, Case, checkers, quick_checker, run, stickslip
from test_space import motions_of_equilibria

# Of tests/support, which test_cli adds to the path.
from everyday import FAMILIES, FLAT, everyday, jaws_twisted, lifted, on_slope, pinched, plain_verdict, pushed_high, pushed_low, twisted

FILES = os.path.join(HERE, "..", "..", "corpus", "everyday")


def second_question(answer):
    """The words that ask what `within` answers, by itself."""
    within = answer["within"]
    words = ["--wrench=" + ",".join(within["wrench"])] if within["wrench"] != answer["wrench"] else []
    return [*words, *(["--max-motion", ",".join(within["max_motion"])] if "max_motion" in within else [])]


class Everyday(Case):
    judges = staticmethod(quick_checker)  # of proofs

    def decide(self, content, *words):
        """The answer, whose proof is accepted."""
        file, proof = self.write("g.json", content), self.path("c.json")
        if os.path.exists(proof):
            os.remove(proof)
        code, out, err = stickslip("decide", file, "--json", "--certificate", proof, *words)
        self.assertIn(code, (DONE, UNDECIDED), err)
        answer = json.loads(out)
        if answer["verdict"] in ("undecided", "fragile"):
            self.assertFalse(os.path.exists(proof))
            return answer
        report = self.accepted(file, proof, *words, verdict=rf"{answer['verdict']}\b")
        self.assertEqual(report["verdict"], answer["verdict"])
        return answer

    def plain_verdict(self, content, *words):
        """What counts, proved: by the answer, or by that to its second question."""
        answer = self.decide(content, *words)
        if "within" in answer:
            again = self.decide(content, *words, *second_question(answer))
            self.assertEqual(again["verdict"], answer["within"]["verdict"])
            self.assertNotIn("within", again)
        return plain_verdict(answer)

    def assert_closed_forms(self, flat, shares, seed):
        rng = random.Random(seed)
        for family in FLAT if flat else FAMILIES:
            for share in shares:
                content = everyday(family, share, rng, flat=flat)
                self.assertEqual(self.plain_verdict(content), "stable" if share < 1 else "unstable",
                                 (family.__name__, share, json.dumps(content)))


class ClosedForms(Everyday):
    def test_in_space(self):
        self.assert_closed_forms(False, (0.5, 0.99, 1.01, 3), 1)

    def test_in_the_plane(self):
        self.assert_closed_forms(True, (0.3, 0.9, 0.99, 1.01, 1.1, 3), 2)

    def test_by_all_checkers(self):
        self.judges = checkers
        self.assert_closed_forms(False, (1.5,), 3)
        self.assert_closed_forms(True, (0.8,), 4)

    def test_what_friction_holds_is_at_rest_at_once(self):
        rng = random.Random(5)
        for family in FAMILIES[:4]:
            answer = self.decide(everyday(family, 0.9, rng))
            self.assertEqual((answer["verdict"], answer["stats"]["nodes"]), ("stable", 0), family.__name__)


class BesideNewton(Everyday):
    def assert_newton_agrees(self, content, seed):
        """Newton's method, in lengths and forces of the size of the problem, finds an equilibrium that counts where one is proved,
        and none where it is proved that there is none."""
        answer = self.decide(content)
        about = answer.get("within", answer)
        length = max(abs(x) for c in content["contacts"] for x in c["position"])
        wrench = [float(Fraction(w)) for w in about["wrench"]]
        force = max(map(abs, wrench[:3])) or max(map(abs, wrench)) / length
        given = [{"preload": 0, **content["defaults"], **c} for c in content["contacts"]]
        stiffness = given[0]["stiffness"]
        contacts = [{"p": [x / length for x in c["position"]], "n": [x / np.linalg.norm(c["normal"]) for x in c["normal"]],
                     "friction": c["friction"], "stiffness": c["stiffness"] / stiffness, "preload": c["preload"] / force}
                    for c in given]
        load = [w / force for w in wrench[:3]] + [w / force / length for w in wrench[3:]]
        found = motions_of_equilibria(contacts, load, 40, np.random.default_rng(seed))
        if "max_motion" in about:
            bound = np.array([float(Fraction(b)) for b in about["max_motion"]]) * stiffness / force
            bound[3:] *= length
            found = found[np.all(np.abs(found) <= bound, axis=1)]
        self.assertEqual(len(found) > 0, about["verdict"] == "stable", json.dumps(content))
        return about["verdict"]

    def test_in_space(self):
        rng = random.Random(12)
        verdicts = [self.assert_newton_agrees(everyday(family, share, rng), k)
                    for k, family in enumerate(FAMILIES) for share in (0.9, 1.05, 1.5)]
        self.assertEqual(verdicts.count("unstable"), 2 * len(FAMILIES))


class Boxes(Everyday):
    def assert_of_all(self, families, share, verdict, rng, flat=False):
        for family in families:
            content = everyday(family, share, rng, flat=flat)
            self.assertEqual(self.plain_verdict(content, "--uncertain", "friction=5%"), verdict, (family.__name__, json.dumps(content)))

    def test_friction_known_to_a_twentieth(self):
        # Whether a block tips is no matter of friction.
        rng = random.Random(6)
        self.assert_of_all(FAMILIES, 0.8, "stable", rng)
        self.assert_of_all(FAMILIES, 1.5, "unstable", rng)

    def test_in_the_plane(self):
        rng = random.Random(7)
        self.assert_of_all((twisted, pinched), 0.8, "stable", rng, flat=True)
        self.assert_of_all((twisted, pinched, pushed_low, pushed_high, on_slope), 1.5, "unstable", rng, flat=True)


class Margins(Everyday):
    """How much of its load each hand can take: all of it."""

    def known(self, file, *words):
        """The answer, whose claims are accepted."""
        proof = self.path("c.json")
        code, out, err = stickslip("margin", file, "--json", "--certificate", proof, *words)
        self.assertEqual(code, DONE, err)
        self.accepted(file, proof, *words)
        return json.loads(out)

    def assert_ends_at_one(self, family, rng, flat=False):
        content = everyday(family, 1, rng, flat=flat)
        file = self.write("g.json", content)
        along = "--direction=" + ",".join(map(repr, content["wrench"]))
        answer = self.known(file, along)
        if "within" in answer:
            second = answer["within"]
            bounded = ("--max-motion", ",".join(second["max_motion"]))
            answer = self.known(file, "--direction=" + ",".join(second["direction"]), *bounded)
            for part in ("resisted", "refuted"):
                self.assertEqual(answer[part], second[part])
        [(low, high)], [(above, end)] = answer["resisted"], answer["refuted"]
        self.assertEqual((low, end), ("0", None), family.__name__)
        self.assertTrue(0.995 < Fraction(high) < 1.0001 and 0.9999 < Fraction(above) < 1.005, (family.__name__, high, above))

    def test_in_space(self):
        rng = random.Random(8)
        for family in (lifted, twisted, jaws_twisted, pinched):
            self.assert_ends_at_one(family, rng)

    def test_in_the_plane(self):
        rng = random.Random(10)
        for family in (twisted, pinched) * 3:
            self.assert_ends_at_one(family, rng, flat=True)

    def test_by_all_checkers(self):
        self.judges = checkers
        for flat in (False, True):
            self.assert_ends_at_one(twisted, random.Random(9), flat)
            self.assert_ends_at_one(pinched, random.Random(9), flat)

    def test_a_bound_keeps_motions_small(self):
        # One soft contact presses 1 for each unit that it gives: up to its bound.
        content = {"format": "stickslip-grasp/2", "contacts": [
            {"position": [0, 0, 0], "normal": [0, 0, 1], "friction": 1, "stiffness": 1}], "wrench": [0, 0, 0, 0, 0, 0]}
        file = self.write("g.json", content)
        along = "--direction=0,0,-1,0,0,0"
        answer = self.known(file, along, "--max-motion", "3,1")
        [(low, high)], [(above, end)] = answer["resisted"], answer["refuted"]
        self.assertEqual((low, end), ("0", None))
        self.assertTrue(2.99 < Fraction(high) <= 3 <= Fraction(above) < 3.01, (high, above))
        self.assertEqual(self.known(file, along)["resisted"], [["0", None]])

    def test_a_bound_in_the_plane(self):
        # As in space; and between four springs of 1, each of which gives up to a half.
        self.judges = checkers
        foot = {"format": "stickslip-grasp/2", "contacts": [
            {"position": [0, 0], "normal": [0, 1], "friction": 1, "stiffness": 1}], "wrench": [0, 0, 0]}
        between = {"format": "stickslip-grasp/2", "defaults": {"friction": 0, "preload": 10}, "contacts": [
            {"position": [side, y], "normal": [-side, 0]} for side in (-1, 1) for y in (-1, 1)], "wrench": [0, 0, 0]}
        # Of a length without a root: it presses 1 for each half that it gives.
        slope = {"format": "stickslip-grasp/2", "contacts": [
            {"position": [0, 0], "normal": [1, 1], "friction": 1, "stiffness": 2, "preload": 0}], "wrench": [0, 0, 0]}
        for content, direction, bound, end in ((foot, "0,-1,0", "3,1", 3), (between, "1,0,0", "1/2,1", 2), (slope, "-1,-1,0", "1,1", 2)):
            file = self.write("g.json", content)
            answer = self.known(file, "--direction=" + direction, "--max-motion", bound)
            [(low, high)], [(above, last)] = answer["resisted"], answer["refuted"]
            self.assertEqual((low, last), ("0", None))
            self.assertTrue(0.99 * end < Fraction(high) <= end <= Fraction(above) < 1.01 * end, (direction, high, above))
            self.assertNotIn("refuted", self.known(file, "--direction=" + direction))
        file = self.write("g.json", {**foot, "max_motion": {"length": 3, "angle": 1}})
        self.assertIn("refuted", self.known(file, "--direction=0,-1,0"))
        self.assertNotIn("refuted", self.known(file, "--direction=0,-1,0", "--max-motion", "none"))

    def test_preloads_that_grow_along_normals_of_irrational_length(self):
        # Two jaws along a diagonal, a load of 2 across it, and friction 1/2: each presses with 2.
        content = {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2", "preload": 1}, "contacts": [
            {"position": [side, side], "normal": [-side, -side]} for side in (-1, 1)], "wrench": ["1.4142135623730951", "-1.4142135623730951", 0]}
        file = self.write("g.json", content)
        self.judges = checkers
        for words in (("scale",), ("1,1", "--preload=0")):
            answer = self.known(file, "--preload-direction", *words)
            [(low, high)], [(least, end)] = answer["refuted"], answer["resisted"]
            self.assertEqual(low, "0")
            self.assertTrue(1.99 < Fraction(high) < 2 < Fraction(least) < 2.01 < 10 < Fraction(end), answer)
            code, out, err = stickslip("margin", file, "--preload-direction", *words, "--least", "--exact")
            self.assertEqual((code, out), (DONE, answer["least"] + "\n"), err)

    def test_a_quality_within_a_bound(self):
        # Four feet under a weight, in a frame along the axes: no ball of loads but the bound's size is held.
        content = {"format": "stickslip-grasp/2", "contacts": [
            {"position": [x, y, 0], "normal": [0, 0, 1], "friction": 1} for x in (-2, 2) for y in (-2, 2)], "wrench": [0, 0, -4, 0, 0, 0]}
        file = self.write("g.json", content)
        answers = {}
        for bound in ("2,2", "11/10,2"):
            code, out, err = stickslip("quality", file, "--json", "--max-motion", bound, "--accuracy", "1/10")
            self.assertEqual(code, DONE, err)
            answers[bound] = json.loads(out)
        # Each foot gives 1 under the weight; a load of 4/10 more, straight down, gives 1/10 more.
        self.assertLessEqual(Fraction(answers["11/10,2"]["proved"]), Fraction(4, 10))
        self.assertGreater(Fraction(answers["2,2"]["proved"]), Fraction(4, 10))

    def test_a_radius_of_friction(self):
        # Eight contacts of 5, a weight of 3: friction 0.3 may fall to 3/40.
        code, out, err = stickslip("radius", os.path.join(FILES, "tol.json"), "--uncertain", "friction=10%", "--json")
        self.assertEqual(code, DONE, err)
        answer = json.loads(out)
        self.assertTrue(7.4 < Fraction(answer["proved"]) < 7.5 <= Fraction(answer["refuted"]) < 7.6, out)


if __name__ == "__main__":
    unittest.main()
