# SPDX-License-Identifier: GPL-3.0-or-later
"""Masses and gravity, frictions by name, angles of normals, and files of version 3 with one body."""

import json
import math
import unittest

from test_cli import BAD_INPUT, DONE, PROVED, Case, checkers, run, stickslip

FLOOR = {"format": "stickslip-grasp/2", "name": "crate", "defaults": {"friction": "1/2", "stiffness": 1000},
         "contacts": [{"position": [-1, 0], "normal": [0, 1]}, {"position": [1, 0], "normal": [0, 1]}],
         "loads": [{"mass": 10, "at": [0, 1]}]}
PINCH = {"format": "stickslip-grasp/2", "name": "pinch", "defaults": {"friction": "1/2", "preload": 10, "stiffness": 100},
         "contacts": [{"position": [-1, 0], "normal": [1, 0]}, {"position": [1, 0], "normal": [-1, 0]}],
         "loads": [{"weight": 4, "at": [0, 0]}]}
PINCH_IN_SPACE = {**PINCH, "contacts": [{"position": [-1, 0, 0], "normal": [1, 0, 0]}, {"position": [1, 0, 0], "normal": [-1, 0, 0]}],
                  "loads": [{"weight": 4, "at": [0, 0, 0]}]}


def of_one_body(grasp):
    """The same file in version 3."""
    return {**grasp, "format": "stickslip-grasp/3", "bodies": [{"name": "it"}],
            "contacts": [{"of": "it", **contact} for contact in grasp["contacts"]],
            "loads": [{"body": "it", **load} for load in grasp["loads"]]}


class Masses(Case):
    def test_the_answer_says_the_gravity(self):
        for gravity, shown, text, wrench in ((None, ["0", "-981/100"], "(0, -9.81)", ["0", "-981/10", "0"]),
                                             ([1, -10], ["1", "-10"], "(1, -10)", ["10", "-100", "-10"])):
            grasp = self.write("g.json", FLOOR if gravity is None else {**FLOOR, "gravity": gravity})
            answer = self.json("decide", grasp)
            self.assertEqual((answer["wrench"], answer["gravity"], answer["verdict"]), (wrench, shown, "stable"))
            for command in (("decide",), ("margin", "--direction", "1,0,0"), ("compare",), ("statics",)):
                code, out, err = stickslip(*command[:1], grasp, *command[1:])
                self.assertEqual(code, DONE, err)
                self.assertIn(f"Gravity, by which masses became forces: {text}.\n", out, command)
        weighed = self.write("w.json", {**FLOOR, "loads": [{"weight": 10, "at": [0, 1]}]})
        self.assertNotIn("gravity", self.json("decide", weighed))
        self.assertNotIn("Gravity", stickslip("decide", weighed)[1])

    def test_of_several_bodies_and_in_space(self):
        answer = self.json("decide", self.write("g.json", of_one_body(FLOOR)))
        self.assertEqual((answer["wrench"], answer["gravity"]), (["0", "-981/10", "0"], ["0", "-981/100"]))
        grasp = {**PINCH_IN_SPACE, "loads": [{"mass": 1, "at": [0, 0, 0]}]}
        answer = self.json("decide", self.write("s.json", grasp))
        self.assertEqual((answer["wrench"], answer["gravity"]), (["0", "0", "-981/100", "0", "0", "0"], ["0", "0", "-981/100"]))


class Frictions(Case):
    def test_a_name_is_a_number(self):
        named = {**PINCH, "friction": {"wood-steel": "1/2", "rubber": {"min": "1/4", "max": 1}},
                 "defaults": {**PINCH["defaults"], "friction": "wood-steel"}}
        self.assertEqual(self.json("decide", self.write("a.json", named)), self.json("decide", self.write("b.json", PINCH)))
        named["contacts"] = [{**contact, "friction": "rubber"} for contact in PINCH["contacts"]]
        answer = self.json("decide", self.write("c.json", named))
        self.assertEqual(answer["verdict"], "stable")

    def test_the_error_says_what_to_do(self):
        grasp = self.write("g.json", {**PINCH, "defaults": {"friction": "steel-wood"}, "friction": {"wood-steel": 1}})
        code, _, err = stickslip("decide", grasp)
        self.assertEqual(code, BAD_INPUT)
        self.assertIn("defaults.friction: \"steel-wood\" is neither a number nor a name in the file's \"friction\"", err)
        self.assertIn("its names are wood-steel", err)


