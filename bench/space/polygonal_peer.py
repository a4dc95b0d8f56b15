# SPDX-License-Identifier: GPL-3.0-or-later
"""What `stickslip decide` is measured against in space, and of several bodies: the same grasps with polygonal friction,
by a mixed-integer program in doubles (HiGHS, by SciPy).

    python3 bench/space/polygonal_peer.py --program build/bin/stickslip [--edges 8] [--limit 60] FILE...

The friction of a contact is confined to a regular polygon that is inscribed in Coulomb's circle, and does
as much work against the slip as it can there: a linear complementarity problem (Stewart and Trinkle 1996).
With directions e_j to the vertices, shares b_j >= 0 of them, and the slip's speed l,

    l >= 0, l + e_j.s >= 0, sum b_j <= mu a,    b_j (l + e_j.s) = 0,    l (mu a - sum b_j) = 0,

so that a contact sticks, slips with its friction at a vertex or between two neighbours, up to half an angle
of the polygon off the slip, or is open. Each product is a choice, a binary variable, and either factor is at
most it times a bound, as all quantities are taken to be below --bound times the largest load or preload.
In the plane the polygon has two vertices and is no approximation, and springs of joints and tendons are linear: there
what is not exact are doubles and bounds.
Says stable if the program has a solution, unstable if it has none, and timeout after --limit seconds of the processor.
"""

import argparse
import json
import multiprocessing
import re
import resource
from collections import Counter, defaultdict
from fractions import Fraction
from statistics import median

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp

from grasps import decided

from bodies_newton import Mechanics  # of tests/interfaces/cli, where grasps looks, too


def read(file):
    """Contacts, as (normal row, slip rows, friction, stiffness, preload), the load, and springs, as (row, stiffness, force)."""
    with open(file, encoding="utf-8") as content:
        grasp = json.load(content)
    if grasp["format"] == "stickslip-grasp/3":
        return read_bodies(grasp)

    def number(x):
        return float(Fraction(str(x)))

    contacts = []
    for c in grasp["contacts"]:
        p, n = (np.array([number(x) for x in c[key]]) for key in ("position", "normal"))
        n /= np.linalg.norm(n)
        first = np.eye(3)[np.argmin(np.abs(n))]
        first -= (first @ n) * n
        first /= np.linalg.norm(first)
        tangents = np.array([first, np.cross(n, first)])
        laws = {"stiffness": 1, "preload": 0, **grasp.get("defaults", {}), **c}
        contacts.append((np.concatenate([n, np.cross(p, n)]), np.hstack([tangents, np.cross(p, tangents)]),
                         *(number(laws[key]) for key in ("friction", "stiffness", "preload"))))
    return contacts, np.array([number(w) for w in grasp["wrench"]]), []


def read_bodies(grasp):
    of = Mechanics(grasp)
    if of.across == 3:
        raise SystemExit("soft fingers: their friction has no polygon")
    contacts = list(zip(of.normal, of.slips, of.friction, of.stiffness, of.preload))
    # A ratchet is a contact without friction, which pushes along its row.
    contacts += [(row, np.zeros((of.dim - 1, of.count)), 0, k, force) for row, k, force, only in of.springs if only]
    return contacts, of.load, [(row, k, force) for row, k, force, only in of.springs if not only]


