# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies of blocks: from files of compas_assembly, and from meshes whose faces lie on each other."""

import json
import math
import struct
from fractions import Fraction as F
from types import SimpleNamespace

import numpy as np
import pytest
import stickslip
from stickslip import Assembly, InputError, statics


def prism(polygon, low=0, high=1):
    """Along y; the polygon of (x, z) runs counterclockwise as one looks along y."""
    n = len(polygon)
    vertices = [[x, y, z] for y in (low, high) for x, z in polygon]
    sides = [[i, n + i, n + (i + 1) % n, (i + 1) % n] for i in range(n)]
    return vertices, [list(range(n)), list(range(n, 2 * n))[::-1], *sides]


def box(low, high):
    (a, b, c), (d, e, f) = low, high
    return prism([(a, c), (d, c), (d, f), (a, f)], b, e)


def triangles(mesh):
    """The same surface, with faces cut in two."""
    vertices, faces = mesh
    return vertices, [[face[0], a, b] for face in faces for a, b in zip(face[1:], face[2:])]


def moved(mesh, matrix, by=(0, 0, 0)):
    vertices, faces = mesh
    return [[sum(m * F(x) for m, x in zip(row, p)) + t for row, t in zip(matrix, by)] for p in vertices], faces


# A turn by whole numbers: its rows have the length 1.
TURN = [[F(2, 3), F(-1, 3), F(2, 3)], [F(2, 3), F(2, 3), F(-1, 3)], [F(-1, 3), F(2, 3), F(2, 3)]]


def compas_mesh(mesh, density=None):
    vertices, faces = mesh
    return {"dtype": "compas_assembly.datastructures/Block", "guid": "0", "data": {
        "attributes": {"node": None, **({} if density is None else {"density": density})},
        "default_vertex_attributes": {"x": 0.0, "y": 0.0, "z": 0.0}, "default_edge_attributes": {}, "default_face_attributes": {},
        "vertex": {str(i): dict(zip("xyz", map(float, p))) for i, p in enumerate(vertices)},
        "face": {str(f): list(face) for f, face in enumerate(faces)},
        "facedata": {}, "edgedata": {}, "max_vertex": len(vertices) - 1, "max_face": len(faces) - 1}}


def compas_interface(points, xaxis, yaxis):
    """Its third axis leads out of the block from which the edge starts."""
    return {"dtype": "compas_assembly.datastructures/Interface", "guid": "0", "data": {
        "points": [{"dtype": "compas.geometry/Point", "data": list(map(float, p)), "guid": "0"} for p in points],
        "size": 1.0, "frame": {"dtype": "compas.geometry/Frame", "guid": "0", "data": {
            "point": list(map(float, points[0])), "xaxis": list(map(float, xaxis)), "yaxis": list(map(float, yaxis))}},
        "forces": None, "mesh": None}}


def compas(blocks, edges, supports, densities=None):
    """A file of compas 2: blocks by their nodes, edges as (node, node, interface)."""
    densities = densities or {}
    node = {str(k): {"block": compas_mesh(mesh, densities.get(k)), **({"is_support": True} if k in supports else {})}
            for k, mesh in blocks.items()}
    edge = {k: {} for k in node}
    for one, two, interface in edges:
        edge[str(one)].setdefault(str(two), {"interfaces": []})["interfaces"].append(interface)
    return {"dtype": "compas_assembly.datastructures/Assembly", "guid": "0", "data": {
        "attributes": {"name": "Assembly"}, "graph": {"dtype": "compas.datastructures/Graph", "guid": "0", "data": {
            "attributes": {}, "default_node_attributes": {"block": None, "is_support": False},
            "default_edge_attributes": {"interfaces": None}, "node": node, "edge": edge, "max_node": len(node) - 1}}}}


def level(x0, x1, z, y0=0, y1=1):
    return compas_interface([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]], [1, 0, 0], [0, 1, 0])


# Two stones on a sill, and one across both. The joint between the two is open.
WALL = {0: box((-1, 0, -1), (5, 1, 0)), 1: box((0, 0, 0), (1.75, 1, 1)), 2: box((2.25, 0, 0), (4, 1, 1)),
        3: box((1, 0, 1), (3, 1, 2))}
WALL_EDGES = [(0, 1, level(0, 1.75, 0)), (0, 2, level(2.25, 4, 0)), (1, 3, level(1, 1.75, 1)), (2, 3, level(2.25, 3, 1))]


