# SPDX-License-Identifier: MIT
"""Boxes (certificate/FORMAT.md, section 6): the syntax, and a twin."""

import itertools
import random
import unittest
from fractions import Fraction

import naive_box
from proofs import EASY
from support import Case, certificate, check, interval, stable


def box_file(*contacts, **members):
    return {"format": "stickslip-grasp/2", "contacts": list(contacts), "wrench": [0, 0, 0], **members}


# A body on a floor, pulled up: unstable. Friction does no work on (0, -1, 0).
FLOOR = {"position": [0, 0], "normal": [0, 1], "friction": interval("1/10", "1/2")}
PULLED = box_file(FLOOR, wrench=[interval("-1/8", "1/8"), interval(1, 2), 0])
PULL = [["-1/8", "1/8"], [1, 2], 0]
UP = [["leaf", 0, -1, 0]]


def pulled(tree=None, wrench=None, **changes):
    return certificate(1, PULL if wrench is None else wrench, tree=UP if tree is None else tree,
                       **changes)


class QuestionTest(Case):
    def test_intervals(self):
        text = self.accepts(PULLED, pulled())
        self.assertEqual(text.split("\n")[1:4], ["verdict     unstable, for every grasp in the box",
                                                 "contacts    1",
                                                 "wrench      ([-1/8, 1/8], [1, 2], 0)"])
        _, report, _, _ = self.run_both(PULLED, pulled())
        self.assertIs(report["box"], True)
        self.assertEqual(report["question"]["wrench"], [["-1/8", "1/8"], ["1", "2"], "0"])
        self.accepts(PULLED, certificate(1, [0, 1, 0], tree=UP), "--wrench", "0,1,0")
        one = {**PULLED, "contacts": [{**FLOOR, "friction": interval(1, "2/2")}], "wrench": [0, 1, 0]}
        _, report, _, _ = self.run_both(one, certificate(1, [0, [1, 1], 0], tree=UP))
        self.assertIs(report["box"], False)
        everywhere = {**PULLED, "defaults": {"friction": interval(0, 1), "preload": interval(0, 1),
                                             "stiffness": interval("1/2", 2)},
                      "contacts": [{"position": [interval(0, 1), interval("-1/2", 0)],
                                    "normal": {"direction": [0, 1], "slope": "1/100"}}]}
        self.accepts(everywhere, pulled())

    def test_cases_add_up(self):
        file = box_file(FLOOR, wrench=[0, interval(1, 2), 0], cases=[
            {"name": "a", "wrench": [interval(0, 1), interval(3, 5), 0]}, {"name": "b", "loads": []}])
        self.accepts(file, pulled(wrench=[[0, 1], [4, 7], 0]), "--case", "a")
        self.accepts(file, pulled(wrench=[0, [1, 2], 0]), "--case", "b")
        self.rejects("question-wrench", file, pulled(wrench=[0, [1, 2], 0]), "--case", "a")

    FIXED = box_file({**FLOOR, "friction": "1/2", "preload": 1}, wrench=[0, 3, 0])

    def test_uncertain(self):
        asked = "wrench=2%,preload=5%,normal=0.0175,friction=10%,stiffness=1/10,position=1e-3"
        said = {"friction": "10%", "stiffness": "1/10", "preload": "5%", "position": "1/1000",
                "normal": "7/400", "wrench": "2%"}
        proof = certificate(1, [0, 3, 0], tree=UP, uncertain=said)
        text = self.accepts(self.FIXED, proof, "--uncertain", asked)
        self.assertIn("\nuncertain   friction 10%, stiffness 1/10, preload 5%, position 1/1000, "
                      "normal 7/400, wrench 2%\n", text)
        _, report, _, _ = self.run_both(self.FIXED, proof, "--uncertain=" + asked)
        self.assertEqual(report["question"]["uncertain"], said)
        rule = "question-uncertain"
        self.rejects(rule, self.FIXED, proof)
        self.rejects(rule, self.FIXED, certificate(1, [0, 3, 0], tree=UP), "--uncertain", "wrench=0")
        for kind in said:
            options = ",".join(part for part in asked.split(",") if not part.startswith(kind))
            self.rejects(rule, self.FIXED, proof, "--uncertain", options)
        fraction = certificate(1, [0, 3, 0], tree=UP, uncertain={"friction": "1/10"})
        self.rejects(rule, self.FIXED, fraction, "--uncertain", "friction=10%")
        self.accepts(self.FIXED, fraction, "--uncertain", "friction=0.1")

    def test_option_syntax(self):
        for text in ("", "friction", "friction=", "friction=%", "friction=x", "mass=1",
                     "friction=1,friction=1", "friction=1,", ",friction=1", "friction=10 %",
                     "friction=1/0%", "=1", "friction=ball:1", "position=ball:1:length=1",
                     "wrench=ball:1,wrench=ball:1", "wrench=2,wrench=ball:1", "wrench= ball:1", "wrench=BALL:1",
                     *("wrench=ball" + ball for ball in (
                         "", ":", ":1%", ":10%", ":x", "::length=1", ":1:", ":1:2", ":1:length=", ":1:length=2%",
                         ":1:length=1:length=1", ":1:length=1:2", ":1:about=", ":1:about=1:x",
                         ":1:about=1:2:about=1:2", ":1:about=1:length=2:2", ":1:about=1:", ":1:radius=2", ":1:size=1",
                         ":1:=2", ":1:body", ":length=1"))):
            code, _, _, err = self.usage("--uncertain", text)
            self.assertEqual(code, 2, text)
            self.assertIn("--uncertain", err)

    def usage(self, *options):
        from support import STICKSLIP_CHECK, in_process, start
        code, _, err = in_process(["g", "c", *options])
        if STICKSLIP_CHECK:
            other = start([STICKSLIP_CHECK], ["g", "c", *options])
            self.assertEqual(other[0], code)
            self.assertIn("--uncertain", other[2])
        return code, None, None, err

    def test_what_is_a_box(self):
        """No interval has a width, but the length of the normal is irrational."""
        file = box_file({**FLOOR, "friction": 0, "normal": [1, 1], "preload": 1}, wrench=[-1, 1, 0])
        proof = certificate(1, [-1, 1, 0], tree=[["leaf", 1, -1, 0]])
        self.assertIn("for every grasp in the box", self.accepts(file, proof))
        for options, is_box in (((), True), (("--preload", "0"), False),
                                (("--uncertain", "preload=0"), True),
                                (("--preload", "0", "--uncertain", "preload=1/1000"), True)):
            said = certificate(1, [-1, 1, 0], 0 if "--preload" in options else None,
                               tree=[["leaf", 1, -1, 0]])
            if "--uncertain" in options:
                kind, size = options[-1].split("=")
                said["question"]["uncertain"] = {kind: size}
            if "preload=1/1000" in options:
                self.malformed("preload", file, said, *options)
                continue
            _, report, _, _ = self.run_both(file, said, *options)
            self.assertIs(report["box"], is_box, options)


