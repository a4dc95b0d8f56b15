# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges the contact forces that an engine in space reports, as forces.py does in the plane.

Doubles are exact numbers, and whether a force is in its cone has no tolerance: with the force f
and a normal n of any length, f.n >= 0 and |f|^2 |n|^2 - (f.n)^2 <= (mu f.n)^2."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Dict, List, Optional

from forces import Found, at_rest, chosen
from judge import Judged
from scene import read
from solid import cross, dot


def outside(force, normal, friction: Fraction) -> float:
    """How far the force is outside the cone, across the normal; 0 exactly if it is within."""
    along, square = dot(force, normal), dot(normal, normal)
    across = dot(force, force) * square - along * along
    if along >= 0 and across <= (friction * along) ** 2:
        return 0.0
    if along < 0:
        return math.sqrt(dot(force, force))
    return float(across - (friction * along) ** 2) / math.sqrt(square) / (math.sqrt(across) + float(friction * along))


def judged_forces(judged: Judged, sample: Dict[str, object], known: bool) -> Optional[Found]:
    exact = [[Fraction(v) for v in c] for c in sample["contacts"] if any(c[6:9])]
    if not exact:
        return None
    largest = max(math.hypot(*map(float, c[6:9])) for c in exact)
    cone = max(outside(c[6:9], c[3:6], c[9]) for c in exact) / largest
    if not known or not at_rest(judged):
        return Found(judged, sample, cone, None, None)
    place = [Fraction(v) for v in sample["pose"][:3]]
    total = [read(v) for v in judged.case["grasp"]["wrench"]]
    for c in exact:
        arm = [a - b for a, b in zip(c[:3], place)]
        total = [t + f for t, f in zip(total, [*c[6:9], *cross(arm, c[6:9])])]
    length = max(math.dist(map(float, c[:3]), map(float, place)) for c in exact)
    return Found(judged, sample, cone, max(max(map(abs, map(float, total[:3]))) / largest,
                                           max(map(abs, map(float, total[3:]))) / (largest * length)), None)


def judge_solid_forces(of: List[Judged], known: bool = True) -> List[Found]:
    """`known`: whether the engine says in which direction friction acts, without which nothing is said of balance."""
    return [f for f in (judged_forces(j, chosen(j), known) for j in of) if f]