def named(blocks):
    return {str(k): mesh for k, mesh in blocks.items()}


def contacts(assembly):
    return sorted((pair, p, tuple(n)) for pair, p, n in zip(assembly.contact_bodies, assembly.positions, assembly.normals))


def both(blocks, edges, supports, friction, **more):
    return (Assembly.from_compas(compas(blocks, edges, supports), friction, **more),
            Assembly.from_meshes(named(blocks), friction, supports=supports, **more))


def test_a_wall_by_both():
    read, found = both(WALL, WALL_EDGES, [0], "1/2", density=10)
    assert read.bodies == found.bodies == ("1", "2", "3") and len(read) == 16 and read.name == "Assembly"
    assert contacts(read) == contacts(found) and read.wrench == found.wrench
    assert read.wrench[:6] == (0, 0, -17.5, -8.75, F(245, 16), 0)  # 1.75 times 10, at (7/8, 1/2, 1/2)
    assert set(read.contact_bodies) == {("1", "ground"), ("2", "ground"), ("1", "3"), ("2", "3")}
    for assembly in (read, found):
        answer = statics(assembly, certificate=True)
        assert answer.load_class == "may stand"
        assert stickslip.decide(assembly, warnings=True).warnings == ()


def test_a_wall_that_overhangs():
    """The upper stone of length 2 over an edge: it stands while its middle is above the lower one."""
    for over, stands in ((0.75, True), (1.25, False)):
        blocks = {0: box((-2, 0, -1), (0, 1, 0)), 1: box((over - 2, 0, 0), (over, 1, 1))}
        for assembly in both(blocks, [(0, 1, level(over - 2, 0, 0))], [0], 1):
            assert statics(assembly).load_class == ("may stand" if stands else "must move")


def slope(rise, run):
    """A wedge, and a flat block on its slope; contacts in its plane."""
    wedge = prism([(0, 0), (run, 0), (run, rise)])
    a, b = (F(1, 4) * run, F(1, 4) * rise), (F(3, 4) * run, F(3, 4) * rise)
    up = (F(-rise, 8), F(run, 8))
    block = prism([a, b, (b[0] + up[0], b[1] + up[1]), (a[0] + up[0], a[1] + up[1])])
    corners = [[x, y, z] for (x, z), y in ((a, 0), (b, 0), (b, 1), (a, 1))]
    return {0: wedge, 1: block}, [(0, 1, compas_interface(corners, [run, 0, rise], [0, 1, 0]))]


@pytest.mark.parametrize("rise, run", [(3, 4), (1, 2), (2, 7)])
def test_a_slope(rise, run):
    """A block stands on it from the friction on that is its tangent."""
    blocks, edges = slope(rise, run)
    tangent = F(rise, run)
    for friction, stands in ((tangent + F(1, 1000), True), (tangent - F(1, 1000), False)):
        for assembly in both(blocks, edges, [0], friction):
            assert len(assembly) == 4 and statics(assembly).load_class == ("may stand" if stands else "must move")
    for assembly in both(blocks, edges, [0], 1):
        low, high = statics(assembly, least_friction=True).least_friction
        assert low <= tangent <= high and high - low < 1e-5
    for friction, stands in ((tangent + F(1, 10**6), True), (tangent - F(1, 10**6), False)):  # with a gravity that leans
        flat = Assembly.from_meshes({"block": box((0, 0, 0), (4, 4, 1))}, friction, ground=0, gravity=(rise, 0, -run))
        assert statics(flat).load_class == ("may stand" if stands else "must move")
        assert flat.wrench[:3] == (16 * rise, 0, -16 * run)


def arch(stones=5, inner=4, outer=5):
    """Between two supports; angles by their half-angle tangents, rounded, so that joints are planes."""
    def at(angle, r):
        t = F(math.tan(angle / 2)).limit_denominator(1000)
        return F(r * (1 - t * t), 1 + t * t), F(2 * r * t, 1 + t * t)

    joints = [(at(math.pi * i / stones, inner), at(math.pi * i / stones, outer)) if i < stones else ((-inner, 0), (-outer, 0))
              for i in range(stones + 1)]
    blocks = {i + 1: prism([a, b, d, c]) for i, ((a, b), (c, d)) in enumerate(zip(joints, joints[1:]))}
    blocks = {0: box((inner, 0, -1), (outer, 1, 0)), **blocks, stones + 1: box((-outer, 0, -1), (-inner, 1, 0))}
    edges = []
    for i, ((ax, az), (bx, bz)) in enumerate(joints):
        corners = [[ax, 0, az], [bx, 0, bz], [bx, 1, bz], [ax, 1, az]]
        edges.append((i, i + 1, compas_interface(corners, [bx - ax, 0, bz - az], [0, 1, 0])))
    return blocks, edges, [0, stones + 1]


