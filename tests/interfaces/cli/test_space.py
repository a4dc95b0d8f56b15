# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps in space: every verdict through both checkers, thresholds in closed form from both sides,
invariance, and Newton's method from everywhere where there is to be no equilibrium."""

import json
import os
import random
import unittest
from fractions import Fraction as F

import numpy as np

from space_smt import smt
from test_box import FRAGILE
from test_cli import (CORPUS, DONE, STABLE, UNDECIDED, UNSTABLE, Case, checkers, quick_checker, read,
                      run, stickslip)

Z3 = os.environ.get("Z3", "z3")
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "examples", "grasps")


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def contact(position, normal, **laws):
    return {"position": [str(F(x)) for x in position], "normal": [str(F(x)) for x in normal],
            **{key: value if isinstance(value, dict) else str(F(value))
               for key, value in laws.items()}}


def grasp(contacts, wrench):
    return {"format": "stickslip-grasp/2", "contacts": contacts,
            "wrench": [w if isinstance(w, dict) else str(F(w)) for w in wrench]}


def force_at(force, point):
    return [*force, *cross(point, force)]


def about(value, part):
    """Just below and just above a threshold, which may be irrational."""
    return [F(value * (1 - part)).limit_denominator(10**6),
            F(value * (1 + part)).limit_denominator(10**6)]


class Export(Case):
    def test_pinch(self):
        pinch = os.path.join(EXAMPLES, "space-pinch.json")
        for weight, expected in (("-4", "sat"), ("-5", "unsat")):
            path = self.path("pinch.smt2")
            words = ("--smt2", "--wrench", f"0,0,{weight},0,0,0")
            self.assertEqual(stickslip("export", pinch, *words, "-o", path), (DONE, "", ""))
            self.assertEqual(run(Z3, "-smt2", path), (0, expected + "\n", ""))


class Space(Case):
    engine = "space"

    def decide(self, content, *words):
        """The answer; its certificate is accepted by all that have to judge it, and says the same."""
        file, proof = self.write("g.json", content), self.path("c.json")
        if os.path.exists(proof):
            os.remove(proof)
        code, out, err = stickslip("decide", file, "--json", "--certificate", proof, *words)
        self.assertIn(code, (DONE, UNDECIDED), err)
        answer = json.loads(out)
        self.assertEqual(answer["engine"], self.engine)
        if answer["verdict"] in ("undecided", "fragile"):
            self.assertFalse(os.path.exists(proof))
        else:
            self.assert_accepted(answer["verdict"], file, proof, *words)
        return answer

    def assert_accepted(self, verdict, file, proof, *words):
        self.assertEqual(self.accepted(file, proof, *words, verdict=rf"{verdict}\b")["verdict"], verdict)

    def verdict(self, *words):
        return self.decide(*words)["verdict"]

    def assert_threshold(self, grasp_at, value, part=0.001):
        low, high = about(value, part)
        self.assertEqual([self.verdict(grasp_at(low)), self.verdict(grasp_at(high))],
                         ["stable", "unstable"], value)


class ClosedForms(Space):
    def test_a_body_on_a_tilted_table_slides_beyond_the_slope_mu(self):
        for mu in (F(1, 5), F(1, 2), F(4, 5)):
            feet = [contact((x, y, -F(1, 2)), (0, 0, 1), friction=mu)
                    for x, y in ((3, 2), (3, -2), (-3, 0))]
            self.assert_threshold(
                lambda slope, feet=feet: grasp(feet, force_at((slope, 0, -1), (0, 0, 0))), mu)

    def test_a_disc_with_four_contacts_turned_on_a_table(self):
        feet = [contact((x, y, 0), (0, 0, 1), friction="2/5")
                for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))]
        self.assert_threshold(lambda t: grasp(feet, (0, 0, -3, 0, 0, t)), F(6, 5))

    def test_three_contacts_turn_about_the_point_with_the_least_sum_of_distances(self):
        points = [(2, 0), (-1, 2), (-1, -1)]
        feet = [contact((*p, 0), (0, 0, 1), friction="1/2", preload=1) for p in points]
        load = [0, 0, -3, -sum(p[1] for p in points), sum(p[0] for p in points), 0]
        center = np.zeros(2)
        for _ in range(1000):  # Weiszfeld
            far = [np.hypot(*(center - p)) for p in points]
            center = sum(np.array(p) / d for p, d in zip(points, far)) / sum(1 / d for d in far)
        least = sum(np.hypot(*(center - p)) for p in points)
        self.assert_threshold(lambda t: grasp(feet, [*load[:5], t]), float(least) / 2)

    def test_a_pinch_holds_what_its_friction_does(self):
        hands = [contact((side * 2, 0, 0), (-side, 0, 0), friction="3/10", preload=4)
                 for side in (-1, 1)]
        self.assert_threshold(lambda w: grasp(hands, (0, 0, -w, 0, 0, 0)), F(12, 5))

    def test_a_peg_with_contacts_at_two_heights(self):
        # Normal forces P at a distance h turn it; friction P h / (2 r) at either side, up and
        # down, holds that, and what is left of mu P holds the load.
        mu, preload, radius = F(1, 2), 4, 1
        for h in (F(1, 4), F(1, 2), F(4, 5)):
            sides = [contact((-radius, 0, 0), (1, 0, 0), friction=mu, preload=preload),
                     contact((radius, 0, h), (-1, 0, 0), friction=mu, preload=preload)]
            self.assert_threshold(lambda w, sides=sides: grasp(sides, (0, 0, -w, 0, 0, 0)),
                                  2 * preload * (mu - h / (2 * radius)))

    def test_a_box_wedged_between_walls_is_turned(self):
        # Friction of four contacts at the distance 5 from the axis.
        hands = [contact((side * 2, y, z), (-side, 0, 0), friction="1/4", preload=2)
                 for side, y, z in ((-1, 3, 4), (-1, -3, -4), (1, 3, 4), (1, -3, -4))]
        self.assert_threshold(lambda t: grasp(hands, (0, 0, 0, t, 0, 0)), 10)

    def test_without_friction_the_normals_alone(self):
        feet = [contact((x, y, 0), (0, 0, 1), friction=0) for x, y in ((1, 0), (-1, 1), (-1, -1))]
        self.assertEqual(self.verdict(grasp(feet, force_at((0, 0, -1), (F(99, 100), 0, 5)))), "stable")
        self.assertEqual(self.verdict(grasp(feet, force_at((0, 0, -1), (F(101, 100), 0, 5)))),
                         "unstable")
        self.assertEqual(self.verdict(grasp(feet, (F(1, 100), 0, -1, 0, 0, 0))), "unstable")


