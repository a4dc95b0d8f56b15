# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps in space: arrays of three coordinates, what answers have of them, and errors."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
import stickslip
from conftest import ROOT
from stickslip import Decision, Grasp, InputError, crosscheck, decide

EXAMPLES = ROOT / "examples" / "grasps"
DOWN = (0, 0, -1, 0, 0, 0)


@pytest.fixture
def pinch():
    """Two fingers of 4 N; they hold up to 4 N."""
    return Grasp(np.array([[-2, 0, 0], [2, 0, 0]]), np.array([[1, 0, 0], [-1, 0, 0]]), "1/2",
                 preload=4, name="pinch")


def test_arrays_in_and_out(pinch):
    assert pinch.in_space and len(pinch) == 2
    assert pinch.positions == ((-2, 0, 0), (2, 0, 0))
    assert pinch.normals == ((1, 0, 0), (-1, 0, 0))
    assert (pinch.friction, pinch.stiffness, pinch.preload) == (
        (Fraction(1, 2),) * 2, (1, 1), (4, 4))
    assert pinch.wrench is None and pinch.outline == () and not pinch.units
    decision = decide(pinch, np.array([0, 0, -1.5, 0, 0, 0]))
    assert decision.forces_float.tolist() == [[4, 0, 0.75], [-4, 0, 0.75]]
    assert decision.wrench_float.tolist() == [0, 0, -1.5, 0, 0, 0]
    assert decision.twist_float.shape == (6,)
    assert isinstance(decision, Decision) and "twist=(0, 0, 0, 0, 0, 0)" in repr(decision)
    alone = Grasp([], [], 1, wrench=[0] * 6)
    assert alone.in_space and not Grasp([], [], 1).in_space
    assert decide(alone).verdict == "stable"
    assert decide(alone, DOWN).verdict == "unstable"


def test_a_motion_near_an_equilibrium_where_none_is_exact():
    corner = decide(Grasp.from_file(EXAMPLES / "space-corner.json"))
    assert (corner.verdict, corner.twist, corner.forces_float) == ("stable", None, None)
    assert corner.near_float.shape == (6,) and corner.near_float[2] < 0
    assert "near=(" in repr(corner)


def test_round_trip(pinch):
    cases = {"up": (0, 0, 1, 0, 0, 0), "turned": ("1/3", 0, -1, 0, "1/2", 0)}
    grasp = Grasp(pinch.positions, pinch.normals, [1, "1/2"], [3, "1e-3"], 4, cases=cases,
                  wrench=(1, 0, 0, 0, 0, "-1/7"), name="é\"", units={"length": "m", "force": "N"})
    for again in (Grasp.from_text(grasp.to_text()), pickle.loads(pickle.dumps(grasp))):
        assert again == grasp and hash(again) == hash(grasp)
        assert again.cases == grasp.cases == {name: tuple(map(Fraction, w)) for name, w in cases.items()}
        assert (again.name, again.units) == (grasp.name, grasp.units)
        assert (again.wrench, again.stiffness) == (grasp.wrench, (3, Fraction(1, 1000)))
    assert pickle.loads(pickle.dumps(decide(pinch, DOWN))) == decide(pinch, DOWN)
    assert Grasp(pinch.positions, pinch.normals, 1, preload=4) != pinch
    assert Grasp([[0, 0]], [[1, 0]], 1) != Grasp([[0, 0, 0]], [[1, 0, 0]], 1)
    with pytest.raises(InputError, match=r'none is chosen.*grasp.cases\["up"\]'):
        decide(grasp)


@pytest.mark.parametrize("replaced", [
    {"normals": [[1, 0, 0], [0, 0, 0]]}, {"friction": [1, -1]}, {"stiffness": [1, 0]},
    {"preload": [1, -1]}], ids=str)
def test_errors_of_arrays_name_the_contact_as_those_of_files(pinch, replaced):
    arguments = {"positions": pinch.positions, "normals": pinch.normals, "friction": 1, **replaced}
    with pytest.raises(InputError) as caught:
        Grasp(**arguments)
    assert caught.value.place == "contacts[1]." + next(iter(replaced)).replace("normals", "normal")


