# SPDX-License-Identifier: MIT
"""Grasps in space (certificate/FORMAT.md, section 7): what is read, every rule made to fail alone, the
two false proofs, and a twin. Both checkers.
"""

import collections
import glob
import itertools
import json
import math
import os
import random
import re
import unittest
from fractions import Fraction

import naive
import naive_box
import naive_space
from support import HERE, Case, certificate, check

CORPUS = os.path.join(HERE, "..", "corpus", "space")


def interval(low, high):
    return {"min": low, "max": high}


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

    def test_one_dimension(self):
        """The first contact says it, and others name themselves."""
        self.bad("contacts[1].position: must be an array of 3", FLOOR, {**FLOOR, "position": [0, 0]})
        self.bad("contacts[1].normal: must be an array of 3", FLOOR, {**FLOOR, "normal": [0, 1]})
        self.bad("contacts[0].normal: must be an array of 3", {**FLOOR, "normal": [0, 1]})
        self.bad("contacts[0].position", {**FLOOR, "position": [0] * 4})
        self.bad("wrench: must be an array of 6", FLOOR, wrench=[0, 0, 0])
        planar = {**FLOOR, "position": [0, 0], "normal": [0, 1]}
        self.malformed("contacts[1].position: must be an array of 2",
                       space_file(planar, FLOOR, wrench=[0, 0, 0]), pulled())
        self.malformed("wrench: must be an array of 3", space_file(planar), pulled())
        self.malformed("contacts[0].position", {**PULLED, "format": "stickslip-grasp/1"}, pulled())
        self.malformed("wrench", {**space_file(), "format": "stickslip-grasp/1"}, pulled())

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

    def test_what_is_planar(self):
        self.bad("outline", FLOOR, outline=[[0, 0], [1, 0], [0, 1]])
        self.bad("contacts[1].on", FLOOR, {"on": [0, "1/2"], "friction": 0})
        self.bad("contacts[0].normal", {**FLOOR, "normal": {"direction": [0, 0, 1], "slope": 0}})
        self.bad("contacts[0].normal", {**FLOOR, "normal": [0, interval(0, 1), 1]})
        self.bad("contacts[0].normal: must not be zero", {**FLOOR, "normal": [0, "0/3", 0]})

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
    def test_options(self):
        self.accepts(space_file(FLOOR), pulled(), "--wrench", "0,0,3,0,0,0")
        self.accepts(space_file(FLOOR), pulled(preload=2), "--wrench=0,0,3,0,0,0", "--preload", "2")
        self.rejects("question-wrench", space_file(FLOOR), pulled())
        for options in (("--wrench", "0,0,3"), ("--direction", "0,0,1"),
                        ("--direction", "0,0,0,0,0,0"), ("--preload-direction", "1,1"),
                        ("--direction", "0,0,1,0,0,0", "--uncertain", "friction=10%"),
                        ("--uncertain", "normal=0.1"), ("--uncertain", "normal=0")):
            self.malformed("the question", PULLED, pulled(), *options)
        planar = space_file({**FLOOR, "position": [0, 0], "normal": [0, 1]}, wrench=[0, 3, 0])
        for name in ("--wrench", "--direction"):
            self.malformed("the question", planar, pulled(), name, "0,3,0,0,0,0")

    def test_a_certificate_of_the_other_dimension(self):
        planar = space_file({**FLOOR, "position": [0, 0], "normal": [0, 1]}, wrench=[0, 3, 0])
        self.malformed("question.wrench", planar, pulled())
        self.malformed("question.wrench", PULLED, certificate(1, [0, 3, 0], tree=[["leaf", 0, -1, 0]]))

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
                      ["stable", 0, 1, {**CUBE_PROOF, "walls": []}],
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
        for key, value in (("twist", [0] * 3), ("walls", []), ("direction", UNIT[:3]),
                           ("walls", [[1, 0, 0]] * 3), ("direction", [[0] * 5] * 6)):
            self.bad("parts[0]", stable(1, PULL, [{**CUBE_PROOF, key: value}]))


class WitnessTest(Case):
    """The floor under (3, 4) to the sides and 10 down, with friction 1/2: it slips if v is 10."""

    LOAD = [3, 4, -10, 0, 0, 0]

    def at(self, twist, shares=(), load=None, **contact):
        load = load or self.LOAD
        return (space_file({**FLOOR, **contact}, wrench=load),
                certificate(1, load, twist=twist, shares=list(shares)))

    def test_slip(self):
        self.accepts(*self.at([3, 4, -9, 0, 0, 0]))
        self.accepts(*self.at(["3/7", "4/7", -9, 0, 0, "1/3"]))
        self.rejects("witness-balance", *self.at([4, 3, -9, 0, 0, 0]))
        self.rejects("witness-balance", *self.at([-3, -4, -9, 0, 0, 0]))
        self.rejects("witness-share", *self.at([3, 4, -9, 0, 0, 0], [[0, [0, 0, 0]]]))

    def test_root(self):
        self.rejects("witness-root", *self.at([1, 1, -9, 0, 0, 0]))
        # Before the balance, and only where there is friction.
        self.rejects("witness-root", *self.at([1, 1, -8, 0, 0, 0]))
        self.accepts(*self.at([1, 1, -9, 0, 0, 0], load=[0, 0, -10, 0, 0, 0], friction=0))
        self.accepts(*self.at([1, 1, 9, 0, 0, 0], load=[0] * 6))
        # Of (1, 1, 0) the length is irrational, and so is that of a slip (0, 0, 1) over it ...
        wall = {"normal": [1, 1, 0], "position": [0, 0, 0], "preload": 0}
        self.rejects("witness-root", *self.at([-1, -1, 1, 0, 0, 0], load=[-1, -1, 0, 0, 0, 0], **wall))
        # ... but not that of (1, -1, 0): a = 1/2 * 2 = 1, and f = -1/2 (1, -1, 0).
        self.accepts(*self.at([0, -2, 0, 0, 0, 0], load=["-1/2", "-3/2", 0, 0, 0, 0], **wall))

    def test_share(self):
        still = [0, 0, -9, 0, 0, 0]
        self.accepts(*self.at(still, [[0, ["-3/5", "-4/5", 0]]]))
        # The share is over the length of the normal: with (0, 0, 2) a = 5, and up to 2 is allowed.
        self.accepts(*self.at(still, [[0, ["-6/5", "-8/5", 0]]], normal=[0, 0, 2]))
        rule = "witness-share"
        self.rejects(rule, *self.at(still, [[0, ["-3/5", "-4/5", "1/100"]]]))
        self.rejects(rule, *self.at(still, [[0, ["-3/5", "-401/500", 0]]]))
        self.rejects(rule, *self.at(still, [[0, ["-6/5", "-801/500", 0]]], normal=[0, 0, 2]))
        self.rejects(rule, *self.at(still, [[1, [0, 0, 0]]]))
        self.rejects(rule, *self.at(still, [[0, [0, 0, 0]], [0, [0, 0, 0]]]))
        self.rejects("witness-balance", *self.at(still, [[0, ["-3/5", "-3/5", 0]]]))
        self.rejects("witness-balance", *self.at(still))

    def test_torque(self):
        """The same force at (1, 2, 3)."""
        load = [3, 4, -10, -32, 19, -2]
        self.accepts(*self.at([3, 4, -9, 0, 0, 0], load=load, position=[1, 2, 3]))
        self.rejects("witness-balance", *self.at([3, 4, -9, 0, 0, 0], load=[*load[:5], -3],
                                                 position=[1, 2, 3]))

    def test_rotation_moves_the_point(self):
        """At (0, 1, 0) a turn about z by -3 is a slip of 3 along x."""
        load = [5, 0, -10, -10, 0, -5]
        self.accepts(*self.at([0, 0, -9, 0, 0, -3], load=load, position=[0, 1, 0]))
        self.rejects("witness-balance", *self.at([0, 0, -9, 0, 0, 3], load=load, position=[0, 1, 0]))

    def test_laws_and_boxes(self):
        grasp, proof = self.at([0, 0, 9, 0, 0, 0], load=[0] * 6)
        self.accepts(grasp, proof)
        proof["question"]["normal_law"] = "bilateral"
        self.rejects("witness-normal", grasp, proof, "--normal-law", "bilateral")
        grasp, proof = self.at([3, 4, -9, 0, 0, 0], friction=interval("1/2", 1))
        self.rejects("witness-box", grasp, proof)


