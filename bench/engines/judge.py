#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges results: of motion, whether what must hold held and what must move moved.

    judge.py RESULTS
"""

from __future__ import annotations

import json
import math
import sys
from collections import Counter, defaultdict
from pathlib import Path
from statistics import median
from typing import Dict, List, NamedTuple, Tuple

import scene
import solid
from engines import ENGINES, HERE, SOLID_ENGINES, SOUND, Engine
from run import read_cases, result_file
from scene import size

HELD = 1e-4  # of the size of the body
MOVED = 1e-2


class Judged(NamedTuple):
    case: Dict[str, object]
    moved: List[float]  # of the size, at each sample
    samples: List[Dict[str, object]]

    @property
    def most(self) -> float:
        return max(self.moved)

    @property
    def verdict(self) -> str:
        if self.case["class"] == "must hold":
            return "right" if self.most <= HELD else "creeps" if self.most <= MOVED else "false slip"
        return "false hold" if self.most <= HELD else "stops" if self.most <= MOVED else "right"


def turned(q: List[float], v: List[float]) -> List[float]:
    """By the unit quaternion x, y, z, w."""
    t = [2 * c for c in solid.cross(q[:3], v)]
    return [c + q[3] * s + r for c, s, r in zip(v, t, solid.cross(q[:3], t))]


def displacement(body, start: List[float], pose: List[float]) -> float:
    """The farthest that a point of the body went, over the size of the body."""
    if not all(map(math.isfinite, pose)):
        return math.inf
    if len(pose) == 7:
        corners = [[float(c) for c in v] for v in body.vertices]
        place = lambda p, v: [a + b for a, b in zip(p[:3], turned(p[3:], v))]
        return max(math.dist(place(start, v), place(pose, v)) for v in corners) / solid.size(body)
    turn = pose[2] - start[2]
    if not body.vertices:
        return (math.dist(start[:2], pose[:2]) + abs(turn) * float(body.radius)) / size(body)
    def at(p: List[float], v) -> List[float]:
        c, s = math.cos(p[2]), math.sin(p[2])
        return [p[0] + c * v[0] - s * v[1], p[1] + s * v[0] + c * v[1]]
    vertices = [(float(x), float(y)) for x, y in body.vertices]
    return max(math.dist(at(start, v), at(pose, v)) for v in vertices) / size(body)


def judged(case: Dict[str, object], samples: List[Dict[str, object]]) -> Judged:
    body, _ = (solid if "vertices" in case else scene).scene_of(case)
    start = samples[0]["pose"]
    return Judged(case, [displacement(body, start, s["pose"]) for s in samples], samples)


def read_results(results: Path, engine: Engine, rate: int, cases: Dict[str, Dict[str, object]]) -> List[Judged]:
    with open(result_file(results, engine, rate), encoding="utf-8") as lines:
        # Chipmunk greets on standard output.
        read = (json.loads(line) for line in lines if line.startswith("{"))
        return [judged(cases[line["name"]], line["samples"]) for line in read if line["name"] in cases]


def count(of: List[Judged]) -> Dict[str, object]:
    table: Dict[str, Counter] = defaultdict(Counter)
    for j in of:
        table[j.verdict][j.case["gap"]] += 1
    held = [j.most for j in of if j.case["class"] == "must hold" and j.most <= MOVED]
    return {"by verdict": table, "creep": median(held) if held else math.nan}


def agreement(runs: List[List[Judged]]) -> Tuple[int, int]:
    """Of how many scenes, that have a case 1 % from the border on both sides, all runs move what must
    move, and nothing else: creep counts as held here."""
    scenes: Dict[str, List[Judged]] = defaultdict(list)
    for j in (j for of in runs for j in of if j.case["gap"] == 1):
        scenes[j.case["grasp"]["name"].rsplit("-", 2)[0]].append(j)
    both = [s for s in scenes.values() if len(s) == 2 * len(runs)]
    return sum(all(j.verdict in ("right", "creeps") for j in s) for s in both), len(both)


def table(results: Path, engines: List[Engine], folder: Path) -> Dict[int, List[List[Judged]]]:
    """Prints it, and returns what the engines of SOUND did, at their steps and ten times them."""
    cases = {c["grasp"]["name"]: c for c in read_cases(folder)}
    sound: Dict[int, List[List[Judged]]] = defaultdict(list)
    for engine in engines:
        for index, rate in enumerate(engine.rates):
            if not result_file(results, engine, rate).exists():
                continue
            of = read_results(results, engine, rate, cases)
            if engine.name in SOUND:
                sound[index].append(of)
            found = count(of)
            by = found["by verdict"]
            cells = "  ".join(f"{v} " + "/".join(str(by[v][g]) for g in (10, 3, 1))
                              for v in ("false hold", "stops", "false slip", "creeps"))
            print(f"{engine.name:24} {rate:5}  {cells}  creep {found['creep']:.1e}")
    return sound


def main(results: str) -> None:
    sound = table(Path(results), ENGINES, HERE / "cases")
    for index, runs in sound.items():
        agreed, of_all = agreement(runs)
        print(f"{len(runs)} of {', '.join(SOUND)} at {'ten times their' if index else 'their'} steps agree with the "
              f"border to 1 % in {agreed} of {of_all} scenes")
    print("In space:")
    table(Path(results) / "space", SOLID_ENGINES, HERE / "cases/space")


if __name__ == "__main__":
    main(*sys.argv[1:])
