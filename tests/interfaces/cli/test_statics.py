# SPDX-License-Identifier: GPL-3.0-or-later
"""Statics of bodies: thresholds in closed form, assemblies at random beside Z3 and the passive verdict, and every answer
through the checkers that judge it."""

import json
import math
import os
import random
import unittest
from fractions import Fraction as F

from bodies_smt import statics as smt
from test_bodies import arch, contact, force, grasp, random_assembly, text, weight
from test_cli import DONE, HERE, UNDECIDED, Case, checkers, read, run, stickslip
from test_space import Z3

ROOT = os.path.join(HERE, "..", "..", "..")


def near(x):
    """A number close to an irrational one."""
    return F(round(x * 2**40), 2**40)


class Statics(Case):
    def ask(self, content, *words):
        """The answer; its certificates are accepted, with the options that it names."""
        file, proof = (content if isinstance(content, str) else self.write("g.json", content)), self.path("c.json")
        code, out, err = stickslip("statics", file, "--json", "--certificate", proof, *words)
        self.assertIn(code, (DONE, UNDECIDED), err)
        answer = json.loads(out)
        text_of = stickslip("statics", file, "--certificate", proof, *words)[1]
        lines = [line.split()[1:] for line in text_of.splitlines() if line.startswith("Check it: ")]
        commands = [line[line.index("stickslip-check") + 1:] for line in lines]
        self.assertEqual(bool(commands), code == DONE, text_of)
        # stickslip-proved knows no limits of forces.
        limited = any(word in read(file) for word in ("max_force", "max_torque"))
        for command in commands:
            for checker in checkers(command[1])[:2 if limited else None]:
                code, out, err = run(*checker, *command)
                self.assertEqual(code, 0, (out, err, command))
        return answer

    def kind(self, content, *words):
        return self.ask(content, *words)["class"]

    def least(self, content, expected, part=1e-6):
        found = self.ask(content, "--least-friction")["least_friction"]
        low, high = F(found["low"]), F(found["high"])
        self.assertLessEqual(high - low, F(1, 10**6) * max(high, F(1, 10**6)))
        self.assertLess(low, expected * (1 + part))
        self.assertGreater(high, expected * (1 - part))
        return low, high

    def multiples(self, content, *words):
        found = self.ask(content, *words)["multiples"]
        return found["stand"], found["below"], found["above"]


