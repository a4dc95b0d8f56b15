# SPDX-License-Identifier: MIT
"""Balls of loads (certificate/FORMAT.md, section 6): the option, and the bound of their work against the work of single loads. (What
rules say of them is for tests/rules.)"""

import random
import unittest
from fractions import Fraction

from support import check, posed

PLANE = {"format": "stickslip-grasp/2", "contacts": [], "wrench": [1, -2, 3]}
SPACE = {"format": "stickslip-grasp/2", "contacts": [], "wrench": [1, -2, 3, 0, "1/2", -1]}
# A tip on a hinge at (1, 0) of a palm that slides along (0, 1), with a joint for each, that of the tip turning it twice as far.
HAND = {"format": "stickslip-grasp/3", "contacts": [], "wrench": [1, 2, 3, 4, 5],
        "bodies": [{"name": "palm", "slide": [0, 1]}, {"name": "box"}, {"name": "tip", "hinge": [1, 0], "on": "palm"}],
        "joints": [{"turns": {"palm": 1}}, {"turns": {"tip": 2}}]}


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def planar(y, c):
    """How the point c moves, and the turn."""
    return y[0] - y[2] * c[1], y[1] + y[2] * c[0], y[2]


def spatial(y, c):
    return *(u + v for u, v in zip(y[:3], cross(y[3:], c))), *y[3:]


def of_the_tip(y, c):
    turn = 2 * y[4]
    return -turn * c[1], y[3] + turn * (c[0] - 1), turn


CASES = {"plane": (PLANE, None, planar), "space": (SPACE, None, spatial), "body": (HAND, "box", planar),
         "link": (HAND, "tip", of_the_tip)}


def in_ball(file, ball):
    return posed(file, "--uncertain", "wrench=" + ball)


def random_box(rng, case):
    """(box, R, L, c): of a ball, some components of which are cut."""
    file, body, _ = CASES[case]
    radius, length = (Fraction(rng.randint(1, 9), rng.randint(1, 4)) for _ in range(2))
    about = [Fraction(rng.randint(-6, 6), 2) for _ in range(3 if case == "space" else 2)]
    words = [f"ball:{radius}", f"about={':'.join(map(str, about))}", f"length={length}"]
    box = check.enlarged(in_ball(file, ":".join(words + [f"body={body}"] * (body is not None))), 128)
    for _ in range(rng.randint(0, 4)):
        j = rng.randrange(len(box.loads.bounds))
        low, high = box.loads.bounds[j]
        cut = low + (high - low) * Fraction(rng.randint(1, 7), 8)
        box = rng.choice(box.halves(check.Node("part", j, (cut,), "wrench")))
    return box, radius, length, about


def on_sphere(rng, size):
    """A rational point of length 1: the image of a random one under the stereographic projection."""
    p = [Fraction(rng.randint(-9, 9), rng.randint(1, 5)) for _ in range(size - 1)]
    square = sum(c * c for c in p)
    point = [2 * c / (1 + square) for c in p] + [(1 - square) / (1 + square)]
    rng.shuffle(point)
    return point


