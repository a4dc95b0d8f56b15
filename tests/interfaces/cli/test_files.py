# SPDX-License-Identifier: GPL-3.0-or-later
"""Files that a command reads are not written over, whatever they are called; what is wrong with a
file is said."""

import json
import os
import resource
import signal
import subprocess
import unittest

from test_batch import grasp
from test_cli import BAD_INPUT, DONE, FIG1, STICKSLIP, Case, read, stickslip
from test_crosscheck import FIG1 as CLAIMED_GRASP
from test_crosscheck import RIGHT, TIE, WRONG_UNSTABLE

OUTPUTS = (("decide", "--certificate"),
           ("margin", "--direction=0,1,0", "--certificate"),
           ("snap", "-o"), ("export", "--smt2", "-o"),
           ("plot grasp", "-o"), ("plot states", "-o"), ("plot region", "-o"))


class Inputs(Case):
    """Every file of the folder is the same after as before."""

    def setUp(self):
        super().setUp()
        self.grasp = self.write("g.json", read(FIG1))
        self.lines = self.write("grasps.jsonl", json.dumps(grasp(1)) + "\n")
        os.makedirs(self.path("proofs"))
        os.link(self.grasp, self.path("hard.json"))
        os.symlink("g.json", self.path("soft.json"))
        os.symlink("soft.json", self.path("soft2.json"))

    def files(self):
        return {os.path.join(place, name): read(os.path.join(place, name))
                for place, _, names in os.walk(self.folder) for name in names}

    def refused(self, *words, naming, stdin=None, stdout=subprocess.PIPE):
        before = self.files()
        result = subprocess.run([STICKSLIP, *words], stdin=stdin, stdout=stdout,
                                stderr=subprocess.PIPE, text=True, check=False,
                                cwd=self.folder, timeout=120)
        self.assertEqual(result.returncode, BAD_INPUT, (words, result.stderr))
        for part in naming:
            self.assertIn(part, result.stderr)
        self.assertEqual(self.files(), before, words)

    def test_no_command_writes_over_its_grasp(self):
        for command, *options in OUTPUTS:
            for name in ("g.json", "./g.json", self.grasp, "proofs/../g.json", "hard.json",
                         "soft.json", "soft2.json"):
                self.refused(*command.split(), "g.json", *options, name,
                             naming=[f"{name}: ", "the input g.json", "name another file"])
            self.refused(*command.split(), "soft.json", *options, "g.json",
                         naming=["g.json: ", "the input soft.json"])

    def test_nor_over_standard_input(self):
        for command, *options in OUTPUTS:
            with open(self.grasp, encoding="utf-8") as stdin:
                self.refused(*command.split(), "-", *options, "g.json", stdin=stdin,
                             naming=["g.json: ", "the input <stdin>"])

    def test_nor_appends_its_output_to_it(self):
        for words in (("decide", "g.json"), ("export", "g.json", "--smt2"),
                      ("batch", "grasps.jsonl"), ("crosscheck", "grasps.jsonl")):
            with open(self.path(words[1]), "a", encoding="utf-8") as stdout:
                self.refused(*words, stdout=stdout, naming=[words[1], "this very file"])

    def test_batch(self):
        os.link(self.lines, self.path("proofs/line-1.json"))
        self.refused("batch", "grasps.jsonl", "--certificates", "proofs",
                     naming=["proofs/line-1.json: ", "the input grasps.jsonl"])
        for more in ((), ("--resume",)):
            for name in ("grasps.jsonl", "proofs/line-1.json"):
                self.refused("batch", "grasps.jsonl", "-o", name, *more,
                             naming=[f"{name}: ", "the input grasps.jsonl"])

    def test_a_batch_keeps_its_own_results(self):
        stickslip("batch", self.lines, "-o", self.path("proofs/line-2.json"))
        self.write("grasps.jsonl", 2 * (json.dumps(grasp(1)) + "\n"))
        self.refused("batch", "grasps.jsonl", "-o", "proofs/line-2.json", "--resume",
                     "--certificates", "proofs", naming=["the output proofs/line-2.json"])

    def test_crosscheck_keeps_what_it_saved_before(self):
        claims = self.path("claims.jsonl")
        self.write("fig1.json", CLAIMED_GRASP)
        self.write("claims.jsonl", json.dumps(WRONG_UNSTABLE) + "\n")
        self.assertEqual(stickslip("crosscheck", claims, "--save", self.path("saved"))[0], 1)
        # The first line would be saved over the grasp of the second.
        again = {**WRONG_UNSTABLE, "grasp": "saved/line-1.grasp.json"}
        self.write("claims.jsonl", "".join(json.dumps(c) + "\n" for c in (TIE, again)))
        self.refused("crosscheck", "claims.jsonl", "--save", "saved",
                     naming=["saved/line-1.", "--save", "another folder"])
        os.makedirs(self.path("other"))
        os.link(claims, self.path("other/line-1.certificate.json"))
        self.refused("crosscheck", "claims.jsonl", "--save", "other", naming=["line-1.certificate"])

    def test_what_is_no_input_is_written_as_ever(self):
        self.write("old.smt2", "old")
        for name in ("old.smt2", "new.smt2"):
            self.assertEqual(stickslip("export", self.grasp, "--smt2", "-o", self.path(name)),
                             (DONE, "", ""))
            self.assertIn("QF_LRA", read(self.path(name)))
        self.assertEqual(read(self.grasp), read(FIG1))
        for device in ("/dev/stdout", "/dev/null", "-"):
            code, out, err = stickslip("export", self.grasp, "--smt2", "-o", device)
            self.assertEqual((code, err), (DONE, ""))
            self.assertEqual(out, "" if device == "/dev/null" else read(self.path("old.smt2")))
        with open(self.path("out.txt"), "w", encoding="utf-8") as stdout:
            subprocess.run([STICKSLIP, "export", self.grasp, "--smt2"], stdout=stdout, check=True,
                           timeout=120)
        self.assertEqual(read(self.path("out.txt")), read(self.path("old.smt2")))


