# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts as other programs have them, in arrays and records, made what a Grasp takes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, TypeVar

import numpy as np

from . import _core
from .arguments import as_array, as_list, as_number, as_numbers, as_rows, coordinates_of, found, one_of
from .errors import InputError

Numbers = List[Fraction]


class Contacts(NamedTuple):
    """Arguments of a Grasp."""

    positions: List[Any]
    normals: List[Any]
    friction: Any
    stiffness: Any
    preload: Any


def exact_list(values: Any, name: str) -> Numbers:
    return [_core.exact(value, f"{name}[{i}]") for i, value in enumerate(values)]


def exact_vector(values: Any, name: str, n: int = 3) -> Numbers:
    return exact_list(as_list(values, name, (n,), f"{n} numbers"), name)


def dot(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b)), Fraction(0))


Number = TypeVar("Number", int, Fraction)


def cross(a: Sequence[Number], b: Sequence[Number]) -> List[Number]:
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def negated(row: Sequence[Any], name: str) -> List[Any]:
    """A float stays one: in the plane a Grasp may round the normals that were given so."""
    return [-x if isinstance(x, (float, np.floating)) else -_core.exact(x, f"{name}[{i}]")
            for i, x in enumerate(row)]


def on_grid(found: Contacts, grid: Any) -> Contacts:
    """With positions rounded to multiples of a length, if there is one; a half to the even one."""
    if grid is None:
        return found
    step = _core.exact(as_number(grid, "grid"), "grid")
    if step <= 0:
        raise InputError("", "grid", f"the value is {_core.readable(step)}", "give a length above 0")
    return found._replace(positions=[
        [round(_core.exact(x, f"positions[{i}, {j}]") / step) * step for j, x in enumerate(row)]
        for i, row in enumerate(found.positions)])


# Springs: of force, penetration and stiffness two give the third.


def springs(places: Sequence[str], forces: Optional[Numbers], distances: Optional[Numbers],
            stiffness: Any, preload: Any) -> Tuple[Any, Any]:
    """Stiffness and preload of contacts with these normal forces at these distances."""
    if distances is not None:
        if forces is not None and stiffness is not None:
            raise InputError("", "distance", "forces and stiffness are given, too",
                             "leave out one of the three: a stiffness is force over penetration")
        if forces is not None:
            stiffness = [_stiffness(*one) for one in zip(places, forces, distances)]
        elif stiffness is not None:
            each = as_numbers(stiffness, "stiffness", len(places))
            rows = each if isinstance(each, list) else [each] * len(places)
            forces = [_core.exact(k, f"stiffness[{i}]") * _penetration(places[i], distances[i])
                      for i, k in enumerate(rows)]
        else:
            raise InputError("", "distance", "there are neither forces nor stiffness",
                             "give forces, which over penetrations are stiffness, or stiffness, "
                             "which times penetrations is force")
    if preload is None:
        preload = 0 if forces is None else forces
    return stiffness, preload


def pushing(place: str, force: Fraction) -> Fraction:
    if force < 0:
        raise InputError("", place, f"the normal force is {_core.readable(force)}: it pulls",
                         "contacts push or let go; leave out what sticks by adhesion, and add its "
                         "pull to the wrench")
    return force


def _penetration(place: str, distance: Fraction) -> Fraction:
    if distance > 0:
        raise InputError("", place, f"there is a gap of {_core.readable(distance)}",
                         "leave out what does not touch; the distance of what penetrates is "
                         "negative")
    return -distance


def _stiffness(place: str, force: Fraction, distance: Fraction) -> Fraction:
    penetration = _penetration(place, distance)
    if force == 0 or penetration == 0:
        raise InputError("", place, f"a force of {_core.readable(force)} at a penetration of "
                         f"{_core.readable(penetration)} says nothing of stiffness",
                         "give stiffness; then the distance is not needed")
    return force / penetration


# From arrays or records.

_FIELDS = {"positions": "position", "normals": "normal", "frames": "frame", "friction": "friction",
           "into": "into", "forces": "force", "distance": "distance", "stiffness": "stiffness",
           "preload": "preload"}