class ClosedForms(Statics):
    def test_three_cylinders(self):
        # Two on the ground, which touch, and one above: between cylinders 2 - sqrt 3, on the ground a third of that.
        h = near(3**0.5)
        def pile(mutual, ground):
            n = (F(1, 2), h / 2)
            return grasp("lru", [contact("l", (-1, 0), (0, 1), friction=ground), contact("r", (1, 0), (0, 1), friction=ground),
                                 contact("r", (0, 1), (1, 0), by="l", friction=mutual),
                                 contact("u", (-F(1, 2), 1 + h / 2), n, by="l", friction=mutual),
                                 contact("u", (F(1, 2), 1 + h / 2), (-n[0], n[1]), by="r", friction=mutual)],
                         [weight("l", 1, (-1, 1)), weight("r", 1, (1, 1)), weight("u", 1, (0, 1 + h))])
        self.least(pile(1, 1), 2 - 3**0.5)
        self.least(pile(100, 1), (2 - 3**0.5) / 3)

    def test_four_balls(self):
        # Three on the ground, apart by nothing, and one above: sqrt 3 - sqrt 2 between balls.
        r, up = near(2 / 3**0.5), near((8 / 3)**0.5)
        places = [(r, F(0)), (-r / 2, F(1)), (-r / 2, F(-1))]
        names, contacts, loads = "abc", [], [weight("u", 1, (0, 0, 1 + up))]
        for name, (x, y) in zip(names, places):
            contacts.append(contact(name, (x, y, 0), (0, 0, 1), friction=1))
            contacts.append(contact("u", (x / 2, y / 2, 1 + up / 2), (-x, -y, up), by=name, friction=1))
            loads.append(weight(name, 1, (x, y, 1)))
        self.least(grasp("abcu", contacts, loads), 3**0.5 - 2**0.5)

    def test_arches(self):
        for name, expected in (("arch.json", 0.396418 / 0.429), ("bodies-arch.json", None)):
            file = os.path.join(ROOT, "tests/corpus/bodies" if expected else "examples/grasps", name)
            with open(file, encoding="utf-8") as open_file:
                content = json.load(open_file)
            if expected is None:
                low, high = self.least(content, 0.2849 / float(F(str(content["defaults"]["friction"]))), 2e-4)
                self.assertEqual([self.kind(content, "--friction-factor", str(f)) for f in (low, high)], ["must move", "may stand"])
            else:
                self.least(content, expected)
        # Three stones of half a circle: 3 t (t + tan 30) = 1 - t tan 30.
        self.least(arch(3, F(2, 5), 1), (-2 / 3**.5 + (4 / 3 + 3)**.5) / 3, 1e-2)  # its stones are on rational places

    def test_what_stands_without_friction_and_what_always_moves(self):
        block = grasp("b", [contact("b", (s, 0), (0, 1), friction=1) for s in (-1, 1)], [weight("b", 1, (0, 1))])
        self.assertEqual(self.ask(block, "--least-friction")["least_friction"], {"low": "0", "high": "0"})
        self.assertEqual(self.kind(block, "--friction-factor", "0"), "may stand")
        tips = grasp("b", [contact("b", (s, 0), (0, 1), friction=1) for s in (-1, 1)], [weight("b", 1, (2, 1))])
        answer = self.ask(tips, "--least-friction")
        self.assertIsNone(answer["least_friction"])
        self.assertEqual(answer["class"], "must move")

    def test_borders_in_the_plane_are_exact(self):
        # A block on two feet: its weight may be anywhere between, with both ends.
        def block(x, slope=0):
            return grasp("b", [contact("b", (s, 0), (0, 1), friction=F(1, 2)) for s in (-1, 1)],
                         [force("b", (slope, -1), (x, 0))])
        tiny = F(1, 10**30)
        self.assertEqual([self.kind(block(x)) for x in (1, 1 + tiny, -1, -1 - tiny)], ["may stand", "must move"] * 2)
        self.assertEqual([self.kind(block(0, s)) for s in (F(1, 2), F(1, 2) + tiny)], ["may stand", "must move"])

    def test_multiples_of_a_load(self):
        block = grasp("b", [contact("b", (s, 0), (0, 1), friction=F(1, 3)) for s in (-1, 1)], [])
        self.assertEqual(self.multiples(block, "--wrench", "0,-6,0", "--direction", "1,0,0"), (["-2", "2"], "-2", "2"))
        self.assertEqual(self.multiples(block, "--direction", "0,-1,0"), (["0", None], "0", None))
        self.assertEqual(self.multiples(block, "--wrench", "1,0,0", "--direction", "0,1,0"), ([None, "-3"], None, "-3"))
        none = self.ask(block, "--wrench", "0,1,0", "--direction", "1,0,0")["multiples"]
        self.assertEqual((none["stand"], none["always_moves"]), (None, True))
        # In space it is enclosed: four feet and a pull along any direction.
        feet = grasp("b", [contact("b", (x, y, 0), (0, 0, 1), friction=F(1, 3)) for x in (-1, 1) for y in (-1, 1)], [])
        (low, high), below, above = self.multiples(feet, "--wrench", "0,0,-6,0,0,0", "--direction", "3/5,4/5,0,0,0,0")
        self.assertLessEqual(F(high), 2)
        self.assertGreaterEqual(F(above), 2)
        self.assertLess(F(above) - F(high), F(1, 250))
        self.assertLess(F(low) - F(below), F(1, 250))

    def test_places_of_a_weight(self):
        # Of three legs on level ground exactly the triangle; of feet on slopes more or less than their hull.
        legs = [(2, 0), (-1, 1), (-1, -1)]
        tripod = grasp("b", [contact("b", (*p, 0), (0, 0, 1), friction=F(1, 2)) for p in legs], [])
        found = self.ask(tripod, "--place", "0,0,-3", "--body", "b")
        places = [[F(x) / F(point["point"][0]) for x in point["point"][1:]] for point in found["stand"]]
        for leg in legs:
            self.assertLess(min(math.dist(leg, place) for place in places), 2e-2, leg)
        self.assertTrue(found["complete"])
        for name, end in (("plane", 2),):
            ledge = grasp("b", [contact("b", (s * 2, 0), (0, 1), friction=F(1, 2)) for s in (-1, 1)], [])
            found = self.ask(ledge, "--place", "0,-1", "--body", "b")["multiples"]
            self.assertEqual(found["stand"], [str(-end), str(end)])

    def test_a_plane_of_loads_is_a_cone_of_friction(self):
        # One contact: (s, t) with |s| <= -t/2, and two directions without an end.
        foot = grasp("b", [contact("b", (0, 0), (0, 1), friction=F(1, 2))], [])
        found = self.ask(foot, "--u", "1,0,0", "--v", "0,1,0")
        self.assertTrue(found["exact"] and found["complete"])
        rays = {tuple(F(x) / abs(F(p["point"][2])) for x in p["point"][1:])
                for p in found["stand"] if p["point"][0] == "0"}
        self.assertLessEqual({(F(1, 2), F(-1)), (F(-1, 2), F(-1))}, rays)

    def test_joints_hold_where_they_are_stiff(self):
        def arm(**joint):
            return grasp([{"name": "arm", "hinge": [0, 0]}], [], [force("arm", (0, -3), (2, 0))], joints=[{"turns": {"arm": 1}, **joint}])
        self.assertEqual([self.kind(arm(**j)) for j in ({}, {"stiffness": "1/9"}, {"torque": 6}, {"torque": "6.001"})],
                         ["must move", "may stand", "may stand", "must move"])
        # Two fingers on a tendon press a disc; the stiff tendon bears any pull.
        links = [{"name": n, "hinge": [s * 2, -2]} for n, s in (("l", -1), ("r", 1))]
        def disc(mu, **tendon):
            return grasp(["disc", *links], [contact("disc", (-s, 0), (s, 0), by=n, friction=mu) for n, s in (("l", 1), ("r", -1))],
                         [weight("disc", 1, (0, 0))], joints=[{"turns": {"l": -1, "r": 1}}],
                         tendons=[{"over": {"l": -1, "r": 1}, **tendon}])
        self.assertEqual(self.kind(disc(F(1, 3), tension=5)), "may stand")
        self.assertEqual(self.kind(disc(F(1, 10**6), tension=5)), "must move")
        self.assertEqual(self.kind(disc(F(1, 10**6), stiffness=1)), "may stand")

    def test_torsion(self):
        # A moment of mu a e about the normal beside a force: |f|^2 + (t/e)^2 <= (mu a)^2.
        def pad(f, t, e=2):
            return grasp("b", [contact("b", (0, 0, 0), (0, 0, 2), friction=F(1, 2), torsion=e)],
                         [force("b", (f, 0, -10), (0, 0, 0)), {"body": "b", "torque": text([0, 0, t])}])
        self.assertEqual([self.kind(pad(*w)) for w in ((3, F(799, 100)), (3, F(801, 100)), (0, F(999, 100)), (0, F(1001, 100)))],
                         ["may stand", "must move"] * 2)

    def test_no_length_of_a_normal_is_needed(self):
        block = grasp("b", [contact("b", (s, 0), (s * 1, 3), friction=1, preload=2) for s in (-1, 1)], [weight("b", 1, (0, 1))])
        self.assertEqual(self.kind(block), "may stand")


