# SPDX-License-Identifier: GPL-3.0-or-later
"""How far numbers may be off: both checkers judge all that `stickslip radius` writes."""

import json
import os
import unittest
from fractions import Fraction

from test_box import A, EXAMPLES, between, with_friction
from test_cli import BAD_INPUT, DONE, FIG1, Case, read, stickslip

QUICK = ("--uncertain", "friction=10%", "--accuracy", "10%")
C = os.path.join(EXAMPLES, "more-friction-breaks-no-preload.json")


def friction(contact):
    """Its interval in a grasp file."""
    value = contact["friction"]
    ends = (value["min"], value["max"]) if isinstance(value, dict) else (value, value)
    return tuple(map(Fraction, ends))


class Radius(Case):
    def judged(self, folder, name, verdict):
        """The grasp file, of which both checkers accept the certificate."""
        grasp = os.path.join(folder, f"{name}.json")
        self.accepted(grasp, os.path.join(folder, f"{name}.certificate.json"), verdict=rf"{verdict}\b")
        return json.loads(read(grasp))

    def radius(self, grasp, *words):
        """The answer; what it writes is checked, and against the factors."""
        folder = self.path("proofs")
        if "--accuracy" not in words:
            words += ("--accuracy", "10%")  # which is quick
        answer = self.json("radius", grasp, *words, "--certificates", folder)
        verdict = answer["verdict"]
        self.assertIn(verdict, ("stable", "unstable"))
        proved = self.judged(folder, "proved", verdict)
        names = {"proved.json", "proved.certificate.json"}
        if answer["refuted"] is not None:
            self.assertLess(Fraction(answer["proved"]), Fraction(answer["refuted"]))
            other = "unstable" if verdict == "stable" else "stable"
            refuted = self.judged(folder, "refuted", other)
            self.assertEqual(refuted["contacts"], answer["counterexample"]["contacts"])
            names |= {"refuted.json", "refuted.certificate.json"}
        self.assertEqual(set(os.listdir(folder)), names)
        for name in names:
            os.remove(os.path.join(folder, name))
        return answer, proved

    def test_one_friction(self):
        # Stable up to 1/2: the middle 2/5 of the interval is half its half-width below.
        grasp = self.write("g.json", with_friction(between("1/5", "3/5")))
        answer, proved = self.radius(grasp, "--accuracy", "1%")
        self.assertEqual(answer["verdict"], "stable")
        self.assertEqual(answer["uncertain"],
                         [{"place": "contacts[2].friction", "interval": ["1/5", "3/5"]}])
        factor, refuted = Fraction(answer["proved"]), Fraction(answer["refuted"])
        self.assertLess(factor, Fraction(1, 2))
        self.assertGreater(refuted, Fraction(1, 2))
        self.assertLess(refuted, Fraction(51, 100))
        self.assertGreater(factor, Fraction(98, 100) * refuted)
        self.assertEqual(friction(proved["contacts"][2]),
                         (Fraction(2, 5) - factor / 5, Fraction(2, 5) + factor / 5))
        found = Fraction(answer["counterexample"]["contacts"][2]["friction"])
        self.assertEqual(found, Fraction(2, 5) + refuted / 5)

    def test_a_counterexample_is_brought_nearer_number_by_number(self):
        # The corner that margins propose differs at 6.8 times the tolerances, and a neighbour of it at 2.5 times.
        grasp = self.write("g.json", {"format": "stickslip-grasp/2", "wrench": ["1/5", "-2/5", -1], "contacts": [
            {"position": [x, y], "normal": ["-" + x if x[0] != "-" else x[1:], "-" + y if y[0] != "-" else y[1:]],
             "friction": friction, "stiffness": stiffness, "preload": preload}
            for x, y, friction, stiffness, preload in (
                ("15/17", "8/17", "9/10", 2, "1/2"), ("-5/13", "-12/13", "3/10", 2, 2), ("15/17", "8/17", "3/5", 3, 2))]})
        answer, _ = self.radius(grasp, "--uncertain", "friction=10%,stiffness=10%,preload=5%,position=0.01,normal=0.0175,wrench=2%",
                                "--accuracy", "1%")
        self.assertLess(Fraction(answer["refuted"]), Fraction(21, 20) * Fraction(answer["proved"]))

    def test_unstable_centre(self):
        grasp = self.write("g.json", with_friction(between("3/5", "3/5")))
        answer, proved = self.radius(grasp, "--uncertain", "friction=10%")
        self.assertEqual(answer["verdict"], "unstable")
        for contact in proved["contacts"]:
            low, high = friction(contact)
            self.assertEqual((high - low) / (high + low), Fraction(answer["proved"]) / 10)

    def test_tolerances(self):
        for grasp in (A, C):
            answer, proved = self.radius(grasp, "--uncertain", "friction=10%")
            factor = Fraction(answer["proved"])
            for contact, given in zip(proved["contacts"], json.loads(read(grasp))["contacts"]):
                mu = Fraction(given["friction"])
                self.assertEqual(friction(contact), (mu * (1 - factor / 10), mu * (1 + factor / 10)))
        wrench, _ = self.radius(FIG1, "--preload", "2", "--wrench", "0,1/2,0", "--normal-law",
                                "unilateral", "--uncertain", "wrench=10%")
        self.assertEqual((wrench["verdict"], wrench["wrench"]), ("stable", ["0", "1/2", "0"]))

    def test_accuracy(self):
        grasp = self.write("g.json", with_friction(between("1/5", "3/5")))
        rough = self.json("radius", grasp, "--accuracy", "0.5")
        fine = self.json("radius", grasp, "--accuracy", "0.1%")
        gap = [1 - Fraction(a["proved"]) / Fraction(a["refuted"]) for a in (fine, rough)]
        self.assertLess(gap[0], Fraction(1, 1000))
        self.assertLess(gap[0], gap[1])

    def test_no_counterexample(self):
        # Whatever the friction, nothing moves where there is no load.
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0],
            "contacts": [{"position": [-1, 0], "normal": [1, 0], "friction": 1, "preload": 1},
                         {"position": [1, 0], "normal": [-1, 0], "friction": 1, "preload": 1}]})
        answer, _ = self.radius(grasp, "--uncertain", "friction=50%")
        self.assertEqual((answer["refuted"], answer["limit"]), (None, "2"))
        self.assertGreater(Fraction(answer["proved"]), 1)
        self.assertNotIn("counterexample", answer)
        text = stickslip("radius", grasp, "--uncertain", "friction=50%")[1]
        self.assertIn("No counterexample is known: at factor 2 the box reaches numbers", text)

    def test_text(self):
        folder = self.path("proofs")
        code, out, err = stickslip("radius", A, *QUICK, "--certificates", folder)
        self.assertEqual((code, err), (DONE, ""))
        self.assertEqual(out.split("\n")[0], "more friction breaks it: stable")
        self.assertRegex(out, r"asked +1 +10 %\n")
        self.assertRegex(out, r"proved +0\.\d+ +\d\.\d+ %\n")
        self.assertIn("Every grasp within the proved tolerances holds the load", out)
        self.assertIn("Within the refuted tolerances one does not hold it.", out)
        self.assertRegex(out, r"contacts\[0\]\.friction +2/5 ")
        self.assertIn(f"Proofs: in {folder}.", out)
        # What is rounded stays true.
        answer = self.json("radius", A, *QUICK)
        rows = {line.split()[0]: line.split() for line in out.split("\n") if " %" in line}
        self.assertLessEqual(Fraction(rows["proved"][1]), Fraction(answer["proved"]))
        self.assertGreaterEqual(Fraction(rows["refuted"][1]), Fraction(answer["refuted"]))
        exact = stickslip("radius", A, *QUICK, "--exact")[1]
        self.assertIn(f" {answer['proved']} ", exact)

    def test_irrational_lengths(self):
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0, "-3/10", 0],
            "defaults": {"friction": "1/2", "preload": 1},
            "contacts": [{"position": [-1, -1], "normal": [1, 1]},
                         {"position": [1, -1], "normal": [-1, 1]},
                         {"position": [0, 1], "normal": [0, -1]}]})
        self.assertEqual(self.radius(grasp, "--uncertain", "friction=10%")[0]["verdict"], "stable")

    def test_in_space(self):
        # Two fingers press with 4 each and bear 2 across: as much friction as 1/4 is enough.
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/2", "wrench": [0, 0, -2, 0, 0, 0], "name": "pinched",
            "units": {"length": "cm", "force": "N"},
            "contacts": [{"position": [side, 0, 0], "normal": [-side, 0, 0], "friction": "1/2",
                          "preload": 4} for side in (-1, 1)]})
        for kind, end in (("friction=10%", 5), ("preload=20%", Fraction(5, 2)), ("wrench=20%", 5)):
            answer, proved = self.radius(grasp, "--uncertain", kind, "--accuracy", "1%")
            self.assertEqual((answer["verdict"], answer["engine"]), ("stable", "space"))
            factor, refuted = Fraction(answer["proved"]), Fraction(answer["refuted"])
            self.assertGreater(factor, Fraction(95, 100) * end)
            self.assertLess(factor, end)
            self.assertGreater(refuted, end)
            self.assertLess(refuted, Fraction(102, 100) * end)
            self.assertEqual((proved["name"], proved["units"]["force"]), ("pinched", "N"))
        code, out, err = stickslip("radius", grasp, "--uncertain", "friction=10%")
        self.assertEqual((code, err, out.split("\n")[0]), (DONE, "", "pinched: stable"))
        self.assertRegex(out, r"contacts\[[01]\]\.friction +1/2 ")
        # Three feet slide below a friction of 2/5, with which they just stand.
        grasp = self.write("feet.json", {
            "format": "stickslip-grasp/2", "wrench": ["2/5", 0, -1, 0, 0, 0],
            "contacts": [{"position": p, "normal": [0, 0, 1], "friction": "1/4"}
                         for p in ([3, 2, "-1/2"], [3, -2, "-1/2"], [-3, 0, "-1/2"])]})
        answer, _ = self.radius(grasp, "--uncertain", "friction=10%")
        self.assertEqual(answer["verdict"], "unstable")
        self.assertLess(Fraction(answer["proved"]), 6)
        self.assertGreaterEqual(Fraction(answer["refuted"]), 6)
        self.assertLess(Fraction(answer["refuted"]), Fraction(61, 10))

    def test_balanced_on_an_edge(self):
        edge = {"format": "stickslip-grasp/2", "wrench": [0, 0, -2, 0, 0, 0], "defaults": {"friction": 1},
                "contacts": [{"position": [side, 0, 0], "normal": [0, 0, 1]} for side in (-1, 1)]}
        grasp = self.write("edge.json", edge)
        for words in ("position=0.1",), ("wrench=0.1",), ("position=1/1000", "--node-limit", "10"):
            answer = self.json("radius", grasp, "--uncertain", *words)
            self.assertEqual((answer["verdict"], answer["proved"]), ("stable", "0"))
            self.assertLess(Fraction(answer["refuted"]), Fraction(1, 10**5))
        self.assertEqual([w["trap"] for w in self.json("decide", grasp)["warnings"]], ["edge-balance"])
        out = stickslip("radius", grasp, "--uncertain", "wrench=0.1")[1]
        self.assertIn("it is on a threshold, or next to one.\n", out)
        # A third foot aside: as far as the load may go before it is beyond an edge, 1/10.
        edge["contacts"].append({"position": [0, 1, 0], "normal": [0, 0, 1]})
        grasp = self.write("feet.json", {**edge, "wrench": [0, 0, -2, "-1/5", 0, 0]})
        self.assertEqual(self.json("decide", grasp)["warnings"], [])
        answer, _ = self.radius(grasp, "--uncertain", "wrench=0.01", "--accuracy", "5%")
        self.assertLess(Fraction(answer["proved"]), 20)
        self.assertGreater(Fraction(answer["proved"]), 19)
        self.assertGreater(Fraction(answer["refuted"]), 20)
        for found, centre in zip(answer["counterexample"]["wrench"], (0, 0, -2, Fraction(-1, 5), 0, 0)):
            self.assertLessEqual(abs(Fraction(found) - centre), Fraction(answer["refuted"]) / 100)

    def test_knows_no_less_than_a_verdict(self):
        seen = set()
        for friction_of_all in ("1/10", "1/5", "1/4", "1/2"):
            for tolerance in ("friction=10%", "wrench=0.02", "position=0.05,friction=5%"):
                grasp = self.write("g.json", {
                    "format": "stickslip-grasp/2", "wrench": ["1/5", -1, 0], "defaults": {"friction": friction_of_all},
                    "contacts": [{"position": [x, 0], "normal": [0, 1]} for x in (-1, 1)]})
                verdict = self.json("decide", grasp, "--uncertain", tolerance)["verdict"]
                answer = self.json("radius", grasp, "--uncertain", tolerance)
                seen.add(verdict)
                if verdict == "fragile":
                    self.assertLessEqual(Fraction(answer["refuted"]), 1)
                else:
                    self.assertGreaterEqual(Fraction(answer["proved"]), 1)
                    self.assertEqual(answer["verdict"], verdict)
        self.assertEqual(seen, {"stable", "unstable", "fragile"})

    def test_errors(self):
        for words in ((), ("--uncertain", "friction=0")):
            self.fails("radius", A, *words, naming=["--uncertain: nothing is uncertain", "friction=10%"])
        for accuracy in ("0", "100%", "-1%", "1", "x%", ""):
            self.fails("radius", A, "--uncertain", "friction=10%", "--accuracy", accuracy,
                       naming=["--accuracy"])
        self.fails("radius", A, "--uncertain", "friction=101%", naming=[A, "contacts[0].friction"])
        taken = self.write("taken", "")
        self.fails("radius", A, *QUICK, "--certificates", taken,
                   naming=["--certificates", taken])
        self.assertEqual(stickslip("radius", A, "--uncertain", "mu=1")[0], BAD_INPUT)


if __name__ == "__main__":
    unittest.main()
