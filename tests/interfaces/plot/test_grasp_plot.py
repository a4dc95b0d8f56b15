# SPDX-License-Identifier: GPL-3.0-or-later
"""plot grasp: arrows are proportional to the exact values that decide reports; and what every
picture owes its readers: well-formed XML, the same bytes, escaped text, a rule for each colour."""

import json
import os
import re
import tempfile
import unittest
from fractions import Fraction

import pictures
from pictures import Picture, arrow, ask, stickslip, value

HERE = os.path.dirname(os.path.abspath(__file__))
CORPUS = os.path.join(HERE, "..", "..", "corpus", "grasps", "good")
PAPER = os.path.join(HERE, "..", "..", "..", "paper_examples", "grasps")
FIG1 = os.path.join(PAPER, "fig1.json")
FIG4 = os.path.join(PAPER, "fig4.json")
PIXEL = 0.02  # two ends, each rounded to 1/100
QUESTIONS = [
    (FIG1, ()),
    (FIG1, ("--wrench", "0,-3,1/4")),
    (FIG1, ("--wrench", "0,11/10,0")),
    (FIG1, ("--wrench", "0,0,0")),
    (FIG1, ("--wrench", "0,0,0", "--preload", "0")),
    (FIG4, ("--wrench", "0,2,1/3", "--preload", "3/2")),
    (FIG4, ("--wrench", "0,0,3")),
    (FIG4, ("--wrench", "0,0,-3")),
    (FIG4, ("--wrench", "0,0,3", "--preload", "1", "--normal-law", "bilateral")),
    (FIG4, ("--wrench", "1e500,0,0")),
    (FIG4, ("--wrench", "1e-500,0,0")),
    (FIG4, ()),
] + [(path, pictures.case_options(pictures.load(path)))
     for path in sorted(os.path.join(CORPUS, name) for name in os.listdir(CORPUS))]


def grasp_of(contacts, wrench, name=None, **defaults):
    grasp = {"format": "stickslip-grasp/1", "wrench": wrench, "defaults": defaults,
             "contacts": [{"position": list(p), "normal": list(n)} for p, n in contacts]}
    return json.dumps(grasp if name is None else {**grasp, "name": name})


