# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers: plain immutable values, that can be compared and pickled.

``forces_float`` and its like are the fractions of ``forces`` as an array of the nearest doubles.
"""

from __future__ import annotations

import importlib
import json
import operator
from dataclasses import dataclass, field, fields
from fractions import Fraction
from typing import (
    Any, Dict, Iterable, Mapping, NamedTuple, Optional, Sequence, Tuple, Type, TypeVar, Union, cast,
    overload,
)

import numpy as np
from numpy.typing import NDArray

from . import _core
from .errors import InputError, LimitReached
from .grasp import SNAPPED_WITHIN, Assembly, Grasp, Pair, SnappedNormal, Triple, Vector
from .views import Answer, FloatArray, FloatView, Picture, doubles, nearest_root, table

AnyAnswer = TypeVar("AnyAnswer")
_MOST_CONTACTS_TO_SHOW = 100  # in a notebook, unasked


def _is_shown(grasp: Grasp) -> bool:
    return len(grasp) <= _MOST_CONTACTS_TO_SHOW


def _picture_of(grasp: Grasp, answer: Union[Decision, BoxDecision], engine: str) -> Picture:
    return Picture(_core.ask(grasp._data, "picture", {
        "wrench": list(answer.wrench), "preload": answer.preload, "engine": engine,
        "bilateral": answer.normal_law == "bilateral", "limit": answer.limit}))


def _as_option(max_motion: Optional[Vector]) -> str:
    return "" if max_motion is None else ",".join(str(number) for number in max_motion)


class ModelWarning(NamedTuple):
    """Where an exact answer may mislead (docs/model.md)."""

    trap: str  # "large-motion", "unbalanced-preload", "lost-preload", "assumed-stiffness",
               # "reversed-contact" or "edge-balance"
    text: str


class Proof(NamedTuple):
    """A question and the proof of its answer, each as a file's text."""

    grasp: str
    """A grasp file, of a box one with intervals."""
    certificate: str
    """The proof (certificate/FORMAT.md)."""
    normal_law: str
    uncertain: str = ""
    """What a checker needs beside the file: of a ball of loads its option ``--uncertain``."""
    preload_direction: Union[str, Tuple[Fraction, ...], None] = None
    """Likewise, of multiples of preloads: as of ``check``."""

    @classmethod
    def of(cls, files: Mapping[str, Any], answer: Mapping[str, Any]) -> Proof:
        """The files that prove this answer."""
        return cls(normal_law=answer["normal_law"], **files)

    def check(self) -> CheckResult:
        """What the independent checker says of the two."""
        along = self.preload_direction
        return CheckResult(**_core.check(
            self.grasp.encode(), self.certificate.encode(), None, None,
            self.normal_law == "bilateral", None,
            list(along) if isinstance(along, tuple) else along, None, None, self.uncertain,
            "", b"<grasp>", b"<certificate>", None, []))

    def __repr__(self) -> str:
        return f"Proof({len(self.certificate)} characters)"


class Within(NamedTuple):
    """The answer to a second question, where rounding of the data alone decides the first one: with
    motions bounded by 1000 times what the load would press the softest contact, or under the
    nearest load that contacts oppose (docs/model.md)."""

    verdict: str
    max_motion: Optional[Vector]
    """The bound, a number for each coordinate of motions; None if the load is another."""
    wrench: Vector
    proof: Optional[Proof]
    """None if undecided."""


def answer_of(kind: Type[AnyAnswer], answer: Mapping[str, Any], **more: Any) -> AnyAnswer:
    """What of an answer in the command's words has the name of a field; ``more`` has others."""
    known = {one.name: answer[one.name] for one in fields(cast(Any, kind)) if one.name in answer}
    if known.get("warnings"):
        known["warnings"] = tuple(ModelWarning(**warning) for warning in known["warnings"])
    return kind(**{**known, **more})


def decision_of(grasp: Grasp, snapped: Tuple[SnappedNormal, ...],
                answer: Mapping[str, Any]) -> Decision:
    """A Decision, of what the library says of one question."""
    contacts, second = answer.get("contacts"), answer.get("within")
    more: Dict[str, Any] = {}
    if contacts is not None:
        more = {name: tuple(contact[key] for contact in contacts)
                for name, key in (("forces", "force"), ("closed", "closed"))}
        if any("moment" in contact for contact in contacts):
            none = (Fraction(0),) * 3
            more["moments"] = tuple(contact.get("moment", none) for contact in contacts)
        in_plane = all(len(contact["slip"]) == 1 for contact in contacts)
        more["slip"] = ("" if in_plane else " ").join(contact["slip"] for contact in contacts)
    if second is not None:
        proof = second.get("proof")
        more["within"] = Within(second["verdict"], second.get("max_motion"), second["wrench"],
                                proof and Proof.of(proof, second))
    return answer_of(Decision, answer, grasp=grasp, snapped=snapped, **more)


