#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the cases: scenes at random, loads at 10, 3 and 1 % from the exact border of what must
hold or must move, and of these only the ones that neither a little friction nor a small move of
the contacts changes.

    generate.py FOLDER [SCENES_PER_FAMILY_IN_THE_PLANE [IN_SPACE]]
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from math import floor
from pathlib import Path
from random import Random
from typing import Dict, List, Optional, Tuple

import families
import scene as flat
import solid
import solid_families
from families import Scene
from scene import Contact, spelled
from truth import load_class, work

F = Fraction
FAMILIES = {**families.FAMILIES, **solid_families.FAMILIES}
GAPS = (10, 3, 1)  # percent
FINE = F(1, 2**20)
FRICTION_MARGIN = F(5, 1000)
MOVED = F(2, 1000)  # of the size


def place_of(scene: Scene):
    """The module that knows its contacts."""
    return solid if isinstance(scene.body, solid.Body) else flat


def load(scene: Scene, multiple: Fraction):
    return tuple(s + multiple * d for s, d in zip(scene.settle, scene.direction))


def asked(scene: Scene, touching: List[Contact], wrench):
    where = place_of(scene)
    return load_class(where.grasp_file("", scene.body, touching, wrench), where.inertia(scene.body))


def borders(scene: Scene, touching: List[Contact]) -> Optional[Tuple[Fraction, Optional[Fraction]]]:
    """The largest multiple up to which it must hold, and the least from which it must move.

    The second is exact: a motion that nothing opposes is opposed below the multiple at which the
    load does no work along it, and so on down; in space, where there is no last such motion, to
    FINE. The first is the same where nothing is open between, and found by bisection otherwise."""
    if asked(scene, touching, scene.settle)[0] != "must hold":
        return None
    multiple, move = F(1), None
    while move is None and multiple <= 64:
        while True:
            kind, motion = asked(scene, touching, load(scene, multiple))
            if kind != "must move":
                break
            slope = work(motion, scene.direction)
            if slope <= 0:
                return None
            below = -work(motion, scene.settle) / slope
            if len(motion) > 3:
                below = F(floor(below / FINE)) * FINE
            if below >= multiple:
                break
            multiple = move = below
        multiple *= 2
    if move is None or move <= 0:
        return None
    low, high = F(0), move
    just_below = move * (1 - 2 * FINE)
    if asked(scene, touching, load(scene, just_below))[0] == "must hold":
        return move, move
    while high - low > move / 2**12:
        middle = (low + high) / 2
        if asked(scene, touching, load(scene, middle))[0] == "must hold":
            low = middle
        else:
            high = middle
    return low, move


def is_firm(scene: Scene, touching: List[Contact], wrench, kind: str) -> bool:
    """Whether nobody can blame a little friction, or where exactly the contacts are."""
    where = place_of(scene)
    far = F(where.size(scene.body)).limit_denominator(64) * MOVED
    changed = [[c._replace(friction=c.friction * factor) for c in touching]
               for factor in (1 - FRICTION_MARGIN, 1 + FRICTION_MARGIN)]
    for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        changed.append([where.moved(c, far * signs[(i + 1) % 2], far * signs[i % 2]) for i, c in enumerate(touching)])
    return all(asked(scene, t, wrench)[0] == kind for t in changed)


def holds_on_the_way(scene: Scene, touching: List[Contact], multiple: Fraction) -> bool:
    return all(asked(scene, touching, load(scene, multiple * F(k, 4)))[0] == "must hold" for k in (1, 2, 3))


def cases_of(family: str, number: int, dropped: Counter) -> List[Dict[str, object]]:
    scene = FAMILIES[family](Random(f"{family} {number}"))
    where = place_of(scene)
    touching = where.contacts(scene.body, scene.obstacles)
    if len(touching) < len(scene.obstacles):
        dropped["an obstacle does not touch"] += 1
        return []
    found = borders(scene, touching)
    if found is None:
        dropped["it need not hold at first, or nothing moves it"] += 1
        return []
    hold, move = found
    cases = []
    for kind, border, sign in (("must hold", hold, -1), ("must move", move, 1)):
        for gap in GAPS:
            multiple = F(round(border * (1 + F(sign * gap, 100)) * 10**6), 10**6)
            wrench = load(scene, multiple)
            if border < F(1, 20) or asked(scene, touching, wrench)[0] != kind:
                dropped["the border is at no load, or open"] += 1
            elif kind == "must hold" and not holds_on_the_way(scene, touching, multiple):
                dropped["it need not hold on the way to the load"] += 1
            elif not is_firm(scene, touching, wrench, kind):
                dropped[f"friction or contacts decide at {gap} %"] += 1
            else:
                name = f"{family}-{number}-{'hold' if sign < 0 else 'move'}-{gap}"
                cases.append({
                    "class": kind, "gap": gap, "border": spelled(border), **where.written(scene),
                    "grasp": where.grasp_file(name, scene.body, touching, wrench)})
    return cases


def make(kinds: Dict[str, object], folder: Path, scenes: int) -> None:
    dropped: Counter = Counter()
    total = kept = 0
    folder.mkdir(parents=True, exist_ok=True)
    for family in kinds if scenes else ():
        # The program that is asked runs beside; threads wait for it.
        with ThreadPoolExecutor(2) as pool, open(folder / f"{family}.jsonl", "w", encoding="utf-8") as out:
            written = 0
            for found in pool.map(lambda n: cases_of(family, n, dropped), range(scenes)):
                written += len(found)
                kept += bool(found)
                for case in found:
                    out.write(json.dumps(case) + "\n")
        print(f"{family:18} {written:4} cases", flush=True)
        total += written
    print(f"{total} cases of {kept} scenes, of {scenes * len(kinds)} that were made")
    for why, count in sorted(dropped.items()):
        print(f"{count:5} dropped: {why}")


if __name__ == "__main__":
    make(families.FAMILIES, Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 32)
    make(solid_families.FAMILIES, Path(sys.argv[1]) / "space", int(sys.argv[3]) if len(sys.argv) > 3 else 5)
