# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs themselves: options, output, exit codes, files; and all three on one question.

The programs are named by the environment variables STICKSLIP, STICKSLIP_CHECK and Z3.
"""

import json
import os
import re
import shlex
import stat
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
CORPUS = os.path.join(HERE, "..", "..", "corpus", "grasps")
FIG1 = os.path.join(CORPUS, "good", "fig1.json")  # P = 1, wrench (0, -11/10, 0): stable
FIG4 = os.path.join(CORPUS, "good", "fig4.json")
STICKSLIP = os.environ.get("STICKSLIP", "stickslip")
CHECK = os.environ.get("STICKSLIP_CHECK", "stickslip-check")
CHECK_PY = os.path.join(HERE, "..", "..", "..", "certificate", "python", "check.py")
PROVED = os.environ.get("STICKSLIP_PROVED")
SANITIZED = os.environ.get("STICKSLIP_SANITIZED") == "yes"  # then programs take twenty times as long, and some tests ask less
UP = ("--wrench", "0,11/10,0")  # unstable

sys.path.append(os.path.join(HERE, "..", "..", "support"))
import batch  # noqa: E402
import check  # noqa: E402
from in_process import in_process  # noqa: E402

DONE, BAD_INPUT, UNDECIDED, STABLE, UNSTABLE = 0, 2, 3, 10, 20


def run(*words, stdin=None):
    """Exit code, standard output, standard error."""
    words = [str(word) for word in words]
    if words[:3] == [sys.executable, "-B", CHECK_PY]:
        return in_process(words[3:])  # tests/certificate/python starts it as a program
    result = subprocess.run(words, input=stdin, capture_output=True,
                            text=True, check=False, timeout=300)
    return result.returncode, result.stdout, result.stderr


def stickslip(*words, stdin=None):
    return run(STICKSLIP, *words, stdin=stdin)


def checkers(proof):
    """The programs that have to judge a certificate."""
    return [[CHECK], [sys.executable, "-B", CHECK_PY], *([[PROVED]] if PROVED else [])]


def quick_checker(_):
    """Of a proof whose numbers have all digits of doubles: the others take ten times as long, or a hundred times."""
    return [[CHECK]]


def report_of(checker, file, proof, words):
    """What a checker says of a certificate, and the text that check.py prints of it. None is started for one question alone:
    that their command lines say the same is for tests/rules."""
    if checker[0] == sys.executable:
        if hasattr(sys, "set_int_max_str_digits"):  # as check.main does
            sys.set_int_max_str_digits(0)
        return check.answer(check.parse_arguments([str(file), str(proof), *map(str, words)]))[:2]
    contents = []
    for path in (file, proof):
        with open(path, "rb") as stream:
            contents.append(stream.read())
    return batch.in_batch(checker, batch.question_of(*contents, words)), ""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Case(unittest.TestCase):
    judges = staticmethod(checkers)  # of proofs

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return self.path(name)

    def json(self, *words, stdin=None, code=DONE):
        found, out, err = stickslip(*words, "--json", stdin=stdin)
        self.assertEqual((found, err), (code, ""))
        return json.loads(out)

    def fails(self, *words, naming=(), stdin=None):
        code, out, err = stickslip(*words, stdin=stdin)
        self.assertEqual((code, out), (BAD_INPUT, ""), err)
        for part in naming:
            self.assertIn(part, err)
        return err

    def accepted(self, file, proof, *words, verdict=""):
        """By all that have to judge it, which say the same. `verdict` is what check.py prints."""
        reports = []
        for checker in self.judges(proof):
            report, text = report_of(checker, file, proof, words)
            self.assertEqual(report["result"], "accepted", (checker, report))
            if text:
                self.assertRegex(text, rf"\n(verdict +)?{verdict}")
            reports.append(report)
        self.assertEqual(reports, reports[:1] * len(reports))
        return reports[0]


class Decide(Case):
    def test_stable_in_json(self):
        answer = self.json("decide", FIG1)
        self.assertEqual([answer[key] for key in ("verdict", "engine", "normal_law", "wrench")],
                         ["stable", "branch-and-bound", "unilateral", ["0", "-11/10", "0"]])
        self.assertEqual(len(answer["twist"]), 3)
        self.assertEqual(len(answer["contacts"]), 3)
        total = [Fraction(w) for w in answer["wrench"]]
        for contact, position in zip(answer["contacts"], ([-1, 0], [0, -1], [1, 0])):
            self.assertEqual(set(contact), {"normal", "tangential", "force", "slip", "closed"})
            self.assertIn(contact["slip"], ("+", "0", "-"))
            self.assertIs(contact["closed"], True)
            normal, tangential = Fraction(contact["normal"]), Fraction(contact["tangential"])
            self.assertLessEqual(abs(tangential), normal / 2)
            x, y = map(Fraction, contact["force"])
            for j, part in enumerate((x, y, position[0] * y - position[1] * x)):
                total[j] += part
        self.assertEqual(total, [0, 0, 0])
        self.assertTrue(all(type(value) is int for value in answer["stats"].values()))

    def test_unstable_in_json(self):
        for engine in ("states", "branch-and-bound", "auto", "cone"):  # the last is a name of old
            answer = self.json("decide", FIG1, *UP, "--engine", engine)
            self.assertEqual(answer["verdict"], "unstable")
            self.assertEqual(answer["engine"], "states" if engine == "states" else "branch-and-bound")
            self.assertGreaterEqual(answer["refutation"]["leaves"], 1)
            self.assertNotIn("twist", answer)

    def test_irrational_magnitudes_are_enclosed(self):
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [-1, -1, 0],
            "contacts": [{"position": [0, 0], "normal": [1, 1], "friction": 0}]})
        normal = self.json("decide", grasp)["contacts"][0]["normal"]
        low, high = map(Fraction, normal)
        self.assertLess(low * low, 2)
        self.assertGreater(high * high, 2)
        self.assertLess(high - low, Fraction(1, 10**15))
        self.assertIn("~1.41421           0  (1, 1)", stickslip("decide", grasp)[1])
        whole = stickslip("decide", grasp, "--exact")[1]
        self.assertRegex(whole, r"1\.414213562373095\d*\.\.1\.414213562373095\d* +0  \(1, 1\)")
        self.assertIn("a..b encloses an irrational number.", whole)

    def test_long_rationals_are_rounded_in_text_and_whole_if_asked_for(self):
        primes = [101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151, 157]
        contacts = [{"position": [x, f"1/{p}"], "normal": [-x, f"1/{p + 1}"], "friction": "1/2"}
                    for p in primes for x in (-1, 1)]
        grasp = self.write("g.json", {"format": "stickslip-grasp/1", "contacts": contacts,
                                      "wrench": ["1/7", "-1/11", "1/13"]})
        text = stickslip("decide", grasp, "--no-warnings")[1]
        self.assertLess(max(map(len, text.splitlines())), 100)
        self.assertIn("~ marks what is rounded", text)
        answer = self.json("decide", grasp)
        self.assertGreater(len(answer["twist"][0]), 60)
        whole = stickslip("decide", grasp, "--exact")[1]
        self.assertIn("  motion d  (" + ", ".join(answer["twist"]) + ")", whole)
        self.assertNotIn("~", whole)
        shown = re.search(r"motion d  \((.*)\)", text)[1].split(", ")
        for number, exact in zip(shown, answer["twist"]):
            self.assertRegex(number, r"^~-?[0-9.]{1,9}(e-?[0-9]+)?$")
            self.assertAlmostEqual(float(number[1:]) / float(Fraction(exact)), 1, delta=1e-5)
        self.assertNotIn("~", stickslip("decide", FIG1)[1])

    def test_virtual_twist_is_scaled(self):
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0.1, 1.0000001, 0.003],
            "defaults": {"friction": 0.1234567}, "contacts": [
                {"position": [0.0301234567, 0.0112345678], "normal": [0.8944271909, 0.4472135955]},
                {"position": [-0.0301234567, 0.0112345678], "normal": [-0.707106781, 0.70710678]}]})
        code, text, _ = stickslip("decide", grasp)
        self.assertEqual((code, text.split("\n")[0]), (DONE, "unstable"))
        twist = re.search(r"twist \((.*?)\)", text)[1].split(", ")
        entries = [Fraction(entry.strip("~")) for entry in twist]
        largest = max(map(abs, entries))
        self.assertTrue(largest == 1 or (largest < 100 and "~" not in "".join(twist)), twist)
        whole = re.search(r"twist \((.*?)\)", stickslip("decide", grasp, "--exact")[1])[1]
        exact = [Fraction(entry) for entry in whole.split(", ")]
        for entry, integer in zip(entries, exact):
            self.assertEqual(integer.denominator, 1)
            self.assertAlmostEqual(float(entry / largest), float(integer / max(map(abs, exact))),
                                   delta=2e-6)

    def test_text_says_what_the_json_says(self):
        for options, word in (((), "stable"), (UP, "unstable")):
            code, out, err = stickslip("decide", FIG1, *options)
            self.assertEqual((code, err), (DONE, ""))
            self.assertEqual(out.split("\n")[0], f"fig1: {word}")

    def test_exit_codes(self):
        self.assertEqual(stickslip("decide", FIG1, "--exit-code")[0], STABLE)
        self.assertEqual(stickslip("decide", FIG1, *UP, "--exit-code")[0], UNSTABLE)
        self.assertEqual(stickslip("decide", FIG1, *UP)[0], DONE)

    def test_undecided(self):
        certificate = self.path("c.json")
        words = ("decide", FIG1, "--wrench", "0,11/10,0", "--engine", "branch-and-bound", "--node-limit", "1",
                 "--certificate", certificate)
        code, out, err = stickslip(*words, "--json")
        answer = json.loads(out)
        self.assertEqual((code, answer["verdict"]), (UNDECIDED, "undecided"))
        self.assertIn("1 node", answer["limit"])
        self.assertIn("--certificate: nothing is written", err)
        self.assertEqual(stickslip(*words, "--exit-code")[0], UNDECIDED)
        self.assertEqual(os.listdir(self.folder), [])  # it proves nothing

    def test_words_that_do_not_fit(self):
        for words, naming in (
                (("decide", FIG1, "other.json"), ['"other.json" is more than stickslip decide takes']),
                (("decide",), ["GRASP is missing", "stickslip decide --help"]),
                (("preload", FIG1, "--hold", "--budget", "3"), ["--hold and --budget do not go together"]),
                (("plot", "grasp"), ["GRASP is missing", "stickslip plot grasp --help"]),
                (("decide", FIG1, "--node-limit"), ["--node-limit", "stickslip decide --help"]),
                (("decide", FIG1, "--wrench", "0 1 0"), ["separate numbers by commas", "0,1,-3/5"]),
                (("decide", FIG1, "--wrench", "0,x,0"), ['"x" is not a number', "write it as 2"])):
            error = self.fails(*words, naming=naming)
            self.assertNotIn("separate" if "x" in words[-1] else "excludes", error)
            self.assertNotIn("not expected", error)

    def test_warnings(self):
        supports = [{"position": [x, 0], "normal": [0, 1], "friction": 1 - abs(x)}
                    for x in (-1, 0, 1)]
        plank = {"format": "stickslip-grasp/1", "contacts": supports,
                 "wrench": [10, -30, 0]}
        file = self.write("plank.json", plank)
        warnings = self.json("decide", file)["warnings"]
        self.assertEqual([warning["trap"] for warning in warnings],
                         ["large-motion", "assumed-stiffness"])
        lines = [f"Warning: {warning['text']}." for warning in warnings]
        out = stickslip("decide", file)[1]
        self.assertEqual(out.split("\n")[-3:], [*lines, ""])
        self.assertEqual(stickslip("decide", file, "--no-warnings")[1],
                         out.replace("\n".join([*lines, ""]), ""))
        self.assertNotIn("warnings", self.json("decide", file, "--no-warnings"))
        plank["defaults"] = {"stiffness": 1}
        self.assertEqual([warning["trap"] for warning in
                          self.json("decide", self.write("plank.json", plank))["warnings"]],
                         ["large-motion"])
        self.assertEqual(self.json("decide", FIG1)["warnings"], [])
        self.assertNotIn("Warning", stickslip("decide", FIG1)[1])
        self.assertIn("docs/model.md", stickslip("decide", "--help")[1])

    def test_negative_wrench_needs_no_equals_sign(self):
        self.assertEqual(self.json("decide", FIG1, "--wrench", "-1,0,0"),
                         self.json("decide", FIG1, "--wrench=-1,0,0"))
        self.assertEqual(self.json("decide", FIG1, "--wrench", "-1,0,0")["wrench"],
                         ["-1", "0", "0"])

    def test_standard_input(self):
        self.assertEqual(self.json("decide", "-", stdin=read(FIG1)), self.json("decide", FIG1))
        err = self.fails("decide", "-", stdin="{", naming=["<stdin>"])
        self.assertNotIn(FIG1, err)

    def test_same_question_same_bytes(self):
        for engine in ("states", "branch-and-bound"):
            outputs = set()
            for name in ("a", "b"):
                code, out, _ = stickslip("decide", FIG4, "--wrench", "0,21/10,0", "--json", "--engine",
                                         engine, "--certificate", self.path(name))
                self.assertEqual(code, DONE)
                outputs.add((out, read(self.path(name))))
            self.assertEqual(len(outputs), 1)


class Certificates(Case):
    """decide --certificate, then both checkers."""

    def asked(self, grasp, *options, verdict):
        for engine in ("states", "branch-and-bound"):
            proof = self.path(engine)
            answer = self.json("decide", grasp, *options, "--engine", engine, "--certificate", proof)
            self.assertEqual(answer["verdict"], verdict)
            for checker in checkers(proof):
                code, out, err = run(*checker, grasp, proof, *options, "--json")
                self.assertEqual((code, err), (0, ""), out)
                report = json.loads(out)
                self.assertEqual((report["result"], report["verdict"]), ("accepted", verdict))
        return proof

    def checked(self, code, *words):
        for checker in checkers(words[1]):
            found, out, err = run(*checker, *words)
            self.assertEqual(found, code, (checker, out, err))
            self.assertEqual(err == "", code != BAD_INPUT)

    def test_round_trips(self):
        self.asked(FIG1, verdict="stable")
        self.asked(FIG1, *UP, verdict="unstable")
        self.asked(FIG1, "--preload", "0", "--wrench", "0,1,0", verdict="unstable")
        self.asked(FIG1, "--preload", "2", "--wrench", "0,2,0", verdict="stable")
        self.asked(FIG4, "--wrench", "0,0,3", "--preload", "0", verdict="stable")
        self.asked(FIG4, "--wrench", "0,0,3", "--preload", "0", "--normal-law", "bilateral",
                   verdict="unstable")

    def test_written_whole_or_not_at_all(self):
        missing = self.path("no/such/folder.json")
        self.fails("decide", FIG1, "--certificate", missing, naming=[missing])
        self.fails("decide", FIG1, "--certificate", self.folder, naming=[self.folder])
        proof = self.write("proof.json", "the old one\n")
        self.fails("decide", self.path("no_grasp.json"), "--certificate", proof)
        self.assertEqual(read(proof), "the old one\n")
        os.chmod(proof, 0o640)
        self.json("decide", FIG1, "--certificate", proof)
        self.assertIn("stickslip-certificate/2", read(proof))
        self.assertEqual(os.listdir(self.folder), ["proof.json"])  # nothing temporary

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_folder_that_must_not_be_written(self):
        os.chmod(self.folder, stat.S_IRUSR | stat.S_IXUSR)
        self.addCleanup(os.chmod, self.folder, stat.S_IRWXU)
        self.fails("decide", FIG1, "--certificate", self.path("c.json"), naming=["c.json"])
        self.assertEqual(os.listdir(self.folder), [])


class States(Case):
    COUNTS = {"contacts": 4, "circles": 2, "rank": 2, "vertices": 2, "edges": 4, "faces": 4,
              "cells": 10, "distinct_states": 9}

    def test_counts(self):
        for options in ((), ("--engine", "cgal")):
            answer = self.json("states", FIG4, *options)
            engine = answer.pop("engine")
            self.assertIn(engine, options[1:] or (engine,))
            self.assertEqual({key: answer[key] for key in self.COUNTS}, self.COUNTS)

    def test_list_is_sorted_and_complete(self):
        states = self.json("states", FIG4, "--list")["states"]
        self.assertEqual(len(states), self.COUNTS["distinct_states"])
        self.assertEqual(states, sorted(set(states)))
        self.assertIn("0000", states)
        code, out, _ = stickslip("states", FIG4, "--list")
        self.assertEqual(code, DONE)
        for state in states:
            self.assertIn(state, out.split("\n"))

    def test_no_contact(self):
        grasp = os.path.join(CORPUS, "good", "no_contact.json")
        self.assertEqual(self.json("states", grasp, "--list")["distinct_states"], 1)


class Margin(Case):
    def resisted(self, grasp, direction, *words):
        return self.json("margin", grasp, "--direction", direction, *words)["resisted"]

    def test_base_wrench_is_zero_unless_given(self):
        self.assertEqual(self.resisted(FIG1, "0,1,0", "--preload", 1, "--wrench", "0,1/2,0"),
                         [["0", "1/2"]])
        answer = self.json("margin", FIG1, "--preload", 1, "--direction", "0,2,0")
        self.assertEqual(answer["wrench"], ["0", "0", "0"])  # the file's is not
        self.assertEqual(answer["resisted"], [["0", "1/2"]])
        self.assertIs(answer["unbounded"], False)

    def test_nothing_is_resisted(self):
        grasp = self.write("none.json", {"format": "stickslip-grasp/1", "contacts": [],
                                         "wrench": [0, 0, 0]})
        self.assertEqual(self.resisted(grasp, "1,0,0", "--wrench", "0,1,0"), [])
        self.assertEqual(self.resisted(grasp, "1,0,0", "--wrench=-3,0,0"), [["3", "3"]])
        self.assertIn("No l is resisted", stickslip("margin", grasp, "--direction", "1,0,0",
                                                    "--wrench", "0,1,0")[1])

    def test_text_says_what_the_json_says(self):
        out = stickslip("margin", FIG1, "--direction", "0,1,0", "--preload", 1)[1]
        self.assertIn("l in [0, 1]", out)
        self.assertIn("[0, oo)", stickslip("margin", FIG1, "--direction", "0,-1,0")[1])

    def test_errors(self):
        self.fails("margin", FIG1, naming=["--direction", "--preload-direction"])
        self.fails("margin", FIG1, "--direction", "0,0,0", naming=["--direction", "is 0"])
        self.fails("margin", FIG1, "--direction", "0,1", naming=["--direction", "2 numbers"])
        preloads = "--preload-direction"
        for words, problem in (
                (("1,1",), "2 numbers for 3 contacts"), (("1,1,-1",), "contact 2 is -1"),
                (("0,0,0",), "all of its numbers are 0"), (("1,x,1",), "x"), (("Scale",), "Scale"),
                (("scale", "--preload", 0), "no preload to scale")):
            self.fails("margin", FIG1, preloads, *words, naming=[preloads, problem])
        # Of irrational length, and preloaded only as the preloads grow: its ends are not exact.
        grasp = self.write("diagonal.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": 1},
            "contacts": [{"position": [0, 0], "normal": [1, 0]},
                         {"position": [0, 0], "normal": [-1, 1]}]})
        self.fails("margin", grasp, "--class", "--direction", "0,1,0", "--preload", 1, naming=[grasp, "contacts[1].normal", "snap"])
        self.fails("margin", grasp, "--class", "--direction", "0,1,0", "--max-motion", "1,1", naming=["max_motion", "none"])
        self.assertNotIn("refuted", self.json("margin", grasp, preloads, "1,0"))
        self.assertEqual(self.json("margin", grasp, preloads, "1,0")["resisted"], [["0", None]])
        self.assertIn("refuted", self.json("margin", grasp, preloads, "0,1"))

    def test_undecided(self):
        code, out, err = stickslip("margin", FIG1, "--direction", "0,1,0", "--node-limit", 1)
        self.assertEqual((code, out), (UNDECIDED, ""))
        self.assertEqual(err, "stickslip: the margin is not known: the search reached the limit of 1 nodes; "
                              "a higher node limit may decide it\n")

    def test_a_limit_is_that_of_all_searches(self):
        for limit in range(2, 7):
            err = stickslip("margin", FIG1, "--preload", "1", "--direction", "0,1,0", "--node-limit", limit)[2]
            self.assertIn(f"the limit of {limit} nodes;", err)

    def test_preloads(self):
        def margin(*words):
            return self.json("margin", FIG1, "--wrench", "0,1,0", *words)

        scale = margin("--preload", 2, "--preload-direction", "scale")
        self.assertEqual((scale["resisted"], scale["least"]), ([["1/2", None]], "1/2"))
        self.assertEqual(scale["preload_direction"], "scale")
        self.assertNotIn("direction", scale)
        sides = margin("--preload", 0, "--preload-direction", "1,0,1")
        self.assertEqual((sides["resisted"], sides["preload_direction"]),
                         ([["1", None]], ["1", "0", "1"]))
        both = margin("--preload", 0, "--preload-direction", "1,0,1", "--direction", "0,1,0")
        self.assertEqual((both["resisted"], both["least"]), ([], None))

    def test_preloads_in_text(self):
        words = ("margin", FIG1, "--preload", 2, "--preload-direction")
        for more, holds in ((("scale", "--wrench", "0,1,0"), "multiples from 1/2 of the preloads"),
                            (("scale", "--wrench", "0,-1,0"), "every multiple of the preloads"),
                            (("1,0,1", "--wrench", "0,3,0"), "multiples from 1"),
                            (("1,0,1", "--direction", "0,1,0"), "every multiple")):
            self.assertIn(f"Holds at {holds}.\n", stickslip(*words, *more)[1])

    def test_the_wrench_is_the_files_unless_the_load_grows(self):
        words = ("margin", FIG1, "--preload", 1, "--preload-direction", "scale")
        self.assertEqual(self.json(*words)["wrench"], ["0", "-11/10", "0"])
        self.assertEqual(self.json(*words, "--direction", "0,1,0")["wrench"], ["0", "0", "0"])
        self.assertEqual(self.json(*words, "--wrench", "0,1/3,0")["least"], "1/3")

    def test_least(self):
        words = ("margin", FIG1, "--preload", 1, "--preload-direction", "scale", "--least")
        self.assertEqual(stickslip(*words, "--wrench", "0,1/3,0"), (DONE, "1/3\n", ""))
        never = ("margin", FIG1, "--preload-direction", "0,1,0", "--preload", 0, "--wrench",
                 "0,1,0", "--least")
        code, out, _ = stickslip(*never)
        self.assertEqual(code, UNSTABLE)
        self.assertIn("no multiple holds", out)
        code, out, _ = stickslip(*never, "--json")
        self.assertEqual((code, json.loads(out)["least"]), (UNSTABLE, None))

    def test_warnings(self):
        words = ("margin", FIG1, "--preload", 0, "--preload-direction", "1,0,0", "--direction",
                 "0,-1,0")
        self.assertIn("Warning: the preloads do not balance", stickslip(*words)[1])
        self.assertEqual([w["trap"] for w in self.json(*words)["warnings"]],
                         ["unbalanced-preload"])
        self.assertNotIn("Warning", stickslip(*words, "--no-warnings")[1])
        self.assertNotIn("warnings", self.json(*words, "--no-warnings"))

    def test_certificate_is_accepted(self):
        for directions in (("--preload-direction", "scale"), ("--preload-direction", "1,1/2,1"),
                           ("--preload-direction", "scale", "--direction", "0,1,0"),
                           ("--preload-direction", "1,0,1", "--direction", "0,1,0")):
            proof = self.path("proof.json")
            self.json("margin", FIG1, *directions, "--certificate", proof)
            self.accepted(FIG1, proof, *directions)
        for direction in ("0,1,0", "0,-1,0", "-1,1/3,1/7"):
            proof = self.path("proof.json")
            self.json("margin", FIG1, "--preload", 1, "--direction", direction,
                      "--certificate", proof)
            question = (FIG1, proof, "--preload", 1, "--direction", direction)
            for checker in checkers(proof):
                code, out, err = run(*checker, *question)
                self.assertEqual(code, DONE, out + err)
                self.assertIn("accepted", out)
                code, out, err = run(*checker, FIG1, proof, "--preload", 1, "--direction", "0,2,0")
                self.assertEqual(code, 1, out + err)
                self.assertIn("question-direction", out)
class Compare(Case):
    METHODS = ["passive equilibrium", "form closure", "frictionless stable load",
               "strongly stable load", "weakly stable load", "grasp wrench space, L1",
               "grasp wrench space, Linf", "linear compliance", "three-state compliance",
               "friction cones alone", "potential contact robustness",
               "potential grasp robustness", "robustness of rigid motions",
               "least singular value", "volume of the wrench space", "least normal forces",
               "margin of internal forces", "distance of the centroid"]
    ROBUSTNESSES = METHODS[10:13]

    def rows(self, *words):
        answer = self.json("compare", *words)
        self.assertEqual([row["method"] for row in answer["methods"]], self.METHODS)
        for row in answer["methods"]:
            self.assertEqual(set(row), {"method", "source", "about", "verdict", "agrees", "why",
                                        "evidence"})
            self.assertTrue(row["why"] and "\n" not in row["why"])
            self.assertTrue(row["evidence"])
        return {row["method"]: row for row in answer["methods"]}

    def test_wrench_spaces(self):
        rows = self.rows(FIG1)
        l1 = rows["grasp wrench space, L1"]["evidence"]
        self.assertEqual((l1["radius_squared"], l1["radius"]), ("1/9", "1/3"))
        self.assertEqual(l1["zero_torque_slice"],
                         [["-1", "0"], ["0", "-1/2"], ["1", "0"], ["3/4", "3/4"], ["0", "1"],
                          ["-3/4", "3/4"]])
        linf = rows["grasp wrench space, Linf"]["evidence"]
        self.assertEqual(linf["radius_squared"], "1/3")
        low, high = (Fraction(bound) ** 2 for bound in linf["radius"])
        self.assertTrue(low < Fraction(1, 3) < high)
        longer = self.rows(FIG1, "--length", "2")["grasp wrench space, L1"]["evidence"]
        self.assertNotEqual(longer["facet"], l1["facet"])

    def test_robustness(self):
        """A pinch has the distance f / (1 + sqrt(1 + mu^2) / mu) = 3 f / 8, and M = diag(2, 2, 2)."""
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": "3/4"},
            "contacts": [{"position": [-1, 0], "normal": [1, 0]}, {"position": [1, 0], "normal": [-2, 0]}]})
        for words, force in (((), 1), (("--max-force", "3"), 3), (("--max-force", "3,4", "--accuracy", "1/1000"), 3)):
            rows = self.rows(grasp, *words)
            for name in self.ROBUSTNESSES:
                evidence = rows[name]["evidence"]
                self.assertEqual((evidence["states"], evidence["complete"]), (["stick", "stick"], True))
                self.assertEqual(Fraction(evidence["distance"]), Fraction(3 * force, 8))
                lower, upper = Fraction(evidence["lower"]), Fraction(evidence["upper"])
                square = 2 * Fraction(3 * force, 8) ** 2
                self.assertTrue(lower ** 2 <= square <= upper ** 2)
                self.assertLessEqual(upper, lower * Fraction(1001 if "--accuracy" in words else 1010, 1000))
                forces = [[Fraction(x) for x in f] for f in evidence["forces"]]
                self.assertEqual([sum(f) for f in zip(*forces)], [0, 0])
                low, high = (float(x) for x in rows[name]["verdict"].split(" to "))
                self.assertTrue(low <= lower and upper <= high)
                self.assertIn("quality is of forces that arise passively", rows[name]["why"])
            # M = diag(2, 2, 2 / L^2), and the contacts' mean is the origin.
            self.assertEqual(rows["least singular value"]["evidence"]["determinant"], "8")
            low, high = map(Fraction, rows["least singular value"]["evidence"]["least"])
            self.assertTrue(low ** 2 <= 2 <= high ** 2 and high - low < Fraction(1, 10**8))
            self.assertEqual(rows["distance of the centroid"]["verdict"], "0")
            for name, kind in zip(self.ROBUSTNESSES, ("contact", "grasp")):
                code, _, err = stickslip("compare", grasp, *words, "--methods", name.replace(" ", "-"), "--certificate", self.path("c.json"))
                self.assertEqual((code, err), (DONE, ""))
                asked = ["--robustness", kind, "--max-force", words[1] if words else "1"]
                for more, result in (([], 0), (["--length", "2"], 1)):
                    for checker in ([CHECK], [sys.executable, "-B", CHECK_PY]):
                        self.assertEqual(run(*checker, grasp, self.path("c.json"), *asked, *more)[0], result)
            # The hull of (1, +-mu, -+mu/L) and (-1, +-mu, +-mu/L) is a tetrahedron: (2 sqrt 2 mu)^2 / 3.
            self.assertEqual(rows["volume of the wrench space"]["verdict"], "3/2")
            self.assertEqual(rows["least normal forces"]["verdict"], "0")
            self.assertEqual(rows["margin of internal forces"]["verdict"], str(Fraction(3 * force, 8)))
        # Each finger carries half of a weight of 3, by friction of 3/4.
        held = self.rows(grasp, "--wrench", "0,-3,0", "--max-force", "4", "--length", "3")
        self.assertEqual(held["volume of the wrench space"]["verdict"], "1/2")
        least = held["least normal forces"]
        self.assertEqual((least["verdict"], least["about"], least["agrees"]), ("4", "grasp", None))
        self.assertEqual(least["evidence"]["sum"]["forces"], [["2", "3/2"], ["-2", "3/2"]])
        self.assertEqual((least["evidence"]["largest"]["lower"], least["evidence"]["largest"]["upper"]), ("2", "2"))
        margin = held["margin of internal forces"]  # (3/4 s - 3/2) 4/5 = 4 - s
        self.assertEqual((margin["verdict"], margin["evidence"]["upper"]), ("3/4", "3/4"))
        short = self.json("compare", grasp, "--methods", "PGR,PCR")["methods"]
        self.assertEqual([row["method"] for row in short], self.METHODS[10:12])
        # A third finger is weak. Without load no rigid motion leaves it.
        with open(grasp, encoding="utf-8") as file:
            content = json.load(file)
        content["contacts"].append({"position": [0, -1], "normal": [0, 1]})
        rows = self.rows(self.write("g3.json", content), "--max-force", "1,1,1/100")
        contact, whole, rigid = ([Fraction(rows[name]["evidence"][end]) for end in ("lower", "upper")] for name in self.ROBUSTNESSES)
        self.assertTrue(whole[0] > 50 * contact[1] and rigid[0] <= contact[1] and contact[0] <= rigid[1])
        long = self.rows(grasp, "--length", "2", "--inertia", "3,4,1")
        self.assertEqual(long["distance of the centroid"]["verdict"], "5")
        self.assertEqual(long["least singular value"]["evidence"]["determinant"], "2")
        low, high = map(Fraction, long["least singular value"]["evidence"]["isotropy"])
        self.assertTrue(low <= Fraction(1, 2) <= high and high - low < Fraction(1, 10**8))
        heavy = self.rows(grasp, "--wrench", "0,-4,0")["potential grasp robustness"]
        self.assertEqual((heavy["verdict"], heavy["why"]), ("none", "no forces up to 1 in the cones balance the load"))
        for words, name in ((("--max-force", "0"), "--max-force"), (("--max-force", "1,2,3"), "--max-force"),
                            (("--accuracy", "0"), "--accuracy"), (("--max-force", "x"), "--max-force")):
            self.fails("compare", grasp, *words, naming=[name])

    def test_irrational_normals(self):
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0, -1, 0], "defaults": {"friction": 1},
            "contacts": [{"position": [-1, -1], "normal": [1, 1]},
                         {"position": [1, -1], "normal": [-1, 1]}]})
        row = self.rows(grasp)["grasp wrench space, L1"]
        self.assertEqual(row["verdict"], "not computed")
        self.assertIn("contacts[0].normal", row["why"])
        self.assertIn("stickslip snap GRASP -o FILE", row["why"])
        stickslip("snap", grasp, "--within", "1/10", "-o", self.path("snapped.json"))
        snapped = self.rows(self.path("snapped.json"))["grasp wrench space, L1"]
        self.assertNotEqual(snapped["verdict"], "not computed")

    def test_limits_are_said(self):
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0, -1, 0], "defaults": {"friction": 1},
            "contacts": [{"position": [f"{i}/65", 0], "normal": [0, 1]} for i in range(65)]})
        rows = self.rows(grasp)
        for method in ("three-state compliance", "grasp wrench space, L1",
                       "grasp wrench space, Linf"):
            self.assertEqual(rows[method]["verdict"], "not computed")
            self.assertIsNone(rows[method]["agrees"])
            self.assertRegex(rows[method]["why"], "there are more than 64 contacts|and at most 3.10 are tried")

    def test_text_says_what_the_json_says(self):
        code, out, err = stickslip("compare", FIG1, "--wrench", "0,1,0")
        self.assertEqual((code, err), (DONE, ""))
        for row in self.rows(FIG1, "--wrench", "0,1,0").values():
            line = next(line for line in out.split("\n") if line.startswith(row["method"] + " "))
            self.assertIn(row["verdict"], line)
            self.assertTrue(line.endswith(row["why"]))
            self.assertEqual("answers another question" in line, row["about"] == "grasp")
        self.assertEqual(stickslip("compare", FIG1, "--wrench", "0,1,0")[1], out)

    def test_class_is_told_by_the_methods_that_are_asked(self):
        both = "weakly-stable-load,strongly-stable-load"
        floor = self.write("floor.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": "1/2"},
            "contacts": [{"position": [side, -1], "normal": [0, 1]} for side in (-1, 1)]})
        for load, methods, told in (
                ("1/2,-1,0", both, "must hold"), ("1/2,-1,0", "strongly-stable-load", "must hold"),
                ("1/2,-1,0", "weakly-stable-load", None), ("51/100,-1,0", both, "must move"),
                ("51/100,-1,0", "weakly-stable-load", "must move"),
                ("51/100,-1,0", "strongly-stable-load", None), ("1/2,-1,0", "form-closure", None)):
            words = ("compare", floor, "--wrench", load, "--methods", methods)
            answer = self.json(*words)
            self.assertEqual(answer["class"], told, (load, methods))
            self.assertEqual({row["method"].replace(" ", "-") for row in answer["methods"]},
                             set(methods.split(",")))
            self.assertTrue(all(row["agrees"] is None for row in answer["methods"]))
            self.assertEqual(stickslip(*words)[1].count(f"  class     {told}\n"), told is not None)
        up = self.json("compare", FIG1, "--wrench", "0,1,0")
        self.assertEqual(up["class"], "open")
        asked = self.json("compare", FIG1, "--wrench", "0,1,0", "--methods",
                          "grasp-wrench-space-L1,passive-equilibrium,weakly-stable-load")
        self.assertEqual(asked["methods"], [row for row in up["methods"] if row["method"] in (
            "passive equilibrium", "weakly stable load", "grasp wrench space, L1")])

    def test_accelerations_are_those_of_mass_one(self):
        # A rod on one end, and nothing else: the end slips, or it tips.
        x, y, square = Fraction(1, 3), Fraction(2), Fraction(1, 12)
        load = (Fraction(3), Fraction(-4), Fraction(-4) * x - 3 * y)
        rod = self.write("rod.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0],
            "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": "1/5"}]})
        answer = self.json("compare", rod, "--wrench", ",".join(map(str, load)), "--inertia",
                           f"{x},{y},{square}", "--methods", "strongly-stable-load")
        self.assertEqual(answer["inertia"],
                         {"centre": ["1/3", "2"], "gyration_squared": "1/12"})
        row, = answer["methods"]
        ax, ay, turn = map(Fraction, row["evidence"]["acceleration"])
        (fx, fy), = [[Fraction(f) for f in force] for force in row["evidence"]["forces"]]
        self.assertEqual((ax - turn * y, ay + turn * x), (load[0] + fx, load[1] + fy))
        self.assertEqual(square * turn, load[2] - (x * load[1] - y * load[0]) - (x * fy - y * fx))

    def test_classes_are_proved(self):
        proof = self.path("proof.json")
        floor = self.write("floor.json", {
            "format": "stickslip-grasp/1", "wrench": [0, -1, 0],
            "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": "1/2"}]})
        for grasp, load, told in ((FIG1, "0,1,0", "open"), (FIG1, "0,-1,0", "must hold"),
                                  (floor, "51/100,-1,0", "must move")):
            question = ("--wrench", load, "--inertia", "1/2,-1/3,2/7")
            answer = self.json("compare", grasp, *question, "--methods", "form-closure", "--certificate", proof)
            self.assertIsNone(answer["class"])
            for checker in ((CHECK,), (sys.executable, "-B", CHECK_PY)):
                code, out, err = run(*checker, grasp, proof, *question)
                self.assertEqual(code, DONE, out + err)
                self.assertIn(f"verdict     {told}\n", out)
                code, out, err = run(*checker, grasp, proof, "--wrench", load, "--inertia", "1/2,-1/3,1/7")
                self.assertEqual(code, 1, out + err)
                self.assertIn("question-inertia", out)
        self.fails("compare", FIG1, "--certificate", FIG1, naming=[FIG1])

    def test_classes_of_all_multiples(self):
        floor = self.write("floor.json", {
            "format": "stickslip-grasp/1", "wrench": [0, -1, 0], "defaults": {"friction": "1/2"},
            "contacts": [{"position": [side, -1], "normal": [0, 1]} for side in (-1, 1)]})
        asked = ("margin", floor, "--class", "--wrench", "0,-1,0", "--direction", "1,0,0")
        answer = self.json(*asked, "--inertia", "1/2,0,1/9")
        self.assertEqual(answer["inertia"], {"centre": ["1/2", "0"], "gyration_squared": "1/9"})
        self.assertEqual(answer["classes"], [
            {"class": "must hold", "low": "0", "high": "1/2", "has_low": True, "has_high": True},
            {"class": "must move", "low": "1/2", "high": None, "has_low": False, "has_high": False}])
        code, out, err = stickslip(*asked)
        self.assertEqual((code, err), (DONE, ""))
        self.assertIn("\n  must hold  l in [0, 1/2]\n  must move  l in (1/2, oo)\n", out)
        for words, naming in ((("--preload-direction", "scale"), "--class"), (("--least",), "--least"),
                              (("--certificate", self.path("p")), "--certificate"),
                              (("--inertia", "0,0"), "--inertia")):
            self.fails(*asked, *words, naming=[naming])
        self.fails("margin", floor, "--class", naming=["--class"])
        self.fails("margin", floor, "--direction", "1,0,0", "--inertia", "0,0,1", naming=["--class"])

    def test_classes_of_all_factors_of_friction(self):
        floor = self.write("floor.json", {
            "format": "stickslip-grasp/1", "wrench": ["1/4", -1, 0], "defaults": {"friction": "1/2"},
            "contacts": [{"position": [side, -1], "normal": [0, 1]} for side in (-1, 1)]})
        asked = ("margin", floor, "--class", "--friction")
        answer = self.json(*asked, "--inertia", "1/2,0,1/9")
        self.assertNotIn("direction", answer)
        self.assertEqual(answer["classes"], [
            {"class": "must move", "low": "0", "high": "1/2", "has_low": True, "has_high": False},
            {"class": "must hold", "low": "1/2", "high": None, "has_low": True, "has_high": False}])
        code, out, err = stickslip(*asked)
        self.assertEqual((code, err), (DONE, ""))
        self.assertIn("\n  must move  s in [0, 1/2)\n  must hold  s in [1/2, oo)\n", out)
        ladder = self.write("ladder.json", {
            "format": "stickslip-grasp/1", "wrench": [0, -1, -1], "defaults": {"friction": "1/2"},
            "contacts": [{"position": [0, 4], "normal": [1, 0]}, {"position": [2, 0], "normal": [0, 1]}]})
        moves, between = self.json("margin", ladder, "--class", "--friction")["classes"][:2]
        self.assertEqual((moves["class"], between["class"]), ("must move", None))
        for words, naming in ((("--direction", "1,0,0"), "--friction"), (("--accuracy", "0"), "--accuracy")):
            self.fails(*asked, *words, naming=[naming])
        self.fails("margin", floor, "--friction", "--direction", "1,0,0", naming=["--class"])

    def test_length_is_printed(self):
        half = ", half the spread of the contacts"
        # Of a pinch in millimetres, too: its pads are 61.3 apart, which is two digits up.
        pinch = self.write("mm.json", {"format": "stickslip-grasp/2", "defaults": {"friction": 1}, "wrench": [0, 0, 0], "contacts": [
            {"position": [x, 7], "normal": [-x, 0]} for x in (-30.7, 30.6)]})
        for file, words, length, default in ((FIG1, (), "1", half), (FIG1, ("--length", "0.08"), "2/25", ""), (pinch, (), "31", half)):
            self.assertIn(f"length L  {length}{default}, by which torques are divided", stickslip("compare", file, *words)[1])
            self.assertEqual(self.json("compare", file, *words)["length"], length)
            self.assertEqual(self.json("quality", file, "--at-most", "1/8", "--wrench", "0,0,0", *words)["ball"]["length"], length)
        for words, square in ((("--length", "1/3"), "1/9"),
                              (("--length", "1/3", "--inertia", "1,2,3"), "3")):
            self.assertEqual(
                self.json("compare", FIG1, *words)["inertia"]["gyration_squared"], square)

    def test_usage(self):
        for value in ("0", "-1", "x"):
            self.fails("compare", FIG1, f"--length={value}", naming=["--length"])
        for value in ("0,0", "0,0,0", "0,0,-1", "0,0,x"):
            self.fails("compare", FIG1, f"--inertia={value}", naming=["--inertia"])
        self.fails("compare", FIG1, "--methods", "weakly-stable-load,best",
                   naming=["--methods", "best"])
        self.fails("compare", self.path("missing.json"), naming=["missing.json"])
class Region(Case):
    def outlines(self, *words):
        answer = self.json("region", *words)
        self.assertEqual((answer["curves"], answer["points"]), ([], []))
        return [area["outlines"] for area in answer["areas"]]

    def test_figure_7(self):
        self.assertEqual(self.outlines(FIG1, "--preload", "0"),
                         [[{"closed": False, "from": ["1", "0"], "vertices": [["0", "0"]],
                            "to": ["-1", "0"]}]])
        self.assertEqual(self.outlines(FIG1, "--preload", "1"),
                         [[{"closed": False, "from": ["1", "0"],
                            "vertices": [["2", "0"], ["0", "1"], ["-2", "0"]],
                            "to": ["-1", "0"]}]])

    def test_planes(self):
        self.assertEqual(self.json("region", FIG1, "--torque", "1/2"),
                         self.json("region", FIG1, "--origin", "0,0,1/2"))
        answer = self.json("region", FIG1, "--u", "0,0,1", "--v", "0,-1,0")
        self.assertEqual(answer["plane"], {"origin": ["0", "0", "0"], "u": ["0", "0", "1"],
                                           "v": ["0", "-1", "0"]})

    def test_thin_and_empty(self):
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0],
            "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": 0}]})
        answer = self.json("region", grasp)
        self.assertEqual(answer["curves"], [{"vertices": [["0", "0"]], "rays": [["0", "-1"]]}])
        self.assertIn("ray (0, 0) towards (0, -1)", stickslip("region", grasp)[1])
        self.assertIs(self.json("region", grasp, "--torque", "1")["empty"], True)
        self.assertIn("No wrench", stickslip("region", grasp, "--torque", "1")[1])

    def test_list(self):
        answer = self.json("region", FIG1, "--preload", "1", "--list")
        modes = {(p["slip"], tuple(p["closed"])) for p in answer["pieces"]}
        self.assertEqual(len(modes), len(answer["pieces"]))
        self.assertLessEqual(len(modes), answer["stats"]["pieces"])
        sticking = [p for p in answer["pieces"] if p["slip"] == "000" and p["closed"] == [True, True, True]]
        self.assertEqual(len(sticking), 1)
        self.assertEqual(len(sticking[0]["vertices"]), 6)
        self.assertIn("\n  000  ", stickslip("region", FIG1, "--list")[1])

    def test_limit(self):
        answer = self.json("region", FIG1, "--mode-limit", "3", code=UNDECIDED)
        self.assertEqual((answer["limit"], answer["reason"], answer["remedy"]),
                         ("there are more than 3 contact modes", "modes", "a higher mode limit may tell"))
        self.assertNotIn("areas", answer)
        self.assertIn("\nNo region is known: there are more than 3 contact modes; a higher mode limit may tell.\n",
                      stickslip("region", FIG1, "--mode-limit", "3")[1])
        code, out, err = stickslip("region", FIG1, "--preload", "1", "--node-limit", "1", "--certificate", self.path("p"))
        self.assertEqual((code, out), (UNDECIDED, ""))
        self.assertEqual(err, "stickslip: the region has no certificate: the search reached the limit of 1 nodes; "
                              "a higher node limit may decide it\n")

    def test_certificate(self):
        proof = self.path("proof.json")
        for words, same in (
                (("--preload", "1"), ("--preload", "1", "--plane", "1,0,0,0,1,0")),
                (("--torque", "1/2"), ("--wrench", "0,0,1/2", "--plane", "1,0,0,0,1,0")),
                (("--u", "0,0,1", "--v", "0,-1,0", "--normal-law", "bilateral"),
                 ("--plane=0,0,1,0,-1,0", "--normal-law", "bilateral"))):
            self.assertEqual(self.json("region", FIG1, *words, "--certificate", proof),
                             self.json("region", FIG1, *words))
            answers = []
            for checker in checkers(proof):
                code, out, err = run(*checker, FIG1, proof, *same, "--json")
                self.assertEqual((code, err), (0, ""), out)
                answers.append(json.loads(out))
                self.assertEqual(run(*checker, FIG1, proof, *same, "--plane=1,0,0,0,1,1")[0], 1)
            self.assertEqual(answers[0]["verdict"], "region")
            self.assertEqual(answers, answers[:1] * len(answers))
            texts = {run(*checker, FIG1, proof, *same)[1] for checker in checkers(proof)}
            self.assertEqual(len(texts), 1)

    def test_the_checkers_command(self):
        """What region prints is what the checkers take, and so is what it was given itself."""
        grasp = self.write("my grasp.json", {
            **{key: value for key, value in json.loads(read(FIG1)).items() if key != "wrench"},
            "format": "stickslip-grasp/2",
            "cases": [{"name": "at rest", "wrench": [0, 0, 0]}, {"name": "the drop", "wrench": [0, 0, "1/2"]}]})
        proof = self.path("proof.json")
        for words in (("--torque", "1/2"), ("--case", "the drop"), ("--origin", "0,1,0", "--u=0,0,1"),
                      ("--preload", "1", "--normal-law", "bilateral")):
            code, out, err = stickslip("region", grasp, *words, "--certificate", proof)
            self.assertEqual((code, err), (DONE, ""))
            command = shlex.split(out.splitlines()[-1].removeprefix("Check it: "))
            self.assertEqual(command[:3], ["stickslip-check", grasp, proof])
            for checker in checkers(proof):
                code, out, err = run(*checker, *command[1:])
                self.assertEqual(code, 0, out + err)
        plane = "--plane=1,0,0,0,1,0"
        torque = self.json("region", grasp, "--torque", "1/2", "--certificate", proof)
        self.assertEqual(torque, self.json("region", grasp, "--case", "the drop"))
        for checker in checkers(proof):
            for origin in (("--torque", "1/2"), ("--torque=1/2",), ("--case", "the drop")):
                self.assertEqual(run(*checker, grasp, proof, plane, *origin)[0], 0)
            self.assertEqual(run(*checker, grasp, proof, plane, "--torque", "1")[0], 1)
            self.assertEqual(run(*checker, grasp, proof, plane, "--torque", "x")[0], BAD_INPUT)
        self.fails("region", grasp, "--case", "nobody", naming=["--case"])
        self.fails("region", grasp, "--case", "the drop", "--torque", "1", naming=["stickslip: "])

    def test_no_certificate_at_a_limit(self):
        proof = self.path("proof.json")
        for limit in (("--node-limit", "1"), ("--mode-limit", "3")):
            code, _, err = stickslip("region", FIG1, *limit, "--certificate", proof)
            self.assertEqual(code, UNDECIDED, err)
            self.assertFalse(os.path.exists(proof))

    def test_usage(self):
        self.fails("region", FIG1, "--svg", "--certificate", self.path("proof.json"))
        self.fails("region", FIG1, "--certificate", self.folder)
        self.fails("region", FIG1, "--u", "1,0,0", "--v", "2,0,0", naming=["--u, --v"])
        self.fails("region", FIG1, "--u", "1,0", naming=["--u"])
        self.fails("region", FIG1, "--torque", "x", naming=["--torque"])
        self.fails("region", FIG1, "--torque", "1", "--origin", "0,0,1")
        self.fails("region", FIG1, "--wrench", "0,0,0")
        self.fails("region", FIG1, "--mode-limit", "-1")

    def test_same_bytes(self):
        words = ("region", FIG4, "--preload", "1", "--list", "--json")
        self.assertEqual(stickslip(*words), stickslip(*words))


class Floats(Case):
    """--json --floats: every member X of exact numbers has a member X_float beside it."""

    WORDS = {"name", "slip", "closed", "claimed_slip", "states", "saved", "verdict"}  # may look like numbers

    def numbers(self, value):
        """The nearest doubles to the exact numbers that a member is, or None if it is not such."""
        if isinstance(value, str) and re.fullmatch(r"-?\d+(/\d+|\.\d+)?(e[-+]?\d+)?", value):
            try:
                return float(Fraction(value))
            except OverflowError:
                return "beyond"
        if isinstance(value, list):
            entries = [self.numbers(entry) for entry in value if entry is not None]
            if entries and None not in entries:
                rest = iter(entries)
                return [None if entry is None else next(rest) for entry in value]
        return None

    def check(self, value):
        """How many there are; and takes them out."""
        if isinstance(value, list):
            return sum(map(self.check, value))
        if not isinstance(value, dict):
            return 0
        found = 0
        for key in list(value):
            if key.endswith("_float"):
                continue
            expected = None if key in self.WORDS else self.numbers(value[key])
            if expected is None:
                self.assertNotIn(key + "_float", value)
                found += self.check(value[key])
            else:
                found += 1
                beyond = json.dumps(expected).replace('"beyond"', "null")
                self.assertEqual(value.pop(key + "_float"), json.loads(beyond), key)
        return found

    def test_every_answer(self):
        claims = self.write("claims.jsonl", json.dumps(
            {"grasp": FIG4, "claim": {"verdict": "stable", "twist": [0, 1, 0.1],
                                      "force_vectors": [[1, 0.3]] * 4}}) + "\n")
        diagonal = self.write("0.json", {
            "format": "stickslip-grasp/1", "wrench": [-1, "-9/10", 0], "name": "5",
            "defaults": {"friction": "1/7"},
            "contacts": [{"position": [0, 0], "normal": [1, 1]}]})
        for at_least, *words in ((8, "decide", FIG1), (1, "decide", FIG1, *UP),
                                 (2, "snap", diagonal, "-o", self.path("snapped.json")),
                                 (5, "decide", diagonal), (3, "margin", FIG1, "--direction=0,1/3,0"),
                                 (5, "region", FIG1, "--preload", "1/3", "--list"),
                                 (8, "compare", FIG4), (6, "compare", diagonal)):
            plain = self.json(*words)
            self.assertNotIn("_float", json.dumps(plain))
            answer = self.json(*words, "--floats")
            self.assertGreaterEqual(self.check(answer), at_least, words)
            self.assertEqual(answer, plain)
        _, plain, _ = stickslip("crosscheck", claims, "--json")
        _, out, _ = stickslip("crosscheck", claims, "--json", "--floats")
        answers = [json.loads(line) for line in out.splitlines()]
        self.assertGreaterEqual(self.check(answers), 5)
        self.assertEqual(answers, [json.loads(line) for line in plain.splitlines()])

    def test_beyond_doubles(self):
        answer = self.json("decide", FIG1, "--wrench", "1e400,-1e-400,123456789123456789123/7",
                           "--floats")
        self.assertEqual(answer["wrench_float"], [None, 0, 123456789123456789123 / 7])
        text = stickslip("decide", FIG1, "--wrench", "1e400,-1e-400,123456789123456789123/7")[1]
        self.assertIn("(1e400, -1e-400, ~1.76367e19)", text)

    def test_numbers_that_no_file_holds(self):
        """Longer than a grasp file may spell them; and with larger exponents."""
        self.addCleanup(sys.set_int_max_str_digits, sys.get_int_max_str_digits())
        sys.set_int_max_str_digits(0)
        short = self.write("short.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, "1e4096"], "defaults": {"friction": 100},
            "contacts": [{"position": [0, 0], "normal": [1, 1]},
                         {"position": ["1e-4096", 0], "normal": [-1, -1]},
                         {"position": [0, "1e-4096"], "normal": [1, 2]}]})
        for at_least, needle, *words in (
                (5, r'"-?[0-9/]{16385,}"', "region", os.path.join(CORPUS, "good", "exact_numbers.json")),
                (5, r'"-?[.0-9]+e8191"', "decide", short)):
            plain, answer = self.json(*words), self.json(*words, "--floats")
            self.assertRegex(json.dumps(plain), needle)
            self.assertGreaterEqual(self.check(answer), at_least, words)
            self.assertEqual(answer, plain)

    def test_usage(self):
        self.fails("decide", FIG1, "--floats", naming=["--json"])


class Snap(Case):
    """A file whose preloads act along normals of irrational length becomes one that can be asked
    about."""

    CONTENT = {"format": "stickslip-grasp/1", "name": "cup", "wrench": [0, "1/10", 0],
               "defaults": {"friction": 1, "preload": 1},
               "contacts": [{"position": [-1, -1], "normal": [1, 1]},
                            {"position": [1, -1], "normal": [-1, 3], "stiffness": 2},
                            {"position": [0, 1], "normal": [0, -5], "preload": "1/3"}]}

    def setUp(self):
        super().setUp()
        self.grasp = self.write("g.json", self.CONTENT)
        self.snapped = self.path("snapped.json")

    def test_writes_and_reports(self):
        for words, within in (((), "1e-9"), (("--within", "1/1000"), "1/1000"),
                              (("--within", "1e-40"), "1e-40")):
            answer = self.json("snap", self.grasp, "-o", self.snapped, *words)
            self.assertEqual(answer["name"], "cup")
            self.assertEqual([entry["contact"] for entry in answer["moved"]], [0, 1])
            written = json.loads(read(self.snapped))
            for entry, (x, y) in zip(answer["moved"], ((1, 1), (-1, 3))):
                u, v = map(Fraction, entry["normal"])
                self.assertEqual(u * u + v * v, 1)
                moved = Fraction(entry["moved_at_most"])
                self.assertLessEqual(moved, Fraction(within))
                # |(u, v) - n/L| <= moved: see SnapNormals in tests/core.
                cosine = 1 - moved * moved / 2
                self.assertGreaterEqual((u * x + v * y) ** 2, cosine**2 * (x * x + y * y))
            # All else is as it was; what "defaults" gave is written out, an assumed stiffness not.
            defaults = self.CONTENT["defaults"]
            expected = [{**defaults, **contact} for contact in self.CONTENT["contacts"]]
            for entry in answer["moved"]:
                expected[entry["contact"]]["normal"] = entry["normal"]
            self.assertEqual(written, {**{key: self.CONTENT[key] for key in ("format", "name", "wrench")},
                                       "contacts": expected})
        _, out, err = stickslip("snap", self.grasp, "-o", self.snapped)
        self.assertEqual(err, "")
        self.assertRegex(out, r"^contact 0: normal \(1, 1\) moved by at most [0-9.]+e-10, "
                              r"to \(~0.707107, ~0.707107\)\ncontact 1: .*\n~ marks")

    def test_then_every_question_has_a_proof(self):
        self.fails("compare", self.grasp, naming=["contacts[0].normal", "stickslip snap GRASP -o FILE"])
        stickslip("snap", self.grasp, "-o", self.snapped)
        for load in ("0,1/10,0", "100,0,0"):
            verdict = self.json("decide", self.snapped, "--wrench", load)["verdict"]
            self.assertEqual(verdict, "stable" if load == "0,1/10,0" else "unstable")
            Certificates.asked(self, self.snapped, "--wrench", load, verdict=verdict)
        proof = self.path("branch-and-bound")
        Certificates.checked(self, 1, self.snapped, proof)
        Certificates.checked(self, 1, self.grasp, proof, "--wrench", "100,0,0")

    def test_regions_and_pictures_need_no_snap(self):
        """Jaws along a diagonal press with 1 each; friction is 1, and both hold alike. So s (1, -1) + t (1, 1) is resisted
        where |s| + |t| is at most the root of 2."""
        jaws = self.write("jaws.json", {
            "format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": 1, "preload": 1},
            "contacts": [{"position": [-1, -1], "normal": [1, 1]}, {"position": [1, 1], "normal": [-1, -1]}]})
        cells = self.json("region", jaws, "--u", "1,-1,0", "--v", "1,1,0", "--within=0:2,0:2", "--depth", "4")["cells"]
        share = {"stable": 0, "unstable": 0, "undecided": 0}
        for cell in cells:
            (left, right), (low, high) = [map(Fraction, cell[axis]) for axis in "xy"]
            if cell["verdict"] == "stable":
                self.assertLess((right + high) ** 2, 2)
            elif cell["verdict"] == "unstable":
                self.assertGreater((left + low) ** 2, 2)
            share[cell["verdict"]] += (right - left) * (high - low)
        self.assertGreater(share["stable"], Fraction(7, 10))  # of 1
        self.assertGreater(share["unstable"], Fraction(5, 2))  # of 3
        self.fails("region", jaws, "--list", naming=["--list", "irrational"])
        for load, verdict in (("1,-1,0", "stable"), ("2,-2,0", "unstable")):
            code, out, err = stickslip("plot", "grasp", jaws, "--wrench", load)
            self.assertEqual((code, err), (DONE, ""))
            self.assertRegex(out, f"<title>.*{verdict}</title>")
            self.assertEqual(out.count('data-near="'), 2 if verdict == "stable" else 0)  # a force at each

    def test_nothing_to_snap(self):
        code, out, err = stickslip("snap", FIG1, "-o", self.snapped)
        self.assertEqual((code, err), (DONE, ""))
        self.assertEqual(out, "nothing to snap: every normal has a rational length\n")
        self.assertEqual(self.json("decide", self.snapped), self.json("decide", FIG1))
        # Nor in what was snapped, which does not change any more.
        stickslip("snap", self.grasp, "-o", self.snapped)
        again = self.path("again.json")
        self.assertEqual(self.json("snap", self.snapped, "-o", again)["moved"], [])
        self.assertEqual(read(again), read(self.snapped))

    def test_standard_output_is_the_grasp_alone(self):
        stickslip("snap", self.grasp, "-o", self.snapped)
        code, out, err = stickslip("snap", "-", "-o", "-", stdin=read(self.grasp))
        self.assertEqual((code, out), (DONE, read(self.snapped)))
        self.assertIn("contact 1: normal (-1, 3) moved by", err)

    def test_never_over_what_it_reads(self):
        for name in (self.grasp, self.path("../" + os.path.basename(self.folder) + "/g.json")):
            self.fails("snap", self.grasp, "-o", name, naming=[name, "the input " + self.grasp])
        self.assertEqual(json.loads(read(self.grasp)), self.CONTENT)

    def test_usage(self):
        self.fails("snap", self.grasp, naming=["--output"])
        self.fails("snap", self.write("old.json", {**self.CONTENT, "normals": "snap"}), "-o", self.snapped,
                   naming=['unknown key "normals"', "stickslip snap GRASP -o FILE"])
        self.assertFalse(os.path.exists(self.snapped))


class Export(Case):
    def test_z3_confirms(self):
        for options, expected in (((), "sat"), (UP, "unsat"),
                                  (("--preload", "0", "--wrench", "0,1,0"), "unsat")):
            path = self.path("problem.smt2")
            self.assertEqual(stickslip("export", FIG1, "--smt2", *options, "-o", path), (DONE, "", ""))
            self.assertEqual(stickslip("export", FIG1, "--smt2", *options), (DONE, read(path), ""))
            z3 = os.environ.get("Z3", "z3")
            self.assertNotIn("NOTFOUND", z3, "install z3 (Debian: apt-get install z3)")
            self.assertEqual(run(z3, "-smt2", path), (0, expected + "\n", ""))

    def test_usage(self):
        self.fails("export", FIG1)
        self.fails("export", FIG1, "--smt2", "-o", self.path("no/folder"),
                   naming=[self.path("no/folder")])


class BadInput(Case):
    def test_usage(self):
        for words in (("decides", FIG1), ("decide",), ("decide", FIG1, "--what"),
                      ("decide", FIG1, FIG4), ("decide", FIG1, "--engine", "guess"),
                      ("decide", FIG1, "--normal-law", "both"),
                      ("decide", FIG1, "--node-limit", "-1"), ("states", FIG1, "--threads", "-1"),
                      ("states", FIG1, "--engine", "guess"), ("decide", FIG1, "--preload"),
                      ("region", FIG1, "--torque", "1", "--origin", "0,0,1")):
            self.assertTrue(self.fails(*words).startswith("stickslip: "), words)

    def test_percents_that_were_meant(self):
        for kind in ("friction", "preload", "stiffness"):
            self.assertIn(f"did you mean {kind}=10%, and not 10 up and down?",
                          self.fails("decide", FIG1, "--uncertain", f"{kind}=10", naming=[f".{kind}"]))
            self.assertNotIn("did you mean", self.fails("decide", FIG1, "--uncertain", f"{kind}=200%"))

    def test_misspelt_words_get_the_nearest(self):
        for words, meant in ((("decides", FIG1), "decide"), (("plot", "grap", FIG1), "grasp"),
                             (("crossceck", "--help"), "crosscheck"), (("--help", "marign"), "margin"),
                             (("help", "decid"), "decide"), (("help", "plot", "state"), "states")):
            self.fails(*words, naming=["stickslip: ", f'did you mean "{meant}"?'])
        for words, meant in ((("--exitcode",), "--exit-code"), (("--nodelimit", "3"), "--node-limit"),
                             (("--nodelimit=3",), "--node-limit"), (("-certificate", "p"), "--certificate"),
                             (("--certificate", "p", "--jsn"), "--json"), (("--wrench", "-1,0,0", "--preloads", "1"), "--preload")):
            self.fails("decide", FIG1, *words, naming=["stickslip decide", f'did you mean "{meant}"?'])
            self.fails("decide", *words, FIG1, naming=[f'did you mean "{meant}"?'])
        self.fails("export", FIG1, "--smt", naming=['did you mean "--smt2"?'])
        self.fails("--verson", naming=['did you mean "--version"?'])
        self.assertNotIn("did you mean", self.fails("bogus", naming=["no command", "decide, states"]))
        self.assertNotIn("did you mean", self.fails("decide", FIG1, "--qqq", naming=["--help"]))
        # Not a word of the command line, but the value of an option, or none that is unknown.
        self.fails("decide", FIG1, "--engine", "--jsn", naming=["--engine"])
        self.assertNotIn("did you mean", self.fails("decide", FIG1, "--engine", "--jsn"))
        self.assertNotIn("no option", self.fails("decide", FIG1, FIG4, "-1"))

    def test_help_in_words(self):
        for words in ((), ("decide",), ("plot",), ("plot", "grasp"), ("help",), ("complete",)):
            code, out, err = stickslip("help", *words)
            self.assertEqual((code, err), (DONE, ""), words)
            self.assertEqual(out, stickslip(*words, "--help")[1])
        for words in (("bogus", "--help"), ("bogus", "-h"), ("--help", "bogus"), ("help", "bogus"),
                      ("plot", "bogus", "--help"), ("help", "plot", "bogus")):
            self.fails(*words, naming=['"bogus"'])
        self.assertEqual(stickslip("decide", "--bogus", "--help")[0], DONE)

    def test_numbers_of_things(self):
        for value in ("-3", "1.5", "x", "", "1e3", "0x10", " 1"):
            self.fails("decide", FIG1, "--node-limit", value,
                       naming=["--node-limit", f'"{value}"', "0 or more"])
        self.fails("decide", FIG1, "--node-limit", "99999999999999999999",
                   naming=["at most 18446744073709551615"])
        self.fails("states", FIG1, "--threads", "1025", naming=["--threads", "at most 1024"])
        self.fails("region", FIG1, "--mode-limit", "-1", naming=["--mode-limit", "0 or more"])
        self.assertEqual(stickslip("states", FIG1, "--threads", "1024")[0], DONE)
        self.assertEqual(stickslip("decide", FIG1, "--node-limit", "0")[0], DONE)

    def test_normals_of_doubles_with_preload(self):
        normal = [0.7071067811865476, 0.7071067811865475]  # math.cos and math.sin of 45 degrees
        content = {"format": "stickslip-grasp/1", "wrench": [0, 0, 0],
                   "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": 1, "preload": 1},
                                {"position": [0, 0], "normal": normal, "friction": 1, "preload": 1}]}
        grasp, snapped = self.write("g.json", content), self.path("snapped.json")
        remedy = "run stickslip snap GRASP -o FILE, and ask about FILE"
        self.assertEqual(stickslip("snap", grasp, "-o", snapped)[0::2], (DONE, ""))
        self.fails("compare", grasp, naming=[grasp, "contacts[1].normal", remedy])
        self.assertEqual(stickslip("compare", snapped)[0::2], (DONE, ""))
        _, out, _ = stickslip("batch", self.write("g.jsonl", json.dumps(content) + "\n"))
        decided = json.loads(stickslip("decide", grasp, "--json")[1])
        self.assertEqual(json.loads(out)["verdict"], decided["verdict"])
        lines = self.write("g.jsonl", json.dumps(json.loads(read(snapped))) + "\n")
        self.assertEqual(stickslip("batch", lines)[0], DONE)

    def test_option_values(self):
        for option, values in (("--wrench", ("1,2", "1,2,3,4", "1,2,x", "1,,3", "1 2 3", "nan,0,0")),
                               ("--preload", ("-1", "x", "1/0", "0x1"))):
            for value in values:
                self.fails("decide", FIG1, f"{option}={value}", naming=[option])
        for value in ("0", "1", "-1", "2", "x"):
            self.fails("snap", FIG1, f"--within={value}", "-o", self.path("never.json"),
                       naming=["--within"])
        self.assertFalse(os.path.exists(self.path("never.json")))

    def test_files(self):
        missing = self.path("missing.json")
        for command in ("decide", "states"):
            self.fails(command, missing, naming=["stickslip: ", missing, "No such file"])
            self.fails(command, self.folder, naming=[self.folder])
        self.fails("export", missing, "--smt2", naming=[missing])

    def test_place_and_remedy(self):
        grasp = self.write("g.json", {"format": "stickslip-grasp/1", "wrench": [0, 0, 0],
                                      "contacts": [{"position": [0, 0], "normal": [0, 1],
                                                    "frictoin": 1}]})
        self.fails("decide", grasp, naming=[grasp, "contacts[0]", "frictoin", "friction"])
        self.fails("decide", self.write("h.json", '{"format": "stickslip-grasp/1",\n  "x" 1}'),
                   naming=["h.json: 2:"])


if __name__ == "__main__":
    unittest.main()
