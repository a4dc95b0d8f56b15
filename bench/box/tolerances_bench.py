# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes in space of tolerances that people have: normals within 2 degrees, friction within 5 %, positions within 1/60 of the body's
half size, of grasps as grippers and floors make them, at 80 % of the load at which Newton's method loses them.

    python3 bench/box/tolerances_bench.py --programs build/bin [--grasps N] [--seed S] [--uncertain LIST] [--radius SECONDS] [FAMILY ...]

Families: jaws4, jaws6 (two jaws with 2 or 3 points each, opposite to each other), uneven4, uneven6 (not quite opposite), fingers (three
with two contacts each), sides (four contacts from two sides, and one or two from below), feet (four, pushed), corner (a floor and two walls).
Seconds are of the processor, of whole programs. With --radius also by which factor the tolerances may grow, proved over refuted, as
far as is known after SECONDS. Exit code 1 if a certificate is rejected."""

import argparse
import json
import math
import os
import random
import sys
import tempfile
from fractions import Fraction as F
from statistics import median

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "space"))
from grasps import decided, threshold, timed  # noqa: E402
from test_space import equilibria, force_at, written  # noqa: E402, from the folder that grasps.py names

PUSHED = F(4, 5)  # of the load at which the grasp is lost


def near(value, grain=20):
    return F(round(value * grain), grain)


def contact(position, normal, friction, preload):
    return {"p": [F(x) for x in position], "n": [F(x) for x in normal], "friction": friction, "stiffness": F(1), "preload": F(preload)}


def jaws(rng, per_jaw, is_even):
    """Contacts, the load that stays, and the one that grows."""
    friction = near(rng.uniform(.35, .7))
    low, high = near(rng.uniform(-.7, -.3)), near(rng.uniform(.3, .7))
    if per_jaw == 2:
        points = [(y, near(rng.uniform(-.3, .3))) for y in (low, high)]
    else:
        points = [(low, F(-2, 5)), (high, F(-2, 5)), (near(rng.uniform(-.2, .2)), F(2, 5))]
    contacts = [contact((-1, y, z), (1, 0, 0), friction, 1) for y, z in points]
    for y, z in points:
        off = (0, 0) if is_even else (near(rng.uniform(-.15, .15)), near(rng.uniform(-.15, .15)))
        contacts.append(contact((1, y + off[0], z + off[1]), (-1, 0, 0), friction, 1))
    return contacts, [F(0)] * 6, weight_and_push(rng, .3, .3)


def weight_and_push(rng, push, off):
    force = [near(rng.uniform(-push, push)), near(rng.uniform(-push, push)), F(-1)]
    return force_at(force, [near(rng.uniform(-off, off)) for _ in range(3)])


def fingers(rng):
    friction, contacts = near(rng.uniform(.4, .8)), []
    for finger in range(3):
        height = near(rng.uniform(-.3, .3))
        for up in (F(-1, 4), F(1, 4)):
            half = F(math.tan(math.pi * (finger / 3 - .45) + rng.uniform(-.075, .075))).limit_denominator(40)
            x, y = (1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)
            contacts.append(contact((x, y, height + up), (-x, -y, 0), friction, 1))
    return contacts, [F(0)] * 6, weight_and_push(rng, .3, .2)


def sides(rng):
    friction = near(rng.uniform(.3, .6))
    contacts = [contact((x, near(y * rng.uniform(.3, .7)), near(rng.uniform(-.4, .4))), (-x, 0, 0), friction, 1)
                for x in (-1, 1) for y in (-1, 1)]
    for _ in range(rng.choice((1, 2))):
        contacts.append(contact((near(rng.uniform(-.6, .6)), near(rng.uniform(-.6, .6)), -1), (0, 0, 1), friction, near(rng.uniform(0, 1))))
    return contacts, [F(0)] * 6, weight_and_push(rng, .5, .3)


def weight_at(rng):
    return force_at([F(0), F(0), F(-1)], [near(rng.uniform(-.2, .2)), near(rng.uniform(-.2, .2)), F(0)])


def feet(rng):
    friction = near(rng.uniform(.3, .6))
    contacts = [contact((near(x * rng.uniform(.6, 1)), near(y * rng.uniform(.6, 1)), 0), (0, 0, 1), friction, 0) for x in (-1, 1) for y in (-1, 1)]
    angle = rng.uniform(0, 2 * math.pi)
    push = force_at([near(math.cos(angle)), near(math.sin(angle)), F(0)], [F(0), F(0), near(rng.uniform(.2, .8))])
    return contacts, weight_at(rng), push


def corner(rng):
    friction = near(rng.uniform(.3, .6))
    contacts = [contact((F(x), F(y), -1), (0, 0, 1), friction, 0) for x, y in (("-0.8", "-0.8"), ("0.8", "-0.7"), ("0.1", "0.8"))]
    contacts.append(contact((-1, near(rng.uniform(-.6, .6)), near(rng.uniform(-.6, .6))), (1, 0, 0), friction, 0))
    contacts.append(contact((near(rng.uniform(-.6, .6)), -1, near(rng.uniform(-.6, .6))), (0, 1, 0), friction, 0))
    force = [near(rng.uniform(-1, 1)), near(rng.uniform(-1, 1)), near(rng.uniform(-.2, .4))]
    return contacts, weight_at(rng), force_at(force, [near(rng.uniform(-.5, .5)) for _ in range(3)])


FAMILIES = {"jaws4": lambda rng: jaws(rng, 2, True), "jaws6": lambda rng: jaws(rng, 3, True),
            "uneven4": lambda rng: jaws(rng, 2, False), "uneven6": lambda rng: jaws(rng, 3, False),
            "fingers": fingers, "sides": sides, "feet": feet, "corner": corner}


def grasps(family, count, seed):
    """Files' contents."""
    rng, found = random.Random(f"{family} {seed}"), 0
    while found < count:
        contacts, stays, grows = FAMILIES[family](rng)

        def load(multiple):
            return [a + multiple * b for a, b in zip(stays, grows)]

        def stable_at(multiple):
            return equilibria(contacts, load(multiple), 15, np.random.default_rng(1)) > 0

        ends = threshold(stable_at, F(1, 200))
        if ends is None:
            continue
        found += 1
        yield written(contacts, load((PUSHED * ends[0]).limit_denominator(200)))


