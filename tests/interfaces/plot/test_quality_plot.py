# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the quality against `stickslip quality`, `region` and `decide`, and the geometry of balls."""

import json
import math
import os
import random
import unittest
from fractions import Fraction

from pictures import Picture, contains, stickslip, subpaths, text_boxes

HERE = os.path.dirname(os.path.abspath(__file__))
PAPER = os.path.join(HERE, "..", "..", "..", "paper_examples", "grasps")
EXAMPLES = os.path.join(HERE, "..", "..", "..", "examples", "grasps")
FIG1 = os.path.join(PAPER, "fig1.json")


def example(name):
    return os.path.join(EXAMPLES, name + ".json")


def numbers(text):
    return list(map(Fraction, text.split(",")))


def cross(c, f):
    return [c[1] * f[2] - c[2] * f[1], c[2] * f[0] - c[0] * f[2], c[0] * f[1] - c[1] * f[0]]


def norm(load, length, about):
    """Of a wrench in the plane or in space: of its force, and of its torque at the point."""
    if len(load) == 3:
        torque = [load[2] - about[0] * load[1] + about[1] * load[0]]
        return math.sqrt(sum(x * x for x in load[:2]) + (torque[0] / length) ** 2)
    torque = [t - m for t, m in zip(load[3:], cross(about, load[:3]))]
    return math.sqrt(sum(x * x for x in load[:3]) + sum(t * t for t in torque) / length ** 2)


# Files, options, and the length and the point that these give; about which sections is asked cell by cell.
QUESTIONS = {
    "fig1": ((FIG1, "--preload", "1", "--wrench", "0,1/2,0", "--length", "2"), 2, (0, 0)),
    "about a point": ((example("jaw"), "--about", "1,-1/2"), 1, (1, Fraction(-1, 2))),
    "space": ((example("space-cup"), "--length", "4", "--accuracy", "10%"), 4, (0, 0, 0)),
}
CELLS = ("--depth", "3")


