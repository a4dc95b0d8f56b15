# SPDX-License-Identifier: GPL-3.0-or-later
"""A question in space in nonlinear real arithmetic (SMT-LIB 2), written from the model alone."""

from fractions import Fraction as F
from math import isqrt


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def number(value):
    value = F(value)
    text = f"(/ {abs(value.numerator)} {value.denominator})"
    return f"(- {text})" if value < 0 else text


def linear(factors, names):
    return "(+ 0 " + " ".join(f"(* {number(c)} {name})" for c, name in zip(factors, names)) + ")"


def smt(contacts, wrench):
    """Contacts (p, n, friction, stiffness, preload), with |n| rational; `sat` means stable."""
    lines = ["(set-logic QF_NRA)"]

    def declare(*names):
        lines.extend(f"(declare-const {name} Real)" for name in names)

    def claim(text):
        lines.append(f"(assert {text})")

    d = [f"d{j}" for j in range(6)]
    declare(*d)
    sums = [[number(w)] for w in wrench]
    for i, (p, n, mu, stiffness, preload) in enumerate(contacts):
        square = sum(x * x for x in n)
        length = F(isqrt(square.numerator), isqrt(square.denominator))
        assert length * length == square
        row = [*n, *cross(p, n)]
        a, t = f"a{i}", f"t{i}"  # t is |s|
        f, s = ([f"{letter}{i}{j}" for j in range(3)] for letter in "fs")
        declare(a, t, *f, *s)
        v = f"(- {number(preload / length)} (* {number(stiffness / square)} {linear(row, d)}))"
        claim(f"(= {a} (ite (> {v} 0) {v} 0))")
        for j, k, l in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            moved = linear([1, p[l], -p[k]], [d[j], d[3 + k], d[3 + l]])  # u + omega x p
            claim(f"(= {s[j]} (- {moved} (* {number(n[j] / square)} {linear(row, d)})))")
            claim(f"(= (* {t} {f[j]}) (- (* {number(mu * length)} {a} {s[j]})))")
            sums[j] += [f"(* {number(n[j])} {a})", f[j]]
            sums[3 + j] += [f"(* {number(row[3 + j])} {a})",
                            f"(- (* {number(p[k])} {f[l]}) (* {number(p[l])} {f[k]}))"]
        claim(f"(and (>= {t} 0) (= (* {t} {t}) (+ {' '.join(f'(* {x} {x})' for x in s)})))")
        claim(f"(= 0 {linear(n, f)})")
        claim(f"(<= (+ {' '.join(f'(* {x} {x})' for x in f)}) (* {number(mu * mu * square)} {a} {a}))")
    for parts in sums:
        claim(f"(= 0 (+ {' '.join(parts)}))")
    return "\n".join([*lines, "(check-sat)"])
