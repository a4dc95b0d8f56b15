# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of resistible wrenches against `stickslip region --json`."""

import json
import os
import tempfile
import unittest
from fractions import Fraction

from pictures import Picture, stickslip

HERE = os.path.dirname(os.path.abspath(__file__))
PAPER = os.path.join(HERE, "..", "..", "paper_examples", "grasps")
FIG1 = os.path.join(PAPER, "fig1.json")
FIG4 = os.path.join(PAPER, "fig4.json")


def point(text):
    return tuple(map(Fraction, text.split(",")))


def grasp(*contacts, name="<&\">"):
    return json.dumps({"format": "stickslip-grasp/1", "name": name, "wrench": [0, 0, 0],
                       "defaults": {"friction": "1/2"}, "contacts": list(contacts)})


SLIDER = {"position": [0, 0], "normal": [0, 1], "friction": 0}
GRASPS = {
    "no contact": (grasp(), []),
    "one frictionless": (grasp(SLIDER), []),
    "one with friction": (grasp({**SLIDER, "friction": 1}), []),
    "facing, frictionless": (grasp(SLIDER, {**SLIDER, "normal": [0, -1]}), []),
    "fig1, no preload": (FIG1, ["--preload", 0]),
    "fig1": (FIG1, ["--preload", 1]),
    "fig1, bilateral": (FIG1, ["--preload", 1, "--normal-law", "bilateral"]),
    "fig1, torque": (FIG1, ["--preload", 1, "--torque", "1/3"]),
    "fig1, force and torque": (FIG1, ["--preload", 1, "--v", "0,0,1"]),
    "fig4": (FIG4, ["--preload", 1]),
}


class RegionPlots(unittest.TestCase):
    def ask(self, kind, source, words):
        stdin = source if source.startswith("{") else None
        code, out, err = stickslip(*kind, "-" if stdin else source, *words, stdin=stdin)
        self.assertEqual((code, err), (0, ""))
        return out

    def test_every_picture_shows_the_exact_region(self):
        for name, (source, words) in GRASPS.items():
            with self.subTest(name):
                region = json.loads(self.ask(("region",), source, [*words, "--json"]))
                picture = Picture(self.ask(("plot", "region"), source, words))
                outlines = [o for area in region["areas"] for o in area["outlines"]]
                corners = {tuple(map(Fraction, v)) for o in outlines for v in o["vertices"]}
                corners |= {tuple(map(Fraction, v))
                            for c in region["curves"] for v in c["vertices"]}
                corners |= {tuple(map(Fraction, p)) for p in region["points"]}
                drawn = [point(e.get("data-corner")) for e in picture.root.iter()
                         if e.get("data-corner")]
                self.assertEqual(sorted(drawn), sorted(corners))
                self.assertEqual(bool(region["areas"]), bool(picture.all("area")))
                # An arrow for each end at infinity.
                ends = sum(2 for o in outlines if not o["closed"])
                ends += sum(len(c["rays"]) for c in region["curves"])
                self.assertEqual(len(picture.all("unbounded")), ends)
                # Every edge between two corners is drawn whole.
                edges = {(e.get("data-from"), e.get("data-to")) for e in picture.all("border")
                         if e.get("data-from")}
                for outline in outlines:
                    vertices = [",".join(v) for v in outline["vertices"]]
                    for edge in zip(vertices, vertices[1:]):
                        self.assertIn(edge, edges)
                self.assertEqual({point(e.get("data-point")) for e in picture.root.iter()
                                  if e.get("data-point")},
                                 {tuple(map(Fraction, p)) for p in region["points"]})

    def test_fig_7c(self):
        picture = Picture(self.ask(("plot", "region"), FIG1, ["--preload", 1]))
        vertices = {point(v) for v in picture.all("area")[0].get("data-vertices").split()}
        half = max(x for x, _ in vertices)
        self.assertGreater(half, 2)
        self.assertEqual(vertices, {(0, 1), (2, 0), (-2, 0), (half, 0), (-half, 0),
                                    (half, -half), (-half, -half)})

    def test_region_svg_is_the_same_picture(self):
        for _ in range(2):
            self.assertEqual(self.ask(("region", "--svg"), FIG1, []),
                             self.ask(("plot", "region"), FIG1, []))

    def test_labels_do_not_cover_each_other(self):
        picture = Picture(self.ask(("plot", "region"), FIG4, ["--preload", 1]))
        labels = [e for e in picture.all("halo")]
        self.assertEqual(len(labels), 8)
        places = {(e.get("x"), e.get("y")) for e in labels}
        self.assertEqual(len(places), 8)

    def test_written_whole_or_undecided(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "region.svg")
            code, out, err = stickslip("plot", "region", FIG1, "--mode-limit", 3, "-o", path)
            self.assertEqual((code, out), (3, ""))
            self.assertIn("given up", err)
            self.assertFalse(os.path.exists(path))
            self.assertEqual(stickslip("plot", "region", FIG1, "-o", path), (0, "", ""))
            with open(path, encoding="utf-8") as file:
                Picture(file.read())


if __name__ == "__main__":
    unittest.main()
