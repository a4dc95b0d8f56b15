# SPDX-License-Identifier: GPL-3.0-or-later
"""Many questions in one call: the same answers as one at a time."""

import importlib.util
import pickle
from fractions import Fraction

import numpy as np
import pytest
from conftest import GOOD
from stickslip import Decision, Decisions, Grasp, InputError, LimitReached, decide

UP = (0, 1, 0)
WRENCHES = [(0, 1, 0), (0, "11/10", 0), (1, 0, 0), (0, 0, 0.25), (-1, -1, "1/3")]


def same(many, singles):
    assert isinstance(many, Decisions)
    assert len(many) == len(singles)
    assert list(many) == singles
    assert [d.certificate for d in many] == [d.certificate for d in singles]
    assert many.verdict.tolist() == [d.verdict for d in singles]
    assert many.engine.tolist() == [d.engine for d in singles]
    assert many.undecided.tolist() == [d.verdict == "undecided" for d in singles]
    if many.undecided.any():
        with pytest.raises(LimitReached, match="questions are undecided.*[.]undecided"):
            many.stable
    else:
        assert many.stable.tolist() == [d.verdict == "stable" for d in singles]
    n = 3 if singles[0].grasp.in_space else 2
    rows = [d.twist_float if d.twist else np.full(3 * n - 3, np.nan) for d in singles]
    np.testing.assert_array_equal(many.twist_float, np.array(rows))
    np.testing.assert_array_equal(many.wrench_float, [d.wrench_float for d in singles])
    forces = np.full((len(singles), max(len(d.grasp) for d in singles), n), np.nan)
    for row, d in zip(forces, singles):
        if d.forces:
            row[:len(d.forces)] = d.forces_float
    np.testing.assert_array_equal(many.forces_float, forces)
    again = pickle.loads(pickle.dumps(many))
    assert again == many and hash(again) == hash(many) and repr(again) == repr(many)
    assert again != many[:1] and [d.stats for d in again] == [d.stats for d in many]
    np.testing.assert_array_equal(again.forces_float, forces)
    np.testing.assert_array_equal(again.twist_float, many.twist_float)


def test_wrenches(fig1):
    same(decide(fig1, WRENCHES), [decide(fig1, w) for w in WRENCHES])
    floats = np.random.default_rng(1).uniform(-2, 2, (200, 3))
    many = decide(fig1, floats)
    same(many, [decide(fig1, tuple(w)) for w in floats])
    assert 0 < many.stable.sum() < 200
    assert all(d.check() for d in many)


@pytest.mark.parametrize("options", [
    {"engine": "states"}, {"engine": "branch-and-bound"}, {"normal_law": "bilateral"}, {"threads": 1},
    {"threads": 7}, {"node_limit": 1}], ids=str)
def test_options(fig1, options):
    same(decide(fig1, WRENCHES, **options), [decide(fig1, w, **options) for w in WRENCHES])


def test_frictions_and_preloads(fig1):
    frictions = [0, "1/2", 0.3, Fraction(7, 5)]
    same(decide(fig1, UP, friction=frictions), [decide(fig1, UP, friction=f) for f in frictions])
    preloads = [0, 1, "3/2", 0.1]
    same(decide(fig1, UP, preload=preloads), [decide(fig1, UP, preload=p) for p in preloads])
    both = decide(fig1, UP, friction=frictions, preload=preloads)
    same(both, [decide(fig1, UP, friction=f, preload=p) for f, p in zip(frictions, preloads)])
    assert both[2].grasp.friction == (Fraction(0.3),) * 3
    assert both[2].preload == Fraction(3, 2)
    assert all(d.check() for d in both)
    each = [[0, 1, 2], ["1/2", 0.25, 3]]
    many = decide(fig1, UP, friction=np.array(each, dtype=object))
    assert [d.grasp.friction for d in many] == [(0, 1, 2), (Fraction(1, 2), Fraction(1, 4), 3)]
    assert all(d.check() for d in many)


def test_grasps():
    grasps = [Grasp.from_file(path) for path in sorted(GOOD.glob("*.json"))]
    asked = []
    for grasp in grasps:
        try:
            decide(grasp)
        except InputError:  # a preloaded normal of irrational length
            continue
        asked.append(grasp)
    assert len(asked) > 10
    same(decide(asked), [decide(g) for g in asked])
    same(decide(asked, UP), [decide(g, UP) for g in asked])
    few = asked[:5]
    same(decide(few, WRENCHES), [decide(g, w) for g, w in zip(few, WRENCHES)])
    assert all(d.check() for d in decide(asked))


def test_in_space():
    pinch = Grasp([(-1, 0, 0), (1, 0, 0)], [(1, 0, 0), (-1, 0, 0)], "1/2", preload=1)
    table = Grasp([(-1, 0, 0), (1, -1, 0), (1, 1, 0)], [(0, 0, 1)] * 3, "1/4", preload=0)
    loads = [(0, 0, "1/2", 0, 0, 0), (0, "3/5", "-4/5", 0, 0, 0), (0, 1, 1, 0, 0, 0)]
    same(decide(pinch, loads), [decide(pinch, w) for w in loads])
    many = decide(pinch, loads[1], friction=[[0, 0], ["1/2", "1/2"], [1, 2]], preload=[1, 2, 1])
    same(many, [decide(pinch, loads[1], friction=0, preload=1),
                decide(pinch, loads[1], preload=2), many[2]])
    assert [d.verdict for d in many] == ["unstable", "stable", "stable"]
    assert many[2].grasp.friction == (1, 2)
    same(decide([pinch, table], (0, 0, -1, 0, 0, 0)),
         [decide(g, (0, 0, -1, 0, 0, 0)) for g in (pinch, table)])
    rng = np.random.default_rng(2)
    many = decide(table, np.column_stack([np.round(rng.uniform(-1, 1, (12, 2)), 1),
                                          np.full((12, 1), -2), np.zeros((12, 3))]))
    assert 0 < many.stable.sum() < 12 and many.twist_float.shape == (12, 6)
    assert all(d.check() for d in many)


