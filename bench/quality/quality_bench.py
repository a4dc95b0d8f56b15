# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the two radii of `stickslip quality` are, and how long they take, with default options and numbers of all digits; and
whether the load that is not resisted, and loads of the proved ball, have the verdicts that it says.

    bench/quality/quality_bench.py [--count N] [--samples S] [--only M] [FAMILY ...]

Families: plane (3 to 10 fingers about an ellipse, preloaded, unequal), stands (feet on the ground and one wall, by their weight
alone), space (4 to 6 fingers about an ellipsoid, preloaded), table (4 to 6 feet and one wall, in space, by weight alone), grip
(a disc between two fingers of two links each). S loads of each proved ball are decided one by one."""

import argparse
import json
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time

BIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin")


def unit(v):
    size = math.sqrt(sum(x * x for x in v))
    return [x / size for x in v]


def fingers(count, dimension, rng):
    axes = [rng.uniform(.6, 1.4) for _ in range(dimension)]
    contacts = []
    for k in range(count):
        if dimension == 2:
            angle = 2 * math.pi * (k + rng.uniform(-.3, .3)) / count
            way = [math.cos(angle), math.sin(angle)]
        else:
            way = unit([rng.gauss(0, 1) for _ in range(3)])
        contacts.append({"position": [a * x for a, x in zip(axes, way)], "normal": unit([-x / a for a, x in zip(axes, way)]),
                         "friction": rng.uniform(.3, .9), "stiffness": rng.uniform(.5, 2), "preload": rng.uniform(.5, 2)})
    return contacts


def plane(rng):
    return {"format": "stickslip-grasp/2", "contacts": fingers(rng.randint(3, 10), 2, rng), "wrench": [0, 0, 0]}, 1


def space(rng):
    return {"format": "stickslip-grasp/2", "contacts": fingers(rng.randint(4, 6), 3, rng), "wrench": [0] * 6}, 1


def foot(position, normal, rng):
    return {"position": position, "normal": normal, "friction": rng.uniform(.3, .8), "stiffness": rng.uniform(.5, 2)}


def stands(rng):
    contacts = [foot([x + rng.uniform(-.2, .2), rng.uniform(-.1, .1)], [0, 1], rng) for x in (-1, 1)]
    contacts.append(foot([-1.2, rng.uniform(.5, 1)], [1, 0], rng))
    return {"format": "stickslip-grasp/2", "contacts": contacts,
            "loads": [{"weight": rng.uniform(1, 3), "at": [rng.uniform(-.3, .3), .6]}, {"force": [-.2, 0], "at": [0, .6]}]}, 1


def table(rng):
    count = rng.randint(3, 5)
    contacts = []
    for k in range(count):
        angle = 2 * math.pi * (k + rng.uniform(-.2, .2)) / count
        contacts.append(foot([math.cos(angle), math.sin(angle), 0], [0, 0, 1], rng))
    contacts.append(foot([-1, rng.uniform(-.2, .2), .5], [1, 0, 0], rng))
    return {"format": "stickslip-grasp/2", "contacts": contacts,
            "loads": [{"weight": rng.uniform(1, 3), "at": [0, 0, .6]}, {"force": [-.2, 0, 0], "at": [0, 0, .6]}]}, 1


def grip(rng):
    """Two fingers of two links, whose tendons press a disc."""
    bodies = [{"name": "disc"}]
    joints, contacts, tendons = [], [], []
    for side, name in ((-1, "left"), (1, "right")):
        base, knee = [2 * side, -1], [1.6 * side + rng.uniform(-.1, .1), .2]
        bodies += [{"name": f"{name}1", "hinge": base}, {"name": f"{name}2", "hinge": knee, "on": f"{name}1"}]
        joints += [{"name": f"j{name}{k}", "turns": {f"{name}{k}": 1}, "stiffness": rng.uniform(2, 4)} for k in (1, 2)]
        angle = rng.uniform(-.2, .2)
        contacts.append({"of": "disc", "by": f"{name}2", "position": [side * math.cos(angle), math.sin(angle)],
                         "normal": [-side * math.cos(angle), -math.sin(angle)], "friction": rng.uniform(.5, .9),
                         "stiffness": rng.uniform(20, 40)})
        tendons.append({"over": {f"{name}1": side * .3, f"{name}2": side * .2}, "tension": -rng.uniform(2, 4)})
    return {"format": "stickslip-grasp/3", "bodies": bodies, "joints": joints, "tendons": tendons, "contacts": contacts}, "disc"


FAMILIES = {"plane": plane, "stands": stands, "space": space, "table": table, "grip": grip}


def run(*words):
    return subprocess.run([os.path.join(BIN, words[0]), *words[1:]], capture_output=True, text=True, check=False)


def sample(answer, file, words, rng, count):
    """Verdicts of loads of the proved ball, all of them as far out as it goes."""
    w, radius = [float(eval(str(x))) for x in answer["wrench"]], float(eval(answer["proved"]))
    wrong = 0
    for _ in range(count):
        z = unit([rng.gauss(0, 1) for _ in w])
        load = ",".join(repr(a + .999999 * radius * x) for a, x in zip(w, z))
        verdict = json.loads(run("stickslip", "decide", file, "--json", "--no-warnings", f"--wrench={load}").stdout)["verdict"]
        wrong += verdict == "unstable"
    return wrong


def measure(family, index, samples):
    rng = random.Random(f"{family} {index}")
    grasp, body = FAMILIES[family](rng)
    words = ["--body", body] if isinstance(body, str) else []
    with tempfile.TemporaryDirectory() as folder:
        file, proofs = os.path.join(folder, "g.json"), os.path.join(folder, "proofs")
        with open(file, "w", encoding="utf-8") as out:
            json.dump(grasp, out)
        begin = time.time()
        answer = run("stickslip", "quality", file, "--json", "--certificates", proofs, *words)
        seconds = time.time() - begin
        if answer.returncode not in (0, 3):
            sys.exit(answer.stderr)
        answer = json.loads(answer.stdout)
        if answer["verdict"] != "stable":
            return None
        ball = ":".join(["ball", answer["proved"], "length=1", *([f"body={body}"] if words else [])])
        for name, option in (("proved", ["--uncertain", "wrench=" + ball]), ("refuted", [])):
            path = os.path.join(proofs, name)
            if (name == "proved" and answer["proved"] == "0") or not os.path.exists(path + ".json"):
                continue
            check = run("stickslip-check", path + ".json", path + ".certificate.json", *option)
            if check.returncode != 0:
                sys.exit(f"{family} {index}: {name}: {check.stdout}{check.stderr}")
        wrong = 0 if words else sample(answer, file, words, rng, samples)
    proved, refuted = (float(eval(answer[k])) if answer[k] else math.inf for k in ("proved", "refuted"))
    return len(grasp["contacts"]), proved, refuted, seconds, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=20, help="grasps of each family")
    parser.add_argument("--samples", type=int, default=0, help="loads of each proved ball")
    parser.add_argument("--only", type=int, help="one grasp, by its number")
    parser.add_argument("families", nargs="*", metavar="FAMILY")
    arguments = parser.parse_args()
    rows, wrong = [], 0
    for family in arguments.families or FAMILIES:
        found = []
        for index in [arguments.only] if arguments.only is not None else range(arguments.count):
            one = measure(family, index, arguments.samples)
            if one is None:
                continue
            found.append(one)
            wrong += one[4]
            ratio = one[2] / one[1] if one[1] else math.inf
            print(f"  {family} {index}: m={one[0]} {one[1]:.4g} to {one[2]:.4g}, ratio {ratio:.3f}, {one[3]:.2f} s", flush=True)
        ratios = sorted(b / a if a else math.inf for _, a, b, _, _ in found)
        times = [t for _, _, _, t, _ in found]
        rows.append(f"| {family} | {len(found)} | {statistics.median(ratios):.3f} | {ratios[int(.9 * len(ratios))]:.3f} | "
                    f"{ratios[-1]:.3f} | {statistics.median(times):.2f} | {max(times):.2f} |")
    print("\n| family | stable | refuted / proved, median | 9 of 10 | worst | s, median | slowest |\n|---|--:|--:|--:|--:|--:|--:|")
    print("\n".join(rows))
    if wrong:
        sys.exit(f"{wrong} loads of proved balls are not resisted")


if __name__ == "__main__":
    main()