@pytest.mark.parametrize("arguments, place", [
    (([[0, 0, 0], [0, 0]], [[0, 0, 1], [0, 0, 1]]), "positions[1]"),
    (([[0, 0], [0, 0, 0]], [[0, 1], [0, 1]]), "positions[1]"),
    (([[0, 0, 0]], [[0, 1]]), "normals"), (([[0, 0, 0, 0]], [[0, 1]]), "positions"),
    (([[0, 0, float("nan")]], [[0, 0, 1]]), "positions[0, 2]"),
    (([[0, 0, 0]], [[0, 0, "x"]]), "normals[0, 2]")], ids=str)
def test_errors_of_shapes(arguments, place):
    with pytest.raises(InputError) as caught:
        Grasp(*arguments, 1)
    assert caught.value.place == place


def test_errors_of_questions(pinch):
    for call, place in (
            (lambda: Grasp([[0, 0, 0]], [[0, 0, 1]], 1, wrench=(0, 0, 0)), "wrench"),
            (lambda: Grasp([[0, 0, 0]], [[0, 0, 1]], 1, cases={"a": (0, 0, 0)}), "cases['a']"),
            (lambda: Grasp([[0, 0, 0]], [[0, 0, 1]], 1, outline=[[0, 0], [1, 0], [0, 1]]), "outline"),
            (lambda: decide(pinch, (0, 0, 1)), "wrench"),
            (lambda: decide(pinch, (0, 0, 1, 0, 0, "x")), "wrench[5]"),
            (lambda: decide(pinch, DOWN, preload=-1), "preload"),
            (lambda: decide(pinch, DOWN, engine="branch-and-bound"), "engine"),
            (lambda: stickslip.margin(pinch, DOWN, accuracy=0), "accuracy"),
            (lambda: stickslip.margin(pinch, (0, 0, -1)), "direction"),
            (lambda: stickslip.margin(pinch), "direction"),
            (lambda: stickslip.margin(pinch, DOWN, preload_direction=[1]), "preload_direction"),
            (lambda: decide(pinch, DOWN, uncertain="normal=1%"), "uncertain"),
            (lambda: decide(pinch, DOWN, uncertain={}), "uncertain"),
            (lambda: stickslip.region(pinch), "grasp"), (lambda: stickslip.plot_region(pinch), "grasp")):
        with pytest.raises(InputError) as caught:
            call()
        assert caught.value.place == place


def test_bounds_of_motions():
    # One contact presses 1 for each unit that it gives.
    foot = Grasp([[0, 0, 0]], [[0, 0, 1]], 1)
    assert decide(foot, DOWN, max_motion=(1, 1)).verdict == "stable"
    small = decide(foot, DOWN, max_motion="1/2,1")
    assert (small.verdict, small.max_motion) == ("unstable", (Fraction(1, 2),) * 3 + (1,) * 3)
    assert small.check().accepted
    assert decide(foot, DOWN, max_motion="none").max_motion is None
    boxed = decide(foot, DOWN, uncertain={"friction": "10%"}, max_motion=(0.5, 1))
    assert boxed.verdict == "unstable"
    bounded = stickslip.margin(foot, DOWN, max_motion=[3] * 6)
    [(low, high)], [(above, end)] = bounded.resisted, bounded.refuted
    assert (low, end) == (0, None) and 2.99 < high <= 3 <= above < 3.01
    assert bounded.check().accepted and bounded.within is None
    assert not stickslip.check(foot, bounded.certificate, direction=DOWN).accepted
    assert stickslip.check(foot, bounded.certificate, direction=DOWN, max_motion=(3, 3)).accepted
    for wrong in ((1, 2, 3), "fast", (-1, 1)):
        with pytest.raises(InputError, match="max_motion"):
            decide(foot, DOWN, max_motion=wrong)


