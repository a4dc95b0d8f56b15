# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals at many moments: no file is left half-written, and a batch goes on where it was.

Nothing here depends on how fast the program is: where it must not have ended before the signal
comes, its input is still open.
"""

import json
import os
import re
import signal
import subprocess
import threading
import unittest

from test_cli import DONE, STICKSLIP, Case, run, stickslip
from test_batch import grasp
from test_crosscheck import WRONG_UNSTABLE

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def start(*words, ignored=()):
    """With the default for each signal, whatever the test was started with."""
    def set_signals():
        for number in SIGNALS:
            signal.signal(number, signal.SIG_IGN if number in ignored else signal.SIG_DFL)
    return subprocess.Popen([STICKSLIP, *map(str, words)], stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            preexec_fn=set_signals)


def content(path):
    with open(path, "rb") as file:
        return file.read()


def files_in(folder):
    return {name: content(os.path.join(folder, name)) for name in os.listdir(folder)}


class Interruption(Case):
    def feed(self, process, text, until):
        """Writes the text, leaves the input open, and comes back when `until` holds."""
        def write():
            try:
                process.stdin.write(text)
                process.stdin.flush()
            except BrokenPipeError:
                pass
        thread = threading.Thread(target=write)
        thread.start()
        while not until():
            self.assertIsNone(process.poll(), "ended before the signal")
        return thread

    def end(self, process, number, writer=None):
        process.send_signal(number)
        process.wait(timeout=120)
        if writer:
            writer.join()
        try:
            process.stdin.close()
        except BrokenPipeError:
            pass
        out, err = process.stdout.read(), process.stderr.read()
        process.stdout.close()
        process.stderr.close()
        return process.returncode, out, err

    def test_batch_goes_on_as_if_never_interrupted(self):
        text = "".join(json.dumps(grasp(seed)) + "\n" for seed in range(200))
        path = self.write("grasps.jsonl", text)
        os.makedirs(self.path("whole"))
        whole, proofs = self.path("whole.jsonl"), self.path("proofs")
        self.assertEqual(stickslip("batch", path, "-o", whole, "--certificates", proofs),
                         (DONE, "", ""))
        expected, expected_proofs = content(whole), files_in(proofs)
        for number in SIGNALS:
            for lines in (1, 2, 17, 120):
                out = self.path(f"out-{number}-{lines}.jsonl")
                for name in expected_proofs:
                    os.remove(os.path.join(proofs, name))
                words = ("batch", "-", "-o", out, "--certificates", proofs)
                process = start(*words)
                writer = self.feed(process, text, lambda: os.path.exists(out)
                                   and content(out).count(b"\n") >= lines)
                code, _, err = self.end(process, number, writer)
                self.assertEqual(code, -number)
                found = content(out)
                self.assertTrue(expected.startswith(found))
                self.assertEqual(found[-1:], b"\n")
                self.assertEqual(len(err.splitlines()), 1, err)
                self.assertIn("--resume", err)
                self.assertEqual(int(re.search(r"with (\d+) results", err).group(1)),
                                 found.count(b"\n"))
                for name, proof in files_in(proofs).items():
                    self.assertEqual(proof, expected_proofs[name], name)
                self.assertEqual(stickslip(*words, "--resume", stdin=text), (DONE, "", ""))
                self.assertEqual(content(out), expected)
                self.assertEqual(files_in(proofs), expected_proofs)

    def test_batch_to_standard_output(self):
        process = start("batch", "-")
        writer = self.feed(process, json.dumps(grasp(1)) + "\n", lambda: True)
        first = process.stdout.readline()
        self.assertEqual(json.loads(first)["verdict"], "stable")
        code, out, err = self.end(process, signal.SIGTERM, writer)
        self.assertEqual((code, out), (-signal.SIGTERM, ""))
        self.assertEqual(len(err.splitlines()), 1)
        self.assertIn("--output", err)

    def test_reader_of_a_batch_goes_away(self):
        path = self.write("grasps.jsonl", "".join(json.dumps(grasp(seed)) + "\n"
                                                  for seed in range(2000)))
        proofs = self.path("proofs")
        process = start("batch", path, "--certificates", proofs)
        process.stdout.readline()
        process.stdout.close()
        process.stdin.close()
        self.assertEqual(process.stderr.read(), "")
        process.stderr.close()
        self.assertEqual(process.wait(timeout=120), -signal.SIGPIPE)
        for name in files_in(proofs):
            self.assertRegex(name, r"^line-\d+\.json$")

    def test_crosscheck_saves_both_files_or_none(self):
        text = (json.dumps(WRONG_UNSTABLE) + "\n") * 150
        reference = self.path("reference")
        stickslip("crosscheck", "-", "--save", reference, stdin=text)
        expected = files_in(reference)
        for number in SIGNALS:
            for files in (1, 2, 9, 61):
                saved = self.path(f"saved-{number}-{files}")
                process = start("crosscheck", "-", "--save", saved)
                writer = self.feed(process, text, lambda: os.path.exists(saved)
                                   and len(os.listdir(saved)) >= files)
                code, _, _ = self.end(process, number, writer)
                self.assertEqual(code, -number)
                found = files_in(saved)
                for name, data in found.items():
                    self.assertEqual(data, expected[name])
                stems = [re.sub(r"\.(grasp|certificate)\.json$", "", name) for name in found]
                for stem in stems:
                    self.assertEqual(stems.count(stem), 2, stem)

    def test_a_large_file_is_the_old_one_or_the_new(self):
        # The name stands in the file that is written.
        path = self.write("g.json", {**grasp(1), "name": "n" * 30_000_000})
        target = self.path("out/big.smt2")
        os.makedirs(os.path.dirname(target))
        words = ("export", path, "--smt2", "-o", target)
        self.assertEqual(stickslip(*words), (DONE, "", ""))
        new, old = content(target), b"old"
        replaced = 0
        for number in SIGNALS * 2:
            with open(target, "wb") as file:
                file.write(old)
            process = start(*words)
            while process.poll() is None and len(os.listdir(os.path.dirname(target))) == 1:
                pass  # until the temporary file is there
            code, out, err = self.end(process, number)
            self.assertIn(code, (DONE, -number))
            self.assertEqual((out, err), ("", ""))
            self.assertEqual(os.listdir(os.path.dirname(target)), ["big.smt2"])
            self.assertIn(content(target), (old, new))
            replaced += content(target) == new
        self.assertGreater(replaced, 0)  # else no signal came as late as it should

    def test_waiting_for_input(self):
        for number in SIGNALS:
            for words in (("decide", "-", "--certificate", self.path("c.json")),
                          ("margin", "-", "--direction", "0,1,0"),
                          ("plot", "grasp", "-", "-o", self.path("p.svg"))):
                code, out, err = self.end(start(*words), number)
                self.assertEqual((code, out, err), (-number, "", ""))
        self.assertEqual(os.listdir(self.folder), [])

    def test_ignored_signals_stay_ignored(self):  # nohup
        process = start("batch", "-", ignored=SIGNALS)
        writer = self.feed(process, json.dumps(grasp(1)) + "\n", lambda: True)
        process.stdout.readline()
        for number in SIGNALS:
            process.send_signal(number)
        writer.join()
        out, err = process.communicate(json.dumps(grasp(20)) + "\n", timeout=120)
        self.assertEqual((process.returncode, err), (DONE, ""))
        self.assertEqual(json.loads(out)["verdict"], "unstable")


class Unwritable(Case):
    def test_through_a_link_and_into_standard_output(self):
        path = self.write("g.json", grasp(1))
        stickslip("export", path, "--smt2", "-o", self.path("real.smt2"))
        os.symlink("later.smt2", self.path("link.smt2"))
        stickslip("export", path, "--smt2", "-o", self.path("link.smt2"))
        self.assertTrue(os.path.islink(self.path("link.smt2")))
        self.assertEqual(content(self.path("later.smt2")), content(self.path("real.smt2")))
        with open(self.path("out.txt"), "wb") as out:  # the shell's (echo first; stickslip ...) >
            out.write(b"first\n")
            out.flush()
            subprocess.run([STICKSLIP, "export", path, "--smt2", "-o", "/dev/stdout"], stdout=out,
                           check=True, timeout=120)
        self.assertEqual(content(self.path("out.txt")),
                         b"first\n" + content(self.path("real.smt2")))


if __name__ == "__main__":
    unittest.main()
