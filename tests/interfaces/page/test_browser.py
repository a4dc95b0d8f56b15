# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages in a browser: what they show is what `stickslip decide` and the others say."""

import json
import math
import os
import re
import subprocess
import unittest
from fractions import Fraction

from browser import FIG1, STICKSLIP_CHECK, Keys, PageTest, cube, decide, example, in_file, run

QUICK = ("--time-limit", "1")  # for who does not look at the map, which takes seconds
MARKS = {"+": "plus", "-": "minus", "0": "stick"}


def mark_of(contact):
    return MARKS[contact["slip"]] if contact["closed"] else "open"


def is_written(path):
    """A download begins as an empty file."""
    return os.path.exists(path) and os.path.getsize(path) > 0


class Planar(PageTest):
    def test_a_stable_grasp_with_an_outline(self):
        grasp = example("bracket")
        self.open(grasp)
        verdict = decide(grasp)
        self.assertEqual(verdict["verdict"], "stable")
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), "stable")
        self.assertIn("holds this load", self.text("#verdict"))
        self.assertIn(verdict["name"], self.text("#name"))
        self.assertEqual(self.attributes("[data-contact-does]", "data-contact-does"),
                         [mark_of(c) for c in verdict["contacts"]])
        self.assertEqual(self.attributes("#body [data-contact-state]", "data-contact-state"),
                         [mark_of(c) for c in verdict["contacts"]])
        forces = [[float(x) for x in e.get_attribute("data-value").split(",")] for e in self.all("#body path.force")]
        self.assertEqual(forces, [[float(Fraction(x)) for x in c["force"]] for c in verdict["contacts"]])
        # Two rings: the outside and the hole.
        self.assertEqual(self.find("#body path.body").get_attribute("d").count("M"), 2)
        # An example to start from is no example of a trap.
        self.assertEqual(verdict["warnings"], [])
        self.assertNotIn("Warning", self.text("#why"))
        self.picture("stable-outline")

    def test_warnings_are_shown(self):
        grasp = example("more-preload-breaks")
        self.open(grasp, *QUICK)
        warning, = decide(grasp)["warnings"]
        self.assertEqual(warning["trap"], "unbalanced-preload")
        self.assertIn(warning["text"], self.text("#why"))

    def test_all_digits_are_there_for_who_asks(self):
        self.open(FIG1, "--wrench", "1/3,-100/301,0", *QUICK)
        self.assertNotIn("100/301", self.text("#why"))
        self.find("#exact-numbers").click()
        self.assertIn("\u2212100/301", self.text("#why"))
        self.find("#exact-panel summary").click()
        self.assertIn("(1/3, \u2212100/301, 0)", self.text("#exact"))

    def test_an_unstable_grasp_and_the_twist_that_wins(self):
        self.set_media(prefers_reduced_motion="no-preference")
        answer = self.open(FIG1, "--wrench", "0,11/10,0", *QUICK)
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), "unstable")
        self.assertEqual(decide(FIG1, "--wrench", "0,11/10,0")["verdict"], "unstable")
        leaves = [node[1:] for node in json.loads(answer["certificate"])["tree"] if node[0] == "leaf"]
        self.assertGreater(len(leaves), 1)
        seen = []
        for _ in leaves:
            number = int(re.search(r"Leaf (\d+) of (\d+)", self.text("#motion-words")).group(1))
            twist = [str(-Fraction(y)) for y in leaves[number - 1]]
            self.assertIn("(" + ", ".join(twist).replace("-", "\u2212") + ")", self.text("#motion-words"))
            work = sum(Fraction(y) * Fraction(w) for y, w in zip(twist, ("0", "11/10", "0")))
            self.assertIn("drives" if work > 0 else "works against" if work < 0 else "does no work", self.text("#motion-words"))
            seen.append(number)
            self.find("[data-choice='leaf-after']").click()
        self.assertEqual(sorted(seen), list(range(1, len(leaves) + 1)))
        # The one shown first is that of the program's text.
        text = run("decide", FIG1, "--wrench", "0,11/10,0")
        largest = re.search(r"The largest leaf:\n((?:  .*\n)*)", text).group(1)
        self.assertEqual(re.search(r"twist (\(.*\))", largest).group(1),
                         "(" + ", ".join(str(-Fraction(y)) for y in leaves[seen[0] - 1]) + ")")
        self.moves_and_rests()
        self.picture("unstable")

    def moves_and_rests(self):
        place = "return document.querySelector('#body .moving').getAttribute('transform')"
        before = self.js(place)
        self.wait(lambda: self.js(place) != before, "the body moves")
        self.find("#pause").click()
        rest = self.js(place)
        self.js("return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        self.assertEqual(self.js(place), rest)

    def test_who_asked_for_no_motion_sees_none(self):
        self.set_media(prefers_reduced_motion="reduce")
        self.open(FIG1, "--wrench", "0,11/10,0", *QUICK)
        self.assertTrue(self.js("return StickslipPage.isPaused()"))

    def test_no_outline(self):
        answer = self.open(FIG1)
        self.assertIsNone(answer["outline"])
        self.assertIn("No outline is given", self.text("#body-legend"))
        self.assertEqual(self.attributes("#compare tr[data-method]", "data-method"), [row["method"] for row in answer["compare"]["methods"]])
        self.assertEqual([row["method"] for row in json.loads(run("compare", FIG1, "--json"))["methods"]],
                         [row["method"] for row in answer["compare"]["methods"]])
        self.picture("stable-no-outline")

    def test_a_name_is_text(self):
        name = "</script><img src=x onerror=alert(1)>&lt;"
        path = os.path.join(self.folder, "name.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"format": "stickslip-grasp/1", "name": name, "contacts": [], "wrench": [0, 0, 0]}, file)
        self.open(path)
        self.assertEqual(self.text("#name"), name)
        self.assertEqual(self.all("img"), [])
        self.assertIn("There are no contacts", self.text("#contacts"))
        self.picture("no-contacts")


class Sphere(PageTest):
    def axes(self):
        return self.js("return StickslipPage.sphereState().axes")

    def test_it_turns(self):
        self.open(FIG1)
        home = self.axes()
        canvas = self.find("#sphere")
        self.drag(canvas, 60, 35)
        turned = self.axes()
        self.assertNotEqual(turned, home)
        self.assertIsNone(self.js("return StickslipPage.shown.cell"), "to turn is not to choose")
        for i in range(3):
            for j in range(3):
                product = sum(a * b for a, b in zip(turned[i], turned[j]))
                self.assertAlmostEqual(product, 1 if i == j else 0, places=9)
        # What is drawn to the right goes to the right.
        self.press(Keys.HOME)
        self.assertEqual(self.axes(), home)
        self.assertGreater(self.js("return StickslipPage.spherePlace([0, 0, 1])[0]"), 0)
        before = self.js("return StickslipPage.spherePlace([0, 0, 1])")
        self.drag(canvas, 30, -20)
        after = self.js("return StickslipPage.spherePlace([0, 0, 1])")
        self.assertGreater(after[0], before[0])
        self.assertLess(after[1], before[1])
        for key in (Keys.ARROW_LEFT, Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.ARROW_DOWN):
            before = self.axes()
            self.press(key)
            self.assertNotEqual(self.axes(), before)

    def test_its_cells_are_the_slip_states(self):
        answer = self.open(FIG1)
        listed = set(json.loads(run("states", FIG1, "--json", "--list"))["states"])
        cells = answer["states"]["cells"]
        self.assertEqual({cell["states"] for cell in cells}, listed - {"000"})
        self.assertEqual(len(cells), 26)
        # A cell is where its motion is; vertices and edges are pointed at first.
        seen = 0
        for k, cell in enumerate(cells):
            place = self.js("return StickslipPage.spherePlace(arguments[0])", cell["motion"])
            if place is None:
                continue
            at = self.js("return StickslipPage.sphereCell(arguments[0][0], arguments[0][1])", place)
            if at == k:
                seen += 1
            else:
                self.assertNotEqual(cells[at]["kind"], "face", (cell, cells[at]))
        self.assertGreater(seen, 8)

    def test_a_cell_is_chosen_and_its_motion_shown(self):
        answer = self.open(FIG1)
        cells = answer["states"]["cells"]
        chosen = next(k for k, cell in enumerate(cells) if cell["kind"] == "face" and cell["states"] == "---")
        place = self.js("return StickslipPage.spherePlace(arguments[0])", cells[chosen]["motion"])
        canvas = self.find("#sphere")
        half = self.js("return arguments[0].clientWidth / 2", canvas)
        self.point_at(canvas, place[0] - half, place[1] - half).click().perform()
        self.assertEqual(self.js("return StickslipPage.shown.cell"), chosen)
        self.assertIn("\u2212\u2212\u2212", self.text("#motion-words"))
        self.assertIn("counterclockwise", self.text("#motion-words"))
        self.picture("cell")

    def test_each_motion_slips_as_its_cell_says(self):
        answer = self.open(example("bracket"))
        for k, cell in enumerate(answer["states"]["cells"]):
            self.js("StickslipPage.chooseCell(arguments[0])", k)
            self.assertEqual(self.attributes("[data-contact-does]", "data-contact-does"),
                             [MARKS[c] for c in cell["states"]])
            x, y, r = cell["motion"]
            size = max(abs(x), abs(y), abs(r) * 40)
            for contact, state in zip(answer["contacts"], cell["states"]):
                (px, py), (nx, ny) = contact["position"], contact["normal"]
                slip = (-ny * (x - r * py) + nx * (y + r * px)) / (nx * nx + ny * ny) ** 0.5 / size
                self.assertEqual("0" if abs(slip) < 1e-9 else "+" if slip > 0 else "-", state)
            pivots = self.all("#body [data-pivot]")
            for pivot in pivots:
                px, py = (float(c) for c in pivot.get_attribute("data-pivot").split(","))
                self.assertAlmostEqual((x - r * py) / size, 0, places=9)
                self.assertAlmostEqual((y + r * px) / size, 0, places=9)

    def test_many_contacts(self):
        contacts = []
        for k in range(20):
            n = [(3, 4), (4, 3), (5, 12), (12, 5), (8, 15)][k % 5]
            turned = [n, (-n[1], n[0]), (-n[0], -n[1]), (n[1], -n[0])][k // 5]
            contacts.append({"position": [f"{-turned[0] * (10 + k)}/100", f"{-turned[1] * (10 - k % 3)}/100"], "normal": turned})
        path = os.path.join(self.folder, "many.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"format": "stickslip-grasp/1", "name": "twenty", "defaults": {"friction": "2/5", "preload": 1},
                       "contacts": contacts, "wrench": [1, -6, "1/2"]}, file)
        answer = self.open(path)
        self.assertLess(self.size, 1000000)
        self.assertGreater(len(answer["states"]["cells"]), 1000)
        self.find("#cell-after").click()
        self.assertEqual(self.js("return StickslipPage.shown.cell"), 0)
        self.picture("twenty-contacts")


def within(point, ring):
    """Whether a point is inside of a polygon, by crossings."""
    inside = False
    for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1]):
        if (y0 > point[1]) != (y1 > point[1]) and point[0] < x0 + (point[1] - y0) * (x1 - x0) / (y1 - y0):
            inside = not inside
    return inside


