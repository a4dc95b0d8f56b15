# SPDX-License-Identifier: GPL-3.0-or-later
"""`stickslip crosscheck`: classes, exit codes, both forms of output, saved files."""

import json
import os
import re
import resource
import shutil
import signal
import subprocess
from fractions import Fraction

from test_cli import BAD_INPUT, CHECK, DONE, STICKSLIP, UNDECIDED, Case, checkers, run, stickslip

WRONG = 1
MU = {"friction": "1/2"}
FIG1 = {"format": "stickslip-grasp/1", "name": "Fig. 1", "defaults": MU, "wrench": [0, 0, 0],
        "contacts": [{"position": [-1, 0], "normal": [1, 0]},
                     {"position": [0, -1], "normal": [0, 1]},
                     {"position": [1, 0], "normal": [-1, 0]}]}
DIAGONAL = {"format": "stickslip-grasp/1", "defaults": MU, "wrench": ["-1/2", "-1/2", 0],
            "contacts": [{"position": [0, 0], "normal": [1, 1]}]}


def claim(wrench, preload, verdict, grasp="fig1.json", **solution):
    return {"grasp": grasp, "options": {"wrench": wrench, "preload": preload},
            "claim": {"verdict": verdict, **solution}}


RIGHT = claim([0, 1, 0], 1, "stable", twist=[0, 1, 0], forces=[[1, -0.5], [0, 0], [1, 0.5]])
OFF = claim([0, 1, 0], 1, "stable", twist=[0, 1, 0], forces=[[1, -0.5], [0, 0], [1, 0.25]])
TIE = claim([0, "1.000000000001", 0], 1, "stable")
WRONG_STABLE = claim([0, "1.1", 0], 1, "stable", twist=[0, 1, 0])
WRONG_UNSTABLE = claim([0, -1, 0], 0, "unstable", grasp=FIG1)


class Claims(Case):
    def setUp(self):
        super().setUp()
        self.write("fig1.json", FIG1)

    def claims(self, *lines):
        return self.write("claims.jsonl", "".join(
            (line if isinstance(line, str) else json.dumps(line)) + "\n" for line in lines))

    def judge(self, *lines, options=(), code=DONE):
        found, out, err = stickslip("crosscheck", self.claims(*lines), "--json", *options)
        self.assertEqual((found, err), (code, ""), out)
        *reports, summary = [json.loads(line) for line in out.splitlines()]
        return reports, summary["summary"]


