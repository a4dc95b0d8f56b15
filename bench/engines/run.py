#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts engines through the cases: a file of results for each engine and rate, those of space in
RESULTS/space.

    run.py RESULTS [ENGINE ...]
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Dict, Iterator, List

import solid
from engines import DIRECT, ENGINES, HERE, ITERATIONS, ITERATIONS_OF, SOLID_ENGINES, Engine
from scene import read, scene_of, shape


def read_cases(folder: Path = HERE / "cases") -> Iterator[Dict[str, object]]:
    for path in sorted(folder.glob("*.jsonl")):
        with open(path, encoding="utf-8") as lines:
            yield from map(json.loads, lines)


def solid_in_doubles(case: Dict[str, object]) -> str:
    body, obstacles = solid.scene_of(case)
    floats = lambda numbers: [float(read(v)) for v in numbers]
    return json.dumps({
        "name": case["grasp"]["name"], "vertices": [floats(v) for v in body.vertices], "inertia": floats(body.gyration),
        "obstacles": [{"shape": solid.shape(o), "point": floats(o.point), "normal": floats(o.normal),
                       "friction": float(o.friction)} for o in obstacles],
        "settle": floats(case["settle"]), "load": floats(case["grasp"]["wrench"])})


def in_doubles(case: Dict[str, object]) -> str:
    """What a driver reads."""
    if "vertices" in case:
        return solid_in_doubles(case)
    body, obstacles = scene_of(case)
    pair = lambda v: [float(v[0]), float(v[1])]
    return json.dumps({
        "name": case["grasp"]["name"], "vertices": [pair(v) for v in body.vertices], "radius": float(body.radius),
        "inertia": float(body.gyration ** 2),
        "obstacles": [{"shape": [pair(v) for v in shape(o)], "point": pair(o.point), "normal": pair(o.normal),
                       "friction": float(o.friction), "tip": o.tip} for o in obstacles],
        "settle": [float(read(c)) for c in case["settle"]],
        "load": [float(read(c)) for c in case["grasp"]["wrench"]]})


def result_file(results: Path, engine: Engine, rate: int) -> Path:
    return results / f"{engine.name.replace(' ', '_')}-{rate}.jsonl"


def put_through(engine: Engine, rate: int, lines: str, results: Path, iterations: int = 1) -> str:
    start = time.monotonic()
    with open(result_file(results, engine, rate), "w", encoding="utf-8") as out:
        done = subprocess.run(engine.command(rate), input=lines, stdout=out, stderr=subprocess.PIPE, text=True,
                              env={**os.environ, "STICKSLIP_ITERATIONS": str(iterations)})
    if done.returncode:
        raise SystemExit(f"{engine.name} at {rate}: {done.stderr[-2000:]}")
    return f"{engine.name} at {rate} steps a second: {time.monotonic() - start:.0f} s"


def run(results: Path, engines: List[Engine], cases: List[Dict[str, object]], iterations: int = 1) -> None:
    results.mkdir(parents=True, exist_ok=True)
    lines = "".join(in_doubles(case) + "\n" for case in cases)
    with ThreadPoolExecutor(2) as pool:
        for said in pool.map(lambda task: put_through(*task, lines, results, iterations),
                             [(e, rate) for e in engines for rate in e.rates]):
            print(said, flush=True)


def main(results: str, *names: str) -> None:
    for engines, folder, out in ((ENGINES, HERE / "cases", Path(results)),
                                 (SOLID_ENGINES, HERE / "cases/space", Path(results) / "space")):
        chosen = [e for e in engines if not names or e.name in names]
        for engine in chosen:
            if engine.missing():
                print(f"{engine.name} is left out: {engine.missing()} is missing")
        run(out, [e for e in chosen if not e.missing()], list(read_cases(folder)))
    some = [e._replace(rates=e.rates[:1]) for e in ENGINES
            if (not names or e.name in names) and not e.missing() and e.name != DIRECT]
    for times in ITERATIONS[1:]:
        print(f"{times} times the iterations, on one in {ITERATIONS_OF} cases")
        run(Path(results) / f"iterations-{times}", some, list(read_cases())[::ITERATIONS_OF], times)


if __name__ == "__main__":
    main(*sys.argv[1:])
