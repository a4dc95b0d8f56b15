# SPDX-License-Identifier: GPL-3.0-or-later
"""Questions about all grasps in a box: uncertain numbers of files and --uncertain."""

import json
import os
import unittest
from fractions import Fraction
from fractions import Fraction as F

from test_cli import (BAD_INPUT, CORPUS, DONE, FIG1, SANITIZED, STABLE, UNDECIDED, UNSTABLE,
                      Case, read, stickslip)

FRAGILE = 30
QUICK = ("--node-limit", "1")
EXAMPLES = os.path.join(CORPUS, "..", "..", "..", "examples", "grasps")
# More friction of contact 2 breaks it: stable up to 1/2, unstable above.
A = os.path.join(EXAMPLES, "more-friction-breaks.json")
UNCERTAIN = os.path.join(CORPUS, "uncertain", "all.json")


def with_friction(friction, path=A):
    """Grasp A in version 2 with another friction at contact 2."""
    grasp = json.loads(read(path))
    grasp["format"] = "stickslip-grasp/2"
    grasp["contacts"][2]["friction"] = friction
    return grasp


def between(low, high):
    return {"min": low, "max": high}


class AtRest(Case):
    """Nothing moves, and friction answers what is left of the load."""

    # Two pairs of fingers, preloaded: friction is at most 1 along each axis.
    GRASP = {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2"},
             "contacts": [{"position": [-1, 0], "normal": [1, 0], "preload": 2},
                          {"position": [1, 0], "normal": [-1, 0], "preload": 2},
                          {"position": [0, 1], "normal": [0, -1], "preload": 1},
                          {"position": [0, -1], "normal": [0, 1], "preload": 1}]}
    WORDS = ("--uncertain", "friction=5%,position=0.01,normal=0.01")

    def proof(self, load, law):
        file = self.write("g.json", {**self.GRASP, "wrench": load})
        words = (*self.WORDS, "--normal-law", law)
        proof = self.path("proof.json")
        answer = json.loads(stickslip("decide", file, *words, "--json", "--certificate", proof)[1])
        self.assertEqual(answer["verdict"], "stable")
        self.accepted(file, proof, *words, verdict="stable")
        return answer["proof"]

    def test_needs_no_tree(self):
        for law in ("unilateral", "bilateral"):
            self.assertEqual(self.proof(["1/5", "-1/4", "1/7"], law), {"nodes": 0, "parts": 1, "at_rest": True})
        out = stickslip("decide", self.write("g.json", {**self.GRASP, "wrench": [0, 0, 0]}), *self.WORDS)[1]
        self.assertIn("nothing moves", out)

    def test_is_not_said_of_what_moves(self):
        self.assertIs(self.proof([0, "-9/4", 0], "unilateral")["at_rest"], False)