@dataclass(frozen=True, repr=False)
class Decision(Answer):
    """A verdict with its evidence. Everything about motion and forces is None unless stable."""

    verdict: str
    """"stable", "unstable", or "undecided" when the node limit was reached."""
    engine: str
    normal_law: str
    wrench: Vector
    grasp: Grasp = field(repr=False)
    """What was asked about, with the friction that was asked for."""
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    snapped: Tuple[SnappedNormal, ...] = ()
    """Normals given in doubles that were rounded to ones of rational length, 1e-12 away or less;
    ``grasp`` has them."""
    certificate: Optional[str] = field(default=None, repr=False)
    """The proof (certificate/FORMAT.md), for ``check`` and for both checkers. None if undecided."""
    twist: Optional[Vector] = None
    """The motion (x, y, r) of an equilibrium; there may be others. In space translation x, y, z and
    rotation x, y, z; of an Assembly a number for each of its ``coordinates``. None, and so the forces,
    where no equilibrium in fractions was found."""
    near: Optional[Vector] = None
    """Stable without a twist: a motion near that of an equilibrium. In space, and in the plane where
    an exact equilibrium would have numbers of many thousand digits (docs/python.md). If undecided, one
    at which the laws seem to hold in doubles."""
    forces: Optional[Tuple[Vector, ...]] = None
    """The force of each contact on the body, in the frame of the body; of an Assembly on the body
    ``of``."""
    moments: Optional[Tuple[Vector, ...]] = None
    """Of an Assembly with ``torsion``: the moment of each contact about its normal, a vector."""
    springs: Optional[Tuple[Fraction, ...]] = None
    """Of an Assembly: the torque, tension or force of each of its ``springs``."""
    coefficients: Optional[Tuple[Pair, ...]] = field(default=None, repr=False)
    """(a, b) for each contact: the force is a n + b t, with its normal n and the
    tangent t, n turned by +90 degrees. For unit normals, normal and tangential force. None in space."""
    slip: Optional[str] = None
    """One character a contact: "+" or "-" as it slips along t or against it, "0" as it sticks. In space
    two, of the default lines of ``find_states``, and a blank between contacts."""
    closed: Optional[Tuple[bool, ...]] = None
    """False where the contact has opened."""
    limit: Optional[str] = None
    """Why there is no answer, if undecided."""
    reason: Optional[str] = None
    """The same in one word, such as "nodes" or "degree" (docs/space.md, "My grasp is undecided")."""
    remedy: Optional[str] = None
    """What may help, if anything is known to."""
    max_motion: Optional[Vector] = None
    """The bound on motions, a number for each coordinate, if there is one."""
    within: Optional[Within] = None
    """The second answer, where only rounding of the data decides the first."""
    warnings: Tuple[ModelWarning, ...] = ()
    """What decide was asked to look for with ``warnings=True``."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)
    """Work counters of the engine; reproducible."""

    wrench_float = FloatView[FloatArray]("wrench")
    twist_float = FloatView[Optional[FloatArray]]("twist")
    near_float = FloatView[Optional[FloatArray]]("near")
    forces_float = FloatView[Optional[FloatArray]]("forces", -1, 2)
    coefficients_float = FloatView[Optional[FloatArray]]("coefficients", -1, 2)

    def plot(self) -> Picture:
        """The grasp, its load and the evidence, as ``plot_grasp`` draws them; if undecided there is
        none."""
        return _picture_of(self.grasp, self, self.engine)

    def check(self) -> CheckResult:
        """What the independent checker says of the certificate, to the same question.

        Raises:
            LimitReached: undecided, and so without a certificate.
        """
        if self.certificate is None:
            raise LimitReached(self.limit or "")
        return CheckResult(**_core.check(
            self.grasp.to_text().encode(), self.certificate.encode(), list(self.wrench),
            self.preload, self.normal_law == "bilateral", None, None, None, None,
            "", _as_option(self.max_motion), b"<grasp>", b"<certificate>", None, []))

    def _picture(self) -> Optional[Picture]:
        return self.plot() if _is_shown(self.grasp) else None


@dataclass(frozen=True)
class Samples:
    """Grasps drawn from a box at random, each decided, with a proof that was checked."""

    count: int
    seed: int
    stable: int
    unstable: int
    undecided: int
    share: Optional[Mapping[str, Fraction]] = None
    """With the given "confidence" from "low" to "high" of all grasps that are drawn so hold, and of one
    side "at_least" (Clopper and Pearson). None if none was drawn."""
    failures: Tuple[Proof, ...] = field(default=(), repr=False)
    """Those that are unstable."""


@dataclass(frozen=True, repr=False)
class BoxDecision(Answer):
    """A verdict about every grasp in a box, with its evidence."""

    verdict: str
    """"stable" or "unstable" throughout; "fragile", some are and some are not; or "undecided"."""
    engine: str
    normal_law: str
    wrench: Vector
    """In the middle."""
    uncertain: str
    """What was asked, as on the command line."""
    grasp: Grasp = field(repr=False)
    """In the middle."""
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    proof: Optional[Proof] = None
    """Of "stable" and "unstable"."""
    examples: Optional[Tuple[Proof, Proof]] = None
    """If fragile: a grasp of the box that is stable, and one that is not."""
    limit: Optional[str] = None
    """Why there is no answer, if undecided."""
    reason: Optional[str] = None
    """The same in one word, such as "nodes" or "degree" (docs/space.md, "My grasp is undecided")."""
    remedy: Optional[str] = None
    """What may help, if anything is known to."""
    near: Optional[Tuple[Fraction, ...]] = None
    """If undecided: a motion at which the laws seem to hold in doubles."""
    samples: Optional[Samples] = None
    """What samples say, if they were asked for and the box has not one verdict."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)
    """Work counters of the engine; reproducible."""

    wrench_float = FloatView[FloatArray]("wrench")

    @property
    def certificate(self) -> Optional[str]:
        """The proof. None of a fragile box, whose examples have one each, and if undecided."""
        return None if self.proof is None else self.proof.certificate

    def check(self) -> CheckResult:
        """What the independent checker says of the proof; of a fragile box, of its examples: the
        last, or the first one that is rejected.

        Raises:
            LimitReached: undecided, and so without a proof.
        """
        if self.examples is not None:
            stable = self.examples[0].check()
            return self.examples[1].check() if stable else stable
        if self.proof is None:
            raise LimitReached(self.limit or "")
        return self.proof.check()

    def plot(self) -> Picture:
        """The grasp in the middle, as ``plot_grasp`` draws it: with its own verdict, which in a
        fragile box is that of some grasps only; if undecided without evidence."""
        file = json.loads(self.grasp.to_text())
        box = "a fragile box" if self.verdict == "fragile" else "a box"
        file["name"] = f"{self.grasp.name or 'Grasp'}, in the middle of {box}"
        middle = Grasp.from_text(json.dumps(file))
        return _picture_of(middle, self, "auto")

    def _picture(self) -> Optional[Picture]:
        return self.plot() if _is_shown(self.grasp) else None