class Loads(PageTest):
    def test_the_region_and_the_present_load(self):
        for wrench, verdict in (("0,9/10,0", "stable"), ("1,3/5,0", "unstable"), ("-5,-2,0", "stable"), ("2,1/5,0", "unstable")):
            with self.subTest(wrench):
                self.open(FIG1, "--wrench", wrench, *QUICK)
                self.assertEqual(decide(FIG1, "--wrench", wrench)["verdict"], verdict)
                s, t = (float(x) for x in self.find("#region .present").get_attribute("data-load").split(","))
                self.assertEqual([s, t], [float(Fraction(x)) for x in wrench.split(",")[:2]])
                d = self.find("#region path.area").get_attribute("d")
                ring = [tuple(map(float, p.split())) for p in d.strip("MZ").split("L")]
                x, y = self.js("return StickslipPage.regionView().place([arguments[0], arguments[1]])", s, t)
                self.assertEqual(within((x, y), ring), verdict == "stable")

    def test_labels_of_corners_keep_off_borders_and_each_other(self):
        fig4 = os.path.join(os.path.dirname(FIG1), "fig4.json")
        for width in (375, 1300):
            for grasp, options in ((example("bracket"), ()), (example("more-friction-breaks"), ()),
                                   (fig4, ("--wrench", "1,1,1/7", "--preload", "0.7654321", *QUICK))):
                with self.subTest((grasp, width)):
                    self.set_size(width, 900)
                    self.open(grasp, *options)
                    labels = self.js("""return [...document.querySelectorAll('#region text.halo')].map((e) => {
                        const { x, y, width, height } = e.getBBox();
                        return [e.textContent, x, y + 2, x + width, y + height - 2];
                    })""")
                    self.assertGreater(len(labels), 1)
                    d = self.find("#region path.border").get_attribute("d")
                    lines = [[tuple(map(float, p.split())) for p in part.split("L")] for part in d.split("M")[1:]]
                    for k, (text, x0, y0, x1, y1) in enumerate(labels):
                        self.assertLessEqual(text.count("~"), 1)
                        for other in labels[:k]:
                            self.assertFalse(x0 < other[3] and other[1] < x1 and y0 < other[4] and other[2] < y1, (text, other))
                        for line in lines:
                            for (ax, ay), (bx, by) in zip(line, line[1:]):
                                for step in range(501):
                                    x, y = ax + (bx - ax) * step / 500, ay + (by - ay) * step / 500
                                    self.assertFalse(x0 < x < x1 and y0 < y < y1, text)

    def test_regions_without_end(self):
        """Two areas' worth of half planes: what goes on without end is filled on the right side."""
        grasp = example("bracket")
        self.open(grasp)
        d = self.find("#region path.area").get_attribute("d")
        ring = [tuple(map(float, p.split())) for p in d.strip("MZ").split("L")]
        for s, t in ((0, 0), (12, 0), (-12, 1), (0, 20), (0, -20), (8, -2), (-8, -2), (15, 14), (15, -3), (-20, 10)):
            x, y = self.js("return StickslipPage.regionView().place([arguments[0], arguments[1]])", s, t)
            torque = json.loads(run("region", grasp, "--json", "--torque", "-81/2"))["plane"]["origin"][2]
            verdict = decide(grasp, "--wrench", f"{s},{t},{torque}")["verdict"]
            self.assertEqual("stable" if within((x, y), ring) else "unstable", verdict, (s, t))

    def test_the_margin(self):
        self.open(example("more-friction-breaks"))
        margin = json.loads(run("margin", example("more-friction-breaks"), "--json", "--direction", "-2,2,-2"))
        for interval in margin["resisted"]:
            for end in interval:
                if end is not None:
                    self.assertIn(end.replace("-", "\u2212"), self.text("#margin-note"))

    def test_the_map_is_about_this_grasp(self):
        answer = self.open(example("more-friction-breaks"))
        self.assertEqual(len(self.all("#map .present")), 1)
        self.assertEqual({cell["verdict"] for cell in answer["map"]["cells"]} - {"stable", "unstable", "undecided"}, set())
        self.picture("more-friction-breaks")


