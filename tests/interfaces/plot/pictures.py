# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads pictures back: SVG as numbers. Standard library only."""

import functools
import json
import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from fractions import Fraction

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)  # exact values may have many thousands
STICKSLIP = os.environ.get("STICKSLIP", "stickslip")
NUMBER = r"-?\d+(?:\.\d{1,2})?"


def ask(*words, stdin=None):
    """Exit code, standard output, standard error."""
    result = subprocess.run([STICKSLIP, *map(str, words)], input=stdin, capture_output=True,
                            check=False, timeout=120,
                            **({} if isinstance(stdin, bytes) else {"text": True}))
    return result.returncode, result.stdout, result.stderr


@functools.lru_cache(maxsize=None)
def answer(words, stdin):
    return ask(*words, stdin=stdin)


def stickslip(*words, stdin=None):
    """ask() where many tests look at one picture. Files that are read do not change meanwhile."""
    return ask(*words, stdin=stdin) if "-o" in words else answer(words, stdin)


def exact(value):
    return value if isinstance(value, Fraction) else Fraction(str(value))


def depth(value):
    return 1 + depth(value[0]) if isinstance(value, list) else 0


def on_outline(outline, place):
    """The point, and a normal into the body (docs/grasp_file.md)."""
    for _ in range(4 - depth(outline)):
        outline = [outline]
    if isinstance(place, list):
        place = dict(zip(("edge", "share"), place))
    edges = []
    for k, ring in enumerate(outline[int(place.get("polygon", 0))]):
        ring = [tuple(map(exact, vertex)) for vertex in ring]
        pairs = list(zip(ring, ring[1:] + ring[:1]))
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs)
        edges += [(a, b, (area > 0) == (k == 0)) for a, b in pairs]
    (ax, ay), (bx, by), body_is_left = edges[int(place["edge"])]
    share, side = exact(place["share"]), 1 if body_is_left else -1
    return (ax + share * (bx - ax), ay + share * (by - ay)), (side * (ay - by), side * (bx - ax))


def case_options(grasp):
    """The first case, where there are any."""
    return ("--case", grasp["cases"][0]["name"]) if "cases" in grasp else ()


class Contact:
    """With exact numbers, as a grasp file has it."""

    def __init__(self, entry, grasp):
        defaults = grasp.get("defaults", {})
        if "on" in entry:
            self.position, self.normal = on_outline(grasp["outline"], entry["on"])
        else:
            self.position = tuple(map(exact, entry["position"]))
            self.normal = tuple(map(exact, entry["normal"]))
        get = lambda key, other: exact(entry.get(key, defaults.get(key, other)))
        self.preload, self.friction = get("preload", 0), get("friction", 0)
        self.largest = max(map(abs, self.normal))
        self.length = math.hypot(*(float(n / self.largest) for n in self.normal))  # over that

    def slip(self, d):
        """A positive multiple of the slip under the motion d."""
        (px, py), (nx, ny) = self.position, self.normal
        return -ny * (d[0] - d[2] * py) + nx * (d[1] + d[2] * px)


def contacts_of(grasp):
    return [Contact(entry, grasp) for entry in grasp["contacts"]]


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
        return float(contact.slip(d) / contact.largest) / contact.length


# Advances of the characters from blank to tilde in thousandths of the size of the font: DejaVu Sans
# and its bold, as their files state them. It is the widest font that the stylesheet names.
ADVANCES = (
    317, 400, 459, 837, 636, 950, 779, 274, 390, 390, 500, 837, 317, 360, 317, 336, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 636, 336, 336, 837, 837, 837, 530, 1000, 684, 686, 698,
    770, 631, 575, 774, 751, 294, 294, 655, 557, 862, 748, 787, 603, 787, 694, 634, 610, 731,
    684, 988, 685, 610, 685, 390, 336, 390, 837, 500, 500, 612, 634, 549, 634, 615, 352, 634,
    633, 277, 277, 579, 277, 974, 633, 611, 634, 634, 411, 520, 392, 633, 591, 817, 591, 591,
    524, 636, 336, 636, 837)
BOLD_ADVANCES = (
    348, 456, 520, 837, 695, 1001, 872, 306, 457, 457, 522, 837, 379, 415, 379, 365, 695, 695,
    695, 695, 695, 695, 695, 695, 695, 695, 399, 399, 837, 837, 837, 580, 1000, 773, 762, 733,
    830, 683, 683, 820, 836, 372, 372, 774, 637, 995, 836, 850, 732, 850, 770, 720, 682, 812,
    773, 1103, 770, 724, 725, 457, 365, 457, 837, 500, 500, 674, 715, 592, 715, 678, 435, 715,
    711, 342, 342, 665, 342, 1041, 711, 687, 715, 715, 493, 595, 478, 711, 651, 923, 645, 651,
    582, 711, 365, 711, 837)
OTHER_ADVANCES = {"\u2212": 837, "\u00d7": 837, "\u2248": 837, "\u2026": 1000, "\u202f": 199}
MONOSPACE_ADVANCE = 602


class TextBox:
    """Where a text stands on the page, by the picture's own stylesheet."""

    def __init__(self, element, style, transform):
        self.text = "".join(element.itertext())
        self.classes = element.get("class", "").split()
        rules = {}
        for name, body in re.findall(r"\.stickslip \.?([\w-]+) \{([^{}]*)\}", style.split("@media")[0]):
            if name == "text" or name in self.classes:
                rules.update(part.strip().split(": ", 1) for part in body.strip().split(";"))
        size = float(re.match(r"[\d.]+", rules.get("font-size", rules["font"])).group())
        width = sum(map(self.advance(rules), self.text)) * size / 1000
        left = {"middle": width / 2, "end": width}.get(rules.get("text-anchor"), 0)
        x, y = float(element.get("x")), float(element.get("y"))
        corners = [transform(x - left, y - 0.76 * size), transform(x - left + width, y + 0.24 * size)]
        self.low = tuple(map(min, zip(*corners)))
        self.high = tuple(map(max, zip(*corners)))

    @staticmethod
    def advance(rules):
        if "Mono" in rules.get("font-family", ""):
            return lambda c: MONOSPACE_ADVANCE + 1000 * float(rules["letter-spacing"].rstrip("em"))
        table = BOLD_ADVANCES if rules.get("font-weight") == "bold" else ADVANCES
        return lambda c: table[ord(c) - 32] if " " <= c <= "~" else OTHER_ADVANCES.get(c, 1000)

    def overlaps(self, other):
        return all(self.low[k] < other.high[k] and other.low[k] < self.high[k] for k in (0, 1))

    def is_inside(self, low, high):
        return all(low[k] <= self.low[k] and self.high[k] <= high[k] for k in (0, 1))

    def __repr__(self):
        return f"{self.text!r} at {self.low}, {self.high}"


def text_boxes(picture):
    found = []

    def visit(element, transform):
        turned = re.fullmatch(r"translate\((\S+) (\S+)\) rotate\(-90\)", element.get("transform", ""))
        if turned:
            x0, y0 = map(float, turned.groups())
            transform = lambda x, y: (x0 + y, y0 - x)
        if element.tag.endswith("}text"):
            found.append(TextBox(element, picture.style, transform))
        for child in element:
            visit(child, transform)

    visit(picture.root, lambda x, y: (x, y))
    return found


def load(path):
    with open(path, encoding="utf-8-sig") as file:
        return json.load(file, parse_float=Fraction, parse_int=Fraction)
