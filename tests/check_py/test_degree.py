# SPDX-License-Identifier: MIT
"""Stable by degree (certificate/FORMAT.md, sections 6 and 7) on simplices and where there are free
motions: the syntax, every rule made to fail alone, and the three false proofs. All checkers.
"""

import copy
import json
import random
import unittest

import proofs
from proofs import unit
from support import Case, certificate


def interval(low, high):
    return {"min": low, "max": high}


def grasp_file(wrench, *contacts, **members):
    return {"format": "stickslip-grasp/2", "contacts": list(contacts), "wrench": wrench, **members}


def stable(file, *parts, law="unilateral", **question):
    wrench = [[c["min"], c["max"]] if isinstance(c, dict) else c for c in file["wrench"]]
    proof = certificate(len(file["contacts"]), wrench, law=law, twist=[0] * len(wrench), **question)
    del proof["twist"], proof["shares"]
    return {**proof, "parts": list(parts)}


def diagonal(*entries):
    return [[entry * c for c in row] for entry, row in zip(entries, unit(len(entries)))]


def leaves(*rows):
    return [["leaf", *row] for row in rows]


def both_ways(rows):
    return leaves(*(tuple(sign * c for c in row) for row in rows for sign in (1, -1)))


class FalseProofTest(Case):
    """One contact without friction, which pushes along x; no other motion is seen by it."""

    def test_format(self):
        def fails(rule, wrench, twist, **part):
            file = grasp_file(wrench, {"position": [0, 0], "normal": [1, 0], "friction": 0, "preload": 1})
            self.rejects(rule, file, stable(file, {"twist": twist, **part}), path="part 0")

        back, nothing = leaves([-1, 0, 0]), leaves([0, 0, 0])
        fails("degree-walls", [1, 0, 0], [0] * 3, simplex=[[2, 0, 0], [1, 0, 0]],
              direction=diagonal(-1, 0, 0), tree=back + nothing)
        fails("degree-free", ["-1/2", 1, 0], ["1/2", 0, 0], walls=[[4, 0, 0]],
              direction=diagonal(1, 0, 0), tree=leaves([1, 0, 0]) + back)
        fails("degree-direction", [1, 0, 0], [0] * 3, walls=[[4, 0, 0]],
              direction=[[0, 0, 0], [1, 0, 0], [0, 0, 0]], tree=back * 2)
        # Where the rule holds, so does the proof: of another load, or where A is right. (A stable one.)
        held = grasp_file(["-1/2", 0, 0], {"position": [0, 0], "normal": [1, 0], "friction": 0, "preload": 1})
        for shape in ({"walls": [[4, 0, 0]]}, {"simplex": [[4, 0, 0], [-3, 0, 0]]}):
            self.accepts(held, stable(held, {"twist": ["1/2", 0, 0], **shape,
                                             "direction": diagonal(1, 0, 0),
                                             "tree": leaves([1, 0, 0]) + back}))

    def test_mutants(self):
        """Whatever the numbers are, neither of these loads is held."""
        rng, rejected = random.Random(33), set()
        choice = [-1, 0, 0, 1, 1, 2, "1/2", "-1/2"]
        for wrench in ([1, 0, 0], ["-1/2", 1, 0]):
            file = grasp_file(wrench, {"position": [0, 0], "normal": [1, 0], "friction": 0, "preload": 1})
            for _ in range(150):
                def row():
                    return [rng.choice(choice), rng.choice([0, 0, 0, 1, -1]), rng.choice([0, 0, 0, 1])]

                shape = rng.choice([{"walls": [row()]}, {"simplex": [row(), row()]},
                                    {"walls": [row(), row()]}])
                part = {"twist": row(), **shape, "direction": [row(), row(), [0, 0, 0]],
                        "tree": leaves(*(rng.choice([[1, 0, 0], [-1, 0, 0], row()]) for _ in range(
                            2 * len(shape.get("walls", [0])))))}
                code, report, _, _ = self.run_both(file, stable(file, part))
                self.assertEqual(code, 1, part)
                rejected.add(report["rule"])
        self.assertEqual(len(rejected), 5, rejected)


# A plate between two jaws without friction: it may slide along them, and as they are one point high, turn.
JAWS = [{"position": [x, 0], "normal": [-x, 0], "friction": 0, "preload": 1} for x in (-1, 1)]
PLATE = grasp_file(["1/4", 0, 0], *JAWS)
X = [1, 0, 0]
PLATE_PROOF = {"twist": [0] * 3, "walls": [[2, 0, 0]], "direction": diagonal(1, 0, 0),
               "tree": both_ways([X])}
