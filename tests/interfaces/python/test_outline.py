# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts on outlines, grippers, and unit normals in doubles."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
import stickslip
from stickslip import Grasp, InputError, check, decide, margin, region

PLATE = [[0, 0], [4, 0], [4, 3], [0, 3]]
HOLE = [[1, 1], [3, 1], [3, 2], [1, 2]]


def test_sides_of_a_plate():
    points = [[1, 0], [4, 1], ["1/3", 3], [0, 2]]
    inward = ((0, 1), (-1, 0), (0, -1), (1, 0))
    for corners in (PLATE, PLATE[::-1], np.array(PLATE), [PLATE], [*PLATE, PLATE[0]]):
        grasp, moved = Grasp.from_outline(corners, points, "1/2", preload=1)
        assert grasp.normals == inward
        assert grasp.positions == ((1, 0), (4, 1), (Fraction(1, 3), 3), (0, 2))
        assert moved == (0, 0, 0, 0)
        assert decide(grasp, (0, 0, 0)).verdict == "stable"
        assert sorted(grasp.outline[0][0]) == sorted(map(tuple, PLATE))


def test_holes_are_held_from_inside():
    for hole in (HOLE, HOLE[::-1]):
        grasp, _ = Grasp.from_outline([PLATE, hole], [[2, 1], [3, "3/2"], [4, 1]], 1)
        assert grasp.normals == ((0, -1), (1, 0), (-1, 0))


def test_slanted_edges():
    triangle = [[0, 0], [4, 0], [0, 3]]  # its long edge is 5 long: a rational unit normal
    (grasp, _) = Grasp.from_outline(triangle, [[2, "3/2"]], 1, preload=1)
    assert grasp.normals == ((Fraction(-3, 5), Fraction(-4, 5)),)
    (grasp, _) = Grasp.from_outline([[0, 0], [1, 0], [0, 1]], [["1/2", "1/2"]], 1)
    assert grasp.normals == ((-1, -1),)
    decided = decide(grasp, (0, 1, 0), preload=1)  # exact corners are never rounded unasked
    assert decided.snapped == () and decided.grasp == grasp and decided.check()
    (grasp, _) = Grasp.from_outline([[0, 0], [1.0, 0], [0, 1]], [["1/2", "1/2"]], 1, preload=1)
    answer = decide(grasp, (0, 0, 0))
    assert [n.contact for n in answer.snapped] == [0]
    assert float(answer.snapped[0].moved_at_most) <= 1e-12


def test_points_off_the_outline():
    points = [[1, -0.25], [4.0625, 1]]
    grasp, moved = Grasp.from_outline(PLATE, points, 1, tolerance="1/4")
    assert grasp.positions == ((1, 0), (4, 1))
    assert moved == (0.25, 0.0625)
    for tolerance in (None, 0.2499999, 0):
        with pytest.raises(InputError) as error:
            Grasp.from_outline(PLATE, points, 1, tolerance=tolerance)
        assert error.value.place == "points[0]" and "0.25" in error.value.problem


def test_the_nearest_edge_is_found_exactly():
    random = np.random.default_rng(2)
    polygons = [PLATE, HOLE]
    rings = [[tuple(map(Fraction, p)) for p in ring] for ring in polygons]
    for _ in range(100):
        point = tuple(Fraction(int(k), 64) for k in random.integers(0, 256, 2))
        best = []
        for ring in rings:  # edges are parallel to the axes
            for a, b in zip(ring, ring[1:] + ring[:1]):
                q = tuple(min(max(point[k], min(a[k], b[k])), max(a[k], b[k])) for k in (0, 1))
                best.append(((q[0] - point[0]) ** 2 + (q[1] - point[1]) ** 2, q, {a, b}))
        squared, q, ends = min(best, key=lambda found: found[0])
        if q in ends:
            continue
        grasp, moved = Grasp.from_outline(polygons, [point], 1, tolerance=10)
        assert grasp.positions == (q,)
        assert moved[0] ** 2 == pytest.approx(float(squared))


@pytest.mark.parametrize("outline, points, place", [
    (3, [[0, 0]], "outline"), ([], [[0, 0]], "outline"), ("plate", [[0, 0]], "outline"),
    ([[0, 0], [1, 0]], [[0, 0]], "outline[0][0]"),
    ([[0, 0], [1, 1], [2, 2]], [[0, 0]], "outline[0][0]"),
    ([[0, 0], [0, 0], [1, 0], [0, 1]], [[0, 0]], "outline[0][0][1]"),
    ([[0, 0], [1, "x"], [0, 1]], [[0, 0]], "outline[0][0][1, 1]"),
    ([PLATE, [[1, 1], [2, float("nan")], [1, 2]]], [[0, 1]], "outline[0][1][1, 1]"),
    (PLATE, [[0, 0]], "points[0]"), (PLATE, [[-1, -1]], "points[0]"), (PLATE, [1, 0], "positions[0]"),
    (PLATE, [[2, "?"]], "points[0, 1]")])
