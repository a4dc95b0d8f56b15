# SPDX-License-Identifier: MIT
"""Leaves whose twist moves (certificate/FORMAT.md, section 4): what forces do that obey the law, at random, against the bound of them by
rays; and all checkers at thresholds of leaves. (What rules say of them is for tests/rules.)"""

import collections
import math
import random
import types
import unittest
from fractions import Fraction

from support import STICKSLIP_CHECK, Case, certificate, check, in_batch, interval, posed


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def some(rng, most=3):
    return Fraction(rng.randint(-8 * most, 8 * most), 8)


def few(rng, low, high, share):
    """An interval, for a share of all; or one number."""
    ends = sorted(Fraction(rng.randint(8 * low, 8 * high), 8) for _ in range(2))
    return ends if rng.random() < share else [ends[0]] * 2


def spelled(ends):
    return interval(*map(str, ends)) if ends[0] < ends[1] else str(ends[0])


CASES = ("plane", "space", "fingers", "links")


class Grasp:
    """A file at random, with what it says in a form of its own. `links`: in the plane, a body on two slides with springs, along x and y."""

    def __init__(self, rng, case):
        share = rng.choice((0, 0, 0.2, 0.6))  # of what is uncertain
        self.case, self.space = case, case in ("space", "fingers")
        size = 3 if self.space else 2
        self.contacts, listed = [], []
        for _ in range(rng.randint(1, 3)):
            normal = [0] * size
            while not any(normal):
                normal = [rng.randint(-2, 2) for _ in range(size)]
            one = {"normal": normal, "p": [few(rng, -2, 2, share) for _ in range(size)], "mu": few(rng, 0, rng.choice((1, 1, 1, 9)), share), "k": few(rng, 1, 3, share),
                   "P": few(rng, 0, 3, share), "slope": Fraction(rng.choice((0, 1, 3)) * (rng.random() < 2 * share), 8), "e": Fraction(0)}
            if case == "fingers" and rng.random() < 0.7:
                one["slope"], one["e"] = Fraction(0), Fraction(rng.randint(1, 8), 4)
            self.contacts.append(one)
            listed.append({"position": list(map(spelled, one["p"])), "friction": spelled(one["mu"]), "stiffness": spelled(one["k"]),
                           "preload": spelled(one["P"]),
                           "normal": {"direction": normal, "slope": str(one["slope"])} if one["slope"] else normal})
            if case in ("fingers", "links"):
                listed[-1]["of"] = "it"
            if one["e"]:
                listed[-1]["torsion"] = str(one["e"])
        self.wrench = [few(rng, -2, 2, share) for _ in range({"plane": 3, "links": 2}.get(case, 6))]
        self.springs = [(few(rng, 0, 2, share), few(rng, -2, 2, share)) for _ in range(2)] if case == "links" else []
        self.file = {"format": "stickslip-grasp/2", "contacts": listed, "wrench": list(map(spelled, self.wrench))}
        if case == "fingers":
            self.file.update(format="stickslip-grasp/3", bodies=[{"name": "it"}])
        if case == "links":
            self.file.update(format="stickslip-grasp/3", bodies=[{"name": "x", "slide": [1, 0]}, {"name": "it", "slide": [0, 1], "on": "x"}],
                             joints=[{"turns": {name: 1}, "stiffness": spelled(k), "torque": spelled(torque)}
                                     for name, (k, torque) in zip(("x", "it"), self.springs)])

    def motion(self, d, p):
        """Of the point p, and the turn, in three coordinates."""
        if self.space:
            return [a + b for a, b in zip(d[:3], cross(d[3:], p))], d[3:]
        x, y, turn = (*d, 0)[:3]
        return [x - turn * p[1], y + turn * p[0], 0], [0, 0, turn]

    def work(self, rng, d, h, y):
        """What load and forces do on y, which obey the law at (d, h), of a choice of all numbers at random; and how many slip."""
        def choice(ends):
            return float(rng.choice((*ends, ends[0] + (ends[1] - ends[0]) * Fraction(rng.random()))))

        total, slips = h * dot(map(choice, self.wrench), y), 0
        for one in self.contacts:
            p = [*map(choice, one["p"]), 0][:3]
            n, stretch = self.turned(rng, [*one["normal"], 0][:3], float(one["slope"]))
            mu, e = choice(one["mu"]), float(one["e"])
            # Any P' and k' of the box of parameters, over a unit normal.
            turned = one["slope"] ** 2
            preload = stretch * choice((one["P"][0] * (1 - turned / 2), one["P"][1]))
            stiffness = stretch ** 2 * choice((one["k"][0] * (1 - turned), one["k"][1]))

            def seen(motion):
                u, turn = self.motion(motion, p)
                along = dot(n, u)
                return along, [c - along * a for c, a in zip(u, n)] + [e * dot(n, turn)]

            along, slip = seen(d)
            pushed, moved = seen(y)
            push = max(0.0, preload * h - stiffness * along)
            length = math.hypot(*slip)
            if length > 1e-6:
                friction = [-mu * push * s / length for s in slip]
                slips += push > 0
            else:
                friction = [rng.gauss(0, 1) for _ in slip]
                if rng.random() < 0.5:
                    friction = list(moved)  # which does most
                friction[3] *= e > 0
                friction[2] *= self.space
                inwards = dot(n, friction)
                friction = [c - inwards * a for c, a in zip(friction, n)] + friction[3:]
                friction = [mu * push * c / (math.hypot(*friction) or 1) for c in friction]
            total += push * pushed + dot(friction, moved)
        for j, (k, torque) in enumerate(self.springs):
            total += (choice(torque) * h - choice(k) * d[j]) * y[j]
        return total, slips

    def turned(self, rng, n, slope):
        """A unit vector near n, and the length of a vector that is n over its length and something across it."""
        length = math.hypot(*n)
        n = [c / length for c in n]
        aside = [rng.gauss(0, 1), rng.gauss(0, 1), rng.gauss(0, 1) * self.space]
        aside = [c - dot(aside, n) * a for c, a in zip(aside, n)]
        size = slope * rng.choice((1, rng.random())) / (math.hypot(*aside) or 1)
        n = [a + size * c for a, c in zip(n, aside)]
        stretch = math.hypot(*n)
        return [c / stretch for c in n], stretch

    def sticking(self, rng, d):
        """A motion near d that does not move the middle of some contact across its normal, if that is all its position."""
        one = rng.choice(self.contacts)
        p = [float(low) for low, _ in one["p"]]
        if not self.space:
            along = dot(one["normal"], d)
            return [along * one["normal"][0], along * one["normal"][1], *([0] * (len(d) - 2))]
        turn = [some(rng) * c for c in one["normal"]] if not one["e"] else [Fraction(0)] * 3
        back = cross([float(c) for c in turn], p)
        lift = some(rng)
        return [lift * c - Fraction(b) for c, b in zip(one["normal"], back)] + turn


