# SPDX-License-Identifier: GPL-3.0-or-later
"""plot states: every place of the picture shows the slip state that the contacts really have there.

The oracle is the model alone: T.d of each contact, at motions that the inverse of the projection
gives. Nothing is shared with the program.
"""

import json
import os
import random
import unittest

import pictures
from pictures import Discs, Picture, stickslip

HERE = os.path.dirname(os.path.abspath(__file__))
CORPUS = os.path.join(HERE, "..", "..", "corpus", "grasps", "good")
PAPER = os.path.join(HERE, "..", "..", "..", "paper_examples", "grasps")
STEPS = 23  # of the grid of places on each disc
INK = 0.004  # places are rounded to 1/100 pixel of a radius of 148, and arcs are polylines


def grasp_of(contacts, friction="1/2"):
    return {"format": "stickslip-grasp/1", "wrench": [0, 0, 0], "defaults": {"friction": friction},
            "contacts": [{"position": list(p), "normal": list(n)} for p, n in contacts]}


DEGENERATE = {
    "no contact": [],
    "one contact": [((2, 1), (3, 5))],
    "one contact at the origin": [((0, 0), (0, -1))],
    "two at one point": [((1, 1), (1, 2)), ((1, 1), (-2, 1))],
    "two circles that coincide": [((0, 0), (0, 1)), ((4, 0), (0, -1))],
    "pencil of translations": [((0, y), (0, 1)) for y in range(4)],
    "pencil inside": [((0, 0), n) for n in ((1, 0), (1, 1), (0, 1), (-1, 2))],
    "pencil aside": [((3, 4), n) for n in ((1, 0), (1, 1), (0, 1))] + [((0, 4), (0, -1))],
    "tangents through the middle": [((x, 0), (0, 1)) for x in (-1, 1)] + [((0, 1), (1, 0))],
    "far from the origin": [((1000, 1000), (1, 0)), ((1001, 1000), (0, 1)), ((1000, 1001), (1, 1))],
    "nearly coincident": [((0, 0), (1, 0)), ((0, 1), (1, "1e-9")), ((1, 1), (0, 1))],
    # The rim is crossed, and vertices lie, at places that no double tells apart.
    "nearly parallel": [((-4, -1), (18, "72.99999999999999994")), ((2, 2), (18, "73.00000000000000006")),
                        ((5, 1), (18, "72.99999999999999997"))],
    "nearly parallel, two of them equal": [((-5, -5), (14, "40.99999999999999991")),
                                   ((5, 3), (14, "40.99999999999999991")),
                                   ((1, 5), (14, "40.99999999999999997"))],
    "tiny and huge": [((0, 0), ("1e-300", "1e-300")), (("1e200", 0), ("1e300", 0)),
                      ((0, "1e200"), (0, 1))],
}