def test_an_arch_by_both():
    blocks, edges, supports = arch()
    for friction, stands in (("0.6", True), ("0.2", False)):
        for more in ({}, {"grid": "1e-6"}):
            read = Assembly.from_compas(compas(blocks, edges, supports), friction, **more)
            found = Assembly.from_meshes(named(blocks), friction, supports=supports, tolerance="1e-5", **more)
            cut = Assembly.from_meshes({k: triangles(mesh) for k, mesh in named(blocks).items()}, friction, supports=supports,
                                       tolerance="1e-5", **more)
            for assembly in (read, found, cut):
                assert len(assembly) == 24 and len(assembly.bodies) == 5
                assert statics(assembly).load_class == ("may stand" if stands else "must move")
    low, high = statics(read, least_friction=True).least_friction
    other = statics(found, least_friction=True).least_friction
    assert abs(float(low - other[0])) < 1e-5 and abs(float(high - other[1])) < 1e-5


def test_a_frame_that_is_turned():
    """Everything is turned, with gravity: nothing changes. Axes that turn in their plane say the same."""
    down = [-row[2] for row in TURN]
    turned = {k: moved(mesh, TURN, (1, 2, 3)) for k, mesh in WALL.items()}
    exact = Assembly.from_meshes(named(turned), "1/2", supports=[0], gravity=down)
    assert len(exact) == 16 and set(exact.normals) == {tuple(row[2] for row in TURN), tuple(down)}
    assert statics(exact).load_class == "may stand"
    doubles = {k: ([[float(x) for x in p] for p in vertices], faces) for k, (vertices, faces) in turned.items()}
    assert pytest.raises(InputError, Assembly.from_meshes, named(doubles), "1/2", supports=[0]).value.problem == "no faces touch"
    near = Assembly.from_meshes(named(doubles), "1/2", supports=[0], gravity=down, tolerance=1e-9)
    assert len(near) == 16 and near.contact_bodies == exact.contact_bodies
    away = np.abs(near.positions_float[:, None] - exact.positions_float).max(axis=2)
    assert away.min(axis=0).max() < 1e-12 and away.min(axis=1).max() < 1e-12
    for normal, other in zip(near.normals, exact.normals):
        assert sum(x * x for x in normal) == 1 and all(abs(x - y) < F("1e-11") for x, y in zip(normal, other))
    edges = []
    for spin in (0.0, 1.0, 2.5):
        edges.append([])
        for one, two, interface in WALL_EDGES:
            points = [p["data"] for p in interface["data"]["points"]]
            x = [math.cos(spin), math.sin(spin), 0.0]
            y = [-math.sin(spin), math.cos(spin), 0.0]
            turn = [[float(c) for c in row] for row in TURN]

            def apply(p, by=(0, 0, 0)):
                return [sum(m * c for m, c in zip(row, p)) + b for row, b in zip(turn, by)]

            edges[-1].append((one, two, compas_interface([apply(p, (1, 2, 3)) for p in points], apply(x), apply(y))))
    for own in edges:
        read = Assembly.from_compas(compas(doubles, own, [0]), "1/2", gravity=down)
        assert statics(read).load_class == "may stand"
        for normal in set(read.normals):
            assert sum(x * x for x in normal) == 1
            assert min(sum(abs(x - y) for x, y in zip(normal, [s * row[2] for row in TURN])) for s in (-1, 1)) < F("1e-11")
    flat = Assembly.from_compas(compas(doubles, edges[0], [0]), "1/2")  # as gravity does not turn with it
    assert statics(flat).load_class == "must move"


