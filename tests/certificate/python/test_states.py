# SPDX-License-Identifier: MIT
"""§17: how many states there are, and the signs of motions, beside naive twins. Rules are in tests/rules.

The naive count is Zaslavsky's: chambers by deletion and restriction, of the restrictions to all flats.
"""

import itertools
import math
import random
import unittest
from fractions import Fraction

from support import check


def normal_form(row):
    divisor = math.gcd(*row)
    return tuple(x // (divisor if next(filter(None, row)) > 0 else -divisor) for x in row) if divisor else None


def restrict(row, plane):
    p = next(i for i, x in enumerate(plane) if x)
    return normal_form([row[i] * plane[p] - row[p] * plane[i] for i in range(len(row)) if i != p])


def chambers(rows):
    rows = list(rows)
    return 1 + sum(chambers({restrict(r, row) for r in rows[:i]}) for i, row in enumerate(rows)) if rows else 1


def naive_faces(rows, dimension):
    """By dimension: each flat is a set of rows, closed."""
    rows = [row for row in dict.fromkeys(map(normal_form, rows)) if row]
    faces = [0] * (dimension + 1)
    flats = {frozenset(): (dimension, {row: row for row in rows})}
    while flats:
        following = {}
        for on, (d, here) in flats.items():
            faces[d] += chambers(set(here.values()))
            for plane in set(here.values()):
                more = frozenset(row for row, image in here.items() if image == plane)
                following[on | more] = (d - 1, {row: restrict(image, plane) for row, image in here.items() if row not in more})
        flats = following
    return faces


def counted(rows, dimension, closed=(), most=10 ** 9):
    return check.count_states([tuple(row) for row in rows], [tuple(row) for row in closed], dimension, most)


def random_rows(draw, count, dimension, most):
    return [tuple(draw.randint(-most, most) for _ in range(dimension)) for _ in range(count)]


class CountTest(unittest.TestCase):
    def test_degenerate_arrangements(self):
        draw = random.Random(1)
        for _ in range(150):
            dimension = draw.randint(2, 6)
            rows = random_rows(draw, draw.randint(0, 8), dimension, 1)
            self.assertEqual(counted(rows, dimension), naive_faces(rows, dimension), rows)

    def test_where_other_planes_meet(self):
        """What is the same with their rows as coordinates that are 0: here the first ones."""
        draw = random.Random(2)
        for _ in range(60):
            dimension, closed = draw.randint(2, 4), draw.randint(1, 2)
            rows = random_rows(draw, 6, dimension + closed, 1)
            zeros = [tuple(int(j == k) for k in range(dimension + closed)) for j in range(closed)]
            twice = zeros + [tuple(map(sum, zip(*zeros)))]
            expected = naive_faces([row[closed:] for row in rows], dimension) + [0] * closed
            self.assertEqual(counted(rows, dimension + closed, twice), expected, rows)

    def test_general_position(self):
        draw = random.Random(3)
        for dimension, n in ((2, 9), (3, 8), (4, 9), (6, 12)):
            rows = random_rows(draw, n, dimension, 10 ** 6)
            cells = [2 * sum(math.comb(n - k - 1, j) for j in range(dimension - k)) for k in range(dimension)]
            self.assertEqual(counted(rows, dimension),
                             [1] + [math.comb(n, k) * cells[k] for k in reversed(range(dimension))])

    def test_contacts(self):
        """Two lines of each: the numbers of docs/enumerate.md, which a closed form gives."""
        draw = random.Random(4)
        for contacts, states in ((4, 4513), (6, 54257)):
            rows = []
            for _ in range(contacts):
                p = [Fraction(draw.randint(-1000, 1000)) for _ in range(3)]
                n = [draw.randint(-1000, 1000) for _ in range(3)]
                u = [draw.randint(-1000, 1000) for _ in range(3)]
                for v in (check.cross(n, u), check.cross(n, check.cross(n, u))):
                    rows.append(check.integers(check.at(p, [Fraction(x) for x in v]))[0])
            self.assertEqual(sum(counted(rows, 6)), states)

    def test_six_dependent_rows(self):
        """A row that is the sum of five others."""
        draw = random.Random(5)
        rows = random_rows(draw, 8, 6, 1000)
        found = counted(rows[:7] + [tuple(map(sum, zip(*rows[:5])))], 6)
        self.assertEqual(found, naive_faces(rows[:7] + [tuple(map(sum, zip(*rows[:5])))], 6))
        self.assertLess(sum(found), sum(counted(rows, 6)))

    def test_more_flats_than_states_end_the_count(self):
        rows = random_rows(random.Random(6), 200, 6, 1000)
        with self.assertRaises(check.Rejected) as caught:
            counted(rows, 6, most=1000)
        self.assertEqual(caught.exception.rule, "state-complete")


class SignsTest(unittest.TestCase):
    def test_all_at_once_as_one_by_one(self):
        draw = random.Random(7)
        for _ in range(300):
            dimension, digits = draw.randint(1, 6), draw.choice((1, 2, 31, 62, 300))
            rows = random_rows(draw, draw.randint(1, 6), dimension, 2 ** draw.choice((1, 8, digits)))
            motion = [draw.randint(-2 ** digits, 2 ** digits) * draw.randint(0, 1) for _ in range(dimension)]
            signs = ["+" if x > 0 else "-" if x < 0 else "0" for x in (check.dot(row, motion) for row in rows)]
            proof = check.StatesProof([], [" ".join(signs) + " : " + " ".join(map(str, motion))], [])
            first = next((sign for sign in signs if sign != "0"), "0")
            if first != "-":
                self.assertEqual(check.check_listed(rows, [1] * len(rows), proof), 1 if first == "0" else 2)
            for i, other in itertools.product(range(len(rows)), "+-0"):
                if signs[i] != other:
                    wrong = " ".join(signs[:i] + [other] + signs[i + 1:]) + " : " + " ".join(map(str, motion))
                    with self.assertRaises(check.Rejected) as caught:
                        check.check_listed(rows, [1] * len(rows), proof._replace(states=[wrong]))
                    self.assertEqual(caught.exception.rule, "state-sign")


if __name__ == "__main__":
    unittest.main()