class Limits(Statics):
    def test_a_beam_on_two_feet(self):
        # Feet 1 to either side bear 8 each, and 10 at x presses them with 5 (1 -+ x).
        def beam(**limit):
            return grasp("b", [contact("b", (s, 0), (0, 5), friction=F(1, 2), **limit) for s in (-1, 1)], [])
        place = ("--wrench", "0,0,0", "--place", "0,-10", "--body", "b")
        self.assertEqual(self.multiples(beam(max_force=8), *place), (["-3/5", "3/5"], "-3/5", "3/5"))
        self.assertEqual(self.multiples(beam(max_force=8), "--direction", "0,-1,0"), (["0", "16"], "0", "16"))
        self.assertEqual(self.multiples(beam(), *place)[0], ["-1", "1"])
        self.assertEqual(self.multiples(beam(max_force=0), "--direction", "0,-1,0"), (["0", "0"], "0", "0"))
        # No load is without an end: (s, t) with |s| <= -t/2 and -t <= 16.
        found = self.ask(beam(max_force=8), "--u", "1,0,0", "--v", "0,1,0")
        self.assertTrue(found["exact"] and all(point["point"][0] != "0" for point in found["stand"]))
        self.assertEqual(min(F(p["point"][2]) / F(p["point"][0]) for p in found["stand"]), -16)

    def test_two_fingers(self):
        # Two that press with 5 at most hold 2 mu 5, whatever the lengths of the normals.
        n = (F(3, 7), F(4, 7), 0)
        def pinch(*loads):
            return grasp("b", [contact("b", (-s * F(3, 5), -s * F(4, 5), 0), (s * n[0], s * n[1], 0), friction=F(1, 2), max_force=5)
                               for s in (1, -1)], list(loads))
        (low, high), below, above = self.multiples(pinch(), "--direction", "0,0,-1,0,0,0")
        for inside, outside in ((-F(low), -F(below)), (F(high), F(above))):
            self.assertLessEqual(inside, 5)
            self.assertGreaterEqual(outside, 5)
            self.assertLess(outside - inside, F(1, 100))
        self.least(pinch(weight("b", 4, (0, 0, 0))), 0.8)
        self.assertEqual(self.kind(pinch(weight("b", 6, (0, 0, 0)))), "must move")

    def test_motors(self):
        # 6 at the joint of an arm of 2 carry 3 either way, whatever its stiffness and torque are.
        for joint in ({}, {"stiffness": 2}, {"torque": 1}):
            arm = grasp([{"name": "arm", "hinge": [0, 0]}], [], [force("arm", (0, -3), (2, 0))],
                        joints=[{"turns": {"arm": 1}, "max_torque": 6, **joint}])
            self.assertEqual(self.multiples(arm, "--direction", "-2"), (["-3", "3"], "-3", "3"))
            self.assertEqual(self.kind(arm), "may stand")
        # Two joints in a row, of which the second is locked: the first bears both levers.
        links = [{"name": "upper", "hinge": [0, 0]}, {"name": "fore", "on": "upper", "hinge": [2, 0]}]
        arm = grasp(links, [], [force("fore", (0, -1), (3, 0))],
                    joints=[{"turns": {"upper": 1}, "max_torque": 6}, {"turns": {"fore": 1}, "stiffness": 1}])
        self.assertEqual(self.multiples(arm, "--wrench", "0,0", "--direction", "-3,-1"), (["-2", "2"], "-2", "2"))

    def test_numbers_of_limits_are_judged(self):
        beam = grasp("b", [contact("b", (s, 0), (0, 1), friction=F(1, 2), max_force=8) for s in (-1, 1)], [weight("b", 17, (0, 1))])
        arm = grasp([{"name": "arm", "hinge": [0, 0]}], [], [force("arm", (0, -4), (2, 0))],
                    joints=[{"turns": {"arm": 1}, "max_torque": 6}])
        for content, dimension in ((beam, 3), (arm, 1)):
            file, proof = self.write("g.json", content), self.path("c.json")
            self.assertEqual(stickslip("statics", file, "--certificate", proof)[0], DONE)
            with open(proof, encoding="utf-8") as text_of_proof:
                right = json.load(text_of_proof)
            self.assertGreater(len(right["twist"]), dimension)
            for change in (lambda q: 0, lambda q: -1, lambda q: 10 * q):  # opposed, below 0, and too much taken up
                wrong = {**right, "twist": [str(x) if j < dimension else str(change(F(x))) for j, x in enumerate(right["twist"])]}
                for checker in checkers(proof)[:2]:
                    code, out, err = run(*checker, file, self.write("wrong.json", wrong), "--statics", "1")
                    self.assertEqual(code, 1, (out, err))
                    self.assertIn("rule   static-motion", out)

    def test_all_else_refuses_them(self):
        beam = grasp("b", [contact("b", (s, 0), (0, 1), friction=F(1, 2), max_force=8) for s in (-1, 1)], [weight("b", 10, (0, 1))])
        arm = grasp([{"name": "arm", "hinge": [0, 0]}], [], [force("arm", (0, -4), (2, 0))],
                    joints=[{"turns": {"arm": 1}, "max_torque": 6}])
        for content, place in ((beam, "contacts[0].max_force"), (arm, "joints[0].max_torque")):
            file = self.write("g.json", content)
            for command in ("decide", "compare", "states", "radius", "quality"):
                words = ("--uncertain", "wrench=1%") if command == "radius" else ()
                code, out, err = stickslip(command, file, *words)
                self.assertEqual((code, out), (2, ""), (command, err))
                self.assertIn(place, err)
                self.assertIn("statics", err)
            for checker in checkers(file)[:2]:
                code, out, err = run(*checker, file, file)
                self.assertEqual(code, 2, (out, err))
                self.assertIn(place, out + err)
        slanted = grasp("b", [contact("b", (0, 0), (1, 2), friction=1, max_force=1)], [])
        older = {"format": "stickslip-grasp/2", "wrench": [0, 0, 0],
                 "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": 1, "max_force": 1}]}
        for content, said in ((slanted, "rational length"), (older, "stickslip-grasp/3")):
            file = self.write("g.json", content)
            for words in (("statics", file), ):
                code, out, err = stickslip(*words)
                self.assertEqual((code, out), (2, ""), err)
                self.assertIn(said, err)
            for checker in checkers(file)[:2]:
                self.assertEqual(run(*checker, file, file, "--statics", "1")[0], 2)


