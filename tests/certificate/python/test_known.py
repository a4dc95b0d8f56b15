# SPDX-License-Identifier: MIT
"""The paper's grasps, the table of questions, and numbers and trees that are long.

"§" refers to certificate/FORMAT.md, "Table" to Haas-Heger et al., RSS 2018.
"""

import random
import unittest

import naive
from support import FIG1, UP, UP_TREE, Case, certificate, grasp, up


class PaperTest(Case):
    """Fig. 1. What the tables say is for tests/engine."""

    def test_figure_1_beyond_its_threshold(self):
        text = self.accepts(FIG1, up(), *UP)
        self.assertEqual(text.split("\n")[1:], [
            "verdict     unstable", "contacts    3", "wrench      (0, 11/10, 0)",
            "preload     1 at all contacts", "normal law  unilateral",
            "proof       a tree of 5 nodes: 3 leaves", ""])
        # On the threshold it is stable, and the tree must fail; just beyond, not.
        at = certificate(3, [0, 1, 0], 1, tree=UP_TREE)
        self.rejects("leaf-bound", FIG1, at, "--wrench", "0,1,0", "--preload", "1",
                     node=2, path="separation 0 closed, separation 2 closed")
        beyond = "1" + "0" * 30 + "1/1" + "0" * 31
        self.accepts(FIG1, certificate(3, [0, beyond, 0], 1, tree=UP_TREE),
                     "--wrench", f"0,{beyond},0", "--preload", "1")

    def test_answer_names_the_file_s_own_question(self):
        file = {**FIG1, "wrench": [0, -1, 0]}
        text = self.accepts(file, certificate(3, [0, -1, 0], twist=[0, -1, 0]))
        self.assertIn("preload     as in the grasp file\n", text)


class QuestionTest(Case):
    """§1."""

    def test_normals_of_irrational_length(self):
        """A margin that needs the length is by claims, and can be asked; `snap` in the file is refused, with the remedy."""
        two = grasp([[0, 0], [1, 0]], [[0, 1], [1, 1]], wrench=[0, -1, 0])
        plain = certificate(2, [0, -1, 0], tree=[["leaf", 0, 0, 0]])
        self.rejects("leaf-bound", two, plain, node=0, path="root")
        remedy = "stickslip snap GRASP -o FILE"
        self.rejects("question-preload", two, plain, "--preload", "1")
        for options in (("--preload-direction", "0,1"),
                        ("--preload", "1", "--preload-direction", "scale")):
            found, _, _, _ = self.run_both(two, plain, *options)
            self.assertEqual(found, 1)  # it can be asked, and the certificate is about something else
        code, _, _, _ = self.run_both(two, plain, "--preload-direction", "1,0")
        self.assertEqual(code, 1)  # length 1, and no preload at the other: it can be asked
        for snap in ("snap", "exact", {"snap": "0.99"}):
            self.malformed(remedy, {**two, "normals": snap}, plain)

    def test_the_base_point(self):
        """§1, the table, in the words of the answer, for all combinations of the options."""
        file = {**FIG1, "wrench": [0, -7, 0], "defaults": {"friction": 0, "preload": 1}}
        never = {"resisted": [], "segments": [], "tree": []}
        own, ones = "as in the grasp file", "1 at all contacts"
        for u in (None, [0, 1, 0]):
            for growth in (None, "scale", ["1", "0", "2"]):
                for wrench in (None, [0, -3, 0]):
                    for preload in (None, "1"):
                        if not u and not growth:
                            continue
                        options = ["--direction", "0,1,0"] if u else []
                        options += ["--wrench", "0,-3,0"] if wrench else []
                        options += ["--preload", preload] if preload else []
                        options += ["--preload-direction", growth if growth == "scale" else
                                    "1,0,2"] if growth else []
                        w = wrench or ([0, 0, 0] if u else [0, -7, 0])
                        proof = certificate(3, w, preload, "unilateral", u, growth, **never)
                        self.rejects("tree-short", file, proof, *options, node=0, path="root")
                        text = self.accepts(file, self.proof(proof, w, u, growth), *options)
                        self.assertIn(f"\nwrench      ({', '.join(map(str, w))})\n", text)
                        self.assertEqual("\ndirection   (0, 1, 0)\n" in text, u is not None)
                        words = ones if preload else own
                        self.assertIn("\npreload     " + (
                            f"f times {words}" if growth == "scale" else
                            f"{words} + f (1, 0, 2)" if growth else words) + "\n", text)

    def proof(self, base, w, u, growth):
        """Frictionless Fig. 1, P = 1 at each contact: balance asks for a_0 = a_2 and
        a_1 = -w_y - λ u_y, which any P allows if that is >= 0: then d = (x, y, 0) with
        a_0 = P_0 - x = P_2 + x and a_1 = P_1 - y."""
        fixed = 0 if growth == "scale" else 1
        grown = (1, 1, 1) if growth == "scale" else (1, 0, 2) if growth else (0, 0, 0)

        def point(load, ray=False):
            p0, p1, p2 = ((0 if ray else fixed) + load * g for g in grown)
            a1 = -((0 if ray else w[1]) + load * (u[1] if u else 0))
            return [None if ray else load, [str(naive.Fraction(p0 - p2, 2)), p1 - a1, 0], []]

        if not u:
            return {**base, "resisted": [[0, None]], "segments": [[point(0), point(1, True)]]}
        return {**base, "resisted": [[0, -w[1]]], "segments": [[point(0), point(-w[1])]],
                "tree": [["leaf", 0, -1, 0]]}


