# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads pictures back: SVG as numbers. Standard library only."""

import json
import math
import os
import re
import subprocess
import xml.etree.ElementTree as ET
from fractions import Fraction

STICKSLIP = os.environ.get("STICKSLIP", "stickslip")
NUMBER = r"-?\d+(?:\.\d{1,2})?"


def stickslip(*words, stdin=None):
    """Exit code, standard output, standard error."""
    result = subprocess.run([STICKSLIP, *map(str, words)], input=stdin, capture_output=True,
                            check=False, timeout=120,
                            **({} if isinstance(stdin, bytes) else {"text": True}))
    return result.returncode, result.stdout, result.stderr


def exact(value):
    return value if isinstance(value, Fraction) else Fraction(str(value))


class Contact:
    """With exact numbers, as a grasp file has it."""

    def __init__(self, entry, defaults):
        self.position = tuple(map(exact, entry["position"]))
        self.normal = tuple(map(exact, entry["normal"]))
        get = lambda key, other: exact(entry.get(key, defaults.get(key, other)))
        self.preload, self.friction = get("preload", 0), get("friction", 0)

    def slip(self, d):
        """A positive multiple of the slip under the motion d."""
        (px, py), (nx, ny) = self.position, self.normal
        return -ny * (d[0] - d[2] * py) + nx * (d[1] + d[2] * px)


def contacts_of(grasp):
    return [Contact(entry, grasp.get("defaults", {})) for entry in grasp["contacts"]]


class Picture:
    def __init__(self, svg):
        self.svg = svg
        self.root = ET.fromstring(svg)
        self.style = self.root.find("{*}style").text

    def all(self, css_class, **attributes):
        """Elements of a class outside of the legend, with these data- attributes."""
        key = {id(e) for group in self.root.iter() if "key" in group.get("class", "").split()
               for e in group.iter()}
        return [e for e in self.root.iter()
                if css_class in e.get("class", "").split() and id(e) not in key
                and all(e.get("data-" + k) == v for k, v in attributes.items())]

    def texts(self):
        return ["".join(e.itertext()) for e in self.root.iter() if e.tag.endswith("}text")]


def subpaths(element):
    """Lists of points; circles (arcs) as the points between which they run."""
    found = []
    for command, numbers in re.findall(r"([MLAZ])([^MLAZ]*)", element.get("d")):
        values = list(map(float, re.findall(NUMBER, numbers)))
        if command == "M":
            found.append([])
        if command != "Z":
            found[-1].append(complex(*values[-2:]))
    return found


def arrow(element):
    """Tail and tip on the page, as complex numbers, y down."""
    (tail, _neck), (tip, _left, _right) = subpaths(element)
    return tail, tip


def value(element):
    return [Fraction(part) for part in element.get("data-value").split(",")]


def contains(polygon, p):
    inside = False
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        if (a.imag > p.imag) != (b.imag > p.imag):
            inside ^= p.real < a.real + (b.real - a.real) * (p.imag - a.imag) / (b.imag - a.imag)
    return inside


def area(polygon):
    return abs(sum((a.conjugate() * b).imag
                   for a, b in zip(polygon, polygon[1:] + polygon[:1]))) / 2


class Discs:
    """The two discs of a states plot, and the motions that they show."""

    def __init__(self, picture):
        self.discs = [(complex(float(e.get("cx")), float(e.get("cy"))), float(e.get("r")))
                      for e in picture.all("rim")]
        group, = picture.all("cells")
        self.centre = list(map(Fraction, group.get("data-centre").split(",")))
        self.radius = Fraction(group.get("data-radius"))

    def motion(self, disc, page):
        """The motion (x, y, r) of the object frame's origin that is drawn at a place; scaled."""
        centre, size = self.discs[disc]
        offset = (page - centre) / size
        u, v = offset.real, -offset.imag
        # Lambert: (u, v) = (-y, x) / sqrt(1 + r) on the unit sphere.
        r = 1 - (u * u + v * v)
        scale = math.sqrt(1 + r)
        x, y = v * scale, -u * scale
        if disc == 1:
            x, y, r = -x, -y, -r
        # (x, y) moves the point `centre`, and r is in units of 1 / radius.
        turn = Fraction(r) / self.radius
        return (Fraction(x) + turn * self.centre[1], Fraction(y) - turn * self.centre[0], turn)

    def slip(self, contact, d):
        """The slip in scene units, a number in about [-1, 1]."""
        length = math.hypot(*(float(n / max(map(abs, contact.normal))) for n in contact.normal))
        return float(contact.slip(d) / max(map(abs, contact.normal))) / length


def load(path):
    with open(path, encoding="utf-8-sig") as file:
        return json.load(file, parse_float=Fraction, parse_int=Fraction)