def test_errors(outline, points, place):
    with pytest.raises(InputError) as error:
        Grasp.from_outline(outline, points, 1, tolerance=5)
    assert error.value.place == place
    assert error.value.problem and error.value.remedy


def test_shapely():
    geometry = pytest.importorskip("shapely.geometry")
    plate = geometry.Polygon(PLATE, [HOLE])
    points = [[2, 1], [3, 1.5], [4, 1]]
    grasp, _ = Grasp.from_outline(plate, points, 1)
    assert grasp == Grasp.from_outline([PLATE, HOLE], points, 1).grasp
    apart = geometry.MultiPolygon([plate, geometry.Polygon([[5, 0], [6, 0], [6, 1], [5, 1]])])
    grasp, _ = Grasp.from_outline(apart, [[6, 0.5], [0, 1]], 1)
    assert grasp.normals == ((-1, 0), (1, 0))
    with pytest.raises(InputError, match="a polygon of shapely"):
        Grasp.from_outline(geometry.MultiPoint([[0, 0], [1, 1]]), [[0, 0]], 1)


def test_grippers():
    one = Grasp.gripper(width=2, force=3, friction="1/2")
    assert one.positions == ((-1, 0), (1, 0)) and one.normals == ((1, 0), (-1, 0))
    assert one.preload == (3, 3)
    # It holds what friction does: 2 mu F.
    assert margin(one, (0, -1, 0)).resisted == ((0, 3),)
    pads = Grasp.gripper(2, "10", 0.5, pad="1/2", stiffness=7, wrench=(0, -1, 0), name="jaws")
    assert len(pads) == 4 and pads.preload == (5,) * 4 and sum(pads.preload) == 20
    assert pads.positions[0] == (-1, Fraction(1, 4)) and pads.stiffness == (7,) * 4
    assert (pads.name, pads.wrench) == ("jaws", (0, -1, 0))
    for arguments, place in (((0, 1, 1), "width"), ((1, -1, 1), "force"), ((1, 1, -1), "friction"),
                             (("x", 1, 1), "width")):
        with pytest.raises(InputError) as error:
            Grasp.gripper(*arguments)
        assert place in error.value.place
    with pytest.raises(InputError) as error:
        Grasp.gripper(1, 1, 1, pad=-1)
    assert error.value.place == "pad"


def circle(entries):
    angle = np.array([0.3, 2.5, 4.4])
    points = np.column_stack([np.cos(angle), np.sin(angle)])
    return Grasp(points, entries(-points), 0.5, preload=1, wrench=(0, 0, 0.25))


def test_unit_normals_in_doubles_need_no_option():
    grasp = circle(lambda normals: normals)
    answer = decide(grasp)
    snapped, moved = grasp.snap("1e-12")
    assert answer.grasp == snapped and answer.snapped == moved and len(moved) == 3
    assert all(float(n.moved_at_most) <= 1e-12 for n in moved)
    assert answer == decide(snapped).__class__(**{**vars(decide(snapped)), "snapped": moved})
    assert "snapped" in repr(answer)
    assert answer.check() and check(grasp, answer.certificate)
    along = margin(grasp, (0, 0, 1))
    assert along.snapped == moved and check(grasp, along.certificate, direction=(0, 0, 1))
    growing = margin(grasp, preload_direction="scale")
    assert along.check() and growing.snapped == moved and growing.check()
    assert margin(grasp, (0, 0, 1), preload=2, preload_direction=(1, 0, 1)).check()
    assert region(grasp).snapped == moved
    many = decide(grasp, [(0, 0, 0.25), (0, 0, 9)])
    assert many[0].snapped == moved and many[0] == answer
    assert stickslip.plot_grasp(grasp) == answer.plot()
    assert stickslip.crosscheck(grasp, answer.verdict).outcome == "right"
    again = pickle.loads(pickle.dumps(grasp))
    assert again == grasp and decide(again) == answer


def test_nothing_else_is_snapped():
    grasp = circle(lambda normals: normals)
    assert decide(grasp, preload=0).snapped == ()  # no need
    assert decide(grasp, preload="0").grasp == grasp
    exact = circle(lambda normals: [[Fraction(x) for x in row] for row in normals])
    for one in (exact, Grasp.from_text(grasp.to_text())):
        decided = decide(one)
        assert decided.snapped == () and decided.grasp == one and decided.check()