def test_long_numbers():
    angles = np.linspace(0, 2 * np.pi, 200, endpoint=False) + 0.1
    normals = np.column_stack([np.cos(angles), np.sin(angles)])
    grasp = Grasp(-2 * normals, normals, 0.5, preload=0)
    loads = [(1, 0, 0), (0, 2, 0.5)]
    many = decide(grasp, loads)
    same(many, [decide(grasp, w) for w in loads])
    for answer in many:
        assert (answer.verdict, answer.engine, answer.twist) == ("stable", "intervals", None)
        assert answer.near is not None and len(answer.certificate) < 20_000
        assert answer.check()
    assert decide(grasp, loads, engine="branch-and-bound")[0].twist is not None


def test_one_and_none(fig1):
    own = Grasp(fig1.positions, fig1.normals, "1/2", preload=1, wrench=UP)
    same(decide([own]), [decide(own)])
    same(decide(fig1, [UP]), [decide(fig1, UP)])
    same(decide([fig1], WRENCHES), [decide(fig1, w) for w in WRENCHES])
    for nothing in (decide(fig1, np.zeros((0, 3))), decide([]), decide(own, friction=[])):
        assert len(nothing) == 0 and nothing.twist_float.shape == (0, 3)
        assert nothing.forces_float.shape[0] == len(nothing.to_dataframe()) == 0
        assert pickle.loads(pickle.dumps(nothing)) == nothing
        assert repr(nothing) == "Decisions(0 questions)"


def test_as_a_sequence(fig1):
    many = decide(fig1, WRENCHES)
    assert isinstance(many[0], Decision) and many[-1] == many[4]
    assert many[1:3] == (many[1], many[2]) and many[::-1][0] == many[4]
    for index in (5, -6):
        with pytest.raises(IndexError, match="there are 5"):
            many[index]
    with pytest.raises(TypeError):
        many["0"]
    assert repr(many) == "Decisions(5 questions: 2 stable, 3 unstable)" or "stable" in repr(many)
    assert "<td" in many._repr_html_()


@pytest.mark.skipif(importlib.util.find_spec("pandas") is None, reason="pandas is not installed")
def test_dataframe(fig1):
    many = decide(fig1, WRENCHES, node_limit=1, engine="branch-and-bound")
    frame = many.to_dataframe()
    assert frame.columns.tolist() == ["verdict", "engine", "limit", "force_x", "force_y", "torque",
                                      "motion_x", "motion_y", "rotation"]
    assert frame["verdict"].tolist() == many.verdict.tolist()
    assert frame["limit"].tolist() == [d.limit for d in many]
    np.testing.assert_array_equal(frame[["force_x", "force_y", "torque"]], many.wrench_float)
    np.testing.assert_array_equal(frame[["motion_x", "motion_y", "rotation"]], many.twist_float)
    assert set(frame.groupby("verdict").size().index) >= {"undecided", "stable"}
    in_space = decide(Grasp([(0, 0, 0)], [(0, 0, 1)], 1), [(0, 0, -1, 0, 0, 0)]).to_dataframe()
    assert in_space.columns.tolist()[3:] == [
        f"{name}_{axis}" for name in ("force", "torque", "motion", "rotation") for axis in "xyz"]
    assert in_space.loc[0, "force_z"] == -1


def test_errors_name_the_question(fig1):
    in_space = Grasp([[0, 0, 0]], [[0, 0, 1]], 1, preload=1)
    for call, place in (
            (lambda: decide(fig1, [[0, 1, 0], [0, "x", 0]]), "wrench[1][1]"),
            (lambda: decide(fig1, [[0, 1, 0], [0, 1]]), "wrench[1]"),
            (lambda: decide(fig1, [[0, 1], [0, 1]]), "wrench"),
            (lambda: decide(fig1, UP, friction=[1, -1]), "question 1, contacts[0].friction"),
            (lambda: decide(fig1, UP, friction=[1, "nan"]), "friction[1]"),
            (lambda: decide(fig1, UP, friction=[[1, 1, 1], [1, 1]]), "friction[1]"),
            (lambda: decide(fig1, UP, preload=[1, -1]), "question 1, preload"),
            (lambda: decide(fig1, UP, preload=[1, None]), "preload[1]"),
            (lambda: decide(fig1, WRENCHES, friction=[1, 2]), "wrench, friction"),
            (lambda: decide([fig1, 3], UP), "grasp"),
            (lambda: decide([fig1, fig1], WRENCHES), "grasp, wrench"),
            (lambda: decide(fig1, WRENCHES, warnings=True), "warnings"),
            (lambda: decide(fig1, WRENCHES, engine="best"), "engine"),
            (lambda: decide([fig1, in_space]), "grasp"),
            (lambda: decide(in_space, [(0, 0, 1)]), "wrench"),
            (lambda: decide(in_space, [(0, 0, 1, 0, 0, 0), (0, 0, 1, 0, "x", 0)]), "wrench[1][4]"),
            (lambda: decide([in_space], (0,) * 6, engine="branch-and-bound"), "engine"),
            (lambda: decide(in_space, (0,) * 6, friction=[1, -1]), "question 1, contacts[0].friction"),
            (lambda: decide([fig1]), "wrench"),
            (lambda: decide(fig1, friction=[1, 2]), "wrench")):
        with pytest.raises(InputError) as caught:
            call()
        assert caught.value.place == place
        assert caught.value.problem and caught.value.remedy