@dataclass(frozen=True, repr=False)
class Radius(Answer):
    """By which factor tolerances may grow before the verdict is another."""

    verdict: str
    """Of the grasp in the middle: "stable", "unstable", or "undecided"."""
    proved: Fraction
    """The largest factor with a proof for the whole box; 0 if there is none."""
    limit: Fraction
    """No larger factor was tried."""
    normal_law: str
    wrench: Triple
    uncertain: str
    """What was asked, as on the command line."""
    grasp: Grasp = field(repr=False)
    """In the middle."""
    refuted: Optional[Fraction] = None
    """The smallest factor with a counterexample. Between the two nothing is known."""
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    proof: Optional[Proof] = None
    """Of the box scaled by ``proved``. None if undecided."""
    counterexample: Optional[Proof] = None
    """A grasp of the box scaled by ``refuted``, and the proof of its verdict."""
    ended_by: Optional[str] = None
    """The time limit, if that ended the work: what is known by then is proved all the same."""

    wrench_float = FloatView[FloatArray]("wrench", 3)


@dataclass(frozen=True, repr=False)
class Quality(Answer):
    """How large a ball of loads around its own a grasp resists."""

    verdict: str
    """Of the load in the centre: "stable", "unstable", or "undecided"."""
    proved: Fraction
    """The radius of the largest ball that is proved to be resisted; 0 if none is."""
    limit: Fraction
    """No larger ball was tried."""
    length: Fraction
    """By which torques are divided."""
    scales: bool
    """Without load and preload a proof about one ball is about all: what is resisted has no end, or
    what is not is not resisted however small."""
    normal_law: str
    wrench: Vector
    """In the centre."""
    grasp: Grasp = field(repr=False)
    refuted: Optional[Fraction] = None
    """The radius of the smallest ball that is known to hold a load that is not resisted."""
    not_resisted: Optional[Vector] = None
    """That load."""
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    proof: Optional[Proof] = None
    """Of the ball of radius ``proved``."""
    ended_by: Optional[str] = None
    """The time limit, if that ended the work: what is known by then is proved all the same."""
    counterexample: Optional[Proof] = None
    """That ``not_resisted`` is not; or the load in the centre."""


