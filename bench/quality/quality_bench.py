# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the two radii of `stickslip quality` are, and how long they take, with default options and numbers of all digits; and
whether the load that is not resisted, and loads of the proved ball, have the verdicts that it says.

    bench/quality/quality_bench.py [--count N] [--samples S] [--only M] [FAMILY ...]

Families: plane (3 to 10 contacts of two pads that press, unequal), stands (two feet on the ground and one on a wall, by weight
alone), space (4 to 6 contacts of two pads), table (3 to 5 feet and one on a wall, in space, by weight alone), grip (a disc in a
hand of two fingers of two links each). S loads of each proved ball are decided one by one."""

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

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bodies"))
import bodies_bench

BIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin")


def unit(v):
    size = math.sqrt(sum(x * x for x in v))
    return [x / size for x in v]


def pads(count, dimension, rng):
    """Two pads that press from both sides, as those of a parallel gripper do: less even than they would be."""
    contacts = []
    for k in range(count):
        side = 1 if k % 2 else -1
        contacts.append({"position": [side * rng.uniform(.9, 1.1), *(rng.uniform(-1, 1) for _ in range(dimension - 1))],
                         "normal": unit([-side, *(rng.uniform(-.1, .1) for _ in range(dimension - 1))]),
                         "friction": rng.uniform(.3, .9), "stiffness": rng.uniform(.5, 2), "preload": rng.uniform(.8, 1.2)})
    return contacts


def plane(rng):
    return {"format": "stickslip-grasp/2", "contacts": pads(rng.randint(3, 10), 2, rng), "wrench": [0, 0, 0]}, 1


def space(rng):
    return {"format": "stickslip-grasp/2", "contacts": pads(rng.randint(4, 6), 3, rng), "wrench": [0] * 6}, 1


def around(count, dimension, rng):
    """Fingers all around a disc or ball of radius 5, as they would be placed by hand."""
    contacts = []
    for _ in range(count):
        normal = unit([rng.gauss(0, 1) for _ in range(dimension)])
        contacts.append({"position": [-5 * n + rng.uniform(-2, 2) for n in normal], "normal": normal, "friction": rng.uniform(.1, 1),
                         "stiffness": rng.uniform(.5, 2), "preload": rng.uniform(.1, 2) if rng.random() < .8 else 0})
    return contacts


def loaded(contacts, dimension, rng):
    """Under a load at 50 to 90 % of its margin, if it has one that is an interval from 0 on."""
    grasp = {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": [0] * (3 * dimension - 3)}
    way = ",".join(repr(rng.uniform(-1, 1) * (1 if k < dimension else 2)) for k in range(3 * dimension - 3))
    low, high = 0, None
    for _ in range(24):  # bisection proposes; the margin need not be an interval
        middle = 2 * low + .5 if high is None else (low + high) / 2
        load = ",".join(repr(middle * float(x)) for x in way.split(","))
        verdict = json.loads(run("stickslip", "decide", "-", "--json", "--no-warnings", f"--wrench={load}", text=json.dumps(grasp)).stdout)["verdict"]
        if verdict != "stable":
            high = middle
        else:
            low = middle
        if low > 50 or (high is not None and (high < .02 or high - low < .02 * high)):
            break
    if high is None or low == 0:
        return None
    part = rng.uniform(.5, .9) * low
    grasp["wrench"] = [part * float(x) for x in way.split(",")]
    return grasp


def first_loaded(least, most, dimension, rng):
    while True:
        grasp = loaded(around(rng.randint(least, most), dimension, rng), dimension, rng)
        if grasp:
            return grasp, 5


def fingers(rng):
    return first_loaded(3, 10, 2, rng)


def hand(rng):
    return first_loaded(4, 6, 3, rng)


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
    return bodies_bench.gripper(4, rng)(.1), "disc"


FAMILIES = {"fingers": fingers, "hand": hand, "plane": plane, "stands": stands, "space": space, "table": table, "grip": grip}


def run(*words, text=None):
    return subprocess.run([os.path.join(BIN, words[0]), *words[1:]], input=text, capture_output=True, text=True, check=False)


def sample(answer, file, length, rng, count):
    """Verdicts of loads of the proved ball, all of them as far out as it goes."""
    w, radius = [float(eval(str(x))) for x in answer["wrench"]], float(eval(answer["proved"]))
    wrong = 0
    for _ in range(count):
        z = unit([rng.gauss(0, 1) for _ in w])
        z = [x * (1 if k < (len(w) + 3) // 3 else length) for k, x in enumerate(z)]
        load = ",".join(repr(a + .999999 * radius * x) for a, x in zip(w, z))
        verdict = json.loads(run("stickslip", "decide", file, "--json", "--no-warnings", f"--wrench={load}").stdout)["verdict"]
        wrong += verdict == "unstable"
    return wrong


def measure(family, index, samples):
    rng = random.Random(f"{family} {index}")
    grasp, body = FAMILIES[family](rng)
    words = ["--body", body] if isinstance(body, str) else ["--length", str(body)]
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
        ball = ":".join(["ball", answer["proved"], *([f"length=1:body={body}"] if isinstance(body, str) else [f"length={body}"])])
        for name, option in (("proved", ["--uncertain", "wrench=" + ball]), ("refuted", [])):
            path = os.path.join(proofs, name)
            if (name == "proved" and answer["proved"] == "0") or not os.path.exists(path + ".json"):
                continue
            check = run("stickslip-check", path + ".json", path + ".certificate.json", *option)
            if check.returncode != 0:
                sys.exit(f"{family} {index}: {name}: {check.stdout}{check.stderr}")
        wrong = 0 if isinstance(body, str) else sample(answer, file, body, rng, samples)
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