class Asking(Case):
    """What does not depend on the answer."""

    def asked(self, *words):
        """The answer, whatever it is, without much search for it."""
        code, out, err = stickslip("decide", *words, "--json", *QUICK)
        self.assertIn(code, (DONE, UNDECIDED), err)
        return json.loads(out)

    def test_what_is_uncertain_is_said(self):
        answer = self.asked(self.write("g.json", with_friction(between("2/5", 0.6))))
        self.assertIs(answer["box"], True)
        self.assertIn(answer["verdict"], ("stable", "unstable", "fragile", "undecided"))
        self.assertEqual(answer["uncertain"],
                         [{"place": "contacts[2].friction", "interval": ["2/5", "3/5"]}])
        self.assertEqual((answer["wrench"], answer["normal_law"], answer["engine"]),
                         (["-2", "2", "-2"], "unilateral", "intervals"))
        self.assertNotIn("bits", answer)
        self.assertEqual(set(answer["stats"]),
                         {"nodes", "pieces", "leaves", "rays", "most_rays", "pairs", "ray_bits", "twist_bits", "filter_hits", "exact_checks",
                          "proofs", "examples", "parts"})

    def test_tolerances_widen(self):
        words = ("friction=10%,stiffness=1/2,preload=1,position=1/100,normal=0.0175,wrench=50%")
        answer = self.asked(A, "--uncertain", words)
        found = {entry["place"]: entry.get("interval", entry.get("slope"))
                 for entry in answer["uncertain"]}
        for i, (x, y) in enumerate(((-2, -1), (-2, -1), (2, -2))):
            for member, interval in (("friction", ["9/25", "11/25"]), ("stiffness", ["1/2", "3/2"]),
                                     ("preload", ["0", "2"]), ("normal", "7/400")):
                self.assertEqual(found.pop(f"contacts[{i}].{member}"), interval)
            for j, p in enumerate((x, y)):
                self.assertEqual(found.pop(f"contacts[{i}].position[{j}]"),
                                 [str(p - Fraction(1, 100)), str(p + Fraction(1, 100))])
        self.assertEqual(found, {"wrench[0]": ["-3", "-1"], "wrench[1]": ["1", "3"],
                                 "wrench[2]": ["-3", "-1"]})
        self.assertEqual(answer["wrench"], [["-3", "-1"], ["1", "3"], ["-3", "-1"]])

    def test_tolerances_come_after_what_is_replaced(self):
        answer = self.asked(UNCERTAIN, "--preload", "2", "--wrench", "1,0,-4",
                            "--uncertain", "preload=25%,wrench=10%,normal=1/400")
        found = {entry["place"]: entry.get("interval", entry.get("slope"))
                 for entry in answer["uncertain"]}
        self.assertEqual([found[f"contacts[{i}].preload"] for i in range(3)], 3 * [["3/2", "5/2"]])
        self.assertEqual(answer["wrench"], [["9/10", "11/10"], "0", ["-22/5", "-18/5"]])
        self.assertEqual([found[f"contacts[{i}].normal"] for i in range(3)],
                         ["1/50", "1/400", "1/400"])
        self.assertEqual(found["contacts[0].friction"], ["2/5", "3/5"])  # as in the file

    def test_cases(self):
        answer = self.asked(UNCERTAIN)
        self.assertEqual([(case["case"], case["box"], case["wrench"]) for case in answer["cases"]],
                         [("certain", True, ["0", ["-11", "-10"], "0"]),
                          ("uncertain", True, [["-1", "1"], ["-11", "-10"], "0"])])
        self.assertEqual(self.asked(UNCERTAIN, "--case", "uncertain")["wrench"],
                         answer["cases"][1]["wrench"])
        # Only the load of one case is uncertain: the other is a question about one grasp.
        mixed = self.asked(os.path.join(CORPUS, "uncertain", "one_case.json"))["cases"]
        self.assertEqual([case.get("box", False) for case in mixed], [False, True])
        self.assertEqual(mixed[0]["verdict"], "stable")
        out = stickslip("decide", os.path.join(CORPUS, "uncertain", "one_case.json"), *QUICK)[1]
        self.assertRegex(out, r"b +\w+ +\(0, \[-2, -1\], 0\)")
        for option in ("--certificate", "--examples"):
            self.fails("decide", UNCERTAIN, option, self.path("x"), naming=[option, "--case NAME"])

    def test_no_width_is_no_box(self):
        grasp = self.write("g.json", with_friction(between("2/5", "2/5")))
        answer = self.json("decide", grasp, "--uncertain", "friction=0,preload=0%")
        self.assertNotIn("box", answer)
        self.assertEqual(answer["verdict"], "stable")

    def test_text_shows_the_box(self):
        def shown(tolerances):
            return stickslip("decide", A, "--uncertain", tolerances, *QUICK)[1]

        out = shown("friction=10%,wrench=1")
        self.assertIn("load w    ([-3, -1], [1, 3], [-3, -1])", out)
        self.assertRegex(out, r"contacts\[2\]\.friction +9/25 +11/25\n")
        self.assertIn("Engine: intervals; normal law: unilateral", out)
        many = shown("friction=10%,position=1e-3,normal=1e-3")
        self.assertIn("contacts[0].normal, slope", many)
        self.assertNotIn("more, which --json lists", many)  # 12 rows
        more = shown("friction=10%,position=1e-3,normal=1e-3,wrench=1")
        self.assertIn("and 3 more, which --json lists", more)

    def test_bad_boxes(self):
        """What is wrong with the box or with the tolerances; tests/core has all that may be."""
        self.fails("decide", A, "--uncertain", "normal=1", naming=[A, ": contacts[0].normal: "])
        self.fails("decide", A, "--uncertain", "fricton=1", naming=["--uncertain: ", 'did you mean "friction"?'])
        empty = self.write("g.json", with_friction(between("1/2", "1/3")))
        self.fails("decide", empty, naming=["contacts[2].friction", "is empty", "min"])
        self.fails("decide", self.write("g.json", with_friction(between(-1, 1))),
                   naming=["contacts[2].friction", "0 or more"])
        old = {**with_friction(between(0, 1)), "format": "stickslip-grasp/1"}
        self.fails("decide", self.write("g.json", old), naming=["contacts[2].friction", "grasp/2"])
        for engine in ("states", "branch-and-bound"):
            self.fails("decide", UNCERTAIN, "--case", "certain", "--engine", engine,
                       naming=["--engine", "box"])

    def test_all_other_commands_refuse_intervals(self):
        grasp = self.write("g.json", with_friction(between("2/5", "1/2")))
        for command, *options in (("states",), ("margin", "--direction", "0,1,0"),
                                  ("margin", "--preload-direction", "scale"), ("region",),
                                  ("plot grasp",), ("plot states",), ("plot region",), ("snap", "-o", "-"),
                                  ("compare",), ("export", "--smt2")):
            self.fails(*command.split(), grasp, *options,
                       naming=[grasp, "contacts[2].friction", "stickslip decide, radius and batch"])
        self.fails("margin", UNCERTAIN, "--direction", "0,1,0", naming=["stickslip decide, radius and batch"])
        code, out, _ = stickslip("batch", self.write("g.jsonl", json.dumps(json.loads(read(grasp)))), "--class")
        self.assertEqual((code, json.loads(out)["error"]["place"]), (BAD_INPUT, "contacts[2].friction"))
        claim = {"claim": {"verdict": "stable"}}
        for value in (json.loads(read(grasp)), grasp):
            claims = self.write("claims.jsonl", json.dumps({"grasp": value, **claim}) + "\n")
            code, out, err = stickslip("crosscheck", claims)
            self.assertEqual(code, BAD_INPUT)
            self.assertIn("contacts[2].friction", out + err)

    def test_commands_without_the_option(self):
        for command in (("margin", FIG1, "--direction", "0,1,0"), ("compare", FIG1), ("region", FIG1)):
            self.fails(*command, "--uncertain", "friction=1%", naming=["--uncertain"])