class Random(Statics):
    def test_assemblies_beside_the_passive_verdict(self):
        rng = random.Random(7)
        kinds = {}
        for k in range(120):
            content = random_assembly(rng, 2 + k % 2)
            kind = self.kind(content)
            passive = json.loads(stickslip("decide", self.write("p.json", content), "--json", "--node-limit", "2000", "--no-warnings")[1])["verdict"]
            if passive == "stable":
                self.assertEqual(kind, "may stand", json.dumps(content))
            if kind == "must move":
                self.assertIn(passive, ("unstable", "undecided"), json.dumps(content))
            kinds[kind] = kinds.get(kind, 0) + 1
        self.assertEqual(kinds.get(None, 0), 0)
        self.assertGreater(min(kinds["may stand"], kinds["must move"]), 15, kinds)

    def test_piles_beside_z3(self):
        self.compare_piles()

    def test_piles_with_limits_beside_z3(self):
        self.compare_piles(limits=True)

    def compare_piles(self, limits=False):
        rng = random.Random(8)
        kinds = []
        for _ in range(60):
            names = "abcd"[:rng.randint(2, 4)]
            contacts = []
            for name in names:
                for _ in range(rng.randint(2, 3)):
                    by = rng.choice([None, *(n for n in names if n < name)])
                    n = rng.choice(((0, 1), (0, 1), (F(3, 5), F(4, 5)), (-F(3, 5), F(4, 5)), (1, 0)) if limits else
                                   ((0, 1), (0, 1), (1, 2), (-1, 2), (1, 0)))
                    contacts.append(contact(name, (rng.randint(-3, 3), rng.randint(-3, 3)), n, by=by, friction=rng.choice((0, F(1, 3), 1))))
                    if limits and rng.random() < 0.5:
                        contacts[-1]["max_force"] = rng.choice((3, 8, 20, "7/2"))
            content = grasp(names, contacts, [weight(n, rng.randint(1, 3), (rng.randint(-2, 2), 1)) for n in names])
            stands = run(Z3, "-in", stdin=smt(content))[1].strip()
            kinds.append(self.kind(content))
            self.assertEqual(kinds[-1], {"sat": "may stand", "unsat": "must move"}[stands], json.dumps(content))
        self.assertGreater(min(kinds.count("may stand"), kinds.count("must move")), 3)


