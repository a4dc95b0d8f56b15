# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of simulators and of meshes, against closed forms and an exact search of all triangles."""

import itertools
import pickle
import random
import shutil
import subprocess
from collections import namedtuple
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from conftest import ROOT
from scenes import MUJOCO, ContactResults, PointPair, drake_pair, mujoco_scene, written
from stickslip import Grasp, InputError, decide

AXES = np.array([[1.0, 0, 0], [-1.0, 0, 0]])
SIDES = np.array([[-2.0, 0, 0], [2.0, 0, 0]])


def refusal(call):
    with pytest.raises(InputError) as caught:
        call()
    assert caught.value.problem and caught.value.remedy
    return caught.value.place, str(caught.value)


def assert_proved(grasp, verdict, load=None):
    answer = decide(grasp, load)
    assert answer.verdict == verdict and answer.check()


# Arrays and records


def test_normals_are_of_the_body_that_is_named():
    expected = Grasp(SIDES, AXES, "1/2", preload=4)
    assert Grasp.from_contacts(SIDES, AXES, "1/2", into="body", forces=4) == expected
    assert Grasp.from_contacts(SIDES, -AXES, "1/2", into="other", forces=[4, "4"]) == expected
    mixed = np.array([AXES[0], -AXES[1]])
    assert Grasp.from_contacts(SIDES, mixed, "1/2", into=["body", "other"], preload=4) == expected
    assert Grasp.from_contacts(SIDES, [["-1/3", 0, 0], [1, 0, 0]], 1, into="other").normals == (
        (Fraction(1, 3), 0, 0), (-1, 0, 0))
    assert Grasp.from_contacts([[-1, 0]], [[-1, 0]], 1, into="other").normals == ((1, 0),)
    for wrong in (None, "mine", ["body"], ["body", "it"]):
        assert refusal(lambda: Grasp.from_contacts(SIDES, AXES, 1, into=wrong))[0].startswith("into")


def test_the_first_rows_of_frames_are_normals_and_their_forces():
    rows = [[n, [0, 1, 0], [0, 0, 1]] for n in AXES]
    forces = [[4, 1, 0], [5, 2, 9]]
    expected = Grasp(SIDES, AXES, 1, preload=[4, 5])
    for frames in (rows, np.array(rows), np.array(rows).reshape(2, 9)):
        assert Grasp.from_contacts(SIDES, None, 1, into="body", frames=frames, forces=forces) == expected
    plane = Grasp.from_contacts([[-1, 0], [1, 0]], None, 1, into="other", forces=[[4, 1], [5, 2]],
                                frames=[[[-1, 0], [0, 1]], [[1, 0], [0, 1]]])
    assert plane == Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], 1, preload=[4, 5])
    assert len(Grasp.from_contacts([], [], 1, into="body", forces=[], distance=[])) == 0
    assert refusal(lambda: Grasp.from_contacts(SIDES, AXES, 1, into="body", forces=forces))[0] == "forces"
    assert refusal(lambda: Grasp.from_contacts(SIDES, AXES, 1, into="body", frames=rows))[0] == "normals"
    assert refusal(lambda: Grasp.from_contacts(SIDES, None, 1, into="body"))[0] == "normals"
    assert refusal(lambda: Grasp.from_contacts(SIDES, None, 1, into="body", frames=AXES))[0] == "frames"


def test_records_are_the_same():
    expected = Grasp(SIDES, AXES, ["1/2", "1/4"], [40, 10], [4, 1], wrench=(0, 0, -1, 0, 0, 0))
    fields = ("position", "normal", "friction", "force", "distance")
    rows = [(tuple(SIDES[0]), tuple(-AXES[0]), "1/2", 4, "-0.1"), (tuple(SIDES[1]), tuple(-AXES[1]), "1/4", 1, "-0.1")]
    table = np.array([(p, n, float(Fraction(f)), force, -0.125) for p, n, f, force, _ in rows],
                     dtype=[("position", float, 3), ("normal", float, 3), ("friction", float),
                            ("force", float), ("distance", float)])
    record = namedtuple("record", fields)
    for records in ([dict(zip(fields, row)) for row in rows], [record(*row) for row in rows],
                    tuple(SimpleNamespace(**dict(zip(fields, row))) for row in rows)):
        assert Grasp.from_contacts(records, into="other", wrench=expected.wrench) == expected
    assert Grasp.from_contacts(table, into="other").stiffness == (32, 8)
    some = [{"position": p, "normal": n, "into": "body"} for p, n in zip(SIDES, AXES)]
    assert Grasp.from_contacts(some, friction=1) == Grasp(SIDES, AXES, 1)
    assert refusal(lambda: Grasp.from_contacts(some, friction=1, into="body"))[0] == "into"
    assert refusal(lambda: Grasp.from_contacts(some))[0] == "friction"
    assert refusal(lambda: Grasp.from_contacts([some[0], {**some[1], "forces": 1}], friction=1)) == (
        "positions[1]", "positions[1]: the record has the unknown key 'forces'; the keys of records are position, "
        "normal, frame, friction, into, force, distance, stiffness, preload")
    del some[1]["normal"]
    assert refusal(lambda: Grasp.from_contacts(some, friction=1))[0] == "positions[1]"


