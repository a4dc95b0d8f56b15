#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks a stickslip certificate, of a verdict or a margin, against a grasp file: FORMAT.md as a
program.

Written from FORMAT.md and in its order, with nothing but the standard library of Python 3.9 or
newer; shares nothing with any solver or other checker. "§4" and the like are sections of
FORMAT.md; docs/grasp_file.md describes grasp files. Arithmetic is exact (integers and Fraction),
no floating point occurs. Exit codes: 0 accepted, 1 rejected, 2 malformed or wrong usage.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import signal
import sys
from fractions import Fraction
from typing import Any, Dict, List, NamedTuple, NoReturn, Optional, Sequence, Tuple

Vector = Tuple[Fraction, ...]
Integers = Tuple[int, ...]


class Malformed(Exception):
    """§6, exit 2: a file that is not what it should be, or a question that cannot be asked."""

    def __init__(self, file: str, place: str, problem: str) -> None:
        super().__init__(": ".join(part for part in (file, place, problem) if part))
        self.place = place


class Rejected(Exception):
    """§6, exit 1: a rule that the certificate fails, where, and what was found."""

    def __init__(self, rule: str, found: str, node: Optional[int] = None) -> None:
        super().__init__(found)
        self.rule, self.found, self.node, self.path = rule, found, node, None


def show(value: Any) -> str:
    """A number, vector or name for a message, shortened if long."""
    if isinstance(value, tuple):
        return "(" + ", ".join(show(v) for v in value) + ")"
    text = "none" if value is None else str(value)
    return text if len(text) <= 80 else f"{text[:40]}...{text[-20:]} ({len(text)} characters)"


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return sum(x * y for x, y in zip(a, b))


# ---- JSON, read exactly (§1, §2) --------------------------------------------------------------


class Numeral(NamedTuple):
    """A JSON number as it is spelled."""
    text: str


class Members(NamedTuple):
    """A JSON object: its members in the order of the file, repetitions included."""
    pairs: List[Tuple[str, Any]]


class FileKind(NamedTuple):
    format: str
    byte_order_mark: bool  # may the file begin with one?
    max_bytes: int
    max_depth: int
    max_string: int   # bytes between the quotation marks
    max_numeral: int  # characters of a JSON number
    max_number: int   # characters of a number in a string
    number: "re.Pattern[str]"  # [0-9], because \d and int() take other scripts' digits too


GRASP = FileKind("stickslip-grasp/1", True, 1 << 28, 32, 1 << 28, 16_384, 16_384, re.compile(
    r"([+-]?[0-9]+)(?:/([0-9]+)|(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?)"))
CERTIFICATE = FileKind("stickslip-certificate/1", False, 1 << 30, 8, 65_536, 4_000, 65_536,
                       re.compile(r"(-?[0-9]+)(?:/([0-9]+))?()()"))
MARGIN = CERTIFICATE._replace(format="stickslip-margin/1")
MAX_EXPONENT = 4096