def older(file, single="interface"):
    """The forms that files had before compas 2."""
    graph = file["data"]["graph"]["data"]

    def block(node):
        return node["block"]["data"]

    def bare(interface):
        data = interface["data"]
        frame = data["frame"]["data"]
        return [p["data"] for p in data["points"]], frame

    def edges(make):
        return {u: {v: make(e["interfaces"][0]) for v, e in others.items()} for u, others in graph["edge"].items()}

    def first(interface):
        points, frame = bare(interface)
        return {"interface_points": points, "interface_uvw": [frame["xaxis"], frame["yaxis"], [9, 9, 9]], "interface_type": "face_face"}

    def second(interface):
        points, frame = bare(interface)
        return {single: {"dtype": "compas_assembly.datastructures/Interface", "value": {
            "points": points, "frame": {"dtype": "compas.geometry/Frame", "value": frame}, "type": "face_face"}}}

    flags = {k: {"is_support": n.get("is_support", False), "x": 0.0} for k, n in graph["node"].items()}
    apart = {k: block(n) for k, n in graph["node"].items()}
    for shape in apart.values():
        shape["face"] = {f: list(map(str, face)) for f, face in shape["face"].items()}
    names = {"attributes": {"name": "Assembly"}}
    yield {"assembly": {**names, "node": flags, "edge": edges(first)}, "blocks": apart}
    yield {"assembly": {**names, "vertex": flags, "edge": edges(first), "dva": {"is_support": False}}, "blocks": apart}
    nodes = {k: {**flags[k], "block": {"dtype": "compas_assembly.datastructures/Block", "value": apart[k]}} for k in apart}
    yield {**names, "dna": {"is_support": False}, "node": nodes, "edge": edges(second)}
    deep = {k: {**flags[k], "block": {"dtype": "compas_assembly.datastructures/Block", "value": {
        "datatype": "compas_assembly.datastructures/Block", "compas": "0.18.1", "data": apart[k]}}} for k in apart}
    yield {**names, "graph": {"dna": {"block": None}, "node": deep, "edge": edges(second)}}
    quoted = {"node": {repr(f"b{k}"): n for k, n in nodes.items()},
              "edge": {repr(f"b{u}"): {repr(f"b{v}"): e for v, e in others.items()} for u, others in edges(second).items()}}
    yield {**names, "graph": quoted}


def test_older_forms(tmp_path):
    now = Assembly.from_compas(compas(WALL, WALL_EDGES, [0]), "1/2")
    for i, content in enumerate(older(compas(WALL, WALL_EDGES, [0]))):
        path = tmp_path / f"{i}.json"
        path.write_text(json.dumps(content))
        read = Assembly.from_compas(path, "1/2")
        if i == 4:
            assert read.bodies == ("b1", "b2", "b3")
            assert (read.positions, read.normals, read.wrench) == (now.positions, now.normals, now.wrench)
        else:
            assert read == now == Assembly.from_compas(content, "1/2")


def test_compas_numbers():
    file = compas(WALL, WALL_EDGES, [0], {3: 7.0})
    read = Assembly.from_compas(file, 0.5, 3, density=2, gravity=(0, 0, "-9.81"), name="wall",
                                units={"length": "m", "force": "N"})
    assert (read.name, read.units["length"], set(read.stiffness)) == ("wall", "m", {3})
    assert read.wrench[2] == -2 * F("1.75") * F("9.81") and read.wrench[14] == -7 * 2 * F("9.81")
    assert Assembly.from_compas(file, 1, density={"3": 5, 1: "1/2"}).wrench[2::6] == (-F(7, 8), -F(7, 4), -10)
    assert Assembly.from_compas(file, 1, supports=["0", 1]).bodies == ("2", "3")
    assert Assembly.from_compas(file, 1, supports=[]).bodies == ("0", "1", "2", "3")
    inside_out = {k: (vertices, [face[::-1] for face in faces]) for k, (vertices, faces) in WALL.items()}
    assert Assembly.from_compas(compas(inside_out, WALL_EDGES, [0]), 1).wrench == Assembly.from_compas(
        compas(WALL, WALL_EDGES, [0]), 1).wrench
    tenth = compas({0: WALL[0], 1: box((0, 0, 0), (0.1, 1, 1))}, [(0, 1, level(0, 0.1, 0))], [0])
    assert Assembly.from_compas(tenth, 1).wrench[2] == -F(0.1)  # the double
    assert Assembly.from_compas(tenth, 1, grid="0.01").wrench[2] == -F("0.1")


