# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of simulators by the names that these give things: of MuJoCo what a run of it wrote
(bench/engines/drivers/mujoco_contacts.mjs), of Drake numbers."""

import copy
import json
from types import SimpleNamespace

from conftest import ROOT

MUJOCO = ROOT / "tests" / "corpus" / "contacts" / "mujoco.json"


def written(name):
    return json.loads(MUJOCO.read_text())[name]


def mujoco_scene(name):
    """(model, data), of lists."""
    scene = written(name)
    names = scene["model"].pop("names")

    def body(which):
        if isinstance(which, str) and which not in names:
            raise KeyError(which)
        return (SimpleNamespace(id=names.index(which)) if isinstance(which, str)
                else SimpleNamespace(name=names[which]))

    model = SimpleNamespace(**{**scene["model"], "opt": SimpleNamespace(**scene["model"]["opt"])}, body=body)
    data = SimpleNamespace(**{**scene["data"],
                              "contact": [SimpleNamespace(**c) for c in scene["data"]["contact"]]})
    return model, data


class PointPair(SimpleNamespace):
    """PenetrationAsPointPair: its members are attributes."""


class ContactInfo:
    """PointPairContactInfo: its members are methods."""

    def __init__(self, body_a, body_b, force_on_b, point, pair):
        self.bodyA_index = lambda: body_a
        self.bodyB_index = lambda: body_b
        self.contact_force = lambda: force_on_b
        self.contact_point = lambda: point
        self.point_pair = lambda: pair


class ContactResults:
    def __init__(self, infos, hydroelastic=0):
        self.infos = infos
        self.num_point_pair_contacts = lambda: len(infos)
        self.point_pair_contact_info = lambda i: infos[i]
        self.num_hydroelastic_contacts = lambda: hydroelastic


def drake_pair(swapped=False):
    """Bodies 1 and 2 press on body 3, a ball of radius 1 at (0, 0, 1), from both sides of x, with 4
    and depth 1/8; B is the ball, or A. A pair of bodies 1 and 2 is no business of it."""
    infos = []
    for body, side in ((1, -1.0), (2, 1.0)):
        skin, finger = [side, 0.0, 1.0], [side * 0.875, 0.0, 1.0]  # the finger is in the ball
        if swapped:  # A is the ball: the normal leads from the finger into it
            pair = PointPair(id_A=30, id_B=10 * body, p_WCa=skin, p_WCb=finger,
                             nhat_BA_W=[-side, 0.0, 0.0], depth=0.125)
            infos.append(ContactInfo(3, body, [side * 4.0, 0.0, 1.5], [side * 0.9375, 0.0, 1.0], pair))
        else:
            pair = PointPair(id_A=10 * body, id_B=30, p_WCa=finger, p_WCb=skin,
                             nhat_BA_W=[side, 0.0, 0.0], depth=0.125)
            infos.append(ContactInfo(body, 3, [-side * 4.0, 0.0, -1.5], [side * 0.9375, 0.0, 1.0], pair))
    strange = PointPair(id_A=10, id_B=20, p_WCa=[0.0, 9.0, 0.0], p_WCb=[0.0, 9.0, 0.0],
                        nhat_BA_W=[0.0, 1.0, 0.0], depth=0.0)
    infos.insert(1, ContactInfo(1, 2, [0.0, 0.0, 0.0], [0.0, 9.0, 0.0], strange))
    return copy.copy(infos)