# A string (also one that never ends) or a bracket; search passes over everything else.
STRING_OR_BRACKET = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*(?:"|\\?\Z)|[\[\]{}]', re.DOTALL)


def rational(text: str, kind: FileKind) -> Fraction:
    """The number spelled by `text`: §1 in a grasp file, NUMBER of §2 in a certificate."""
    if len(text) > kind.max_number:
        raise ValueError(f"a number of more than {kind.max_number} characters")
    match = kind.number.fullmatch(text)
    if not match:
        forms = "decimals and fractions" if kind is GRASP else "integers and \"3/5\""
        raise ValueError(f"'{show(text)}' is not a number as used here ({forms})")
    whole, denominator, decimals, exponent = match.groups()
    if denominator:
        if int(denominator) == 0:
            raise ValueError("a fraction with denominator 0")
        return Fraction(int(whole), int(denominator))
    power = int(exponent or 0)
    if abs(power) > MAX_EXPONENT:
        raise ValueError(f"an exponent beyond {MAX_EXPONENT}")
    return int(whole + (decimals or "")) * Fraction(10) ** (power - len(decimals or ""))


class Source:
    """One JSON file: its content, and errors that name the file and the place in it."""

    def __init__(self, name: str, kind: FileKind) -> None:
        self.name, self.kind = "standard input" if name == "-" else name, kind
        try:
            with open(sys.stdin.fileno() if name == "-" else name, "rb") as file:
                data = file.read(kind.max_bytes + 1)
        except (OSError, ValueError, AttributeError) as error:
            self.fail("", f"cannot be read: {error}")
        if len(data) > kind.max_bytes:
            self.fail("", f"longer than {kind.max_bytes} bytes")
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError as error:
            self.fail(f"byte {error.start}", "not UTF-8")
        if text.startswith("\ufeff"):
            if not kind.byte_order_mark:
                self.fail("byte 0", "a byte order mark; use UTF-8 without one")
            text = text[1:]
        depth = 0
        for match in STRING_OR_BRACKET.finditer(text):
            depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(text[match.start()], 0)
            problem = None
            if depth > kind.max_depth:
                problem = f"nesting deeper than {kind.max_depth}"
            elif match.end() - match.start() > kind.max_string // 4:  # UTF-8: at most 4 bytes each
                if len(match.group().encode("utf-8")) > kind.max_string + 2:
                    problem = f"a string of more than {kind.max_string} bytes"
            if problem:
                self.fail(f"line {text.count(chr(10), 0, match.start()) + 1}", problem)
        try:
            self.root = json.loads(text, parse_int=Numeral, parse_float=Numeral,
                                   parse_constant=lambda name: self.fail("", f"not JSON: {name}"),
                                   object_pairs_hook=Members)
        except json.JSONDecodeError as error:
            self.fail(f"line {error.lineno}, column {error.colno}", f"not JSON: {error.msg}")
        except RecursionError:
            self.fail("", "nested too deeply")
        if "\\u" in text:
            try:
                json.dumps(self.root, ensure_ascii=False).encode("utf-8")
            except UnicodeEncodeError:
                self.fail("", "a \\u escape that is half of a surrogate pair")

    def fail(self, place: str, problem: str) -> NoReturn:
        raise Malformed(self.name, place, problem)

    def members(self, value: Any, place: str, names: str, in_order: bool = False) -> Dict[str, Any]:
        """An object that has these members only; one whose name ends in ? may be missing."""
        if type(value) is not Members:
            self.fail(place, "must be an object")
        known = [name.rstrip("?") for name in names.split()]
        found: Dict[str, Any] = {}
        for key, content in value.pairs:
            if key not in known:
                self.fail(place, f"unknown member '{show(key)}' (known: {', '.join(known)})")
            if key in found:
                self.fail(place, f"member '{key}' is repeated")
            found[key] = content
        for name in names.split():
            if name not in found and not name.endswith("?"):
                self.fail(place, f"member '{name}' is missing")
        if in_order and list(found) != [key for key in known if key in found]:
            self.fail(place, f"members out of order, must be: {', '.join(known)}")
        return found

    def check_format(self, value: Any) -> None:
        """§9: a version that is not known is malformed; §10: so is the kind not asked for."""
        if type(value) is not str or value != self.kind.format:
            hint = {(CERTIFICATE, MARGIN.format): "; a margin is asked for with --direction",
                    (MARGIN, CERTIFICATE.format): "; one verdict is asked for without --direction"}
            found = value if type(value) is str else ""
            self.fail("format", f"must be \"{self.kind.format}\"" + hint.get((self.kind, found), ""))

    def choice(self, value: Any, place: str, words: Tuple[str, ...]) -> str:
        if type(value) is not str or value not in words:
            self.fail(place, f"must be one of: {', '.join(words)}")
        return value

    def array(self, value: Any, place: str, length: Optional[int] = None) -> List[Any]:
        if type(value) is not list or (length is not None and len(value) != length):
            self.fail(place, "must be an array" + ("" if length is None else f" of {length}"))
        return value

    def number(self, value: Any, place: str) -> Fraction:
        if type(value) is Numeral:
            value = value.text
            if len(value) > self.kind.max_numeral:
                self.fail(place, f"a JSON number of more than {self.kind.max_numeral} characters; "
                                 "write it as a string")
        elif type(value) is not str:
            self.fail(place, "must be a number or a string that spells one")
        try:
            return rational(value, self.kind)
        except ValueError as error:
            self.fail(place, str(error))

    def vector(self, value: Any, place: str, length: int) -> Vector:
        return tuple(self.number(v, f"{place}[{j}]")
                     for j, v in enumerate(self.array(value, place, length)))

    def index(self, value: Any, place: str) -> int:
        """§2: CONTACT, and m: a JSON integer >= 0."""
        number = self.number(value, place) if type(value) is Numeral else -1
        if number < 0:
            self.fail(place, "must be an integer >= 0")
        return int(number)


# ---- §1 The question --------------------------------------------------------------------------

LAWS = ("unilateral", "bilateral")


class Contact(NamedTuple):
    """A contact as the grasp file gives it; its normal has any length but 0."""
    position: Vector
    normal: Vector
    friction: Fraction
    stiffness: Fraction
    preload: Fraction


class Question(NamedTuple):
    """What is asked; `preload` if it replaces the file's, `snap` is the tolerance, if any."""
    contacts: List[Contact]
    wrench: Vector
    preload: Optional[Fraction]
    law: str
    snap: Optional[Fraction]
    direction: Optional[Vector] = None  # §10, if the margin is asked for


class Row(NamedTuple):
    """The rows and coefficients of one contact."""
    N: Vector
    T: Vector
    friction: Fraction
    preload: Fraction    # P' = P/L
    stiffness: Fraction  # k' = k/L²


def coefficients(source: Source, fields: Dict[str, Any], place: str) -> Dict[str, Fraction]:
    """Those of μ ≥ 0, k > 0 and P ≥ 0 that an object of the grasp file states."""
    found = {}
    for key in ("friction", "stiffness", "preload"):
        if key in fields:
            found[key] = source.number(fields[key], f"{place}.{key}")
            if found[key] < 0 or (key == "stiffness" and found[key] == 0):
                source.fail(f"{place}.{key}", f"{show(found[key])} is out of range, must be "
                                              + ("> 0" if key == "stiffness" else ">= 0"))
    return found


def read_grasp(name: str) -> Question:
    """§1: the question as the grasp file asks it."""
    source = Source(name, GRASP)
    top = source.members(source.root, "", "format name? defaults? contacts wrench normals?")
    source.check_format(top["format"])
    if type(top.get("name", "")) is not str:
        source.fail("name", "must be a string")
    stated = source.members(top.get("defaults", Members([])), "defaults",
                            "friction? stiffness? preload?")
    defaults = {"stiffness": Fraction(1), "preload": Fraction(0),
                **coefficients(source, stated, "defaults")}
    contacts = []
    for i, entry in enumerate(source.array(top["contacts"], "contacts")):
        place = f"contacts[{i}]"
        fields = source.members(entry, place, "position normal friction? stiffness? preload?")
        values = {**defaults, **coefficients(source, fields, place)}
        if "friction" not in values:
            source.fail(place, "'friction' is missing, here and in defaults")
        normal = source.vector(fields["normal"], f"{place}.normal", 2)
        if not any(normal):
            source.fail(f"{place}.normal", "must not be zero")
        contacts.append(Contact(source.vector(fields["position"], f"{place}.position", 2), normal,
                                values["friction"], values["stiffness"], values["preload"]))
    snap = None
    if type(top.get("normals")) is Members:
        fields = source.members(top["normals"], "normals", "snap")
        snap = source.number(fields["snap"], "normals.snap")
        if not 0 < snap < 1:
            source.fail("normals.snap", "must be > 0 and < 1")
    elif source.choice(top.get("normals", "exact"), "normals", ("exact", "snap")) == "snap":
        snap = Fraction(1, 10**9)
    return Question(contacts, source.vector(top["wrench"], "wrench", 3), None, LAWS[0], snap)


def rational_root(square: Fraction) -> Optional[Fraction]:
    root = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
    return root if root * root == square else None


def rows(question: Question, grasp_file: str) -> List[Row]:
    """§1, Rows. Malformed if a contact with P > 0 has an irrational L."""
    table = []
    for i, ((px, py), (nx, ny), friction, stiffness, preload) in enumerate(question.contacts):
        square = nx * nx + ny * ny
        length = rational_root(square)
        if preload > 0 and length is None:
            raise Malformed(grasp_file, f"contacts[{i}].normal",
                            "the contact has a preload and a normal of irrational length, so the "
                            "question cannot be asked; allow snapping (--snap-normals EPS)")
        tx, ty = -ny, nx
        table.append(Row((nx, ny, px * ny - py * nx), (tx, ty, px * ty - py * tx), friction,
                         preload / length if preload else preload, stiffness / square))
    return table


# ---- §2 Syntax --------------------------------------------------------------------------------


class Claim(NamedTuple):
    """The member `question` of a certificate."""
    contacts: int
    wrench: Vector
    preload: Optional[Fraction]
    law: str
    normals: Optional[List[Tuple[int, Vector]]]


class Node(NamedTuple):
    """§4: slip and separation have a contact, plane has numbers a, leaf has numbers y and θs."""
    kind: str
    contact: int = -1
    numbers: Vector = ()
    thetas: Sequence[Tuple[int, Fraction]] = ()


class Point(NamedTuple):
    """A motion and its forces: of "stable", or with λ a POINT of §10, which is a ray if that is
    null."""
    twist: Vector
    forces: List[Vector]
    load: Optional[Fraction] = Fraction(0)  # λ


Interval = Tuple[Fraction, Optional[Fraction]]  # None for ∞


class Certificate(NamedTuple):
    question: Claim
    verdict: str                # "stable", "unstable" or, of §10, "margin"
    tree: List[Node] = []       # of "unstable" and "margin"
    witness: Optional[Point] = None         # of "stable"
    direction: Vector = ()                  # of "margin", as are those below
    resisted: List[Interval] = []
    segments: List[Tuple[Point, Point]] = []


def read_certificate(name: str, kind: FileKind) -> Certificate:
    """§2 and §10. All of the syntax comes before any rule."""
    source = Source(name, kind)
    claimed = dict(source.root.pairs) if type(source.root) is Members else {}
    if "format" in claimed:
        source.check_format(claimed["format"])
    evidence = ("direction resisted segments tree" if kind is MARGIN else
                "verdict twist forces" if claimed.get("verdict") == "stable" else "verdict tree")
    top = source.members(source.root, "", "format producer? question " + evidence, True)
    if type(top.get("producer", "")) is not str:
        source.fail("producer", "must be a string")
    claim = read_claim(source, top["question"])
    verdict = "margin" if kind is MARGIN else source.choice(top["verdict"], "verdict",
                                                            ("stable", "unstable"))
    if verdict == "stable":
        return Certificate(claim, verdict, witness=read_witness(source, top["twist"], "twist",
                                                                top["forces"], "forces"))
    tree = [read_node(source, node, f"tree[{k}]")
            for k, node in enumerate(source.array(top["tree"], "tree"))]
    if verdict == "unstable":
        return Certificate(claim, verdict, tree)

    def number_or_null(value: Any, place: str) -> Optional[Fraction]:
        return None if value is None else source.number(value, place)

    def read_point(value: Any, place: str, load: Any) -> Point:
        first, twist, forces = source.array(value, place, 3)
        return read_witness(source, twist, place, forces, place)._replace(load=load(first, place))

    resisted, segments = [], []
    for k, entry in enumerate(source.array(top["resisted"], "resisted")):
        low, high = source.array(entry, f"resisted[{k}]", 2)
        resisted.append((source.number(low, f"resisted[{k}]"),
                         number_or_null(high, f"resisted[{k}]")))
    for k, entry in enumerate(source.array(top["segments"], "segments")):
        first, second = source.array(entry, f"segments[{k}]", 2)
        segments.append((read_point(first, f"segments[{k}]", source.number),
                         read_point(second, f"segments[{k}]", number_or_null)))
    direction = source.vector(top["direction"], "direction", 3)
    return Certificate(claim, verdict, tree, None, direction, resisted, segments)


def read_witness(source: Source, twist: Any, twist_place: str, forces: Any,
                 forces_place: str) -> Point:
    return Point(source.vector(twist, twist_place, 3),
                 [source.vector(pair, f"{forces_place}[{i}]", 2)
                  for i, pair in enumerate(source.array(forces, forces_place))])


def read_claim(source: Source, value: Any) -> Claim:
    fields = source.members(value, "question", "contacts wrench preload? normal_law normals?", True)
    preload = normals = None
    if "preload" in fields:
        preload = source.number(fields["preload"], "question.preload")
    if "normals" in fields:
        normals = []
        for k, entry in enumerate(source.array(fields["normals"], "question.normals")):
            place = f"question.normals[{k}]"
            i, x, y = source.array(entry, place, 3)
            normals.append((source.index(i, place), source.vector([x, y], place, 2)))
    return Claim(source.index(fields["contacts"], "question.contacts"),
                 source.vector(fields["wrench"], "question.wrench", 3), preload,
                 source.choice(fields["normal_law"], "question.normal_law", LAWS), normals)


def read_node(source: Source, value: Any, place: str) -> Node:
    """§4, the table of nodes."""
    kind, *rest = source.array(value, place) or [None]
    if kind in ("slip", "separation") and len(rest) == 1:
        return Node(kind, source.index(rest[0], place))
    if kind == "plane" and len(rest) == 4:
        return Node(kind, numbers=source.vector(rest, place, 4))
    if kind == "leaf" and len(rest) in (3, 4):
        thetas = []
        for entry in source.array(rest[3], place) if len(rest) == 4 else []:
            i, theta = source.array(entry, place, 2)
            thetas.append((source.index(i, place), source.number(theta, place)))
        return Node(kind, numbers=source.vector(rest[:3], place, 3), thetas=thetas)
    if kind == "void" and not rest:
        return Node(kind)
    source.fail(place, "must be [\"slip\", i], [\"separation\", i], [\"plane\", a1, a2, a3, a4], "
                       "[\"leaf\", y1, y2, y3], [\"leaf\", y1, y2, y3, [[i, theta], ...]] or "
                       "[\"void\"]")


# ---- §3 The question and the stable verdict ---------------------------------------------------


def check_question(question: Question, claim: Claim) -> Question:
    """`question-...`. Returns the question, with the normals that the certificate replaces."""
    m = len(question.contacts)
    for rule, said, asked in (("contacts", claim.contacts, m),
                              ("wrench", claim.wrench, question.wrench),
                              ("preload", claim.preload, question.preload),
                              ("law", claim.law, question.law)):
        if said != asked:
            raise Rejected(f"question-{rule}", f"the certificate says {show(said)}, asked was "
                                               f"{show(asked)}")
    if claim.normals is None:
        return question
    if question.snap is None:
        raise Rejected("question-normals", "normals are replaced, but snapping was not asked for")
    contacts, last = list(question.contacts), -1
    for i, u in claim.normals:
        if not last < i < m:
            raise Rejected("question-normals", f"contact {show(i)} is out of range or of order")
        n, s = contacts[i].normal, dot(u, contacts[i].normal)
        if rational_root(dot(n, n)) is not None:
            raise Rejected("question-normals", f"contact {i}: the length of {show(n)} is rational")
        if dot(u, u) != 1:
            raise Rejected("question-normals", f"contact {i}: {show(u)} has not length 1")
        if not (s > 0 and s * s >= (1 - question.snap**2 / 2) ** 2 * dot(n, n)):
            raise Rejected("question-normals", f"contact {i}: {show(u)} is further than "
                                               f"{show(question.snap)} from the grasp's normal")
        contacts[i], last = contacts[i]._replace(normal=u), i
    return question._replace(contacts=contacts)


def plus(a: Vector, factor: Fraction, b: Vector) -> Vector:
    return tuple(x + factor * y for x, y in zip(a, b))


def compression(row: Row, point: Point) -> Fraction:
    """v; a ray has no preload."""
    preload = 0 if point.load is None else row.preload
    return preload - row.stiffness * dot(row.N, point.twist)


def check_witness(point: Point, question: Question, table: List[Row]) -> None:
    """`witness-...`: the laws of §1 by substitution, under w + λu, or for a ray under u."""
    if len(point.forces) != len(table):
        raise Rejected("witness-count", f"{len(point.forces)} pairs for {len(table)} contacts")
    u = question.direction or NOWHERE
    total = list(u if point.load is None else plus(question.wrench, point.load, u))
    for row, (a, b) in zip(table, point.forces):
        total = [c + a * n + b * t for c, n, t in zip(total, row.N, row.T)]
    if any(total):
        raise Rejected("witness-balance", f"wrench and forces add up to {show(tuple(total))}")
    for i, (row, (a, b)) in enumerate(zip(table, point.forces)):
        v = compression(row, point)
        if not (a == v >= 0 if question.law == "bilateral" else a == max(0, v)):
            raise Rejected("witness-normal", f"contact {i}: a = {show(a)} where v = {show(v)}")
    for i, (row, (a, b)) in enumerate(zip(table, point.forces)):
        if abs(b) > row.friction * a:
            raise Rejected("witness-cone", f"contact {i}: a = {show(a)}, b = {show(b)}")
    for i, (row, (a, b)) in enumerate(zip(table, point.forces)):
        slip = dot(row.T, point.twist)
        if (slip > 0 and b != -row.friction * a) or (slip < 0 and b != row.friction * a):
            raise Rejected("witness-dissipation", f"contact {i}: T.d = {show(slip)}, "
                                                  f"a = {show(a)}, b = {show(b)}")


# ---- §4 The unstable verdict: a tree ----------------------------------------------------------

MAX_PLANES = 64
NOWHERE = (Fraction(0),) * 3


class Loads(NamedTuple):
    """The λ that a tree is about (§10): a gap, or the one load of an "unstable", λ = 0.

    The generators (r, ℓ) are those of §10; for one load each r comes with one ℓ.
    """
    ends: Tuple[Fraction, ...] = (Fraction(0),)            # α, and β if it is finite
    strict: Tuple[Tuple[Fraction, Fraction], ...] = ()     # (p, q) for pℓ + qh
    unbounded: bool = False

    def lift(self, rays: Sequence[Tuple[Integers, int]]) -> List[Tuple[Integers, int, Any]]:
        lifted = [(r, zero, end * r[3]) for r, zero in rays
                  for end in (self.ends if r[3] else self.ends[:1])]
        return lifted + [((0, 0, 0, 0), -1, 1)] * self.unbounded

    def name(self, r: Integers, l: Any) -> str:
        return show(r if self == Loads() else (*r, l))

    def bars(self, region: Region, lifted: Sequence[Tuple[Integers, int, Any]]) -> bool:
        """§4, barred: is some strict function zero on all of these generators?"""
        return (region.bars([(r, zero) for r, zero, _ in lifted])
                or any(all(p * l + q * r[3] == 0 for r, _, l in lifted) for p, q in self.strict))


def integers(vector: Sequence[Fraction]) -> Tuple[Integers, int]:
    """The least positive multiple without denominators, and the factor."""
    factor = math.lcm(*(c.denominator for c in vector))
    return tuple(c.numerator * (factor // c.denominator) for c in vector), factor


def reduced(vector: Integers) -> Integers:
    divisor = math.gcd(*vector)
    return vector if divisor == 1 else tuple(c // divisor for c in vector)


def negated(vector: Integers) -> Integers:
    return tuple(-c for c in vector)


class Cone:
    """§4, Generators: a region of x = (d_x, d_y, d_r, h), by the double description method.

    `lines` are linearly independent; `rays` are extreme, one for each class modulo the lines, and
    each comes with the set (bits, numbered by the cuts so far) of the conditions that are zero on
    it; on lines all are. Two rays span a two-dimensional face, modulo the lines, iff no third ray
    is zero in all conditions in which both are; where a cut crosses such a face is a new ray.
    """

    def __init__(self, lines: List[Integers], rays: List[Tuple[Integers, int]], cuts: int) -> None:
        self.lines, self.rays, self.cuts = lines, rays, cuts
        self.generators = rays + [(x, -1) for line in lines for x in (line, negated(line))]

    def cut(self, a: Integers, equality: bool = False) -> Cone:
        """The part with a·x ≥ 0, or a·x = 0."""
        bit = 1 << self.cuts
        crossing = next((line for line in self.lines if dot(a, line)), None)
        if crossing is not None:
            # Move all other generators along this line into the plane; half of it stays, as a ray.
            line = crossing if dot(a, crossing) > 0 else negated(crossing)
            rise = dot(a, line)

            def moved(x: Integers) -> Integers:
                height = dot(a, x)
                return reduced(tuple(rise * c - height * e for c, e in zip(x, line)))

            lines = [moved(other) for other in self.lines if other is not crossing]
            rays = [(moved(x), zero | bit) for x, zero in self.rays]
            return Cone(lines, rays + ([] if equality else [(line, bit - 1)]), self.cuts + 1)

        heights = [(x, zero, dot(a, x)) for x, zero in self.rays]
        rays = [(x, zero if height else zero | bit) for x, zero, height in heights
                if height == 0 or (height > 0 and not equality)]
        for p, p_zero, up in heights:
            for q, q_zero, down in heights:
                if up > 0 > down:
                    both = p_zero & q_zero
                    if all(zero & both != both or x is p or x is q for x, zero in self.rays):
                        rays.append((reduced(tuple(up * c - down * e for c, e in zip(q, p))),
                                     both | bit))
        return Cone(self.lines, rays, self.cuts + 1)


class Terms:
    """§4: the rows of the contacts in integers, by positive factors.

    `slip` is a multiple of τ_i and `gap` one of v_i; `plus` and `minus` are multiples of
    N_i − μ_i T_i and N_i + μ_i T_i, `load` one of w and `rise` one of u. The factors are such that,
    for one D > 0, D·α_i v_i(r) = (y·plus or y·minus)(gap·r), D·(y·w) = y·load, D·(y·u) = y·rise.
    """

    def __init__(self, table: List[Row], wrench: Vector, direction: Vector = NOWHERE) -> None:
        self.slip, self.plus, self.minus, gaps = [], [], [], []
        for row in table:
            self.slip.append(integers(row.T + (Fraction(0),))[0])
            forces, factor = integers([n - row.friction * t for n, t in zip(row.N, row.T)]
                                      + [n + row.friction * t for n, t in zip(row.N, row.T)])
            self.plus.append(forces[:3])
            self.minus.append(forces[3:])
            gaps.append([-row.stiffness * n / factor for n in row.N] + [row.preload / factor])
        self.D = math.lcm(*(c.denominator for v in (*gaps, wrench, direction) for c in v))
        self.gap = [tuple(int(self.D * c) for c in v) for v in gaps]
        self.load = tuple(int(self.D * c) for c in wrench)
        self.rise = tuple(int(self.D * c) for c in direction)


class Region:
    """A node's region, labels and strict functions, and what holds of each contact in the region.

    side[i] is +1 if v_i ≥ 0 on all rays, −1 if v_i ≤ 0 on all rays, else 0; sign[i] is +1, −1, or 0
    for none. These belong to the region, not to its choice of rays, and hold in all regions inside:
    only the contacts in `bent` and `loose` need another look there. `strict` is the set (bits, as
    in Cone) of the strict functions: each is the condition of a cut, up to its sign.
    """

    def __init__(self, parent: Optional[Region], split: Tuple[str, int], step: str, row: Integers,
                 equality: bool = False, label: Optional[int] = None, strict: bool = False):
        self.parent = parent
        self.split = split        # the parent's kind of node, and its contact
        self.step = step          # the last step of the path from the root
        self.row = row            # the condition: row·x ≥ 0, or = 0
        self.equality = equality
        self.label = label        # if a child of slip
        self.adds_strict = strict  # is row·x a new strict function?

    def open(self, terms: Terms, m: int, law: str) -> None:
        """Computes the cone, when the node's turn has come."""
        if self.parent is None:
            everything = [tuple(int(j == k) for k in range(4)) for j in range(4)]
            self.cone = Cone(everything, [], 0).cut((0, 0, 0, 1))
            for gap in terms.gap if law == "bilateral" else []:
                self.cone = self.cone.cut(gap)
            self.strict = 1  # h, the first cut
            self.side = self.sign = [0] * m
            self.bent = self.loose = list(range(m))
        else:
            self.cone = self.parent.cone.cut(self.row, self.equality)
            self.strict = self.parent.strict | self.adds_strict << self.parent.cone.cuts
            self.side, self.sign = self.parent.side, self.parent.sign
            self.bent, self.loose = self.parent.bent, self.parent.loose
            if self.label is not None:
                self.sign = list(self.sign)
                self.sign[self.split[1]] = self.label
                self.loose = [i for i in self.loose if i != self.split[1]]

    def bars(self, rays: Sequence[Tuple[Integers, int]]) -> bool:
        """§4, barred: is some strict function zero on all of these rays?"""
        common = self.strict
        for _, zero in rays:
            common &= zero
        return common != 0

    def look(self, terms: Terms) -> None:
        """Finds the sides and signs that the parent's region did not have."""
        found = {i: side for i in self.bent if (side := self.common_side(terms.gap[i]))}
        self.side = [found.get(i, side) for i, side in enumerate(self.side)]
        self.bent = [i for i in self.bent if i not in found]
        found = {i: sign for i in self.loose if (sign := self.common_sign(terms.slip[i]))}
        self.sign = [found.get(i, sign) for i, sign in enumerate(self.sign)]
        self.loose = [i for i in self.loose if i not in found]

    def common_side(self, row: Integers) -> int:
        """+1 if row·r ≥ 0 for all rays, else −1 if row·r ≤ 0 for all rays, else 0."""
        a, b, c, e = row
        side = 0
        for (x, y, z, h), _ in self.cone.generators:
            value = a * x + b * y + c * z + e * h
            if side * value < 0:
                return 0
            if value:
                side = 1 if value > 0 else -1
        return side or 1

    def common_sign(self, row: Integers) -> int:
        """+1 if row·r ≥ 0 for all rays and those with row·r = 0 are barred; −1 likewise; else 0.
        (0 as well if row·r = 0 for all rays; if they are barred, no leaf asks for the sign.)"""
        a, b, c, _ = row
        sign, common = 0, self.strict
        for (x, y, z, _), zero in self.cone.generators:
            value = a * x + b * y + c * z
            if value == 0:
                common &= zero
            elif sign * value < 0:
                return 0
            else:
                sign = 1 if value > 0 else -1
        return sign if common else 0

    def line_of_descent(self) -> List[Region]:
        """The regions from this one up to the root's, the latter left out."""
        line, region = [], self
        while region.parent is not None:
            line.append(region)
            region = region.parent
        return line

    def path(self) -> str:
        return ", ".join(region.step for region in reversed(self.line_of_descent())) or "root"


def check_leaf(region: Region, node: Node, m: int, terms: Terms, loads: Loads = Loads()) -> None:
    """§4, Leaf."""
    last = -1
    for i, theta in node.thetas:
        if not last < i < m or not 0 <= theta <= 1:
            raise Rejected("leaf-theta", f"contact {show(i)}, theta {show(theta)}")
        last = i
    generators = loads.lift(region.cone.generators)
    if loads.bars(region, generators):
        return
    thetas = dict(node.thetas)
    (y1, y2, y3), factor = integers(node.numbers)
    form = [0, 0, 0, dot((y1, y2, y3), terms.load)]  # D·g(r, ℓ), but for ℓ·rise and `bends`
    rise = dot((y1, y2, y3), terms.rise)
    bends = []
    for sign, side, p, q, gap, i in zip(region.sign, region.side, terms.plus, terms.minus,
                                        terms.gap, range(m)):
        if side < 0:
            continue
        work = [y1 * f[0] + y2 * f[1] + y3 * f[2] for f in ((p, q)[sign < 0], (q, p)[sign > 0])]
        alpha = max(work)  # over the one direction of the sign, or over both
        if side > 0:
            form = [f + alpha * c for f, c in zip(form, gap)]
        else:
            bends.append((alpha, thetas.get(i, 0), gap))
    flat = []  # the generators with g(r, ℓ) = 0
    for r, zero, l in generators:
        g = dot(form, r) + (rise and l * rise)
        for alpha, theta, gap in bends:
            v = dot(gap, r)
            g += alpha * max(0, v) if alpha >= 0 else alpha * theta * v
        if g > 0:
            g = Fraction(g) / (terms.D * factor)
            raise Rejected("leaf-bound", f"ray {loads.name(r, l)}: g = {show(g)}, must be <= 0")
        if g == 0:
            flat.append((r, zero, l))
    if not loads.bars(region, flat):
        raise Rejected("leaf-bound", "g = 0 on rays that are not barred: "
                                     + ", ".join(loads.name(r, l) for r, _, l in flat[:4]))


def check_void(region: Region, loads: Loads = Loads()) -> None:
    """§4, Void."""
    rays = loads.lift(region.cone.generators)
    if not loads.bars(region, rays):
        raise Rejected("void-region", "the region's rays are not barred: "
                                      + ", ".join(loads.name(r, l) for r, _, l in rays[:4]))


def children(region: Region, node: Node, m: int, terms: Terms, law: str) -> List[Region]:
    """§4, the table of nodes: the rules of an inner node, and its children in order."""
    kind, i = split = node.kind, node.contact
    above = [ancestor.split for ancestor in region.line_of_descent()]
    if kind != "plane" and i >= m:
        raise Rejected("node-contact", f"contact {show(i)}, the grasp has {m}")
    if above.count(split) >= (MAX_PLANES if kind == "plane" else 1):
        raise Rejected("node-repeated", f"{MAX_PLANES} planes stand above this one"
                       if kind == "plane" else f"another {kind} {i} stands above this one")
    if kind == "plane" and not any(node.numbers):
        raise Rejected("node-plane", "all four numbers are 0")
    if kind == "separation" and law == "bilateral":
        raise Rejected("node-law", "separation under the bilateral law")

    if kind == "slip":
        row = terms.slip[i]
        return [Region(region, split, f"slip {i} +", row, label=1, strict=True),
                Region(region, split, f"slip {i} 0", row, equality=True, label=0),
                Region(region, split, f"slip {i} -", negated(row), label=-1, strict=True)]
    if kind == "separation":
        row, steps = terms.gap[i], (f"separation {i} closed", f"separation {i} open")
    else:
        row, steps = integers(node.numbers)[0], ("plane +", "plane -")
    return [Region(region, split, steps[0], row),
            Region(region, split, steps[1], negated(row), strict=True)]


def check_tree(tree: List[Node], question: Question, table: List[Row],
               ranges: Sequence[Loads] = (Loads(),)) -> None:
    """§4; and §10, one tree for each of the ranges. `waiting` holds the regions whose nodes are
    still to come, the next one last."""
    m, terms = len(table), Terms(table, question.wrench, question.direction or NOWHERE)
    waiting: List[Region] = []
    loads, begun = Loads(), 0
    for number, node in enumerate(tree):
        if not waiting:
            if begun == len(ranges):
                raise Rejected("tree-long", f"{len(tree) - number} nodes after the end", number)
            loads, waiting = ranges[begun], [Region(None, ("root", -1), "", ())]
            begun += 1
        region = waiting.pop()
        try:
            region.open(terms, m, question.law)
            if node.kind == "void":
                check_void(region, loads)
                continue
            region.look(terms)
            if node.kind == "leaf":
                check_leaf(region, node, m, terms, loads)
            else:
                waiting += reversed(children(region, node, m, terms, question.law))
        except Rejected as failure:
            failure.node, failure.path = number, region.path()
            raise
    if waiting or begun < len(ranges):
        missing = f"{len(waiting)} children" if waiting else f"{len(ranges) - begun} trees"
        failure = Rejected("tree-short", f"{missing} are missing", len(tree))
        failure.path = waiting[-1].path() if waiting else "root"
        raise failure


# ---- §10 Margin certificates ------------------------------------------------------------------


def check_direction(claimed: Vector, question: Question) -> None:
    if claimed != question.direction:
        raise Rejected("question-direction", f"the certificate says {show(claimed)}, asked was "
                                             f"{show(question.direction)}")


def check_resisted(resisted: List[Interval]) -> None:
    """`resisted-order`."""
    for k, (low, high) in enumerate(resisted):
        before = resisted[k - 1][1] if k else None
        in_order = low >= 0 if k == 0 else before is not None and before < low
        if not in_order or (high is not None and high < low):
            failure = Rejected("resisted-order", f"({show(low)}, {show(high)})"
                                                 + (f" after {show(before)}" if k else ""))
            failure.path = f"interval {k}"
            raise failure


def check_chain(segments: List[Tuple[Point, Point]], resisted: List[Interval], question: Question,
                table: List[Row]) -> None:
    """Segments: each goes from where it must, in one mode, until all intervals are covered."""
    at = 0        # the interval at hand
    done = None   # how far it is covered, if at all
    for k, (first, second) in enumerate([*segments, (None, None)]):
        place = f"segment {k}"
        try:
            if first is None:
                if at < len(resisted):
                    raise Rejected("segment-chain", "missing: the intervals are not covered yet")
                return
            if at == len(resisted):
                raise Rejected("segment-chain", "left over: the intervals are covered already")
            low, high = resisted[at]
            end = second.load
            if first.load != (low if done is None else done):
                raise Rejected("segment-chain", f"begins at {show(first.load)}, must begin at "
                                                f"{show(low if done is None else done)}")
            if high is not None and (end is None or end > high):
                raise Rejected("segment-chain", f"goes to {show(end)}, beyond {show(high)}")
            if end is not None and end < first.load:
                raise Rejected("segment-chain", f"goes down, to {show(end)}")
            for point, name in ((first, "first"), (second, "second")):
                place = f"segment {k}, {name} point"
                check_witness(point, question, table)
            place = f"segment {k}"
            check_mode(first, second, table)
        except Rejected as failure:
            failure.path = place
            raise
        if end == high:
            at, done = at + 1, None
        else:
            done = end


def check_mode(first: Point, second: Point, table: List[Row]) -> None:
    """`segment-mode`."""
    for i, (row, (a1, b1), (a2, b2)) in enumerate(zip(table, first.forces, second.forces)):
        v1, v2 = compression(row, first), compression(row, second)
        if v1 < 0 < v2 or v2 < 0 < v1:
            raise Rejected("segment-mode", f"contact {i}: v = {show(v1)} and v = {show(v2)}")
        if row.friction == 0 or a1 + a2 == 0:
            continue
        slip1, slip2 = dot(row.T, first.twist), dot(row.T, second.twist)
        if slip1 < 0 < slip2 or slip2 < 0 < slip1:
            raise Rejected("segment-mode", f"contact {i}: T.d = {show(slip1)} and {show(slip2)}")
        for edge, slips in ((-row.friction, slip1 + slip2 > 0), (row.friction, slip1 + slip2 < 0)):
            if slips and (b1 != edge * a1 or b2 != edge * a2):
                raise Rejected("segment-mode", f"contact {i} slips, but b = {show(b1)} or b = "
                                               f"{show(b2)} is not {show(edge)} a")


def gaps(resisted: List[Interval]) -> List[Loads]:
    """What the intervals leave of [0, ∞)."""
    found = []
    starts: List[Tuple[Fraction, bool]] = [(Fraction(0), True)]  # with: does the gap contain it?
    starts += [(high, False) for _, high in resisted if high is not None]
    ends: List[Optional[Fraction]] = [low for low, _ in resisted]
    if all(high is not None for _, high in resisted):
        ends.append(None)
    for (low, contained), high in zip(starts, ends):
        if low == high:  # of the first only: the intervals begin at 0
            continue
        above = () if contained else ((Fraction(1), -low),)
        below = () if high is None else ((Fraction(-1), high),)
        found.append(Loads((low,) if high is None else (low, high), above + below, high is None))
    return found


def in_words(resisted: List[Interval]) -> str:
    return ", ".join(f"[{low}, oo)" if high is None else f"[{low}, {high}]"
                     for low, high in resisted) or "no multiple"


# ---- §6 What a checker answers ----------------------------------------------------------------


def parse_arguments(arguments: Sequence[str]) -> argparse.Namespace:
    """Wrong usage ends with exit code 2."""
    def number(text: str) -> Fraction:
        try:
            return rational(text, GRASP)
        except ValueError as error:
            raise argparse.ArgumentTypeError(str(error)) from None

    def three(text: str) -> Vector:
        if text.count(",") != 2:
            raise argparse.ArgumentTypeError("must be three numbers WX,WY,T")
        return tuple(number(part) for part in text.split(","))

    parser = argparse.ArgumentParser(prog="check.py", allow_abbrev=False,
                                     description="Checks a stickslip certificate (FORMAT.md).",
                                     epilog="Exit codes: 0 accepted, 1 rejected, 2 malformed.")
    parser.add_argument("grasp", metavar="GRASP", help="grasp file; - is standard input")
    parser.add_argument("certificate", metavar="CERTIFICATE", help="certificate; likewise")
    parser.add_argument("--wrench", type=three, metavar="WX,WY,T", help="replaces the file's")
    parser.add_argument("--direction", type=three, metavar="WX,WY,T",
                        help="ask for the margin: all factors f >= 0 such that the grasp is stable "
                             "under wrench + f direction, with wrench 0 unless given; needs a "
                             "stickslip-margin/1 certificate")
    parser.add_argument("--preload", type=number, metavar="P", help="at all contacts")
    parser.add_argument("--normal-law", choices=LAWS, default=LAWS[0], help="unilateral if absent")
    parser.add_argument("--snap-normals", type=number, metavar="EPS",
                        help="allow normals within EPS of the file's")
    parser.add_argument("--json", action="store_true", help="answer as one JSON object")
    joined: List[str] = []  # "--wrench=-1,0,0", as argparse takes -1,0,0 alone for an option
    for word in arguments:
        if joined and joined[-1] in ("--wrench", "--direction", "--preload", "--snap-normals"):
            joined[-1] += "=" + word
        else:
            joined.append(word)
    options = parser.parse_args(joined)
    if options.grasp == options.certificate == "-":
        parser.error("standard input cannot be both files")
    if options.direction is not None and not any(options.direction):
        parser.error("--direction must not be 0,0,0")
    if options.preload is not None and options.preload < 0:
        parser.error("--preload must be >= 0")
    if options.snap_normals is not None and not 0 < options.snap_normals < 1:
        parser.error("--snap-normals must be > 0 and < 1")
    return options


def accepted(certificate: Certificate, question: Question, leaves: int) -> str:
    claim = certificate.question
    preload = "the grasp file's" if claim.preload is None else f"{claim.preload} at all contacts"
    margin = certificate.verdict == "margin"
    lines = ["accepted", f"resisted: {in_words(certificate.resisted)}" if margin
             else f"verdict: {certificate.verdict}", f"contacts: {claim.contacts}",
             f"wrench: {', '.join(map(str, claim.wrench))}"]
    if margin:
        lines.append(f"direction: {', '.join(map(str, certificate.direction))}")
    lines += [f"preload: {preload}", f"normal law: {claim.law}"]
    lines += [f"normal of contact {i}: ({x}, {y}), within {question.snap} of the grasp file's"
              for i, (x, y) in claim.normals or []]
    if certificate.witness:
        lines.append(f"twist: {', '.join(map(str, certificate.witness.twist))}")
    else:
        lines += [f"segments: {len(certificate.segments)}"] * margin
        lines.append(f"tree{'s' * margin}: {len(certificate.tree)} nodes, {leaves} leaves")
    return "\n".join(lines)


def answer(options: argparse.Namespace) -> int:
    """One answer on standard output, malformed on standard error. In --json every key is there;
    `leaves` counts leaf nodes, and `path` is the place if malformed."""
    report: Dict[str, Any] = dict.fromkeys(
        ("result", "rule", "node", "path", "found", "verdict", "nodes", "leaves", "resisted"))
    text = None
    try:
        question = read_grasp(options.grasp)._replace(law=options.normal_law)
        question = question._replace(direction=options.direction)
        if options.direction is not None:
            question = question._replace(wrench=NOWHERE)  # §10
        if options.wrench is not None:
            question = question._replace(wrench=options.wrench)
        if options.preload is not None:
            contacts = [c._replace(preload=options.preload) for c in question.contacts]
            question = question._replace(preload=options.preload, contacts=contacts)
        if options.snap_normals is not None:
            question = question._replace(snap=options.snap_normals)
        certificate = read_certificate(options.certificate,
                                       CERTIFICATE if options.direction is None else MARGIN)
        leaves = sum(node.kind == "leaf" for node in certificate.tree)
        report["verdict"] = certificate.verdict
        if certificate.verdict != "stable":
            report.update(nodes=len(certificate.tree), leaves=leaves)
        question = check_question(question, certificate.question)
        table = rows(question, options.grasp)
        if certificate.witness:
            check_witness(certificate.witness, question, table)
        elif certificate.verdict == "unstable":
            check_tree(certificate.tree, question, table)
        else:
            check_direction(certificate.direction, question)
            check_resisted(certificate.resisted)
            check_chain(certificate.segments, certificate.resisted, question, table)
            check_tree(certificate.tree, question, table, gaps(certificate.resisted))
            report["resisted"] = [[str(low), high if high is None else str(high)]
                                  for low, high in certificate.resisted]
        report["result"], code = "accepted", 0
        text = accepted(certificate, question, leaves)
    except Rejected as failure:
        report.update(result="rejected", rule=failure.rule, node=failure.node, path=failure.path,
                      found=failure.found)
        where = "" if failure.node is None else f" at node {failure.node}"
        where += "" if failure.path is None else f" ({failure.path})"
        text, code = f"rejected: {failure.rule}{where}: {failure.found}", 1
    except Malformed as failure:
        report.update(result="malformed", path=failure.place or None, found=str(failure),
                      verdict=None, nodes=None, leaves=None, resisted=None)
        print(failure, file=sys.stderr)
        code = 2
    if options.json or text is not None:
        print(json.dumps(report) if options.json else text, flush=True)
    return code


def main(arguments: Sequence[str]) -> int:
    """Exit code 0 says accepted and 1 says rejected; anything unforeseen must be neither."""
    if hasattr(sys, "set_int_max_str_digits"):  # Python 3.11's limit is below that of §2
        sys.set_int_max_str_digits(0)
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="backslashreplace")
    options = parse_arguments(arguments)
    try:
        return answer(options)
    except BrokenPipeError:  # nobody reads the answer; the interpreter must not try again
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 2
    except Exception as error:  # pylint: disable=broad-except
        print(f"check.py: internal error: {type(error).__name__}: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C: end without a traceback
    sys.exit(main(sys.argv[1:]))
