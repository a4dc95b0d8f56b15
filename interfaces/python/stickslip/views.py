# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact values as people look at them: the nearest doubles, and a ``repr`` of a few lines."""

from __future__ import annotations

import dataclasses
import html
import math
import os
from fractions import Fraction
from typing import Any, Generic, Iterable, Optional, Sequence, Tuple, Type, TypeVar, Union, cast

import numpy as np
from numpy.typing import NDArray

from . import _core

FloatArray = NDArray[np.float64]
View = TypeVar("View", FloatArray, Optional[FloatArray])


def nearest_double(value: Fraction) -> float:
    """Rounded to nearest, ties to even, as division of ints is; infinite beyond the doubles."""
    try:
        return value.numerator / value.denominator
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def nearest_root(square: Fraction) -> float:
    """The double nearest to the root of a number >= 0."""
    n, d = square.numerator, square.denominator
    shift = max(0, 64 + (d.bit_length() - n.bit_length()) // 2)
    root = math.isqrt((n << 2 * shift) // d)  # of at least 63 bits
    inexact = root * root * d != n << 2 * shift  # then above root: half a unit keeps that
    return nearest_double(Fraction(2 * root + inexact, 2 << shift))


class FloatView(Generic[View]):
    """An attribute: the fractions of another one as an array of the nearest doubles.

    None if it is None; None within it, the end of an interval without end, is infinity. The shape
    is that of an empty one.
    """

    def __init__(self, name: str, *shape: int) -> None:
        self.__doc__ = f"``{name}`` as an array of the nearest doubles."
        self._name = name
        self._shape = shape

    def __get__(self, answer: Any, owner: Optional[Type[Any]] = None) -> View:
        if answer is None:
            return cast(View, self)  # the class is asked, as help() does
        values = getattr(answer, self._name)
        return cast(View, None if values is None else doubles(values, *self._shape))


def doubles(values: Any, *shape: int) -> FloatArray:
    """Nested tuples of fractions as an array of the nearest doubles; None is infinity. The shape
    is that of an empty one."""
    array = _doubles(values)
    return array if array.size > 0 else array.reshape(shape)


def _doubles(values: Any) -> FloatArray:
    if values is None:
        return np.array(math.inf)
    if isinstance(values, Fraction):
        return np.array(nearest_double(values))
    return np.array([_doubles(value) for value in values], dtype=float)


# Text for people. A number after "~" is rounded, all others are exact.

_WIDTH = 96


def shown(value: Any, room: int = _WIDTH) -> str:
    """A value within the text of an answer, with as many of its entries as there is room for."""
    if isinstance(value, Fraction):
        return _core.readable(value)
    if isinstance(value, str):
        cut = value[:room - len("'' (1000000 more)")]
        return repr(value) if len(value) + 2 <= room else f"{cut!r} ({len(value) - len(cut)} more)"
    if type(value) is not tuple:
        return repr(value)
    text = ""
    for i, entry in enumerate(value):
        longer = text + (", " if i > 0 else "") + shown(entry, room)
        rest = len(value) - i - 1
        more = f", ... {rest} more" if rest > 0 else ""
        if i > 0 and len(f"({longer}{more})") > room:
            return f"({text}, ... {rest + 1} more)"
        text = longer
    return f"({text},)" if len(value) == 1 else f"({text})"


def call_of(name: str, fields: Iterable[Tuple[str, Any]]) -> str:
    """name(field=value, ...), without what is None or empty, in lines of limited width."""
    margin = " " * len(name + "(")
    lines = [margin]
    for field, value in fields:
        if value in (None, (), ""):
            continue
        indent = margin + " " * len(field + "=")
        item = f"{field}={shown(value, _WIDTH - len(indent + ','))},".replace("\n", "\n" + indent)
        if lines[-1] != margin:
            if len(f"{lines[-1]} {item}".split("\n")[0]) > _WIDTH:
                lines.append(margin)
            else:
                item = " " + item
        lines[-1:] = (lines[-1] + item).split("\n")
    return name + "(" + "\n".join(lines)[len(margin):].removesuffix(",") + ")"


class Document(str):
    """A text to keep or to show, of which ``print`` and ``repr`` say one line.

    In all else it is the str of its text, also in an f-string.
    """

    _language = ""

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes it to a file, over what is there."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self._language} of {len(self)} characters>"

    __str__ = __repr__

    def __format__(self, how: str) -> str:
        return format(self[:], how)

    def __reduce__(self) -> Tuple[Any, ...]:  # the oldest protocols would keep str(self)
        return type(self), (self[:],)


class Picture(Document):
    """An SVG document, which shows itself in a notebook; ``save("grasp.svg")`` keeps it."""

    _language = "SVG"

    def _repr_svg_(self) -> str:
        return self[:]


class Page(Document):
    """An HTML document that loads nothing, which shows itself in a notebook; ``save`` keeps it."""

    _language = "HTML"

    def _repr_html_(self) -> str:
        return ("<iframe style='width:100%;height:48em;border:0' sandbox='allow-scripts allow-downloads' "
                f"srcdoc='{html.escape(self[:])}'></iframe>")


class Answer:
    """What all answers share: their text has the fields that are declared for it."""

    def _shown_fields(self) -> Iterable[Tuple[str, Any]]:
        return ((f.name, getattr(self, f.name))
                for f in dataclasses.fields(cast(Any, self)) if f.repr)

    def _picture(self) -> Optional[Picture]:
        """What a notebook shows above the fields."""
        return None

    def __repr__(self) -> str:
        return call_of(type(self).__name__, self._shown_fields())

    def _repr_svg_(self) -> Optional[str]:
        return self._picture()

    def _repr_html_(self) -> str:
        rows = [(name, shown(value)) for name, value in self._shown_fields()
                if value not in (None, (), "")]
        return (self._picture() or "") + table(rows)


def table(rows: Iterable[Sequence[str]]) -> str:
    """In HTML; the first entry of each row heads it."""
    return "<table>" + "".join(
        "<tr><th style='text-align:left'>" + html.escape(row[0]) + "</th>" + "".join(
            f"<td style='text-align:left'>{html.escape(entry)}</td>" for entry in row[1:])
        + "</tr>" for row in rows) + "</table>"
