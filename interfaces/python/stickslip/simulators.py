# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of MuJoCo and of Drake, made what a Grasp takes.

Nothing of them is imported: what is looked up is the names that their objects offer.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any, Dict, List, Optional, Set, Tuple

from . import _core
from .arguments import as_array, as_number, as_numbers, found
from .contacts import Contacts, Numbers, cross, dot, exact_vector, negated, normal_forces, pushing, springs
from .errors import InputError

# MuJoCo: the names of its C structures, which are those of its Python and JavaScript modules.

_PYRAMIDAL = 0  # of mjtCone
_TO_BODY = 5  # of mjtTrn: an actuator of adhesion
_PASSIVE = 4  # of mjContact.exclude: pushes by a force that is no constraint's


def _of(thing: Any, name: str, what: str) -> Any:
    try:
        return getattr(thing, name)
    except AttributeError:
        raise InputError("", f"{what}.{name}", f"{found(thing)} has no such attribute",
                         "give an MjModel and an MjData of MuJoCo") from None


class _Scene:
    """Of a model: which bodies move, and as one."""

    def __init__(self, model: Any, body: Any) -> None:
        self.model = model
        self.welded = [int(b) for b in _of(model, "body_weldid", "model")]
        self.geoms = [int(b) for b in _of(model, "geom_bodyid", "model")]
        self.body = self.index(body, "body")
        self.held = self.welded[self.body]
        if self.held == 0:
            raise InputError("", "body", f"{self.name(self.body)} is fixed to the world",
                             "name the body that is held")
        freedom = int(_of(model, "body_dofnum", "model")[self.held])
        if freedom != 6:
            raise InputError("", "body", f"joints leave {self.name(self.body)} {freedom} degrees of "
                             "freedom of 6", "give it a free joint: what joints hold is no contact's")
        roots = _of(model, "body_rootid", "model")
        for b, whole in enumerate(self.welded):
            if roots[b] == roots[self.held] and whole != self.held:
                raise InputError("", "body", f"{self.name(b)} hangs on {self.name(self.body)} by a "
                                 "joint", "the model is about one rigid body: weld it, by leaving "
                                 "out the joint")

    def index(self, body: Any, place: str) -> int:
        remedy = "give the name of a body, or its number, which for bodies but the world is " \
            f"from 1 to {len(self.welded) - 1}"
        if isinstance(body, str):
            try:
                body = self.model.body(body).id
            except (KeyError, AttributeError):
                raise InputError("", place, f"there is no body {body!r}", remedy) from None
        if isinstance(body, bool) or not hasattr(body, "__index__") \
                or not 0 < int(body) < len(self.welded):
            raise InputError("", place, f"this is {found(body)}", remedy)
        return int(body)

    def all_of(self, bodies: Any) -> List[int]:
        """Of an argument ``fixed``."""
        if bodies is False:
            return []
        listed = list(bodies) if isinstance(bodies, Iterable) and not isinstance(bodies, str) else [bodies]
        return [self.welded[self.index(b, "fixed")] for b in listed]

    def name(self, body: int) -> str:
        """For messages."""
        known = self.model.body(body).name if hasattr(self.model, "body") else ""
        return f"body {known!r}" if known else f"body {body}"

    def whole(self, geom: int, place: str) -> int:
        if geom < 0:
            raise InputError("", place, "something flexible touches",
                             "the model is about rigid bodies: leave flexes out")
        return self.welded[self.geoms[geom]]