@pytest.mark.parametrize("given, stiffness, preload", [
    ({}, 1, 0), ({"forces": 3}, 1, 3), ({"stiffness": 7}, 7, 0), ({"forces": 3, "stiffness": 7}, 7, 3),
    ({"forces": 3, "distance": "-1/7"}, 21, 3), ({"stiffness": 21, "distance": "-1/7"}, 21, 3),
    ({"stiffness": [21], "distance": 0}, 21, 0), ({"forces": 3, "distance": "-1/7", "preload": 0}, 21, 0),
    ({"stiffness": 5, "preload": 2}, 5, 2)], ids=str)
def test_force_is_stiffness_times_penetration(given, stiffness, preload):
    grasp = Grasp.from_contacts(SIDES[:1], AXES[:1], 1, into="body", **given)
    assert (grasp.stiffness, grasp.preload) == ((stiffness,), (preload,))
    assert ('"stiffness"' in grasp.to_text()) and grasp == Grasp(SIDES[:1], AXES[:1], 1, stiffness, preload)


@pytest.mark.parametrize("given, place, says", [
    ({"forces": [1, -3]}, "forces[1]", "it pulls"),
    ({"forces": [1, -3], "distance": -1}, "forces[1]", "it pulls"),
    ({"forces": 3, "distance": [-1, "1/4"]}, "distance[1]", "a gap of 1/4"),
    ({"stiffness": 3, "distance": [-1, "1/4"]}, "distance[1]", "a gap of 1/4"),
    ({"forces": [3, 0], "distance": -1}, "distance[1]", "says nothing of stiffness"),
    ({"forces": 3, "distance": [-1, 0]}, "distance[1]", "says nothing of stiffness"),
    ({"distance": -1}, "distance", "neither forces nor stiffness"),
    ({"distance": -1, "forces": 1, "stiffness": 1}, "distance", "leave out one of the three"),
    ({"forces": [1, 2, 3]}, "forces", "the shape is (3,)"), ({"forces": [1, "x"]}, "forces[1]", ""),
    ({"grid": 0}, "grid", "above 0")], ids=str)
def test_what_springs_cannot_be(given, place, says):
    found, text = refusal(lambda: Grasp.from_contacts(SIDES, AXES, 1, into="body", **given))
    assert found == place and says in text


def test_grid():
    grasp = Grasp.from_contacts([[0.1, "-0.26", "0.25"]], [[0, 0, 1]], 1, into="body", grid="0.1")
    assert grasp.positions == ((Fraction(1, 10), Fraction(-3, 10), Fraction(1, 5)),)


def test_doubles_in_the_plane_are_rounded_as_those_of_a_grasp():
    angle = np.array([0.3, 2.5, 4.4])
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    given = Grasp(circle, -circle, 0.5, preload=1)
    read = Grasp.from_contacts(circle, circle, 0.5, into="other", forces=1)
    assert read == given and decide(read, (0, 0, 0.25)) == decide(given, (0, 0, 0.25))
    assert len(decide(read, (0, 0, 0.25)).snapped) == 3


# MuJoCo


def gripped(**options):
    return Grasp.from_mujoco(*mujoco_scene("gripper"), "object", **{"fixed": True, **options})


def resting(**options):
    return Grasp.from_mujoco(*mujoco_scene("resting"), "box", **options)