class WhatIsWrong(Case):
    READERS = (("decide",), ("batch",), ("crosscheck",))

    def test_a_directory(self):
        for words in self.READERS:
            self.fails(*words, self.folder, naming=[self.folder, "this is a directory", "name a "])
            folder = os.open(self.folder, os.O_RDONLY)
            self.addCleanup(os.close, folder)
            result = subprocess.run([STICKSLIP, *words, "-"], stdin=folder, capture_output=True,
                                    text=True, check=False, timeout=120)
            self.assertEqual(result.returncode, BAD_INPUT)
            self.assertIn("<stdin>: this is a directory", result.stderr)
        self.fails("export", FIG1, "--smt2", "-o", self.folder, naming=["Is a directory"])

    def test_nothing_in_it(self):
        for text in ("", "\n \n"):
            path = self.write("e", text)
            self.fails("decide", path, naming=[path, "empty"])
            self.fails("crosscheck", path, naming=[path, "empty", "no claim"])
            code, out, err = stickslip("batch", path)
            self.assertEqual((code, out), (DONE, ""))
            self.assertIn(f"{path}: the file is empty, there is no grasp in it", err)

    def test_a_trailing_comma(self):
        text = json.dumps(grasp(1))
        contact = text.index('}], "wrench"') + 1
        cases = [(text[:-1] + ",}", len(text), '"}"'),
                 (text[:-1] + " , }", len(text) + 1, '"}"'),
                 (text[:contact] + "," + text[contact:], contact + 1, '"]"')]
        for broken, place, bracket in cases:
            for command, form in (("decide", "%s"), ("batch", "%s\n"), ("crosscheck", (
                    '{"grasp": %s, "claim": {"verdict": "stable"}}'))):
                _, out, err = stickslip(command, self.write("g", form % broken))
                said = (out + err).replace("\\", "")
                self.assertIn(f"a comma before {bracket}", said)
                self.assertIn(f"1:{place + form.index('%')}", said)
                self.assertIn("remove it", said)
        for claim in (json.dumps(RIGHT)[:-1] + ",}", json.dumps(RIGHT)[:-1] + ", }"):
            _, out, _ = stickslip("crosscheck", self.write("c", claim))
            self.assertIn(f'1:{len(json.dumps(RIGHT))}: a comma before "}}"', out)

    def test_a_comma_between_lines(self):
        path = self.write("g", json.dumps(grasp(1)) + ",\n")
        _, out, _ = stickslip("batch", path)
        self.assertIn("remove the comma", out)
        _, out, _ = stickslip("crosscheck", self.write("c", json.dumps(RIGHT) + ",\n"))
        self.assertIn("remove the comma", out)

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")
    def test_a_full_disk(self):
        full = "No space left on device"
        lines = self.write("g.jsonl", json.dumps(grasp(1)) + "\n")
        for words in (("decide", FIG1, "--certificate"), ("export", FIG1, "--smt2", "-o"),
                      ("batch", lines, "-o"), ("completion", "bash", "-o")):
            self.fails(*words, "/dev/full", naming=["/dev/full", full, "make room"])
        self.write("fig1.json", CLAIMED_GRASP)
        claims = self.write("c.jsonl", 200 * (json.dumps(TIE) + "\n"))  # more than a buffer
        for words in (("decide", FIG1), ("batch", lines), ("states", FIG1), ("--help",),
                      ("help", "decide"), ("decide", "--help"), ("crosscheck", claims, "--json")):
            with open("/dev/full", "w", encoding="utf-8") as stdout:
                found = subprocess.run([STICKSLIP, *words], stdout=stdout, stderr=subprocess.PIPE,
                                       text=True, check=False, timeout=120)
            self.assertEqual(found.returncode, BAD_INPUT, words)
            self.assertIn(f"<stdout>: the file cannot be written: {full}", found.stderr, words)


class TemporaryFiles(Case):
    def test_resume_removes_what_a_killed_run_left(self):
        lines = self.write("g.jsonl", "".join(json.dumps(grasp(i)) + "\n" for i in (1, 2)))
        proofs, out = self.path("proofs"), self.path("out.jsonl")

        def limit_files():  # the first certificate is longer, and kills
            signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_FSIZE, (64, 64))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        words = ["batch", lines, "-o", out, "--certificates", proofs]
        killed = subprocess.run([STICKSLIP, *words, "--threads", "1"], preexec_fn=limit_files,
                                check=False, timeout=120)
        self.assertEqual(killed.returncode, -signal.SIGXFSZ)
        self.assertTrue([name for name in os.listdir(proofs) if name.endswith(".tmp")])

        others = {"line-1.json.tmp", "line-x.json.1-2.tmp", "other.json.1-2.tmp",
                  "line-1.json.1-2.tmp.bak", "line-1.grasp.json.1-2.tmp"}
        for name in others:
            self.write(os.path.join("proofs", name), "kept")
        os.makedirs(os.path.join(proofs, "line-9.json.1-2.tmp"))  # a folder
        self.assertEqual(stickslip(*words, "--resume"), (DONE, "", ""))
        self.assertEqual(set(os.listdir(proofs)),
                         others | {"line-1.json", "line-2.json", "line-9.json.1-2.tmp"})


if __name__ == "__main__":
    unittest.main()