class Proofs(PageTest):
    def test_a_true_proof_is_accepted_and_a_false_one_is_not(self):
        self.open(FIG1, "--wrench", "0,11/10,0", *QUICK)
        self.assertEqual(self.check_proof(), "accepted")
        self.assertIn("ms", self.text("#proof-result"))
        self.js("""const { answer } = StickslipPage;
                   answer.certificate = answer.certificate.replace('["leaf",0,-1,0]', '["leaf",0,1,0]');
                   StickslipPage.draw();""")
        self.assertTrue(self.js("return document.getElementById('proof-result').hidden"), "nothing is said of another proof")
        self.assertEqual(self.js("return StickslipPage.checkProof().answer"), "rejected")
        self.assertIn("leaf-bound", self.text("#proof-result"))

    def test_downloads(self):
        self.open(FIG1)
        self.find("#save-proof").click()
        self.find("#save-grasp").click()
        names = [os.path.join(self.downloads, name) for name in ("Fig-1.json", "Fig-1.certificate.json")]
        self.wait(lambda: all(map(is_written, names)), "two files")
        checked = subprocess.run([STICKSLIP_CHECK, *names], capture_output=True, text=True, check=False)
        self.assertEqual(checked.stdout.split("\n")[0], "accepted", checked.stderr)


