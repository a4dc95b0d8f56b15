# SPDX-License-Identifier: GPL-3.0-or-later
"""The first minutes: the program without arguments, and grasps to start from."""

import json
import os
import re
import unittest

from test_cli import DONE, HERE, Case, read, stickslip

ROOT = os.path.join(HERE, "..", "..", "..")
FOLDERS = [os.path.join(ROOT, "examples", "grasps"), os.path.join(ROOT, "paper_examples", "grasps")]


class Examples(Case):
    def names(self):
        code, out, err = stickslip("example")
        self.assertEqual((code, err), (DONE, ""))
        return [line.split()[0] for line in out.split("\n\n")[0].splitlines()[1:]]

    def test_they_are_the_files(self):
        files = {name[:-len(".json")]: os.path.join(folder, name)
                 for folder in FOLDERS for name in os.listdir(folder)}
        self.assertEqual(sorted(self.names()), sorted(files))
        for name, path in files.items():
            self.assertEqual(stickslip("example", name), (DONE, read(path), ""))

    def test_each_has_a_verdict_and_a_proof(self):
        for name in self.names():
            grasp, proof = self.path(name + ".json"), self.path("proof.json")
            self.assertEqual(stickslip("example", name, "-o", grasp), (DONE, "", ""))
            if json.loads(read(grasp)).get("cases"):
                continue
            code, _, err = stickslip("decide", grasp, "--certificate", proof)
            self.assertEqual((code, err), (DONE, ""), name)
            self.accepted(grasp, proof)

    def test_more_friction_breaks_it(self):
        grasp = json.loads(stickslip("example", "more-friction-breaks")[1])
        for friction, verdict in ((0, "stable"), ("1/2", "stable"), ("0.5001", "unstable"),
                                  (1, "unstable")):
            grasp["contacts"][2]["friction"] = friction
            self.assertEqual(self.json("decide", "-", stdin=json.dumps(grasp))["verdict"], verdict)

    def test_unknown(self):
        self.fails("example", "jaws", naming=['no example "jaws"', 'did you mean "jaw"?', "fig4"])

    def test_nothing_to_do(self):
        code, out, err = stickslip()
        self.assertEqual((code, err), (DONE, ""))
        (line,) = re.findall(r"^  \$ (.*)$", out, re.MULTILINE)
        first, second = (words.split()[1:] for words in line.split(" | "))
        code, text, err = stickslip(*first)
        self.assertEqual((code, err), (DONE, ""))
        self.assertIn("stable", stickslip(*second, stdin=text)[1])
        for command in ("decide", "margin", "plot", "example"):
            self.assertRegex(out, rf"(?m)^  {command}  ")


if __name__ == "__main__":
    unittest.main()
