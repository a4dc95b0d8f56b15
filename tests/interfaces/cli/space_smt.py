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


def rigid_smt(contacts, wrench, inertia, moves):
    """Contacts (p, n, friction) that are rigid; `sat` means that the body may stay at rest, or, with `moves`, that it may
    have an acceleration along which the load does work. `inertia` is the centre c and G of FORMAT.md, section 13."""
    lines = ["(set-logic QF_NRA)"]
    centre, (xx, yy, zz, xy, xz, yz) = inertia[:3], inertia[3:]
    a = [f"d{j}" for j in range(6)] if moves else [number(0)] * 6
    lines += [f"(declare-const {name} Real)" for name in a if moves]
    axes = [(1, 2), (2, 0), (0, 1)]
    push = [linear([1, centre[l], -centre[k]], [a[j], a[3 + k], a[3 + l]]) for j, (k, l) in enumerate(axes)]
    tensor = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    sums = [[number(w), f"(- {push[j]})"] for j, w in enumerate(wrench[:3])]
    sums += [[number(wrench[3 + j]), f"(- {linear(tensor[j], a[3:])})",
              f"(- (* {number(centre[l])} {push[k]}) (* {number(centre[k])} {push[l]}))"]
             for j, (k, l) in enumerate(axes)]
    if moves:
        lines.append(f"(assert (> {linear(wrench, a)} 0))")
    for i, (p, n, mu) in enumerate(contacts):
        square = sum(F(x) * x for x in n)
        row, force = [*n, *cross(p, n)], f"a{i}"
        f = [f"f{i}{j}" for j in range(3)]
        lines += [f"(declare-const {name} Real)" for name in (force, *f)]
        apart = linear(row, a)
        lines += [f"(assert (and (>= {force} 0) (>= {apart} 0) (or (= {force} 0) (= {apart} 0))))",
                  f"(assert (= 0 {linear(n, f)}))"]
        limit = f"(* {number(F(mu) ** 2 * square)} {force} {force})"
        lines.append(f"(assert (<= (+ {' '.join(f'(* {x} {x})' for x in f)}) {limit}))")
        if moves:
            s, rate = [f"s{i}{j}" for j in range(3)], f"r{i}"  # f = -r s, of the greatest length unless s = 0
            lines += [f"(declare-const {name} Real)" for name in (rate, *s)]
            for j, (k, l) in enumerate(axes):
                moved = linear([1, p[l], -p[k]], [a[j], a[3 + k], a[3 + l]])
                lines.append(f"(assert (= {s[j]} (- {moved} (* {number(n[j] / square)} {apart}))))")
            still = " ".join(f"(= {x} 0)" for x in s)
            against = " ".join(f"(= {f[j]} (- (* {rate} {s[j]})))" for j in range(3))
            full = f"(= (+ {' '.join(f'(* {x} {x})' for x in f)}) {limit})"
            lines.append(f"(assert (or (and {still}) (and (>= {rate} 0) {against} {full})))")
        for j, (k, l) in enumerate(axes):
            sums[j] += [f"(* {number(n[j])} {force})", f[j]]
            sums[3 + j] += [f"(* {number(row[3 + j])} {force})",
                            f"(- (* {number(p[k])} {f[l]}) (* {number(p[l])} {f[k]}))"]
    lines += [f"(assert (= 0 (+ {' '.join(parts)})))" for parts in sums]
    return "\n".join([*lines, "(check-sat)"])