def test_a_frame_that_is_turned_round_is_taken_as_it_is():
    turned = WALL_EDGES[:3] + [(2, 3, compas_interface([[2.25, 0, 1], [3, 0, 1], [3, 1, 1], [2.25, 1, 1]], [0, 1, 0], [1, 0, 0]))]
    read = Assembly.from_compas(compas(WALL, turned, [0]), 1)
    assert read.normals[-1] == (0, 0, 1) and read.contact_bodies[-1] == ("2", "3")
    assert [w.trap for w in stickslip.decide(read, warnings=True, node_limit=1).warnings] == ["reversed-contact"]


def test_faces_are_found_where_a_file_has_no_interfaces():
    bare = compas(WALL, [], [0])
    assert contacts(Assembly.from_compas(bare, 1, tolerance=0)) == contacts(Assembly.from_compas(compas(WALL, WALL_EDGES, [0]), 1))
    plate = ([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], [[0, 1, 2, 3]])  # a support may be open
    on_it = Assembly.from_compas(compas({**WALL, 0: plate}, [], [0]), 1, tolerance=0)
    assert on_it.contact_bodies == Assembly.from_compas(bare, 1, tolerance=0).contact_bodies


def test_what_two_faces_have_in_common():
    low = box((0, 0, 0), (4, 4, 1))

    def corners(up, **more):
        found = Assembly.from_meshes({"low": low, "up": up}, 1, supports=["low"], **more)
        assert set(found.contact_bodies) == {("up", "ground")} and set(found.normals) == {(0, 0, 1)}
        return sorted((x, y) for x, y, _ in found.positions)

    assert corners(box((3, 3, 1), (6, 5, 2))) == [(3, 3), (3, 4), (4, 3), (4, 4)]
    half = [[F(1, 2), F(-1, 2), 0], [F(1, 2), F(1, 2), 0], [0, 0, 1]]  # by 45 degrees, and smaller
    diamond = moved(box((-4, -4, 1), (4, 4, 2)), half, (2, 2, 0))
    assert corners(diamond) == corners(triangles(diamond)) == [(0, 0), (0, 4), (4, 0), (4, 4)]
    assert corners(moved(box((-3, -3, 1), (3, 3, 2)), half, (2, 2, 0))) == sorted(
        (x, y) for x, y in [(0, 1), (0, 3), (1, 0), (3, 0), (4, 1), (4, 3), (1, 4), (3, 4)])
    angle = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]  # as seen from above
    n = len(angle)
    ell = ([[x, y, z] for z in (1, 2) for x, y in angle],
           [list(range(n))[::-1], list(range(n, 2 * n)), *([i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n))])
    assert corners(ell) == [(0, 0), (0, 3), (1, 3), (3, 0), (3, 1)]
    assert Assembly.from_meshes({"low": low, "up": ell}, 1, supports=["low"]).wrench == (0, 0, -5, -F(11, 2), F(11, 2), 0)
    bridge = prism([(0, 1), (1, 1), (1, 2), (3, 2), (3, 1), (4, 1), (4, 3), (0, 3)], 1, 2)  # two feet, two faces
    assert corners(bridge) == [(x, y) for x in (0, 1, 3, 4) for y in (1, 2)]


@pytest.mark.parametrize("up, tolerance, count", [
    (box((0, 0, "1.001"), (1, 1, 2)), 0, 0),
    (box((0, 0, "1.001"), (1, 1, 2)), "0.002", 4),
    (box((0, 0, "0.999"), (1, 1, 2)), "0.002", 4),
    (box((1, 0, 1), (2, 1, 2)), 0, 0),  # along an edge
    (box(("0.999", 0, 1), (2, 1, 2)), 0, 4),
    (box(("0.999", 0, 1), (2, 1, 2)), "0.002", 0),  # narrower than the tolerance
    (prism([(0, 1), (1, "1.1"), (1, 2), (0, 2)]), "0.2", 0),  # 6 degrees
    (prism([(0, 1), (1, "1.01"), (1, 2), (0, 2)]), "0.02", 4),
    (prism([(0, 1), (1, "1.01"), (1, 2), (0, 2)]), "0.009", 0),
    (box((0, 0, "0.5"), (1, 1, "1.5")), "0.1", 0),  # one in the other
])
def test_tolerances(up, tolerance, count):
    blocks = {"low": box((0, 0, 0), (1, 1, 1)), "up": up, "far": box((8, 8, 0), (9, 9, 1))}
    found = Assembly.from_meshes(blocks, 1, tolerance=tolerance, ground=0)
    assert found.contact_bodies.count(("low", "up")) == count and found.contact_bodies.count(("far", "ground")) == 4
    for (of, _), p in zip(found.contact_bodies, found.positions):
        assert p[2] == (1 if of == "low" and p[2] > 0 else 0)  # on the face of the first


