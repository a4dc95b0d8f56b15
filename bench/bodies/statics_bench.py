# SPDX-License-Identifier: GPL-3.0-or-later
"""Statics of many bodies: how long `stickslip statics` takes for the class, with its certificate, and for the least friction, and
how long stickslip-check takes to agree.

    bench/bodies/statics_bench.py [--save FOLDER] [ASSEMBLY ...]

Assemblies: wall144, wall400, wall1000 (bricks in running bond, each pushed sideways by a tenth of its weight), arch60, arch200 (half
a circle), boxes100 (in space, in four layers that lie across joints, pushed by a tenth). Positions have all digits of doubles, and
weights differ."""

import argparse
import json
import math
import os
import random
import subprocess
import tempfile
import time

BIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin")


def file_of(bodies, contacts, loads, friction):
    return {"format": "stickslip-grasp/3", "bodies": [{"name": name} for name in bodies], "defaults": {"friction": friction},
            "contacts": contacts, "loads": loads}


def brick(name, at, weight, push):
    force = [push * weight, *[0] * (len(at) - 2), -weight]
    return {"body": name, "force": force, "at": at}


def wall(courses, columns, rng):
    """Bricks of about 2 by 1; every joint is a little off."""
    width, height = 2 * rng.uniform(.99, 1.01), rng.uniform(.99, 1.01)
    contacts, loads, rows = [], [], []
    for c in range(courses):
        row = []
        for k in range(columns):
            left = width * (k + (c % 2) / 2)
            row.append((f"b{c}.{k}", left, left + width))
            if k:
                contacts += [{"of": row[k][0], "by": row[k - 1][0], "position": [left, y], "normal": [1, 0]}
                             for y in (height * c, height * (c + 1))]
            loads.append(brick(row[k][0], [left + width / 2, height * (c + .5)], rng.uniform(.9, 1.1), .1))
            below = rows[-1] if rows else [("ground", -math.inf, math.inf)]
            for name, a, b in below:
                low, high = max(left, a), min(left + width, b)
                if low < high:
                    contacts += [{"of": row[k][0], **({} if name == "ground" else {"by": name}), "position": [x, height * c],
                                  "normal": [0, 1]} for x in (low, high)]
        rows.append(row)
    return file_of([name for row in rows for name, _, _ in row], contacts, loads, 0.7)


def arch(stones, rng):
    """Half a circle of radius 10 and thickness 2."""
    ends = [0, *sorted(math.pi * (k + rng.uniform(-.1, .1)) / stones for k in range(1, stones)), math.pi]
    contacts, loads = [], []

    def at(radius, angle):
        return [-radius * math.cos(angle), radius * math.sin(angle)]

    for k in range(stones + 1):
        along = [math.sin(ends[k]), math.cos(ends[k])]
        of, side = (f"s{k}", 1) if k < stones else (f"s{k - 1}", -1)
        by = {"by": f"s{k - 1}"} if 0 < k < stones else {}
        contacts += [{"of": of, **by, "position": at(radius, ends[k]), "normal": [side * x for x in along]} for radius in (9, 11)]
        if k < stones:
            loads.append({"body": f"s{k}", "weight": ends[k + 1] - ends[k], "at": at(10, (ends[k] + ends[k + 1]) / 2)})
    return file_of([f"s{k}" for k in range(stones)], contacts, loads, 0.7)


def boxes(side, layers, rng):
    places, contacts, loads = {}, [], []
    for z in range(layers):
        for x in range(side):
            for y in range(side):
                off = .5 * (z % 2)
                places[f"b{x}.{y}.{z}"] = (x + off, y + off, z)
    for name, (x, y, z) in places.items():
        below = [(other, place) for other, place in places.items() if place[2] == z - 1] if z else [(None, (x, y, -1))]
        for other, (a, b, _) in below:
            xs, ys = (max(x, a), min(x, a) + 1), (max(y, b), min(y, b) + 1)
            if xs[0] < xs[1] and ys[0] < ys[1]:
                contacts += [{"of": name, **({"by": other} if other else {}), "position": [u, v, z], "normal": [0, 0, 1]}
                             for u in xs for v in ys]
        loads.append(brick(name, [x + .5, y + .5, z + .5], rng.uniform(.9, 1.1), .1))
    return file_of(list(places), contacts, loads, 0.5)


ASSEMBLIES = {"wall144": lambda rng: wall(12, 12, rng), "wall400": lambda rng: wall(20, 20, rng),
              "wall1000": lambda rng: wall(25, 40, rng), "arch60": lambda rng: arch(60, rng), "arch200": lambda rng: arch(200, rng),
              "boxes100": lambda rng: boxes(5, 4, rng)}


def timed(*words):
    begin = time.time()
    run = subprocess.run(words, capture_output=True, text=True, check=True)
    return time.time() - begin, run.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--save", metavar="FOLDER", help="keep the grasp files and certificates there")
    parser.add_argument("assemblies", nargs="*", metavar="ASSEMBLY")
    asked = parser.parse_args()
    program, checker = (os.path.join(BIN, name) for name in ("stickslip", "stickslip-check"))
    print("| assembly | bodies | contacts | class | s | kB of proof | s to check | least friction, times 0.7 or 0.5 | s |\n"
          "|---|--:|--:|---|--:|--:|--:|---|--:|")
    with tempfile.TemporaryDirectory() as folder:
        folder = asked.save or folder
        os.makedirs(folder, exist_ok=True)
        for name in asked.assemblies or ASSEMBLIES:
            grasp = ASSEMBLIES[name](random.Random(1))
            file, proof = os.path.join(folder, name + ".json"), os.path.join(folder, name + ".certificate.json")
            with open(file, "w", encoding="utf-8") as out:
                json.dump(grasp, out)
            seconds, said = timed(program, "statics", file, "--certificate", proof)
            kind = "may stand" if "May stand" in said else "must move" if "Must move" in said else "undecided"
            checked = timed(checker, file, proof, "--statics", "1")[0] if kind != "undecided" else math.nan
            wait, said = timed(program, "statics", file, "--least-friction", "--json", "--floats")
            least = json.loads(said)["least_friction"]
            ends = f"{least['low_float']:.7f} to {least['high_float']:.7f}" if least else "none"
            size = os.path.getsize(proof) / 1000 if os.path.exists(proof) else 0
            print(f"| {name} | {len(grasp['bodies'])} | {len(grasp['contacts'])} | {kind} | {seconds:.2f} | {size:.0f} | "
                  f"{checked:.2f} | {ends} | {wait:.1f} |", flush=True)


if __name__ == "__main__":
    main()