def unit_normal(rng, fineness=6):
    a, b = (F(rng.randint(-fineness, fineness), fineness) for _ in range(2))
    s = 1 + a * a + b * b
    n = [2 * a / s, 2 * b / s, (1 - a * a - b * b) / s]
    rng.shuffle(n)
    return [x * rng.choice((-1, 1)) for x in n]


def random_grasp(rng, m, scale):
    contacts = []
    for _ in range(m):
        n = unit_normal(rng)
        p = [-x + F(rng.randint(-2, 2), 8) for x in n]
        contacts.append({"p": p, "n": n, "friction": F(rng.randint(4, 18), 20),
                         "stiffness": F(rng.randint(2, 6), 4), "preload": F(rng.randint(0, 8), 4)})
    return contacts, [scale * F(rng.randint(-8, 8), 8) for _ in range(6)]


def written(contacts, wrench):
    return grasp([contact(c["p"], c["n"], friction=c["friction"], stiffness=c["stiffness"],
                          preload=c["preload"]) for c in contacts], wrench)


def turned(vector, quaternion):
    """By the rotation of a quaternion of any length."""
    w, *v = quaternion
    norm = w * w + sum(x * x for x in v)
    t = cross(v, vector)
    return [x + (2 * w * a + 2 * b) / norm for x, a, b in zip(vector, t, cross(v, t))]


def equilibria(contacts, wrench, starts, rng):
    """How many starts of Newton's method lead to an equilibrium."""
    return len(motions_of_equilibria(contacts, wrench, starts, rng))


def motions_of_equilibria(contacts, wrench, starts, rng):
    """The motions that Newton's method finds on laws whose corners are rounded less and less, each start from a roundness of its
    own."""
    rows = []
    for c in contacts:
        p, n = (np.array([float(x) for x in c[key]]) for key in "pn")
        velocity = np.hstack([np.eye(3), -np.array([[0, -p[2], p[1]], [p[2], 0, -p[0]],
                                                    [-p[1], p[0], 0]])])
        rows.append((np.concatenate([n, np.cross(p, n)]), (np.eye(3) - np.outer(n, n)) @ velocity,
                     float(c["friction"]), float(c["stiffness"]), float(c["preload"])))
    w = np.array([float(x) for x in wrench])
    d = rng.normal(size=(starts, 6)) * rng.choice([0.1, 1, 10, 100, 1000], size=(starts, 1))
    roundest = 8.0 ** rng.uniform(-6, 1, size=starts)

    def force(d, smooth):
        total, slope = np.tile(w, (len(d), 1)), np.zeros((len(d), 6, 6)) - 1e-10 * np.eye(6)
        for normal, slip, mu, k, preload in rows:
            v, s = preload - k * d @ normal, d @ slip.T
            far, over = np.hypot(v, smooth), np.sqrt(np.sum(s * s, axis=1) + smooth**2)
            a, unit = (v + far) / 2, s / over[:, None]
            wrenches = normal - mu * unit @ slip
            change = np.eye(3) - unit[:, :, None] * unit[:, None, :]
            total += a[:, None] * wrenches
            slope -= (k * a / far)[:, None, None] * wrenches[:, :, None] * normal
            slope -= (a * mu / over)[:, None, None] * (slip.T @ change @ slip)
        return total, slope

    for least_round in 4.0 ** -np.arange(-1, 9):
        smooth = np.minimum(roundest, least_round)
        for _ in range(12):
            total, slope = force(d, smooth)
            move = np.linalg.solve(slope, -total[:, :, None])[:, :, 0]
            best, least = d, np.linalg.norm(total, axis=1)
            for part in (1, 0.5, 0.25, 0.1, 0.01):
                there = np.linalg.norm(force(d + part * move, smooth)[0], axis=1)
                better = there < least
                best = np.where(better[:, None], d + part * move, best)
                least = np.where(better, there, least)
            d = best
    return d[np.linalg.norm(force(d, smooth)[0], axis=1) < 1e-6]


