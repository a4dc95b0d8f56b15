# SPDX-License-Identifier: GPL-3.0-or-later
"""The least sum of preloads that hold loads in the plane, as linear arithmetic with an objective, written from the model alone."""

from fractions import Fraction as F
from math import isqrt

from space_smt import linear, number


def rows_of(p, n):
    """What a unit force along the normal, of rational length, and across it exerts."""
    square = n[0] * n[0] + n[1] * n[1]
    length = F(isqrt(square.numerator), isqrt(square.denominator))
    assert length * length == square
    n = [x / length for x in n]
    return [[*u, p[0] * u[1] - p[1] * u[0]] for u in (n, [-n[1], n[0]])]


def least_sum(contacts, wrenches, balanced=False):
    """Of contacts (p, n, friction, stiffness); `balanced` if friction is to balance the preloads without load and motion."""
    preloads = [f"P{i}" for i in range(len(contacts))]
    lines = [f"(declare-const {name} Real)(assert (>= {name} 0))" for name in preloads]
    for c, wrench in enumerate(wrenches):
        d = [f"d{c}{j}" for j in range(3)]
        lines += [f"(declare-const {name} Real)" for name in d]
        sums = [[number(w)] for w in wrench]
        for i, (p, n, mu, stiffness) in enumerate(contacts):
            rows = rows_of(p, n)
            a, b = f"a{c}_{i}", f"b{c}_{i}"
            away, slip = linear(rows[0], d), linear(rows[1], d)
            separation = f"(- {preloads[i]} (* {number(stiffness)} {away}))"
            lines.append(f"""(declare-const {a} Real)(declare-const {b} Real)
(assert (= {a} (ite (> {separation} 0) {separation} 0)))
(assert (and (<= {b} (* {number(mu)} {a})) (>= {b} (* {number(-mu)} {a}))))
(assert (=> (> {slip} 0) (= {b} (* {number(-mu)} {a}))))
(assert (=> (< {slip} 0) (= {b} (* {number(mu)} {a}))))""")
            for j in range(3):
                sums[j] += [f"(* {number(rows[0][j])} {a})", f"(* {number(rows[1][j])} {b})"]
        lines += [f"(assert (= 0 (+ {' '.join(parts)})))" for parts in sums]
    if balanced:
        sums = [[], [], []]
        for i, (p, n, mu, _) in enumerate(contacts):
            rows = rows_of(p, n)
            lines.append(f"""(declare-const t{i} Real)
(assert (and (<= t{i} (* {number(mu)} {preloads[i]})) (>= t{i} (* {number(-mu)} {preloads[i]}))))""")
            for j in range(3):
                sums[j] += [f"(* {number(rows[0][j])} {preloads[i]})", f"(* {number(rows[1][j])} t{i})"]
        lines += [f"(assert (= 0 (+ 0 {' '.join(parts)})))" for parts in sums]
    return "\n".join([*lines, f"(minimize (+ 0 {' '.join(preloads)}))", "(check-sat)", "(get-objectives)"])


def fraction(text):
    """Of what Z3 prints: 3.0, (/ 1 3), (- (/ 1.0 3.0))."""
    words = text.replace("(", " ").replace(")", " ").split()
    signs = -1 if "-" in words else 1
    numbers = [F(word) for word in words if word not in "-/"]
    return signs * (numbers[0] / numbers[1] if len(numbers) == 2 else numbers[0])
