# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers: plain immutable values, that can be compared and pickled."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Dict, NamedTuple, Optional, Tuple

from .grasp import Pair, Triple


class SnappedNormal(NamedTuple):
    """A contact whose normal was replaced by a rational unit vector."""

    contact: int
    normal: Pair
    moved_at_most: str  # a decimal, rounded up


@dataclass(frozen=True)
class Decision:
    """A verdict with its evidence. Everything about motion and forces is None unless stable."""

    verdict: str
    """"stable", "unstable", or "undecided" when the node limit was reached."""
    engine: str
    normal_law: str
    wrench: Triple
    snapped_normals: Tuple[SnappedNormal, ...]
    certificate: Optional[str] = field(default=None, repr=False)
    """The proof (certificate/FORMAT.md), for ``check`` and for both checkers. None if undecided."""
    twist: Optional[Triple] = None
    """The motion (x, y, r) of an equilibrium; there may be others."""
    forces: Optional[Tuple[Pair, ...]] = None
    """The force of each contact on the body, in the frame of the body."""
    coefficients: Optional[Tuple[Pair, ...]] = None
    """(a, b) for each contact: the force is a n + b t, with its normal n (as snapped) and the
    tangent t, n turned by +90 degrees. For unit normals, normal and tangential force."""
    slip: Optional[str] = None
    """One character a contact: "+" or "-" as it slips along t or against it, "0" as it sticks."""
    closed: Optional[Tuple[bool, ...]] = None
    """False where the contact has opened."""
    limit: Optional[str] = None
    """The limit that was reached, if undecided."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)
    """Work counters of the engine; reproducible."""


@dataclass(frozen=True)
class SlipStates:
    """Slip states consistent with rigid motion, and counts of the arrangement's cells."""

    contacts: int
    circles: int
    rank: int
    vertices: int
    edges: int
    faces: int
    cells: int
    """vertices + edges + faces, #(S) in Table II of the paper."""
    distinct_states: int
    """All-stick included; differs from ``cells``."""
    engine: str
    states: Optional[Tuple[str, ...]] = field(default=None, repr=False)
    """Sorted; one character a contact: "+", "-" or "0". None if they were not asked for."""


@dataclass(frozen=True)
class Margin:
    """Exactly these multiples l >= 0 are resisted under wrench + l direction."""

    resisted: Tuple[Tuple[Fraction, Optional[Fraction]], ...]
    """Closed intervals (low, high), increasing and disjoint; high is None for one without end."""
    direction: Triple
    wrench: Triple
    normal_law: str
    snapped_normals: Tuple[SnappedNormal, ...]
    certificate: str = field(repr=False)
    """The proof (certificate/FORMAT.md, section 10)."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)


@dataclass(frozen=True)
class CheckResult:
    """What the independent checker says of a certificate. True in a condition iff accepted."""

    accepted: bool
    # If accepted: the verdict that is proved, and the question that it answers.
    verdict: Optional[str] = None
    contacts: Optional[int] = None
    wrench: Optional[Triple] = None
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    normal_law: Optional[str] = None
    snapped: Optional[int] = None
    """The number of normals that were replaced."""
    snapped_by_at_most: Optional[str] = None
    nodes: Optional[int] = None
    leaves: Optional[int] = None
    voids: Optional[int] = None
    # Of a margin: exactly these multiples of the direction are resisted.
    direction: Optional[Triple] = None
    resisted: Optional[Tuple[Tuple[Fraction, Optional[Fraction]], ...]] = None
    # If rejected: the rule of certificate/FORMAT.md that does not hold, and where.
    rule: Optional[str] = None
    node: Optional[int] = None
    path: Optional[str] = None
    found: Optional[str] = None

    def __bool__(self) -> bool:
        return self.accepted