class Random(Space):
    def test_where_a_tree_says_unstable_newton_finds_nothing(self):
        rng = random.Random(5)
        verdicts = {"stable": 0, "unstable": 0, "undecided": 0}
        found_in_stable = 0
        for k in range(12):
            contacts, wrench = random_grasp(rng, 3 + k % 3, F(1, 2))
            verdict = self.verdict(written(contacts, wrench))
            verdicts[verdict] += 1
            count = equilibria(contacts, wrench, 100, np.random.default_rng(k))
            if verdict == "unstable":
                self.assertEqual(count, 0, (contacts, wrench))
            elif verdict == "stable":
                found_in_stable += count > 0
        self.assertGreaterEqual(min(verdicts["stable"], verdicts["unstable"]), 3, verdicts)
        self.assertLessEqual(verdicts["undecided"], 1, verdicts)
        self.assertEqual(found_in_stable, verdicts["stable"])  # or it could find none anywhere

    def test_rotations_permutations_units_and_lengths_of_normals_change_nothing(self):
        rng = random.Random(8)
        verdicts = set()
        for k in range(4):
            contacts, wrench = random_grasp(rng, 4, F(1, 2))
            verdict = self.verdict(written(contacts, wrench))
            if verdict == "undecided":
                continue
            verdicts.add(verdict)
            quaternion = [rng.randint(1, 4) for _ in range(4)]
            others = []
            for c in rng.sample(contacts, len(contacts)):
                # Longer normals, a force ten times as large, and millimetres.
                n = [x * (k + 2) for x in turned(c["n"], quaternion)]
                others.append({**c, "p": [1000 * x for x in turned(c["p"], quaternion)], "n": n,
                               "preload": 10 * c["preload"], "stiffness": c["stiffness"] / 100})
            load = [*(10 * x for x in turned(wrench[:3], quaternion)),
                    *(10000 * x for x in turned(wrench[3:], quaternion))]
            self.assertEqual(self.verdict(written(others, load)), verdict)
        self.assertEqual(verdicts, {"stable", "unstable"})

    def test_what_is_stable_in_the_plane_is_in_space(self):
        rng = random.Random(2)
        stable = 0
        units = [(F(3, 5), F(4, 5)), (F(-3, 5), F(4, 5)), (F(0), F(-1)), (F(1), F(0)),
                 (F(-4, 5), F(-3, 5)), (F(5, 13), F(-12, 13))]
        for _ in range(8):
            chosen = rng.sample(units, 4)
            rows = [([-n[0] * 2, -n[1] * 2 + F(rng.randint(-4, 4), 4)], n, F(rng.randint(2, 8), 10),
                     F(rng.randint(0, 4), 2)) for n in chosen]
            x, y, t = (F(rng.randint(-4, 4), 4) for _ in range(3))
            flat = {"format": "stickslip-grasp/2", "wrench": [str(x), str(y), str(t)],
                    "contacts": [contact(p, n, friction=mu, preload=preload)
                                 for p, n, mu, preload in rows]}
            if self.json("decide", self.write("flat.json", flat))["verdict"] != "stable":
                continue
            stable += 1
            spatial = grasp([contact((*p, 0), (*n, 0), friction=mu, preload=preload)
                             for p, n, mu, preload in rows], (x, y, 0, 0, 0, t))
            self.assertNotEqual(self.verdict(spatial), "unstable", flat)
        self.assertGreaterEqual(stable, 3)


    def test_against_z3_in_nonlinear_real_arithmetic(self):
        rng = random.Random(3)
        agreed = {"sat": 0, "unsat": 0}
        for k in range(12):
            contacts = []
            for _ in range(1 + k % 3):
                n = unit_normal(rng, 2)
                contacts.append({"p": [-x for x in n], "n": n, "friction": F(rng.randint(1, 4), 4),
                                 "stiffness": F(1), "preload": F(rng.randint(1, 3))})
            # What all preloads and some of the friction balance; more than there is, at times.
            wrench = [F(0)] * 6
            for c in contacts:
                f = [F(rng.randint(-2, 2), 3 if k % 3 else 1) * c["friction"] * c["preload"]
                     for _ in range(3)]
                along = sum(a * b for a, b in zip(f, c["n"]))
                force = [c["preload"] * n + a - along * n for a, n in zip(f, c["n"])]
                wrench = [w - x for w, x in zip(wrench, force_at(force, c["p"]))]
            verdict = self.verdict(written(contacts, wrench))
            text = smt([[c[key] for key in ("p", "n", "friction", "stiffness", "preload")]
                        for c in contacts], wrench)
            # It answers in a twentieth of a second, or not in many.
            z3 = run(Z3, "-T:1", "-in", stdin=text)[1].strip()
            self.assertNotIn((verdict, z3), (("stable", "unsat"), ("unstable", "sat")))
            if (verdict, z3) in (("stable", "sat"), ("unstable", "unsat")):
                agreed[z3] += 1
        self.assertGreaterEqual(agreed["sat"], 3, agreed)
        self.assertGreaterEqual(agreed["unsat"], 1, agreed)


class Near(Space):
    """Loads within 1 % of a threshold; how much work an answer may be."""

    NODES = {"box4_1_0u": 395, "box4_1_3s": 182, "box4_2_1u": 431, "sphere4_1_2u": 117,
             "sphere4_1_3s": 73, "sphere4_2_0u": 347, "sphere8_1_0s": 12, "sphere8_1_0u": 687,
             "sphere8_0s": 524, "sphere12_0s": 96}

    def test_verdicts_and_work(self):
        folder = os.path.join(CORPUS, "..", "near")
        self.assertEqual({name[:-len(".json")] for name in os.listdir(folder)}, set(self.NODES))
        for name, nodes in self.NODES.items():
            content = json.loads(read(os.path.join(folder, name + ".json")))
            answer = self.decide(content)
            self.assertEqual(answer["verdict"], {"s": "stable", "u": "unstable"}[name[-1]], name)
            self.assertLessEqual(answer["stats"]["nodes"], 1.3 * nodes, name)
            self.assertEqual(self.json("decide", self.path("g.json")), answer)
            self.assertLess(os.path.getsize(self.path("c.json")), 200_000)