class StatesPlot(unittest.TestCase):
    def check(self, grasp, text=None):
        text = text if text is not None else json.dumps(grasp)
        code, svg, err = stickslip("plot", "states", "-", stdin=text)
        self.assertEqual((code, err), (0, ""))
        counts = json.loads(stickslip("states", "-", "--json", "--list", stdin=text)[1])
        picture = Picture(svg)
        contacts = pictures.contacts_of(grasp)
        cells = {kind: picture.all(kind) for kind in ("face", "edge", "vertex")}
        for kind, name in (("face", "faces"), ("edge", "edges"), ("vertex", "vertices")):
            self.assertEqual(len(cells[kind]), counts[name], kind)
        shown = [e.get("data-state") for kind in cells.values() for e in kind]
        self.assertEqual(sorted(set(shown) | {"0" * len(contacts)}), counts["states"])
        faces = [e.get("data-state") for e in cells["face"]]
        self.assertEqual(len(set(faces)), len(faces))
        caption = " ".join(picture.texts())
        for number in (f"= {counts['cells']} cell", f"; {counts['distinct_states']} distinct"):
            self.assertIn(number, caption)

        discs = Discs(picture)
        self.check_faces(cells["face"], discs, contacts)
        self.check_thin_cells(cells["edge"] + cells["vertex"], discs, contacts)
        self.check_numbers(picture, discs, contacts)
        return picture

    def check_numbers(self, picture, discs, contacts):
        """A number stands where its contact slips +."""
        for e in picture.all("number"):
            place = complex(float(e.get("x")), float(e.get("y")) - 4)
            disc, (centre, radius) = min(enumerate(discs.discs), key=lambda d: abs(place - d[1][0]))
            if abs(place - centre) < 0.99 * radius:
                for number in e.text.split(", "):
                    if number != "\u2026":
                        self.assertGreater(discs.slip(contacts[int(number)], discs.motion(disc, place)), -INK)

    def check_faces(self, faces, discs, contacts):
        polygons = [[[], []] for _ in faces]  # by disc
        for sides, face in zip(polygons, faces):
            for polygon in pictures.subpaths(face):
                middle = sum(polygon) / len(polygon)
                disc = min((0, 1), key=lambda k: abs(middle - discs.discs[k][0]))
                sides[disc].append(polygon)
        for disc, (centre, radius) in enumerate(discs.discs):
            whole = sum(pictures.area(p) for sides in polygons for p in sides[disc])
            self.assertAlmostEqual(whole / (3.14159265 * radius**2), 1, places=2)
            # By the row, which few of them cross.
            spans = [[(min(p.imag for p in polygon), max(p.imag for p in polygon), polygon) for polygon in sides[disc]] for sides in polygons]
            for j in range(STEPS):
                row = centre.imag + radius * (2 * j + 1 - STEPS) / STEPS
                crossed = [[polygon for low, high, polygon in sides if low <= row <= high] for sides in spans]
                for i in range(STEPS):
                    place = centre + radius * complex(2 * i + 1 - STEPS, 2 * j + 1 - STEPS) / STEPS
                    if abs(place - centre) > 0.99 * radius:
                        continue
                    d = discs.motion(disc, place)
                    slips = [discs.slip(contact, d) for contact in contacts]
                    # Scaled: d may move the origin far.
                    if any(abs(slip) < INK for slip in slips):
                        continue
                    state = "".join("+" if slip > 0 else "-" for slip in slips)
                    inside = [face.get("data-state") for sides, face in zip(crossed, faces)
                              if sum(pictures.contains(p, place) for p in sides) % 2]
                    self.assertEqual(inside, [state], (disc, place))

    def check_thin_cells(self, cells, discs, contacts):
        for cell in cells:
            for points in pictures.subpaths(cell):
                if "vertex" in cell.get("class").split():
                    points = [sum(points[:2]) / 2]
                for k, point in enumerate(points):
                    disc = min((0, 1), key=lambda n: abs(point - discs.discs[n][0]))
                    d = discs.motion(disc, point)
                    at_end = k in (0, len(points) - 1) and len(points) > 1
                    for sign, contact in zip(cell.get("data-state"), contacts):
                        slip = discs.slip(contact, d)
                        if sign == "0":
                            self.assertLess(abs(slip), INK)
                        elif not at_end:
                            self.assertGreater(slip * int(sign + "1"), -INK)

    def test_paper(self):
        for name, faces in (("fig1", 8), ("fig4", 4)):
            path = os.path.join(PAPER, name + ".json")
            with open(path, encoding="utf-8") as file:
                picture = self.check(pictures.load(path), file.read())
            self.assertEqual(len(picture.all("face")), faces)
            hatched = [e for e in picture.all("face") if "hatch" in e.get("class")]
            self.assertEqual(len(hatched), faces / 2)
            self.assertTrue(all(e.get("data-state")[0] == "-" for e in hatched))
            colours = {e.get("class")[-1] for e in picture.all("face")}
            self.assertEqual(len(colours), faces / 2)

    def test_degenerate(self):
        for name, contacts in DEGENERATE.items():
            with self.subTest(name):
                self.check(grasp_of(contacts))

    def test_corpus(self):
        for name in sorted(os.listdir(CORPUS)):
            path = os.path.join(CORPUS, name)
            if name != "exact_numbers.json":  # spelt as no Fraction is; drawn below
                with self.subTest(name), open(path, encoding="utf-8-sig") as file:
                    self.check(pictures.load(path), file.read())
        picture = Picture(stickslip("plot", "states", os.path.join(CORPUS, "exact_numbers.json"))[1])
        self.assertEqual(len(picture.all("face")), 8)

    def test_small_worlds(self):
        rng = random.Random(5)
        directions = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (3, -4)]
        for size in (2, 3, 4, 5, 6) * 4:
            contacts = [((rng.randint(-1, 1), rng.randint(-1, 1)), rng.choice(directions))
                        for _ in range(size)]
            with self.subTest(contacts):
                self.check(grasp_of(contacts))

    def test_one_colour_for_opposite_states_or_shades(self):
        rng = random.Random(8)
        many = [((rng.randint(-99, 99), rng.randint(-99, 99)), (rng.randint(1, 99), rng.randint(-99, 99)))
                for _ in range(12)]
        picture = self.check(grasp_of(many))
        for face in picture.all("face"):
            shade = face.get("data-state").count("+") * 8 // 12
            self.assertEqual(face.get("class"), f"face shade{shade}")

    def test_too_many_circles(self):
        many = [((k, k * k), (1, 2 * k)) for k in range(101)]
        code, out, err = stickslip("plot", "states", "-", stdin=json.dumps(grasp_of(many)))
        self.assertEqual((code, out), (2, ""))
        self.assertIn("101 circles", err)
        self.assertIn("at most 100", err)


