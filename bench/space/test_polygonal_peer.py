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


def of_bodies(grasp):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "grasp.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump({"format": "stickslip-grasp/3", **grasp}, out)
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

    def test_the_upper_of_two_boxes_slides(self):
        # In space towards a vertex of the polygon, and between two.
        for dim, angle in ((2, 0), (3, 0), (3, math.pi / 8)):
            feet = [[-1], [1]] if dim == 2 else [[x, y] for x in (-1, 1) for y in (-1, 1)]
            contacts = [{"of": of, **({"by": by} if by else {}), "position": [*foot, height], "normal": [*[0] * (dim - 1), 1]}
                        for of, by, height in (("low", None, 0), ("up", "low", 1)) for foot in feet]
            for part, expected in ((0.99, "stable"), (1.01, "unstable")):
                push = part * 0.5 * math.cos(angle)
                way = [push] if dim == 2 else [push * math.cos(angle), push * math.sin(angle)]
                loads = [{"body": b, "weight": 1, "at": [*[0] * (dim - 1), z]} for b, z in (("low", 0), ("up", 1))]
                self.assertEqual(of_bodies({"bodies": [{"name": "low"}, {"name": "up"}], "defaults": {"friction": 0.5},
                                            "contacts": contacts, "loads": [*loads, {"body": "up", "force": [*way, 0],
                                                                                     "at": [*[0] * (dim - 1), 1]}]}),
                                 expected, (dim, angle, part))

    def test_a_tendon_and_a_ratchet(self):
        # Fingers hold a disc of weight 1 with a tendon's pull above 5/2 (tests/interfaces/cli/test_bodies.py); a ratchet pushes only.
        for tension, expected in ((2.49, "unstable"), (2.51, "stable")):
            self.assertEqual(of_bodies({
                "bodies": [{"name": "disc"}, {"name": "l", "hinge": [-2, -2]}, {"name": "r", "hinge": [2, -2]}],
                "joints": [{"turns": {"l": -1, "r": 1}}], "tendons": [{"over": {"l": -1, "r": 1}, "tension": tension}],
                "contacts": [{"of": "disc", "by": by, "position": [s, 0], "normal": [-s, 0], "friction": "1/3",
                              "stiffness": 1000} for by, s in (("l", -1), ("r", 1))],
                "loads": [{"body": "disc", "weight": 1, "at": [0, 0]}]}), expected, tension)
        for force, expected in ((-5, "stable"), (0.1, "unstable")):
            self.assertEqual(of_bodies({
                "bodies": [{"name": "l", "slide": [0, 1]}], "joints": [{"turns": {"l": 1}}],
                "ratchets": [{"over": {"l": 1}, "stiffness": 3}], "contacts": [],
                "loads": [{"body": "l", "force": [0, force], "at": [0, 0]}]}), expected, force)


if __name__ == "__main__":
    unittest.main()