class Boxes(Space):
    def feet(self, friction):
        return [contact((x, y, -F(1, 2)), (0, 0, 1), friction=friction)
                for x, y in ((3, 2), (3, -2), (-3, 0))]

    def test_uncertain_numbers_and_tolerances(self):
        load = force_at((F(2, 5), 0, -1), (0, 0, 0))
        between = {"min": "1/2", "max": "3/5"}
        answer = self.decide(grasp(self.feet(between), load))
        self.assertEqual((answer["verdict"], answer["box"]), ("stable", True))
        self.assertEqual(self.verdict(grasp(self.feet({"min": "1/5", "max": "3/10"}), load)), "unstable")
        words = ("--uncertain", "friction=10%,wrench=1%")
        self.assertEqual(self.verdict(grasp(self.feet("3/5"), load), *words), "stable")
        self.assertEqual(self.verdict(grasp(self.feet("1/4"), load), *words), "unstable")
        self.assertEqual(self.verdict(grasp(self.feet("2/5"), load), *words), "fragile")

    def test_two_grasps_of_a_fragile_box(self):
        file, folder = self.write("g.json", grasp(
            self.feet({"min": "3/10", "max": "1/2"}), force_at((F(2, 5), 0, -1), (0, 0, 0)))), self.path("two")
        code, out, err = stickslip("decide", file, "--examples", folder, "--exit-code", "--json")
        self.assertEqual((code, err), (FRAGILE, ""))
        answer = json.loads(out)
        self.assertEqual(answer["verdict"], "fragile")
        self.assertEqual([d["place"] for d in answer["differences"]],
                         [f"contacts[{i}].friction" for i in range(3)])
        for verdict in ("stable", "unstable"):
            self.assert_accepted(verdict, os.path.join(folder, f"{verdict}.json"),
                                 os.path.join(folder, f"{verdict}.certificate.json"))
            given = json.loads(read(os.path.join(folder, f"{verdict}.json")))
            self.assertEqual(given, answer["examples"][verdict])
            for c, d in zip(given["contacts"], answer["differences"]):
                self.assertEqual(F(c["friction"]), F(d[verdict]))
                self.assertTrue(F(3, 10) <= F(c["friction"]) <= F(1, 2))
        self.assertIn("Two of them, what differs most first:", stickslip("decide", file)[1])
        code, _, err = stickslip("decide", file, "--certificate", self.path("c.json"))
        self.assertEqual(code, DONE)
        self.assertIn("--examples DIR writes them", err)

    def test_a_box_that_is_proved_in_parts(self):
        between = [{"min": "1/2", "max": "7/10"}, {"min": "4/5", "max": "9/10"},
                   {"min": "2/5", "max": "11/10"}]
        contacts = [contact((0, 1, -1), (0, 0, 1), friction=between[0], preload=1),
                    contact((-1, 0, 0), (1, 0, 0), friction=between[1], preload=3),
                    contact((1, 0, -1), (-1, 0, 0), friction=between[2], preload=2)]
        answer = self.decide(grasp(contacts, (-3, -3, 3, -2, 3, 0)))
        self.assertEqual(answer["verdict"], "unstable")
        self.assertIn('["part","friction",2,', read(self.path("c.json")))

    def test_uncertain_positions_of_what_must_slide(self):
        feet = self.feet("1/5")
        for foot in feet:
            x = F(foot["position"][0])
            foot["position"][0] = {"min": str(x - F(1, 10)), "max": str(x + F(1, 10))}
        self.assertEqual(self.verdict(grasp(feet, force_at((1, 0, -1), (0, 0, 0)))), "unstable")

    def test_normals_of_irrational_length_with_preload(self):
        # Four contacts of 4 N on two faces whose normals have the length sqrt 3.
        hands = [contact((side * 2 + t, side * 2 - t, side * 2), (-side, -side, -side),
                         friction="3/10", preload=4) for side in (-1, 1) for t in (-1, 1)]
        for w, verdict in ((F(19, 10), "stable"), (2, "unstable")):  # sqrt 6 w is 24/5 between
            answer = self.decide(grasp(hands, (w, w, -2 * w, 0, 0, 0)))
            self.assertEqual(answer["verdict"], verdict)
            self.assertNotIn("box", answer)
            self.assertEqual((answer["enclosed"], answer["bits"]), ([0, 1, 2, 3], 128))
            out = stickslip("decide", self.write("hands.json", grasp(hands, (w, w, -2 * w, 0, 0, 0))))[1]
            self.assertIn("\nThe normals of contacts 0, 1, 2, 3 have irrational lengths |n|: P/|n| was enclosed to 128 bits,\n",
                          out)
            self.assertNotIn("box", out)


