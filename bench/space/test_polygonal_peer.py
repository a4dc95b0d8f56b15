# SPDX-License-Identifier: GPL-3.0-or-later
"""The polygonal model of the peer, on grasps whose thresholds are known for polygons too."""

import json
import math
import os
import tempfile
import unittest

from polygonal_peer import peer, read


def verdict(contacts, wrench, **defaults):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "grasp.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump({"format": "stickslip-grasp/2", "defaults": defaults, "wrench": wrench,
                       "contacts": [{"position": p, "normal": n} for p, n in contacts]}, out)
        return peer(*read(file))[0]


class Polygon(unittest.TestCase):
    def test_a_tilted_table_holds_less_between_the_vertices_than_towards_one(self):
        feet = [([x, y, "-1/2"], [0, 0, 2]) for x, y in ((3, 2), (3, -2), (-3, 0))]
        for angle, most in ((0, 0.5), (math.pi / 8, 0.5 * math.cos(math.pi / 8))):
            for part, expected in ((0.99, "stable"), (1.01, "unstable")):
                slope = part * most
                load = [slope * math.cos(angle), slope * math.sin(angle), -1, 0, 0, 0]
                self.assertEqual(verdict(feet, load, friction="1/2"), expected, (angle, part))

    def test_a_pinch_needs_its_preload(self):
        hands = [([2 * side, 0, 0], [-side, 0, 0]) for side in (-1, 1)]
        for weight, preload, expected in ((2.39, 4, "stable"), (2.41, 4, "unstable"), (0.01, 0, "unstable")):
            self.assertEqual(verdict(hands, [0, 0, -weight, 0, 0, 0], friction=0.3, preload=preload),
                             expected, (weight, preload))

    def test_a_wedge_is_not_held_by_friction_along_its_slip(self):
        # Deeper in the wedge normal forces grow, and friction could balance any pull but for its sign.
        walls = [([-side, 0, 0], [4 * side, 0, 3]) for side in (-1, 1)]
        for pull, expected in ((0.399, "stable"), (0.401, "unstable")):
            self.assertEqual(verdict(walls, [0, 0, pull, 0, 0, 0], friction=1, preload=1), expected, pull)


if __name__ == "__main__":
    unittest.main()
