# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft fingers, whose friction resists a turn about the normal: thresholds in closed form from both sides, every verdict
through all checkers that judge it."""

import unittest
from fractions import Fraction as F

from test_bodies import Bodies, contact, force, grasp, text, weight


def torque(body, about):
    return {"body": body, "torque": text(about)}


def pinch(load, e, mu=F(1, 2), preload=10, length=1):
    """A body between two fingers at (-2, 0, 0) and (2, 0, 0)."""
    return grasp(["cap"], [contact("cap", (2 * s, 0, 0), (-s * length, 0, 0), friction=mu, preload=preload, torsion=e) for s in (-1, 1)],
                 load)


def on_a_table(e, load, place=(0, 0, 0), length=1, mu=F(1, 2), preload=2, springs=()):
    """A plate that slides along x and y and turns about the origin, on one soft finger; with springs along x, y and the turn."""
    bodies = [{"name": "x", "slide": [1, 0, 0]}, {"name": "y", "slide": [0, 1, 0], "on": "x"},
              {"name": "plate", "on": "y", "hinge": {"at": [0, 0, 0], "axis": [0, 0, 1]}}]
    joints = [{"turns": {b["name"]: 1}} for b in bodies]
    for joint, stiffness in zip(joints, springs):
        joint["stiffness"] = text(stiffness)
    return grasp(bodies, [contact("plate", place, (0, 0, length), friction=mu, preload=preload, torsion=e)],
                 [force("plate", (*load[:2], 0), (0, 0, 0)), torque("plate", (0, 0, load[2]))], joints=joints)


class ClosedForms(Bodies):
    def test_a_pinched_body_off_its_centre(self):
        # Each finger carries 3 of 5, and so a moment of 4 e at most: both together 6 times the arm.
        for e, length in ((F(1, 2), 1), (F(3), F(2, 3)), (F(1, 7), 10**6 + 3)):
            self.assert_threshold(lambda y, e=e, length=length: pinch([weight("cap", 6, (0, y, 0))], e, length=length), 8 * e / 6)
        # Without torsion nothing holds it but at its centre.
        self.assertEqual(self.verdict(pinch([weight("cap", 6, (0, F(1, 10**6), 0))], 0)), "unstable")
        self.assertEqual(self.verdict(pinch([weight("cap", 6, (0, 0, 0))], 0)), "stable")

    def test_friction_is_an_ellipsoid_of_forces_and_moment(self):
        # A plate under a force and a torque: |f|^2 + (t / e)^2 is at most mu^2 P^2, which is 1.
        for e, length in ((F(2), 1), (F(1, 3), F(5, 2))):
            for fx, fy, t in ((F(2, 3), F(2, 3), F(1, 3)), (F(-2, 7), F(3, 7), F(6, 7)), (0, 0, 1), (F(3, 5), F(-4, 5), 0)):
                self.assert_threshold(lambda part, e=e, n=length, w=(fx, fy, t):
                                      on_a_table(e, (part * w[0], part * w[1], part * w[2] * e), length=n), F(1))

    def test_a_finger_beside_the_axis_resists_as_the_hypotenuse(self):
        # It slips by R and spins by 1 for each turn: the torque is mu P sqrt(R^2 + e^2).
        def hinged(t, arm, e):
            return grasp([{"name": "plate", "hinge": {"at": [0, 0, 0], "axis": [0, 0, 1]}}],
                         [contact("plate", (arm, 0, 0), (0, 0, 1), friction=F(1, 2), preload=2, torsion=e)],
                         [torque("plate", (0, 0, t))], joints=[{"turns": {"plate": 1}}])
        for arm, e, most in ((3, 4, 5), (5, 12, 13), (0, 2, 2), (2, 0, 2)):
            self.assert_threshold(lambda t, arm=arm, e=e: hinged(t, arm, e), F(most))

    def test_slips_are_along_the_friction_that_springs_leave(self):
        # With springs the plate moves under every load, and where it slips friction is against it, all in one proportion:
        # the load beyond the threshold is carried by springs.
        for w in ((3, 0, 0), (2, -2, 1), (-1, 2, 5), (F(1, 3), F(1, 2), F(-7, 2))):
            self.assertEqual(self.verdict(on_a_table(F(1, 2), w, springs=(1, 2, 3))), "stable")
        # Without the spring of the turn friction alone carries the torque, at most e, however the plate slips beside.
        for w in ((0, 0), (3, -1), (F(1, 5), F(2, 5))):
            self.assert_threshold(lambda t, w=w: on_a_table(F(2, 5), (*w, t), springs=(1, 2, 0)), F(2, 5))

    def test_boxes(self):
        # With e = 1 and the weight 27/5 each finger has 27/10 and moments of 27/10 y; it may have 9/2 where friction is least,
        # and 11/2 where it is most: moments of 18/5, and of 4.79.
        for y, verdict in ((F(4, 3), "stable"), (F(5, 3), "fragile"), (F(9, 5), "unstable")):
            at = pinch([weight("cap", F(27, 5), (0, y * F(99, 100) if verdict == "stable" else y, 0))], F(1))
            self.assertEqual(self.verdict(at, "--uncertain", "friction=10%"), verdict)
        self.assertEqual(self.verdict(pinch([weight("cap", 6, (0, F(6, 5), 0))], F(1)), "--uncertain", "position=0.001,preload=5%"),
                         "stable")

    def test_margins(self):
        file, proof = self.write("g.json", pinch([], F(1, 2))), self.path("m.json")
        words = ("--direction", "0,0,-1,-1/2,0,0")
        answer = self.json("margin", file, *words, "--certificate", proof, "--accuracy", "1/1000")
        low, high = answer["resisted"][0]
        self.assertEqual(F(low), 0)
        self.assertTrue(199 < 4 * F(high) ** 2 < 200, high)  # w^2 (1 + (arm / e)^2) <= (2 mu P)^2
        self.assertGreater(4 * F(answer["refuted"][0][0]) ** 2, 200)
        self.accepted(file, proof, *words)


if __name__ == "__main__":
    unittest.main()
