# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases, their proofs, and judgements of physics engines, on 40 cases and two engines."""

import contextlib
import copy
import io
import json
import os
import subprocess
import sys
import tempfile
import unittest
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "bench" / "engines"))

import solid  # noqa: E402
from certify import CHECKER, accepted, certify, judgement  # noqa: E402
from engines import ENGINES, HERE, SOLID_ENGINES  # noqa: E402
from forces import judge_forces, summary  # noqa: E402
from judge import read_results  # noqa: E402
from run import read_cases, run  # noqa: E402
from scene import Body, Obstacle, contacts, disc, grasp_file, placed, polygon, scene_of  # noqa: E402
from solid_forces import judge_solid_forces, outside  # noqa: E402
from truth import inertia_of, load_class, read, work  # noqa: E402

ALL = list(read_cases())
CASES = ALL[:: len(ALL) // 40][:40]
SOLID = list(read_cases(HERE / "cases/space"))
# Few: what must hold takes its time to ask. Two of each family, one that must hold and one that must move.
SOLID_CASES = list({(c["grasp"]["name"].rsplit("-", 3)[0], c["class"]): c for c in SOLID if c["gap"] == 10}.values())


def judged(name, cases, engines=ENGINES):
    """At the engine's own rate."""
    engine = next(e for e in engines if e.name == name)
    if engine.missing():
        if os.environ.get("CI") and name != "rapier":  # which is one of npm's that CI leaves out
            raise AssertionError(f"{name}: {engine.missing()} is missing")
        raise unittest.SkipTest(f"{name}: {engine.missing()} is missing")
    engine = engine._replace(rates=engine.rates[:1])
    with tempfile.TemporaryDirectory() as folder:
        run(Path(folder), [engine], cases)
        return read_results(Path(folder), engine, engine.rates[0], {c["grasp"]["name"]: c for c in cases})


class Cases(unittest.TestCase):
    def test_there_are_enough(self):
        self.assertGreaterEqual(len(ALL), 600)
        self.assertEqual(len({c["grasp"]["name"] for c in ALL}), len(ALL))

    def test_class_and_contacts_are_those_of_the_scene(self):
        for case in CASES:
            body, obstacles = scene_of(case)
            grasp = case["grasp"]
            wrench = tuple(map(read, grasp["wrench"]))
            self.assertEqual(grasp_file(grasp["name"], body, contacts(body, obstacles), wrench), grasp)
            kind, motion = load_class(grasp, inertia_of(case))
            self.assertEqual(kind, case["class"], grasp["name"])
            if kind == "must move":
                self.assertGreater(work(motion, wrench), 0)

    def test_in_space(self):
        self.assertGreaterEqual(len(SOLID), 100)
        self.assertEqual(len({c["grasp"]["name"] for c in SOLID}), len(SOLID))
        for case in SOLID_CASES:
            body, obstacles = solid.scene_of(case)
            grasp = case["grasp"]
            wrench = tuple(map(read, grasp["wrench"]))
            self.assertEqual(solid.grasp_file(grasp["name"], body, solid.contacts(body, obstacles), wrench), grasp)
            kind, motion = load_class(grasp, inertia_of(case))
            self.assertEqual(kind, case["class"], grasp["name"])
            if kind == "must move":
                self.assertGreater(work(motion, wrench), 0)

    def test_what_slides_in_space_is_known_in_closed_form(self):
        """A block that is pushed at its middle slides at mu times its weight, in every direction."""
        yawed = [c for c in SOLID if c["grasp"]["name"].startswith("yawed")]
        self.assertGreater(len(yawed), 5)
        for case in yawed:
            x, y, z, *_ = map(read, case["grasp"]["wrench"])
            slides = x * x + y * y > (read(case["obstacles"][0]["friction"]) * z) ** 2
            self.assertEqual(case["class"], "must move" if slides else "must hold")


class Proofs(unittest.TestCase):
    CHECKERS = ([CHECKER], [sys.executable, str(HERE.parents[1] / "certificate/python/check.py")])

    def test_of_every_17th_case_are_accepted_for_their_own_case_alone(self):
        """In space these are one of each family that must hold, and one that must move."""
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-B", str(HERE / "certify.py"), "--every", "17", folder],
                                  capture_output=True, text=True)
            families = sorted(path.relative_to(HERE / "cases") for path in (HERE / "cases").rglob("*.jsonl"))
            self.assertEqual(sorted(p.relative_to(folder) for p in Path(folder).rglob("*") if p.is_file()), families)
            cases, proofs = [], []
            for family in families:
                cases += map(json.loads, (HERE / "cases" / family).read_text(encoding="utf-8").splitlines()[::17])
                proofs += (Path(folder) / family).read_text(encoding="utf-8").splitlines()
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (0, f"{len(cases)} proofs made, {len(cases)} accepted\n", ""))
        self.assertEqual(len(proofs), len(cases))
        self.assertEqual({c["class"] for c in cases if "vertices" in c}, {"must hold", "must move"})
        for index, case in enumerate(cases):
            for checker in self.CHECKERS:
                self.assertEqual(judgement(checker, case, proofs[index]), accepted(case), case["grasp"]["name"])
                self.assertRegex(judgement(checker, case, proofs[index - 1]), "^(rejected|stickslip-check:|check.py:)")

    def test_of_another_class_than_the_case_states_are_counted(self):
        right, wrong = copy.deepcopy(ALL[:2])
        wrong["class"] = {"must hold": "must move", "must move": "must hold"}[wrong["class"]]
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as said:
            family = Path(folder) / "family.jsonl"
            family.write_text(f"{json.dumps(right)}\n{json.dumps(wrong)}\n", encoding="utf-8")
            self.assertEqual(certify([family], Path(folder) / "proofs"), (2, 1))
        self.assertEqual(said.getvalue().splitlines()[0], f"{wrong['grasp']['name']}, which {wrong['class']}: accepted")