class Normals(Space):
    """That are uncertain."""

    def test_a_point_on_a_floor_whose_normal_is_known_to_a_slope(self):
        """The floor's reaction is within atan mu of the normal, and that within atan E of the file's: along U, where
        the square of directions that proofs are about is no wider than the disc. Of a slanted floor as well."""
        e, mu = F(7, 200), F(1, 2)
        held, lost = (mu - e) / (1 + mu * e), (mu + e) / (1 - mu * e)
        for push, verdict in ((held * F(98, 100), "stable"), (lost * F(102, 100), "unstable"), (mu, "fragile")):
            # The normal, U, and |U| / |n|, the last nearly.
            for n, along, size in (((0, 0, 1), (0, 1, 0), F(1)), ((2, -2, -1), (-2, -2, 0), F(942809, 10**6))):
                load = [push / size * a - c for a, c in zip(along, n)]
                file = grasp([contact((0, 0, 0), n, friction=mu)], force_at(load, (0, 0, 0)))
                self.assertEqual(self.verdict(file, "--uncertain", f"normal={e}"), verdict, (push, n))
                file["contacts"][0]["normal"] = {"direction": file["contacts"][0]["normal"], "slope": str(e)}
                self.assertEqual(self.verdict(file), verdict, (push, n))

    def test_a_pinch_whose_normals_are_known_to_a_slope(self):
        """Two fingers that press with 2 hold 2 at mu = 1/2, and 4 (mu - E) if both normals lean down."""
        for weight, holds in ((F(17, 10), True), (F(196, 100), False)):
            pinch = grasp([contact((-1, 0, 0), (1, 0, 0), friction=F(1, 2), preload=2),
                           contact((1, 0, 0), (-1, 0, 0), friction=F(1, 2), preload=2)], (0, 0, -weight, 0, 0, 0))
            self.assertEqual(self.verdict(pinch), "stable")
            self.assertEqual(self.verdict(pinch, "--uncertain", "normal=0.0175") == "stable", holds)

    def test_grasps_of_a_box_of_normals_have_its_verdict(self):
        """Four fingers at rest, and three feet that are pushed too hard, on slanted floors: some of their grasps, one by
        one."""
        rng, slope = random.Random(31), F(7, 200)

        def fingers():
            mu = F(rng.randint(12, 18), 20)
            return [contact((-x, -y, F(rng.randint(-2, 2), 8)), (x, y, 0), friction=mu, preload=2)
                    for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1))], [F(rng.randint(-2, 2), 10) for _ in range(6)]

        def feet():
            mu, push = F(rng.randint(4, 8), 20), F(rng.randint(12, 20), 20)
            x, y, z = rng.choice((((1, 0, 0), (0, 1, 0), (0, 0, 1)),
                                  ((F(1, 3), F(2, 3), F(2, 3)), (F(2, 3), F(1, 3), F(-2, 3)), (F(2, 3), F(-2, 3), F(1, 3)))))
            places = [[a * i + b * j for i, j in zip(x, y)] for a, b in ((3, 2), (3, -2), (-3, 0))]
            return [contact(p, z, friction=mu) for p in places], force_at([push * i - k for i, k in zip(x, z)], (0, 0, 0))

        for make, verdict in ((fingers, "stable"), (feet, "unstable")):
            for _ in range(3):
                file = grasp(*make())
                self.assertEqual(self.verdict(file, "--uncertain", f"normal={slope},friction=2%"), verdict)
                for _ in range(2):
                    one = json.loads(json.dumps(file))
                    for c in one["contacts"]:
                        n = [F(x) for x in c["normal"]]
                        t = cross(n, [rng.randint(-9, 9) for _ in range(3)])
                        most = float(slope) * np.linalg.norm(np.array(n, float)) / (np.linalg.norm(np.array(t, float)) or 1)
                        part = F(most * rng.choice((0.5, 0.99))).limit_denominator(1000)
                        self.assertLessEqual(part**2 * sum(x * x for x in t), slope**2 * sum(x * x for x in n))
                        c["normal"] = [str(x + part * y) for x, y in zip(n, t)]
                        c["friction"] = str(F(c["friction"]) * rng.choice((F(98, 100), 1, F(102, 100))))
                    self.assertEqual(self.verdict(one), verdict)

    def test_two_grasps_that_differ_in_their_normals(self):
        slope, folder = F(1, 10), self.path("two")
        file = self.write("g.json", grasp([contact((0, 0, 0), (1, 2, 2), friction=F(1, 2))],
                                          force_at((0, F(-3, 2), -3), (0, 0, 0))))  # at the edge of the cone
        code, out, err = stickslip("decide", file, "--uncertain", f"normal={slope}", "--examples", folder, "--json")
        self.assertEqual((code, err, json.loads(out)["verdict"]), (DONE, "", "fragile"))
        for verdict in ("stable", "unstable"):
            self.assert_accepted(verdict, os.path.join(folder, f"{verdict}.json"),
                                 os.path.join(folder, f"{verdict}.certificate.json"))
            n = [F(x) for x in json.loads(read(os.path.join(folder, f"{verdict}.json")))["contacts"][0]["normal"]]
            along = n[0] + 2 * n[1] + 2 * n[2]  # n.n0, and |n|^2 |n0|^2 = along^2 (1 + tangent^2)
            self.assertLessEqual(9 * sum(x * x for x in n), along**2 * (1 + slope**2))
        self.assertEqual({d["place"] for d in json.loads(out)["differences"]} - {
            "contacts[0].normal.turn_u", "contacts[0].normal.turn_v"}, set())


def in_doubles(values):
    return [F(float(x)) for x in values]


def round_grasp(rng, m, preloaded=True):
    """Unit normals all round, in doubles with all their digits, and a direction of loads."""
    contacts = []
    for _ in range(m):
        n = rng.normal(size=3)
        n /= np.linalg.norm(n)
        contacts.append({"p": in_doubles(-n), "n": in_doubles(n), "friction": F(rng.uniform(0.3, 0.9)),
                         "stiffness": F(rng.uniform(0.5, 2)),
                         "preload": F(rng.uniform(0, 2)) if preloaded else F(0)})
    return contacts, in_doubles(rng.uniform(-1, 1, size=6))