@dataclass(frozen=True, repr=False)
class BestPreload(Answer):
    """Preloads of the least sum that hold loads; or those of a sum that resist the largest ball."""

    preloads: Optional[Vector]
    """One for each contact. None if none were found."""
    bound: Optional[Fraction]
    """No preloads of a smaller sum hold the loads; or with a budget, none resist a larger ball. 0, or
    None with a budget, if nothing is proved."""
    multiples: Tuple[Tuple[Fraction, Optional[Fraction]], ...]
    """Which multiples of the preloads hold; (low, high), high is None for one without end."""
    each_for_itself: bool
    """Whether preloads may differ in what multiple they are, between the first and the last."""
    normal_law: str
    grasp: Grasp = field(repr=False)
    """What was asked about."""
    radius: Optional[Fraction] = None
    """With a budget: of the ball of loads that is proved to be resisted."""
    refuted: Optional[Fraction] = None
    """With a budget: of one with a load that is not."""
    equal: Tuple[Tuple[int, ...], ...] = ()
    """Which contacts were to press alike."""
    looked: int = 0
    """Boxes of preloads that were looked at for the bound."""
    warnings: Tuple[ModelWarning, ...] = ()
    """That the preloads do not balance, if they do not."""
    proofs: Dict[str, Proof] = field(default_factory=dict, repr=False)
    """All proofs, by the names that ``stickslip preload --certificates`` gives them (docs/preload.md)."""
    ended_by: Optional[str] = None
    """The time limit, if that ended the work: what is known by then is proved all the same."""

    @property
    def sum(self) -> Optional[Fraction]:
        """Of the preloads."""
        return None if self.preloads is None else sum(self.preloads, Fraction())


class MapCell(NamedTuple):
    """A rectangle of a map, with one verdict for all grasps in it."""

    x: Tuple[Fraction, Fraction]
    """From and to, along the first axis."""
    y: Tuple[Fraction, Fraction]
    """Along the second axis."""
    verdict: str
    """"stable" or "unstable" throughout; or "undecided", where the finest cells have no proof."""
    proof: Optional[Proof] = None
    """If proofs were asked for, unless undecided."""


@dataclass(frozen=True, repr=False)
class StabilityMap(Answer):
    """Where in a plane of two numbers a grasp holds, proved cell by cell."""

    x: str
    """The axes, as they were asked for."""
    y: str
    normal_law: str
    wrench: Triple
    uncertain: str
    """How far numbers of every grasp may be off, as on the command line."""
    grasp: Grasp = field(repr=False)
    cells: Tuple[MapCell, ...] = field(repr=False)
    """They tile the rectangle of the axes."""
    picture: Picture = field(repr=False)
    ended_by: Optional[str] = None
    """The time limit, if that ended the work: what is known by then is proved all the same."""
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""

    def _picture(self) -> Optional[Picture]:
        return self.picture


