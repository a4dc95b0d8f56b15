# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers: plain immutable values, that can be compared and pickled.

``forces_float`` and its like are the fractions of ``forces`` as an array of the nearest doubles.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Dict, NamedTuple, Optional, Tuple, Union

from . import _core
from .grasp import Pair, Triple
from .views import Answer, FloatArray, FloatView, nearest_root


class ModelWarning(NamedTuple):
    """Where an exact answer may mislead (docs/model.md)."""

    trap: str  # "large-motion", "unbalanced-preload", "lost-preload" or "assumed-stiffness"
    text: str


@dataclass(frozen=True, repr=False)
class Decision(Answer):
    """A verdict with its evidence. Everything about motion and forces is None unless stable."""

    verdict: str
    """"stable", "unstable", or "undecided" when the node limit was reached."""
    engine: str
    normal_law: str
    wrench: Triple
    certificate: Optional[str] = field(default=None, repr=False)
    """The proof (certificate/FORMAT.md), for ``check`` and for both checkers. None if undecided."""
    twist: Optional[Triple] = None
    """The motion (x, y, r) of an equilibrium; there may be others."""
    forces: Optional[Tuple[Pair, ...]] = None
    """The force of each contact on the body, in the frame of the body."""
    coefficients: Optional[Tuple[Pair, ...]] = field(default=None, repr=False)
    """(a, b) for each contact: the force is a n + b t, with its normal n and the
    tangent t, n turned by +90 degrees. For unit normals, normal and tangential force."""
    slip: Optional[str] = None
    """One character a contact: "+" or "-" as it slips along t or against it, "0" as it sticks."""
    closed: Optional[Tuple[bool, ...]] = None
    """False where the contact has opened."""
    limit: Optional[str] = None
    """The limit that was reached, if undecided."""
    warnings: Tuple[ModelWarning, ...] = ()
    """What decide was asked to look for with ``warnings=True``."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)
    """Work counters of the engine; reproducible."""

    wrench_float = FloatView[FloatArray]("wrench", 3)
    twist_float = FloatView[Optional[FloatArray]]("twist", 3)
    forces_float = FloatView[Optional[FloatArray]]("forces", -1, 2)
    coefficients_float = FloatView[Optional[FloatArray]]("coefficients", -1, 2)


@dataclass(frozen=True, repr=False)
class SlipStates(Answer):
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


@dataclass(frozen=True, repr=False)
class Margin(Answer):
    """Exactly these multiples l >= 0 are resisted under wrench + l direction, and with preloads
    that grow in the preload direction."""

    resisted: Tuple[Tuple[Fraction, Optional[Fraction]], ...]
    """Closed intervals (low, high), increasing and disjoint; high is None for one without end."""
    direction: Optional[Triple]
    wrench: Triple
    normal_law: str
    certificate: str = field(repr=False)
    """The proof (certificate/FORMAT.md, section 5)."""
    preload_direction: Union[str, Tuple[Fraction, ...], None] = None
    """"scale", or one number for each contact."""
    warnings: Tuple[ModelWarning, ...] = ()
    """What margin was asked to look for with ``warnings=True``."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)

    @property
    def least(self) -> Optional[Fraction]:
        """The least multiple that is resisted; None if there is none. Not all above it need be."""
        return self.resisted[0][0] if self.resisted else None

    resisted_float = FloatView[FloatArray]("resisted", -1, 2)
    """An interval without end ends at infinity."""
    direction_float = FloatView[Optional[FloatArray]]("direction", 3)
    wrench_float = FloatView[FloatArray]("wrench", 3)


class Residual(NamedTuple):
    """The largest by which a claimed solution misses a condition; 0 if it misses none."""

    squared: Fraction
    """Its square: forces along a normal of irrational length are irrational themselves."""
    contact: Optional[int]
    """Where it occurs first; None if it is 0 everywhere."""

    @property
    def value(self) -> float:
        """The double nearest to the root."""
        return nearest_root(self.squared)

    def __repr__(self) -> str:
        return f"Residual(value={_core.readable_root(self.squared)}, contact={self.contact})"


@dataclass(frozen=True, repr=False)
class NearbyEquilibrium(Answer):
    """An exact equilibrium, for a claim "stable" with a solution."""

    twist: Triple
    forces: Tuple[Pair, ...] = field(repr=False)
    """On the body, in its frame."""
    from_claim: bool
    """Of the kind that the claim suggests; else it is the engine's own."""
    force_distance: Optional[Fraction]
    """Largest difference of a component from the claim; None where the claim has none."""
    twist_distance: Optional[Fraction]
    same_slip: Optional[bool]
    same_contacts: bool
    """Whether the same contacts bear force."""

    twist_float = FloatView[FloatArray]("twist", 3)
    forces_float = FloatView[FloatArray]("forces", -1, 2)


@dataclass(frozen=True, repr=False)
class CrossCheck(Answer):
    """Another program's answer, judged exactly. What the claim does not allow to say is None."""

    outcome: str
    """"right"; "tie", another verdict but within ``tie`` of a threshold; "wrong"; "undecided"."""
    decision: Decision
    """The exact verdict, with its evidence."""
    inaccurate: bool = False
    """Of a right "stable": the claimed solution misses a condition by more than ``tolerance``."""
    balance: Optional[Triple] = None
    """The wrench plus all claimed forces."""
    cone: Optional[Residual] = None
    """Friction beyond its cone, or a pull."""
    normal_law: Optional[Residual] = None
    """Normal forces that are not those of the springs at the claimed motion."""
    dissipation: Optional[Residual] = None
    """What friction falls short of the most it could take out, as a power."""
    claimed_slip: Optional[str] = None
    """The signs of slip of the claimed motion."""
    nearby: Optional[NearbyEquilibrium] = None
    distance: Optional[Fraction] = None
    """The smallest relative change of the load, along itself or one of six axes, that changes the
    verdict; found for disagreements, and for all with ``distances``. None also if none does."""
    distance_along_load: Optional[Fraction] = None

    balance_float = FloatView[Optional[FloatArray]]("balance", 3)


@dataclass(frozen=True, repr=False)
class CheckResult(Answer):
    """What the independent checker says of a certificate. True in a condition iff accepted."""

    accepted: bool
    # If accepted: the verdict that is proved, and the question that it answers.
    verdict: Optional[str] = None
    contacts: Optional[int] = None
    wrench: Optional[Triple] = None
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    normal_law: Optional[str] = None
    nodes: Optional[int] = None
    leaves: Optional[int] = None
    # Of a margin: exactly these multiples of the directions are resisted.
    direction: Optional[Triple] = None
    preload_direction: Union[str, Tuple[Fraction, ...], None] = None
    resisted: Optional[Tuple[Tuple[Fraction, Optional[Fraction]], ...]] = None
    # If rejected: the rule of certificate/FORMAT.md that does not hold, and where.
    rule: Optional[str] = None
    node: Optional[int] = None
    path: Optional[str] = None
    found: Optional[str] = None

    wrench_float = FloatView[Optional[FloatArray]]("wrench", 3)
    direction_float = FloatView[Optional[FloatArray]]("direction", 3)
    resisted_float = FloatView[Optional[FloatArray]]("resisted", -1, 2)

    def __bool__(self) -> bool:
        return self.accepted
