# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments as they are needed, or an InputError that names the place.

What the entries are worth as numbers is the compiled part's to say.
"""

from __future__ import annotations

import operator
import os
import reprlib
from fractions import Fraction
from typing import Any, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from .errors import InputError

AXES = {2: "x, y", 3: "x, y, z"}
WRENCHES = {2: (3, "force x, force y and torque"), 3: (6, "force x, y, z and torque x, y, z")}
"""By coordinates: how many numbers a wrench has, and what they are."""
_ENOUGH_BYTES = 2**30 + 1  # more than a grasp file or a certificate may have


def as_array(values: Any, name: str) -> np.ndarray[Any, np.dtype[np.object_]]:
    """The entries unchanged: without dtype=object NumPy turns mixed ones into strings."""
    _refuse_masked(values, name, ())
    try:
        return np.asarray(values, dtype=object)
    except ValueError as error:  # arrays that do not fit together
        raise InputError("", name, str(error), "give an array, or lists of equal length") from None


def as_list(values: Any, name: str, shape: Tuple[int, ...], meaning: str) -> List[Any]:
    """The entries as nested lists, if they have the shape."""
    array = as_array(values, name)
    if array.shape == (0,) and shape[0] == 0:
        return []
    if array.ndim == 0:
        raise InputError("", name, f"this is {found(array.item())}",
                         f"expected the shape {shape}: {meaning}")
    if array.ndim == 1 and len(shape) == 2:  # NumPy leaves rows of several lengths as they are
        for i, row in enumerate(array):
            if as_array(row, f"{name}[{i}]").shape != shape[1:]:
                raise InputError("", f"{name}[{i}]", f"this is {found(row)}",
                                 f"expected {shape[1]} numbers: {meaning}")
    if array.shape != shape:
        raise InputError("", name, f"the shape is {array.shape}", f"expected {shape}: {meaning}")
    entries: List[Any] = array.tolist()
    return entries


def as_rows(positions: Any, n: int = 2) -> List[Any]:
    """Of n coordinates."""
    return as_list(positions, "positions", (len(_rows(positions)), n),
                   f"one row {AXES[n]} for each contact")


def coordinates_of(positions: Any, wrench: Any) -> int:
    """How many: 3 if the first row is in space, or, if there are none, the wrench; else 2."""
    rows = _rows(positions)
    if len(rows) > 0:
        return 3 if as_array(rows[0], "positions[0]").shape == (3,) else 2
    return 3 if wrench is not None and as_array(wrench, "wrench").shape == (6,) else 2


def _rows(positions: Any) -> Any:
    array = as_array(positions, "positions")
    if array.ndim == 0:
        raise InputError("", "positions", f"this is {found(array.item())}",
                         "give one row x, y or x, y, z for each contact; Grasp.from_file reads a "
                         "file")
    return array


def as_number(value: Any, name: str) -> Any:
    """The one entry, unchanged."""
    array = as_array(value, name)
    if array.ndim != 0:
        raise InputError("", name, f"the shape is {array.shape}", "give one number")
    return array.item()


def as_number_or_none(value: Any, name: str) -> Any:
    return None if value is None else as_number(value, name)


def as_numbers(values: Any, name: str, count: int) -> Any:
    """A list with one entry for each of ``count`` contacts, or the entry that all of them have."""
    array = as_array(values, name)
    if array.ndim == 0:
        return array.item()
    return as_list(array, name, (count,), "one number, or one for each row of positions")


def as_wrench(values: Any, name: str, n: int = 2) -> List[Any]:
    """Of a grasp with n coordinates."""
    count, meaning = WRENCHES[n]
    return as_list(values, name, (count,), meaning)


def as_row_or_none(values: Any, name: str, row: Optional[Tuple[int, str]]) -> Optional[List[Any]]:
    """Of so many numbers with this meaning; or of any number, which somebody else knows."""
    if values is None:
        return None
    count, meaning = row or (len(np.atleast_1d(as_array(values, name))), "one row of numbers")
    return as_list(values, name, (count,), meaning)


def as_file(value: Any, place: str = "") -> Any:
    """What may stand in a file for JSON, with its numbers taken exactly."""
    if isinstance(value, Mapping):
        return {as_text(key, f"a key of {place or 'the file'}"): as_file(
            entry, f"{place}.{key}" if place else key) for key, entry in value.items()}
    if isinstance(value, (list, tuple)) or (isinstance(value, np.ndarray) and value.ndim > 0):
        _refuse_masked(value, place, ())
        return [as_file(entry, f"{place}[{i}]") for i, entry in enumerate(value)]
    if isinstance(value, bool):
        return value  # which the reader refuses
    if isinstance(value, str):
        return as_text(value, place)
    number = _core.exact(value, place)
    # Large integers as strings, which no reader rounds.
    whole = number.denominator == 1 and abs(number) < 2**53
    return number.numerator if whole else str(number)


def as_inertia(values: Any, n: int = 2) -> List[Any]:
    if n == 2:
        return as_list(values, "inertia", (3,), "centre x, y and squared radius of gyration")
    count = 9 if as_array(values, "inertia").shape == (9,) else 6
    return as_list(values, "inertia", (count,),
                   "centre x, y, z and tensor xx, yy, zz, perhaps xy, xz, yz")


def as_plane_or_none(values: Any) -> Optional[List[List[Any]]]:
    """u and v."""
    if values is None:
        return None
    return as_list(values, "plane", (2, 3), "two wrenches, u and v")


def as_preload_direction_or_none(values: Any) -> Union[str, List[Any], None]:
    name = "preload_direction"
    if values is None:
        return None
    if isinstance(values, str):
        return one_of(name, values, ("scale",))
    return as_list(values, name, as_array(values, name).shape[:1], "one number for each contact")


def as_max_motion(value: Any) -> str:
    """As on the command line: "1/100,1/50", "1000x" or "none"; "" leaves the grasp's own."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    name = "max_motion"
    numbers = as_list(value, name, as_array(value, name).shape[:1],
                      "a length and an angle, or one number for each coordinate")
    return ",".join(str(Fraction(number)) for number in numbers)


