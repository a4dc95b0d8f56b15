#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks a stickslip certificate against a grasp file: FORMAT.md as a program.

Written from FORMAT.md and in its order, with nothing but the standard library of Python 3.9 or
newer; shares nothing with any solver or other checker. "§4" and the like are sections of
FORMAT.md; docs/grasp_file.md describes grasp files. Arithmetic is exact (integers and Fraction),
no floating point occurs. Exit codes: 0 accepted, 1 rejected, 2 malformed or wrong usage, 3 not
judged.
"""

from __future__ import annotations

import bisect
import errno
import functools
import itertools
import json
import math
import operator
import os
import re
import signal
import sys
from fractions import Fraction
from typing import (Any, Callable, Dict, Iterable, List, NamedTuple, NoReturn, Optional, Sequence, Set, TextIO, Tuple,
                    Type, TypeVar, Union)

Vector = Tuple[Fraction, ...]
Integers = Tuple[int, ...]

Matrix = Tuple[Vector, ...]  # by columns

PLANE, SPACE = 3, 6  # §1: the dimension of a body's motions and wrenches; of several D is another (§14)


class Malformed(Exception):
    """§8, exit 2: a file that is not what it should be, or a question that cannot be asked."""

    def __init__(self, file: str, place: str, problem: str) -> None:
        super().__init__(": ".join(part for part in (file, place, problem) if part))
        self.place, self.problem = place, problem


class Rejected(Exception):
    """§8, exit 1: a rule that the certificate fails, where, and what was found."""

    def __init__(self, rule: str, found: str, path: Optional[str] = None,
                 node: Optional[int] = None) -> None:
        super().__init__(found)
        self.rule, self.found, self.path, self.node = rule, found, path, node


class NotJudged(Exception):
    """§8, exit 3: the proof takes more work than this program does for files of their length."""


class Work:
    """§8: steps of about a microsecond, and products of words, counted and not timed; and, within `with Work():`,
    the most for files of so many bytes."""
    limited = False
    bytes_read = steps = products = 0

    def __enter__(self) -> None:
        Work.limited, Work.bytes_read, Work.steps, Work.products = True, 0, 0, 0

    def __exit__(self, *_: Any) -> None:
        Work.limited = False

    @classmethod
    def spend(cls, steps: int) -> None:
        cls.steps += steps
        most = 2_000_000 + cls.bytes_read ** 2 // 50
        if cls.limited and cls.steps > most:
            raise NotJudged(f"it takes more than {most} steps, the most for {cls.bytes_read} bytes")

    @classmethod
    def spend_products(cls, count: int) -> None:
        cls.products += count
        most = 500_000_000 + 5 * cls.bytes_read ** 2
        if cls.limited and cls.products > most:
            raise NotJudged(f"it takes more than {most} products of words, the most for {cls.bytes_read} bytes")

    @classmethod
    def multiply(cls, count: int, n: int, m: int) -> None:
        """So many products of numbers of n and m words: long ones cost less than they have digits."""
        if n > 1 or m > 1:
            least, most = min(n, m), max(n, m)
            cls.spend_products(count * (least * most if least <= 64 else int(8 * most * least ** 0.5)))

    @classmethod
    def divide(cls, count: int, n: int, m: int) -> None:
        """Common divisors and quotients, which take Python as many steps as there are products of digits."""
        if n > 1 or m > 1:
            cls.spend_products(count * n * m)


def words(vector: Sequence[int]) -> int:
    """Of 64 bits, of the longest; 1 or more."""
    return 1 + (max(map(int.bit_length, vector)) >> 6)


def weight(vector: Sequence[int]) -> int:
    """What a product with it costs, with numbers of a few words as the unit."""
    return 1 + (max(map(int.bit_length, vector)) >> 9)


def show(value: Any) -> str:
    """A number, vector or name for a message, shortened if long."""
    if type(value) is tuple:
        return "(" + ", ".join(map(show, value[:8])) + (", ...)" if len(value) > 8 else ")")
    if isinstance(value, dict):
        value = ", ".join(f"{key}={entry}" for key, entry in value.items())
    text = "none" if value is None else str(value)
    return text if len(text) <= 80 else f"{text[:40]}...{text[-20:]} ({len(text)} characters)"


def printable(text: str) -> str:
    """§8: every byte that is not printable ASCII as \\xNN."""
    return "".join(chr(byte) if 32 <= byte < 127 else f"\\x{byte:02x}"
                   for byte in text.encode("utf-8", "surrogateescape"))


def at(point: Sequence[Fraction], force: Sequence[Fraction]) -> Vector:
    """The wrench of a force at a point; what acts along a coordinate has no point, and one number (§14)."""
    if len(force) == 1:
        return tuple(force)
    if len(force) == 2:
        return (*force, point[0] * force[1] - point[1] * force[0])
    return (*force, *(point[j - 2] * force[j - 1] - point[j - 1] * force[j - 2] for j in range(3)))


def dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    """The sum of products of as many coordinates as the shorter of the two has."""
    if not a or type(a[0]) is int:
        return sum(map(operator.mul, a, b))
    # Of fractions many are 0, and each sum and product of two takes long.
    products = [x * y for x, y in zip(a, b) if x and y]
    return functools.reduce(operator.add, products) if products else Fraction(0)


def pulled(motion: Optional[Matrix], row: Vector) -> Vector:
    """§14: Gᵀ times the row. One body has no G, and then it is the row."""
    return row if motion is None else tuple(dot(row, column) for column in motion)


def pairwise_sum(terms: List[Sequence[Fraction]]) -> Vector:
    """Denominators that have nothing in common stay short for most of the additions."""
    while len(terms) > 1:
        odd = terms[len(terms) // 2 * 2:]
        terms = [tuple(x + y for x, y in zip(*pair)) for pair in zip(terms[::2], terms[1::2])] + odd
    return tuple(terms[0])


# ---- JSON, read exactly (§1, §2) --------------------------------------------------------------


class Numeral(NamedTuple):
    """A JSON number as it is spelled."""
    text: str


class Members(NamedTuple):
    """A JSON object: its members in the order of the file, repetitions included."""
    pairs: List[Tuple[str, Any]]


class FileKind(NamedTuple):
    """§2, Limits."""
    formats: Tuple[str, ...]
    byte_order_mark: bool  # may the file begin with one?
    max_bytes: int
    max_depth: int
    max_string: int   # bytes between the quotation marks
    max_numeral: int  # characters of a JSON number
    max_number: int   # characters of a number in a string
    max_values: int   # in one member; of `lists`, in one element
    lists: Tuple[str, ...]
    number: "re.Pattern[str]"  # [0-9], because \d and int() take other scripts' digits too


GRASP = FileKind(("stickslip-grasp/1", "stickslip-grasp/2", "stickslip-grasp/3"), True, 1 << 28, 32,
                 1 << 28, 16_384, 16_384, 1 << 16, ("contacts",), re.compile(
                     r"([+-]?[0-9]+)(?:/([0-9]+)|(?:\.([0-9]+))?(?:[eE]([+-]?[0-9]+))?)"))
CERTIFICATE = FileKind(("stickslip-certificate/2",), False, 1 << 30, 8, 65_536, 4_000, 65_536,
                       1 << 22, ("segments", "tree", "parts", "intervals", "pieces", "states"),
                       re.compile(r"(-?[0-9]+)(?:/([0-9]+))?()()"))
MAX_EXPONENT = 4096
BEYOND_NUMERALS = 2 ** 16384 - 2 ** 16319  # what rounds to 2^16384 with a mantissa of 64 bits
MAX_CONTACTS = 1_000_000
MAX_DIMENSION, MOST_DIMENSION, GROUND = 30, 65_536, "ground"  # §14

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
    digits, power = int(whole + (decimals or "")), power - len(decimals or "")
    return Fraction(digits, 10 ** -power) if power < 0 else Fraction(digits * 10 ** power)


def count_values(value: Any, most: int) -> int:
    """The values in a value, itself included, or at least the first `most` + 1 of them."""
    waiting, count = [value], 0
    while waiting and count <= most:
        count += 1
        inside = waiting.pop()
        if type(inside) is list:
            waiting += inside
        elif type(inside) is Members:
            waiting += [content for _, content in inside.pairs]
    return count


class Source:
    """One JSON file: its content, and errors that name the file and the place in it."""

    def __init__(self, name: str, kind: FileKind, rowless: bool = False) -> None:
        self.name, self.kind = "<stdin>" if name == "-" else name, kind
        self.rowless = rowless  # of a grasp file: is it about statics (§16), or of many coordinates (§14)?
        self.uncertain = ""  # where an interval or a slope was found first
        self.dimension = PLANE  # D of a certificate; in a grasp file that of one body
        self.space = False
        self.several = False    # is a certificate about several bodies?
        self.soft: Set[int] = set()  # its contacts with torsion (§15)
        self.limits = 0         # and how many elements with limits it is about (§16)
        self.gravity: Vector = ()    # of a grasp file, if it has one
        self.frictions: Dict[str, Bounds] = {}  # of a grasp file, those with names
        text = self.read(name)
        self.limit(text)
        try:
            self.root = json.loads(text, parse_int=Numeral, parse_float=Numeral,
                                   parse_constant=lambda name: self.fail("", f"not JSON: {name}"),
                                   object_pairs_hook=Members)
        except json.JSONDecodeError as error:
            before, after = text[:error.pos].rstrip(), text[error.pos:].lstrip()
            comma = before.endswith(",") or after.startswith(",")
            trailing = comma and after.lstrip(", \t\n\r")[:1] in ("]", "}")
            self.fail(f"line {error.lineno}, column {error.colno}",
                      "the file is empty" if not text.strip(" \t\n\r") else
                      "a comma after the last element; remove it" if trailing else
                      f"not JSON: {error.msg}")
        except RecursionError:
            self.fail("", "nested too deeply")
        if "\\u" in text:
            try:
                json.dumps(self.root, ensure_ascii=False).encode("utf-8")
            except UnicodeEncodeError:
                self.fail("", "a \\u escape that is half of a surrogate pair")
        for key, value in self.root.pairs if type(self.root) is Members else ():
            for part in value if key in kind.lists and type(value) is list else [value]:
                if count_values(part, kind.max_values) > kind.max_values:
                    self.fail(key, f"more than {kind.max_values} values in one place")

    def read(self, name: str) -> str:
        if name != "-" and os.path.isdir(name):
            self.fail("opening", "it is a directory; name a file, or - for standard input")
        try:
            with open(sys.stdin.fileno() if name == "-" else name, "rb") as file:
                # In pieces, as read() makes room for all that it may read.
                pieces, left = [], self.kind.max_bytes + 1
                while left and (not pieces or pieces[-1]):
                    pieces.append(file.read(min(left, 1 << 16)))
                    left -= len(pieces[-1])
                data = b"".join(pieces)
        except (OSError, ValueError, AttributeError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            self.fail("opening", f"{reason}; name a file, or - for standard input")
        Work.bytes_read += len(data)
        if len(data) > self.kind.max_bytes:
            self.fail("", f"longer than {self.kind.max_bytes} bytes")
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError as error:
            self.fail(f"byte {error.start}", "not UTF-8")
        if text.startswith("\ufeff"):
            if not self.kind.byte_order_mark:
                self.fail("byte 0", "a byte order mark; use UTF-8 without one")
            text = text[1:]
        return text

    def limit(self, text: str) -> None:
        depth = 0
        for match in STRING_OR_BRACKET.finditer(text):
            depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(text[match.start()], 0)
            problem = None
            if depth > self.kind.max_depth:
                problem = f"nesting deeper than {self.kind.max_depth}"
            elif match.end() - match.start() > self.kind.max_string // 4:  # at most 4 bytes each
                if len(match.group().encode("utf-8")) > self.kind.max_string + 2:
                    problem = f"a string of more than {self.kind.max_string} bytes"
            if problem:
                self.fail(f"line {text.count(chr(10), 0, match.start()) + 1}", problem)

    @property
    def coordinates(self) -> int:
        """Of positions, normals and points."""
        return 3 if self.space else 2

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
                self.fail(place, f"unknown member '{show(key)}' (known: {', '.join(known)})"
                                 + "; to snap normals, run: stickslip snap GRASP -o FILE"
                                 * (key == "normals" and not place))
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
        """§11: a version that is not known is malformed."""
        if type(value) is not str or value not in self.kind.formats:
            known = " or ".join(f'"{name}"' for name in self.kind.formats)
            self.fail("format", f"must be {known}; no other is known here")

    def choice(self, value: Any, place: str, words: Tuple[str, ...]) -> str:
        if type(value) is not str or value not in words:
            self.fail(place, f"must be one of: {', '.join(words)}")
        return value

    def array(self, value: Any, place: str, length: Optional[int] = None) -> List[Any]:
        if type(value) is not list or (length is not None and len(value) != length):
            self.fail(place, "must be an array" + ("" if length is None else f" of {length}"))
        return value

    def number(self, value: Any, place: str) -> Fraction:
        is_numeral = type(value) is Numeral
        if is_numeral:
            value = value.text
            if len(value) > self.kind.max_numeral:
                self.fail(place, f"a JSON number of more than {self.kind.max_numeral} characters; "
                                 "write it as a string")
        elif type(value) is not str:
            self.fail(place, "must be a number or a string that spells one")
        try:
            found = rational(value, self.kind)
        except ValueError as error:
            self.fail(place, str(error))
        if is_numeral and abs(found) >= BEYOND_NUMERALS:
            self.fail(place, "a JSON number must be below 2^16384; a string spells larger ones")
        return found

    def vector(self, value: Any, place: str, length: Optional[int] = None) -> Vector:
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
CLASSES = ("must move", "must hold", "open")  # §13
STATICS = ("may stand", "must move")  # §16
STATES = ("slip", "full", "closed")  # §17
ROBUSTNESSES = ("contact", "grasp")  # §18


class Bounds(NamedTuple):
    """The numbers from low to high."""
    low: Fraction
    high: Fraction

    @property
    def certain(self) -> bool:
        return self.low == self.high

    @property
    def middle(self) -> "Bounds":
        return exactly((self.low + self.high) / 2)

    def __str__(self) -> str:
        return str(self.low) if self.certain else f"[{self.low}, {self.high}]"


def exactly(number: Fraction) -> Bounds:
    return Bounds(number, number)


def zeros(count: int) -> Vector:
    return (Fraction(0),) * count


Wrench = Tuple[Bounds, ...]


def exact_wrench(wrench: Sequence[Fraction]) -> Wrench:
    return tuple(map(exactly, wrench))


class Contact(NamedTuple):
    """A contact as the grasp file gives it; its normal n⁰ has any length but 0. Or another element of
    §14, with its row for `motion`: it has no position, and one number as normal, 1."""
    position: Tuple[Bounds, ...]
    normal: Vector
    slope: Fraction
    friction: Bounds
    stiffness: Bounds
    preload: Bounds
    place: str = ""         # in the grasp file
    motion: Optional[Matrix] = None  # §14: G, if the grasp is of several bodies
    spring: str = ""        # what a spring's τ is called in the grasp file; "" of all others
    torsion: Fraction = Fraction(0)  # §15: e
    of: str = ""   # the body that it touches, which has no name if it is the only one
    by: str = GROUND
    over: Dict[str, Fraction] = {}  # of a ratchet or a tendon: the numbers of links
    joint: int = -1                 # of a joint's spring: its coordinate
    limit: Optional[Fraction] = None  # §16: A

    def is_contact(self) -> bool:
        return bool(self.position)

    @property
    def gamma(self) -> Fraction:
        """§1"""
        return self.torsion ** 2 / dot(self.normal, self.normal)


Pushes = List[Tuple[Optional[str], Wrench]]  # each a wrench on the body of that name, or w itself


class Grasp(NamedTuple):
    contacts: List[Contact]   # or elements
    common: Pushes            # of all cases
    cases: Dict[str, Pushes]  # what else there is in each, by name
    space: bool
    bodies: Bodies
    choose: bool              # has a case to be chosen?
    names: Tuple[str, ...] = ()  # §14: of the coordinates, if the grasp is of several bodies
    motions: Dict[str, Matrix] = {}  # J of each of them, unless there are no rows
    joints: int = 0
    max_motion: Optional[Vector] = None  # §1: B

    @property
    def dimension(self) -> int:
        """D"""
        return self.bodies.dimension


KINDS = ("friction", "stiffness", "preload", "position", "normal", "wrench")


class Tolerance(NamedTuple):
    size: Fraction
    percent: bool

    def __str__(self) -> str:
        return f"{self.size}{'%' * self.percent}"

    def widen(self, number: Bounds) -> Bounds:
        """§6, the question."""
        below, above = (self.size * abs(end) / 100 if self.percent else self.size for end in number)
        return Bounds(number.low - below, number.high + above)

    def refusal(self, kind: str) -> str:
        return ("must be >= 0" if self.size < 0 else
                "must be a slope, such as 0.01" if kind == "normal" and self.percent else "")


class Ball(NamedTuple):
    """§6, a ball of loads."""
    radius: Fraction
    length: Fraction
    about: Vector        # () of an option that leaves it out
    body: Optional[str]  # of several bodies

    def __str__(self) -> str:
        about = ", ".join(map(str, self.about))
        return (f"ball:{self.radius}, length {self.length}" + f", about ({about})" * bool(self.about)
                + ("" if self.body is None else f', on the body "{printable(self.body)}"'))

    def refusal(self, _: str) -> str:
        return ("the radius must be > 0" if self.radius <= 0 else
                "the length must be > 0" if self.length <= 0 else "")


class Loads(NamedTuple):
    """§6, the work of loads: all w = w⁰ + B z with each z_j within its bounds and, of a ball, z in it."""
    base: Vector             # w⁰
    moves: Optional[Matrix]  # B, by columns; None where it is 1
    bounds: Wrench           # of z
    radii: Vector = ()       # of a ball: how far each z_j goes in it

    def most_work(self, y: Sequence[Fraction]) -> Fraction:
        """Λ(y)."""
        moved = pulled(self.moves, tuple(y))
        most = sum((max(c * end for end in bounds) for c, bounds in zip(moved, self.bounds)), Fraction(0))
        if self.radii:
            most = min(most, root_above(sum(((r * c) ** 2 for r, c in zip(self.radii, moved)), Fraction(0))))
        return most + Fraction(dot(self.base, y))

    def middle(self) -> Loads:
        """Those of q⁰."""
        return self._replace(bounds=tuple(exactly(min(max(z.low, Fraction(0)), z.high)) if self.radii else z.middle
                                          for z in self.bounds))


def loads_within(wrench: Wrench) -> Loads:
    return Loads(zeros(len(wrench)), None, wrench)


class Options(NamedTuple):
    """What whoever asks chooses; None leaves the grasp file's own values."""
    wrench: Optional[Vector] = None
    preload: Optional[Fraction] = None
    law: str = LAWS[0]
    direction: Optional[Vector] = None
    preload_direction: Union[None, str, Vector] = None  # "scale", or a number for each contact
    case: Optional[str] = None  # whose wrench is asked about, if none is given
    uncertain: Optional[Dict[str, Union[Tolerance, Ball]]] = None  # by kind
    plane: Optional[Tuple[Vector, Vector]] = None     # §12: u and v
    inertia: Optional[Vector] = None                  # §13: the centre of mass and γ²
    statics: Optional[Fraction] = None                # §16: φ
    max_motion: Optional[Vector] = None  # B, or a length and an angle, or () for none; of a question B, or None
    states: Optional[str] = None                      # §17: one of STATES
    robustness: Optional[str] = None                  # §18: one of ROBUSTNESSES
    length: Optional[Fraction] = None                 # §18: L
    max_force: Optional[Vector] = None                # §18: f, of a question of each contact

    def margin(self) -> bool:
        return self.direction is not None or self.preload_direction is not None

    def family(self) -> str:
        """What is about one grasp and many loads or preloads, if that is asked."""
        return ("the set of states" if self.states else
                "a robustness" if self.robustness else
                "statics" if self.statics is not None else
                "a margin" if self.margin() else "a region" if self.plane else
                "a class" if self.inertia else "")


class Row(NamedTuple):
    """What is known of one contact."""
    N: Vector
    slip: List[Vector]  # T, or the rows of S; friction acts along them
    friction: Fraction
    v: Vector  # v_i(x) = v·x for a point x = (d, h, ℓ)
    normal: Vector
    gamma: Fraction  # §1
    spring: bool

    @property
    def longest(self) -> Fraction:
        """The square of the length that a share has at most."""
        return Fraction(1) if len(self.normal) == 2 else dot(self.normal, self.normal)


def starred(s: Vector, gamma: Fraction) -> Vector:
    """§1: s*, whose product with t is ⟨s, t⟩."""
    return s[:3] + tuple(gamma * c for c in s[3:])


def force_square(f: Vector, gamma: Fraction) -> Fraction:
    """§1: the square of the length of friction, or of a share."""
    return dot(f[:3], f[:3]) + sum(c * c / gamma for c in f[3:])


class Question(NamedTuple):
    """About one grasp, or about a box (§6), statics (§16) or many coordinates (§14), and then without rows."""
    asked: Options
    wrench: Wrench            # w, before it is widened
    loads: Loads              # w
    growths: Tuple[Vector, ...]  # u; §12: u and v
    contacts: List[Contact]   # with what was replaced and widened
    preload_growth: Vector    # Pᵘ
    rows: List[Row]
    is_box: bool
    space: bool = False
    names: Tuple[str, ...] = ()  # §14: of the coordinates
    claims: bool = False  # §5: is a margin a list of claims?
    bodies: Optional[Bodies] = None

    @property
    def large(self) -> bool:
        """§14: has it many coordinates?"""
        return self.asked.statics is None and len(self.wrench) > MAX_DIMENSION

    def slipping(self) -> int:
        """How many are contacts; other elements follow."""
        return sum(contact.is_contact() for contact in self.contacts)

    def springs(self) -> int:
        """They are the last."""
        return sum(bool(contact.spring) for contact in self.contacts)

    def w(self) -> Vector:
        """Of one grasp."""
        return tuple(entry.low for entry in self.wrench)


def rational_root(square: Fraction) -> Optional[Fraction]:
    root = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
    return root if root * root == square else None


def read_bounds(source: Source, value: Any, place: str) -> Bounds:
    """A number, or an INTERVAL of §6."""
    if type(value) is not Members:
        return exactly(source.number(value, place))
    source.uncertain = source.uncertain or place
    fields = source.members(value, place, "min max")
    low, high = (source.number(fields[key], f"{place}.{key}") for key in ("min", "max"))
    if low > high:
        source.fail(place, f"min {show(low)} is above max {show(high)}, must be min <= max")
    return Bounds(low, high)


def read_vector_of_bounds(source: Source, value: Any, place: str, length: int) -> Wrench:
    return tuple(read_bounds(source, entry, f"{place}[{j}]")
                 for j, entry in enumerate(source.array(value, place, length)))


PI = Fraction("3.14159265358979323846264338328")


def direction_at(degrees: Fraction) -> Vector:
    """§1, *angles*: the vector that stands for this direction."""
    quarter = math.floor((degrees + 45) / 90)
    rest = degrees - 90 * quarter
    x, y = Fraction(1), Fraction(-1 if rest == -45 else 0)
    if rest not in (-45, 0):
        half = Fraction(math.floor(rest * PI / 360 * 2 ** 64), 2 ** 64)
        cosine = sine = Fraction(1)  # sine over half
        for k in (4, 3, 2, 1, 0):
            cosine = 1 - half * half * cosine / ((2 * k + 1) * (2 * k + 2))
            sine = 1 - half * half * sine / ((2 * k + 2) * (2 * k + 3))
        t = Fraction(math.floor(half * sine / cosine * 2 ** 32 + Fraction(1, 2)), 2 ** 32)
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(quarter % 4):
        x, y = -y, x
    return (x, y)


def read_normal(source: Source, value: Any, place: str) -> Tuple[Vector, Fraction]:
    """n⁰ and the slope."""
    if type(value) is not Members:
        return read_point_of(source, value, place), Fraction(0)
    source.uncertain = source.uncertain or place  # version 1 has no angles either
    by_angle = any(key == "angle" for key, _ in value.pairs)
    fields = source.members(value, place, "angle slope?" if by_angle else "direction slope")
    if by_angle:
        if source.space:
            source.fail(f"{place}.angle", "the grasp is in space; give [x, y, z]")
        normal = direction_at(source.number(fields["angle"], f"{place}.angle"))
        if "slope" not in fields:
            return normal, Fraction(0)
    slope = source.number(fields["slope"], f"{place}.slope")
    if not 0 <= slope < 1:
        source.fail(f"{place}.slope", f"{show(slope)} is out of range, must be >= 0 and < 1")
    if by_angle:
        return normal, slope
    return read_point_of(source, fields["direction"], f"{place}.direction"), slope


def read_point_of(source: Source, value: Any, place: str) -> Vector:
    """So many numbers as a point has."""
    return source.vector(value, place, source.coordinates)


def coefficients(source: Source, fields: Dict[str, Any], place: str) -> Dict[str, Bounds]:
    """Those of μ ≥ 0, k > 0, P ≥ 0 and e ≥ 0 that an object of the grasp file states."""
    found = {}
    for key in ("friction", "stiffness", "preload"):
        if key == "friction" and type(fields.get(key)) is str and not begins_as_number(fields[key]):
            if fields[key] not in source.frictions:
                source.fail(f"{place}.{key}", "must be a number, or a name in 'friction' of the file")
            found[key] = source.frictions[fields[key]]
        elif key in fields:
            found[key] = read_bounds(source, fields[key], f"{place}.{key}")
            low = found[key].low
            if low < 0 or (key == "stiffness" and low == 0):
                source.fail(f"{place}.{key}", f"{show(low)} is out of range, must be "
                                              + ("> 0" if key == "stiffness" else ">= 0"))
    if "torsion" in fields:
        torsion = source.number(fields["torsion"], f"{place}.torsion")
        if torsion < 0 or not source.space:
            source.fail(f"{place}.torsion", f"{show(torsion)} is out of range, must be >= 0" if source.space else
                        "the grasp is in the plane, and has none")
        found["torsion"] = exactly(torsion)
    if "max_force" in fields:
        found["max_force"] = exactly(read_limit(source, fields["max_force"], f"{place}.max_force"))
    return found


def read_limit(source: Source, value: Any, place: str) -> Fraction:
    limit = source.number(value, place)
    if limit < 0:
        source.fail(place, f"{show(limit)} is out of range, must be >= 0")
    return limit


def begins_as_number(text: str) -> bool:
    return text[:1] in tuple("+-.0123456789") or not text


def read_common(source: Source, top: Dict[str, Any]) -> None:
    """§1: gravity, and friction by name."""
    if "gravity" in top:
        source.gravity = read_point_of(source, top["gravity"], "gravity")
    named = top.get("friction", Members([]))
    if type(named) is not Members:
        source.fail("friction", "must be an object")
    for name, value in named.pairs:
        place = f"friction.{show(name)}"
        if begins_as_number(name):
            source.fail(place, "must be a name that begins neither with a digit nor with +, - or .")
        if name in source.frictions:
            source.fail("friction", f"member '{show(name)}' is repeated")
        source.frictions[name] = read_bounds(source, value, place)
        if source.frictions[name].low < 0:
            source.fail(place, f"{show(source.frictions[name].low)} is out of range, must be >= 0")


class Body(NamedTuple):
    name: str
    on: str                   # of links
    turn: Optional[Vector]    # η of links
    joints: Dict[int, Fraction] = {}  # of links: c_bq, by the coordinate of q
    first: int = 0            # of one that is no link: its first coordinate


class Bodies(NamedTuple):
    """§14; of one body it is that alone. Lists go from a body to those that are on it, so that one pass over
    them says how all move, or what acts on all coordinates, in a time that is linear in the size of the file."""
    bodies: Dict[str, Body]
    size: int       # of a motion of one body
    dimension: int  # D

    def known(self, source: Source, name: Any, place: str, ground: bool = False) -> str:
        """That of a body."""
        if type(name) is not str or not (name in self.bodies or (name == GROUND and ground)):
            source.fail(place, "must be the name of a body" + f" or '{GROUND}'" * ground)
        return str(name)

    def row_over(self, over: Dict[str, Fraction]) -> Dict[int, Fraction]:
        """The row of an object of `over`, by coordinate."""
        row: Dict[int, Fraction] = {}
        for name, r in over.items():
            Work.spend(len(self.bodies[name].joints))
            for q, c in self.bodies[name].joints.items():
                row[q] = row.get(q, Fraction(0)) + r * c
        return row

    def matrices(self) -> Dict[str, Matrix]:
        """J of each, and of the ground."""
        found: Dict[str, Matrix] = {GROUND: (zeros(self.size),) * self.dimension}
        for name, on, turn, joints, first in self.bodies.values():
            found[name] = (tuple(unit(self.size, q - first) for q in range(self.dimension)) if turn is None else
                           tuple(plus(column, joints.get(q, Fraction(0)), turn) for q, column in enumerate(found[on])))
        return found

    def moved(self, y: Vector) -> Tuple[Dict[str, Vector], Dict[str, Fraction]]:
        """J y of each and of the ground, and how far links turn."""
        motions, turned = {GROUND: zeros(self.size)}, {}
        for name, on, turn, joints, first in self.bodies.values():
            Work.spend(6 + 2 * len(joints))
            if turn is None:
                motions[name] = y[first:first + self.size]
                continue
            (angle,) = pairwise_sum([(c * y[q],) for q, c in joints.items()])
            count_words((*motions[on], angle, *turn), 2 * self.size + len(joints))
            turned[name], motions[name] = angle, plus(motions[on], angle, turn)
        return motions, turned

    def gathered(self, wrenches: Dict[str, List[Vector]], work: Dict[str, List[Fraction]],
                 along: Dict[int, List[Fraction]]) -> Vector:
        """The sum of Jᵀ times the wrenches on bodies, of forces that do so much work as links turn, and of those
        along coordinates. What is given is used up."""
        total = [Fraction(0)] * self.dimension
        for name, on, turn, joints, first in reversed(list(self.bodies.values())):
            here = wrenches.get(name, [])
            if not here and name not in work:
                continue
            sum_ = summed(here) if here else zeros(self.size)
            if turn is None:
                total[first:first + self.size] = sum_
                continue
            count_words((*sum_, *turn), self.size)
            (push,) = summed([(one,) for one in (dot(sum_, turn), *work.get(name, []))])
            for q, c in joints.items():
                along.setdefault(q, []).append(c * push)
            if here and on != GROUND:
                wrenches.setdefault(on, []).append(sum_)
        for q, pushes in along.items():
            (total[q],) = summed([(push,) for push in pushes])
        return tuple(total)