@pytest.mark.parametrize("name, body, first", [("gripper", "object", True), ("resting", "box", False)])
def test_a_run_of_mujoco_is_read(name, body, first):
    model, data = mujoco_scene(name)
    number = model.body(body).id
    assert all((model.geom_bodyid[c.geom[0]] == number) == first for c in data.contact)  # both orders
    grasp = Grasp.from_mujoco(model, data, body, fixed=True)
    assert grasp == Grasp.from_mujoco(model, data, number, fixed=True) and grasp.wrench is None
    # Normals into the body: its boxes are convex, and their centres inside.
    for position, normal in zip(grasp.positions_float, grasp.normals_float):
        assert np.dot(data.xipos[number] - position, normal) > 0.01
    forces = [row[0] for row in written(name)["forces"]]  # of mj_contactForce
    np.testing.assert_allclose(grasp.preload_float, forces, rtol=1e-12)
    depths = np.array([-c.dist for c in data.contact])
    np.testing.assert_allclose(grasp.stiffness_float * depths, forces, rtol=1e-12)
    given = Grasp.from_mujoco(model, data, body, fixed=True, forces=written(name)["forces"], stiffness=5)
    assert given.preload == tuple(map(Fraction, forces)) and set(given.stiffness) == {5}
    assert given == Grasp.from_mujoco(model, data, body, fixed=True, forces=forces, stiffness=5)


def test_the_order_of_the_two_geoms_does_not_matter():
    model, data = mujoco_scene("gripper")
    for contact in data.contact[::2]:
        contact.geom = contact.geom[::-1]
        contact.frame = [-x for x in contact.frame[:3]] + contact.frame[3:]
    for contact in data.contact[1::3]:  # its name of old
        contact.geom1, contact.geom2 = contact.geom
        del contact.geom
    assert Grasp.from_mujoco(model, data, "object", fixed=(2, "right")) == gripped()


def test_a_gripper_holds_what_friction_does():
    """Two jaws press with 10 each, friction is 0.4, and the mass 0.3: 8 is held, all contacts alike."""
    for down, verdict in ((-26, "stable"), (-27, "unstable")):
        grasp = gripped(gravity=(0, 0, down))
        assert float(grasp.wrench[2]) == pytest.approx(0.3 * down)
        assert_proved(grasp, verdict)
    assert gripped(gravity=True).wrench == (0,) * 6  # that of the model is none
    pushed = gripped(gravity=(0, 0, -1), wrench=(1, 0, 0, 0, "1/2", 0))
    assert pushed.wrench[0] == 1 and pushed.wrench[2] < 0
    assert pushed.wrench[4] == gripped(gravity=(0, 0, -1)).wrench[4] + Fraction(1, 2)


def test_a_box_on_the_floor_slides_at_its_friction_and_sinks_by_its_penetration():
    """20 N, friction 1/2; positions to a millimetre: penetrations are a tenth of one."""
    data = mujoco_scene("resting")[1]
    feet = resting(preload=0, gravity=True, grid="1/1000")
    assert feet.preload == (0,) * 4 and feet.wrench[:3] == (0, 0, -20)
    x, y, z = map(Fraction, data.xipos[1])
    assert feet.wrench[3:] == (-20 * y, 20 * x, 0)
    assert_proved(feet, "stable")
    answer = decide(feet)
    d = answer.near_float if answer.twist is None else answer.twist_float
    for position, contact in zip(feet.positions_float, data.contact):
        assert (d[:3] + np.cross(d[3:], position))[2] == pytest.approx(contact.dist, rel=1e-6)
    # In doubles as they are, feet are not in a plane: all that rub slip a little.
    for loaded in (feet, resting(gravity=True, grid="1/1000"), resting(preload=0, gravity=True),
                   resting(gravity=True)):
        for push, verdict in (("9.9", "stable"), ("10.1", "unstable")):
            push = Fraction(push)
            load = [a + b for a, b in zip(loaded.wrench, (push, 0, 0, 0, 0, -push / 10))]
            assert_proved(loaded, verdict, load)


def test_forces_under_a_load_that_is_not_asked_about_are_warned_of():
    def traps(grasp, load):
        return [w.trap for w in decide(grasp, load, warnings=True).warnings]

    push = (1, 0, 0, 0, 0, "-1/10")
    assert "unbalanced-preload" in traps(resting(grid="1/1000"), push)
    weight = resting(gravity=True).wrench
    assert "unbalanced-preload" not in traps(resting(preload=0, grid="1/1000"), weight)
    assert traps(gripped(), (0, 0, -1, 0, 0, 0)) == []


def change(scene, **changes):
    """In the model, the data or its contact 0, whichever has the attribute."""
    model, data = scene
    for name, value in changes.items():
        thing = next(t for t in (model, data, data.contact[0]) if hasattr(t, name))
        setattr(thing, name, value)
    return model, data


