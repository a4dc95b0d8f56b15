# SPDX-License-Identifier: MIT
"""Proofs by degree (certificate/FORMAT.md, section 6) for small grasps: a search for their trees, with
check.py as the judge of every leaf.
"""

import itertools
import unittest.mock
from fractions import Fraction

from support import check, posed

EASY = [y for y in itertools.product((-1, 0, 1), repeat=3) if any(y)]


def unit(n):
    return [[int(j == k) for k in range(n)] for j in range(n)]


def numbers(rows):
    return [tuple(map(Fraction, row)) for row in rows]


def search(root, easy, axes, most_depth=12):
    """The nodes of a tree of one root: a leaf where one of the twists `easy`, and few others, holds;
    else the region is halved across that of the axes, functions of motions, along which it is longest."""
    nodes, d = [], root.box.dimension

    def visit(region):
        points = [[Fraction(c, x[d]) for c in x[:d]] for x, _ in region.cone.generators if x[d]]
        mean = [sum(column) / len(points) for column in zip(*points or [[Fraction(0)] * d])]
        largest = max(map(abs, mean)) or 1
        pushed = tuple(Fraction(round(8 * c / largest), 8) for c in mean)
        for y in ((Fraction(0),) * d, pushed, *numbers(easy)):
            try:
                check.check_leaf(region, y)
            except check.Rejected:
                continue
            nodes.append(["leaf", *map(str, y)])
            return
        if region.depth == most_depth:
            raise LookupError
        row = max(numbers(axes), key=lambda row: max(check.dot(row, p) for p in points)
                  - min(check.dot(row, p) for p in points))
        row += (-Fraction(round(check.dot(row, mean) * 1024), 1024),)
        row += (Fraction(0),) * (root.box.coordinates - len(row))
        nodes.append(["plane", *map(str, row)])
        for child in check.children(region, check.Node("plane", -1, row)):
            child.open()
            visit(child)

    visit(check.begin(root))
    return nodes


def box_of(file, options):
    return check.enlarged(posed(file, *options), 128)


def prove(box, part, easy=tuple(EASY), axes=None, low=0, high=0, margin=False):
    """The part, which is not cut, with its tree; in a margin for all multiples from low to high."""
    shape = "simplex" if "simplex" in part else "walls"
    (twist,) = numbers([part["twist"]])
    proof = check.DegreeProof(twist, numbers(part[shape]), numbers(part["direction"]), [], twist,
                              simplex=shape == "simplex")
    tree = []
    with unittest.mock.patch.object(check, "check_tree", lambda _, roots, __: tree.extend(
            node for root in roots for node in search(root, easy, axes or unit(len(twist))))):
        check.check_degree(proof, box, check.Options(), "", Fraction(low), Fraction(high))
    if not margin:  # the last number is that of l
        tree = [node[:-1] if node[0] == "plane" else node for node in tree]
    return {**part, "tree": tree}
