# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts of every kind of picture, read back with the widths of a real font: none leaves the page or
its frame, and none meets another."""

import json
import math
import os
import random
import unittest

import pictures
import test_space_plot
from pictures import Picture, arrow, stickslip, subpaths, text_boxes

HERE = os.path.dirname(os.path.abspath(__file__))
CORPUS = os.path.join(HERE, "..", "..", "corpus", "grasps", "good")
PAPER = os.path.join(HERE, "..", "..", "..", "paper_examples", "grasps")


def contact(position, normal, **more):
    return {"position": list(position), "normal": list(normal), **more}


def grasp(contacts, wrench=(0, 0, 0), name="g", **defaults):
    return {"format": "stickslip-grasp/1", "name": name, "wrench": list(wrench),
            "defaults": {"friction": 0.345678912, **defaults}, "contacts": contacts}


def nine_digits(rng, count):
    """Positions with nine digits, unit normals in doubles that point inwards."""
    contacts = []
    for _ in range(count):
        angle = rng.uniform(0, 2 * math.pi)
        size = rng.uniform(0.5, 1.5)
        contacts.append(contact((round(size * math.cos(angle), 9), round(size * math.sin(angle), 9)),
                                (-math.cos(angle), -math.sin(angle))))
    return contacts


def corpus():
    rng = random.Random(13)
    for folder in (CORPUS, PAPER):
        for name in sorted(os.listdir(folder)):
            with open(os.path.join(folder, name), encoding="utf-8-sig") as file:
                yield name, file.read()
    grasps = {}
    for k in range(12):
        wrench = [round(rng.uniform(-1, 1), 9) for _ in range(3)]
        grasps[f"nine digits {k}"] = grasp(nine_digits(rng, 2 + k % 5), wrench)
    axes = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    for k in range(6):
        grasps[f"nine digits, preloaded {k}"] = grasp(
            [contact((-n[0] + rng.uniform(-0.3, 0.3), -n[1] + rng.uniform(-0.3, 0.3)), n,
                     preload=rng.uniform(0.1, 1)) for n in axes[k % 2:]],
            [0, -rng.random(), rng.uniform(-1e-4, 1e-4)])
    box = [contact((-x, -y), (x, y), preload=1) for x, y in axes]
    for name in ("W" * 300, "a long name of many words " * 20, "\u00c5\u4e2d" * 80, "\U0001F916" * 90, "%@" * 200):
        grasps["named " + name[:3]] = grasp(box, (0, 1, 0), name)
    for exponent in (-4000, -300, -30, -7, 9, 30, 300, 4000):
        unit = f"1e{exponent}"
        grasps[f"lengths {unit}"] = grasp(
            [contact((f"-{x}e{exponent}", f"-{y}e{exponent}") if x + y > 0 else
                     (f"{-x}e{exponent}", f"{-y}e{exponent}"), (x, y), preload=1) for x, y in axes],
            (0, 1, unit))
        grasps[f"forces {unit}"] = grasp(
            [{**c, "preload": unit} for c in box], (f"123456789e{exponent}", f"-987654321e{exponent}", 0))
    for count in (20, 61, 150):
        ring = [(math.cos(2 * math.pi * k / count), math.sin(2 * math.pi * k / count)) for k in range(count)]
        grasps[f"{count} contacts"] = grasp([contact(p, (-p[0], -p[1])) for p in ring], (0, -1, 0))
    grasps["a row"] = grasp([contact((k / 7, 0), (0, 1)) for k in range(60)], (1, 0, 0))
    grasps["one place"] = grasp([contact((3, 4), n, preload=2) for n in axes * 6], (0, 1, 0))
    grasps["one place, one normal"] = grasp([contact((0, 0), (0, 1))] * 30, (0, -1, 0))
    grasps["nearly one place"] = grasp([contact((k * 1e-9, 1), (0, -1)) for k in range(9)]
                                       + [contact((0, -1), (0, 1))], (0, 0, 0))
    grasps["far away"] = grasp([contact((123456.789012345 + x, -98765.4321012 + y), (-x, -y), preload=1)
                                for x, y in axes], (0, -1, 0))
    grasps["small load"] = grasp([{**c, "preload": 123456} for c in box], ("1e-7", "-2e-7", 0))
    for name, content in grasps.items():
        yield name, json.dumps(content)


def cases(text):
    return pictures.case_options(json.loads(text)) if '"cases"' in text else ()


def questions():
    for name, text in corpus():
        for kind in ("grasp", "states", "region"):
            if kind == "region" and (text.count('"position"') > 6 or name == "exact_numbers.json"):
                continue  # slow: its cells are many, or have 4,000 digits
            if kind == "states" and text.count('"position"') > 100:
                continue
            yield (name, kind), text, cases(text) if kind == "grasp" else ()
        if name.startswith("nine digits"):
            for options in (("--v", "0.123456789,0.987654321,-0.111111111"), ("--torque", "0.123456789")):
                yield (name, "region", *options), text, options
    for text, options in test_space_plot.questions():
        yield ("in space", "grasp", *options), text, options


class Labels(unittest.TestCase):
    def check(self, picture, kind):
        page = float(picture.root.get("width")), float(picture.root.get("height"))
        boxes = text_boxes(picture)
        self.assertTrue(boxes)
        for k, box in enumerate(boxes):
            self.assertTrue(box.is_inside((0, 0), page), (box, page))
            for other in boxes[:k]:
                self.assertFalse(box.overlaps(other), (box, other))
        if kind == "region":
            frame, = (subpaths(e)[0] for e in picture.all("frame"))
            low, high = ((f(p.real for p in frame), f(p.imag for p in frame)) for f in (min, max))
            for box in boxes:
                if "halo" in box.classes:
                    self.assertTrue(box.is_inside(low, high), box)
            self.assertGreaterEqual(sum("tick" in box.classes for box in boxes), 2)
        if kind == "grasp":
            # Neither does the ink leave the page.
            for element in picture.root.iter():
                if element.tag.endswith("}path"):
                    for p in sum(subpaths(element), []):
                        self.assertTrue(0 <= p.real <= page[0] and 0 <= p.imag <= page[1])
        return boxes

    def test_every_text_has_its_own_place(self):
        asked = 0
        for name, text, options in questions():
            with self.subTest(name):
                code, svg, err = stickslip("plot", name[1], "-", *options, stdin=text)
                self.assertEqual((code, err), (0, ""))
                self.check(Picture(svg), name[1])
                asked += 1
        self.assertGreater(asked, 150)

    def test_no_number_in_a_label_is_long(self):
        """Nine digits of a coordinate are in the data- attributes, not in the texts."""
        for name, text, options in questions():
            if "nine digits" in name[0]:
                with self.subTest(name):
                    picture = Picture(stickslip("plot", name[1], "-", *options, stdin=text)[1])
                    for line in picture.texts():
                        self.assertNotRegex(line, r"\d[\d./]{12}")

    def test_few_contacts_are_all_numbered(self):
        for name, text in corpus():
            count = text.count('"position"') + text.count('"on"')
            if count > 8:
                continue
            for kind in ("grasp", "states"):
                options = cases(text) if kind == "grasp" else ()
                with self.subTest((name, kind)):
                    picture = Picture(stickslip("plot", kind, "-", *options, stdin=text)[1])
                    numbers = {n for t in picture.root.iter() if "number" in t.get("class", "").split()
                               for n in t.text.split(", ")}
                    if "\u2026" not in numbers:
                        self.assertEqual(numbers, set(map(str, range(count))))

    def test_a_check_that_can_fail(self):
        svg = stickslip("plot", "grasp", os.path.join(PAPER, "fig1.json"))[1]
        title = text_boxes(Picture(svg))[0]
        moved = svg.replace(' x="24" y="34"', ' x="700" y="34"')
        self.assertNotEqual(moved, svg)
        with self.assertRaises(AssertionError):
            self.check(Picture(moved), "grasp")
        with self.assertRaises(AssertionError):
            self.check(Picture(svg.replace("</svg>", f'<text class="caption" x="{title.low[0]}" '
                                                     f'y="{title.high[1]}">over it</text></svg>')), "grasp")

    def test_a_small_load_is_seen(self):
        text = dict(corpus())["small load"]
        picture = Picture(stickslip("plot", "grasp", "-", stdin=text)[1])
        load, = (e for e in picture.all("load") if e.get("data-value"))
        tail, tip = arrow(load)
        self.assertGreater(abs(tip - tail), 15)
        self.assertGreater(int(load.get("data-factor")), 10**9)
        self.assertTrue(any("enlarged" in t for t in picture.texts()))


if __name__ == "__main__":
    unittest.main()