class GraspPlot(unittest.TestCase):
    def drawn(self, *words, stdin=None):
        code, svg, err = stickslip("plot", *words, stdin=stdin)
        self.assertEqual((code, err), (0, ""))
        return Picture(svg)

    def decided(self, *words, stdin=None):
        return json.loads(stickslip("decide", *words, "--json", stdin=stdin)[1])

    def assert_scaled(self, elements):
        """Arrows are one factor times their values, which is returned."""
        size = lambda v: max(map(abs, v))
        shown = [(value(e), arrow(e)[1] - arrow(e)[0]) for e in elements]
        if not shown:
            return None
        unit, ink = max(shown, key=lambda pair: size(pair[0]))
        ratio = [float(part / size(unit)) for part in unit]
        scale = abs(ink) / abs(complex(*ratio))  # pixels for a component of size(unit)
        for v, line in shown:
            expected = scale * complex(float(v[0] / size(unit)), -float(v[1] / size(unit)))
            self.assertLess(abs(line - expected), 2 * PIXEL)
        return scale, size(unit)

    def check(self, grasp, options, stdin=None):
        picture = self.drawn("grasp", grasp, *options, stdin=stdin)
        answer = self.decided(grasp, *options, stdin=stdin)
        title, = picture.all("title")
        self.assertEqual(title.get("data-verdict"), answer["verdict"])
        wrench = list(map(Fraction, answer["wrench"]))
        loads = [e for e in picture.all("load") if e.get("data-value")]
        self.assertEqual([value(e) for e in loads], [wrench[:2]] if any(wrench[:2]) else [])
        torques = picture.all("torque")
        self.assertEqual(len(torques), 1 if wrench[2] else 0)
        for e in torques:
            self.assertEqual(value(e), [wrench[2]])
            self.assertEqual(e.get("data-sense"), "+" if wrench[2] > 0 else "-")
        if answer["verdict"] == "stable":
            self.check_witness(picture, answer, loads)
        else:
            self.assertFalse(picture.all("force") + picture.all("motion") + picture.all("ghost"))
            self.check_virtual_twist(picture)
        self.check_scale(picture, loads)
        return picture

    def check_virtual_twist(self, picture):
        """A ghost, arrows that one twist explains, and a mark and a word for each contact."""
        if any("allows no motion" in t for t in picture.texts()):
            return
        caption = " ".join(picture.texts())
        x, y, r = (Fraction(n.replace("\u2212", "-").replace("~", "")) for n in re.search(
            r"along the virtual twist \((.*?)\)", caption).group(1).split(", "))
        arrows = picture.all("virtual")
        self.assert_scaled(arrows)
        size = max(map(abs, (x, y, r)))
        for e in arrows:
            px, py = self.positions[int(e.get("data-contact"))]
            error = [abs(a - b) for a, b in zip(value(e), (x - r * py, y + r * px))]
            self.assertLessEqual(max(error), size * (1 + abs(px) + abs(py)) / 100000)
        marks = [e.get("data-contact-state") for e in picture.root.iter() if e.get("data-contact-state")]
        self.assertEqual(len(picture.all("virtual-ghost")), 1 if self.positions else 0)
        self.assertLessEqual(set(marks), {"loses", "cannot oppose"})
        for mark, verb in (("loses", "oppose(s it and loses| it and lose)"), ("cannot oppose", "cannot oppose it")):
            found = re.search(r"contacts? ([\d, ]+) " + verb, caption)
            shown = [e.get("data-contact") for e in picture.all("full") + picture.all("hollow")
                     if e.get("data-contact-state") == mark]
            self.assertEqual(found.group(1).split(", ") if found else [], sorted(shown, key=int))

    def check_scale(self, picture, loads):
        loads = loads if all(e.get("data-factor") == "1" for e in loads) else []
        arrows = self.assert_scaled(picture.all("force") + loads)
        bars = [e for e in picture.root.iter() if "scale" in e.get("class", "").split()]
        if arrows is None or not bars:
            return
        scale, unit = arrows
        bar = pictures.subpaths(bars[0])[1]
        self.assertLess(abs(abs(bar[1] - bar[0]) - scale * float(value(bars[0])[0] / unit)), 0.1)

    def check_witness(self, picture, answer, loads):
        x, y, r = map(Fraction, answer["twist"])
        forces = {e.get("data-contact"): e for e in picture.all("force")}
        marks = {e.get("data-contact"): e for e in picture.root.iter() if e.get("data-contact-state")}
        for i, contact in enumerate(answer["contacts"]):
            force = list(map(Fraction, contact["force"]))
            self.assertEqual(str(i) in forces, any(force))
            if any(force):
                self.assertEqual(value(forces[str(i)]), force)
            state = contact["slip"] if contact["closed"] else "open"
            self.assertEqual(marks[str(i)].get("data-contact-state"), state)
        # The forces and the load close to a polygon.
        total = sum((arrow(e)[1] - arrow(e)[0]) / float(Fraction(e.get("data-factor", "1")))
                    for e in picture.all("force") + loads)
        self.assertLess(abs(total), PIXEL * (len(forces) + 1))
        motions = picture.all("motion")
        self.assert_scaled(motions)
        self.assertEqual(len(picture.all("ghost")), 1 if any((x, y, r)) and marks else 0)
        for e in motions:
            position = self.positions[int(e.get("data-contact"))]
            self.assertEqual(value(e), [x - r * position[1], y + r * position[0]])
        # A force starts where the motion of the same contact does.
        for e in motions:
            if e.get("data-contact") in forces:
                self.assertEqual(arrow(e)[0], arrow(forces[e.get("data-contact")])[0])

    def test_arrows(self):
        for path, options in QUESTIONS:
            with self.subTest(path=path, options=options):
                self.positions = [c.position for c in pictures.contacts_of(pictures.load(path))]
                self.check(path, options)

    def test_both_verdicts_and_all_marks_are_covered(self):
        verdicts, states = set(), set()
        for path, options in QUESTIONS:
            picture = self.drawn("grasp", path, *options)
            verdicts.update(e.get("data-verdict") for e in picture.all("title"))
            states.update(e.get("data-contact-state", "") for e in picture.root.iter())
        self.assertEqual(verdicts, {"stable", "unstable"})
        self.assertEqual(states, {"", "+", "-", "0", "open", "loses", "cannot oppose"})

    def test_cones_and_preloads(self):
        picture = self.drawn("grasp", FIG1, "--preload", "5/2")
        self.assertEqual(len(picture.all("cone")), 3)
        self.assertEqual([e.get("data-value") for e in picture.all("preload")], ["5/2"] * 3)
        for cone in picture.all("cone"):
            points = pictures.subpaths(cone)[0]
            self.assertEqual(len(points), 26)
            left, right = points[1] - points[0], points[-1] - points[0]
            slope = (left.conjugate() * right)  # twice the half angle, tan = 1/2
            self.assertAlmostEqual(abs(slope.imag / slope.real), 4 / 3, places=2)
        self.assertFalse(self.drawn("grasp", FIG1, "--preload", "0").all("preload"))

    def test_virtual_twist_of_a_single_case(self):
        # Six contacts without friction that push up; the load pulls sideways.
        contacts = [((k, k * k), (0, 1)) for k in range(6)]
        self.positions = [p for p, _ in contacts]
        picture = self.check("-", (), stdin=grasp_of(contacts, [1, 0, 0], friction=0))
        self.assertTrue(picture.all("virtual"))
        self.assertTrue(any("The load drives this motion" in t for t in picture.texts()))

    def test_load_of_a_grasp_far_from_the_origin(self):
        contacts = [((1000, 5), (1, 0)), ((1002, 5), (-1, 0))]
        picture = self.drawn("grasp", "-", stdin=grasp_of(contacts, [0, 1, 1001], friction=1, preload=1))
        self.assertFalse(picture.all("torque"))  # at (1001, 5) nothing is left of it
        self.assertTrue("drawn at (1001, 5), where its torque is 0" in " ".join(picture.texts()))