class Angles(Case):
    def test_all_but_the_proved_checker_read_them(self):
        vee = {**FLOOR, "contacts": [{"position": [-1, 0], "normal": {"angle": 30}}, {"position": [1, 0], "normal": {"angle": 135}}],
               "loads": [{"weight": 1, "at": [0, 0]}]}
        grasp, proof = self.write("vee.json", vee), self.path("proof.json")
        answer = self.json("decide", grasp, "--certificate", proof)
        self.assertEqual(answer["rounded_normals"], [{"contact": 0, "angle": "30"}])
        self.assertIn("rounded to rational unit vectors, by less than 1e-9: contacts[0] at 30 degrees.\n", stickslip("decide", grasp)[1])
        for checker in checkers(proof):
            code, out, err = run(*checker, grasp, proof)
            if checker == [PROVED]:
                self.assertEqual((code, out), (BAD_INPUT, ""))
                self.assertIn("contacts[0].normal.angle: ", err)
                self.assertIn("; stickslip snap GRASP -o FILE writes a file without", err)
            else:
                self.assertEqual((code, out.split("\n")[0]), (DONE, "accepted"), out + err)

    def test_a_snapped_file_is_plain(self):
        """Of angles, frictions by name and masses: all checkers read what snap writes, of one body in either version."""
        grasp = {**FLOOR, "friction": {"wood": "1/2"}, "defaults": {"friction": "wood", "stiffness": 1000, "preload": 1},
                 "contacts": [{"position": [-1, 0], "normal": {"angle": 45}}, {"position": [1, 0], "normal": {"angle": 121}}]}
        plain, proof = self.path("plain.json"), self.path("proof.json")
        for version in (grasp, of_one_body(grasp)):
            code, out, err = stickslip("snap", self.write("g.json", version), "-o", plain)
            self.assertEqual(code, DONE, err)
            self.assertIn("contact 0: normal (1, 1) moved by at most", out)
            self.json("decide", plain, "--certificate", proof)
            self.accepted(plain, proof)

    def test_a_friction_beside_the_angle_decides(self):
        """A body on a slope of 30 degrees holds by friction alone if its tangent, 0.57735, is below it."""
        for friction, verdict in (("0.57736", "stable"), ("0.57734", "unstable")):
            slope = {"format": "stickslip-grasp/2", "defaults": {"friction": friction, "stiffness": 1000},
                     "contacts": [{"position": [0, 0], "normal": {"angle": 120}}], "loads": [{"mass": 1, "at": [0, 0]}]}
            self.assertEqual(self.json("decide", self.write("s.json", slope))["verdict"], verdict)
        self.assertAlmostEqual(math.tan(math.radians(30)), 0.57735, 5)


class OneBody(Case):
    """Each command answers of a body in version 3 as it does of the same in version 2."""

    COMMANDS = (("states",), ("compare",), ("region",), ("margin", "--class", "--direction", "0,-1,0"), ("plot", "states"), ("plot", "region"), ("export", "--smt2"))
    IN_SPACE = (("compare",), ("margin", "--class", "--direction", "0,0,-1,0,0,0"), ("export", "--smt2"))

    def ask(self, name, grasp, command):
        words = 2 if command[0] == "plot" else 1
        code, out, err = stickslip(*command[:words], self.write(name, grasp), *command[words:])
        self.assertEqual(code, DONE, (command, err))
        return out

    def test_every_command(self):
        for grasp, commands in ((PINCH, self.COMMANDS), (PINCH_IN_SPACE, self.IN_SPACE)):
            for command in commands:
                with self.subTest(command=command):
                    self.assertEqual(self.ask("three.json", of_one_body(grasp), command), self.ask("two.json", grasp, command))

    def test_no_body_need_be_named(self):
        """Of a load that is not resisted, which takes no search."""
        grasp = self.write("g.json", of_one_body({**PINCH, "loads": [{"weight": 400, "at": [0, 0]}]}))
        self.assertEqual(self.json("quality", grasp), self.json("quality", grasp, "--body", "it"))


class Jaws(Case):
    JAWS = {"format": "stickslip-grasp/2", "defaults": {"friction": "1/10", "preload": 10},
            "contacts": [{"position": [-30, 0], "normal": [4, 1]}, {"position": [30, 0], "normal": [-5, 1]}], "wrench": [0, 0, 0]}

    def test_a_motion_that_opens_both(self):
        """
        The motion (0, 60, 0) opens both jaws, and so does any near it: no equilibrium stands alone. Both contacts are left out of
        the proof then; with normals of rational length an equilibrium is stated.
        """
        grasp, snapped, proof = self.write("jaws.json", self.JAWS), self.path("snapped.json"), self.path("proof.json")
        for words, verdict in (((), "stable"), (("--max-motion", "100,100"), "stable"), (("--max-motion", "30,1"), "unstable")):
            with self.subTest(words=words):
                self.assertEqual(self.json("decide", grasp, *words, "--certificate", proof)["verdict"], verdict)
                self.accepted(grasp, proof, *words)
        self.assertEqual(stickslip("snap", grasp, "-o", snapped)[0], DONE)
        self.assertEqual(self.json("decide", snapped, "--certificate", proof)["verdict"], "stable")
        self.accepted(snapped, proof)


class AssumedStiffness(Case):
    def test_the_warning_of_a_large_motion_says_who_chose_1(self):
        pushed = {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2"}, "contacts": PINCH["contacts"], "wrench": [50, 0, 0]}
        for more, said in (({}, "stiffness that is not given was taken as 1, with which the motion found is too large for the model"),
                           ({"stiffness": 1}, "the motion found is too large for the model")):
            grasp = self.write("g.json", {**pushed, "defaults": {**pushed["defaults"], **more}})
            warnings = [w["text"] for w in self.json("decide", grasp)["warnings"] if w["trap"] == "large-motion"]
            self.assertEqual([w[:len(said)] for w in warnings], [said])


if __name__ == "__main__":
    unittest.main()