class Scenes(unittest.TestCase):
    def test_a_box_on_a_floor_and_tilted(self):
        F = Fraction
        body, centre = polygon([(F(0), F(0)), (F(2), F(0)), (F(2), F(1)), (F(0), F(1))])
        self.assertEqual(centre, (1, F(1, 2)))
        floor = Obstacle((F(0), F(-1, 2)), (F(0), F(1)), F(1, 2))
        self.assertEqual([c.position for c in contacts(body, [floor])], [(-1, F(-1, 2)), (1, F(-1, 2))])
        tilted = placed(body, (0.0, 0.0, 0.01))
        self.assertEqual(contacts(tilted, [floor]), [])
        self.assertEqual(len(contacts(tilted, [floor], F(1, 50))), 2)

    def test_a_tip_pushes_along_the_normal_of_the_edge(self):
        F = Fraction
        body, _ = polygon([(F(-1), F(-1)), (F(1), F(-1)), (F(1), F(1)), (F(-1), F(1))])
        found = contacts(body, [Obstacle((F(1, 2), F(-1)), (F(0), F(1)), F(1), True)])
        self.assertEqual([(c.position, c.normal) for c in found], [((F(1, 2), -1), (0, 2))])

    def test_a_disc(self):
        wall = Obstacle((Fraction(-1), Fraction(0)), (Fraction(1), Fraction(0)), Fraction(1))
        self.assertEqual([c.position for c in contacts(disc(Fraction(1)), [wall])], [(-1, 0)])
        self.assertEqual(contacts(disc(Fraction(1, 2)), [wall]), [])
        self.assertIsInstance(disc(Fraction(1)), Body)


class Cones(unittest.TestCase):
    def test_no_tolerance(self):
        F = Fraction
        normal, mu = (F(0), F(0), F(2)), F(1, 2)
        self.assertEqual(outside((F(3), F(4), F(10)), normal, mu), 0.0)
        self.assertGreater(outside((F(3), F(4), F(10) - F(1, 10**12)), normal, mu), 0.0)
        self.assertAlmostEqual(outside((F(3), F(4), F(8)), normal, mu), 1.0)
        self.assertEqual(outside((F(0), F(0), F(-1)), normal, mu), 1.0)


class Engines(unittest.TestCase):
    def check(self, name):
        found = judged(name, CASES)
        self.assertEqual(len(found), len(CASES))
        failures = [(j.case["grasp"]["name"], j.verdict) for j in found if j.verdict.startswith("false")]
        self.assertEqual(failures, [])
        self.assertEqual(summary(judge_forces(found))["cone"]["broken"], 0)
        return found

    def test_planck(self):
        self.check("planck")

    def test_box2d_and_what_it_would_be_if_it_were_wrong(self):
        found = self.check("Box2D")
        # Its forces, with friction by half too large: all that slip, and some that hold, leave the cone.
        wrong = copy.deepcopy(found)
        for j in wrong:
            for s in j.samples:
                for c in s["contacts"]:
                    normal = c[2] * c[4] + c[3] * c[5]
                    c[4] += (c[4] - normal * c[2]) / 2
                    c[5] += (c[5] - normal * c[3]) / 2
        self.assertGreater(summary(judge_forces(wrong))["cone"]["broken"], len(CASES) // 3)

    def test_in_space_pyramids_are_found_out(self):
        """ODE's friction has a limit along each of two directions: right along them, too much between."""
        cases = [c for c in SOLID if c["class"] == "must move" and c["gap"] == 10]
        moved = defaultdict(set)
        for j in judged("ODE dWorldQuickStep", cases, SOLID_ENGINES):
            moved[j.case["grasp"]["name"].rsplit("-", 3)[0]].add(j.verdict)
        self.assertEqual(moved["extruded-ramp"], {"right"})
        self.assertIn("false hold", moved["yawed"])
        forces = judge_solid_forces(judged("ODE dWorldQuickStep", SOLID_CASES, SOLID_ENGINES))
        self.assertGreater(summary(forces)["cone"]["broken"], 3)

    def test_in_space_rapier_has_round_cones(self):
        found = judged("rapier", [c for c in SOLID_CASES if c["grasp"]["name"].startswith("yawed")], SOLID_ENGINES)
        self.assertEqual({j.verdict for j in found} - {"creeps"}, {"right"})

    def test_in_space_friction_by_a_fifth_more_holds_what_must_move(self):
        ramps = [c for c in SOLID if c["grasp"]["name"].startswith("extruded-ramp") and c["gap"] == 10]
        changed = copy.deepcopy(ramps)
        for case in changed:
            case["obstacles"][0]["friction"] = str(read(case["obstacles"][0]["friction"]) * Fraction(6, 5))
        verdicts = lambda cases: {j.verdict for j in judged("ODE dWorldQuickStep", cases, SOLID_ENGINES)}
        self.assertLessEqual(verdicts(ramps), {"right", "creeps"})
        self.assertIn("false hold", verdicts(changed))

    def test_wrong_friction_is_a_failure(self):
        ramps = [c for c in ALL if c["grasp"]["name"].startswith("ramp")][:12]
        for factor, verdict in ((Fraction(6, 5), "false hold"), (Fraction(4, 5), "false slip")):
            changed = copy.deepcopy(ramps)
            for case in changed:
                for obstacle in case["obstacles"]:
                    obstacle["friction"] = str(read(obstacle["friction"]) * factor)
            self.assertEqual({j.verdict for j in judged("Box2D", changed)} - {"right", "creeps"}, {verdict})


if __name__ == "__main__":
    unittest.main()
