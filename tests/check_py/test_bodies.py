# SPDX-License-Identifier: MIT
"""Grasp files of several bodies (FORMAT.md, section 14) that are malformed: where, and what would be right. (What is true of them is
for tests/rules.)"""

import collections
import copy
import random
import unittest
from fractions import Fraction

from support import Case, certificate

HAND = {
    "format": "stickslip-grasp/3",
    "bodies": [{"name": "palm", "slide": [0, 1]}, {"name": "tip", "hinge": [1, 0], "on": "palm"}, {"name": "box"}],
    "joints": [{"turns": {"palm": 1}, "stiffness": 1}, {"turns": {"tip": 1}}],
    "tendons": [{"over": {"palm": 1, "tip": 2}, "tension": 1}],
    "ratchets": [{"over": {"tip": 1}, "stiffness": 1}],
    "contacts": [{"of": "box", "by": "tip", "position": [0, 0], "normal": [0, 1], "friction": 1}],
    "loads": [{"body": "box", "weight": 1, "at": [0, 0]}],
}
STABLE = certificate(4, [0, -1, 0, 0, 0], twist=[0, 0, 0, 0, 0])


def changed(place, value):
    """The hand with another value at a path of members and indices; None removes it."""
    hand = copy.deepcopy(HAND)
    *keys, last = place
    inside = hand
    for key in keys:
        inside = inside[key]
    if value is None:
        del inside[last]
    else:
        inside[last] = value
    return hand


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