class SyntaxTest(Case):
    def bad(self, needle, proof):
        self.malformed(needle, PULLED, proof)

    def test_question(self):
        def bad(needle, **question):
            proof = pulled()
            self.bad(needle, {**proof, "question": {**proof["question"], **question}})

        for value in ({}, [], "10%", None, {"friction": "%"}, {"friction": "1e2"}, {"friction": 0.5},
                      {"mass": 1}, {"stiffness": 1, "friction": 1}, {"friction": "0.1%"},
                      {"friction": None}):
            bad("question.uncertain", uncertain=value)
        for value in ([0, 0], [0, [1], 0], [0, [1, 2, 3], 0], [0, [1, [2]], 0], [0, "1%", 0]):
            bad("question.wrench", wrench=value)

    def test_bits(self):
        for bits, good in ((64, True), (4096, True), (63, False), (4097, False), ("128", False),
                           (128.5, False), (-128, False), (None, False)):
            proof = pulled()
            proof = {"format": proof["format"], "question": proof["question"], "bits": bits,
                     "verdict": "unstable", "tree": UP}
            if good:
                self.accepts(PULLED, proof)
            else:
                self.bad("bits", proof)
        self.bad("bits", {**pulled(), "bits": 128})  # out of order
        margin = certificate(1, [0, 0, 0], direction=[0, 1, 0], resisted=[], segments=[], tree=[])
        margin = {"format": margin["format"], "question": margin["question"], "bits": 128,
                  **{key: margin[key] for key in ("verdict", "resisted", "segments", "tree")}}
        self.malformed("", PULLED, margin, "--wrench", "0,1,0")

    def test_parts(self):
        for node in (["part"], ["part", "friction", 0], ["part", "friction", 0, 1, 1],
                     ["part", "mass", 0, 1], ["part", 0, 0, 1], ["part", "friction", "0", 1],
                     ["part", "friction", -1, 1], ["part", "friction", 0, None]):
            self.bad("tree[0]", pulled([node]))
        for part in (0, [], ["leaf", 0, 0, 0], {}, {**PROOF, "tree": 0}, {**PROOF, "twist": [0, 0]},
                     {**PROOF, "walls": [[1, 0]]}, {**PROOF, "direction": [[0, 0]] * 3},
                     {**PROOF, "tree": [["leaf"]]}, {**PROOF, "more": 0},
                     {key: PROOF[key] for key in ("twist", "walls", "direction")},
                     {key: PROOF[key] for key in ("walls", "twist", "direction", "tree")}):
            self.bad("parts[0]", stable(1, PULL, [part]))
        self.bad("", {**stable(1, PULL, []), "tree": []})
        self.bad("", {**stable(1, PULL, []), "verdict": "unstable"})
        margin = certificate(1, [0, 0, 0], direction=[0, 1, 0], resisted=[], segments=[],
                             tree=[["part", "friction", 0, 1]])
        self.malformed("tree[0]", box_file({**FLOOR, "friction": 1}), margin, "--direction", "0,1,0")


