#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cross-checks a floating-point solver: where is it right, and what does its tolerance decide?

`is_stable` is a solver as one might write it with NumPy: it tries every combination of contacts
that stick, slip either way, or have opened, solves the linear equations of each, and accepts
inequalities that fail by no more than a tolerance. Its verdicts are compared with the exact ones
of stickslip on random three-finger grasps, under random loads and under loads at thresholds.

    python3 examples/crosscheck_numpy.py [GRASPS]
"""

import sys
from fractions import Fraction
from itertools import product

import numpy as np
import stickslip

TOLERANCE = 1e-9
STICK, SLIP_PLUS, SLIP_MINUS, OPEN = range(4)


def is_stable(positions, normals, friction, stiffness, preload, wrench):
    """Passive stability, in doubles. Arrays of shapes (m, 2), (m, 2), (m,), (m,), (m,), (3,)."""
    m = len(positions)
    n = normals / np.linalg.norm(normals, axis=1)[:, None]
    t = np.stack([-n[:, 1], n[:, 0]], axis=1)
    cross = lambda p, v: p[:, 0] * v[:, 1] - p[:, 1] * v[:, 0]
    N = np.column_stack([n, cross(positions, n)])
    T = np.column_stack([t, cross(positions, t)])
    for modes in product(range(4), repeat=m):
        # Unknowns: the motion d, and the tangential force of each contact.
        A = np.zeros((3 + m, 3 + m))
        b = np.zeros(3 + m)
        b[:3] = -wrench
        for i, mode in enumerate(modes):
            A[:3, 3 + i] = T[i]
            if mode != OPEN:  # c_n = P - k N.d
                A[:3, :3] -= stiffness[i] * np.outer(N[i], N[i])
                b[:3] -= preload[i] * N[i]
            if mode == STICK:
                A[3 + i, :3] = T[i]
            else:  # c_t = -+ mu c_n, or 0
                A[3 + i, 3 + i] = 1
                if mode != OPEN:
                    sign = 1 if mode == SLIP_PLUS else -1
                    A[3 + i, :3] = -sign * friction[i] * stiffness[i] * N[i]
                    b[3 + i] = -sign * friction[i] * preload[i]
        x = np.linalg.lstsq(A, b, rcond=None)[0]
        d, tangential = x[:3], x[3:]
        normal = preload - stiffness * (N @ d)
        slip = T @ d
        conditions = [-np.abs(A @ x - b)]  # all must be >= 0
        for i, mode in enumerate(modes):
            if mode == OPEN:
                conditions.append([-normal[i]])
            else:
                conditions.append([normal[i], friction[i] * normal[i] - abs(tangential[i])])
            if mode in (SLIP_PLUS, SLIP_MINUS):
                conditions.append([slip[i] if mode == SLIP_PLUS else -slip[i]])
        if min(np.min(c) for c in conditions) >= -TOLERANCE:
            return True
    return False


def random_grasp(random):
    """Three contacts. Dyadic positions, and normals of rational length, so that preloads are
    exact."""
    triples = [(1, 0), (3, 4), (4, 3), (5, 12), (12, 5), (8, 15)]
    normals = np.array([triples[k] for k in random.integers(0, len(triples), 3)])
    return stickslip.Grasp(random.integers(-16, 17, (3, 2)) / 8,
                           normals * random.choice([-1, 1], (3, 2)),
                           random.integers(1, 5, 3) / 4,
                           stiffness=random.integers(1, 3, 3),
                           preload=random.integers(1, 4, 3))


def is_tie(grasp, wrench):
    """Whether the load is on a threshold: the least more, or less, of it changes the verdict."""
    return any(1 in interval for interval in stickslip.margin(grasp, wrench).resisted)


def compare(grasp, wrench):
    """"right", "wrong", or "tie" where rounding alone may lead to either."""
    if is_tie(grasp, wrench):
        return "tie"
    said = is_stable(*(np.array(values, float) for values in (
        grasp.positions, grasp.normals, grasp.friction, grasp.stiffness, grasp.preload, wrench)))
    exact = stickslip.decide(grasp, wrench).verdict == "stable"
    return "right" if said == exact else "wrong"


def main(grasps):
    random = np.random.default_rng(7)
    factors = {"1e-6 above a threshold": 1 + Fraction(1, 10**6),
               "1e-12 above a threshold": 1 + Fraction(1, 10**12),
               "exactly on a threshold": Fraction(1),
               "1e-12 below a threshold": 1 - Fraction(1, 10**12)}
    counts = {family: dict(right=0, wrong=0, tie=0) for family in ("random", *factors)}
    done = 0
    while done < grasps:
        grasp = random_grasp(random)
        load = [Fraction(int(c)) for c in random.integers(-9, 10, 3)]
        if not any(load):
            continue
        resisted = stickslip.margin(grasp, load).resisted
        if not resisted or not resisted[-1][1]:  # nothing, all, or 0 alone is resisted
            continue
        done += 1
        counts["random"][compare(grasp, load)] += 1
        for family, factor in factors.items():
            wrench = [resisted[-1][1] * factor * c for c in load]
            counts[family][compare(grasp, wrench)] += 1

    print(f"A NumPy solver with tolerance {TOLERANCE:g} against exact verdicts\n")
    print(f"{'loads':26}{'grasps':>8}{'right':>8}{'wrong':>8}{'tie':>8}")
    for family, count in counts.items():
        print(f"{family:26}{grasps:8}{count['right']:8}{count['wrong']:8}{count['tie']:8}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
