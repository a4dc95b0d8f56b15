# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies: Newton's method of the tests (tests/interfaces/cli/bodies_newton.py), in doubles and from many random starts, where a
proof says unstable, and where one says stable.

    python3 bench/bodies/random_starts.py [--starts N] [--count N] [FAMILY ...]

The families of bodies_bench.py, 1 % beyond and 1 % below the load at which they are lost, and random assemblies: plane, space.
Exit code 1 if an equilibrium is found against a proof."""

import argparse
import os
import random
import sys
import time
from itertools import repeat

import numpy as np
from bodies_bench import BIN, FAMILIES, about_thresholds, decide

os.environ.setdefault("STICKSLIP", os.path.join(BIN, "stickslip"))
os.environ.setdefault("STICKSLIP_CHECK", os.path.join(BIN, "stickslip-check"))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "interfaces", "cli"))
from bodies_newton import equilibria  # noqa: E402
from test_bodies import random_assembly  # noqa: E402


def of_family(name, count):
    return (grasp for key, grasp in about_thresholds(name, count) if key != "at 80 %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--starts", type=int, default=1000)
    parser.add_argument("--count", type=int, default=3, help="of each family")
    parser.add_argument("--random", type=int, default=200, help="assemblies in the plane, and in space")
    parser.add_argument("families", nargs="*", metavar="FAMILY")
    asked = parser.parse_args()
    groups = {name: lambda name=name: of_family(name, asked.count) for name in FAMILIES}
    for dim, name in ((2, "plane"), (3, "space")):
        groups[name] = lambda dim=dim: map(random_assembly, repeat(random.Random(1), asked.random), repeat(dim))
    wrong = 0
    print("| assemblies | verdict | how many | from no start | starts that lead to one: least, median, most | s each |\n"
          "|---|---|--:|--:|--:|--:|")
    for name in asked.families or groups:
        found = {}
        for k, grasp in enumerate(groups[name]()):
            verdict = decide(grasp, "--node-limit", "3000")[0]
            begin = time.process_time()
            hits = equilibria(grasp, asked.starts, np.random.default_rng(k))[0]
            found.setdefault(verdict, []).append((hits, time.process_time() - begin))
        for verdict, rows in sorted(found.items()):
            hits = sorted(h for h, _ in rows)
            print(f"| {name} | {verdict} | {len(rows)} | {hits.count(0)} | {hits[0]}, {hits[len(hits) // 2]}, {hits[-1]} "
                  f"| {sum(s for _, s in rows) / len(rows):.1f} |", flush=True)
            wrong += verdict == "unstable" and hits[-1] > 0
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
