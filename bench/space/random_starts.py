# SPDX-License-Identifier: GPL-3.0-or-later
"""Newton's method of the tests, in doubles, from 10,000 random starts: where a proof says unstable it may
find no equilibrium.

    python3 bench/space/random_starts.py --program build/bin/stickslip [--starts N] FILE...

Exit code 1 if it finds one.
"""

import argparse
import json
import os
import sys
import time

import numpy as np

from grasps import decided

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "cli"))
from test_space import F, equilibria  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="+")
    parser.add_argument("--program", required=True)
    parser.add_argument("--starts", type=int, default=10000)
    options = parser.parse_args()
    wrong = 0
    for file in options.files:
        with open(file, encoding="utf-8") as content:
            grasp = json.load(content)
        contacts = [{"stiffness": 1, "preload": 0, **c, "p": [F(x) for x in c["position"]],
                     "n": [F(x) for x in c["normal"]]} for c in grasp["contacts"]]
        contacts = [{key: F(c[key]) if key in ("friction", "stiffness", "preload") else c[key]
                     for key in ("p", "n", "friction", "stiffness", "preload")} for c in contacts]
        verdict = decided(options.program, file)[0]
        start = time.process_time()
        found = equilibria(contacts, [F(w) for w in grasp["wrench"]], options.starts, np.random.default_rng(1))
        print(f"{file}: {verdict}, equilibria from {found} of {options.starts} starts "
              f"({time.process_time() - start:.0f} s)", flush=True)
        wrong += verdict == "unstable" and found > 0
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
