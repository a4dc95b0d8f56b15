# SPDX-License-Identifier: GPL-3.0-or-later
"""A bound on motions, in regions, maps, comparisons and exports: a contact of stiffness k that bears w gives w / k."""

import os
import subprocess
import unittest
from fractions import Fraction as F

from test_cli import DONE, Case, stickslip

Z3 = os.environ.get("Z3", "z3")
FOOT = {"format": "stickslip-grasp/2", "wrench": [0, -1, 0],
        "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": 1, "stiffness": 1}]}
FOOT_IN_SPACE = {"format": "stickslip-grasp/2", "wrench": [0, 0, -1, 0, 0, 0],
                 "contacts": [{"position": [0, 0, 0], "normal": [0, 0, 1], "friction": 1, "stiffness": 1}]}
BOUND = ("--max-motion", "3,1")


def ends(interval):
    return tuple(map(F, interval))


class Cells(Case):
    def cells(self, command, content, *words):
        """Ends along both axes, and verdicts; all checkers accept each that is proved."""
        file, folder = self.write("g.json", content), self.path("cells")
        answer = self.json(command, file, *words, "--certificates", folder)
        cells = [(ends(c["x"]), ends(c["y"]), c["verdict"]) for c in answer["cells"]]
        for k, (_, _, verdict) in enumerate(cells):
            if verdict != "undecided":
                name = os.path.join(folder, f"cell{k}")
                self.accepted(name + ".json", name + ".certificate.json", verdict=verdict)
        return answer, cells

    def assert_triangle(self, cells):
        """Loads down to 3 in the cone are held, and no others: proved up to cells that the border is in."""
        resisted = 0
        for s, t, verdict in cells:
            far = max(map(abs, s))
            near = 0 if s[0] <= 0 <= s[1] else min(map(abs, s))
            self.assertIn(verdict, ("stable", "unstable", "undecided"))
            if verdict == "stable":
                self.assertTrue(far <= -t[1] and t[0] >= -3, (s, t))
                resisted += (s[1] - s[0]) * (t[1] - t[0])
            elif verdict == "unstable":
                self.assertTrue(t[1] < -3 or t[0] > 0 or near > -max(t[0], -3), (s, t))
        self.assertGreater(resisted, 1)  # of 9
        self.assertTrue(any(t[1] < -3 and s[0] < 0 < s[1] or t[1] < -3 and s[0] == 0 for s, t, v in cells if v == "unstable"))

    def test_a_region_in_the_plane(self):
        words = ("--within=-7:7,-7:7", "--depth", "4")
        answer, cells = self.cells("region", FOOT, *BOUND, *words)
        self.assertEqual((answer["max_motion"], answer["plane"]["u"]), (["3", "3", "1"], ["1", "0", "0"]))
        self.assert_triangle(cells)
        # Of the file, and decided by itself.
        of_file = {**FOOT, "max_motion": {"length": 3, "angle": 1}}
        file = self.write("g.json", of_file)
        self.assertEqual(self.json("region", file, *words), answer)
        for load, verdict in (("1,-2,0", "stable"), ("2,-5/2,0", "stable"), ("0,-31/10,0", "unstable"), ("3,-2,0", "unstable")):
            self.assertEqual(self.json("decide", file, "--wrench=" + load)["verdict"], verdict)
        self.assertIn("areas", self.json("region", file, "--max-motion", "none"))
        self.assertIn("areas", self.json("region", self.write("g.json", FOOT)))

    def test_a_region_in_space(self):
        answer, cells = self.cells("region", FOOT_IN_SPACE, *BOUND, "--v", "0,0,1,0,0,0", "--within=-7:7,-7:7", "--depth", "4")
        self.assertEqual(answer["max_motion"], ["3"] * 3 + ["1"] * 3)
        self.assert_triangle(cells)

    def test_another_plane(self):
        # With a torque that nothing opposes.
        file = self.write("g.json", FOOT)
        for words in (("--torque", "1"), ("--origin", "0,0,1")):
            answer = self.json("region", file, *BOUND, "--depth", "1", *words)
            self.assertEqual(answer["plane"]["origin"], ["0", "0", "1"])
            self.assertEqual({c["verdict"] for c in answer["cells"]}, {"unstable"})
        code, out, err = stickslip("region", file, *BOUND, "--depth", "1")
        self.assertEqual(code, DONE, err)
        self.assertIn("\nMotions up to 3,1 are asked about.\n", out)
        code, out, err = stickslip("plot", "region", file, *BOUND, "--depth", "1")
        self.assertEqual((code, out[:4]), (DONE, "<svg"), err)

    def test_what_is_not_known_within_a_bound(self):
        file = self.write("g.json", FOOT)
        for words in (("--list",), ("--mode-limit", "3"), ("--certificate", self.path("c.json"))):
            self.fails("region", file, *BOUND, *words, naming=[words[0], "without a bound"])
        self.fails("region", file, *BOUND, "--u", "1,0", naming=["--u", "2 numbers", "the plane"])
        self.fails("region", file, *BOUND, "--u", "0,1,0", naming=["--u, --v"])
        self.fails("region", file, "--depth", "3", naming=["--depth", "bounded"])
        self.fails("region", file, "--max-motion", "1000x", naming=["--max-motion"])  # no load, no preload

    def test_a_map_in_the_plane(self):
        # Up to three times the stiffness.
        _, cells = self.cells("map", FOOT, *BOUND, "--x", "load=1:8", "--y", "stiffness=1:2", "--depth", "3")
        verdicts = set()
        for load, stiffness, verdict in cells:
            verdicts.add(verdict)
            if verdict == "stable":
                self.assertLessEqual(load[1], 3 * stiffness[0])
            elif verdict == "unstable":
                self.assertGreater(load[0], 3 * stiffness[1])
        self.assertLessEqual({"stable", "unstable"}, verdicts)