class Decisions(Sequence[Decision]):
    """The answers to many questions, in their order. Each becomes a Decision when it is looked at;
    all of them do to be compared or pickled.

    >>> from stickslip import Grasp, decide
    >>> jaws = Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], friction="1/2", preload=1)
    >>> many = decide(jaws, [(0, 1, 0), (0, 2, 0)])
    >>> many
    Decisions(2 questions: 1 stable, 1 unstable)
    >>> many.stable
    array([ True, False])
    >>> bool(many[1].check())
    True
    """

    def __init__(self, data: _core.DecisionsData,
                 asked: Sequence[Tuple[Grasp, Tuple[SnappedNormal, ...]]]) -> None:
        self._data = data
        self._asked = asked  # of all or of each
        self.verdict: NDArray[np.str_] = np.array(data.verdicts(), dtype="<U9")
        """(n,), "stable", "unstable" or "undecided"."""
        self.engine: NDArray[np.str_] = np.array(data.engines(), dtype="<U16")
        """(n,), as of a Decision."""

    @property
    def undecided(self) -> NDArray[np.bool_]:
        """(n,), where the verdict is "undecided"."""
        return np.equal(self.verdict, "undecided")

    @property
    def stable(self) -> NDArray[np.bool_]:
        """(n,), True where the verdict is "stable", and False where it is "unstable".

        Raises:
            LimitReached: one is undecided, which is neither. ``verdict == "stable"`` is what is
                proved to be stable.
        """
        open_ones = np.count_nonzero(self.undecided)
        if open_ones > 0:
            raise LimitReached(f"{open_ones} of {len(self)} questions are undecided, and .undecided "
                               "says which; .verdict == 'stable' is where stability is proved")
        return np.equal(self.verdict, "stable")

    @property
    def wrench_float(self) -> FloatArray:
        """(n, 3), in space (n, 6), or a column for each of ``coordinates``: the loads in the nearest doubles."""
        return self._data.wrenches()

    @property
    def twist_float(self) -> FloatArray:
        """(n, 3), in space (n, 6): the motions of the equilibria in the nearest doubles; NaN where
        there is none, or none is known exactly."""
        return self._data.twists()

    @property
    def forces_float(self) -> FloatArray:
        """(n, m, 2), in space (n, m, 3): the forces of the contacts on the body in the nearest
        doubles; NaN where there are none, or none are known exactly, and beyond the last contact
        of a grasp that has fewer than another."""
        coordinates = self._asked[0][0]._coordinates if self._asked else 2
        forces = self._data.forces()
        contacts = max((len(grasp) for grasp, _ in self._asked), default=0)
        result = np.full((len(self), contacts, coordinates), np.nan)
        given = forces.reshape(len(self), forces.shape[1] // coordinates, coordinates)
        result[:, :given.shape[1]] = given
        return result

    def to_dataframe(self) -> Any:
        """A ``pandas.DataFrame`` with a row for each question: verdict, engine, why it is undecided
        (``limit``), and in doubles the load and the motion that holds it."""
        pandas = importlib.import_module("pandas")
        of = self._asked[0][0] if self._asked else None
        wrench, motion = (
            tuple(tuple(f"{name}_{c}" for c in of.coordinates) for name in ("load", "motion"))
            if isinstance(of, Assembly) else
            (("force_x", "force_y", "torque"), ("motion_x", "motion_y", "rotation"))
            if self.twist_float.shape[1] == 3 else
            tuple(tuple(f"{name}_{axis}" for name in names for axis in "xyz")
                  for names in (("force", "torque"), ("motion", "rotation"))))
        limits = [limit or None for limit in self._data.limits()]
        return pandas.DataFrame({
            "verdict": self.verdict, "engine": self.engine, "limit": limits,
            **dict(zip(wrench, self.wrench_float.T)), **dict(zip(motion, self.twist_float.T))})

    def __len__(self) -> int:
        return self._data.size()

    @overload
    def __getitem__(self, index: int) -> Decision: ...

    @overload
    def __getitem__(self, index: slice) -> Tuple[Decision, ...]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Decision, Tuple[Decision, ...]]:
        if isinstance(index, slice):
            return tuple(self[i] for i in range(*index.indices(len(self))))
        i = operator.index(index)
        if not -len(self) <= i < len(self):
            raise IndexError(f"there are {len(self)} decisions")
        data, fields = self._data.at(i % len(self))
        grasp, snapped = self._asked[0 if len(self._asked) == 1 else i % len(self)]
        return decision_of(Grasp._of(data, grasp._loaded), snapped, fields)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Decisions):
            return NotImplemented
        return np.array_equal(self.verdict, other.verdict) and tuple(self) == tuple(other)

    def __hash__(self) -> int:
        return hash(self.verdict.tobytes())

    def _counts(self) -> Tuple[Tuple[str, int], ...]:
        verdicts, counts = np.unique(self.verdict, return_counts=True)
        return tuple(zip(verdicts.tolist(), counts.tolist()))

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {verdict}" for verdict, count in self._counts())
        return f"Decisions({len(self)} questions{': ' if counts else ''}{counts})"

    def _repr_html_(self) -> str:
        return table([("questions", str(len(self)))] + [
            (verdict, str(count)) for verdict, count in self._counts()])


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
    grasp: Grasp = field(repr=False)
    """Whose states they are."""
    states: Optional[Tuple[str, ...]] = field(default=None, repr=False)
    """Sorted; one character a contact: "+", "-" or "0". None if they were not asked for."""

    def plot(self) -> Picture:
        """The sphere of motions with its cells, as ``plot_states`` draws it."""
        return Picture(_core.ask(self.grasp._planar(), "states picture", {"modes": "slip"}))

    def _picture(self) -> Optional[Picture]:
        return self.plot() if self.circles <= _MOST_CONTACTS_TO_SHOW else None


class Cell(NamedTuple):
    """The hull of points and directions of a plane: a polygon, a segment, a ray, ..."""

    vertices: Tuple[Pair, ...]
    """Counterclockwise."""
    rays: Tuple[Pair, ...]
    """Directions in which it has no end."""

    @property
    def vertices_float(self) -> FloatArray:
        """(n, 2), in the nearest doubles."""
        return doubles(self.vertices, -1, 2)


class Outline(NamedTuple):
    """A border of an area, which lies to its left."""

    vertices: Tuple[Pair, ...]
    start: Optional[Pair] = None
    """The direction at infinity from which an open border comes; None if it is closed."""
    end: Optional[Pair] = None
    """The direction in which an open border goes."""

    @property
    def vertices_float(self) -> FloatArray:
        """(n, 2), in the nearest doubles."""
        return doubles(self.vertices, -1, 2)


class Piece(NamedTuple):
    """What is resisted in one contact mode."""

    slip: str
    """As in Decision; ``0`` also where a contact has no force, or no friction."""
    closed: Tuple[bool, ...]
    """Which contacts have a force."""
    cell: Cell