CUBE = {"format": "stickslip-grasp/2", "name": "cube on a floor", "defaults": {"friction": "1/2"}, "wrench": [0] * 6,
        "contacts": [{"position": [x, y, 0], "normal": [0, 0, 1]} for x in (-1, 1) for y in (-1, 1)]}


class StateLayers(unittest.TestCase):
    """Rows of states by dimension: the states are those of the list, and lines are what their signs say."""

    def check(self, grasp, *modes):
        code, svg, err = stickslip("plot", "states", "-", *modes, stdin=json.dumps(grasp))
        self.assertEqual((code, err), (0, ""))
        answer = json.loads(stickslip("states", "-", "--json", "--list", *(modes or ("--lines", "0")), stdin=json.dumps(grasp))[1])
        states = {state["state"]: state for state in answer["states"]}
        picture = Picture(svg)
        nodes, boxes = {}, {}
        for node in picture.all("node"):
            self.assertNotIn(node.get("data-state"), nodes)
            nodes[node.get("data-state")] = int(node.get("data-dimension"))
            [corners] = pictures.subpaths(node)
            boxes[node.get("data-state")] = corners[0], corners[2]
        self.assertEqual(nodes, {name: state["dimension"] for name, state in states.items()})
        for name, (low, high) in boxes.items():
            self.assertTrue(0 < low.real and high.real < float(picture.root.get("width")))
            for other, (start, end) in boxes.items():
                apart = high.real < start.real or end.real < low.real or high.imag < start.imag or end.imag < low.imag
                self.assertTrue(apart or other == name)
                self.assertEqual(low.imag < start.imag, nodes[name] > nodes[other])

        def tends(above, below):
            """Whether each row has 0 below, the same sign, or does not count above."""
            return all(row in states[above][sign] or not any(row in states[above][s] for s in ("zero", "positive", "negative"))
                       for sign in ("positive", "negative") for row in states[below][sign])

        links = sorted((line.get("data-from"), line.get("data-to")) for line in picture.all("link"))
        self.assertEqual(links, sorted((a, b) for a in states for b in states if nodes[a] == nodes[b] + 1 and tends(a, b)))
        for line in picture.all("link"):
            ends = [complex(float(line.get("x" + i)), float(line.get("y" + i))) for i in "12"]
            for end, name, side in ((ends[0], line.get("data-from"), 1), (ends[1], line.get("data-to"), 0)):
                low, high = boxes[name]
                self.assertTrue(low.real < end.real < high.real)
                self.assertAlmostEqual(end.imag, (low, high)[side].imag)
        return nodes, links, picture

    def test_a_cube_on_a_floor(self):
        nodes, links, picture = self.check(CUBE)
        self.assertEqual([list(nodes.values()).count(d) for d in range(7)], [0, 0, 0, 1, 12, 24, 14])
        # The rhombic dodecahedron: an edge has two corners, which are cells, and two faces.
        self.assertEqual(len(links), 2 * 24 + 2 * 24 + 12)
        graph = json.loads(stickslip("states", "-", "--graph", "--json", stdin=json.dumps(CUBE))[1])
        for facet in graph["facets"]:
            self.assertEqual({graph["cells"][i] for i in facet["cells"]}, {a for a, b in links if b == facet["state"]})
        self.assertIn("d = 5: 24", picture.texts())
        with open(os.path.join(HERE, "..", "..", "..", "docs", "states-cube.svg"), encoding="utf-8") as file:
            self.assertEqual(file.read(), picture.svg)

    def test_other_states(self):
        blocks = {"format": "stickslip-grasp/3", "bodies": [{"name": "lower"}, {"name": "upper"}],
                  "contacts": [{"position": [x, 1], "normal": [0, 1], "friction": 1, "of": "upper", "by": "lower"} for x in (-1, 2)]}
        flat = grasp_of([((-1, 0), (1, 0)), ((0, -1), (0, 1))])
        for grasp, *modes in ((CUBE, "cs"), (CUBE, "ss"), (CUBE, "closed"), (flat, "full"), (flat, "ss"), (blocks, "ss"), (grasp_of([]), "cs"),
                              ({**CUBE, "contacts": CUBE["contacts"][:1]}, "full")):
            self.check(grasp, "--modes", *modes)
        self.check(blocks)

    def test_too_many_states(self):
        three = {**CUBE, "contacts": [{**contact, "normal": [i, 1 - i, 2]} for i, contact in enumerate(CUBE["contacts"][:3])]}
        code, out, err = stickslip("plot", "states", "-", stdin=json.dumps(three))
        self.assertEqual((code, out), (2, ""))
        self.assertIn("more than 200 states", err)


if __name__ == "__main__":
    unittest.main()