def count_words(numbers: Sequence[Fraction], count: int) -> None:
    """§8: so many sums or products of them, with their common divisors."""
    longest = 1 + (max(max(x.numerator.bit_length(), x.denominator.bit_length()) for x in numbers) >> 6)
    Work.divide(2 * count, 2 * longest, longest)


def summed(terms: List[Vector]) -> Vector:
    """Counted as work; one or more."""
    Work.spend(len(terms))
    for term in terms:
        count_words(term, len(term))
    return pairwise_sum(list(terms))


def read_one_load(source: Source, value: Any, place: str, bodies: Optional[Bodies]) -> Tuple[Optional[str], Wrench]:
    """The wrench of a force at a point, of a torque or of a weight; of several bodies also the name of one."""
    kinds = [key for key, _ in value.pairs] if type(value) is Members else []
    body = "body " if bodies else ""
    if "torque" in kinds:
        torque = source.members(value, place, body + "torque")["torque"]
        found = ((source.number(torque, f"{place}.torque"),) if not source.space else
                 source.vector(torque, f"{place}.torque", 3))
        wrench = exact_wrench(zeros(source.dimension - len(found)) + found)
    elif "weight" in kinds:
        fields = source.members(value, place, body + "weight at direction?")
        weight = source.number(fields["weight"], f"{place}.weight")
        if weight < 0:
            source.fail(f"{place}.weight", f"{show(weight)} is out of range, must be >= 0")
        direction = source.gravity or (*zeros(source.coordinates - 1), Fraction(-1))
        if "direction" in fields:
            direction = read_point_of(source, fields["direction"], f"{place}.direction")
        length = rational_root(dot(direction, direction))
        if not length:
            source.fail(f"{place}.direction",
                        "must have a rational length that is not 0, as [3, -4] has")
        force = tuple(weight * c / length for c in direction)
        wrench = exact_wrench(at(read_point_of(source, fields["at"], f"{place}.at"), force))
    elif "mass" in kinds:
        fields = source.members(value, place, body + "mass at")
        mass = source.number(fields["mass"], f"{place}.mass")
        if mass < 0:
            source.fail(f"{place}.mass", f"{show(mass)} is out of range, must be >= 0")
        gravity = source.gravity or (*zeros(source.coordinates - 1), Fraction(-981, 100))
        wrench = exact_wrench(at(read_point_of(source, fields["at"], f"{place}.at"), times(mass, gravity)))
    elif "wrench" in kinds and bodies:
        fields = source.members(value, place, "body wrench")
        wrench = read_vector_of_bounds(source, fields["wrench"], f"{place}.wrench", source.dimension)
        if bodies.bodies[bodies.known(source, fields["body"], f"{place}.body")].turn:
            source.fail(f"{place}.wrench", f"{show(fields['body'])} is a link; give a force at a point, a weight or a torque")
    else:
        fields = source.members(value, place, body + "force at")
        force = read_point_of(source, fields["force"], f"{place}.force")
        wrench = exact_wrench(at(read_point_of(source, fields["at"], f"{place}.at"), force))
    return bodies.known(source, dict(value.pairs)["body"], f"{place}.body") if bodies else None, wrench


def wrench_of(pushes: Pushes, bodies: Bodies) -> Wrench:
    """Their sum. Where an end of an interval is not the other, J has ones and zeros alone."""
    ends = []
    for end in (0, 1):
        whole, wrenches = [zeros(bodies.dimension)], {}
        for name, wrench in pushes:
            one = tuple(bounds[end] for bounds in wrench)
            (whole if name is None else wrenches.setdefault(name, [])).append(one)
        ends.append(pairwise_sum(whole + [bodies.gathered(wrenches, {}, {})]))
        if all(bounds.certain for _, wrench in pushes for bounds in wrench):
            return exact_wrench(ends[0])
    return tuple(map(Bounds, *ends))


def read_load(source: Source, fields: Dict[str, Any], place: str, needed: bool,
              bodies: Optional[Bodies] = None) -> Pushes:
    """§1: "wrench" or "loads"."""
    given = [key for key in ("wrench", "loads") if key in fields]
    if len(given) > 1 or (needed and not given):
        source.fail(place.rstrip("."), "both 'wrench' and 'loads'; give one of them" if given else
                                       "'wrench' is missing (in version 2, that or 'loads')")
    if "wrench" in fields:
        return [(None, read_vector_of_bounds(source, fields["wrench"], place + "wrench",
                                             bodies.dimension if bodies else source.dimension))]
    return [read_one_load(source, load, f"{place}loads[{k}]", bodies)
            for k, load in enumerate(source.array(fields.get("loads", []), place + "loads"))]


def read_cases(source: Source, value: Any, bodies: Optional[Bodies] = None) -> Dict[str, Pushes]:
    cases: Dict[str, Pushes] = {}
    for k, entry in enumerate(source.array(value, "cases")):
        place = f"cases[{k}]"
        fields = source.members(entry, place, "name wrench? loads?")
        name = fields["name"]
        if type(name) is not str or not name or name in cases:
            source.fail(f"{place}.name", "must be a string, not empty, and of this case alone")
        cases[name] = read_load(source, fields, place + ".", True, bodies)
    if not cases:
        source.fail("cases", "must not be empty")
    return cases