def own_slips(rng, grasp, c, d):
    """A list of [i, κ, ψ], with |ψ| <= κ. Mostly ψ is nearly against the slip at the motion d."""
    listed = []
    for i, one in enumerate(grasp.contacts):
        kappa = rng.choice((abs(c), abs(c), abs(some(rng))))
        n, p = [*map(float, one["normal"]), 0][:3], [*(float(low) for low, _ in one["p"]), 0][:3]
        u, turn = grasp.motion(list(map(float, d)), p)
        slip = [a - dot(n, u) / dot(n, n) * b for a, b in zip(u, n)]
        if not grasp.space:
            slip = [n[0] * slip[1] - n[1] * slip[0]]  # τ has its sign
        elif one["e"]:
            slip.append(dot(n, turn))
        if rng.random() < 0.3:
            slip = [rng.gauss(0, 1) for _ in slip]
        gamma = float(one["e"] ** 2) / dot(n, n)
        length = math.sqrt(sum((1, 1, 1, gamma)[j] * s * s for j, s in enumerate(slip)))
        size = rng.choice((1, 1, rng.random(), -1)) * (1 - 1e-9)
        psi = [Fraction(-float(kappa) * size * s / length) if length > 1e-6 else Fraction(0) for s in slip]
        if rng.random() < 0.8:
            listed.append((i, kappa, tuple(psi)))
    return listed