# FORMAT.md, section 7: false proofs, of grasps that are stable.
LENGTH = space_file({"position": [0] * 3, "normal": [0, 0, 2], "friction": "1/2", "preload": 1},
                    wrench=["2/5", 0, -1, 0, 0, 0])
OPPOSITE = space_file({"position": [0] * 3, "normal": [0, 0, 1], "friction": 1, "preload": 1},
                      wrench=[0, "-1/2", -1, 0, 0, 0])
ACROSS = [["plane", 0, 1, 0, 0, 0, 0, 0], ["plane", 1, 0, 0, 0, 0, 0, 1], ["plane", -1, 0, 0, 0, 0, 0, 1],
          *[["leaf", 0, 1, 0, 0, 0, 0]] * 3, ["plane", 1, 0, 0, 0, 0, 0, 0],
          ["leaf", 1, -1, 1, 0, 0, 0], ["leaf", -1, -1, 1, 0, 0, 0]]


class FalseProofTest(Case):
    def test_the_length_of_the_normal(self):
        wrench = LENGTH["wrench"]
        self.rejects("leaf-bound", LENGTH, certificate(1, wrench, tree=[["leaf", -4, 0, -1, 0, 0, 0]]),
                     node=0, path="root")
        self.accepts(LENGTH, certificate(1, wrench, twist=[0] * 6, shares=[[0, ["-8/5", 0, 0]]]))

    def test_opposite_slips(self):
        wrench = OPPOSITE["wrench"]
        self.rejects("leaf-bound", OPPOSITE, certificate(1, wrench, tree=ACROSS), node=3,
                     path="plane +, plane +, plane +")
        self.accepts(OPPOSITE, certificate(1, wrench, twist=[0] * 6, shares=[[0, [0, "1/2", 0]]]))


class TreeTest(Case):
    def test_steps(self):
        """Where each step leads, by a list that ends there."""
        two = space_file(FLOOR, {**FLOOR, "normal": [1, 2, 2], "preload": 0}, wrench=PULL)
        for tree, path in (([["slip", 1]], "slip 1 0"), ([["slip", 1], *UP], "slip 1 not 0"),
                           ([["slip", 1], *UP, ["slip", 0], *UP], "slip 1 not 0, slip 0 not 0"),
                           ([["separation", 1]], "separation 1 closed"),
                           ([["plane", *[1] * 7], *UP], "plane -")):
            self.rejects("tree-short", two, certificate(2, PULL, tree=tree), node=len(tree), path=path)
            self.accepts(two, certificate(2, PULL, tree=tree + UP * (
                1 + sum(node[0] != "leaf" for node in tree) - sum(node[0] == "leaf" for node in tree))))
        self.rejects("node-contact", two, certificate(2, PULL, tree=[["slip", 2]]), node=0, path="root")
        self.rejects("tree-long", two, certificate(2, PULL, tree=UP * 2), node=1)
        deep = [["slip", 0], ["leaf", *PULL]] * 300
        self.rejects("node-depth", PULLED, pulled([["slip", 0], *UP] * 260), node=517,
                     path=", ".join(["slip 0 not 0"] * 258 + ["slip 0 0"]))
        self.rejects("leaf-bound", PULLED, pulled(deep), node=1, path="slip 0 0")

    def test_a_strict_slip_bars(self):
        """Behind slip 0 0, where no motion slips, slip 0 not 0 holds nothing."""
        void = ["leaf", *[0] * 6]
        self.accepts(PULLED, pulled([["slip", 0], ["slip", 0], *UP, void, *UP]))
        self.rejects("leaf-bound", PULLED, pulled([["slip", 0], ["slip", 0], void, void, *UP]), node=2,
                     path="slip 0 0, slip 0 0")

    def test_node_certain(self):
        def split(kind, rule, **changes):
            file, proof = space_file({**FLOOR, **changes}, wrench=PULL), pulled([[kind, 0], *UP, *UP])
            if rule:
                self.rejects(rule, file, proof, node=0, path="root")
            else:
                self.accepts(file, proof)

        along, across = [0, 0, interval(0, 1)], [interval(0, 1), 0, 0]
        split("slip", "node-certain", position=along)
        split("slip", "node-certain", position=across)
        split("slip", None, friction=interval(0, 1), preload=interval(0, 1), stiffness=interval(1, 2))
        # Along the normal N does not change.
        split("separation", None, position=along)
        split("separation", "node-certain", position=across)
        split("separation", "node-certain", preload=interval(0, 1))
        split("separation", "node-certain", stiffness=interval(1, 2))
        split("separation", None, stiffness=interval(1, 2), preload=0)

    def test_parts(self):
        file = space_file({**FLOOR, "position": [0, interval(0, 1), interval(0, 2)]},
                          wrench=[0, 0, 3, 0, 0, interval(0, 1)])
        load = [0, 0, 3, 0, 0, [0, 1]]
        tree = [["part", "z", 0, 1], ["part", "wrench", 5, "1/2"], *UP * 3]
        self.accepts(file, pulled(tree, load))
        self.rejects("tree-short", file, pulled(tree[:3], load), node=3, path="z 0 low, wrench 5 high")
        for name, i in (("z", 1), ("wrench", 6)):
            self.rejects("part-contact", file, pulled([["part", name, i, 1]], load), node=0, path="root")
        for name, i, cut in (("x", 0, 0), ("y", 0, 1), ("z", 0, 2), ("friction", 0, "1/2"),
                             ("wrench", 4, 0)):
            self.rejects("part-inside", file, pulled([["part", name, i, cut]], load), node=0, path="root")

    def test_what_moves(self):
        """The floor of length 1 is pushed along x with friction 1: it moves, and not back, where
        d_x >= h and |d_y| <= d_x, and then friction does no work on (1, 0, ...) that is above 0."""
        file = space_file({**FLOOR, "friction": 1}, wrench=["1/8", 0, -1, 0, 0, 0])
        moved = [["plane", 1, 0, 0, 0, 0, 0, -1], ["plane", 1, 1, 0, 0, 0, 0, 0],
                 ["plane", 1, -1, 0, 0, 0, 0, 0], ["leaf", 1, 0, "1/2", 0, 0, 0]]
        path = "plane +, plane +, plane +"
        # There friction is at most -1/sqrt(2) < -1/2 along x: 1/2 - 0.707 < 0, and 1/8 - 1/2 < 0.
        self.rejects("tree-short", file, certificate(1, file["wrench"], tree=moved), node=4,
                     path="plane +, plane +, plane -")
        worse = moved[:-1] + [["leaf", 1, 0, "3/4", 0, 0, 0]]
        self.rejects("leaf-bound", file, certificate(1, file["wrench"], tree=worse), node=3, path=path)
        back = moved[:-1] + [["leaf", -1, 0, "-1/2", 0, 0, 0]]
        self.rejects("leaf-bound", file, certificate(1, file["wrench"], tree=back), node=3, path=path)
        # Where d_x >= 0, only a strict slip says that it moves: |d_y| <= d_x, d not 0.
        cone = [["plane", 1, 1, 0, 0, 0, 0, 0], ["plane", 1, -1, 0, 0, 0, 0, 0]]
        leaf = [["leaf", 1, 0, "1/2", 0, 0, 0]]
        self.rejects("leaf-bound", file, certificate(1, file["wrench"], tree=cone + leaf), node=2,
                     path="plane +, plane +")
        strict = certificate(1, file["wrench"], tree=[["slip", 0], ["leaf", *[0] * 6], *cone, *leaf])
        self.rejects("leaf-bound", file, strict, node=1, path="slip 0 0")
        strict["tree"] = [*cone, ["slip", 0], ["plane", 0, 0, -1, 0, 0, 0, 0],
                          ["leaf", *[0] * 6], ["leaf", *[0] * 6], *leaf]
        self.rejects("leaf-bound", file, strict, node=4, path="plane +, plane +, slip 0 0, plane +")

    def test_roots_are_bounded_from_above(self):
        """Friction 1 along (1, 1, 0) is irrational: y = (-1, -1, -a, ...) holds from a = sqrt(2) on, up
        to the bound with 64 bits."""
        low = math.isqrt(2 << 126)
        for a, good in ((Fraction(low, 1 << 63), False), (Fraction(low + 1, 1 << 63), True)):
            wrench = [3, 3, -1, 0, 0, 0]
            proof = certificate(1, wrench, tree=[["leaf", -1, -1, str(-a), 0, 0, 0]])
            file = space_file({**FLOOR, "friction": 1}, wrench=wrench)
            if good:
                self.accepts(file, proof)
            else:
                self.rejects("leaf-bound", file, proof, node=0, path="root")


