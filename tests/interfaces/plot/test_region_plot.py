# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of resistible wrenches against `stickslip region --json`."""

import json
import os
import tempfile
import unittest
from fractions import Fraction

from pictures import Picture, stickslip, text_boxes

HERE = os.path.dirname(os.path.abspath(__file__))
PAPER = os.path.join(HERE, "..", "..", "..", "paper_examples", "grasps")
EXAMPLES = os.path.join(HERE, "..", "..", "..", "examples", "grasps")
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

    def test_region_svg_is_the_same_picture(self):
        for _ in range(2):
            self.assertEqual(self.ask(("region", "--svg"), FIG1, []),
                             self.ask(("plot", "region"), FIG1, []))

    def labelled(self):
        """Pictures with labels that had no room, or several spellings of numbers."""
        for name in ("bracket", "more-friction-breaks", "cup", "all-friction-not-monotone"):
            yield name, os.path.join(EXAMPLES, name + ".json"), []
        yield "fig4", FIG4, ["--preload", 1]
        yield "fig4, long", FIG4, ["--preload", "0.7654321", "--torque", "1/7"]
        yield "fig1, long", FIG1, ["--preload", "1.123456789", "--v", "0.123456789,0.987654321,-0.111111111"]
        yield "tiny", FIG1, ["--preload", "1e-300"]

    def test_labels_keep_off_outlines_and_each_other(self):
        for name, source, words in self.labelled():
            with self.subTest(name):
                picture = Picture(self.ask(("plot", "region"), source, words))
                labels = [box for box in text_boxes(picture) if "halo" in box.classes]
                self.assertTrue(labels)
                borders = [(complex(float(e.get("x1")), float(e.get("y1"))),
                            complex(float(e.get("x2")), float(e.get("y2"))))
                           for e in picture.all("border") if e.get("data-from")]
                self.assertTrue(borders)
                for k, label in enumerate(labels):
                    self.assertFalse(any(label.overlaps(other) for other in labels[:k]), label)
                    for a, b in borders:
                        for step in range(1001):
                            p = a + (b - a) * step / 1000
                            inside = (label.low[0] < p.real < label.high[0]
                                      and label.low[1] < p.imag < label.high[1])
                            self.assertFalse(inside, label)

    def test_written_whole_or_undecided(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "region.svg")
            code, out, err = stickslip("plot", "region", FIG1, "--mode-limit", 3, "-o", path)
            self.assertEqual((code, out), (3, ""))
            self.assertEqual(err, "stickslip: no region is known: there are more than 3 contact modes; "
                                  "a higher mode limit may tell\n")
            self.assertFalse(os.path.exists(path))
            self.assertEqual(stickslip("plot", "region", FIG1, "-o", path), (0, "", ""))
            with open(path, encoding="utf-8") as file:
                Picture(file.read())


if __name__ == "__main__":
    unittest.main()
