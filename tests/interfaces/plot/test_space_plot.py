# SPDX-License-Identifier: GPL-3.0-or-later
"""plot grasp in space: three views of one scale, in each of which everything is the projection of
what decide reports; where decide proves an equilibrium without naming it, forces that obey the laws."""

import cmath
import json
import math
import os
import unittest
from fractions import Fraction

import pictures
from pictures import Picture, area, arrow, ask, contains, stickslip, subpaths

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..", "..")
EXAMPLES = os.path.join(ROOT, "examples", "grasps")
NEAR = os.path.join(ROOT, "tests", "corpus", "near")
PIXEL = 0.02  # two ends, each rounded to 1/100
# Right and up on the page, and the sign of the axis that points at the eye.
VIEWS = (("from above", 0, 1, 2, 1), ("from the front", 0, 2, 1, -1), ("from the right", 1, 2, 0, 1))
BOOK = ("held at its middle", "held off centre")


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def floats(v):
    return list(map(float, v))


def exact(text):
    return [Fraction(part) for part in text.split(",")]


def made(contacts, wrench):
    return json.dumps({"format": "stickslip-grasp/2", "wrench": wrench,
                       "contacts": [{"position": p, "normal": n, "friction": mu, "preload": preload}
                                    for p, n, mu, preload in contacts]})


TABLE = [([3, 2, 0], [0, 0, 1], "1/2", 1), ([3, -2, 0], [0, 0, 1], "1/2", 0), ([-3, 0, 0], [0, 0, 1], 0, 0)]
MADE = {
    "without a contact": made([], [0] * 6), "pulled without a contact": made([], [1, 0, 0, 0, 0, 1]),
    "one contact": made([([1, 2, 3], [1, 2, 2], 1, 0)], [0] * 6),
    "slides with a witness": made(TABLE, [0, 0, -3, 0, 0, 0]),
    "lifted": made(TABLE, [0, 0, 3, 0, 0, 0]),
    "far away": made([([p[0] + 1000, p[1] - 500, p[2]], n, mu, 1) for p, n, mu, _ in TABLE], [0, 0, -1, 500, 1000, 0]),
    "irrational": made([([2 * s + t, 2 * s - t, 2 * s], [-s, -s, -s], "3/10", 4)
                        for s in (-1, 1) for t in (-1, 1)], ["3/2", "3/2", -3, 0, 0, 0]),
    "small load": made([([s, 0, 0], [-s, 0, 0], 1, 1000) for s in (-1, 1)], [0, 0, -1, 0, 0, 0]),
    "huge": made([([f"{s}e400", 0, 0], [-s, 0, 0], 1, "1e300") for s in (-1, 1)], [0, 0, 0, 0, 0, 0]),
}


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def questions():
    for name in ("cup", "corner"):
        yield read(os.path.join(EXAMPLES, f"space-{name}.json")), ()
    for case in BOOK:
        yield read(os.path.join(EXAMPLES, "space-book.json")), ("--case", case)
    yield read(os.path.join(EXAMPLES, "space-cup.json")), ("--preload", 0, "--wrench", "0,0,1,0,0,0")
    yield read(os.path.join(EXAMPLES, "space-cup.json")), ("--normal-law", "bilateral")
    for name in ("box4_1_3s", "box4_1_0u", "sphere4_1_3s", "sphere4_1_2u"):
        yield read(os.path.join(NEAR, name + ".json")), ()
    for text in MADE.values():
        yield text, ()


class Contact:
    def __init__(self, entry, defaults, preload):
        get = lambda key, other: Fraction(str(entry.get(key, defaults.get(key, other))))
        self.position = [Fraction(str(x)) for x in entry["position"]]
        self.normal = [Fraction(str(x)) for x in entry["normal"]]
        self.friction, self.stiffness = get("friction", 0), get("stiffness", 1)
        self.preload = get("preload", 0) if preload is None else Fraction(preload)