BOX = ("--uncertain", "friction=10%,stiffness=1%,preload=2%,wrench=1%")
SAID = {"friction": "10%", "stiffness": "1%", "preload": "2%", "wrench": "1%"}


def boxed(part, lists=2):
    """With as many lists as a box needs."""
    return {**part, "tree": part["tree"] * lists}


class SyntaxTest(Case):
    def test_parts(self):
        walls, rest = PLATE_PROOF["walls"], {key: PLATE_PROOF[key] for key in ("twist", "direction", "tree")}
        twist, direction, tree = (PLATE_PROOF[key] for key in ("twist", "direction", "tree"))
        for part in (
                rest, {**rest, "simplex": walls * 2},  # out of order
                {"twist": twist, "walls": walls, "simplex": walls * 2, "direction": direction, "tree": tree},
                {"twist": twist, "simplex": walls * 2, "walls": walls, "direction": direction, "tree": tree},
                *({"twist": twist, shape: rows, "direction": direction, "tree": tree} for shape, rows in (
                    ("walls", []), ("walls", unit(3) + [X]), ("walls", [[1, 0]]), ("walls", [X, 1]),
                    ("walls", {}), ("simplex", []), ("simplex", [X]), ("simplex", unit(3) + [X, X]),
                    ("simplex", [X, [1]]), ("simplex", None), ("simplexes", [X, X]))),
                *({**PLATE_PROOF, "direction": direction[:n]} for n in (0, 1, 2))):
            self.malformed("parts[0]", PLATE, stable(PLATE, part))
        for shape, rows in (("walls", unit(3)), ("simplex", unit(3) + [X])):
            proof = stable(PLATE, {"twist": twist, shape: rows, "direction": direction, "tree": tree})
            self.assertEqual(self.run_both(PLATE, proof)[0], 1)

    def test_margins(self):
        """Claims have all that parts have; segments are parallelepipeds of all motions."""
        asked = ("--direction", "0,0,-1,0,0,0")
        for shape, rows in (("walls", []), ("walls", unit(6) + unit(6)[:1]), ("simplex", unit(6)[:1]),
                            ("simplex", unit(6) + unit(6)[:2])):
            claim = ["stable", 0, 1, {"twist": [0] * 6, shape: rows, "direction": unit(6), "tree": []}]
            proof = certificate(2, [0] * 6, direction=[0, 0, -1, 0, 0, 0], intervals=[claim])
            self.malformed("intervals[0]", PINCH, proof, *asked)
        for shape, rows in (("walls", unit(3)[:2]), ("walls", unit(3) + [X]), ("simplex", unit(3) + [X])):
            segment = {"to": 1, "twists": [[0] * 3] * 2, shape: rows, "direction": unit(3), "tree": []}
            proof = certificate(2, [0] * 3, direction=X, resisted=[[0, 1]], segments=[segment], tree=[])
            self.malformed("segments[0]", PLATE, proof, "--direction", "1,0,0")