def write_obj(mesh, base=0):
    vertices, faces = mesh
    return "".join(f"v {x} {y} {z}\n" for x, y, z in vertices) + "".join(
        "f " + " ".join(f"{v + 1 + base}//1" for v in face) + "\n" for face in faces)


def write_stl(mesh, path, binary):
    vertices, faces = triangles(mesh)
    rows = [[vertices[v] for v in face] for face in faces]
    if binary:
        path.write_bytes(bytes(80) + struct.pack("<I", len(rows)) + b"".join(
            struct.pack("<12fH", 0, 0, 0, *(float(x) for p in row for x in p), 0) for row in rows))
    else:
        path.write_text("solid s\n" + "".join(
            "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {float(x)} {float(y)} {float(z)}\n" for x, y, z in row)
            + "endloop\nendfacet\n" for row in rows) + "endsolid s\n")


def test_files_of_meshes(tmp_path):
    asked = Assembly.from_meshes(named(WALL), "1/2", supports=["0"])
    by_name, offset, whole = {}, 0, "# a wall\nmtllib none.mtl\n"
    for i, (key, mesh) in enumerate(named(WALL).items()):
        path = tmp_path / (key + [".obj", ".stl", ".STL"][i % 3])
        if i % 3 == 0:
            path.write_text(write_obj(mesh))
        else:
            write_stl(mesh, path, i % 3 == 2)
        by_name[key] = path if i % 2 else str(path)
        whole += f"o {key}\nvn 0 0 1\n" + write_obj(mesh, offset) + "s off\n"
        offset += len(mesh[0])
    read = Assembly.from_meshes(by_name, "1/2", supports=["0"])
    assert contacts(read) == contacts(asked) and read.wrench == asked.wrench
    (tmp_path / "wall.obj").write_text(whole)
    assert Assembly.from_meshes(tmp_path / "wall.obj", "1/2", supports=["0"]) == asked
    (tmp_path / "negative.obj").write_text("v 9 9 9\n" + "".join(
        line for line in write_obj(WALL[1]).splitlines(True) if line[0] == "v")
        + "".join("f " + " ".join(str(v - 8) for v in face) + "  # back\n" for face in WALL[1][1]))
    one = Assembly.from_meshes({"a": tmp_path / "negative.obj"}, 1, ground=0)
    assert one.wrench == asked.wrench[:6]
    tenths = Assembly.from_meshes({"a": box((0, 0, 0), ("0.1", 1, 1))}, 1, ground=0)
    (tmp_path / "tenths.obj").write_text(write_obj(box((0, 0, 0), ("0.1", 1, 1))))
    assert Assembly.from_meshes({"a": tmp_path / "tenths.obj"}, 1, ground=0) == tenths and tenths.wrench[2] == -F(1, 10)
    trimesh = SimpleNamespace(vertices=np.array(WALL[1][0], dtype=float), faces=np.array(triangles(WALL[1])[1]))
    assert Assembly.from_meshes({"a": trimesh}, 1, ground=0).wrench == asked.wrench[:6]


def wall_without(*path, value=None):
    """The file with what is at this path of its graph left out, or another."""
    file = json.loads(json.dumps(compas(WALL, WALL_EDGES, [0])))
    inner = file["data"]["graph"]["data"]
    for key in path[:-1]:
        inner = inner[key]
    if value is None:
        del inner[path[-1]]
    else:
        inner[path[-1]] = value
    return file


