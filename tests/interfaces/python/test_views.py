# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers as people see them: nearest doubles, and a few readable lines."""

import dataclasses
import math
import re
from fractions import Fraction

import numpy as np
import pytest
from stickslip import (CheckResult, CrossCheck, Decision, Grasp, Margin, NearbyEquilibrium, check,
                       crosscheck, decide, margin, slip_states)
from stickslip.results import Residual
from stickslip.views import nearest_double, nearest_root, shown

UP, DOWN = (0, 1, 0), (0, -1, 0)
LARGEST = Fraction(2**1024 - 2**971)


def is_nearest(double, distance_sign):
    """By definition: the value lies between the borders halfway to the neighbours.

    ``distance_sign`` is that of (value - its argument).
    """
    even = math.frexp(double)[0] * 2**53 % 2 == 0 if abs(double) > 2.0**-1000 else None
    for neighbour, sign in ((math.nextafter(double, math.inf), -1),
                            (math.nextafter(double, -math.inf), 1)):
        step = Fraction(neighbour) if math.isfinite(neighbour) else -sign * Fraction(2**1024)
        side = sign * distance_sign((Fraction(double) + step) / 2)
        if side < 0 or (side == 0 and even is False):
            return False
    return True


def sign(x):
    return (x > 0) - (x < 0)


@pytest.mark.parametrize("value", [
    Fraction(0), Fraction(1, 3), Fraction(-2, 3), Fraction(2**53 + 1), Fraction(2**53 + 3),
    Fraction(2**54 + 1, 2), Fraction(10**5000 + 1, 10**5000), Fraction(10**5000, 3 * 10**4900 + 1),
    Fraction(-7**3000, 7**3001 - 1), LARGEST, Fraction(1, 2**1074), Fraction(3, 2**1075),
    Fraction(5, 2**1076), Fraction(10**400, 10**720 + 3)], ids=lambda value: None)
def test_nearest_doubles(value):
    double = nearest_double(value)
    assert is_nearest(double, lambda border: sign(value - border))
    assert nearest_double(-value) == -double


def test_beyond_the_doubles():
    assert nearest_double(Fraction(10**400)) == math.inf == -nearest_double(Fraction(-10**400, 3))
    assert nearest_double(LARGEST + 2**970 - 1) == float(LARGEST)
    assert nearest_double(LARGEST + 2**970) == math.inf
    assert nearest_double(Fraction(1, 10**400)) == 0
    assert nearest_double(Fraction(1, 2**1075)) == 0  # a tie, to even
    assert nearest_double(Fraction(1, 2**1075) + Fraction(1, 10**5000)) == 2.0**-1074


@pytest.mark.parametrize("square", [
    Fraction(0), Fraction(4, 9), Fraction(2), Fraction(1, 3), Fraction(10**500, 7),
    Fraction(7, 10**500), Fraction((2**53 + 1)**2), Fraction((2**53 + 1)**2) + Fraction(1, 10**900),
    Fraction((2**53 + 1)**2) - Fraction(1, 10**900), Fraction(1, 2**2147), Fraction(9, 2**2150),
    Fraction(10**5000, 10**5000 - 1)], ids=lambda value: None)
def test_nearest_roots(square):
    root = nearest_root(square)
    assert is_nearest(root, lambda border: sign(square - border * abs(border)))


def test_many_nearest_roots():
    random = np.random.default_rng(5)
    for _ in range(500):
        square = Fraction(int(random.integers(1, 2**62)) << int(random.integers(0, 300)),
                          int(random.integers(1, 2**62)) << int(random.integers(0, 300)))
        assert is_nearest(nearest_root(square), lambda border: sign(square - border * abs(border)))


@pytest.mark.parametrize("value, text", [
    (Fraction(0), "0"), (Fraction(-3), "-3"), (Fraction(11, 10), "11/10"), (Fraction(0.1), "~0.1"),
    (Fraction("21.534"), "21.534"), (Fraction(2, 3 * 10**9), "~6.66667e-10"),
    (Fraction(10**5000 + 1, 10**5000), "~1"), (Fraction(1, 7 * 10**20000), "~1.42857e-20001"),
])
def test_numbers_are_written_as_by_the_programs(value, text):
    assert shown(value) == text