def as_uncertain(value: Any) -> str:
    """As on the command line, "friction=10%,wrench=1/100"."""
    if isinstance(value, str):
        return value
    if not isinstance(value, Mapping):
        raise InputError("", "uncertain", f"this is {found(value)}",
                         'give kinds and their tolerances, as in {"friction": "10%"}')
    return ",".join(
        f"{kind}=" + (size if isinstance(size, str)
                      else str(_core.exact(as_number(size, place), place)))
        for kind, size in value.items() for place in [f"uncertain[{kind!r}]"])


def as_text(value: Any, name: str, remedy: str = "give a str") -> str:
    if not isinstance(value, str):
        raise InputError("", name, f"this is {found(value)}", remedy)
    try:
        value.encode()
    except UnicodeEncodeError as error:
        raise InputError("", name, f"character {error.start}, {value[error.start]!a}, is half of a "
                         "surrogate pair", "give text that UTF-8 can hold") from None
    return value


def as_outline(outline: Any) -> List[List[List[Any]]]:
    """A list of polygons, also of one polygon or of one ring, or of a geometry of shapely."""
    form = ("give a list of polygons, each a list of rings of rows x, y; or one polygon, or one ring; "
            "or a polygon of shapely")
    if hasattr(outline, "exterior") or hasattr(outline, "geoms"):  # its rings repeat their start
        parts = getattr(outline, "geoms", [outline])
        if not all(hasattr(part, "exterior") for part in parts):
            raise InputError("", "outline", f"this is {found(outline)}", form)
        return [[list(map(list, ring.coords[:-1])) for ring in (part.exterior, *part.interiors)]
                for part in parts]

    def entries(value: Any, name: str) -> List[Any]:
        if isinstance(value, (str, bytes)) or not hasattr(value, "__iter__"):
            raise InputError("", name, f"this is {found(value)}", form)
        return list(value)

    polygons, depth = entries(outline, "outline"), 0
    first: Any = polygons
    while hasattr(first, "__len__") and not isinstance(first, (str, bytes)) and len(first) > 0:
        first, depth = first[0], depth + 1
    for _ in range(4 - depth if depth > 0 else 0):
        polygons = [polygons]
    return [[as_list(ring, f"outline[{j}][{k}]", (len(entries(ring, f"outline[{j}][{k}]")), 2),
                     "one row x, y for each vertex")
             for k, ring in enumerate(entries(polygon, f"outline[{j}]"))]
            for j, polygon in enumerate(polygons)]