class Crosscheck(Claims):
    def test_an_equilibrium_beyond_the_bound_is_none(self):
        # It presses 1 for each unit that it gives, in words that are exact.
        foot = {"format": "stickslip-grasp/2", "contacts": [{"position": [0, 0, 0], "normal": [0, 0, 1], "friction": 1}],
                "max_motion": [0.5] * 6, "wrench": [0, 0, 0, 0, 0, 0]}
        held = claim([0, 0, -1, 0, 0, 0], 0, "stable", grasp=foot, twist=[0, 0, -1, 0, 0, 0], force_vectors=[[0, 0, 1]])
        [report], _ = self.judge(held, code=WRONG)
        self.assertEqual((report["class"], report["verdict"]), ("wrong", "unstable"))
        del foot["max_motion"]
        [report], _ = self.judge(held)
        self.assertEqual(report["class"], "right")

    def test_exit_codes(self):
        for lines, options, code in (
                ((RIGHT, TIE, OFF), (), DONE),
                ((RIGHT, WRONG_STABLE), (), WRONG),
                ((RIGHT, "nonsense"), (), BAD_INPUT),
                (("nonsense", WRONG_UNSTABLE, TIE), (), WRONG),
                ((WRONG_STABLE,), ("--node-limit", 1), UNDECIDED),
                ((WRONG_STABLE, "nonsense"), ("--node-limit", 1), BAD_INPUT),
                ((TIE,), ("--tie", "1e-13"), WRONG)):
            path = self.claims(*lines)
            self.assertEqual(stickslip("crosscheck", path, *options)[0], code, lines)
            self.assertEqual(stickslip("crosscheck", path, "--json", *options)[0], code, lines)

    def test_bad_usage(self):
        self.fails("crosscheck", self.path("nowhere.jsonl"), naming=["nowhere.jsonl"])
        self.fails("crosscheck", self.folder, naming=["directory"])
        self.fails("crosscheck", self.claims(), naming=["no claim"])
        path = self.claims(RIGHT)
        self.fails("crosscheck", path, "--tie", "-1", naming=["--tie"])
        self.fails("crosscheck", path, "--tie", "x", naming=["--tie"])
        self.fails("crosscheck", path, "--residual-tolerance", "-1e-9",
                   naming=["--residual-tolerance"])
        self.fails("crosscheck", path, "--save", os.path.join(path, "below"), naming=["--save"])

    def test_bad_lines_between_good_ones(self):
        bad = ["{", "[]", json.dumps({"grasp": "fig1.json"}),
               json.dumps(claim([0, 1], 1, "stable")),
               json.dumps(claim([0, 1, 0], 1, "stabel")),
               json.dumps(claim([0, 1, 0], 1, "stable", grasp="nowhere.json")),
               json.dumps(claim([0, 1, 0], 1, "stable", grasp="no\nwhere.json")),
               json.dumps(claim([0, 1, 0], 1, "stable", forces=[[1, 0]])),
               json.dumps(claim([0, 1, 0], 0, "stable", grasp=DIAGONAL, forces=[[1, 0]])),
               json.dumps({"grasp": FIG1, "claim": {"verdict": "stable"}, "extra": 1}),
               "\u00e9", "\x00"]
        lines = [line for pair in zip([RIGHT] * len(bad), bad) for line in pair] + ["", RIGHT]
        reports, summary = self.judge(*lines, code=BAD_INPUT)
        self.assertEqual([r["class"] for r in reports],
                         ["right", "unreadable"] * len(bad) + ["right"])
        numbers = list(range(1, 2 * len(bad) + 1)) + [2 * len(bad) + 2]  # a blank line
        self.assertEqual([r["line"] for r in reports], numbers)
        for report in reports:
            if report["class"] == "unreadable":
                self.assertTrue(report["problem"] and report["remedy"], report)
        self.assertEqual((summary["right"], summary["unreadable"]), (len(bad) + 1, len(bad)))
        _, text, _ = stickslip("crosscheck", self.path("claims.jsonl"))
        self.assertIn("force_vectors", text)  # the remedy
        self.assertEqual(len(text.splitlines()), len(bad) + 1)

    def test_preloads_along_irrational_normals(self):
        # Jaws along a diagonal press with 1 each: across it they hold 2, the length of a root of 2 times (1, -1).
        jaws = {"format": "stickslip-grasp/1", "name": "jaws", "wrench": [0, 0, 0], "defaults": {"friction": 1}, "contacts": [
            {"position": [-1, -1], "normal": [1, 1]}, {"position": [1, 1], "normal": [-1, -1]}]}
        half = 0.5 ** 0.5
        solution = {"twist": [0, 0, 0], "force_vectors": [[half - 0.5, half + 0.5], [-half - 0.5, 0.5 - half]]}
        lines = [claim([1, -1, 0], 1, "stable", grasp=jaws, **solution), claim(["1.41", "-1.41", 0], 1, "stable", grasp=jaws),
                 claim(["1.42", "-1.42", 0], 1, "stable", grasp=jaws), claim([1, -1, 0], 1, "stable", grasp=jaws, forces=[[1, 0], [1, 0]])]
        (near, right, wrong, magnitudes), _ = self.judge(*lines, code=WRONG)
        self.assertEqual([near["class"], right["class"], wrong["class"]], ["right", "right", "wrong"])
        self.assertFalse(near["inaccurate"])
        low, high = map(Fraction, wrong["distance"]["along_load"])
        self.assertLess((1 - high) * Fraction("1.42"), half * 2)
        self.assertGreater((1 - low) * Fraction("1.42"), half * 2)
        self.assertLess(high - low, Fraction(1, 1000))
        self.assertIn("force_vectors", magnitudes["remedy"])

    def test_exact_values(self):
        reports, _ = self.judge(RIGHT, OFF, TIE, WRONG_STABLE, WRONG_UNSTABLE, code=WRONG)
        right, off, tie, wrong, other = reports
        none = {"value": "0", "contact": None}
        self.assertEqual(right["residuals"], {"force": ["0", "0"], "torque": "0", "cone": none,
                                              "normal_law": none, "dissipation": none})
        self.assertEqual(right["nearby"]["force_distance"], "0")
        self.assertEqual(right["claimed_slip"], "+0-")
        # The tangent of contact 2 is (0, -1): a quarter too little of it, at arm 1.
        self.assertEqual((off["class"], off["inaccurate"]), ("right", True))
        self.assertEqual(off["residuals"]["force"], ["0", "1/4"])
        self.assertEqual(off["residuals"]["torque"], "1/4")
        self.assertEqual(off["residuals"]["dissipation"], {"value": "1/4", "contact": 2})
        self.assertEqual(tie["distance"]["smallest"], "1/1000000000001")
        self.assertEqual(wrong["distance"]["along_load"], "1/11")
        self.assertEqual((other["claimed"], other["verdict"]), ("unstable", "stable"))

    def test_irrational_residual_is_enclosed(self):
        line = {"grasp": DIAGONAL, "claim": {"verdict": "stable", "force_vectors": [[0, 0]],
                                             "twist": ["-1/2", "-1/2", 0]}}
        (report,), _ = self.judge(line)
        low, high = (float(x) for x in report["residuals"]["normal_law"]["value"])
        self.assertTrue(low <= 0.5 ** 0.5 <= high and high - low < 1e-15)
        self.assertTrue(report["inaccurate"])

    def test_both_forms_agree(self):
        lines = (RIGHT, OFF, "nonsense", TIE, WRONG_STABLE, WRONG_UNSTABLE)
        reports, summary = self.judge(*lines, code=WRONG)
        code, text, err = stickslip("crosscheck", self.path("claims.jsonl"))
        self.assertEqual((code, err), (WRONG, ""))
        shown = {int(n): word for n, word in re.findall(r"^line (\d+): (\w+)", text, re.M)}
        self.assertEqual(shown, {r["line"]: r["class"] for r in reports
                                 if r["class"] != "right" or r["inaccurate"]})
        last = text.splitlines()[-1]
        for word in ("right", "tie", "wrong", "undecided", "unreadable"):
            self.assertEqual(int(re.search(rf"(\d+) {word}", last).group(1)), summary[word])
        self.assertEqual(int(last.split()[0]), summary["claims"])
        self.assertEqual(summary["claims"], len(lines))
        # Same input, same bytes; and from standard input, where files are relative to here.
        self.assertEqual(stickslip("crosscheck", self.path("claims.jsonl"))[1], text)

    def test_standard_input(self):
        line = dict(WRONG_UNSTABLE)
        code, out, _ = stickslip("crosscheck", "-", "--json", stdin=json.dumps(line))
        self.assertEqual(code, WRONG)
        self.assertEqual(json.loads(out.splitlines()[0])["class"], "wrong")

    def test_distances_of_all(self):
        (plain,), _ = self.judge(claim([0, "1/2", 0], 1, "stable"))
        self.assertIsNone(plain["distance"])
        (all_,), _ = self.judge(claim([0, "1/2", 0], 1, "stable"), options=("--distances",))
        self.assertEqual(all_["distance"]["along_load"], "1")

    def test_saved_files_are_accepted(self):
        bilateral = {"grasp": FIG1, "claim": {"verdict": "unstable"},
                     "options": {"preload": 1, "normal_law": "bilateral",
                                 "wrench": [0, "1/2", 0]}}
        folder = self.path("saved")
        reports, _ = self.judge(RIGHT, TIE, "nonsense", WRONG_STABLE, WRONG_UNSTABLE, bilateral,
                                options=("--save", folder), code=WRONG)
        saved = {r["line"]: r["saved"] for r in reports if "saved" in r}
        self.assertEqual(set(saved), {r["line"] for r in reports
                                      if r["class"] in ("tie", "wrong")})
        self.assertEqual(set(saved), {2, 4, 5, 6})
        self.assertEqual(sorted(os.listdir(folder)),
                         sorted(os.path.basename(f) for fs in saved.values() for f in fs))
        verdicts = {r["line"]: r["verdict"] for r in reports if "verdict" in r}
        for number, (grasp, certificate) in saved.items():
            law = ("--normal-law", "bilateral") if number == 6 else ()
            code, out, err = run(CHECK, grasp, certificate, *law)
            self.assertEqual(code, DONE, out + err)
            self.assertEqual(re.search(r"^verdict +(\w+)", out, re.M).group(1), verdicts[number])

    def test_saved_whole_or_not_at_all(self):
        # The grasp, which is written last, is longer than a file may be.
        grasp = {**FIG1, "name": "n" * 20000}
        claims = self.claims(claim([0, "1.000000000001", 0], 1, "stable", grasp=grasp))
        program = [STICKSLIP, "crosscheck", claims, "--save", self.path("saved")]
        self.assertEqual(subprocess.run(program, capture_output=True, check=False).returncode, DONE)
        sizes = {name: os.path.getsize(os.path.join(self.path("saved"), name))
                 for name in os.listdir(self.path("saved"))}
        self.assertGreater(sizes["line-1.grasp.json"], 10000)
        self.assertLess(sizes["line-1.certificate.json"], 10000)
        shutil.rmtree(self.path("saved"))

        def limit_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))
        result = subprocess.run(program, capture_output=True, text=True, check=False,
                                restore_signals=False, preexec_fn=limit_files)
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("line-1.grasp.json", result.stderr)
        self.assertEqual(os.listdir(self.path("saved")), [])

    def test_residuals_are_relative_to_the_forces(self):
        """The same claim in other units, with doubles' rounding: always right and accurate."""
        for force in ("1", "1e9", "1e-9"):
            for length in ("1", "1e6", "1e-6"):
                f, l = Fraction(force), Fraction(length)
                contacts = [{"position": [str(l * x) for x in c["position"]], "normal": c["normal"],
                             "stiffness": str(f / l)} for c in FIG1["contacts"]]
                for off, inaccurate in (("1e-7", False), ("1e-5", True)):
                    forces = [[1, -0.5], [0, 0], [1, 0.5 + float(off)]]
                    line = {"grasp": {**FIG1, "contacts": contacts},
                            "options": {"wrench": [0, str(f), 0], "preload": str(f)},
                            "claim": {"verdict": "stable", "twist": [0, str(l), 0],
                                      "forces": [[str(f * Fraction(x)) for x in p] for p in forces]}}
                    (report,), _ = self.judge(line)
                    self.assertEqual((report["class"], report["inaccurate"]), ("right", inaccurate),
                                     (force, length, off))
                    scale = {name: Fraction(x) for name, x in report["residual_scale"].items()}
                    self.assertEqual(scale, {"force": f, "length": l, "motion": l})

    def test_right_claims_take_a_line_at_most(self):
        code, text, _ = stickslip("crosscheck", self.claims(RIGHT, OFF))
        self.assertEqual(code, DONE)
        self.assertEqual(text.splitlines(), [
            'line 2: right: claimed stable, exactly stable ("Fig. 1"), but its solution misses: '
            "balance force (0, 1/4), torque 1/4; dissipation 1/4 at contact 2; an exact "
            "equilibrium of its kind is within 1/4 in the forces and 1 in the twist",
            "2 claims: 2 right (1 of them with an inaccurate solution), 0 tie, 0 wrong, "
            "0 undecided, 0 unreadable"])

    def test_help_teaches(self):
        code, out, _ = stickslip("crosscheck", "--help")
        self.assertEqual(code, DONE)
        for word in ("--tie", "--save", "force", "force_vectors", "In space", "Exit codes"):
            self.assertIn(word, out)


