# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples that compas_cra publishes (github.com/BlockResearchGroup/compas_cra, MIT licence; Kao and others, Computer-Aided
Design 146, 2022), decided over a box of stiffnesses.

    bench/bodies/compas_cra.py SAMPLES [--stiffness 50%] [--limit SECONDS] [--save FOLDER] [EXAMPLE ...]

SAMPLES is the folder src/compas_cra/data/samples of that repository. Its files have blocks as surfaces, and some their
interfaces; where there are none, faces of two blocks that lie on each other meet in one. A contact is a corner of an interface,
along the normal of the block's face; a block weighs its volume; those that docs/examples names as supports are the ground, and an
assembly that is rotated there has its weight rotated back here. Coordinates are rounded to 1e-6, as those of the files are to
about that, so that faces that should lie on each other do, and all numbers are short.

The model there is of rigid blocks, whose forces need no stiffness; here every contact has one. So what is asked is whether the
verdict is the same for all from 1/2 to 3/2, each by itself."""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from fractions import Fraction as F

BIN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "bin")
FLAT, LEAST_AREA = F(1, 100), F(1, 10**4)


def rounded(x):
    return F(round(x * 10**6), 10**6)


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def normal_of(polygon):
    """Of twice its area: the sum over a fan. Outwards, as faces run."""
    fans = [cross(sub(a, polygon[0]), sub(b, polygon[0])) for a, b in zip(polygon[1:], polygon[2:])]
    return [sum(n[j] for n in fans) for j in range(3)]


class Block:
    def __init__(self, vertices, faces):
        self.faces = [[vertices[v] for v in face] for face in faces]
        triangles = [(f[0], a, b) for f in self.faces for a, b in zip(f[1:], f[2:])]
        parts = [dot(a, cross(b, c)) / 6 for a, b, c in triangles]
        self.volume = sum(parts)
        self.centre = [sum(p * (a[j] + b[j] + c[j]) for p, (a, b, c) in zip(parts, triangles)) / 4 / self.volume
                       for j in range(3)]
        if self.volume < 0:
            self.volume, self.faces = -self.volume, [f[::-1] for f in self.faces]


def box(x, y, z):
    """A unit cube about a point."""
    h = F(1, 2)
    vertices = [[F(str(x)) + i * h, F(str(y)) + j * h, F(str(z)) + k * h] for k in (-1, 1) for j in (-1, 1) for i in (-1, 1)]
    return Block(vertices, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])


def clipped(polygon, a, b, inside):
    """The part of a polygon in the plane of two coordinates on the left of the line from a to b."""
    def side(p):
        return inside * ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]))

    result = []
    for p, q in zip(polygon, [*polygon[1:], *polygon[:1]]):
        s, t = side(p), side(q)
        if s >= 0:
            result.append(p)
        if s * t < 0:
            result.append([x + (y - x) * s / (s - t) for x, y in zip(p, q)])
    return result


def area(polygon):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(polygon, [*polygon[1:], *polygon[:1]])) / 2


def common_part(face, other):
    """Of two faces on each other: a polygon in the plane of the first, or nothing."""
    n = normal_of(face)
    size = dot(n, n)
    if dot(n, normal_of(other)) >= 0 or any(dot(n, sub(p, face[0]))**2 > FLAT**2 * size for p in other):
        return []
    drop = max(range(3), key=lambda j: abs(n[j]))
    keep = [j for j in range(3) if j != drop]
    part, clip = ([[p[j] for j in keep] for p in polygon] for polygon in (other, face))
    turn = 1 if area(clip) > 0 else -1
    assert all(turn * area([a, b, c]) >= 0 for a, b, c in zip(clip, [*clip[1:], clip[0]], [*clip[2:], *clip[:2]])), "not convex"
    for a, b in zip(clip, [*clip[1:], clip[0]]):
        part = clipped(part, a, b, turn)
    if len(part) < 3 or abs(area(part)) * math.sqrt(size) < LEAST_AREA * abs(n[drop]):
        return []
    corners = []
    for p in part:
        whole = [F(0)] * 3
        whole[keep[0]], whole[keep[1]] = p
        whole[drop] = face[0][drop] - sum(n[j] * (whole[j] - face[0][j]) for j in keep) / n[drop]
        if whole not in corners:
            corners.append(whole)
    return corners


def read(file):
    """Blocks, and interfaces as (from, to, normal into the first, corners)."""
    with open(file, encoding="utf-8") as content:
        graph = json.load(content)["data"]["graph"]["data"]
    blocks, interfaces = {}, []
    for key, node in graph["node"].items():
        data = node["block"]["data"]
        vertices = {int(k): [rounded(v[axis]) for axis in "xyz"] for k, v in data["vertex"].items()}
        blocks[int(key)] = Block(vertices, data["face"].values())
    for one, others in graph["edge"].items():
        for two, edge in others.items():
            for interface in edge.get("interfaces") or []:
                data = interface["data"]
                corners = [[rounded(x) for x in p] for p in data["points"]]
                axes = data["frame"]["data"]
                out = cross(*([rounded(x) for x in axes[axis]] for axis in ("xaxis", "yaxis")))
                interfaces.append((int(one), int(two), [-x for x in out], corners))
    return blocks, interfaces or found(blocks)


def found(blocks):
    return [(i, j, [-x for x in normal_of(f)], corners) for i in blocks for j in blocks if i < j
            for f in blocks[i].faces for g in blocks[j].faces for corners in [common_part(f, g)] if corners]


def down(degrees):
    """Where the weight pulls once the assembly is turned about the y axis: of length 1."""
    if degrees == 90:
        return [F(1), F(0), F(0)]
    t = F(math.tan(math.radians(degrees) / 2)).limit_denominator(10**5)
    return [2 * t / (1 + t * t), F(0), (t * t - 1) / (1 + t * t)]


def grasp_of(name, blocks, interfaces, supports, mu, degrees, densities):
    free = [k for k in blocks if k not in supports]
    contacts = []
    for one, two, normal, corners in interfaces:
        if one in supports and two in supports:
            continue
        if one in supports:
            one, two, normal = two, one, [-x for x in normal]
        by = {} if two in supports else {"by": f"b{two}"}
        contacts += [{"of": f"b{one}", **by, "position": [str(x) for x in p], "normal": [str(x) for x in normal]}
                     for p in corners]
    loads = [{"body": f"b{k}", "weight": str(blocks[k].volume * densities.get(k, 1)), "direction": [str(x) for x in down(degrees)],
              "at": [str(x) for x in blocks[k].centre]} for k in free]
    return {"format": "stickslip-grasp/3", "name": f"{name}, of compas_cra",
            "bodies": [{"name": f"b{k}", "mesh": mesh_of(blocks[k])} for k in free], "defaults": {"friction": str(mu)},
            "contacts": contacts, "loads": loads}


def mesh_of(block):
    vertices = []
    faces = []
    for face in block.faces:
        for p in face:
            if p not in vertices:
                vertices.append(p)
        faces.append([vertices.index(p) for p in face])
    return {"vertices": [[str(x) for x in p] for p in vertices], "faces": faces}


def cubes(*places):
    blocks = dict(enumerate(box(*p) for p in places))
    return blocks, found(blocks)


# Of docs/examples there: supports, friction, degrees about y, densities; which method is asked, and what its picture shows.
EXAMPLES = {
    "00 simple cube": (lambda _: cubes((0, 0, 0), (0, 0, 1)), (0,), "0.84", 0, {}, "CRA: held"),
    "01 cube on a slope of 48 degrees": (lambda _: cubes((0, 0, 0), (0, 0, 1)), (0,), "0.1", 48, {}, "RBE"),
    "02 cubes": ("cubes", (0,), "0.84", 0, {}, "CRA: held"),
    "03 cube that overhangs, 40 degrees": (lambda _: cubes((0, 0, 0), (.75, 0, 1)), (0,), "0.84", 40, {}, "penalty"),
    "04 stack, 20 degrees": (lambda _: cubes((0, 0, 0), (0, 0, 1), (0, 0, 2)), (0,), "0.84", 20, {}, "CRA: held"),
    "05 wedge a": ("type-a", (0, 1), "0.84", 0, {}, ""),
    "05 wedge b": ("type-b", (0, 1), "0.84", 0, {}, ""),
    "05 wedge b, 90 degrees": ("type-b", (0, 1), "0.84", 90, {}, "CRA: held"),
    "05 wedge c": ("type-c", (0, 1), "0.84", 0, {}, ""),
    "05 wedge d": ("type-d", (0, 1), "0.84", 0, {}, ""),
    "08 snake": ("snake", (0,), "0.7", 0, {}, "penalty: held"),
    "11 concave short, 40 degrees": ("concave-short", (0,), "0.84", 40, {}, "CRA: held"),
    "12 concave long, 50 degrees": ("concave-long", (0,), "0.84", 50, {}, "CRA: held"),
    "13 three curved blocks": ("curve-3-blocks", (0,), "0.84", 0, {}, "CRA: held"),
    "14 curved cube, short": ("cube-curve-short", (0,), "0.84", 0, {}, "CRA: held"),
    "15 curved cube, tall": ("cube-curve-tall", (0,), "0.84", 0, {}, "CRA: held"),
    "16 A": ("A", (0, 1), "0.84", 0, {}, "RBE: held"),
    "16 H": ("H", (0, 1), "0.84", 0, {}, "RBE: held"),
}


def decided(file, limit, *words):
    begin = time.time()
    try:
        run = subprocess.run([os.path.join(BIN, "stickslip"), "decide", file, "--json", *words], capture_output=True, text=True,
                             check=False, timeout=limit)
    except subprocess.TimeoutExpired:
        return "no answer", limit
    if not run.stdout:
        sys.exit(run.stderr)
    return json.loads(run.stdout)["verdict"], time.time() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples")
    parser.add_argument("--stiffness", default="50%")
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--save", metavar="FOLDER")
    parser.add_argument("examples", nargs="*", metavar="EXAMPLE")
    asked = parser.parse_intermixed_args()
    print("| example | there | D, contacts | stiffness 1 | s | 1/2 to 3/2 | s |\n|---|---|---|---|--:|---|--:|")
    with tempfile.TemporaryDirectory() as folder:
        for name, (source, supports, mu, degrees, densities, there) in EXAMPLES.items():
            if asked.examples and not any(word in name for word in asked.examples):
                continue
            made = source(None) if callable(source) else read(os.path.join(asked.samples, source + ".json"))
            grasp = grasp_of(name, *made, supports, mu, degrees, densities)
            where = asked.save or folder
            os.makedirs(where, exist_ok=True)
            file = os.path.join(where, name.replace(" ", "_").replace(",", "") + ".json")
            with open(file, "w", encoding="utf-8") as out:
                json.dump(grasp, out)
            cells = [f"{verdict} | {seconds:.2g}" for verdict, seconds in
                     (decided(file, asked.limit), decided(file, asked.limit, "--uncertain", f"stiffness={asked.stiffness}"))]
            print(f"| {name} | {there} | {6 * len(grasp['bodies'])}, {len(grasp['contacts'])} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
