# SPDX-License-Identifier: GPL-3.0-or-later
"""What page.html plays of a run: shapes, and by sample the body's place and the forces on it. What
is in space is seen from a corner, with the body as its shadow and obstacles as tiles about their
contacts."""

from __future__ import annotations

import json
from typing import Dict, List

import solid
from judge import Judged, turned
from run import in_doubles
from scene import cross, plus

TILE = 1.2  # half the width


def seen(v: List[float]) -> List[float]:
    x, y, z = v
    return [0.85 * x + 0.5 * y, 0.3 * y - 0.25 * x + 0.9 * z]


def shadow(points: List[List[float]]) -> List[List[float]]:
    """The convex hull, counterclockwise."""
    chain: List[List[float]] = []
    ordered = sorted(points)
    for half in (ordered, ordered[::-1]):
        start = len(chain)
        for p in half:
            while len(chain) - start >= 2 and cross(plus(chain[-1], chain[-2], -1), plus(p, chain[-2], -1)) <= 0:
                chain.pop()
            chain.append(p)
        chain.pop()
    return chain


def tile(obstacle: Dict[str, object]) -> List[List[float]]:
    """About its point, on the face of its slab."""
    a, b, c = (obstacle["shape"][k] for k in (0, 2, 4))  # three corners of the face
    sides = [[(q - p) / (2 * solid.WIDTH) * TILE for p, q in zip(a, other)] for other in (b, c)]
    return [seen([p + i * s + j * t for p, s, t in zip(obstacle["point"], *sides)])
            for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def rounded(value):
    return [rounded(v) for v in value] if isinstance(value, list) else float(f"{value:.5g}")


def played(judged: Judged) -> str:
    case = json.loads(in_doubles(judged.case))
    if "vertices" in judged.case:
        place = lambda pose, v: seen([a + b for a, b in zip(pose[:3], turned(pose[3:], v))])
        data = {"bodies": [shadow([place(s["pose"], v) for v in case["vertices"]]) for s in judged.samples],
                "obstacles": [tile(o) for o in case["obstacles"]],
                "forces": [[seen(c[:3]) + seen(c[6:9]) for c in s["contacts"]] for s in judged.samples]}
    else:
        data = {"body": case["vertices"], "radius": case["radius"], "obstacles": [o["shape"] for o in case["obstacles"]],
                "poses": [s["pose"] for s in judged.samples],
                "forces": [[c[:2] + c[4:6] for c in s["contacts"]] for s in judged.samples]}
    return json.dumps({**{k: rounded(v) for k, v in data.items()}, "moved": rounded(judged.moved)},
                      separators=(",", ":"))