def wall(courses, columns, mu, lean):
    """Bricks of 2 by 1, one on the other and side by side, each with the weight 1 and a push of `lean` to the right."""
    contacts, loads = [], []
    for c in range(courses):
        for k in range(columns):
            name, x, y = f"b{c}.{k}", 2 * k, c
            contacts += [contact(name, (at, y), (0, 1), by=f"b{c - 1}.{k}" if c else None, friction=mu) for at in (x, x + 2)]
            if k:
                contacts += [contact(name, (x, at), (1, 0), by=f"b{c}.{k - 1}", friction=mu) for at in (y, y + 1)]
            loads += [weight(name, 1, (x + 1, y)), force(name, (lean, 0), (x + 1, F(2 * y + 1, 2)))]
    return grasp([f"b{c}.{k}" for c in range(courses) for k in range(columns)], contacts, loads)


def running_bond(courses, columns, push, seed):
    """Bricks of 2 by 1 with joints above middles, all pushed to the right. Of every other course the last brick stands on its half."""
    rng, contacts, loads = random.Random(seed), [], []

    def touch(name, position, normal, by):
        contacts.append(contact(name, position, normal, by=by, friction=F(7, 10), stiffness=F(rng.randint(50, 200), 100)))

    for c in range(courses):
        for k in range(columns):
            name, x = f"b{c}.{k}", 2 * k + c % 2
            if k:
                for y in (c, c + 1):
                    touch(name, (x, y), (1, 0), f"b{c}.{k - 1}")
            below = [(f"b{c - 1}.{l}", 2 * l + (c - 1) % 2) for l in range(columns)] if c else [(None, x)]
            for by, left in below:
                for at in sorted({max(x, left), min(x, left) + 2}) if abs(x - left) < 2 else ():
                    touch(name, (at, c), (0, 1), by)
            heavy = F(rng.randint(90, 110), 100)
            loads += [weight(name, heavy, (x + 1, c)), force(name, (push * heavy, 0), (x + 1, F(2 * c + 1, 2)))]
    return grasp([f"b{c}.{k}" for c in range(courses) for k in range(columns)], contacts, loads)


