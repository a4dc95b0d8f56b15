# SPDX-License-Identifier: MIT
"""Stable by sticking contacts (certificate/FORMAT.md, section 6): proofs of a producer, what all checkers say of them when they
are changed at random, and whether what is accepted is so.
"""

import copy
import json
import os
import random
import tempfile
import unittest
from fractions import Fraction

from sticking import sticking_proof
from support import Case, certificate, check, interval, posed, start
from test_rest import CUP, CUP_BOX, CUP_SAID, proved
from test_space import space_file

STICKSLIP = os.environ.get("STICKSLIP")

# Two jaws in a frame that is turned by an angle with the tangent 3/4; what they press with differs by the last digit of a double.
JAWS = {"format": "stickslip-grasp/2", "wrench": [0, 0, 0], "contacts": [
    {"position": ["-4/5", "-3/5"], "normal": ["4/5", "3/5"], "friction": "0.5", "preload": 1},
    {"position": ["4/5", "3/5"], "normal": ["-4/5", "-3/5"], "friction": interval("0.4", "0.5"),
     "preload": f"{2 ** 52 + 1}/{2 ** 52}"}]}
# Two soft pads hold a block, which a third body presses that a spring of a tendon pulls along.
PADS = {"format": "stickslip-grasp/3", "bodies": [{"name": "block"}, {"name": "slider", "slide": [1, 2, 2]}],
        "joints": [{"turns": {"slider": 1}, "stiffness": 2, "torque": "0.6"}],
        "tendons": [{"over": {"slider": "1/3"}, "stiffness": 0, "tension": "0.1"}],
        "contacts": [
            {"of": "block", "position": [-1, 0, 0], "normal": [2, 0, 0], "friction": "0.5", "preload": 2, "torsion": "0.3"},
            {"of": "block", "position": [1, 0, 0], "normal": [-1, 0, 0], "friction": "0.5", "preload": "2.0001", "torsion": "0.3"},
            {"of": "block", "by": "slider", "position": [0, "0.1", -1], "normal": [0, 0, 1], "friction": "0.5",
             "preload": "0.3"}],
        "loads": [{"body": "block", "force": [0, 0, "-0.3"], "at": [0, 0, 0]}]}
HELD = space_file({"position": [-1, -1, 0], "normal": [1, 1, 0], "friction": "0.5", "preload": 1},
                  {"position": [1, 0, 0], "normal": [-1, 0, 0], "friction": "0.5", "preload": "0.7"},
                  {"position": [0, 1, "0.1"], "normal": [0, -1, 0], "friction": "0.5", "preload": "0.7"}, wrench=[0, 0, 0, 0, 0, 0])
PULLED = ("--direction", "0,1/64,0,0,0,1/64", "--preload-direction", "1/64,0,1/64")


def claims(*intervals):
    return certificate(3, [0] * 6, direction=[0, "1/64", 0, 0, 0, "1/64"], preload_direction=["1/64", 0, "1/64"],
                       intervals=[["stable", *one] for one in intervals])


def known():
    """Grasps, options and certificates that are accepted."""
    yield JAWS, (), proved(JAWS, sticking_proof(posed(JAWS)))
    yield JAWS, ("--normal-law", "bilateral"), proved(JAWS, sticking_proof(posed(JAWS)), law="bilateral")
    # Each jaw gives way by 1/10; and where the motion slips by so much more, it may do too much.
    moved = {**JAWS, "wrench": ["4/25", "3/25", 0]}
    for slip in (Fraction(1, 2), Fraction(1, 1000)):
        twist = [Fraction(2, 25) - 3 * slip / 5, Fraction(3, 50) + 4 * slip / 5, 0]
        yield moved, (), proved(moved, sticking_proof(posed(moved), twist))
    bounded = proved(moved, sticking_proof(posed(moved), twist))
    bounded["question"]["max_motion"] = ["1/5", "1/5", "1/20"]
    yield moved, ("--max-motion", "1/5,1/20"), bounded
    cup = sticking_proof(posed(CUP, *CUP_BOX))
    yield CUP, CUP_BOX, proved(CUP, cup, uncertain=CUP_SAID)
    question = posed(PADS)
    yield PADS, (), {**certificate(5, [str(w.low) for w in question.wrench], parts=[sticking_proof(question)])}
    question = posed(HELD, *PULLED)
    yield HELD, PULLED, claims([0, 1, sticking_proof(question, multiples=(0, 1))],
                               [1, 1, sticking_proof(question, ["0.001", "-0.0005", 0, 0, 0, 0], multiples=(1,))])


def shaken(random_, part):
    """One of its numbers, indices or lists is changed, of each member as often."""
    member = random_.choice(sorted(part))
    return {**part, member: changed_in(random_, part[member])}


