# SPDX-License-Identifier: GPL-3.0-or-later
"""stickslip batch: order, bad lines, resuming, certificates."""

import json
import os
import random
import unittest

from test_cli import BAD_INPUT, CHECK, DONE, UNDECIDED, Case, run, stickslip


def grasp(seed):
    """Fig. 1 with another load each time; stable up to w_y = 1."""
    return {"format": "stickslip-grasp/1", "name": f"number {seed}",
            "defaults": {"friction": "1/2", "preload": 1},
            "contacts": [{"position": [-1, 0], "normal": [1, 0]},
                         {"position": [0, -1], "normal": [0, 1]},
                         {"position": [1, 0], "normal": [-1, 0]}],
            "wrench": [0, f"{seed}/10", 0]}


def expected(seed):
    return "stable" if seed <= 10 else "unstable"


class Batch(Case):
    def lines(self, seeds, bad=()):
        text = "".join(json.dumps(grasp(seed)) + "\n" for seed in seeds)
        return self.write("grasps.jsonl", text)

    def results(self, *words, code=DONE, stdin=None, said=""):
        found, out, err = stickslip("batch", *words, stdin=stdin)
        self.assertEqual((found, err), (code, said))
        return [json.loads(line) for line in out.splitlines()]

    def test_results_are_in_order_and_right(self):
        seeds = [random.Random(1).randint(0, 20) for _ in range(300)]
        path = self.lines(seeds)
        results = self.results(path)
        self.assertEqual([r["line"] for r in results], list(range(1, 301)))
        self.assertEqual([r["verdict"] for r in results], [expected(s) for s in seeds])
        self.assertEqual([r["name"] for r in results], [f"number {s}" for s in seeds])
        for threads in (1, 3, 8):
            self.assertEqual(self.results(path, "--threads", threads), results)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(self.results("-", stdin=file.read()), results)

    def test_options_apply_to_every_line(self):
        path = self.lines([0, 20])
        self.assertEqual([r["verdict"] for r in self.results(path, "--wrench", "0,1/2,0")],
                         ["stable", "stable"])
        self.assertEqual([r["verdict"] for r in
                          self.results(path, "--wrench", "0,1/2,0", "--preload", 0)],
                         ["unstable", "unstable"])

    def test_classes_in_place_of_verdicts(self):
        floor = {"format": "stickslip-grasp/1", "defaults": {"friction": "1/2"},
                 "contacts": [{"position": [side, -1], "normal": [0, 1]} for side in (-1, 1)]}
        loads = ([0, -1, 0], ["1/2", -1, 0], ["1/2", "-0.999", 0])
        path = self.write("floors.jsonl", "".join(
            json.dumps({**floor, "wrench": load}) + "\n" for load in loads))
        results = self.results(path, "--class")
        self.assertEqual([r["class"] for r in results], ["must hold", "must hold", "must move"])
        self.assertEqual(set(results[0]), {"line", "key", "name", "class"})
        moved = self.results(path, "--class", "--inertia", "0,1,2")
        self.assertNotEqual(results[0]["key"], moved[0]["key"])
        self.fails("batch", path, "--inertia", "0,0,1", naming=["--class"])
        self.fails("batch", path, "--class", "--inertia", "0,0,0", naming=["--inertia"])
        proved = self.results(path, "--class", "--inertia", "0,1,2", "--certificates", self.path("proofs"))
        for load, result in zip(loads, proved):
            one = self.write("floor.json", {**floor, "wrench": load})
            code, out, err = run(CHECK, one, result["certificate"], "--inertia", "0,1,2")
            self.assertEqual(code, DONE, out + err)
            self.assertIn(f"verdict     {result['class']}\n", out)

    def test_space_and_boxes_among_others(self):
        """Two fingers press with 1 each, friction 1/2: in space as in the plane they hold 1, and no more."""
        def pinch(friction, load, in_space):
            zero = [0] if in_space else []
            return {"format": "stickslip-grasp/2",
                    "contacts": [{"position": [side, 0, *zero], "normal": [-side, 0, *zero], "preload": 1,
                                  "friction": friction} for side in (-1, 1)],
                    "wrench": [0, load, *zero, *zero, *zero, 0]}

        around = {"min": "49/100", "max": "51/100"}
        asked = [(friction, load, in_space) for in_space in (False, True)
                 for friction, load in (("1/2", "-99/100"), ("1/2", "-101/100"), (around, "-97/100"),
                                        (around, -1), (around, "-103/100"))]
        path = self.write("pinches.jsonl", "".join(json.dumps(pinch(*a)) + "\n" for a in asked))
        results = self.results(path, "--certificates", os.path.join(self.folder, "proofs"))
        self.assertEqual([r["verdict"] for r in results],
                         2 * ["stable", "unstable", "stable", "fragile", "unstable"])
        for a, result in zip(asked, results):
            self.assertEqual("certificate" in result, result["verdict"] != "fragile")
            if "certificate" in result:
                grasp = self.write("pinch.json", json.dumps(pinch(*a)))
                self.assertEqual(run(CHECK, grasp, result["certificate"])[0], DONE)
        weak = self.results(path, "--preload", "1/2", "--wrench", "0,-3/4,0,0,0,0", code=BAD_INPUT,
                            said=f"stickslip: {path}: 5 of 10 lines could not be read, the first is "
                                 "line 1; their results say why\n")
        self.assertEqual([r.get("verdict") for r in weak], 5 * [None] + 5 * ["unstable"])

    def test_bad_lines_are_reported_and_the_rest_goes_on(self):
        good = json.dumps(grasp(3))
        bad = ["{", "[]", json.dumps({**grasp(1), "wrench": [0, 0]}),
               json.dumps({**grasp(1), "colour": 1}), "\x00", good + good]
        text = "\n".join([good, *bad, "", good]) + "\n"
        results = self.results("-", code=BAD_INPUT, stdin=text, said=(
            "stickslip: <stdin>: 6 of 8 lines could not be read, the first is line 2; their "
            "results say why\n"))
        self.assertEqual([r["line"] for r in results], [1, 2, 3, 4, 5, 6, 7, 9])
        self.assertEqual([r.get("verdict") for r in results],
                         ["stable", *[None] * len(bad), "stable"])
        self.assertEqual(results[3]["error"]["place"], "wrench")
        self.assertIn("colour", results[4]["error"]["problem"])

    def test_undecided(self):
        results = self.results(self.lines([20, 0]), "--node-limit", 1, code=UNDECIDED)
        self.assertEqual(results[0]["verdict"], "undecided")
        self.assertIn("1 nodes", results[0]["limit"])

    def test_nothing(self):
        said = "stickslip: <stdin>: the file is empty, there is no grasp in it\n"
        self.assertEqual(self.results("-", stdin="\n \n", said=said), [])

    def test_resume_after_every_interruption(self):
        seeds = list(range(14))
        path = self.lines(seeds)
        out = self.path("out.jsonl")
        self.assertEqual(stickslip("batch", path, "-o", out), (DONE, "", ""))
        with open(out, "rb") as file:
            whole = file.read()
        for length in [0, 1, *range(7, len(whole), 97), len(whole) - 1, len(whole)]:
            with open(out, "wb") as file:
                file.write(whole[:length])
            self.assertEqual(stickslip("batch", path, "-o", out, "--resume"), (DONE, "", ""))
            with open(out, "rb") as file:
                self.assertEqual(file.read(), whole, length)

    def test_finished_lines_are_not_decided_again(self):
        path, out = self.lines([1, 2, 3]), self.path("out.jsonl")
        stickslip("batch", path, "-o", out)
        with open(out, encoding="utf-8") as file:
            marked = file.read().replace("number 1", "MARK")
        with open(out, "w", encoding="utf-8") as file:
            file.write("".join(line + "\n" for line in marked.splitlines()[:2]))
        stickslip("batch", path, "-o", out, "--resume")
        with open(out, encoding="utf-8") as file:
            results = [json.loads(line) for line in file]
        self.assertEqual([r["name"] for r in results], ["MARK", "number 2", "number 3"])

    def test_resumed_or_not_the_exit_code_is_that_of_all_lines(self):
        good, bad = json.dumps(grasp(20)), "{"
        for lines, options, code in (([good, bad, good], [], BAD_INPUT),
                                     ([good, good], ["--node-limit", 1], UNDECIDED)):
            path = self.write("mixed.jsonl", "\n".join(lines) + "\n")
            said = (f"stickslip: {path}: 1 of 3 lines could not be read, the first is line 2; "
                    "their results say why\n") if code == BAD_INPUT else ""
            out = self.path(f"out-{code}.jsonl")
            words = ["batch", path, "-o", out, *options]
            self.assertEqual(stickslip(*words), (code, "", said))
            self.assertEqual(stickslip(*words, "--resume"), (code, "", said))

    def test_other_questions_are_not_mixed(self):
        path, out = self.lines([1, 2, 3]), self.path("out.jsonl")
        stickslip("batch", path, "-o", out)
        with open(out, "rb") as file:
            before = file.read()
        self.fails("batch", path, "-o", out, naming=["exists", "--resume"])
        self.fails("batch", path, "-o", out, "--resume", "--preload", 2, naming=["options"])
        self.fails("batch", self.lines([1, 9, 3]), "-o", out, "--resume", naming=["line 2"])
        self.fails("batch", self.lines([1]), "-o", out, "--resume", naming=["not that of"])
        self.fails("batch", path, "-o", path, "--resume", naming=["the input"])
        other = self.write("other.jsonl", json.dumps(grasp(1)) + "\n")
        self.fails("batch", path, "-o", other, "--resume", naming=["not a result"])
        with open(out, "rb") as file:
            self.assertEqual(file.read(), before)

    def test_certificates_are_accepted(self):
        path, folder = self.lines([10, 11]), self.path("proofs")
        results = self.results(path, "--certificates", folder)
        for seed, result in zip((10, 11), results):
            file = self.write("g.json", grasp(seed))
            code, out, _ = run(CHECK, file, result["certificate"])
            self.assertEqual(code, DONE)
            self.assertIn(expected(seed), out)
        self.assertEqual(sorted(os.listdir(folder)), ["line-1.json", "line-2.json"])

    def test_a_certificate_that_cannot_be_written_ends_the_batch(self):
        path, folder, out = self.lines([1, 2]), self.path("proofs"), self.path("out.jsonl")
        os.makedirs(os.path.join(folder, "line-2.json"))  # a folder stands where the proof goes
        words = ["batch", path, "-o", out, "--certificates", folder]
        self.fails(*words, naming=["line-2.json"])
        os.rmdir(os.path.join(folder, "line-2.json"))
        self.assertEqual(stickslip(*words, "--resume"), (DONE, "", ""))
        with open(out, encoding="utf-8") as file:
            self.assertEqual([json.loads(line)["verdict"] for line in file], ["stable"] * 2)

    def test_usage(self):
        self.fails("batch", naming=["GRASPS"])
        self.fails("batch", self.path("none.jsonl"), naming=["none.jsonl", "cannot open"])
        self.fails("batch", self.folder, naming=["this is a directory"])
        self.fails("batch", self.lines([1]), "--resume", naming=["--output"])
        self.fails("batch", self.lines([1]), "-o", self.path("no/such/folder"),
                   naming=["cannot be written"])


if __name__ == "__main__":
    unittest.main()
