# SPDX-License-Identifier: GPL-3.0-or-later
"""Newton's method of the tests, in doubles, from 10,000 random starts: where a proof says unstable it may
find no equilibrium.

    python3 bench/space/random_starts.py --program build/bin/stickslip [--starts N] FILE...

Exit code 1 if it finds one.
"""

import argparse
import json
import sys
import time
from fractions import Fraction as F

import numpy as np

from grasps import decided, equilibria


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
        contacts = [{"p": [F(x) for x in c["position"]], "n": [F(x) for x in c["normal"]],
                     **{key: F(c[key]) for key in ("friction", "stiffness", "preload")}}
                    for c in grasp["contacts"]]
        verdict, _, _ = decided(options.program, file)
        start = time.process_time()
        found = equilibria(contacts, [F(w) for w in grasp["wrench"]], options.starts, np.random.default_rng(1))
        print(f"{file}: {verdict}, equilibria from {found} of {options.starts} starts "
              f"({time.process_time() - start:.0f} s)", flush=True)
        wrong += verdict == "unstable" and found > 0
    return wrong > 0


if __name__ == "__main__":
    sys.exit(main())
