# SPDX-License-Identifier: GPL-3.0-or-later
"""How many everyday grasps, whose thresholds are known in closed form, `stickslip decide` answers as expected with default
options, in what time and how many nodes; with friction known to 5 % as well.

    python3 bench/everyday/everyday_bench.py [--program build/bin/stickslip] [--seed S] [--count N] [--limit SECONDS]

The families are those of tests/support/everyday.py, in space and, where there is one, in the plane: N grasps of each below
and N beyond its threshold, turned and moved at random, in doubles. As expected is a verdict, or the second answer where there
is one: about motions of the size of the problem, or about the load without what only rounding opposes. Milliseconds are of
whole programs, from start to end. With --save FOLDER the grasps that are not answered as expected are written there."""

import argparse
import json
import os
import random
import statistics
import subprocess
import sys
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "tests", "support"))
import everyday  # noqa: E402

# Of the threshold, below it and beyond.
SHARES = {"": ((0.3, 0.5, 0.8, 0.9, 0.99), (1.01, 1.1, 1.5, 3)), "friction=5%": ((0.8,), (1.5,))}


def decide(program, grasp, uncertain, limit):
    """The answer, or None if there is none in time; and milliseconds."""
    words = [program, "decide", "-", "--json", *(["--uncertain", uncertain] if uncertain else [])]
    begin = time.perf_counter()
    try:
        done = subprocess.run(words, input=json.dumps(grasp), capture_output=True, text=True, timeout=limit, check=False)
    except subprocess.TimeoutExpired:
        return None, 1000 * limit
    took = 1000 * (time.perf_counter() - begin)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    return json.loads(done.stdout), took


def nodes_of(answer):
    """Of the trees of both answers."""
    return sum(one["stats"].get("nodes", 0) for one in (answer, answer.get("within")) if one)


def row(family, flat, beyond, uncertain, arguments):
    # Its own source, so that a family has the same grasps whatever others are asked.
    rng = random.Random(f"{arguments.seed} {family.__name__} {flat} {beyond} {uncertain}")
    shares, expected = SHARES[uncertain][beyond], "unstable" if beyond else "stable"
    verdicts, times, nodes = [], [], []
    for k in range(arguments.count):
        grasp = everyday.everyday(family, shares[k % len(shares)], rng, flat=flat)
        answer, took = decide(arguments.program, grasp, uncertain, arguments.limit)
        verdicts.append(everyday.plain_verdict(answer) if answer else "no answer")
        times.append(took)
        if answer:
            nodes.append(nodes_of(answer))
        if verdicts[-1] != expected and arguments.save:
            os.makedirs(arguments.save, exist_ok=True)
            name = "_".join(filter(None, (family.__name__, "plane" if flat else "space", str(shares[k % len(shares)]), uncertain, str(k))))
            with open(os.path.join(arguments.save, name + ".json"), "w", encoding="utf-8") as file:
                json.dump(grasp, file)
    missed = verdicts.count("undecided") + verdicts.count("no answer")
    print(f"| {family.__name__}{', plane' if flat else ''} | {'beyond' if beyond else 'below'} | {uncertain or '-'} | "
          f"{verdicts.count(expected)} of {arguments.count} | {missed} | {statistics.median(times):.0f} | {max(times):.0f} | "
          f"{statistics.median(nodes or [0]):.0f} | {max(nodes, default=0)} |", flush=True)
    return verdicts, expected, times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "stickslip"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=10, help="grasps of each family, on each side of its threshold")
    parser.add_argument("--limit", type=float, default=60, help="seconds for each")
    parser.add_argument("--save", metavar="FOLDER", help="write there what is not answered as expected")
    arguments = parser.parse_args()
    kinds = [(family, False) for family in everyday.FAMILIES] + [(family, True) for family in everyday.FLAT]
    print("| family | load | uncertain | as expected | undecided | ms, median | most | nodes, median | most |\n"
          "|---|---|---|--:|--:|--:|--:|--:|--:|")
    for uncertain in SHARES:
        for beyond in (0, 1):
            right, times, count = 0, [], 0
            for family, flat in kinds:
                verdicts, expected, took = row(family, flat, beyond, uncertain, arguments)
                right, count, times = right + verdicts.count(expected), count + len(verdicts), times + took
            print(f"| *all* | {'beyond' if beyond else 'below'} | {uncertain or '-'} | {right} of {count} | | "
                  f"{statistics.median(times):.0f} | {max(times):.0f} | | |", flush=True)


if __name__ == "__main__":
    main()
