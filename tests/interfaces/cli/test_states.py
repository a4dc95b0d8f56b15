# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip states and contact modes in space and of several bodies: options, output, filters, errors."""

import json
import os
import pty
import re
import signal
import subprocess
import unittest
from fractions import Fraction

from test_cli import CHECK, DONE, FIG1, STICKSLIP, UNDECIDED, Case, stickslip


def cube(walls, preload=0):
    """A cube of edge 2 about the origin with a contact in each corner of walls, (axis, side) each."""
    contacts = []
    for axis, side in walls:
        for s in (-1, 1):
            for t in (-1, 1):
                position, normal = [0, 0, 0], [0, 0, 0]
                position[axis], position[(axis + 1) % 3], position[(axis + 2) % 3] = side, s, t
                normal[axis] = -side
                contacts.append({"position": position, "normal": normal})
    return {"format": "stickslip-grasp/2", "name": "cube", "defaults": {"friction": "1/2", "preload": preload},
            "contacts": contacts, "wrench": [0] * 6}


FLOOR, CORNER = [(2, -1)], [(2, -1), (0, -1), (1, -1)]


def dot(row, motion):
    return sum(Fraction(a) * Fraction(b) for a, b in zip(row, motion))


class States(Case):
    def answer(self, grasp, *options, code=DONE):
        return self.json("states", self.write("g.json", grasp), *options, code=code)

    def count(self, grasp, *options):
        return self.answer(grasp, *options)["distinct_states"]

    def test_counts_by_dimension(self):
        # A cube on a wall: sliding and turning in the wall's plane, which three directions of
        # slip planes share, and three more motions that no contact resists.
        answer = self.answer(cube(FLOOR))
        self.assertEqual((answer["modes"], answer["contacts"], answer["coordinates"]), ("slip", 4, 6))
        self.assertEqual(sum(answer["by_dimension"]), answer["distinct_states"])
        self.assertIs(answer["complete"], True)
        for modes, counts in (("cs", (10, 136)), ("ss", (196, 136))):
            self.assertEqual([self.count(cube(walls), "--modes", modes) for walls in (FLOOR, CORNER)], list(counts))

    def test_a_listed_mode_has_its_equalities_and_inequalities(self):
        for modes in ("slip", "full", "closed", "cs", "ss"):
            answer = self.answer(cube(FLOOR), "--list", "--modes", modes)
            self.assertEqual(len(answer["states"]), answer["distinct_states"])
            self.assertEqual(len({state["state"] for state in answer["states"]}), answer["distinct_states"])
            rows = [row["row"] for row in answer["rows"]]
            by_dimension = [0] * 7
            for state in answer["states"]:
                by_dimension[state["dimension"]] += 1
                signs = {i: sign for name, sign in (("zero", 0), ("positive", 1), ("negative", -1)) for i in state[name]}
                for i, sign in signs.items():
                    value = dot(rows[i], state["motion"])
                    self.assertEqual((value > 0) - (value < 0), sign)
                for i, row in enumerate(answer["rows"]):
                    # What does not count is a slip of a contact that opens.
                    opens = modes == "ss" and row["line"] is not None and any(
                        answer["rows"][j]["contact"] == row["contact"] and answer["rows"][j]["line"] is None
                        for j in state["positive"])
                    self.assertEqual(i in signs, not opens)
            self.assertEqual(by_dimension, answer["by_dimension"])

    def test_text(self):
        code, out, err = stickslip("states", self.write("g.json", cube(FLOOR, preload=1)), "--modes", "ss", "--list")
        self.assertEqual((code, err), (DONE, ""))
        lines = out.splitlines()
        self.assertEqual(lines[0], "cube")
        self.assertIn("00 00 00 00  0  (0, 0, 0, 0, 0, 0)", lines)
        self.assertRegex(out, r"\no o o o  6  \(")
        self.assertRegex(out, r"\n +states +1 .* 196\n")
        self.assertIn("moved by P/k", out)
        code, out, _ = stickslip("states", self.write("g.json", cube(FLOOR)), "--modes", "ss")
        self.assertNotIn("P/k", out)

    def test_filters_are_the_part_of_the_list_that_they_say(self):
        grasp = cube(CORNER[:2])
        everything = self.answer(grasp, "--list", "--modes", "ss")["states"]
        closed = self.answer(grasp, "--list", "--modes", "ss", "--at-least-closed", "3")["states"]
        self.assertEqual(closed, [state for state in everything if state["state"].split().count("o") <= 5])
        self.assertLess(0, len(closed))
        flat = self.answer(grasp, "--list", "--modes", "ss", "--dimension", "2")["states"]
        self.assertEqual(flat, [state for state in everything if state["dimension"] == 2])
        limited = self.answer(grasp, "--list", "--modes", "ss", "--limit", "7", code=UNDECIDED)
        self.assertEqual((limited["states"], limited["complete"]), (everything[:7], False))
        self.assertEqual(self.answer(grasp, "--modes", "ss", "--limit", "7", code=UNDECIDED)["distinct_states"], 7)
        whole = self.answer(grasp, "--modes", "ss", "--limit", str(len(everything)))
        self.assertEqual((whole["distinct_states"], whole["complete"]), (len(everything), True))

    def test_lines_of_slip(self):
        ball = {**cube([]), "contacts": [{"position": [0, 0, 0], "normal": [2, -1, 2]}]}
        for k in (1, 2, 4):
            self.assertEqual(self.count(ball, "--lines", str(k)), 3 if k == 1 else 4 * k + 1)
        self.assertEqual(self.count(ball, "--lines", "3", "--snap"), 13)
        directions = self.write("d.json", [[[1, 2, 0], ["1/2", 0, "-0.5"]]])
        answer = self.answer(ball, "--directions", directions)
        self.assertEqual([row["row"][:3] for row in answer["rows"]], [["1", "2", "0"], ["1", "0", "-1"]])
        file = self.write("g.json", ball)
        self.fails("states", file, "--lines", "3", naming=["--lines", "irrational", "--snap", "--directions"])
        self.fails("states", file, "--lines", "65", naming=["--lines", "64"])
        for content, naming in (([[[1, 0, 0]]], ["[0][0]", "not across the normal", "(5/9, 2/9, -4/9)"]),
                                ([[[1, 2]]], ["[0][0]", "3"]), ([], ["one for each of the 1 contacts"]),
                                ([[]], ["[0]", "0 directions"]), ([[["x", 0, 0]]], ["[0][0]"]), ({}, ["array"]),
                                ([[[1, 2, 0], [-2, -4, 0]]], ["[0][1]", "leave out"])):
            wrong = self.write("wrong.json", content)
            self.fails("states", file, "--directions", wrong, naming=[wrong, *naming])

    def test_a_certificate_is_accepted(self):
        """Whatever its bodies and lines are."""
        floor = cube(FLOOR)
        arm = {"format": "stickslip-grasp/3", "bodies": [{"name": "block"}, {"name": "arm", "hinge": {"at": [0, 0, 0], "axis": [0, 1, 0]}}],
               "joints": [{"turns": {"arm": 1}}], "defaults": {"friction": 1},
               "contacts": [{"of": "block", "by": "arm", "position": [1, 0, "1/3"], "normal": [0, 0, 1]},
                            {"of": "block", "position": [2, 1, 0], "normal": [0, 1, 2]}]}
        for grasp, *options in ((floor, "slip"), (floor, "full"), (floor, "closed"), (floor, "slip", "--lines", "3", "--snap"), (cube(CORNER), "closed"),
                                (arm, "full")):
            file, proof = self.write("g.json", grasp), self.path("proof.json")
            answer = self.json("states", file, "--certificate", proof, "--modes", *options)
            judged = subprocess.run([CHECK, file, proof, "--states", options[0], "--json"], capture_output=True, encoding="ascii", check=True)
            self.assertEqual(json.loads(judged.stdout)["by_dimension"], answer["by_dimension"])

    def test_lists_and_proofs_are_the_same_from_any_number_of_threads(self):
        grasp = {**cube([]), "contacts": [{"position": [i, i * i % 7, -i], "normal": [1, i, 3 - i]} for i in range(6)]}
        file, proof = self.write("g.json", grasp), self.path("proof.json")
        for options in (("--list",), ("--list", "--json"), ("--list", "--modes", "ss")):
            said = {stickslip("states", file, *options, "--threads", str(threads)) for threads in (1, 2, 5)}
            self.assertEqual(len(said), 1)
        # A limit, and a list beside a proof, are of the same order.
        everything = self.answer(grasp, "--list")["states"]
        limit = len(everything) // 2
        self.assertEqual(self.answer(grasp, "--list", "--limit", str(limit), code=UNDECIDED)["states"], everything[:limit])
        proofs = set()
        for threads in ("1", "2"):
            beside = self.answer(grasp, "--list", "--certificate", proof, "--threads", threads)["states"]
            self.assertEqual(beside, everything)
            with open(proof, encoding="ascii") as written:
                proofs.add(written.read())
        self.assertEqual(len(proofs), 1)
        self.assertEqual(len(json.loads(proofs.pop())["states"]), (len(everything) + 1) // 2)

    def test_the_graph_joins_cells_by_facets(self):
        file = self.write("g.json", cube(FLOOR))
        for modes in ("slip", "full", "closed"):
            graph = self.json("states", file, "--graph", "--modes", modes)
            answer = self.json("states", file, "--modes", modes, "--list")
            states = {state["state"]: state for state in answer["states"]}
            top = graph["dimension"]
            self.assertEqual([states[cell]["dimension"] for cell in graph["cells"]], [top] * answer["by_dimension"][top])
            self.assertEqual(len({facet["state"] for facet in graph["facets"]}), answer["by_dimension"][top - 1])
            for facet in graph["facets"]:
                one, other = (graph["cells"][i] for i in facet["cells"])
                self.assertNotEqual(one, other)
                self.assertEqual(states[facet["state"]]["dimension"], top - 1)
                for a, b, between in zip(one, other, facet["state"]):
                    # What is not 0 on the facet is the same beside it, and the rest opposite.
                    self.assertEqual({a, b}, {between} if between != "0" or a == "0" else {"+", "-"})
            reached, border = {0}, [0]
            while border:
                cell = border.pop()
                for facet in graph["facets"]:
                    for i in facet["cells"] if cell in facet["cells"] else ():
                        if i not in reached:
                            reached.add(i)
                            border.append(i)
            self.assertEqual(len(reached), len(graph["cells"]))
        code, out, _ = stickslip("states", file, "--graph")
        self.assertEqual((code, out.splitlines()[0], out.count("label="), out.count('";\n')), (DONE, "graph slip {", 24, 14))
        self.fails("states", file, "--graph", "--modes", "ss", naming=["--graph", "--modes slip"])
        self.fails("states", file, "--graph", "--list", naming=["--graph", "--list"])

    def test_an_equilibrium_has_a_state_of_the_list(self):
        """In the words of --list, where the equilibrium is exact: pushed, turned and pressed."""
        grasp = cube(FLOOR)
        states = [state["state"] for state in self.answer(grasp, "--list")["states"]]
        for load in ([0, 0, -5, 0, 0, 0], [2, 0, -4, 0, 0, 0], [0, 2, -4, 0, 0, 0], [0, 0, -4, 0, 0, 1]):
            grasp["wrench"] = load
            found = json.loads(stickslip("decide", self.write("g.json", grasp), "--json")[1])
            if "twist" not in found:
                continue
            said = " ".join(contact["slip"] for contact in found["contacts"])
            self.assertIn(said, states)
            rows = [row["row"] for row in self.answer(grasp)["rows"]]
            signs = "".join("0+-"[(x > 0) - (x < 0)] for x in (dot(row, found["twist"]) for row in rows))
            self.assertEqual(said.replace(" ", ""), signs)
            contact = found["contacts"][0]
            self.assertRegex(stickslip("decide", self.path("g.json"))[1],
                             f"\n +0 .* {re.escape(contact['slip'])}  {'closed' if contact['closed'] else 'open'}\n")
        # Without friction, pressed into a corner, it slips along all three walls.
        corner = {**cube(CORNER), "defaults": {"friction": 0}, "wrench": [-1, -2, -4, 0, 0, 0]}
        found = self.json("decide", self.write("g.json", corner))
        said = " ".join(contact["slip"] for contact in found["contacts"])
        self.assertEqual(set(said), {"+", "-", " "})
        states = self.answer(corner, "--list", "--dimension", "6")["states"]
        self.assertIn(said, [state["state"] for state in states])

    def test_what_has_no_certificate_writes_none(self):
        file, proof = self.write("g.json", cube(FLOOR)), self.path("proof.json")
        for options, says in ((("--modes", "cs"), "--modes full"), (("--modes", "ss"), "--modes full"),
                              (("--dimension", "3"), "all dimensions"), (("--limit", "3"), "leave out --limit")):
            self.fails("states", file, "--certificate", proof, *options, naming=["--certificate", says])
        self.assertEqual(os.listdir(self.folder), ["g.json"])

    def test_options_that_do_not_fit(self):
        file = self.write("g.json", cube(FLOOR))
        self.fails("states", file, "--engine", "sweep", naming=["--engine", "in the plane"])
        self.fails("states", file, "--at-least-closed", "1", naming=["--at-least-closed", "--modes cs"])
        self.fails("states", file, "--modes", "cs", "--at-least-closed", "5", naming=["--at-least-closed", "it has 4"])
        self.fails("states", file, "--dimension", "7", naming=["--dimension", "at most 6"])
        self.fails("states", file, "--modes", "sc", naming=["--modes"])

    def test_in_the_plane_the_states_are_those_of_the_sphere(self):
        sphere = sorted(self.json("states", FIG1, "--list")["states"])
        general = self.json("states", FIG1, "--list", "--lines", "1")["states"]
        self.assertEqual(sorted(state["state"].replace(" ", "") for state in general), sphere)
        # A body between three fingers: it escapes from none alone.
        modes = self.json("states", FIG1, "--list", "--modes", "cs")["states"]
        self.assertIn("c c c", [state["state"] for state in modes])
        self.fails("states", FIG1, "--lines", "2", naming=["--lines", "tangent"])

    def test_bodies(self):
        box = {"format": "stickslip-grasp/3", "bodies": [{"name": "lower"}, {"name": "upper"}], "defaults": {"friction": "1/2"},
               "contacts": [{"position": [s, t, height], "normal": [0, 0, 1], **who}
                            for height, who in ((0, {"of": "lower", "by": "ground"}), (1, {"of": "upper", "by": "lower"}))
                            for s in (-1, 1) for t in (-1, 1)]}
        self.assertEqual(self.count(box, "--modes", "cs"), 100)
        self.assertEqual(self.count(box, "--modes", "ss"), 196 ** 2)
        box["bodies"].append({"name": "third"})
        self.fails("states", self.write("g.json", box), naming=["18 coordinates", "at most 12"])

    def test_a_tilt_of_a_millionth(self):
        grasp = cube(FLOOR)
        self.assertNotIn("warnings", self.answer(grasp, "--modes", "cs"))
        grasp["contacts"][0]["normal"] = ["0.000001", 0, 1]
        answer = self.answer(grasp, "--modes", "cs")
        self.assertEqual(answer["distinct_states"], 16)
        self.assertIn("planes nearly coincide", answer["warnings"][0])
        self.assertIn("Warning: planes nearly", stickslip("states", self.write("g.json", grasp), "--modes", "cs")[1])

    def test_an_interruption_ends_with_what_was_found(self):
        many = cube(CORNER + [(0, 1), (1, 1), (2, 1)])
        file = self.write("g.json", many)
        master, terminal = pty.openpty()
        with subprocess.Popen([STICKSLIP, "states", file, "--lines", "8", "--snap", "--json", "--certificate", self.path("proof.json")], stdout=subprocess.PIPE,
                              stderr=terminal,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as program:
            os.close(terminal)
            shown = b""
            while b"states so far" not in shown:  # progress, after a second
                shown += os.read(master, 1000)
            program.send_signal(signal.SIGINT)
            out, _ = program.communicate()
        os.close(master)
        answer = json.loads(out)
        self.assertEqual((program.returncode, answer["complete"]), (UNDECIDED, False))
        self.assertGreater(answer["distinct_states"], 0)
        self.assertEqual(os.listdir(self.folder), ["g.json"])  # it proves nothing


if __name__ == "__main__":
    unittest.main()
