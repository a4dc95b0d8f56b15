# SPDX-License-Identifier: MIT
"""Grasps in space (certificate/FORMAT.md, sections 1, 5 and 7): what is read, properties of margins, and a twin."""

import collections
import glob
import itertools
import json
import math
import os
import random
import unittest
from fractions import Fraction

import naive
import naive_space
from support import HERE, Case, certificate, check, interval, stable

CORPUS = os.path.join(HERE, "..", "..", "corpus", "space")


def space_file(*contacts, **members):
    return {"format": "stickslip-grasp/2", "contacts": list(contacts), "wrench": [0] * 6, **members}


# A body on a floor, pulled up. Friction does no work on (0, 0, -1).
FLOOR = {"position": [0, 0, 0], "normal": [0, 0, 1], "friction": "1/2", "preload": 1}
PULL = [0, 0, 3, 0, 0, 0]
PULLED = space_file(FLOOR, wrench=PULL)
UP = [["leaf", 0, 0, -1, 0, 0, 0]]


def pulled(tree=None, wrench=None, **changes):
    return certificate(1, PULL if wrench is None else wrench, tree=UP if tree is None else tree,
                       **changes)


def without(content, *names):
    return {name: value for name, value in content.items() if name not in names}


class GraspFileTest(Case):
    def bad(self, needle, *contacts, **members):
        self.malformed(needle, space_file(*contacts, **members), pulled())

    def test_no_contacts(self):
        empty = space_file(wrench=[0, 0, 0, 0, 0, 1])
        self.accepts(empty, certificate(0, [0, 0, 0, 0, 0, 1], tree=[["leaf", 0, 0, 0, 0, 0, -1]]))
        self.accepts(space_file(), certificate(0, [0] * 6, twist=[0] * 6))
        # Without contacts and without six numbers it is planar.
        loads = without(space_file(loads=[]), "wrench")
        self.accepts(loads, certificate(0, [0, 0, 0], twist=[0, 0, 0]))
        self.malformed("loads[0].force", {**loads, "loads": [{"force": [0, 0, 0], "at": [0, 0, 0]}]}, pulled())

    def test_the_order_of_members_plays_no_part(self):
        for names in itertools.permutations(PULLED):
            self.accepts({name: PULLED[name] for name in names}, pulled())

    def test_loads(self):
        def loaded(*loads):
            return without(space_file(FLOOR, loads=list(loads)), "wrench")

        def asks(wrench, *loads):
            file, proof = loaded(*loads), certificate(1, wrench, tree=UP)
            _, report, _, _ = self.run_both(file, proof)
            self.assertIn(report["rule"], ("leaf-bound", None), report)

        asks([1, 2, 3, 1, -2, 1], {"force": [1, 2, 3], "at": [1, 1, 1]})
        asks([1, 2, 3, "21/2", 0, "-7/2"], {"force": [1, 2, 3], "at": [0, "1/2", 4]},
             {"torque": [17, -4, -3]})
        asks([0, 0, -2, -2, 6, 0], {"weight": 2, "at": [3, 1, 5]})
        asks([0, 4, -3, 0, -3, -4], {"weight": 5, "at": [-1, 0, 0], "direction": [0, 8, -6]})
        for needle, load in (("loads[0].force: must be an array of 3", {"force": [1, 2], "at": [0] * 3}),
                             ("loads[0].at: must be an array of 3", {"force": [1, 2, 3], "at": [0] * 2}),
                             ("loads[0].torque: must be an array of 3", {"torque": 1}),
                             ("loads[0].direction", {"weight": 1, "at": [0] * 3, "direction": [0, 1]}),
                             ("loads[0].direction", {"weight": 1, "at": [0] * 3,
                                                     "direction": [1, 1, 0]})):
            self.malformed(needle, loaded(load), pulled())

    def test_cases(self):
        file = space_file(FLOOR, wrench=PULL, cases=[
            {"name": "a", "wrench": [1, 0, interval(1, 2), 0, 0, 0]},
            {"name": "b", "loads": [{"torque": [0, 0, 1]}]}])
        self.accepts(file, pulled(wrench=[1, 0, [4, 5], 0, 0, 0]), "--case", "a")
        self.accepts(file, pulled(wrench=[0, 0, 3, 0, 0, 1]), "--case", "b")
        self.malformed("cases[0].wrench", {**file, "cases": [{"name": "a", "wrench": [0, 0, 0]}]},
                       pulled())