@dataclass(frozen=True, repr=False)
class Region(Answer):
    """Exactly these wrenches origin + s u + t v are resisted, in coordinates (s, t)."""

    areas: Tuple[Tuple[Outline, ...], ...]
    """The interior in its connected parts, each by its borders; none for the whole plane."""
    curves: Tuple[Cell, ...]
    """Segments, rays and lines outside of the areas."""
    points: Tuple[Pair, ...]
    """Outside of the areas and curves."""
    whole_plane: bool
    origin: Triple
    u: Triple
    v: Triple
    normal_law: str
    grasp: Grasp = field(repr=False)
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    snapped: Tuple[SnappedNormal, ...] = ()
    """Normals given in doubles that were rounded to ones of rational length, 1e-12 away or less;
    ``grasp`` has them."""
    pieces: Tuple[Piece, ...] = field(default=(), repr=False)
    """If they were asked for: one for each contact mode that resists something. Their union is the
    region."""
    certificate: Optional[str] = field(default=None, repr=False)
    """The proof, if asked for with ``certificate=True`` (certificate/FORMAT.md, section 12)."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)

    points_float = FloatView[FloatArray]("points", -1, 2)

    def check(self) -> CheckResult:
        """What the independent checker says of the certificate, to the same question.

        Raises:
            InputError: it was not asked for.
        """
        if self.certificate is None:
            raise InputError("", "certificate", "the region has none",
                             "ask for it by region(..., certificate=True)")
        return CheckResult(**_core.check(
            self.grasp.to_text().encode(), self.certificate.encode(), list(self.origin),
            self.preload, self.normal_law == "bilateral", None, None,
            [list(self.u), list(self.v)], None, "", "", b"<grasp>", b"<certificate>", None, []))

    def plot(self) -> Picture:
        """As ``plot_region`` draws it."""
        return Picture(_core.ask(self.grasp._planar(), "region", {
            "origin": list(self.origin), "u": list(self.u), "v": list(self.v),
            "preload": self.preload, "bilateral": self.normal_law == "bilateral", "pieces": False,
            "mode_limit": 0, "node_limit": 0, "certificate": False, "picture": True})["picture"])

    def _picture(self) -> Optional[Picture]:
        return self.plot()

    def _shown_fields(self) -> Iterable[Tuple[str, Any]]:
        """Polygons in place of the tuples that hold them."""
        for name, value in super()._shown_fields():
            yield name, len(value) if name in ("areas", "curves") else value


@dataclass(frozen=True, repr=False)
class Margin(Answer):
    """Exactly these multiples l >= 0 are resisted under wrench + l direction, and with preloads
    that grow in the preload direction; if there is ``refuted``, these are, and those in it are not."""

    resisted: Tuple[Tuple[Fraction, Optional[Fraction]], ...]
    """Closed intervals (low, high), increasing and disjoint; high is None for one without end."""
    direction: Optional[Vector]
    wrench: Vector
    normal_law: str
    grasp: Grasp = field(repr=False)
    """What was asked about."""
    certificate: str = field(repr=False)
    """The proof (certificate/FORMAT.md, section 5)."""
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    preload_direction: Union[str, Tuple[Fraction, ...], None] = None
    """"scale", or one number for each contact."""
    warnings: Tuple[ModelWarning, ...] = ()
    """What margin was asked to look for with ``warnings=True``."""
    snapped: Tuple[SnappedNormal, ...] = ()
    """Normals given in doubles that were rounded to ones of rational length, 1e-12 away or less;
    ``grasp`` has them."""
    refuted: Optional[Tuple[Tuple[Fraction, Optional[Fraction]], ...]] = None
    """Multiples between these are not resisted. Of what is in neither nothing is known. None where
    ``resisted`` is exact: in the plane, of one body, without a bound on motions, and with rational
    lengths of normals that preloads act along."""
    max_motion: Optional[Vector] = None
    """The bound on motions, a number for each coordinate, if there is one."""
    within: Optional[Margin] = None
    """The second answer, where only rounding of the data decides the first: within 1000 times the
    natural motion, and along the nearest direction that contacts oppose (docs/model.md)."""
    ended_by: Optional[str] = None
    """The time limit, if that ended the work: what is known by then is proved all the same."""
    stats: Dict[str, int] = field(default_factory=dict, repr=False, compare=False)

    def check(self) -> CheckResult:
        """What the independent checker says of the certificate, to the same question."""
        along = self.preload_direction
        return CheckResult(**_core.check(
            self.grasp.to_text().encode(), self.certificate.encode(), list(self.wrench),
            self.preload, self.normal_law == "bilateral",
            None if self.direction is None else list(self.direction),
            list(along) if isinstance(along, tuple) else along, None, None, "",
            _as_option(self.max_motion), b"<grasp>", b"<certificate>", None, []))

    @property
    def least(self) -> Optional[Fraction]:
        """The least multiple that is resisted; None if there is none. Not all above it need be."""
        return self.resisted[0][0] if self.resisted else None

    resisted_float = FloatView[FloatArray]("resisted", -1, 2)
    """An interval without end ends at infinity."""
    refuted_float = FloatView[Optional[FloatArray]]("refuted", -1, 2)
    direction_float = FloatView[Optional[FloatArray]]("direction")
    wrench_float = FloatView[FloatArray]("wrench")


class Residual(NamedTuple):
    """The largest by which a claimed solution misses a condition; 0 if it misses none."""

    squared: Union[Fraction, Tuple[Fraction, Fraction]]
    """Its square: forces along a normal of irrational length are irrational themselves. Two numbers
    that this lies between where even the square is irrational, as in space it may be."""
    contact: Optional[int]
    """Where it occurs first; None if it is 0 everywhere."""

    @property
    def value(self) -> float:
        """The double nearest to the root; of two numbers, to that of the lower one."""
        return nearest_root(self.squared[0] if isinstance(self.squared, tuple) else self.squared)

    def __repr__(self) -> str:
        square = self.squared[0] if isinstance(self.squared, tuple) else self.squared
        value = _core.readable_root(square)
        rounded = isinstance(self.squared, tuple) and not value.startswith("~")
        return f"Residual(value={'~' if rounded else ''}{value}, contact={self.contact})"


# A number that is known exactly, or two that it lies between; None: no upper one is known.
Distance = Union[Fraction, Tuple[Fraction, Optional[Fraction]]]


@dataclass(frozen=True, repr=False)
class NearbyEquilibrium(Answer):
    """An exact equilibrium, for a claim "stable" with a solution."""

    twist: Vector
    forces: Tuple[Vector, ...] = field(repr=False)
    """On the body, in its frame."""
    from_claim: bool
    """Of the kind that the claim suggests; else it is the engine's own."""
    force_distance: Optional[Fraction]
    """Largest difference of a component from the claim; None where the claim has none."""
    twist_distance: Optional[Fraction]
    same_slip: Optional[bool]
    same_contacts: bool
    """Whether the same contacts bear force."""

    twist_float = FloatView[FloatArray]("twist")
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
    balance: Optional[Vector] = None
    """The wrench plus all claimed forces."""
    cone: Optional[Residual] = None
    """Friction beyond its cone, or a pull."""
    normal_law: Optional[Residual] = None
    """Normal forces that are not those of the springs at the claimed motion."""
    dissipation: Optional[Residual] = None
    """What friction falls short of the most it could take out, as a power."""
    claimed_slip: Optional[str] = None
    """The signs of slip of the claimed motion; in space "+" wherever there is slip."""
    nearby: Optional[NearbyEquilibrium] = None
    """None also where a stable verdict is proved without an exact equilibrium."""
    distance: Optional[Distance] = None
    """The smallest relative change of the load, along itself or one of six axes, that changes the
    verdict; found for disagreements, and for all with ``distances``. None also if none does. In
    space the smallest change of any kind lies between these two; None is not known."""
    distance_along_load: Optional[Distance] = None
    """The same along the load alone, in space between these two."""

    balance_float = FloatView[Optional[FloatArray]]("balance")


