# SPDX-License-Identifier: GPL-3.0-or-later
"""What `stickslip decide` takes as people type it, with its warnings, beside --no-warnings: seconds of the processor,
user and system, of whole programs, the least of some runs.

    python3 bench/verdict/default_options.py build/bin/stickslip [100 1000 3000 10000 100000]
"""

import json
import random
import resource
import subprocess
import sys
import tempfile
from fractions import Fraction

SIZES = (100, 1000, 3000, 10000, 100000)
RUNS = 3


def unit(t):
    """The rational unit vector with the parameter t."""
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def all_round(contacts, unlike):
    """Preloaded contacts around an ellipse. Their normals have a hundred directions, or, if unlike, denominators that are
    all different, so that sums are as long as the grasp. No stiffness is given."""
    source = random.Random(1)
    listed = []
    for i in range(contacts):
        t = Fraction(2 * i - contacts + 1, contacts) if unlike else Fraction(source.randint(-97, 97), 97)
        side = (-1) ** i
        c, s = unit(t)
        listed.append({"position": [round(float(2 * side * c), 4), round(float(1.5 * s), 4)],
                       "normal": [str(-side * c), str(-s)],
                       "preload": "1" if unlike else str(Fraction(source.randint(50, 150), 100))})
    return listed


def jaws(contacts):
    """Two rows of contacts that press against each other."""
    return [{"position": [(-1) ** i, round(1 - 4 * (i // 2) / contacts, 5)], "normal": [-((-1) ** i), 0], "preload": "1"}
            for i in range(contacts)]


FAMILIES = {"all round": lambda m: all_round(m, False), "all round, unlike": lambda m: all_round(m, True), "jaws": jaws}


def seconds(*words):
    """Of the processor; and what the program printed."""
    least = None
    for _ in range(RUNS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = subprocess.run(words, capture_output=True, text=True, check=True).stdout
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        least = spent if least is None else min(least, spent)
    return least, answer


def main(program, *sizes):
    print("| m | grasp | verdict | default, s | `--no-warnings`, s | ratio |\n|--:|---|---|--:|--:|--:|")
    for contacts in map(int, sizes or SIZES):
        for family, made in FAMILIES.items():
            grasp = {"format": "stickslip-grasp/1", "defaults": {"friction": "3/10"}, "contacts": made(contacts),
                     "wrench": [contacts / 20, contacts / 50, contacts / 100]}
            with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
                json.dump(grasp, file)
                file.flush()
                default, answer = seconds(program, "decide", file.name)
                alone, _ = seconds(program, "decide", file.name, "--no-warnings")
            verdict = answer.split("\n", 1)[0].split(": ")[-1]
            print(f"| {contacts} | {family} | {verdict} | {default:.3f} | {alone:.3f} | {default / alone:.1f} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