UNIT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
PROOF = {"twist": [0, 0, 0], "walls": UNIT, "direction": UNIT, "tree": []}


def random_interval(rng, low, high, uncertain):
    a, b = sorted(Fraction(rng.randint(4 * low, 4 * high), 4) for _ in range(2))
    return (a, b) if uncertain else (a, a)


def random_box(rng, m, law):
    contacts = []
    for _ in range(m):
        def uncertain():
            return rng.random() < 0.4
        normal = rng.choice([(1, 0), (0, 1), (-1, 0), (0, -2), (3, 4), (1, 1), (1, -2)])
        slope = Fraction(rng.randint(1, 3), 8) if uncertain() else 0
        contacts.append(naive_box.Contact(
            normal, slope, random_interval(rng, -1, 1, uncertain()),
            random_interval(rng, -1, 1, uncertain()), random_interval(rng, 0, 1, uncertain()),
            tuple(k + Fraction(1, 2) for k in random_interval(rng, 0, 2, uncertain())),
            random_interval(rng, 0, 1, uncertain())))
    wrench = [random_interval(rng, -1, 1, uncertain()) for _ in range(3)] if m else [(1, 1)] * 3
    return naive_box.Box(contacts, wrench, law)


def file_of(box):
    def written(ends):
        low, high = map(str, ends)
        return low if low == high else interval(low, high)

    contacts = [{"position": [written(c.given["x"]), written(c.given["y"])],
                 "normal": {"direction": list(map(str, c.normal)), "slope": str(c.slope)},
                 **{key: written(c.given[key]) for key in ("friction", "stiffness", "preload")}}
                for c in box.contacts]
    return box_file(*contacts, wrench=list(map(written, box.wrench)))


def said(box):
    return [list(map(str, ends)) if ends[0] != ends[1] else str(ends[0]) for ends in box.wrench]


def begun(box):
    """The root of its tree, in check.py."""
    here = check.Box([check.Parameters(c.normal, {
        name: check.Bounds(*ends) for name, ends in c.ends.items()}, check.exactly(Fraction(0)))
        for c in box.contacts], check.loads_within(tuple(check.Bounds(*ends) for ends in box.wrench)), (check.zeros(3),))
    return check.begin(check.Root(here, [((0, 0, 0, 1, 0), False, True), ((0, 0, 0, 0, 1), True, False)],
                                  box.law == "bilateral"))