def unit_normals(m):
    angle = np.random.default_rng(m).uniform(0, 7, m)
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    return Grasp(circle, -circle, 0.5, preload=1).snap().grasp


def answers(grasp):
    """One of each, of values of every length."""
    stable = decide(grasp, DOWN)
    limits = margin(grasp, UP)
    claim = {"twist": stable.twist_float, "forces": stable.forces_float, "wrench": DOWN}
    return [stable, decide(grasp, (0, 10**6, 0)), limits, slip_states(grasp),
            check(grasp, stable.certificate, wrench=DOWN),
            check(grasp, limits.certificate, direction=UP),
            check(grasp, stable.certificate, wrench=UP), crosscheck(grasp, "stable", **claim),
            crosscheck(grasp, "unstable", wrench=DOWN)]


@pytest.mark.parametrize("m", [3, 4, 40])
def test_answers_are_a_few_lines(m):
    for answer in answers(unit_normals(m)):
        text = repr(answer)
        assert text.startswith(type(answer).__name__ + "(") and text.endswith(")")
        lines = text.split("\n")
        nests = isinstance(answer, CrossCheck)
        assert len(lines) <= (20 if nests else 9)
        assert max(map(len, lines)) <= (125 if nests else 96)
        assert "Fraction" not in text and not re.search(r"[1-9]\d{17}", text)


def test_the_text_of_an_answer(fig1):
    assert repr(decide(fig1, UP, engine="states")) == (
        "Decision(verdict='stable', engine='states', normal_law='unilateral', wrench=(0, 1, 0),\n"
        "         twist=(0, 1, 0), forces=((1, -1/2), (0, 0), (-1, -1/2)), slip='+0-',\n"
        "         closed=(True, True, True))")
    assert repr(margin(fig1, DOWN, wrench=(0, "1/3", 0))) == (
        "Margin(resisted=((0, None),), direction=(0, -1, 0), wrench=(0, 1/3, 0), "
        "normal_law='unilateral')")
    assert repr(check(fig1, decide(fig1, UP).certificate, wrench=DOWN)).startswith(
        "CheckResult(accepted=False, rule='question-wrench',")
    assert repr(Residual(Fraction(2), 1)) == "Residual(value=~1.41421, contact=1)"
    assert repr(Residual(Fraction(0), None)) == "Residual(value=0, contact=None)"
    many = decide(Grasp([[0, 0]] * 200, [[0, 1]] * 200, 1), DOWN)
    assert re.search(r"closed=\((True, )+\.\.\. \d+ more\)", repr(many))
    assert re.search(r"slip='[+0-]{64}' \(136 more\)", repr(many))


@pytest.mark.parametrize("m", [0, 1, 4])
def test_float_views(m):
    grasp = unit_normals(m)
    seen = set()
    nearby = crosscheck(grasp, "stable", wrench=DOWN, twist=(0, 0, 0)).nearby
    for answer in [*answers(grasp), nearby]:
        for field in dataclasses.fields(answer) if answer is not None else ():
            exact = getattr(answer, field.name)
            shape = {"resisted": (-1, 2), "forces": (m, 2), "coefficients": (m, 2)}
            if field.name in ("wrench", "twist", "direction", "balance", *shape):
                view = getattr(answer, field.name + "_float")
                seen.add((type(answer), field.name))
                if exact is None:
                    assert view is None
                    continue
                assert view.dtype == np.float64
                expected = [[math.inf if x is None else nearest_double(x)
                             for x in (row if isinstance(row, tuple) else (row,))] for row in exact]
                assert np.array_equal(view, np.array(expected).reshape(
                    shape.get(field.name, (3,))))
    assert len(seen) >= 10


def test_every_vector_of_fractions_has_its_float_view():
    for kind in (Decision, Margin, NearbyEquilibrium, CrossCheck, CheckResult):
        for field in dataclasses.fields(kind):
            if re.search("Triple|Pair|Fraction.*Fraction", str(field.type)):
                assert hasattr(kind, field.name + "_float"), (kind, field.name)


def test_views_do_not_change_answers(fig1):
    answer = decide(fig1, UP)
    answer.forces_float[:] = 7
    assert answer.forces_float[0].tolist() == [1, -0.5]
    with pytest.raises(AttributeError):
        answer.forces_float = None
