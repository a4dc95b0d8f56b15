# SPDX-License-Identifier: GPL-3.0-or-later
"""Maps of verdicts: cells that tile, that both checkers accept, and that samples agree with."""

import json
import os
import random
import unittest
import xml.etree.ElementTree as ET
from fractions import Fraction

from test_box import A
from test_cli import BAD_INPUT, DONE, FIG1, Case, checkers, read, run, stickslip
from test_radius import C

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..")
AXES = ("--x", "friction[2]=0:1", "--y", "friction[0]=1/5:3/5")


def ends(interval):
    return tuple(map(Fraction, interval))


class Map(Case):
    def cells(self, *words):
        answer = self.json("map", *words)
        found = [(ends(c["x"]), ends(c["y"]), c["verdict"]) for c in answer["cells"]]
        whole = [ends(answer[axis]["range"]) for axis in "xy"]
        area = sum((x[1] - x[0]) * (y[1] - y[0]) for x, y, _ in found)
        self.assertEqual(area, (whole[0][1] - whole[0][0]) * (whole[1][1] - whole[1][0]))
        for k, (x, y, _) in enumerate(found):
            for u, v, _ in found[:k]:
                self.assertFalse(x[0] < u[1] and u[0] < x[1] and y[0] < v[1] and v[0] < y[1])
        return found

    def test_cells_tile_and_agree_with_samples(self):
        cells = self.cells(A, *AXES, "--depth", "4")
        self.assertEqual({"stable", "unstable", "undecided"}, {c[2] for c in cells})
        grasp = json.loads(read(A))
        source = random.Random(1)
        for x, y, verdict in source.sample(cells, 25):
            if verdict == "undecided":
                continue
            places = [Fraction(source.randint(0, 4), 4) for _ in "xy"]
            for contact, (low, high), place in zip((2, 0), (x, y), places):
                grasp["contacts"][contact]["friction"] = str(low + place * (high - low))
            asked = self.write("sample.json", json.dumps(grasp))
            self.assertEqual(self.json("decide", asked)["verdict"], verdict)

    def test_both_checkers_accept_every_cell(self):
        folder = self.path("cells")
        svg = self.path("map.svg")
        cells = self.cells(A, *AXES, "--depth", "3", "--certificates", folder, "--svg", svg)
        proved = [k for k, cell in enumerate(cells) if cell[2] != "undecided"]
        names = {f"cell{k}{end}" for k in proved for end in (".json", ".certificate.json")}
        self.assertEqual(set(os.listdir(folder)), names)
        for k in proved:
            grasp = os.path.join(folder, f"cell{k}.json")
            friction = [c["friction"] for c in json.loads(read(grasp))["contacts"]]
            for contact, interval in ((2, cells[k][0]), (0, cells[k][1])):
                self.assertEqual((Fraction(friction[contact]["min"]),
                                  Fraction(friction[contact]["max"])), interval)
            self.accepted(grasp, os.path.join(folder, f"cell{k}.certificate.json"), verdict=rf"{cells[k][2]}\b")
        drawn = [(r.get("data-x"), r.get("data-y"), r.get("data-verdict"))
                 for r in ET.fromstring(read(svg)).iter("{http://www.w3.org/2000/svg}rect")
                 if r.get("data-verdict")]
        self.assertEqual([(ends(x.split(",")), ends(y.split(",")), v) for x, y, v in drawn], cells)

    def test_cells_of_uncertain_numbers_agree_with_samples_and_checkers(self):
        for uncertain in ("friction=10%,wrench=1/10", "wrench=ball:1/10:length=2:about=1:0,position=1/50"):
            folder = self.path(f"cells{len(uncertain)}")
            cells = self.cells(A, *AXES, "--depth", "3", "--uncertain", uncertain, "--certificates", folder)
            self.assertEqual({"stable", "unstable", "undecided"}, {c[2] for c in cells})
            ball = "ball" in uncertain
            option = ("--uncertain", uncertain.split(",")[0]) if ball else ()
            for k, (x, y, verdict) in enumerate(cells):
                if verdict == "undecided":
                    continue
                files = [os.path.join(folder, f"cell{k}{end}") for end in (".json", ".certificate.json")]
                self.accepted(*files, *option, verdict=rf"{verdict}\b")
                for checker in checkers(files[1]) if ball else ():
                    self.assertIn("question-uncertain", run(*checker, *files)[1])
                self.agrees_nearby(json.loads(read(A)), x, y, verdict, ball, random.Random(k))

    def agrees_nearby(self, grasp, x, y, verdict, ball, source):
        """One grasp of the cell, as far off as it may be."""
        for contact, ends_of in ((2, x), (0, y)):
            factor = 1 if ball else source.choice([Fraction(9, 10), Fraction(11, 10)])
            grasp["contacts"][contact]["friction"] = str(factor * source.choice(ends_of))
        if ball:
            # (3/5, 4/5) of the radius as force and as torque over the length, at (1, 0).
            turn = source.choice([-1, 1])
            f, t = ((Fraction(3, 50) * turn, Fraction(8, 50)) if source.random() < 0.5
                    else (Fraction(4, 50) * turn, Fraction(-6, 50)))
            along_x = source.random() < 0.5
            off = (f, 0, t) if along_x else (0, f, t + f)
            for contact in grasp["contacts"]:
                contact["position"] = [str(p + source.choice([-1, 1]) * Fraction(1, 50)) for p in contact["position"]]
        else:
            off = [source.choice([-1, 1]) * Fraction(1, 10) for _ in "xyt"]
        grasp["wrench"] = [str(w + z) for w, z in zip(grasp["wrench"], off)]
        self.assertEqual(self.json("decide", self.write("near.json", grasp))["verdict"], verdict)

    def test_uncertain_numbers_are_said(self):
        words = (A, *AXES, "--depth", "1", "--uncertain", "wrench=ball:1/10")
        self.assertEqual(self.json("map", *words)["uncertain"], "wrench=ball:1/10")
        out = stickslip("map", *words)[1]
        self.assertIn("all grasps of a cell with wrench=ball:1/10.", out)
        for axis, uncertain, naming in (
                ("load=0:1", "wrench=ball:1", ["--x: load varies the load in the centre", "wrench=T"]),
                ("wrench[1]=0:1", "wrench=ball:1", ["wrench[1]"]),
                ("load=0:1", "friction=1/10", ["contacts[2].friction", "[-1/10, 11/10]"]),
                ("load=0:1", "frction=1", ["--uncertain", "friction"])):
            self.fails("map", A, "--x", axis, "--y", "friction[2]=0:1", "--uncertain", uncertain, naming=naming)

    def test_every_axis(self):
        for name in ("friction=1/2:3/2", "stiffness=1/2:2", "preload=1/2:2", "friction[1]=0:1",
                     "stiffness[0]=1/2:2", "preload[2]=0:2", "wrench[2]=-3:3",
                     "direction=100:190"):
            cells = self.cells(A, "--x", name, "--y", "load=1/2:1", "--depth", "2")
            self.assertGreaterEqual(len(cells), 1, name)

    def test_a_direction_is_enclosed(self):
        # The load points up at 90 degrees; with the torque 0 it holds as --wrench says.
        grasp = (FIG1, "--preload", "1", "--wrench", "1,0,0")
        folder = self.path("turned")
        cells = self.cells(*grasp, "--x", "direction=80:100", "--y", "load=1/8:1/4", "--depth", "1",
                           "--certificates", folder)
        self.assertTrue(any(c[2] == "stable" for c in cells))
        for name in os.listdir(folder):
            if name.endswith(".certificate.json"):
                continue
            x, y, _ = json.loads(read(os.path.join(folder, name)))["wrench"]
            # |F| is between 1/8 and 1/4, and cos 80 degrees is about 0.17.
            self.assertLessEqual(Fraction(y["max"]), Fraction(1, 4))
            self.assertGreaterEqual(Fraction(y["min"]), Fraction(12, 100))
            self.assertLess(abs(Fraction(x["min"])), Fraction(5, 100))

    def test_more_friction_breaks_without_preload(self):
        cells = self.cells(C, "--x", "friction[1]=1/10:3/10", "--y", "load=9/10:11/10", "--depth", "3")
        row = [c for c in cells if c[1][0] <= 1 <= c[1][1]]
        self.assertEqual(row[0][2], "stable")
        self.assertEqual(row[-1][2], "unstable")

    def test_in_space(self):
        # Two fingers press with 4 each: they bear a load of l times 4 across if friction is l / 2.
        grasp = self.write("g.json", {
            "format": "stickslip-grasp/2", "wrench": [0, 0, -4, 0, 0, 0],
            "contacts": [{"position": [side, 0, 0], "normal": [-side, 0, 0], "friction": 1,
                          "preload": 4} for side in (-1, 1)]})
        folder = self.path("space")
        cells = self.cells(grasp, "--x", "friction=0:1", "--y", "load=0:2", "--depth", "3",
                           "--certificates", folder)
        for k, (x, y, verdict) in enumerate(cells):
            expected = ("stable" if y[1] <= 2 * x[0] else
                        "unstable" if y[0] >= 2 * x[1] and y[0] > 0 else "undecided")
            self.assertIn(verdict, (expected, "undecided"))
            if verdict == "undecided":
                continue
            files = [os.path.join(folder, f"cell{k}{end}") for end in (".json", ".certificate.json")]
            self.accepted(*files, verdict=rf"{verdict}\b")
        area = sum((x[1] - x[0]) * (y[1] - y[0]) for x, y, verdict in cells if verdict != "undecided")
        self.assertGreater(area, Fraction(6, 10) * 2)
        self.fails("map", grasp, "--x", "direction=0:90", "--y", "load=0:1",
                   naming=["--x", "in space", "wrench[0]"])
        self.fails("map", grasp, "--x", "wrench[6]=0:1", "--y", "load=0:1",
                   naming=["--x", "wrench[5]"])

    def test_a_wrench_that_is_added(self):
        # Fig. 1 resists (s, t) exactly if t <= max(0, 1 - |s|/2).
        cells = self.cells(FIG1, "--preload", "1", "--wrench", "0,0,0", "--x", "1,0,0=-3:3", "--y", "0,1,0=-1/2:3/2",
                           "--depth", "4")
        # The other axis may be of another kind; with t = 0 it holds for all these s.
        mixed = self.cells(FIG1, "--preload", "1", "--wrench", "0,0,0", "--x", "1,0,0=-1:1", "--y", "stiffness=1:2", "--depth", "2")
        self.assertEqual({verdict for _, _, verdict in mixed}, {"stable"})
        for x, y, verdict in cells:
            inside = [t <= max(0, 1 - abs(s) / 2) for s in x for t in y]
            if verdict != "undecided":
                self.assertEqual({verdict == "stable"}, set(inside), (x, y))
        area = sum((x[1] - x[0]) * (y[1] - y[0]) for x, y, verdict in cells if verdict != "undecided")
        self.assertGreater(area, 12 * Fraction(3, 4))
        for words, part in (
                (("--x", "1,0=0:1", "--y", "load=0:1"), "a wrench of 2 numbers"),
                (("--x", "0,0,0=0:1", "--y", "load=0:1"), "its wrench is 0"),
                (("--x", "1,0,0=0:1", "--y", "2,0,0=0:1"), "--y: both axes vary")):
            self.fails("map", FIG1, "--wrench", "0,0,0", *words, naming=[part])

    def test_pictures_of_the_documentation(self):
        for name, grasp, x, depth in (("A", A, "friction[2]=0:1", "7"),
                                      ("C", C, "friction[1]=0:1/2", "6")):
            svg = self.path("again.svg")
            self.cells(grasp, "--x", x, "--y", x.replace("2]", "0]").replace("1]", "0]"),
                       "--depth", depth, "--svg", svg)
            committed = os.path.join(ROOT, "docs", "maps", f"{name}.svg")
            self.assertEqual(read(svg), read(committed))

    def test_errors(self):
        for words, part in (
                (("--x", "frction=0:1", "--y", "load=0:1"), "did you mean \"friction\""),
                (("--x", "friction=1:0", "--y", "load=0:1"), "its range is empty"),
                (("--x", "friction=-1:1", "--y", "load=0:1"), "it is 0 or more"),
                (("--x", "stiffness=0:1", "--y", "load=0:1"), "a stiffness is above 0"),
                (("--x", "friction[9]=0:1", "--y", "load=0:1"), "the last is friction[2]"),
                (("--x", "wrench=0:1", "--y", "load=0:1"), "wrench[2], which is the torque"),
                (("--x", "load[1]=0:1", "--y", "friction=0:1"), "load has no parts"),
                (("--x", "load=0", "--y", "friction=0:1"), "write NAME=FROM:TO"),
                (("--x", "load=0:x", "--y", "friction=0:1"), "its range"),
                (("--x", "friction=0:1", "--y", "friction[1]=0:1"), "both axes vary"),
                (("--x", "direction=0:9", "--y", "wrench[0]=0:1"), "both axes vary")):
            code, out, err = stickslip("map", A, *words)
            self.assertEqual((code, out), (BAD_INPUT, ""), words)
            self.assertIn(part, err)


