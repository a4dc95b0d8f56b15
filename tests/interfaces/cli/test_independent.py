# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers against evaluators that know nothing of the program: Newton's method on the laws, written from mechanics, for loads, preloads
and parameters that are sampled; and statics by linear programs, whose friction cones have many edges from inside and from
outside, so that each says one thing for certain."""

import json
import math
import random
import unittest
from fractions import Fraction as F

import numpy as np
from bodies_newton import Mechanics, Residual, finds, solve
from scipy.optimize import linprog
from test_bodies import contact, force, grasp, random_assembly, weight
from test_cli import DONE, UNDECIDED, UNSTABLE, Case, stickslip
from test_space import unit_normal, written

EDGES = 32


def ask(command, path, *words):
    """The answer, whatever it is."""
    code, out, err = stickslip(command, path, *words, "--json")
    assert code in (DONE, UNSTABLE, UNDECIDED) and not err, (code, err)
    return json.loads(out)


def as_bodies(content, **changes):
    """A file about one body, as Mechanics reads it."""
    contacts = [{**content.get("defaults", {}), **c, "of": "it"} for c in content["contacts"]]
    return {"format": "stickslip-grasp/3", "bodies": [{"name": "it"}], "contacts": contacts, "wrench": content["wrench"], **changes}


def in_statics(content, outside, capacity=None):
    """Whether forces in polyhedral cones, around Coulomb's cones or inside them, balance the load; of given normal forces with
    `capacity`. Scaled to numbers near 1, as the program answers within 1e-7."""
    m = Mechanics(content)
    columns, bounds, rows, limits = [], [], [], []
    for i, mu in enumerate(m.friction):
        first = len(columns)
        columns.append(m.pressing[i])
        bounds.append((0, None) if capacity is None else (capacity[i], capacity[i]))
        across = m.rubbing[i].shape[1]
        columns += [m.rubbing[i][:, k] for k in range(across)]
        bounds += [(None, None)] * across
        edges = [(1.0,), (-1.0,)] if across == 1 else [
            (math.cos(2 * math.pi * k / EDGES), math.sin(2 * math.pi * k / EDGES)) for k in range(EDGES)]
        reach = mu * (1 if outside or across == 1 else math.cos(math.pi / EDGES))
        for edge in edges:
            rows.append({first: -reach, **{first + 1 + k: x for k, x in enumerate(edge)}})
    for row in rows:
        limits.append([row.get(j, 0.0) for j in range(len(columns))])
    size = max(np.abs(m.load).max(), 1e-9)
    found = linprog(np.zeros(len(columns)), A_ub=limits or None, b_ub=np.zeros(len(limits)) if limits else None,
                    A_eq=np.array(columns).T if columns else np.zeros((m.count, 0)), b_eq=-m.load / (1 if capacity is not None else size),
                    bounds=bounds, method="highs")
    return found.status == 0


def directions(count, size, rng):
    for _ in range(count):
        z = [rng.gauss(0, 1) for _ in range(size)]
        length = math.sqrt(sum(x * x for x in z)) * 1.000001
        yield [F(x / length) for x in z]


def with_load(content, z, length):
    """The load of a file about one body, and z more, whose torques are divided by the length."""
    size = 2 if len(z) == 3 else 3
    return {**content, "wrench": [str(F(w) + x * (1 if k < size else length)) for k, (w, x) in enumerate(zip(content["wrench"], z))]}


class Qualities(Case):
    def assert_ball(self, content, answer, length, rng, count):
        """Loads on the border of the proved ball are resisted, and so is one on the way to that which is said not to be, and is not."""
        proved, refuted = F(answer["proved"]), F(answer["refuted"])
        self.assertLess(proved, refuted)
        size = 2 if len(content["wrench"]) == 3 else 3
        towards = [(F(a) - F(b)) / refuted / (1 if k < size else length)
                   for k, (a, b) in enumerate(zip(answer["not_resisted"], content["wrench"]))]
        for z in [towards, *directions(count, len(content["wrench"]), rng)]:
            there = as_bodies(with_load(content, [proved * x for x in z], length))
            self.assertTrue(finds(there), json.dumps(there))
            self.assertTrue(in_statics(there, outside=True), json.dumps(there))
        there = as_bodies({**content, "wrench": answer["not_resisted"]})
        self.assertFalse(finds(there, 100), json.dumps(there))

    def test_in_space(self):
        """Feet on a floor, and the same with one of them on a slope. (Where heights differ, too, a proof takes half a minute.)"""
        for slope in ((0, 0, 1), (0, F(3, 5), F(4, 5))):
            rng = random.Random(11)
            feet = [[F(x) + F(rng.randint(-2, 2), 4) for x in foot] for foot in ((5, 0), (-3, 4), (-3, -4))]
            content = written([{"p": [*foot, 0], "n": (0, 0, 1) if k else slope, "friction": F(rng.randint(4, 9), 10),
                                "stiffness": F(rng.randint(2, 6), 4), "preload": 0} for k, foot in enumerate(feet)],
                              [0, 0, -F(rng.randint(2, 6)), 0, 0, 0])
            answer = ask("quality", self.write("g.json", content), "--length", "1/2", "--accuracy", "50%")
            # The two radii are near each other, so neither is much off.
            self.assertLess(F(answer["refuted"]), F(6, 5) * F(answer["proved"]))
            self.assert_ball(content, answer, F(1, 2), rng, 12)

    def test_of_several_bodies(self):
        """Loads on the upper of two blocks."""
        rng = random.Random(3)
        content = grasp(["low", "up"], [contact(of, (x, y), (0, 1), by=by, friction=mu) for of, by, y, mu in
                                        (("low", None, 0, F(1, 2)), ("up", "low", 1, F(1, 3))) for x in (-1, 1)],
                        [weight("low", 3, (0, F(1, 2))), weight("up", 2, (0, F(3, 2)))])
        answer = self.json("quality", self.write("g.json", content), "--body", "up", "--about", "0,3/2", "--accuracy", "10%")
        proved = F(answer["proved"])
        self.assertGreater(proved, 0)
        for z in directions(20, 3, rng):
            x, y, torque = (proved * e for e in z)
            pushed = {**content, "loads": content["loads"] + [force("up", (x, y), (0, F(3, 2))), {"body": "up", "torque": str(torque)}]}
            self.assertTrue(finds(pushed), json.dumps(pushed))
        falls = {**{k: v for k, v in content.items() if k != "loads"}, "wrench": answer["not_resisted"]}
        self.assertFalse(finds(falls, 100), json.dumps(falls))


def random_pinch(rng, size):
    """Contacts around the origin."""
    contacts = []
    for _ in range(rng.randint(3, 4)):
        n = unit_normal(rng) if size == 3 else rng.choice([(1, 0), (-1, 0), (0, 1), (0, -1), (F(3, 5), F(4, 5)), (-F(4, 5), F(3, 5))])
        contacts.append({"position": [str(-x + F(rng.randint(-1, 1), 4)) for x in n], "normal": [str(x) for x in n],
                         "friction": str(F(rng.randint(4, 9), 10)), "stiffness": str(rng.randint(1, 3))})
    return contacts


class Preloads(Case):
    def pressed(self, content, preloads):
        return {**content, "contacts": [{**c, "preload": str(p)} for c, p in zip(content["contacts"], preloads)]}

    def sampled(self, count, most, rng):
        """Preloads whose sum is at most that, many near it."""
        shares = [rng.expovariate(1) for _ in range(count)]
        part = F(rng.choice((1, 1, rng.random())))
        return [F(most) * part * F(x / sum(shares)) for x in shares]

    def test_least_sums(self):
        """What is found holds, and balances where it says so; no preloads of a sum below the bound do."""
        rng, held = random.Random(21), 0
        for _ in range(40):
            balanced = rng.random() < 0.5
            content = {"format": "stickslip-grasp/2", "contacts": random_pinch(rng, 2),
                       "wrench": [str(F(rng.randint(-4, 4), 2)) for _ in range(3)]}
            code = self.call("preload", content, "--hold", *(["--balanced"] if balanced else []))
            if code is None or not F(code["sum"]):
                continue
            held += 1
            found = [F(p) for p in code["preloads"]]
            self.assertTrue(finds(as_bodies(self.pressed(content, [p * F(1000001, 1000000) for p in found])))
                            or finds(as_bodies(self.pressed(content, found)), 200), json.dumps([content, code]))
            if balanced:
                alone = as_bodies({**content, "wrench": [0, 0, 0]})
                self.assertTrue(in_statics(alone, True, [float(p) for p in found]), json.dumps([content, code]))
            bound = F(code["bound"])
            for _ in range(8 if bound else 0):
                less = self.sampled(len(found), bound * F(999, 1000), rng)
                self.assertFalse(finds(as_bodies(self.pressed(content, less)), 20), json.dumps([content, [str(p) for p in less]]))
            if held == 10:
                break
        self.assertEqual(held, 10)

    def call(self, command, content, *words):
        """The answer; None if there are no preloads."""
        answer = ask(command, self.write("g.json", content), *words)
        return answer if answer["preloads"] is not None else None

    def test_balls(self):
        """Loads of the ball are all held."""
        rng, held = random.Random(22), 0
        while held < 2:
            content = {"format": "stickslip-grasp/2", "contacts": random_pinch(rng, 2),
                       "wrench": [str(F(rng.randint(-2, 2), 2)) for _ in range(3)]}
            answer = self.call("preload", content, "--hold", "--uncertain", "wrench=ball:1/4:length=1/2", "--accuracy", "50%", "--boxes", "8")
            if answer is None:
                continue
            held += 1
            content = self.pressed(content, answer["preloads"])
            for z in directions(20, 3, rng):
                there = as_bodies(with_load(content, [x / 4 for x in z], F(1, 2)))
                self.assertTrue(finds(there), json.dumps(there))

    def budget(self, content, length, rng, samples, *words):
        """What is found resists its ball. Of other preloads of the sum some load is not resisted that is as far as the bound."""
        answer = self.call("preload", content, "--budget", "6", "--length", str(length), *words)
        if answer is None or not F(answer["proved"]):
            return False
        self.assertLessEqual(sum(F(p) for p in answer["preloads"]), 6)
        best = self.pressed(content, answer["preloads"])
        size = len(content["wrench"])
        for z in directions(samples, size, rng):
            there = as_bodies(with_load(best, [F(answer["proved"]) * x for x in z], length))
            self.assertTrue(finds(there), json.dumps(there))
        for _ in range(3):
            other = self.pressed(content, self.sampled(len(content["contacts"]), 6, rng))
            far = F(answer["bound"]) * F(1000002, 1000000)
            self.assertTrue(any(not finds(as_bodies(with_load(other, [far * x for x in z], length)), 20)
                                for z in directions(200, size, rng)), json.dumps([other, answer]))
        return True

    def test_budgets_in_the_plane(self):
        rng, asked = random.Random(23), 0
        while asked < 3:
            content = {"format": "stickslip-grasp/2", "contacts": random_pinch(rng, 2), "wrench": ["0", "-1/2", "0"]}
            asked += self.budget(content, F(1, 2), rng, 15, "--accuracy", "20%", "--boxes", "60")

    def test_budgets_in_space(self):
        """Three fingers round a disc; one box of preloads, as each takes many seconds there."""
        contacts = [{"position": p, "normal": n, "friction": "1/2", "stiffness": "10"} for p, n in (
            (["-1", "0", "0"], ["1", "0", "0"]), (["3/5", "-4/5", "0"], ["-3", "4", "0"]), (["3/5", "4/5", "0"], ["-3", "-4", "0"]))]
        content = {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": ["0", "0", "-1", "0", "0", "0"]}
        self.assertTrue(self.budget(content, F(1, 2), random.Random(25), 8, "--accuracy", "50%", "--boxes", "1"))

    def test_in_space(self):
        """The least that holds."""
        rng = random.Random(24)
        content = {"format": "stickslip-grasp/2", "wrench": ["1/2", "0", "-2", "0", "0", "0"], "contacts": [
            {"position": [str(2 * side), "0", "0"], "normal": [str(-side), "0", "0"], "friction": mu, "stiffness": "10"}
            for side, mu in ((-1, "1/2"), (1, "3/4"))]}
        answer = self.call("preload", content, "--hold", "--accuracy", "30%")
        found, bound = [F(p) for p in answer["preloads"]], F(answer["bound"])
        self.assertTrue(finds(as_bodies(self.pressed(content, [p * F(1000001, 1000000) for p in found]))), json.dumps(answer))
        self.assertGreater(bound, 0)
        for _ in range(10):
            less = self.sampled(2, bound * F(999, 1000), rng)
            self.assertFalse(finds(as_bodies(self.pressed(content, less)), 20), json.dumps([str(p) for p in less]))


class Classes(Case):
    def test_in_space(self):
        """What must move no forces in cones balance; at rest are only what some do."""
        rng, seen = random.Random(31), {"must move": 0, "must hold": 0, "open": 0}
        inside = 0
        for k in range(40):
            contacts = []
            for foot in rng.sample([(x, y) for x in (-1, 1) for y in (-1, 1)], 4 - k % 2):
                x, y = foot
                n = rng.choice([(0, 0, 1), (0, 0, 1), (-x * F(3, 5), 0, F(4, 5)), (0, -y * F(3, 5), F(4, 5)), (x * F(3, 5), 0, F(4, 5))])
                p = [x, y, -1 + F(rng.randint(-1, 1), 4)]
                contacts.append({"position": [str(x) for x in p], "normal": [str(x) for x in n], "friction": str(F(rng.randint(1, 9), 10))})
            at, load = [F(rng.randint(-2, 2), 8) for _ in range(3)], [F(rng.randint(-4, 4), 8), F(rng.randint(-4, 4), 8), F(-1)]
            torque = [at[1] * load[2] - at[2] * load[1], at[2] * load[0] - at[0] * load[2], at[0] * load[1] - at[1] * load[0]]
            content = {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": [str(x) for x in load + torque]}
            code, out, err = stickslip("compare", self.write("g.json", content), "--json", "--methods", "weakly-stable-load,strongly-stable-load",
                                       "--inertia", "0,0,0,1,1,1")
            if code == UNDECIDED:
                continue
            self.assertEqual(code, DONE, err)
            found = json.loads(out)["class"]
            if found is None:
                continue
            seen[found] += 1
            loaded = as_bodies(content)
            loaded["wrench"] = [str(F(x) / max(abs(F(y)) for y in content["wrench"])) for x in content["wrench"]]
            if found == "must move":
                self.assertFalse(in_statics(loaded, outside=False), json.dumps(content))
            else:
                self.assertTrue(in_statics(loaded, outside=True), json.dumps([content, found]))
                inside += in_statics(loaded, outside=False)
        self.assertGreaterEqual(min(seen["must move"], seen["must hold"] + seen["open"]), 5, seen)
        self.assertGreater(inside, 0)


def bilateral(content, starts, seed):
    """How many starts lead to equilibria of the bilateral law, where no contact pulls."""
    mechanics = Mechanics(content)
    if mechanics.size == 0:
        return starts
    residual, rng = Residual(mechanics, bilateral=True), np.random.default_rng(seed)
    x = rng.normal(size=(starts, residual.n)) * rng.choice([0.01, 0.1, 1, 10], size=(starts, 1))
    roundest = 8.0 ** rng.uniform(-6, 1, size=starts)
    for most in 8.0 ** -np.arange(-1, 6):
        x, _ = solve(residual, x, np.minimum(roundest, most), 8)
    x, off = solve(residual, x, np.zeros(starts), 40)
    z = (x[off < 1e-9] * residual.unit)[:, :mechanics.count]
    v = mechanics.preload - mechanics.stiffness * (z @ mechanics.normal.T)
    presses = np.all(v >= -1e-7 * mechanics.size, axis=1)
    for row, k, pull, only in mechanics.springs:
        presses &= (not only) | (pull - k * z @ row >= -1e-7 * mechanics.size)
    return int(np.sum(presses))


class SeveralBodies(Case):
    def verdict(self, content, *words):
        return ask("decide", self.write("g.json", content), "--no-warnings", *words)["verdict"]

    def test_the_bilateral_law(self):
        rng, seen, lost = random.Random(41), {"stable": 0, "unstable": 0, "undecided": 0}, 0
        differ = 0
        for k in range(40):
            content = random_assembly(rng, 2 if k % 4 else 3)
            for c in content["contacts"]:
                c["preload"] = str(rng.choice((1, 2, 4)))
            verdict = self.verdict(content, "--normal-law", "bilateral")
            seen[verdict] += 1
            differ += verdict != self.verdict(content)
            found = bilateral(content, 40, 5)
            if verdict == "unstable":
                self.assertEqual(found, 0, json.dumps(content))
            elif verdict == "stable":
                lost += found == 0
        self.assertGreaterEqual(min(seen["stable"], seen["unstable"]), 8, seen)
        self.assertGreater(differ, 0)
        self.assertLessEqual(lost, seen["stable"] // 10, seen)

    def random_pile(self, rng, count, space):
        """Blocks of random sizes one on the other, pushed at random."""
        names, contacts, loads, bottom = [f"b{k}" for k in range(count)], [], [], F(0)
        width = F(2)
        for k, name in enumerate(names):
            width *= F(rng.randint(14, 20), 20)
            mu, height, by = F(rng.randint(4, 12), 20), F(rng.randint(2, 6), 4), names[k - 1] if k else None
            feet = [(x, y) for x in (-1, 1) for y in (-1, 1)] if space else [(-1,), (1,)]
            contacts += [contact(name, (*(width * s for s in foot), bottom), (*[0] * len(foot), 1), by=by, friction=mu,
                                 preload=0, stiffness=F(rng.randint(2, 8), 4)) for foot in feet]
            loads.append(weight(name, rng.randint(1, 3), (*[0] * (2 if space else 1), bottom + height / 2)))
            bottom += height
        for _ in range(2):
            name = rng.choice(names)
            push = [F(rng.randint(-8, 8), 8) for _ in range(2 if space else 1)]
            loads.append(force(name, (*push, 0), (*[0] * len(push), F(rng.randint(0, 4), 4) * bottom)))
        return grasp(names, contacts, loads)

    def test_many_coordinates(self):
        """Of more than 14, which other tests have."""
        rng, seen, lost = random.Random(42), {"stable": 0, "unstable": 0, "undecided": 0}, 0
        for count, space in [(5, False)] * 8 + [(6, False)] * 4 + [(3, True)] * 4:
            content = self.random_pile(rng, count, space)
            verdict = self.verdict(content)
            seen[verdict] += 1
            found = verdict != "undecided" and (finds(content, 24) or verdict == "stable" and finds(content, 100))
            if verdict == "unstable":
                self.assertFalse(found, json.dumps(content))
            elif verdict == "stable":
                lost += not found
        self.assertGreaterEqual(min(seen["stable"], seen["unstable"]), 4, seen)
        self.assertLessEqual(seen["undecided"], 2, seen)
        self.assertLessEqual(lost, 1, seen)

    def test_radii(self):
        """Grasps within the proved tolerances answer as the middle; the one that is said to differ does."""
        rng, asked = random.Random(43), {"stable": 0, "unstable": 0}
        while sum(asked.values()) < 6:
            content = self.random_pile(rng, 2, False)
            answer = self.json("radius", self.write("g.json", content), "--uncertain", "friction=10%,stiffness=10%,preload=10%",
                               "--accuracy", "30%")
            if asked[answer["verdict"]] == 3:
                continue
            asked[answer["verdict"]] += 1
            holds, factor = answer["verdict"] == "stable", F(answer["proved"])
            for _ in range(12):
                near = {**content, "contacts": [{**c, **{key: str(F(c[key]) * (1 + rng.choice((-1, 1, F(rng.randint(-9, 9), 10))) * factor / 10))
                                                         for key in ("friction", "stiffness")}} for c in content["contacts"]]}
                self.assertEqual(finds(near, 30), holds, json.dumps(near))
            if answer["refuted"] is not None:
                other = {**content, **{key: answer["counterexample"][key] for key in ("contacts", "loads") if key in answer["counterexample"]}}
                self.assertEqual(finds(other, 60), not holds, json.dumps(other))

    def test_maps(self):
        """Cells that are proved, sampled at their corners and inside."""
        rng = random.Random(44)
        content = grasp(["low", "up"], [contact(of, (x, y), (0, 1), by=by, friction=mu) for of, by, y, mu in
                                        (("low", None, 0, F(1, 2)), ("up", "low", 1, F(1, 3))) for x in (-1, 1)],
                        [weight("low", 3, (0, F(1, 2))), weight("up", 2, (0, F(3, 2))), force("up", (F(1, 2), 0), (0, F(3, 2)))])
        cells = self.json("map", self.write("g.json", content), "--x", "friction[2]=0:1", "--y", "friction[0]=0:1",
                          "--depth", "4")["cells"]
        asked = {"stable": 0, "unstable": 0}
        for cell in rng.sample(cells, min(len(cells), 30)):
            if cell["verdict"] not in asked:
                continue
            asked[cell["verdict"]] += 1
            for part in (F(1, 100), F(1, 2), F(99, 100)):
                at = [F(cell[axis][0]) + part * (F(cell[axis][1]) - F(cell[axis][0])) for axis in "xy"]
                there = json.loads(json.dumps(content))
                there["contacts"][2]["friction"], there["contacts"][0]["friction"] = map(str, at)
                self.assertEqual(finds(there, 40), cell["verdict"] == "stable", json.dumps(there))
        self.assertGreaterEqual(min(asked.values()), 3, asked)


if __name__ == "__main__":
    unittest.main()
