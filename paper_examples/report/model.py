# SPDX-License-Identifier: GPL-3.0-or-later
"""The model's contact rows in exact fractions, apart from the library, to judge what programs print."""

import json
from fractions import Fraction
from typing import NamedTuple


class Contact(NamedTuple):
    position: tuple
    normal: tuple  # a unit vector in all grasps of the paper
    friction: Fraction
    stiffness: Fraction

    @property
    def tangent(self):
        return (-self.normal[1], self.normal[0])

    def row(self, direction):
        """(direction, moment): the wrench of a unit force, and with a motion its displacement."""
        return (*direction, cross(self.position, direction))


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def fractions(values):
    return tuple(Fraction(str(value)) for value in values)


def read_contacts(path):
    with open(path, encoding="utf-8") as file:
        grasp = json.load(file)

    def contact(entry):
        entry = {**grasp["defaults"], **entry}
        return Contact(fractions(entry["position"]), fractions(entry["normal"]),
                       *fractions((entry["friction"], entry["stiffness"])))
    return [contact(entry) for entry in grasp["contacts"]]


def within_cones(contacts, preload, wrench, twist, forces):
    """Eqs. 1-4 with contacts that open: normal springs, friction cones, balance; no dissipation."""
    total = fractions(wrench)
    for contact, force in zip(contacts, map(fractions, forces)):
        spring = preload - contact.stiffness * dot(contact.row(contact.normal), fractions(twist))
        normal, tangential = dot(force, contact.normal), dot(force, contact.tangent)
        if normal != max(0, spring) or abs(tangential) > contact.friction * normal:
            return False
        total = tuple(a + b for a, b in zip(total, contact.row(force)))
    return len(forces) == len(contacts) and total == (0, 0, 0)


def solve3(rows, right):
    """x with rows x = right, by Cramer's rule; the rows are independent."""
    def det(m):
        return dot(m[0], (cross(m[1][1:], m[2][1:]), -cross(m[1][::2], m[2][::2]), cross(m[1], m[2])))

    def replaced(column):
        return [[b if j == column else value for j, value in enumerate(row)] for row, b in zip(rows, right)]
    return tuple(Fraction(det(replaced(column))) / det(rows) for column in range(3))


def torque_free_forces(contacts):
    """Points whose convex hull is the zero-torque slice of the L1 grasp wrench space.

    The space is the hull of the cones' edges at normal force 1 (0 is inside when the grasp is
    closed), so its slice is that of the segments that join two of them.
    """
    edges = [contact.row(tuple(n + side * contact.friction * t for n, t in zip(contact.normal, contact.tangent)))
             for contact in contacts for side in (1, -1)]
    points = {edge[:2] for edge in edges if edge[2] == 0}
    for a in edges:
        for b in edges:
            if a[2] < 0 < b[2]:
                points.add(tuple((b[2] * x - a[2] * y) / (b[2] - a[2]) for x, y in zip(a[:2], b[:2])))
    return points