def peer(contacts, wrench, springs, edges=8, bound=20):
    """Its verdict; if stable, the largest angle in degrees between friction and what Coulomb's would be."""
    motions = len(wrench)
    size = max(np.abs(wrench).max(), *(c[4] for c in contacts), *(abs(force) for _, _, force in springs), 0, 0)
    if size == 0:
        return "stable", 0
    if all(len(slip) == 1 for _, slip, *_ in contacts):
        edges, directions = 2, np.array([[1.0], [-1.0]])
    else:
        angles = 2 * np.pi * np.arange(edges) / edges
        directions = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    each = 3 + 2 * edges + 1  # a, l, may it be closed, may it slip, shares, may they be used
    count = motions + each * len(contacts)
    lower, upper, binary = np.zeros(count), np.full(count, float(bound)), np.zeros(count)
    lower[:motions] = -bound
    rows, lows, highs = [], [], []

    def between(low, row, high):
        rows.append(row)
        lows.append(low)
        highs.append(high)

    def row_of(entries):
        row = np.zeros(count)
        for index, value in entries:
            row[index] = value
        return row

    twist, free = slice(0, motions), np.inf
    balance = np.zeros((motions, count))
    load = np.array(wrench, dtype=float)
    for row, stiffness, force in springs:
        load += force * row
        balance[:, twist] -= stiffness * np.outer(row, row)
    for i, (normal, slip, mu, stiffness, preload) in enumerate(contacts):
        start = motions + each * i
        a, speed, closed, slips = range(start, start + 4)
        shares = np.arange(start + 4, start + 4 + edges)
        chosen = shares + edges
        for index in (closed, slips, *chosen):
            binary[index], upper[index] = 1, 1
        moves = directions @ slip
        balance[:, a] = normal
        balance[:, shares] = moves.T
        # a = max(0, v) with v = preload - stiffness normal.d
        between(preload / size, row_of([(a, 1), (twist, stiffness * normal)]), free)
        between(-free, row_of([(a, 1), (closed, -bound)]), 0)
        between(-free, row_of([(a, 1), (twist, stiffness * normal), (closed, bound)]),
                preload / size + bound)
        # Friction, and how fast it slips.
        used, most = [(shares, 1), (a, -mu)], max(mu, 1) * bound
        between(-free, row_of(used), 0)
        between(-most, row_of([*used, (slips, -most)]), free)
        between(-free, row_of([(speed, 1), (slips, -bound)]), 0)
        # At most two neighbours if it slips: implied, but stronger.
        between(-free, row_of([(chosen, 1), (slips, edges - 2)]), edges)
        for share, choice, move in zip(shares, chosen, moves):
            against = [(speed, 1), (twist, move)]
            between(0, row_of(against), free)
            between(-free, row_of([*against, (choice, 2 * bound)]), 2 * bound)
            between(-free, row_of([(share, 1), (choice, -bound)]), 0)
    for row, part in zip(balance, load / size):
        between(-part, row, -part)
    found = milp(np.zeros(count), integrality=binary, bounds=Bounds(lower, upper),
                 constraints=LinearConstraint(np.array(rows), lows, highs))
    verdict = {0: "stable", 2: "unstable"}.get(found.status, f"failed: {found.message}")
    if verdict != "stable":
        return verdict, 0
    angle = 0
    for i, (_, slip, *_) in enumerate(contacts):
        start = motions + each * i
        s, f = slip @ found.x[twist], directions.T @ found.x[start + 4:start + 4 + edges]
        if found.x[start] > 1e-6 and np.linalg.norm(s) > 1e-6 and f.any():
            angle = max(angle, np.arccos(np.clip(-s @ f / np.linalg.norm(s) / np.linalg.norm(f), -1, 1)))
    return verdict, np.degrees(angle)


def limited(seconds, function, *arguments):
    """Its result in a process of its own, or None after these seconds of the processor; and how many it took."""
    def work():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        child.send(function(*arguments))

    parent, child = multiprocessing.Pipe(False)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    process = multiprocessing.get_context("fork").Process(target=work)
    process.start()
    process.join()
    took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    return parent.recv() if process.exitcode == 0 else None, took


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="+")
    parser.add_argument("--program", required=True)
    parser.add_argument("--edges", type=int, default=8)
    parser.add_argument("--limit", type=int, default=60, help="seconds of the processor")
    parser.add_argument("--bound", type=float, default=20)
    options = parser.parse_args()
    pairs, times = defaultdict(Counter), defaultdict(list)
    for file in options.files:
        ours, our_time, _ = decided(options.program, file)
        said, their_time = limited(options.limit, peer, *read(file), options.edges, options.bound)
        theirs, angle = said or ("timeout", 0)
        print(f"{file}: {ours} in {our_time:.3f} s, the peer {theirs} in {their_time:.3f} s"
              + f", friction {angle:.0f} degrees off the slip" * (theirs == "stable"), flush=True)
        group = re.sub(r".*/|_\d+(?=_)|[.]json$", "", file)
        pairs[group][ours, theirs] += 1
        times[group].append((our_time, their_time))
    print("\n| grasps | ours, peer's: how many | ours, s: median | slowest | peer, s: median | slowest |\n"
          "|---|---|--:|--:|--:|--:|")
    for group, counted in pairs.items():
        said = ", ".join(f"{a}, {b}: {n}" for (a, b), n in counted.most_common())
        cells = " | ".join(f"{median(t):.3g} | {max(t):.3g}" for t in zip(*times[group]))
        print(f"| {group} | {said} | {cells} |")


if __name__ == "__main__":
    main()