class LongTest(Case):
    def test_many_leaves(self):
        m = 100
        points = [[f"{(37 * j) % 101 - 50}/10", f"{(53 * j) % 97 - 48}/7"] for j in range(m)]
        normals = [[(5 * j) % 7 - 3, (3 * j) % 5 + 1] for j in range(m)]
        file = grasp(points, normals, wrench=["1/3", 40, "-1/7"])
        file["defaults"] = {"friction": "1/10"}
        tree = []
        for j in range(m):  # every leaf refutes all motions: all contacts push up
            tree += [["separation", j], ["leaf", 0, -1, 0], ["slip", (j + 50) % m],
                     ["leaf", 0, -1, 0], ["leaf", 0, -1, 0]]
        tree += [["leaf", 0, -1, 0]]
        text = self.accepts(file, certificate(m, ["1/3", 40, "-1/7"], tree=tree))
        self.assertIn("a tree of 501 nodes: 301 leaves", text)

    def test_long_denominators(self):
        """Each contact with its own: bounds must not carry all of them."""
        rng = random.Random(4)
        m = 16

        def long(low, high):
            denominator = rng.randrange(10**800, 10**801)
            return f"{denominator * rng.randint(low, high) // 1000 + 1}/{denominator}"

        contacts = [{"position": [long(-2000, 2000), long(-2000, 2000)],
                     "normal": [long(-300, 300), long(800, 1000)], "friction": long(100, 500),
                     "stiffness": long(1000, 3000)} for _ in range(m)]
        file = {"format": "stickslip-grasp/1", "contacts": contacts, "wrench": [0, 1, 0]}
        leaf = ["leaf", 0, -1, 0]
        tree = []
        for j in range(m):
            tree += [["separation", j], leaf]
        self.accepts(file, certificate(m, [0, 1, 0], tree=[*tree, leaf]))
        self.rejects("leaf-bound", file, certificate(m, [0, 1, 0], tree=[["slip", 1],
                                                                      ["leaf", "1/3", 1, 0]]),
                     node=1, path="slip 1 +")
        self.rejects("witness-balance", file, certificate(m, [0, 1, 0], twist=[0, "-1/7", "1/9"]))


if __name__ == "__main__":
    unittest.main()