def fingers(m, load, digits=None, **laws):
    """m of them around a cylinder, which `load` pulls down."""
    angles = 2 * np.pi * np.arange(m) / m
    around = [[np.cos(a), np.sin(a), 0.0] for a in angles]
    if digits is not None:
        around = [[round(x, digits) for x in n] for n in around]
    return grasp([contact(in_doubles([-x for x in n]), in_doubles(n), **laws) for n in around],
                 (0, 0, -F(load), 0, 0, 0))


class Doubles(Space):
    """The numbers that NumPy has: unit normals are of irrational length, and nothing is short."""

    def test_random_grasps_are_decided_and_newton_agrees(self):
        verdicts = {"stable": 0, "unstable": 0}
        for m in (3, 4, 6):
            for k in range(4):
                rng = np.random.default_rng(100 * m + k)
                contacts, wrench = round_grasp(rng, m, preloaded=k % 4 != 3)
                wrench = [F(rng.choice([0.03, 0.1, 0.5])) * w for w in wrench]
                verdict = self.verdict(written(contacts, wrench))
                verdicts[verdict] += 1
                found = equilibria(contacts, wrench, 100, rng)
                self.assertEqual(found > 0, verdict == "stable", (m, k))
        self.assertGreaterEqual(min(verdicts.values()), 2, verdicts)

    def test_slips_that_span_half_a_plane_but_for_rounding(self):
        # Contacts on the faces of a cube that is turned: planes coincide but for the last digit.
        self.judges = quick_checker
        for seed, m in ((1, 6), (4, 8)):
            rng = np.random.default_rng(seed)
            turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
            contacts = []
            for _ in range(m):
                p, n = rng.uniform(-1, 1, size=3), np.zeros(3)
                axis, side = rng.integers(3), rng.choice([-1.0, 1.0])
                p[axis], n[axis] = side, -side
                contacts.append({"p": in_doubles(turn @ p), "n": in_doubles(turn @ n), "friction": F(1, 2),
                                 "stiffness": F(1), "preload": F(rng.uniform(0, 2))})
            wrench = in_doubles(2 * rng.uniform(-1, 1, size=6))
            self.assertNotEqual(self.verdict(written(contacts, wrench)), "undecided", seed)

    def test_what_is_at_rest_is_proved_at_once(self):
        for m in (3, 5, 20):
            for digits in (7, None):
                # Each finger holds 0.4 of what its friction may.
                file = fingers(m, F(1, 5) * m, digits, friction="1/2", preload=1)
                answer = self.decide(file)
                self.assertEqual((answer["verdict"], answer["stats"]["nodes"]), ("stable", 0), (m, digits))
                words = ("--uncertain", "friction=5%,preload=1%,wrench=2%,position=0.001")
                answer = self.decide(file, *words)
                self.assertEqual((answer["verdict"], answer["stats"]["nodes"]), ("stable", 0), (m, digits))
                self.assertIn('"rest"', read(self.path("c.json")))

    def test_a_pinch_turns_freely_and_is_stable_all_the_same(self):
        rng = np.random.default_rng(3)
        for n in ([1.0, 0.0, 0.0], rng.normal(size=3)):
            n = np.array(n) / np.linalg.norm(n)
            hands = [contact(in_doubles(-side * n), in_doubles(side * n), friction="1/2", preload=4)
                     for side in (-1, 1)]
            file = grasp(hands, (0, 0, -1, 0, 0, 0))
            for words in ((), ("--uncertain", "friction=1%"), ("--uncertain", "preload=1%"),
                          ("--uncertain", "friction=1%,preload=1%,wrench=1%")):
                self.assertEqual(self.verdict(file, *words), "stable", (n, words))
            # A torque about the line through the fingers nothing holds.
            self.assertEqual(self.verdict(grasp(hands, [0, 0, -1, *in_doubles(n)])), "unstable", n)
            # Where that line lies is uncertain, and then the load turns the body about it.
            self.assertEqual(self.verdict(file, "--uncertain", "position=0.001"), "fragile", n)

    def test_a_book_held_at_places_known_to_a_billionth(self):
        file = os.path.join(EXAMPLES, "space-book.json")
        for case in ("held at its middle", "held near its top"):
            answer = self.json("decide", file, "--case", case, "--uncertain", "position=1e-9")
            self.assertEqual(answer["verdict"], "stable", case)


class Undecided(Space):
    def test_only_what_was_reached_is_named(self):
        contacts, wrench = round_grasp(np.random.default_rng(602), 6)
        file = self.write("g.json", written(contacts, wrench))
        code, out, _ = stickslip("decide", file, "--json", "--node-limit", "3")
        answer = json.loads(out)
        self.assertEqual((code, answer["verdict"], answer["reason"]), (UNDECIDED, "undecided", "nodes"))
        self.assertIn("limit of 3 nodes", answer["limit"])
        self.assertIn("node limit", answer["remedy"])
        _, out, _ = stickslip("decide", file, "--node-limit", "3")
        self.assertIn("limit of 3 nodes", out)
        self.assertIn("node limit", out)

    def test_the_limit_bounds_all_trees_together(self):
        file = os.path.join(EXAMPLES, "space-book.json")
        words = ("--case", "too heavy", "--uncertain", "position=1e-9", "--node-limit", "100")
        stats = json.loads(stickslip("decide", file, *words, "--json")[1])["stats"]
        self.assertLessEqual(stats["nodes"], 30 * 100)