def from_arrays(given: Dict[str, Any], wrench: Any) -> Contacts:
    """``given`` has the arguments that _FIELDS names."""
    given = _columns(given)
    n = coordinates_of(given["positions"], wrench)
    positions = as_rows(given["positions"], n)
    m = len(positions)
    normals = _normals(given["normals"], given["frames"], m, n)
    sides = given["into"]
    sides = [sides] * m if isinstance(sides, str) or sides is None else list(sides)
    if len(sides) != m:
        raise InputError("", "into", f"there are {len(sides)}", f"give one, or one for each of {m}")
    for i, side in enumerate(sides):
        if one_of(f"into[{i}]", side, ("body", "other")) == "other":
            normals[i] = negated(normals[i], f"normals[{i}]")
    if given["friction"] is None:
        raise InputError("", "friction", "there is none", "give one number, or one for each contact")
    stiffness, preload = springs(
        [f"distance[{i}]" for i in range(m)],
        normal_forces(given["forces"], m, given["frames"] is not None),
        _scalars(given["distance"], "distance", m, "a number for each contact"),
        given["stiffness"], given["preload"])
    return Contacts(positions, normals, given["friction"], stiffness, preload)


def _field(record: Any, name: str) -> Any:
    if isinstance(record, Mapping):
        return record.get(name)
    if isinstance(record, np.void):
        return record[name] if name in (record.dtype.names or ()) else None
    return getattr(record, name, None)


def _columns(given: Dict[str, Any]) -> Dict[str, Any]:
    """Of records, each with a position, the columns; other arguments stay."""
    records = given["positions"]
    if isinstance(records, (str, Mapping)) or not isinstance(records, Iterable):
        return given
    records = list(records)
    if not records or _field(records[0], "position") is None:
        return given
    for i, record in enumerate(records):  # what is misspelt is not to pass for a default
        for key in (record if isinstance(record, Mapping)
                    else record.dtype.names or () if isinstance(record, np.void) else ()):
            if key not in _FIELDS.values():
                raise InputError("", f"positions[{i}]", f"the record has the unknown key {found(key)}",
                                 "the keys of records are " + ", ".join(_FIELDS.values()))
    result = dict(given)
    for argument, name in _FIELDS.items():
        values = [_field(record, name) for record in records]
        missing = [i for i, value in enumerate(values) if value is None]
        if len(missing) == len(values):
            continue
        if missing:
            raise InputError("", f"positions[{missing[0]}]", f"the record has no {name}, and others "
                             "have one", f"give {name} in each record, or {argument} for all")
        if argument != "positions" and given[argument] is not None:
            raise InputError("", argument, f"the records have a {name} each", "give one of the two")
        result[argument] = values
    return result


def _normals(normals: Any, frames: Any, m: int, n: int) -> List[Any]:
    if (normals is None) == (frames is None):
        raise InputError("", "normals", "there are no normals" if normals is None
                         else "there are frames, too",
                         "give normals, or frames whose first rows are normals")
    if frames is None:
        return as_list(normals, "normals", (m, n), "one row for each row of positions")
    array = as_array(frames, "frames")
    if array.shape == (m, n * n):  # row after row
        array = array.reshape(m, n, n)
    rows = as_list(array, "frames", (m, n, n), "a matrix for each contact, whose first row is the normal")
    return [frame[0] for frame in rows]


def _scalars(values: Any, name: str, m: int, meaning: str) -> Optional[Numbers]:
    """One a contact."""
    if values is None:
        return None
    array = as_array(values, name)
    if array.ndim == 0:
        return [_core.exact(array.item(), name)] * m
    return exact_list(as_list(array, name, (m,), meaning), name)


def normal_forces(values: Any, m: int, first: bool) -> Optional[Numbers]:
    """Normal forces; with ``first`` also rows, of which they are the first numbers."""
    if first and values is not None:
        array = as_array(values, "forces")
        if array.ndim == 2 and array.shape[1] > 0:
            values = array[:, 0]
    forces = _scalars(values, "forces", m, "the normal force of each contact, a number; rows, of which "
                      "it is the first, go with frames")
    return None if forces is None else [pushing(f"forces[{i}]", f) for i, f in enumerate(forces)]