class Space(PageTest):
    def colours(self):
        """How many colours the drawing has."""
        return self.js("""const from = document.getElementById('space-canvas'), to = document.createElement('canvas');
            to.width = to.height = 64;
            const context = to.getContext('2d');
            context.drawImage(from, 0, 0, 64, 64);
            return new Set(new Uint32Array(context.getImageData(0, 0, 64, 64).data.buffer)).size""")

    def shot(self):
        return self.js("return document.getElementById('space-canvas').toDataURL()")

    def test_stable_with_a_witness(self):
        self.open(example("space-cup"), *QUICK)
        self.assertLess(self.size, 1000000)
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), "stable")
        self.assertGreater(self.colours(), 30)
        verdict = decide(example("space-cup"))
        self.assertIn("(2, 0, 3/4)", self.text("#contacts"))
        self.assertEqual(verdict["contacts"][0]["force"], ["2", "0", "3/4"])
        self.assertEqual(self.check_proof(), "accepted")
        self.picture("space-stable")
        canvas = self.find("#space-canvas")
        before = self.shot()
        self.drag(canvas, 80, 30)
        self.assertNotEqual(self.shot(), before)
        self.js("arguments[0].focus()", canvas)
        self.press(Keys.HOME)
        self.assertEqual(self.shot(), before)
        self.press(Keys.ARROW_LEFT)
        self.assertNotEqual(self.shot(), before)

    def test_unstable(self):
        self.open(example("space-book"), "--case", "too heavy", *QUICK)
        self.assertIn("work 9", self.text("#motion-words"))
        self.assertIn("axis", self.text("#motion-words"))
        self.assertEqual(self.check_proof(), "accepted")
        self.picture("space-unstable")

    def test_the_body_and_the_region(self):
        answer = self.open(in_file(self.folder, cube()), "--time-limit", "5")
        self.assertNotIn("sketched", self.text("#body-legend"))
        self.assertGreater(self.colours(), 30)
        self.assertEqual(self.check_proof(), "accepted")
        self.assertNotIn("vertices", self.text("#exact pre"), "it is named there, and not printed")
        self.assertIn("8 vertices and 6 faces", self.text("#exact"))
        self.find("#save-grasp").click()
        saved = os.path.join(self.downloads, "grasp.json")
        self.wait(lambda: is_written(saved), "the file")
        with open(saved, encoding="utf-8") as file:
            self.assertEqual(json.load(file)["body"], cube()["body"])
        self.assertEqual(decide(saved)["verdict"], "stable")
        # The region's cells, and the load in them.
        stable = [cell for cell in answer["region"]["cells"] if cell["verdict"] == "stable"]
        self.assertEqual(self.find("#region path.hue0").get_attribute("d").count("M"), len(stable))
        self.assertEqual(len(self.all("#region .present")), 1)
        self.assertIn("force along z", self.text("#region"))
        self.assertIn("resisted, proved throughout each cell", self.text("#region-note"))
        self.picture("space-body")

    def test_a_large_body(self):
        rows = 50
        grasp = {**cube(), "body": {
            "vertices": [[math.sin(math.pi * i / rows) * math.cos(2 * math.pi * j / 100) * 1.5,
                          math.sin(math.pi * i / rows) * math.sin(2 * math.pi * j / 100) * 1.5,
                          1.5 * math.cos(math.pi * i / rows)] for i in range(rows + 1) for j in range(100)],
            "faces": [face for i in range(rows) for j in range(100) for a, b in [(100 * i + j, 100 * i + (j + 1) % 100)]
                      for face in ([a, a + 100, b], [b, a + 100, b + 100])]}}
        self.open(in_file(self.folder, grasp), *QUICK)
        self.assertEqual(self.js("return StickslipPage.solids[0].triangles.length"), 10000)
        self.assertLess(self.size, 3000000)
        self.assertGreater(self.colours(), 30)
        before = self.shot()
        self.js("arguments[0].focus()", self.find("#space-canvas"))
        self.press(Keys.ARROW_LEFT)
        self.assertNotEqual(self.shot(), before)
        self.picture("space-large-body")

    def test_fragile(self):
        answer = self.open(example("space-cup"), "--uncertain", "friction=90%", *QUICK)
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), "fragile")
        self.assertGreater(self.colours(), 30)
        self.assertFalse(self.find("#check").is_displayed())
        self.assertIn(answer["decide"]["differences"][0]["place"], self.text("#why"))
        self.picture("space-fragile")
        before = self.shot()
        for verdict in ("stable", "unstable"):
            self.find(f"[data-choice=grasp-{verdict}]").click()
            self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), verdict)
            self.assertNotEqual(self.shot(), before)
            self.assertEqual(self.check_proof(), "accepted")
            self.picture("space-fragile-" + verdict)
        self.find("[data-choice=grasp-box]").click()
        self.assertEqual(self.shot(), before)
        self.assertFalse(self.find("#check").is_displayed())