@pytest.mark.parametrize("changes, options, place, says", [
    ({"friction": [0.5, 0.4, 0, 0, 0]}, {}, "data.contact[0].friction", "make both equal"),
    ({"dim": 4}, {}, "data.contact[0].dim", "against spinning;"),
    ({"dim": 6}, {}, "data.contact[0].dim", "spinning and rolling"),
    ({}, {"forces": [-1] + [1] * 7}, "forces[0]", "it pulls"),
    ({"efc_force": [-1.0] * 32}, {}, "data.contact[0]", "it pulls"),
    ({"dist": 0.001}, {}, "data.contact[0]", "a gap"),
    ({"geom": [0, 0]}, {}, "data.contact[0]", "touches itself"),
    ({"geom": [0, -1]}, {}, "data.contact[0]", "flexible"),
    ({"efc_address": -1, "exclude": 4}, {}, "data.contact[0]", "passive"),
    ({}, {"fixed": ()}, "fixed", "body 'left', body 'right'"),
    ({}, {"fixed": False}, "fixed", "fixed=[2, 3]"), ({}, {"fixed": "left"}, "fixed", "moves: body 'right'"),
    ({}, {"fixed": ["leg"]}, "fixed", "no body 'leg'"),
    ({"body_dofnum": [0, 3, 1, 1]}, {}, "body", "3 degrees of freedom"),
    ({"body_weldid": [0, 0, 2, 3]}, {}, "body", "fixed to the world"),
    ({"body_rootid": [0, 1, 1, 3]}, {}, "body", "body 'left' hangs on body 'object'"),
    ({"actuator_trntype": [0, 5], "actuator_trnid": [[0, -1], [2, -1]]}, {}, "data.actuator_force[1]", "adhesion"),
    ({}, {"forces": [1, 2]}, "forces", "shape is (2,)"), ({}, {"gravity": (0, 1)}, "gravity", "(2,)")],
    ids=str)
def test_what_mujoco_has_and_the_model_has_not(changes, options, place, says):
    model, data = mujoco_scene("gripper")
    model.actuator_trnid = [[0, -1], [1, -1]]
    model, data = change((model, data), **changes)
    found, text = refusal(lambda: Grasp.from_mujoco(model, data, "object", **{"fixed": True, **options}))
    assert found == place and says in text


def test_what_the_remedies_say():
    anisotropic = change(mujoco_scene("gripper"), friction=[0.5, 0.4, 0, 0, 0], dim=4)
    # Pyramids have two edges more then.
    taken = Grasp.from_mujoco(*anisotropic, "object", fixed=True, friction="0.4", forces=[2] * 8)
    assert set(taken.friction) == {Fraction(2, 5)} and set(taken.preload) == {2}
    early = Grasp.from_mujoco(*change(mujoco_scene("resting"), dist=0.25, includemargin=0.5), "box")
    assert early.stiffness[0] == early.preload[0] * 4  # pushed back from the margin on
    smooth = Grasp.from_mujoco(*change(mujoco_scene("resting"), dim=1), "box")
    assert smooth.friction[0] == 0 and smooth.friction[1] == Fraction(1, 2)
    apart = Grasp.from_mujoco(*change(mujoco_scene("resting"), efc_address=-1, exclude=1), "box")
    assert apart.positions == resting().positions[1:]
    model, data = mujoco_scene("gripper")
    model.actuator_trntype, model.actuator_trnid, data.actuator_force = [0, 5], [[0, -1], [3, -1]], [1, 0]
    assert Grasp.from_mujoco(model, data, "object", fixed=True) == gripped()  # it is off
    for body in ("cup", 0, 4, -1, 1.0, True):
        assert refusal(lambda: Grasp.from_mujoco(model, data, body))[0] == "body"
    assert refusal(lambda: Grasp.from_mujoco(data, model, 1))[0].startswith("model.")
    alone = mujoco_scene("resting")
    alone[1].ncon = 0
    free = Grasp.from_mujoco(*alone, "box", gravity=True)
    assert len(free) == 0 and free.in_space and decide(free).verdict == "unstable"


def test_the_file_is_what_mujoco_writes():
    package = ROOT / "bench" / "engines" / "node_modules" / "@mujoco" / "mujoco"
    if shutil.which("node") is None or not package.exists():
        pytest.skip("MuJoCo is not installed (bench/engines/install.sh)")
    script = ROOT / "bench" / "engines" / "drivers" / "mujoco_contacts.mjs"
    done = subprocess.run(["node", script], capture_output=True, text=True, check=True, timeout=300)
    assert done.stdout == MUJOCO.read_text()


# Drake


