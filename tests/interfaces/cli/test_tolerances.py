# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes of tolerances that people have, in space: normals within 2 degrees, friction within 5 %, positions within 1/60 of
the body's half size."""

import os
import unittest

from test_cli import CORPUS, DONE, Case, read, stickslip

GRASPS = os.path.join(CORPUS, "..", "tolerances")


class Tolerances(Case):
    """Two jaws with four pads, four feet that are pushed, and a corner of floor and two walls, at 80 % of the load that they
    resist."""

    def test_all_of_a_box_is_proved_by_twists_that_move(self):
        words = ("--uncertain", "normal=0.035,friction=5%,position=1/60")
        for name in ("jaws", "jaws-unbalanced", "feet", "corner"):
            with self.subTest(name):
                file = os.path.join(GRASPS, name + ".json")
                proof = self.path("proof.json")
                code, _, err = stickslip("decide", file, *words, "--certificate", proof)
                self.assertEqual(code, DONE, err)
                self.accepted(file, proof, *words, verdict="stable")
                self.assertIn('"moving"', read(proof))
                self.assertLess(len(read(proof)), 150_000)


if __name__ == "__main__":
    unittest.main()