class PlaneTest(Case):
    def fails(self, rule, proof, *options, file=None, path="part 0", node=None):
        self.rejects(rule, file or PLATE, proof, *options, path=path, node=node)

    def test_accepted(self):
        text = self.accepts(PLATE, stable(PLATE, PLATE_PROOF))
        self.assertIn("by degree, parts: 1; trees of 2 nodes: 2 leaves", text)
        text = self.accepts(PLATE, stable(PLATE, boxed(PLATE_PROOF), uncertain=SAID), *BOX)
        self.assertIn("verdict     stable, for every grasp in the box\n", text)
        self.assertIn("trees of 4 nodes: 4 leaves", text)
        # A body may slide along all of Z at once.
        moved = {**PLATE_PROOF, "twist": ["1/8", 5, "-7/3"]}
        self.accepts(PLATE, stable(PLATE, moved))

    def test_cut_parts(self):
        parts = [["part", "preload", 1, 1], boxed(PLATE_PROOF), ["part", "stiffness", 0, 1],
                 *[boxed(PLATE_PROOF)] * 2]
        self.accepts(PLATE, stable(PLATE, *parts, uncertain=SAID), *BOX)
        thin = boxed({**PLATE_PROOF, "walls": [[0, 1, 0]]})
        self.fails("degree-free", stable(PLATE, *parts[:4], thin, uncertain=SAID), *BOX,
                   path="part 4, preload 1 high, stiffness 0 high")

    def test_walls(self):
        for rows in ([[0, 0, 0]], [X, [2, 0, 0]], [X, [0, 1, 0], [3, -5, 0]]):
            self.fails("degree-walls", stable(PLATE, {**PLATE_PROOF, "walls": rows}))

    def test_simplices(self):
        def part(*rows):
            return {"twist": [0] * 3, "simplex": rows, "direction": diagonal(1, 0, 0),
                    "tree": both_ways([X])}

        good = part([2, 0, 0], ["-3/2", 0, 0])
        self.accepts(PLATE, stable(PLATE, good))
        self.accepts(PLATE, stable(PLATE, boxed(good), uncertain=SAID), *BOX)
        for rows in ([[2, 0, 0], [2, 0, 0]], [[2, 0, 0], [0, 0, 0]], [[0, 0, 0], [0, 0, 0]],
                     [[2, 0, 0], [-2, 1, 0]], [[2, 0, 0], [-1, 0, 0], [-1, 0, 0]],
                     [[2, 0, 0], [-2, 0, 0], [0, 1, 0]], [[1, 0, 0], [0, 1, 0], [1, 1, 0]],
                     [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, -1, 0]],
                     [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, -1, 1]]):
            self.fails("degree-walls", stable(PLATE, part(*rows)))
        # One wall after another, and no more of them.
        tree = good["tree"]
        for lists, names in ((1, ["middle wall 1", "middle wall 2"]),
                             (2, ["wall 1", "wall 2", "middle wall 1", "middle wall 2"])):
            question = ({"uncertain": SAID}, BOX) if lists == 2 else ({}, ())
            for k, name in enumerate(names):
                short = {**good, "tree": (tree * lists)[:k]}
                self.fails("tree-short", stable(PLATE, short, **question[0]), *question[1], node=k,
                           path=f"part 0, {name}")
                wrong = {**good, "tree": (tree * lists)[:k] + [tree[1 - k % 2]] + (tree * lists)[k + 1:]}
                self.fails("leaf-bound", stable(PLATE, wrong, **question[0]), *question[1], node=k,
                           path=f"part 0, {name}")
            long = {**good, "tree": tree * lists + tree[:1]}
            self.fails("tree-long", stable(PLATE, long, **question[0]), *question[1], node=2 * lists)
        self.fails("leaf-direction", stable(PLATE, {**good, "direction": diagonal(-1, 0, 0)}), node=0,
                   path="part 0, middle wall 1")

    def test_forces_see_it(self):
        """K goes on without end where a contact presses, or has friction, in some choice of the box."""
        self.fails("degree-free", stable(PLATE, {**PLATE_PROOF, "walls": [[0, 1, 0]],
                                                 "direction": diagonal(0, 1, 0)}))
        for contact in ({"friction": "1/2"}, {"friction": interval(0, "1/100")},
                        {"position": [-1, "1/100"]}, {"position": [-1, interval(0, "1/100")]},
                        {"normal": [1, "1/100"], "preload": 0},
                        {"normal": {"direction": [1, 0], "slope": "1/100"}}):
            file = {**PLATE, "contacts": [{**JAWS[0], **contact}, JAWS[1]]}
            self.fails("degree-free", stable(file, boxed(PLATE_PROOF)), file=file)
        for kind, size in (("position", "1/1000"), ("normal", "1/1000")):
            self.fails("degree-free", stable(PLATE, boxed(PLATE_PROOF), uncertain={kind: size}),
                       "--uncertain", f"{kind}={size}")
        # Along x a position, and a stiffness, change nothing of Z.
        file = {**PLATE, "contacts": [{**JAWS[0], "position": [interval(-2, -1), 0],
                                       "stiffness": interval("9/10", 1)}, JAWS[1]]}
        self.accepts(file, stable(file, boxed(PLATE_PROOF)))

    def test_loads_see_it(self):
        for wrench in (["1/4", "1/100", 0], ["1/4", 0, "-1/100"], ["1/4", interval(0, "1/100"), 0],
                       ["1/4", 0, interval("-1/100", "1/100")], ["1/4", 1, 1]):
            file = {**PLATE, "wrench": wrench}
            self.fails("degree-free", stable(file, boxed(PLATE_PROOF)), file=file)
        self.fails("degree-free", stable(PLATE, boxed(PLATE_PROOF), uncertain={"wrench": "1/100"}),
                   "--uncertain", "wrench=1/100")
        file = {**PLATE, "wrench": [interval("-1/4", "1/4"), 0, 0]}
        self.accepts(file, stable(file, boxed(PLATE_PROOF)))

    def test_direction(self):
        for direction in (unit(3), diagonal(0, 0, 0), diagonal(0, 1, 0), diagonal(1, 1, 0),
                          [[1, 1, 0], [0] * 3, [0] * 3], [[1, 0, 0], [1, 0, 0], [0] * 3],
                          [[1, 0, 0], [0] * 3, [0, 0, 1]], [[0, 0, 1], [0] * 3, [0] * 3],
                          [[0] * 3, [0] * 3, [1, 0, 0]]):
            self.fails("degree-direction", stable(PLATE, {**PLATE_PROOF, "direction": direction}))
        self.fails("leaf-direction", stable(PLATE, {**PLATE_PROOF, "direction": diagonal(-1, 0, 0)}),
                   node=0, path="part 0, middle wall 1 +")

    def test_law(self):
        """The vertices of K are lines along Z, on which v does not change: |x| <= 1/2, or up to 2."""
        law = ("--normal-law", "bilateral")
        self.accepts(PLATE, stable(PLATE, PLATE_PROOF, law="bilateral"), *law)
        for shape in ({"walls": [["1/2", 0, 0]]}, {"simplex": [["1/2", 0, 0], [-1, 0, 0]]},
                      {"simplex": [[1, 0, 0], ["-1/2", 0, 0]]}):
            part = {"twist": [0] * 3, **shape, "direction": diagonal(1, 0, 0), "tree": both_ways([X])}
            self.fails("degree-law", stable(PLATE, part, law="bilateral"), *law)

    def test_order(self):
        """Walls, free motions, direction, law, tree."""
        bad = {"twist": [5, 0, 0], "walls": [X, X], "direction": unit(3), "tree": []}
        law = ("--normal-law", "bilateral")
        for rule, mended in (("degree-walls", {}), ("degree-free", {"walls": [[0, 1, 0]]}),
                             ("degree-direction", {"walls": [X]}),
                             ("degree-law", {"direction": diagonal(1, 0, 0)})):
            bad.update(mended)
            self.fails(rule, stable(PLATE, bad, law="bilateral"), *law)
        bad["twist"] = [0] * 3
        self.fails("tree-short", stable(PLATE, bad, law="bilateral"), *law, node=0,
                   path="part 0, middle wall 1 +")


