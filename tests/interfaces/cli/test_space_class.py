# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes of loads under rigid contacts in space: every proof through both checkers, borders in closed form from both
sides, the plane put into space, and Z3."""

import json
import os
import random
import sys
import unittest
from collections import Counter
from fractions import Fraction as F

from space_smt import rigid_smt
from test_cli import CHECK, CHECK_PY, DONE, UNDECIDED, Case, run, stickslip

Z3 = os.environ.get("Z3", "z3")
METHODS = "weakly-stable-load,strongly-stable-load"
UNIT = (0, 0, 0, 1, 1, 1)
SKEW = (F(1, 5), -F(1, 7), F(1, 3), 1, 2, F(3, 2), F(1, 5), 0, -F(1, 4))
FLOOR = [((x, y, -1), (0, 0, 1)) for x in (-1, 1) for y in (-1, 1)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def force_at(force, point):
    return [*force, *cross(point, force)]


def turned(q, v):
    """By a rational rotation, of a quaternion of any length."""
    u, w = q[1:], q[0]
    twice = [2 * F(x) / sum(F(y) ** 2 for y in q) for x in cross(u, v)]
    return [x + w * t + c for x, t, c in zip(v, twice, cross(u, twice))]


def turned_wrench(q, w):
    return [*turned(q, w[:3]), *turned(q, w[3:])]


def texts(numbers):
    return [str(F(x)) for x in numbers]


class SpaceClass(Case):
    def answer(self, contacts, load, friction, inertia=UNIT):
        """The class, or the reason why there is none; its proof is accepted by both checkers."""
        grasp = self.write("g.json", {"format": "stickslip-grasp/2", "defaults": {"friction": str(F(friction))},
                                      "contacts": [{"position": texts(p), "normal": texts(n)} for p, n in contacts],
                                      "wrench": texts(load)})
        words, proof = ("--inertia", ",".join(texts(inertia))), self.path("c.json")
        if os.path.exists(proof):
            os.remove(proof)
        code, out, err = stickslip("compare", grasp, "--json", "--methods", METHODS, "--certificate", proof, *words)
        if code == UNDECIDED:
            self.assertIn("class is not known", err)
            self.assertFalse(os.path.exists(proof))
            return "undecided"
        self.assertEqual(code, DONE, err)
        found = json.loads(out)
        for checker in ((CHECK,), (sys.executable, "-B", CHECK_PY)):
            code, out, err = run(*checker, grasp, proof, *words)
            self.assertEqual(code, 0, out + err)
            self.assertRegex(out, rf"verdict +{found['class']}\n")
        return found["class"]


class ClosedForms(SpaceClass):
    def test_a_block_on_a_ramp_slides_beyond_the_slope_mu_whatever_its_direction(self):
        for q in ((1, 0, 0, 0), (5, 1, -2, 3)):  # the ramp turned in space
            contacts = [(turned(q, p), turned(q, n)) for p, n in FLOOR]
            for x, y in ((1, 0), (F(3, 5), -F(4, 5)), (-F(5, 13), F(12, 13))):
                for slope, expected in ((F(49, 100), {"must hold"}), (F(501, 1000), {"must move"})):
                    load = turned_wrench(q, force_at((slope * x, slope * y, -1), (0, 0, -1)))
                    self.assertIn(self.answer(contacts, load, F(1, 2), SKEW), expected, (q, x, y))

    def test_exactly_on_the_border_forces_balance_the_load(self):
        for q in ((1, 0, 0, 0), (5, 1, -2, 3)):
            contacts = [(turned(q, p), turned(q, n)) for p, n in FLOOR]
            load = turned_wrench(q, force_at((F(3, 10), -F(4, 10), -1), (0, 0, -1)))
            grasp = self.write("g.json", {
                "format": "stickslip-grasp/2", "defaults": {"friction": "1/2"}, "wrench": texts(load),
                "contacts": [{"position": texts(p), "normal": texts(n)} for p, n in contacts]})
            answer = self.json("compare", grasp, "--methods", "weakly-stable-load")
            self.assertEqual((answer["methods"][0]["verdict"], answer["class"]), ("stable", None))

    def test_a_block_tips_where_the_load_leaves_its_feet(self):
        for push, expected in ((F(49, 100), "must hold"), (F(51, 100), "must move")):
            self.assertEqual(self.answer(FLOOR, force_at((push, 0, -1), (0, 0, 1)), 2), expected)

    def test_a_disc_turns_beyond_the_torque_of_its_friction(self):
        feet = [((1, 0, 0), (0, 0, 1)), ((0, 1, 0), (0, 0, 1)), ((-1, 0, 0), (0, 0, 1)), ((0, -1, 0), (0, 0, 1))]
        for torque, expected in ((F(119, 100), "must hold"), (F(121, 100), "must move")):
            self.assertEqual(self.answer(feet, (0, 0, -3, 0, 0, torque), F(2, 5)), expected)

    def test_a_groove_holds_along_it_by_more_than_the_weight(self):
        """Sides of slope 4/3 press with 5/8 of the weight each."""
        sides = [((-side * F(3, 5), y, -F(4, 5)), (side * F(3, 5), 0, F(4, 5))) for side in (1, -1) for y in (-1, 1)]
        self.assertEqual(self.answer(sides, (0, F(31, 50), -1, 0, 0, 0), F(1, 2)), "must hold")
        # Against each other they can press more than they do when it slides.
        self.assertEqual(self.answer(sides, (0, F(32, 50), -1, 0, 0, 0), F(1, 2)), "open")
        self.assertEqual(self.answer(sides, (0, 2, -1, 0, 0, 0), F(1, 2)), "must move")

    def test_what_can_degenerate(self):
        down = (0, 0, -1, 0, 0, 0)
        self.assertEqual(self.answer([], down, 1), "must move")
        self.assertEqual(self.answer([], [0] * 6, 1, SKEW), "must hold")
        self.assertEqual(self.answer(FLOOR, down, 0), "must hold")
        self.assertEqual(self.answer(FLOOR, (F(1, 1000), 0, -1, 0, 0, 0), 0), "must move")
        self.assertEqual(self.answer(FLOOR * 2, force_at((F(1, 4), 0, -1), (0, 0, -1)), F(1, 2)), "must hold")
        pinch = [((-1, 0, 0), (1, 0, 0)), ((1, 0, 0), (-1, 0, 0))]
        self.assertEqual(self.answer(pinch, (0, 0, -F(1, 10), 0, 0, 0), F(1, 2)), "open")
        self.assertEqual(self.answer(pinch, (0, 0, 0, 1, 0, 0), F(1, 2)), "must move")
        irrational = [((x, y, -x), (1, 0, 1)) for x in (-1, 1) for y in (-1, 1)]
        self.assertEqual(self.answer(irrational, (-F(1, 2), F(1, 10), -F(3, 5), 0, 0, 0), F(1, 2)), "must hold")

    def test_forces_that_only_the_laws_of_contacts_exclude(self):
        """They would accelerate: with the slip, where contacts part, and of one contact by the slip of another."""
        parting = [((1, -1, 0), (1, 0, 1)), ((0, 0, 0), (0, 0, 1))]
        self.assertEqual(self.answer(parting, (-F(3, 4), -F(1, 4), -F(1, 2), F(1, 2), F(1, 2), -1), 1), "must hold")
        for y, side, load, friction in ((1, 1, (-F(9, 8), 0, -F(1, 4), -F(1, 4), 0, F(9, 8)), F(1, 4)),
                                        (0, -1, (F(1, 8), 0, -F(1, 8), 0, F(1, 4), 0), 1)):
            line = [((x, y, 1 - y), (side, 0, 0)) for x in (1, 0)]
            self.assertEqual(self.answer(line, load, friction, (0, 0, 1, 1, 1, 1)), "open")
        twice = [((x, y, -x), (s, 0, s)) for x in (-1, 1) for y in (-1, 1) for s in (1, 3)]  # of irrational lengths
        self.assertEqual(self.answer(twice, (-F(1, 2), F(1, 10), -F(3, 5), 0, 0, 0), F(1, 2)), "must hold")


class Plane(SpaceClass):
    def test_the_plane_put_into_space(self):
        """Each contact twice, at y and -y, and the load between them: what is at rest in one is in the other, as
        the mean of forces and their mirror image has none across the plane; and what moves in the plane moves in
        space."""
        seen, rng = Counter(), random.Random(5)
        for _ in range(20):
            contacts = [((rng.randint(-3, 3), rng.randint(-3, 3)),
                         rng.choice(((1, 0), (-1, 0), (0, 1), (F(3, 5), F(4, 5)))))
                        for _ in range(rng.randint(1, 3))]
            load = [F(rng.randint(-4, 4), 2) for _ in range(2)] + [F(rng.randint(-4, 4))]
            flat = self.write("p.json", {
                "format": "stickslip-grasp/1", "defaults": {"friction": "1/2"}, "wrench": texts(load),
                "contacts": [{"position": texts(p), "normal": texts(n)} for p, n in contacts]})
            in_plane = self.json("compare", flat, "--methods", METHODS, "--inertia", "1/2,-1/3,3/4")["class"]
            deep = [((x, side, z), (nx, 0, nz)) for (x, z), (nx, nz) in contacts for side in (-2, 2)]
            in_space = self.answer(deep, (load[0], 0, load[1], 0, -load[2], 0), F(1, 2),
                                   (F(1, 2), 0, -F(1, 3), F(1, 2), F(3, 4), 1))
            seen[in_plane] += 1
            if in_space != "undecided":
                seen["decided"] += 1
                self.assertEqual(in_plane == "must move", in_space == "must move", (contacts, load))
                self.assertFalse(in_plane == "open" and in_space == "must hold", (contacts, load))
        self.assertGreaterEqual(min(seen[name] for name in ("must move", "must hold", "open")), 1, seen)
        self.assertGreaterEqual(seen["decided"], 18, seen)

    def test_z3_agrees_on_small_ones(self):
        agreed, rng = Counter(), random.Random(8)
        for k in range(10):
            contacts = [([rng.randint(-1, 1) for _ in range(3)],
                         rng.choice(((0, 0, 1), (0, 0, 2), (1, 0, 0), (0, F(3, 5), F(4, 5)))))
                        for _ in range(1 + k % 2)]
            p = contacts[0][0]
            load = force_at([F(rng.randint(-2, 2), 4), F(rng.randint(-2, 2), 4), -1], p)
            inertia = (*p, 1, 2, F(3, 2), F(1, 5), 0, -F(1, 4)) if k % 3 else SKEW
            found = self.answer(contacts, load, F(1, 2), inertia)
            rows = [(p, n, F(1, 2)) for p, n in contacts]
            inertia = (*inertia, 0, 0, 0)[:9]
            rest, moves = (run(Z3, "-T:1", "-in", stdin=rigid_smt(rows, load, inertia, kind))[1].strip()
                           for kind in (False, True))
            where = (contacts, load, inertia)
            self.assertNotIn((found, rest), (("must move", "sat"), ("must hold", "unsat"), ("open", "unsat")), where)
            self.assertNotIn((found, moves), (("must hold", "sat"), ("open", "unsat")), where)
            agreed.update([(found, rest), (found, moves, "moves")])
        self.assertGreaterEqual(agreed["must move", "unsat"], 2, agreed)
        self.assertGreaterEqual(agreed["must hold", "sat"], 2, agreed)
        self.assertGreaterEqual(agreed["must hold", "unsat", "moves"], 1, agreed)


class OtherMethods(SpaceClass):
    def test_a_block_that_rests_and_slides(self):
        """In text and in JSON: each method by its closed form, on a floor with friction 1/2."""
        expected = {
            "passive equilibrium": "stable unstable", "form closure": "not closed",
            "frictionless stable load": "unstable", "strongly stable load": "stable unstable",
            "weakly stable load": "stable unstable", "grasp wrench space, L1": "not closed",
            "linear compliance": "stable unstable", "friction cones alone": "stable unstable"}
        for k, slope in enumerate((F(2, 5), F(3, 5))):
            grasp = self.write("g.json", {
                "format": "stickslip-grasp/2", "defaults": {"friction": "1/2"},
                "contacts": [{"position": texts(p), "normal": texts(n)} for p, n in FLOOR],
                "wrench": texts(force_at((F(3, 5) * slope, F(4, 5) * slope, -1), (0, 0, -1)))})
            rows = self.json("compare", grasp)["methods"]
            measures = [row["method"] for row in rows[len(expected):]]
            self.assertEqual(measures, ["potential contact robustness", "potential grasp robustness",
                                        "least singular value", "volume of the wrench space", "least normal forces",
                                        "margin of internal forces", "distance of the centroid"])
            rows = rows[:len(expected)]
            self.assertEqual([row["method"] for row in rows], list(expected))
            passive = rows[0]["verdict"]
            for row in rows:
                words = expected[row["method"]]
                verdict = words if words == "not closed" else words.split()[min(k, len(words.split()) - 1)]
                self.assertEqual(row["verdict"], verdict, row)
                agrees = row["verdict"] == passive if row["about"] == "load" and row is not rows[0] else None
                self.assertEqual(row["agrees"], agrees, row)
            code, out, err = stickslip("compare", grasp)
            self.assertEqual((code, err), (DONE, ""))
            for row in rows:
                self.assertRegex(out, rf"(?m)^{row['method']} +{row['verdict']} ")
            one = self.json("compare", grasp, "--methods", "friction-cones-alone")["methods"]
            self.assertEqual(one, [{**rows[-1], "agrees": None}])

    def test_pyramids(self):
        """Each finger of a pinch carries (3/4, 3/4), at 45 degrees between the edges of a pyramid of four."""
        pinch = self.write("g.json", {
            "format": "stickslip-grasp/2", "defaults": {"friction": "3/4"}, "wrench": ["0", "-3/2", "-3/2", "0", "0", "0"],
            "contacts": [{"position": [-1, 0, 0], "normal": [1, 0, 0]}, {"position": [1, 0, 0], "normal": [-1, 0, 0]}]})
        rows = {row["method"]: row for row in self.json("compare", pinch, "--edges", "4", "--max-force", "4")["methods"]}
        self.assertEqual(rows["least normal forces"]["verdict"], "4")
        self.assertEqual(rows["margin of internal forces"]["verdict"], "3/4")
        self.assertEqual(rows["margin of internal forces"]["evidence"]["edges"], 4)
        self.assertIn("pyramids of 4 edges", rows["least normal forces"]["why"])
        flat = self.write("flat.json", {"format": "stickslip-grasp/1", "wrench": [0, 0, 0], "contacts": []})
        for words in ((flat, "--edges", "4"), (pinch, "--edges", "2"), (pinch, "--edges", "65"), (pinch, "--edges", "x"),
                      (pinch, "--edges", "8", "--methods", "potential-grasp-robustness", "--certificate", self.path("c.json"))):
            self.fails("compare", *words, naming=["--edges"])

    def test_force_closure_has_bounds(self):
        """Three pads that press on a ball at its equator: 0 is inside the hull once there is friction."""
        pads = [((1, 0, 0), (-1, 0, 0)), ((-F(3, 5), F(4, 5), 0), (F(3, 5), -F(4, 5), 0)),
                ((-F(3, 5), -F(4, 5), 0), (F(3, 5), F(4, 5), 0))]
        for friction, verdict in ((0, "not closed"), ("1/2", "closed")):
            grasp = self.write("g.json", {
                "format": "stickslip-grasp/2", "defaults": {"friction": friction}, "wrench": [0] * 6,
                "contacts": [{"position": texts(p), "normal": texts(n)} for p, n in pads]})
            row, = self.json("compare", grasp, "--methods", "grasp-wrench-space-L1")["methods"]
            self.assertEqual(row["verdict"], verdict)
            low, high = (F(row["evidence"][key]) for key in ("low_squared", "high_squared"))
            if verdict == "closed":
                self.assertTrue(0 < F(98, 100) * high <= low <= high, row)
            else:
                self.assertEqual((low, high), (0, 0))


class Asked(SpaceClass):
    def test_what_cannot_be_asked(self):
        grasp = self.write("g.json", {"format": "stickslip-grasp/2", "defaults": {"friction": 1}, "wrench": [0] * 6,
                                      "contacts": [{"position": [0, 0, 0], "normal": [0, 0, 1]}]})
        for method in ("three-state-compliance", "grasp-wrench-space-Linf"):
            self.fails("compare", grasp, "--methods", method, naming=["--methods", method, "in space"])
        for inertia in ("0,0,1", "0,0,0,1,1,0", "0,0,0,1,1,1,1,0,0", "0,0,0,1,1,1,0"):
            self.fails("compare", grasp, "--methods", METHODS, f"--inertia={inertia}", naming=["--inertia"])
        uncertain = self.write("u.json", {
            "format": "stickslip-grasp/2", "defaults": {"friction": {"min": 0, "max": 1}}, "wrench": [0] * 6,
            "contacts": [{"position": [0, 0, 0], "normal": [0, 0, 1]}]})
        self.fails("compare", uncertain, "--methods", METHODS, naming=["u.json"])


if __name__ == "__main__":
    unittest.main()