def from_mujoco(model: Any, data: Any, body: Any, friction: Any, stiffness: Any, forces: Any,
                preload: Any, fixed: Any) -> Contacts:
    scene = _Scene(model, body)
    count = int(_of(data, "ncon", "data"))
    given = normal_forces(forces, count, True)
    rows: List[Tuple[str, List[Any], List[Any], Any, Fraction, Fraction]] = []
    touched: Dict[int, None] = {}  # in their order
    for i in range(count):
        contact, place = data.contact[i], f"data.contact[{i}]"
        pair = getattr(contact, "geom", None)
        pair = [contact.geom1, contact.geom2] if pair is None else pair
        wholes = [scene.whole(int(g), place) if int(g) >= 0 else None for g in pair]
        mine = [whole == scene.held for whole in wholes]
        if not any(mine):
            continue
        if all(mine):
            raise InputError("", place, f"{scene.name(scene.body)} touches itself",
                             "exclude the pair in the model: its forces cancel")
        other = scene.whole(int(pair[mine.index(False)]), place)
        if int(contact.efc_address) < 0:
            if int(getattr(contact, "exclude", 0)) == _PASSIVE:
                raise InputError("", place, "it pushes by a passive force, which is no contact force",
                                 "make it a contact of the constraint solver")
            continue  # in its margin, and does not touch
        touched[other] = None
        normal = as_array(contact.frame, f"{place}.frame").reshape(-1)[:3].tolist()
        rows.append((place, as_array(contact.pos, f"{place}.pos").tolist(),
                     normal if mine[1] else negated(normal, f"{place}.frame"),
                     _friction_of(contact, place) if friction is None else 0,
                     pushing(place, _force_of(model, data, contact, place)) if given is None else given[i],
                     # a constraint begins to push at the margin
                     _core.exact(contact.dist, f"{place}.dist")
                     - _core.exact(contact.includemargin, f"{place}.includemargin")))
    others = [] if fixed is True else [b for b in touched if b not in {0, *scene.all_of(fixed)}]
    if others:
        names = ", ".join(map(scene.name, others))
        raise InputError("", "fixed", f"{scene.name(scene.body)} touches what moves: {names}",
                         "one body moves here: say which others are taken as fixed, as in "
                         f"fixed={others}, or that all are, fixed=True")
    _refuse_adhesion(scene, data, {scene.held, *touched})
    places = [row[0] for row in rows]
    stiffness, preload = springs(places, [row[4] for row in rows],
                                 [row[5] for row in rows] if stiffness is None else None,
                                 stiffness, preload)
    return Contacts([row[1] for row in rows], [row[2] for row in rows],
                    [row[3] for row in rows] if friction is None else friction, stiffness, preload)


def _friction_of(contact: Any, place: str) -> Any:
    dimensions = int(contact.dim)
    if dimensions == 1:
        return 0
    along, across = contact.friction[0], contact.friction[1]
    if along != across:
        raise InputError("", f"{place}.friction", f"sliding has {along} one way and {across} across",
                         "cones are round here: make both equal in the model, or give friction")
    if dimensions != 3:
        raise InputError("", f"{place}.dim", f"condim is {dimensions}: friction against "
                         + ("spinning" if dimensions == 4 else "spinning and rolling"),
                         "points have none: set condim to 3, or give friction, of sliding alone")
    return along


def _force_of(model: Any, data: Any, contact: Any, place: str) -> Fraction:
    """The normal force, as mj_contactForce finds it."""
    first, dimensions = int(contact.efc_address), int(contact.dim)
    edges = 2 * (dimensions - 1) if int(_of(model, "opt", "model").cone) == _PYRAMIDAL else 1
    values = [_of(data, "efc_force", "data")[first + k] for k in range(max(1, edges))]
    return sum((_core.exact(value, place) for value in values), Fraction(0))


def _refuse_adhesion(scene: _Scene, data: Any, wholes: Set[int]) -> None:
    """It presses contacts of these bodies without being a force on them."""
    for i, kind in enumerate(getattr(scene.model, "actuator_trntype", ())):
        if int(kind) == _TO_BODY and data.actuator_force[i] != 0 \
                and scene.welded[int(scene.model.actuator_trnid[i][0])] in wholes:
            raise InputError("", f"data.actuator_force[{i}]", "an actuator of adhesion pulls",
                             "contacts never pull here: switch it off, settle, and read again")


def weight_of(model: Any, data: Any, body: Any, gravity: Any) -> Numbers:
    """The wrench about the world's origin of the weight of the body and of what is welded to it."""
    scene = _Scene(model, body)
    acceleration = exact_vector(model.opt.gravity if gravity is True else gravity, "gravity")
    total = [Fraction(0)] * 6
    for b, whole in enumerate(scene.welded):
        if whole == scene.held:
            mass = _core.exact(_of(model, "body_mass", "model")[b], f"model.body_mass[{b}]")
            force = [mass * g for g in acceleration]
            centre = exact_vector(_of(data, "xipos", "data")[b], f"data.xipos[{b}]")
            total = [x + y for x, y in zip(total, [*force, *cross(centre, force)])]
    return total


