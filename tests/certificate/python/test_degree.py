# SPDX-License-Identifier: MIT
"""Stable by degree (certificate/FORMAT.md, section 6) on simplices and where there are free
motions: the syntax, proofs that a search finds, and mutants.
"""

import copy
import random
import unittest

import proofs
from proofs import unit
from support import Case, certificate, corpus


def grasp_file(wrench, *contacts, **members):
    return {"format": "stickslip-grasp/2", "contacts": list(contacts), "wrench": wrench, **members}


def stable(file, *parts, law="unilateral", **question):
    wrench = [[c["min"], c["max"]] if isinstance(c, dict) else c for c in file["wrench"]]
    return certificate(len(file["contacts"]), wrench, law=law, parts=list(parts), **question)


def diagonal(*entries):
    return [[entry * c for c in row] for entry, row in zip(entries, unit(len(entries)))]


def leaves(*rows):
    return [["leaf", *row] for row in rows]


def both_ways(rows):
    return leaves(*(tuple(sign * c for c in row) for row in rows for sign in (1, -1)))


class FalseProofTest(Case):
    """One contact without friction, which pushes along x; no other motion is seen by it."""

    def test_mutants(self):
        """Whatever the numbers are, neither of these loads is held."""
        rng, rejected = random.Random(33), set()
        choice = [-1, 0, 0, 1, 1, 2, "1/2", "-1/2"]
        for wrench in ([1, 0, 0], ["-1/2", 1, 0]):
            file = grasp_file(wrench, {"position": [0, 0], "normal": [1, 0], "friction": 0, "preload": 1})
            for _ in range(75):
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
class SyntaxTest(Case):
    def test_parts(self):
        walls, rest = PLATE_PROOF["walls"], {key: PLATE_PROOF[key] for key in ("twist", "direction", "tree")}
        twist, direction, tree = (PLATE_PROOF[key] for key in ("twist", "direction", "tree"))
        for part in (
                rest, {**rest, "simplex": walls * 2},  # out of order
                {"twist": twist, "walls": walls, "simplex": walls * 2, "direction": direction, "tree": tree},
                {"twist": twist, "simplex": walls * 2, "walls": walls, "direction": direction, "tree": tree},
                *({"twist": twist, shape: rows, "direction": direction, "tree": tree} for shape, rows in (
                    ("walls", unit(3) + [X]), ("walls", [[1, 0]]), ("walls", [X, 1]),
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
        for shape, rows in (("walls", unit(6) + unit(6)[:1]), ("simplex", unit(6)[:1]),
                            ("simplex", unit(6) + unit(6)[:2])):
            claim = ["stable", 0, 1, {"twist": [0] * 6, shape: rows, "direction": unit(6), "tree": []}]
            proof = certificate(0, [0] * 6, direction=[0, 0, -1, 0, 0, 0], intervals=[claim])
            self.malformed("intervals[0]", grasp_file([0] * 6), proof, *asked)
        for shape, rows in (("walls", unit(3)[:2]), ("walls", unit(3) + [X]), ("simplex", unit(3) + [X])):
            segment = {"to": 1, "twists": [[0] * 3] * 2, shape: rows, "direction": unit(3), "tree": []}
            proof = certificate(2, [0] * 3, direction=X, resisted=[[0, 1]], segments=[segment], tree=[])
            self.malformed("segments[0]", PLATE, proof, "--direction", "1,0,0")


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
    def prove(self, file, part):
        """And that no wall can be left out or stand in another's place."""
        part = proofs.prove(proofs.box_of(file, FRICTION), part)
        proof = stable(file, part, uncertain=FRICTION_SAID)
        self.assertIn(f"trees of {len(part['tree'])} nodes", self.accepts(file, proof, *FRICTION))
        shape = "simplex" if "simplex" in part else "walls"
        for rows in (part[shape][1:] + part[shape][:1], part[shape][1:], part[shape][:-1]):
            code, report, _, _ = self.run_both(file, stable(file, {**part, shape: rows},
                                                            uncertain=FRICTION_SAID), *FRICTION)
            self.assertEqual(code, 1, (rows, report))

    def test_pin(self):
        flat = diagonal(1, 1, 0)
        self.prove(PIN, {"twist": [0] * 3, "walls": [[2, 0, 0], [0, 2, 0]], "direction": flat})
        self.prove(PIN, {"twist": [0] * 3, "simplex": [[-2, 0, 0], [1, 2, 0], [1, -2, 0]],
                         "direction": flat})

    def test_three_at_rest(self):
        self.prove(THREE, {"twist": [0] * 3, "simplex": SLIPS, "direction": unit(3)})

    def test_walls_of_the_simplex_are_not_those_of_a_part(self):
        part = proofs.prove(proofs.box_of(THREE, FRICTION),
                            {"twist": [0] * 3, "simplex": SLIPS, "direction": unit(3)})
        bad = {"twist": [0] * 3, "walls": SLIPS[:3], "direction": unit(3), "tree": part["tree"]}
        code, report, _, _ = self.run_both(THREE, stable(THREE, bad, uncertain=FRICTION_SAID), *FRICTION)
        self.assertEqual(code, 1, report)


class MutantTest(Case):
    def test_same_answers(self):
        """Numbers exchanged anywhere in proofs of the corpus of rules: all checkers answer the same, and as
        the grasps are stable, nobody can be wrong to accept."""
        rng, rejected = random.Random(32), set()
        wanted = ("a plate between smooth jaws", "a pinch", "springs, in a simplex")
        entries = [entry for kind in ("plane", "space") for entry in corpus.entries(kind) if entry.name in wanted]
        self.assertEqual(len(entries), 3)
        for entry in entries:
            for _ in range(40):
                proof = copy.deepcopy(entry.certificate)
                (mutant,) = proof["parts"]
                shape = "simplex" if "simplex" in mutant else "walls"
                key = rng.choice(["twist", shape, shape, "direction", "direction", "tree"])
                rows = [mutant["twist"]] if key == "twist" else mutant[key]
                row = rng.choice(rows)
                row[rng.randrange(key == "tree", len(row))] = rng.choice([-1, 0, 1, 2])
                if rng.random() < 0.2:
                    rows.append(list(rng.choice(rows)))
                _, report, _, _ = self.run_both(entry.grasp, proof)
                rejected.add(report["rule"])
        self.assertTrue({None, "degree-walls", "degree-free", "degree-direction", "leaf-bound"}
                        <= rejected, rejected)


if __name__ == "__main__":
    unittest.main()
