# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that lie on each other, weights and tilts, of blocks that are known."""

import math
import unittest
from fractions import Fraction as F

from compas_cra import arch, assembly_of, cubes, down, least_of


class Geometry(unittest.TestCase):
    def test_cubes_meet_where_they_overlap(self):
        grasp = assembly_of("", "", cubes((0, 0, 0), (0.75, 0, 1)), (0,), "0.5", 0, {1: 3})
        self.assertEqual(sorted(grasp.positions), [(F(x), F(y), F(1, 2)) for x in ("1/4", "1/2") for y in ("-1/2", "1/2")])
        self.assertEqual((set(grasp.normals), set(grasp.contact_bodies)), ({(0, 0, 1)}, {("1", "ground")}))
        self.assertEqual(grasp.wrench, (0, 0, -3, 0, F(9, 4), 0))

    def test_an_arch_has_four_contacts_at_each_joint(self):
        grasp = assembly_of("", "", arch(), (0, 19), "0.7", 0, {})
        self.assertEqual((len(grasp.bodies), len(grasp)), (18, 4 * 19))
        weight = (5.5**2 - 5**2) * 0.5 * math.sin(math.pi / 20) / 2  # of a stone with straight sides
        for w in grasp.wrench[2::6]:
            self.assertAlmostEqual(float(w), -weight, 4)

    def test_a_weight_is_turned_and_has_the_length_1(self):
        for degrees in (0, 20, 48, 90):
            x, y, z = down(degrees)
            self.assertEqual((x * x + z * z, y), (1, 0))
            self.assertAlmostEqual(math.degrees(math.atan2(x, -z)), degrees, 6)

    def test_the_least_coefficient_is_of_the_factor(self):
        self.assertEqual(least_of({"least_friction": {"low": "1/2", "high": "3/4"}}, "0.8"), "0.6")
        self.assertEqual(least_of({"least_friction": None}, "0.5"), "none")


if __name__ == "__main__":
    unittest.main()