class BodiesTest(Case):
    def test_a_hand(self):
        code, report, _, _ = self.run_both(HAND, STABLE)
        self.assertEqual((code, report["rule"]), (1, "witness-balance"))

    def test_places_and_remedies(self):
        loop = [{"name": "palm", "slide": [0, 1], "on": "tip"}, {"name": "tip", "hinge": [1, 0], "on": "palm"}, {"name": "box"}]
        wrench = {"body": "tip", "wrench": [0, 0, 0]}
        for place, value, where, words in (
                (["bodies"], loop, "bodies[0].on", "a body that stands before this one, so that no links are in a loop"),
                (["bodies", 1, "on"], "tip", "bodies[1].on", "a body that stands before this one"),
                (["bodies", 1, "on"], ["palm"], "bodies[1].on", "a body that stands before this one"),
                (["bodies", 2, "on"], "palm", "bodies[2].on", "only a link, with 'hinge' or 'slide', is on a body"),
                (["bodies", 0, "hinge"], [0, 0], "bodies[0]", "give one of them"),
                (["bodies", 0, "slide"], [0, 0], "bodies[0].slide", "must not be zero"),
                (["bodies", 2, "name"], "tip", "bodies[2].name", "of this body alone"),
                (["bodies", 2, "name"], 7, "bodies[2].name", "must be a string"),
                (["bodies"], {}, "bodies", "must be an array"),
                (["joints", 1], None, "bodies[1]", "no joint turns the link 'tip'; name it in 'turns' of one"),
                (["joints", 1, "turns"], {"box": 1}, "joints[1].turns", "'box' is no link (known: palm, tip)"),
                (["joints", 1, "turns"], {"thumb": 1}, "joints[1].turns", "'thumb' is no link (known: palm, tip)"),
                (["joints", 1, "turns", "tip"], 0, "joints[1].turns.tip", "must not be 0; leave the link out"),
                (["joints", 1, "turns"], ["tip"], "joints[1].turns", "such as {\"tip\": 1}"),
                (["joints", 0, "stiffness"], -1, "joints[0].stiffness", "-1 is out of range, must be >= 0"),
                (["ratchets", 0, "stiffness"], 0, "ratchets[0].stiffness", "0 is out of range, must be > 0"),
                (["ratchets", 0, "stiffness"], None, "ratchets[0]", "'stiffness' is missing"),
                (["ratchets", 0, "over"], {}, "ratchets[0].over", "one link or more"),
                (["joints", 0, "turns"], {"palm": 1, "tip": -2}, None, None),
                (["contacts", 0, "by"], "box", "contacts[0].by", "must be another body than that of 'of', or 'ground'"),
                (["contacts", 0, "by"], "thumb", "contacts[0].by", "must be the name of a body or 'ground'"),
                (["contacts", 0, "of"], "ground", "contacts[0].of", "must be the name of a body"),
                (["contacts", 0, "of"], None, "contacts[0]", "'of' is missing"),
                (["contacts", 0, "normal"], [0, 1, 0], "contacts[0].normal", "must be an array of 2"),
                (["contacts", 0, "position"], [0, 0, 0], "bodies[0].slide", "must be an array of 3"),
                (["loads", 0, "body"], "thumb", "loads[0].body", "must be the name of a body"),
                (["loads", 0, "body"], None, "loads[0]", "'body' is missing"),
                (["loads", 0], wrench, "loads[0].wrench", "tip is a link; give a force at a point, a weight or a torque"),
                (["format"], "stickslip-grasp/2", "format", "must be \"stickslip-grasp/3\", as the file has bodies")):
            with self.subTest(place=place, value=value):
                code, report, _, _ = self.run_both(changed(place, value), STABLE)
                if where is None:  # a link may be turned by several joints
                    self.assertEqual(code, 1)
                    continue
                self.assertEqual((code, report["path"]), (2, where))
                self.assertIn(words, report["found"])

    def test_rows_of_zeros(self):
        hand = changed(["joints", 0, "turns"], {"palm": 1, "tip": -2})
        hand["joints"][1]["turns"] = {"tip": 1, "palm": "1/2"}
        hand["tendons"][0]["over"] = {"palm": 2, "tip": 1}
        hand["joints"].pop()
        code, report, _, _ = self.run_both(hand, STABLE)
        self.assertEqual((code, report["path"]), (2, "tendons[0].over"))
        self.assertIn("its numbers cancel, so that no joint moves it", report["found"])

    def test_thirty_coordinates(self):
        for more, code in ((8, 1), (9, 2)):
            hand = changed(["bodies"], HAND["bodies"] + [{"name": str(k)} for k in range(more)])
            hand["joints"] += [{"turns": {"tip": 1}}] * (more == 8)
            zeros = [0] * (5 + 3 * more + (more == 8))
            found, report, _, _ = self.run_both(hand, certificate(4, [0, -1] + zeros[2:], twist=zeros))
            self.assertEqual(found, code, report)
            if code == 2:
                self.assertEqual(report["path"], "bodies")
                self.assertIn("32 coordinates, of bodies and joints; must be at most 30", report["found"])

    def test_as_many_numbers_as_coordinates(self):
        for options in (["--wrench", "0,-1,0"], ["--direction", "0,-1,0,0,0,0"]):
            _, report, _, _ = self.run_both(HAND, STABLE, *options)
            self.assertEqual(report["result"], "malformed")
            self.assertIn("must be 5 as the grasp has", report["found"])

    def test_without_contacts_it_is_in_the_plane(self):
        """However many numbers its wrench has: two bodies have six."""
        two = {"format": "stickslip-grasp/3", "bodies": [{"name": "a"}, {"name": "b"}], "contacts": [], "wrench": [0, 0, 0, 0, 0, 1]}
        self.accepts(two, certificate(0, two["wrench"], tree=[["leaf", 0, 0, 0, 0, 0, -1]]))

    def test_names_are_printed_plainly(self):
        evil = "\x1b[2J\r\u202e"
        hand = changed(["bodies", 1, "name"], evil)
        self.assertEqual(self.run_both(hand, STABLE)[0], 2)
        hand["joints"][1]["turns"] = {evil: 0}
        self.assertEqual(self.run_both(hand, STABLE)[0], 2)


if __name__ == "__main__":
    unittest.main()
