# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be asked about a grasp. Every answer is exact.

Long work runs without Python's global lock, so that other threads go on. Ctrl-C breaks it off;
``node_limit`` bounds it.
"""

from __future__ import annotations

import json
import os
from decimal import Decimal
from fractions import Fraction
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Type, TypeVar, Union, overload

import numpy as np

from . import _core
from .arguments import (
    WRENCHES,
    as_array,
    as_content,
    as_count,
    as_engine,
    as_inertia,
    as_json,
    as_list,
    as_max_motion,
    as_number,
    as_number_or_none,
    as_numbers,
    as_time_limit,
    as_plane_or_none,
    as_preload_direction_or_none,
    as_row_or_none,
    as_uncertain,
    as_wrench,
    found,
    is_bilateral,
    one_of,
)
from .errors import InputError
from .grasp import Assembly, Grasp, SnappedNormal, Vector
from .results import (
    BestPreload,
    BoxDecision,
    Cell,
    CheckResult,
    ClassRange,
    Comparison,
    CrossCheck,
    Decision,
    Decisions,
    MapCell,
    Margin,
    Method,
    NearbyEquilibrium,
    Outline,
    Piece,
    Proof,
    Quality,
    StaticForce,
    StaticMultiples,
    Statics,
    Radius,
    Region,
    Residual,
    Samples,
    SlipStates,
    StabilityMap,
    answer_of,
    decision_of,
)
from .views import Picture

AnyAnswer = TypeVar("AnyAnswer")
Number = Union[int, float, str, Fraction, Decimal]
OneWrench = Union[Tuple[Any, Any, Any], Tuple[Any, Any, Any, Any, Any, Any], Vector,
                  Tuple[Number, ...]]


@overload
def decide(
    grasp: Grasp,
    wrench: Optional[OneWrench] = None,
    *,
    friction: Optional[Number] = None,
    preload: Optional[Number] = None,
    normal_law: str = "unilateral",
    engine: str = "auto",
    node_limit: int = 0,
    time_limit: Number = 0,
    threads: int = 0,
    warnings: bool = False,
    max_motion: Any = None,
) -> Decision: ...


@overload
def decide(
    grasp: Grasp,
    wrench: Any = None,
    *,
    uncertain: Union[str, Mapping[str, Number]],
    friction: Optional[Number] = None,
    preload: Optional[Number] = None,
    normal_law: str = "unilateral",
    engine: str = "auto",
    node_limit: int = 0,
    time_limit: Number = 0,
    threads: int = 0,
    warnings: bool = False,
    max_motion: Any = None,
    samples: int = 0,
    seed: int = 1,
) -> BoxDecision: ...


@overload
def decide(
    grasp: Any,
    wrench: Any = None,
    *,
    friction: Any = None,
    preload: Any = None,
    normal_law: str = "unilateral",
    engine: str = "auto",
    node_limit: int = 0,
    time_limit: Number = 0,
    threads: int = 0,
    warnings: bool = False,
    max_motion: Any = None,
) -> Union[Decision, Decisions]: ...


def decide(
    grasp: Any,
    wrench: Any = None,
    *,
    uncertain: Any = None,
    friction: Any = None,
    preload: Any = None,
    normal_law: str = "unilateral",
    engine: str = "auto",
    node_limit: int = 0,
    time_limit: Number = 0,
    threads: int = 0,
    warnings: bool = False,
    max_motion: Any = None,
    samples: int = 0,
    seed: int = 1,
) -> Union[Decision, Decisions, BoxDecision]:
    """Will the grasp hold its load passively? A verdict, with evidence.

    Of ``grasp``, ``wrench``, ``friction`` and ``preload`` each may be one or n, as NumPy
    broadcasts. If any is n, n questions are asked, on all cores, and the answer is a ``Decisions``.

    Args:
        grasp: what is asked about, or a sequence of n grasps.
        wrench: (3,) or (n, 3), force x, force y and torque about the origin, applied to the
            body; the grasp's own if None. In space (6,) or (n, 6), as of a Grasp. ``wrench_of``
            sums forces at points and weights. Of an Assembly a number for each of its ``coordinates``.
        uncertain: how far numbers may be off, by kind, such as {"friction": "10%", "wrench": 0.1}
            or "friction=10%": the verdict is then a ``BoxDecision`` about all grasps in the box
            (docs/uncertainty.md). {} encloses the irrational lengths of preloaded normals, and
            nothing else is off. Of one question; the engine is one for boxes.
        friction: of every contact, one number or (n,); (n, m) gives each contact its own. The
            grasp's own if None.
        preload: of every contact, one number or (n,); the grasp's own if None.
        normal_law: "unilateral", contacts may open, c_n = max(0, P - k N.d); or "bilateral", the
            paper's Eq. 4 literally, c_n = P - k N.d >= 0.
        engine: "states" solves the systems of all slip states, in groups, "branch-and-bound" is
            made for many contacts, "auto" takes the one that suits. All are exact. In space, and
            of several bodies, there is one.
        node_limit: let the engine "branch-and-bound" give up, undecided, after so many nodes; 0 is no limit.
            In space 0 is one with which twelve contacts take about a minute at most.
        time_limit: in seconds, fractions too: answer then what is known by then; 0 is no limit. Of one
            question.
        threads: 0 is one a core. The answers do not depend on it.
        warnings: look for traps of the model as well, such as a large motion, or a preload that
            does not balance (docs/model.md). Takes longer than most verdicts; of one question.
        max_motion: count only equilibria whose motion is within this: a length and an angle, such
            as ("1/100", "1/50"), a number for each coordinate, "1000x" the natural motion, or "none"
            for no bound (docs/model.md). The grasp's own if None; of one question.
        samples, seed: with ``uncertain``, where the box has not one verdict, decide so many of its grasps,
            drawn at random: ``BoxDecision.samples`` says which share holds.

    Raises:
        InputError: an argument is wrong, or there is no load.
    """
    if uncertain is not None:
        one_of("engine", engine, ("auto",))
        if warnings:
            raise InputError("", "warnings", "the question is about a box of grasps",
                             "ask for the warnings of one grasp, without uncertain")
        about = _with_friction(grasp, friction)
        tolerances = as_uncertain(uncertain)
        return _boxed(BoxDecision, _ask(
            "decide_box", about, wrench, preload, normal_law, node_limit, max_motion,
            time_limit=time_limit, uncertain=tolerances, samples=as_count("samples", samples, 1000000),
            seed=as_count("seed", seed, 1000000000)), about, uncertain=tolerances)
    if samples:
        raise InputError("", "samples", "the question is about one grasp, of which there are no samples",
                         "say with uncertain how far numbers may be off")
    method = as_engine(engine)
    at_once = as_count("threads", threads, 1024)
    many = Questions(grasp, wrench, friction, preload)
    if many.count is not None:
        if warnings:
            raise InputError("", "warnings", "these are many questions",
                             "ask for the warnings of one question at a time")
        if max_motion is not None:
            raise InputError("", "max_motion", "these are many questions",
                             "bound the motions of one question at a time")
        if time_limit != 0:
            raise InputError("", "time_limit", "these are many questions",
                             "limit the time of one question at a time, or give a node_limit")
        return Decisions(_core.decide_many(
            many.count, *many.lists(), is_bilateral(normal_law), method,
            as_count("node_limit", node_limit), at_once), many.asked)
    about, snapped = _asked(grasp, preload)
    about = _with_friction(about, friction)
    return decision_of(about, snapped, _ask(
        "decide", about, wrench, preload, normal_law, node_limit, max_motion, time_limit=time_limit, engine=method,
        warnings=bool(warnings)))


def radius(
    grasp: Grasp,
    wrench: Any = None,
    *,
    uncertain: Union[str, Mapping[str, Number]],
    friction: Optional[Number] = None,
    preload: Optional[Number] = None,
    normal_law: str = "unilateral",
    accuracy: Number = "1/100",
    node_limit: int = 0,
    time_limit: Number = 0,
    max_motion: Any = None,
) -> Radius:
    """By which factor may all tolerances grow before the verdict is another? With proofs.

    Args:
        grasp, wrench, uncertain, friction, preload, normal_law, max_motion: as of ``decide``.
        accuracy: stop when what is proved and what is refuted differ by this part of it.
        node_limit: let each proof give up after so many nodes; 0: one that suits most questions.
        time_limit: in seconds, as of ``decide``.
    """
    about = _with_friction(grasp, friction)
    tolerances = as_uncertain(uncertain)
    return _boxed(Radius, _ask(
        "radius", about, wrench, preload, normal_law, node_limit, max_motion,
        time_limit=time_limit, uncertain=tolerances,
        accuracy=as_number(accuracy, "accuracy")), about, uncertain=tolerances)


def quality(
    grasp: Grasp,
    wrench: Any = None,
    *,
    length: Optional[Number] = None,
    about: Any = None,
    body: str = "",
    friction: Optional[Number] = None,
    preload: Optional[Number] = None,
    normal_law: str = "unilateral",
    at_most: Optional[Number] = None,
    accuracy: Number = "1/100",
    node_limit: int = 0,
    time_limit: Number = 0,
    max_motion: Any = None,
) -> Quality:
    """How large a ball of loads around its own does the grasp resist? With proofs.

    A load that differs by a force f and a torque t is in the ball of radius R if
    |f|^2 + |t / length|^2 <= R^2.

    Args:
        grasp, wrench, friction, preload, normal_law, max_motion: as of ``decide``.
        length: characteristic length of the object, by which torques are divided; half the spread of
            the contacts if None.
        about: the point that torques are about; the origin if it is left out.
        body: of several bodies the name of the one that the loads are on.
        at_most: no larger ball is of interest.
        accuracy: stop when what is proved and what is refuted differ by this part of it.
        node_limit: let each proof give up after so many nodes; 0: one that suits most questions.
        time_limit: in seconds, as of ``decide``.
    """
    about_grasp = _with_friction(grasp, friction)
    answer = _ask(
        "quality", about_grasp, wrench, preload, normal_law, node_limit, max_motion,
        time_limit=time_limit,
        length=as_number_or_none(length, "length"), about=as_row_or_none(about, "about", None), body=str(body),
        at_most=as_number_or_none(at_most, "at_most"), accuracy=as_number(accuracy, "accuracy"))
    proofs = answer.get("proofs", {})
    answer.update({field: proofs[name] for name, field in
                   (("proved", "proof"), ("refuted", "counterexample")) if name in proofs})
    return _boxed(Quality, answer, about_grasp, length=answer["ball"]["length"],
                  scales="scales" in answer)


def best_preload(
    grasp: Grasp,
    wrench: Any = None,
    *,
    budget: Optional[Number] = None,
    uncertain: Union[str, Mapping[str, Number]] = "",
    length: Optional[Number] = None,
    about: Any = (),
    body: str = "",
    balanced: bool = False,
    equal: Any = "normals",
    friction: Optional[Number] = None,
    normal_law: str = "unilateral",
    accuracy: Number = "1/20",
    boxes: int = 0,
    node_limit: int = 0,
    time_limit: Number = 0,
    max_motion: Any = None,
) -> BestPreload:
    """Preloads of the least sum that hold a load, or that with a budget resist the largest ball.

    Args:
        grasp, friction, normal_law, max_motion: as of ``decide``. The grasp's own preloads are tried, too.
        wrench: one load, or without a budget (n, 3), in space (n, 6): all of them are to be held.
        budget: the sum of preloads; then the ball around the load is sought.
        uncertain: without a budget a ball of loads to be held, "wrench=ball:1/2:length=2".
        length, about, body: with a budget the length by which torques are divided (None: half the spread of
            the contacts), the point about which they are, () for the origin, and of an Assembly the body of the loads.
        balanced: seek preloads that friction balances before the load comes, of one body in the
            plane. The bound is about all preloads even so.
        equal: which contacts press alike, unless all preloads are a multiple of the grasp's: "normals" for
            those whose normals have one direction, "none", or groups, as in [(0, 1), (2, 3)]. The bound is
            about all preloads even so.
        accuracy: stop when what is found and the bound differ by this part.
        boxes: look at so many boxes of preloads for the bound; 0: so many as suit most questions.
        node_limit: let each proof give up after so many nodes; 0: one that suits most questions.
        time_limit: in seconds, as of ``decide``.
    """
    about_grasp, _ = _asked(_with_friction(grasp, friction), 1)
    rows = [wrench] if wrench is None or np.ndim(wrench) < 2 else list(wrench)
    if not rows or (budget is not None and len(rows) > 1):
        raise InputError("", "wrench", f"there are {len(rows)} loads",
                         "give one, or without a budget one or more")
    answer = _ask(
        "preload", about_grasp, None, None, normal_law, node_limit, max_motion,
        time_limit=time_limit, needed=False,
        loads=[about_grasp._load(row) for row in rows],
        budget=as_number_or_none(budget, "budget"), uncertain=as_uncertain(uncertain),
        length=as_number_or_none(length, "length"),
        about=as_list(about, "about", (len(about),), "a point") if len(about) else [], body=body,
        balanced=bool(balanced),
        equal=equal if isinstance(equal, str) else ":".join(",".join(str(i) for i in group) for group in equal),
        accuracy=as_number(accuracy, "accuracy"),
        boxes=as_count("boxes", boxes))
    ball = {} if answer["preloads"] is None else answer
    return answer_of(
        BestPreload, answer, grasp=about_grasp, radius=ball.get("proved"),
        equal=tuple(tuple(group) for group in answer["equal"]),
        refuted=ball.get("not_resisted_at"),
        proofs={name: Proof.of(files, answer) for name, files in answer["proofs"].items()})


def stability_map(
    grasp: Grasp,
    x: str,
    y: str,
    wrench: Any = None,
    *,
    uncertain: Union[str, Mapping[str, Number]] = "",
    friction: Optional[Number] = None,
    preload: Optional[Number] = None,
    normal_law: str = "unilateral",
    depth: int = 6,
    node_limit: int = 0,
    time_limit: Number = 0,
    proofs: bool = False,
    max_motion: Any = None,
) -> StabilityMap:
    """Where in a plane of two numbers does it hold? Proved cell by cell.

    Args:
        grasp, wrench, friction, preload, normal_law, max_motion: as of ``decide``.
        x, y: "NAME=FROM:TO", as in "friction=0:1"; the names are those of ``stickslip map``.
            Of two wrenches, "1,0,0,0,0,0=-2:2", it is the region of a plane of loads in space, or
            where motions are bounded.
        uncertain: how far numbers of every grasp of the map may be off, as of ``decide``: a cell's
            verdict is then one about all grasps that are so near to one in it.
        depth: the finest cells are a 2**depth-th of an axis.
        node_limit: let each proof give up after so many nodes; 0: one that suits most questions.
        time_limit: in seconds, as of ``decide``.
        proofs: keep the proof of each cell.
    """
    about = _with_friction(grasp, friction)
    tolerances = as_uncertain(uncertain)
    answer = _ask(
        "map", about, wrench, preload, normal_law, node_limit, max_motion,
        time_limit=time_limit, uncertain=tolerances,
        x=str(x), y=str(y), depth=as_count("depth", depth, 12), proofs=bool(proofs))
    cells = tuple(
        MapCell(cell["x"], cell["y"], cell["verdict"], files and Proof.of(files, answer))
        for cell, files in zip(answer["cells"], answer["proofs"]))
    return answer_of(StabilityMap, answer, grasp=about, x=str(x), y=str(y), uncertain=tolerances,
                     cells=cells, picture=Picture(answer["picture"]))


def slip_states(
    grasp: Grasp, *, engine: str = "auto", list_states: bool = True, threads: int = 0,
    time_limit: Number = 0,
) -> SlipStates:
    """The slip states consistent with rigid motion, and counts of cells.

    Args:
        grasp: its positions and normals matter, nothing else.
        engine: "cgal", CGAL's arrangement on the sphere, the reference; "sweep", for many
            contacts; "paper", the paper's own three steps, a baseline; "auto".
        list_states: list the states. There are O(m^2) of m characters each: beyond a few hundred
            contacts ask for counts alone.
        threads: of the counts of "sweep"; 0 is one a core.
        time_limit: in seconds, fractions too; 0 is no limit.

    Raises:
        LimitReached: at ``time_limit``.
    """
    engine = one_of("engine", engine, ("auto", "cgal", "sweep", "paper"))
    threads = as_count("threads", threads, 1024)
    about = _require_grasp(grasp)
    if not isinstance(about, Assembly) and about.in_space:
        raise InputError("", "grasp", "the grasp is in space",
                         "find_states counts and lists its slip states")
    return answer_of(SlipStates, _core.ask(about._planar(), "states", {
        "engine": engine, "list": bool(list_states), "threads": threads,
        "time_limit": as_time_limit(time_limit)}), grasp=grasp)


def region(
    grasp: Grasp,
    *,
    torque: Any = None,
    origin: Any = (0, 0, 0),
    u: Any = (1, 0, 0),
    v: Any = (0, 1, 0),
    preload: Any = None,
    normal_law: str = "unilateral",
    mode_limit: int = 0,
    pieces: bool = False,
    certificate: bool = False,
    node_limit: int = 0,
    time_limit: Number = 0,
    max_motion: Any = None,
) -> Region:
    """Which wrenches origin + s u + t v does the grasp resist? The exact set of (s, t).

    By default the plane is that of forces at zero torque. The grasp's own wrench plays no part.

    Args:
        torque: short for the origin (0, 0, torque).
        mode_limit: give up at more than so many contact modes; 0 is no limit.
        pieces: also what is resisted in each contact mode.
        certificate: also prove that exactly this region is resisted.
        node_limit: of the search for the proof; 0 is no limit.
        time_limit: in seconds, fractions too; 0 is no limit.
        max_motion: None or "none": within a bound the region is not exact, and ``stability_map``
            proves cells of the plane.

    Raises:
        InputError: an argument is wrong; u and v are not independent.
        LimitReached: ``mode_limit``, ``node_limit`` or ``time_limit``.
    """
    if as_max_motion(max_motion) not in ("", "none"):
        raise InputError("", "max_motion", "motions are bounded",
                         'ask stability_map(grasp, "1,0,0=-2:2", "0,1,0=-2:2", origin, max_motion=...), '
                         "which proves cells of the plane")
    # A certificate of a region is about a file of one body.
    about, snapped = _asked(grasp if certificate else _alone(grasp), preload)
    answer = _region(about, torque, origin, u, v, preload, normal_law, mode_limit, node_limit,
                     time_limit=time_limit, pieces=bool(pieces), certificate=bool(certificate))
    return answer_of(
        Region, answer, grasp=about, snapped=snapped, **answer["plane"],
        areas=tuple(tuple(Outline(border["vertices"], border.get("from"), border.get("to"))
                          for border in area["outlines"]) for area in answer["areas"]),
        curves=tuple(Cell(**curve) for curve in answer["curves"]),
        pieces=tuple(Piece(piece["slip"], piece["closed"], Cell(piece["vertices"], piece["rays"]))
                     for piece in answer.get("pieces", ())))


def plot_region(
    grasp: Grasp,
    *,
    torque: Any = None,
    origin: Any = (0, 0, 0),
    u: Any = (1, 0, 0),
    v: Any = (0, 1, 0),
    preload: Any = None,
    normal_law: str = "unilateral",
    mode_limit: int = 0,
) -> Picture:
    """A picture of ``region``, as SVG."""
    about, _ = _asked(_alone(grasp), preload)
    return Picture(_region(
        about, torque, origin, u, v, preload, normal_law, mode_limit, picture=True)["picture"])


def plot_grasp(
    grasp: Grasp, wrench: Any = None, *, preload: Any = None, normal_law: str = "unilateral"
) -> Picture:
    """A picture of the verdict, as SVG: contacts, cones, load, and the forces and motion that
    hold it, or the virtual twist that wins. In space from three sides."""
    about, _ = _asked(grasp, preload)
    return Picture(_ask("picture", about, wrench, preload, normal_law, 0, None, engine="auto",
                        limit=None))


def plot_states(grasp: Grasp, *, modes: str = "slip") -> Picture:
    """A picture of the slip states, as SVG: the sphere of motions, cut by one great circle a
    contact. In space, of several bodies and with other ``modes``, those of ``find_states``: a row
    for each dimension of their motions."""
    one_of("modes", modes, ("slip", "full", "closed", "cs", "ss"))
    return Picture(_core.ask(_require_grasp(grasp)._data, "states picture", {"modes": modes}))


def compare(
    grasp: Grasp, wrench: Any = None, *, preload: Any = None, normal_law: str = "unilateral",
    methods: Sequence[str] = (), length: Any = None, inertia: Any = None, certificate: bool = False,
    max_motion: Any = None, max_force: Any = 1, accuracy: Any = "1/100", edges: int = 0,
    time_limit: Number = 0,
) -> Comparison:
    """What earlier methods say of the same question as ``decide``, and why they differ.

    Args:
        grasp, wrench, preload, normal_law: as of ``decide``, for one question. Of several bodies
            the class alone is known, that of ``statics``, and there are no methods to choose.
        methods: ask these alone, as in ("weakly-stable-load", "strongly-stable-load") or ("PCR", "PGR"). Two are
            about the plane alone: "three-state-compliance" and "grasp-wrench-space-Linf".
        length: characteristic of the object, by which grasp wrench spaces divide torques; half the spread
            of the contacts if None.
        inertia: (3,): the centre of mass and the squared radius of gyration about it, which
            strong stability needs; (0, 0, length**2) if None. In space (6,) or (9,): the centre
            and xx, yy, zz, and perhaps xy, xz, yz, of the tensor of inertia about it, over the mass.
        max_motion: as of ``decide``, of passive equilibrium alone: the other methods know no bound.
        certificate: prove the class of the load, for ``check`` with this inertia; or, if PCR or PGR is
            the only method, its bounds, for ``check`` with this robustness.
        max_force: the largest normal force, of the robustnesses and the margin of internal forces: a
            number, or one for each contact.
        accuracy: how near the bounds of these are to be, as a part of them.
        edges: in space, of the robustnesses, the volume of the wrench space, the least normal forces
            and the margin: pyramids with so many edges in place of round cones; 0 is round.
        time_limit: in seconds, fractions too, for all methods together: what is not known by then is
            "not computed"; 0 is no limit.

    Raises:
        LimitReached: what a certificate is wanted of is not known.
    """
    # A certificate is about the file, as it is.
    about, snapped = _asked(grasp if certificate else _alone(grasp), preload)
    if isinstance(about, Assembly):
        for name, is_given in (("methods", methods), ("inertia", inertia is not None), ("length", length is not None),
                               ("max_force", np.ndim(max_force) > 0 or max_force != 1), ("edges", edges != 0)):
            if is_given:
                raise InputError("", name, "the grasp is of several bodies",
                                 "leave it out: of them the class alone is computed")
        found = statics(about, wrench, certificate=certificate, time_limit=time_limit)
        return Comparison((), found.load_class, about, snapped, found.certificates.get("statics"))
    answer = _ask(
        "compare", about, wrench, preload, normal_law, 0, max_motion, time_limit=time_limit,
        methods=list(methods),
        length=as_number_or_none(length, "length"), certificate=bool(certificate),
        max_force=as_numbers(max_force, "max_force", len(about)), accuracy=as_number(accuracy, "accuracy"),
        edges=as_count("edges", edges), inertia=None if inertia is None else as_inertia(inertia, about._coordinates))
    rows = tuple(Method(row["method"], row["source"], row["about"] == "load", row["verdict"],
                        row["agrees"], row["why"], json.loads(row["evidence"]))
                 for row in answer["methods"])
    return Comparison(rows, answer["class"], about, snapped, answer.get("certificate"))


def statics(
    grasp: Grasp, wrench: Any = None, *, friction_factor: Any = 1, least_friction: bool = False,
    directions: Sequence[Any] = (), place: Any = None, body: str = "", accuracy: Any = None,
    certificate: bool = False, time_limit: Number = 0,
) -> Statics:
    """May it stand at all, whatever stiffness and preloads are? With which friction and loads?

    Args:
        grasp: of one body or several, or a mechanism. Its preloads play no part.
        wrench: the load, in place of the grasp's own; with directions it is 0 if None.
        friction_factor: all friction is multiplied by it.
        least_friction: ask for the least such factor with which it may stand.
        directions: one load u, or two: which l may stand under wrench + l u, or which (s, t)
            under wrench + s u + t v?
        place: a force besides the load, such as a weight: at which places (x, y), or x in the
            plane, may it act?
        body: the one of several that it is on.
        accuracy: where ends are not exact, the part that may be left: 1/1000000 of a factor, 1/1000
            of a way to the border of loads.
        certificate: also prove it, for stickslip-check.
        time_limit: in seconds, fractions too: undecided then; 0 is no limit.
    """
    about, _ = _asked(grasp, 0)
    rows = [as_row_or_none(row, "directions", None) for row in directions]
    load = wrench
    if rows and wrench is None:
        load = [0] * len(rows[0] or ())
    answer = _ask(
        "statics", about, load, None, "unilateral", 0, None, friction_factor=as_number(friction_factor, "friction_factor"),
        least_friction=bool(least_friction), directions=rows, place=as_row_or_none(place, "place", None),
        body=str(body), accuracy=as_number_or_none(accuracy, "accuracy"), certificate=bool(certificate), time_limit=time_limit)

    def forces(rows: Any) -> Tuple[StaticForce, ...]:
        return tuple(StaticForce(row["contact"], row["normal"], tuple(row["friction"])) for row in rows)

    least = answer.get("least_friction")
    multiples = answer.get("multiples")
    return Statics(
        grasp=about, wrench=answer["wrench"], load_class=answer.get("class"), reason=answer.get("reason"),
        forces=forces(answer.get("forces", ())), motion=answer.get("motion"),
        least_friction=None if least is None else (least["low"], least["high"]),
        multiples=None if multiples is None else StaticMultiples(
            None if multiples["stand"] is None else (multiples["stand"][0], multiples["stand"][1]),
            multiples["below"], multiples["above"], multiples["always_moves"]),
        stand=tuple((tuple(row["point"]), forces(row["forces"])) for row in answer.get("stand", ())),
        move=tuple(answer.get("move", ())), exact=answer.get("exact"), complete=answer.get("complete"),
        certificates=answer.get("certificates", {}))


def class_margin(
    grasp: Grasp, direction: Any, wrench: Any = None, *, inertia: Any = (0, 0, 1),
) -> Tuple[ClassRange, ...]:
    """Of which class is every multiple l >= 0 of a load on rigid contacts?

    Args:
        grasp: what is asked about. Its preloads and stiffnesses play no part. In space and of several
            bodies the classes are those of ``statics``, "may stand" and "must move".
        direction: (3,), or as many numbers as the grasp's wrench has: the load is wrench + l direction.
        wrench: what the load starts from; 0 if None.
        inertia: (3,): the centre of mass and the squared radius of gyration about it; in space and of
            several bodies it plays no part.

    Returns:
        Ranges in their order, each of one class; a class may have several.
    """
    about, _ = _asked(_alone(grasp), 0)
    if isinstance(about, Assembly) or about.in_space:
        return _standing(about, wrench, direction)
    return _classes("classes", about, wrench, needed=False, inertia=as_inertia(inertia),
                    direction=as_wrench(direction, "direction", 2))


def friction_margin(
    grasp: Grasp, wrench: Any = None, *, inertia: Any = (0, 0, 1), accuracy: Optional[Number] = None,
) -> Tuple[ClassRange, ...]:
    """Of which class is a load on rigid contacts when all friction is multiplied by s >= 0?

    Args:
        grasp: what is asked about, as of ``class_margin``.
        wrench: (3,), or as many numbers as the grasp's wrench has: the load; the grasp's own if None.
        inertia: as of ``class_margin``.
        accuracy: which part of a factor may be unknown where what must hold ends at a load that is open,
            1/1000 if None; or where what may stand begins, 1/1000000.

    Returns:
        Ranges of s in their order. Where the class is not known, ``load_class`` is None.
    """
    about, _ = _asked(_alone(grasp), 0)
    if isinstance(about, Assembly) or about.in_space:
        return _standing(about, wrench, None, accuracy)
    return _classes("factors", about, wrench, inertia=as_inertia(inertia),
                    accuracy=as_number("1/1000" if accuracy is None else accuracy, "accuracy"))


def export(
    grasp: Grasp, wrench: Any = None, *, preload: Any = None, normal_law: str = "unilateral"
) -> str:
    """The question for Z3, cvc5 and others: SMT-LIB 2, logic QF_LRA, in space QF_NRA; sat means
    stable."""
    about, _ = _asked(_alone(grasp), preload)
    about._one_body()
    text: str = _ask("smtlib", about, wrench, preload, normal_law, 0, None)
    return text


def margin(
    grasp: Grasp,
    direction: Any = None,
    wrench: Any = None,
    *,
    preload: Any = None,
    preload_direction: Any = None,
    normal_law: str = "unilateral",
    accuracy: Number = "1/1000",
    node_limit: int = 0,
    time_limit: Number = 0,
    warnings: bool = False,
    max_motion: Any = None,
) -> Margin:
    """Which multiples l >= 0 of a load, or of preloads, are resisted?

    The set is a finite union of closed intervals with rational ends; the last may have no end. In
    space, of an Assembly, where motions are bounded, and where preloads act along normals of
    irrational length, ends are not exact: some multiples are proved to be resisted, some to be
    ``refuted``, and of those between nothing is known.

    Args:
        grasp: what is asked about.
        direction: (3,), in space (6,): the load grows as wrench + l direction. Of an Assembly a
            number for each of its ``coordinates``.
        wrench: what the load starts from. If None it is 0 with a ``direction``, whatever the
            grasp's own, and without one the grasp's own.
        preload: of every contact; the grasp's own if None.
        preload_direction: how preloads grow: "scale", all in proportion, l times what they are;
            or (m,), one number of 0 or more for each contact: by l times these, from what they
            are. ``least`` of the answer is then the least preload that holds the load. Of an Assembly
            the numbers of its springs follow those of contacts.
        normal_law: as in ``decide``.
        accuracy: where ends are not exact: which part of a multiple may stay undecided at one.
        node_limit: give up after so many nodes; 0 is no limit.
        time_limit: in seconds, as of ``decide``.
        warnings: look for traps of the model as well, as ``decide`` does.
        max_motion: as of ``decide``.

    Raises:
        InputError: an argument is wrong; nothing grows.
        LimitReached: at ``node_limit`` or ``time_limit``, where ends are exact.
    """
    about, snapped = _asked(grasp, preload if preload_direction is None else 1)
    if direction is None and preload_direction is None:
        raise InputError("", "direction", "nothing grows",
                         "give a direction such as (0, 1, 0), or a preload_direction")
    answer = _ask(
        "margin", about, wrench, preload, normal_law, node_limit, max_motion,
        time_limit=time_limit,
        needed=direction is None, warnings=bool(warnings), accuracy=as_number(accuracy, "accuracy"),
        direction=as_row_or_none(direction, "direction", about._components),
        preload_direction=as_preload_direction_or_none(preload_direction))

    def margin_of(one: Dict[str, Any], within: Optional[Margin]) -> Margin:
        return answer_of(Margin, one, grasp=about, snapped=snapped, within=within,
                         direction=one.get("direction"))

    second = answer.get("within")
    return margin_of(answer, second and margin_of(second, None))


def crosscheck(
    grasp: Grasp,
    verdict: str,
    *,
    twist: Any = None,
    forces: Any = None,
    wrench: Any = None,
    preload: Any = None,
    normal_law: str = "unilateral",
    tie: Any = "1e-9",
    tolerance: Any = "1e-6",
    node_limit: int = 0,
    distances: bool = False,
) -> CrossCheck:
    """Is another program's answer right, wrong, or a tie that only exact arithmetic can see?

    Args:
        grasp: what was asked about, as are ``wrench``, ``preload`` and ``normal_law``.
        verdict: the claim, "stable" or "unstable".
        twist: (3,) or (6,), the claimed motion (x, y, r), in space translation and rotation, if
            there is one.
        forces: (m, 2) or (m, 3), the claimed forces of the contacts on the body, in its frame.
        tie: a wrong verdict is a tie if a relative change of the load by this much mends it.
        tolerance: residuals up to this fraction of the forces and motions at hand count as none.
        node_limit: for the verdict and for each margin; 0 is no limit, and in space one that suits
            most questions.
        distances: find the distance to the threshold for right claims as well.
    """
    about, snapped = _asked(grasp, preload)
    about._one_body()
    answer = _ask(
        "crosscheck", about, wrench, preload, normal_law, node_limit, None,
        verdict=one_of("verdict", verdict, ("stable", "unstable")),
        twist=None if twist is None
        else as_list(twist, "twist", (6,), "translation x, y, z and rotation x, y, z")
        if about.in_space
        else as_list(twist, "twist", (3,), "motion x, y and rotation r"),
        forces=None if forces is None
        else as_list(forces, "forces", (len(about), about._coordinates), "one vector for each contact"),
        tie=as_number(tie, "tie"), tolerance=as_number(tolerance, "tolerance"),
        distances=bool(distances))
    missed, near, distance = answer["residuals"], answer["nearby"], answer["distance"] or {}
    torque = missed.get("torque")
    return answer_of(
        CrossCheck, {}, outcome=answer["class"], inaccurate=answer["inaccurate"],
        decision=decision_of(about, snapped, answer["decision"]),
        balance=None if torque is None
        else missed["force"] + (torque if isinstance(torque, tuple) else (torque,)),
        claimed_slip=answer["claimed_slip"],
        nearby=near and answer_of(NearbyEquilibrium, near, forces=near["force_vectors"],
                                  from_claim=near["from"] == "claim"),
        distance=distance.get("smallest"), distance_along_load=distance.get("along_load"),
        **{name: Residual(missed[name]["value"], missed[name]["contact"])
           for name in ("cone", "normal_law", "dissipation") if name in missed})


def check(
    grasp: Union[Grasp, os.PathLike[str]],
    certificate: Union[str, os.PathLike[str]],
    *,
    wrench: Any = None,
    preload: Any = None,
    normal_law: str = "unilateral",
    direction: Any = None,
    preload_direction: Any = None,
    plane: Any = None,
    inertia: Any = None,
    statics: Any = None,
    uncertain: Union[str, Mapping[str, Number]] = "",
    max_motion: Any = None,
    states: str = "",
    robustness: str = "",
    length: Any = 1,
    max_force: Any = 1,
) -> CheckResult:
    """Does the certificate prove its verdict about this question?

    The checker shares no code with the engines; it believes nothing in the certificate
    (docs/prove.md). Give the same question as to ``decide``.

    Args:
        grasp: a grasp, or the path of its file, which the checker then reads itself.
        certificate: its text, or the path of a file, as a ``pathlib.Path``.
        direction: of a margin, whose certificate this then is; the wrench is then 0 unless given.
        preload_direction: of a margin, as for ``margin``.
        plane: u and v of a region, whose certificate this then is; the wrench is its origin, and
            0 unless given.
        inertia: as of ``compare``: of the class of a load, whose certificate this then is.
        statics: of ``statics``, whose certificate this then is: the factor of all friction.
        uncertain: as of ``decide``, of a box.
        max_motion: numbers as of ``decide``, or "none".
        states: "slip", "full" or "closed": the modes of ``find_states``, whose certificate this then is.
        robustness: "contact" or "grasp", of the potential contact robustness or that of the grasp,
            whose certificate this then is; with length and max_force as of ``compare``.

    Raises:
        InputError: the grasp or the certificate cannot be read, or the question not be asked.
    """
    if isinstance(grasp, Grasp):
        # States are of positions and normals as they are, and of no load.
        about = grasp if states else _asked(grasp, preload if preload_direction is None else 1)[0]
        grasp_bytes, grasp_name = about.to_text().encode(), b"<grasp>"
        n, row = about._coordinates, about._components
        load = None if states and wrench is None else about._load(wrench, needed=direction is None and plane is None)
    else:
        grasp_bytes, grasp_name = as_content(
            grasp, "grasp", "give a stickslip.Grasp, or the path of its file")
        in_space = any(values is not None and as_array(values, name).shape == (6,)
                       for name, values in (("wrench", wrench), ("direction", direction)))
        n, row = 3 if in_space else 2, None
        load = as_row_or_none(wrench, "wrench", row)
    remedy = "give its text as a str, or the path of its file as a pathlib.Path"
    if isinstance(certificate, str):
        certificate_bytes, name = as_json(certificate, "certificate", remedy), b"<certificate>"
    else:
        certificate_bytes, name = as_content(certificate, "certificate", remedy)
    return CheckResult(**_core.check(
        grasp_bytes,
        certificate_bytes,
        load,
        as_number_or_none(preload, "preload"),
        is_bilateral(normal_law),
        as_row_or_none(direction, "direction", row),
        as_preload_direction_or_none(preload_direction),
        as_plane_or_none(plane) if statics is None else plane,
        None if inertia is None else as_inertia(inertia, n),
        as_uncertain(uncertain),
        as_max_motion(max_motion),
        grasp_name,
        name,
        as_number_or_none(statics, "statics"),
        [*(["--states", str(states)] if states else []),
         *(_robustness_words(robustness, length, max_force) if robustness else [])],
    ))


def _robustness_words(robustness: str, length: Any, max_force: Any) -> List[str]:
    def spelled(value: Any, name: str) -> str:
        number = as_number(value, name)
        return number if isinstance(number, str) else str(Fraction(number))
    forces = [max_force] if np.ndim(max_force) == 0 else list(max_force)
    return ["--robustness", robustness, "--length", spelled(length, "length"),
            "--max-force", ",".join(spelled(f, "max_force") for f in forces)]


def _region(
    grasp: Grasp, torque: Any, origin: Any, u: Any, v: Any, preload: Any, normal_law: str,
    mode_limit: int, node_limit: int = 0, pieces: bool = False, certificate: bool = False,
    picture: bool = False, time_limit: Any = 0,
) -> Dict[str, Any]:
    grasp._one_body()
    if grasp.in_space:
        raise InputError("", "grasp", "the grasp is in space",
                         'ask stability_map(grasp, "1,0,0,0,0,0=-2:2", "0,1,0,0,0,0=-2:2", origin), '
                         "which proves cells of the plane")
    start = as_wrench(origin, "origin")
    if torque is not None:
        if any(entry != 0 for entry in start):
            raise InputError("", "torque", "there is an origin as well", "give one of the two")
        start = [0, 0, as_number(torque, "torque")]
    answer: Dict[str, Any] = _ask(
        "region", grasp, None, preload, normal_law, node_limit, None, needed=False,
        time_limit=time_limit, origin=start,
        u=as_wrench(u, "u"), v=as_wrench(v, "v"), pieces=pieces, picture=picture,
        mode_limit=as_count("mode_limit", mode_limit), certificate=certificate)
    return answer


def _alone(grasp: Grasp) -> Grasp:
    """An assembly of one body that moves freely, without springs, is a grasp of that body."""
    data = grasp._data.alone() if isinstance(grasp, Assembly) else None
    return grasp if data is None else Grasp._of(data, grasp._loaded)


def _standing(grasp: Grasp, wrench: Any, direction: Any, accuracy: Any = None) -> Tuple[ClassRange, ...]:
    """The classes that statics knows of multiples of a direction, or of factors of friction if it is None."""
    rows: List[ClassRange] = []

    def add(load_class: Optional[str], low: Optional[Fraction], high: Optional[Fraction], has_low: bool, has_high: bool) -> None:
        if low is None or low < 0:
            low, has_low = Fraction(0), True
        if high is None or low < high or (low == high and has_low and has_high):
            rows.append(ClassRange(load_class, low, high, has_low, has_high and high is not None))

    if direction is None:
        found = statics(grasp, wrench, least_friction=True, accuracy=accuracy)
        if found.least_friction is None:
            add(found.load_class, None, None, True, False)
        else:
            fails, stands = found.least_friction
            if fails > 0:
                add("must move", None, fails, True, True)
            add(None, fails, stands, fails == 0, False)
            add("may stand", stands, None, True, False)
        return tuple(rows)
    multiples = statics(grasp, wrench, directions=[direction]).multiples
    assert multiples is not None
    below, above = multiples.below, multiples.above
    if multiples.always_moves or (below is not None and above is not None and below > above):
        add("must move", None, None, True, False)
        return tuple(rows)
    if below is not None:
        add("must move", None, below, True, False)
    if multiples.stand is None:
        add(None, below, above, True, True)
    else:
        low, high = multiples.stand
        if low is not None:
            add(None, below, low, True, False)
        add("may stand", low, high, True, True)
        if high is not None:
            add(None, high, above, False, True)
    if above is not None:
        add("must move", above, None, False, False)
    return tuple(rows)


def _classes(question: str, grasp: Grasp, wrench: Any, needed: bool = True,
             **options: Any) -> Tuple[ClassRange, ...]:
    answer = _ask(question, grasp, wrench, None, "unilateral", 0, None, needed, **options)
    return tuple(ClassRange(row.pop("class"), **row) for row in answer["classes"])


class Questions:
    """What ``decide`` was given, one or n of each."""

    def __init__(self, grasp: Any, wrench: Any, friction: Any, preload: Any) -> None:
        self._grasps = grasp
        self._given = {"wrench": wrench, "friction": friction, "preload": preload}
        self.asked: List[Tuple[Grasp, Tuple[SnappedNormal, ...]]] = []
        """Each grasp with the normals that moved, once they are in lists()."""
        counts = {}
        if isinstance(grasp, (list, tuple)) or (
                isinstance(grasp, np.ndarray) and grasp.ndim == 1):
            counts["grasp"] = len(grasp)
        for name, value in self._given.items():
            if value is None:
                continue
            array, alone = as_array(value, name), 1 if name == "wrench" else 0
            rows = array.ndim == 1 and any(isinstance(row, (list, tuple)) for row in array)
            if array.ndim > alone or rows:  # rows of several lengths are not one array
                counts[name] = len(array)
        several = {name: count for name, count in counts.items() if count != 1}
        if len(set(several.values())) > 1:
            raise InputError("", ", ".join(several), "their lengths are " + ", ".join(
                map(str, several.values())), "give one or n of each")
        self.count: Optional[int] = next(iter(several.values()), 1) if counts else None
        """None if there is one of each, and so one question."""
        self._counts = counts

    def lists(self) -> Tuple[List[Any], List[Any], List[Any], List[Any]]:
        """Grasps, wrenches, frictions and preloads: n or 1 of each, 0 if it was not given."""
        given = list(self._grasps) if "grasp" in self._counts else [self._grasps]
        kinds = {(_require_grasp(grasp)._components, grasp._coordinates) for grasp in given}
        if len(kinds) > 1 and any(isinstance(grasp, Assembly) for grasp in given):
            raise InputError("", "grasp", "the grasps differ in their bodies or joints",
                             "ask about those that have the same coordinates")
        if len(kinds) > 1:
            raise InputError("", "grasp", "some grasps are in the plane, and some in space",
                             "ask about those in the plane, and about those in space")
        components, meaning = given[0]._components if given else WRENCHES[2]
        preloads = self._numbers("preload", as_number)
        largest = max((_core.exact(value, f"preload[{i}]") for i, value in enumerate(preloads)),
                      default=None)
        self.asked = [_asked(grasp, largest) for grasp in given]
        frictions = self._numbers("friction", lambda value, name: as_numbers(
            value, name, len(given[0])))
        wrenches: List[Any] = []
        if "wrench" in self._counts:
            wrenches = as_list(self._given["wrench"], "wrench",
                               (self._counts["wrench"], components), meaning + " in each row")
        elif self._given["wrench"] is not None:
            wrenches = [as_list(self._given["wrench"], "wrench", (components,), meaning)]
        else:
            for grasp in given:
                grasp._load(None)
        return [grasp._data for grasp, _ in self.asked], wrenches, frictions, preloads

    def _numbers(self, name: str, convert: Callable[[Any, str], Any]) -> List[Any]:
        value = self._given[name]
        if value is None:
            return []
        if name not in self._counts:
            return [as_number(value, name)]
        return [convert(entry, f"{name}[{i}]")
                for i, entry in enumerate(as_array(value, name).tolist())]


def _asked(grasp: Any, preload: Any = None) -> Tuple[Grasp, Tuple[SnappedNormal, ...]]:
    _require_grasp(grasp)
    if preload is not None:
        preload = _core.exact(as_number(preload, "preload"), "preload")
    asked: Tuple[Grasp, Tuple[SnappedNormal, ...]] = grasp._asked(preload)
    return asked


def _with_friction(grasp: Grasp, friction: Any) -> Grasp:
    data = _require_grasp(grasp)._data
    if friction is None:
        return grasp
    return Grasp._of(data.with_friction(as_number(friction, "friction")), grasp._loaded)


def _ask(question: str, grasp: Grasp, wrench: Any, preload: Any, normal_law: str, node_limit: int,
         max_motion: Any, needed: bool = True, time_limit: Any = 0, **options: Any) -> Any:
    """The answer as the command's JSON has it; with the preload, if one replaced the grasp's own."""
    load = grasp._load(wrench, needed=needed)
    replaced = as_number_or_none(preload, "preload")
    answer = _core.ask(grasp._data, question, dict(
        options, wrench=load, preload=replaced, bilateral=is_bilateral(normal_law),
        node_limit=as_count("node_limit", node_limit), max_motion=as_max_motion(max_motion),
        time_limit=as_time_limit(time_limit)))
    if replaced is not None and isinstance(answer, dict):
        answer["preload"] = _core.exact(replaced, "preload")
    return answer


def _boxed(kind: Type[AnyAnswer], answer: Dict[str, Any], grasp: Grasp, **more: Any) -> AnyAnswer:
    """An answer whose files of proofs become proofs."""
    for name in ("proof", "counterexample"):
        if name in answer:
            answer[name] = Proof.of(answer[name], answer)
    if "examples" in answer:
        answer["examples"] = tuple(Proof.of(files, answer) for files in answer["examples"])
    if "samples" in answer:
        samples = answer["samples"]
        samples["failures"] = tuple(Proof.of(files, answer) for files in samples["failures"])
        answer["samples"] = Samples(**samples)
    return answer_of(kind, answer, grasp=grasp, **more)


def _require_grasp(grasp: Grasp) -> Grasp:
    if not isinstance(grasp, Grasp):
        raise InputError("", "grasp", f"this is {found(grasp)}",
                         "give a stickslip.Grasp; Grasp.from_file reads one")
    return grasp
