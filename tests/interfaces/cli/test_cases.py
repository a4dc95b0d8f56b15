# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasp files of version 2: loads, and several cases answered together."""

import sys
import unittest

from test_cli import BAD_INPUT, CHECK, CHECK_PY, DONE, STABLE, UNDECIDED, UNSTABLE, Case, checkers, read, run, stickslip

SHELF = {
    "format": "stickslip-grasp/2", "name": "shelf", "defaults": {"friction": "1/2", "stiffness": 1},
    "contacts": [{"position": [0, 0], "normal": [0, 1]}, {"position": [4, 0], "normal": [0, 1]}],
    "loads": [{"weight": 10, "at": [2, 1]}],
    "cases": [{"name": "at rest", "loads": []},
              {"name": "pushed", "loads": [{"force": ["3/2", 0], "at": [2, 3]}]},
              {"name": "lifted", "wrench": [0, 11, 22]}]}
WRENCHES = {"at rest": "0,-10,-20", "pushed": "3/2,-10,-49/2", "lifted": "0,1,2"}  # by hand
VERDICTS = {"at rest": "stable", "pushed": "stable", "lifted": "unstable"}


class Cases(Case):
    def setUp(self):
        super().setUp()
        self.grasp = self.write("shelf.json", SHELF)

    def with_cases(self, *names):
        return self.write("some.json", {**SHELF, "cases": [
            entry for entry in SHELF["cases"] if entry["name"] in names]})

    def test_each_answer_is_that_of_its_wrench(self):
        for options in ((), ("--preload", "1"), ("--normal-law", "bilateral"), ("--engine", "states"),
                        ("--no-warnings", "--floats")):
            together = self.json("decide", self.grasp, *options)
            self.assertEqual((list(together), together["name"]), (["name", "cases"], "shelf"))
            self.assertEqual([answer["case"] for answer in together["cases"]], list(WRENCHES))
            for answer in together["cases"]:
                name = answer["case"]
                self.assertEqual(self.json("decide", self.grasp, "--case", name, *options), answer)
                del answer["case"]
                wrench = WRENCHES[name]
                self.assertEqual(self.json("decide", self.grasp, "--wrench", wrench, *options), answer)
                self.assertEqual(",".join(answer["wrench"]), wrench)
                if not options:
                    self.assertEqual(answer["verdict"], VERDICTS[name])

    def test_table(self):
        code, out, err = stickslip("decide", self.grasp, "--no-warnings")
        self.assertEqual((code, err), (DONE, ""))
        self.assertTrue(out.startswith("shelf: 3 cases\n\n"
                                       "case     verdict   load w\n"
                                       "at rest  stable    (0, -10, -20)\n"
                                       "pushed   stable    (3/2, -10, -49/2)\n"
                                       "lifted   unstable  (0, 1, 2)\n\n"), out)

    def test_a_warning_is_printed_once(self):
        preloaded = {**SHELF, "defaults": {"friction": "1/2", "preload": 1}}
        out = stickslip("decide", self.write("g.json", preloaded))[1]
        self.assertEqual(out.count("do not balance"), 1)
        self.assertIn("\nWarning, at rest, pushed, lifted: the preloads do not balance", out)
        self.assertEqual(out.count("too large"), 1)
        self.assertIn("\nWarning, pushed: stiffness that is not given was taken as 1, with which the motion found is too large", out)

    def test_titles_name_the_case(self):
        out = stickslip("decide", self.grasp, "--case", "pushed")[1]
        self.assertTrue(out.startswith("shelf, pushed: stable\n"), out)

    def test_exit_code_of_the_worst(self):
        def code(grasp, *options):
            return stickslip("decide", grasp, "--exit-code", *options)[0]

        self.assertEqual(code(self.grasp), UNSTABLE)
        self.assertEqual(code(self.with_cases("at rest", "pushed")), STABLE)
        self.assertEqual(code(self.with_cases("lifted")), UNSTABLE)
        for name, verdict in VERDICTS.items():
            self.assertEqual(code(self.grasp, "--case", name),
                             STABLE if verdict == "stable" else UNSTABLE)

    def test_undecided_is_worse_than_stable_and_better_than_unstable(self):
        # One node is enough for the first and for the last case, not for the second.
        contacts = [*SHELF["contacts"], {"position": [4, 2], "normal": [-1, 0]}]
        grasp = {**SHELF, "contacts": contacts,
                 "cases": [SHELF["cases"][0], {"name": "tilted", "wrench": [6, 9, 0]},
                           SHELF["cases"][2]]}
        all_cases = self.write("all.json", grasp)
        limit = ("--node-limit", "1", "--no-warnings")
        verdicts = [a["verdict"] for a in self.json("decide", all_cases, *limit, code=UNDECIDED)["cases"]]
        self.assertEqual(verdicts, ["stable", "undecided", "unstable"])
        self.assertEqual(stickslip("decide", all_cases, *limit, "--exit-code")[0], UNSTABLE)
        two = self.write("two.json", {**grasp, "cases": grasp["cases"][:2]})
        self.assertEqual(stickslip("decide", two, *limit, "--exit-code")[0], UNDECIDED)

    def test_one_case_is_a_list_too(self):
        grasp = self.with_cases("pushed")
        self.assertEqual([a["case"] for a in self.json("decide", grasp)["cases"]], ["pushed"])
        self.assertIn("shelf: 1 case\n", stickslip("decide", grasp)[1])

    def test_proof_of_a_case(self):
        proof = self.path("proof.json")
        self.fails("decide", self.grasp, "--certificate", proof, naming=["--certificate", "--case NAME"])
        for name, verdict in VERDICTS.items():
            stickslip("decide", self.grasp, "--case", name, "--certificate", proof)
            for checker in checkers(proof):
                code, out, _ = run(*checker, self.grasp, proof, "--case", name)
                self.assertEqual(code, 0, out)
                self.assertIn(f"verdict     {verdict}\n", out)
                self.assertEqual(run(*checker, self.grasp, proof, "--wrench", WRENCHES[name])[:2], (0, out))
                self.assertEqual(run(*checker, self.grasp, proof)[0], BAD_INPUT)
                for other in WRENCHES:
                    if other != name:
                        self.assertEqual(run(*checker, self.grasp, proof, "--case", other)[0], 1)

    def test_margin_starts_from_the_case(self):
        options = ("--direction", "1,0,0", "--certificate", self.path("margin.json"))
        for name, wrench in WRENCHES.items():
            answer = self.json("margin", self.grasp, *options, "--case", name)
            self.assertEqual(answer.pop("case"), name)
            self.assertEqual(answer, self.json("margin", self.grasp, *options, "--wrench", wrench))
            out = stickslip("margin", self.grasp, *options, "--case", name)[1]
            self.assertTrue(out.startswith(f"shelf, {name}: loads w + l u"), out)
            self.assertEqual(run(CHECK, self.grasp, self.path("margin.json"), "--direction", "1,0,0",
                                 "--case", name)[0], 0)
        self.assertEqual(self.json("margin", self.grasp, *options)["wrench"], ["0", "0", "0"])
        # Along preloads alone the load is the file's, and so that of a case.
        preloads = ("--preload", "1", "--preload-direction", "scale")
        self.fails("margin", self.grasp, *preloads, naming=["--case", "none is chosen"])
        answer = self.json("margin", self.grasp, *preloads, "--case", "pushed")
        self.assertEqual(",".join(answer["wrench"]), WRENCHES["pushed"])

    def test_commands_that_need_a_load_ask_for_the_case(self):
        for command in (["plot", "grasp"], ["export", "--smt2"], ["compare"]):
            self.fails(*command, self.grasp, naming=[
                self.grasp + ": --case: ", "none is chosen", '"at rest", "pushed", "lifted"'])
            self.assertEqual(stickslip(*command, self.grasp, "--case", "pushed")[0], DONE)
        for command in (["states"], ["region"], ["plot", "states"], ["plot", "region"]):
            self.assertEqual(stickslip(*command, self.grasp)[0], DONE)

    def test_batch(self):
        one_line = self.write("all.jsonl", str(SHELF).replace("'", '"') + "\n")
        code, out, _ = stickslip("batch", one_line)
        self.assertEqual(code, BAD_INPUT)
        self.assertIn("none is chosen", out)
        code, out, _ = stickslip("batch", one_line, "--case", "lifted")
        self.assertEqual(code, DONE)
        self.assertIn('"verdict":"unstable"', out)

    def test_crosscheck(self):
        def outcome(options):
            line = {"grasp": "shelf.json", "options": options, "claim": {"verdict": "unstable"}}
            return stickslip("crosscheck", self.write("claims.jsonl", line))

        self.assertEqual(outcome({"case": "lifted"})[0], 0)
        self.assertEqual(outcome({"case": "pushed"})[0], 1)
        self.assertIn("options.case", outcome({"case": "pulled"})[1])
        self.assertIn("options.case", outcome({"case": 1})[1])

    def test_what_may_be_meant(self):
        self.fails("decide", self.grasp, "--case", "lift", naming=[
            "shelf.json", '--case: the grasp has no case "lift"; did you mean "lifted"?'])
        self.fails("decide", self.grasp, "--case", "lifted", "--wrench", "0,0,0", naming=["--case", "--wrench"])
        version1 = self.write("v1.json", {**SHELF, "format": "stickslip-grasp/1"})
        self.fails("decide", version1, naming=['unknown key "loads"', '"format": "stickslip-grasp/2"'])

    def test_units_are_told_and_change_nothing(self):
        units = {"length": "mm", "force": "N"}
        told = "\nUnits: force N, length mm, torque N mm.\n"
        grasp = self.write("units.json", {**SHELF, "units": units})
        for words in (["decide", "--case", "pushed"], ["decide"], ["compare", "--case", "pushed"],
                      ["margin", "--direction", "0,-1,0"], ["region"]):
            plain, with_units = self.json(*words, self.grasp), self.json(*words, grasp)
            self.assertNotIn("units", plain)
            if "cases" in with_units:
                for answer in with_units["cases"]:
                    self.assertEqual(answer.pop("units"), units)
            else:
                self.assertEqual(with_units.pop("units"), units)
            self.assertEqual(with_units, plain)
            self.assertIn(told, stickslip(*words, grasp)[1])
            self.assertNotIn("Units", stickslip(*words, self.grasp)[1])

    def test_contacts_on_the_outline(self):
        """A proof about them is one about their positions and normals, and about no others."""
        outline = [[[0, 0], [4, 0], [8, 3], [0, 3]], [[1, 1], [3, 1], [1, 2]]]
        contacts = [{"on": [0, "1/2"]}, {"on": [1, 0.2]}, {"on": [2, "1/3"]}, {"on": [4, "3/4"]}]
        plain = [{"position": [2, 0], "normal": [0, 1]},
                 {"position": ["24/5", "3/5"], "normal": ["-3/5", "4/5"]},
                 {"position": ["16/3", 3], "normal": [0, -1]},
                 {"position": ["5/2", 1], "normal": [0, -1]}]
        rest = {"wrench": ["1/2", "-1/3", "1/5"], "defaults": {"friction": "1/2", "preload": 1}}
        on = {"format": "stickslip-grasp/2", "outline": outline, "contacts": contacts, **rest}
        files = [self.write("on.json", on),
                 self.write("plain.json", {"format": "stickslip-grasp/1", "contacts": plain, **rest})]
        moved = [self.write(f"moved{i}.json", {**on, "contacts": [
            {"on": [c["on"][0], "1/7"] if i == j else c["on"]} for j, c in enumerate(contacts)]})
            for i in range(len(contacts))]
        for wrench in ("1/2,-1/3,1/5", "0,40,0", "0,0,0"):
            proofs = []
            for i, file in enumerate(files):
                proofs.append(self.path(f"proof{i}.json"))
                stickslip("decide", file, "--wrench", wrench, "--certificate", proofs[-1])
            for checker in checkers(proofs[0]):
                for file in files:
                    for proof in proofs:
                        self.assertEqual(run(*checker, file, proof, "--wrench", wrench)[0], 0)
            answers = [run(CHECK, file, proofs[0], "--wrench", wrench)[0] for file in moved]
            self.assertEqual(answers, [run(sys.executable, "-B", CHECK_PY, file, proofs[0],
                                           "--wrench", wrench)[0] for file in moved])
            if wrench.startswith("1/2"):
                self.assertIn(1, answers)

    def test_irrational_edges_need_snap_under_preload(self):
        grasp = {"format": "stickslip-grasp/2", "name": "wedge", "wrench": [0, 0, 0],
                 "outline": [[0, 0], [2, 0], [1, 1]], "defaults": {"friction": 1, "preload": 1},
                 "contacts": [{"on": [0, "1/2"]}, {"on": [1, "1/2"]}], "units": {"length": "m", "force": "N"}}
        wedge, snapped = self.write("wedge.json", grasp), self.path("snapped.json")
        self.fails("compare", wedge, naming=["contacts[1].normal", "stickslip snap GRASP -o FILE"])
        self.assertEqual(stickslip("decide", wedge, "--preload", "0")[0], DONE)
        self.assertEqual(stickslip("snap", wedge, "-o", snapped)[0], DONE)
        self.assertEqual(self.json("decide", snapped)["units"], grasp["units"])
        self.assertIn('"outline": [[[[0, 0], [2, 0], [1, 1]]]]', read(snapped))

    def test_snap_keeps_cases(self):
        grasp = {**SHELF, "contacts": [{"position": [0, 0], "normal": [1, 1], "preload": 1},
                                       SHELF["contacts"][1]]}
        snapped = self.path("snapped.json")
        self.assertEqual(stickslip("snap", self.write("g.json", grasp), "-o", snapped)[0], DONE)
        for name, wrench in WRENCHES.items():
            self.assertEqual(self.json("decide", snapped, "--case", name)["wrench"], wrench.split(","))


if __name__ == "__main__":
    unittest.main()
