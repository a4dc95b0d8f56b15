# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip states and contact modes in space and of several bodies, as arrays."""

import os
import queue
import threading
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from .arguments import as_count, one_of
from .errors import InputError
from .grasp import Grasp

NO_SIGN = 2
"""In arrays of signs: a line of slip of a contact that opens."""


@dataclass(frozen=True)
class StatesChunk:
    """Some states, one a row; arrays belong to the caller."""

    signs: NDArray[np.int8]
    """(n, planes): 1, -1 or 0 for each row of ``States.rows``, ``NO_SIGN`` where it does not count."""
    dimensions: NDArray[np.int8]
    """(n,): the dimension of the motions with these signs."""
    motions: NDArray[Any]
    """(n, coordinates): a motion of each, in integers; of ints of Python if some are longer than 64 bits."""

    def __len__(self) -> int:
        return len(self.dimensions)


@dataclass(frozen=True)
class StateCounts:
    """How many states there are."""

    by_dimension: Tuple[int, ...]
    """States whose motions have the dimension 0, 1, ..."""
    distinct_states: int
    rank: int
    """Of all rows."""
    distinct_planes: int
    warnings: Tuple[str, ...] = ()
    """That planes nearly coincide, so that rounding decides what the states are."""


class States:
    """The states of a grasp. Iterating finds them, and gives ``StatesChunk`` after chunk; nothing is kept.

    >>> cube = Grasp([[-1, -1, 0], [-1, 1, 0], [1, -1, 0], [1, 1, 0]], [[0, 0, 1]] * 4, "1/2")
    >>> modes = find_states(cube, modes="cs")
    >>> modes.count().by_dimension
    (0, 0, 0, 1, 4, 4, 1)
    >>> sum(len(chunk) for chunk in modes)
    10
    """

    def __init__(self, grasp: Grasp, options: Dict[str, Any], chunk: int) -> None:
        self._grasp, self._options, self._chunk = grasp, options, chunk
        head = _core.state_rows(grasp._data, options)
        self.coordinates: int = head["coordinates"]
        """Of motions: 6 in space, translation and rotation about the origin; 3 in the plane."""
        self.planes: Tuple[Tuple[int, Optional[int]], ...] = tuple((row["contact"], row["line"]) for row in head["rows"])
        """The contact of each row, and which of its lines; None is its normal."""
        self.rows: Tuple[Tuple[Fraction, ...], ...] = tuple(tuple(row["row"]) for row in head["rows"])
        """Rows a: their signs are those of a . motion, whole numbers."""

    def count(self) -> StateCounts:
        """The counts, in about half of the time of a walk."""
        counts = _core.state_counts(self._grasp._data, self._options)
        return StateCounts(tuple(counts["by_dimension"]), counts["distinct_states"], counts["rank"],
                           counts["distinct_planes"], tuple(counts.get("warnings", ())))

    def write_certificate(self, path: Union[str, "os.PathLike[str]"], threads: int = 0) -> None:
        """Writes a proof that there are no other states, for ``check`` with ``states``, ``stickslip-check`` and
        ``check.py``, and these modes: "slip", "full" or "closed", of all dimensions. The file stays as it was
        if that is interrupted."""
        _core.prove_states(self._grasp._data, self._options, os.fspath(path), as_count("threads", threads))

    def __iter__(self) -> Iterator[StatesChunk]:
        ready: "queue.Queue[Any]" = queue.Queue(maxsize=2)
        ended = threading.Event()

        def put(item: Any) -> bool:
            while not ended.is_set():
                try:
                    ready.put(item, timeout=0.05)
                    return True
                except queue.Full:
                    pass
            return False

        def take(arrays: Any) -> bool:
            return not ended.is_set() if arrays is None else put(StatesChunk(*arrays))

        def work() -> None:
            try:
                _core.find_states(self._grasp._data, self._options, self._chunk, take)
                put(None)
            except BaseException as error:  # for the thread that iterates
                put(error)

        worker = threading.Thread(target=work, daemon=True)
        worker.start()
        try:
            while True:
                item = ready.get()
                if item is None:
                    return
                if isinstance(item, BaseException):
                    raise item
                yield item
        finally:
            ended.set()
            worker.join()


def find_states(
    grasp: Grasp,
    *,
    modes: str = "slip",
    lines: int = 0,
    snap: bool = False,
    directions: Any = None,
    at_least_closed: Optional[int] = None,
    dimension: Optional[int] = None,
    chunk: int = 65536,
) -> States:
    """Slip states and contact modes of a grasp in space or the plane, of one body or several.

    Args:
        grasp: its positions and normals matter, nothing else.
        modes: "slip", the signs of slip of all motions, as if no contact opened; "full", those and the
            signs of N.d; "closed", slip while all contacts stay closed; "cs", which contacts open by
            motions that press nothing together; "ss", contact modes: those and the slip of the closed ones.
        lines: of slip of each contact in space; 0 is 2, across the normal and each other.
        snap: take rational directions near those that are irrational.
        directions: in place of ``lines``, a list for each contact of vectors across its normal.
        at_least_closed: with "cs" or "ss", only modes in which so many contacts stay closed.
        dimension: only states whose motions have this dimension.
        chunk: how many states come at once.

    Raises:
        InputError: lines with irrational directions without ``snap``, directions that are not across
            their normal, motions of more than 12 coordinates.
    """
    if not isinstance(grasp, Grasp):
        raise InputError("", "grasp", "this is no grasp", "give a stickslip.Grasp; Grasp.from_file reads one")
    chosen: Optional[List[List[List[Any]]]] = None
    if directions is not None:
        chosen = [[list(vector) for vector in of_contact] for of_contact in directions]
    return States(grasp, {
        "modes": one_of("modes", modes, ("slip", "full", "closed", "cs", "ss")),
        "lines": as_count("lines", lines, 64), "snap": bool(snap), "directions": chosen,
        "at_least_closed": None if at_least_closed is None else as_count("at_least_closed", at_least_closed),
        "dimension": None if dimension is None else as_count("dimension", dimension),
    }, max(1, as_count("chunk", chunk)))


__all__ = ["NO_SIGN", "StateCounts", "States", "StatesChunk", "find_states"]