class EveryPicture(unittest.TestCase):
    def pictures(self):
        for path, options in QUESTIONS:
            yield ("plot", "grasp", path, *options)
            yield ("plot", "states", path)

    def test_same_question_same_bytes(self):
        for words in self.pictures():
            first = stickslip(*words)
            self.assertEqual(first[0], 0)
            self.assertEqual(first, ask(*words))

    def test_the_readme_shows_the_picture_that_is_drawn(self):
        with open(os.path.join(HERE, "..", "..", "..", "docs", "fig1.svg"), encoding="utf-8") as file:
            self.assertEqual(file.read(), stickslip("plot", "grasp", FIG1)[1])

    def test_numbers_are_plain(self):
        for words in self.pictures():
            picture = Picture(stickslip(*words)[1])
            width, height = float(picture.root.get("width")), float(picture.root.get("height"))
            for element in picture.root.iter():
                for name, text in element.attrib.items():
                    if name in ("d", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r"):
                        self.assertRegex(text, rf"^(?:[MLAZ ]|{pictures.NUMBER})*$")
                if element.tag.endswith("}text"):
                    self.assertTrue(0 <= float(element.get("x")) <= width)
                    self.assertTrue(0 <= float(element.get("y")) <= height)

    def test_stands_alone(self):
        for words in self.pictures():
            picture = Picture(stickslip(*words)[1])
            self.assertNotRegex(picture.svg.replace("http://www.w3.org/2000/svg", ""), r"https?:|@import")
            names = {e.get("id") for e in picture.root.iter()}
            for name in re.findall(r"url\(#(.*?)\)", picture.svg):
                if "hatch" not in name or picture.all("cells"):
                    self.assertIn(name, names)

    def test_every_light_colour_has_a_dark_one(self):
        style = Picture(stickslip("plot", "states", FIG1)[1]).style
        light, dark = style.split("@media screen and (prefers-color-scheme: dark)")
        for selectors, body in re.findall(r"([^{}]+)\{([^{}]*)\}", light):
            for selector in map(str.strip, selectors.split(",")):
                for prop in re.findall(r"(fill|stroke): #", body):
                    rules = [b for s, b in re.findall(r"([^{}]+)\{([^{}]*)\}", dark)
                             if selector in map(str.strip, s.split(","))]
                    self.assertTrue(any(f"{prop}: #" in b for b in rules), (selector, prop))

    def test_hostile_names(self):
        for name in ("<&\">'", "]]></title><script>", "\u0001\u0000\ufffe", "x" * 500, "\u202e\U0001F916", ""):
            grasp = grasp_of([((0, -1), (0, 1))], [0, -1, 0], name=name, friction="1/2")
            for kind in ("grasp", "states"):
                code, svg, err = stickslip("plot", kind, "-", stdin=grasp)
                self.assertEqual((code, err), (0, ""))
                picture = Picture(svg)
                legal = re.sub("[\u0000-\u001f\ufffe]", "\ufffd", name) or "Grasp"
                shown = picture.root.find("{*}title").text.rsplit(": ", 1)[0]
                self.assertEqual(re.sub("\ufffd+", "\ufffd", shown), re.sub("\ufffd+", "\ufffd", legal))
                self.assertFalse([e for e in picture.root.iter() if e.tag.endswith("}script")])
                title, = picture.all("title")
                self.assertLess(len(title.text), 100)

    def test_files_are_written_whole_or_not_at_all(self):
        with tempfile.TemporaryDirectory() as folder:
            for kind in ("grasp", "states"):
                path = os.path.join(folder, kind + ".svg")
                self.assertEqual(stickslip("plot", kind, FIG1, "-o", path), (0, "", ""))
                with open(path, encoding="utf-8") as file:
                    self.assertEqual(file.read(), stickslip("plot", kind, FIG1)[1])
                missing = os.path.join(folder, "no", "such.svg")
                code, out, err = stickslip("plot", kind, FIG1, "-o", missing)
                self.assertEqual((code, out), (2, ""))
                self.assertIn(missing, err)
                bad = os.path.join(folder, "bad.json")
                self.assertEqual(stickslip("plot", kind, bad, "-o", path)[0], 2)
            self.assertEqual(sorted(os.listdir(folder)), ["grasp.svg", "states.svg"])

    def test_usage(self):
        for words in (("plot",), ("plot", "cube", FIG1), ("plot", "grasp"), ("plot", "states"),
                      ("plot", "states", FIG1, "--wrench", "0,0,0"), ("plot", "grasp", FIG1, FIG4)):
            code, out, err = stickslip(*words)
            self.assertEqual((code, out), (2, ""), words)
            self.assertTrue(err)
        for words in (("plot", "--help"), ("plot", "grasp", "--help"), ("plot", "states", "--help")):
            code, out, err = stickslip(*words)
            self.assertEqual((code, err), (0, ""))
            self.assertIn("svg", out.lower())


if __name__ == "__main__":
    unittest.main()