# Three fingers that meet in one point, about which the body may turn; and three around it, which slip before
# it turns.
NORMALS = [[1, 0], ["-3/5", "4/5"], ["-3/5", "-4/5"]]
PIN = grasp_file([0, "-1/8", 0], *({"position": [0, 0], "normal": n} for n in NORMALS),
                 defaults={"friction": "1/4", "preload": 1})
THREE = grasp_file([0, "-1/8", 0], *({"position": p, "normal": n} for p, n in zip(
    ([-1, 0], ["3/5", "-4/5"], ["3/5", "4/5"]), NORMALS)), defaults={"friction": "1/2", "preload": 1})
FRICTION = ("--uncertain", "friction=5%,preload=1%")
FRICTION_SAID = {"friction": "5%", "preload": "1%"}
SLIPS = [[0, 1, -1], ["-4/5", "-3/5", -1], ["4/5", "-3/5", -1], [0, "1/5", 3]]


class FingersTest(Case):
    def prove(self, file, part, count):
        """And that no wall can be left out or stand in another's place."""
        part = proofs.prove(proofs.box_of(file, FRICTION), part)
        proof = stable(file, part, uncertain=FRICTION_SAID)
        self.assertIn(f"trees of {len(part['tree'])} nodes", self.accepts(file, proof, *FRICTION))
        shape = "simplex" if "simplex" in part else "walls"
        for rows in (part[shape][1:] + part[shape][:1], part[shape][1:], part[shape][:-1]):
            code, report, _, _ = self.run_both(file, stable(file, {**part, shape: rows},
                                                            uncertain=FRICTION_SAID), *FRICTION)
            self.assertEqual(code, 1, (rows, report))
        begun = 0
        for k, node in enumerate(part["tree"]):
            _, report, _, _ = self.run_both(file, stable(file, {**part, "tree": part["tree"][:k]},
                                                         uncertain=FRICTION_SAID), *FRICTION)
            self.assertEqual((report["rule"], report["node"]), ("tree-short", k))
            begun += "plane" not in report["path"]
        self.assertEqual(begun, count)

    def test_pin(self):
        flat = diagonal(1, 1, 0)
        self.prove(PIN, {"twist": [0] * 3, "walls": [[2, 0, 0], [0, 2, 0]], "direction": flat}, 8)
        self.prove(PIN, {"twist": [0] * 3, "simplex": [[-2, 0, 0], [1, 2, 0], [1, -2, 0]],
                         "direction": flat}, 6)

    def test_three_at_rest(self):
        self.prove(THREE, {"twist": [0] * 3, "simplex": SLIPS, "direction": unit(3)}, 8)

    def test_walls_of_the_simplex_are_not_those_of_a_part(self):
        part = proofs.prove(proofs.box_of(THREE, FRICTION),
                            {"twist": [0] * 3, "simplex": SLIPS, "direction": unit(3)})
        bad = {"twist": [0] * 3, "walls": SLIPS[:3], "direction": unit(3), "tree": part["tree"]}
        code, report, _, _ = self.run_both(THREE, stable(THREE, bad, uncertain=FRICTION_SAID), *FRICTION)
        self.assertEqual(code, 1, report)