# Drake: PointPairContactInfo, PenetrationAsPointPair and ContactResults.


def _said(thing: Any, name: str, place: str) -> Any:
    """An attribute, or what the method of that name returns."""
    try:
        value = getattr(thing, name)
    except AttributeError:
        raise InputError("", f"{place}.{name}", f"{found(thing)} has no such attribute",
                         "give ContactResults, PointPairContactInfo or PenetrationAsPointPair of "
                         "Drake") from None
    return value() if callable(value) else value


def _point_pairs(contacts: Any) -> List[Any]:
    if not hasattr(contacts, "num_point_pair_contacts"):
        if isinstance(contacts, Iterable):
            return list(contacts)
        raise InputError("", "contacts", f"this is {found(contacts)}",
                         "give ContactResults of Drake, or a list of point pairs")
    for kind in ("hydroelastic", "deformable"):
        count = getattr(contacts, f"num_{kind}_contacts", lambda: 0)()
        if count > 0:
            raise InputError("", "contacts", f"{count} contacts are {kind}: they bear over areas",
                             "contacts are points here: simulate with ContactModel.kPoint, or give "
                             "a list of the point pairs")
    return [contacts.point_pair_contact_info(i) for i in range(contacts.num_point_pair_contacts())]


def from_drake(contacts: Any, body: Any, friction: Any, stiffness: Any, forces: Any,
               preload: Any) -> Contacts:
    all_pairs = _point_pairs(contacts)
    m = len(all_pairs)
    bodies = list(body) if isinstance(body, Iterable) and not isinstance(body, str) else [body]
    given = normal_forces(forces, m, False)
    each = None if callable(friction) else as_numbers(friction, "friction", m)
    rows: List[Tuple[str, Numbers, Numbers, Any, Optional[Fraction], Fraction]] = []
    for i, one in enumerate(all_pairs):
        place = f"contacts[{i}]"
        told = hasattr(one, "point_pair")
        pair = _said(one, "point_pair", place) if told else one
        ends = [_said(one, name, place) for name in
                (("bodyA_index", "bodyB_index") if told else ("id_A", "id_B"))]
        mine = [any(end == b for b in bodies) for end in ends]
        if not any(mine):
            continue
        if all(mine):
            raise InputError("", place, "the body touches itself", "leave the contact out: its "
                             "forces cancel")
        a, b, to_a = (exact_vector(_said(pair, name, place), f"{place}.{name}")
                      for name in ("p_WCa", "p_WCb", "nhat_BA_W"))
        if dot([y - x for x, y in zip(a, b)], to_a) < 0:
            raise InputError("", f"{place}.nhat_BA_W", "the points are apart along the normal, which "
                             "is to lead from B to A", "give point pairs that penetrate")
        force = given[i] if given is not None else None
        if force is None and told:  # that on B, along the unit normal into B
            force = pushing(place, -dot(exact_vector(_said(one, "contact_force", place),
                                                     f"{place}.contact_force"), to_a))
        position = (exact_vector(_said(one, "contact_point", place), f"{place}.contact_point")
                    if told else [(x + y) / 2 for x, y in zip(a, b)])
        rows.append((place, position, to_a if mine[0] else [-x for x in to_a],
                     friction(pair) if callable(friction) else each[i] if isinstance(each, list) else each,
                     force, -_core.exact(as_number(_said(pair, "depth", place), place),
                                         f"{place}.depth")))
    known = [row[4] for row in rows if row[4] is not None]
    if 0 < len(known) < len(rows):
        raise InputError("", "contacts", "some have forces, and some are bare point pairs",
                         "give one kind, or forces")
    told_forces = known if known else None
    if told_forces is None and stiffness is None and rows:
        raise InputError("", "stiffness", "point pairs have no forces",
                         "give stiffness, which times depth is the preload, or forces")
    needs_depths = rows and (told_forces is None or stiffness is None)
    stiffness, preload = springs([row[0] for row in rows], told_forces,
                                 [row[5] for row in rows] if needs_depths else None, stiffness, preload)
    return Contacts([row[1] for row in rows], [row[2] for row in rows], [row[3] for row in rows],
                    stiffness, preload)
