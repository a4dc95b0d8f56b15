# SPDX-License-Identifier: GPL-3.0-or-later
"""Everyday grasps with the numbers that people bring, and how much each can hold, in closed form.

A family makes a hand in a frame of its own, under `share` of the load that friction, or the reach of its feet, can just take.
`placed` turns and moves it at random, in doubles with all their digits. So a body is round, or a load goes through a line, only
up to rounding: below 1 the grasp holds, at rest or tilted; beyond 1 no equilibrium has motions that are small beside the body.
"""

import math

import numpy as np

# Half of a body's size, and the stiffness of its contacts: metres, decimetres, none, millimetres.
UNITS = ((0.03, 2e4), (0.3, 1e5), (1.0, 1.0), (30.0, 20.0), (45.0, 1e3))


class Hand:
    """Contacts (position, normal, preload), forces at points, and a torque."""

    def __init__(self, size, mu, preload=0.0):
        self.size, self.mu, self.preload = size, mu, preload
        self.contacts, self.forces, self.torque = [], [], np.zeros(3)

    def touch(self, position, normal):
        self.contacts.append((np.array(position, float), np.array(normal, float), self.preload))

    def pull(self, force, at=(0, 0, 0)):
        self.forces.append((np.array(force, float), np.array(at, float)))


def around(rng, size, mu):
    """Three to eight fingers around a body; what they hold by friction."""
    hand, count, start = Hand(size, mu, rng.uniform(2, 20)), rng.randint(3, 8), rng.uniform(0, 7)
    for a in (start + 2 * math.pi * k / count for k in range(count)):
        hand.touch((size * math.cos(a), size * math.sin(a), 0), (-math.cos(a), -math.sin(a), 0))
    return hand, count * mu * hand.preload


def lifted(rng, size, mu, share):
    hand, most = around(rng, size, mu)
    hand.pull((0, 0, -share * most))
    return hand


def twisted(rng, size, mu, share):
    hand, most = around(rng, size, mu)
    hand.torque[2] = share * most * size
    return hand


def jaws(rng, size, mu):
    """The two pads of a parallel gripper, rectangles of four contacts; what they hold by friction, and how far corners are."""
    hand, (a, b, w) = Hand(size, mu, rng.uniform(2, 20)), (size * rng.uniform(0.2, 0.6) for _ in range(3))
    for x, y, side in ((x, y, side) for side in (-1, 1) for x in (-a, a) for y in (-b, b)):
        hand.touch((x, y, side * w), (0, 0, -side))
    return hand, 8 * mu * hand.preload, math.hypot(a, b)


def jaws_lifted(rng, size, mu, share):
    hand, most, _ = jaws(rng, size, mu)
    a = rng.uniform(0, 7)
    hand.pull((share * most * math.cos(a), share * most * math.sin(a), 0))
    return hand


def jaws_twisted(rng, size, mu, share):
    hand, most, arm = jaws(rng, size, mu)
    hand.torque[2] = share * most * arm
    return hand


def on_feet(rng, size, mu):
    """A block on four feet; its weight, and how far from its middle it tips along x."""
    hand, (a, b) = Hand(size, mu), (size * rng.uniform(0.3, 1) for _ in range(2))
    for x, y in ((x, y) for x in (-a, a) for y in (-b, b)):
        hand.touch((x, y, 0), (0, 0, 1))
    return hand, rng.uniform(1, 50), a


def pushed_low(rng, size, mu, share):
    """Slides when the push is mu times the weight."""
    hand, weight, reach = on_feet(rng, size, mu)
    height = rng.uniform(0.1, 0.8) * reach / (mu * max(share, 1))
    hand.pull((share * mu * weight, 0, -weight), (0, 0, height))
    return hand


def pushed_high(rng, size, mu, share):
    """Tips when the push, times its height, is the weight times the reach."""
    hand, weight, reach = on_feet(rng, size, mu)
    height = rng.uniform(1.3, 3) * reach / mu * max(share, 1)
    hand.pull((0, 0, -weight), (0, 0, height / 2))
    hand.pull((share * weight * reach / height, 0, 0), (0, 0, height))
    return hand


def on_slope(rng, size, mu, share):
    """Slides when the tangent of the slope is mu."""
    hand, weight, reach = on_feet(rng, size, mu)
    down = np.array((share * mu, 0, -1)) / math.hypot(share * mu, 1)
    hand.pull(weight * down, (0, 0, rng.uniform(0.05, 0.5) * reach / (share * mu)))
    return hand


def pinched(rng, size, mu, share):
    """Two fingers, and a force through their line, but for rounding: the torque about that line nothing opposes."""
    hand = Hand(size, mu, rng.uniform(2, 20))
    for side in (-1, 1):
        hand.touch((side * size, 0, 0), (-side, 0, 0))
    hand.pull((0, share * 2 * mu * hand.preload, 0))
    return hand


FAMILIES = (lifted, twisted, jaws_lifted, jaws_twisted, pushed_low, pushed_high, on_slope, pinched)
# Those that are the same in the plane of two axes, and hold as much there.
FLAT = {twisted: (0, 1), pushed_low: (0, 2), pushed_high: (0, 2), on_slope: (0, 2), pinched: (0, 1)}


def rotation(rng):
    """Any, all alike: that of a quaternion."""
    q = np.array([rng.gauss(0, 1) for _ in range(4)])
    w, v = q[0] / np.linalg.norm(q), q[1:] / np.linalg.norm(q)
    across = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    return np.eye(3) + 2 * w * across + 2 * across @ across


def placed(hand, rng, stiffness, turn=True, axes=(0, 1, 2)):
    """The grasp file of a hand that is turned, and moved by up to five times its size, or as it is; in the plane of two axes."""
    to, axes = rotation(rng) if turn else np.eye(3), list(axes)
    if len(axes) == 2:
        a = rng.uniform(0, 7) * turn
        to = np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]])
    offset = np.array([rng.uniform(-5, 5) * hand.size * turn for _ in axes])
    force, torque = np.zeros(len(axes)), to @ hand.torque if len(axes) == 3 else hand.torque[2]
    for pull, at in hand.forces:
        pull, at = to @ pull[axes], to @ at[axes] + offset
        force, torque = force + pull, torque + np.cross(at, pull)
    contacts = [{"position": (to @ p[axes] + offset).tolist(), "normal": (to @ n[axes]).tolist(), "preload": preload}
                for p, n, preload in hand.contacts]
    return {"format": "stickslip-grasp/2", "defaults": {"friction": hand.mu, "stiffness": stiffness},
            "contacts": contacts, "wrench": np.hstack([force, torque]).tolist()}


def everyday(family, share, rng, turn=True, flat=False):
    """A grasp of a family: friction, size, stiffness, and the frame, as `rng` has it."""
    size, stiffness = rng.choice(UNITS)
    hand = family(rng, size, rng.uniform(0.15, 0.9), share)
    return placed(hand, rng, stiffness, turn, FLAT[family] if flat else (0, 1, 2))


def plain_verdict(answer):
    """What `decide --json` says about motions of the size of the problem: within its bound, where it answers that as well."""
    return answer.get("within", answer)["verdict"]