class Margins(Space):
    def test_margins_of_doubles_know_what_decide_does(self):
        for seed in (24, 29):
            self.judges = checkers if seed == 24 else quick_checker
            contacts, wrench = round_grasp(np.random.default_rng(seed), 4)
            file = self.write("g.json", written(contacts, wrench))
            words = ("--direction", ",".join(str(w) for w in wrench))
            proof = self.path("m.json")
            known = self.json("margin", file, *words, "--certificate", proof)
            self.accepted(file, proof, *words)
            (low, end), = known["resisted"]
            (begin, beyond), = known["refuted"]
            self.assertEqual((F(low), beyond), (0, None))
            self.assertLess(F(begin), F(end) * F(101, 100))
            for multiple in (F(1, 4) * F(end), F(99, 100) * F(end), F(101, 100) * F(end), 3 * F(end)):
                verdict = self.verdict(written(contacts, [multiple * w for w in wrench]))
                self.assertEqual(verdict, "stable" if multiple < F(end) else "unstable", (seed, multiple))

    def test_where_nothing_is_known_the_exit_code_says_so(self):
        contacts, wrench = round_grasp(np.random.default_rng(624), 6)
        file = self.write("g.json", written(contacts, wrench))
        code, out, _ = stickslip("margin", file, "--node-limit", "1",
                                 "--direction", ",".join(str(w) for w in wrench))
        self.assertEqual(code, UNDECIDED, out)
        self.assertIn("No l is known to be resisted", out)


class Files(Space):
    def test_examples_say_what_they_do(self):
        for name, verdicts in (("cup", ["stable"]), ("corner", ["stable"]),
                               ("book", ["stable", "stable", "unstable", "unstable"])):
            content = json.loads(read(os.path.join(EXAMPLES, f"space-{name}.json")))
            cases = [("--case", case["name"]) for case in content.get("cases", [])] or [()]
            self.assertEqual([self.verdict(content, *words) for words in cases], verdicts, name)

    def test_loads_and_cases(self):
        content = grasp([contact((0, 0, 0), (0, 0, 1), friction=1)], [0] * 6)
        del content["wrench"]
        content["loads"] = [{"weight": 3, "at": [1, 2, 0]}, {"torque": [1, 0, "-1/2"]},
                            {"force": [1, 0, 0], "at": [0, 0, 2]},
                            {"weight": 3, "at": [0, 0, 0], "direction": [1, 2, 2]}]
        self.assertEqual(self.decide(content)["wrench"], ["2", "2", "-1", "-5", "5", "-1/2"])
        content["cases"] = [{"name": "more", "loads": [{"weight": 1, "at": [0, 0, 0]}]}]
        self.assertEqual(self.decide(content, "--case", "more")["wrench"][2], "-2")
        both = self.json("decide", self.write("g.json", content))
        self.assertEqual([case["case"] for case in both["cases"]], ["more"])

    def test_errors_name_the_contact(self):
        feet = [contact((0, 0, 0), (0, 0, 1), friction=1) for _ in range(3)]
        load = [0, 0, -1, 0, 0, 0]

        def changed(change, wrench=None):
            content = grasp(json.loads(json.dumps(feet)), wrench or load)
            change(content)
            return self.write("g.json", content)

        def set_in(index, key, value):
            return lambda content: content["contacts"][index].__setitem__(key, value)

        for change, naming in (
                (set_in(2, "position", [0, 0]), ["contacts[2].position", "three numbers"]),
                (set_in(0, "position", [0, 0]), ["contacts[0].normal"]),
                (set_in(1, "normal", [0, 1]), ["contacts[1].normal", "three numbers"]),
                (set_in(1, "normal", [0, 0, 0]), ["contacts[1].normal", "(0, 0, 0)"]),
                (set_in(1, "friction", -1), ["contacts[1].friction"]),
                (set_in(1, "on", [0, 0]), ["contacts[1].on", "in space"]),
                (lambda c: c.update(outline=[[0, 0], [1, 0], [0, 1]]), ["outline", "in space"]),
                (lambda c: c.update(format="stickslip-grasp/1"), ["contacts[0].position"]),
                (lambda c: c.update(wrench=[0, 0, 0]), ["wrench", "six numbers"])):
            self.fails("decide", changed(change), naming=naming)
        good = changed(lambda content: None)
        self.fails("decide", good, "--wrench", "0,0,0", naming=["--wrench", "in space"])
        self.fails("decide", good, "--engine", "branch-and-bound", naming=["--engine", "in space"])
        self.fails("decide", good, "--uncertain", "normal=1", naming=["contacts[0].normal", "slope"])
        self.fails("decide", good, "--case", "x", naming=["--case", "no case"])
        self.assertIn("</svg>", stickslip("plot", "states", good)[1])  # test_states looks at it

    def test_answers_in_words_and_by_exit_code(self):
        file = self.write("g.json", grasp(
            [contact((side * 2, 0, 0), (-side, 0, 0), friction="1/2", preload=4) for side in (-1, 1)],
            [0, 0, -1, 0, 0, 0]))
        code, out, err = stickslip("decide", file, "--exit-code")
        self.assertEqual((code, err), (STABLE, ""))
        self.assertRegex(out, r"^stable\n\n  load w    \(0, 0, -1, 0, 0, 0\)\n  motion d  \(0")
        self.assertIn("in their friction cones", out)
        code, out, _ = stickslip("decide", file, "--exit-code", "--wrench", "0,0,-5,0,0,0")
        self.assertEqual(code, UNSTABLE)
        self.assertRegex(out, r"Proved by a tree of \d+ leaves")
        code, out, _ = stickslip("decide", file, "--exit-code", "--node-limit", "1", "--wrench", "1,2,-3,1,2,1")
        self.assertIn(code, (UNDECIDED, UNSTABLE))


