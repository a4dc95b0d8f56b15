# SPDX-License-Identifier: MIT
"""Stable at rest (certificate/FORMAT.md, section 6): proofs of a producer, bounds that are as tight as they are
said to be, and what an accepted proof says of single grasps.
"""

import copy
import itertools
import json
import os
import random
import tempfile
import unittest
from fractions import Fraction

from at_rest import Grasp, proof_at_rest
from support import Case, certificate, check, interval, posed, stable, start
from test_space import TURN, space_file

STICKSLIP = os.environ.get("STICKSLIP")

# Three fingers around a cup, as typed: normals of irrational length. Friction holds up to 30 N of its weight.
FINGERS = [{"position": p, "normal": n, "friction": "0.5", "preload": 20} for p, n in (
    (["0.04", 0, "0.05"], [-1, 0, 0]),
    (["-0.02", "0.0346410", "0.05"], ["0.5", "-0.8660254", 0]),
    (["-0.02", "-0.0346410", "0.05"], ["0.5", "0.8660254", 0]))]
CUP = space_file(*FINGERS, wrench=[0, 0, -6, 0, 0, 0])
CUP_BOX = ("--uncertain", "friction=5%,position=0.0001")
CUP_SAID = {"friction": "5%", "position": "1/10000"}

# Four contacts around a plate; that with the normal (1, 2) presses with an irrational one.
PLATE = {"format": "stickslip-grasp/2", "wrench": ["0.3", interval("-0.5", "-0.4"), "0.1"], "contacts": [
    {"position": [1, 0], "normal": {"direction": [-2, 0], "slope": "0.01"}, "friction": "0.6", "preload": 3},
    {"position": [0, interval("0.99", "1.01")], "normal": [0, -1], "friction": "0.6", "preload": 3},
    {"position": [-1, 0], "normal": {"direction": [1, 0], "slope": "0.02"}, "friction": interval("0.5", "0.6"),
     "preload": interval("2.99", "3.01"), "stiffness": interval(1, 2)},
    {"position": ["-0.1", "-0.2"], "normal": [1, 2], "friction": "0.5", "preload": 1},
    {"position": [0, -1], "normal": [0, 3], "friction": "0.4", "preload": 2}]}


def stated(wrench):
    """In the member `question`."""
    return [[str(w.low), str(w.high)] if not w.certain else str(w.low) for w in wrench]


def proved(file, proof, *options, **question):
    return stable(len(file["contacts"]), stated(posed(file).wrench), [proof], **question)


def changed(proof, place, value):
    """`place` is a path of keys."""
    proof = copy.deepcopy(proof)
    at = proof
    for key in place[:-1]:
        at = at[key]
    at[place[-1]] = value
    return proof


def doubled(force, factor):
    if isinstance(force, list):
        return [str(Fraction(c) * factor) for c in force]
    return str(Fraction(force) * factor)