class Several(PageTest):
    """Several bodies: all are drawn, and the checker in the browser judges what is said of them."""

    def refuses(self, forged, rule):
        self.assertEqual(self.check_proof(), "accepted")
        self.js("StickslipPage.answer.certificate = arguments[0]; StickslipPage.draw()", json.dumps(forged))
        self.assertEqual(self.js("return StickslipPage.checkProof().answer"), "rejected")
        self.assertIn(rule, self.text("#proof-result"))

    def forces(self):
        return [[float(x) for x in value.split(",")] for value in self.attributes("#body path.force", "data-value")]

    def test_boxes_on_a_table(self):
        grasp, case = example("bodies-stack"), ("--case", "pushed above")
        answer = self.open(grasp, *case, *QUICK)
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), "stable")
        shapes = self.attributes("#body path.body", "d")
        self.assertEqual((len(shapes), len(set(shapes))), (2, 2))
        self.assertEqual(len(self.all("#body .moving")), 2)
        self.assertEqual(self.forces(), [[float(Fraction(x)) for x in c["force"]] for c in decide(grasp, *case)["contacts"]])
        self.assertIn("up turns clockwise", self.text("#motion-words"))
        self.assertIn("there are several bodies", self.text("#why"))
        self.assertIn("For any stiffness and preloads: may stand", self.text("#why"))
        for panel in ("sphere", "region", "map"):
            self.assertFalse(self.find(f"#{panel}-panel").is_displayed())
        self.picture("bodies-stack")
        forged = json.loads(answer["certificate"])
        forged["twist"][4] = str(Fraction(forged["twist"][4]) - 1)
        self.refuses(forged, "witness-balance")

    def test_the_upper_box_slides(self):
        answer = self.open(example("bodies-stack"), "--case", "the upper one slides", *QUICK)
        self.assertEqual(self.js("return document.getElementById('verdict').dataset.verdict"), "unstable")
        self.assertIn("The load drives this motion", self.text("#motion-words"))
        self.assertIn("For any stiffness and preloads: must move", self.text("#why"))
        self.assertEqual(len(self.all("#body .moving .virtual-ghost")), 2)
        self.picture("bodies-stack-unstable")
        forged = json.loads(answer["certificate"])
        leaf = next(node for node in forged["tree"] if node[0] == "leaf")
        leaf[1:] = [str(-Fraction(y)) for y in leaf[1:]]
        self.refuses(forged, "leaf-bound")

    def test_fingers_with_joints(self):
        self.open(example("bodies-gripper"), *QUICK)
        self.assertEqual(len(self.all("#body path.body")), 5)
        self.assertEqual(len(self.all("#body .hinge")), 4)
        self.assertIn("tendon", self.text("#contacts .springs"))
        self.assertEqual(self.check_proof(), "accepted")
        self.fits()
        self.picture("bodies-gripper")

    def test_a_hand_in_space(self):
        answer = self.open(example("bodies-hand"), *QUICK)
        self.assertEqual(self.js("return StickslipPage.spaceState().bodies"), list(range(7)))
        self.assertNotIn(None, self.js("return StickslipPage.spaceState().moved"))
        self.assertIn("ball turns about the axis", self.text("#motion-words"))
        canvas = self.find("#space-canvas")
        shot = "return document.getElementById('space-canvas').toDataURL()"
        before = self.js(shot)
        self.drag(canvas, 80, 30)
        self.assertNotEqual(self.js(shot), before)
        self.picture("bodies-hand")
        forged = json.loads(answer["certificate"])
        forged["shares"][0][1][2] = "73/215"  # of 72/215
        self.refuses(forged, "witness-balance")