class QualityPlots(unittest.TestCase):
    def ask(self, *words):
        code, out, err = stickslip(*words)
        self.assertEqual((code, err), (0, ""), words)
        return out

    def found(self, name):
        words, length, about = QUESTIONS[name]
        answer = json.loads(self.ask("quality", *words, "--json"))
        picture = Picture(self.ask("plot", "quality", *words, *CELLS))
        wrench = list(map(Fraction, answer["wrench"]))
        return words, answer, picture, wrench, lambda load: norm(load, length, about)

    def test_circles_are_balls_and_the_load_is_that_of_the_answer(self):
        for name in QUESTIONS:
            with self.subTest(name):
                _, answer, picture, wrench, size = self.found(name)
                lost = list(map(Fraction, answer["not_resisted"]))
                sections = picture.all("section")
                self.assertEqual(len(sections), 2 if len(wrench) == 3 else 4)
                shown = 0
                for section in sections:
                    u, v = numbers(section.get("data-u")), numbers(section.get("data-v"))
                    circles = [e for e in section.iter() if e.get("class") == "rim"]
                    self.assertEqual([e.get("data-radius") for e in circles], [answer["proved"], answer["refuted"]])
                    self.assertEqual([e.get("stroke-dasharray") is None for e in circles], [True, False])
                    frame = next(e for e in section.iter() if e.get("class") == "frame")
                    corners = subpaths(frame)[0]
                    pixels = (corners[1].real - corners[0].real) / 2
                    # The window is a square of twice the larger ball: a unit is as long along both axes.
                    unit = pixels / (2 * float(Fraction(answer["refuted"])))
                    for e in circles:
                        self.assertAlmostEqual(float(e.get("r")), unit * float(Fraction(e.get("data-radius"))), delta=.02)
                        self.assertAlmostEqual(complex(float(e.get("cx")), float(e.get("cy"))),
                                               (corners[0] + corners[2]) / 2, delta=.02)
                    for e in section.iter():
                        if "lost" not in e.get("class", "").split():
                            continue
                        shown += 1
                        s, t = Fraction(e.get("data-s")), Fraction(e.get("data-t"))
                        self.assertEqual([w + s * a + t * b for w, a, b in zip(wrench, u, v)], lost)
                        at = complex(float(e.get("cx")), float(e.get("cy"))) - (corners[0] + corners[2]) / 2
                        expected = complex(s * size(u), -t * size(v)) * unit
                        self.assertAlmostEqual(at, expected, delta=.02)
                        self.assertLessEqual(size([a - b for a, b in zip(lost, wrench)]), Fraction(answer["refuted"]))
                        self.assertGreater(size([a - b for a, b in zip(lost, wrench)]), Fraction(answer["proved"]))
                self.assertGreaterEqual(shown, 1)
                title = picture.all("title")[0]
                self.assertEqual((title.get("data-proved"), title.get("data-refuted")), (answer["proved"], answer["refuted"]))

    def test_the_load_on_the_body_is_not_resisted(self):
        for name in QUESTIONS:
            with self.subTest(name):
                _, answer, picture, _, _ = self.found(name)
                lost = list(map(Fraction, answer["not_resisted"]))
                forces = {e.get("data-value") for e in picture.all("load") if e.get("data-value")}
                whole = ",".join(answer["not_resisted"][:2 if len(lost) == 3 else 3])
                self.assertIn(whole, forces)

    def test_areas_are_those_of_region(self):
        for name in ("fig1", "about a point"):
            words, answer, picture, wrench, _ = self.found(name)
            preload = words[1:3] if "--preload" in words else ()
            for section in picture.all("section"):
                u, v = section.get("data-u"), section.get("data-v")
                region = json.loads(self.ask("region", words[0], *preload, "--origin=" + ",".join(answer["wrench"]),
                                             "--u=" + u, "--v=" + v, "--json"))
                exact = {tuple(map(Fraction, p)) for area in region["areas"] for o in area["outlines"]
                         for p in o["vertices"]}
                drawn = {tuple(numbers(p)) for e in section.iter() if e.get("data-vertices")
                         for p in e.get("data-vertices").split()}
                most = [max(abs(p[k]) for p in drawn) for k in (0, 1)]
                inside = {p for p in exact if abs(p[0]) < most[0] and abs(p[1]) < most[1]}
                self.assertLessEqual(inside, drawn)
                # All other corners are of the window, or where its frame cuts a border: on the frame.
                for p in drawn - inside:
                    self.assertTrue(abs(p[0]) == most[0] or abs(p[1]) == most[1], p)
                polygons = [[complex(*map(float, numbers(p))) for p in e.get("data-vertices").split()]
                            for e in section.iter() if e.get("data-vertices")]
                source = random.Random(1)
                for _ in range(12):
                    s, t = (m * Fraction(source.randint(-19, 19), 20) for m in most)
                    load = [w + s * a + t * b for w, a, b in zip(wrench, numbers(u), numbers(v))]
                    stable = json.loads(self.ask("decide", words[0], *preload, "--json",
                                                 "--wrench=" + ",".join(map(str, load))))["verdict"] == "stable"
                    self.assertEqual(any(contains(p, complex(s, t)) for p in polygons), stable, (name, s, t))

    def test_cells_have_their_verdict_inside(self):
        words, _, picture, wrench, _ = self.found("space")
        source, asked = random.Random(2), 0
        for section in picture.all("section"):
            u, v = numbers(section.get("data-u")), numbers(section.get("data-v"))
            cells = [e for e in section.iter() if e.get("data-verdict")]
            area = 0
            for e in cells:
                x, y = numbers(e.get("data-x")), numbers(e.get("data-y"))
                area += (x[1] - x[0]) * (y[1] - y[0])
            most = [max(numbers(e.get("data-" + axis))[1] for e in cells) for axis in "xy"]
            self.assertEqual(area, 4 * most[0] * most[1])
            for e in source.sample(cells, min(4, len(cells))):
                if e.get("data-verdict") == "undecided":
                    continue
                s, t = (low + Fraction(source.randint(0, 8), 8) * (high - low)
                        for low, high in (numbers(e.get("data-x")), numbers(e.get("data-y"))))
                load = [w + s * a + t * b for w, a, b in zip(wrench, u, v)]
                verdict = json.loads(self.ask("decide", words[0], "--json",
                                              "--wrench=" + ",".join(map(str, load))))["verdict"]
                self.assertEqual(verdict, e.get("data-verdict"))
                asked += 1
        self.assertGreater(asked, 4)

    def test_texts_keep_off_each_other(self):
        for name in QUESTIONS:
            _, _, picture, _, _ = self.found(name)
            texts = text_boxes(picture)
            width = float(picture.root.get("width"))
            height = float(picture.root.get("height"))
            for k, text in enumerate(texts):
                self.assertTrue(text.is_inside((0, 0), (width, height)), text)
                self.assertFalse(any(text.overlaps(other) for other in texts[:k]), text)

    def test_of_several_bodies(self):
        words = (example("bodies-stack"), "--case", "pushed above", "--body", "up", "--accuracy", "10%")
        answer = json.loads(self.ask("quality", *words, "--json"))
        picture = Picture(self.ask("plot", "quality", *words, "--depth", "2"))
        sections = picture.all("section")
        # Forces on the upper body alone, and their torque.
        self.assertEqual(numbers(sections[0].get("data-u")), [0, 0, 0, 1, 0, 0])
        self.assertEqual(numbers(sections[0].get("data-v")), [0, 0, 0, 0, 1, 0])
        lost = picture.all("lost")[-1]
        u, v = (numbers(sections[-1].get("data-" + axis)) for axis in "uv")
        self.assertEqual([Fraction(w) + Fraction(lost.get("data-s")) * a + Fraction(lost.get("data-t")) * b
                          for w, a, b in zip(answer["wrench"], u, v)], list(map(Fraction, answer["not_resisted"])))

    def test_the_page_about_it_shows_what_is_drawn(self):
        with open(os.path.join(HERE, "..", "..", "..", "docs", "three-sides.svg"), encoding="utf-8") as file:
            self.assertEqual(file.read(), stickslip("plot", "quality", example("three-sides"))[1])

    def test_without_a_ball(self):
        # A load that is not resisted has no ball; and without load and preload all balls are like one.
        picture = Picture(self.ask("plot", "quality", FIG1, "--preload", "1", "--wrench", "0,5,0"))
        self.assertEqual((picture.all("section"), picture.all("rim")), ([], []))
        self.assertIn("no quality", picture.all("title")[0].text)
        facing = json.dumps({"format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": 1},
                             "contacts": [{"position": [-1, 0], "normal": [1, 0]},
                                          {"position": [1, 0], "normal": [-1, 0]}]})
        code, out, err = stickslip("plot", "quality", "-", stdin=facing)
        self.assertEqual((code, err), (0, ""))
        answer = json.loads(stickslip("quality", "-", "--json", stdin=facing)[1])
        circles = [e.get("data-radius") for e in Picture(out).all("rim") if e.get("data-radius")]
        kept = [r for r in (answer["proved"], answer["refuted"]) if r not in (None, "0")]
        self.assertTrue(kept)
        self.assertEqual(set(circles), set(kept))


if __name__ == "__main__":
    unittest.main()
