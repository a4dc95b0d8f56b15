# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts with positions and unit normals in doubles, all digits of them: what verdicts take, how long their
certificates are, and what the checkers take. Seconds of the processor of whole programs.

    python3 bench/verdict/doubles.py --programs build/bin [--contacts 10 100 1000] [--no-python]

Exit code 1 if a certificate is not accepted. A verdict that takes longer than --limit seconds is left out.
"""

import argparse
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile

CHECK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "certificate", "python", "check.py")
LOADS = {
    ("round", "stable"): (0.3, 0.2, 0.0007), ("round", "unstable"): (3, 2, 1),
    ("arc", "stable"): (0.1, -1, 0.001), ("arc", "unstable"): (0.1, 1, 0.001),
    ("edges", "stable"): (0.05, -1, 0.001), ("edges", "unstable"): (0.05, 1.5, 0.001),
}


def exact(x):
    return "{}/{}".format(*float(x).as_integer_ratio())


def contact(source, layout, i, contacts):
    """A place and the angle of a normal."""
    reach = 0.05 * (1 + 0.1 * source.uniform(-1, 1))
    if layout == "edges":  # on three, open at the top, turned a little
        edge = i % 3
        angle = 0.28 + (math.pi / 2, math.atan2(5, 12), math.pi - math.atan2(5, 12))[edge]
        x, y = ((0, -0.05), (-0.075, 0), (0.075, 0))[edge]
        along = 0.045 * source.uniform(-1, 1)
        return (x * math.cos(0.28) - y * math.sin(0.28) - along * math.sin(angle),
                x * math.sin(0.28) + y * math.cos(0.28) + along * math.cos(angle)), angle
    if layout == "round":
        angle = 2 * math.pi * (i + 0.3 * source.random()) / contacts
        tilt = 0.2
    else:
        angle = -math.pi / 2 + 0.8 * math.pi * ((i + source.random()) / contacts - 0.5)
        tilt = 0.1
    return ((reach * math.cos(angle), reach * math.sin(angle)),
            angle + math.pi + tilt * source.uniform(-1, 1))


def grasp(layout, contacts, preloaded, load):
    source = random.Random(contacts)
    listed = []
    for i in range(contacts):
        (x, y), angle = contact(source, layout, i, contacts)
        listed.append({"position": [exact(x), exact(y)],
                       "normal": [exact(math.cos(angle)), exact(math.sin(angle))],
                       "friction": str(source.randint(2, 9) / 10), "stiffness": source.randint(1, 5),
                       "preload": str(source.randint(1, 8) / 4) if preloaded else 0})
    wrench = [exact(w * contacts * (1 + 0.1 * source.uniform(-1, 1))) for w in LOADS[layout, load]]
    return {"format": "stickslip-grasp/1", "contacts": listed, "wrench": wrench}


def timed(words, limit):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=limit)
    except subprocess.TimeoutExpired:
        return None, limit
    return done, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--programs", required=True)
    parser.add_argument("--contacts", type=int, nargs="+", default=[10, 100, 1000])
    parser.add_argument("--limit", type=float, default=120)
    parser.add_argument("--no-python", action="store_true", help="do not ask check.py")
    options = parser.parse_args()
    program = os.path.join(options.programs, "stickslip")
    checkers = [[os.path.join(options.programs, "stickslip-check")]]
    if not options.no_python:
        checkers.append([sys.executable, "-B", CHECK])
    print("| layout | m | preload | verdict | s | certificate, kB | " +
          " | ".join(f"{os.path.basename(c[-1])}, s" for c in checkers) + " |")
    print("|---|--:|---|---|--:|--:|" + "--:|" * len(checkers))
    refused = False
    with tempfile.TemporaryDirectory() as folder:
        file, proof = os.path.join(folder, "grasp.json"), os.path.join(folder, "certificate.json")
        for contacts in options.contacts:
            for layout, load in LOADS:
                for preloaded in (False, True):
                    with open(file, "w", encoding="utf-8") as out:
                        json.dump(grasp(layout, contacts, preloaded, load), out)
                    if os.path.exists(proof):
                        os.remove(proof)
                    done, took = timed([program, "decide", file, "--certificate", proof, "--json",
                                        "--no-warnings"], options.limit)
                    row = [layout, contacts, "yes" if preloaded else "no"]
                    if done is None or not os.path.exists(proof):
                        row += ["late" if done is None else "undecided", f"{took:.2f}", ""]
                        row += [""] * len(checkers)
                    else:
                        row += [json.loads(done.stdout)["verdict"], f"{took:.2f}",
                                f"{os.path.getsize(proof) / 1e3:.1f}"]
                        for checker in checkers:
                            checked, took = timed([*checker, file, proof], options.limit)
                            refused = refused or (checked is not None and checked.returncode != 0)
                            row.append("late" if checked is None else f"{took:.2f}")
                    print("|", " | ".join(map(str, row)), "|", flush=True)
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