def measure(programs, file, uncertain, seconds_of_radius):
    proof = os.path.join(os.path.dirname(file), "certificate.json")
    words = ["--uncertain", uncertain]
    verdict, seconds, answer = decided(os.path.join(programs, "stickslip"), file, "--certificate", proof, *words)
    check, size, ratio = 0, 0, None
    if verdict not in ("undecided", "fragile"):
        check, _ = timed(os.path.join(programs, "stickslip-check"), file, proof, *words)
        size = os.path.getsize(proof)
    if seconds_of_radius:
        _, text = timed(os.path.join(programs, "stickslip"), "radius", file, "--json", "--time-limit", str(seconds_of_radius), *words)
        radius = json.loads(text)
        if radius["refuted"]:
            ratio = float(F(radius["proved"]) / F(radius["refuted"]))
    return verdict, seconds, check, size, answer["stats"], ratio


def row(family, found):
    verdicts, seconds, checks, sizes, stats, ratios = zip(*found)
    proved = [k for k, verdict in enumerate(verdicts) if verdict == "stable"]

    def both(values, form):
        chosen = [values[k] for k in proved]
        return f"{form(median(chosen))} | {form(max(chosen))}" if chosen else "– | –"

    known = [ratio for ratio in ratios if ratio is not None]
    cells = [len(found), *(verdicts.count(word) for word in ("stable", "fragile", "undecided")),
             f"{median(seconds):.1f} | {max(seconds):.1f}", both(seconds, "{:.1f}".format), both(checks, "{:.1f}".format),
             both([s["pieces"] for s in stats], "{:.0f}".format), both([s["leaves"] for s in stats], "{:.0f}".format),
             both([size / 1000 for size in sizes], "{:.0f}".format), f"{median(known):.2f}" if known else "–"]
    return f"| {family} | " + " | ".join(map(str, cells)) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("families", nargs="*", metavar="FAMILY", help="all, if none is named")
    parser.add_argument("--programs", required=True)
    parser.add_argument("--grasps", type=int, default=3, help="of each family")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--uncertain", default="normal=0.035,friction=5%,position=1/60")
    parser.add_argument("--radius", type=int, metavar="SECONDS", help="ask for the radius as well, for so long")
    options = parser.parse_args()
    rows = []
    for family in options.families or FAMILIES:
        found = []
        for index, content in enumerate(grasps(family, options.grasps, options.seed)):
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "grasp.json")
                with open(file, "w", encoding="utf-8") as out:
                    json.dump(content, out)
                one = measure(options.programs, file, options.uncertain, options.radius)
            found.append(one)
            verdict, seconds, check, size, stats, ratio = one
            print(f"{family} {index}: {verdict} in {seconds:.2f} s, checked in {check:.2f} s, {size} bytes, radius {ratio}, {stats}", flush=True)
        rows.append(row(family, found))
    print("\n| family | grasps | stable | fragile | undecided | s, median | slowest | proved: s, median | slowest | check, s: median | slowest "
          "| pieces, median | most | leaves, median | most | kB, median | most | radius: proved / refuted, median |\n" + "|---|" + "--:|" * 17)
    print("\n".join(rows))


if __name__ == "__main__":
    main()