# Two fingers that press with 4 and hold a weight of 4; four hold torques as well.
PINCH = {"format": "stickslip-grasp/2", "name": "pinch", "defaults": {"friction": "1/2", "preload": 4},
         "contacts": [{"position": [-2, 0, 0], "normal": [1, 0, 0]},
                      {"position": [2, 0, 0], "normal": [-1, 0, 0]}], "wrench": [0] * 6}
BOOK = {**PINCH, "name": "book", "contacts": [{"position": [x, y, 0], "normal": [-x // 2, 0, 0]}
                                              for x in (-2, 2) for y in (-3, 3)]}


def weighed(grasp, weight, verdict, **solution):
    return {"grasp": grasp, "options": {"wrench": [0, 0, f"-{weight}", 0, 0, 0]},
            "claim": {"verdict": verdict, **solution}}


HELD = weighed(PINCH, 3, "stable", twist=[0] * 6, force_vectors=[[4, 0, 1.5], [-4, 0, 1.5]])
SPACE_OFF = weighed(PINCH, 3, "stable", twist=[0] * 6, force_vectors=[[4, 0, 1.5], [-4, 1, 1.75]])
SPACE_TIE = weighed(PINCH, "4.000000000001", "stable")
SPACE_WRONG = weighed(BOOK, 9, "stable", twist=[0, 0, -1, 0, 0, 0], force_vectors=[[4, 0, "9/4"], [4, 0, "9/4"],
                                                                                [-4, 0, "9/4"], [-4, 0, "9/4"]])
SPACE_WRONG_UNSTABLE = weighed(BOOK, 7, "unstable")


class InSpace(Claims):
    """Claims about grasps in space, among others."""

    def test_exit_codes(self):
        for lines, code in (((HELD, SPACE_TIE, SPACE_OFF, RIGHT), DONE), ((SPACE_WRONG,), WRONG),
                            ((HELD, "nonsense"), BAD_INPUT)):
            self.judge(*lines, code=code)
        self.judge(weighed(BOOK, 9, "stable"), options=("--node-limit", 1), code=UNDECIDED)

    def test_exact_values(self):
        reports, summary = self.judge(HELD, RIGHT, SPACE_OFF, SPACE_TIE, TIE, SPACE_WRONG, SPACE_WRONG_UNSTABLE,
                                      code=WRONG)
        held, plane, off, tie, _, wrong, other = reports
        self.assertEqual([r["class"] for r in reports],
                         ["right", "right", "right", "tie", "tie", "wrong", "wrong"])
        self.assertEqual((summary["right"], summary["inaccurate"], summary["tie"], summary["wrong"]), (3, 1, 2, 2))
        self.assertEqual((held["engine"], plane["engine"]), ("space", "branch-and-bound"))
        none = {"value": "0", "contact": None}
        self.assertEqual(held["residuals"], {"force": ["0"] * 3, "torque": ["0"] * 3, "cone": none,
                                             "normal_law": none, "dissipation": none})
        self.assertEqual((held["nearby"]["from"], held["nearby"]["force_distance"]), ("claim", "0"))
        self.assertEqual((held["claimed_slip"], wrong["claimed_slip"]), ("00", "++++"))
        # (0, 1, 1/4) too much at (2, 0, 0); its friction is (1, 7/4), of 2.
        self.assertTrue(off["inaccurate"])
        self.assertEqual(off["residuals"]["force"], ["0", "1", "1/4"])
        self.assertEqual(off["residuals"]["torque"], ["0", "-1/2", "2"])
        low, high = (Fraction(x) for x in off["residuals"]["cone"]["value"])
        self.assertLess((low + 2) ** 2, Fraction(65, 16))  # 1 + 49/16
        self.assertGreater((high + 2) ** 2, Fraction(65, 16))
        self.assertLess(high - low, Fraction(1, 10**15))
        self.assertEqual(off["residuals"]["cone"]["contact"], 1)
        self.assertEqual(tie["distance"]["all_at_once"], ["0", "1/1000000000"])
        # Four fingers hold 8: of 9 a ninth is too much, and 7 may grow by a seventh.
        for report, exact in ((wrong, Fraction(1, 9)), (other, Fraction(1, 7))):
            low, high = (Fraction(x) for x in report["distance"]["along_load"])
            self.assertTrue(low <= exact <= high < low + Fraction(1, 500), report)
            self.assertEqual(report["distance"]["all_at_once"], ["1/1000000000", None])
            self.assertEqual(Fraction(report["distance"]["smallest"][0]), Fraction(1, 10**9))
        # Each bears 9/4 of at most 2.
        self.assertEqual(wrong["residuals"]["cone"], {"value": "1/4", "contact": 0})

    def test_both_forms_agree(self):
        lines = (HELD, RIGHT, SPACE_OFF, "nonsense", SPACE_TIE, SPACE_WRONG, SPACE_WRONG_UNSTABLE, WRONG_STABLE)
        reports, _ = self.judge(*lines, code=WRONG)
        code, text, err = stickslip("crosscheck", self.path("claims.jsonl"))
        self.assertEqual((code, err), (WRONG, ""))
        shown = {int(n): word for n, word in re.findall(r"^line (\d+): (\w+)", text, re.M)}
        self.assertEqual(shown, {r["line"]: r["class"] for r in reports
                                 if r["class"] != "right" or r["inaccurate"]})
        self.assertIn("misses: balance force (0, 1, 1/4), torque (0, -1/2, 2); cone ~0.0155644 at contact 1", text)
        self.assertIn("  A load within 1e-9 of its size has another verdict.\n", text)
        self.assertIn("  All loads within 1e-9 of its size have this verdict.\n", text)
        self.assertRegex(text, "  The verdict changes when the load changes by ~0.110[0-9]* to ~0.11[0-9]* of itself.\n")
        self.assertIn("  The claimed twist slips ++++.\n", text)
        self.assertEqual(stickslip("crosscheck", self.path("claims.jsonl"))[1], text)
        _, exact, _ = stickslip("crosscheck", self.path("claims.jsonl"), "--exact")
        self.assertRegex(exact, r"cone 0\.01556443707463[0-9]*\.\.0\.01556443707463[0-9]* at contact 1")
        self.assertIn("a..b encloses an irrational number.", exact)

    def test_bad_lines_between_good_ones(self):
        uncertain = {**PINCH, "contacts": [{**PINCH["contacts"][0], "friction": {"min": "0.4", "max": "0.5"}},
                                           PINCH["contacts"][1]]}
        for line, place, words in (
                (weighed(PINCH, 3, "stable", forces=[[4, 1.5], [4, 1.5]]), "claim.forces", "force_vectors"),
                (weighed(PINCH, 3, "stable", force_vectors=[[4, 0], [4, 0]]), "claim.force_vectors[0]", "three"),
                (weighed(PINCH, 3, "stable", force_vectors=[[4, 0, 0]]), "claim.force_vectors", "2 contacts"),
                (weighed(PINCH, 3, "stable", twist=[0, 0, 0]), "claim.twist", "six"),
                (claim([0, 1, 0], 1, "stable", twist=[0] * 6), "claim.twist", "three"),
                (claim([0, 1, 0], 1, "stable", force_vectors=[[0, 0, 0]] * 3), "claim.force_vectors[0]", "two"),
                (claim([0, 1, 0], 1, "stable", grasp=PINCH), "options.wrench", "six"),
                (weighed("fig1.json", 1, "stable"), "options.wrench", "three"),
                (weighed(uncertain, 3, "stable"), "grasp.contacts[0].friction", "stickslip decide, radius and batch")):
            reports, _ = self.judge(HELD, line, RIGHT, code=BAD_INPUT)
            self.assertEqual([r["class"] for r in reports], ["right", "unreadable", "right"], line)
            self.assertEqual(reports[1]["place"], place, line)
            self.assertIn(words, reports[1]["problem"] + reports[1]["remedy"], line)

    def test_saved_files_are_accepted(self):
        bilateral = {"grasp": BOOK, "claim": {"verdict": "unstable"},
                     "options": {"wrench": [0, 0, -7, 0, 0, 0], "normal_law": "bilateral"}}
        lines = {2: ("stable", SPACE_TIE), 3: ("stable", SPACE_WRONG), 4: ("unstable", SPACE_WRONG_UNSTABLE),
                 6: ("unstable", bilateral)}
        reports, _ = self.judge(HELD, SPACE_TIE, SPACE_WRONG, SPACE_WRONG_UNSTABLE, "nonsense", bilateral,
                                options=("--save", self.path("saved")), code=WRONG)
        saved = {r["line"]: r["saved"] for r in reports if "saved" in r}
        self.assertEqual(set(saved), set(lines))
        for number, (grasp, certificate) in saved.items():
            law = ("--normal-law", "bilateral") if number == 6 else ()
            for checker in checkers(certificate):
                code, out, err = run(*checker, grasp, certificate, *law)
                self.assertEqual(code, DONE, out + err)
                self.assertNotEqual(re.search(r"^verdict +(\w+)", out, re.M).group(1), lines[number][0])