UNIT = [[int(j == k) for k in range(6)] for j in range(6)]
# A cube with a contact in the middle of each face. The walls are d = +-1/2 and +-1 for turns.
CUBE = [{"position": [-c for c in n], "normal": n, "friction": "1/10", "preload": 1}
        for n in ([1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1])]
WALL_LEAVES = [["leaf", *[sign * c for c in row]] for row in UNIT for sign in (1, -1)]
CUBE_PROOF = {"twist": [0] * 6,
              "walls": [[(1 + (j < 3)) * c for c in row] for j, row in enumerate(UNIT)],
              "direction": UNIT, "tree": WALL_LEAVES}


def stable(m, wrench, parts, **question):
    proof = certificate(m, wrench, twist=[0] * 6, **question)
    del proof["twist"], proof["shares"]
    return {**proof, "parts": parts}


# The same, smooth below and above: friction holds torques about z up to 2/5 of the preloads. That N.d is
# without rotations makes two walls push with the same sum, as long as none of them opens; and if one
# does, the other is not balanced.
TURN = [0, 0, 0, 0, 0, 1]
TURNED = space_file(*[{**c, "friction": "1/10" if k < 4 else 0} for k, c in enumerate(CUBE)])


def turned(x=4, z="1/4", lists=2, **changes):
    """A part; x and z are rows of E for translations, and for turns about z."""
    walls = [[c and x for c in row] for row in UNIT[:3]] + UNIT[3:5] + [[0] * 5 + [z]]
    return {**CUBE_PROOF, "walls": walls, "tree": WALL_LEAVES * lists, **changes}


def slack(splits, leaf):
    """A tree that tells which walls open; `leaf` makes a leaf of the sides where they do."""
    def along_y(x):
        return [splits[2], splits[3], leaf(x, 0), leaf(x, -1), leaf(x, 1)]

    return [splits[0], splits[1], *along_y(0), *along_y(-1), *along_y(1)]


SLACK = slack([["separation", i] for i in range(4)],
              lambda x, y: ["leaf", x, y, 0, 0, 0, 0] if x or y else ["leaf", *[-c for c in TURN]])