class QuestionTest(Case):
    def test_boxes(self):
        contact = {**FLOOR, "position": [0, interval(-1, 1), interval(0, "1/2")],
                   "friction": interval(0, 1), "stiffness": interval(1, 2)}
        file = space_file(contact, wrench=[0, 0, interval(2, 3), 0, 0, 0])
        text = self.accepts(file, pulled(wrench=[0, 0, [2, 3], 0, 0, 0]))
        self.assertIn("verdict     unstable, for every grasp in the box\n", text)
        self.assertIn("wrench      (0, 0, [2, 3], 0, 0, 0)\n", text)
        said = {"friction": "10%", "position": "1/1000", "wrench": "1"}
        self.accepts(PULLED, pulled(uncertain=said), "--uncertain",
                     "friction=10%,position=0.001,wrench=1")
        self.rejects("question-uncertain", PULLED, pulled(uncertain={"normal": "1/10"}))
        # The length of (1, 1, 0) is irrational.
        for preload, is_box in ((1, True), (0, False)):
            file = space_file({**FLOOR, "normal": [1, 1, 0], "preload": preload},
                              wrench=[1, 1, 0, 0, 0, 0])
            proof = certificate(1, [1, 1, 0, 0, 0, 0], tree=[["leaf", -1, -1, 0, 0, 0, 0]])
            _, report, _, _ = self.run_both(file, proof)
            self.assertEqual((report["result"], report["box"]), ("accepted", is_box))


class SyntaxTest(Case):
    def bad(self, needle, proof):
        self.malformed(needle, PULLED, proof)

    def test_numbers(self):
        for node in (["leaf", 0, -1, 0], ["leaf", *[0] * 5], ["leaf", *[0] * 7],
                     ["plane", *[0] * 4], ["plane", *[0] * 6], ["plane", *[0] * 8], ["slip", 0, 0],
                     ["part", "turn", 0, 0], ["part", "x", 0], ["sector", 0]):
            self.bad("tree[0]", pulled([node]))
        self.bad("twist", certificate(1, PULL, twist=[0, 0, 0]))
        for share in (0, [0, 0], [0] * 4, [0, 0, None], "0"):
            self.bad("shares", certificate(1, PULL, twist=[0] * 6, shares=[[0, share]]))
        self.malformed("tree[0]", space_file({**FLOOR, "position": [0, 0], "normal": [0, 1]},
                                             wrench=[0, 3, 0]),
                       certificate(1, [0, 3, 0], tree=[["part", "z", 0, 0]]))

    def test_margins(self):
        question = {"direction": PULL}
        self.bad("", pulled(**question))
        for missing in ({"resisted": [], "segments": []}, {"resisted": []}, {"segments": []}):
            self.bad("", {**certificate(1, PULL, **question, **missing, tree=UP), "verdict": "margin"})
        good = ["unstable", 0, None, UP]
        for claim in ([], good[1:], [*good, 0], ["Unstable", *good[1:]], [None, *good[1:]], {},
                      ["stable", *good[1:]], ["unstable", None, None, UP], ["unstable", 0, 1.5, UP],
                      ["unstable", 0, None, ["leaf", *PULL]], ["unstable", 0, None, CUBE_PROOF],
                      ["unstable", 0, None, [["plane", *[0] * 7]]],
                      ["unstable", 0, None, [["part", "friction", 0, 1]]],
                      ["unstable", 0, None, [["leaf", 0]]], ["stable", 0, 1, ["part", "z", 0, 1]],
                      ["stable", 0, 1, without(CUBE_PROOF, "tree")],
                      ["stable", 0, 1, {**CUBE_PROOF, "tree": [["part", "friction", 0, 1]]}]):
            self.bad("intervals[0]", certificate(1, PULL, **question, intervals=[claim]))
        claims = certificate(1, PULL, **question, intervals=[])
        for member in ({"tree": []}, {"resisted": []}, {"parts": []}, {"intervals": None},
                       {"question": {**claims["question"], "direction": [0, 0, 1]}}):
            self.bad("", {**claims, **member})
        # Whichever rule fails before.
        self.bad("intervals[1]", certificate(9, PULL, **question, intervals=[good, good[:3]]))

    def test_parts(self):
        proof = stable(1, PULL, [CUBE_PROOF])
        self.assertEqual(self.run_both(PULLED, proof)[0], 1)
        for key, value in (("twist", [0] * 3), ("direction", UNIT[:3]),
                           ("walls", [[1, 0, 0]] * 3), ("direction", [[0] * 5] * 6)):
            self.bad("parts[0]", stable(1, PULL, [{**CUBE_PROOF, key: value}]))