def changed_in(random_, value):
    places = []

    def visit(inside, key):
        one = inside[key]
        if isinstance(one, list):
            places.append((inside, key))
        for k in range(len(one)) if isinstance(one, list) else ():
            visit(one, k)
        if isinstance(one, str):
            places.extend([(inside, key)] * 3)

    root = {"": copy.deepcopy(value)}
    visit(root, "")
    if not places:
        return root[""]
    inside, key = random_.choice(places)
    one = inside[key]
    if isinstance(one, list):
        if one and isinstance(one[0], list):
            k = random_.randrange(len(one))
            random_.choice([lambda: one.pop(k), lambda: one.insert(k, copy.deepcopy(one[k])), lambda: one.reverse()])()
        elif one and isinstance(one[0], int):
            one[0] += random_.choice([-1, 1, 5])
    else:
        c = Fraction(one)
        inside[key] = str(random_.choice([-c, 0, 2 * c, c / 2, c * Fraction(9, 10), c * Fraction(11, 10), c / 64, 64 * c,
                                          c + Fraction(1, 8), c - Fraction(1, 8)] if c else [Fraction(1, 8), Fraction(-1, 2 ** 20)]))
    return root[""]


def random_grasp(random_):
    """In the plane, with small numbers, a motion, and friction at it that its load has to balance, more or less."""
    def number(low, high, unit=4):
        return Fraction(random_.randint(low * unit, high * unit), unit)

    normals = [(1, 0), (0, 1), (-1, 0), (0, -1), (3, 4), (-4, 3), (-3, -4), (4, -3), (0, 2), (-2, 0)]
    contacts = [{"position": [str(number(-1, 1, 2)), str(number(-1, 1, 2))], "normal": list(random_.choice(normals)),
                 "friction": str(number(0, 2)), "stiffness": str(number(1, 3, 2)), "preload": str(number(0, 2))}
                for _ in range(random_.randint(2, 4))]
    file = {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": [0, 0, 0]}
    twist = [random_.choice([0, 1, 1]) * number(-1, 1, 8) / random_.choice([1, 1, 4, 16, 64]) for _ in range(3)]
    if random_.random() < 0.3:
        twist = [0] * 3
    load, friction = [Fraction(0)] * 3, {}
    box = check.enlarged(posed(file), 128)
    for i, (c, term) in enumerate(zip(box.contacts, box.terms)):
        v = c.bounds["preload"].low - c.bounds["stiffness"].low * check.dot(term.N[0], twist)
        if v > 0:
            along = random_.choice([-1, 1, 1]) * number(0, 1, 64) * term.friction.low * v * Fraction(9, 8)
            load = [a - v * n - along * t for a, n, t in zip(load, term.N[0], term.rows[0][0])]
            friction[i] = (along,)
    off = random_.choice([0, Fraction(1, 1000), Fraction(1, 100), Fraction(1, 10)])
    file["wrench"] = [str(a + off * number(-1, 1)) for a in load]
    return file, twist, friction


class StickingTest(Case):
    def test_known(self):
        rules = []
        for file, options, content in known():
            report, text = self.run_both(file, content, *options)[1:3]
            rules.append(report["rule"])
            if report["rule"] is None:
                self.assertTrue("sticking, parts: 1\n" in text or ", sticking: 2, refuted: 0;" in text, text)
        self.assertEqual(rules, [None, None, "sticking-press", None, None, None, None, None])

    def test_changed(self):
        """All checkers say the same."""
        random_ = random.Random(61)
        tally = {}
        for file, options, content in known():
            for _ in range(50):
                other = copy.deepcopy(content)
                for _ in range(random_.choice([1, 1, 2])):
                    parts, key = (other["parts"], 0) if "parts" in other else (random_.choice(other["intervals"]), 3)
                    parts[key] = shaken(random_, parts[key])
                rule = self.run_both(file, other, *options)[1]["rule"]
                tally[rule] = tally.get(rule, 0) + 1
        self.assertLessEqual({"sticking-share", "sticking-motion", "sticking-reach", "sticking-press", "sticking-energy",
                              "sticking-bound", None},
                             set(tally), tally)

    def test_truth(self):
        """What is accepted is stable, also where load, motion, friction and energy were chosen at random."""
        random_ = random.Random(62)
        accepted = 0
        for _ in range(400):
            file, twist, friction = random_grasp(random_)
            bearing = random_.choice([None, random_.sample(sorted(friction), max(0, len(friction) - 1))])
            try:
                part = sticking_proof(posed(file), twist, rest=friction, bearing=bearing)
            except ZeroDivisionError:
                continue  # not all wrenches are answered
            part["energy"] = str(Fraction(part["energy"]) * random_.choice([Fraction(9, 16), 1, 4, 64]))
            report = self.run_both(file, proved({**file, "wrench": list(map(str, file["wrench"]))}, part))[1]
            if report["rule"] is None:
                accepted += 1
                if STICKSLIP and accepted <= 30:
                    self.assertEqual(self.verdict(file), "stable", (file, part))
        self.assertGreater(accepted, 30)

    def verdict(self, file):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "g.json")
            with open(path, "w", encoding="utf-8") as stream:
                json.dump(file, stream)
            return json.loads(start([STICKSLIP], ["decide", path, "--json"])[1])["verdict"]


if __name__ == "__main__":
    unittest.main()
