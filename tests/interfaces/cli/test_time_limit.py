# SPDX-License-Identifier: GPL-3.0-or-later
"""--time-limit: what is answered when the time is over is true, and proved. No test asserts a time. A limit of a millionth of a
second ends work where it first asks for the time, so that what is said then is the same on every machine."""

import json
import os
import pty
import subprocess
import unittest
from fractions import Fraction as F

import test_quality
from test_cli import DONE, FIG1, STICKSLIP, UNDECIDED, Case, read, stickslip
from test_preload import pinch as held_pinch
from test_quality import HAND, sled

EXAMPLES = os.path.join(os.path.dirname(FIG1), "..", "..", "..", "..", "examples", "grasps")
CUP = os.path.join(EXAMPLES, "space-cup.json")
AT_ONCE = ("--time-limit", "0.000001")
SOON = ("--time-limit", "1/5")
BOX = ("--uncertain", "normal=1/30,friction=5%,position=1/60")  # many seconds


class TimeLimit(Case):
    judge = test_quality.Quality.judge
    quality = test_quality.Quality.quality

    def test_a_verdict_is_undecided_for_the_true_reason(self):
        for words in ([CUP, *BOX],):
            answer = self.json("decide", *words, *AT_ONCE, code=UNDECIDED)
            self.assertEqual((answer["verdict"], answer["reason"], answer["limit"]),
                             ("undecided", "time", "the time limit of 1e-6 s was over first"))
            code, out, err = stickslip("decide", *words, *AT_ONCE, "--certificate", self.path("no.json"))
            self.assertEqual(code, UNDECIDED)
            self.assertIn("Not decided: the time limit of 1e-6 s was over first.", out)
            self.assertIn("nothing is written", err)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_verdict_in_time_is_the_same(self):
        self.assertEqual(self.json("decide", FIG1, "--time-limit", "1000"), self.json("decide", FIG1))
        self.assertEqual(self.json("decide", FIG1, "--time-limit", "0"), self.json("decide", FIG1))

    def test_a_quality_lies_between_what_is_known(self):
        # As in test_quality: |horizontal force| = mu (W - force z).
        mu, weight = F(1, 5), 6
        file = self.write("g.json", sled(mu, weight))
        square = (mu * weight) ** 2 / (1 + mu ** 2)
        for limit in (AT_ONCE, SOON, ("--time-limit", "1")):
            code, out, _ = stickslip("quality", file, "--length", "1/4", *limit, "--json")
            answer = json.loads(out)
            self.assertEqual(code, UNDECIDED if answer["verdict"] == "undecided" else DONE)
            if limit == AT_ONCE:
                self.assertEqual(answer["ended_by"], "the time limit of 1e-6 s")
            self.assertLessEqual(F(answer["proved"]) ** 2, square)
            if "not_resisted_at" in answer:
                self.assertGreaterEqual(F(answer["not_resisted_at"]) ** 2, square)
            if code == DONE:
                self.quality(file, "--length", "1/4", *limit)  # whatever it knows, the checkers accept

    def test_pictures_show_what_is_known(self):
        for words, code in ((("grasp", CUP, "--wrench", "0,0,-1,0,0,0"), DONE), (("quality", CUP, "--wrench", "0,0,-1,0,0,0"), DONE),
                            (("region", CUP), DONE), (("region", FIG1), UNDECIDED)):
            file = self.path("picture.svg")
            found, out, err = stickslip("plot", *words, *AT_ONCE, "-o", file)
            self.assertEqual((found, out), (code, ""), words)
            if words == ("region", FIG1):
                self.assertIn("no region is known: the time limit of 1e-6 s was over first", err)
                continue
            self.assertIn("</svg>", read(file))
            if words[0] == "quality":
                self.assertIn("quality 0 or more", read(file))  # the load alone holds at rest
            os.remove(file)

    def test_a_radius_agrees_with_one_that_takes_longer(self):
        words = ("radius", FIG1, "--uncertain", "friction=10%,wrench=5%,position=1/100,stiffness=5%")
        full = self.json(*words)
        for limit in (AT_ONCE, SOON):
            folder = self.path("proofs" + limit[1].replace("/", "_"))
            code, out, _ = stickslip(*words, *limit, "--json", "--certificates", folder)
            answer = json.loads(out)
            self.assertEqual(code, UNDECIDED if answer["verdict"] == "undecided" else DONE)
            # Both contain the radius.
            if answer.get("refuted"):
                self.assertLess(F(full["proved"]), F(answer["refuted"]))
            if full.get("refuted"):
                self.assertLess(F(answer["proved"]), F(full["refuted"]))
            for name in os.listdir(folder) if code == DONE else ():
                if not name.endswith(".certificate.json"):
                    proof = os.path.join(folder, name[:-len(".json")] + ".certificate.json")
                    self.accepted(os.path.join(folder, name), proof)

    def test_preloads_lie_above_the_bound(self):
        # Two fingers of friction mu carry a weight W with W / (2 mu) each.
        mu, weight = F(2, 5), 3
        file = self.write("g.json", held_pinch(weight, mu, mu))
        for limit in (AT_ONCE, SOON):
            code, out, _ = stickslip("preload", file, "--hold", *limit, "--json")
            answer = json.loads(out)
            self.assertLessEqual(F(answer["bound"]), weight / mu)
            if answer["preloads"] is None:
                self.assertEqual(code, UNDECIDED)
            else:
                self.assertEqual(code, DONE)
                self.assertGreaterEqual(sum(map(F, answer["preloads"])), weight / mu)
        answer = self.json("preload", file, "--budget", "10", *AT_ONCE, code=UNDECIDED)
        self.assertEqual((answer["preloads"], answer["ended_by"]), (None, "the time limit of 1e-6 s"))
        code, out, _ = stickslip("preload", file, "--budget", "10", *AT_ONCE)
        self.assertEqual(code, UNDECIDED)
        self.assertIn("Ended by the time limit of 1e-6 s", out)

    def test_cells_tile_the_map(self):
        # A pinch with preloads P holds a weight up to 2 mu P: here mu and P from 0 to 2, and a weight of 1.
        file = self.write("g.json", held_pinch(1, 1, 1))
        for limit in (AT_ONCE, SOON, ("--time-limit", "20")):
            answer = self.json("map", file, "--preload", "1", "--x", "friction=0:2", "--y", "preload=0:2", "--depth", "5", *limit)
            area = 0
            for cell in answer["cells"]:
                x, y = ([F(v) for v in cell[axis]] for axis in "xy")
                area += (x[1] - x[0]) * (y[1] - y[0])
                if cell["verdict"] == "stable":
                    self.assertGreaterEqual(2 * x[0] * y[0], 1)
                elif cell["verdict"] == "unstable":
                    self.assertLess(2 * x[1] * y[1], 1)
            self.assertEqual(area, 4)
            # Cells that are not the finest are left undecided by the limit alone.
            left = [cell for cell in answer["cells"] if cell["verdict"] == "undecided" and F(cell["x"][1]) - F(cell["x"][0]) > F(2, 32)]
            self.assertTrue(not left or "ended_by" in answer)
            self.assertTrue(left or limit != AT_ONCE)

    def test_margins(self):
        _, out, err = stickslip("margin", FIG1, "--direction", "0,1,0", *AT_ONCE)
        self.assertEqual((out, err), ("", "stickslip: the margin is not known: the time limit of 1e-6 s was over first; "
                                          "a longer one may decide it\n"))
        # A claim holds at multiples inside it.
        words = ("margin", CUP, "--direction", "0,0,-1,0,0,0")
        for limit in (AT_ONCE, ("--time-limit", "1")):
            proof = self.path("margin.json")
            code, out, _ = stickslip(*words, *limit, "--json", "--certificate", proof)
            answer = json.loads(out)
            self.assertEqual(code, DONE if answer["resisted"] or answer["refuted"] else UNDECIDED)
            if limit == AT_ONCE:
                self.assertIn("ended_by", answer)
            for low, high in answer["resisted"]:
                multiple = F(low) if high is None else (F(low) + F(high)) / 2
                load = f"0,0,{-multiple},0,0,0"
                self.assertEqual(self.json("decide", CUP, "--wrench", load)["verdict"], "stable")
            if code == DONE:
                self.accepted(CUP, proof, "--direction", "0,0,-1,0,0,0", "--wrench", "0,0,0,0,0,0")

    def test_other_commands_say_that_it_was_the_time(self):
        said = "the time limit of 1e-6 s was over first"
        answer = self.json("region", FIG1, *AT_ONCE, code=UNDECIDED)
        self.assertEqual(answer["undecided"]["reason"] if "undecided" in answer else answer["reason"], "time")
        code, _, err = stickslip("states", FIG1, *AT_ONCE)
        self.assertEqual(code, UNDECIDED)
        self.assertIn(said, err)

    def test_methods_of_which_nothing_is_known_are_not_computed(self):
        for row in self.json("compare", CUP, *AT_ONCE)["methods"]:
            self.assertEqual((row["verdict"], row["agrees"]), ("not computed", None))
            self.assertTrue(row["why"].startswith("the time limit of 1e-6 s was over first"), row["why"])
        words = ("--max-force", "10", "--methods", "potential-grasp-robustness", "--certificate", self.path("no.json"))
        _, _, err = stickslip("compare", CUP, *words, *AT_ONCE)
        self.assertIn("nothing is written", err)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_batch_ends_between_lines_and_goes_on(self):
        lines = "".join(json.dumps(json.loads(read(FIG1))) + "\n" for _ in range(3000))
        grasps, whole, part = self.write("g.jsonl", lines), self.path("whole.jsonl"), self.path("part.jsonl")
        stickslip("batch", grasps, "-o", whole)
        code, _, err = stickslip("batch", grasps, "-o", part, *AT_ONCE)
        self.assertEqual(code, UNDECIDED)
        self.assertRegex(err, r"\Astickslip: ended by the time limit of 1e-6 s with \d+ results in .* and --resume\n\Z")
        self.assertTrue(read(whole).startswith(read(part)))
        self.assertLess(len(read(part)), len(read(whole)))
        stickslip("batch", grasps, "-o", part, "--resume")
        self.assertEqual(read(part), read(whole))

    def test_words(self):
        for bad in ("-1", "86401", "soon"):
            self.fails("decide", FIG1, "--time-limit=" + bad, naming=["--time-limit"])

    def shown(self, *words):
        """What a terminal shows until the work is ended."""
        master, terminal = pty.openpty()
        with subprocess.Popen([STICKSLIP, *words], stdout=subprocess.DEVNULL, stderr=terminal) as program:
            os.close(terminal)
            shown = b""
            try:
                while b" s\r" not in shown.replace(b"\x1b[K", b"\r") and b" s" not in shown[-3:]:
                    shown += os.read(master, 1000)
            finally:
                program.kill()
        os.close(master)
        return shown.decode()

    def test_progress_on_a_terminal(self):
        # A line comes after a second; each of these takes many.
        self.assertRegex(self.shown("quality", HAND, "--body", "disc"), r"quality: proved up to [^\r]*, \d+ s")
        self.assertRegex(self.shown("map", CUP, "--x", "friction=0:2", "--y", "load=0:2", "--time-limit", "300"),
                         r"map: \d+ % of the area, \d+ cells, \d+ of 300 s")


if __name__ == "__main__":
    unittest.main()
