# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes of tolerances that people have, in space: normals within 2 degrees, friction within 5 %, positions within 1/60 of
the body's half size; and larger ones of friction, stiffness, preload and load alone."""

import os
import unittest

from test_cli import CORPUS, DONE, Case, checkers, quick_checker, read, stickslip

GRASPS = os.path.join(CORPUS, "..", "tolerances")


class Tolerances(Case):
    """Two jaws with four pads, four feet that are pushed, and a corner of floor and two walls, at 80 % of the load that they
    resist."""

    def test_all_of_a_box_is_proved_by_twists_that_move(self):
        # Two of the proofs go through stickslip-check alone: the other checkers take ten times as long, and judge the other two.
        for name, judges in (("jaws", quick_checker), ("jaws-unbalanced", quick_checker), ("feet", checkers), ("corner", checkers)):
            with self.subTest(name):
                self.proves(name, judges, "normal=0.035,friction=5%,position=1/60")

    def test_walls_are_close_to_the_equilibria_where_geometry_is_certain(self):
        # Six fingers around a ball: walls with room for tilted normals prove nothing of it.
        self.proves("fingers", quick_checker, "friction=20%,stiffness=20%,preload=10%,wrench=10%")

    def test_a_descent_finds_a_grasp_that_does_not_hold(self):
        # Corners at random nearly all hold, and proofs of all of the box fail for half a minute. The jaws lose their load only
        # where normals are turned by all that they may be, and then hold all but a part in 500 of it.
        for name in ("sides", "jaws-weak"):
            with self.subTest(name):
                self.fails(name)

    def test_what_is_held_far_away_alone_is_doubted_before_it_is_proved(self):
        # Newton's method finds no equilibrium of the middle, but the search does, two thousand lengths away.
        self.assertEqual(self.fails("jaws-far")["stats"]["pieces"], 0)

    def fails(self, name):
        file, folder = os.path.join(GRASPS, name + ".json"), self.path(name)
        answer = self.json("decide", file, "--uncertain", "normal=0.035,friction=5%,position=1/60", "--examples", folder)
        self.assertEqual(answer["verdict"], "fragile")
        for verdict in ("stable", "unstable"):
            files = [os.path.join(folder, f"{verdict}{end}") for end in (".json", ".certificate.json")]
            self.assertEqual(self.accepted(*files, verdict=verdict)["verdict"], verdict)
        return answer

    def proves(self, name, judges, uncertain):
        file, proof, words = os.path.join(GRASPS, name + ".json"), self.path("proof.json"), ("--uncertain", uncertain)
        code, _, err = stickslip("decide", file, *words, "--certificate", proof)
        self.assertEqual(code, DONE, err)
        self.judges = judges
        self.assertEqual(self.accepted(file, proof, *words, verdict="stable")["verdict"], "stable")
        self.assertIn('"moving"', read(proof))
        self.assertLess(len(read(proof)), 150_000)


if __name__ == "__main__":
    unittest.main()