class RegionInSpace(Case):
    """Two pads at x = -1 and 1 press with 1 and have friction 1/2: forces across the x axis at the point x are
    resisted up to 1 / (1 + |x|), whatever their direction."""

    def setUp(self):
        super().setUp()
        self.grasp = self.write("pinch.json", {
            "format": "stickslip-grasp/2", "defaults": {"friction": "1/2", "preload": 1}, "wrench": [3] * 6,
            "contacts": [{"position": [side, 0, 0], "normal": [-side, 0, 0]} for side in (-1, 1)]})

    def region(self, *words):
        answer = self.json("region", self.grasp, *words)
        return answer, [(ends(c["x"]), ends(c["y"]), c["verdict"]) for c in answer["cells"]]

    def agrees(self, cells, radius):
        """Returns the part of the area that is proved."""
        proved = 0
        for x, y, verdict in cells:
            nearest = [0 if low <= 0 <= high else min(low ** 2, high ** 2) for low, high in (x, y)]
            farthest = [max(low ** 2, high ** 2) for low, high in (x, y)]
            if verdict == "stable":
                self.assertLessEqual(sum(farthest), radius ** 2)
            elif verdict == "unstable":
                self.assertGreater(sum(nearest), radius ** 2)
            if verdict != "undecided":
                proved += (x[1] - x[0]) * (y[1] - y[0])
        window = [max(c[k][1] for c in cells) - min(c[k][0] for c in cells) for k in (0, 1)]
        return proved / (window[0] * window[1])

    def test_forces_at_the_middle_and_aside_of_it(self):
        for at, radius in ((0, 1), (Fraction(1, 2), Fraction(2, 3))):
            folder = self.path(f"cells{at.numerator}")
            answer, cells = self.region(
                f"--u=0,1,0,0,0,{at}", f"--v=0,0,1,0,-{at},0", "--within=-5/4:5/4,-1:3/2", "--depth", "4",
                "--certificates", folder)
            self.assertEqual(answer["plane"]["u"], ["0", "1", "0", "0", "0", str(at)])
            self.assertGreater(self.agrees(cells, radius), Fraction(3, 5))
            self.assertEqual({"stable", "unstable", "undecided"}, {c[2] for c in cells})
            for k, (_, _, verdict) in enumerate(cells):
                if verdict == "undecided":
                    continue
                files = [os.path.join(folder, f"cell{k}{end}") for end in (".json", ".certificate.json")]
                self.accepted(*files, verdict=rf"{verdict}\b")

    def test_by_default_all_forces_within_the_preloads(self):
        answer, cells = self.region("--depth", "2")
        self.assertEqual(answer["plane"], {"origin": ["0"] * 6, "u": ["1"] + ["0"] * 5, "v": ["0", "1"] + ["0"] * 4})
        self.assertEqual([answer[axis]["range"] for axis in "xy"], [["-2", "2"]] * 2)
        code, out, err = stickslip("region", self.grasp, "--depth", "2")
        self.assertEqual((code, err), (DONE, ""))
        self.assertRegex(out, r"plane  \(0, 0, 0, 0, 0, 0\) \+ s \(1, 0, 0, 0, 0, 0\) \+ t \(0, 1, 0, 0, 0, 0\),\n"
                              r" +s from -2 to 2, t from -2 to 2 \(--within\)")
        self.assertRegex(out, rf"\n{len(cells)} cells ")

    def test_a_picture_has_all_cells(self):
        words = ("--u=0,1,0,0,0,0", "--v=0,0,1,0,0,0", "--depth", "3")
        _, cells = self.region(*words)
        svg = self.path("r.svg")
        self.assertEqual(stickslip("plot", "region", self.grasp, *words, "-o", svg), (DONE, "", ""))
        code, out, _ = stickslip("region", self.grasp, *words, "--svg")
        self.assertEqual((code, out), (DONE, read(svg)))
        drawn = [(r.get("data-x"), r.get("data-y"), r.get("data-verdict"))
                 for r in ET.fromstring(read(svg)).iter("{http://www.w3.org/2000/svg}rect") if r.get("data-verdict")]
        self.assertEqual([(ends(x.split(",")), ends(y.split(",")), v) for x, y, v in drawn], cells)
        self.assertIn("s along (0, 1, 0, 0, 0, 0)", out)

    def test_what_cannot_be_asked(self):
        for words, naming in (
                (("--torque", "1"), ["--torque", "--origin"]), (("--list",), ["--list", "--json"]),
                (("--mode-limit", "3"), ["--mode-limit", "--depth"]),
                (("--certificate", self.path("c.json")), ["--certificate", "--certificates"]),
                (("--within", "0:1"), ["--within", "0:1"]), (("--within", "1:0,0:1"), ["--within"]),
                (("--u", "1,0,0"), ["--u", "in space"]), (("--u", "0,2,0,0,0,0"), ["--u, --v", "no plane"])):
            self.fails("region", self.grasp, *words, naming=naming)
        for words in (("--within=0:1,0:1",), ("--depth", "3"), ("--certificates", self.path("x"))):
            self.fails("region", FIG1, *words, naming=[words[0].split("=")[0], "exact"] if "cert" not in words[0]
                       else ["--certificates", "whole region"])


if __name__ == "__main__":
    unittest.main()