class SpacePlot(unittest.TestCase):
    def ask(self, text, options):
        code, svg, err = stickslip("plot", "grasp", "-", *options, stdin=text)
        self.assertEqual((code, err), (0, ""))
        answer = json.loads(stickslip("decide", "-", "--json", *options, stdin=text)[1])
        grasp = json.loads(text)
        preload = options[options.index("--preload") + 1] if "--preload" in options else None
        contacts = [Contact(c, grasp.get("defaults", {}), preload) for c in grasp["contacts"]]
        return Picture(svg), answer, contacts

    def by_view(self, elements):
        """Lists of elements; the three headings stand before what they are about."""
        parts = [[], [], []]
        for e in elements:
            parts[self.view_of[id(e)]].append(e)
        return parts

    def read_views(self, picture):
        view, self.view_of = -1, {}
        for e in picture.root.iter():
            if "".join(e.itertext()).startswith("from ") and e.tag.endswith("}text"):
                view += 1
                self.assertTrue(e.text.startswith(VIEWS[view][0]), e.text)
            self.view_of[id(e)] = view
        self.assertEqual(view, 2)

    def find_centres(self, picture, contacts):
        """Of the marks of all contacts, in each view; their places are one map of the positions."""
        marks = self.by_view([e for kind in ("full", "hollow") for e in picture.all(kind)
                              if e.get("data-contact")])
        self.centres = []
        for view in marks:
            places = {}
            for e in view:
                points = subpaths(e)[0]
                points = points[:2] if "A" in e.get("d") else points
                places[int(e.get("data-contact"))] = sum(points) / len(points)
            self.assertEqual(sorted(places), list(range(len(contacts))))
            self.assertEqual(len(view), len(contacts))
            self.centres.append(places)
        size = max([abs(x) for c in contacts for x in c.position] or [0])
        spans = [max(abs(a.position[j] - b.position[j]) for a in contacts for b in contacts) if contacts
                 else 0 for j in range(3)]
        widest = max(range(3), key=lambda j: spans[j])
        self.scale = None  # pixels for a length of 1
        if spans[widest] == 0:
            return
        view, part = (0, "real" if widest == 0 else "imag") if widest < 2 else (1, "imag")
        along = [getattr(self.centres[view][i], part) for i in range(len(contacts))]
        self.scale = (max(along) - min(along)) / float(spans[widest] / size) if size else None
        for (_, right, up, _, _), places in zip(VIEWS, self.centres):
            for i, a in enumerate(contacts):
                for j, b in enumerate(contacts):
                    way = [float((x - y) / size) for x, y in zip(a.position, b.position)]
                    expected = self.scale * complex(way[right], -way[up])
                    self.assertLess(abs(places[i] - places[j] - expected), 4 * PIXEL)

    def assert_projected(self, elements, key):
        """Arrows of all views are one factor times the projections of their values."""
        shown = [(exact(e.get(key)), arrow(e), VIEWS[self.view_of[id(e)]]) for e in elements]
        if not shown:
            return None
        unit = max(max(map(abs, v)) for v, _, _ in shown)
        flat = lambda v, view: complex(float(v[view[1]] / unit), -float(v[view[2]] / unit))
        value, (tail, tip), view = max(shown, key=lambda part: abs(flat(part[0], part[2])))
        scale = abs(tip - tail) / abs(flat(value, view))
        for v, (tail, tip), view in shown:
            self.assertLess(abs(tip - tail - scale * flat(v, view)), 2 * PIXEL, (v, view))
        # What is not drawn is seen from its tip or its tail.
        for value in {tuple(v) for v, _, _ in shown}:
            count = sum(tuple(v) == value for v, _, _ in shown)
            seen = sum(scale * abs(flat(value, view)) >= 0.01 + PIXEL for view in VIEWS)
            self.assertGreaterEqual(count, seen)
        return scale / float(unit) if unit < 10**300 else None

    def check(self, text, options):
        picture, answer, contacts = self.ask(text, options)
        self.read_views(picture)
        title, = picture.all("title")
        self.assertEqual(title.get("data-verdict"), answer["verdict"])
        self.find_centres(picture, contacts)
        for view in self.by_view(picture.all("cone")):
            self.assertEqual([int(e.get("data-contact")) for e in view], list(range(len(contacts))))
        wrench = list(map(Fraction, answer["wrench"]))
        loads = [e for e in picture.all("load") if e.get("data-value")]
        for e in loads:
            self.assertEqual(exact(e.get("data-value")), wrench[:3])
        self.assertEqual(bool(loads), any(wrench[:3]))
        self.check_torques(picture, contacts, wrench)
        forces, motions = picture.all("force"), picture.all("motion")
        if answer["verdict"] != "stable":
            self.assertFalse(forces + motions + picture.all("ghost"))
            said = {"unstable": "proved by",
                    "undecided": "Undecided: " + answer.get("limit", "")[:40]}[answer["verdict"]]
            self.assertTrue(any(said in t for t in picture.texts()))
            self.assert_projected(loads, "data-value")
            return answer["verdict"]
        key = "data-value" if "twist" in answer else "data-near"
        d = list(map(Fraction, answer["twist" if "twist" in answer else "near"]))
        caption = " ".join(picture.texts())
        self.assertEqual("checked exactly" in caption, "twist" in answer)
        self.assertEqual("proves nothing" in caption, "near" in answer)
        self.assert_projected(motions, key)
        for e in motions:
            c = contacts[int(e.get("data-contact"))]
            self.assertEqual(exact(e.get(key)), plus(d[:3], cross(d[3:], c.position)))
        self.assertEqual(len(picture.all("ghost")), 3 if any(d) and contacts else 0)
        if key == "data-value":
            self.check_witness(picture, answer, contacts)
        else:
            self.check_near(picture, wrench, d, contacts)
        self.assert_projected(forces, key)
        self.check_balance(forces, loads)
        for e in forces + motions:
            centre = self.centres[self.view_of[id(e)]][int(e.get("data-contact"))]
            self.assertLess(abs(arrow(e)[0] - centre), PIXEL)
        return key

    def check_torques(self, picture, contacts, wrench):
        caption = " ".join(picture.texts())
        centre = [0, 0, 0]
        if "drawn at (" in caption:
            text = caption.split("drawn at (")[1].split(")")[0].replace("\u2212", "-")
            centre = [Fraction(x) for x in text.split(", ")]
        torque = plus(wrench[3:], [-x for x in cross(centre, wrench[:3])])
        for (_, _, _, towards, sign), view in zip(VIEWS, self.by_view(picture.all("torque"))):
            seen = sign * torque[towards]
            self.assertEqual([Fraction(e.get("data-value")) for e in view], [seen] if seen else [])
            for e in view:
                self.assertEqual(e.get("data-sense"), "+" if seen > 0 else "-")

    def check_witness(self, picture, answer, contacts):
        marks = {e.get("data-contact"): e.get("data-contact-state") for kind in ("full", "hollow")
                 for e in picture.all(kind)}
        for i, contact in enumerate(answer["contacts"]):
            force = list(map(Fraction, contact["force"]))
            arrows = picture.all("force", contact=str(i))
            self.assertEqual([exact(e.get("data-value")) for e in arrows], [force] * len(arrows))
            self.assertEqual(bool(arrows), any(force))
            self.assertEqual(marks[str(i)] == "open", not contact["closed"])

    def check_near(self, picture, wrench, d, contacts):
        """The laws, at the motion that decide says is near an equilibrium."""
        w, d = floats(wrench), floats(d)
        total, largest = list(w), max(map(abs, w))
        lengths = max([abs(float(x)) for c in contacts for x in c.position])
        for i, c in enumerate(contacts):
            forces = {e.get("data-near") for e in picture.all("force", contact=str(i))}
            self.assertLessEqual(len(forces), 1)
            force = floats(exact(forces.pop())) if forces else [0.0] * 3
            n = floats(c.normal)
            n = [x / math.sqrt(dot(n, n)) for x in n]
            p = floats(c.position)
            moved = plus(d[:3], cross(d[3:], p))
            press, rise = dot(force, n), dot(moved, n)
            wanted = max(0.0, float(c.preload) - float(c.stiffness) * rise)
            self.assertAlmostEqual(press, wanted, delta=1e-6 * (1 + largest))
            friction = plus(force, [-press * x for x in n])
            slip = plus(moved, [-rise * x for x in n])
            size, most = math.sqrt(dot(friction, friction)), float(c.friction) * press
            self.assertLessEqual(size, most * (1 + 1e-6) + 1e-9 * largest)
            state, = {e.get("data-contact-state") for kind in ("full", "hollow")
                      for e in picture.all(kind, contact=str(i))}
            self.assertEqual(state == "open", wanted == 0)
            if state == "slips":
                speed = math.sqrt(dot(slip, slip))
                self.assertAlmostEqual(dot(friction, slip), -most * speed, delta=1e-9 * (1 + most) * speed)
            total = plus(total, force + cross(p, force))
        for j, part in enumerate(total):
            self.assertLess(abs(part), 1e-6 * (largest + 1) * (1 if j < 3 else lengths))

    def check_balance(self, forces, loads):
        """In each view the arrows of the forces and of the load close to a polygon."""
        for view in range(3):
            arrows = [e for e in forces + loads if self.view_of[id(e)] == view]
            total = sum((arrow(e)[1] - arrow(e)[0]) / float(Fraction(e.get("data-factor", "1"))) for e in arrows)
            # Arrows shorter than 1/100 are left out.
            self.assertLess(abs(total), PIXEL * (len(forces) + 1) + 0.15)

    def test_everything_is_a_projection(self):
        found = set()
        for text, options in questions():
            with self.subTest(options=options, grasp=text):
                found.add(self.check(text, options))
        self.assertLessEqual({"data-value", "data-near", "unstable"}, found)

    def test_cones_are_outlines_of_round_ones(self):
        size, mu = {}, 0.5
        picture, _, _ = self.ask(made([([1, 0, 0], [-3, 0, 0], mu, 0), ([-1, 0, 0], [1, 0, 0], mu, 0),
                                       ([0, 0, -1], [0, 0, 1], mu, 0)], [0, 0, -1, 0, 0, 0]), ())
        self.read_views(picture)
        for (_, right, up, _, _), view in zip(VIEWS, self.by_view(picture.all("cone"))):
            for e in view:
                points = subpaths(e)[0]
                span = [max(f(p) for p in points) - min(f(p) for p in points)
                        for f in (lambda p: p.real, lambda p: p.imag)]
                axis = 2 if e.get("data-contact") == "2" else 0
                for part, number in zip((right, up), span):
                    size.setdefault(part == axis, []).append(number)
        # Along its normal each has the length L, across it everywhere 2 L sin(atan mu).
        length = size[True][0]
        for number in size[True]:
            self.assertAlmostEqual(number, length, delta=PIXEL)
        for number in size[False]:
            self.assertAlmostEqual(number, 2 * length * math.sin(math.atan(mu)), delta=0.01 * length)
        self.assertEqual((len(size[True]), len(size[False])), (6, 12))

    def test_preloads_stand_on_the_normals_that_are_seen(self):
        picture, _, _ = self.ask(MADE["irrational"], ())
        self.assertEqual(len(picture.all("preload")), 12)
        picture, _, _ = self.ask(read(os.path.join(EXAMPLES, "space-book.json")), ("--case", BOOK[0]))
        self.read_views(picture)
        self.assertEqual(list(map(len, self.by_view(picture.all("preload")))), [4, 4, 0])
        self.assertEqual({e.get("data-value") for e in picture.all("preload")}, {"5"})

    def test_a_body_is_where_its_faces_are_seen(self):
        # A frame of four bars, of which one can see through the hole, some of their faces turned around, one bar of
        # triangles. Whether a face is seen at a point says a ray.
        grasp = json.loads(made([([-3, 0, 0], [1, 0, 0], "1/2", 4), ([3, 0, 1], [-1, 0, 0], "1/2", 4)],
                                [1, 0, -1, 0, 0, 0]))
        vertices, faces = [], []
        for low, high in (([-3, -1, -3], [-2, 1, 3]), ([2, -1, -3], [3, 1, 3]), ([-2, -1, 2], [2, 1, 3]),
                          ([-2, 0, -3], [2, 1, -2])):
            first = len(vertices)
            vertices += [[ends[k >> j & 1] for j, ends in enumerate(zip(low, high))] for k in range(8)]
            for face in ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)):
                faces.append([first + v for v in (face if len(faces) % 3 else face[::-1])])
        faces = [f for face in faces[:6] for f in (face[:3], [face[0], *face[2:]])] + faces[6:]
        grasp["body"] = {"vertices": vertices, "faces": faces}
        picture, _, contacts = self.ask(json.dumps(grasp), ())
        self.read_views(picture)
        self.find_centres(picture, contacts)
        self.assertIn("body", picture.texts())
        self.assertEqual(len(picture.all("ghost")), 3)
        seen = []
        for (_, right, up, _, _), centre, (path,) in zip(VIEWS, self.centres, self.by_view(picture.all("body"))):
            self.assertIsNone(path.get("fill-rule"), "what rings wind around is inside")
            origin = contacts[0].position
            flat = lambda p: centre[0] + self.scale / 3 * complex(p[right] - origin[right], -(p[up] - origin[up]))
            projected = [[flat(vertices[v]) for v in face] for face in faces]
            for x in range(-8, 9):
                for y in range(-8, 9):
                    at = [0.41 * x + 0.013, 0.41 * y + 0.017]
                    p = [0, 0, 0]
                    p[right], p[up] = at
                    p = flat(p)
                    turns = sum(cmath.phase((b - p) / (a - p)) for ring in subpaths(path)
                                for a, b in zip(ring, ring[1:] + ring[:1]))
                    seen.append(any(contains(face, p) for face in projected if abs(area(face)) > 1))
                    self.assertEqual(abs(turns) > 3, seen[-1], (right, up, at))
        self.assertEqual((True in seen, seen.count(False) > 3 * 9), (True, True))

    def test_errors(self):
        book = os.path.join(EXAMPLES, "space-book.json")
        interval = MADE["lifted"].replace('"1/2"', '{"min": 0, "max": 1}')
        for words, stdin, naming in (
                ((book,), None, ["--case", "held at its middle"]),
                ((book, "--wrench", "0,1,0"), None, ["--wrench", "in space"]),
                (("-",), interval, ["contacts[0].friction", "uncertain"])):
            code, out, err = stickslip("plot", "grasp", *words, stdin=stdin)
            self.assertEqual((code, out), (2, ""))
            for word in naming:
                self.assertIn(word, err)

    def test_same_question_same_bytes(self):
        for text, options in questions():
            words = ("plot", "grasp", "-", *options)
            self.assertEqual(stickslip(*words, stdin=text), ask(*words, stdin=text))

    def test_the_page_shows_the_picture_that_is_drawn(self):
        self.assertEqual(read(os.path.join(ROOT, "docs", "space-cup.svg")),
                         stickslip("plot", "grasp", os.path.join(EXAMPLES, "space-cup.json"))[1])


if __name__ == "__main__":
    unittest.main()
