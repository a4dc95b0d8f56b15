# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies: how long `stickslip decide` takes, with default options and numbers of all digits, beside the multiple of a load
at which families of assemblies and grippers are lost; and how long stickslip-check takes to agree.

    bench/bodies/bodies_bench.py [--count N] [--save FOLDER] [FAMILY ...]

Families: stack2 to stack4, row2, row4, row8 (blocks squeezed between walls), arch3, arch5, arch7, grip2, grip4 (two fingers and a
tendon), box2, box3 (stacked in space), squeezed2 (in space), soft3, soft4 (soft fingers on a ball). For each it finds the multiple by bisection, to 1e-3, and decides 1 %
beyond it, 1 % below, and at four fifths of it."""

import argparse
import json
import math
import os
import random
import statistics
import subprocess
import tempfile
import time

BIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin")


def decide(grasp, *words):
    """The verdict, nodes, seconds, and seconds of the checker (0 without a proof)."""
    with tempfile.TemporaryDirectory() as folder:
        file, proof = os.path.join(folder, "g.json"), os.path.join(folder, "c.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump(grasp, out)
        begin = time.time()
        run = subprocess.run([os.path.join(BIN, "stickslip"), "decide", file, "--json", "--certificate", proof, *words],
                             capture_output=True, text=True, check=False)
        seconds = time.time() - begin
        answer = json.loads(run.stdout)
        checked = 0
        if os.path.exists(proof):
            begin = time.time()
            subprocess.run([os.path.join(BIN, "stickslip-check"), file, proof], capture_output=True, check=True)
            checked = time.time() - begin
        return answer["verdict"], answer["stats"]["nodes"], seconds, checked


def file_of(bodies, contacts, loads, **others):
    return {"format": "stickslip-grasp/3", "bodies": bodies, "contacts": contacts, "loads": loads, **others}


def names(n):
    return [{"name": f"b{k}"} for k in range(n)]


def stack(n, rng):
    widths, bottoms = [], [0]
    for _ in range(n):
        widths.append(rng.uniform(.6, 1) * (widths[-1] if widths else 1))
        bottoms.append(bottoms[-1] + rng.uniform(.3, 1))
    contacts = []
    for k in range(n):
        mu = rng.uniform(.3, .8)
        for side in (-1, 1):
            contacts.append({"of": f"b{k}", **({"by": f"b{k-1}"} if k else {}), "position": [side * widths[k], bottoms[k]],
                             "normal": [0, 1], "friction": mu, "stiffness": rng.uniform(.5, 2)})
    loads = [{"body": f"b{k}", "weight": rng.uniform(.5, 2), "at": [0, (bottoms[k] + bottoms[k + 1]) / 2]} for k in range(n)]
    push = {"body": f"b{n-1}", "at": [0, bottoms[-1]]}
    return lambda f: file_of(names(n), contacts, [*loads, {**push, "force": [f, 0]}])


def between(k, n, axis):
    """The bodies at face k of a row of n, and the normal."""
    if k == n:
        return {"of": f"b{n-1}", "normal": [-x for x in axis]}
    return {"of": f"b{k}", **({"by": f"b{k-1}"} if k else {}), "normal": axis}


def row(n, rng):
    mu, preload, height, faces = rng.uniform(.3, .8), rng.uniform(.5, 2), rng.uniform(.3, 1), [0]
    for _ in range(n):
        faces.append(faces[-1] + rng.uniform(.4, 1))
    contacts = [{"position": [faces[k], side * height], "friction": mu if k in (0, n) else mu * rng.uniform(1, 1.3),
                 "preload": preload, "stiffness": rng.uniform(.5, 2), **between(k, n, [1, 0])}
                for k in range(n + 1) for side in (-1, 1)]
    weights = [(rng.uniform(.5, 2), (faces[k] + faces[k + 1]) / 2) for k in range(n)]
    return lambda f: file_of(names(n), contacts, [{"body": f"b{k}", "weight": w * f, "at": [x, 0]}
                                                  for k, (w, x) in enumerate(weights)])


def arch(n, rng):
    thickness, mu, contacts = rng.uniform(.2, .35), rng.uniform(.6, .9), []
    middle = [[math.cos(a), math.sin(a)] for a in (math.pi * (1 - (k + .5) / n) for k in range(n))]
    for k in range(n + 1):
        a = math.pi * (1 - k / n)
        for radius in (1 - thickness / 2, 1 + thickness / 2):
            contacts.append({"position": [radius * math.cos(a), radius * math.sin(a)], "friction": mu,
                             "stiffness": rng.uniform(50, 200), **between(k, n, [math.sin(a), -math.cos(a)])})
    loads = [{"body": f"b{k}", "weight": 1, "at": p} for k, p in enumerate(middle)]
    return lambda f: file_of(names(n), contacts, [*loads, {"body": f"b{n//2}", "force": [f, 0], "at": middle[n // 2]}])


def gripper(joints, rng):
    mu, bodies, turns, over = rng.uniform(.3, .8), [{"name": "disc"}], [], {}
    for side, name in ((-1, "l"), (1, "r")):
        for k in range(joints // 2):
            link = name + str(k + 1)
            place = [2 * side * rng.uniform(.9, 1.1), -2] if k == 0 else [1.2 * side, 0]
            bodies.append({"name": link, "hinge": place, **({"on": name + "1"} if k else {})})
            turns.append({"turns": {link: side}, "stiffness": rng.uniform(.05, .3)})
            over[link] = side * rng.uniform(.7, 1.2) / (k + 1)
    last = str(joints // 2)
    contacts = [{"of": "disc", "by": by, "position": p, "normal": n, "friction": mu, "stiffness": rng.uniform(5, 20)}
                for by, p, n in (("l" + last, [-1, .5], [1, 0]), ("r" + last, [1, .5], [-1, 0]),
                                 ("l1", [-1, -.5], [2, 1]), ("r1", [1, -.5], [-2, 1]))]
    return lambda f: file_of(bodies, contacts, [{"body": "disc", "force": [.3 * f, .8 * f], "at": [.1, 0]}], joints=turns,
                             tendons=[{"over": over, "stiffness": 2, "tension": 2}])


def boxes(n, rng):
    mu, widths, bottoms, contacts = rng.uniform(.3, .8), [], [0], []
    for k in range(n):
        widths.append(rng.uniform(.6, 1) * (widths[-1] if widths else 1))
        bottoms.append(bottoms[-1] + rng.uniform(.3, 1))
        contacts += [{"position": [x * widths[k], y * widths[k] * .9, bottoms[k]], "friction": mu * rng.uniform(1, 1.3),
                      "stiffness": rng.uniform(.5, 2), "of": f"b{k}", "normal": [0, 0, 1], **({"by": f"b{k-1}"} if k else {})}
                     for x in (-1, 1) for y in (-1, 1)]
    way = rng.uniform(0, 2 * math.pi)
    loads = [{"body": f"b{k}", "weight": 1, "at": [0, 0, (bottoms[k] + bottoms[k + 1]) / 2]} for k in range(n)]
    return lambda f: file_of(names(n), contacts, [*loads, {"body": f"b{n-1}", "at": [0, 0, bottoms[-1]],
                                                           "force": [f * math.cos(way), f * math.sin(way), 0]}])


def squeezed(n, rng):
    mu, faces = rng.uniform(.3, .8), [0]
    for _ in range(n):
        faces.append(faces[-1] + rng.uniform(.4, 1))
    contacts = [{"position": [faces[k], .8 * y, .8 * z], "friction": mu * (1 if k in (0, n) else 1.2), "preload": 1,
                 "stiffness": rng.uniform(.5, 2), **between(k, n, [1, 0, 0])}
                for k in range(n + 1) for y in (-1, 1) for z in (-1, 1)]
    return lambda f: file_of(names(n), contacts, [{"body": f"b{k}", "weight": f * (1 + .3 * k),
                                                   "at": [(faces[k] + faces[k + 1]) / 2, .05, 0]} for k in range(n)])


def soft(n, rng):
    contacts = []
    for k in range(n):
        around, up = 2 * math.pi * (k + rng.uniform(-.1, .1)) / n, rng.uniform(-.1, .1)
        way = [math.cos(around) * math.cos(up), math.sin(around) * math.cos(up), math.sin(up)]
        contacts.append({"of": "b0", "position": way, "normal": [-x for x in way], "friction": rng.uniform(.15, .4),
                         "preload": rng.uniform(.5, 2), "stiffness": rng.uniform(.5, 2), "torsion": rng.uniform(.1, .4)})
    force, torque = ([rng.uniform(-.3, .3), rng.uniform(-.3, .3), rng.choice((-1, 1))] for _ in range(2))
    return lambda f: file_of(names(1), contacts, [{"body": "b0", "force": [f * x for x in force], "at": [0, 0, 0]},
                                                  {"body": "b0", "torque": [f * x / 2 for x in torque]}])


FAMILIES = {**{f"stack{n}": (stack, n) for n in (2, 3, 4)}, **{f"row{n}": (row, n) for n in (2, 4, 8)},
            **{f"arch{n}": (arch, n) for n in (3, 5, 7)}, "grip2": (gripper, 2), "grip4": (gripper, 4),
            "box2": (boxes, 2), "box3": (boxes, 3), "squeezed2": (squeezed, 2),
            "soft3": (soft, 3), "soft4": (soft, 4)}


def threshold(at):
    """
    The largest multiple that is stable, to a thousandth, and one above it: the next, if what is 1 % beyond it is unstable, and else
    the smallest that is.
    """
    def bisected(low, high, verdict):
        """Where what is below has the verdict, and what is above has not, or the other way round."""
        below = verdict == "stable"
        while high - low > 1e-3 * high:
            middle = (low + high) / 2
            has_it = decide(at(middle), "--node-limit", "1000")[0] == verdict
            low, high = (middle, high) if has_it == below else (low, middle)
        return low, high

    top = 1
    while decide(at(top))[0] != "unstable":
        top *= 2
        if top > 1e3:
            return None
    low, high = bisected(0, top, "stable")
    if decide(at(1.01 * high))[0] != "unstable":
        high = bisected(high, top, "unstable")[1]
    return low, high


def about_thresholds(name, count):
    """Assemblies of a family: how they were made, as in the table, and they."""
    make, size = FAMILIES[name]
    for seed in range(count):
        at = make(size, random.Random(seed))
        ends = threshold(at)
        if ends is None:
            continue
        for key, multiple in (("1 % beyond", ends[1] * 1.01), ("1 % below", ends[0] * .99), ("at 80 %", ends[0] * .8)):
            yield key, at(multiple)


def save(name, count, folder):
    os.makedirs(folder, exist_ok=True)
    for number, (key, grasp) in enumerate(about_thresholds(name, count)):
        kind = {"1 % beyond": "0.01u", "1 % below": "0.01s", "at 80 %": "0.2s"}[key]
        with open(os.path.join(folder, f"{name}_{number // 3}_{kind}.json"), "w", encoding="utf-8") as out:
            json.dump(grasp, out)


def measure(name, count):
    found = {}
    for key, grasp in about_thresholds(name, count):
        found.setdefault(key, []).append(decide(grasp))
    for key, answers in found.items():
        verdicts = ", ".join(f"{sum(a[0] == v for a in answers)} {v}" for v in sorted({a[0] for a in answers}))
        columns = [f"{statistics.median(a[k] for a in answers):.3g} / {max(a[k] for a in answers):.3g}" for k in (1, 2, 3)]
        print(f"| {name} | {key} | {verdicts} | {' | '.join(columns)} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=5)
    parser.add_argument("--save", metavar="FOLDER", help="write them there, for bench/space/polygonal_peer.py, and do no more")
    parser.add_argument("families", nargs="*", metavar="FAMILY")
    asked = parser.parse_args()
    if asked.save:
        for name in asked.families or FAMILIES:
            save(name, asked.count, asked.save)
        return
    print("| family | load | verdicts | nodes, median / most | s | s to check |\n|---|---|---|--:|--:|--:|")
    for name in asked.families or FAMILIES:
        measure(name, asked.count)


if __name__ == "__main__":
    main()
