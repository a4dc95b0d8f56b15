# SPDX-License-Identifier: MIT
"""Grasps, certificates, and all checkers asked the same for every case.

certificate/python/check.py runs in this process. stickslip-check runs too if the environment variable
STICKSLIP_CHECK names it, and certificate/js/check.js if STICKSLIP_NODE names node, as they do under ctest:
result, rule, node, path and everything else but the words of `found` (and where a malformed file is
malformed) must be the same. So does stickslip-proved, if STICKSLIP_PROVED names it; but its rules,
nodes and paths may be others, and what its theorem does not cover it does not judge.
"""

import atexit
import json
import os
import py_compile
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

HERE = os.path.dirname(os.path.abspath(__file__))
CHECK = os.path.join(HERE, "..", "..", "..", "certificate", "python", "check.py")
CHECK_NODE = os.path.join(HERE, "..", "..", "..", "certificate", "js", "check_node.js")
STICKSLIP_CHECK = os.environ.get("STICKSLIP_CHECK")
STICKSLIP_NODE = os.environ.get("STICKSLIP_NODE")
STICKSLIP_PROVED = os.environ.get("STICKSLIP_PROVED")
NOT_JUDGED = 3  # what takes too much work, or is of a kind that a checker does not cover
sys.path[:0] = [os.path.dirname(CHECK), os.path.join(HERE, "..", "..", "rules"), os.path.join(HERE, "..", "..", "support"), HERE]

import batch  # noqa: E402
import check  # noqa: E402
import corpus  # noqa: E402, F401
from in_process import in_process  # noqa: E402


def grasp(points, normals, **members):
    return {"format": "stickslip-grasp/1", "defaults": {"friction": "1/2"},
            "contacts": [{"position": p, "normal": n} for p, n in zip(points, normals)],
            "wrench": [0, 0, 0], **members}


FIG1 = grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]])


def certificate(m, wrench, preload=None, law="unilateral", direction=None, preload_direction=None,
                uncertain=None, **evidence):
    question = {"contacts": m, "wrench": wrench}
    if preload is not None:
        question["preload"] = preload
    question["normal_law"] = law
    if direction is not None:
        question["direction"] = direction
    if preload_direction is not None:
        question["preload_direction"] = preload_direction
    if uncertain is not None:
        question["uncertain"] = uncertain
    verdict = ("margin" if "resisted" in evidence or "intervals" in evidence else
               "unstable" if "tree" in evidence else "stable")
    if verdict == "stable" and "parts" not in evidence:
        evidence = {"twist": evidence["twist"], "shares": evidence.get("shares", [])}
    return {"format": "stickslip-certificate/2", "question": question, "verdict": verdict, **evidence}


def interval(low, high):
    return {"min": low, "max": high}


def stable(m, wrench, parts, **question):
    return certificate(m, wrench, parts=parts, **question)