class Method(NamedTuple):
    """What one method says of the question."""

    method: str
    source: str
    """Who proposed it."""
    about_the_load: bool
    """Else it asks about the grasp, whatever the load."""
    verdict: str
    """In the method's own terms, or "not computed" where that would take too long."""
    agrees: Optional[bool]
    """Whether it says of the load what the passive model says; None where that has no meaning."""
    why: str
    evidence: Any
    """As in ``stickslip compare --json``; rationals are strings."""


@dataclass(frozen=True)
class ClassRange:
    """Multiples of a load, or factors of friction, from low to high, that are all of one class."""

    load_class: Optional[str]
    """"must move", "must hold" or "open"; of factors None where it is not known."""
    low: Fraction
    high: Optional[Fraction]
    """None: without end."""
    has_low: bool
    """Whether low is one of them; else it ends the range before."""
    has_high: bool
    """The same of high."""


@dataclass(frozen=True)
class StaticForce:
    """The force of a contact, ratchet or spring by statics, over the length of the normal."""

    contact: int
    normal: Fraction
    friction: Vector
    """The coefficient of the tangent in the plane, else a vector across the normal."""


@dataclass(frozen=True)
class StaticMultiples:
    """Which multiples of a direction may stand, and which must move."""

    stand: Optional[Tuple[Optional[Fraction], Optional[Fraction]]]
    """From the one to the other; None for an end that there is not, or if none is known."""
    below: Optional[Fraction]
    """Those below it must move."""
    above: Optional[Fraction]
    """Those above it must move."""
    always_moves: bool


