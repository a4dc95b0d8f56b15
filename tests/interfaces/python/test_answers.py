# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever decide returns has the same attributes; loads, and that there is one."""

import pickle
import xml.etree.ElementTree as ElementTree
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import stickslip
from conftest import ROOT, program
from stickslip import CheckResult, Grasp, InputError, LimitReached, decide, wrench_of

UP = (0, "1/2", 0)
IN_SPACE = (0, 0, -1, 0, 0, 0)
BREAKS = Grasp.from_file(ROOT / "examples" / "grasps" / "more-friction-breaks.json")
TURNED = Grasp([[-1, -1], [1, -1], [0, 1]], [[1, 1], [-1, 1], [0, -1]], 1, preload=1)


@pytest.fixture
def pinch():
    return Grasp([(-1, 0, 0), (1, 0, 0)], [(1, 0, 0), (-1, 0, 0)], "1/2", preload=4)


def answers(fig1, pinch):
    """Of every kind, with the engine and the verdict that they must have."""
    table = Grasp([(3, 2, "-1/2"), (3, -2, "-1/2"), (-3, 0, "-1/2")], [(0, 0, 1)] * 3, "3/5")
    return [
        (decide(fig1, UP), "branch-and-bound", "stable"),
        (decide(fig1, UP, engine="states"), "states", "stable"),
        (decide(fig1, (0, 2, 0)), "branch-and-bound", "unstable"),
        (decide(fig1, (0, 2, 0), engine="branch-and-bound", node_limit=1), "branch-and-bound", "undecided"),
        (decide(fig1, [UP])[0], "branch-and-bound", "stable"),
        (decide(fig1, UP, uncertain="friction=1%"), "intervals", "stable"),
        (decide(fig1, (0, 5, 0), uncertain="friction=1%"), "intervals", "unstable"),
        (decide(BREAKS, uncertain="friction=10%"), "intervals", "fragile"),
        (decide(fig1, (0, "99/100", 0), uncertain="friction=1%", node_limit=1), "intervals", "undecided"),
        (decide(TURNED, (0, "1/10", 0), uncertain={}), "intervals", "stable"),
        (decide(pinch, IN_SPACE), "space", "stable"),
        (decide(pinch, (0, 0, -9, 0, 0, 0)), "space", "unstable"),
        (decide(Grasp.from_file(ROOT / "tests" / "corpus" / "near" / "box4_1_0u.json"), node_limit=1),
         "space", "undecided"),
        (decide(table, ("2/5", 0, -1, 0, 0, 0), uncertain="friction=10%"), "space", "stable"),
        (decide(pinch, (0, 0, -4, 0, 0, 0), uncertain="friction=10%"), "space", "fragile"),
    ]


def test_one_protocol(fig1, pinch):
    for answer, engine, verdict in answers(fig1, pinch):
        assert (answer.engine, answer.verdict) == (engine, verdict), answer
        picture = answer.plot()
        assert picture._repr_svg_() == answer._repr_svg_()
        ElementTree.fromstring(picture)
        if verdict == "undecided":
            assert ": undecided<" in picture[:] and answer.certificate is None
            with pytest.raises(LimitReached) as caught:
                answer.check()
            assert caught.value.limit == answer.limit and answer.limit in str(caught.value)
        else:
            assert answer.limit is None
            result = answer.check()
            assert isinstance(result, CheckResult) and result.accepted
        if verdict == "fragile":
            assert "in the middle of a fragile box" in picture[:] and answer.certificate is None
        elif verdict != "undecided":
            assert f": {verdict}<" in picture[:] and answer.certificate
        assert len(answer.wrench_float) == len(answer.wrench)
        assert pickle.loads(pickle.dumps(answer)) == answer
        assert f"engine='{engine}'" in repr(answer)


def test_numbers_of_a_grasp_as_doubles(fig1, pinch):
    for grasp in (fig1, pinch, TURNED, BREAKS):
        for name in ("positions", "normals", "friction", "stiffness", "preload"):
            np.testing.assert_array_equal(
                getattr(grasp, name + "_float"),
                np.array([[*map(float, row)] if isinstance(row, tuple) else float(row)
                          for row in getattr(grasp, name)]))
    np.testing.assert_array_equal(BREAKS.wrench_float, [float(w) for w in BREAKS.wrench])
    assert Grasp([], [], 1).positions_float.shape == (0, 2) and fig1.wrench_float is None