class Answers(Case):
    """What the engine answers; each proof is judged by both checkers."""

    def answer(self, verdict, grasp, *words, box=True):
        """Asks twice, and lets both checkers judge the proof."""
        proof = self.path("proof.json")
        code = {"stable": STABLE, "unstable": UNSTABLE}[verdict]
        answer = self.json("decide", grasp, *words, "--exit-code", "--certificate", proof, code=code)
        self.assertEqual((answer["verdict"], answer.get("box")), (verdict, True if box else None))
        self.assertEqual(set(answer) & {"proof", "refutation"},
                         {"proof" if verdict == "stable" else "refutation"})
        self.accepted(grasp, proof, *words)
        os.remove(proof)
        return answer

    def test_stable_and_unstable_throughout(self):
        for low, high, verdict in (("1/10", "9/20", "stable"), ("0", "49/100", "stable"),
                                   ("51/100", "1", "unstable")):
            grasp = self.write("g.json", with_friction(between(low, high)))
            self.answer(verdict, grasp)
            sentence = "Every grasp in the box holds" if verdict == "stable" else "No grasp in the box"
            self.assertIn(sentence, stickslip("decide", grasp)[1])
        self.answer("stable", A, "--uncertain", "friction=0.001,wrench=0.001")
        self.answer("stable", FIG1, "--uncertain", "friction=5%,wrench=1%")
        self.answer("stable", FIG1, "--uncertain",
                    "friction=2%,stiffness=2%,preload=2%,position=0.002,normal=0.002,wrench=1%")

    def test_fragile(self):
        grasp = self.write("g.json", with_friction(between("2/5", "3/5")))
        folder, proof = self.path("examples"), self.path("proof.json")
        code, out, err = stickslip("decide", grasp, "--examples", folder, "--exit-code")
        self.assertEqual((code, err), (FRAGILE, ""))
        self.assertIn("Some grasps in the box hold the load and some do not.", out)
        self.assertIn(f"Both are in {folder}", out)
        answer = self.json("decide", grasp)  # exit code 0
        self.assertEqual(answer["verdict"], "fragile")
        difference, = answer["differences"]
        self.assertEqual(difference["place"], "contacts[2].friction")
        self.assertEqual(sorted(os.listdir(folder)), sorted(
            f"{verdict}{end}" for verdict in ("stable", "unstable") for end in (".json", ".certificate.json")))
        for verdict in ("stable", "unstable"):
            example = os.path.join(folder, f"{verdict}.json")
            friction = Fraction(json.loads(read(example))["contacts"][2]["friction"])
            self.assertEqual(friction, Fraction(difference[verdict]))
            self.assertTrue(Fraction(2, 5) <= friction <= Fraction(3, 5))
            self.assertEqual(friction > Fraction(1, 2), verdict == "unstable")
            self.assertEqual(json.loads(read(example))["name"], "more friction breaks it")
            self.accepted(example, os.path.join(folder, f"{verdict}.certificate.json"))
            given = answer["examples"][verdict]["contacts"][2]["friction"]
            self.assertEqual(Fraction(given), friction)
        # All frictions at once: less of the others breaks it as well.
        self.assertEqual(self.json("decide", A, "--uncertain", "friction=5%")["verdict"], "fragile")
        # One certificate cannot say it.
        code, _, err = stickslip("decide", grasp, "--certificate", proof)
        self.assertEqual(code, DONE)
        self.assertIn("--examples DIR", err)
        self.assertFalse(os.path.exists(proof))
        self.assertIn("--examples DIR writes both", stickslip("decide", grasp)[1])

    @unittest.skipIf(SANITIZED, "for its answers")
    def test_tolerances_of_fingers_are_too_wide(self):
        # Three fingers with two contacts each: corners of the box at which Newton's method is lost are decided.
        unit = [(F(-23001, 25049), F(-9920, 25049)), (F(-31755, 34493), F(-13468, 34493)), (F(540, 829), F(-629, 829)),
                (F(225, 353), F(-272, 353)), (F(165, 1517), F(1508, 1517)), (F(671, 1921), F(1800, 1921))]
        heights = F(-3, 10), F(1, 5), F(-11, 20), F(-1, 20), F(-9, 20), F(1, 20)
        words = [[str(F(x)) for x in (*u, z)] for u, z in zip(unit, heights)]
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/2", "defaults": {"friction": "13/20", "preload": 1},
            "contacts": [{"position": p, "normal": [str(-x) for x in u] + ["0"]} for p, u in zip(words, unit)],
            "wrench": ["349/905", "698/905", "-698/181", "1047/9050", "-8027/18100", "-349/4525"]})
        tolerances = "normal=0.035,friction=5%,position=1/60"
        folder = self.path("examples")
        code, out, _ = stickslip("decide", grasp, "--uncertain", tolerances, "--examples", folder, "--exit-code")
        self.assertEqual(code, FRAGILE, out)
        for verdict in ("stable", "unstable"):
            example = os.path.join(folder, f"{verdict}.json")
            self.accepted(example, os.path.join(folder, f"{verdict}.certificate.json"), verdict=verdict)
            for old, new in zip(unit, json.loads(read(example))["contacts"]):
                n = [F(x) for x in new["normal"]]
                along = -n[0] * old[0] - n[1] * old[1]
                self.assertLessEqual(sum(x * x for x in n) - along ** 2, F("0.035") ** 2 * along ** 2)

    def test_examples_of_what_is_not_fragile(self):
        folder = self.path("examples")
        grasp = self.write("g.json", with_friction(between("1/10", "9/20")))
        for asked, verdict in ((grasp, "stable"), (FIG1, "stable")):
            code, out, err = stickslip("decide", asked, "--examples", folder)
            self.assertEqual(code, DONE)
            self.assertIn(verdict, out.split("\n")[0])
            self.assertIn("--examples: nothing is written", err)
            self.assertFalse(os.path.exists(folder))

    def test_irrational_lengths_need_no_snap(self):
        cup = {"format": "stickslip-grasp/1", "name": "cup", "wrench": [0, "-3/10", 0],
               "defaults": {"friction": "1/2", "preload": 1},
               "contacts": [{"position": [-1, -1], "normal": [1, 1]},
                            {"position": [1, -1], "normal": [-1, 1]},
                            {"position": [0, 1], "normal": [0, -1]}]}
        grasp = self.write("g.json", cup)
        answer = self.answer("stable", grasp, box=False)
        self.assertEqual((answer["uncertain"], answer["enclosed"]), ([], [0, 1]))
        self.assertGreaterEqual(answer["bits"], 128)
        out = stickslip("decide", grasp)[1]
        self.assertIn("have irrational lengths |n|: P/|n| was enclosed to 128 bits", out)
        self.assertRegex(out, r"\n  motion d  near \([^)]*\)\n")
        self.assertEqual(len(answer["near"]), 3)
        self.answer("unstable", grasp, "--wrench", "0,0,100", box=False)
        self.answer("stable", grasp, "--normal-law", "bilateral", box=False)
        # Nobody made a box, and nobody reads of one.
        for words in ((), ("--wrench", "0,0,100"), ("--json",), ("--node-limit", "1"), ("--examples", self.path("e"))):
            code, out, err = stickslip("decide", grasp, *words)
            self.assertIn(code, (DONE, UNDECIDED))
            self.assertNotIn("box", out + err)
        for engine in ("states", "branch-and-bound"):
            self.fails("decide", grasp, "--engine", engine, naming=["--engine", "irrational length", "snap"])
        self.assertIs(self.json("decide", grasp, "--uncertain", "friction=1/1000")["box"], True)

    def test_cases_have_the_exit_code_of_the_worst(self):
        grasp = with_friction(between("2/5", "3/5"))
        grasp["wrench"] = [0, 0, 0]
        cases = {"no load": [0, 0, 0], "fragile": [-2, 2, -2], "far": [1000, 0, 0]}

        def code(*names):
            content = {**grasp, "cases": [{"name": name, "wrench": cases[name]} for name in names]}
            return stickslip("decide", self.write("c.json", content), "--exit-code")[0]

        self.assertEqual(code("fragile"), FRAGILE)
        self.assertEqual(code("fragile", "far"), UNSTABLE)


if __name__ == "__main__":
    unittest.main()
