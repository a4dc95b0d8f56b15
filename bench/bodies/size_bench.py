# SPDX-License-Identifier: GPL-3.0-or-later
"""More coordinates than are searched: what `stickslip decide` says beside the push at which statics lets an assembly go, and how long
it takes.

    bench/bodies/size_bench.py [--save FOLDER] [ASSEMBLY ...]

Assemblies: wall105 (bricks in running bond with halves at the ends, pushed at the top), shaken105 (the same, where every brick is
pushed by a part of its weight), arch31, arch60 and arch100 (half a circle; the keystone is pushed aside), stack34 (blocks), boxes10
(in space). Positions, weights and stiffnesses have all digits of doubles. `stickslip statics` finds the push by bisection, to 1e-3; `decide`
is asked 1 % beyond it, and at 99, 95, 90 and 80 % of it."""

import argparse
import json
import math
import os
import random
import subprocess
import tempfile
import time

from bodies_bench import BIN, boxes, file_of, stack
from statics_bench import arch as arch_of

PARTS = (1.01, .99, .95, .9, .8)


def wall(courses, columns, everywhere, rng):
    """Bricks of about 2 by 1."""
    contacts, weights, rows = [], [], []
    for c in range(courses):
        inner = range(1, columns) if c % 2 == 0 else [k + .5 for k in range(columns)]
        cuts = [0, *(2 * k + rng.uniform(-.05, .05) for k in inner), 2 * columns]
        row = [(f"b{c}.{k}", left, right) for k, (left, right) in enumerate(zip(cuts, cuts[1:]))]
        for (one, _, _), (name, left, _) in zip(row, row[1:]):
            contacts += [{"of": name, "by": one, "position": [left, y], "normal": [1, 0]} for y in (c, c + 1)]
        for name, left, right in row:
            weights.append((name, (right - left) * rng.uniform(.9, 1.1), [(left + right) / 2, c + .5]))
            for below, a, b in rows[-1] if rows else [(None, -math.inf, math.inf)]:
                low, high = max(left, a), min(right, b)
                if low < high:
                    contacts += [{"of": name, **({"by": below} if below else {}), "position": [x, c], "normal": [0, 1]}
                                 for x in (low, high)]
        rows.append(row)
    for contact in contacts:
        contact.update(friction=.7, stiffness=rng.uniform(.5, 2))
    top = {"body": rows[-1][0][0], "at": [0, courses - .5]}

    def at(push):
        loads = [{"body": name, "force": [push * w if everywhere else 0, -w], "at": place} for name, w, place in weights]
        if not everywhere:
            loads.append({**top, "force": [push, 0]})
        return file_of([{"name": name} for row in rows for name, _, _ in row], contacts, loads)
    return at


def arch(stones, rng):
    grasp = arch_of(stones, rng)
    for contact in grasp["contacts"]:
        contact["stiffness"] = rng.uniform(50, 200)
    key = grasp["loads"][stones // 2]
    return lambda push: {**grasp, "loads": [*grasp["loads"], {"body": key["body"], "force": [push, 0], "at": key["at"]}]}


ASSEMBLIES = {"wall105": lambda rng: wall(10, 10, False, rng), "shaken105": lambda rng: wall(10, 10, True, rng),
              **{f"arch{n}": lambda rng, n=n: arch(n, rng) for n in (31, 60, 100)},
              "stack34": lambda rng: stack(34, rng), "boxes10": lambda rng: boxes(10, rng)}


def asked(command, grasp, file):
    """The verdict or class, and seconds."""
    with open(file, "w", encoding="utf-8") as out:
        json.dump(grasp, out)
    begin = time.time()
    run = subprocess.run([os.path.join(BIN, "stickslip"), command, file, "--json"], capture_output=True, text=True, check=False)
    answer = json.loads(run.stdout)
    return answer["verdict" if command == "decide" else "class"], time.time() - begin


def most_that_may_stand(at, file):
    low, high = 0, 1
    while asked("statics", at(high), file)[0] != "must move":
        low, high = high, 2 * high
    while high - low > 1e-3 * high:
        middle = (low + high) / 2
        low, high = (low, middle) if asked("statics", at(middle), file)[0] == "must move" else (middle, high)
    return low


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--save", metavar="FOLDER", help="keep the grasp files there")
    parser.add_argument("assemblies", nargs="*", metavar="ASSEMBLY")
    words = parser.parse_args()
    print("| assembly | D | contacts | push | " + " | ".join(f"at {100 * part:.0f} %" for part in PARTS) + " |\n"
          "|---|--:|--:|--:|" + "---|" * len(PARTS))
    with tempfile.TemporaryDirectory() as folder:
        folder = words.save or folder
        os.makedirs(folder, exist_ok=True)
        for name in words.assemblies or ASSEMBLIES:
            at = ASSEMBLIES[name](random.Random(1))
            push = most_that_may_stand(at, os.path.join(folder, "search.json"))
            grasp, cells = at(push), []
            for part in PARTS:
                verdict, seconds = asked("decide", at(part * push), os.path.join(folder, f"{name}_{part}.json"))
                cells.append(f"{verdict}, {seconds:.2g} s")
            size = (6 if len(grasp["contacts"][0]["position"]) == 3 else 3) * len(grasp["bodies"])
            print(f"| {name} | {size} | {len(grasp['contacts'])} | {push:.5g} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