UNIT = [[int(j == k) for k in range(6)] for j in range(6)]
# A cube with a contact in the middle of each face. The walls are d = +-1/2 and +-1 for turns.
CUBE = [{"position": [-c for c in n], "normal": n, "friction": "1/10", "preload": 1}
        for n in ([1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1])]
CUBE_PROOF = {"twist": [0] * 6,
              "walls": [[(1 + (j < 3)) * c for c in row] for j, row in enumerate(UNIT)],
              "direction": UNIT, "tree": [["leaf", *[sign * c for c in row]] for row in UNIT for sign in (1, -1)]}


TURN = [0, 0, 0, 0, 0, 1]


def margin(*claims, m=2, wrench=None, **question):
    return certificate(m, [0] * 6 if wrench is None else wrench, intervals=list(claims), **question)


# Two fingers: whatever the motion is, their friction holds 2 · 3/10 · 4 = 12/5.
PINCH = space_file(*[{"position": [x, 0, 0], "normal": [-x // 2, 0, 0], "friction": "3/10", "preload": 4}
                     for x in (-2, 2)])
DOWN = [0, 0, -1, 0, 0, 0]


def point(*shares, twist=(0,) * 6):
    return {"twist": list(twist), "shares": [[i, list(share)] for i, share in shares]}


def held(share):
    """Both fingers have it."""
    return point(*((i, [0, 0, share]) for i in range(2)))


class PointsTest(Case):
    ASKED = ("--direction", "0,0,-1,0,0,0")

    def test_syntax(self):
        a, b = held(0), held(1)
        for claim in (["stable", 0, 1, a], ["stable", 1, 1, a, a], ["stable", "1/2", "2/4", a, a],
                      ["stable", 0, None, a, a], ["stable", 0, 1, a, b, b], ["stable", 0, 1],
                      ["stable", 2, 1, a], ["stable", None, 1, a, b], ["stable", 0, 1, a, CUBE_PROOF],
                      ["stable", 0, 1, CUBE_PROOF, a], ["stable", 0, 1, CUBE_PROOF, CUBE_PROOF],
                      ["unstable", 0, 1, a], ["unstable", 0, 1, a, b], ["unstable", 0, 1, UP, UP],
                      ["stable", 0, 1, a, []], ["stable", 0, 1, [], b], ["stable", 0, 1, a, None],
                      *(["stable", 0, 0, bad] for bad in (
                          without(a, "twist"), without(a, "shares"), {**a, "tree": []}, {**CUBE_PROOF, **a},
                          dict(reversed(a.items())), {**a, "twist": [0] * 5}, {**a, "shares": {}},
                          {**a, "shares": [[0, 1]]}, {**a, "shares": [[0, [0, 0]]]}, [0, *a.values()]))):
            self.malformed("intervals[1]", PINCH, margin(["stable", 0, 0, a], claim, direction=DOWN), *self.ASKED)
        once = json.dumps(margin(["stable", 0, 0, point()], direction=DOWN))
        self.accepts(PINCH, once, *self.ASKED)
        self.malformed("intervals[0]", PINCH, once.replace('"shares": []', '"shares": [], "shares": []'),
                       *self.ASKED)

    def test_modes_are_what_mixtures_allow(self):
        """Any two equilibria of one contact, under the loads that they balance: accepted if and only if
        all mixtures are equilibria. A mixture that slips by chance as it should, or not at all, is
        not near both ends."""
        rng = random.Random(16)
        frames = [((0, 0, 1), (1, 0, 0), (0, 1, 0)), ((0, -2, 0), (1, 0, 0), (0, 0, 1)),
                  ((1, 2, 2), (Fraction(2, 3), Fraction(-2, 3), Fraction(1, 3)),
                   (Fraction(2, 3), Fraction(1, 3), Fraction(-2, 3)))]
        tally = collections.Counter()
        for _ in range(400):
            n, *across = rng.choice(frames)
            length = naive_space.root_of(Fraction(naive.dot(n, n)))
            mu, preloads = Fraction(rng.choice([0, 1, 1, 2]), 2), sorted(rng.choices([0, 1, 2], k=2))

            def along(c):
                return check.plus(check.times(c[0], across[0]), c[1], across[1])

            slips = [along(rng.choice([(0, 0), (0, 0), (1, 0), (2, 0), (-1, 0), (3, 4), (6, 8), (-3, -4)]))
                     for _ in range(2)]
            ends = []
            for slip, other, preload in zip(slips, reversed(slips), preloads):
                v = Fraction(rng.choice([-1, 0, 0, 1, 2]))
                a, size = max(Fraction(0), v), naive_space.root_of(naive.dot(slip, slip))
                share = None
                if any(slip):
                    f = check.times(-mu * length * a / size, slip)
                else:
                    share = along(rng.choice([(1, 0), (Fraction(-3, 5), Fraction(-4, 5)), (0, 0)]))
                    if any(other):
                        share = check.times(-rng.choice([1, 1, Fraction(1, 2), -1])
                                            / naive_space.root_of(naive.dot(other, other)), other)
                    share = check.times(length, share)
                    f = check.times(mu * a, share)
                # v = (P - n·d / L) / L with P = L preload.
                ends.append((v, a, f, check.plus(slip, preload - v, n), share))

            def mixed(t, k):
                return check.plus(check.times(1 - t, ends[0][k]), t, ends[1][k])

            def holds(t):
                v, a = ((1 - t) * ends[0][k] + t * ends[1][k] for k in (0, 1))
                f, slip = mixed(t, 2), check.plus(check.times(1 - t, slips[0]), t, slips[1])
                work = naive.dot(f, slip)
                return a == max(0, v) and (not any(slip) or (work <= 0 and work ** 2 == (
                    mu * length * a) ** 2 * naive.dot(slip, slip)))

            loads = [check.times(-1, check.plus(f, a, n)) for _, a, f, _, _ in ends]
            u, grown = check.plus(loads[1], -1, loads[0]), (preloads[1] - preloads[0]) * length
            if not any(u) and not grown:
                continue
            w, u = ([str(c) for c in force] + [0] * 3 for force in (loads[0], u))
            file = space_file({"position": [0] * 3, "normal": list(n), "friction": str(mu),
                               "preload": str(preloads[0] * length)})
            proof = margin(["stable", 0, 1, *(
                point(*([] if share is None else [(0, map(str, share))]),
                      twist=[*map(str, d), 0, 0, 0]) for *_, d, share in ends)],
                m=1, wrench=w, direction=u, preload_direction=[str(grown)])
            code, report, _, _ = self.run_both(file, proof, "--wrench=" + ",".join(map(str, w)),
                                               "--direction=" + ",".join(map(str, u)),
                                               f"--preload-direction={grown}")
            good = all(map(holds, (Fraction(1, 100), Fraction(1, 2), Fraction(99, 100))))
            self.assertEqual((code, report["rule"], report["path"]), (0, None, None) if good else
                             (1, "segment-mode", "interval 0"), (ends, slips))
            tally[good, sum(map(any, slips)), sum(end[1] > 0 for end in ends), mu > 0] += 1
        self.assertEqual(len([key for key in tally if key[3] and key[2]]), 10, tally)


def corpus():
    """(name, grasp, certificate, options)"""
    for path in sorted(glob.glob(os.path.join(CORPUS, "*.grasp.json"))):
        stem = path[:-len(".grasp.json")]
        name = os.path.basename(stem)
        texts = []
        for ending in (".grasp.json", ".certificate.json"):
            with open(stem + ending, encoding="utf-8") as file:
                texts.append(file.read())
        asked = json.loads(texts[1])["question"]
        options = ["--normal-law", "bilateral"] * name.startswith("bilateral_")
        for key in ("direction", "preload_direction"):
            if key in asked:
                options += [f"--{key.replace('_', '-')}", "scale" if asked[key] == "scale" else
                            ",".join(map(str, asked[key]))]
        yield name, *texts, tuple(options)


# Squares of the ends of what is resisted.
TRUTH = {"cube_turned": (0, Fraction(4, 25)), "cube_at_45_degrees": (0, Fraction(8, 25)),
         "cube_pressed": (Fraction(25, 4), math.inf), "pinch": (0, Fraction(144, 25)),
         "sliding": (0, math.inf)}


class CorpusTest(Case):
    def test_accepted(self):
        count = 0
        for name, grasp, proof, options in corpus():
            text = self.accepts(grasp, proof, *options)
            verdict = name.split("_")[-1]
            if verdict == "margin":
                self.is_true(name, self.run_both(grasp, proof, *options)[1])
            self.assertIn("elsewhere   nothing" if verdict == "margin" else f"verdict     {verdict}",
                          text, name)
            count += 1
        self.assertGreater(count, 10)

    def is_true(self, name, report):
        """Of a margin, whose ends are known: their squares are."""
        first, last = next(ends for key, ends in TRUTH.items() if key in name)

        def squares(low, high, *_):
            return (Fraction(low) ** 2, math.inf if high is None else Fraction(high) ** 2)

        for low, high in itertools.starmap(squares, report["resisted"]):
            self.assertTrue(first <= low and high <= last, (name, report))
        for low, high in itertools.starmap(squares, report["refuted"]):
            self.assertTrue(high <= first or last <= low, (name, report))

    def test_trees_about_stable_grasps(self):
        """Unstable proofs, asked about a load under which the grasp is stable."""
        for name, grasp, proof, options in corpus():
            if not name.endswith("unstable"):
                continue
            file, content = json.loads(grasp), json.loads(proof)
            file["wrench"] = content["question"]["wrench"] = stable_load(file)
            code, report, _, _ = self.run_both(file, content, *options)
            self.assertEqual((code, report["rule"]), (1, "leaf-bound"), name)


def stable_load(file):
    """What the preloads alone balance."""
    total = check.zeros(6)
    for contact in file["contacts"]:
        p, n = (tuple(map(Fraction, contact[key])) for key in ("position", "normal"))
        a = Fraction(contact["preload"]) / naive_space.root_of(naive.dot(n, n))
        total = check.plus(total, -a, check.at(p, n))
    return list(map(str, total))


# ---- The twin ---------------------------------------------------------------------------------

NORMALS = [(0, 0, 1), (0, 0, 2), (1, 0, 0), (0, -1, 0), (1, 2, 2), (-2, 1, 2), (0, 3, 4), (1, 1, 0),
           (1, -1, 1)]


def spread(rng, value, share):
    return (value, value + Fraction(rng.randint(1, 4), 8) * (rng.random() < share))


def random_contact(rng, share, soft=False):
    normal = rng.choice(NORMALS)
    preload = spread(rng, rng.choice([0, 0, 1, Fraction(1, 2)]), share)
    if naive_space.root_of(Fraction(naive.dot(normal, normal))) is None:
        preload = (0, 0)
    turns = rng.random() < share  # and then fewer positions are uncertain: corners are many
    return naive_space.Contact.of_file(
        normal, [spread(rng, rng.randint(-1, 1), 0 if turns else share) for _ in range(3)],
        spread(rng, rng.choice([0, Fraction(1, 2), 1, Fraction(2, 3)]), share), preload,
        spread(rng, rng.choice([1, 2]), share),
        slope=rng.choice([Fraction(1, 40), Fraction(1, 8), Fraction(1, 3)]) * turns,
        torsion=0 if turns or not soft else rng.choice([Fraction(1, 4), 1, 3]))


def margin_contact(rng, normals, bits):
    return naive_space.Contact.of_margin(
        rng.choice(normals), [rng.randint(-1, 1) for _ in range(3)],
        rng.choice([0, Fraction(1, 2), 1]),
        [Fraction(rng.choice([0, 0, 1, 2]), 2) for _ in range(2)], rng.choice([1, 2]), bits)


def box_of(contacts, wrench, growth):
    def parameters(c):
        bounds, growth = {name: check.Bounds(*ends) for name, ends in c.ends.items()}, (0, 0)
        if c.loads:
            ends = [tuple(Fraction(load * inverse) for inverse in c.inverse) for load in c.loads]
            bounds["preload"], growth = check.Bounds(*ends[0]), ends[1]
        return check.Parameters(c.normal, bounds, check.Bounds(*growth), gamma=c.gamma)

    return check.Box(list(map(parameters, contacts)), check.loads_within(tuple(check.Bounds(*w) for w in wrench)),
                     (check.zeros(6) if growth is None else growth,))


class Walk:
    """A random path, in check.py and in the twin."""

    def __init__(self, rng, contacts, wrench, growth=None, ends=()):
        """With a growth of the wrench it is about the multiples between two ends, each of which is
        among them unless its second entry says so."""
        self.rng, self.contacts, self.wrench, self.growth = rng, contacts, wrench, growth
        self.strict, self.slips = [naive_space.H], []
        conditions = [(naive_space.LOAD, True, False), (naive_space.H, False, True)]
        if growth:
            h, load = naive_space.H, naive_space.LOAD
            (low, low_open), (high, high_open) = ends
            rows = [(check.plus(load, -low, h), False, low_open),
                    (check.plus(check.times(high, h), -1, load), False, high_open)]
            self.strict += [row for row, _, is_open in rows if is_open]
            conditions = [conditions[1], *rows]
        self.region = check.begin(check.Root(box_of(contacts, wrench, growth), conditions))

    def step(self, choose):
        """`choose` says which child, of a row's sign or of a slip."""
        kind, i = self.rng.choice(["slip", "separation", "plane", "plane"]), \
            self.rng.randrange(len(self.contacts))
        row = tuple(Fraction(self.rng.choice([-1, 0, 0, 0, 1])) for _ in range(8))
        if not self.growth:
            row = row[:7] + (Fraction(0),)
        node = check.Node(kind, i, row if kind == "plane" else ())
        try:
            children = check.children(self.region, node)
        except check.Rejected:
            return
        if kind == "separation":
            row = children[0].rows[0]
        child = choose(i if kind == "slip" else row)
        if child == 1 and kind == "slip":
            self.slips.append(i)
        elif child == 1:
            self.strict.append(row)
        self.region = children[child]
        self.region.open()

    def twin(self):
        return naive_space.Region(self.contacts, self.wrench, self.growth or check.zeros(6), [
            tuple(map(Fraction, x)) for x, _ in self.region.cone.generators], self.strict, self.slips)


def random_twist(rng):
    return tuple(Fraction(rng.choice([-2, -1, -1, 0, 0, 0, 1, 1, 2]), rng.choice([1, 1, 3]))
                 for _ in range(6))


class TwinTest(Case):
    def test_leaves(self):
        rng = random.Random(7)

        def of_verdict(soft):
            share = rng.choice([0, 0, 0.2, 0.1 if soft else 0.4])  # corners take long
            contacts = [random_contact(rng, share, soft) for _ in range(rng.randint(1, 2))]
            return contacts, [spread(rng, rng.randint(-3, 3), share / 2) for _ in range(6)]

        self.compare(rng, lambda: of_verdict(False), 60)
        self.compare(rng, lambda: of_verdict(True), 60)  # k = 3

    def test_leaves_of_margins(self):
        """With irrational lengths, growing wrenches and growing preloads."""
        rng = random.Random(14)

        def of_margin():
            low, size = rng.randint(0, 2), rng.randint(0, 2)
            # Of 1/L two bits are known.
            contacts = [margin_contact(rng, NORMALS, 2) for _ in range(rng.randint(1, 2))]
            return (contacts, [(Fraction(rng.randint(-2, 2)),) * 2 for _ in range(6)],
                    tuple(Fraction(rng.randint(-1, 1)) for _ in range(6)),
                    [(end, rng.random() < 0.5) for end in (low, low + size)])

        self.compare(rng, of_margin, 70)

    def compare(self, rng, question, count):
        tally = {}
        for _ in range(count):
            contacts, wrench, *rest = question()
            walk = Walk(rng, contacts, wrench, *rest)
            for _ in range(rng.randint(0, 6)):
                walk.step(lambda what: rng.choice([0, 1, 1]) if isinstance(what, int) else
                          rng.randint(0, 1))
            region, twin = walk.region, walk.twin()
            points = [x for x, _ in region.generators()]
            barred = twin.barred(twin.rays)
            self.assertEqual(region.bars(region.generators()), barred)
            for trial in range(4):
                y = random_twist(rng) if trial % 2 else tuple(
                    Fraction(-high) for _, high in wrench)
                for i, contact in enumerate(contacts):
                    if barred:
                        continue
                    moves = twin.moves(i)
                    self.assertEqual(region.box.terms[i].alpha(region, points, y),
                                     contact.alpha(y, twin.rays, moves))
                    tally[moves] = tally.get(moves, 0) + 1
                held = check.leaf_refusal(region, y, lambda x: x) is None
                self.assertEqual(held, twin.leaf_holds(y))
                tally[f"held {held}"] = tally.get(f"held {held}", 0) + (not barred)
                self.assertTrue(held or check.leaf_refusal(region, y, check.short_above))
        self.assertGreater(min(tally.values()), 20, tally)
        self.assertEqual(len(tally), 4)

    def test_the_middle_of_a_margin(self):
        contact = naive_space.Contact.of_margin((1, 1, 0), (0, 0, 0), 1, (2, 3), 1, 2)
        (middle,) = box_of([contact], [(0, 0)] * 6, None).middle().contacts
        c = sum(contact.inverse) / 2
        self.assertEqual((middle.bounds["preload"], middle.growth),
                         (check.exactly(2 * c), check.exactly(3 * c)))

    def test_redundant_rays_change_nothing(self):
        rng = random.Random(8)
        for _ in range(60):
            contacts = [random_contact(rng, rng.choice([0, 0.3])) for _ in range(2)]
            walk = Walk(rng, contacts, [spread(rng, rng.randint(-3, 3), 0.1) for _ in range(6)])
            for _ in range(rng.randint(1, 6)):
                walk.step(lambda what: rng.randint(0, 1))
            region = walk.region
            y = random_twist(rng)
            held = check.leaf_refusal(region, y, lambda x: x) is None
            rays = region.cone.rays
            if not rays:
                continue
            more = []
            for _ in range(3):
                (a, a_zero), (b, b_zero) = rng.choice(rays), rng.choice(rays)
                weight = rng.randint(1, 3)
                more.append((tuple(p + weight * q for p, q in zip(a, b)), a_zero & b_zero))
            region.cone = check.Cone(region.cone.lines, rays + more, region.cone.cuts)
            self.assertEqual(check.leaf_refusal(region, y, lambda x: x) is None, held)

    def test_the_bound_is_above_all_friction_and_close(self):
        """Unit vectors of C_i, many of them: what the force does is at most the bound, and nearly as
        much."""
        rng = random.Random(9)
        moving = 0
        while moving < 40:
            contact = random_contact(rng, 0)
            walk = Walk(rng, [contact], [(0, 0)] * 6)
            for _ in range(rng.randint(1, 5)):
                walk.step(lambda what: 1 if isinstance(what, int) else rng.randint(0, 1))
            region, twin = walk.region, walk.twin()
            if twin.barred(twin.rays) or not twin.moves(0):
                continue
            moving += 1
            y = random_twist(rng)
            p = contact.positions()[0]
            z = tuple(map(float, naive_space.slip(contact.normal, p, y)))
            slips = [tuple(map(float, s)) for r in twin.rays for s in contact.slips(r) if any(s)]
            most = -math.inf
            for a, b in itertools.combinations_with_replacement(slips, 2):
                for t in range(41):
                    s = [((40 - t) * x / math.hypot(*a) + t * e / math.hypot(*b)) for x, e in zip(a, b)]
                    length = math.hypot(*s)
                    if length > 1:
                        most = max(most, -naive.dot(s, z) / length)
            mu = float(contact.ends["friction"][1])
            length = math.sqrt(contact.square)
            work = float(naive.dot(contact.normal, naive_space.velocity(y, p))) + mu * length * most
            bound = float(region.box.terms[0].alpha(region, [x for x, _ in region.generators()], y))
            self.assertLessEqual(work, bound + 1e-9)
            self.assertLess(bound - work, 1e-2 * (1 + mu * length * math.hypot(*z)))

    def test_no_friction_of_a_turned_normal_does_more_than_the_bound(self):
        """By mechanics: friction of the length mu |n| against the motion across n, wherever the normal and
        the motion are. The term with delta is needed: without it some friction does more."""
        class Of:
            """A region with these rays, in which the contact is known to move, or not."""

            def __init__(self, rays, moving):
                self.rays, self.known = rays, moving

            def generators(self):
                return [(ray, 0) for ray in self.rays]

            def moving(self):
                return self.known

            def bars(self, _):
                return False

        rng = random.Random(19)
        beyond = {True: 0, False: 0}
        for trial in range(48):
            moves = trial % 4 > 0
            contact = naive_space.Contact.of_file(
                rng.choice(NORMALS), [(rng.randint(-1, 1),) * 2 for _ in range(3)],
                (Fraction(1), Fraction(1) + rng.randint(0, 1)), (0, 0), (1, 1),
                slope=rng.choice([Fraction(1, 20), Fraction(1, 4), Fraction(3, 4)]))
            (term,) = box_of([contact], [(0, 0)] * 6, None).terms
            main = [rng.randint(-9, 9) for _ in range(6)]
            rays = [tuple(c + rng.randint(-3, 3) for c in main) + (1, 0) for _ in range(rng.randint(1, 4))]
            region = Of(rays, [term] if moves else [])
            for turn in range(4):
                y = random_twist(rng)
                bound = term.alpha(region, rays, y)
                if trial < 8 and turn == 0:  # its roots take long
                    self.assertEqual(bound, contact.alpha(y, tuple(rays), moves))
                tilt, term.tilt = term.tilt, Fraction(0)
                careless = float(term.alpha(region, rays, y))
                term.tilt = tilt
                for _ in range(12):
                    q = {name: low + (high - low) * Fraction(rng.choice([0, 8, rng.randint(0, 8)]), 8)
                         for name, (low, high) in contact.ends.items()}
                    p = (q["x"], q["y"], q["z"])
                    n = naive_space.turned(contact.normal, q["turn_u"], q["turn_v"])
                    x = [0] * 6
                    for r in rng.choices(rays, k=rng.randint(1, 3)):
                        x = naive_space.plus(x, r[:6])
                    s, z = naive_space.slip(n, p, x), naive_space.slip(n, p, y)
                    if not any(s):
                        continue
                    along = (-float(naive.dot(s, z)) / math.hypot(*s)) if moves else math.hypot(*z)
                    work = (float(naive.dot(n, naive_space.velocity(y, p)))
                            + float(q["friction"]) * math.hypot(*n) * along)
                    self.assertLessEqual(work, float(bound) + 1e-9)
                    beyond[moves] += work > careless + 1e-9
        self.assertGreater(min(beyond.values()), 3, beyond)

    def test_nothing_refutes_the_home_of_a_multiple(self):
        """Equilibria for a multiple, with rational directions of slip."""
        rng = random.Random(15)
        slipped = 0
        for _ in range(200):
            contacts = [margin_contact(rng, [(0, 0, 1), (0, -2, 0), (1, 2, 2), (0, 3, 4)], 128)
                        for _ in range(rng.randint(1, 3))]
            x = (*(Fraction(rng.choice([-1, 0, 0, 1]), 2) for _ in range(6)), Fraction(1),
                 Fraction(rng.randint(0, 3), 2))
            growth = tuple(Fraction(rng.choice([-1, 0, 0, 0, 1])) for _ in range(6))
            wrench = check.times(-x[7], growth)
            for i, contact in enumerate(contacts):
                n, (p,), (s,) = contact.normal, contact.positions(), contact.slips(x)
                ratio = naive_space.root_of(contact.square / naive.dot(s, s)) if any(s) else Fraction(0)
                if ratio is None:
                    contact = contacts[i] = contact.cut("friction", 0, 0)
                a, mu = max(0, contact.v(x)[0]), contact.ends["friction"][0]
                slipped += a * mu > 0 and any(s)
                wrench = check.plus(wrench, -a, check.at(p, tuple(
                    c - mu * (ratio or 0) * e for c, e in zip(n, s))))
            ends = []
            for sign in (-1, 1):
                end = max(Fraction(0), x[7] + Fraction(sign * rng.randint(0, 2), 2))
                ends.append((end, end != x[7] and rng.random() < 0.5))
            walk = Walk(rng, contacts, [(c, c) for c in wrench], growth, ends)

            def home(what):
                if isinstance(what, int):
                    return int(any(contacts[what].slips(x)[0]))
                return int(check.dot(what, x) < 0)

            for _ in range(rng.randint(0, 6)):
                walk.step(home)
            for y in (check.zeros(6), check.times(-1, wrench), check.times(-1, growth),
                      random_twist(rng)):
                self.assertIsNotNone(check.leaf_refusal(walk.region, y, lambda x: x))
        self.assertGreater(slipped, 50)


class ConeTest(unittest.TestCase):
    def test_in_seven_coordinates(self):
        """Regions by brute force, with slips that are 0."""
        rng = random.Random(12)
        for _ in range(12):
            conditions = [(tuple(rng.randint(-1, 1) for _ in range(7)), rng.random() < 0.3)
                          for _ in range(8)]
            lines, rays = naive.generators(conditions, 7)
            cone = check.Cone([tuple(int(j == k) for k in range(7)) for j in range(7)], [], 0)
            for a, equality in conditions:
                cone = cone.cut(a, equality)
            self.assertEqual(len(cone.lines), len(lines))
            found = [frozenset(k for k in range(8) if zero >> k & 1) for _, zero in cone.rays]
            self.assertEqual(sorted(map(sorted, found)), sorted(map(sorted, rays)))


if __name__ == "__main__":
    unittest.main()
