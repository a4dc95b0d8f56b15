#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many questions about one grasp: one call of stickslip.decide, and the same lines by stickslip batch.

    PYTHONPATH=build/python python3 bench/batch/one_call_bench.py build/bin [--questions N] [--rounds N]

By turns, on all cores; medians of questions a second, and of questions a second of the processor. The verdicts are
compared. batch reads, and writes results; decide takes arrays and gives arrays.
"""

import argparse
import json
import pathlib
import resource
import subprocess
import tempfile
import time
from fractions import Fraction

import numpy as np
from stickslip import Grasp, decide


def round_grasp(rng, m):
    """All round a disc of radius 2."""
    def unit(turns):
        quarter, rest = divmod(turns, 1)
        t = Fraction(round(40 * rest), 40)
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        return [(x, y), (-y, x), (-x, -y), (y, -x)][int(quarter)]

    normals = [unit(4 * i / m) for i in range(m)]
    return Grasp([(-2 * x, -2 * y) for x, y in normals], normals,
                 friction=[Fraction(int(f), 10) for f in rng.integers(2, 10, m)],
                 stiffness=[int(k) for k in rng.integers(1, 6, m)],
                 preload=[Fraction(int(p), 4) for p in rng.integers(1, 9, m)])


def timed(who, work):
    """What it gives, seconds, and seconds of the processor."""
    def processor():
        usage = resource.getrusage(who)
        return usage.ru_utime + usage.ru_stime

    start, used = time.perf_counter(), processor()
    result = work()
    return result, time.perf_counter() - start, processor() - used


def by_batch(programs, folder, grasp, changes):
    path = pathlib.Path(folder, "lines.jsonl")
    text = json.loads(grasp.to_text())
    with open(path, "w", encoding="utf-8") as file:
        for change in changes:
            line = {**text, "wrench": change["wrench"]}
            if "friction" in change:
                line["contacts"] = [{**c, "friction": f}
                                    for c, f in zip(text["contacts"], change["friction"])]
            file.write(json.dumps(line) + "\n")

    def run():
        done = subprocess.run([programs / "stickslip", "batch", path], check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return [json.loads(line)["verdict"] for line in done.stdout.splitlines()]

    return timed(resource.RUSAGE_CHILDREN, run)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--questions", type=int, default=2000)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    print("| m | what varies | questions | batch, 1/s | decide, 1/s | decide / batch "
          "| of the processor: batch, 1/s | decide, 1/s | decide / batch |")
    print("|--:|---|--:|--:|--:|--:|--:|--:|--:|")
    for m in (4, 10, 100):
        rng = np.random.default_rng(m)
        grasp = round_grasp(rng, m)
        n = given.questions if m < 100 else given.questions // 10
        loads = np.round(rng.uniform(-1, 1, (n, 3)) * m / 2, 3)
        frictions = np.round(rng.uniform(0.1, 1, (n, m)), 3)
        one = (0.0, m / 4, 0.0)
        for name, call, changes in (
                ("loads", lambda: decide(grasp, loads),
                 [{"wrench": w} for w in loads.tolist()]),
                ("friction", lambda: decide(grasp, one, friction=frictions),
                 [{"wrench": one, "friction": f} for f in frictions.tolist()])):
            rows = []
            with tempfile.TemporaryDirectory() as folder:
                for _ in range(given.rounds):
                    many, wall, used = timed(resource.RUSAGE_SELF, call)
                    lines, batch_wall, batch_used = by_batch(given.programs, folder, grasp, changes)
                    assert many.verdict.tolist() == lines, "verdicts differ"
                    rows.append((n / batch_wall, n / wall, batch_wall / wall,
                                 n / batch_used, n / used, batch_used / used))
            middle = np.median(np.array(rows), axis=0)
            print(f"| {m} | {name} | {n} | {middle[0]:.0f} | {middle[1]:.0f} | {middle[2]:.2f} "
                  f"| {middle[3]:.0f} | {middle[4]:.0f} | {middle[5]:.2f} |", flush=True)


if __name__ == "__main__":
    main()