@pytest.mark.parametrize("source, place, problem", [
    ({"a": 1}, "", "there is no graph with nodes"),
    (3, "source", "this is 3"),
    (wall_without("node", "1", "block"), "node['1']", "there is no block"),
    (wall_without("node", "1", "block", "data", "face"), "node['1'].block", "the mesh has no face"),
    (wall_without("node", "1", "block", "data", "vertex"), "node['1'].block", "the mesh has no vertex"),
    (wall_without("node", "1", "block", "data", "face", "2", value=[0, 1, 77]), "node['1'].block.face['2']", "there is no vertex 77"),
    (wall_without("node", "1", "block", "data", "face", "2"), "node['1'].block.faces[4]", "the edge from vertex .* has no face"),
    (wall_without("node", "1", "block", "data", "vertex", "2", value={"x": "a", "y": 0, "z": 0}), "node['1'].block.vertex['2'][0]", ""),
    (wall_without("edge", "1", value={"8": {}}), "edge['1']['8']", "there is no node '8'"),
    (wall_without("edge", "1", "3", "interfaces", 0, "data", "points"), "edge['1']['3'].interfaces[0].points", "this is None"),
    (wall_without("edge", "1", "3", "interfaces", 0, "data", "points", 2, value=[0, 1]), "edge['1']['3'].interfaces[0].points[2]", r"this is \[0, 1\]"),
    (wall_without("edge", "1", "3", "interfaces", 0, "data", "frame"), "edge['1']['3'].interfaces[0].frame", "this is None"),
    (wall_without("edge", "1", "3", "interfaces", 0, "data", "frame", "data", "xaxis", value=[0, 2, 0]),
     "edge['1']['3'].interfaces[0].frame", "the axes are parallel"),
    (wall_without("node", "0", "is_support"), "supports", "no node of the file has is_support"),
    (wall_without("edge"), "tolerance", "the file has no interfaces"),
])
def test_errors_of_compas(source, place, problem, tmp_path):
    with pytest.raises(InputError, match=problem) as error:
        Assembly.from_compas(source, 1)
    assert error.value.place == place and error.value.remedy and error.value.file == ""
    if isinstance(source, dict):
        (tmp_path / "wall.json").write_text(json.dumps(source))
        with pytest.raises(InputError, match=problem) as error:
            Assembly.from_compas(tmp_path / "wall.json", 1)
        assert error.value.place == place
        assert error.value.file == ("" if place in ("supports", "tolerance") else str(tmp_path / "wall.json"))


@pytest.mark.parametrize("more, place, problem", [
    ({"supports": [7]}, "supports[0]", "there is no block 7"),
    ({"supports": "0"}, "supports", "this is '0'"),
    ({"supports": [0, 1, 2, 3]}, "supports", "every block is a support"),
    ({"density": {"7": 1}}, "density['7']", "there is no such block"),
    ({"density": -1}, "density", "the value is -1"),
    ({"density": {1: -1}}, "density['1']", "the value is -1"),
    ({"gravity": (0, -1)}, "gravity", "the shape is"),
    ({"gravity": (0, 0, float("nan"))}, "gravity[2]", "not a finite number"),
    ({"grid": 0}, "grid", "the value is 0"),
    ({"tolerance": 1}, "tolerance", "the file has interfaces"),
    ({"friction": -1}, "defaults.friction", ""),
    ({"stiffness": 0}, "defaults.stiffness", ""),
])
def test_errors_of_arguments_of_compas(more, place, problem):
    with pytest.raises(InputError, match=problem) as error:
        Assembly.from_compas(compas(WALL, WALL_EDGES, [0]), **{"friction": 1, **more})
    assert error.value.place == place


def test_errors_of_files_of_compas(tmp_path):
    with pytest.raises(InputError, match="cannot open the file") as error:
        Assembly.from_compas(tmp_path / "none.json", 1)
    assert error.value.file == str(tmp_path / "none.json")
    (tmp_path / "broken.json").write_text('{"data": \n [}')
    with pytest.raises(InputError, match="this is no JSON") as error:
        Assembly.from_compas(tmp_path / "broken.json", 1)
    assert error.value.place == "2:3"


CUBE = box((0, 0, 0), (1, 1, 1))