class Size(Statics):
    def test_a_wall_of_many_bricks(self):
        # All weights and pushes are alike, so that friction has to be the lean at every course.
        lean = F(1, 9)
        content = wall(8, 8, 1, lean)
        self.least(content, float(lean), 1e-5)
        self.assertEqual(self.kind(content), "may stand")
        self.assertEqual(self.kind(content, "--friction-factor", "0.11"), "must move")

    def decided(self, content, verdict):
        """Checks the verdict, whose proof the checkers accept, and not with a number changed."""
        file, proof = self.write("w.json", content), self.path("w.certificate.json")
        code, out, err = stickslip("decide", file, "--json", "--certificate", proof)
        self.assertEqual((code, json.loads(out)["verdict"]), (DONE, verdict), err)
        with open(proof, encoding="utf-8") as file_of_proof:
            wrong = json.load(file_of_proof)
        if verdict == "stable":
            wrong["twist"][1] = str(F(wrong["twist"][1]) + 1)
        else:
            wrong["tree"][0][1:] = [str(-F(y)) for y in wrong["tree"][0][1:]]
        for checker in checkers(proof)[:2]:  # stickslip-proved judges 30 coordinates at most
            code, out, err = run(*checker, file, proof)
            self.assertEqual(code, 0, (out, err))
            code, out, err = run(*checker, file, self.write("wrong.json", wrong))
            self.assertEqual(code, 1, (out, err))
            self.assertIn("rule   witness-" if verdict == "stable" else "rule   static-motion", out)

    def test_verdicts_of_more_coordinates_than_are_searched(self):
        # 16 bricks, 48 coordinates; and a tower of 11, in which friction carries the lean.
        self.decided(wall(4, 4, 1, 0), "stable")
        self.decided(wall(11, 1, F(1, 20), F(99, 2000)), "stable")
        self.decided(wall(11, 1, F(1, 20), F(101, 2000)), "unstable")

    def test_verdicts_on_both_sides_of_a_border(self):
        # Twenty stones, 60 coordinates, that are pushed aside: they hold by statics up to 0.28516 of their weight.
        for lean, verdict in ((F(71, 250), "stable"), (F(143, 500), "unstable")):
            content = arch(20, F(1, 5), 1)
            content["loads"] += [force(load["body"], (lean, 0), tuple(map(F, load["at"]))) for load in content["loads"]]
            self.decided(content, verdict)

    def test_walls_in_running_bond(self):
        # On the way from smooth friction to sharp one the equilibrium is on a curve that turns back.
        for seed in range(4):
            self.decided(running_bond(4, 4, 0, seed), "stable")
        # Forces could balance this push. Whether such forces arise nobody proves; in doubles the last bricks turn over.
        file = self.write("w.json", running_bond(4, 4, F(3, 10), 0))
        self.assertEqual(self.kind(running_bond(4, 4, F(3, 10), 0)), "may stand")
        answer = json.loads(stickslip("decide", file, "--json")[1])
        self.assertEqual((answer["verdict"], answer["reason"]), ("undecided", "size"))
        self.assertIn("drift away", answer["limit"])

    def test_margins_have_no_more_coordinates_than_are_searched(self):
        code, out, err = stickslip("margin", self.write("w.json", wall(4, 4, 1, 0)), "--direction", ",".join(["1"] * 48))
        self.assertEqual((code, out), (2, ""))
        self.assertIn("48 coordinates", err)
        self.assertIn("at most 30", err)
        self.assertIn("statics", err)


class Refusals(Statics):
    def test_what_cannot_be_asked(self):
        block = grasp("b", [contact("b", (s, 0), (0, 1), friction=1) for s in (-1, 1)], [weight("b", 1, (0, 1))])
        file = self.write("g.json", block)
        uncertain = self.write("u.json", {**block, "contacts": [{**block["contacts"][0], "friction": {"min": 0, "max": 1}}]})
        for words, said in (((file, "--friction-factor=-1"), "--friction-factor"), ((file, "--direction", "0,0,0"), "direction"),
                            ((file, "--u", "1,0,0", "--v", "2,0,0"), "multiples"), ((file, "--place", "1"), "place"),
                            ((file, "--place", "0,-1", "--body", "c"), "there is no body"), ((uncertain,), "uncertain"),
                            ((file, "--direction", "1,0"), "2 numbers"), ((file, "--accuracy", "0", "--least-friction"), "--accuracy")):
            code, out, err = stickslip("statics", *words)
            self.assertEqual((code, out), (2, ""), words)
            self.assertIn(said, err)


if __name__ == "__main__":
    unittest.main()
