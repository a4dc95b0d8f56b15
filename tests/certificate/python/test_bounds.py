# SPDX-License-Identifier: MIT
"""Bounded motions: proofs of the corpus of rules with a bound and other changes, about which all checkers say the same; and trees that
would be false proofs, which none accepts."""

import collections
import copy
import json
import random
import unittest
from fractions import Fraction

from support import Case, corpus

BOUNDS = [Fraction(1, 1000), Fraction(1, 4), Fraction(1, 2), Fraction(1), Fraction(3, 2), Fraction(2), Fraction(9)]
KINDS = ("plane", "plane_box", "plane_claims", "space", "space_box", "space_margin", "bodies", "bodies_margin", "bodies_space",
         "bodies_soft")


def proofs():
    """Short ones, by kind; without bounds of their own."""
    found = {kind: [one for one in corpus.entries(kind) if one.rule is None and len(json.dumps(one.certificate)) < 1500
                    and "max_motion" not in json.dumps([one.grasp, one.certificate])] for kind in KINDS}
    assert all(found.values())
    return found


NODES = ("slip", "separation", "plane", "leaf", "moving", "part")


def lists_in(content):
    """All that are in a certificate, with the name of what they are in or None."""
    waiting = [(None, content)]
    while waiting:
        name, value = waiting.pop()
        if isinstance(value, list):
            yield name, value
        inside = value.items() if isinstance(value, dict) else [(name, one) for one in value] if isinstance(value, list) else []
        waiting += reversed(list(inside))


def size_of(certificate):
    return len(certificate["question"]["wrench"])


def with_bound(one, bound):
    """The question, asked and stated with a bound; given by the option, or by the file."""
    certificate = copy.deepcopy(one.certificate)
    certificate["question"]["max_motion"] = [str(b) for b in bound]
    if sum(bound) > 4:
        return {**one.grasp, "max_motion": [str(b) for b in bound]}, certificate, one.options
    return one.grasp, certificate, ["--max-motion", ",".join(map(str, bound)), *one.options]


def plane_at(rng, certificate, bound):
    """Where a motion reaches a bound, or nearly."""
    j, sign = rng.randrange(len(bound)), rng.choice((1, -1))
    question = certificate["question"]
    more = 2 if {"direction", "preload_direction"} & set(question) else 1
    row = [0] * (len(bound) + more)
    row[j], row[len(bound)] = -sign, str(sign * bound[j] * rng.choice((1, 1, 1, Fraction(1, 2), 2, -1)))
    return ["plane", *row]


def change(rng, certificate, bound):
    """One, at random."""
    lists = [*lists_in(certificate)]
    trees = [found for _, found in lists
             if found and all(isinstance(node, list) and node and node[0] in NODES for node in found)]
    twists = [found for name, found in lists if name in ("twist", "twists") and not isinstance(found[0], list)]
    kind = rng.randrange(6)
    if not trees or (twists and kind == 0):
        if twists:
            rng.choice(twists)[rng.randrange(len(bound))] = str(rng.choice(bound) * rng.choice((1, -1, Fraction(1001, 1000))))
        return
    tree = rng.choice(trees)
    k = rng.randrange(len(tree))
    if kind < 4 and tree[k][0] == "leaf":
        # What the leaf stands for is cut: of the two children one has the leaf, or both.
        zero, leaf = ["leaf", *[0] * len(bound)], tree[k]
        tree[k:k + 1] = [plane_at(rng, certificate, bound), *rng.choice(([leaf, zero], [leaf, zero], [zero, leaf], [leaf, leaf]))]
    elif tree[k][0] in ("leaf", "moving", "plane"):
        numbers = tree[k]
        numbers[rng.randrange(1, len(numbers) - (numbers[0] == "moving"))] = str(rng.choice((0, 1, -1, Fraction(1, 2))))


class BoundsTest(Case):
    def test_all_say_the_same(self):
        rng = random.Random(8)
        tally = collections.Counter()
        everything = proofs()
        for k in range(300):
            one = rng.choice(everything[KINDS[k % len(KINDS)]])
            bound = [rng.choice(BOUNDS) for _ in range(size_of(one.certificate))]
            if rng.random() < 0.3:
                bound = [9 * b for b in bound]
            file, certificate, options = with_bound(one, bound)
            for _ in range(rng.choice((0, 1, 1, 2))):
                change(rng, certificate, bound)
            _, report, _, _ = self.run_both(file, certificate, *options)
            tally[report["rule"] or report["result"]] += 1
        for rule in ("accepted", "leaf-bound", "witness-bound", "degree-bound"):
            self.assertGreater(tally[rule], 8, tally)

    def test_stable_grasps_are_not_refuted(self):
        """Their equilibrium is within the bound, or on it."""
        rng = random.Random(9)
        tally = collections.Counter()
        stable = [one for kind in ("plane", "space", "bodies", "bodies_soft") for one in proofs()[kind]
                  if "twist" in one.certificate and size_of(one.certificate) <= 6]
        for _ in range(150):
            one = rng.choice(stable)
            bound = [max(abs(Fraction(d)), rng.choice(BOUNDS[:4])) for d in one.certificate["twist"]]
            file, certificate, options = with_bound(one, bound)
            del certificate["twist"], certificate["shares"]
            certificate["verdict"], waiting, tree = "unstable", 1, []
            while waiting:
                if len(tree) < 12 and rng.random() < 0.6:
                    tree.append(plane_at(rng, certificate, bound))
                    waiting += 1
                else:
                    tree.append(["leaf", *(rng.choice((0, 0, 1, -1)) for _ in bound)])
                    waiting -= 1
            _, report, _, _ = self.run_both(file, {**certificate, "tree": tree}, *options)
            self.assertEqual(report["result"], "rejected", (one.name, bound, tree))
            tally[report["rule"]] += 1
        self.assertEqual(set(tally), {"leaf-bound"})


if __name__ == "__main__":
    unittest.main()