class Warnings(Space):
    """The traps of the model, as in the plane."""

    def traps(self, content, *words):
        answer = self.json("decide", self.write("w.json", content), *words)
        return {warning["trap"]: warning["text"] for warning in answer["warnings"]}

    def floor(self, weight):
        """On three springs of stiffness 1, each of which takes a third."""
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
        return grasp([contact(p, (0, 0, 1), friction=F(1, 2)) for p in points],
                     force_at((0, 0, -weight), (F(1, 3), F(1, 3), 0)))

    def test_a_motion_that_is_larger_than_the_grasp(self):
        # Wide by the root of 2, in which the floor goes down by a third of the weight.
        self.assertEqual(self.traps(self.floor(F(42, 10))), {})
        text = self.traps(self.floor(F(43, 10)))["large-motion"]
        self.assertEqual(text, "stiffness that is not given was taken as 1, with which the motion found is too large for the "
                               "model: contact 0 moves by 1.43 in a grasp 1.41 wide")
        file = self.write("w.json", self.floor(300))
        self.assertIn("\nWarning: stiffness that is not given was taken as 1, with which the motion", stickslip("decide", file)[1])
        self.assertNotIn("Warning", stickslip("decide", file, "--no-warnings")[1])
        self.assertNotIn("warnings", self.json("decide", file, "--no-warnings"))

    def test_preloads_that_do_not_balance(self):
        def squeezed(*preloads):
            return grasp([contact((-1, 0, 0), (1, 0, 0), friction=F(3, 5), stiffness=100, preload=preloads[0]),
                          contact((1, 0, 0), (-1, 0, 0), friction=F(3, 5), stiffness=100, preload=preloads[1])],
                         [0, 0, -1, 0, 0, 0])
        self.assertNotIn("unbalanced-preload", self.traps(squeezed(12, 12)))
        self.assertEqual(self.traps(squeezed(12, 9))["unbalanced-preload"],
                         "the preloads do not balance, even with friction: the object moves before any load is applied")
        # Three fingers as doubles have them; friction makes up for what the third presses more.
        def fingers(friction, last):
            spots = [(np.cos(a), np.sin(a), 0.0) for a in 2 * np.pi * np.arange(3) / 3]
            return grasp([contact(p, [-x for x in p], friction=friction, stiffness=100, preload=P)
                          for p, P in zip(spots, (1, 1, last))], [0] * 6)
        self.assertNotIn("unbalanced-preload", self.traps(fingers(F(1, 2), 1)))
        self.assertNotIn("unbalanced-preload", self.traps(fingers(F(1, 2), F(3, 2))))
        self.assertIn("unbalanced-preload", self.traps(fingers(F(1, 10), F(3, 2))))

    def test_a_preload_that_is_all_but_gone(self):
        def finger(load):
            return grasp([contact((0, 0, 0), (0, 0, 1), friction=1, stiffness=20000, preload=100)],
                         [0, 0, -load, 0, 0, 0])
        self.assertNotIn("lost-preload", self.traps(finger(1)))
        self.assertEqual(self.traps(finger(F(1, 2)))["lost-preload"],
                         "the preload is all but gone in this equilibrium: no contact keeps more than 0.5 % of its own")

    def test_a_stiffness_that_nobody_gave(self):
        """Of three supports the middle one alone has friction, and bears 3 k / (2 + k) of 10."""
        def plank(push, **stiffness):
            return grasp([contact((x, 0, 0), (0, 0, 1), friction=F(1, 2) if x == 0 else 0,
                                  **(stiffness if x == 0 else {"stiffness": 1})) for x in (-1, 0, 1)],
                         [push, 0, -30, 0, 0, 0])
        text = "no stiffness is given for contact 1, so 1 was taken; with {} the verdict would be {}"
        self.assertEqual(self.traps(plank(2))["assumed-stiffness"], text.format("1/10", "unstable"))
        self.assertEqual(self.traps(plank(6))["assumed-stiffness"], text.format("10", "stable"))
        for quiet in (plank(F(1, 2)), plank(14), plank(2, stiffness=1)):
            self.assertNotIn("assumed-stiffness", self.traps(quiet))

    def test_numbers_that_are_uncertain_have_none(self):
        file = self.write("w.json", self.floor(300))
        answer = json.loads(stickslip("decide", file, "--uncertain", "wrench=1%", "--node-limit", "50", "--json")[1])
        self.assertEqual((answer["box"], answer["warnings"]), (True, []))

    def test_of_a_margin(self):
        file = self.write("w.json", self.floor(1))
        direction = ",".join(map(str, force_at((0, 0, -1), (F(1, 3), F(1, 3), 0))))
        answer = self.json("margin", file, "--direction", direction, "--accuracy", "1/10")
        self.assertIsInstance(answer["warnings"], list)
        self.assertNotIn("warnings", self.json("margin", file, "--direction", direction, "--accuracy", "1/10",
                                               "--no-warnings"))


if __name__ == "__main__":
    unittest.main()
