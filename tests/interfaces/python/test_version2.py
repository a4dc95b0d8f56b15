# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasp files of version 2: loads, and cases, each a question of its own."""

import pickle
from fractions import Fraction

import numpy as np
import pytest
from conftest import GOOD
from stickslip import Grasp, InputError, check, decide, margin

# By hand, from tests/corpus/grasps/good/cases.json.
CASES = {"at rest": (0, -10, -20), "pushed": ("3/2", -10, "-49/2"), "lifted": (0, 1, -19)}


@pytest.fixture
def shelf():
    return Grasp.from_file(GOOD / "cases.json")


def of_cases(cases, **more):
    return Grasp([[0, 0], [4, 0]], [[0, 1], [0, 1]], "1/2", 1, wrench=(0, -10, -20), cases=cases,
                 name="shelf", **more)


def test_loads_are_a_wrench():
    assert Grasp.from_file(GOOD / "loads.json").wrench == (4, -16, -20)


def test_cases(shelf):
    assert shelf == of_cases(CASES)
    assert shelf.wrench == (0, -10, -20)
    assert list(shelf.cases) == list(CASES)
    assert shelf.cases == of_cases(CASES).cases
    assert shelf.cases["pushed"][0].denominator == 2
    assert not Grasp([], [], 1).cases


def test_round_trip(shelf):
    for again in (Grasp.from_text(shelf.to_text()), pickle.loads(pickle.dumps(shelf)),
                  shelf.snap().grasp):
        assert again == shelf
        assert again.cases == shelf.cases
        assert again.to_text() == shelf.to_text()
    assert of_cases({**CASES, "lifted": (0, 1, -18)}) != shelf


def test_decide_needs_one_of_them(shelf):
    with pytest.raises(InputError, match=r'wrench: the grasp has cases.*grasp.cases\["at rest"\]'):
        decide(shelf)
    answers = {name: decide(shelf, load) for name, load in shelf.cases.items()}
    assert {name: a.verdict for name, a in answers.items()} == {
        "at rest": "stable", "pushed": "stable", "lifted": "unstable"}
    for name, answer in answers.items():
        assert answer.wrench == shelf.cases[name]
        assert check(shelf, answer.certificate, wrench=shelf.cases[name])
    assert margin(shelf, (1, 0, 0)).wrench == (0, 0, 0)


@pytest.mark.parametrize("cases, message", [
    ({"": (0, 0, 0)}, "a name is empty"), ({1: (0, 0, 0)}, "of type str"),
    ({"lift": (0, 0)}, r"cases\['lift'\]: the shape is \(2,\)"),
    ({"lift": (0, 0, "x")}, r'cases\["lift"\]'), ({"\ud800": (0, 0, 0)}, "surrogate"),
])
def test_bad_cases(cases, message):
    with pytest.raises(InputError, match=message):
        of_cases(cases)


def test_cases_do_not_change(shelf):
    with pytest.raises(TypeError):
        shelf.cases["at rest"] = (0, 0, 0)


SQUARE = [[0, 0], [2, 0], [2, 2], [0, 2]]
HOLE = [["1/2", "1/2"], [1, "1/2"], ["1/2", 1]]
TRIANGLE = [[5, 0], [6, 0], [5, 1]]


def with_outline(outline, **more):
    return Grasp([[1, 0]], [[0, 1]], 1, outline=outline, **more)


def fractions(ring):
    return tuple(tuple(map(Fraction, vertex)) for vertex in ring)


@pytest.mark.parametrize("given, meant", [
    (SQUARE, [[SQUARE]]), (np.array(SQUARE), [[SQUARE]]), ([SQUARE, HOLE], [[SQUARE, HOLE]]),
    ([[SQUARE, HOLE], [TRIANGLE]], [[SQUARE, HOLE], [TRIANGLE]]),
    (np.array([SQUARE]), [[SQUARE]]), ([np.array(SQUARE), np.array(HOLE, dtype=object)], [[SQUARE, HOLE]]),
    ((), []), ([], []),
])
def test_outlines(given, meant):
    grasp = with_outline(given)
    assert grasp.outline == tuple(tuple(map(fractions, polygon)) for polygon in meant)
    for again in (Grasp.from_text(grasp.to_text()), pickle.loads(pickle.dumps(grasp)),
                  grasp.snap().grasp, with_outline(grasp.outline)):
        assert again == grasp
        assert again.outline == grasp.outline
    assert (with_outline([[9, 9], [8, 9], [9, 8]]) == grasp) is False


@pytest.mark.parametrize("outline, place", [
    ("square", "outline"), (4, "outline"), (None, "outline"), ([0, 1, 2], r"outline\[0\]\[0\]"),
    ([[0, 0], [1, 0], [2]], r"outline\[0\]\[0\]\[2\]"), ([[0, 0], [1, 0], [2, 0]], r"outline\[0\]\[0\].*no area"),
    ([[0, 0], [1, 0], [1, 1], [0, 0]], r"outline\[0\]\[0\]\[3\].*closes by itself"),
    ([SQUARE, 3], r"outline\[0\]\[1\]"), ([[SQUARE], 3], r"outline\[1\]"),
    ([[0, 0], [1, 0], [1, "x"]], r"outline\[0\]\[0\]\[2, 1\]"), ([[[[SQUARE]]]], "outline"),
])
def test_bad_outlines(outline, place):
    with pytest.raises(InputError, match=place):
        with_outline(outline)


def test_contacts_on_the_outline():
    grasp = Grasp.from_file(GOOD / "outline.json")
    assert grasp.positions == ((2, 0), (3, 3), (2, 1), (1, 1), (0, 1))
    assert grasp.normals == ((0, 1), (0, -1), (0, -1), (-1, 0), (1, 0))
    assert len(grasp.outline[0]) == 2


def test_units():
    units = {"length": "mm", "force": "N"}
    grasp = Grasp([], [], 1, units=units)
    assert grasp.units == units
    assert Grasp.from_text(grasp.to_text()).units == grasp.snap().grasp.units == units
    assert grasp != Grasp([], [], 1)
    assert not Grasp([], [], 1).units


@pytest.mark.parametrize("units, message", [
    ({"length": "mm"}, "give both"), ({"length": "mm", "force": 1}, r"units\['force'\]"),
    ({"length": "", "force": "N"}, "1 to 16 bytes"), ({"length": "m" * 17, "force": "N"}, "1 to 16"),
])
def test_bad_units(units, message):
    with pytest.raises(InputError, match=message):
        Grasp([], [], 1, units=units)
