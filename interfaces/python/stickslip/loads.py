# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces at points, torques and weights, as grasp files have them."""

from __future__ import annotations

import json
from typing import Any, Mapping, Sequence

from . import _core
from .arguments import as_array, found
from .errors import InputError
from .grasp import Vector

_NUMBERS = ("force", "at", "torque", "weight", "direction")
_IN_SPACE = {"position": [0, 0, 0], "normal": [0, 0, 1], "friction": 0}  # says so, and no more


def wrench_of(loads: Sequence[Mapping[str, Any]]) -> Vector:
    """The wrench about the origin that these loads sum to, exactly.

    Each is a load of docs/grasp_file.md, with numbers of any type that a Grasp takes:
    ``{"force": (fx, fy), "at": (x, y)}``, ``{"torque": t}``, or ``{"weight": W, "at": (x, y)}``, which
    pulls along -y, or along its ``"direction"`` of rational length. In space vectors have three
    coordinates, also a torque, and weights pull along -z.

    Raises:
        InputError: there is no load; one is none of these.

    >>> wrench_of([{"weight": 10, "at": (2, 1)}, {"force": ("1.5", 0), "at": (2, 3)}])
    (Fraction(3, 2), Fraction(-10, 1), Fraction(-49, 2))
    """
    if isinstance(loads, (Mapping, str)) or not hasattr(loads, "__iter__") or len(loads) == 0:
        raise InputError("", "loads", f"this is {found(loads)}",
                         'give a list of loads, such as [{"force": (0, -1), "at": (2, 0)}]')
    written = [_written(load, f"loads[{i}]") for i, load in enumerate(loads)]
    in_space = any(isinstance(value, list) and len(value) == 3
                   for load in written for value in load.values())
    text = json.dumps({"format": "stickslip-grasp/2", "contacts": [_IN_SPACE] if in_space else [],
                       "loads": written})
    return _core.parse_grasp(text.encode(), b"").wrench()


def _written(load: Any, place: str) -> Mapping[str, Any]:
    """As in a file, which judges it."""
    if not isinstance(load, Mapping):
        raise InputError("", place, f"this is {found(load)}",
                         'give a load, such as {"force": (0, -1), "at": (2, 0)}')
    return {str(key): _spelled(value, f"{place}.{key}") if key in _NUMBERS else None
            for key, value in load.items()}


def _spelled(value: Any, place: str) -> Any:
    array = as_array(value, place)
    if array.ndim == 0:
        return str(_core.exact(array.item(), place))
    return [_spelled(entry, f"{place}[{i}]") for i, entry in enumerate(array)]