def posed(file, *options):
    """The question, as check.py reads it."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "g.json")
        with open(path, "w", encoding="utf-8") as stream:
            json.dump(file, stream)
        return check.pose(path, check.parse_arguments([path, "c", *options]).options)


# Fig. 1 under (0, 11/10, 0) with P = 1: unstable (Table I). v_0 = h - x, v_2 = h + x.
UP = ("--wrench", "0,11/10,0", "--preload", "1")
UP_TREE = [["separation", 0], ["separation", 2], ["leaf", 0, -1, 0], ["leaf", 0, -1, -1],
           ["leaf", 0, -1, 1]]


def up(tree=None, **changes):
    return {**certificate(3, [0, "11/10", 0], 1, tree=UP_TREE if tree is None else tree), **changes}


def as_bytes(content):
    if not isinstance(content, (str, bytes)):
        content = json.dumps(content)
    return content if isinstance(content, bytes) else content.encode("utf-8")


def both_ways(arguments):
    """in_process() without and with --json. The certificate is judged once."""
    judge, found = check.answer, []

    def answer(asked):
        if not found:
            found.append(judge(asked))
        return found[0]

    with unittest.mock.patch.object(check, "answer", answer):
        return in_process(arguments), in_process([*arguments, "--json"])


def start(program, arguments, stdin=None, cwd=None):
    """Exit code, standard output and standard error of one of PROGRAMS."""
    done = subprocess.run([*program, *arguments], input=stdin, capture_output=True, timeout=300,
                          check=False, cwd=cwd)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


# Compiled once: that takes most of a start.
COMPILED = tempfile.TemporaryDirectory()
atexit.register(COMPILED.cleanup)
PROGRAMS = [[sys.executable, py_compile.compile(CHECK, os.path.join(COMPILED.name, "check.pyc"), doraise=True)]]
PROGRAMS += [[program] for program in (STICKSLIP_CHECK, STICKSLIP_PROVED) if program]
PROGRAMS += [[STICKSLIP_NODE, CHECK_NODE]] if STICKSLIP_NODE else []


def question_of(grasp_file, certificate_file, options):
    return batch.question_of(as_bytes(grasp_file), as_bytes(certificate_file), options)


def in_batch(program, grasp_file, certificate_file, options):
    """The report of a checker that answers line by line."""
    return batch.in_batch(program, question_of(grasp_file, certificate_file, options))


class Case(unittest.TestCase):
    def run_both(self, grasp_file, certificate_file, *options):
        """Exit code, report, text and standard error of check.py; files are objects, texts or
        bytes. stickslip-check and check.js must answer the same; their texts are for tests/rules."""
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for name, content in (("g.json", grasp_file), ("c.json", certificate_file)):
                paths.append(os.path.join(folder, name))
                with open(paths[-1], "wb") as file:
                    file.write(as_bytes(content))
            (code, text, err), (_, out, _) = both_ways([*paths, *options])
            report = json.loads(out)
        for program in ([STICKSLIP_CHECK], [STICKSLIP_NODE, CHECK_NODE]):
            if program[0]:
                self.compare(report, in_batch(program, grasp_file, certificate_file, options))
        if STICKSLIP_PROVED:
            self.compare_proved(report, in_batch([STICKSLIP_PROVED], grasp_file, certificate_file, options))
        self.assertTrue((text + err).isascii() and (text + err).replace("\n", "").isprintable())
        return code, report, text, err

    def compare(self, report, other):
        """Of two checkers."""
        mine, theirs = dict(report), dict(other)
        self.assertEqual(mine.pop("found") is None, theirs.pop("found") is None, (report, other))
        if report["result"] == "malformed":
            del mine["path"], theirs["path"]
        self.assertEqual(list(mine.items()), list(theirs.items()), (report, other))

    def compare_proved(self, report, proved):
        """stickslip-proved accepts what the others do, and says the same of it; its rules may be coarser."""
        self.assertEqual(proved["result"], report["result"], (report, proved))
        if report["result"] == "accepted":
            self.assertEqual(proved, report)

    def accepts(self, grasp_file, certificate_file, *options):
        code, report, text, err = self.run_both(grasp_file, certificate_file, *options)
        self.assertEqual((code, report["result"], text.split("\n")[0], err),
                         (0, "accepted", "accepted", ""), report)
        return text

    def rejects(self, rule, grasp_file, certificate_file, *options, node=None, path=None):
        code, report, text, err = self.run_both(grasp_file, certificate_file, *options)
        self.assertEqual((code, err, report["result"], report["rule"]), (1, "", "rejected", rule),
                         report)
        self.assertEqual((report["node"], report["path"]), (node, path), report)
        self.assertTrue(report["found"])
        self.assertTrue(text.startswith(f"rejected\nrule   {rule}\n"), text)

    def malformed(self, needle, grasp_file, certificate_file, *options):
        code, report, text, err = self.run_both(grasp_file, certificate_file, *options)
        self.assertEqual((code, report["result"], text), (2, "malformed", ""), err)
        self.assertIn(needle, err)
        self.assertTrue(err.startswith("check.py: "), err)