class Reading(PageTest):
    def test_dark(self):
        self.set_media(prefers_color_scheme="dark")
        self.open(example("bracket"))
        colour = "return getComputedStyle(document.body).backgroundColor"
        dark = self.js(colour)
        self.assertLess(sum(map(int, re.findall(r"\d+", dark))), 150)
        self.picture("dark")
        self.find("#theme").click()
        self.assertEqual(self.js("return document.documentElement.dataset.theme"), "light")
        self.assertGreater(sum(map(int, re.findall(r"\d+", self.js(colour)))), 600)
        self.find("#theme").click()
        self.assertEqual(self.js(colour), dark)

    def test_narrow(self):
        for grasp, options, name in ((FIG1, ("--wrench", "0,11/10,0", *QUICK), "narrow-unstable"), (example("bracket"), (), "narrow"),
                                     (example("space-corner"), QUICK, "narrow-space"), (example("bodies-gripper"), QUICK, "narrow-bodies")):
            self.set_size(360, 740)
            self.open(grasp, *options)
            self.fits()
            self.picture(name)

    def test_tables_are_not_cut(self):
        """At the widths of a telephone, a tablet and a screen, with short and with long numbers."""
        digits = [f"0.{k}23456789" for k in range(1, 7)]
        files = {}
        for name, of in (("plane", FIG1), ("space", example("space-cup"))):
            with open(of, encoding="utf-8") as file:
                grasp = json.load(file)
            for k, contact in enumerate(grasp["contacts"]):
                contact["friction"], contact["preload"] = f"0.5{k}3456789", f"1.{k}23456789"
            grasp.pop("loads", None)
            grasp["wrench"] = digits[:3 if name == "plane" else 6]
            files[name] = os.path.join(self.folder, name + ".json")
            with open(files[name], "w", encoding="utf-8") as file:
                json.dump(grasp, file)
        for name, path in files.items():
            for width in (375, 768, 1300):
                self.set_size(width, 900)
                answer = self.open(path, *QUICK)
                self.assertEqual(answer["decide"]["verdict"], "stable")
                self.js("document.querySelector('details').open = true")
                for exact in (False, True):
                    with self.subTest((name, width, exact)):
                        self.js("StickslipPage.show({ exact: arguments[0] })", exact)
                        self.fits()
                        parts = self.js("""return [...document.querySelectorAll('.wide')].map(
                            (e) => [e.getClientRects().length, e.scrollWidth, e.clientWidth])""")
                        self.assertGreater(len(parts), 0)
                        for boxes, scrolled, seen in parts:
                            self.assertGreater(boxes, 0)
                            self.assertLessEqual(scrolled, seen)
                        # Whichever way they stand, all numbers are there.
                        rows = self.js("return [...document.querySelectorAll('#contacts tbody tr')].map((e) => e.innerText)")
                        self.assertEqual(len(rows), len(answer["contacts"]))
                        for contact, row in zip(answer["decide"]["contacts"], rows):
                            if exact:
                                for x in contact["force"]:
                                    self.assertIn(x.replace("-", "\u2212"), row)
                self.picture(f"table-{name}-{width}-exact")

    def test_with_the_keyboard_alone(self):
        self.open(FIG1)
        reached = []
        for _ in range(40):
            self.press(Keys.TAB)
            name = self.js("return document.activeElement.id || document.activeElement.dataset.choice || ''")
            if name in reached:
                break
            reached.append(name)
            if name == "sphere":
                self.press(Keys.PAGE_DOWN)
                self.press(Keys.PAGE_DOWN)
                self.assertEqual(self.js("return StickslipPage.shown.cell"), 1)
                self.press(Keys.ESCAPE)
                self.assertEqual(self.js("return StickslipPage.motion().kind"), "equilibrium")
                self.press(Keys.ENTER)
                self.assertEqual(self.js("return StickslipPage.motion().kind"), "cell")
            if name == "check":
                self.press(Keys.ENTER)
                self.wait(lambda: "accepted" in self.text("#proof-result"), "the proof is accepted")
            if name == "pause":
                paused = self.js("return StickslipPage.isPaused()")
                self.press(Keys.ENTER)
                self.assertNotEqual(self.js("return StickslipPage.isPaused()"), paused)
                self.assertEqual(self.js("return document.activeElement.id"), "pause", "the focus stays")
        for name in ("exact-numbers", "theme", "grasp-lost", "show-lost", "check", "save-proof", "save-grasp", "sphere", "cell-list"):
            self.assertIn(name, reached)

    def test_names_for_those_who_do_not_see(self):
        self.open(FIG1)
        for element in self.all("button, input, select, canvas, [role=img], [role=application]"):
            name = element.accessible_name if hasattr(element, "accessible_name") else ""
            self.assertNotEqual(name.strip(), "", element.get_attribute("outerHTML")[:200])


if __name__ == "__main__":
    unittest.main()