class MarginTest(Case):
    ASKED = ("--direction", "0,0,0,0,0,1")

    def margin(self, *claims, m=6, wrench=None, **question):
        if not question:
            question = {"direction": TURN}
        return certificate(m, [0] * 6 if wrench is None else wrench, intervals=list(claims), **question)

    def test_accepted(self):
        proof = self.margin(["stable", 0, "3/8", turned()], ["unstable", "2/5", None, SLACK])
        text = self.accepts(TURNED, proof, *self.ASKED)
        self.assertEqual(text.split("\n")[1:], [
            "resisted    [0, 3/8]", "refuted     (2/5, oo)", "elsewhere   nothing is claimed",
            "contacts    6", "wrench      (0, 0, 0, 0, 0, 0)", "direction   (0, 0, 0, 0, 0, 1)",
            "preload     as in the grasp file", "normal law  unilateral",
            "proof       intervals by degree: 1, refuted: 1; trees of 41 nodes: 33 leaves", ""])
        _, report, _, _ = self.run_both(TURNED, proof, *self.ASKED)
        self.assertEqual((report["verdict"], report["box"], report["resisted"], report["refuted"]),
                         ("margin", False, [["0", "3/8"]], [["2/5", None, False]]))
        proof["question"]["normal_law"] = "bilateral"
        self.accepts(TURNED, proof, *self.ASKED, "--normal-law", "bilateral")
        # There nothing opens.
        whole = self.margin(["unstable", "2/5", None, SLACK[4:5]])
        self.rejects("leaf-bound", TURNED, whole, *self.ASKED, node=0, path="interval 0")
        whole["question"]["normal_law"] = "bilateral"
        self.accepts(TURNED, whole, *self.ASKED, "--normal-law", "bilateral")
        nothing = self.accepts(TURNED, self.margin(), *self.ASKED)
        self.assertIn("\nresisted    none claimed\nrefuted     none claimed\n", nothing)

    def test_what_is_not_so(self):
        early = self.margin(["unstable", "399/1000", None, SLACK])
        self.rejects("leaf-bound", TURNED, early, *self.ASKED, node=4,
                     path="interval 0, separation 0 closed, separation 1 closed, "
                          "separation 2 closed, separation 3 closed")
        # The walls are too near for this one, and list 1 says so. At 9/20, list 2 does.
        self.rejects("leaf-bound", TURNED, self.margin(["stable", 0, "2/5", turned()]), *self.ASKED,
                     node=10, path="interval 0, wall 6 +")
        point = self.margin(["stable", "9/20", "9/20", turned(lists=1)])
        self.rejects("leaf-bound", TURNED, point, *self.ASKED, node=10,
                     path="interval 0, middle wall 6 +")
        # The multiple does not go below 0, nor does it in a part.
        below = self.margin(["stable", 0, "3/8", turned()], ["unstable", "3/8", None, SLACK])
        self.rejects("leaf-bound", TURNED, below, *self.ASKED, node=4,
                     path="interval 1, separation 0 closed, separation 1 closed, "
                          "separation 2 closed, separation 3 closed")

    def test_lists(self):
        """List 1 is left out where there is one multiple, of one point."""
        point = self.margin(["stable", "1/8", "1/8", turned(lists=1)])
        self.accepts(TURNED, point, *self.ASKED)
        self.rejects("tree-long", TURNED, self.margin(["stable", 0, 0, turned()]), *self.ASKED,
                     node=12, path="interval 0")
        self.rejects("tree-short", TURNED, self.margin(["stable", 0, "1/8", turned(lists=1)]),
                     *self.ASKED, node=12, path="interval 0, middle wall 1 +")
        for rule, changes in (("degree-walls", {"walls": [UNIT[0], *UNIT[:5]]}),
                              ("degree-direction", {"direction": [UNIT[0], *UNIT[:5]]})):
            self.rejects(rule, TURNED, self.margin(["stable", 0, 0, turned(**changes)]), *self.ASKED,
                         path="interval 0")
        away = turned(direction=[*UNIT[:5], [0, 0, 0, 0, 0, -1]])
        self.rejects("leaf-direction", TURNED, self.margin(["stable", 0, "1/8", away]), *self.ASKED,
                     node=22, path="interval 0, middle wall 6 +")
        for tree, rule, node, path in (
                (SLACK[:-1], "tree-short", 16, "interval 0, separation 0 open, separation 2 open"),
                ([*SLACK, SLACK[4]], "tree-long", 17, "interval 0"),
                ([["slip", 6]], "node-contact", 0, "interval 0"),
                ([], "tree-short", 0, "interval 0")):
            self.rejects(rule, TURNED, self.margin(["unstable", 1, None, tree]), *self.ASKED,
                         node=node, path=path)

    def test_touching_claims(self):
        halves = [["stable", low, high, turned()] for low, high in ((0, "1/4"), ("1/4", "3/8"))]
        rest = [["unstable", low, high, SLACK] for low, high in (("2/5", 1), (1, 2), (3, None))]
        _, report, text, _ = self.run_both(TURNED, self.margin(*halves, *rest), *self.ASKED)
        self.assertIn("\nresisted    [0, 3/8]\nrefuted     (2/5, 1), (1, 2), (3, oo)\n", text)
        self.assertIn("intervals by degree: 2, refuted: 3;", text)
        self.assertEqual(report["resisted"], [["0", "3/8"]])
        apart = self.margin(halves[0], ["stable", "1/3", "3/8", turned()])
        self.assertIn("resisted    [0, 1/4], [1/3, 3/8]\n", self.accepts(TURNED, apart, *self.ASKED))

    def test_a_plane_between_ranges(self):
        """What two claims say one can, and also of the multiple between."""
        at = ["plane", *[0] * 6, -1, 1]
        both = self.margin(["unstable", "2/5", None, [at, *SLACK, *SLACK]])
        self.assertIn("refuted     (2/5, oo)\n", self.accepts(TURNED, both, *self.ASKED))
        self.rejects("tree-short", TURNED, self.margin(["unstable", "2/5", None, [at, *SLACK]]),
                     *self.ASKED, node=18, path="interval 0, plane -")

    def test_order(self):
        def stands(*claims):
            """The claim that is not in order, or None: by its places on the line alone."""
            for k, (kind, low, high, _) in enumerate(claims):
                end = math.inf if high is None else high
                ends = [math.inf if c[2] is None else c[2] for c in claims[:k]]
                if low < 0 or end < low or (kind == "unstable" and end == low) or any(
                        e > low for e in ends):
                    return k
            return None

        rng = random.Random(31)
        ends = (-1, 0, 1, 2, None)
        ranges = [["unstable", low, high, UP] for low in ends[:4] for high in ends]
        forth = [["unstable", low, high, UP] for low, high in itertools.combinations(ends[1:], 2)]
        pairs = list(itertools.product(forth, repeat=2))
        triples = [rng.choices(forth, k=3) for _ in range(30)] + [[forth[k] for k in (0, 3, 5)]]
        asked = ("--preload", "0", "--direction", "0,0,1,0,0,0")
        tally = set()
        self.assertEqual([one[1:3] for one in triples[-1]], [[0, 1], [1, 2], [2, None]])
        for claims in [*([one] for one in ranges), *pairs, *triples]:
            wrong = stands(*claims)
            proof = self.margin(*claims, m=1, preload=0, direction=[0, 0, 1, 0, 0, 0])
            if wrong is None:
                self.accepts(PULLED, proof, *asked)
            else:
                self.rejects("interval-order", PULLED, proof, *asked, path=f"interval {wrong}")
            tally.add((len(claims), wrong))
        self.assertEqual(len(tally), 7, tally)
        for claims, wrong in (([["stable", 1, "1/2", turned()]], 0),
                              ([["stable", "-1/8", 0, turned()]], 0),
                              ([["stable", 0, "1/8", turned()], ["stable", 0, "1/8", turned()]], 1),
                              ([["stable", 0, "1/8", turned()], ["unstable", "1/9", 1, SLACK]], 1)):
            self.rejects("interval-order", TURNED, self.margin(*claims), *self.ASKED,
                         path=f"interval {wrong}")

    def test_zero(self):
        """Where 0 is refuted."""
        down = ("--wrench", "0,0,3,0,0,0", "--direction", "0,0,-1,0,0,0")
        claims = [["unstable", 0, 1, UP], ["unstable", 1, 3, UP]]
        proof = self.margin(*claims, m=1, wrench=PULL, direction=[0, 0, -1, 0, 0, 0])
        _, report, text, _ = self.run_both(PULLED, proof, *down)
        self.assertIn("refuted     [0, 1), (1, 3)\n", text)
        self.assertEqual(report["refuted"], [["0", "1", True], ["1", "3", False]])
        beyond = self.margin(["unstable", 0, "301/100", UP], m=1, wrench=PULL,
                             direction=[0, 0, -1, 0, 0, 0])
        self.rejects("leaf-bound", PULLED, beyond, *down, node=0, path="interval 0")
        # w = 0: with a preload 0 is among the multiples, and resisted; without one it is not.
        up = ("--direction", "0,0,3,0,0,0")
        self.rejects("leaf-bound", PULLED, self.margin(["unstable", 0, None, UP], m=1, direction=PULL),
                     *up, node=0, path="interval 0")
        for claim, words in ((["unstable", 0, None, UP], "(0, oo)"), (["unstable", 0, 2, UP], "(0, 2)")):
            text = self.accepts(PULLED, self.margin(claim, m=1, preload=0, direction=PULL), *up,
                                "--preload", "0")
            self.assertIn(f"refuted     {words}\n", text)
        # With scaled preloads it is w that counts.
        scaled = self.margin(["unstable", 0, None, UP], m=1, wrench=PULL, preload_direction="scale")
        self.assertIn("refuted     [0, oo)\n",
                      self.accepts(PULLED, scaled, "--preload-direction", "scale"))
        # After a claim about 0 alone, 0 is not meant.
        two = self.margin(["stable", 0, 0, turned(lists=1)], ["unstable", 0, 1, SLACK[4:5]])
        self.rejects("leaf-bound", TURNED, two, *self.ASKED, node=0, path="interval 1")

    def test_preloads(self):
        """It holds a torque of 1 from preloads of 5/2 on."""
        file = {**TURNED, "wrench": TURN}
        part = turned(x="4/3", z="1/8")
        claims = [["unstable", 0, "5/2", SLACK], ["stable", 3, "7/2", part]]
        scaled = ({"wrench": TURN, "preload_direction": "scale"}, ("--preload-direction", "scale"))
        for question, options in (
                scaled, ({"wrench": TURN, "preload": 0, "preload_direction": [1] * 6},
                         ("--preload=0", "--preload-direction", "1,1,1,1,1,1"))):
            text = self.accepts(file, self.margin(*claims, **question), *options)
            self.assertIn("resisted    [3, 7/2]\nrefuted     [0, 5/2)\n", text)
        later = self.margin(["unstable", 0, "251/100", SLACK], **scaled[0])
        self.assertEqual(self.run_both(file, later, *scaled[1])[1]["rule"], "leaf-bound")
        # 1 + f: from 3/2 on.
        grown = self.margin(["unstable", 0, "3/2", SLACK], ["stable", 2, "5/2", part], wrench=TURN,
                            preload_direction=[1] * 6)
        self.accepts(file, grown, "--preload-direction", "1,1,1,1,1,1")
        # Under the bilateral law no contact may open in K, at either end.
        for low, rule in ((3, None), ("5/2", "degree-law")):
            wide = self.margin(["stable", low, 4, turned(x="1/3", z="1/8")], law="bilateral",
                               **scaled[0])
            report = self.run_both(file, wide, *scaled[1], "--normal-law", "bilateral")[1]
            self.assertEqual(report["path"] if report["rule"] == "degree-law" else None,
                             rule and "interval 0")

    def test_whole(self):
        """Scaled preloads and a torque of 3/10 of them hold always, of 1/2 never."""
        part = turned(lists=1)
        for torque, claim, words in (
                ("3/10", ["stable", 0, None, part], "\nresisted    [0, oo)\nrefuted     none claimed\n"),
                ("1/2", ["unstable", 0, None, SLACK], "\nresisted    none claimed\nrefuted     (0, oo)\n")):
            question = {"direction": [0] * 5 + [torque], "preload_direction": "scale"}
            options = ("--direction", f"0,0,0,0,0,{torque}", "--preload-direction", "scale")
            self.assertIn(words, self.accepts(TURNED, self.margin(claim, **question), *options))
        self.rejects("leaf-bound", TURNED, self.margin(["stable", 0, None, part], **question), *options,
                     node=10, path="interval 0, middle wall 6 +")
        question, options = {"direction": TURN}, self.ASKED
        self.rejects("interval-whole", TURNED, self.margin(["stable", 0, None, part]), *self.ASKED,
                     path="interval 0")
        question["preload_direction"], options = "scale", (*options, "--preload-direction", "scale")
        self.rejects("interval-whole", TURNED, self.margin(["stable", "1/2", None, part], **question),
                     *options, path="interval 0")
        self.rejects("interval-whole", {**TURNED, "wrench": [1] * 6},
                     self.margin(["stable", 0, None, part], wrench=[1] * 6, preload_direction="scale"),
                     "--preload-direction", "scale", path="interval 0")
        self.rejects("interval-order", TURNED, self.margin(
            ["stable", 0, None, turned(lists=1)], ["unstable", 1, None, SLACK],
            direction=[0] * 5 + ["3/10"], preload_direction="scale"), "--direction", "0,0,0,0,0,0.3",
            "--preload-direction", "scale", path="interval 1")

    def test_irrational_lengths(self):
        """Turned by 45 degrees, with normals and arms of the length sqrt(2): up to 2/5 sqrt(2). Where a
        wall opens is uncertain: planes tell, beyond it."""
        sides = [[1, 1, 0], [-1, -1, 0], [-1, 1, 0], [1, -1, 0]]
        file = {**TURNED, "contacts": [
            {**c, "normal": n, "position": [-x for x in n]} for c, n in zip(
                TURNED["contacts"], [*sides, *([0, 0, 1], [0, 0, -1])])]}
        rows = [[1, 1, 0, 0, 0, 0], [-1, 1, 0, 0, 0, 0], UNIT[2], [0, 0, 0, 1, 1, 0],
                [0, 0, 0, -1, 1, 0], UNIT[5]]

        def part_of(*sizes):
            return {**CUBE_PROOF, "walls": [[str(c * Fraction(size)) for c in row]
                                            for row, size in zip(rows, sizes)],
                    "tree": [["leaf", *[sign * c for c in row]] for row in rows for sign in (1, -1)] * 2}

        part = part_of("14/5", "14/5", 4, "7/10", "7/10", "1/4")
        tree = slack([["plane", *[-c for c in n], 0, 0, 0, "71/50", 0] for n in sides],
                     lambda x, y: ["leaf", x - y, x + y, 0, 0, 0, 0] if x or y else
                     ["leaf", *[-c for c in TURN]])
        claims = [["stable", 0, "1/2", part], ["unstable", "57/100", None, tree]]
        proof = self.margin(*claims)
        _, report, text, _ = self.run_both(file, proof, *self.ASKED)
        self.assertIn("resisted    [0, 1/2]\nrefuted     (57/100, oo)\n", text)
        self.assertTrue(report["box"])
        with_bits = {"format": 0, "question": 0, "bits": 64, **proof}
        self.accepts(file, with_bits, *self.ASKED)
        self.malformed("bits", file, {**with_bits, "bits": 63}, *self.ASKED)
        self.rejects("node-certain", file, self.margin(["unstable", 1, None, SLACK]), *self.ASKED,
                     node=0, path="interval 0")
        early = self.margin(["unstable", "14/25", None, tree])
        self.assertEqual(self.run_both(file, early, *self.ASKED)[1]["rule"], "leaf-bound")
        # Both lists, even about one multiple.
        self.accepts(file, self.margin(["stable", "1/4", "1/4", part]), *self.ASKED)
        short = {**part, "tree": part["tree"][:12]}
        self.rejects("tree-short", file, self.margin(["stable", 0, 0, short]), *self.ASKED, node=12,
                     path="interval 0, middle wall 1 +")
        # By preloads: P^u' has the interval of P'.
        pressed = {**file, "wrench": TURN}
        tree = [[*n[:-2], 0, "71/50"] if n[0] == "plane" else n for n in tree]
        part = part_of("14/15", "14/15", "4/3", "7/10", "7/10", "1/8")
        ranges = self.margin(["unstable", 0, "7/4", tree], ["stable", 2, "9/4", part], wrench=TURN,
                             preload_direction="scale")
        self.accepts(pressed, ranges, "--preload-direction", "scale")
        # Without preloads nothing is uncertain.
        free = self.margin(["unstable", 0, None, [["separation", 0], *[tree[4]] * 2]], preload=0,
                           direction=TURN)
        _, report, _, _ = self.run_both(file, free, *self.ASKED, "--preload", "0")
        self.assertNotEqual(report["rule"], "node-certain")

    def test_the_end_of_1_over_l_decides(self):
        """A pinch between two normals of the length sqrt(2), with friction 1/2: as long as both push,
        it holds at most 2 P mu, as far as roots are known."""
        pinch = [{"position": [-c for c in n], "normal": n, "friction": "1/2", "preload": 1}
                 for n in ([1, 1, 0], [-1, -1, 0])]
        file = space_file(*pinch)
        up = [0, 0, 1, 0, 0, 0]
        root = naive_space.root_above(Fraction(1, 2))
        tiny = Fraction(1, 10 ** 60)

        def tree(*preload):
            return [["plane", -1, -1, *[0] * 4, *preload], ["plane", 1, 1, *[0] * 4, *preload],
                    ["leaf", *[-c for c in up]], ["leaf", -1, -1, 0, 0, 0, 0],
                    ["leaf", 1, 1, 0, 0, 0, 0]]

        for bits in (64, 128, 200):
            most = 2 * root * naive_box.inverse_length(2, bits)[1]
            grown = ("--preload-direction", "scale")
            for file["wrench"], options, claims, question in (
                    ([0] * 6, ("--direction", "0,0,1,0,0,0"),
                     [["unstable", str(most - less), None, tree("1/2", 0)] for less in (0, tiny)],
                     {"direction": up}),
                    (up, grown, [["unstable", 0, str(1 / most + more), tree(0, "1/2")]
                                 for more in (0, tiny)],
                     {"wrench": up, "preload_direction": "scale"})):
                good, bad = ({"format": 0, "question": 0, "bits": bits,
                              **self.margin(claim, m=2, **question)} for claim in claims)
                self.accepts(file, good, *options)
                self.rejects("leaf-bound", file, bad, *options, node=2,
                             path="interval 0, plane +, plane +")

    def test_one_grasp(self):
        for contact in ({"friction": interval(0, 1)}, {"position": [0, interval(0, 1), 0]}):
            self.malformed("a margin is about one grasp", space_file({**FLOOR, **contact}),
                           self.margin(m=1), *self.ASKED)


