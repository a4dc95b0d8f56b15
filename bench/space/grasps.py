# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps in space with loads just before and just beyond a threshold, as files for the other scripts
of this folder. A threshold is where Newton's method of the tests finds no equilibrium any more as the load
grows, from 70 starts and in doubles, by bisection; so it does not depend on what is measured.

    python3 bench/space/grasps.py FOLDER [--on sphere|box|pads|fingers|pinch] [--contacts M] [--grasps N]
        [--gaps PART...] [--at MULTIPLE...] [--digits D | --doubles [--no-preload]] [--seed S]

With --doubles all numbers are doubles with all their digits, as NumPy has them, unit normals among them.

Names tell what is in a file: box8_3_0.001u.json is the grasp number 3 with 8 contacts on a box, 0.1 % beyond
(u, as it should be unstable; s is before).
"""

import argparse
import json
import os
import random
import resource
import subprocess
import sys
from fractions import Fraction as F

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "interfaces", "cli"))
from test_space import equilibria, written  # noqa: E402


def unit_vector(rng):
    a, b = F(rng.randint(-8, 8), 8), F(rng.randint(-8, 8), 8)
    s = 1 + a * a + b * b
    n = [2 * a / s, 2 * b / s, rng.choice((-1, 1)) * (1 - a * a - b * b) / s]
    rng.shuffle(n)
    return n


def on_sphere(rng):
    n = unit_vector(rng)
    return [-x for x in n], n


def on_box(rng):
    """On the faces of the cube about the unit sphere."""
    axis, side = rng.randrange(3), rng.choice((-1, 1))
    p, n = [F(rng.randint(-8, 8), 8) for _ in range(3)], [F(0)] * 3
    p[axis], n[axis] = F(side), F(-side)
    return p, n


def pads(rng):
    """Three fingers on the faces of a prism, each a soft pad of eight points; equal but for their
    preloads, which balance."""
    octagon = [(F(1), F(0)), (F(5, 7), F(5, 7)), (F(0), F(1)), (F(-5, 7), F(5, 7)),
               (F(-1), F(0)), (F(-5, 7), F(-5, 7)), (F(0), F(-1)), (F(5, 7), F(-5, 7))]
    friction, radius = F(rng.randint(4, 18), 20), F(rng.randint(2, 6), 20)
    for (x, y), preload in (((-1, 0), F(6, 5)), ((F(3, 5), F(4, 5)), F(1)), ((F(3, 5), F(-4, 5)), F(1))):
        height = F(rng.randint(-4, 4), 8)
        for u, v in octagon:
            yield {"p": [-x - radius * u * y, -y + radius * u * x, height + radius * v],
                   "n": [F(x), F(y), F(0)], "friction": friction, "stiffness": 1, "preload": preload}


def unit_in_doubles(rng):
    n = np.array([rng.gauss(0, 1) for _ in range(3)])
    return n / np.linalg.norm(n)


def turned_at_random(rng):
    """A rotation, in doubles."""
    q, r = np.linalg.qr(np.array([[rng.gauss(0, 1) for _ in range(3)] for _ in range(3)]))
    return q * np.sign(np.diag(r))


def places_in_doubles(rng, on, m):
    """Positions and unit normals."""
    if on == "pinch":
        n = unit_in_doubles(rng)
        return [(-n, n), (n, -n)]
    if on == "fingers":  # three to five on a cylinder, of 1, 2 or 4 contacts each
        fingers = next(k for k in (3, 4, 5) if m % k == 0 and m // k in (1, 2, 4))
        places, turn = [], turned_at_random(rng)
        for k in range(fingers):
            angle, height = 2 * np.pi * (k + rng.uniform(-0.2, 0.2)) / fingers, rng.uniform(-0.5, 0.5)
            for j in range(m // fingers):
                at, up = angle + 0.15 * (j % 2), height + 0.3 * (j // 2)
                out = np.array([np.cos(at), np.sin(at), 0.0])
                places.append((turn @ (out + [0, 0, up]), turn @ -out))
        return places
    if on == "sphere":
        return [(-n, n) for n in (unit_in_doubles(rng) for _ in range(m))]
    places, turn = [], turned_at_random(rng)
    for _ in range(m):
        axis, side = rng.randrange(3), rng.choice((-1.0, 1.0))
        p, n = np.array([rng.uniform(-1, 1) for _ in range(3)]), np.zeros(3)
        p[axis], n[axis] = side, -side
        places.append((turn @ p, turn @ n))
    return places


def grasp_in_doubles(rng, on, m, preloaded):
    """Contacts, and the direction of a load. That of a pinch is a weight in the middle: it has no
    torque about the line through the contacts, about which nothing holds."""
    friction = rng.uniform(0.3, 0.9)
    contacts = [{"p": [F(x) for x in p], "n": [F(x) for x in n],
                 "friction": F(friction * rng.uniform(0.8, 1.25)), "stiffness": F(rng.uniform(0.5, 2)),
                 "preload": F(rng.uniform(0, 2) if on in ("sphere", "box") else rng.uniform(0.8, 1.2))
                 if preloaded else F(0)} for p, n in places_in_doubles(rng, on, m)]
    torque = [F(0)] * 3 if on == "pinch" else [F(rng.uniform(-1, 1)) for _ in range(3)]
    return contacts, [F(rng.uniform(-1, 1)) for _ in range(3)] + torque


def random_grasp(rng, on, m, digits, rough):
    """Contacts, and the direction of a load."""
    def ragged(value):  # to so many digits
        return value + F(rough.randint(-10**digits // 100, 10**digits // 100), 10**digits) if digits else value

    if on == "pads":
        contacts = list(pads(rng))
    else:
        contacts = []
        for _ in range(m):
            p, n = on_sphere(rng) if on == "sphere" else on_box(rng)
            contacts.append({"p": p, "n": n, "friction": F(rng.randint(4, 18), 20), "stiffness": 1,
                             "preload": F(rng.randint(0, 8), 4)})
    for c in contacts:
        c["p"] = [x if on == "box" and n else ragged(x) for x, n in zip(c["p"], c["n"])]
        c["friction"] = ragged(c["friction"])
    return contacts, [ragged(F(rng.randint(-8, 8), 8)) for _ in range(6)]


def timed(*words):
    """Seconds of the processor that a program took, and what it said."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    said = subprocess.run(words, text=True, capture_output=True, check=False)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if said.returncode not in (0, 3):
        raise SystemExit(said.stdout + said.stderr)
    return seconds, said.stdout


