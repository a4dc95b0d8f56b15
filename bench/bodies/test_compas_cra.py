# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces that lie on each other, centres of mass and tilts, of blocks that are known."""

import math
import unittest
from fractions import Fraction as F

from compas_cra import Block, cubes, down, found, grasp_of


def prism(polygon):
    """Along y, from 0 to 2."""
    n = len(polygon)
    vertices = [[F(x), F(y), F(z)] for y in (0, 2) for x, z in polygon]
    sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return Block(vertices, [list(range(n))[::-1], list(range(n, 2 * n)), *sides])


class Geometry(unittest.TestCase):
    def test_cubes_meet_where_they_overlap(self):
        blocks, interfaces = cubes((0, 0, 0), (0.75, 0, 1))
        [(one, two, normal, corners)] = interfaces
        self.assertEqual((one, two), (0, 1))
        self.assertEqual(sorted(corners), [[F(x), F(y), F(1, 2)] for x in ("1/4", "1/2") for y in ("-1/2", "1/2")])
        self.assertTrue(normal[2] < 0 == normal[0] == normal[1])  # into the lower one
        grasp = grasp_of("", blocks, interfaces, (0,), "0.5", 0, {1: 3})
        self.assertEqual([(c["of"], "by" in c, F(c["normal"][2]) > 0) for c in grasp["contacts"]], [("b1", False, True)] * 4)
        self.assertEqual(grasp["loads"], [{"body": "b1", "weight": "3", "direction": ["0", "0", "-1"], "at": ["3/4", "0", "1"]}])

    def test_only_faces_against_each_other_meet(self):
        for place in ((1, 1, 0), (0, 0, 2), (0.25, 0, 0.5)):  # at an edge, apart, and one in the other
            self.assertEqual(cubes((0, 0, 0), place)[1], [])

    def test_faces_that_are_inclined(self):
        low, up = prism([(0, 0), (4, 0), (0, 3)]), prism([(4, 0), (2, 5), (0, 3)])
        self.assertEqual([block.volume for block in (low, up)], [12, 14])
        [(_, _, normal, corners)] = found({0: low, 1: up})
        self.assertEqual(sorted(corners), [[0, 0, 3], [0, 2, 3], [4, 0, 0], [4, 2, 0]])
        self.assertEqual([4 * normal[0], normal[1]], [3 * normal[2], 0])

    def test_the_centre_of_a_block_with_a_notch(self):
        block = prism([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
        self.assertEqual((block.volume, block.centre), (6, [F(5, 6), 1, F(5, 6)]))

    def test_a_weight_is_turned_and_has_the_length_1(self):
        for degrees in (0, 20, 48, 90):
            x, y, z = down(degrees)
            self.assertEqual((x * x + z * z, y), (1, 0))
            self.assertAlmostEqual(math.degrees(math.atan2(x, -z)), degrees, 6)


if __name__ == "__main__":
    unittest.main()
