# SPDX-License-Identifier: MIT
"""Stable at rest (certificate/FORMAT.md, section 6): accepted proofs, every rule made to fail alone, proofs
that are false, and what an accepted proof says of single grasps. All checkers.
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
from support import Case, certificate, check, start
from test_space import CUBE, CUBE_PROOF, SLACK, TURN, TURNED, WALL_LEAVES, interval, space_file, stable

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


def posed(file, *options):
    """The question, as check.py reads it."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "g.json")
        with open(path, "w", encoding="utf-8") as stream:
            json.dump(file, stream)
        return check.pose(path, check.parse_arguments([path, "c", *options]).options)


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


def mutants(proof, m):
    """(what, proof, rule)"""
    reach = [Fraction(z) for z in proof["reach"]]
    first, last = proof["rest"][0][0], proof["rest"][-1][0]
    for name in ("rest", "answers"):
        for i, what in ((m, "none"), (10 ** 30, "far"), (first, "twice")):
            yield f"{name} {what}", changed(proof, [name, -1, 0], i), "rest-share"
        yield f"{name} order", {**proof, name: proof[name][::-1]}, "rest-share"
    for k, z in enumerate(reach):
        yield f"Z_{k + 1} below 0", changed(proof, ["reach", k], str(-z)), "rest-reach"
        yield f"Z_{k + 1} large", changed(proof, ["reach", k], str(1000 * z + 1000)), None
    yield "no friction", {**proof, "rest": [], "answers": []}, "rest-reach"
    yield "no answers", {**proof, "answers": []}, "rest-reach"
    yield "f twice", {**proof, "rest": [[i, doubled(f, 9)] for i, f in proof["rest"]]}, None
    twice = [[i, [doubled(f, 2) for f in forces]] for i, forces in proof["answers"]]
    yield "G twice", {**proof, "answers": twice}, "rest-reach"
    yield "one contact less", {**proof, "answers": proof["answers"][:-1]}, "rest-reach"
    assert first < last


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

    def test_ends_of_a_margin(self):
        """At rest without preloads that do not grow: [0, oo) by the proof for 1, and not from 1 on."""
        scale = ("--preload-direction", "scale", "--wrench", "0,0,0,0,0,0")
        proof = self.proof_of(CUP, *scale, multiples=(1,))
        asked = certificate(3, [0] * 6, preload_direction="scale", intervals=[["stable", 0, None, proof]])
        self.assertIn("\nresisted    [0, oo)\n", self.accepts(CUP, asked, *scale))
        self.rejects("interval-whole", CUP, {**asked, "intervals": [["stable", 1, None, proof]]}, *scale,
                     path="interval 0")
        # At the multiple 0 nothing presses: cones are empty there, whatever they are at 1.
        self.rejects("rest-cone", CUP, {**asked, "intervals": [["stable", 0, 1, proof]]}, *scale, path="interval 0")
        self.rejects("rest-cone", CUP, {**asked, "intervals": [["stable", 1, 1, proof], ["stable", 0, 0, proof]][1:]},
                     *scale, path="interval 0")
        # From 1/2 on what is left is smaller at the low end, and so are the cones.
        self.accepts(CUP, {**asked, "intervals": [["stable", "1/2", 1, proof]]}, *scale)
        wide = {**proof, "reach": [str(Fraction(z) + Fraction(1, 16)) for z in proof["reach"]]}
        self.accepts(CUP, {**asked, "intervals": [["stable", 1, 2, wide]]}, *scale)
        self.rejects("rest-cone", CUP, {**asked, "intervals": [["stable", "1/16", 1, wide]]}, *scale,
                     path="interval 0")

    def test_cut_in_two(self):
        """One half at rest, the other by degree."""
        file = space_file(*CUBE)
        options = ("--uncertain", "friction=10%,preload=1%,stiffness=5%,position=0.001,wrench=0.01")
        said = {"friction": "10%", "stiffness": "5%", "preload": "1%", "position": "1/1000", "wrench": "1/100"}
        proof = self.proof_of(file, *options)
        degree = {**CUBE_PROOF, "tree": WALL_LEAVES * 2}
        asked = stable(6, [0] * 6, [["part", "z", 4, -1], proof, degree], uncertain=said)
        text = self.accepts(file, asked, *options)
        self.assertIn("proof       at rest, parts: 1; by degree, parts: 1; trees of 24 nodes: 24 leaves\n", text)
        asked["parts"][1:] = asked["parts"][:0:-1]
        self.accepts(file, asked, *options)
        lame = changed(proof, ["reach", 3], 0)
        for parts, rule, path in (
                ([["part", "z", 4, -1], degree, lame], "rest-reach", "part 2, z 4 high"),
                ([["part", "z", 4, -1], lame, degree], "rest-reach", "part 1, z 4 low"),
                ([["part", "z", 4, -1], proof], "tree-short", "part 2, z 4 high"),
                ([proof, proof], "tree-long", "part 1")):
            self.rejects(rule, file, {**asked, "parts": parts}, *options, path=path)
        # A part knows less of its parameters: Z as it is needed in the low half is not enough for both.
        options, said = ("--uncertain", "wrench=0.01"), {"wrench": "1/100"}
        question = posed(file, *options)
        proof = proof_at_rest(question)
        low = Grasp(question)
        low.box, _ = low.box.halves(check.Node("part", 0, (Fraction(-1, 200),), "wrench"))
        # The four sides of the cube along x take what is left in its middle.
        below = {**proof, "rest": [[i, ["3/1600", 0, 0]] for i in range(2, 6)]}
        below["reach"] = [str(c) for c in low.needed({**below, "reach": below["reach"]})]
        parts = [["part", "wrench", 0, "-1/200"], below, proof]
        self.accepts(file, {**stable(6, [0] * 6, parts, uncertain=said)}, *options)
        self.rejects("rest-reach", file, stable(6, [0] * 6, [below], uncertain=said), *options, path="part 0")

    def test_rules(self):
        for file, options, said in ((CUP, CUP_BOX, {"uncertain": CUP_SAID}), (PLATE, (), {})):
            proof = self.proof_of(file, *options)
            m = len(file["contacts"])
            for what, mutant, rule in mutants(proof, m):
                code, report, _, _ = self.run_both(file, proved(file, mutant, **said), *options)
                self.assertEqual((code, report["node"], report["path"]), (1, None, "part 0"), what)
                self.assertIn(report["rule"], (rule,) if rule else ("rest-reach", "rest-cone"), what)
        # Along the normal, by however little, in f0 or G.
        proof = self.proof_of(CUP)
        for place in (["rest", 0, 1, 0], ["answers", 0, 1, 5, 0]):
            mutant = changed(proof, place, "1/1000000000000")
            self.rejects("rest-share", CUP, proved(CUP, mutant), path="part 0")

    def test_the_first_contact_and_rule_are_named(self):
        """Words are the checker's own, but rules come in their order."""
        proof = self.proof_of(CUP)
        bad = {**changed(proof, ["rest", 1, 0], 7), "reach": [0] * 6}
        self.rejects("rest-share", CUP, proved(CUP, bad), path="part 0")
        heavy = {**CUP, "wrench": [0, 0, -100, 0, 0, 0]}
        bad = proof_at_rest(posed(heavy))
        self.rejects("rest-cone", heavy, proved(heavy, bad), path="part 0")
        self.rejects("rest-reach", heavy, proved(heavy, {**bad, "reach": [0] * 6}), path="part 0")

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

    def test_cones_to_the_bound(self):
        """One contact that bears nothing but its own friction: 3 by 4 on a normal of length 5/3, and mu."""
        def asked(mu, force, preload=5, normal=(0, 0, "5/3")):
            one = {"position": [0, 0, 0], "normal": list(normal), "friction": mu, "preload": preload}
            wrench = [*(-Fraction(c) for c in force), -5, 0, 0, 0]
            if normal[0]:  # of the length sqrt(2)
                wrench = ["-3.5355339", "-3.5355339", str(-force[0]), 0, 0, 0]
            file = space_file(one, *CUBE, wrench=list(map(str, wrench)))
            proof = proof_at_rest(posed(file), range(1, 7))
            proof["rest"].insert(0, [0, [0, 0, str(force[0])] if normal[0] else [*force, 0]])
            for entry in proof["rest"][1:]:
                entry[1] = ["0"] * 3
            return file, proved(file, proof)

        # |f| = 5 = mu L P' with P' = 5/L.
        self.accepts(*asked(1, [3, 4]))
        file, proof = asked("0.999999999999", [3, 4])
        self.rejects("rest-cone", file, proof, path="part 0")
        # The least mu and P' count; nobody minds that the others hold 0.001 more or less.
        for found in (asked(interval("0.999", 1), [3, 4]), asked(1, [3, 4], interval("4.999", "5.001"))):
            self.rejects("rest-cone", *found, path="part 0")
        for found in (asked(interval(1, "1.001"), [3, 4]), asked(1, [3, 4], interval(5, "5.001"))):
            self.accepts(*found)
        # sqrt(2) is bounded from above: to 64 bits.
        low = Fraction(check.math.isqrt(2 << 126), 1 << 63)
        for mu, good in ((low / 5, False), ((low + Fraction(1, 1 << 63)) / 5, True)):
            file, proof = asked(str(mu), [1, 1])
            if good:
                self.accepts(file, proof)
            else:
                self.rejects("rest-cone", file, proof, path="part 0")
        # L = sqrt(2) is bounded from below, to 64 bits, and P' = 5/L to 128.
        most = low * 5 * Fraction(check.math.isqrt(1 << 255), 1 << 128)
        self.accepts(*asked(1, [most], normal=[1, 1, 0]))
        self.rejects("rest-cone", *asked(1, [most + Fraction(1, 1 << 100)], normal=[1, 1, 0]), path="part 0")

    def test_false_proofs(self):
        # Beyond what friction holds: the weight of the cup is 40 N.
        heavy = {**CUP, "wrench": [0, 0, -40, 0, 0, 0]}
        self.rejects("rest-cone", heavy, proved(heavy, proof_at_rest(posed(heavy))), path="part 0")
        proof = self.proof_of(CUP)
        self.rejects("rest-reach", heavy, proved(heavy, proof), path="part 0")
        # A torque that friction holds up to 2/5, with both verdicts.
        for torque, rule in (("3/10", None), ("1/2", "rest-cone")):
            file, law = {**TURNED, "wrench": [0, 0, 0, 0, 0, torque]}, ("--normal-law", "bilateral")
            tree = certificate(6, file["wrench"], law="bilateral", tree=SLACK[4:5])
            proof = stable(6, file["wrench"], [proof_at_rest(posed(file), range(4))], law="bilateral")
            if rule:
                self.accepts(file, tree, *law)
                self.rejects(rule, file, proof, *law, path="part 0")
            else:
                self.rejects("leaf-bound", file, tree, *law, node=0, path="root")
                self.accepts(file, proof, *law)
        proof = self.proof_of(CUP)
        # The same forces with G = 0 and a Z that says that nothing is left.
        empty = {**proof, "answers": [], "reach": [10 ** 9] * 6}
        self.rejects("rest-reach", heavy, proved(heavy, empty), path="part 0")
        # A reach below 0 would be one of cones without end: here G is -50 times what it should be.
        back = {"rest": [], "answers": [[i, [doubled(f, -50) for f in fs]] for i, fs in proof["answers"]],
                "reach": [-1] * 6}
        self.rejects("rest-reach", heavy, proved(heavy, back), path="part 0")
        # mu is at its high end only.
        proof = self.proof_of({**CUP, "wrench": [0, 0, -20, 0, 0, 0]})
        slippery = {**CUP, "wrench": [0, 0, -20, 0, 0, 0],
                    "contacts": [{**FINGERS[0], "friction": interval("0.1", "0.5")}, *FINGERS[1:]]}
        self.accepts({**slippery, "contacts": FINGERS}, proved(slippery, proof))
        self.rejects("rest-cone", slippery, proved(slippery, proof), path="part 0")
        # So is P'.
        loose = {**slippery, "contacts": [*FINGERS[:2], {**FINGERS[2], "preload": interval(4, 20)}]}
        self.assertEqual(self.run_both(loose, proved(loose, proof))[1]["rule"], "rest-reach")
        # Contacts listed twice would have their cones twice: 40 N again.
        twice = proof_at_rest(posed({**CUP, "wrench": [0, 0, -20, 0, 0, 0]}))
        twice["rest"] = sorted([*twice["rest"], *copy.deepcopy(twice["rest"])])
        self.rejects("rest-share", heavy, proved(heavy, twice), path="part 0")
        # A force along the normal is no friction: one finger does not carry 10 N across the cup.
        push = {**CUP, "wrench": [10, 0, 0, 0, 0, "0"], "contacts": [{**c, "friction": "0.01"} for c in FINGERS]}
        along = proof_at_rest(posed(push))
        along["rest"][0][1] = [-10, 0, 0]
        self.rejects("rest-share", push, proved(push, along), path="part 0")
        # A contact that does not press bears nothing.
        apart = {**CUP, "contacts": [*FINGERS, {**FINGERS[0], "preload": 0}], "wrench": [0, 0, -1, 0, 0, 0]}
        proof = self.proof_of(apart, bearing=range(3))
        self.accepts(apart, proved(apart, proof))
        self.accepts(apart, proved(apart, {**proof, "rest": [*proof["rest"], [3, [0, 0, 0]]]}))
        self.rejects("rest-cone", apart, proved(apart, {**proof, "rest": [*proof["rest"], [3, [0, 0, "1/10000000"]]]}),
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