def decided(program, file, *words):
    """The verdict, seconds of the processor, and the whole answer."""
    seconds, text = timed(program, "decide", file, "--json", *words)
    answer = json.loads(text)
    return answer["verdict"], seconds, answer


def threshold(stable_at, width):
    """Multiples below and above; None if there is none between 0.01 and 20."""
    low, high = F(1, 100), F(2, 100)
    if not stable_at(low):
        return None
    while high < 20 and stable_at(high):
        low, high = high, 2 * high
    if high >= 20:
        return None
    while high - low > width * high:
        middle = ((low + high) / 2).limit_denominator(10**6)
        low, high = (middle, high) if stable_at(middle) else (low, middle)
    return low, high


def write(folder, name, contacts, wrench):
    with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as file:
        json.dump(written(contacts, wrench), file)


def write_near(folder, name, contacts, direction, gaps):
    """Whether there is a threshold."""
    def load(multiple):
        return [multiple * u for u in direction]

    def stable_at(multiple):
        return any(equilibria(contacts, load(multiple), starts, np.random.default_rng(1)) for starts in (10, 60))

    ends = threshold(stable_at, min(gaps) / 5)
    if ends is None:
        return False
    for gap in gaps:
        for letter, multiple in (("s", ends[0] * (1 - F(gap))), ("u", ends[1] * (1 + F(gap)))):
            write(folder, f"{name}_{gap:g}{letter}", contacts, load(multiple.limit_denominator(10**6)))
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("folder")
    parser.add_argument("--on", choices=("sphere", "box", "pads", "fingers", "pinch"), default="sphere")
    parser.add_argument("--contacts", type=int, default=4, help="of pads there are always 24")
    parser.add_argument("--grasps", type=int, default=6)
    parser.add_argument("--gaps", type=float, nargs="+", default=[0.01, 0.001])
    parser.add_argument("--at", type=F, nargs="+", default=[], help="multiples of the load; no threshold is sought")
    parser.add_argument("--digits", type=int, default=0)
    parser.add_argument("--doubles", action="store_true")
    parser.add_argument("--no-preload", dest="preload", action="store_false")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    os.makedirs(options.folder, exist_ok=True)
    seed = f"{options.seed} {options.on} {options.contacts}"
    rng, rough = random.Random(seed), random.Random(seed)
    count = 0
    while count < options.grasps:
        if options.doubles:
            contacts, direction = grasp_in_doubles(rng, options.on, options.contacts, options.preload)
        else:
            contacts, direction = random_grasp(rng, options.on, options.contacts, options.digits, rough)
        kind = "doubles" * options.doubles or "d" * (options.digits > 0)
        name = f"{options.on}{len(contacts)}{kind}{'idle' * (not options.preload)}_{count}"
        for multiple in options.at:
            write(options.folder, f"{name}_at{float(multiple):g}", contacts, [multiple * u for u in direction])
        count += bool(options.at) or write_near(options.folder, name, contacts, direction, options.gaps)


if __name__ == "__main__":
    main()
