# SPDX-License-Identifier: GPL-3.0-or-later
"""The outline of the body, where the grasp file has one, in every picture that shows the grasp."""

import json
import unittest

import pictures
from pictures import Picture, contains, stickslip, subpaths

RINGS = [[(0, 0), (4, 0), (4, 3), (0, 3)], [(1, 1), (3, 1), (3, 2), (1, 2)], [(6, 0), (5, 0), (5, 2)]]
FRAME = {"format": "stickslip-grasp/2", "wrench": [0, -1, 0], "defaults": {"friction": "1/2", "preload": 1},
         "outline": [RINGS[:2], RINGS[2:]],
         "contacts": [{"on": [0, "1/2"]}, {"on": [2, "1/2"]}, {"on": {"edge": 6, "share": "1/4"}, "preload": 0},
                      {"on": {"polygon": 1, "edge": 0, "share": "1/2"}}]}


class Outlines(unittest.TestCase):
    def drawn(self, *words, **members):
        code, svg, err = stickslip("plot", *words, stdin=json.dumps({**FRAME, **members}))
        self.assertEqual((code, err), (0, ""))
        return Picture(svg)

    def assert_similar(self, shown, rings):
        """One scale and shift, y up, takes all rings to the page."""
        corner, size = shown[0][0], shown[0][1] - shown[0][0]
        scale = abs(size) / 4
        for ring, points in zip(rings, shown):
            self.assertEqual(len(ring), len(points))
            for (x, y), point in zip(ring, points):
                self.assertLess(abs(corner + complex(scale * x, -scale * y) - point), 0.05)
        return scale

    def test_body_is_the_outline(self):
        for command in ("grasp", "states"):
            body, = self.drawn(command, "-").all("body")
            shown = subpaths(body)
            self.assertEqual(len(shown), len(RINGS))
            self.assert_similar(shown, RINGS)
            self.assertEqual(body.get("fill-rule"), "evenodd")

    def test_contacts_are_on_it(self):
        picture = self.drawn("grasp", "-")
        shown = subpaths(picture.all("body")[0])
        scale = self.assert_similar(shown, RINGS)
        # Half-way on edges of the outer ring, a quarter of the hole's upper edge, half-way again.
        for i, (x, y) in enumerate([(2, 0), (2, 3), (2.5, 2), (5.5, 0)]):
            cone, = picture.all("cone", contact=str(i))
            apex = subpaths(cone)[0][0]
            self.assertLess(abs(shown[0][0] + complex(scale * x, -scale * y) - apex), 0.05)
            inside = apex + 0.02 * (subpaths(cone)[0][13] - apex)  # on the normal
            self.assertEqual(sum(contains(ring, inside) for ring in shown) % 2, 1, i)

    def test_the_ghost_is_the_outline_moved(self):
        # Under a pull of 1/4 the jaw moves by (0, 1/4) times a factor: nothing turns.
        picture = self.drawn("grasp", "-", contacts=FRAME["contacts"][:2], wrench=[0, "-1/4", "-1/2"])
        ghost, body = picture.all("ghost") + picture.all("virtual-ghost"), picture.all("body")
        self.assertEqual(len(ghost), 1)
        moved = [b - a for old, new in zip(subpaths(body[0]), subpaths(ghost[0]))
                 for a, b in zip(old, new)]
        self.assertEqual(len(moved), sum(map(len, RINGS)))
        for step in moved:
            self.assertLess(abs(step - moved[0]), 0.05)
        self.assertGreater(abs(moved[0]), 1)

    def test_legend_says_what_the_body_is(self):
        self.assertIn("body", self.drawn("grasp", "-").texts())
        plain = {key: FRAME[key] for key in ("wrench", "defaults")}
        plain.update(format="stickslip-grasp/1", contacts=[{"position": [0, 0], "normal": [0, 1]}])
        hull = Picture(stickslip("plot", "grasp", "-", stdin=json.dumps(plain))[1])
        self.assertIn("body: a sketch", hull.texts())

    def test_all_of_it_is_on_the_page(self):
        far = [[[-1000, -1], [1000, -1], [1000, 1], [-1000, 1]]]
        tiny = [[["-1e-300", "-1e-300"], ["1e-300", "-1e-300"], [0, "1e-300"]]]
        for outline in (far, tiny, [[[1e300, 0], ["2e300", 0], ["1e300", 1]]]):
            for command in ("grasp", "states"):
                picture = self.drawn(command, "-", outline=outline, contacts=[{"on": [0, "1/2"]}])
                width, height = (float(picture.root.get(key)) for key in ("width", "height"))
                for point in subpaths(picture.all("body")[0])[0]:
                    self.assertTrue(0 <= point.real <= width and 0 <= point.imag <= height)

    def test_without_contacts(self):
        for command in ("grasp", "states"):
            self.assertEqual(len(subpaths(self.drawn(command, "-", contacts=[]).all("body")[0])), 3)

    def test_title_names_the_case(self):
        picture = self.drawn("grasp", "-", "--case", "up & away", name="jaw",
                             cases=[{"name": "up & away", "loads": []}])
        title, = picture.all("title")
        self.assertEqual(title.text, f"jaw, up & away: {title.get('data-verdict')}")

    def test_units(self):
        units = {"length": "mm", "force": "kN"}
        region = ("region", "-", "--v", "0,0,1")
        texts = [" ".join(self.drawn(*words, units=units, wrench=[0, -1, "1/2"]).texts())
                 for words in (("grasp", "-"), ("states", "-"), region)]
        self.assertRegex(texts[0], r"force \S+ kN ")
        self.assertRegex(texts[0], r"torque \S+ kN mm ")
        self.assertIn("Units: kN, mm.", texts[0])
        self.assertIn("at distance 6 mm from", texts[1])
        self.assertIn("applied force along x / kN", texts[2])
        self.assertIn("applied torque / kN mm", texts[2])
        for words in (("grasp", "-"), ("states", "-"), region):
            self.assertNotIn("kN", " ".join(self.drawn(*words).texts()))

    def test_written_by_snap(self):
        contacts = [{"on": {"polygon": 1, "edge": 2, "share": "1/3"}}]
        out = stickslip("snap", "-", "-o", "-", stdin=json.dumps({**FRAME, "contacts": contacts}))[1]
        snapped = json.loads(out)
        self.assertEqual(snapped["outline"], [[[list(v) for v in ring] for ring in RINGS[:2]],
                                              [[list(v) for v in RINGS[2]]]])
        self.assertEqual(snapped["contacts"][0]["position"], ["16/3", "4/3"])


if __name__ == "__main__":
    unittest.main()