# Two fingers: whatever the motion is, their friction holds 2 · 3/10 · 4 = 12/5.
PINCH = space_file(*[{"position": [x, 0, 0], "normal": [-x // 2, 0, 0], "friction": "3/10", "preload": 4}
                     for x in (-2, 2)])
DOWN = [0, 0, -1, 0, 0, 0]
PINCHED = [["separation", 0], ["separation", 1], ["leaf", 0, 0, 1, 0, 0, 0],
           ["leaf", -1, 0, 0, 0, 0, 0], ["leaf", 1, 0, 0, 0, 0, 0]]


def point(*shares, twist=(0,) * 6):
    return {"twist": list(twist), "shares": [[i, list(share)] for i, share in shares]}


def held(share):
    """Both fingers have it."""
    return point(*((i, [0, 0, share]) for i in range(2)))


class PointsTest(Case):
    ASKED = ("--direction", "0,0,-1,0,0,0")
    WHOLE = (*ASKED, "--preload-direction", "scale")

    def margin(self, *claims, m=2, **question):
        return MarginTest.margin(self, *claims, m=m, **question or {"direction": DOWN})

    def test_accepted(self):
        proof = self.margin(["stable", 0, "12/5", held(0), held(1)], ["unstable", "12/5", None, PINCHED])
        _, report, text, _ = self.run_both(PINCH, proof, *self.ASKED)
        self.assertIn("\nresisted    [0, 12/5]\nrefuted     (12/5, oo)\nelsewhere   nothing", text)
        self.assertIn("intervals by degree: 0, refuted: 1; trees of 5 nodes: 3 leaves\n", text)
        self.assertEqual((report["resisted"], report["nodes"]), ([["0", "12/5"]], 5))
        proof["question"]["normal_law"] = "bilateral"
        self.accepts(PINCH, proof, *self.ASKED, "--normal-law", "bilateral")

    def test_touching_claims(self):
        parts = self.margin(["stable", 0, 1, held(0), held("5/12")],
                            ["stable", 1, "12/5", held("5/12"), held(1)])
        self.assertIn("resisted    [0, 12/5]\n", self.accepts(PINCH, parts, *self.ASKED))
        turn = [point(*((i, [str(share * c) for c in around]) for i, around in enumerate(
            ([0, 1, 0], [0, -1, 0], [-1, 0, 0], [1, 0, 0])))) for share in (Fraction(5, 8), Fraction(1))]
        both = self.margin(["stable", 0, "1/4", turned()], ["stable", "1/4", "2/5", *turn],
                           ["unstable", "2/5", None, SLACK], m=6, direction=TURN)
        text = self.accepts(TURNED, both, *MarginTest.ASKED)
        self.assertIn("\nresisted    [0, 2/5]\nrefuted     (2/5, oo)\n", text)
        self.assertIn("intervals by degree: 1, refuted: 1;", text)

    def test_one_point(self):
        half = held("5/24")
        self.assertIn("resisted    [1/2, 1/2]\n", self.accepts(
            PINCH, self.margin(["stable", "1/2", "2/4", half]), *self.ASKED))
        self.rejects("witness-balance", PINCH, self.margin(["stable", 0, 0, half]), *self.ASKED,
                     path="interval 0, first point")
        # For all multiples: of the preloads, and of half of what these hold.
        whole = {"direction": DOWN, "preload_direction": "scale"}
        self.assertIn("resisted    [0, oo)\n", self.accepts(
            PINCH, self.margin(["stable", 0, None, held("5/12")], **whole), *self.WHOLE))
        self.rejects("witness-balance", PINCH, self.margin(["stable", 0, None, half], **whole),
                     *self.WHOLE, path="interval 0, first point")
        for low, question, options in ((0, {"direction": DOWN}, self.ASKED), (1, whole, self.WHOLE)):
            self.rejects("interval-whole", PINCH, self.margin(
                ["stable", low, None, held("5/12")], **question), *options, path="interval 0")

    def test_syntax(self):
        a, b = held(0), held(1)
        for claim in (["stable", 0, 1, a], ["stable", 1, 1, a, a], ["stable", "1/2", "2/4", a, a],
                      ["stable", 0, None, a, a], ["stable", 0, 1, a, b, b], ["stable", 0, 1],
                      ["stable", 2, 1, a], ["stable", None, 1, a, b], ["stable", 0, 1, a, turned()],
                      ["stable", 0, 1, turned(), a], ["stable", 0, 1, turned(), turned()],
                      ["unstable", 0, 1, a], ["unstable", 0, 1, a, b], ["unstable", 0, 1, UP, UP],
                      ["stable", 0, 1, a, []], ["stable", 0, 1, [], b], ["stable", 0, 1, a, None],
                      *(["stable", 0, 0, bad] for bad in (
                          without(a, "twist"), without(a, "shares"), {**a, "tree": []}, {**turned(), **a},
                          dict(reversed(a.items())), {**a, "twist": [0] * 5}, {**a, "shares": {}},
                          {**a, "shares": [[0, 1]]}, {**a, "shares": [[0, [0, 0]]]}, [0, *a.values()]))):
            self.malformed("intervals[1]", PINCH, self.margin(["stable", 0, 0, a], claim), *self.ASKED)
        once = json.dumps(self.margin(["stable", 0, 0, point()]))
        self.accepts(PINCH, once, *self.ASKED)
        self.malformed("intervals[0]", PINCH, once.replace('"shares": []', '"shares": [], "shares": []'),
                       *self.ASKED)

    def test_rules_of_points(self):
        """At each end, where the rules before it hold."""
        good = (held(0), held(1))
        apart, aslant = point(twist=[5, 0, 0, 0, 0, 0]), point(twist=[0, 1, 2, 0, 0, 0])
        for rule, bad in (("witness-share", point((1, [0, 0, 1]), (0, [0, 0, 1]))),
                          ("witness-share", point((2, [0, 0, 1]))),
                          ("witness-share", point((0, [1, 0, 0]))),
                          ("witness-share", point((0, [0, "4/5", "4/5"]))),
                          ("witness-share", {**aslant, "shares": good[1]["shares"]}),
                          ("witness-normal", apart), ("witness-root", aslant),
                          ("witness-balance", held("1/2"))):
            for k, name in enumerate(("first", "second")):
                claim = ["stable", 0, "12/5", *good]
                claim[3 + k] = bad
                proof = self.margin(claim, law="bilateral", direction=DOWN)
                self.rejects(rule, PINCH, proof, *self.ASKED, "--normal-law", "bilateral",
                             path=f"interval 0, {name} point")
        # Nor do they hold more, or at another end; and the first of what is wrong is named.
        for claims, rule, path in (
                ([["stable", 0, "13/5", *good]], "witness-balance", "interval 0, second point"),
                ([["stable", 0, "13/5", held(0), point((0, [0, 0, "7/6"]), (1, [0, 0, 1]))]],
                 "witness-share", "interval 0, second point"),
                ([["stable", 0, "12/5", *reversed(good)]], "witness-balance", "interval 0, first point"),
                ([["stable", 0, 1, held(0), apart], ["stable", 0, 1, *good]], "witness-balance",
                 "interval 0, second point"),
                ([["stable", 1, 0, apart, apart]], "interval-order", "interval 0")):
            self.rejects(rule, PINCH, self.margin(*claims), *self.ASKED, path=path)

    def test_no_box(self):
        sloped = space_file(*({**c, "normal": [c["normal"][0], 1, 0]} for c in PINCH["contacts"]))
        for claim in (["stable", 0, 1, held(0), held(1)], ["stable", 0, 0, held(0)]):
            self.rejects("witness-box", sloped, self.margin(claim), *self.ASKED,
                         path="interval 0, first point")
        # Without preloads the lengths of normals play no part.
        self.accepts(sloped, self.margin(["stable", 0, 0, held(0)], preload=0, direction=DOWN),
                     *self.ASKED, "--preload", "0")

    def test_sliding(self):
        """Pushed along a floor with friction 1/2 and a load of 2 on it, between smooth walls: from 1/5 on
        it slides, until one of the walls opens."""
        walls = ([0, 0, -1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0])
        room = space_file({**FLOOR, "preload": 2}, *({**FLOOR, "normal": n, "friction": 0, "preload": 2}
                                                     for n in walls))
        push, asked = [3, 4, 0, 0, 0, 0], ("--direction", "3,4,0,0,0,0")
        full, slid = point((0, ["-3/5", "-4/5", 0])), point(twist=["3/2", 2, 0, 0, 0, 0])
        sticks, slides = ["stable", 0, "1/5", point(), full], ["stable", "1/5", "6/5", full, slid]
        proof = self.margin(sticks, slides, m=6, direction=push)
        self.assertIn("resisted    [0, 6/5]\n", self.accepts(room, proof, *asked))
        early = ["stable", "1/10", "6/5", point((0, ["-3/10", "-2/5", 0])), slid]
        self.rejects("segment-mode", room, self.margin(sticks[:2] + ["1/10", sticks[3], early[3]], early,
                                                       m=6, direction=push), *asked, path="interval 1")
        # Beyond, where a wall is apart: v has two signs.
        beyond = point(twist=["9/4", 3, 0, 0, 0, 0])
        code, report, _, _ = self.run_both(room, self.margin(
            ["stable", "1/5", 2, full, beyond], m=6, direction=push), *asked)
        self.assertEqual((code, report["rule"]), (1, "witness-balance"))

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
            proof = self.margin(["stable", 0, 1, *(
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


class DegreeTest(Case):
    FILE = space_file(*CUBE)
    ASKED = ("--uncertain", "friction=10%,preload=5%,stiffness=5%,wrench=0.05,position=0.01")
    SAID = {"friction": "10%", "stiffness": "5%", "preload": "5%", "position": "1/100",
            "wrench": "1/20"}

    def proof(self, **changes):
        return stable(6, [0] * 6, [{**CUBE_PROOF, **changes}])

    def boxed(self, **changes):
        changes = {"tree": WALL_LEAVES * 2, **changes}
        return stable(6, [0] * 6, [{**CUBE_PROOF, **changes}], uncertain=self.SAID)

    def test_one_point(self):
        text = self.accepts(self.FILE, self.proof())
        self.assertIn("verdict     stable\n", text)
        self.assertIn("by degree, parts: 1; trees of 12 nodes: 12 leaves", text)
        bilateral = self.proof()
        bilateral["question"]["normal_law"] = "bilateral"
        self.accepts(self.FILE, bilateral, "--normal-law", "bilateral")
        wide = self.proof(walls=[["1/2", 0, 0, 0, 0, 0], *UNIT[1:]])
        wide["question"]["normal_law"] = "bilateral"
        self.rejects("degree-law", self.FILE, wide, "--normal-law", "bilateral", path="part 0")

    def test_box(self):
        text = self.accepts(self.FILE, self.boxed(), *self.ASKED)
        self.assertIn("verdict     stable, for every grasp in the box\n", text)
        self.assertIn("trees of 24 nodes", text)
        self.rejects("tree-short", self.FILE, self.boxed(tree=WALL_LEAVES), *self.ASKED, node=12,
                     path="part 0, middle wall 1 +")
        self.rejects("tree-long", self.FILE, self.proof(tree=WALL_LEAVES * 2), node=12, path="part 0")

    def test_irrational_lengths(self):
        """The cube and its walls turned by 45 degrees about z: normals have the length sqrt(2)."""
        turned = [{**c, "normal": n, "position": [-x for x in n]} for c, n in zip(
            CUBE, ([1, 1, 0], [-1, -1, 0], [-1, 1, 0], [1, -1, 0], [0, 0, 1], [0, 0, -1]))]
        file = space_file(*turned, wrench=["1/10", "1/20", 0, 0, 0, 0])
        rows = [[1, 1, 0, 0, 0, 0], [-1, 1, 0, 0, 0, 0], UNIT[2], [0, 0, 0, 1, 1, 0],
                [0, 0, 0, -1, 1, 0], UNIT[5]]
        sizes = ["7/5", "7/5", 2, "7/10", "7/10", 1]
        walls = [[str(c * Fraction(size)) for c in row] for row, size in zip(rows, sizes)]
        leaves = [["leaf", *[sign * c for c in row]] for row in rows for sign in (1, -1)]
        proof = stable(6, file["wrench"], [{**CUBE_PROOF, "walls": walls, "tree": leaves * 2}])
        self.assertIn("for every grasp in the box", self.accepts(file, proof))
        cut = stable(6, file["wrench"], [["part", "preload", 0, "7/10"]])
        self.assertEqual(self.run_both(file, cut)[1]["rule"], "part-inside")

    def test_walls(self):
        tree = list(WALL_LEAVES)
        for j in range(12):
            path = f"part 0, middle wall {j // 2 + 1} {'+-'[j % 2]}"
            self.rejects("tree-short", self.FILE, self.proof(tree=tree[:j]), node=j, path=path)
            turned = [*tree[:j], ["leaf", *[-c for c in tree[j][1:]]], *tree[j + 1:]]
            self.rejects("leaf-bound", self.FILE, self.proof(tree=turned), node=j, path=path)

    def test_direction(self):
        flat = [*UNIT[:5], [1, 1, 0, 0, 0, 0]]
        self.rejects("degree-walls", self.FILE, self.proof(walls=flat), path="part 0")
        self.rejects("degree-direction", self.FILE, self.proof(direction=flat), path="part 0")
        turned = [*UNIT[:5], [0, 0, 0, 0, 0, -1]]
        self.rejects("leaf-direction", self.FILE, self.proof(direction=turned), node=10,
                     path="part 0, middle wall 6 +")

    def test_what_is_not_so(self):
        """Other places, walls so near that friction holds the body there, a larger load."""
        for changes in ({"twist": [1, 0, 0, 0, 0, 0]}, {"walls": [[1000 * c for c in row] for row in UNIT]}):
            self.assertEqual(self.run_both(self.FILE, self.proof(**changes))[1]["rule"], "leaf-bound")
        heavy = space_file(*CUBE, wrench=[2, 0, 0, 0, 0, 0])
        self.rejects("leaf-bound", heavy, stable(6, heavy["wrench"], [CUBE_PROOF]), node=0,
                     path="part 0, middle wall 1 +")

    def test_cut_parts(self):
        parts = [["part", "z", 4, -1], self.boxed()["parts"][0], ["part", "wrench", 5, 0],
                 *[self.boxed()["parts"][0]] * 2]
        proof = self.boxed()
        proof["parts"] = parts
        self.assertIn("parts: 3; trees of 72 nodes", self.accepts(self.FILE, proof, *self.ASKED))
        proof["parts"] = parts[:3]
        self.rejects("tree-short", self.FILE, proof, *self.ASKED, path="part 3, z 4 high, wrench 5 low")


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

    def test_mutants(self):
        """Numbers exchanged, nodes left out or doubled: both checkers say the same. And what is about
        a stable grasp is not accepted as unstable, nor about a multiple."""
        rng = random.Random(21)
        for name, grasp, proof, options in corpus():
            for _ in range(12):
                mutant = json.loads(proof)
                trees = [mutant[key] for key in ("tree",) if key in mutant]
                for *_, evidence in mutant.get("intervals", []):
                    tree = evidence if isinstance(evidence, list) else evidence.get("tree")
                    trees += [tree] * (tree is not None)
                if rng.random() < 0.5 and trees:
                    tree = rng.choice(trees)
                    k = rng.randrange(len(tree))
                    tree[k:k + 1] = rng.choice([[], [tree[k]] * 2, [["slip", 0]],
                                                [["leaf", *[rng.randint(-1, 1) for _ in range(6)]]]])
                    text = json.dumps(mutant)
                else:
                    start = proof.index("verdict")
                    numbers = list(re.finditer(r"\d+", proof[start:]))
                    at = rng.choice(numbers)
                    text = (proof[:start + at.start()] + str(rng.randint(1, 9))
                            + proof[start + at.end():])
                code, report, _, _ = self.run_both(grasp, text, *options)
                if code == 0:
                    self.assertEqual(report["verdict"], name.split("_")[-1])
                if code == 0 and report["verdict"] == "margin":
                    self.is_true(name, report)

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


def random_contact(rng, share):
    normal = rng.choice(NORMALS)
    preload = spread(rng, rng.choice([0, 0, 1, Fraction(1, 2)]), share)
    if naive_space.root_of(Fraction(naive.dot(normal, normal))) is None:
        preload = (0, 0)
    return naive_space.Contact.of_file(
        normal, [spread(rng, rng.randint(-1, 1), share) for _ in range(3)],
        spread(rng, rng.choice([0, Fraction(1, 2), 1, Fraction(2, 3)]), share), preload,
        spread(rng, rng.choice([1, 2]), share))


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
        return check.Parameters(c.normal, bounds, check.Bounds(*growth))

    return check.Box(list(map(parameters, contacts)), tuple(check.Bounds(*w) for w in wrench),
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

        def of_verdict():
            share = rng.choice([0, 0, 0.2, 0.4])
            contacts = [random_contact(rng, share) for _ in range(rng.randint(1, 2))]
            return contacts, [spread(rng, rng.randint(-3, 3), share / 2) for _ in range(6)]

        self.compare(rng, of_verdict, 50)

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

    def test_nothing_refutes_the_home_of_an_equilibrium(self):
        """Equilibria by construction, in the middle of boxes. Directions of slip may be irrational:
        then the load is an interval around what balances."""
        rng = random.Random(10)
        slipped = 0
        for _ in range(250):
            contacts = [random_contact(rng, rng.choice([0, 0.3])) for _ in range(rng.randint(1, 3))]
            d = tuple(Fraction(rng.randint(-2, 2), 2) for _ in range(6))
            wrench = [(Fraction(0), Fraction(0))] * 6
            chosen = []
            for contact in contacts:
                q = {name: low + Fraction(rng.randint(0, 4), 4) * (high - low)
                     for name, (low, high) in contact.ends.items()}
                p = (q["x"], q["y"], q["z"])
                chosen.append(p)
                n, u = contact.normal, naive_space.velocity(d, p)
                a = max(0, q["preload"] - q["stiffness"] * naive.dot(n, u))
                s = naive_space.slip(n, p, d)
                ends = [naive_space.slip(n, (0, 0, 0), (rng.randint(-1, 1), rng.randint(-1, 1), 1,
                                                        0, 0, 0))] * 2  # sticks
                ends = [tuple(c / 4 for c in e) for e in ends]
                if any(s):
                    low, high = naive_space.inverse_length(naive.dot(s, s) / contact.square, 64)
                    ends = [tuple(-c * root for c in s) for root in (low, high)]
                    slipped += bool(a * q["friction"])
                forces = [check.at(p, tuple(a * (c + q["friction"] * e) for c, e in zip(n, end)))
                          for end in ends]
                wrench = [(low - max(f), high - min(f))
                          for (low, high), f in zip(wrench, zip(*forces))]
            x = (*d, Fraction(1), Fraction(0))
            walk = Walk(rng, contacts, wrench)

            def home(what):
                if isinstance(what, int):
                    return int(any(naive_space.slip(contacts[what].normal, chosen[what], d)))
                return int(check.dot(what, x) < 0)

            for _ in range(rng.randint(0, 6)):
                walk.step(home)
            for y in (check.zeros(6), tuple(-low for low, _ in wrench), random_twist(rng)):
                self.assertIsNotNone(check.leaf_refusal(walk.region, y, lambda x: x))
        self.assertGreater(slipped, 100)


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
    def test_of_slips(self):
        """Against pairs of generators, on all sets of up to four directions of a grid."""
        for normal in ((0, 0, 1), (1, 2, -2), (0, 3, 0)):
            basis = [naive_space.cross(normal, e) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
            basis = [b for b in basis if any(b)][:2]
            grid = [tuple(i * a + j * b for a, b in zip(*basis))
                    for i, j in itertools.product((-1, 0, 1), repeat=2)]
            for count in range(4):
                for chosen in itertools.combinations(grid, count):
                    cone = check.SlipCone(tuple(map(Fraction, normal)), chosen)
                    for s in grid:
                        self.assertEqual(cone.contains(s), naive_space.in_cone(s, chosen),
                                         (normal, chosen, s))

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
