# SPDX-License-Identifier: MIT
"""Several bodies (FORMAT.md, sections 14 and 15): trees about soft fingers, and the work of their friction. (What is true of grasps that
can be stated, and which files are malformed, is for tests/rules.)"""

import collections
import random
import unittest
from fractions import Fraction

import naive
import naive_space
from support import Case, certificate

# A pad that slides and turns on the ground, pressed with what does not depend on that: no preload is a matter of motion.
PAD = {
    "format": "stickslip-grasp/3",
    "bodies": [{"name": "x", "slide": [1, 0, 0]}, {"name": "y", "slide": [0, 1, 0], "on": "x"},
               {"name": "pad", "hinge": {"at": [0, 0, 0], "axis": [0, 0, 1]}, "on": "y"}],
    "joints": [{"turns": {name: 1}} for name in ("x", "y", "pad")],
}


class SoftTest(Case):
    """Section 15."""

    def random_tree(self, rng, contacts, leaf, depth):
        kind = rng.choice(["slip", "plane", "plane", "leaf"]) if depth else "leaf"
        if kind == "leaf":
            return [leaf()]
        node = ["slip", rng.randrange(contacts)] if kind == "slip" else ["plane", *(rng.choice([-1, 0, 0, 1]) for _ in range(4))]
        return [node] + [one for _ in range(2) for one in self.random_tree(rng, contacts, leaf, depth - 1)]

    def test_checkers_say_the_same_of_any_tree(self):
        """Loads are near what friction holds, so that leaves hold or not by what is known of slips there."""
        rng, tally = random.Random(15), collections.Counter()
        for _ in range(600):
            contacts = []
            for _ in range(rng.randint(1, 2)):
                length, size = rng.choice([1, 2, 3]), Fraction(rng.randint(-2, 2), 2)
                wide = rng.random() < 0.3
                contacts.append({
                    "of": "pad", "position": [{"min": str(size), "max": str(size + Fraction(1, 8))} if wide else str(size), rng.randint(-1, 1), 0],
                    "normal": [0, 0, length], "friction": {"min": "1/2", "max": "3/4"} if wide else "3/4", "preload": rng.choice([2, 4]),
                    "torsion": rng.choice([0, "1/2", 1, 2])})
            size = Fraction(sum(contact["preload"] for contact in contacts) * 3, 4) * Fraction(rng.randint(8, 14), 10)
            ways = [(Fraction(3, 5), Fraction(4, 5), 0), (Fraction(2, 3), Fraction(-1, 3), Fraction(2, 3)), (0, 0, 1), (1, 0, 0)]
            w = [size * c for c in rng.choice(ways)]

            def leaf():
                return ["leaf", *(str(-c + rng.choice([0, 0, -1, 1, size, -size])) for c in w)]

            w_text = list(map(str, w))
            code, report, _, _ = self.run_both({**PAD, "contacts": contacts, "wrench": w_text}, certificate(
                len(contacts), w_text, tree=self.random_tree(rng, len(contacts), leaf, rng.randint(0, 4))))
            self.assertIn(report["rule"], (None, "leaf-bound", "node-certain"))
            tally["accepted" if code == 0 else "deep" if report["node"] > 2 else "else"] += 1
        self.assertGreater(tally["accepted"], 30, tally)
        self.assertGreater(tally["deep"], 50, tally)

    # The nearest point takes the first slip and the last; who looks for it step by step comes to the second before the last.
    STEPS = ([(4, -1, 0, 1), (0, -9, 1, 1), (8, -5, 1, 1)], (-12, 3, -1), Fraction(1, 2))

    def random_cone(self, rng):
        """Motions and h of rays, a twist, and a torsion."""
        rays = [(*(rng.randint(-2, 2) for _ in range(3)), rng.choice([1, 1, 0])) for _ in range(rng.randint(1, 6))]
        rays += [(*(-c for c in rays[0][:3]), rays[0][3])] * (rng.random() < 0.3)
        return rays, [rng.randint(-2, 2) for _ in range(3)], rng.choice([0, 0, Fraction(1, 2), Fraction(7, 3)])

    def test_friction_does_all_that_it_may_and_no_more(self):
        """A pad that slides and turns across n: each checker refuses a leaf under the load against which the friction of the twin does all
        that it can in a region of motions, and takes it under next to nothing more."""
        frames = [((0, 0, 1), (1, 0, 0), (0, 1, 0)), ((0, -2, 0), (1, 0, 0), (0, 0, 1)),
                  ((1, 2, 2), (Fraction(2, 3), Fraction(-2, 3), Fraction(1, 3)), (Fraction(2, 3), Fraction(1, 3), Fraction(-2, 3)))]
        rng, tally = random.Random(16), collections.Counter()
        for rays, y, torsion in [self.STEPS, *(self.random_cone(rng) for _ in range(250))]:
            n, *across = rng.choice(frames)
            length = naive_space.root_of(Fraction(naive.dot(n, n)))

            def moved(x):
                return *(x[0] * a + x[1] * b for a, b in zip(*across)), *(x[2] * c / length for c in n)

            contact = naive_space.Contact.of_file(n, [(0, 0)] * 3, (Fraction(3, 4),) * 2, (length,) * 2, (1, 1), torsion=torsion)
            region = naive_space.Region([contact], [], [], [(*moved(x), x[3], 0) for x in rays], [naive_space.H], [])
            if not any(y) or region.barred(region.rays):
                continue
            moves = region.moves(0)
            most = contact.alpha(moved(y), region.rays, moves)
            bodies = [{"name": name, "slide": list(map(str, way)), "on": on} for name, way, on in zip("xy", across, ("ground", "x"))]
            bodies += [{"name": "pad", "hinge": {"at": [0, 0, 0], "axis": [str(c / length) for c in n]}, "on": "y"}]
            file = {**PAD, "bodies": bodies, "contacts": [{"of": "pad", "position": [0, 0, 0], "normal": list(n), "friction": "3/4",
                                                           "preload": str(length), "torsion": str(torsion)}]}
            lines, facets = naive.generators([(x, False) for x in rays], 4)
            planes = [*lines, *(tuple(-c for c in line) for line in lines), *facets.values()]
            tree = [*(["plane", *plane] for plane in planes), ["leaf", *y]]
            for more, rule in ((0, "leaf-bound"), (Fraction(1, 10 ** 18), "tree-short")):
                w = [str(-c * (most + more) / naive.dot(y, y)) for c in y]
                report = self.run_both({**file, "wrench": w}, certificate(1, w, tree=tree))[1]
                self.assertEqual(report["rule"], rule, (file, w, tree))
            tally[moves, torsion > 0] += 1
        self.assertGreater(min(tally.values()), 20, tally)
        self.assertEqual(len(tally), 4)


class BodiesTest(Case):
    def test_without_contacts_it_is_in_the_plane(self):
        """However many numbers its wrench has: two bodies have six."""
        two = {"format": "stickslip-grasp/3", "bodies": [{"name": "a"}, {"name": "b"}], "contacts": [], "wrench": [0, 0, 0, 0, 0, 1]}
        self.accepts(two, certificate(0, two["wrench"], tree=[["leaf", 0, 0, 0, 0, 0, -1]]))


if __name__ == "__main__":
    unittest.main()