class TwinTest(Case):
    def test_signs_of_v(self):
        """Least and largest v are found from ends, without v at every corner."""
        rng = random.Random(12)
        signs = set()
        for _ in range(150):
            box = random_box(rng, 1, "unilateral")
            (contact,), (term,) = box.contacts, begun(box).box.terms
            points = [(*(rng.randint(-2, 2) for _ in range(3)), rng.randint(0, 2), 0)
                      for _ in range(6)]
            lows, highs = term.extremes(points)
            for x, low, high in zip(points, lows, highs):
                values = [contact.v(q, x) for q in contact.corners()]
                wanted = check.sign(min(values)), check.sign(max(values))
                self.assertEqual((check.sign(low), check.sign(high)), wanted)
                signs.add(wanted + (x[3] > 0,))
        self.assertEqual(len(signs), 12)

    def test_bounds_of_work(self):
        rng = random.Random(13)
        compared = 0
        while compared < 60:
            box = random_box(rng, 1, "unilateral")
            (contact,), (term,) = box.contacts, begun(box).box.terms
            if term.by_preload:
                continue
            y = tuple(rng.randint(-2, 2) for _ in range(3))
            x = (*(rng.randint(-2, 2) for _ in range(3)), rng.randint(0, 2), 0)
            low, high = contact.ends["friction"]
            for slip, slopes in ((1, (-low, -high)), (-1, (low, high)), (0, (-high, high))):
                self.assertEqual(term.bound(y, slip, False, [x]),
                                 [max(contact.greatest(s, y, x) for s in slopes)])
            compared += 1

    def test_random_trees(self):
        """First children only, down to a leaf, which fails; or holds, and the next node is missing.
        Nodes that may not stand there are rejected."""
        rng = random.Random(11)
        tally = {"holds": 0, "fails": 0, "node-certain": 0}
        while min(tally.values()) < 6:
            law = rng.choice(["unilateral", "unilateral", "bilateral"])
            box = random_box(rng, rng.randint(1, 2), law)
            tree, here, place = [], box, box.root()
            file, options = file_of(box), ("--normal-law", law)
            rule = None
            for _ in range(rng.randint(0, 4)):
                i = rng.randrange(len(box.contacts))
                kind = rng.choice(["slip", "separation", "part", "part", "plane", "plane"])
                if kind == "part":
                    name = rng.choice(naive_box.NAMES)
                    low, high = here.contacts[i].ends[name]
                    if low == high:
                        continue
                    middle = (2 * low + high) / 3
                    tree.append([kind, name, i, str(middle)])
                    here = here.cut(name, i, low, middle)
                    continue
                if kind == "plane":
                    row = tuple(Fraction(rng.randint(-2, 2)) for _ in range(4)) + (Fraction(0),)
                    tree.append([kind, *map(str, row[:4])])
                else:
                    tree.append([kind, i])
                    row = here.plane(kind, i)
                    if row is None:
                        rule = "node-certain"
                        break
                place = naive_box.Place(place.conditions + [(row, False)],
                                        place.strict + [row] * (kind == "slip"))
            if rule is None:
                y = rng.choice(EASY)
                tree.append(["leaf", *y])
                rule = "holds" if here.leaf_holds(place, y) else "fails"
                if rule == "fails" and rng.random() < 0.8:  # rather one that does
                    good = next((y for y in rng.sample(EASY, 5) if here.leaf_holds(place, y)), None)
                    if good:
                        tree[-1], rule = ["leaf", *good], "holds"
            tally[rule] += 1
            proof = certificate(len(box.contacts), said(box), None, law, tree=tree)
            code, report, _, _ = self.run_both(file, proof, *options)
            wanted = {"holds": "accepted" if len(tree) == 1 else "tree-short", "fails": "leaf-bound",
                      "node-certain": "node-certain"}[rule]
            self.assertEqual("accepted" if code == 0 else report["rule"], wanted, (file, proof))
            if code:
                self.assertEqual(report["node"], len(tree) - (wanted != "tree-short"))

    def test_enclosures(self):
        for square, bits in itertools.product((Fraction(2), Fraction(1, 3), Fraction(5, 10**40),
                                               Fraction(10**41), Fraction(4, 9)), (64, 65, 128)):
            self.assertEqual(tuple(check.root_bounds(1 / square, bits)),
                             naive_box.inverse_length(square, bits))


# ---- Stable: by degree ------------------------------------------------------------------------


if __name__ == "__main__":
    unittest.main()
