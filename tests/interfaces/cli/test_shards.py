# SPDX-License-Identifier: GPL-3.0-or-later
"""stickslip batch --shard and --merge: together they are the batch, and nothing else passes for it."""

import json
import os
import shutil
import signal
import subprocess
import unittest

from test_batch import grasp
from test_cli import BAD_INPUT, DONE, SANITIZED, STICKSLIP, UNDECIDED, Case, read, run, stickslip


def text_of(seeds):
    return "".join(json.dumps(grasp(seed)) + "\n" for seed in seeds)


class Shards(Case):
    def batch(self, path, *options, code=DONE):
        """The results without shards."""
        found, out, _ = stickslip("batch", path, *options)
        self.assertEqual(found, code)
        return out

    def shards(self, path, count, *options, prefix="shard"):
        """The files of all shards."""
        names = []
        for index in range(1, count + 1):
            names.append(self.path(f"{prefix}-{index}.jsonl"))
            if os.path.exists(names[-1]):
                os.remove(names[-1])
            found, out, _ = stickslip("batch", path, "--shard", f"{index}/{count}", "-o",
                                      names[-1], *options)
            self.assertIn((found, out), [(code, "") for code in (DONE, BAD_INPUT, UNDECIDED)])
        return names

    def merged(self, names, code=DONE):
        found, out, _ = stickslip("batch", "--merge", *names)
        self.assertEqual(found, code)
        return out

    def test_merged_shards_are_the_batch(self):
        good = text_of([3])
        texts = [text_of(range(20)), text_of(range(20))[:-1], "", "\n \n", good, good[:-1],
                 "\n\n" + text_of(range(5)) + "\n" * 700 + text_of([7]) + "\n \n",
                 good + "{\n" + "\r\n" + good.replace("\n", "\r\n") + "x" * 3000 + "\n" + good]
        for text in texts:
            path = self.write("grasps.jsonl", text)
            code, whole, complaint = stickslip("batch", path)
            for count in (1, 3) if SANITIZED else (1, 2, 3, 7, 50):
                names = self.shards(path, count)
                found, out, err = stickslip("batch", "--merge", *reversed(names))
                self.assertEqual((found, out), (code, whole), (text, count))
                self.assertEqual(err, complaint.replace(path, "<stdout>"))

    def test_each_line_is_in_one_shard_and_has_the_number_that_it_has_in_the_file(self):
        path = self.write("grasps.jsonl", text_of([1] * 40))
        numbers = []
        for name in self.shards(path, 4):
            head, *results = read(name).splitlines()
            found = [json.loads(line)["line"] for line in results]
            self.assertEqual(len(found), json.loads(head)["results"])
            self.assertGreater(len(found), 5)
            numbers += found
        self.assertEqual(numbers, list(range(1, 41)))

    def test_options_and_certificates(self):
        path, proofs = self.write("grasps.jsonl", text_of(range(8))), self.path("proofs")
        options = ("--wrench", "0,2,0", "--preload", "2", "--certificates", proofs)
        whole = self.batch(path, *options)
        before = {name: read(os.path.join(proofs, name)) for name in os.listdir(proofs)}
        self.assertEqual(len(before), 8)
        shutil.rmtree(proofs)
        self.assertEqual(self.merged(self.shards(path, 3, *options)), whole)
        self.assertEqual({name: read(os.path.join(proofs, name)) for name in os.listdir(proofs)},
                         before)

    def test_undecided(self):
        path = self.write("grasps.jsonl", text_of([20] * 6))
        whole = self.batch(path, "--node-limit", 1, code=UNDECIDED)
        self.assertEqual(self.merged(self.shards(path, 2, "--node-limit", 1), UNDECIDED), whole)

    def test_resume_after_every_interruption(self):
        path = self.write("grasps.jsonl", text_of(range(9)))
        _, name, _ = self.shards(path, 3)
        words = ("batch", path, "--shard", "2/3", "-o", name, "--resume")
        whole = read(name)
        for length in [0, 1, *range(7, len(whole), 41), len(whole) - 1, len(whole)]:
            self.write("shard-2.jsonl", whole[:length])
            self.assertEqual(stickslip(*words), (DONE, "", ""))
            self.assertEqual(read(name), whole, length)

    def test_a_killed_shard_goes_on(self):
        path = self.write("grasps.jsonl", text_of(range(400)))
        whole = self.batch(path)
        names = self.shards(path, 2)
        os.remove(names[1])
        process = subprocess.Popen([STICKSLIP, "batch", path, "--shard", "2/2", "-o", names[1]])
        while process.poll() is None and not (os.path.exists(names[1]) and read(names[1])):
            pass
        os.kill(process.pid, signal.SIGKILL)
        process.wait(timeout=60)
        stickslip("batch", path, "--shard", "2/2", "-o", names[1], "--resume")
        self.assertEqual(self.merged(names), whole)

    def test_other_questions_are_not_resumed(self):
        path = self.write("grasps.jsonl", text_of(range(9)))
        one, two, _ = self.shards(path, 3)
        self.fails("batch", path, "--shard", "1/3", "-o", one, naming=["exists", "--resume"])
        for words in ((path, "--shard", "1/3", "-o", two), (path, "--shard", "2/4", "-o", two),
                      (path, "--shard", "2/3", "-o", two, "--preload", "2")):
            self.fails("batch", *words, "--resume", naming=[two, "line 1", "not the head"])
        self.fails("batch", path, "-o", two, "--resume", naming=["not a result of a batch"])
        self.write("whole.jsonl", self.batch(path))
        self.fails("batch", path, "--shard", "1/3", "-o", self.path("whole.jsonl"), "--resume",
                   naming=["not the head of a shard"])

    def refused(self, names, *naming):
        out = self.path("refused.jsonl")
        self.fails("batch", "--merge", *names, "-o", out, naming=naming)
        self.assertFalse(os.path.exists(out))

    def test_what_is_not_all_of_one_batch_is_refused_by_name(self):
        path = self.write("grasps.jsonl", text_of(range(9)))
        one, two, three = self.shards(path, 3)
        self.refused([one, three], "missing: shard 2/3")
        self.refused([two], "missing: shard 1/3, 3/3")
        copy = self.write("copy.jsonl", read(two))
        self.refused([one, two, copy, three], "copy.jsonl", "shard 2/3", "so is", "shard-2.jsonl")
        self.refused([one, two, two, three], "each shard once")
        self.refused([one, two, three, self.path("none.jsonl")], "none.jsonl", "cannot open")
        self.refused([one, "-", three], "standard input")

        other = self.shards(path, 4, prefix="other")
        self.refused([one, other[1], three], "other-2.jsonl", "2/4", "1/3")
        other = self.shards(path, 3, "--preload", "2", prefix="other")
        self.refused([one, other[1], three], "other-2.jsonl", "options")
        other = self.shards(path, 3, "--certificates", self.path("proofs"), prefix="other")
        self.refused([one, two, other[2]], "other-3.jsonl", "options")

        results = self.write("whole.jsonl", self.batch(path))
        self.refused([one, results, three], "whole.jsonl", "line 1", "not the head")
        self.refused([one, path, three], "grasps.jsonl", "not the head")

    def test_shards_of_another_file_of_the_same_length_are_refused(self):
        path = self.write("grasps.jsonl", text_of(range(9)))
        names = self.shards(path, 3)
        other = self.write("other.jsonl", read(path).replace('"0/10"', '"9/10"')
                           .replace('"4/10"', '"9/10"').replace('"8/10"', '"9/10"'))
        others = self.shards(other, 3, prefix="other")
        self.assertEqual(os.path.getsize(path), os.path.getsize(other))
        for i in range(3):
            mixed = [*names[:i], others[i], *names[i + 1:]]
            if i == 2:  # also that of the other file, whose first parts are different
                mixed = [*others[:2], names[2]]
            self.refused(mixed, "another file")

    def test_what_is_incomplete_or_changed_is_refused(self):
        path = self.write("grasps.jsonl", text_of(range(9)))
        one, two, three = self.shards(path, 3)
        whole = read(two)
        head, *results = whole.splitlines(keepends=True)
        for text, *naming in (
                ("", "no results"), (head[:-1], "no results"),
                (head, "incomplete", "0 of its", "--resume"),
                (whole[:-1], "incomplete"), (whole[:-9], "incomplete"),
                (whole + results[-1], "does not belong"), (whole + "{", "incomplete"),
                (head + "".join(reversed(results)), "line 3", "does not belong"),
                (head + read(three).split("\n", 1)[1], "does not belong"),
                (head + "{}\n", "line 2", "not a result"),
                (whole.replace('"verdict":"', '"verdict":"un', 1), "line 2", "not as a batch has written it", "--resume"),
                (head.replace('"first_line":', '"first_line": '), "not the head"),
                (whole[1:], "not the head")):
            broken = self.write("broken.jsonl", text)
            self.refused([one, broken, three], "broken.jsonl", *naming)

    def test_output(self):
        path = self.write("grasps.jsonl", text_of(range(9)))
        whole, names, out = self.batch(path), self.shards(path, 2), self.path("out.jsonl")
        self.assertEqual(stickslip("batch", "-o", out, "--merge", *names), (DONE, "", ""))
        self.assertEqual(read(out), whole)
        self.fails("batch", "--merge", *names, "-o", out, naming=["exists"])
        self.fails("batch", "--merge", *names, "-o", names[0], naming=["exists"])
        self.assertEqual(read(out), whole)
        if os.path.exists("/dev/full"):
            self.fails("batch", "--merge", *names, "-o", "/dev/full", naming=["No space left"])
            self.fails("batch", path, "--shard", "1/2", "-o", "/dev/full", naming=["No space left"])

    def test_usage(self):
        path = self.write("grasps.jsonl", text_of([1]))
        for value in ("0/3", "4/3", "1", "/", "1/", "/1", "a/b", "1/2/3", "-1/2", "1.5/2", "1/0"):
            self.fails("batch", path, f"--shard={value}", naming=["--shard", "2/4"])
        code, _, err = stickslip("batch", "-", "--shard", "1/2", stdin=text_of([1]))
        self.assertEqual(code, BAD_INPUT)
        self.assertIn("<stdin>: --shard: this is not a file", err)
        self.fails("batch", path, "--merge", path, naming=["--merge", "nothing else"])
        self.fails("batch", "--shard", "1/2", "--merge", path, naming=["--merge", "--shard"])
        self.fails("batch", "--shard", "1/2", naming=["GRASPS"])

    @unittest.skipUnless(shutil.which("parallel"), "no GNU parallel")
    def test_gnu_parallel(self):
        """The command lines of docs/batch.md."""
        path = self.write("grasps.jsonl", text_of(range(60)) + "{\n")
        whole = self.batch(path, code=BAD_INPUT)
        command = f"{STICKSLIP} batch {path} --shard {{}}/4 -o {self.folder}/shard-{{}}.jsonl --resume"
        log = self.path("joblog")
        run("parallel", "--will-cite", "--joblog", log, command, ":::", 1, 2, 3, 4)
        codes = [int(line.split("\t")[6]) for line in read(log).splitlines()[1:]]
        self.assertEqual(sorted(codes), [DONE] * 3 + [BAD_INPUT])  # the last line is unreadable
        names = [self.path(f"shard-{i}.jsonl") for i in range(1, 5)]
        self.assertEqual(self.merged(names, BAD_INPUT), whole)
        self.write("shard-3.jsonl", read(names[2])[:500])  # as a killed job leaves it
        run("parallel", "--will-cite", command, ":::", 1, 2, 3, 4)
        self.assertEqual(self.merged(names, BAD_INPUT), whole)


if __name__ == "__main__":
    unittest.main()