class Others(Case):
    def assert_compared(self, content):
        file = self.write("g.json", content)
        for bound, verdict in (("1/2,1", "unstable"), ("2,1", "stable"), ("none", "stable")):
            answer = self.json("compare", file, "--max-motion", bound)
            methods = {row["method"]: row for row in answer["methods"]}
            self.assertEqual(methods["passive equilibrium"]["verdict"], verdict)
            for name in ("weakly stable load", "linear compliance", "friction cones alone"):
                self.assertEqual((methods[name]["verdict"], methods[name]["agrees"]), ("stable", verdict == "stable"))
            self.assertEqual("beyond the bound" in methods["friction cones alone"]["why"], verdict == "unstable")
            self.assertEqual("max_motion" in answer, bound != "none")
        _, out, _ = stickslip("compare", file, "--max-motion", "1/2,1")
        self.assertIn("\nPassive equilibrium alone is about motions up to 0.5,1; the other methods know no bound.\n", out)
        # A class is of all motions, whatever the bound.
        proof = self.path("class.json")
        self.json("compare", file, "--max-motion", "1/2,1", "--certificate", proof)
        self.accepted(file, proof, "--inertia", "0,0,1" if len(content["wrench"]) == 3 else "0,0,0,1,1,1", verdict="must hold")

    def test_compare(self):
        self.assert_compared(FOOT)
        self.assert_compared(FOOT_IN_SPACE)

    def test_export(self):
        for content in (FOOT, FOOT_IN_SPACE):
            file = self.write("g.json", content)
            for words, expected in (((), "sat"), (("--max-motion", "101/100,1"), "sat"), (("--max-motion", "99/100,1"), "unsat")):
                code, text, err = stickslip("export", file, "--smt2", *words)
                self.assertEqual(code, DONE, err)
                said = subprocess.run([Z3, "-in"], input=text, capture_output=True, text=True, check=True).stdout
                self.assertEqual(said.strip(), expected, words)
                self.assertEqual(self.json("decide", file, *words)["verdict"], "stable" if expected == "sat" else "unstable")


if __name__ == "__main__":
    unittest.main()
