# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasp files of version 2: loads, and cases, each a question of its own."""

import pickle

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
