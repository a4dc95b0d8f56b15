# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples that compas_cra publishes (github.com/BlockResearchGroup/compas_cra, MIT licence; Kao and others, Computer-Aided
Design 146, 2022): by statics, with the least friction, and decided over a box of stiffnesses.

    PYTHONPATH=build/python bench/bodies/compas_cra.py SAMPLES [--stiffness 50%] [--limit SECONDS] [--save FOLDER] [EXAMPLE ...]

SAMPLES is the folder src/compas_cra/data/samples of that repository. Its files have blocks as surfaces, and some their
interfaces; where there are none, stickslip.Assembly finds them (docs/bodies.md). Those blocks that docs/examples names as supports
are the ground, and an assembly that is rotated there has its weight rotated back here. Coordinates are rounded to 1e-6, as those of
the files are to about that, so that all numbers are short.

The model there is of rigid blocks, whose forces need no stiffness. Statics asks the same without one. To `decide` every contact
has a stiffness, so what is asked is whether the verdict is the same for all from 1/2 to 3/2, each by itself; at most 30
coordinates, five blocks that move."""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from fractions import Fraction as F

from stickslip import Assembly

BIN = os.environ.get("STICKSLIP_BIN", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin"))
H = F(1, 2)
TOLERANCE, GRID = "1e-3", "1e-6"
MOST_COORDINATES = 30


def box(x, y, z):
    """A unit cube about a point."""
    corners = [[F(str(x)) + i, F(str(y)) + j, F(str(z)) + k] for k in (-H, H) for j in (-H, H) for i in (-H, H)]
    return corners, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def cubes(*places):
    return {str(i): box(*place) for i, place in enumerate(places)}


def arch(stones=20, radius=5.0, thickness=0.5, depth=0.5):
    """Half a circle, from right to left."""
    def section(i):
        angle = math.pi * i / stones
        return [[r * math.cos(angle), y, r * math.sin(angle)]
                for r, y in ((radius, 0.0), (radius, depth), (radius + thickness, depth), (radius + thickness, 0.0))]

    sides = [[3, 2, 1, 0], [4, 5, 6, 7], *([i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i] for i in range(4))]
    return {str(i): (section(i) + section(i + 1), [face[::-1] for face in sides]) for i in range(stones)}


def down(degrees):
    """Where the weight pulls once the assembly is turned about the y axis: of length 1."""
    if degrees == 90:
        return [F(1), F(0), F(0)]
    t = F(math.tan(math.radians(degrees) / 2)).limit_denominator(10**5)
    return [2 * t / (1 + t * t), F(0), (t * t - 1) / (1 + t * t)]


def assembly_of(name, samples, source, supports, mu, degrees, densities):
    more = {"supports": supports, "gravity": down(degrees), "density": densities, "grid": GRID, "name": f"{name}, of compas_cra"}
    if isinstance(source, dict):
        return Assembly.from_meshes(source, mu, tolerance=TOLERANCE, **more)
    file = os.path.join(samples, source + ".json")
    with open(file, encoding="utf-8") as content:
        graph = json.load(content)["data"]["graph"]["data"]
    interfaces = any(edge.get("interfaces") for others in graph["edge"].values() for edge in others.values())
    return Assembly.from_compas(file, mu, tolerance=None if interfaces else TOLERANCE, **more)


# Of docs/examples there: supports, friction, degrees about y, densities; which method is asked, and what its picture shows.
EXAMPLES = {
    "00 simple cube": (cubes((0, 0, 0), (0, 0, 1)), (0,), "0.84", 0, {}, "CRA: held"),
    "01 cube on a slope of 48 degrees": (cubes((0, 0, 0), (0, 0, 1)), (0,), "0.1", 48, {}, "RBE"),
    "02 cubes": ("cubes", (0,), "0.84", 0, {}, "CRA: held"),
    "03 cube that overhangs, 40 degrees": (cubes((0, 0, 0), (.75, 0, 1)), (0,), "0.84", 40, {}, "penalty"),
    "04 stack, 20 degrees": (cubes((0, 0, 0), (0, 0, 1), (0, 0, 2)), (0,), "0.84", 20, {}, "CRA: held"),
    "05 wedge a": ("type-a", (0, 1), "0.84", 0, {}, ""),
    "05 wedge b": ("type-b", (0, 1), "0.84", 0, {}, ""),
    "05 wedge b, 90 degrees": ("type-b", (0, 1), "0.84", 90, {}, "CRA: held"),
    "05 wedge c": ("type-c", (0, 1), "0.84", 0, {}, ""),
    "05 wedge d": ("type-d", (0, 1), "0.84", 0, {}, ""),
    "06 arch": (arch(), (0, 19), "0.7", 0, {}, "CRA: held"),
    "07 shelf": ("shelf", (0,), "0.9", 0, {}, "penalty"),
    "08 snake": ("snake", (0,), "0.7", 0, {}, "penalty: held"),
    "09 bridge": ("bridge", (0, 1), "0.9", 0, {k: "3.51" for k in range(11, 16)}, "penalty"),
    "10 armadillo vault": ("armadillo_cra", None, "0.84", 0, {}, "CRA: held"),
    "11 concave short, 40 degrees": ("concave-short", (0,), "0.84", 40, {}, "CRA: held"),
    "12 concave long, 50 degrees": ("concave-long", (0,), "0.84", 50, {}, "CRA: held"),
    "13 three curved blocks": ("curve-3-blocks", (0,), "0.84", 0, {}, "CRA: held"),
    "14 curved cube, short": ("cube-curve-short", (0,), "0.84", 0, {}, "CRA: held"),
    "15 curved cube, tall": ("cube-curve-tall", (0,), "0.84", 0, {}, "CRA: held"),
    "16 A": ("A", (0, 1), "0.84", 0, {}, "RBE: held"),
    "16 H": ("H", (0, 1), "0.84", 0, {}, "RBE: held"),
}


def asked(limit, *words):
    """What the program prints, or none within the limit, and the time that it took."""
    begin = time.time()
    try:
        run = subprocess.run([os.path.join(BIN, "stickslip"), *words, "--json"], capture_output=True, text=True,
                             check=False, timeout=limit)
    except subprocess.TimeoutExpired:
        return None, limit
    if not run.stdout:
        sys.exit(run.stderr)
    return json.loads(run.stdout), time.time() - begin


def least_of(answer, mu):
    """The least coefficient of friction, rounded; none where it must move with any."""
    if answer is None:
        return "no answer"
    least = answer["least_friction"]
    return "none" if least is None else f"{float(F(least['high']) * F(mu)):.5g}"


def cells_of(file, mu, coordinates, limit, stiffness):
    answer, seconds = asked(limit, "statics", file)
    yield f"{'no answer' if answer is None else answer.get('class') or 'undecided'} | {seconds:.2g}"
    answer, seconds = asked(limit, "statics", file, "--least-friction")
    yield f"{least_of(answer, mu)} | {seconds:.2g}"
    for words in ((), ("--uncertain", f"stiffness={stiffness}")):
        if coordinates > MOST_COORDINATES:
            yield "– | –"
        else:
            answer, seconds = asked(limit, "decide", file, *words)
            yield f"{'no answer' if answer is None else answer['verdict']} | {seconds:.2g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples")
    parser.add_argument("--stiffness", default="50%")
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--save", metavar="FOLDER")
    parser.add_argument("examples", nargs="*", metavar="EXAMPLE")
    options = parser.parse_intermixed_args()
    print("| example | there | D, contacts | read, s | class | s | least friction | s | stiffness 1 | s | 1/2 to 3/2 | s |\n"
          "|---|---|---|--:|---|--:|--:|--:|---|--:|---|--:|")
    with tempfile.TemporaryDirectory() as folder:
        for name, (source, supports, mu, degrees, densities, there) in EXAMPLES.items():
            if options.examples and not any(word in name for word in options.examples):
                continue
            begin = time.time()
            assembly = assembly_of(name, options.samples, source, supports, mu, degrees, densities)
            read = time.time() - begin
            where = options.save or folder
            os.makedirs(where, exist_ok=True)
            file = os.path.join(where, name.replace(" ", "_").replace(",", "") + ".json")
            with open(file, "w", encoding="utf-8") as out:
                out.write(assembly.to_text())
            cells = cells_of(file, mu, len(assembly.coordinates), options.limit, options.stiffness)
            print(f"| {name} | {there} | {len(assembly.coordinates)}, {len(assembly)} | {read:.2g} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