class MechanicsTest(unittest.TestCase):
    def test_forces_do_not_more_than_the_bound(self):
        rng = random.Random(61)
        tally = collections.Counter()
        for k in range(1200):
            case = CASES[k % len(CASES)]
            grasp = Grasp(rng, case)
            box = check.enlarged(posed(grasp.file), 128)
            size = box.dimension
            # A point as a sum of rays, around one at which mostly something sticks.
            d = [some(rng) for _ in range(size)]
            if rng.random() < 0.5:
                d = grasp.sticking(rng, d) if rng.random() < 0.8 else [Fraction(0)] * size
            spread = Fraction(1, rng.choice((1, 4, 64)))
            shifts = [[spread * some(rng) for _ in range(size)] for _ in range(rng.randint(0, 3))]
            shifts.append([-sum(column, Fraction(0)) for column in zip(*shifts)] if shifts else [Fraction(0)] * size)
            count = len(shifts)
            rays = [check.integers([*((a + b) / count for a, b in zip(d, shift)), Fraction(1, count), Fraction(0)]) for shift in shifts]
            shares = [1 / factor for _, factor in rays]
            region = types.SimpleNamespace(generators=lambda: [(x, 0) for x, _ in rays], box=box,
                                           cone=types.SimpleNamespace(weight=1))
            y, c = [some(rng) for _ in range(size)], some(rng)
            if rng.random() < 0.4:
                y = [rng.choice((-2, 0, 0)) * a for a in d]  # y(x) is a multiple of the motion, or nearly
            leaf = check.MovingLeaf(region, check.Node("moving", numbers=(*y, c), own=own_slips(rng, grasp, c, d)), None)
            bound = sum(float(leaf.bound(r, s)) / 2 * shares[r] * shares[s] for r in range(count) for s in range(count))
            motion, twist = [float(a) for a in d], [float(c * a + b) for a, b in zip(d, y)]
            for _ in range(5):
                work, slips = grasp.work(rng, motion, 1.0, twist)
                self.assertLessEqual(work, bound + 1e-7 * (1 + abs(bound)), (grasp.file, d, y, c))
                tally[case, "slips" if slips else "sticks", "near" if work > bound - 1e-2 else "far"] += 1
        for case in CASES:
            for state in ("slips", "sticks"):
                self.assertGreater(tally[case, state, "near"], 5, tally)


class ThresholdTest(Case):
    """A load is moved along a leaf's twist until the leaf holds, and a little back: all checkers must find the same node to be the first
    that does not hold, that leaf or one of those behind it."""

    def asked(self, grasp, y, t, nodes):
        grasp.file["wrench"] = [spelled([end - t * c for end in ends]) for ends, c in zip(grasp.wrench, y)]
        stated = [list(map(str, ends)) if ends[0] < ends[1] else str(ends[0])
                  for ends in ([end - t * c for end in ends] for ends, c in zip(grasp.wrench, y))]
        bound = ["1/2"] * len(y)
        proof = certificate(len(grasp.contacts), stated, tree=nodes + [["leaf", *[0] * len(y)]] * (len(nodes) - 1))
        proof["question"]["contacts"] += len(grasp.springs)
        proof["question"]["max_motion"] = bound
        return grasp.file, proof, "--max-motion=" + ",".join(bound)

    def test_all_say_the_same(self):
        rng = random.Random(62)
        tally = collections.Counter()
        for k in range(120):
            grasp = Grasp(rng, CASES[k % len(CASES)])
            size = len(grasp.wrench)
            y, c = [some(rng) for _ in range(size)], abs(some(rng))
            if not any(y):
                continue
            own = [[i, str(kappa), list(map(str, psi)) if grasp.space else str(psi[0])]
                   for i, kappa, psi in own_slips(rng, grasp, c, [some(rng) for _ in y])]
            nodes = [["plane", *(str(some(rng, 1)) for _ in y), str(rng.choice((0, 1, Fraction(1, 8))))] for _ in range(rng.randint(0, 3))]
            nodes.append(["moving", *map(str, y), str(c), own])

            def holds(t, report=None):
                report = report or self.judged(*self.asked(grasp, y, t, nodes))
                self.assertIn(report["rule"], ("leaf-bound", None), report)
                return report["node"] != len(nodes) - 1

            low, high = Fraction(0), Fraction(1)
            while high < 2000 and not holds(high):
                low, high = high, high * 8
            if high >= 2000:
                tally["never"] += 1
                continue
            for _ in range(rng.choice((3, 20, 70))):
                middle = (low + high) / 2
                low, high = (low, middle) if holds(middle) else (middle, high)
            for t in (low, high):
                _, report, _, _ = self.run_both(*self.asked(grasp, y, t, nodes))
                tally[holds(t, report)] += 1
        self.assertGreater(tally[True], 40, tally)
        self.assertGreater(tally[False], 40, tally)

    def judged(self, file, proof, option):
        """The report of stickslip-check alone, or if there is none of check.py."""
        if STICKSLIP_CHECK:
            return in_batch([STICKSLIP_CHECK], file, proof, [option])
        return self.run_both(file, proof, option)[1]


if __name__ == "__main__":
    unittest.main()
