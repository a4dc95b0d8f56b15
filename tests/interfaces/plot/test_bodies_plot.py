# SPDX-License-Identifier: GPL-3.0-or-later
"""plot grasp of several bodies, in the plane and in space: all are drawn, and in each view the arrows of what acts on a
body that no joint holds close to a polygon."""

import json
import os
import unittest
from fractions import Fraction

from pictures import Picture, arrow, stickslip, subpaths, text_boxes

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
EXAMPLES = os.path.join(ROOT, "examples", "grasps")
CORPUS = os.path.join(ROOT, "tests", "corpus", "bodies")
ARROW = 0.03  # pixels: two ends, each rounded to 1/100
LEFT_OUT = 0.02  # pixels: what is shorter is not drawn


def of_text(text):
    return [float(Fraction(x)) for x in text.split(",")]


def questions():
    """A name, a file, and options."""
    for name, cases in (("stack", ("at rest", "pushed above", "pushed below", "both slide")), ("gripper", (None,)),
                        ("arch", (None,)), ("hand", (None,)), ("books", ("held", "too heavy"))):
        for case in cases:
            yield name, os.path.join(EXAMPLES, f"bodies-{name}.json"), (("--case", case) if case else ())
    yield "slide in space", os.path.join(CORPUS, "link_in_space_unstable.grasp.json"), ()
    yield "dragged", os.path.join(CORPUS, "margin_dragged.grasp.json"), ("--wrench", "1")


class BodiesPlot(unittest.TestCase):
    def ask(self, file, options):
        code, svg, err = stickslip("plot", "grasp", file, *options)
        self.assertEqual((code, err), (0, ""))
        answer = json.loads(stickslip("decide", file, "--json", *options)[1])
        with open(file, encoding="utf-8") as text:
            return Picture(svg), answer, json.load(text)

    def test_all_bodies_are_drawn_and_named(self):
        for name, file, options in questions():
            with self.subTest((name, options)):
                picture, answer, grasp = self.ask(file, options)
                sides = 3 if any("from above" in t for t in picture.texts()) else 1
                self.assertEqual(sides, 3 if "hand" in name or "space" in name else 1)
                self.assertEqual(len(picture.all("body")), sides * len(grasp["bodies"]))
                for body in picture.all("body"):
                    self.assertGreaterEqual(len(subpaths(body)[0]), 3)
                links = sum("hinge" in b or "slide" in b for b in grasp["bodies"])
                self.assertEqual(len([e for e in picture.all("joint") if e.tag.endswith("}circle")]), sides * links)
                moves = "twist" in answer and any(map(Fraction, answer["twist"]))
                self.assertEqual(len(picture.all("ghost")), sides * len(grasp["bodies"]) if moves else 0)
                if name != "books":
                    for body in grasp["bodies"]:
                        self.assertIn(body["name"], picture.texts())
                fingers = sum(c.get("by", "ground") == "ground" for c in grasp["contacts"])
                self.assertLessEqual(len(picture.all("finger")), sides * fingers)
                self.assertEqual(bool(picture.all("force")), answer["verdict"] == "stable" and bool(grasp["contacts"]))

    def test_texts_have_places_of_their_own(self):
        for name, file, options in questions():
            with self.subTest((name, options)):
                picture, _, _ = self.ask(file, options)
                boxes = text_boxes(picture)
                page = float(picture.root.get("width")), float(picture.root.get("height"))
                for k, box in enumerate(boxes):
                    self.assertTrue(box.is_inside((0, 0), page), box)
                    for other in boxes[:k]:
                        self.assertFalse(box.overlaps(other), (box, other))

    def test_arrows_on_a_body_close_to_a_polygon(self):
        balanced = 0
        for name, file, options in questions():
            picture, answer, grasp = self.ask(file, options)
            if answer["verdict"] != "stable":
                continue
            forces = {}
            for e in picture.all("force"):
                forces.setdefault(e.get("data-contact"), set()).add(e.get("data-value"))
                self.assertEqual(of_text(e.get("data-value")),
                                 [float(Fraction(x)) for x in answer["contacts"][int(e.get("data-contact"))]["force"]])
            size = 3 if len(next(iter(forces.values())).pop().split(",")) == 3 else 2
            first = 0
            for body in grasp["bodies"]:
                if "hinge" in body or "slide" in body:
                    continue
                load = [float(Fraction(w)) for w in answer["wrench"][first:first + size]]
                first += 3 if size == 2 else 6
                for view in range(3 if size == 3 else 1):
                    with self.subTest((name, options, body["name"], view)):
                        total, drawn = self.pull_on(picture, grasp, body["name"], view, size, load)
                        self.assertLess(abs(total), (ARROW + LEFT_OUT) * (len(grasp["contacts"]) + 1))
                        balanced += drawn > 1
        self.assertGreater(balanced, 12)

    def pull_on(self, picture, grasp, name, view, size, load):
        """The sum of the arrows of one view of all that acts on a body, and how many there are."""
        per_view = self.per_view(picture, size)
        total, drawn = 0j, 0
        for e in picture.all("force"):
            if per_view[id(e)] != view:
                continue
            contact = grasp["contacts"][int(e.get("data-contact"))]
            tail, tip = arrow(e)
            sign = (contact["of"] == name) - (contact.get("by") == name)
            total += sign * (tip - tail)
            drawn += abs(sign)
        for e in picture.all("load"):
            if per_view[id(e)] == view and of_text(e.get("data-value")) == load:
                tail, tip = arrow(e)
                total += (tip - tail) / float(Fraction(e.get("data-factor")))
                return total, drawn + 1
        return total, drawn

    @staticmethod
    def per_view(picture, size):
        found, view = {}, 0 if size == 2 else -1
        for e in picture.root.iter():
            view += size == 3 and e.tag.endswith("}text") and (e.text or "").startswith("from ")
            found[id(e)] = view
        return found

    def test_the_page_about_them_shows_what_is_drawn(self):
        for name, options in (("bodies-hand", ()), ("bodies-stack", ("--case", "pushed above")), ("bodies-cap", ("--case", "off centre"))):
            with open(os.path.join(ROOT, "docs", name + ".svg"), encoding="utf-8") as file:
                self.assertEqual(file.read(), stickslip("plot", "grasp", os.path.join(EXAMPLES, name + ".json"), *options)[1])


if __name__ == "__main__":
    unittest.main()