def test_there_is_a_load(fig1, pinch):
    assert fig1.wrench is None and pinch.wrench is None
    grown = Grasp.gripper(width=2, force=10, friction="1/2")
    placed = Grasp.from_outline([[0, 0], [1, 0], [0, 1]], [["1/2", 0]], 1).grasp
    questions = [decide, stickslip.export, stickslip.compare, stickslip.plot_grasp,
                 lambda g: decide([g, g]), lambda g: decide(g, friction=[1, 2]),
                 lambda g: decide(g, uncertain="friction=1%"),
                 lambda g: stickslip.radius(g, uncertain="friction=1%"),
                 lambda g: stickslip.stability_map(g, "friction=0:1", "load=0:1"),
                 lambda g: stickslip.margin(g, preload_direction="scale"),
                 lambda g: stickslip.crosscheck(g, "stable"),
                 lambda g: stickslip.check(g, "{}"), lambda g: g.page()]
    of_both = (decide, stickslip.plot_grasp, lambda g: g.page())
    for grasp in (fig1, grown, placed, pickle.loads(pickle.dumps(fig1)), pinch, fig1.snap().grasp):
        for ask in of_both if grasp.in_space else questions:
            with pytest.raises(InputError) as caught:
                ask(grasp)
            assert caught.value.place == "wrench"
            assert "no load" in caught.value.problem and "(0, 0, 0" in caught.value.remedy
    # A load of 0 that somebody gave is one, as in every file.
    at_rest = Grasp(fig1.positions, fig1.normals, "1/2", preload=1, wrench=(0, 0, 0))
    assert decide(at_rest).verdict == "stable" and decide(fig1, (0, 0, 0)).verdict == "stable"
    assert decide(pickle.loads(pickle.dumps(at_rest))) == decide(at_rest)
    assert Grasp.from_text(fig1.to_text()) == fig1 and Grasp.from_text(fig1.to_text()).wrench == (0, 0, 0)
    # What needs no load does without.
    assert stickslip.margin(fig1, (0, 1, 0)).check()
    assert stickslip.region(fig1).areas and stickslip.slip_states(fig1).cells
    with pytest.raises(InputError, match="has cases"):
        decide(Grasp([[0, 0]], [[0, 1]], 1, cases={"a": (0, -1, 0)}))


def test_loads_are_those_of_a_file(tmp_path):
    loads = [
        ([{"weight": 10, "at": [2, 1]}, {"force": ["1.5", 0], "at": [2, 3]}],
         (Fraction(3, 2), -10, Fraction(-49, 2))),
        ([{"torque": 0.1}], (0, 0, Fraction(0.1))),
        ([{"weight": 5, "at": np.array([1, 1]), "direction": (3, -4)}], (3, -4, -7)),
        (({"weight": Decimal("0.1"), "at": (Fraction(1, 3), 0)},), (0, Fraction(-1, 10), Fraction(-1, 30))),
        ([{"force": (0, 0, -2), "at": (1, 0, 0)}, {"torque": (0, 0, 1)}], (0, 0, -2, 0, 2, 1)),
        ([{"weight": 3, "at": (0, 1, 0), "direction": (2, 1, -2)}], (2, 1, -2, -2, 0, -2)),
        ([{"weight": 3, "at": (0, 1, 0)}], (0, 0, -3, -3, 0, 0)),
    ]
    for given, wrench in loads:
        found = wrench_of(given)
        assert found == wrench and all(isinstance(w, Fraction) for w in found)
        n = 2 if len(wrench) == 3 else 3
        axis = [0] * (n - 1) + [1]
        grasp = Grasp([[0] * n], [axis], 1, wrench=found, cases={"twice": [2 * w for w in found]})
        assert grasp.wrench == wrench and decide(grasp, found).wrench == wrench
    path = tmp_path / "shelf.json"
    path.write_text('{"format": "stickslip-grasp/2", "contacts": [{"position": [0, 0], "normal": [0, 1], '
                    '"friction": 1}], "loads": [{"weight": 10, "at": [2, 1]}, '
                    '{"force": ["1.5", 0], "at": [2, 3]}]}')
    said = program("decide", path)
    assert tuple(map(Fraction, said["wrench"])) == wrench_of(loads[0][0])


@pytest.mark.parametrize("loads, place, problem", [
    ([], "loads", "[]"), ({"torque": 1}, "loads", "of type dict"), ("torque", "loads", "torque"),
    ([3], "loads[0]", "3"),
    ([{"torque": 1}, {"force": (1, 0)}], "loads[1]", '"at" is missing'),
    ([{"forse": (1, 0), "at": (0, 0)}], "loads[0]", 'unknown key "forse"'),
    ([{"force": (1, 0), "at": (0, "x")}], "loads[0].at[1]", "x"),
    ([{"force": (1, 0), "at": (0, 0, 0)}], "loads[0].force", "2"),
    ([{"weight": -1, "at": (0, 0)}], "loads[0].weight", "-1"),
    ([{"weight": 1, "at": (0, 0), "direction": (1, 1)}], "loads[0].direction", "irrational"),
    ([{"torque": float("nan")}], "loads[0].torque", "finite"),
    ([{}], "loads[0]", "no load")], ids=str)
def test_what_is_no_load(loads, place, problem):
    with pytest.raises(InputError) as caught:
        wrench_of(loads)
    assert caught.value.place == place
    assert problem in caught.value.problem and caught.value.remedy