@pytest.mark.parametrize("meshes, more, place, problem", [
    (3, {}, "meshes", "this is 3"),
    ({}, {}, "meshes", "there is no block"),
    ({"": CUBE}, {}, "meshes['']", "no block has this name"),
    ({"ground": CUBE}, {}, "meshes['ground']", "no block has this name"),
    ({"a": 3}, {}, "meshes['a']", "this is 3"),
    ({"a": (CUBE[0], [[0, 1]])}, {}, "meshes['a'].faces[0]", r"this is \[0, 1\]"),
    ({"a": (CUBE[0], [[0, 1, 9]])}, {}, "meshes['a'].faces[0]", "9 is no vertex"),
    ({"a": (CUBE[0], CUBE[1][1:])}, {}, "meshes['a'].faces[4]", "has no face on its other side"),
    ({"a": (CUBE[0], [face[::-1] for face in CUBE[1]])}, {}, "meshes['a'].faces[0]", "inside out"),
    ({"a": ([[0, 0], [1, 1]], [])}, {}, "meshes['a'].vertices", "the shape is"),
    ({"a": CUBE}, {"ground": None}, "ground", "nothing is the ground"),
    ({"a": CUBE}, {"ground": "1/2"}, "meshes['a']", "a vertex is under the ground at 1/2"),
    ({"a": CUBE}, {"ground": -1}, "tolerance", "no faces touch"),
    ({"a": CUBE}, {"tolerance": -1}, "tolerance", "the value is -1"),
    ({"a": CUBE}, {"grid": -1}, "grid", "the value is -1"),
    ({"a": CUBE}, {"supports": ["b"]}, "supports[0]", "there is no block 'b'"),
    ({"a": "cube.ply"}, {}, "meshes['a']", "no file of a mesh"),
    ("cube.stl", {}, "meshes", "no OBJ file"),
])
def test_errors_of_meshes(meshes, more, place, problem):
    with pytest.raises(InputError, match=problem) as error:
        Assembly.from_meshes(meshes, 1, **{"ground": 0, **more})
    assert error.value.place == place and error.value.remedy


def test_a_face_whose_sides_cross():
    with pytest.raises(InputError, match="the sides of the face cross each other") as error:
        Assembly.from_meshes({"a": ([[0, 0, 0], [2, 0, 0], [0, 1, 0], [3, 1, 0], [1, 3, 1]], [[0, 1, 2, 3]])}, 1, supports=["a"])
    assert error.value.place == "meshes['a'].faces[0]"


@pytest.mark.parametrize("name, text, place, problem", [
    ("a.obj", "v 0 0 0\nv 1 0\n", "line 2", "a vertex has 2 numbers"),
    ("a.obj", "v 0 0 x\n", "line 1", "'x'"),
    ("a.obj", "v 0 0 0\nf 1 2 3\n", "line 2", "'2' is no vertex"),
    ("a.obj", "v 0 0 0\nv 0 0 0\nf 1 2\n", "line 3", "a face has 2 vertices"),
    ("a.obj", "v 0 0 0\n", "", "there is no face"),
    ("a.stl", "nothing", "", "this is no STL file"),
    ("a.stl", "solid a\nvertex 1 2\n", "line 2", "a vertex has 2 numbers"),
    ("a.stl", "solid a\nvertex 1 2 3\n", "", "there are 1 vertices"),
    ("a.stl", bytes(80) + struct.pack("<I", 2) + bytes(60), "", "144 bytes for 2 triangles"),
])
def test_errors_of_files_of_meshes(name, text, place, problem, tmp_path):
    path = tmp_path / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(InputError, match=problem) as error:
        Assembly.from_meshes({"a": path}, 1, ground=0)
    assert (error.value.file, error.value.place) == (str(path), place) and error.value.remedy


def test_errors_of_objects(tmp_path):
    path = tmp_path / "wall.obj"
    for text, problem in ((write_obj(CUBE), "the file has no objects"),
                          (write_obj(CUBE) + "o b\n" + write_obj(CUBE, 8), "there are faces before the first object")):
        path.write_text(text)
        with pytest.raises(InputError, match=problem) as error:
            Assembly.from_meshes(path, 1, ground=0)
        assert error.value.file == str(path)
    with pytest.raises(InputError, match="cannot open the file"):
        Assembly.from_meshes({"a": tmp_path / "none.stl"}, 1, ground=0)


def test_many_faces_are_no_part_of_a_file():
    """Of blocks whose surfaces are larger than a file holds only the contacts are kept."""
    strips = 2800
    fine = prism([(F(i, strips), 0) for i in range(strips + 1)] + [(1, 1), (0, 1)])
    found = Assembly.from_meshes({"fine": fine}, 1, ground=0)
    assert len(found) == 4 and found.wrench[:3] == (0, 0, -1)
    assert Assembly.from_text(found.to_text()) == found