def test_a_pair_of_drake():
    """Two fingers of 4 with friction 1/2 hold 4."""
    expected = Grasp([[-0.9375, 0, 1], [0.9375, 0, 1]], AXES, "1/2", 32, 4)
    for infos in (drake_pair(), drake_pair(swapped=True)):
        for contacts in (infos, ContactResults(infos)):
            assert Grasp.from_drake(contacts, 3, "1/2") == expected
        pairs = [info.point_pair() for info in infos]
        for body in (30, [30, 31], {30}):
            assert Grasp.from_drake(pairs, body, "1/2", stiffness=32) == expected
        assert Grasp.from_drake(pairs, 30, "1/2", forces=[4, 0, 4]) == expected
    for weight, verdict in ((4, "stable"), (5, "unstable")):
        load = (0, 0, -weight, 0, 0, 0)
        assert_proved(Grasp.from_drake(drake_pair(), 3, "1/2", wrench=load), verdict)


def test_options_of_drake():
    by_pair = Grasp.from_drake(drake_pair(), 3, lambda pair: Fraction(min(pair.id_A, pair.id_B), 100))
    assert by_pair.friction == (Fraction(1, 10), Fraction(1, 5))
    assert Grasp.from_drake(drake_pair(), 3, [1, 7, 2]).friction == (1, 2)
    unloaded = Grasp.from_drake(drake_pair(), 3, 1, preload=0, grid="1/2")
    assert (unloaded.preload, unloaded.stiffness) == ((0, 0), (32, 32))
    assert unloaded.positions == ((-1, 0, 1), (1, 0, 1))
    assert len(Grasp.from_drake([], 3, 1)) == 0 and Grasp.from_drake([], 3, 1).in_space
    pairs = [info.point_pair() for info in drake_pair()]
    wrong = PointPair(**{**vars(pairs[0]), "nhat_BA_W": [1.0, 0.0, 0.0]})
    pulled = drake_pair()[0]
    pulled.contact_force = lambda: [-4.0, 0.0, 0.0]
    for call, place, says in (
            (lambda: Grasp.from_drake(pairs, 30, 1), "stiffness", "no forces"),
            (lambda: Grasp.from_drake([*drake_pair(), pairs[0]], [3, 30], 1), "contacts", "bare point pairs"),
            (lambda: Grasp.from_drake(pairs, [10, 30], 1, stiffness=1), "contacts[0]", "touches itself"),
            (lambda: Grasp.from_drake([wrong], 30, 1, stiffness=1), "contacts[0].nhat_BA_W", "from B to A"),
            (lambda: Grasp.from_drake([drake_pair()[0], pulled], 3, 1), "contacts[1]", "it pulls"),
            (lambda: Grasp.from_drake(ContactResults([], 2), 3, 1), "contacts", "2 contacts are hydroelastic"),
            (lambda: Grasp.from_drake(pairs, 30, [1, 2], stiffness=1), "friction", "(2,)"),
            (lambda: Grasp.from_drake(3, 30, 1), "contacts", "point pairs"),
            (lambda: Grasp.from_drake([3], 30, 1), "contacts[0].id_A", "no such attribute")):
        found, text = refusal(call)
        assert found == place and says in text


# Meshes

CUBE = (np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]),
        np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]))


