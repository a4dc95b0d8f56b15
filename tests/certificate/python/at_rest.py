# SPDX-License-Identifier: MIT
"""Proofs at rest (certificate/FORMAT.md, section 6): a producer in doubles, and the two rules by their
definitions, at all corners of the box together.
"""

import itertools
import math
from fractions import Fraction

from support import check


def solve(matrix, right):
    """matrix^-1 right, of rows, by elimination; of fractions or of doubles."""
    rows = [[*row, *more] for row, more in zip(matrix, right)]
    n = len(rows)
    for j in range(n):
        pivot = max(range(j, n), key=lambda k: abs(rows[k][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        rows[j] = [c / rows[j][j] for c in rows[j]]
        for k in range(n):
            if k != j and rows[k][j]:
                factor = rows[k][j]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[j])]
    return [row[n:] for row in rows]


def tangents(n):
    """Directions of friction at a contact, rational and across each other; in the plane the unit is T."""
    if len(n) == 2:
        return [(Fraction(1),)]
    k = min(range(3), key=lambda j: abs(n[j]))

    def cross(a, b):
        return tuple(a[j - 2] * b[j - 1] - a[j - 1] * b[j - 2] for j in range(3))

    first = cross(n, [Fraction(j == k) for j in range(3)])
    return [first, cross(n, first)]


class Grasp:
    """Of a box: its parameters, as check.py reads them, and what follows at one of its points."""

    def __init__(self, question, bits=128):
        self.box = check.enlarged(question, bits)
        self.size = self.box.dimension
        self.growth = self.box.growths[0]
        self.uncertain = [(i, name) for i, c in enumerate(self.box.contacts)
                          for name, number in c.bounds.items() if not number.certain]
        self.uncertain += [(k, "wrench") for k, w in enumerate(self.box.loads.bounds) if not w.certain]

    def at(self, values, multiple=0):
        """(w, contacts) for the values of uncertain parameters: contacts as (p, n, t, mu, P')."""
        contacts = []
        for i, c in enumerate(self.box.contacts):
            x = {name: values.get((i, name), number.low) for name, number in c.bounds.items()}
            p = [x["x"], x["y"]] + [x[name] for name in ("z",) if name in x]
            n = c.normal
            if len(n) == 2:
                n = (n[0] - x["turn"] * n[1], n[1] + x["turn"] * n[0])
            low, high = c.bounds["preload"]
            share = (x["preload"] - low) / (high - low) if low < high else 0  # both ends go together
            growth = c.growth.low + share * (c.growth.high - c.growth.low)
            contacts.append((p, n, x["friction"], x["preload"] + multiple * growth))
        return [values.get((k, "wrench"), w.low) + multiple * u
                for k, (w, u) in enumerate(zip(self.box.loads.bounds, self.growth))], contacts

    def wrench(self, contact, force):
        p, n = contact[:2]
        return check.at(p, force if len(n) == 3 else (-n[1] * force[0], n[0] * force[0]))

    def corners(self, of=None):
        """Of all parameters, or of those of one contact."""
        uncertain = [one for one in self.uncertain if of is None or one[0] == of and one[1] != "wrench"]
        ends = [(self.box.loads.bounds[i] if name == "wrench" else self.box.contacts[i].bounds[name])
                for i, name in uncertain]
        for choice in itertools.product(*ends):
            yield dict(zip(uncertain, choice))

    def middle(self):
        return {(i, name): (self.box.loads.bounds[i] if name == "wrench" else
                            self.box.contacts[i].bounds[name]).middle.low for i, name in self.uncertain}

    def left(self, proof, values, multiple=0, of=None):
        """W and M, by rows, at one point; or what one contact adds to them."""
        load, contacts = self.at(values, multiple)
        total, matrix = [c * (of is None) for c in load], [[Fraction(0)] * self.size for _ in load]

        def add(k, contact, force):
            for row, c in zip(matrix, self.wrench(contact, force)):
                row[k] += c

        for contact in contacts if of is None else contacts[of:of + 1]:
            total = [a + contact[3] * b for a, b in zip(total, check.at(contact[0], contact[1]))]
        for i, force in (entry for entry in proof["rest"] if of in (None, entry[0])):
            total = [a + b for a, b in zip(total, self.wrench(contacts[i], vector(force)))]
        for i, forces in (entry for entry in proof["answers"] if of in (None, entry[0])):
            for k, force in enumerate(forces):
                add(k, contacts[i], vector(force))
        return total, matrix

    def needed(self, proof, multiples=(0,), together=False):
        """What Z has to be at least for this Z: by rest-reach. Contact by contact, or of all parameters
        together, which takes long if they are many."""
        reach, needed = list(map(Fraction, proof["reach"])), []
        most = [[0] * (1 + self.size) for _ in reach]  # of |W_k| and the |M_kl - 1_kl|
        for multiple in multiples:
            if together:
                ends = [[self.flat(proof, values, multiple)] * 2 for values in self.corners()]
            else:
                load = [(w[0] + multiple * u, w[1] + multiple * u) for w, u in zip(self.box.loads.bounds, self.growth)]
                unit = [[-int(j == k) for j in range(self.size)] for k in range(self.size)]
                ends = [[[[w[end], *row] for w, row in zip(load, unit)] for end in (0, 1)]]
                for i in range(len(self.box.contacts)):
                    found = [self.flat(proof, values, multiple, i) for values in self.corners(i)]
                    for end, extreme in ((0, min), (1, max)):
                        ends[0][end] = [[c + extreme(one[k][j] for one in found) for j, c in enumerate(row)]
                                        for k, row in enumerate(ends[0][end])]
            for low, high in ends:
                most = [[max(a, -b, c) for a, b, c in zip(*rows)] for rows in zip(most, low, high)]
        for row in most:
            needed.append(row[0] + sum(c * z for c, z in zip(row[1:], reach)))
        return needed

    def flat(self, proof, values, multiple, of=None):
        """W and M, of all contacts M - 1, in rows."""
        total, matrix = self.left(proof, values, multiple, of)
        return [[c, *(b - (j == k and of is None) for j, b in enumerate(row))]
                for k, (c, row) in enumerate(zip(total, matrix))]

    def room(self, proof, multiples=(0,)):
        """rest-cone, in doubles: what is left of the cone, in parts of its size, where that is least."""
        reach, rooms = [float(Fraction(z)) for z in proof["reach"]], [1]
        rest, answers = dict(map(tuple, proof["rest"])), dict(map(tuple, proof["answers"]))
        for i in {*rest, *answers}:
            c = self.box.contacts[i]
            used = length(rest.get(i, 0)) + sum(map(lambda f, z: length(f) * z, answers.get(i, []), reach))
            size = min(float(c.bounds["friction"].low * (c.bounds["preload"].low + multiple * c.growth.low))
                       for multiple in multiples) * (length(c.normal) if self.size == check.SPACE else 1)
            rooms.append((size - used) / size if size else -used)
        return min(rooms)

    def shares(self, proof, values, multiple=0):
        """Of the equilibrium at rest at this point: by M z = -W; and the twist is 0."""
        total, matrix = self.left(proof, values, multiple)
        z = [row[0] for row in solve(matrix, [[-c] for c in total])]
        assert all(abs(a) <= Fraction(b) for a, b in zip(z, proof["reach"]))
        rest, answers = dict(map(tuple, proof["rest"])), dict(map(tuple, proof["answers"]))
        found = []
        for i, (_, n, mu, push) in enumerate(self.at(values, multiple)[1]):
            force = vector(rest.get(i, [0] * 3 if len(n) == 3 else 0))
            for f, c in zip(answers.get(i, []), z):
                force = check.plus(force, c, vector(f))
            if mu * push:
                share = [str(f / (mu * push)) for f in force]
                found.append([i, share if len(n) == 3 else share[0]])
            else:
                assert not any(force)
        return found


def vector(force):
    return tuple(map(Fraction, force if isinstance(force, (list, tuple)) else [force]))


def length(force):
    return math.hypot(*map(float, vector(force)))


def proof_at_rest(question, bearing=None, multiples=(0,), bits=20, bits_of_lengths=128):
    """A PART, which need not be good enough: f0 by least squares for the middle of load and multiples, and a
    right inverse for G, rounded to so many bits behind the point; Z is twice what rest-reach asks."""
    grasp = Grasp(question, bits_of_lengths)
    middle = grasp.middle()
    load, contacts = grasp.at(middle, Fraction(sum(multiples)) / len(multiples))
    bearing = range(len(contacts)) if bearing is None else bearing
    ways = [(i, t, math.hypot(*map(float, t))) for i in bearing for t in tangents(contacts[i][1])]
    columns = [[float(c) / size for c in grasp.wrench(contacts[i], t)] for i, t, size in ways]
    for contact in contacts:
        load = [a + contact[3] * b for a, b in zip(load, check.at(contact[0], contact[1]))]
    square = [[sum(c[k] * c[j] for c in columns) for j in range(grasp.size)] for k in range(grasp.size)]
    unit = [[float(j == k) for j in range(grasp.size)] for k in range(grasp.size)]
    inverse = solve(square, unit)

    def forces(wrench):
        """The least friction that adds up to it: of each bearing contact, across its normal."""
        by = [sum(inverse[k][j] * wrench[j] for j in range(grasp.size)) for k in range(grasp.size)]
        found = {i: (Fraction(0),) * len(tangents(contacts[i][1])[0]) for i in bearing}
        for (i, t, size), column in zip(ways, columns):
            along = Fraction(round(sum(c * b for c, b in zip(column, by)) / size * 2 ** bits), 2 ** bits)
            found[i] = check.plus(found[i], along, t)
        return {i: [str(c) for c in f] if len(f) == 3 else str(f[0]) for i, f in found.items()}

    rest = forces([-float(c) for c in load])
    answers = [forces(row) for row in unit]
    proof = {"rest": [[i, rest[i]] for i in bearing],
             "answers": [[i, [answer[i] for answer in answers]] for i in bearing], "reach": [0] * grasp.size}
    for _ in range(3):
        # Lengths are known within an interval, also those of what the preloads gain.
        proof["reach"] = [str(short_above(2 * c + Fraction(1, 2 ** 60))) for c in grasp.needed(proof, multiples)]
    return proof


def short_above(x):
    """Of ten bits or so."""
    if x == 0:
        return x
    unit = Fraction(2) ** (x.numerator.bit_length() - x.denominator.bit_length() - 10)
    return -(-x // unit) * unit