def spread(length: Fraction, angle: Fraction, dimension: int, space: bool) -> Vector:
    """§1, max motion: B of a length and an angle, where there are no joints."""
    return ((length, length, angle) if not space else (length,) * 3 + (angle,) * 3) * (dimension // (SPACE if space else PLANE))


def read_max_motion(source: Source, top: Dict[str, Any], dimension: int, joints: int) -> Optional[Vector]:
    """§1: B, if the grasp file has it."""
    if "max_motion" not in top:
        return None
    value = top["max_motion"]
    if type(value) is not Members:
        bound = source.vector(value, "max_motion", dimension)
    elif joints:
        source.fail("max_motion", f"must be an array of {dimension}, a number for each coordinate, as there are joints")
    else:
        fields = source.members(value, "max_motion", "length angle")
        length, angle = (source.number(fields[key], f"max_motion.{key}") for key in ("length", "angle"))
        bound = spread(length, angle, dimension, source.space)
    if min(bound) <= 0:
        source.fail("max_motion", f"{show(min(bound))} is out of range, must be > 0")
    return bound


class Edge(NamedTuple):
    """Of the outline, in the sense of its ring."""
    start: Vector
    end: Vector
    inwards: Vector  # the normal of contacts on it


def depth_of(value: Any) -> int:
    """Of arrays, first elements within first elements."""
    depth = 0
    while type(value) is list:
        value, depth = value[0] if value else None, depth + 1
    return depth


def read_ring(source: Source, value: Any, place: str, hole: bool) -> List[Edge]:
    """§1: the edges, and on which side of them the body is."""
    ring = [source.vector(vertex, f"{place}[{i}]", 2)
            for i, vertex in enumerate(source.array(value, place))]
    if len(ring) < 3:
        source.fail(place, "must have three vertices or more")
    sides = list(zip(ring, ring[1:] + ring[:1]))
    area = sum(a[0] * b[1] - a[1] * b[0] for a, b in sides)
    if area == 0 or any(a == b for a, b in sides):
        source.fail(place, "must have an area, and no vertex that is the same as the next")
    side = -1 if (area > 0) == hole else 1
    edges = []
    for a, b in sides:
        n = (side * (a[1] - b[1]), side * (b[0] - a[0]))
        length = rational_root(dot(n, n)) or 1
        edges.append(Edge(a, b, (n[0] / length, n[1] / length)))
    return edges


def read_outline(source: Source, value: Any, where: str = "outline") -> List[List[Edge]]:
    """The edges of each polygon. A list of polygons, a list of rings, or a ring."""
    depth = depth_of(value)
    if depth < 2:
        source.fail(where, "must be a list of polygons [[[[x, y], ...]]]")
    for _ in range(4 - depth):
        value = [value]
    outline = []
    for j, polygon in enumerate(value):
        place = f"{where}[{j}]"
        if not source.array(polygon, place):
            source.fail(place, "must have one ring or more")
        outline.append([edge for k, ring in enumerate(polygon)
                        for edge in read_ring(source, ring, f"{place}[{k}]", k > 0)])
    return outline


def check_body(source: Source, value: Any, where: str = "body") -> None:
    """§1: it has no meaning here."""
    fields = source.members(value, where, "vertices faces")
    vertices = source.array(fields["vertices"], f"{where}.vertices")
    for i, vertex in enumerate(vertices):
        source.vector(vertex, f"{where}.vertices[{i}]", 3)
    faces = source.array(fields["faces"], f"{where}.faces")
    if not faces:
        source.fail(f"{where}.faces", "must have one face or more")
    for j, face in enumerate(faces):
        place = f"{where}.faces[{j}]"
        if len(source.array(face, place)) < 3:
            source.fail(place, "must have three vertices or more")
        for k, entry in enumerate(face):
            index = source.number(entry, f"{place}[{k}]")
            if index.denominator != 1 or not 0 <= index < len(vertices):
                source.fail(f"{place}[{k}]", f"there is no vertex {show(index)}")


def read_place(source: Source, value: Any, place: str,
               outline: Sequence[List[Edge]]) -> Tuple[Vector, Vector]:
    """§1: position and normal of a contact on the outline."""
    polygon = Fraction(0)
    if type(value) is list:
        edge, share = source.vector(value, place, 2)
    else:
        fields = source.members(value, place, "polygon? edge share")
        if "polygon" in fields:
            polygon = source.number(fields["polygon"], f"{place}.polygon")
        edge, share = (source.number(fields[key], f"{place}.{key}") for key in ("edge", "share"))
    if not 0 <= share <= 1:
        source.fail(place, f"the share {show(share)} is not from 0 to 1")

    def choose(entries: List[Any], index: Fraction, what: str) -> Any:
        if index.denominator != 1 or not 0 <= index < len(entries):
            source.fail(place, f"there is no {what} {show(index)}")
        return entries[int(index)]

    start, end, inwards = choose(choose(outline, polygon, "polygon"), edge, "edge")
    return tuple(a + share * (b - a) for a, b in zip(start, end)), inwards


def show_dimension(source: Source, top: Dict[str, Any]) -> None:
    """§1, §14: which grasps are in space."""
    contacts = top["contacts"]
    shown, length = top.get("wrench") if top["format"] == GRASP.formats[1] else None, SPACE
    if contacts:
        first = contacts[0] if type(contacts) is list else None
        length = 3
        shown = dict(first.pairs).get("position") if type(first) is Members else None
    if top["format"] != GRASP.formats[0] and type(shown) is list and len(shown) == length:
        source.dimension, source.space = SPACE, True


def read_defaults(source: Source, top: Dict[str, Any]) -> Dict[str, Bounds]:
    """And what all versions have."""
    if type(top.get("name", "")) is not str:
        source.fail("name", "must be a string")
    if "units" in top:
        for key, unit in source.members(top["units"], "units", "length force").items():
            if type(unit) is not str or not 1 <= len(unit.encode("utf-8")) <= 16:
                source.fail(f"units.{key}", "must be a string of 1 to 16 bytes")
    stated = source.members(top.get("defaults", Members([])), "defaults",
                            "friction? stiffness? preload?" + " torsion? max_force?" * ("bodies" in top))
    if len(source.array(top["contacts"], "contacts")) > MAX_CONTACTS:
        source.fail("contacts", "too many contacts")
    show_dimension(source, top)
    read_common(source, top)
    return {"stiffness": exactly(Fraction(1)), "preload": exactly(Fraction(0)), "torsion": exactly(Fraction(0)),
            **coefficients(source, stated, "defaults")}


def read_contact(source: Source, fields: Dict[str, Any], place: str, defaults: Dict[str, Bounds],
                 outline: Sequence[List[Edge]] = ()) -> Contact:
    values = {**defaults, **coefficients(source, fields, place)}
    if "friction" not in values:
        source.fail(place, "'friction' is missing, here and in defaults")
    if "on" in fields:
        point, normal = read_place(source, fields["on"], f"{place}.on", outline)
        position, slope = tuple(map(exactly, point)), Fraction(0)
    else:
        position = read_vector_of_bounds(source, fields["position"], f"{place}.position",
                                         source.coordinates)
        normal, slope = read_normal(source, fields["normal"], f"{place}.normal")
    if not any(normal):
        source.fail(f"{place}.normal", "must not be zero")
    limit = None
    if "max_force" in values:
        length = rational_root(dot(normal, normal))
        if length is None:
            source.fail(f"{place}.max_force", "must be of a contact whose normal has a rational length")
        limit = values["max_force"].low / length
    return Contact(position, normal, slope, values["friction"], values["stiffness"],
                   values["preload"], place, torsion=values["torsion"].low, limit=limit)


def read_grasp(name: str, statics: bool) -> Grasp:
    """§1, §14: what the grasp file says."""
    source = Source(name, GRASP, statics)
    given = dict(source.root.pairs) if type(source.root) is Members else {}
    if given.get("format") == GRASP.formats[2] or "bodies" in given:
        return read_several(source)
    top = source.members(source.root, "",
                         "format name? units? outline? body? defaults? contacts wrench? loads? "
                         "cases? max_motion? gravity? friction?")
    source.check_format(top["format"])
    for key in ("units", "outline", "body", "loads", "cases", "max_motion", "gravity", "friction"):
        if key in top and top["format"] == GRASP.formats[0]:
            source.fail("", f"'{key}' needs \"format\": \"{GRASP.formats[1]}\"")
    defaults = read_defaults(source, top)
    if "outline" in top and source.space:
        source.fail("outline", "the grasp is in space, and has none")
    if "body" in top:
        if not source.space:
            source.fail("body", "the grasp is in the plane, and has none")
        check_body(source, top["body"])
    outline = read_outline(source, top["outline"]) if "outline" in top else []
    contacts = []
    for i, entry in enumerate(top["contacts"]):
        place, where = f"contacts[{i}]", "position normal "
        if type(entry) is Members and any(key == "on" for key, _ in entry.pairs):
            where = "on "  # and no position, no normal
            if source.space:
                source.fail(f"{place}.on", "the grasp is in space; give position and normal")
            if top["format"] == GRASP.formats[0]:
                source.fail(place, f"'on' needs \"format\": \"{GRASP.formats[1]}\"")
        fields = source.members(entry, place, where + "friction? stiffness? preload?")
        contacts.append(read_contact(source, fields, place, defaults, outline))
    common = read_load(source, top, "", "cases" not in top)
    cases = read_cases(source, top["cases"]) if "cases" in top else {}
    if source.uncertain and top["format"] == GRASP.formats[0]:
        source.fail(source.uncertain, f"an object here needs \"format\": \"{GRASP.formats[1]}\"")
    alone = Bodies({"": Body("", GROUND, None)}, source.dimension, source.dimension)
    return Grasp(contacts, common, cases, source.space, alone, bool(cases), max_motion=read_max_motion(source, top, source.dimension, 0))


def make_row(contact: Contact, growth: Fraction) -> Row:
    """§1, Rows, of a contact without uncertainty."""
    point, n = tuple(p.low for p in contact.position), contact.normal
    preload = contact.preload.low
    square = dot(n, n)
    length = rational_root(square) if preload or growth else Fraction(1)
    assert length is not None
    normal = pulled(contact.motion, at(point, n))
    return Row(normal, slip_rows(contact.motion, point, n, n, contact.gamma), contact.friction.low,
               times(-contact.stiffness.low / square, normal) + (preload / length, growth / length),
               n, contact.gamma, bool(contact.spring))


def slip_rows(motion: Optional[Matrix], point: Sequence[Fraction], n: Vector, straight: Vector,
              gamma: Fraction) -> List[Vector]:
    """T, or the rows of S; with torsion the fourth is that of the turn about n (§1)."""
    wrenches = [at(point, t) for t in across(n, straight)] + [zeros(3) + n] * (gamma > 0)
    return [pulled(motion, wrench) for wrench in wrenches]


def across(n: Vector, straight: Vector) -> List[Vector]:
    """What the slip of §1 is measured along: t, or the rows of the projection along n on the
    plane across n⁰, `straight`. Along a coordinate nothing slips (§14)."""
    if len(n) == 1:
        return []
    if len(n) == 2:
        return [(-n[1], n[0])]
    square = dot(straight, straight)
    return [tuple((j == k) - n[j] * straight[k] / square for k in range(3)) for j in range(3)]


def turns(n: Vector) -> List[Vector]:
    """The ways in which the normal n⁰ may turn: t⁰, or U and V, of §6."""
    if len(n) < 3:
        return across(n, n)
    least = min(range(3), key=lambda j: abs(n[j]))
    u = cross(n, tuple(Fraction(j == least) for j in range(3)))
    return [u, cross(n, u)]


def wrench_asked(grasp: Grasp, asked: Options) -> Wrench:
    """§1, the table: w."""
    if asked.wrench is not None:
        if asked.case is not None:
            raise Malformed("the question", "case", "a wrench is given as well")
        return exact_wrench(asked.wrench)
    if asked.case is not None:
        if asked.case not in grasp.cases:
            raise Malformed("the question", "case", f"the grasp has no case '{show(asked.case)}'")
        return wrench_of(grasp.common + grasp.cases[asked.case], grasp.bodies)
    if asked.direction is not None or asked.plane:
        return exact_wrench(zeros(grasp.dimension))
    if grasp.choose:
        raise Malformed("the question", "case", f"the grasp has {len(grasp.cases)} cases, and none "
                                                "is chosen; give the name of one")
    return wrench_of(grasp.common, grasp.bodies)


def check_dimension(asked: Options, grasp: Grasp) -> None:
    """§1: so many numbers as the grasp has."""
    u, v = asked.plane if asked.plane and asked.statics is not None else (None, None)
    for part, vector in (("wrench", asked.wrench), ("direction", asked.direction), ("plane", u), ("plane", v)):
        if vector is not None and len(vector) != grasp.dimension:
            raise Malformed("the question", part, f"found {len(vector)} numbers, must be "
                                                  f"{grasp.dimension} as the grasp has")
    if asked.statics is None and grasp.dimension > MAX_DIMENSION and (asked.margin() or asked.uncertain or asked.states):
        raise Malformed("the question", "bodies", f"{grasp.dimension} coordinates, must be at most {MAX_DIMENSION} "
                                                  "but in a question of statics or the verdict about one grasp")


def check_plane(asked: Options, grasp: Grasp) -> None:
    """§12, §16: which plane cannot be asked about."""
    if asked.plane is None:
        return
    u, v = asked.plane
    pivot, statics = next((j for j, c in enumerate(u) if c), 0), asked.statics is not None
    problem = ("the grasp is in space" if grasp.space and not statics else
               "the grasp is of several bodies" if grasp.names and not statics else
               "a direction is given as well" if asked.margin() else
               "its directions are multiples of one another"
               if all(u[pivot] * c == v[pivot] * b for b, c in zip(u, v)) else "")
    if problem:
        raise Malformed("the question", "plane", problem)


def check_inertia(asked: Options, grasp: Grasp) -> None:
    """§13: which class cannot be asked about."""
    if asked.inertia is None:
        return
    m, space = asked.inertia, grasp.space
    problem = ("the grasp is of several bodies" if grasp.names else
               "a direction or a plane is given as well" if asked.margin() or asked.plane else
               f"expected {'6 or 9' if space else '3'} numbers" if len(m) != (9 if space else 3) else
               "the squared radius of gyration must be > 0" if not space and m[2] <= 0 else "")
    if space and not problem:
        xx, yy, zz, xy, xz, yz = m[3:]
        minor = xx * yy - xy * xy
        if min(xx, minor, zz * minor - xx * yz ** 2 - yy * xz ** 2 + 2 * xy * xz * yz) <= 0:
            problem = "the tensor is not positive definite"
    if problem:
        raise Malformed("the question", "inertia", problem)


def check_statics(asked: Options) -> None:
    """§16: with what it cannot be asked."""
    if asked.statics is None:
        return
    problem = (f"found {show(asked.statics)}, must be >= 0" if asked.statics < 0 else
               "a direction of preloads is given as well" if asked.preload_direction is not None else
               "an inertia is given as well" if asked.inertia else
               "a bound of motions is given as well" if asked.max_motion else "")
    if problem:
        raise Malformed("the question", "statics", problem)


def pose_states(grasp_file: str, grasp: Grasp, asked: Options) -> Question:
    """§17: a question about positions and normals alone."""
    if asked != Options(states=asked.states):
        raise Malformed("the question", "states", "another option is given as well")
    check_dimension(asked, grasp)
    for contact in filter(Contact.is_contact, grasp.contacts):
        for name, numbers in (("position", contact.position), ("normal", (Bounds(-contact.slope, contact.slope),))):
            for number in numbers:
                if not number.certain:
                    raise Malformed(grasp_file, f"{contact.place}.{name}", f"found {show(number)}, but states are those of "
                                                                           "one grasp; give a number")
    wrench = exact_wrench(zeros(grasp.dimension))
    return Question(asked, wrench, loads_within(wrench), (), grasp.contacts, (), [], False, grasp.space, grasp.names,
                    bodies=grasp.bodies)


def robustness_asked(asked: Options, grasp: Grasp) -> Options:
    """§18: with the numbers that were left out."""
    given = asked._replace(robustness=None, length=None, max_force=None, wrench=None, case=None)
    m, length, most = len(grasp.contacts), asked.length, asked.max_force
    if asked.robustness:
        length = Fraction(1) if length is None else length
        most = (Fraction(1),) * m if most is None else most * m if len(most) == 1 else most
    problem = ("another option is given as well" if asked.robustness and given != Options() else
               "the grasp is of several bodies" if asked.robustness and grasp.names else
               "there is no robustness" if not asked.robustness and (length, most) != (None, None) else
               "the length is not > 0" if length is not None and length <= 0 else
               f"expected {m} largest forces > 0" if most is not None and (len(most) != m or any(f <= 0 for f in most)) else "")
    if problem:
        raise Malformed("the question", "robustness", problem)
    return asked._replace(length=length, max_force=most)


def check_finger(grasp_file: str, contact: Contact) -> None:
    """§18: what a robustness is not about."""
    problem = ("has torsion" if contact.torsion else "has a normal of irrational length; run stickslip snap GRASP -o FILE"
               if rational_root(dot(contact.normal, contact.normal)) is None else "")
    if problem:
        raise Malformed(grasp_file, contact.place, "it " + problem)


def in_full(inertia: Vector) -> Vector:
    """§13: with xy, xz and yz, which may be left out."""
    return inertia + zeros(3) if len(inertia) == 6 else inertia


def max_motion_asked(asked: Options, grasp: Grasp) -> Optional[Vector]:
    """§1, max motion: B, or None if motions are not bounded."""
    if asked.statics is not None or asked.robustness:
        return None  # that of a file plays no part
    of_option = asked.max_motion is not None
    bound = asked.max_motion if of_option else grasp.max_motion
    if not bound:
        return None
    problem = (f"{asked.family()} is about all motions; " + (
                   "leave one of the two out" if of_option else
                   "to leave the bound of the grasp file out, give --max-motion none")
               if asked.plane or asked.inertia else
               f"found {show(min(bound))}, must be > 0" if min(bound) <= 0 else "")
    if not problem and len(bound) == 2 and not grasp.joints:
        bound = spread(*bound, grasp.dimension, grasp.space)
    if not problem and len(bound) != grasp.dimension:
        problem = (f"found {len(bound)} numbers, must be {grasp.dimension}, one for each coordinate"
                   + ", or a length and an angle" * (not grasp.joints))
    if problem:
        raise Malformed("the question", "max_motion", problem)
    return bound


def check_tolerances(asked: Options) -> None:
    """§6: what cannot be asked, whatever the grasp."""
    for kind, tolerance in (asked.uncertain or {}).items():
        problem = f"{asked.family()} is about one grasp" if asked.family() else tolerance.refusal(kind)
        if problem:
            raise Malformed("the question", "uncertain", f"{kind}={show(tolerance)}: {problem}")


def widened(contact: Contact, asked: Options) -> Contact:
    """§6: with the tolerances, after what was replaced."""
    if asked.preload is not None and contact.is_contact():
        contact = contact._replace(preload=exactly(asked.preload))
    for kind, tolerance in (asked.uncertain or {}).items():
        if isinstance(tolerance, Ball) or (not contact.is_contact() and kind not in ("stiffness", "preload")):
            continue
        if kind == "normal":
            contact = contact._replace(slope=contact.slope + tolerance.size)
        elif kind == "position":
            contact = contact._replace(position=tuple(map(tolerance.widen, contact.position)))
        elif kind != "wrench":
            contact = contact._replace(**{kind: tolerance.widen(getattr(contact, kind))})
    return contact


def about_given(asked: Options, grasp: Grasp) -> Options:
    """With the point of a ball, which is 0 if it is left out."""
    ball = (asked.uncertain or {}).get("wrench")
    if not isinstance(ball, Ball) or ball.about:
        return asked
    return asked._replace(uncertain={**(asked.uncertain or {}),
                                     "wrench": ball._replace(about=zeros(3 if grasp.space else 2))})


def loads_of(grasp: Grasp, wrench: Wrench, tolerance: Union[None, Tolerance, Ball]) -> Loads:
    """§6: w, widened."""
    if not isinstance(tolerance, Ball):
        return loads_within(tuple(map(tolerance.widen, wrench)) if tolerance else wrench)
    about, body, size = tolerance.about, tolerance.body, SPACE if grasp.space else PLANE
    bodies = [name for name in grasp.motions if name != GROUND]
    length = 3 if grasp.space else 2  # of a point
    problem = (f"about has {len(about)} coordinates, must have {length}" if len(about) != length else
               "the grasp is of one body; leave body= out" if body is not None and not bodies else
               f"no body is named; add :body= and one of {show(tuple(bodies))}" if body is None and bodies else
               f"there is no body '{show(body)}', must be one of {show(tuple(bodies))}"
               if bodies and body not in bodies else
               f"the wrench is {show(wrench)}, must be numbers" if not all(w.certain for w in wrench) else "")
    if problem:
        raise Malformed("the question", "uncertain", f"wrench={show(tolerance)}: {problem}")
    ways = [at(about, unit(length, j)) for j in range(length)] + [unit(size, j) for j in range(length, size)]
    motion = None if body is None else grasp.motions[body]
    radii = (tolerance.radius,) * length + (tolerance.radius * tolerance.length,) * (size - length)
    return Loads(tuple(w.low for w in wrench), tuple(pulled(motion, way) for way in ways),
                 tuple(Bounds(-r, r) for r in radii), radii)


def is_irrational(contact: Contact, grows: bool) -> bool:
    """§6: whether its length is irrational, where it has a preload."""
    return bool(contact.preload.high or grows) and not rational_root(dot(contact.normal, contact.normal))


def check_contact(grasp_file: str, contact: Contact, grows: bool, asked: Options, family: str) -> bool:
    """§6: what cannot be asked of a contact; and whether it makes the question a box."""
    place = contact.place + "."
    numbers = {"friction": contact.friction, "stiffness": contact.stiffness,
               "preload": contact.preload, "normal": Bounds(-contact.slope, contact.slope),
               **{f"position[{j}]": p for j, p in enumerate(contact.position)}}
    if contact.slope >= 1 or (contact.slope and contact.torsion):
        raise Malformed(grasp_file, place + "normal", f"slope {show(contact.slope)}, must be "
                                                      + ("0 where there is torsion" if contact.torsion else "< 1"))
    for name in ("friction", "stiffness", "preload"):
        low = numbers[name].low
        if contact.spring and (name == "preload" or low == 0):
            continue
        if low < 0 or (name == "stiffness" and low == 0):
            raise Malformed(grasp_file, place + name, f"it may be {show(low)}, must be "
                                                      + ("> 0" if name == "stiffness" else ">= 0"))
    if family:
        for name, number in numbers.items():
            if not number.certain:
                name = contact.spring if contact.spring and name == "preload" else name
                raise Malformed(grasp_file, place + name, f"found {show(number)}, but {family} is "
                                                          "about one grasp; give a number")
    irrational = asked.statics is None and is_irrational(contact, grows)
    if irrational and (asked.plane or asked.inertia) and len(contact.normal) == 2:
        raise Malformed(grasp_file, place + "normal",
                        "the contact has a preload and a normal of irrational length, so there "
                        "is no exact question; run stickslip snap GRASP -o FILE, and ask about FILE")
    return irrational or not all(number.certain for number in numbers.values())


def check_limits(grasp_file: str, grasp: Grasp, asked: Options) -> None:
    """§16: only statics is asked of limited forces."""
    for contact in grasp.contacts if asked.statics is None else ():
        if contact.limit is not None:
            raise Malformed(grasp_file, contact.place + (".max_force" if contact.is_contact() else ".max_torque"),
                            "the force is limited, which must not be but in a question of statics")


def pose(grasp_file: str, asked: Options) -> Question:
    """§1, the table: the question, if it can be asked."""
    grasp = read_grasp(grasp_file, asked.statics is not None)
    asked = robustness_asked(asked, grasp)
    if asked.states:
        check_limits(grasp_file, grasp, asked)
        return pose_states(grasp_file, grasp, asked)
    m = len(grasp.contacts)
    check_limits(grasp_file, grasp, asked)
    if asked.preload is not None and asked.preload < 0:
        raise Malformed("the question", "preload", f"found {show(asked.preload)}, must be >= 0")
    check_dimension(asked, grasp)
    check_plane(asked, grasp)
    check_inertia(asked, grasp)
    check_statics(asked)
    check_tolerances(asked)
    asked = about_given(asked, grasp)._replace(max_motion=max_motion_asked(asked, grasp))
    contacts = [widened(contact, asked) for contact in grasp.contacts]
    growth = zeros(m)
    if asked.preload_direction not in (None, "scale"):
        growth = asked.preload_direction
    if len(growth) != m or any(p < 0 and not one.spring for p, one in zip(growth, contacts)):
        raise Malformed("the question", "preload direction",
                        f"found {show(growth)}, must be {m} numbers, one for each contact, and >= 0"
                        + " but those of springs" * bool(grasp.names))
    wrench = wrench_asked(grasp, asked)
    loads = loads_of(grasp, wrench, (asked.uncertain or {}).get("wrench"))
    is_box = not all(load.certain for load in loads.bounds)
    large = asked.statics is None and grasp.dimension > MAX_DIMENSION
    family = asked.family() or f"a verdict of more than {MAX_DIMENSION} coordinates" * large
    if is_box and family:
        raise Malformed(grasp_file, "wrench", f"found {show(wrench)}, but {family} is about "
                                              "one grasp; give numbers")
    for contact, grown in zip(contacts, growth):
        is_box |= check_contact(grasp_file, contact, bool(grown), asked, family)
        if asked.robustness:
            check_finger(grasp_file, contact)
    if asked.preload_direction == "scale":
        growth = tuple(contact.preload.low for contact in contacts)
        contacts = [contact._replace(preload=exactly(Fraction(0))) for contact in contacts]
    u = asked.direction or zeros(grasp.dimension)
    if asked.margin() and not any(u) and not any(growth):
        raise Malformed("the question", "direction", "neither the wrench nor a preload changes")
    rows = [] if is_box or large or asked.statics is not None else list(map(make_row, contacts, growth))
    claims = (grasp.space or bool(grasp.names) or asked.max_motion is not None
              or any(is_irrational(contact, bool(grown)) for contact, grown in zip(contacts, growth)))
    return Question(asked, wrench, loads, asked.plane or (u,), contacts, growth, rows, is_box, grasp.space,
                    grasp.names, claims, grasp.bodies)


# ---- §14 The grasp file of several bodies ------------------------------------------------------

def unit(size: int, j: int) -> Vector:
    return tuple(Fraction(j == k) for k in range(size))


def read_body(source: Source, entry: Any, place: str, before: Dict[str, Body]) -> Body:
    fields = source.members(entry, place, "name hinge? slide? on? outline? mesh?")
    name, on = fields["name"], fields.get("on", GROUND)
    if type(name) is not str or not name or name == GROUND or name in before:
        source.fail(f"{place}.name", f"must be a string, not empty, not '{GROUND}', and of this body alone")
    if "outline" in fields:
        if source.space:
            source.fail(f"{place}.outline", "the grasp is in space, and has none; give a mesh")
        read_outline(source, fields["outline"], f"{place}.outline")
    if "mesh" in fields:
        if not source.space:
            source.fail(f"{place}.mesh", "the grasp is in the plane, and has none; give an outline")
        check_body(source, fields["mesh"], f"{place}.mesh")
    if "hinge" in fields and "slide" in fields:
        source.fail(place, "both 'hinge' and 'slide'; give one of them")
    if "hinge" not in fields and "slide" not in fields:
        if "on" in fields:
            source.fail(f"{place}.on", "only a link, with 'hinge' or 'slide', is on a body")
        return Body(name, on, None)
    if type(on) is not str or (on not in before and on != GROUND):
        source.fail(f"{place}.on", f"must be '{GROUND}' or a body that stands before this one, so that no links "
                                   "are in a loop")
    if "slide" in fields:
        axis, where = read_point_of(source, fields["slide"], f"{place}.slide"), "slide"
        turn = axis + zeros(source.dimension - len(axis))
    elif source.space:
        hinge = source.members(fields["hinge"], f"{place}.hinge", "at axis")
        point, axis = (read_point_of(source, hinge[key], f"{place}.hinge.{key}") for key in ("at", "axis"))
        turn, where = cross(point, axis) + axis, "hinge.axis"
    else:
        x, y = read_point_of(source, fields["hinge"], f"{place}.hinge")
        turn = (y, -x, Fraction(1))
    if not any(turn):
        source.fail(f"{place}.{where}", "must not be zero")
    return Body(name, on, turn)


def read_over(source: Source, value: Any, place: str, links: Dict[str, Body]) -> Dict[str, Fraction]:
    """An object of `turns` or `over`: numbers for links."""
    if type(value) is not Members or not value.pairs:
        source.fail(place, "must be an object of one link or more, such as {\"tip\": 1}")
    found: Dict[str, Fraction] = {}
    for name, entry in value.pairs:
        if name not in links or name in found:
            source.fail(place, f"'{show(name)}' is " + ("repeated" if name in found else
                               f"no link (known: {', '.join(map(show, links)) or 'none'})"))
        found[name] = source.number(entry, f"{place}.{show(name)}")
        if not found[name]:
            source.fail(f"{place}.{show(name)}", "must not be 0; leave the link out")
    return found


def read_bodies(source: Source, top: Dict[str, Any], joints: Sequence[Dict[str, Any]]) -> Bodies:
    bodies: Dict[str, Body] = {}
    for k, entry in enumerate(source.array(top["bodies"], "bodies")):
        body = read_body(source, entry, f"bodies[{k}]", bodies)
        bodies[body.name] = body
    if not bodies:
        source.fail("bodies", "must not be empty")
    links, size = {name: body for name, body in bodies.items() if body.turn}, source.dimension
    first = size * (len(bodies) - len(links))  # coordinate of a joint
    dimension = first + len(joints)
    source.rowless = source.rowless or dimension > MAX_DIMENSION
    turned: Dict[str, Dict[int, Fraction]] = {link: {} for link in links}
    for q, joint in enumerate(joints):
        for link, c in read_over(source, joint["turns"], f"joints[{q}].turns", links).items():
            turned[link][first + q] = c
    if dimension > MOST_DIMENSION:
        source.fail("bodies", f"{dimension} coordinates, of bodies and joints; must be at most {MOST_DIMENSION}")
    begin_ = 0
    for k, (name, body) in enumerate(bodies.items()):
        if body.turn is None:
            bodies[name], begin_ = body._replace(first=begin_), begin_ + size
            continue
        if not turned[name]:
            source.fail(f"bodies[{k}]", f"no joint turns the link '{show(name)}'; name it in 'turns' of one")
        bodies[name] = body._replace(joints=turned[name])
    return Bodies(bodies, size, dimension)


def element(place: str, stiffness: Bounds, preload: Bounds, spring: str = "") -> Contact:
    """What acts along a row: a ratchet or a spring."""
    return Contact((), (Fraction(1),), Fraction(0), exactly(Fraction(0)), stiffness, preload, place, None, spring)


def read_spring(source: Source, fields: Dict[str, Any], place: str, force: str) -> Contact:
    stiffness, pull = (read_bounds(source, fields[key], f"{place}.{key}") if key in fields else
                       exactly(Fraction(0)) for key in ("stiffness", force))
    if stiffness.low < 0:
        source.fail(f"{place}.stiffness", f"{show(stiffness.low)} is out of range, must be >= 0")
    return element(place, stiffness, pull, force)


def read_several(source: Source) -> Grasp:
    top = source.members(source.root, "", "format name? units? bodies defaults? joints? tendons? ratchets? "
                                          "contacts wrench? loads? cases? max_motion? gravity? friction?")
    if top["format"] != GRASP.formats[2]:
        source.fail("format", f"must be \"{GRASP.formats[2]}\", as the file has bodies")
    defaults = read_defaults(source, top)
    lists = {}
    for key, members in (("joints", "turns name? stiffness? torque? max_torque?"),
                         ("tendons", "over name? stiffness? tension?"),
                         ("ratchets", "over name? stiffness preload?")):
        lists[key] = [source.members(entry, f"{key}[{k}]", members)
                      for k, entry in enumerate(source.array(top.get(key, []), key))]
        for k, fields in enumerate(lists[key]):
            if type(fields.get("name", "")) is not str:
                source.fail(f"{key}[{k}].name", "must be a string")
    joints = lists["joints"]
    bodies = read_bodies(source, top, joints)

    links = {name: body for name, body in bodies.bodies.items() if body.turn}
    motions = {} if source.rowless else bodies.matrices()

    def along(one: Contact, row: Dict[int, Fraction]) -> Contact:
        """With its row as a matrix, if there are rows."""
        return one if source.rowless else one._replace(
            motion=tuple((row.get(q, Fraction(0)),) for q in range(bodies.dimension)))

    def over(one: Contact, fields: Dict[str, Any]) -> Contact:
        """With the links that it is over."""
        place = f"{one.place}.over"
        numbers = read_over(source, fields["over"], place, links)
        row = bodies.row_over(numbers)
        if not any(row.values()):
            source.fail(place, "its numbers cancel, so that no joint moves it")
        return along(one._replace(over=numbers), row)

    elements = []
    for i, entry in enumerate(top["contacts"]):
        place = f"contacts[{i}]"
        fields = source.members(entry, place, "of by? position normal friction? stiffness? preload? torsion? max_force?")
        of = bodies.known(source, fields["of"], f"{place}.of")
        by = bodies.known(source, fields.get("by", GROUND), f"{place}.by", True)
        if of == by:
            source.fail(f"{place}.by", f"must be another body than that of 'of', or '{GROUND}'")
        contact = read_contact(source, fields, place, defaults)._replace(of=of, by=by)
        elements.append(contact if source.rowless else contact._replace(
            motion=tuple(plus(a, Fraction(-1), b) for a, b in zip(motions[of], motions[by]))))
    for k, fields in enumerate(lists["ratchets"]):
        place = f"ratchets[{k}]"
        stated = {"preload": exactly(Fraction(0)), **coefficients(source, fields, place)}
        elements.append(over(element(place, stated["stiffness"], stated["preload"]), fields))
    for q, fields in enumerate(joints):
        if "stiffness" in fields or "torque" in fields or "max_torque" in fields:
            joint = bodies.dimension - len(joints) + q
            spring = read_spring(source, fields, f"joints[{q}]", "torque")
            if "max_torque" in fields:
                spring = spring._replace(limit=read_limit(source, fields["max_torque"], f"joints[{q}].max_torque"))
            elements.append(along(spring._replace(joint=joint), {joint: Fraction(1)}))
    for k, fields in enumerate(lists["tendons"]):
        elements.append(over(read_spring(source, fields, f"tendons[{k}]", "tension"), fields))
    common = read_load(source, top, "", False, bodies)
    cases = read_cases(source, top["cases"], bodies) if "cases" in top else {}
    moves = ("x", "y", "z", "turn x", "turn y", "turn z") if source.space else ("x", "y", "turn")
    names = [f"{body} {move}" for body in bodies.bodies if body not in links for move in moves]
    names += [joint.get("name", f"joint {q}") for q, joint in enumerate(joints)]
    return Grasp(elements, common, cases, source.space, bodies, bool(cases) and not {"loads", "wrench"} & set(top),
                 tuple(names), motions, len(joints), read_max_motion(source, top, bodies.dimension, len(joints)))


# ---- §2 Syntax --------------------------------------------------------------------------------


class Claim(NamedTuple):
    """The member `question` of a certificate."""
    contacts: int
    wrench: Wrench
    asked: Options  # the rest




class Node(NamedTuple):
    """§4: slip and separation have a contact, plane has numbers a, leaf has numbers y; part has
    a name, an index (`contact`) and a number; §12: held has a piece (`contact`); §13: touch has a
    contact, and leaf t and y as numbers, and multipliers."""
    kind: str
    contact: int = -1
    numbers: Vector = ()
    name: str = ""
    normal: List[Tuple[int, Fraction]] = []
    tangent: List[Tuple[int, Vector]] = []
    own: List[Tuple[int, Fraction, Vector]] = []


class RestProof(NamedTuple):
    """§6, a PART at rest."""
    rest: List[Tuple[int, List[Vector]]]     # f⁰: one friction force each
    answers: List[Tuple[int, List[Vector]]]  # G: D each
    reach: Vector                            # Z


class StickingProof(NamedTuple):
    """§6, a PART that is sticking."""
    twist: Vector                              # d⁰
    friction: List[Tuple[int, List[Vector]]]   # f⁰: one friction force each
    presses: List[Tuple[int, Vector]]          # H
    answers: List[Tuple[int, List[Vector]]]    # G: D each
    reach: Vector                              # Z
    energy: Fraction                           # c


class DegreeProof(NamedTuple):
    """§6, a PART by degree; or a segment by degree (§5)."""
    twist: Vector            # d⁰, or d'
    walls: List[Vector]      # E
    direction: List[Vector]  # A
    tree: List[Node]
    end_twist: Vector        # d⁰, or d"
    to: Optional[Fraction] = None  # β of a segment
    simplex: bool = False    # else K is a parallelepiped
    open: Sequence[int] = ()  # the contacts that are said to be open on K

    def free_motions(self) -> List[Vector]:
        """A basis of Z."""
        return kernel(self.walls or [zeros(len(self.twist))])

    def faces(self) -> List[Tuple[str, Vector]]:
        """The walls, by name: the rows F."""
        if self.simplex:
            return [(f"{j}", row) for j, row in enumerate(self.walls, 1)]
        return [(f"{j} {name}", times(Fraction(sign_), row)) for j, row in enumerate(self.walls, 1)
                for name, sign_ in (("+", 1), ("-", -1))]


class Witness(NamedTuple):
    """§3: a point (d, 1, λ), or (d, 0, 1) for a ray, and the shares of friction; §12: (d, h, s, t)."""
    x: Vector
    shares: List[Tuple[int, Vector]]  # of one number, in space of three


Interval = Tuple[Fraction, Optional[Fraction]]  # None for ∞


Part = Union[Node, DegreeProof, RestProof, StickingProof]
Proof = TypeVar("Proof", DegreeProof, RestProof, StickingProof)


Segment = Union[Tuple[Witness, Witness], DegreeProof]


class RangeProof(NamedTuple):
    """§5, a CLAIM."""
    stable: bool
    interval: Interval
    points: List[Witness] = []  # of a stable claim: two, or one, or none and then
    part: Union[None, DegreeProof, RestProof, StickingProof] = None
    tree: List[Node] = []       # of an unstable claim


RigidForce = Tuple[int, Fraction, Vector]  # i, a_i and a force across n


class RigidProof(NamedTuple):
    """§13, but its tree: of "must move" a twist, else forces at rest, and of "open" a motion with others."""
    twist: Vector = ()
    rest: List[RigidForce] = []
    acceleration: Vector = ()
    forces: List[RigidForce] = []


class StaticProof(NamedTuple):
    """§16: of one verdict forces or a twist, else load points with forces, and twists."""
    forces: List[RigidForce] = []
    twist: Vector = ()
    stand: List[Tuple[Vector, List[RigidForce]]] = []
    move: List[Vector] = []


class StatesProof(NamedTuple):
    """§17: lines of slip of each contact, states with a motion each, and their numbers by dimension."""
    lines: List[List[Vector]]
    states: List[str]
    by_dimension: List[int]


class RobustForce(NamedTuple):
    """§18: of a contact that is not detached."""
    contact: int
    state: str  # "stick" or "slip"
    force: Vector


class RobustProof(NamedTuple):
    """§18: the bounds; d, c and forces, if there is a combination; and nodes."""
    lower: Fraction
    upper: Fraction
    combination: Optional[Tuple[Fraction, Fraction, List[RobustForce]]]
    tree: List[Tuple[str, Vector]]  # each a kind and numbers

    def leaves(self) -> int:
        return sum(kind in ROBUST_LEAVES for kind, _ in self.tree)


class Certificate(NamedTuple):
    question: Claim
    verdict: str                # "stable", "unstable", "margin" or "region"
    witness: Optional[Witness] = None  # of "stable"
    tree: List[Node] = []       # of "unstable", "margin" and "region"
    resisted: List[Interval] = []      # of "margin", as is the next
    segments: List[Segment] = []
    bits: int = 128
    parts: Optional[List[Part]] = None  # of "stable", if there is no witness
    claims: Optional[List[RangeProof]] = None  # of "margin" by claims, and then nothing else
    pieces: Optional[List[List[Witness]]] = None  # of "region"
    rigid: Optional[RigidProof] = None  # of a class
    statics: Optional[StaticProof] = None
    states: Optional[StatesProof] = None
    robust: Optional[RobustProof] = None

    def proofs(self, kind: Type[Proof]) -> List[Proof]:
        """All parts that are not cut, of one kind."""
        parts = [*(self.parts or []), *(claim.part for claim in self.claims or []), *self.segments]
        return [part for part in parts if isinstance(part, kind)]

    def trees(self) -> List[Node]:
        """All nodes."""
        nodes = [node for part in self.proofs(DegreeProof) for node in part.tree] + self.tree
        return nodes + [node for claim in self.claims or [] for node in claim.tree]


def read_certificate(name: str, question: Question) -> Certificate:
    """All of the syntax comes before any rule."""
    source, dimension = Source(name, CERTIFICATE), len(question.wrench)
    source.dimension, source.space, source.several = dimension, question.space, bool(question.names)
    source.soft = {i for i, contact in enumerate(question.contacts) if contact.torsion}
    source.limits = sum(contact.limit is not None for contact in question.contacts)
    claimed = dict(source.root.pairs) if type(source.root) is Members else {}
    if "format" in claimed:
        source.check_format(claimed["format"])
    statics = states_member(claimed.get("question"), "statics")
    if states_member(claimed.get("question"), "states"):
        return read_states(source)
    if question.asked.states:
        raise Rejected("question-states", f"the certificate is about no states, asked was {question.asked.states}")
    if states_member(claimed.get("question"), "robustness"):
        return read_robustness(source)
    if question.asked.robustness:
        raise Rejected("question-robustness", f"the certificate is about none, asked was {question.asked.robustness}")
    evidence = {"region": "stand move" if statics else "pieces tree", "stable": "parts" if "parts" in claimed else "twist shares",
                "margin": "stand move" if statics else "intervals" if question.claims else "resisted segments tree",
                "must move": "twist", "may stand": "forces", "must hold": "rest tree",
                "open": "rest acceleration forces"}.get(
                    claimed["verdict"] if type(claimed.get("verdict")) is str else "", "tree")
    top = source.members(source.root, "", "format producer? question bits? verdict " + evidence,
                         True)
    if type(top.get("producer", "")) is not str:
        source.fail("producer", "must be a string")
    claim = read_claim(source, top["question"])
    margin, plane = claim.asked.margin(), claim.asked.plane is not None
    rigid = claim.asked.inertia is not None and not margin and not plane and not statics
    bits = source.index(top["bits"], "bits") if "bits" in top else 128
    if (margin and not question.claims or plane or rigid or statics) and "bits" in top:
        source.fail("bits", "not in a margin by segments, and not with a plane, an inertia or statics")
    if not 64 <= bits <= 4096:
        source.fail("bits", "must be from 64 to 4096")
    verdict = source.choice(top["verdict"], "verdict",
                            ("region",) if plane else ("margin",) if margin else
                            STATICS if statics else CLASSES if rigid else ("stable", "unstable"))
    if statics:
        return Certificate(claim, verdict, statics=read_statics(source, top, 2 + plane))
    if rigid:
        return Certificate(claim, verdict, rigid=RigidProof(
            source.vector(top["twist"], "twist", dimension) if "twist" in top else (),
            read_forces(source, top.get("rest", []), "rest"),
            source.vector(top["acceleration"], "acceleration", dimension) if "acceleration" in top else (),
            read_forces(source, top.get("forces", []), "forces")),
            tree=[read_rigid_node(source, node, f"tree[{k}]")
                  for k, node in enumerate(source.array(top.get("tree", []), "tree"))])
    if "parts" in top:
        parts = [read_part(source, part, f"parts[{k}]")
                 for k, part in enumerate(source.array(top["parts"], "parts"))]
        return Certificate(claim, verdict, bits=bits, parts=parts)
    if "intervals" in top:
        claims = [read_range(source, claim, f"intervals[{k}]")
                  for k, claim in enumerate(source.array(top["intervals"], "intervals"))]
        return Certificate(claim, verdict, bits=bits, claims=claims)
    if verdict == "stable":
        return Certificate(claim, verdict, read_witness(source, top, "", Fraction(0)), bits=bits)
    if verdict == "region":
        pieces = [[read_load_point(source, point, f"pieces[{k}][{p}]")
                   for p, point in enumerate(source.array(piece, f"pieces[{k}]"))]
                  for k, piece in enumerate(source.array(top["pieces"], "pieces"))]
        return Certificate(claim, verdict, pieces=pieces,
                           tree=read_tree(source, top["tree"], "tree", 2))
    tree = read_tree(source, top["tree"], "tree", margin)
    if verdict == "unstable":
        return Certificate(claim, verdict, None, tree, bits=bits)
    resisted: List[Interval] = []
    segments: List[Segment] = []
    for k, entry in enumerate(source.array(top["resisted"], "resisted")):
        low, high = source.array(entry, f"resisted[{k}]", 2)
        resisted.append((source.number(low, f"resisted[{k}]"),
                         None if high is None else source.number(high, f"resisted[{k}]")))
    end: Optional[Witness] = None  # of the segment before, if that has points
    for k, entry in enumerate(source.array(top["segments"], "segments")):
        place = f"segments[{k}]"
        if type(entry) is Members:
            segments.append(read_segment(source, entry, place))
            end = None
            continue
        if len(source.array(entry, place)) == 1 and end and end.x[dimension]:
            begin = end
        else:
            begin = read_point(source, source.array(entry, place, 2)[0], place, False)
        end = read_point(source, entry[-1], place, True)
        segments.append((begin, end))
    return Certificate(claim, verdict, None, tree, resisted, segments)


def read_across(source: Source, value: Any, place: str) -> Vector:
    """§13: a force across n, in the plane one number."""
    return source.vector(value, place, 3) if source.space else (source.number(value, place),)


def read_forces(source: Source, value: Any, place: str) -> List[RigidForce]:
    """FORCES of §13."""
    forces = []
    for entry in source.array(value, place):
        contact, a, friction = source.array(entry, place, 3)
        i = source.index(contact, place)
        forces.append((i, source.number(a, place), read_friction(source, friction, place, i)))
    return forces


def states_member(question: Any, name: str) -> bool:
    """Whether the member `question` of a certificate has one of that name."""
    return type(question) is Members and name in dict(question.pairs)


def read_states(source: Source) -> Certificate:
    """§17"""
    top = source.members(source.root, "", "format producer? question verdict lines states by_dimension", True)
    if type(top.get("producer", "")) is not str:
        source.fail("producer", "must be a string")
    fields = source.members(top["question"], "question", "contacts states", True)
    kind = source.choice(fields["states"], "question.states", STATES)
    claim = Claim(source.index(fields["contacts"], "question.contacts"), exact_wrench(zeros(source.dimension)), Options(states=kind))
    verdict = source.choice(top["verdict"], "verdict", ("complete",))
    lines = [[source.vector(line, f"lines[{i}][{j}]", source.coordinates)
              for j, line in enumerate(source.array(lines, f"lines[{i}]"))]
             for i, lines in enumerate(source.array(top["lines"], "lines"))]
    for i, some in enumerate(lines):
        if not some:
            source.fail(f"lines[{i}]", "must be a line or more")
    syntax = "".join((r"[-+0]\|" if kind == "full" else "") + f"[-+0]{{{len(some)}}} " for some in lines)
    state = re.compile(syntax + f":(?: -?[0-9]+){{{source.dimension}}}")
    for k, text in enumerate(source.array(top["states"], "states")):
        if type(text) is not str or not state.fullmatch(text):
            source.fail(f"states[{k}]", f"must be a string: signs of each contact, a colon, and {source.dimension} integers")
    counts = source.array(top["by_dimension"], "by_dimension", source.dimension + 1)
    return Certificate(claim, verdict, states=StatesProof(
        lines, top["states"], [source.index(count, f"by_dimension[{j}]") for j, count in enumerate(counts)]))


ROBUST_LEAVES = ("leaf", "combination", "none")


def read_robustness(source: Source) -> Certificate:
    """§18"""
    top = source.members(source.root, "", "format producer? question verdict lower upper combination tree", True)
    if type(top.get("producer", "")) is not str:
        source.fail("producer", "must be a string")
    fields = source.members(top["question"], "question", "contacts wrench robustness length max_force", True)
    n = source.dimension
    claim = Claim(source.index(fields["contacts"], "question.contacts"),
                  exact_wrench(source.vector(fields["wrench"], "question.wrench", n)),
                  Options(robustness=source.choice(fields["robustness"], "question.robustness", ROBUSTNESSES),
                          length=source.number(fields["length"], "question.length"),
                          max_force=source.vector(fields["max_force"], "question.max_force")))
    verdict = source.choice(top["verdict"], "verdict", ("bounds",))
    combination = None
    if top["combination"] is not None:
        parts = source.members(top["combination"], "combination", "distance inverse_square forces", True)
        forces = []
        for k, entry in enumerate(source.array(parts["forces"], "combination.forces")):
            place = f"combination.forces[{k}]"
            contact, state, force = source.array(entry, place, 3)
            forces.append(RobustForce(source.index(contact, place), source.choice(state, place, ("stick", "slip")),
                                      source.vector(force, place, source.coordinates)))
        combination = (source.number(parts["distance"], "combination.distance"),
                       source.number(parts["inverse_square"], "combination.inverse_square"), forces)
    sizes = {"state": 1, "distance": 1, "leaf": n + n * (n + 1) // 2, "combination": 2 * n, "none": n}
    tree = []
    for k, entry in enumerate(source.array(top["tree"], "tree")):
        kind, *rest = source.array(entry, f"tree[{k}]") or [None]
        if type(kind) is not str or len(rest) != sizes.get(kind):
            source.fail(f"tree[{k}]", f"must be one of {', '.join(sizes)} with {', '.join(map(str, sizes.values()))} numbers")
        if kind == "state":
            source.index(rest[0], f"tree[{k}]")
        tree.append((kind, source.vector(rest, f"tree[{k}]")))
    return Certificate(claim, verdict, robust=RobustProof(
        source.number(top["lower"], "lower"), source.number(top["upper"], "upper"), combination, tree))


def read_statics(source: Source, top: Dict[str, Any], numbers: int) -> StaticProof:
    """§16; of load points with so many numbers."""
    dimension, stand = source.dimension + source.limits, []
    for k, entry in enumerate(source.array(top.get("stand", []), "stand")):
        point, forces = source.array(entry, f"stand[{k}]", 2)
        stand.append((source.vector(point, f"stand[{k}][0]", numbers), read_forces(source, forces, f"stand[{k}][1]")))
    return StaticProof(read_forces(source, top.get("forces", []), "forces"),
                       source.vector(top["twist"], "twist", dimension) if "twist" in top else (), stand,
                       [source.vector(y, f"move[{k}]", dimension)
                        for k, y in enumerate(source.array(top.get("move", []), "move"))])


def read_rigid_node(source: Source, value: Any, place: str) -> Node:
    """§13, the table of nodes."""
    kind, *rest = source.array(value, place) or [None]
    space = source.space
    if (kind, len(rest)) in (("touch", 1), ("slip", 2 if space else 1)):
        return Node(kind, source.index(rest[0], place),
                    source.vector(rest[1], place, 3) if len(rest) == 2 else ())
    if kind == "leaf" and len(rest) == 4:
        pairs = [[source.array(entry, place, 2) for entry in source.array(part, place)] for part in rest[2:]]
        return Node(kind, numbers=(source.number(rest[0], place),
                                   *source.vector(rest[1], place, source.dimension)),
                    normal=[(source.index(i, place), source.number(g, place)) for i, g in pairs[0]],
                    tangent=[(source.index(i, place), read_across(source, h, place)) for i, h in pairs[1]])
    source.fail(place, f"must be [\"touch\", i], [\"slip\", i{', d' * space}] or [\"leaf\", t, y, g, h]")


def read_claim(source: Source, value: Any) -> Claim:
    has_statics = states_member(value, "statics")
    fields = source.members(
        value, "question", "contacts wrench preload? normal_law direction? preload_direction? "
                           + "plane? " * (has_statics or (not source.space and not source.several))
                           + "inertia? " * (not source.several) + "statics? uncertain? max_motion?", True)
    preload = direction = growth = None
    if "preload" in fields:
        preload = source.number(fields["preload"], "question.preload")
    if "direction" in fields:
        direction = source.vector(fields["direction"], "question.direction", source.dimension)
    if "preload_direction" in fields:
        growth = fields["preload_direction"]
        if type(growth) is not str or growth != "scale":
            growth = source.vector(growth, "question.preload_direction")
    uncertain = None
    if "uncertain" in fields:
        uncertain = read_tolerances(source, fields["uncertain"], "question.uncertain")
    plane = None
    if "plane" in fields:
        u, v = source.array(fields["plane"], "question.plane", 2)
        plane = (source.vector(u, "question.plane[0]", source.dimension),
                 source.vector(v, "question.plane[1]", source.dimension))
    inertia = None
    if "inertia" in fields:
        inertia = source.vector(fields["inertia"], "question.inertia")
        if len(inertia) not in ((6, 9) if source.space else (3,)):
            source.fail("question.inertia", "must be as the option --inertia has it")
        inertia = in_full(inertia)
    statics = source.number(fields["statics"], "question.statics") if has_statics else None
    bound = None
    if "max_motion" in fields:
        bound = source.vector(fields["max_motion"], "question.max_motion", source.dimension)
    wrench = [read_load_entry(source, entry, "question.wrench")
              for entry in source.array(fields["wrench"], "question.wrench", source.dimension)]
    return Claim(source.index(fields["contacts"], "question.contacts"), tuple(wrench),
                 Options(None, preload,
                         source.choice(fields["normal_law"], "question.normal_law", LAWS),
                         direction, growth, None, uncertain, plane, inertia, statics, bound))


def read_load_entry(source: Source, value: Any, place: str) -> Bounds:
    """§6: a NUMBER, or an interval of the grasp file."""
    if type(value) is not list:
        return exactly(source.number(value, place))
    return Bounds(*source.vector(value, place, 2))


def read_tolerances(source: Source, value: Any, place: str) -> Dict[str, Union[Tolerance, Ball]]:
    """TOLERANCE of each kind."""
    found: Dict[str, Union[Tolerance, Ball]] = {}
    for kind, size in source.members(value, place, " ".join(f"{kind}?" for kind in KINDS),
                                     True).items():
        if kind == "wrench" and type(size) is Members:
            found[kind] = read_ball(source, size, f"{place}.{kind}")
            continue
        percent = type(size) is str and size.endswith("%")
        number = source.number(size[:-1] if percent else size, f"{place}.{kind}")
        found[kind] = Tolerance(number, percent)
    if not found:
        source.fail(place, "must not be empty")
    return found


def read_ball(source: Source, value: Any, place: str) -> Ball:
    fields = source.members(value, place, "ball length about?" + " body" * source.several, True)
    radius, length = (source.number(fields[key], f"{place}.{key}") for key in ("ball", "length"))
    about, body = zeros(source.coordinates), fields.get("body")
    if "about" in fields:
        about = source.vector(fields["about"], f"{place}.about", source.coordinates)
    if source.several and type(body) is not str:
        source.fail(f"{place}.body", "must be a string")
    return Ball(radius, length, about, body)


def read_friction(source: Source, value: Any, place: str, i: int) -> Vector:
    """A share, or F, that is listed for contact i."""
    return (source.vector(value, place, 3 + (i in source.soft)) if source.space else
            (source.number(value, place),))


def read_shares(source: Source, value: Any, place: str) -> List[Tuple[int, Vector]]:
    shares = []
    for entry in source.array(value, place):
        contact, share = source.array(entry, place, 2)
        i = source.index(contact, place)
        shares.append((i, read_friction(source, share, place, i)))
    return shares


def read_witness(source: Source, fields: Dict[str, Any], place: str, load: Fraction) -> Witness:
    """For the multiple `load`."""
    return Witness(source.vector(fields["twist"], place + "twist", source.dimension)
                   + (Fraction(1), load), read_shares(source, fields["shares"], place + "shares"))


def read_point(source: Source, value: Any, place: str, may_be_ray: bool) -> Witness:
    """POINT."""
    load, twist, shares = source.array(value, place, 3)
    ray = may_be_ray and load is None
    ends = (Fraction(0), Fraction(1)) if ray else (Fraction(1), source.number(load, place))
    return Witness(source.vector(twist, place, source.dimension) + ends, read_shares(source, shares, place))


def read_load_point(source: Source, value: Any, place: str) -> Witness:
    """§12, POINT."""
    word, s, t, twist, shares = source.array(value, place, 5)
    h = Fraction(source.choice(word, place, ("at", "towards")) == "at")
    return Witness(source.vector(twist, place, PLANE)
                   + (h, source.number(s, place), source.number(t, place)),
                   read_shares(source, shares, place))


# By the numbers of a normal: of what acts along a coordinate, and of contacts in the plane and in space.
GEOMETRY = {1: (), 2: ("x", "y", "turn"), 3: ("x", "y", "z", "turn_u", "turn_v")}
PARAMETERS = {numbers: names + ("friction",) * (numbers > 1) + ("preload", "stiffness")
              for numbers, names in GEOMETRY.items()}


def read_tree(source: Source, value: Any, place: str, more: int) -> List[Node]:
    """With `more` coordinates of points behind h."""
    return [read_node(source, node, f"{place}[{k}]", more)
            for k, node in enumerate(source.array(value, place))]


def read_part(source: Source, value: Any, place: str) -> Part:
    """PART."""
    if type(value) is list:
        node = read_node(source, value, place, False)
        if node.kind != "part":
            source.fail(place, "must be a part")
        return node
    return read_proof(source, value, place, False)


def read_range(source: Source, value: Any, place: str) -> RangeProof:
    """CLAIM."""
    word, begin, end, *proofs = source.array(value, place) + [None] * 3
    stable = source.choice(word, place, ("stable", "unstable")) == "stable"
    low, high = interval = (source.number(begin, place),
                            None if end is None else source.number(end, place))
    by_points = type(proofs[0]) is Members and "shares" in dict(proofs[0].pairs)
    # Without an end 1 stands for all.
    loads = [Fraction(1)] if high is None else [low, high][:1 + (low != high)]
    source.array(value, place, 3 + (len(loads) if by_points else 1))
    if not stable:
        return RangeProof(stable, interval, tree=read_tree(source, proofs[0], place, True))
    if not by_points:
        return RangeProof(stable, interval, part=read_proof(source, proofs[0], place, True))
    return RangeProof(stable, interval, [
        read_witness(source, source.members(point, place, "twist shares", True), f"{place}.", load)
        for point, load in zip(proofs, loads)])


def read_proof(source: Source, value: Any, place: str, margin: bool) -> Union[DegreeProof, RestProof, StickingProof]:
    """A PART that is not cut."""
    if type(value) is Members and "rest" in dict(value.pairs):
        return read_rest(source, value, place)
    if type(value) is Members and "sticking" in dict(value.pairs):
        return read_sticking(source, value, place)
    simplex = type(value) is Members and "simplex" in dict(value.pairs)
    walls = "simplex" if simplex else "walls"
    has_open = type(value) is Members and "open" in dict(value.pairs)
    fields = source.members(value, place, f"twist {'open ' * has_open}{walls} direction tree", True)
    twist = source.vector(fields["twist"], f"{place}.twist", source.dimension)
    open_ = [source.index(i, f"{place}.open") for i in source.array(fields["open"], f"{place}.open")] if has_open else []
    if not simplex <= len(source.array(fields[walls], f"{place}.{walls}")) - simplex <= source.dimension:
        source.fail(f"{place}.{walls}", f"must be an array of {2 * simplex} to "
                                        f"{source.dimension + simplex}")
    return DegreeProof(twist, *read_shape(source, fields, walls, place, margin), twist,
                       simplex=simplex, open=open_)


def read_rest(source: Source, value: Any, place: str) -> RestProof:
    """A PART at rest."""
    fields = source.members(value, place, "rest answers reach", True)
    return RestProof(read_forces_at_rest(source, fields["rest"], f"{place}.rest"),
                     read_answers(source, fields["answers"], f"{place}.answers"),
                     source.vector(fields["reach"], f"{place}.reach", source.dimension))


def read_sticking(source: Source, value: Any, place: str) -> StickingProof:
    """A PART that is sticking."""
    fields = source.members(value, place, "sticking friction presses answers reach energy", True)
    presses = []
    for entry in source.array(fields["presses"], f"{place}.presses"):
        contact, numbers = source.array(entry, f"{place}.presses", 2)
        presses.append((source.index(contact, f"{place}.presses"),
                        source.vector(numbers, f"{place}.presses", source.dimension)))
    return StickingProof(source.vector(fields["sticking"], f"{place}.sticking", source.dimension),
                         read_forces_at_rest(source, fields["friction"], f"{place}.friction"), presses,
                         read_answers(source, fields["answers"], f"{place}.answers"),
                         source.vector(fields["reach"], f"{place}.reach", source.dimension),
                         source.number(fields["energy"], f"{place}.energy"))


def read_forces_at_rest(source: Source, value: Any, place: str) -> List[Tuple[int, List[Vector]]]:
    """f⁰."""
    return [(i, [force]) for i, force in read_shares(source, value, place)]


def read_answers(source: Source, value: Any, place: str) -> List[Tuple[int, List[Vector]]]:
    """G."""
    answers = []
    for entry in source.array(value, place):
        contact, forces = source.array(entry, place, 2)
        i = source.index(contact, place)
        answers.append((i, [read_friction(source, force, place, i)
                            for force in source.array(forces, place, source.dimension)]))
    return answers


def read_segment(source: Source, value: Any, place: str) -> DegreeProof:
    """BY_DEGREE."""
    fields = source.members(value, place, "to twists walls direction tree", True)
    to = None if fields["to"] is None else source.number(fields["to"], f"{place}.to")
    twist, end_twist = (source.vector(d, f"{place}.twists", source.dimension)
                        for d in source.array(fields["twists"], f"{place}.twists", 2))
    source.array(fields["walls"], f"{place}.walls", source.dimension)
    return DegreeProof(twist, *read_shape(source, fields, "walls", place, True), end_twist, to)


def read_shape(source: Source, fields: Dict[str, Any], walls: str, place: str,
               margin: bool) -> Tuple[List[Vector], List[Vector], List[Node]]:
    """E, A and the trees."""
    source.array(fields["direction"], f"{place}.direction", source.dimension)
    rows, direction = ([source.vector(row, f"{place}.{key}", source.dimension)
                        for row in source.array(fields[key], f"{place}.{key}")]
                       for key in (walls, "direction"))
    return rows, direction, read_tree(source, fields["tree"], f"{place}.tree", margin)


def read_node(source: Source, value: Any, place: str, more: int) -> Node:
    """§4, the table of nodes, and §12."""
    kind, *rest = source.array(value, place) or [None]
    dimension = source.dimension
    if kind == "part" and not more:
        name, i, cut = source.array(rest, place, 3)
        return Node(kind, source.index(i, place), (source.number(cut, place),),
                    source.choice(name, place, PARAMETERS[source.coordinates] + ("wrench",)))
    if kind in ("slip", "separation") and len(rest) == 1:
        return Node(kind, source.index(rest[0], place))
    if kind == "held" and more == 2 and len(rest) == 1:
        return Node(kind, source.index(rest[0], place))
    if kind == "plane" and len(rest) == dimension + 1 + more:
        return Node(kind, numbers=source.vector(rest, place) + (Fraction(0),) * (not more))
    if kind == "leaf" and len(rest) == dimension:
        return Node(kind, numbers=source.vector(rest, place))
    if kind == "moving" and not more and len(rest) == dimension + 2:
        own = []
        for entry in source.array(rest.pop(), place):
            index, kappa, psi = source.array(entry, place, 3)
            i = source.index(index, place)
            own.append((i, source.number(kappa, place), read_friction(source, psi, place, i)))
        return Node(kind, numbers=source.vector(rest, place), own=own)
    source.fail(place, "must be [\"slip\", i], [\"separation\", i], [\"plane\", a1, ...] with "
                       f"{dimension + 1 + more} numbers or [\"leaf\", y1, ...] with {dimension}"
                       + ", or [\"moving\", y1, ..., c, [[i, kappa, psi], ...]]" * (not more))


# ---- §3 The question agrees, and the stable verdict -------------------------------------------


def check_question(question: Question, claim: Claim) -> None:
    """`question-...`."""
    said, asked = claim.asked, question.asked
    for rule, found, wanted in (("states", said.states, asked.states),
                                ("robustness", (said.robustness, said.length, said.max_force),
                                 (asked.robustness, asked.length, asked.max_force)),
                                ("contacts", claim.contacts, len(question.contacts)),
                                ("wrench", claim.wrench, question.wrench),
                                ("preload", said.preload, asked.preload),
                                ("law", said.law, asked.law),
                                ("direction", said.direction, asked.direction),
                                ("preload-direction", said.preload_direction,
                                 asked.preload_direction),
                                ("plane", said.plane, asked.plane),
                                ("inertia", said.inertia, asked.inertia),
                                ("statics", said.statics, asked.statics),
                                ("uncertain", said.uncertain, asked.uncertain),
                                ("max-motion", said.max_motion, asked.max_motion)):
        if found != wanted:
            raise Rejected(f"question-{rule}", f"the certificate says {show(found)}, asked was "
                                               f"{show(wanted)}")


class ContactForce(NamedTuple):
    """What follows from a witness for one contact."""
    v: Fraction
    slip: Vector  # τ_i, or s_i
    a: Fraction
    b: Vector     # the friction b_i, or f_i


def sign(x: Union[int, Fraction]) -> int:
    return (x > 0) - (x < 0)


class SlipLaw(NamedTuple):
    """What a Row has, too, and friction takes to be known."""
    normal: Vector
    longest: Fraction  # L², of a share in the plane 1
    gamma: Fraction
    friction: Fraction
    spring: bool


def pushed_by(v: Fraction, slip: Vector, spring: bool) -> ContactForce:
    """Without friction."""
    return ContactForce(v, slip, v if spring else max(Fraction(0), v), zeros(len(slip)))


def check_grasp(question: Question) -> None:
    if question.is_box:
        raise Rejected("witness-box", "an equilibrium of one grasp, but the question is about a box")


def take_friction(question: Question, witness: Witness, rows: Sequence[Union[Row, SlipLaw]],
                  forces: List[ContactForce]) -> None:
    """The rules between `witness-box` and the balance: adds friction to the forces."""
    for j, b in enumerate(question.asked.max_motion or ()):
        if abs(witness.x[j]) > b * witness.x[len(question.wrench)]:
            raise Rejected("witness-bound", f"motion {j + 1} is {show(witness.x[j])}, beyond {show(b)} h")
    last = -1
    for i, share in witness.shares:
        if not last < i < question.slipping():
            raise Rejected("witness-share", f"contact {show(i)}, which is not there or not in order")
        row, last = rows[i], i
        if any(forces[i].slip):
            raise Rejected("witness-share", f"contact {i} slips: {show(forces[i].slip)}")
        if force_square(share, row.gamma) > row.longest or (len(share) > 1 and dot(share, row.normal) != 0):
            raise Rejected("witness-share", f"contact {i}, share {show(share)}")
        forces[i] = forces[i]._replace(b=times(row.friction * forces[i].a, share))
    for i, force in enumerate(forces):
        if question.asked.law == "bilateral" and force.v < 0 and not rows[i].spring:
            raise Rejected("witness-normal", f"contact {i}: v = {show(force.v)} is below 0")
    for i, (row, force) in enumerate(zip(rows, forces)):
        if any(force.slip) and row.friction * force.a:
            against = starred(force.slip, row.gamma)
            ratio = rational_root(row.longest / dot(against, force.slip))
            if ratio is None:
                raise Rejected("witness-root", f"contact {i} slips by {show(force.slip)}, and the "
                                               "ratio of its normal's length to that is irrational")
            forces[i] = force._replace(b=times(-row.friction * force.a * ratio, against))


def check_witness(question: Question, witness: Witness) -> List[ContactForce]:
    """`witness-...`. Returns the forces, one for each contact."""
    check_grasp(question)
    forces = [pushed_by(dot(row.v, witness.x), tuple(dot(s, witness.x) for s in row.slip), row.spring)
              for row in question.rows]
    take_friction(question, witness, question.rows, forces)
    loads = witness.x[len(question.wrench):]  # h and what follows
    total = pairwise_sum([tuple(dot(loads, column)
                                for column in zip(question.w(), *question.growths))]
                         + [tuple(force.a * n + dot(force.b, rows)
                                  for n, *rows in zip(row.N, *row.slip))
                            for row, force in zip(question.rows, forces) if force.a])
    if any(total):
        raise Rejected("witness-balance", f"load and forces add up to {show(total)}, not to 0")
    return forces


# ---- §4 Trees ---------------------------------------------------------------------------------

MORE_DEPTH = 256


class Range(NamedTuple):
    """The λ that a tree is about; high is None for ∞."""
    low: Fraction
    high: Optional[Fraction]
    contains_low: bool
    contains_high: bool


VERDICT = Range(Fraction(0), Fraction(0), True, True)


def h_and_load(dimension: int) -> Tuple[Vector, Vector]:
    """h and ℓ as functions of points."""
    return (zeros(dimension) + (Fraction(1), Fraction(0)),
            zeros(dimension + 1) + (Fraction(1),))


def integers(vector: Sequence[Fraction]) -> Tuple[Integers, int]:
    """The least positive multiple without denominators, and the factor."""
    factor = math.lcm(*(c.denominator for c in vector))
    return tuple(c.numerator * (factor // c.denominator) for c in vector), factor


def reduced(vector: Integers) -> Integers:
    length = words(vector)
    if length > 1:
        Work.divide(4, length, length)
    divisor = math.gcd(*vector)
    if divisor <= 1:
        return vector
    if length > 1:
        Work.divide(5 * len(vector), length, words((divisor,)))  # the other common divisors, and quotients
    return tuple(c // divisor for c in vector)


def negated(vector: Integers) -> Integers:
    return tuple(map(operator.neg, vector))


class Cone:
    """§4, Generators: a region of points, by the double description method.

    `lines` are linearly independent; `rays` are extreme, one for each class modulo the lines, and
    each comes with the set (bits, numbered by the cuts so far) of the conditions that are zero on
    it; on lines all are. Two rays span a two-dimensional face, modulo the lines, iff no third ray
    is zero in all conditions in which both are; where a cut crosses such a face is a new ray.
    """

    def __init__(self, lines: List[Integers], rays: List[Tuple[Integers, int]], cuts: int) -> None:
        self.lines, self.rays, self.cuts = lines, rays, cuts
        self.generators = rays + [(x, -1) for line in lines for x in (line, negated(line))]
        longest = tuple(max(map(abs, x)) for x in itertools.chain(lines, (x for x, _ in rays))) or (0,)
        self.weight, self.words = weight(longest), words(longest)

    def cut(self, a: Integers, equality: bool = False) -> Cone:
        """The part with a·x ≥ 0, or a·x = 0."""
        bit = 1 << self.cuts
        Work.spend(weight(a) * self.weight * len(self.generators))
        Work.multiply(len(a) * len(self.generators), words(a), self.words)
        crossing = next((line for line in self.lines if dot(a, line)), None)
        if crossing is not None:
            # Move all other generators along this line into the plane; half of it stays, as a ray.
            line = crossing if dot(a, crossing) > 0 else negated(crossing)
            rise = dot(a, line)

            def moved(x: Integers) -> Integers:
                height = dot(a, x)
                Work.multiply(2 * len(x), words((rise, height)), self.words)
                return reduced(tuple(rise * c - height * e for c, e in zip(x, line)))

            lines = [moved(other) for other in self.lines if other is not crossing]
            rays = [(moved(x), zero | bit) for x, zero in self.rays]
            return Cone(lines, rays + ([] if equality else [(line, bit - 1)]), self.cuts + 1)

        heights = [(x, zero, dot(a, x)) for x, zero in self.rays]
        rays = [(x, zero if height else zero | bit) for x, zero, height in heights
                if height == 0 or (height > 0 and not equality)]
        # The face that two rays span is given by so many conditions at least.
        least = len(a) - len(self.lines) - 2
        above, below = ([one for one in heights if sign(one[2]) == side_] for side_ in (1, -1))
        for p, p_zero, up in above:
            Work.spend(1 + len(below) // 4)
            search = len(self.rays) // 8 + weight((up,)) * self.weight
            for q, q_zero, down in below:
                both = p_zero & q_zero
                if bin(both).count("1") < least:
                    continue
                Work.spend(search)
                if all(zero & both != both or x is p or x is q for x, zero in self.rays):
                    Work.multiply(2 * len(p), words((up, down)), self.words)
                    rays.append((reduced(tuple(up * c - down * e for c, e in zip(q, p))),
                                 both | bit))
        return Cone(self.lines, rays, self.cuts + 1)


class Parameters(NamedTuple):
    """§6: of one contact, and its preload's growth in a margin, whose ends go with the preload's."""
    normal: Vector             # n⁰
    bounds: Dict[str, Bounds]  # by PARAMETERS
    growth: Bounds             # Pᵘ'
    motion: Optional[Matrix] = None  # §14: G
    spring: bool = False
    gamma: Fraction = Fraction(0)    # §1


class Terms:
    """What trees need of a contact: N and the slip at all corners (of one that is certain, there is
    one), v_i in integers, up to positive factors; and what goes into the bounds of a leaf. As it stands, of
    one without friction."""

    def __init__(self, c: Parameters) -> None:
        x = c.bounds
        self.normal, self.friction, self.spring = c.normal, x.get("friction", exactly(Fraction(0))), c.spring
        self.certain = c.growth.certain and all(number.certain for number in x.values())
        # Corners of positions and e: as 0s and 1s, without those that are certain.
        geometry = GEOMETRY[len(c.normal)]
        uncertain = [name for name in geometry if not x[name].certain]
        self.corners = list(itertools.product((0, 1), repeat=len(uncertain)))
        self.N: List[Vector] = []
        self.rows: List[List[Vector]] = []  # of the slip
        self.tilt = Fraction(0)             # δ of §7
        for corner in self.corners:
            here = [x[name][corner[uncertain.index(name)] if name in uncertain else 0]
                    for name in geometry]
            n = c.normal
            for e, way in zip(here[len(n):], turns(n)):
                n = plus(n, e, way)
            here = here[:len(n)]
            self.tilt = max(self.tilt, dot(n, n) / dot(c.normal, c.normal) - 1)
            self.N.append(pulled(c.motion, at(here, n)))
            self.rows.append(slip_rows(c.motion, here, n, c.normal, c.gamma))
        self.dimension = len(self.N[0])
        pushes = set(zip(x["preload"], c.growth))
        values = [times(-k, n) + push for n in self.N for k in set(x["stiffness"]) for push in pushes]
        forms, self.v_factor = integers([entry for value in values for entry in value])
        self.all_v = [forms[k:k + len(values[0])] for k in range(0, len(forms), len(values[0]))]
        self.v = list(dict.fromkeys(map(reduced, self.all_v)))
        self.certain_v = len(set(self.N)) == 1 and (
            not any(map(any, pushes)) or (x["stiffness"].certain and len(pushes) == 1))
        self.slip = [[integers(row)[0] + (0, 0) for row in rows] for rows in self.rows]
        # What one ray costs in a leaf.
        self.steps = sum(map(weight, itertools.chain(self.all_v, *self.slip)))

    @functools.cached_property
    def in_integers(self) -> Tuple[List[Integers], List[List[Integers]], int]:
        """N and the rows of the slip at all corners, times the number that stands last."""
        size, count = self.dimension, 1 + len(self.rows[0])
        flat, factor = integers([entry for n, rows in zip(self.N, self.rows) for row in (n, *rows) for entry in row])
        rows = [flat[k:k + size] for k in range(0, len(flat), size)]
        return rows[::count], [rows[k + 1:k + count] for k in range(0, len(rows), count)], factor

    def extremes(self, points: Sequence[Integers]) -> Tuple[List[int], List[int]]:
        """The signs, at least, of the least and of the largest v on each point."""
        return extremes(self.v, points)

    def slip_rows(self) -> Optional[List[Integers]]:
        """What a node splits, or None where that is uncertain."""
        raise NotImplementedError

    def stuck(self, x: Integers) -> bool:
        """Whether the slip, which is certain, is zero."""
        return not any(dot(row, x) for row in self.slip[0])

    def work(self, region: Region, points: Sequence[Integers], y: Vector,
             mixed: bool) -> Union[Fraction, List[Fraction]]:
        """α_i of a contact without uncertainty but of its preload in the plane; of others the
        bounds b_i, one for each point."""
        alpha = self.alpha(region, points, y)
        if self.certain:
            return alpha
        if mixed and alpha <= 0:
            return [Fraction(0)] * len(points)
        # α v is largest where v is, or where it is least.
        extreme = max if alpha > 0 else min
        found = [extreme(dot(v, x) for v in self.all_v) for x in points]
        if mixed:
            found = [max(0, v) for v in found]
        weight_ = alpha / self.v_factor
        return [weight_ * v for v in found]

    def alpha(self, region: Region, points: Sequence[Integers], y: Vector) -> Fraction:
        """α_i, the same at all corners."""
        return Fraction(dot(y, self.N[0]))


class PlanarTerms(Terms):
    """§4, in the plane."""

    def __init__(self, c: Parameters) -> None:
        super().__init__(c)
        x, preload, stiffness = c.bounds, c.bounds["preload"], c.bounds["stiffness"]
        normals, tangents = self.N, [rows[0] for rows in self.rows]
        self.tau = [reduced(integers(t)[0]) + (0, 0) for t in dict.fromkeys(tangents)]
        # N + s T by corner, for the ends of ±μ: all by one factor.
        ends = {s: [plus(n, s, t) for n, t in zip(normals, tangents)]
                for s in (-x["friction"].high, -x["friction"].low, *x["friction"])}
        edge_factor = integers([z for edges in ends.values() for edge in edges for z in edge])[1]
        self.edges = {s: [tuple(int(z * edge_factor) for z in edge) for edge in edges]
                      for s, edges in ends.items()}
        self.edge_factor = edge_factor
        # Where P' alone is uncertain, §4 says of the P' that makes the bound large what it says of one grasp.
        self.by_preload = (len(self.corners) == 1 and x["friction"].certain
                           and stiffness.certain)
        if self.by_preload:
            self.all_v.sort(key=lambda v: v[-2:])  # by the end of P', or of c of §5
            return
        self.normals, normal_factor = [], integers([z for n in normals for z in n])[1]
        self.normals = [tuple(int(z * normal_factor) for z in n) for n in normals]
        (*scaled, _), factor = integers([*preload, *stiffness, Fraction(1)])
        self.preload = [p * normal_factor for p in scaled[:2]]
        self.stiffness = scaled[2:]
        self.weight = Fraction(1, edge_factor * normal_factor * factor * len(self.corners))
        # For each k = c + c' the pairs of corners (their numbers, the first ones and the second
        # ones), and what makes means of sums.
        pairs: Dict[Integers, List[Tuple[int, int]]] = {}
        for (a, c1), (b, c2) in itertools.product(enumerate(self.corners), repeat=2):
            pairs.setdefault(tuple(map(operator.add, c1, c2)), []).append((a, b))
        self.cells = [(tuple(a for a, _ in found), tuple(b for _, b in found),
                       len(self.corners) // len(found)) for found in pairs.values()]
        # Of the rays last seen: a leaf asks for them more than once.
        self.heights = functools.lru_cache(maxsize=64)(self.compute_heights)
        self.steps += len(self.corners) ** 2 // 4 * weight(self.edges[self.friction.high][0])

    def slip_rows(self) -> Optional[List[Integers]]:
        return self.tau if len(self.tau) == 1 else None

    def compute_heights(self, x: Integers) -> Tuple[int, int, List[List[int]]]:
        """N·d: the least and the largest of the corners, and those of the second ones by k."""
        height = [dot(n, x) for n in self.normals]
        return min(height), max(height), [[height[b] for b in second] for _, second, _ in self.cells]

    def extremes(self, points: Sequence[Integers]) -> Tuple[List[int], List[int]]:
        if self.by_preload:
            return super().extremes(points)
        # v = P' h − k' N·d, at all ends: what P' and N·d are largest or least is the same for all.
        lows, highs = [], []
        for x in points:
            pushes, (least, most, _) = [p * x[self.dimension] for p in self.preload], self.heights(x)
            lows.append(min(pushes) - max(k * most for k in self.stiffness))
            highs.append(max(pushes) - min(k * least for k in self.stiffness))
        return lows, highs

    def sign(self, region: Region, points: Sequence[Integers]) -> int:
        """+1, −1, or 0 for none."""
        sign_ = side(*extremes(self.tau, points))
        rays = region.generators()
        barred = sign_ and all(region.bars([ray for ray in rays if dot(tau, ray[0]) == 0])
                               for tau in self.tau)
        return sign_ if barred else 0

    def work(self, region: Region, points: Sequence[Integers], y: Vector,
             mixed: bool) -> Union[Fraction, List[Fraction]]:
        sign_ = self.sign(region, points)
        scaled, factor = integers(y)
        if not self.by_preload:
            return [b / factor for b in self.bound(scaled, sign_, mixed, points)]
        ends = {1: (-1,), -1: (1,), 0: (-1, 1)}[sign_]
        alpha = max(dot(scaled, self.edges[s * self.friction.low][0]) for s in ends)
        return Fraction(alpha, self.edge_factor * factor)

    def bound(self, y: Integers, sign_: int, mixed: bool, points: Sequence[Integers]) -> List[Fraction]:
        """§4: the bound b_i(r) on each ray, where y is a multiple without denominators."""
        low, high = self.friction
        best: List[int] = []
        for s in {1: (-low, -high), -1: (low, high), 0: (-high, high)}[sign_]:
            alpha = [dot(y, edge) for edge in self.edges[s]]
            if mixed and max(alpha) <= 0:
                found = [0] * len(points)
            elif mixed and min(alpha) < 0:
                most = max(alpha) * len(self.corners)
                found = [most * max(0, high) for high in self.extremes(points)[1]]
            else:
                # By k: the α(c) of its pairs, and their sum times the end of P' that makes it large.
                at_first = [[alpha[a] for a in first] for first, _, _ in self.cells]
                pushes = [max(p * total for p in self.preload) for total in map(sum, at_first)]
                found = [self.largest(at_first, pushes, x) for x in points]
                if mixed:
                    found = [max(0, value) for value in found]
            best = list(map(max, best, found)) if best else found
        return [self.weight * value for value in best]

    def largest(self, at_first: Sequence[Sequence[int]], pushes: Sequence[int], x: Integers) -> int:
        """U_s(r), times the denominator of the weight."""
        (_, _, at_second), h, (low, high) = self.heights(x), x[self.dimension], self.stiffness
        found = []
        for (_, _, repeat), alpha, height, push in zip(self.cells, at_first, at_second, pushes):
            pull = dot(alpha, height)
            found.append(repeat * (h * push - (low if pull > 0 else high) * pull))
        return max(found)


class SlipCone:
    """§7: C_i, the sums of these slips, by its dual cone: all z with z·s ≥ 0 for them."""

    def __init__(self, slips: Sequence[Integers], gamma: Fraction) -> None:
        # ⟨s, t⟩ = Σ weights_j s_j t_j over the denominator of γ.
        self.weights = (gamma.denominator,) * 3 + (gamma.numerator,) * (gamma > 0)
        self.over = gamma.denominator
        self.dual = all_points(len(self.weights))
        self.steps = 1 + max(map(weight, slips), default=1) ** 2 // 8  # of a product
        self.slips: List[Integers] = []  # of which it is the cone
        for s in dict.fromkeys(map(reduced, slips)):  # many are alike
            if not self.contains(s):
                self.dual = self.dual.cut(s)
                self.slips.append(s)

    def contains(self, s: Integers) -> bool:
        lines, rays = self.dual.lines, self.dual.rays
        Work.spend(self.steps * len(rays))
        # If one line is left, it is n.
        return all(dot(z, s) >= 0 for z, _ in rays) and (len(lines) == 1 or not any(dot(z, s) for z in lines))

    def product(self, s: Integers, t: Integers) -> int:
        """⟨s, t⟩ times the denominator of γ."""
        return sum(map(operator.mul, map(operator.mul, self.weights, s), t))

    def square(self, t: Integers) -> Fraction:
        return Fraction(self.product(t, t), self.over)

    def most_along(self, t: Integers) -> Fraction:
        """M(c)², with the sign of M(c), of a contact that moves, where S_i y = t."""
        q = negated(t)
        if self.contains(q):
            return self.square(q)
        Work.spend(self.steps * len(self.slips) ** 2)
        heights = [(s, self.product(q, s), self.product(s, s)) for s in self.slips]
        most = max(Fraction(height * abs(height), square) for _, height, square in heights)
        # Two slips of a plane have all of it in their span, where q is in the cone of the two or nearest to one.
        for (a, qa, aa), (b, qb, bb) in itertools.combinations(heights, 2) if len(q) > 3 else ():
            ab = self.product(a, b)
            x, y = qa * bb - qb * ab, qb * aa - qa * ab
            if x > 0 and y > 0:
                most = max(most, Fraction(x * qa + y * qb, aa * bb - ab * ab))
        return most / self.over


def root_bounds(square: Fraction, bits: int) -> Bounds:
    """§6: the root, or ℓ⁻ and ℓ⁺."""
    root = rational_root(square)
    if root is not None:
        return exactly(root)
    s = bits + (square.denominator.bit_length() - square.numerator.bit_length()) // 2 - 2
    while True:
        scaled = Fraction(4) ** s * square
        j = math.isqrt(scaled.numerator // scaled.denominator)
        if j >= 1 << (bits - 1):
            return Bounds(j / Fraction(2) ** s, (j + 1) / Fraction(2) ** s)
        s += 1


ROOT_BITS = 64


def root_above(signed_square: Fraction) -> Fraction:
    """§6: the bound of √q, or where q < 0 is given, of −√−q."""
    if signed_square >= 0:
        return root_bounds(signed_square, ROOT_BITS).high
    return -root_bounds(-signed_square, ROOT_BITS).low


class SpatialTerms(Terms):
    """§7."""

    def __init__(self, c: Parameters) -> None:
        super().__init__(c)
        # S at all corners by one factor.
        flat, _ = integers([entry for rows in self.rows for row in rows for entry in row])
        size = self.dimension
        length = size * len(self.rows[0])
        self.S = [[flat[k:k + size] for k in range(start, start + length, size)]
                  for start in range(0, len(flat), length)]
        self.gamma = c.gamma

    def slip_rows(self) -> Optional[List[Integers]]:
        return self.slip[0] if len(self.corners) == 1 else None

    def alpha(self, region: Region, points: Sequence[Integers], y: Vector) -> Fraction:
        slips = [[tuple(dot(row, x) for row in rows) for x in points] for rows in self.S]
        cone = SlipCone([s for at_corner in slips for s in at_corner], self.gamma)
        moves = self in region.moving() or all(
            region.bars([ray for ray, s in zip(region.generators(), at_corner)
                         if cone.contains(negated(s))]) for at_corner in slips)
        found = []
        for n, rows in zip(self.N, self.rows):
            z, factor = integers([dot(row, y) for row in rows])  # S_i y, times the factor
            most_square = cone.square(z) / factor ** 2
            signed_square = cone.most_along(z) / factor ** 2 if moves else most_square
            for mu in set(self.friction):
                cone_square = mu * mu * dot(self.normal, self.normal)
                found.append(dot(y, n) + root_above(cone_square * signed_square))
                if self.tilt:
                    found[-1] += Fraction(3, 2) * self.tilt * root_above(cone_square * most_square)
        return max(found)


def terms_of(c: Parameters) -> Terms:
    return (Terms, PlanarTerms, SpatialTerms)[len(c.normal) - 1](c)


class Box:
    """§6: intervals of all parameters; and §1, of one grasp. A part of a box shares its Terms."""

    def __init__(self, contacts: List[Parameters], loads: Loads, growths: Tuple[Vector, ...],
                 terms: Optional[List[Terms]] = None) -> None:
        self.contacts, self.loads, self.growths = contacts, loads, growths
        self.terms = list(map(terms_of, contacts)) if terms is None else terms
        self.most_depth = 2 * len(contacts) + MORE_DEPTH
        self.dimension = len(loads.base)
        self.coordinates = self.dimension + 1 + len(growths)  # of points

    @property
    def certain(self) -> bool:
        """Is it one point?"""
        return (all(term.certain for term in self.terms)
                and all(load.certain for load in self.loads.bounds))

    def halves(self, part: Node) -> Tuple[Box, Box]:
        """`part-contact`, `part-inside`."""
        i, (cut,) = part.contact, part.numbers
        loads = self.loads.bounds
        if i >= len(loads if part.name == "wrench" else self.contacts) or (
                part.name != "wrench" and part.name not in self.contacts[i].bounds):
            raise Rejected("part-contact", f"there is no {part.name} {show(i)}")
        whole = loads[i] if part.name == "wrench" else self.contacts[i].bounds[part.name]
        if not whole.low < cut < whole.high:
            raise Rejected("part-inside", f"{show(cut)} is not inside {show(whole)}")
        return (self.with_bounds(part.name, i, Bounds(whole.low, cut)),
                self.with_bounds(part.name, i, Bounds(cut, whole.high)))

    def with_bounds(self, name: str, i: int, bounds: Bounds) -> Box:
        if name == "wrench":
            loads = self.loads.bounds
            return Box(self.contacts, self.loads._replace(bounds=(*loads[:i], bounds, *loads[i + 1:])),
                       self.growths, self.terms)
        contacts, terms = list(self.contacts), list(self.terms)
        contacts[i] = contacts[i]._replace(bounds={**contacts[i].bounds, name: bounds})
        terms[i] = terms_of(contacts[i])
        return Box(contacts, self.loads, self.growths, terms)

    def only(self, contacts: Sequence[int]) -> Box:
        """Without all other contacts."""
        return Box([self.contacts[i] for i in contacts], self.loads, self.growths, [self.terms[i] for i in contacts])

    def middle(self) -> Box:
        """q⁰."""
        return Box([contact._replace(bounds={name: number.middle for name, number in contact.bounds.items()},
                                     growth=contact.growth.middle) for contact in self.contacts],
                   self.loads.middle(), self.growths)


def enlarged(question: Question, bits: int) -> Box:
    """§6, the enlarged box; or the box of one grasp, or of a margin."""
    contacts = []
    for contact, grown in zip(question.contacts, question.preload_growth):
        square, preload = dot(contact.normal, contact.normal), contact.preload
        inverse = exactly(Fraction(1))
        if preload.high or grown:
            inverse = root_bounds(1 / square, bits)
        growth = Bounds(grown * inverse.low, grown * inverse.high)
        turned = contact.slope ** 2
        most = [root_bounds(turned * square / dot(way, way), ROOT_BITS).high
                for way in turns(contact.normal)]
        bounds = (*contact.position, *(Bounds(-e, e) for e in most),
                  *(contact.friction,) * contact.is_contact(),
                  Bounds(preload.low * (1 - turned / 2) * inverse.low,
                         preload.high * inverse.high),
                  Bounds(contact.stiffness.low * (1 - turned) / square,
                         contact.stiffness.high / square))
        contacts.append(Parameters(contact.normal, dict(zip(PARAMETERS[len(contact.normal)], bounds)), growth,
                                   contact.motion, bool(contact.spring), contact.gamma))
    return Box(contacts, question.loads, question.growths)


def short_above(x: Fraction) -> Fraction:
    """x, or the least multiple of a power of 2 above it that keeps its first 64 bits."""
    bits = x.denominator.bit_length()
    if bits <= 64:
        return x
    shift = 64 + max(0, bits - x.numerator.bit_length())
    return Fraction(-(-(x.numerator << shift) // x.denominator), 1 << shift)


Condition = Tuple[Sequence[Fraction], bool, bool]  # a; is it a·x = 0, not ≥; is a·x strict?


class Root(NamedTuple):
    """Where a tree begins."""
    box: Box
    conditions: List[Condition]
    bilateral: bool = False       # cut also by v_i ≥ 0, where that is certain
    path: str = ""                # that leads here
    direction: Sequence[Vector] = ()  # of list 2 (§6): A e, by rows
    pieces: Sequence[Cone] = ()   # §12: the dual cones of the load parts of each
    bound: Vector = ()            # B, if motions are bounded and it is no wall


class Region:
    """A node's region and its strict functions: a set (bits, as in Cone) of cuts, each being the
    condition of its cut up to its sign; and in space the slips of some contacts, which are no
    conditions. The cone is computed when the node's turn has come."""

    def __init__(self, parent: Optional[Region], step: str, rows: Sequence[Sequence[Fraction]] = (),
                 equality: bool = False, strict: bool = False, box: Optional[Box] = None,
                 slips: Tuple[int, ...] = ()) -> None:
        self.parent = parent
        self.step = step          # the last step of the path from the root
        self.rows = rows          # the conditions: row·x ≥ 0, or = 0
        self.equality = equality
        self.adds_strict = strict  # is row·x a new strict function?
        self.depth = parent.depth + 1 if parent else 0
        self.strict = 0
        self.slips = slips        # the contacts whose slips are strict
        if parent:
            self.box, self.direction = box or parent.box, parent.direction
            self.pieces, self.bound = parent.pieces, parent.bound
            self.slips += parent.slips

    def open(self) -> None:
        assert self.parent is not None
        cone = self.parent.cone
        self.strict = self.parent.strict | self.adds_strict << cone.cuts
        for row in self.rows:
            cone = cone.cut(integers(row)[0], self.equality)
        self.cone = cone

    def moving(self) -> List[Terms]:
        return [self.box.terms[i] for i in self.slips]

    def generators(self) -> List[Tuple[Integers, int]]:
        """Those of the cone. Behind the bits of its cuts come those of the slips."""
        if not self.slips:
            return self.cone.generators
        cuts, moving = self.cone.cuts, self.moving()
        return [(x, zero & ((1 << cuts) - 1)
                 | sum(term.stuck(x) << (cuts + k) for k, term in enumerate(moving)))
                for x, zero in self.cone.generators]

    def bars(self, rays: Sequence[Tuple[Integers, int]]) -> bool:
        """§4, barred: is some strict function zero on all of these rays?"""
        common = self.strict | ((1 << len(self.slips)) - 1) << self.cone.cuts
        for _, zero in rays:
            common &= zero
        return common != 0

    def path(self) -> str:
        steps, region = [], self
        while region.parent is not None:
            steps.append(region.step)
            region = region.parent
        return ", ".join([region.step] * bool(region.step) + steps[::-1]) or "root"


def all_points(n: int) -> Cone:
    return Cone([tuple(int(j == k) for k in range(n)) for j in range(n)], [], 0)


def begin(root: Root) -> Region:
    region = Region(None, root.path)
    region.box, region.direction, region.pieces = root.box, root.direction, root.pieces
    region.bound = root.bound
    region.cone = all_points(root.box.coordinates)
    conditions = list(root.conditions)
    if root.bilateral:
        conditions += [(term.v[0], False, False) for term in root.box.terms
                       if term.certain_v and not term.spring]
    for row, equality, strict in conditions:
        region.strict |= strict << region.cone.cuts
        region.cone = region.cone.cut(integers(row)[0], equality)
    return region


def within(loads: Range, dimension: int) -> List[Condition]:
    """h > 0, and λ in the range."""
    h, load = h_and_load(dimension)
    found = [(h, False, True), (plus(load, -loads.low, h), False, not loads.contains_low)]
    if loads.high is not None:
        found.append((plus(times(loads.high, h), Fraction(-1), load), False,
                      not loads.contains_high))
    return found


def simplex_around(bound: Vector) -> List[Condition]:
    """§4: d_j ≥ −B_j h for all j, and Σ d_j/B_j ≤ D h."""
    size = len(bound)
    rows = [unit(size, j) + (b, Fraction(0)) for j, b in enumerate(bound)]
    rows += [tuple(-1 / b for b in bound) + (Fraction(size), Fraction(0))] * (size > 0)
    return [(row, False, False) for row in rows]


def roots(question: Question, box: Box, ranges: Sequence[Range], path: str = "") -> List[Root]:
    """§4, of an unstable verdict or a margin."""
    bound = question.asked.max_motion or ()
    return [Root(box, within(loads, box.dimension) + simplex_around(bound), question.asked.law == "bilateral", path,
                 bound=bound) for loads in ranges]


def times(factor: Fraction, a: Sequence[Fraction]) -> Vector:
    return tuple(factor * x if x else x for x in a)


def plus(a: Sequence[Fraction], factor: Fraction, b: Sequence[Fraction]) -> Vector:
    return tuple(x + factor * y if y else x for x, y in zip(a, b))


def extremes(forms: Sequence[Integers], points: Sequence[Integers]) -> Tuple[List[int], List[int]]:
    """The signs, at least, of the least and of the largest on each point."""
    lows = highs = [dot(forms[0], x) for x in points]
    for form in forms[1:]:
        values = [dot(form, x) for x in points]
        lows, highs = list(map(min, lows, values)), list(map(max, highs, values))
    return lows, highs


def side(lows: Sequence[int], highs: Sequence[int]) -> int:
    """+1 if all are ≥ 0, else −1 if all are ≤ 0, else 0."""
    return 1 if min(lows) >= 0 else -1 if max(highs) <= 0 else 0


def leaf_refusal(region: Region, y: Vector,
                 shorten: Callable[[Fraction], Fraction]) -> Optional[str]:
    """`leaf-bound`: why it does not hold, or None. g grows with every α_i and b_i, so if it holds
    with each replaced by something that is not smaller, `shorten`, then it holds."""
    rays, box = region.generators(), region.box
    if region.bars(rays):
        return None
    points = [x for x, _ in rays]
    # Terms of g, `bends`: factor·max(0, v_i(x)), and the bounds of contacts that are uncertain.
    linear = [zeros(box.dimension) + (box.loads.most_work(y),)
              + tuple(Fraction(dot(y, growth)) for growth in box.growths)]
    bends, bounds = [], []
    for term in box.terms:
        Work.spend(term.steps * region.cone.weight * len(points))
        v_side = 1 if term.spring else side(*term.extremes(points))  # §14: a spring is closed
        if v_side < 0:
            continue  # max(0, v_i) = 0
        found = term.work(region, points, y, v_side == 0)
        if isinstance(found, list):
            bounds.append(list(map(shorten, found)))
            continue
        v = term.all_v[-1 if found > 0 else 0]
        # v of a spring may be below 0, so that a larger α serves for it no more than a smaller one.
        weight = found / term.v_factor if term.spring else shorten(found / term.v_factor)
        if v_side > 0:
            linear.append(tuple(weight * c for c in v) + zeros(box.coordinates - len(v)))
        elif weight > 0:
            bends.append((weight, [dot(v, x) for x in points]))
    form, scale = integers(pairwise_sum(linear))
    flat = []  # the rays with g = 0
    for k, x in enumerate(points):
        g = Fraction(dot(form, x), scale) + sum(f * values[k] for f, values in bends
                                                if values[k] > 0)
        g += sum(values[k] for values in bounds)
        if g > 0:
            return f"g = {show(g)} at {show(x)}"
        if g == 0:
            flat.append(rays[k])
    return None if region.bars(flat) else "g = 0 on rays that are not barred together"


def is_beyond(region: Region) -> bool:
    """§4: is the region beyond the bound?"""
    rays = region.generators()
    for j, b in enumerate(region.bound):
        Work.spend(1 + region.cone.weight * len(rays) // 4)
        for sign_ in (1, -1):
            # σ d_j − B_j h, times the denominator of B_j
            heights = [sign_ * b.denominator * x[j] - b.numerator * x[len(region.bound)] for x, _ in rays]
            if min(heights, default=0) >= 0 and region.bars([ray for ray, height in zip(rays, heights) if not height]):
                return True
    return False


def check_leaf(region: Region, y: Vector) -> None:
    """`leaf-bound`, and §6, `leaf-direction`."""
    if is_beyond(region):
        return
    for shorten in (short_above, lambda x: x):
        found = leaf_refusal(region, y, shorten)
        if found is None:
            break
    else:
        raise Rejected("leaf-bound", found or "")
    if not region.direction or region.bars(region.generators()):
        return
    pull = [sum(c * row[k] for c, row in zip(y, region.direction)) for k in range(len(y) + 2)]
    for x, _ in region.cone.generators:
        if dot(pull, x) < 0:
            raise Rejected("leaf-direction", f"y.A(d - h d0) = {show(dot(pull, x))} at {show(x)}")


def check_own(box: Box, own: Sequence[Tuple[int, Fraction, Vector]]) -> None:
    """`moving-list`."""
    last = -1
    for i, kappa, psi in own:
        if not last < i < len(box.terms) or not box.terms[i].rows[0]:
            raise Rejected("moving-list", f"contact {show(i)} after {show(last)}, of {len(box.terms)}")
        if kappa < 0 or dot(starred(psi, box.contacts[i].gamma), psi) > kappa ** 2:
            raise Rejected("moving-list", f"psi = {show(psi)} of contact {i} is longer than {show(kappa)}")
        last = i


Extent = Tuple[Any, Any]  # the least and the largest, as exact numbers or as whole ones


class MovingLeaf:
    """§4, a leaf whose twist moves: B(r, r') for its rays. With `bits` numbers are whole multiples of 2^-bits, each rounded to the
    side on which B is not smaller, and a ray stands for the multiple of it that has a largest coordinate below 1."""

    def __init__(self, region: Region, node: Node, bits: Optional[int]) -> None:
        self.region, self.bits = region, bits
        (*self.y, self.c), self.over = integers(node.numbers)  # y and c are these over that
        self.rays = [x for x, _ in region.generators()]
        box, size = region.box, len(self.y)
        self.sizes = [1 if bits is None else 1 << max(map(int.bit_length, x)) for x in self.rays]
        # What does work: whether it is mixed, v(r) and A(r). The load is a closed one, with h for v.
        moved = [tuple(Fraction(z, self.over) for z in self.moved(x)) for x in self.rays]
        self.weight = max(weight((self.c, self.over, *self.y)), region.cone.weight)
        heights = [Fraction(x[size]) for x in self.rays]
        loads = [self.above(work.numerator, work.denominator, one) for work, one in zip(map(box.loads.most_work, moved), self.sizes)]
        self.works: List[Tuple[bool, List[Extent], List[Extent]]] = [
            (False, [self.extent(h, h, one) for h, one in zip(heights, self.sizes)], [(load, load) for load in loads])]
        own = {i: (kappa, psi) for i, kappa, psi in node.own}
        for i, (term, c) in enumerate(zip(box.terms, box.contacts)):
            self.add(term, c, *own.get(i, (Fraction(0), ())))

    def moved(self, x: Integers) -> Integers:
        """y(x), times self.over."""
        h = x[len(self.y)]
        return tuple(self.c * d + h * y for d, y in zip(x, self.y))

    def above(self, n: int, d: int, size: int) -> Any:
        """n/d over the size of its ray."""
        return Fraction(n, d) if self.bits is None else -((-n << self.bits) // (d * size))

    def extent(self, low: Fraction, high: Fraction, size: int) -> Extent:
        return -self.above(-low.numerator, low.denominator, size), self.above(high.numerator, high.denominator, size)

    def root(self, n: int, d: int, size: int, sign_: int = 1) -> Any:
        """The bound of √(n/d), or of −√(n/d)."""
        if self.bits is None:
            return root_above(Fraction(sign_ * n, d))
        # What §6 says differs from the root by less than a part in 2^62.
        root = math.isqrt((n << 2 * self.bits) // (d * size * size))
        return sign_ * root + (root >> 62) + 2

    def times(self, factor: Fraction, x: Any) -> Any:
        return factor * x if self.bits is None else -(-factor.numerator * x // factor.denominator)

    def add(self, term: Terms, c: Parameters, kappa: Fraction, psi: Vector) -> None:
        """One contact, unless it is open."""
        normals, rows, factor = term.in_integers
        size = len(self.y)
        rubs = term.friction.high > 0
        Work.spend((4 + 10 * rubs) * len(normals) * len(self.rays) * max(self.weight, weight(normals[0])) ** 2)
        across = Across(self, term, c, kappa, psi) if rubs else None
        heights = [[dot(n, x) for n in normals] for x in self.rays]
        own_heights = [dot(n, self.y) for n in normals]
        preload, stiffness = c.bounds["preload"], c.bounds["stiffness"]
        pressures = []
        for x, height in zip(self.rays, heights):
            least, most = min(height), max(height)
            pressures.append((preload.low * x[size] - max(k * most for k in stiffness) / factor,
                              preload.high * x[size] - min(k * least for k in stiffness) / factor))
        v_side = 1 if term.spring else side(*zip(*pressures))
        if v_side < 0:
            return
        found = []
        for x, one, height in zip(self.rays, self.sizes, heights):
            works = [self.c * high + x[size] * own for high, own in zip(height, own_heights)]
            most = max(self.above(work, self.over * factor, one) + (across.most(corner, x, one) if across else 0)
                       for corner, work in enumerate(works))
            # v of a spring may be below 0, where a larger A is no bound.
            found.append((-self.above(-works[0], self.over * factor, one) if term.spring else most, most))
        self.works.append((v_side == 0, [self.extent(*v, one) for v, one in zip(pressures, self.sizes)], found))

    def bound(self, r: int, s: int) -> Any:
        """2 B, times something positive."""
        total = 0
        for mixed_, v, most in self.works:
            for a, b in ((r, s), (s, r)):
                if mixed_:
                    total += max(0, v[a][1]) * max(0, most[b][1])
                else:
                    total += max(one * other for one in v[a] for other in most[b])
        if self.bits is None:
            length = words((Fraction(total).denominator,))
            Work.divide(4 * len(self.works), length, length)
        return total

    def refusal(self) -> Optional[str]:
        """`leaf-bound`: why it does not hold, or None."""
        rays, flat = self.region.generators(), []
        Work.spend(len(rays) ** 2 * len(self.works) * self.weight)
        for r, x in enumerate(self.rays):
            for s, other in enumerate(self.rays[:r + 1]):
                bound = self.bound(r, s)
                if bound > 0:
                    return f"B = {show(Fraction(bound) / 2)} at {show(x)} and {show(other)}"
            if bound == 0:
                flat.append(rays[r])
        return None if self.region.bars(flat) else "B(r, r) = 0 on rays that are not barred together"

    def check_direction(self) -> None:
        """`leaf-direction`."""
        length = len(self.y) + 2
        flat, _ = integers([c for row in self.region.direction for c in row])
        rows = [flat[k:k + length] for k in range(0, len(flat), length)]
        pairs = [(self.moved(x), [dot(row, x) for row in rows]) for x in self.rays]
        Work.spend(len(pairs) ** 2 * self.weight)
        for (y, pull), (other_y, other_pull) in itertools.combinations_with_replacement(pairs, 2):
            if dot(y, other_pull) + dot(other_y, pull) < 0:
                raise Rejected("leaf-direction", f"y.A(d - h d0) is below 0 for y = {show(y)} and {show(other_y)}")


class Across:
    """The friction of a contact in a moving leaf."""

    def __init__(self, leaf: MovingLeaf, term: Terms, c: Parameters, kappa: Fraction, psi: Vector) -> None:
        _, self.rows, factor = term.in_integers
        # In the plane neither δ nor L² plays a part.
        tilt, square = (term.tilt, dot(c.normal, c.normal)) if len(c.normal) == 3 else (Fraction(0), Fraction(1))
        self.leaf, self.stretch, self.friction = leaf, 1 + tilt / 2, set(term.friction)
        gamma = c.gamma or Fraction(1)
        self.weights = (gamma.denominator,) * 3 + (gamma.numerator,)
        # S y(x) − κ s is `along` s and h `across`, by corner, over this:
        self.along = leaf.c * kappa.denominator - leaf.over * kappa.numerator
        self.own = [[kappa.denominator * dot(row, leaf.y) for row in rows] for rows in self.rows]
        over = factor * leaf.over * kappa.denominator
        self.square, self.over = square.numerator, square.denominator * gamma.denominator * over ** 2
        psi, psi_over = integers(psi)
        self.psi = tuple(map(operator.mul, self.weights, psi))
        self.psi_over = square.denominator * (gamma.denominator * psi_over * factor) ** 2

    def most(self, corner: int, x: Integers, size: int) -> Any:
        leaf, h = self.leaf, x[len(self.leaf.y)]
        slip = [dot(row, x) for row in self.rows[corner]]
        left = [self.along * s + h * own for s, own in zip(slip, self.own[corner])]
        length = leaf.root(self.square * sum(w * z * z for w, z in zip(self.weights, left)), self.over, size)
        most = leaf.times(self.stretch, length)
        if self.psi:
            product = dot(self.psi, slip)
            most += leaf.root(self.square * product * product, self.psi_over, size, sign(product))
        return max(leaf.times(mu, most) for mu in self.friction)


def check_moving(region: Region, node: Node) -> None:
    """`moving-list`, `leaf-bound`, and §6, `leaf-direction`."""
    check_own(region.box, node.own)
    if region.bars(region.generators()) or is_beyond(region):
        return
    for bits in (96, None):
        leaf = MovingLeaf(region, node, bits)
        found = leaf.refusal()
        if found is None:
            break
    else:
        raise Rejected("leaf-bound", found or "")
    if region.direction:
        leaf.check_direction()


def children(region: Region, node: Node) -> List[Region]:
    """§4, the table of nodes: the children in order."""
    i, box = node.contact, region.box
    if node.kind == "part":
        return [Region(region, f"{node.name} {i} {name}", box=half)
                for name, half in zip(("low", "high"), box.halves(node))]
    if node.kind == "plane":
        row, steps = node.numbers, ("plane +", "plane -")
        return [Region(region, steps[0], [row]),
                Region(region, steps[1], [times(Fraction(-1), row)], strict=True)]
    if i >= len(box.terms):
        raise Rejected("node-contact", f"contact {show(i)}, the grasp has {len(box.terms)}")
    term = box.terms[i]
    if term.spring or (node.kind == "slip" and not term.rows[0]):
        raise Rejected("node-contact", f"there is no {node.kind} of element {i}, a spring or ratchet")
    if node.kind == "separation":
        rows = term.v if term.certain_v else None
    else:
        rows = term.slip_rows()
    if rows is None:
        raise Rejected("node-certain", f"contact {i} is uncertain there")
    below = [negated(rows[0])]
    if node.kind == "separation":
        return [Region(region, f"separation {i} closed", rows),
                Region(region, f"separation {i} open", below, strict=True)]
    if len(box.terms[i].normal) == 3:
        return [Region(region, f"slip {i} 0", rows, equality=True),
                Region(region, f"slip {i} not 0", slips=(i,))]
    return [Region(region, f"slip {i} +", rows, strict=True),
            Region(region, f"slip {i} 0", rows, equality=True),
            Region(region, f"slip {i} -", below, strict=True)]


def check_held(region: Region, piece: int) -> None:
    """§12: `held-piece`, `held-inside`."""
    if piece >= len(region.pieces):
        raise Rejected("held-piece", f"piece {show(piece)}, of {len(region.pieces)}")
    dual = region.pieces[piece]
    for x, _ in region.generators():
        load = x[PLANE:]
        if any(dot(a, load) for a in dual.lines) or any(dot(a, load) < 0 for a, _ in dual.rays):
            raise Rejected("held-inside", f"{show(x)} has its load outside of piece {piece}")


def check_node(region: Region, node: Node) -> List[Region]:
    """The rules of one node, whose children are returned."""
    if region.depth > region.box.most_depth:
        raise Rejected("node-depth", f"{region.depth} nodes stand above this one")
    if node.kind == "held":
        check_held(region, node.contact)
        return []
    if node.kind == "moving":
        check_moving(region, node)
        return []
    if node.kind != "leaf":
        return children(region, node)
    check_leaf(region, node.numbers)
    return []


def check_tree(tree: Sequence[Node], beginnings: Sequence[Root], place: Optional[str] = None) -> None:
    """One tree for each of the roots; `place` is where the list is. `waiting` holds the regions
    whose nodes are still to come, the next one last."""
    waiting: List[Region] = []
    begun = 0
    for number, node in enumerate(tree):
        if waiting:
            region = waiting.pop()
            region.open()
        elif begun < len(beginnings):
            region = begin(beginnings[begun])
            begun += 1
        else:
            raise Rejected("tree-long", f"{len(tree) - number} nodes after the end", place, number)
        try:
            waiting += reversed(check_node(region, node))
        except Rejected as failure:
            failure.node, failure.path = number, region.path()
            raise
    if waiting:
        raise Rejected("tree-short", f"{len(waiting)} children are missing", waiting[-1].path(),
                       len(tree))
    if begun < len(beginnings):
        raise Rejected("tree-short", f"{len(beginnings) - begun} trees are missing",
                       beginnings[begun].path or "root", len(tree))


# ---- §5 Margins -------------------------------------------------------------------------------


def check_resisted(resisted: Sequence[Interval]) -> None:
    """`resisted-order`."""
    for k, (low, high) in enumerate(resisted):
        before = resisted[k - 1][1] if k else None
        in_order = low >= 0 if k == 0 else before is not None and before < low
        if not in_order or (high is not None and high < low):
            raise Rejected("resisted-order", f"({show(low)}, {show(high)})"
                           + (f" after {show(before)}" if k else ""), f"interval {k}")


def multiple(point: Witness) -> Optional[Fraction]:
    """λ; None for a ray."""
    return point.x[-1] if point.x[-2] else None


def check_segments(segments: Sequence[Segment], resisted: Sequence[Interval],
                   question: Question) -> None:
    """Each goes from where it must until all intervals are covered."""
    at = 0                            # the interval at hand
    done: Optional[Fraction] = None   # how far it is covered, if at all
    last: Optional[Witness] = None    # the last point, where a segment often begins
    forces: List[ContactForce] = []   # and its forces
    box = enlarged(question, 128)
    for k, segment in enumerate(segments):
        place = f"segment {k}"
        if at == len(resisted):
            raise Rejected("segment-chain", "the intervals are covered already", place)
        low, high = resisted[at]
        begin = low if done is None else done
        by_degree = isinstance(segment, DegreeProof)
        end = segment.to if isinstance(segment, DegreeProof) else multiple(segment[1])
        if not isinstance(segment, DegreeProof) and multiple(segment[0]) != begin:
            raise Rejected("segment-chain", f"begins at {show(multiple(segment[0]))}, must begin at "
                                            f"{show(begin)}", place)
        if high is not None and (end is None or end > high):
            raise Rejected("segment-chain", f"goes to {show(end)}, beyond {show(high)}", place)
        if end is not None and (end < begin or (by_degree and end == begin)):
            raise Rejected("segment-chain", f"goes from {show(begin)} to {show(end)}", place)
        if isinstance(segment, DegreeProof):
            if end is None and begin == 0 and not at_rest(question):
                raise Rejected("segment-chain", "from 0 to infinity, but the wrench or a preload is "
                                                "not 0", place)
            start = Fraction(1) if end is None and begin == 0 else begin
            check_degree(segment, box, question.asked, place, start, end)
        else:
            for point, name in zip(segment, ("first", "second")):
                if point == last:
                    continue
                before, forces = forces, check_point(question, point, f"{place}, {name} point")
                if name == "second":
                    check_mode(question, before, forces, place)
                last = point
        at, done = (at + 1, None) if end == high else (at, end)
    if at < len(resisted):
        raise Rejected("segment-chain", "missing: the intervals are not covered yet",
                       f"segment {len(segments)}")


def check_point(question: Question, point: Witness, place: str) -> List[ContactForce]:
    """`witness-...`."""
    try:
        return check_witness(question, point)
    except Rejected as failure:
        failure.path = place
        raise


def check_mode(question: Question, first: Sequence[ContactForce], second: Sequence[ContactForce],
               place: str) -> None:
    """`segment-mode`."""
    for i, (row, p, q) in enumerate(zip(question.rows, first, second)):
        if not row.spring and (p.v < 0 < q.v or q.v < 0 < p.v):
            raise Rejected("segment-mode", f"contact {i}: v = {show(p.v)} and {show(q.v)}", place)
        if row.friction == 0 or p.a + q.a == 0:
            continue
        if not one_way(p.slip, q.slip):
            raise Rejected("segment-mode", f"contact {i} slips by {show(p.slip)} and by "
                                           f"{show(q.slip)}, not in one direction", place)
        against = times(Fraction(-1), starred(plus(p.slip, Fraction(1), q.slip), row.gamma))
        for force in (p, q):
            full = force_square(force.b, row.gamma) == (row.friction * force.a) ** 2 * row.longest
            if any(against) and not (full and one_way(force.b, against)):
                raise Rejected("segment-mode", f"contact {i} slips at one end, and at the other its "
                                               "friction is not the same full share", place)


def one_way(a: Vector, b: Vector) -> bool:
    """Whether both are multiples >= 0 of one vector."""
    parallel = all(a[j] * b[k] == a[k] * b[j] for k in range(len(a)) for j in range(k))
    return parallel and dot(a, b) >= 0


def gaps(resisted: Sequence[Interval]) -> List[Range]:
    """What the intervals leave of [0, ∞)."""
    found, low, contained = [], Fraction(0), True
    for begin, end in resisted:
        if low < begin:
            found.append(Range(low, begin, contained, False))
        if end is None:
            return found
        low, contained = end, False
    return found + [Range(low, None, contained, False)]


# ---- §6 Stable: at rest -----------------------------------------------------------------------


def no_friction(term: Terms) -> List[Vector]:
    return [zeros(len(term.rows[0]))] * (1 + term.dimension)


def friction_of(proof: Union[RestProof, StickingProof], box: Box, place: str) -> Dict[int, List[Vector]]:
    """`rest-share`, or what `sticking-share` says of them: f⁰ and G_1, …, G_D of each contact that is listed; 0 where they are
    not stated."""
    found: Dict[int, List[Vector]] = {}
    rule, forces_at_rest = ("rest-share", proof.rest) if isinstance(proof, RestProof) else ("sticking-share", proof.friction)
    for entries, first in ((forces_at_rest, 0), (proof.answers, 1)):
        before = -1
        for i, forces in entries:
            if not before < i < len(box.contacts) or not box.terms[i].rows[0]:
                raise Rejected(rule, f"contact {show(i)} after {show(before)}", place)
            if len(forces[0]) > 1 and any(dot(f, box.contacts[i].normal) for f in forces):
                raise Rejected(rule, f"contact {i}: not across its normal", place)
            found.setdefault(i, no_friction(box.terms[i]))[first:first + len(forces)] = forces
            before = i
    return found


def wrenches(term: Terms, push: Bounds, forces: Sequence[Vector], presses: Vector) -> List[Vector]:
    """Of one contact: a N + Sᵀ f⁰, H_1 N + Sᵀ G_1, …, H_D N + Sᵀ G_D in one, the least and the largest entries."""
    found = []
    for normal, rows in zip(term.N, term.rows):
        first, *columns = [tuple(dot(force, entries) for _, *entries in zip(normal, *rows)) for force in forces]
        answers = sum((plus(column, h, normal) for column, h in zip(columns, presses)), ())
        found += [plus(first, p, normal) + answers for p in set(push)]
    return [tuple(map(end, zip(*found))) for end in (min, max)]


def largest_left(box: Box, multiple: Fraction, pushes: Sequence[Bounds], friction: Dict[int, List[Vector]],
                 presses: Dict[int, Vector]) -> Vector:
    """The largest |W_k|, and |M_kl − δ_kl| by columns."""
    size = box.dimension
    units = [unit(size, k) for k in range(size)]
    less = tuple(-c for row in units for c in row)
    ends = [[plus(tuple(sign_ * box.loads.most_work(times(Fraction(sign_), e)) for e in units), multiple, box.growths[0]) + less]
            for sign_ in (-1, 1)]
    for i, (term, push) in enumerate(zip(box.terms, pushes)):
        if any(push) or i in friction or i in presses:
            found = wrenches(term, push, friction.get(i) or no_friction(term), presses.get(i) or zeros(size))
            for terms, end in zip(ends, found):
                terms.append(end)
    return tuple(max(-low, high) for low, high in zip(*map(pairwise_sum, ends)))


def preloads(box: Box, multiple: Fraction) -> List[Bounds]:
    """P'_i for this multiple."""
    return [Bounds(*(p + multiple * grown for p, grown in zip(c.bounds["preload"], c.growth))) for c in box.contacts]


def normal_length(c: Parameters) -> Bounds:
    """L_i; 1 where friction is a number."""
    return root_bounds(dot(c.normal, c.normal), ROOT_BITS) if len(c.normal) == 3 else exactly(Fraction(1))


def friction_lengths(c: Parameters, forces: Sequence[Vector]) -> Vector:
    return tuple(root_bounds(force_square(f, c.gamma), ROOT_BITS).high if len(f) > 1 else abs(f[0]) for f in forces)


def check_rest(proof: RestProof, box: Box, place: str, multiples: Sequence[Fraction] = (Fraction(0),)) -> None:
    """A part at rest, for all λ between two."""
    friction = friction_of(proof, box, place)
    factors = (Fraction(1), *proof.reach)
    for multiple in multiples:
        pushes = preloads(box, multiple)
        left = largest_left(box, multiple, pushes, friction, {})
        for k, reach in enumerate(proof.reach):
            if reach < 0 or dot(left[k::box.dimension], factors) > reach:
                raise Rejected("rest-reach", f"Z_{k + 1} = {show(reach)} is too small", place)
        for i, forces in sorted(friction.items()):
            c = box.contacts[i]
            most = c.bounds["friction"].low * normal_length(c).low * pushes[i].low
            needed = dot(friction_lengths(c, forces), factors)
            if needed > most:
                raise Rejected("rest-cone", f"contact {i}: friction may be {show(needed)}, the cone allows {show(most)}", place)


# ---- §6 Stable: sticking ----------------------------------------------------------------------


def presses_of(proof: StickingProof, box: Box, place: str) -> Dict[int, Vector]:
    """What `sticking-share` says of H, Z and c."""
    found: Dict[int, Vector] = {}
    before = -1
    for i, numbers in proof.presses:
        if not before < i < len(box.contacts):
            raise Rejected("sticking-share", f"contact {show(i)} after {show(before)}", place)
        if not box.contacts[i].bounds["stiffness"].low:
            raise Rejected("sticking-share", f"contact {i}: its stiffness may be 0", place)
        found[i], before = numbers, i
    if not min(*proof.reach, proof.energy) > 0:
        raise Rejected("sticking-share", "Z or c is not above 0", place)
    return found


class Sticking(NamedTuple):
    """Of an element, at d⁰, by the names of the text."""
    v: Bounds
    a: Bounds        # a⁰
    sigma: Fraction
    r: Fraction
    phi: Fraction
    spare: Fraction  # s
    gamma: Fraction


def sticking_at(proof: StickingProof, c: Parameters, term: Terms, preload: Bounds, forces: Sequence[Vector],
                presses: Vector) -> Sticking:
    stiffness, mu, length = c.bounds["stiffness"], term.friction, normal_length(c)
    pulls = [k * dot(n, proof.twist) for n in term.N for k in stiffness]
    v = Bounds(preload.low - max(pulls), preload.high - min(pulls))
    a = v if c.spring else Bounds(max(Fraction(0), v.low), max(Fraction(0), v.high))
    slips = [tuple(dot(row, proof.twist) for row in rows) for rows in term.rows]
    sigma = max(root_above(dot(starred(s, c.gamma), s)) if len(s) > 1 else abs(sum(s, Fraction(0))) for s in slips)
    r = root_above(2 * proof.energy * stiffness.high)
    phi = dot(friction_lengths(c, forces), (Fraction(1), *proof.reach))
    delta = dot(tuple(map(abs, presses)), proof.reach)
    rho = mu.high * length.high
    gamma = max(((delta + rho * k * sigma) ** 2 / (2 * k) + (rho * a.high + phi) * sigma for k in stiffness if k),
                default=Fraction(0))
    return Sticking(v, a, sigma, r, phi, mu.low * length.low * (v.low - r) - phi, gamma)


def check_sticking(proof: StickingProof, box: Box, asked: Options, place: str,
                   multiples: Sequence[Fraction] = (Fraction(0),)) -> None:
    """A sticking part, for all λ between two."""
    size = box.dimension
    friction, presses = friction_of(proof, box, place), presses_of(proof, box, place)
    listed = sorted({*friction, *presses})
    turning = any(len(c.normal) == 3 and term.tilt for c, term in zip(box.contacts, box.terms))
    if any(proof.twist) and (len(multiples) > 1 or turning):
        raise Rejected("sticking-motion", "d0 is not 0, for more than one multiple or with uncertain normals", place)
    if asked.law == "bilateral" and any(not c.spring and i not in friction and i not in presses for i, c in enumerate(box.contacts)):
        raise Rejected("sticking-motion", "a contact is not listed, under the bilateral law", place)
    factors = (Fraction(1), *proof.reach)
    for multiple in multiples:
        found = [sticking_at(proof, c, term, preload, friction.get(i, ()), presses.get(i, ()))
                 for i, (c, term, preload) in enumerate(zip(box.contacts, box.terms, preloads(box, multiple)))]
        left = largest_left(box, multiple, [one.a for one in found], friction, presses)
        for k, reach in enumerate(proof.reach):
            if dot(left[k::size], factors) >= reach:
                raise Rejected("sticking-reach", f"Z_{k + 1} = {show(reach)} is too small", place)
        for i in listed:
            v, r, phi = found[i].v.low, found[i].r, found[i].phi
            if not box.contacts[i].spring and v < r:
                raise Rejected("sticking-press", f"contact {i}: v may be {show(v)}, below r = {show(r)}", place)
            if i in friction and found[i].spare <= 0:
                raise Rejected("sticking-press", f"contact {i}: friction may be {show(phi)}, as much as the cone allows", place)
        (energy,) = pairwise_sum([(one.gamma,) for one in found] or [(Fraction(0),)])
        if energy >= proof.energy:
            raise Rejected("sticking-energy", f"c = {show(proof.energy)}, but the sum may be {show(energy)}", place)
        if asked.max_motion is None:
            continue
        within = [b - abs(d) for b, d in zip(asked.max_motion, proof.twist)]
        for l in range(size):
            most = dot(left[size * (l + 1):size * (l + 2)], within)
            for i in listed:
                if i in presses:
                    most += abs(presses[i][l]) * root_above(2 * proof.energy / box.contacts[i].bounds["stiffness"].low)
                if i in friction:
                    (length,) = friction_lengths(box.contacts[i], friction[i][l + 1:l + 2])
                    most += length * (proof.energy / found[i].spare + found[i].sigma)
            if min(within) <= 0 or most > within[l]:
                raise Rejected("sticking-bound", f"motion {l + 1} may differ from d0 by {show(most)}", place)


# ---- §6 Stable: by degree ---------------------------------------------------------------------


def kernel(rows: Sequence[Vector]) -> List[Vector]:
    """A basis of the vectors that have the product 0 with every row: by elimination."""
    reduced_rows: Dict[int, Vector] = {}  # by the column in which it alone has a 1, and no other
    for row in rows:
        for j, other in reduced_rows.items():
            row = plus(row, -row[j], other)
        pivot = next((j for j, c in enumerate(row) if c), None)
        if pivot is None:
            continue
        row = times(1 / row[pivot], row)
        reduced_rows = {j: plus(other, -other[pivot], row) for j, other in reduced_rows.items()}
        reduced_rows[pivot] = row
    return [tuple(-reduced_rows[j][free] if j in reduced_rows else Fraction(j == free)
                  for j in range(len(rows[0])))
            for free in range(len(rows[0])) if free not in reduced_rows]


def what_sees(z: Vector, box: Box) -> Optional[str]:
    """`degree-free`: what sees the motion z, if anything."""
    for i, term in enumerate(box.terms):
        if any(dot(normal, z) for normal in term.N):
            return f"contact {i} presses along {show(z)}"
        if term.friction.high and any(dot(row, z) for rows in term.rows for row in rows):
            return f"contact {i} has friction along {show(z)}"
    if box.loads.most_work(z) or box.loads.most_work(times(Fraction(-1), z)) or any(
            dot(growth, z) for growth in box.growths):
        return f"the load works on {show(z)}"
    return None


def check_walls(part: DegreeProof, place: str) -> None:
    """`degree-walls`."""
    dependent = kernel(list(zip(*part.walls))) if part.walls else []  # the c with Σ c_j E_j = 0
    if len(dependent) != part.simplex or any(abs(sum(map(sign, c))) < len(c) for c in dependent):
        raise Rejected("degree-walls", "the rows of E are not independent, or of a simplex they are "
                                       "not around 0", place)


def check_free(part: DegreeProof, box: Box, place: str) -> None:
    """`degree-free`, `degree-direction`."""
    free = part.free_motions()
    for z in free:
        seen = what_sees(z, box)
        if seen:
            raise Rejected("degree-free", seen, place)
    for matrix in (part.direction, list(zip(*part.direction))):
        if len(kernel(matrix)) != len(free) or any(dot(row, z) for row in matrix for z in free):
            raise Rejected("degree-direction", f"A has not the rank {box.dimension - len(free)}, or "
                                               "takes or gives free motions", place)


def shares_of(low: Fraction, high: Optional[Fraction]) -> Tuple[Vector, Vector]:
    """s and t of §6 as functions of (h, ℓ): those with (h, ℓ) = s·(h, ℓ of x') + t·(h, ℓ of x"), by
    Cramer's rule. If low == high, as of one verdict, x' and x" are one point: s = h, t = 0."""
    (a, b), (c, d) = (1, low), (0, low) if high is None else (1, high)
    det = a * d - b * c
    if det == 0:
        return (Fraction(1), Fraction(0)), (Fraction(0), Fraction(0))
    return (Fraction(d) / det, Fraction(-c) / det), (Fraction(-b) / det, Fraction(a) / det)


class Cell:
    """K: its functions of points."""

    def __init__(self, part: DegreeProof, low: Fraction, high: Optional[Fraction]) -> None:
        self.part = part
        self.zero = zeros(len(part.twist))
        self.s, self.t = (self.zero + share for share in shares_of(low, high))
        self.size = plus(self.s, Fraction(1), self.t)  # s + t
        self.multiples = within(Range(low, high, True, True), len(part.twist))
        if high is None:
            self.multiples = [(self.s, False, False), (self.t, False, False),
                              (self.size, False, True)]

    def about(self, row: Vector, more: int = 0) -> Vector:
        """row·e + more·(s + t)."""
        found = row + (Fraction(0), Fraction(0))
        for d, share in ((self.part.twist, self.s), (self.part.end_twist, self.t)):
            found = plus(found, -dot(row, d), share)
        return plus(found, Fraction(more), self.size)

    def cone(self, multiples: List[Condition], wall: Optional[int] = None) -> List[Condition]:
        """Over K, or over a wall of K."""
        conditions = list(multiples)
        for k, (_, row) in enumerate(self.part.faces()):
            conditions.append((self.about(times(Fraction(-1), row), 1), k == wall, False))
        return conditions


def check_open(part: DegreeProof, box: Box, cell: Cell, asked: Options, place: str) -> None:
    """`degree-open`."""
    before = -1
    for i in part.open:
        if not before < i < len(box.terms):
            raise Rejected("degree-open", f"contact {show(i)} after {show(before)}", place)
        before = i
    if not part.open:
        return
    if asked.law == "bilateral":
        raise Rejected("degree-open", "no contact opens under the bilateral law", place)
    across = [(cell.about(z), True, False) for z in part.free_motions()]
    points = [x for x, _ in begin(Root(box, [*cell.cone(cell.multiples), *across])).cone.generators]
    for i in part.open:
        if box.terms[i].spring or max(box.terms[i].extremes(points)[1]) > 0:
            raise Rejected("degree-open", f"contact {i} is a spring, or its v may be above 0", place)


def renumbered(node: Node, others: List[int]) -> Node:
    """A node about a grasp of these contacts alone, by their numbers among them; of another the number is that of none."""
    def number(i: int) -> int:
        at = bisect.bisect_left(others, i)
        return at if others[at:at + 1] == [i] else len(others) + i

    if node.kind in ("slip", "separation") or (node.kind == "part" and node.name != "wrench"):
        return node._replace(contact=number(node.contact))
    return node._replace(own=[(number(i), kappa, psi) for i, kappa, psi in node.own])


def inverse_of(E: List[Vector]) -> List[Vector]:
    """C by columns, of independent rows: (E; Z) C_k is 1 in row k, else 0, and of (E; Z, −1; 0) the kernel is that of all (C u, u)."""
    count, size = len(E), len(E[0])
    return [z[:size] for z in kernel([row + times(Fraction(-1), unit(count, k)) for k, row in enumerate(E + kernel(E))])]


def check_bound(part: DegreeProof, bound: Vector, place: str) -> None:
    """`degree-bound`."""
    E = part.walls[:-1] if part.simplex else part.walls
    C = inverse_of(E) if E else []
    if part.simplex:
        # e = C u with E_j·e = 1 for all rows of E but one, which the last of the simplex replaces or which is that.
        (c,), size = kernel(list(zip(*part.walls))), len(E)
        corners = [[Fraction(1)] * size] + [[1 - sum(c) / c[k] * (j == k) for j in range(size)] for k in range(size)]
        reached = [[dot(u, entries) for u in corners] for entries in zip(*C)]
    else:
        reached = [[sign_ * sum(abs(c[j]) for c in C) for sign_ in (-1, 1)] for j in range(len(bound))]
    for j, (d, b, entries) in enumerate(zip(part.twist, bound, reached)):
        if max(abs(d + e) for e in entries) > b:
            raise Rejected("degree-bound", f"motion {j + 1} of K goes beyond {show(b)}", place)


def check_degree(part: DegreeProof, box: Box, asked: Options, place: str,
                 low: Fraction = Fraction(0), high: Optional[Fraction] = Fraction(0)) -> None:
    """A part by degree, or a segment, for all λ from low to high."""
    check_walls(part, place)
    cell = Cell(part, low, high)
    check_open(part, box, cell, asked, place)
    tree = part.tree
    if part.open:
        others = sorted({*range(len(box.terms))} - {*part.open})
        box, tree = box.only(others), [renumbered(node, others) for node in tree]
    check_free(part, box, place)
    if asked.max_motion:
        check_bound(part, asked.max_motion, place)
    if asked.law == "bilateral":
        region = begin(Root(box, cell.cone(cell.multiples)))
        for i, term in enumerate(box.terms):
            lows, _ = term.extremes([x for x, _ in region.cone.generators])
            if min(lows) < 0 and not term.spring:
                raise Rejected("degree-law", f"v of contact {i} may be below 0", place)
    direction = [cell.about(row) for row in part.direction]
    if low == high:
        halfway = cell.multiples
    else:
        halfway = [*cell.multiples, (plus(cell.s, Fraction(-1), cell.t), True, False)]
    lists = (("wall", box, cell.multiples, ()),
             ("middle wall", box.middle(), halfway, direction))
    check_tree(tree, [Root(where, cell.cone(multiples, j), False, f"{place}, {name} {wall}", pull)
                           for name, where, multiples, pull in lists[box.certain and low == high:]
                           for j, (wall, _) in enumerate(part.faces())], place)


def check_parts(parts: Sequence[Part], box: Box, asked: Options) -> None:
    """`waiting` holds the boxes that are still to come, with their paths and depths."""
    waiting = [(box, "", 0)]
    for k, part in enumerate(parts):
        if not waiting:
            raise Rejected("tree-long", f"{len(parts) - k} parts after the end", f"part {k}")
        here, path, depth = waiting.pop()
        place = f"part {k}{path}"
        if depth > here.most_depth:
            raise Rejected("node-depth", f"{depth} parts stand above this one", place)
        if isinstance(part, RestProof):
            check_rest(part, here, place)
            continue
        if isinstance(part, StickingProof):
            check_sticking(part, here, asked, place)
            continue
        if isinstance(part, DegreeProof):
            check_degree(part, here, asked, place)
            continue
        try:
            low, high = here.halves(part)
        except Rejected as failure:
            failure.path = place
            raise
        path += f", {part.name} {part.contact} "
        waiting += [(high, path + "high", depth + 1), (low, path + "low", depth + 1)]
    if waiting:
        raise Rejected("tree-short", f"{len(waiting)} parts are missing",
                       f"part {len(parts)}{waiting[-1][1]}")


# ---- §5 Claims --------------------------------------------------------------------------------


def at_rest(question: Question) -> bool:
    """w and P are 0."""
    return not any(question.w()) and not any(contact.preload.high for contact in question.contacts)


def check_ranges(question: Question, claims: Sequence[RangeProof], box: Box) -> List[Range]:
    """`interval-...`, and the proofs. Returns what is refuted."""
    before: Optional[Fraction] = Fraction(0)
    refuted = []
    for k, claim in enumerate(claims):
        (low, high), place = claim.interval, f"interval {k}"
        if before is None or low < before or (high is not None and not (
                low <= high if claim.stable else low < high)):
            raise Rejected("interval-order", f"({show(low)}, {show(high)}) after {show(before)}",
                           place)
        before = high
        if not claim.stable:
            refuted.append(Range(low, high, k == 0 and low == 0 and not at_rest(question), False))
            check_tree(claim.tree, roots(question, box, refuted[-1:], place), place)
            continue
        if high is None:
            if low or not at_rest(question):
                raise Rejected("interval-whole", "a proof about all multiples, but the wrench, a "
                                                 "preload or the low end is not 0", place)
            if question.asked.max_motion:
                raise Rejected("interval-whole", "a proof about all multiples, but motions are bounded", place)
            low = high = Fraction(1)  # for all: the laws are homogeneous
        if isinstance(claim.part, RestProof):
            check_rest(claim.part, box, place, sorted({low, high}))
            continue
        if isinstance(claim.part, StickingProof):
            check_sticking(claim.part, box, question.asked, place, sorted({low, high}))
            continue
        if claim.part:
            check_degree(claim.part, box, question.asked, place, low, high)
            continue
        forces = [check_point(question, point, f"{place}, {name} point")
                  for point, name in zip(claim.points, ("first", "second"))]
        check_mode(question, forces[0], forces[-1], place)
    return refuted


def resisted_ranges(claims: Sequence[RangeProof]) -> List[Interval]:
    """Those that touch are one."""
    found: List[Interval] = []
    for stable, (low, high), *_ in claims:
        if stable:
            if found and found[-1][1] == low:
                low = found.pop()[0]
            found.append((low, high))
    return found


# ---- §12 Planes of loads ----------------------------------------------------------------------


def check_piece(question: Question, points: Sequence[Witness], place: str) -> Cone:
    """`witness-...`, `piece-mode`. Returns the dual cone of the load parts."""
    forces = [check_point(question, point, f"{place}, point {p}") for p, point in enumerate(points)]
    for i, row in enumerate(question.rows):
        here = [force[i] for force in forces]
        signs = {sign(force.v) for force in here}
        if {1, -1} <= signs:
            raise Rejected("piece-mode", f"contact {i}: v has opposite signs", place)
        if row.friction == 0 or 1 not in signs:
            continue
        slips = {sign(force.slip[0]) for force in here} - {0}
        if len(slips) == 2:
            raise Rejected("piece-mode", f"contact {i} slips both ways", place)
        if any(force.b[0] != -s * row.friction * force.a for s in slips for force in here):
            raise Rejected("piece-mode", f"contact {i} slips at one point, and at another its "
                                         "friction is not the same full share", place)
    dual = all_points(3)
    for point in points:
        dual = dual.cut(integers(point.x[PLANE:])[0])
    return dual


def root_of(question: Question, box: Box, pieces: Sequence[Sequence[Witness]]) -> Root:
    """The pieces are checked."""
    duals = [check_piece(question, points, f"piece {k}") for k, points in enumerate(pieces)]
    h = zeros(PLANE) + (Fraction(1), Fraction(0), Fraction(0))
    return Root(box, [(h, False, True)], question.asked.law == "bilateral", pieces=duals)


# ---- §13 Rigid contacts -----------------------------------------------------------------------


class RigidRow(NamedTuple):
    """A contact: p, n, N, and (μ|n|)²."""
    point: Vector
    normal: Vector
    N: Vector
    square: Fraction

    def at(self, force: Sequence[Fraction]) -> Vector:
        """The wrench of a force at p."""
        if len(force) == 2:
            return (*force, self.point[0] * force[1] - self.point[1] * force[0])
        return (*force, *cross(self.point, force))

    def slip(self, d: Vector) -> Vector:
        """S d; in the plane the motion of p along t."""
        n, p = self.normal, self.point
        u = ((d[0] - d[2] * p[1], d[1] + d[2] * p[0]) if len(n) == 2 else
             plus(d[:3], Fraction(1), cross(d[3:], p)))
        return plus(u, -dot(n, u) / dot(n, n), n)

    def across(self, friction: Vector) -> Vector:
        """A force across n as certificates have it: in the plane b, of b t."""
        n = self.normal
        return (-friction[0] * n[1], friction[0] * n[0]) if len(n) == 2 else friction

    def slips_like(self, other: RigidRow) -> bool:
        """Under every motion; in space with a normal of the same direction."""
        if len(self.normal) == 2:
            t, t_other = (row.at(row.across((Fraction(1),))) for row in (self, other))
            return factor_sign(t, t_other) != 0
        return self.point == other.point and factor_sign(self.N, other.N) > 0

    def resists(self, y: Vector, side: Vector) -> bool:
        """The force against a slip along that, which is not 0, does no work below 0 on y."""
        a, c = dot(y, self.N), dot(side, self.slip(y))
        return bool(sign(a) * a * a * dot(side, side) >= sign(c) * c * c * self.square)

    def resists_all(self, y: Vector) -> bool:
        """So do all forces in the cone."""
        a, s = dot(y, self.N), self.slip(y)
        return bool(a >= 0 and a * a >= self.square * dot(s, s))

    def resists_against(self, y: Vector, slips: Optional[Slips]) -> bool:
        """So do all forces that slips which are known allow."""
        if not slips:
            return self.resists_all(y)
        if len(slips) == 2:
            s, n = self.slip(y), self.normal
            if dot(n, cross(slips[0], s)) >= 0 and dot(n, cross(s, slips[1])) >= 0:
                return self.resists_all(y)
        return all(self.resists(y, side) for side in slips)


Slips = Tuple[Vector, ...]  # sums of multiples of these; () is 0


def cross(a: Sequence[Fraction], b: Sequence[Fraction]) -> Vector:
    return tuple(a[j - 2] * b[j - 1] - a[j - 1] * b[j - 2] for j in range(3))


def rigid_rows(question: Question) -> List[RigidRow]:
    rows = []
    for contact in question.contacts:
        n, p = contact.normal, tuple(x.low for x in contact.position)
        row = RigidRow(p, n, (), contact.friction.low ** 2 * dot(n, n))
        rows.append(row._replace(N=row.at(n)))
    return rows


class RigidCell:
    """A node's cell: of each contact whether it touches, and its slip (None: it is not known)."""

    def __init__(self, m: int, steps: Tuple[str, ...] = ()) -> None:
        self.touch: List[Optional[bool]] = [None] * m
        self.slip: List[Optional[Slips]] = [None] * m
        self.steps = steps

    def child(self, step: str) -> RigidCell:
        cell = RigidCell(0, self.steps + (step,))
        cell.touch, cell.slip = list(self.touch), list(self.slip)
        return cell


def times_mass(inertia: Vector, a: Vector) -> Vector:
    """M a."""
    if len(a) == PLANE:
        (x, y, square), turn = inertia, a[2]
        force = (a[0] - turn * y, a[1] + turn * x)
        return (*force, x * force[1] - y * force[0] + square * turn)
    centre, (xx, yy, zz, xy, xz, yz), spin = inertia[:3], inertia[3:], a[3:]
    push = plus(a[:3], Fraction(1), cross(spin, centre))
    moment = (dot((xx, xy, xz), spin), dot((xy, yy, yz), spin), dot((xz, yz, zz), spin))
    return (*push, *plus(cross(centre, push), Fraction(1), moment))


def factor_sign(u: Vector, v: Vector) -> int:
    """The sign of c if v = c u, else 0; neither is 0."""
    if any(u[j] * v[k] != u[k] * v[j] for j in range(len(u)) for k in range(j)):
        return 0
    return sign(dot(u, v))


def check_rigid_forces(question: Question, forces: Sequence[RigidForce], a: Vector, place: str) -> None:
    """`class-force`, `class-balance`."""
    rows, total, last = rigid_rows(question), question.w(), -1
    for i, normal, stated in forces:
        if not last < i < len(rows):
            raise Rejected("class-force", f"contact {i} is not there, or out of order", place)
        row, last = rows[i], i
        friction = row.across(stated)
        if (normal < 0 or dot(friction, row.normal)
                or dot(friction, friction) > row.square * normal * normal):
            raise Rejected("class-force", f"the force of contact {i} is not in its cone", place)
        total = plus(plus(total, normal, row.N), Fraction(1), row.at(friction))
    if total != times_mass(require_inertia(question), a):
        raise Rejected("class-balance", f"load and forces are {show(total)} together", place)


def require_inertia(question: Question) -> Vector:
    assert question.asked.inertia is not None
    return question.asked.inertia


def check_motion(question: Question, proof: RigidProof) -> None:
    """`class-motion`."""
    a, rows, place = proof.acceleration, rigid_rows(question), "forces"
    if not any(a):
        raise Rejected("class-motion", "the acceleration is 0", place)
    for i, row in enumerate(rows):
        if dot(row.N, a) < 0:
            raise Rejected("class-motion", f"contact {i} is penetrated", place)
    for i, normal, stated in proof.forces:
        slip = rows[i].slip(a)
        power = dot(rows[i].across(stated), slip)
        if (normal * dot(rows[i].N, a) or power > 0
                or power ** 2 != rows[i].square * normal ** 2 * dot(slip, slip)):
            raise Rejected("class-motion", f"contact {i} parts, or its friction does not oppose its slip", place)


def rigid_children(rows: List[RigidRow], cell: RigidCell, node: Node) -> List[RigidCell]:
    i = node.contact
    if i >= len(rows):
        raise Rejected("node-contact", f"contact {i}, but the grasp has {len(rows)}")
    found = []
    Work.spend(20 * len(rows))
    if node.kind == "touch":
        for touches, word in ((True, "touching"), (False, "apart")):
            child = cell.child(f"touch {i} {word}")
            for j, row in enumerate(rows):
                if factor_sign(rows[i].N, row.N) > 0:
                    child.touch[j] = touches
            found.append(child)
        return found
    for word, slips in rigid_slips(rows[i].normal, cell.slip[i], node):
        child = cell.child(f"slip {i} {word}")
        for j, row in enumerate(rows):
            if rows[i].slips_like(row):
                child.slip[j] = slips
        found.append(child)
    return found


def rigid_slips(n: Vector, known: Optional[Slips], node: Node) -> List[Tuple[str, Slips]]:
    """What the children of a slip say; `class-slip`."""
    if len(n) == 2:
        t = (-n[1], n[0])
        return [("+", (t,)), ("0", ()), ("-", (times(Fraction(-1), t),))]
    d = node.numbers
    if not any(d) or dot(n, d):
        raise Rejected("class-slip", "d is 0, or not across n")
    if known:
        if dot(n, cross(known[0], d)) <= 0 or dot(n, cross(d, known[1])) <= 0:
            raise Rejected("class-slip", "d is not inside of the slips that are known")
        return [("before", (known[0], d)), ("after", (d, known[1]))]
    sides = [d]
    for _ in range(4):
        sides.append(cross(n, sides[-1]))
    return [("0", ())] + [(str(k + 1), (sides[k], sides[k + 1])) for k in range(4)]


def rigid_leaf_refusal(question: Question, rows: List[RigidRow], cell: RigidCell, node: Node) -> Optional[str]:
    """Why the leaf proves nothing."""
    (t, *twist), w = node.numbers, question.w()
    y = tuple(twist)
    Work.spend(20 * len(rows))
    if t < 0 or dot(y, w) < 0 or (t == 0 and dot(y, w) == 0):
        return "t or y·w is below 0, or both are 0"
    total = plus(times_mass(require_inertia(question), y), t, w)
    for multipliers in (node.normal, node.tangent):
        last = -1
        for i, _ in multipliers:
            if not last < i < len(rows):
                return f"contact {i} is not there, or out of order"
            last = i
    for i, x in node.normal:
        if x < 0 and cell.touch[i] is not True:
            return f"g of contact {i} is below 0, but it may part"
        total = plus(total, x, rows[i].N)
    for i, stated in node.tangent:
        slips, h = cell.slip[i], rows[i].across(stated)
        if slips is None or dot(h, rows[i].normal) or any(dot(h, side) < 0 for side in slips):
            return f"h of contact {i} is not of one sign with its slip"
        total = plus(total, Fraction(1), rows[i].at(h))
    if any(total):
        return f"the sum is {show(total)}"
    for i, row in enumerate(rows):
        if cell.touch[i] is not False and not row.resists_against(y, cell.slip[i]):
            return f"contact {i} opposes y"
    return None


def check_rigid_tree(question: Question, tree: Sequence[Node]) -> None:
    rows = rigid_rows(question)
    waiting = [RigidCell(len(rows))]
    for number, node in enumerate(tree):
        if not waiting:
            raise Rejected("tree-long", f"{len(tree) - number} nodes after the end", None, number)
        cell = waiting.pop()
        try:
            if len(cell.steps) > 2 * len(rows) + 256:
                raise Rejected("node-depth", f"{len(cell.steps)} nodes stand above this one")
            if node.kind == "leaf":
                refusal = rigid_leaf_refusal(question, rows, cell, node)
                if refusal:
                    raise Rejected("class-leaf", refusal)
            else:
                waiting += reversed(rigid_children(rows, cell, node))
        except Rejected as failure:
            failure.node, failure.path = number, ", ".join(cell.steps) or "root"
            raise
    if waiting:
        raise Rejected("tree-short", f"{len(waiting)} children are missing",
                       ", ".join(waiting[-1].steps) or "root", len(tree))


def check_class(question: Question, certificate: Certificate, proof: RigidProof) -> None:
    if certificate.verdict == "must move":
        y = proof.twist
        if dot(y, question.w()) <= 0 or not all(row.resists_all(y) for row in rigid_rows(question)):
            raise Rejected("class-twist", "the load does no work along it, or a force in a cone opposes it")
        return
    check_rigid_forces(question, proof.rest, zeros(len(question.w())), "rest")
    if certificate.verdict == "must hold":
        check_rigid_tree(question, certificate.tree)
    else:
        check_rigid_forces(question, proof.forces, proof.acceleration, "forces")
        check_motion(question, proof)


# ---- §16 Statics ------------------------------------------------------------------------------


class StaticRow(NamedTuple):
    """A contact by integers: positive multiples of p and n, φ² μ², and the torsion's e²."""
    point: Integers
    scale: int  # p is the point over that
    normal: Integers
    normal_factor: int  # n times that
    friction: Fraction
    torsion: Fraction

    def opposes(self, motion: Integers, price: Fraction) -> bool:
        """Whether some force in the cone does work below 0 on this motion of the body beside that which it touches: not if
        N·y + q ≥ 0 and (N·y + q)² ≥ φ² μ² (L² |u|² − (n·u)² + e² (n·ω)²), where u and ω are by one factor as well, and the
        price q of a limit is by that, too."""
        n, p, scale = self.normal, self.point, self.scale
        if len(n) == 2:
            u = (motion[0] * scale - motion[2] * p[1], motion[1] * scale + motion[2] * p[0])
            work, slip = dot(n, u) + price, n[0] * u[1] - n[1] * u[0]
            return work < 0 or work * work * self.friction.denominator < slip * slip * self.friction.numerator
        omega = motion[3:]
        u = tuple(motion[j] * scale + omega[j - 2] * p[j - 1] - omega[j - 1] * p[j - 2] for j in range(3))
        along, turn = dot(n, u), scale * dot(n, omega)
        work, e = along + price, self.torsion
        square = work * work
        slip = e.denominator * (dot(n, n) * dot(u, u) - along * along) + e.numerator * turn * turn
        return work < 0 or square * self.friction.denominator * e.denominator < slip * self.friction.numerator


class Statics:
    """The forces and twists of a question."""

    def __init__(self, question: Question) -> None:
        assert question.bodies
        self.contacts, self.bodies = question.contacts, question.bodies
        self.factor = Fraction(1) if question.asked.statics is None else question.asked.statics
        # Springs that are not locked pull, whatever moves: with their forces w is the load.
        work: Dict[str, List[Fraction]] = {}
        along: Dict[int, List[Fraction]] = {}
        for contact in self.contacts:
            if contact.spring and not contact.stiffness.low and contact.limit is None:
                self.push_along(contact, contact.preload.low, work, along)
        self.limits = [contact.limit for contact in self.contacts if contact.limit is not None]
        self.loads = (summed([question.w(), self.bodies.gathered({}, work, along)]), *question.growths)
        self.rows: Dict[int, StaticRow] = {}  # of contacts, made where a twist asks for it

    def push_along(self, contact: Contact, a: Fraction, work: Dict[str, List[Fraction]],
                   along: Dict[int, List[Fraction]]) -> None:
        """The force a of a ratchet or a spring."""
        if contact.joint >= 0:
            along.setdefault(contact.joint, []).append(a)
        for name, r in contact.over.items():
            count_words((a, r), 1)
            work.setdefault(name, []).append(a * r)

    def row(self, i: int) -> StaticRow:
        if i not in self.rows:
            contact = self.contacts[i]
            Work.spend(10)
            point, scale = integers(tuple(x.low for x in contact.position))
            self.rows[i] = StaticRow(point, scale, *integers(contact.normal), (self.factor * contact.friction.low) ** 2,
                                     contact.torsion ** 2)
        return self.rows[i]

    def check_move(self, y: Vector, place: str) -> None:
        """`static-motion`."""
        dimension = self.bodies.dimension
        moved, turned = self.bodies.moved(y[:dimension])
        prices = iter(y[dimension:])
        motions = {}
        for name, motion in moved.items():
            count_words(motion, len(motion))
            motions[name] = integers(motion)
        for i, contact in enumerate(self.contacts):
            price = Fraction(0) if contact.limit is None else next(prices)
            if price < 0:
                raise Rejected("static-motion", f"the number {show(price)} of the limit of {contact.place} is below 0", place)
            if not contact.is_contact():
                if contact.spring and not contact.stiffness.low and contact.limit is None:
                    continue
                terms = [(y[contact.joint],)] if contact.joint >= 0 else []
                for name, r in contact.over.items():
                    count_words((turned[name], r), 1)
                    terms.append((turned[name] * r,))
                (way,) = summed(terms)
                if contact.limit is not None and abs(way) <= price:
                    continue
                if way < 0 or (way and contact.spring):
                    raise Rejected("static-motion", f"{contact.place} moves by {show(way)}, but "
                                                    + (f"may by {show(price)}" if contact.limit is not None else
                                                       "is locked" if contact.spring else "is a ratchet"), place)
                continue
            (of, of_factor), (by, by_factor), row = motions[contact.of], motions[contact.by], self.row(i)
            motion = tuple(by_factor * a - of_factor * b for a, b in zip(of, by))
            Work.spend(10)
            length = words(motion) + 2 * words((*row.point, row.scale, *row.normal)) + words(
                (row.friction.numerator, row.friction.denominator, row.torsion.numerator, row.torsion.denominator))
            Work.multiply(12 * len(motion), length, length)
            if contact.limit is not None:  # n and p are by factors of their own
                price *= of_factor * by_factor * row.scale * row.normal_factor
            if row.opposes(motion, price):
                raise Rejected("static-motion", f"a force in the cone of contact {i} does work below 0", place)

    def works(self, y: Vector) -> Vector:
        """Of the loads on the twist: y·(w + Σ τ N) − Σ A q, and y·u and y·v."""
        found = []
        for load in self.loads:
            terms = [(a * b,) for a, b in zip(y, load) if a and b]
            found += summed(terms or [(Fraction(0),)])[:1]
        found[0] -= sum((q * most for q, most in zip(y[self.bodies.dimension:], self.limits)), Fraction(0))
        return tuple(found)

    def check_forces(self, point: Vector, forces: Sequence[RigidForce], place: str) -> None:
        """`static-point`, `static-force`, `static-balance`."""
        if point[0] < 0:
            raise Rejected("static-point", f"h is {show(point[0])}, which is below 0", place)
        last = -1
        for i, a, stated in forces:
            if not last < i < len(self.contacts):
                raise Rejected("static-force", f"contact {show(i)}, which is not there or not in order", place)
            last, contact = i, self.contacts[i]
            count_words((a, *stated, *contact.normal, contact.friction.low, contact.torsion, self.factor), 30)
            if not self.may_push(contact, a, stated) or (
                    contact.limit is not None and abs(a) > point[0] * contact.limit):
                raise Rejected("static-force", f"the force of contact {i} is not one that it may have", place)
        total = self.total(point, forces)
        if any(total):
            raise Rejected("static-balance", f"load and forces add up to {show(total)}, not to 0", place)

    def total(self, point: Vector, forces: Sequence[RigidForce]) -> Vector:
        """The load of a load point, and forces."""
        wrenches: Dict[str, List[Vector]] = {}
        work: Dict[str, List[Fraction]] = {}
        along: Dict[int, List[Fraction]] = {}
        for i, a, stated in forces:
            contact = self.contacts[i]
            Work.spend(30)
            if not contact.is_contact():
                self.push_along(contact, a, work, along)
                continue
            point_, n = tuple(x.low for x in contact.position), contact.normal
            count_words((a, *stated, *n, *point_), 30)
            friction = (-stated[0] * n[1], stated[0] * n[0]) if len(n) == 2 else stated[:3]
            wrench = at(point_, plus(friction, a, n))
            if len(stated) == 4:
                wrench = plus(wrench, stated[3], zeros(3) + n)
            wrenches.setdefault(contact.of, []).append(wrench)
            if contact.by != GROUND:
                wrenches.setdefault(contact.by, []).append(times(Fraction(-1), wrench))
        terms = [self.bodies.gathered(wrenches, work, along)]
        Work.spend(len(self.bodies.bodies) + len(terms[0]) * len(point))
        for c, load in zip(point, self.loads):
            count_words((c, *load), len(load))
            terms.append(times(c, load))
        return summed(terms)

    def may_push(self, contact: Contact, a: Fraction, stated: Vector) -> bool:
        if not contact.is_contact():
            return not any(stated) and (contact.stiffness.low > 0 or contact.limit is not None if contact.spring
                                        else a >= 0)
        if a < 0:
            return False
        most = self.factor * contact.friction.low * a
        if len(stated) == 1:  # of t, which is as long as n
            return abs(stated[0]) <= most
        n = contact.normal
        return not dot(n, stated[:3]) and force_square(stated, contact.gamma) <= most * most * dot(n, n)


def check_statics_proof(question: Question, certificate: Certificate, proof: StaticProof) -> Statics:
    statics = Statics(question)
    if certificate.verdict == "may stand":
        statics.check_forces((Fraction(1),), proof.forces, "forces")
    if certificate.verdict == "must move":
        statics.check_move(proof.twist, "twist")
        (work,) = statics.works(proof.twist)[:1]
        if work <= 0:
            raise Rejected("static-motion", f"the load does the work {show(work)}, which is not above 0", "twist")
    for k, (point, forces) in enumerate(proof.stand):
        statics.check_forces(point, forces, f"stand {k}")
    for k, y in enumerate(proof.move):
        statics.check_move(y, f"move {k}")
    return statics


class Large(Statics):
    """§14, many coordinates: an equilibrium. All is multiplied by h, so that motions are integers."""

    def force_of(self, contact: Contact, motions: Dict[str, Vector], turned: Dict[str, Fraction], z: Vector,
                 h: Fraction) -> ContactForce:
        """Without friction."""
        if not contact.is_contact():
            terms = [(z[contact.joint],)] if contact.joint >= 0 else []
            terms += [(turned[name] * r,) for name, r in contact.over.items()]
            (way,) = summed(terms)
            return pushed_by(contact.preload.low * h - contact.stiffness.low * way, (), bool(contact.spring))
        d, n, p = plus(motions[contact.of], Fraction(-1), motions[contact.by]), contact.normal, tuple(
            x.low for x in contact.position)
        count_words((*d, *n, *p, h), 30)
        u = plus(d[:2], d[2], (-p[1], p[0])) if len(n) == 2 else plus(d[:3], Fraction(1), cross(d[3:], p))
        square, press = dot(n, n), dot(n, u)
        v = -contact.stiffness.low / square * press
        if contact.preload.low:
            length = rational_root(square)
            assert length is not None  # else the question is a box
            v += contact.preload.low / length * h
        slip = ((n[0] * u[1] - n[1] * u[0],) if len(n) == 2 else
                plus(u, -press / square, n) + ((dot(n, d[3:]),) if contact.torsion else ()))
        return pushed_by(v, slip, False)

    def check_witness(self, question: Question, witness: Witness) -> None:
        """`witness-...`"""
        check_grasp(question)
        d = witness.x[:len(question.wrench)]
        count_words(d, len(d))
        for _, share in witness.shares:
            count_words(share, 10)
        numerators, factor = integers(d)
        z, h = tuple(map(Fraction, numerators)), Fraction(factor)
        motions, turned = self.bodies.moved(z)
        forces = [self.force_of(contact, motions, turned, z, h) for contact in self.contacts]
        take_friction(question, witness, [
            SlipLaw(c.normal, dot(c.normal, c.normal) if question.space else Fraction(1), c.gamma, c.friction.low, bool(c.spring))
            for c in self.contacts], forces)
        # What springs without stiffness exert is among the loads.
        total = self.total((h,), [(i, force.a, force.b or (Fraction(0),)) for i, (contact, force) in
                                  enumerate(zip(self.contacts, forces)) if force.a and (contact.stiffness.low or not contact.spring)])
        if any(total):
            raise Rejected("witness-balance", f"load and forces add up to {show(times(1 / h, total))}, not to 0")

    def check_leaf(self, tree: Sequence[Node]) -> None:
        """`large-proof`, and `static-motion`."""
        if len(tree) != 1 or tree[0].kind != "leaf":
            raise Rejected("large-proof", "neither an equilibrium nor a tree of one leaf")
        y = times(Fraction(-1), tree[0].numbers)
        self.check_move(y, "twist")
        if self.works(y)[0] <= 0:
            raise Rejected("static-motion", "the load does no work along it", "twist")


def check_large(question: Question, certificate: Certificate) -> None:
    large = Large(question)
    if certificate.witness:
        large.check_witness(question, certificate.witness)
    else:
        large.check_leaf(certificate.tree)


class Standing(NamedTuple):
    """Which multiples may stand, and beyond which they must move; None is no limit."""
    stand: Optional[Tuple[Optional[Fraction], Optional[Fraction]]]  # None: none are known
    below: Optional[Fraction]
    above: Optional[Fraction]
    all_move: bool

    def listed(self) -> Dict[str, Any]:
        """For a report."""
        ends = [[None if end is None else str(end) for end in pair] for pair in (self.stand or (), (self.below, self.above))]
        return {"stand": ends[0] or None, "move": "all" if self.all_move else ends[1]}

    def lines(self) -> List[str]:
        low, high = self.stand or (None, None)
        stand = f"{'(-oo' if low is None else f'[{low}'}, {'oo)' if high is None else f'{high}]'}"
        move = ", ".join([f"below {self.below}"] * (self.below is not None) + [f"above {self.above}"] * (self.above is not None))
        return [f"may stand   {stand if self.stand else 'none claimed'}",
                f"must move   {'all' if self.all_move else move or 'none claimed'}",
                "elsewhere   nothing is claimed"]


def standing(statics: Statics, proof: StaticProof) -> Standing:
    """Of a margin: the claim, as one interval, and what is outside of another."""
    points = [point for point, _ in proof.stand]
    multiples, ways = [point[1] / point[0] for point in points if point[0]], [point[1] for point in points if not point[0]]
    stand = (None if min(ways, default=0) < 0 else min(multiples),
             None if max(ways, default=0) > 0 else max(multiples)) if multiples else None
    works = [statics.works(y) for y in proof.move]
    below = max((-base / growth for base, growth in works if growth < 0), default=None)
    above = min((-base / growth for base, growth in works if growth > 0), default=None)
    return Standing(stand, below, above, any(base > 0 and not growth for base, growth in works))


# ---- §17 States --------------------------------------------------------------------------------


class Codes(Dict[str, int]):
    """The signs of a contact as they are spelled, in the bits of Signs."""

    def __init__(self, first: int, width: int) -> None:
        super().__init__()
        self.first, self.width = first, width

    def __missing__(self, signs: str) -> int:
        code = 0
        for i, sign_ in enumerate(signs.replace("|", "")):
            code |= {"+": 3, "0": 2, "-": 0}[sign_] << self.width * (self.first + i + 1) - 2
        self[signs] = code
        return code


class Signs:
    """The signs of all rows on a motion, from one product: row i has `width` bits from bit i * width on, where its product
    is stored plus 2^(width - 1), and so without a sign. Of these the uppermost is the first bit of its sign, whether the
    product is at least 0; the bit below it says in a code whether it is above 0."""

    def __init__(self, rows: Sequence[Integers], contacts: Sequence[int], width: int) -> None:
        """Each contact has so many rows; others come after them, and have to be 0."""
        self.columns = [sum(entry << width * i for i, entry in enumerate(column)) for column in zip(*rows)]
        self.ones = sum(1 << width * i for i in range(len(rows)))
        self.tops = self.ones << width - 1
        firsts = list(itertools.accumulate(contacts, initial=0))
        self.codes = [Codes(first, width) for first in firsts[:-1]]
        self.zeros = sum(2 << width * (i + 1) - 2 for i in range(firsts[-1], len(rows)))

    def agree(self, signs: str, motion: Sequence[int]) -> bool:
        products = sum(map(operator.mul, self.columns, motion)) + self.tops
        code = products & self.tops | (products - self.ones & self.tops) >> 1
        return code == self.zeros + sum(map(operator.getitem, self.codes, signs.split()))


def state_rows(question: Question, proof: StatesProof) -> Tuple[List[Integers], List[int], List[Integers]]:
    """`state-line`: the rows in the order of signs, how many each contact has, and the rows that must be 0."""
    contacts = question.contacts[:question.slipping()]
    if len(proof.lines) != len(contacts):
        raise Rejected("state-line", f"lines of {len(proof.lines)} contacts, must be {len(contacts)}")
    rows: List[Integers] = []
    counts, closed = [], []
    for i, (contact, lines) in enumerate(zip(contacts, proof.lines)):
        point = [p.low for p in contact.position]

        def row(v: Vector) -> Integers:
            return integers(pulled(contact.motion, at(point, v)))[0]

        counts.append(len(lines) + (question.asked.states == "full"))
        if question.asked.states == "closed":
            closed.append(row(contact.normal))
        elif question.asked.states == "full":
            rows.append(row(contact.normal))
        for j, v in enumerate(lines):
            if not any(v) or dot(v, contact.normal):
                raise Rejected("state-line", f"{show(v)} must be across the normal, {show(contact.normal)}, and not 0",
                               f"contact {i}, line {j}")
            rows.append(row(v))
    return rows, counts, closed


def check_listed(rows: Sequence[Integers], counts: Sequence[int], proof: StatesProof) -> int:
    """`state-sign`, `state-half`, `state-new` of each state; how many they are with their opposites."""
    tables: Dict[int, Signs] = {}
    longest = max((abs(x).bit_length() for row in rows for x in row), default=0) + max(map(len, rows), default=0).bit_length()
    seen: Set[str] = set()
    work = 2 + len(rows) // 8
    number = 0
    for k, text in enumerate(proof.states):
        signs, _, numbers = text.partition(":")
        motion = list(map(int, numbers.split()))
        length = -(-(longest + max(map(int.bit_length, motion)) + 2) // 32)
        Work.spend(work * length)
        if length not in tables:
            tables[length] = Signs(rows, counts, 32 * length)
        if not tables[length].agree(signs, motion):
            raise Rejected("state-sign", f"the motion ({numbers.strip()}) has not the signs {signs.strip()}", f"state {k}")
        first = signs.lstrip("0| ")[:1]
        if first == "-":
            raise Rejected("state-half", "the first sign that is not 0 is -", f"state {k}")
        if signs in seen:
            raise Rejected("state-new", "a state before it has the same signs", f"state {k}")
        seen.add(signs)
        number += 2 if first else 1
    return number


def primitive(row: Sequence[int]) -> Integers:
    """The row of a plane: without common divisors, the first entry that is not 0 above 0; () if all are 0."""
    divisor = math.gcd(*row)
    if divisor == 0:
        return ()
    if next(filter(None, row)) < 0:
        divisor = -divisor
    return tuple(x // divisor for x in row)


def restricted(rows: Dict[Integers, int], plane: Integers) -> Dict[Integers, int]:
    """Planes as those of `plane`, in one coordinate less; each has the bits of all that are the same there. Those
    that contain all of it are left out."""
    p = next(j for j, x in enumerate(plane) if x)
    pivot, rest = plane[p], plane[:p] + plane[p + 1:]
    result: Dict[Integers, int] = {}
    for row, bits in rows.items():
        entry = row[p]
        here = primitive([x * pivot - entry * y for x, y in zip(row[:p] + row[p + 1:], rest)])
        if here:
            result[here] = result.get(here, 0) | bits
    length = words(plane)
    Work.spend(len(rows))
    Work.multiply(2 * len(rows) * len(plane), length, length)
    return result


def columns_of(rows: Sequence[Integers]) -> List[int]:
    """Of coordinates that determine all others of a sum of rows, as few as can be: as many as the rank."""
    columns: List[int] = []
    left = {row: 0 for row in rows}
    names = list(range(len(rows[0]))) if rows else []
    while left:
        plane = next(iter(left))
        p = next(j for j, x in enumerate(plane) if x)
        columns.append(names.pop(p))
        left = restricted(left, plane)
    return columns


def members_of(bits: int) -> List[int]:
    return [i for i in range(bits.bit_length()) if bits >> i & 1]


class Flats:
    """§17, *Computing*: the flats of an arrangement, and the numbers of its faces. A set of planes is an integer, with
    the bit 2^i for plane i."""

    def __init__(self, planes: Sequence[Integers], most: int) -> None:
        """Throws if there are more faces than that."""
        self.planes, self.most, self.found = planes, most, 0
        self.known: Dict[int, List[int]] = {}

    def faces(self) -> List[int]:
        """By the codimension of the face, from 0 to the rank."""
        return [2 * x for x in self.sums((1 << len(self.planes)) - 1, True)] + [1]

    def sums(self, planes: int, counted: bool = False) -> List[int]:
        """The sum of ±w(Y) over all flats Y of these planes but the least, where the sign is + if their codimensions differ
        by an odd number. `counted`: those with + alone, each of which is at least a face."""
        chosen = members_of(planes)
        columns = columns_of([self.planes[i] for i in chosen])
        rank = len(columns)
        rows = {primitive([self.planes[i][j] for j in columns]): 1 << i for i in chosen}
        total, simple = [0] * rank, [0] * rank  # of flats with as many planes as their codimension, how many there are
        waiting = [(0, 0, 0, rows)] if rank else []

        def take(flat: int, codimension: int) -> None:
            odd = (rank - codimension) % 2
            if counted:
                self.found += 1
                if self.found > self.most:
                    raise Rejected("state-complete", f"there are more states than {self.most}")
            if counted and not odd:
                return
            if bin(flat).count("1") == codimension:
                simple[codimension] += 1
                return
            for c, x in enumerate(self.weights(flat)):
                total[c] += x if odd else -x

        if rank:
            take(0, 0)
        while waiting:
            flat, codimension, last, rows = waiting.pop()
            for row, bits in rows.items():
                first = bits & -bits
                if first > last and codimension + 1 < rank:
                    take(flat | bits, codimension + 1)
                    if codimension + 2 < rank:
                        waiting.append((flat | bits, codimension + 1, first, restricted(rows, row)))
            Work.spend(1 + len(rows))
        for codimension, count in enumerate(simple):
            for c in range(codimension + 1):
                total[c] += (1 if (rank - codimension) % 2 else -1) * count * math.comb(codimension, c)
        return total

    def weights(self, flat: int) -> List[int]:
        """w_c(Y) for c from 0 to the codimension of the flat Y that these planes, all that contain it, have in common."""
        free = self.free(members_of(flat))
        bound = flat & ~sum(1 << i for i in free)
        if bound not in self.known:
            self.known[bound] = self.sums(bound) + [1]
        result = self.known[bound]
        for _ in free:
            result = list(map(operator.add, result + [0], [0] + result))
        return result

    def free(self, chosen: Sequence[int]) -> List[int]:
        """Which of these planes have rows that are not in the span of those of the others."""
        matrix = [[self.planes[i][j] for i in chosen] for j in range(len(self.planes[0]))]
        pivots: List[int] = []
        for c in range(len(chosen)):
            top = len(pivots)
            found = next((k for k in range(top, len(matrix)) if matrix[k][c]), None)
            if found is None:
                continue
            matrix[top], matrix[found] = matrix[found], matrix[top]
            pivot = matrix[top]
            for k, row in enumerate(matrix):
                if k != top and row[c]:
                    reduced_row = [x * pivot[c] - row[c] * y for x, y in zip(row, pivot)]
                    divisor = math.gcd(*reduced_row) or 1
                    matrix[k] = [x // divisor for x in reduced_row]
            pivots.append(c)
            Work.spend(1 + len(matrix) * len(chosen) // 8)
            Work.multiply(2 * len(matrix) * len(chosen), words(pivot), words(pivot))
        return [chosen[c] for row, c in zip(matrix, pivots) if sum(map(bool, row)) == 1]


def count_states(rows: Sequence[Integers], closed: Sequence[Integers], dimension: int, most: int) -> List[int]:
    """§17: f_0, f_1, …; throws by `state-complete` if there are more than `most` in all."""
    for k, plane in enumerate(closed):
        plane = primitive(plane)
        if plane:
            p = next(j for j, x in enumerate(plane) if x)
            dimension -= 1
            rows, closed = ([[x * plane[p] - row[p] * y for j, (x, y) in enumerate(zip(row, plane)) if j != p]
                             for row in some] for some in (rows, closed))
            return count_states(rows, closed[k + 1:], dimension, most) + [0]
    planes = list(dict.fromkeys(filter(None, map(primitive, rows))))
    found = Flats(planes, most).faces()
    return [0] * (dimension + 1 - len(found)) + found[::-1]


def check_states(question: Question, proof: StatesProof) -> None:
    rows, counts, closed = state_rows(question, proof)
    number = check_listed(rows + closed, counts, proof)
    by_dimension = count_states(rows, closed, len(question.wrench), number)
    if sum(by_dimension) != number:
        raise Rejected("state-complete", f"there are {sum(by_dimension)} states, and {number} are listed")
    if proof.by_dimension != by_dimension:
        raise Rejected("state-dimension", f"there are {show(tuple(by_dimension))} states of the dimensions 0, 1, ...")


# ---- §18 Robustness ---------------------------------------------------------------------------


def work_of(count: int, *vectors: Sequence[Fraction]) -> None:
    """So many products of numbers of these vectors."""
    longest = sorted((max((max(x.numerator.bit_length(), x.denominator.bit_length()) for x in vector), default=0) >> 6) + 1
                     for vector in vectors)
    Work.spend(2 * count)
    Work.divide(8 * count, longest[0], longest[-1])


def rank_of_semidefinite(matrix: List[List[Fraction]]) -> Optional[int]:
    """The rank; None if the symmetric matrix is not positive semidefinite. Rows are taken off from the last one on."""
    a, rank = [list(row) for row in matrix], 0
    while a:
        last = a.pop()
        pivot = last.pop()
        if pivot < 0 or (pivot == 0 and any(last)):
            return None
        for row in a:
            x = row.pop()
            if x:
                work_of(2 * len(row), row, last)
                row[:] = [y - x * z / pivot for y, z in zip(row, last)]
        rank += pivot > 0
    return rank


def mixed(terms: Iterable[Tuple[Fraction, Vector]], n: int) -> List[List[Fraction]]:
    """The sum of factors times v vᵀ."""
    total = [[Fraction(0)] * n for _ in range(n)]
    for factor, v in terms:
        work_of(n * n, v, v)
        for j in range(n):
            for k in range(n):
                total[j][k] += factor * v[j] * v[k]
    return total


def image(matrix: List[List[Fraction]], v: Vector) -> Vector:
    work_of(len(v) ** 2, v, *matrix)
    return tuple(dot(row, v) for row in matrix)


class Finger:
    """A contact of §18."""

    def __init__(self, contact: Contact, most: Fraction, length: Fraction) -> None:
        self.point, self.length, self.most = tuple(p.low for p in contact.position), length, most
        norm = rational_root(dot(contact.normal, contact.normal))
        assert norm is not None
        self.normal = times(1 / norm, contact.normal)
        self.mu, self.k = contact.friction.low, contact.stiffness.low
        self.o = root_bounds(1 + self.mu ** 2, 128).low / self.mu if self.mu else Fraction(0)
        size = len(self.point)
        self.pressed = (self.wrench(self.normal),)
        self.held = tuple(self.wrench(unit(size, j)) for j in range(size))
        Work.spend(50)

    def wrench(self, force: Vector) -> Vector:
        size = len(force)
        whole = at(self.point, force)
        return whole[:size] + tuple(torque / self.length for torque in whole[size:])

    def squares(self, state: str) -> Sequence[Vector]:
        """The vectors whose squares are its part of M."""
        return {"stick": self.held, "slip": self.pressed, "detached": ()}[state]

    def offset(self, state: str) -> Fraction:
        return self.o if state == "stick" else Fraction(1)

    def works(self, y: Vector, state: str) -> Tuple[Fraction, Fraction]:
        """α and h."""
        work_of(40, y, self.pressed[0])
        alpha = dot(y, self.pressed[0])
        beta = Fraction(0)
        if state == "stick":
            beta = root_bounds(sum(dot(y, axis) ** 2 for axis in self.held) - alpha ** 2, 128).high
        return alpha, max(Fraction(0), self.mu * beta - alpha)


class Robustness:
    def __init__(self, question: Question, proof: RobustProof) -> None:
        asked = question.asked
        assert asked.length is not None and asked.max_force is not None
        self.proof, self.of_grasp = proof, asked.robustness == "grasp"
        self.fingers = [Finger(contact, f, asked.length) for contact, f in zip(question.contacts, asked.max_force)]
        size = 3 if question.space else 2
        w = question.w()
        self.load = w[:size] + tuple(torque / asked.length for torque in w[size:])
        self.equal = len({finger.k for finger in self.fingers}) < 2

    def forms(self, states: Sequence[str]) -> Tuple[List[List[Fraction]], List[List[Fraction]]]:
        """P and Q."""
        n = len(self.load)
        held = [(finger, v) for finger, state in zip(self.fingers, states) for v in finger.squares(state)]
        if self.equal:
            return mixed(((Fraction(1), v) for _, v in held), n), [[Fraction(j == k) for k in range(n)] for j in range(n)]
        a = mixed(((finger.k, v) for finger, v in held), n)
        return [list(image(a, tuple(row))) for row in a], mixed(((finger.k ** 2, v) for finger, v in held), n)

    def check_combination(self) -> None:
        """Of the lower bound."""
        proof, n = self.proof, len(self.load)
        if proof.lower < 0 or proof.upper < 0 or (proof.combination is None and proof.lower):
            raise Rejected("robust-lower", f"the bounds are {show(proof.lower)} and {show(proof.upper)}")
        if proof.combination is None:
            return
        d, c, forces = proof.combination
        if d <= 0:
            raise Rejected("robust-distance", f"the distance is {show(d)}")
        states, total, before = ["detached"] * len(self.fingers), list(self.load), -1
        for i, state, force in forces:
            place = f"contact {i}"
            if i <= before or i >= len(self.fingers):
                raise Rejected("robust-forces", "it is not there, or out of order", place)
            before, finger = i, self.fingers[i]
            states[i] = state
            work_of(50, force, finger.pressed[0])
            pressing = dot(finger.normal, force)
            across = tuple(x - pressing * n for x, n in zip(force, finger.normal))
            square = dot(across, across)
            if state == "slip" and (square or not self.of_grasp):
                raise Rejected("robust-forces", "it slips, and has friction or is to stick", place)
            if not d <= pressing <= finger.most - d:
                raise Rejected("robust-distance", f"the normal force is {show(pressing)}", place)
            if state == "stick" and not is_sum_within(finger.mu * pressing, square, d * d * (1 + finger.mu ** 2)):
                raise Rejected("robust-distance", "the force is too near to its cone", place)
            total = [x + y for x, y in zip(total, finger.wrench(force))]
        if not self.of_grasp and "detached" in states:
            raise Rejected("robust-forces", "a contact does not stick")
        if any(total):
            raise Rejected("robust-balance", f"load and forces are {show(tuple(total))} together")
        flat = mixed(((Fraction(1), v) for finger, state in zip(self.fingers, states) for v in finger.squares(state)), n)
        p, q = self.forms(states)
        rest = [[x - c * y for x, y in zip(*rows)] for rows in zip(p, q)]
        if c < 0 or rank_of_semidefinite(flat) != n or rank_of_semidefinite(rest) is None:
            raise Rejected("robust-stiffness", f"M has not full rank, or {show(c)} is below 0 or above 1/σ²")
        if proof.lower ** 2 > d * d * c:
            raise Rejected("robust-lower", f"{show(proof.lower)} is above the value of the combination")

    def is_mixture(self, y: Vector, triangle: Vector, sets: Sequence[Tuple[str, ...]], low: Fraction, high: Fraction) -> bool:
        """`robust-leaf`, of `leaf`."""
        n = len(y)
        rows = iter(triangle)
        half = [[next(rows) for _ in range(j, n)] for j in range(n)]
        z = [[half[min(j, k)][abs(j - k)] for k in range(n)] for j in range(n)]
        if rank_of_semidefinite(z) is None:
            return False
        psi = -dot(y, self.load)
        for finger, states in zip(self.fingers, sets):
            values = []
            for state in states:
                o = finger.offset(state)
                room = finger.most - low * (1 + o)
                if state == "detached":
                    values.append(Fraction(0))
                elif room >= 0:
                    alpha, h = finger.works(y, state)
                    # Without friction h is max(0, -α).
                    values.append(sum((dot(image(z, v), v) for v in finger.squares(state)), room * h - low * o * alpha))
            if not values:
                return True
            psi += max(values)
        trace = sum(z[j][j] for j in range(n))
        return psi < 0 or (trace > 0 and high ** 2 * psi <= self.proof.upper ** 2 * trace)

    def reach(self, y: Vector, states: Sequence[str]) -> Tuple[Fraction, Fraction, Fraction]:
        """C, S and the least f / (1 + o), of contacts that are there."""
        constant, slope, least = -dot(y, self.load), Fraction(0), max((f.most for f in self.fingers), default=Fraction(0)) / 2
        for finger, state in zip(self.fingers, states):
            if state != "detached":
                o = finger.offset(state)
                alpha, h = finger.works(y, state)
                constant += finger.most * h
                slope += o * alpha + (1 + o) * h
                least = min(least, finger.most / (1 + o))
        return constant, slope, least

    def is_bounded(self, y: Vector, z: Vector, sets: Sequence[Tuple[str, ...]], high: Fraction) -> bool:
        """`robust-leaf`, of `combination`."""
        if not all(sets):
            return all(len(states) < 2 for states in sets)
        if any(len(states) > 1 for states in sets):
            return False
        states = [state for state, in sets]
        constant, slope, least = self.reach(y, states)
        if constant < 0:
            return True
        e = min(high, least, constant / slope if slope > 0 else high)
        p, q = self.forms(states)
        return any(z) and e * e * dot(image(p, z), z) <= self.proof.upper ** 2 * dot(image(q, z), z)

    def is_none(self, y: Vector) -> bool:
        """`robust-leaf`, of `none`."""
        constant, slope, _ = self.reach(y, ["stick" if finger.mu else "slip" for finger in self.fingers])
        return constant < 0 or (constant == 0 and slope > 0)

    def check_tree(self) -> None:
        """Each node that is waiting is known by the step to it from the one above, which is the depth of the path."""
        sets = [("stick",) * (finger.mu > 0) + ("slip", "detached") * self.of_grasp for finger in self.fingers]
        low, high = Fraction(0), max((finger.most for finger in self.fingers), default=Fraction(0)) / 2
        names: List[str] = []
        undo: List[Tuple[int, Any]] = []  # what was before each step
        waiting: List[Tuple[int, str, int, Any]] = [(0, "", -2, None)]
        for k, (kind, numbers) in enumerate(self.proof.tree):
            if not waiting:
                raise Rejected("tree-long", "everything was complete before this", node=k)
            Work.spend(10)
            depth, name, i, change = waiting.pop()
            while len(names) > depth:
                names.pop()
                j, before = undo.pop()
                if j < 0:
                    low, high = before
                else:
                    sets[j] = before
            if i != -2:
                names.append(name)
                undo.append((i, (low, high) if i < 0 else sets[i]))
                if i < 0:
                    low, high = change
                else:
                    sets[i] = change
            depth, path = len(names), ", ".join(names) or "root"
            if kind == "state":
                i = int(numbers[0])
                if i >= len(sets) or len(sets[i]) < 2:
                    raise Rejected("robust-split", f"contact {i} has no choice of states", path, k)
                waiting += [(depth, f"state {i} {state}", i, (state,)) for state in reversed(sets[i])]
                continue
            if kind == "distance":
                if not low < numbers[0] < high:
                    raise Rejected("robust-split", f"{show(numbers[0])} is not between {show(low)} and {show(high)}", path, k)
                waiting += [(depth, "distance above", -1, (numbers[0], high)), (depth, "distance below", -1, (low, numbers[0]))]
                continue
            n = len(self.load)
            y, rest = numbers[:n], numbers[n:]
            if not (self.is_mixture(y, rest, sets, low, high) if kind == "leaf" else
                    self.is_bounded(y, rest, sets, high) if kind == "combination" else
                    k == 0 and self.of_grasp and self.is_none(y)):
                raise Rejected("robust-leaf", f"it does not show that nothing has a value above {show(self.proof.upper)}", path, k)
        if waiting:
            depth, name, *_ = waiting[-1]
            path = ", ".join([*names[:depth], name]) or "root"
            raise Rejected("tree-short", "the list ends before this node", path, len(self.proof.tree))


def is_sum_within(x: Fraction, square: Fraction, other: Fraction) -> bool:
    """Is √square + √other at most x?"""
    left = x * x - square - other
    return x >= 0 and left >= 0 and left * left >= 4 * square * other


# ---- §8 What a checker answers ----------------------------------------------------------------

USAGE = """check.py GRASP CERTIFICATE [options]

Checks a stickslip certificate, as FORMAT.md says. GRASP is the grasp file, CERTIFICATE the proof;
one of them may be - for standard input. Give the same options as to the program that made it:
  --wrench WX,WY,T         replaces the file's; in space WX,WY,WZ,TX,TY,TZ; of several bodies a number
                           for each coordinate, as in --direction
  --torque T               short for --wrench 0,0,T
  --case NAME              the wrench of this case of the grasp file
  --preload P              one preload for all contacts
  --normal-law LAW         unilateral (the default) or bilateral
  --direction WX,WY,T      ask for the margin: all factors f >= 0 for which the grasp is stable under
                           wrench + f direction, with wrench 0 unless given by --wrench or --case;
                           in space WX,WY,WZ,TX,TY,TZ
  --plane UX,UY,UT,VX,VY,VT
                           ask for the region: all (s, t) for which the (planar) grasp is stable
                           under wrench + s U + t V, with wrench 0 unless given by --wrench or --case
  --preload-direction D    ask for the margin along preloads: P0,P1,..., of which f times is added to
                           the preloads; or scale: f times the preloads
  --inertia X,Y,G2         ask for the class of rigid contacts: must move, must hold or open; the
                           centre of mass, and the squared radius of gyration about it; in space
                           X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ], the centre and the tensor of inertia about it
  --statics FACTOR         ask whether the bodies may stand or must move, whatever stiffness and preloads
                           are, with all friction multiplied by FACTOR; with --direction or --plane (of two
                           wrenches that have a number for each coordinate) which of these loads may or must
  --states SET             ask which states there are, of the set slip, full or closed
  --robustness MEASURE     ask for bounds of the potential contact robustness (contact) or the potential
                           grasp robustness (grasp)
  --length L               the length by which torques are divided there; 1 if left out
  --max-force F,...        the largest normal force there, of all contacts or each; 1 if left out
  --uncertain LIST         ask about every grasp in a box: how far numbers of each kind may be off,
                           such as friction=10%,stiffness=10%,preload=5%,position=0.001,
                           normal=0.0175,wrench=2%; any of them, absolute or in percent, for
                           normals the slope by which they may be turned; and
                           wrench=ball:R[:length=L][:about=X:Y[:Z]][:body=NAME] adds every force f and
                           torque t at a point (of a body, if there are several) with
                           |f|^2 + |t|^2/L^2 <= R^2; L is 1 and the point 0 if left out
  --max-motion LENGTH,ANGLE
                           ask about motions up to these alone, in place of the file's max_motion; or
                           B1,B2,..., a number for each coordinate (with joints always); or none
  --json                   answer as one JSON object
  -h, --help               this text, if it comes before GRASP
  --                       no options follow
Exit codes: 0 accepted, 1 rejected, 2 a file or the command line cannot be understood, 3 not judged:
to see whether it proves its verdict takes more work than the files' length allows.
"""


class UsageError(Exception):
    pass


class Arguments(NamedTuple):
    files: List[str]
    options: Options
    json: bool


def number_option(name: str, text: str) -> Fraction:
    try:
        return rational(text, GRASP)
    except ValueError as error:
        raise UsageError(f"{name}: {error}") from None


def wrench_option(name: str, text: str, most: int) -> Vector:
    """So many numbers as a grasp can have coordinates; which it has is known later."""
    if text.count(",") >= most:
        raise UsageError(f"{name}: '{show(text)}' has more than {most} numbers")
    return list_option(name, text)


def list_option(name: str, text: str) -> Vector:
    return tuple(number_option(name, part) for part in text.split(","))


def ball_option(name: str, text: str) -> Ball:
    """What stands behind "ball:": R[:length=L][:about=X:Y[:Z]][:body=NAME], of which the name is the last."""
    words, has_body, body = text.partition(":body=")
    radius, *rest = words.split(":")
    found: Dict[str, List[str]] = {}
    member = ""
    for word in rest:
        key, equals, value = word.partition("=")
        if equals and key in ("length", "about") and key not in found:
            member, found[key] = key, [value]
        elif not equals and member == "about":
            found[member].append(word)
        else:
            raise UsageError(f"{name}: '{show(word)}' is not length=L, about=X:Y, about=X:Y:Z or body=NAME of "
                             f"'ball:{show(text)}', each at most once, and body the last")
    return Ball(number_option(name, radius), number_option(name, found.get("length", ["1"])[0]),
                tuple(number_option(name, c) for c in found.get("about", [])), body if has_body else None)


def tolerances_option(name: str, text: str) -> Dict[str, Union[Tolerance, Ball]]:
    found: Dict[str, Union[Tolerance, Ball]] = {}
    for part in text.split(","):
        kind, equals, size = part.partition("=")
        if kind not in KINDS or not equals or kind in found:
            raise UsageError(f"{name}: '{show(part)}' is not KIND=TOLERANCE, such as friction=10%, "
                             f"where KIND is one of {', '.join(KINDS)}, each at most once")
        if kind == "wrench" and size.startswith("ball:"):
            found[kind] = ball_option(name, size[len("ball:"):])
            continue
        percent = size.endswith("%")
        found[kind] = Tolerance(number_option(name, size[:-1] if percent else size), percent)
    return found


def parse_arguments(words: Sequence[str]) -> Optional[Arguments]:
    """None if help is asked for: before the first file only, and after -- nothing is an option, so
    that no file's name makes the program end with success."""
    files: List[str] = []
    options, as_json, ended = Options(), False, False
    waiting = list(reversed(words))
    while waiting:
        word = waiting.pop()
        is_help = word in ("-h", "--help")
        if ended or len(word) < 2 or word[0] != "-" or (is_help and files):
            files.append(word)
            continue
        if is_help:
            return None
        if word in ("--", "--json"):
            ended, as_json = ended or word == "--", as_json or word == "--json"
            continue
        name, equals, value = word.partition("=") if word.startswith("--") else (word, "", "")
        if name not in ("--wrench", "--torque", "--case", "--preload", "--normal-law", "--direction",
                        "--preload-direction", "--plane", "--inertia", "--statics", "--states", "--robustness",
                        "--length", "--max-force", "--uncertain", "--max-motion"):
            raise UsageError(f"unknown option '{show(word)}'")
        if not equals:
            if not waiting:
                raise UsageError(f"{name} needs a value")
            value = waiting.pop()
        if name == "--wrench":
            options = options._replace(wrench=wrench_option(name, value, MOST_DIMENSION))
        elif name == "--direction":
            options = options._replace(direction=wrench_option(name, value, MOST_DIMENSION))
        elif name == "--plane":
            values = list_option(name, value)
            options = options._replace(plane=(values[:len(values) // 2], values[len(values) // 2:]))
        elif name == "--inertia":
            values = list_option(name, value)
            if len(values) not in (3, 6, 9):
                raise UsageError(f"{name}: '{show(value)}' is not X,Y,G2, such as 0,0,1, or in space "
                                 "X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ]")
            options = options._replace(inertia=in_full(values))
        elif name == "--statics":
            options = options._replace(statics=number_option(name, value))
        elif name == "--states":
            if value not in STATES:
                raise UsageError(f"{name}: '{show(value)}' is not slip, full or closed")
            options = options._replace(states=value)
        elif name == "--robustness":
            if value not in ROBUSTNESSES:
                raise UsageError(f"{name}: '{show(value)}' is not contact or grasp")
            options = options._replace(robustness=value)
        elif name == "--length":
            options = options._replace(length=number_option(name, value))
        elif name == "--max-force":
            options = options._replace(max_force=list_option(name, value))
        elif name == "--torque":
            options = options._replace(wrench=(Fraction(0), Fraction(0), number_option(name, value)))
        elif name == "--case":
            options = options._replace(case=value)
        elif name == "--preload":
            options = options._replace(preload=number_option(name, value))
        elif name == "--preload-direction":
            options = options._replace(preload_direction="scale" if value == "scale" else
                                       list_option(name, value))
        elif name == "--uncertain":
            options = options._replace(uncertain=tolerances_option(name, value))
        elif name == "--max-motion":
            options = options._replace(max_motion=() if value == "none" else wrench_option(name, value, MOST_DIMENSION))
        elif value in LAWS:
            options = options._replace(law=value)
        else:
            raise UsageError(f"{name}: '{show(value)}' is not unilateral or bilateral")
    u, v = options.plane or ((), ())
    if len(u) != len(v) or (options.plane and options.statics is None and len(u) != PLANE):
        raise UsageError(f"--plane: '{show(','.join(map(str, u + v)))}' is not UX,UY,UT,VX,VY,VT, two wrenches")
    if len(files) != 2:
        raise UsageError(f"expected two files, GRASP and CERTIFICATE, found {len(files)}")
    if files == ["-", "-"]:
        raise UsageError("only one of GRASP and CERTIFICATE can be standard input")
    return Arguments(files, options, as_json)


def listed(vector: Optional[Vector]) -> Optional[List[str]]:
    return None if vector is None else list(map(str, vector))


def listed_wrench(wrench: Wrench) -> List[Union[str, List[str]]]:
    return [str(load.low) if load.certain else list(map(str, load)) for load in wrench]


def tolerances(asked: Options) -> Dict[str, Union[Tolerance, Ball]]:
    """In the order of §2."""
    given = asked.uncertain or {}
    return {kind: given[kind] for kind in KINDS if kind in given}


def listed_tolerance(tolerance: Union[Tolerance, Ball]) -> Union[str, Dict[str, Any]]:
    if isinstance(tolerance, Tolerance):
        return str(tolerance)
    return {"ball": str(tolerance.radius), "length": str(tolerance.length), "about": listed(tolerance.about),
            **({} if tolerance.body is None else {"body": tolerance.body})}


def contact_lines(question: Question) -> List[str]:
    """How many contacts there are; of several bodies, which elements, and the coordinates of motions."""
    if not question.names:
        return [f"contacts    {len(question.contacts)}"]
    contacts, springs = question.slipping(), question.springs()
    ratchets = len(question.contacts) - contacts - springs
    return [f"contacts    {contacts}; ratchets: {ratchets}; springs: {springs}",
            f"coordinates {', '.join(map(printable, question.names))}"]


def states_text(proof: StatesProof, question: Question) -> str:
    return "\n".join(["accepted", f"verdict     complete: {sum(proof.by_dimension)} states, of the set {question.asked.states}",
                      *contact_lines(question), f"dimensions  {', '.join(map(str, proof.by_dimension))}",
                      f"proof       motions: {len(proof.states)}", ""])


def robustness_text(proof: RobustProof, question: Question) -> str:
    asked = question.asked
    return "\n".join(["accepted", f"robustness  of the {asked.robustness}, from {proof.lower} to {proof.upper}", *contact_lines(question),
                      f"wrench      ({', '.join(map(str, question.w()))})", f"length      {asked.length}",
                      f"max force   ({', '.join(map(str, asked.max_force or ()))})",
                      f"proof       forces, and a tree of {len(proof.tree)} nodes: {proof.leaves()} leaves", ""])


def accepted_text(certificate: Certificate, question: Question, leaves: int, ranges: List[Range],
                  resisted: Sequence[Interval], standing_: Optional[Standing]) -> str:
    static = certificate.statics
    asked, margin = question.asked, certificate.verdict == "margin"
    growth = asked.preload_direction
    preload = "f times " * (growth == "scale")
    preload += "as in the grasp file" if asked.preload is None else f"{asked.preload} at all contacts"
    if growth is not None and growth != "scale":
        preload += f" + f ({', '.join(map(str, growth))})"
    tree = f"{len(certificate.trees())} nodes: {leaves} leaves"
    proofs, rests, stickings = (len(certificate.proofs(kind)) for kind in (DegreeProof, RestProof, StickingProof))
    intervals = ", ".join(f"[{low}, oo)" if high is None else f"[{low}, {high}]"
                          for low, high in resisted)
    gone = ", ".join(f"{'(['[held]}{low}, {'oo' if high is None else high})"
                     for low, high, held, _ in ranges)
    lines = ["accepted"]
    if certificate.claims is not None:
        lines += [f"resisted    {intervals or 'none claimed'}",
                  f"refuted     {gone or 'none claimed'}", "elsewhere   nothing is claimed"]
    elif static and (margin or certificate.verdict == "region"):
        lines += standing_.lines() if standing_ else [f"may stand   the sums of load points: {len(static.stand)}",
                                                      f"must move   where a load does work on a twist: {len(static.move)}"]
    elif certificate.pieces is not None:
        count = len(certificate.pieces)
        lines += [f"resisted    of the plane exactly the pieces: {count}" if count else
                  "resisted    no load of the plane"]
    elif margin:
        lines += [f"resisted    {intervals or 'no multiple'}"]
    else:
        lines += [f"verdict     {certificate.verdict}"
                  + ", for every grasp in the box" * question.is_box]
    lines += contact_lines(question)
    lines.append(f"wrench      ({', '.join(map(str, question.wrench))})")
    if asked.direction is not None:
        lines.append(f"direction   ({', '.join(map(str, asked.direction))})")
    if asked.plane is not None:
        u, v = (", ".join(map(str, growth)) for growth in asked.plane)
        lines.append(f"plane       wrench + s ({u}) + t ({v})")
    if asked.inertia is not None:
        lines.append(f"inertia     ({', '.join(map(str, asked.inertia))})")
    if asked.statics is not None:
        lines.append(f"statics     friction times {asked.statics}")
    lines += [f"preload     {preload}", f"normal law  {asked.law}"]
    if asked.uncertain:
        lines.append("uncertain   " + ", ".join(f"{kind} {size}" for kind, size in tolerances(asked).items()))
    if asked.max_motion:
        lines.append(f"max motion  ({', '.join(map(str, asked.max_motion))})")
    lines += ["proof       " + (
        "forces" if certificate.verdict == "may stand" else
        f"load points: {len(static.stand)}, twists: {len(static.move)}" if static and certificate.verdict != "must move" else
        f"intervals by degree: {proofs}" + f", at rest: {rests}" * (rests > 0)
        + f", sticking: {stickings}" * (stickings > 0)
        + f", refuted: {len(ranges)}; trees of {tree}"
        if certificate.claims is not None else
        f"segments: {len(certificate.segments)}" + f", by degree: {proofs}" * (proofs > 0)
        + f"; trees: {len(ranges)}, of {tree}" if margin else
        f"pieces: {len(certificate.pieces)}; a tree of {tree}"
        if certificate.pieces is not None else
        "; ".join([f"at rest, parts: {rests}"] * (rests > 0)
                  + [f"sticking, parts: {stickings}"] * (stickings > 0)
                  + [f"by degree, parts: {proofs}; trees of {tree}"] * (proofs > 0))
        if certificate.parts is not None else
        f"forces at rest, and a tree of {tree}" if certificate.verdict == "must hold" else
        "a twist" if certificate.verdict == "must move" else
        "forces at rest, and others with an acceleration" if certificate.verdict == "open" else
        "an equilibrium" if certificate.witness else f"a tree of {tree}")]
    return "\n".join(lines) + "\n"


def answer(arguments: Arguments) -> Tuple[Dict[str, Any], str, int]:
    """The answer as an object, in which every key is there, and as text; and the exit code."""
    with Work():
        return judge(arguments)


def judge(arguments: Arguments) -> Tuple[Dict[str, Any], str, int]:
    report: Dict[str, Any] = dict.fromkeys(("result", "rule", "node", "path", "found", "verdict",
                                            "box", "nodes", "leaves", "resisted",
                                            "refuted", "question"))
    try:
        question = pose(arguments.files[0], arguments.options)
        certificate = read_certificate(arguments.files[1], question)
        check_question(question, certificate.question)
        ranges = [VERDICT]
        if certificate.verdict == "margin" and certificate.claims is None and certificate.statics is None:
            check_resisted(certificate.resisted)
            check_segments(certificate.segments, certificate.resisted, question)
            ranges = gaps(certificate.resisted)
        standing_ = None
        if certificate.states is not None:
            check_states(question, certificate.states)
        elif certificate.robust is not None:
            robust = Robustness(question, certificate.robust)
            robust.check_combination()
            robust.check_tree()
        elif certificate.statics is not None:
            statics = check_statics_proof(question, certificate, certificate.statics)
            standing_ = standing(statics, certificate.statics) if certificate.verdict == "margin" else None
        elif certificate.rigid is not None:
            check_class(question, certificate, certificate.rigid)
        elif question.large:
            check_large(question, certificate)
        elif certificate.pieces is not None:
            box = enlarged(question, certificate.bits)
            check_tree(certificate.tree, [root_of(question, box, certificate.pieces)])
        elif certificate.witness:
            check_witness(question, certificate.witness)
        elif certificate.claims is not None:
            ranges = check_ranges(question, certificate.claims,
                                  enlarged(question, certificate.bits))
        elif certificate.parts is not None:
            check_parts(certificate.parts, enlarged(question, certificate.bits), question.asked)
        else:
            check_tree(certificate.tree,
                       roots(question, enlarged(question, certificate.bits), ranges))
    except Rejected as failure:
        found = printable(failure.found)
        report.update(result="rejected", rule=failure.rule, node=failure.node, path=failure.path,
                      found=found)
        lines = [f"node   {failure.node}"] * (failure.node is not None)
        lines += [f"path   {failure.path}"] * (failure.path is not None)
        return report, "\n".join(["rejected", f"rule   {failure.rule}", *lines, f"found  {found}",
                                  ""]), 1
    except NotJudged as failure:
        report.update(result="not judged", found=str(failure))
        return report, f"not judged\nwhy    {failure}\n", 3
    except Malformed as failure:
        report.update(result="malformed", path=printable(failure.place) or None,
                      found=printable(failure.problem))
        return report, printable(str(failure)) + "\n", 2
    leaves = sum(node.kind in ("leaf", "moving", "held") for node in certificate.trees())
    resisted = certificate.resisted + resisted_ranges(certificate.claims or [])
    asked, growth = question.asked, question.asked.preload_direction
    if certificate.states is not None:
        report.update(result="accepted", verdict=certificate.verdict, box=False, by_dimension=certificate.states.by_dimension,
                      question={"contacts": len(question.contacts), "states": asked.states})
        return report, states_text(certificate.states, question), 0
    if certificate.robust is not None:
        proof = certificate.robust
        report.update(result="accepted", verdict=certificate.verdict, box=False, nodes=len(proof.tree), leaves=proof.leaves(),
                      bounds=[str(proof.lower), str(proof.upper)],
                      question={"contacts": len(question.contacts), "wrench": listed_wrench(question.wrench),
                                "robustness": asked.robustness, "length": str(asked.length), "max_force": listed(asked.max_force)})
        return report, robustness_text(proof, question), 0
    report.update(result="accepted", verdict=certificate.verdict, box=question.is_box, question={
        "contacts": len(question.contacts), "wrench": listed_wrench(question.wrench),
        "preload": None if asked.preload is None else str(asked.preload), "normal_law": asked.law,
        "direction": listed(asked.direction),
        "preload_direction": growth if growth == "scale" else listed(growth),
        **({"plane": list(map(listed, asked.plane))} if asked.plane else {}),
        **({"inertia": listed(asked.inertia)} if asked.inertia else {}),
        **({} if asked.statics is None else {"statics": str(asked.statics)}),
        "uncertain": {kind: listed_tolerance(size) for kind, size in tolerances(asked).items()} or None,
        **({"max_motion": listed(asked.max_motion)} if asked.max_motion else {})})
    if not certificate.witness and certificate.statics is None:
        report.update(nodes=len(certificate.trees()), leaves=leaves)
    if certificate.verdict == "margin" and certificate.statics is None:
        report["resisted"] = [[str(low), high if high is None else str(high)]
                              for low, high in resisted]
    if certificate.claims is not None:
        report["refuted"] = [[str(low), high if high is None else str(high), held]
                             for low, high, held, _ in ranges]
    if certificate.pieces is not None:
        report["pieces"] = len(certificate.pieces)
    if certificate.statics is not None and certificate.verdict in ("margin", "region"):
        report.update(points=len(certificate.statics.stand), twists=len(certificate.statics.move))
    if standing_:
        report["standing"] = standing_.listed()
    return report, accepted_text(certificate, question, leaves, ranges, resisted, standing_), 0


def write(text: str, code: int) -> int:
    """What nobody can read was not answered."""
    if not text:
        return code
    if sys.stdout is None:  # it was closed before the start
        complain(f"standard output cannot be written: {os.strerror(errno.EBADF)}\n")
        return 2
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
        return code
    except OSError as error:
        give_up(sys.stdout)
        if not isinstance(error, BrokenPipeError):
            complain(f"standard output cannot be written: {error.strerror}\n")
        return 2


def complain(text: str) -> None:
    """On standard error, if there is one: that it cannot be written changes no exit code."""
    try:
        if sys.stderr is not None:
            sys.stderr.write("check.py: " + text)
            sys.stderr.flush()
    except OSError:
        give_up(sys.stderr)


def give_up(stream: TextIO) -> None:
    """So that Python does not try again at the end, and fail with a code of its own."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def main(words: Sequence[str]) -> int:
    """Exit code 0 says accepted, 1 rejected and 3 not judged; anything unforeseen must be 2."""
    if hasattr(sys, "set_int_max_str_digits"):  # Python 3.11's limit is below that of §2
        sys.set_int_max_str_digits(0)
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.reconfigure(errors="backslashreplace")
    try:
        arguments = parse_arguments(words)
        if arguments is None:
            return write(USAGE, 0)
        report, text, code = answer(arguments)
    except UsageError as error:
        complain(f"{printable(str(error))}; try check.py --help\n")
        return 2
    except Exception as error:  # pylint: disable=broad-except
        complain(f"internal error: {type(error).__name__}: {printable(str(error))}\n")
        return 2
    if code == 2:
        complain(text)
        text = ""
    return write(json.dumps(report) + "\n" if arguments.json else text, code)


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C: end without a traceback
    sys.exit(main(sys.argv[1:]))