class RestTest(Case):
    def proof_of(self, file, *options, **more):
        proof = proof_at_rest(posed(file, *options), **more)
        grasp = Grasp(posed(file, *options))
        self.assertGreater(grasp.room(proof, more.get("multiples", (0,))), 0.01)
        return proof

    def test_three_fingers(self):
        for options, said in (((), {}), (CUP_BOX, {"uncertain": CUP_SAID})):
            proof = self.proof_of(CUP, *options)
            text = self.accepts(CUP, proved(CUP, proof, **said), *options)
            self.assertIn("verdict     stable, for every grasp in the box\n", text)
            self.assertIn("proof       at rest, parts: 1\n", text)
            bilateral = proved(CUP, proof, law="bilateral", **said)
            self.accepts(CUP, bilateral, "--normal-law", "bilateral", *options)
        _, report, _, _ = self.run_both(CUP, proved(CUP, self.proof_of(CUP)))
        self.assertEqual((report["nodes"], report["leaves"], report["box"]), (0, 0, True))

    def test_plate(self):
        proof = self.proof_of(PLATE)
        self.accepts(PLATE, proved(PLATE, proof))
        # A contact that is not listed presses all the same.
        self.accepts(PLATE, proved(PLATE, self.proof_of(PLATE, bearing=[0, 1, 2, 4])))
        tolerances = ("--uncertain", "normal=0.001,wrench=1%")
        wider = proof_at_rest(posed(PLATE, *tolerances))
        asked = proved(PLATE, wider, uncertain={"normal": "1/1000", "wrench": "1%"})
        self.accepts(PLATE, asked, *tolerances)
        # For normals that are turned more this proof says too little.
        asked["parts"] = [proof]
        self.rejects("rest-reach", PLATE, proved(PLATE, {**proof, "reach": [str(z) for z in Grasp(
            posed(PLATE)).needed(proof)]}, uncertain={"normal": "1/1000", "wrench": "1%"}), *tolerances,
            path="part 0")

    def test_margin(self):
        """From 0 to 20 N of weight, of a grasp whose normals have no rational lengths."""
        down = [0, 0, -1, 0, 0, 0]
        options = ("--direction", "0,0,-1,0,0,0")
        proof = self.proof_of(CUP, *options, multiples=(0, 10))
        asked = certificate(3, [0] * 6, direction=down, intervals=[["stable", 0, 10, proof]])
        text = self.accepts(CUP, asked, *options)
        self.assertIn("\nresisted    [0, 10]\n", text)
        self.assertIn("proof       intervals by degree: 0, at rest: 1, refuted: 0; trees of 0 nodes", text)
        # What is left is largest at both ends: neither may be further away, if Z is as it is needed.
        grasp = Grasp(posed(CUP, *options))
        tight = dict(proof)
        for _ in range(4):
            tight["reach"] = [str(z) for z in grasp.needed(tight, (2, 8))]
        tight["reach"] = [str(Fraction(z) + Fraction(1, 1000)) for z in tight["reach"]]
        for ends, rule in (((2, 8), None), ((3, 5), None), (("19/10", 8), "rest-reach"),
                           ((2, "81/10"), "rest-reach")):
            found = {**asked, "intervals": [["stable", *ends, tight]]}
            if rule:
                self.rejects(rule, CUP, found, *options, path="interval 0")
            else:
                self.accepts(CUP, found, *options)
        # Preloads grow: the cones of the high end are larger, so the low end decides.
        grown = ("--direction", "0,0,-1,0,0,0", "--preload-direction", "10,10,10", "--wrench", "0,0,-6,0,0,0")
        proof = self.proof_of(CUP, *grown, multiples=(0, 8))
        asked = certificate(3, [0, 0, -6, 0, 0, 0], direction=down, preload_direction=[10, 10, 10],
                            intervals=[["stable", 0, 8, proof]])
        self.accepts(CUP, asked, *grown)

    def test_the_bounds_themselves(self):
        """Z is enough as it is needed, and not one ulp below; so are cones."""
        for file, options, said in ((CUP, CUP_BOX, {"uncertain": CUP_SAID}), (PLATE, (), {})):
            grasp = Grasp(posed(file, *options))
            proof = self.proof_of(file, *options)
            proof["answers"] = [[i, [doubled(f, 1) for f in fs]] for i, fs in proof["answers"]]
            for k in range(grasp.size):
                exact = changed(proof, ["reach", k], "0")
                # Z_k (1 - max |M_kk - 1|) = what the others ask for.
                without = grasp.needed(exact)[k]
                slope = grasp.needed(changed(proof, ["reach", k], "1"))[k] - without
                least = without / (1 - slope)
                self.accepts(file, proved(file, changed(proof, ["reach", k], str(least)), **said), *options)
                below = str(least * (1 - Fraction(1, 1 << 60)))
                self.rejects("rest-reach", file, proved(file, changed(proof, ["reach", k], below), **said), *options,
                             path="part 0")

    def test_syntax(self):
        for file, proof in ((CUP, proof_at_rest(posed(CUP))), (PLATE, proof_at_rest(posed(PLATE)))):
            space = file is CUP
            force = [0, 0, 0] if space else 0
            other = 0 if space else [0]
            size = 6 if space else 3
            for mutant in (
                    {"answers": proof["answers"], "rest": proof["rest"], "reach": proof["reach"]},
                    {"rest": proof["rest"], "answers": proof["answers"]},
                    {"rest": proof["rest"], "reach": proof["reach"]},
                    {**proof, "tree": []}, {"twist": [0] * size, **proof}, {**proof, "rest": {}},
                    {**proof, "rest": None}, {**proof, "reach": [0] * (9 - size)}, {**proof, "reach": 1},
                    {**proof, "reach": [*proof["reach"][1:], 0.5]}, {**proof, "rest": [[0, other]]},
                    {**proof, "rest": [[-1, force]]}, {**proof, "rest": [["0", force]]},
                    {**proof, "rest": [[0, force, force]]}, {**proof, "answers": [[0, force]]},
                    {**proof, "answers": [[0, [force] * (size - 1)]]}, {**proof, "answers": [[0, [other] * size]]},
                    {**proof, "answers": [[0, [force] * (size + 1)]]}):
                code, report, _, _ = self.run_both(file, proved(file, mutant))
                self.assertEqual(code, 2, mutant)
        margin = certificate(3, [0] * 6, direction=TURN, intervals=[["stable", 0, 1, {"rest": [], "answers": []}]])
        self.assertEqual(self.run_both(CUP, margin, "--direction", "0,0,0,0,0,1")[0], 2)