def test_a_margin_that_rounding_ends_has_a_second_one():
    turned = 2 ** -0.5
    hands = Grasp([[-turned, -turned, 0], [turned, turned, 0]], [[turned, turned, 0], [-turned, -turned, 1e-17]],
                  0.5, preload=4)
    margin = stickslip.margin(hands, (turned, -turned, 0, 1e-17, 0, 0))
    [(low, high)], [(above, end)] = margin.within.resisted, margin.within.refuted
    assert (low, end) == (0, None) and 3.99 < high <= 4.01 and high < above < 4.02
    assert margin.within.check().accepted and margin.check().accepted


def test_crosscheck(pinch):
    load = (0, 0, -3, 0, 0, 0)
    forces = [[4, 0, 1.5], [-4, 0, 1.5]]
    right = crosscheck(pinch, "stable", twist=np.zeros(6), forces=forces, wrench=load)
    assert (right.outcome, right.inaccurate, right.claimed_slip) == ("right", False, "00")
    assert right.decision == decide(pinch, load)
    assert right.balance == (0,) * 6 and right.balance_float.shape == (6,)
    assert right.cone == right.normal_law == right.dissipation == (0, None)
    assert right.nearby.from_claim and right.nearby.twist == (0,) * 6
    assert right.nearby.forces == decide(pinch, load).forces
    assert right.nearby.forces_float.shape == (2, 3)

    # Friction (1, 7/4) where there is 2: sqrt(65)/4 - 2.
    forces[1][1:] = 1, 1.75
    off = crosscheck(pinch, "stable", forces=forces, wrench=load)
    assert (off.outcome, off.inaccurate, off.normal_law) == ("right", True, None)
    assert off.balance == (0, 1, Fraction(1, 4), 0, Fraction(-1, 2), 2)
    low, high = off.cone.squared
    # Its square x is 129/16 - sqrt(65).
    assert (Fraction(129, 16) - low) ** 2 > 65 > (Fraction(129, 16) - high) ** 2
    assert off.cone.contact == 1 and high - low < low / 10**17
    assert off.cone.value == pytest.approx(65**0.5 / 4 - 2, rel=1e-12)
    assert "cone=Residual(value=~0.0155644, contact=1)" in repr(off)

    tie = crosscheck(pinch, "stable", wrench=(0, 0, "-4.000000000001", 0, 0, 0))
    assert (tie.outcome, tie.distance) == ("tie", (0, Fraction(1, 10**9)))
    wrong = crosscheck(pinch, "stable", wrench=(0, 0, -5, 0, 0, 0))
    assert (wrong.outcome, wrong.distance[0]) == ("wrong", Fraction(1, 10**9))
    low, high = wrong.distance_along_load
    assert low <= Fraction(1, 5) <= high < low + Fraction(1, 500)
    assert wrong.decision.check()


@pytest.mark.parametrize("place, solution", [
    ("twist", {"twist": [0] * 3}), ("twist[4]", {"twist": [0, 0, 0, 0, np.nan, 0]}),
    ("forces", {"forces": [[0, 0, 0]]}), ("forces[1]", {"forces": [[0, 0, 0], [0, 0]]}),
    ("forces[1, 2]", {"forces": [[0, 0, 0], [0, 0, np.inf]]})])
def test_crosscheck_errors(pinch, place, solution):
    with pytest.raises(InputError) as error:
        crosscheck(pinch, "stable", wrench=DOWN, **solution)
    assert error.value.place == place


def test_doubles_stay_what_they_are():
    """Normals of irrational length need nothing in space."""
    angles = np.array([0.1, 2.2, 4.3])
    circle = np.column_stack([np.cos(angles), np.sin(angles), [0.3, -0.2, 0]])
    fingers = Grasp(circle, -circle, 0.5, preload=1, wrench=(0, 0, "-1/10", 0, 0, 0))
    answer = decide(fingers)
    assert (answer.grasp, answer.snapped) == (fingers, ()) and answer.check()
    assert decide(fingers, uncertain={}).proof.check().verdict == answer.verdict