def star(seed, scale=1, rings=5, sides=7):
    """A surface around the origin, closed and rough, with whole numbers times a scale."""
    chance = random.Random(seed)
    ends = [(0, 0, -40), (0, 0, 40)]
    vertices = [(round(chance.uniform(20, 40) * np.cos(2 * np.pi * k / sides)),
                 round(chance.uniform(20, 40) * np.sin(2 * np.pi * k / sides)), 12 * (r - rings // 2))
                for r in range(rings) for k in range(sides)] + ends
    faces = []
    for k in range(sides):
        after = (k + 1) % sides
        for r in range(rings - 1):
            a, b, c, d = r * sides + k, r * sides + after, (r + 1) * sides + k, (r + 1) * sides + after
            faces += [(a, b, d), (a, d, c)]
        faces += [(after, k, len(vertices) - 2), ((rings - 1) * sides + k, (rings - 1) * sides + after,
                                                  len(vertices) - 1)]
    chance.shuffle(faces)
    return [tuple(scale * x for x in v) for v in vertices], faces


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def squared_distance(p, triangle):
    """The least over all places where the nearest point can be: vertices, feet on edges, foot inside."""
    found = [dot(minus(p, v), minus(p, v)) for v in triangle]
    for a, b in itertools.combinations(triangle, 2):
        e, w = minus(b, a), minus(p, a)
        if 0 <= dot(w, e) <= dot(e, e):
            found.append(dot(w, w) - Fraction(dot(w, e) ** 2) / dot(e, e))
    a, b, c = triangle
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    uu, uv, vv, wu, wv = dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)
    det = uu * vv - uv * uv
    s, t = Fraction(wu * vv - wv * uv) / det, Fraction(wv * uu - wu * uv) / det
    if s >= 0 and t >= 0 and s + t <= 1:
        found.append(dot(w, w) - s * wu - t * wv)
    return min(found)


def assert_nearest(vertices, faces, point, on, i):
    """By a search of all triangles, and by the condition that holds for the nearest point alone."""
    point = tuple(map(Fraction, point))
    triangles = [[tuple(map(Fraction, vertices[v])) for v in face] for face in faces]
    q, normal, f = on.grasp.positions[i], on.grasp.normals[i], on.faces[i]
    away = minus(point, q)
    distances = [squared_distance(point, triangle) for triangle in triangles]
    assert dot(away, away) == min(distances)
    assert f == distances.index(min(distances))
    assert all(dot(away, minus(corner, q)) <= 0 for corner in triangles[f])
    a, b, c = triangles[f]
    outward = cross(minus(b, a), minus(c, a))
    assert dot(minus(q, a), outward) == 0  # on the triangle's plane; inside by the distance
    assert cross(outward, normal) == (0, 0, 0) and dot(outward, normal) < 0
    moved = on.moved[i]
    assert moved == float("inf") if min(distances) > 2 ** 2048 else (
        abs(Fraction(moved) ** 2 - min(distances)) <= min(distances) / 2 ** 50)


@pytest.mark.parametrize("seed, scale", [(1, 1), (2, Fraction(1, 7)), (3, 2 ** -700), (4, 2 ** 700),
                                         (5, Fraction(10) ** 400)],
                         ids=["whole", "sevenths", "tiny", "huge", "beyond doubles"])
def test_the_nearest_place_of_a_mesh(seed, scale):
    scale = Fraction(scale)
    vertices, faces = star(seed, scale)
    chance = random.Random(seed)
    points = [[scale * Fraction(chance.randint(-90, 90), 2) for _ in range(3)] for _ in range(25)]
    points += [vertices[0], [(a + b) / 2 for a, b in zip(*(vertices[v] for v in faces[3][:2]))], (0, 0, 0)]
    on = Grasp.from_mesh((vertices, faces), points, 1, tolerance=1000 * scale)
    for i, point in enumerate(points):
        assert_nearest(vertices, faces, point, on, i)


@pytest.mark.parametrize("half", [Fraction(8, 2 ** 15), Fraction(5, 2 ** 15)], ids=["a double", "none"])
def test_doubles_decide_nothing_of_a_mesh(half):
    """Far from the origin the sides of a cube are equally near in doubles, and not exactly; or doubles
    have them elsewhere."""
    far = 2 ** 40
    vertices = [[far + half * int(x) for x in row] for row in CUBE[0]]
    tiny = Fraction(1, 2 ** 80)
    middle = [Fraction(far)] * 3
    for k in range(3):
        for sign in (-1, 1):
            point = list(middle)
            point[k] += sign * tiny
            on = Grasp.from_mesh((vertices, CUBE[1]), [point], 1, tolerance=1)
            assert_nearest(vertices, CUBE[1], point, on, 0)
            assert on.grasp.normals[0] == tuple(-sign * (j == k) for j in range(3))


def test_ties_go_to_the_first_face():
    for order in ([*range(12)], [*range(11, -1, -1)]):
        faces = CUBE[1][order]
        points = [[0, 0, 0], [1, 1, 1], [1, 0, 1], [3, 3, 3], [0, 0, 1]]
        on = Grasp.from_mesh((CUBE[0], faces), points, 1, tolerance=5)
        for i, point in enumerate(points):
            assert_nearest(CUBE[0], faces, point, on, i)
        assert on.faces[0] == 0 and on.moved[0] == 1


def test_a_cube_is_held_as_its_contacts_say():
    mesh = SimpleNamespace(vertices=CUBE[0].astype(float), faces=CUBE[1])  # as of trimesh
    on = Grasp.from_mesh(mesh, [[-1, 0, 0], [1.25, 0, 0]], "1/2", preload=4, tolerance="1/4", name="cube",
                         wrench=(0, 0, -4, 0, 0, 0))
    assert on.moved == (0, 0.25)
    assert on.grasp == Grasp([[-1, 0, 0], [1, 0, 0]], AXES, "1/2", preload=4, name="cube",
                             wrench=(0, 0, -4, 0, 0, 0), body=on.grasp.body)
    assert_proved(on.grasp, "stable")
    assert_proved(on.grasp, "unstable", (0, 0, -5, 0, 0, 0))
    # On slanted triangles, whose normals have irrational lengths, and at places with long numbers.
    octahedron = (np.array([[1.1, 0, 0], [-1.1, 0, 0], [0, 1.1, 0], [0, -1.1, 0], [0, 0, 1.1], [0, 0, -1.1]]),
                  [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    corners = [(x, y, z) for x in (-0.4, 0.4) for y in (-0.4, 0.4) for z in (-0.4, 0.4)]
    on = Grasp.from_mesh(octahedron, corners, 1, preload=1, tolerance=1)
    assert max(on.moved) < 0.1
    assert all(np.array_equal(np.sign(n), -np.sign(c)) for n, c in zip(on.grasp.normals_float, corners))
    assert_proved(on.grasp, "stable", (0, 0, "-1/10", 0, 0, 0))


def test_vertices_at_one_place_are_one():
    soup = (CUBE[0][CUBE[1]].reshape(-1, 3), np.arange(36).reshape(12, 3))  # as in STL files
    points = [[-1, 0, 0], ["1/2", "1/2", 1]]
    assert Grasp.from_mesh(soup, points, 1) == Grasp.from_mesh(CUBE, points, 1)
    collapsed = (CUBE[0], [*CUBE[1].tolist(), [0, 0, 1], [5, 5, 5]])
    assert Grasp.from_mesh(collapsed, points, 1) == Grasp.from_mesh(CUBE, points, 1)


def test_the_mesh_is_the_body(tmp_path):
    unused = (np.concatenate([[[9, 9, 9]], CUBE[0]]), CUBE[1] + 1)
    body = Grasp.from_mesh(unused, [[1, 0, 0]], 1).grasp.body
    # The same triangles, without the vertex that none has.
    triangles = [[tuple(unused[0][v]) for v in face] for face in unused[1]]
    assert len(body.vertices) == 8 and [[body.vertices[v] for v in face] for face in body.faces] == triangles
    grasp = Grasp([[1, 0, 0]], [[-1, 0, 0]], 1, body=([[0, 0, 0], ["1/3", 0, 0], [0, 0.1, 0]], [[0, 1, 2]]))
    path = tmp_path / "grasp.json"
    path.write_text(grasp.to_text(), encoding="utf-8")
    assert Grasp.from_file(path) == grasp and pickle.loads(pickle.dumps(grasp)) == grasp
    assert Grasp.from_file(path).body == (((0, 0, 0), (Fraction(1, 3), 0, 0), (0, Fraction(0.1), 0)), ((0, 1, 2),))
    assert grasp.snap().grasp.body == grasp.body
    assert Grasp([[1, 0, 0]], [[-1, 0, 0]], 1).body is None


def test_a_body_that_no_file_holds_is_left_out():
    def cone(n):  # over n corners of a polygon, with its base
        corners = [[k, k * k, 0] for k in range(n)]
        sides = [[k, (k + 1) % n, n] for k in range(n)]
        return [*corners, [0, 0, 1]], sides + [[0, k + 1, k] for k in range(1, n - 1)]

    # n + 1 vertices and 2 n - 2 faces of four values each, the two lists and the object: 65,536 at most.
    for n, kept in ((5461, True), (5462, False)):
        grasp = Grasp.from_mesh(cone(n), [[0, 0, 1]], 1).grasp
        assert (grasp.body is not None) == kept
        assert Grasp.from_text(grasp.to_text()) == grasp


def test_bodies_are_checked():
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    for body, place in (((vertices, [[0, 1]]), "body.faces[0]"), ((vertices, [[0, 1, 3]]), "body.faces[0]"),
                        ((vertices, [[0, 1, 2], [0, 1, -1]]), "body.faces[1]"), ((vertices, []), "body.faces"),
                        ((vertices, [[0, 1, 0.5]]), "body.faces[0]"), (([[0, 0]], [[0, 0, 0]]), "body.vertices"),
                        (vertices, "body"), (([[0, 0, "x"]], [[0, 0, 0]]), "body.vertices[0, 2]")):
        assert refusal(lambda: Grasp([[0, 0, 0]], [[0, 0, 1]], 1, body=body))[0] == place
    assert refusal(lambda: Grasp([[0, 0]], [[0, 1]], 1, body=(vertices, [[0, 1, 2]])))[0] == "body"


def test_holes_within_a_mesh():
    hollow = (np.concatenate([CUBE[0] * 4, CUBE[0]]), np.concatenate([CUBE[1], CUBE[1][:, ::-1] + 8]))
    on = Grasp.from_mesh(hollow, [[1, 0, "1/2"], [4, 0, 1]], 1)
    assert on.grasp.normals == ((1, 0, 0), (-1, 0, 0))


def test_an_edge_may_have_four_faces():
    two = (np.concatenate([CUBE[0], CUBE[0] + [2, 2, 0]]), np.concatenate([CUBE[1], CUBE[1] + 8]))
    assert Grasp.from_mesh(two, [[3, 2, 0], [0, 1, 0]], 1).grasp.normals == ((-1, 0, 0), (0, -1, 0))


def test_a_flat_triangle_between_others_has_no_normal():
    # The side x = 1 of a cube with a vertex in an edge of it, on one side of the edge alone.
    vertices = [*CUBE[0].tolist(), [1, 1, 0]]
    faces = [f for f in CUBE[1].tolist() if f != [4, 6, 7]] + [[4, 6, 8], [4, 8, 7], [6, 7, 8]]
    on = Grasp.from_mesh((vertices, faces), [[1, 1, 0], [1, 1, "1/2"]], 1)
    for i, point in enumerate(([1, 1, 0], [1, 1, Fraction(1, 2)])):
        assert on.grasp.positions[i] == tuple(point)
        assert any(on.grasp.normals[i])


@pytest.mark.parametrize("mesh, place, says", [
    ((CUBE[0], CUBE[1][1:]), "faces[", "has no face on its other side"),
    ((CUBE[0], np.concatenate([CUBE[1][:1, ::-1], CUBE[1][1:]])), "faces[", "runs the same way in faces"),
    ((CUBE[0], CUBE[1][:, ::-1]), "faces[0]", "inside out"),
    ((np.concatenate([CUBE[0], CUBE[0] + 5]), np.concatenate([CUBE[1], CUBE[1][:, ::-1] + 8])), "faces[12]",
     "inside out"),
    ((CUBE[0], np.concatenate([CUBE[1], CUBE[1][:1]])), "faces[12]", "runs the same way in faces 0 and 12"),
    (([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 1]]), "faces[0]", "encloses no volume"),
    ((CUBE[0], CUBE[1] + 1), "faces[2]", "8 is no vertex"), ((CUBE[0], CUBE[1] * 1.0), "faces[0]", "no vertex"),
    ((CUBE[0], [[0, 1, 3, 2]]), "faces", "three vertices"), ((CUBE[0], []), "faces", "no triangle"),
    ((CUBE[0][:, :2], CUBE[1]), "vertices", "x, y, z"), ((CUBE[0] * np.nan, CUBE[1]), "vertices[0, 0]", "finite"),
    (CUBE[0], "mesh", "vertices and faces"), ("cube.stl", "mesh", "a pair")], ids=lambda x: x if isinstance(x, str) else "")
def test_meshes_that_are_none(mesh, place, says):
    found, text = refusal(lambda: Grasp.from_mesh(mesh, [[1, 0, 0]], 1))
    assert found.startswith(place) and says in text


def test_open_edges_are_named():
    place, text = refusal(lambda: Grasp.from_mesh((CUBE[0], CUBE[1][:11]), [[1, 0, 0]], 1))
    face = int(place[6:-1])
    a, b = (int(word) for word in text.split() if word.isdigit())
    assert {a, b} < set(CUBE[1][11]) and {a, b} < set(CUBE[1][face])


def test_points_off_a_mesh():
    for tolerance, says in ((None, "give a tolerance"), ("0.2", "the tolerance is 0.2"), (-1, "the tolerance is")):
        place, text = refusal(lambda: Grasp.from_mesh(CUBE, [[1, 0, 0], [1.25, 0, 0]], 1, tolerance=tolerance))
        assert place == "points[1]" and "it is 0.25 from the mesh" in text and says in text
    assert refusal(lambda: Grasp.from_mesh(CUBE, [[1, 0]], 1))[0].startswith("points")
    assert refusal(lambda: Grasp.from_mesh(CUBE, [[1, 0, "x"]], 1))[0] == "points[0][2]"
    assert len(Grasp.from_mesh(CUBE, np.zeros((0, 3)), 1).grasp) == 0