# ---- Space ------------------------------------------------------------------------------------

# Two fingers, between which the body may turn about the line through their tips.
FINGERS = [{"position": [x, 0, 0], "normal": [-x // 2, 0, 0], "friction": "3/10", "preload": 4}
           for x in (-2, 2)]
PINCH = grasp_file([0, 0, "-1/2", 0, 0, 0], *FINGERS)
# x, and how each of them slips; and the twists that move one of these and no other.
PINCH_WALLS = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, -2], [0, 0, 1, 0, 2, 0], [0, 1, 0, 0, 0, 2],
               [0, 0, 1, 0, -2, 0]]
PINCH_PROOF = {"twist": [0] * 6, "walls": PINCH_WALLS, "direction": diagonal(1, 2, 2, 0, 8, 8),
               "tree": both_ways([[1, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, -1], [0, 0, 2, 0, 1, 0],
                                  [0, 2, 0, 0, 0, 1], [0, 0, 2, 0, -1, 0]])}
ONE_PERCENT = ("--uncertain", "friction=1%,preload=1%,wrench=1%")
ONE_PERCENT_SAID = {"friction": "1%", "preload": "1%", "wrench": "1%"}


class PinchTest(Case):
    def fails(self, rule, part, *options, file=None, path="part 0", node=None, **question):
        file = file or PINCH
        self.rejects(rule, file, stable(file, part, **question), *options, path=path, node=node)

    def test_accepted(self):
        self.accepts(PINCH, stable(PINCH, PINCH_PROOF))
        text = self.accepts(PINCH, stable(PINCH, boxed(PINCH_PROOF), uncertain=ONE_PERCENT_SAID),
                            *ONE_PERCENT)
        self.assertIn("for every grasp in the box", text)
        self.assertIn("trees of 20 nodes: 20 leaves", text)
        law = ("--normal-law", "bilateral")
        self.accepts(PINCH, stable(PINCH, PINCH_PROOF, law="bilateral"), *law)
        wide = {**PINCH_PROOF, "walls": [["1/5", 0, 0, 0, 0, 0], *PINCH_WALLS[1:]]}
        self.fails("degree-law", wide, *law, law="bilateral")

    def test_free(self):
        for uncertain in ({"position": "1/1000"}, {"wrench": "1/1000"}):
            (kind, size), = uncertain.items()
            self.fails("degree-free", boxed(PINCH_PROOF), "--uncertain", f"{kind}={size}",
                       uncertain=uncertain)
        for wrench in ([0, 0, "-1/2", "1/100", 0, 0], [0, 0, "-1/2", interval("-1/100", "1/100"), 0, 0]):
            self.fails("degree-free", boxed(PINCH_PROOF), file={**PINCH, "wrench": wrench})
        for contact in ({"position": [-2, 0, "1/100"]}, {"position": [-2, interval(0, "1/100"), 0]},
                        {"normal": [1, "1/100", 0], "position": [-2, 0, "1/100"]}):
            file = grasp_file(PINCH["wrench"], {**FINGERS[0], **contact}, FINGERS[1])
            self.fails("degree-free", boxed(PINCH_PROOF), file=file)
        # The line through the tips may be longer or shorter. Then the walls move, and leaves with them.
        file = grasp_file(PINCH["wrench"], {**FINGERS[0], "position": [interval("-2001/1000", -2), 0, 0]},
                          FINGERS[1])
        self.accepts(file, stable(file, boxed(PINCH_PROOF)))
        # Too few walls: friction sees the rest.
        few = {**PINCH_PROOF, "walls": PINCH_WALLS[:4], "direction": diagonal(1, 2, 2, 0, 0, 8)}
        self.fails("degree-free", few)
        # A contact without friction sees less.
        smooth = grasp_file([0] * 6, *({**finger, "friction": 0} for finger in FINGERS))
        part = {"twist": [0] * 6, "simplex": [[2, 0, 0, 0, 0, 0], [-1, 0, 0, 0, 0, 0]],
                "direction": diagonal(1, 0, 0, 0, 0, 0), "tree": both_ways([[1, 0, 0, 0, 0, 0]])}
        self.accepts(smooth, stable(smooth, part))
        rough = grasp_file([0] * 6, {**FINGERS[0], "friction": "1/1000"}, {**FINGERS[1], "friction": 0})
        self.fails("degree-free", part, file=rough)

    def test_walls_and_direction(self):
        for walls in ([*PINCH_WALLS, [2, 0, 0, 0, 0, 0]], [*PINCH_WALLS[:4], [0] * 6],
                      [*PINCH_WALLS[:4], [0, 1, 0, 0, 0, 0]]):
            self.fails("degree-walls", {**PINCH_PROOF, "walls": walls})
        for direction in (unit(6), diagonal(1, 2, 2, 0, 8, 0), diagonal(1, 2, 2, 8, 8, 0),
                          [[1, 0, 0, 1, 0, 0], *PINCH_PROOF["direction"][1:]],
                          [*PINCH_PROOF["direction"][:3], [0, 0, 0, 0, 0, 1],
                           *PINCH_PROOF["direction"][4:]]):
            self.fails("degree-direction", {**PINCH_PROOF, "direction": direction})
        self.fails("leaf-direction", {**PINCH_PROOF, "direction": diagonal(1, 2, 2, 0, 8, -8)}, node=2,
                   path="part 0, middle wall 2 +")

    def test_what_is_not_so(self):
        heavy = grasp_file([0, 0, -3, 0, 0, 0], *FINGERS)
        self.fails("leaf-bound", PINCH_PROOF, file=heavy, node=5, path="part 0, middle wall 3 -")
        elsewhere = {**PINCH_PROOF, "twist": [2, 0, 0, 0, 0, 0]}
        self.fails("leaf-bound", elsewhere, node=1, path="part 0, middle wall 1 -")

    def test_margin(self):
        def margin(direction, *claims, **question):
            return certificate(2, [0] * 6, direction=direction, intervals=list(claims), **question)

        down, turn = [0, 0, -1, 0, 0, 0], [0, 0, -1, "1/100", 0, 0]
        bare = grasp_file([0] * 6, *FINGERS)
        asked, turned = (("--direction=" + ",".join(map(str, u)),) for u in (down, turn))
        self.accepts(bare, margin(down, ["stable", 0, 1, boxed(PINCH_PROOF)],
                                  ["stable", 1, 1, PINCH_PROOF]), *asked)
        for claim in (["stable", 0, 1, boxed(PINCH_PROOF)], ["stable", 0, 0, PINCH_PROOF]):
            self.rejects("degree-free", bare, margin(turn, claim), *turned, path="interval 0")
        # The torque of the wrench goes away at 1/2, and nowhere else.
        twisted = ("--wrench=0,0,0,-1/200,0,0", *turned)
        claim = margin(turn, ["stable", "1/2", "1/2", PINCH_PROOF])
        claim["question"]["wrench"] = [0, 0, 0, "-1/200", 0, 0]
        self.rejects("degree-free", bare, claim, *twisted, path="interval 0")
        # All multiples, where preloads grow with the load.
        limp = grasp_file([0] * 6, *({**finger, "preload": 0} for finger in FINGERS))
        question = {"preload_direction": [4, 4]}
        grown = (*asked, "--preload-direction=4,4")
        self.accepts(limp, margin(down, ["stable", 0, None, PINCH_PROOF], **question), *grown)
        for k, name in enumerate(["wall 1 +", "wall 1 -", "wall 2 +"]):
            short = {**PINCH_PROOF, "tree": PINCH_PROOF["tree"][:k]}
            self.rejects("tree-short", bare, margin(down, ["stable", 0, 1, short]), *asked, node=k,
                         path=f"interval 0, {name}")