def as_units(units: Mapping[str, str]) -> List[str]:
    """Of length and of force; empty if there are none."""
    if len(units) == 0:
        return []
    if set(units) != {"length", "force"}:
        raise InputError("", "units", f"the keys are {found(list(units))}",
                         'give both, as in {"length": "mm", "force": "N"}')
    return [as_text(units[key], f"units[{key!r}]") for key in ("length", "force")]


def as_case_name(value: Any) -> str:
    if as_text(value, "cases", "give names that are of type str") == "":
        raise InputError("", "cases", "a name is empty", "give each case a name")
    return str(value)


def as_json(value: Any, name: str, remedy: str) -> bytes:
    text = as_text(value, name, remedy)
    if not looks_like_json(text):
        raise InputError("", name, f"this is no JSON object: {found(text)}", remedy)
    return text.encode()


def as_content(path: Any, name: str, remedy: str) -> Tuple[bytes, bytes]:
    """What the file of this path holds, and its name for messages."""
    try:
        path = os.fspath(path)
    except TypeError:
        raise InputError("", name, f"this is {found(path)}", remedy) from None
    try:
        with open(path, "rb") as file:
            return file.read(_ENOUGH_BYTES), os.fsencode(path)
    except (OSError, ValueError) as error:  # a ValueError if the path has a NUL
        shown = os.fsdecode(path)
        if "\n" in shown or looks_like_json(shown):
            raise InputError("", name, f"this is text and not a path: {found(shown)}",
                             remedy) from None
        reason = error.strerror if isinstance(error, OSError) else error
        raise InputError(shown, "", f"cannot open the file: {reason}",
                         "name a file that can be read") from error


def looks_like_json(text: str) -> bool:
    return text.lstrip("\ufeff \t\r\n").startswith("{")


def one_of(name: str, value: str, allowed: Sequence[str]) -> str:
    if not isinstance(value, str) or value not in allowed:
        raise InputError("", name, f"this is {found(value)}", "give one of " + ", ".join(allowed))
    return value


def as_engine(engine: str) -> str:
    if isinstance(engine, str) and engine == "cone":  # its name of old
        return "branch-and-bound"
    return one_of("engine", engine, ("auto", "states", "branch-and-bound"))


def is_bilateral(normal_law: str) -> bool:
    return one_of("normal_law", normal_law, ("unilateral", "bilateral")) == "bilateral"


def as_count(name: str, value: int, most: int = 2**32 - 1) -> int:
    try:
        count = operator.index(value)
    except TypeError:
        count = -1
    if not 0 <= count <= most:
        raise InputError("", name, f"this is {found(value)}", f"give an int from 0 to {most}")
    return count


def as_time_limit(value: Any) -> Any:
    """None is no limit."""
    seconds = _core.exact(as_number(value, "time_limit"), "time_limit")
    if not 0 <= seconds <= 86400:
        raise InputError("", "time_limit", f"found {value!r}", "give seconds, from 0, which is no limit, to 86400")
    return seconds or None


def found(value: Any) -> str:
    """For messages."""
    if value is None:
        return "None"
    if isinstance(value, (str, int, float, list, tuple)):
        return reprlib.repr(value)
    return f"an object of type {type(value).__name__}"


def _refuse_masked(values: Any, name: str, index: Tuple[Any, ...]) -> None:
    """NumPy would take the number behind the mask."""
    if isinstance(values, np.ma.MaskedArray):
        masked = np.argwhere(np.broadcast_to(values.mask, values.shape))
        if len(masked) > 0:
            index += tuple(map(int, masked[0]))
            place = name + (f"[{', '.join(map(str, index))}]" if index else "")
            raise InputError("", place, "this entry is masked",
                             "leave it out, or give its number with the method filled")
    elif isinstance(values, (list, tuple)) or (
            isinstance(values, np.ndarray) and values.dtype == object and values.ndim > 0):
        for i, entry in enumerate(values):
            _refuse_masked(entry, name, (*index, i))
