# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies in doubles, and Newton's method for their equilibria from many random starts.

Written from mechanics and not from the rows of the program: how points move follows from kinematics, body by body and
joint by joint; what forces do to free bodies and joints from statics. That the one is the other turned over, by the
principle of virtual work, is checked for each contact.

Unknown are the motion z and the friction t of every contact. They are an equilibrium if all balances and if each t is
the point of its disc (in the plane an interval) |t| <= mu a that is nearest to t - r s, with the slip s, a normal force
a = max(0, P - k n.d) and any r > 0: then t is in the disc, and where s is not 0 it is mu a long and against s. Of a soft
finger a turn about the normal times its torsion e is a further number of s, and the moment over e one of t."""

from fractions import Fraction as F

import numpy as np


def number(x):
    return float(F(str(x)))


def numbers(row):
    return np.array([number(x) for x in row])


def cross(a, b):
    """The torque of b at a; in the plane a number."""
    return np.array([a[0] * b[1] - a[1] * b[0]]) if len(a) == 2 else np.cross(a, b)


class Mechanics:
    """Contacts as rows (normal, slips), what their forces do (pressing, rubbing), and laws; springs; the load."""

    def __init__(self, grasp):
        self.bodies = {b["name"]: b for b in grasp["bodies"]}
        self.joints = grasp.get("joints", [])
        contacts = [{"stiffness": 1, "preload": 0, "torsion": 0, **grasp.get("defaults", {}), **c} for c in grasp["contacts"]]
        self.dim = len(contacts[0]["position"]) if contacts else 2
        self.turns = 1 if self.dim == 2 else 3
        self.first, count = {}, 0
        for name, body in self.bodies.items():
            if "hinge" not in body and "slide" not in body:
                self.first[name], count = count, count + self.dim + self.turns
        self.joint, self.count = count, count + len(self.joints)
        self.load = np.zeros(self.count)
        if "wrench" in grasp:
            self.load += numbers(grasp["wrench"])
        for load in grasp.get("loads", []):
            self.load += self.pull(load)
        normals = [numbers(c["normal"]) for c in contacts]
        units, places = [n / np.linalg.norm(n) for n in normals], [numbers(c["position"]) for c in contacts]
        self.friction, self.stiffness, self.preload, torsion = (
            numbers([c[key] for c in contacts]) for key in ("friction", "stiffness", "preload", "torsion"))
        moves = [self.speed(c["of"], p) - self.speed(c.get("by"), p) for c, p in zip(contacts, places)]
        pushes = [self.push(c["of"], p) - self.push(c.get("by"), p) for c, p in zip(contacts, places)]
        across = [np.linalg.svd(n[None, :])[2][1:] for n in units]
        m, soft = len(contacts), bool(np.any(torsion))
        self.across = self.dim - 1 + soft
        self.normal = np.array([n @ move for n, move in zip(units, moves)]).reshape(m, self.count)
        self.pressing = np.array([push @ n for n, push in zip(units, pushes)]).reshape(m, self.count)
        slips, rubbing = ([t @ move for t, move in zip(across, moves)], [push @ t.T for t, push in zip(across, pushes)])
        if soft:
            for i, (c, n, e) in enumerate(zip(contacts, units, torsion)):
                slips[i] = np.vstack([slips[i], e * n @ (self.spin(c["of"]) - self.spin(c.get("by")))])
                rubbing[i] = np.column_stack([rubbing[i], e * (self.twist(c["of"], n) - self.twist(c.get("by"), n))])
        self.slips = np.array(slips).reshape(m, self.across, self.count)
        self.rubbing = np.array(rubbing).reshape(m, self.count, self.across)
        for one, other in ((self.normal, self.pressing), (self.slips.transpose(0, 2, 1), self.rubbing)):
            assert np.allclose(one, other, atol=1e-12 * (1 + np.abs(other).max(initial=0)))
        self.springs = []  # row of joints, stiffness, force, pushes only
        for k, joint in enumerate(self.joints):
            row = np.zeros(self.count)
            row[self.joint + k] = 1
            self.springs.append((row, number(joint.get("stiffness", 0)), number(joint.get("torque", 0)), False))
        for key, force, only in (("tendons", "tension", False), ("ratchets", "preload", True)):
            for spring in grasp.get(key, []):
                row = sum(number(arm) * self.rate(link) for link, arm in spring["over"].items())
                self.springs.append((row, number(spring.get("stiffness", 0)), number(spring.get(force, 0)), only))
        self.lengths = max([1e-9, *(np.abs(p).max() for p in places)])
        force_rows = [f for f in range(self.count) if not self.is_turn(f)]
        self.size = max([np.abs(self.load[force_rows]).max(initial=0), np.abs(self.load).max() / self.lengths,
                         *self.preload, *(abs(s[2]) / self.lengths for s in self.springs)])

    def is_turn(self, coordinate):
        if coordinate < self.joint:
            return coordinate % (self.dim + self.turns) >= self.dim
        return any("hinge" in self.bodies[link] for link in self.joints[coordinate - self.joint]["turns"])

    def rate(self, link):
        """How fast joints turn the link itself, as a row."""
        row = np.zeros(self.count)
        for k, joint in enumerate(self.joints):
            row[self.joint + k] = number(joint["turns"].get(link, 0))
        return row

    def outboard(self, name):
        """The links from the body down to the ground or to a free body, and that one."""
        chain = []
        while name not in (None, "ground") and name not in self.first:
            chain.append(name)
            name = self.bodies[name].get("on")
        return chain, None if name == "ground" else name

    def hinge(self, link):
        """A point and the axis; in the plane that is 1."""
        hinge = self.bodies[link]["hinge"]
        return (numbers(hinge), np.ones(1)) if self.dim == 2 else (numbers(hinge["at"]), numbers(hinge["axis"]))

    def speed(self, name, p):
        """Of the point p of a body: a row for each coordinate."""
        rows = np.zeros((self.dim, self.count))
        chain, free = self.outboard(name)
        if free is not None:
            at = self.first[free]
            rows[:, at:at + self.dim] = np.eye(self.dim)
            for j in range(self.turns):
                omega = np.eye(self.turns)[j]
                rows[:, at + self.dim + j] = omega[0] * np.array([-p[1], p[0]]) if self.dim == 2 else np.cross(omega, p)
        for link in chain:
            if "slide" in self.bodies[link]:
                move = numbers(self.bodies[link]["slide"])
            else:
                c, axis = self.hinge(link)
                move = np.array([c[1] - p[1], p[0] - c[0]]) if self.dim == 2 else np.cross(axis, p - c)
            rows += np.outer(move, self.rate(link))
        return rows

    def spin(self, name):
        """How fast a body in space turns: a row for each axis."""
        rows = np.zeros((3, self.count))
        chain, free = self.outboard(name)
        if free is not None:
            rows[:, self.first[free] + 3:self.first[free] + 6] = np.eye(3)
        for link in chain:
            if "hinge" in self.bodies[link]:
                rows += np.outer(self.hinge(link)[1], self.rate(link))
        return rows

    def twist(self, name, torque):
        """What a torque on a body does to free bodies and joints."""
        total = np.zeros(self.count)
        chain, free = self.outboard(name)
        if free is not None:
            at = self.first[free] + self.dim
            total[at:at + self.turns] += torque
        for link in chain:
            if "hinge" in self.bodies[link]:
                total += self.hinge(link)[1] @ torque * self.rate(link)
        return total

    def push(self, name, p):
        """What a force at the point p of a body does to free bodies and joints, by columns."""
        columns = np.zeros((self.count, self.dim))
        chain, free = self.outboard(name)
        for j in range(self.dim):
            f = np.eye(self.dim)[j]
            if free is not None:
                at = self.first[free]
                columns[at:at + self.dim + self.turns, j] += np.concatenate([f, cross(p, f)])
            for link in chain:
                if "slide" in self.bodies[link]:
                    part = numbers(self.bodies[link]["slide"]) @ f
                else:
                    c, axis = self.hinge(link)
                    part = axis @ cross(p - c, f)
                columns[:, j] += part * self.rate(link)
        return columns

    def pull(self, load):
        total = np.zeros(self.count)
        if "wrench" in load:
            at = self.first[load["body"]]
            total[at:at + self.dim + self.turns] = numbers(load["wrench"])
        elif "torque" in load:
            total += self.twist(load["body"], numbers([load["torque"]] if self.dim == 2 else load["torque"]))
        else:
            force = numbers(load.get("force", load.get("direction", [*[0] * (self.dim - 1), -1])))
            if "weight" in load:
                force *= number(load["weight"]) / np.linalg.norm(force)
            total += self.push(load["body"], numbers(load["at"])) @ force
        return total


class Residual:
    """Balance and laws of many z and t at once, with their slopes, in units of the load. Of the bilateral law the normal force is
    P - k n.d, which has to be 0 or more where it is solved."""

    def __init__(self, mechanics, bilateral=False):
        self.of = m = mechanics
        self.bilateral = bilateral
        self.contacts, self.across = len(m.friction), m.across
        self.n = m.count + self.contacts * self.across
        soft = np.median(m.stiffness) if self.contacts else 1
        turn = np.array([m.is_turn(j) for j in range(m.count)], dtype=bool)
        self.rows = np.where(turn, 1 / m.lengths, 1) / m.size  # of the balance
        self.unit = np.concatenate([m.size / soft * np.where(turn, 1 / m.lengths, 1),
                                    np.full(self.contacts * self.across, m.size)])

    def __call__(self, x, rounding):
        """max(0, v) is (v + hypot(v, rounding)) / 2, by start, which pulls on contacts that are open."""
        m, s, q, c = self.of, len(x), self.across, self.contacts
        x = x * self.unit
        z, t = x[:, :m.count], x[:, m.count:].reshape(s, c, q)
        balance = np.tile(m.load, (s, 1))
        slope = np.zeros((s, self.n, self.n))
        for row, k, force, only in m.springs:
            pull = force - k * z @ row
            on = (pull > 0) | (not only) | self.bilateral
            balance += (pull * on)[:, None] * row
            slope[:, :m.count, :m.count] -= on[:, None, None] * k * np.outer(row, row)
        # Of all contacts at once, by start, contact and direction of slip.
        v, soft = m.preload - m.stiffness * (z @ m.normal.T), np.maximum(rounding * m.size, 1e-200)[:, None]
        if self.bilateral:
            a, closed = v, np.ones((s, c))
        else:
            far, sharp = np.hypot(v, soft), (rounding == 0)[:, None]
            a, closed = np.where(sharp, np.maximum(v, 0), (v + far) / 2), np.where(sharp, v > 0, (1 + v / far) / 2)
        rubbing, slips = (rows.reshape(c * q, m.count) for rows in (m.rubbing.transpose(0, 2, 1), m.slips))
        balance += a @ m.pressing + t.reshape(s, c * q) @ rubbing
        rise = -(m.stiffness * closed)[:, :, None] * m.normal  # of a
        slope[:, :m.count, :m.count] += m.pressing.T @ rise
        slope[:, :m.count, m.count:] = rubbing.T
        r, most = m.stiffness[:, None], m.friction * a
        u = t - r * (z @ slips.T).reshape(s, c, q)
        long = np.sqrt(np.sum(u * u, axis=2))
        free = long > most  # it slips
        unit = u / np.maximum(long, 1e-300)[:, :, None]
        laws = t - np.where(free[:, :, None], most[:, :, None] * unit, u)
        ratio = np.where(free, most / np.maximum(long, 1e-300), 1)
        by_u = ratio[:, :, None, None] * (np.eye(q) - free[:, :, None, None] * unit[:, :, :, None] * unit[:, :, None, :])
        for i in range(c):
            at = slice(m.count + i * q, m.count + (i + 1) * q)
            slope[:, at, at] = np.eye(q) - by_u[:, i]
        slope[:, m.count:, :m.count] = (r[:, :, None] * by_u @ m.slips - ((free * m.friction)[:, :, None] * unit)[:, :, :, None]
                                        * rise[:, :, None, :]).reshape(s, c * q, m.count)
        total = np.hstack([balance * self.rows, laws.reshape(s, c * q) / m.size])
        slope[:, :m.count] *= self.rows[:, None]
        slope[:, m.count:] /= m.size
        return total, slope * self.unit


NEAR = 1e-9  # the residual of an equilibrium is at most this times the load and preloads


def solve(residual, x, rounding, steps):
    """Levenberg's and Marquardt's variant, each start with a damping of its own; and what is left."""
    damping = np.full(len(x), 1e-3)
    total, slope = residual(x, rounding)
    least = np.sum(total * total, axis=1)
    for _ in range(steps):
        if np.all(least < (NEAR / 1000) ** 2):
            break  # all are found
        turned = slope.transpose(0, 2, 1)
        square = turned @ slope
        lift = damping * (1e-3 + np.trace(square, axis1=1, axis2=2) / residual.n)
        move = np.linalg.solve(square + lift[:, None, None] * np.eye(residual.n), -(turned @ total[:, :, None]))
        there, steeper = residual(x + move[:, :, 0], rounding)
        found = np.sum(there * there, axis=1)
        better = found < least
        x = np.where(better[:, None], x + move[:, :, 0], x)
        total, least = np.where(better[:, None], there, total), np.where(better, found, least)
        slope = np.where(better[:, None, None], steeper, slope)
        damping = np.clip(np.where(better, damping / 5, damping * 4), 1e-13, 1e6)
    return x, np.sqrt(least)


def from_random(residual, starts, rng):
    """The equilibria that are found from random starts."""
    x = rng.normal(size=(starts, residual.n)) * rng.choice([0.01, 0.1, 1, 10, 100], size=(starts, 1))
    roundest = 8.0 ** rng.uniform(-6, 1, size=starts)
    for most in 8.0 ** -np.arange(-1, 6):
        x, _ = solve(residual, x, np.minimum(roundest, most), 8)
    x, off = solve(residual, x, np.zeros(starts), 40)
    return x[off < NEAR]


def finds(grasp, starts=60, seed=1):
    """Whether an equilibrium is found from one of these many starts. A few are tried first, as one is enough."""
    mechanics, rng, few = Mechanics(grasp), np.random.default_rng(seed), min(6, starts)
    return mechanics.size == 0 or any(count and len(from_random(Residual(mechanics), count, rng)) for count in (few, starts - few))


def equilibria(grasp, starts, rng):
    """From how many random starts an equilibrium is found, and of those, how many are found again after each of three small
    changes of the load, as no tie would be."""
    mechanics = Mechanics(grasp)
    if mechanics.size == 0:
        return starts, starts
    residual = Residual(mechanics)
    x = from_random(residual, starts, rng)
    stays, load = np.ones(len(x), dtype=bool), mechanics.load
    for _ in range(3 if len(x) else 0):
        mechanics.load = load + 100 * NEAR * mechanics.size * rng.normal(size=len(load)) * (load != 0)
        stays &= solve(residual, x, np.zeros(len(x)), 40)[1] < NEAR
    mechanics.load = load
    return len(x), int(np.sum(stays))