@dataclass(frozen=True, repr=False)
class Statics(Answer):
    """What statics says of a grasp, for any stiffness and preloads."""

    grasp: Grasp = field(repr=False)
    wrench: Vector
    load_class: Optional[str] = None
    """"may stand" or "must move" of one load; else None."""
    reason: Optional[str] = None
    """Why it is not known, if so."""
    forces: Tuple[StaticForce, ...] = field(default=(), repr=False)
    """Some with which it may stand: those that are not 0."""
    motion: Optional[Vector] = field(default=None, repr=False)
    """One along which it must move, and with the least friction, at the lower end."""
    least_friction: Optional[Tuple[Fraction, Fraction]] = None
    """It must move with all friction times the first, unless that is 0, and may stand with it
    times the second."""
    multiples: Optional[StaticMultiples] = None
    """Those of one direction."""
    stand: Tuple[Tuple[Vector, Tuple[StaticForce, ...]], ...] = field(default=(), repr=False)
    """Load points (h, l) with forces: l may stand if (1, l) is a sum of multiples of these."""
    move: Tuple[Vector, ...] = field(default=(), repr=False)
    """Motions: loads that do work on one must move."""
    exact: Optional[bool] = None
    """Whether the two leave no load out, of many loads."""
    complete: Optional[bool] = None
    """Whether they leave out no more than the accuracy."""
    certificates: Mapping[str, str] = field(default_factory=dict, repr=False)
    """By name, if they were asked for: "statics", or "moves" and "stands" of the least friction."""

    def __repr__(self) -> str:
        if self.least_friction is not None:
            low, high = map(float, self.least_friction)
            return f"least friction: {low:g} to {high:g} times what it is"
        if self.multiples is not None:
            return repr(self.multiples)
        if self.exact is not None:
            return f"loads: {len(self.stand)} that may stand, {len(self.move)} motions"
        return self.load_class or f"undecided: {self.reason}"


@dataclass(frozen=True, repr=False)
class Comparison(Answer):
    """The passive model, first, and earlier methods on one question; all of them exact."""

    methods: Tuple[Method, ...]
    load_class: Optional[str]
    """What rigid contacts do: "must move", "must hold" or "open"; None if the methods that were
    asked do not tell."""
    grasp: Grasp = field(repr=False)
    snapped: Tuple[SnappedNormal, ...] = ()
    """Normals given in doubles that were rounded to ones of rational length, 1e-12 away or less;
    ``grasp`` has them."""
    certificate: Optional[str] = field(default=None, repr=False)
    """That of the class, if it was asked for."""

    def __getitem__(self, method: str) -> Method:
        """By its name."""
        for row in self.methods:
            if row.method == method:
                return row
        raise KeyError(method)

    def __repr__(self) -> str:
        known = [] if self.methods else [f"load class: {self.load_class}"]
        return "\n".join(known + [f"{row.method}: {row.verdict}; {row.why}" for row in self.methods])

    def _repr_html_(self) -> str:
        agrees = {True: "yes", False: "no", None: ""}
        return table([("method", "verdict", "agrees", "why")] + [
            (row.method, row.verdict, agrees[row.agrees], row.why) for row in self.methods])


@dataclass(frozen=True, repr=False)
class CheckResult(Answer):
    """What the independent checker says of a certificate. True in a condition iff accepted."""

    accepted: bool
    # If accepted: the verdict that is proved, and the question that it answers.
    verdict: Optional[str] = None
    contacts: Optional[int] = None
    wrench: Optional[Vector] = None
    preload: Optional[Fraction] = None
    """Set if it replaced the grasp's preloads."""
    normal_law: Optional[str] = None
    nodes: Optional[int] = None
    leaves: Optional[int] = None
    # Of a margin: exactly these multiples of the directions are resisted.
    direction: Optional[Vector] = None
    preload_direction: Union[str, Tuple[Fraction, ...], None] = None
    resisted: Optional[Tuple[Tuple[Fraction, Optional[Fraction]], ...]] = None
    # Of a region: exactly the wrenches of the plane in so many pieces of the certificate are.
    plane: Optional[Tuple[Vector, Vector]] = None
    pieces: Optional[int] = None
    # Of a robustness: it is not below the first and not above the second.
    bounds: Optional[Tuple[Fraction, Fraction]] = None
    # Of slip states: so many there are, of motions of 0, 1, ... dimensions.
    by_dimension: Optional[Tuple[int, ...]] = None
    # If rejected: the rule of certificate/FORMAT.md that does not hold, and where.
    rule: Optional[str] = None
    node: Optional[int] = None
    path: Optional[str] = None
    found: Optional[str] = None

    wrench_float = FloatView[Optional[FloatArray]]("wrench")
    direction_float = FloatView[Optional[FloatArray]]("direction")
    resisted_float = FloatView[Optional[FloatArray]]("resisted", -1, 2)
    bounds_float = FloatView[Optional[FloatArray]]("bounds", 2)

    def __bool__(self) -> bool:
        return self.accepted