# A body whose six springs are alike: four contacts at each pair of faces, nearly without friction.
FACES = [{"position": [-c + (1 - c * c) * (j == (k + 1) % 3) * side for j, c in enumerate(n)], "normal": n,
          "friction": "1/1000", "preload": 1}
         for k in range(3) for sign in (1, -1) for side in (1, -1)
         for n in [[sign * (j == k) for j in range(3)]]]
SPRINGS = grasp_file(["1/20", 0, 0, 0, "-1/20", 0], *FACES)
ROWS = [*unit(6), [-1] * 6]
SPRINGS_PROOF = {"twist": [0] * 6, "simplex": [[10 * c for c in row] for row in ROWS], "direction": unit(6),
                 "tree": leaves(*ROWS)}


class SpringsTest(Case):
    """A simplex of seven walls."""

    def test_accepted(self):
        text = self.accepts(SPRINGS, stable(SPRINGS, SPRINGS_PROOF))
        self.assertIn("trees of 7 nodes: 7 leaves", text)
        options = ("--uncertain", "preload=1/10000,stiffness=1%")
        self.accepts(SPRINGS, stable(SPRINGS, boxed(SPRINGS_PROOF), uncertain={
            "stiffness": "1%", "preload": "1/10000"}), *options)
        self.accepts(SPRINGS, stable(SPRINGS, SPRINGS_PROOF, law="bilateral"), "--normal-law", "bilateral")

    def test_walls(self):
        tree = SPRINGS_PROOF["tree"]
        for j in range(7):
            path = f"part 0, middle wall {j + 1}"
            short = stable(SPRINGS, {**SPRINGS_PROOF, "tree": tree[:j]})
            self.rejects("tree-short", SPRINGS, short, node=j, path=path)
            swapped = tree[:j] + [tree[(j + 1) % 7]] + tree[j + 1:]
            self.rejects("leaf-bound", SPRINGS, stable(SPRINGS, {**SPRINGS_PROOF, "tree": swapped}), node=j,
                         path=path)
        for j in range(7):
            rows = list(SPRINGS_PROOF["simplex"])
            rows[j] = [-c for c in rows[j]]
            self.rejects("degree-walls", SPRINGS, stable(SPRINGS, {**SPRINGS_PROOF, "simplex": rows}),
                         path="part 0")
        few = {**SPRINGS_PROOF, "simplex": [*unit(6)[:5], [-1] * 5 + [0]]}
        self.rejects("degree-free", SPRINGS, stable(SPRINGS, few), path="part 0")


class MutantTest(Case):
    def test_same_answers(self):
        """Numbers exchanged anywhere in the proofs of this file: all checkers answer the same, and as the
        grasps are stable, nobody can be wrong to accept."""
        rng, rejected = random.Random(32), set()
        for file, part in ((PLATE, PLATE_PROOF), (PINCH, PINCH_PROOF), (SPRINGS, SPRINGS_PROOF)):
            for _ in range(40):
                mutant = copy.deepcopy(part)
                shape = "simplex" if "simplex" in part else "walls"
                key = rng.choice(["twist", shape, shape, "direction", "direction", "tree"])
                rows = [mutant["twist"]] if key == "twist" else mutant[key]
                row = rng.choice(rows)
                row[rng.randrange(key == "tree", len(row))] = rng.choice([-1, 0, 1, 2])
                if rng.random() < 0.2:
                    rows.append(list(rng.choice(rows)))
                _, report, _, _ = self.run_both(file, json.dumps(stable(file, mutant)))
                rejected.add(report["rule"])
        self.assertTrue({None, "degree-walls", "degree-free", "degree-direction", "leaf-bound"}
                        <= rejected, rejected)


if __name__ == "__main__":
    unittest.main()