class WorkTest(unittest.TestCase):
    def test_no_load_does_more(self):
        """Nor is the bound larger than it has to be: one of the two is attained, the root up to its rounding."""
        rng = random.Random(1)
        inside = roots = corners = 0
        for k in range(400):
            case = list(CASES)[k % 4]
            box, radius, length, about = random_box(rng, case)
            file, _, moved_by = CASES[case]
            w = list(map(Fraction, file["wrench"]))
            y = tuple(Fraction(rng.randint(-5, 5), rng.randint(1, 3)) for _ in w)
            moved, size = moved_by(y, about), 6 if case == "space" else 3
            fixed = sum(a * b for a, b in zip(w, y))
            bound = box.loads.most_work(y) - fixed
            radii = [radius * (1 if j < len(about) else length) for j in range(size)]
            for _ in range(20):
                share = rng.choice([1, 1, Fraction(1, 2)])
                z = [share * r * c for r, c in zip(radii, on_sphere(rng, size))]
                if all(low <= c <= high for c, (low, high) in zip(z, box.loads.bounds)):
                    inside += 1
                    self.assertLessEqual(sum(a * b for a, b in zip(z, moved)), bound)
            square = sum((r * c) ** 2 for r, c in zip(radii, moved))  # that of the ball's largest work
            most = sum(max(low * c, high * c) for c, (low, high) in zip(moved, box.loads.bounds))
            if bound == most:
                corners += 1
                self.assertTrue(most <= 0 or (most * (1 - Fraction(1, 2 ** 62))) ** 2 <= square)
            else:
                roots += 1
                self.assertTrue(0 <= bound < most and square <= bound ** 2 <= square * (1 + Fraction(1, 2 ** 60)), (bound, square))
        self.assertGreater(min(inside // 10, roots, corners), 50)

    def test_rational_lengths_are_not_rounded(self):
        loads = in_ball({**PLANE, "wrench": [0, 0, 0]}, "ball:2:length=2").loads
        self.assertEqual([loads.most_work(tuple(map(Fraction, y))) for y in ((3, 4, 0), (0, 3, 2), (0, 0, -1), (0, 0, 0))],
                         [10, 10, 4, 0])

    def test_middle_is_nearest_to_none(self):
        """In the ball, if any load of the part is."""
        box = check.enlarged(in_ball(PLANE, "ball:1"), 128)
        for j, cut, end in ((0, "1/2", 1), (1, "-1/4", 0), (2, "3/4", 0), (2, "-1/8", 1)):
            box = box.halves(check.Node("part", j, (Fraction(cut),), "wrench"))[end]
        self.assertEqual([tuple(map(str, z)) for z in box.middle().loads.bounds], [("1/2", "1/2"), ("-1/4", "-1/4"), ("0", "0")])
        self.assertTrue(box.middle().certain)
        self.assertFalse(box.certain)


class OptionTest(unittest.TestCase):
    def read(self, text):
        return check.parse_arguments(["g", "c", "--uncertain", text]).options.uncertain

    def test_members_in_any_order(self):
        wanted = check.Ball(Fraction(1, 10), Fraction(2), (Fraction(3), Fraction(0)), "a:b=c")
        for text in ("ball:0.1:length=2:about=3:0:body=a:b=c", "ball:1/10:about=3:0:length=2:body=a:b=c"):
            self.assertEqual(self.read(f"friction=5%,wrench={text},preload=1"), {
                "friction": check.Tolerance(Fraction(5), True), "wrench": wanted, "preload": check.Tolerance(Fraction(1), False)})
        self.assertEqual(self.read("wrench=ball:3"), {"wrench": check.Ball(Fraction(3), Fraction(1), (), None)})
        self.assertEqual(self.read("wrench=ball:3:body=x:length=2")["wrench"].body, "x:length=2")

    def test_balls_that_cannot_be_asked(self):
        uncertain = {**PLANE, "wrench": [{"min": 0, "max": 1}, 0, 0]}
        for file, ball, words in (
                (PLANE, "ball:0", "radius must be > 0"), (PLANE, "ball:-1", "radius must be > 0"),
                (PLANE, "ball:1:length=0", "length must be > 0"), (PLANE, "ball:1:about=1", "has 1 coordinates, must have 2"),
                (PLANE, "ball:1:about=1:2:3", "has 3 coordinates, must have 2"),
                (SPACE, "ball:1:about=1:2", "has 2 coordinates, must have 3"), (PLANE, "ball:1:body=it", "of one body"),
                (HAND, "ball:1", "no body is named"), (HAND, "ball:1:body=", "no body ''"), (HAND, "ball:1:body=ground", "no body 'ground'"),
                (HAND, "ball:1:body=thumb", "must be one of (palm, box, tip)"), (uncertain, "ball:1", "must be numbers")):
            with self.assertRaises(check.Malformed) as raised:
                in_ball(file, ball)
            self.assertEqual(raised.exception.place, "uncertain")
            self.assertIn(words, raised.exception.problem)


if __name__ == "__main__":
    unittest.main()