class TruthTest(Case):
    """What is accepted at rest is so: at points of the box the checkers accept an equilibrium at rest,
    and the program does not find the grasp unstable."""

    def random_file(self, random_):
        """A box or a grasp, with normals of rational length."""
        def number(low, high, unit=8):
            return Fraction(random_.randint(low * unit, high * unit), unit)

        def perhaps(x, off):
            return str(x) if random_.random() < 0.9 else interval(str(x - off), str(x + off))

        space = random_.random() < 0.5
        normals = ([[1, 0, 0], [0, 2, 0], [0, 0, 1], [1, 2, 2], [2, -1, 2]] if space else [[1, 0], [0, 2], [3, 4]])
        contacts = []
        for n, side in itertools.product(random_.sample(normals, 3 if space else 2), (1, -1)):
            across = [random_.randint(-1, 1) for _ in n]
            p = [-side * Fraction(a) / 2 + Fraction(b, 8) for a, b in zip(n, across)]
            contacts.append({"position": [perhaps(c, Fraction(1, 1000)) for c in p], "normal": [side * c for c in n],
                             "friction": perhaps(number(0, 1) + Fraction(1, 4), Fraction(1, 20)),
                             "preload": perhaps(1 + number(0, 1), Fraction(1, 100))})
        load = random_.choice([Fraction(1, 16), Fraction(1, 16), Fraction(1, 2)])
        wrench = [perhaps(number(-1, 1) * load / 2, Fraction(1, 100)) for _ in range(6 if space else 3)]
        return {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": wrench}

    def point(self, file, values):
        """The grasp at a point of its box."""
        file = copy.deepcopy(file)
        for (i, name), value in values.items():
            if name == "wrench":
                file["wrench"][i] = str(value)
            elif name in ("x", "y", "z"):
                file["contacts"][i]["position"]["xyz".index(name)] = str(value)
            elif name == "preload":
                n = list(map(Fraction, file["contacts"][i]["normal"]))
                file["contacts"][i]["preload"] = str(value * check.rational_root(check.dot(n, n)))
            else:
                file["contacts"][i][name] = str(value)
        return file

    def test_points_of_the_box(self):
        random_ = random.Random(20)
        tally = {"accepted": 0, "rest-cone": 0, "points": 0, "rest-reach": 0, "boxes": 0, "decided": 0}
        for trial in range(60):
            file = self.random_file(random_)
            question = posed(file)
            grasp = Grasp(question)
            if len(grasp.uncertain) > 8:
                continue
            try:
                proof = proof_at_rest(question)
            except ZeroDivisionError:
                continue  # friction does not reach all wrenches
            if random_.random() < 0.2:
                proof["reach"] = [str(Fraction(z) / 3) for z in proof["reach"]]
            needed = grasp.needed(proof, together=len(grasp.uncertain) <= 5)
            reached = all(a <= Fraction(z) for a, z in zip(needed, proof["reach"]))
            room = grasp.room(proof)
            if abs(room) < 1e-9:
                continue
            report = self.run_both(file, proved(file, proof))[1]
            expected = "rest-reach" if not reached else "rest-cone" if room < 0 else None
            self.assertEqual(report["rule"], expected, file)
            tally[expected or "accepted"] += 1
            if expected:
                continue
            tally["boxes"] += question.is_box
            corners = list(grasp.corners())
            for values in [grasp.middle(), *random_.sample(corners, min(len(corners), 2))]:
                here = self.point(file, values)
                witness = certificate(len(file["contacts"]), here["wrench"], twist=[0] * grasp.size,
                                      shares=grasp.shares(proof, values))
                witness["question"]["wrench"] = [str(Fraction(w)) for w in here["wrench"]]
                self.accepts(here, witness)
                tally["points"] += 1
            if STICKSLIP and tally["decided"] < 12:
                self.decide(here, "stable")
                tally["decided"] += 1
        self.assertTrue(all(count > 5 for name, count in tally.items() if STICKSLIP or name != "decided"), tally)

    def decide(self, file, *verdicts):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "g.json")
            with open(path, "w", encoding="utf-8") as stream:
                json.dump(file, stream)
            _, out, err = start([STICKSLIP], ["decide", path, "--json"])
        self.assertIn(json.loads(out)["verdict"], verdicts, (out, err))

    @unittest.skipUnless(STICKSLIP, "needs the program")
    def test_fingers(self):
        """Whose normals have no rational length, so that no witness says so."""
        corners = Grasp(posed(CUP, *CUP_BOX)).corners()
        for values in itertools.islice(corners, 0, 4096, 999):
            values = {key: value for key, value in values.items() if key[1] != "preload"}
            self.decide(self.point(CUP, values), "stable", "undecided")


if __name__ == "__main__":
    unittest.main()
