# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes of loads on rigid contacts, with certificates."""

from fractions import Fraction

import pytest
import stickslip
from stickslip import ClassRange, Grasp, InputError

HALF = Fraction(1, 2)
INERTIA = (0, 0, "2/3")


@pytest.fixture(name="block")
def a_block():
    """Of width 2 and height 2 on a floor; the preload plays no part in what is asked here."""
    return Grasp([[-1, -1], [1, -1]], [[0, 1], [0, 1]], HALF, preload=1, wrench=(0, -1, 0))


def test_a_block_slides_where_the_load_leaves_the_cone(block):
    assert stickslip.class_margin(block, (1, 0, 0), (0, -1, 0), inertia=INERTIA) == (
        ClassRange("must hold", Fraction(0), HALF, True, True),
        ClassRange("must move", HALF, None, False, False))


def test_what_the_load_starts_from_is_0_unless_given(block):
    assert stickslip.class_margin(block, (0, 1, 0)) == (
        ClassRange("must hold", Fraction(0), Fraction(0), True, True),
        ClassRange("must move", Fraction(0), None, False, False))


@pytest.mark.parametrize("push, kind", [(HALF, "must hold"), (Fraction(51, 100), "must move")])
def test_certificates_of_classes_are_accepted_for_their_inertia(block, push, kind):
    load = (push, -1, 0)
    comparison = stickslip.compare(block, load, inertia=INERTIA, certificate=True,
                                   methods=["weakly-stable-load", "strongly-stable-load"])
    assert comparison.load_class == kind
    result = stickslip.check(block, comparison.certificate, wrench=load, inertia=INERTIA)
    assert (result.accepted, result.verdict) == (True, kind)
    other = stickslip.check(block, comparison.certificate, wrench=load, inertia=(0, 0, 1))
    assert (other.accepted, other.rule) == (False, "question-inertia")
    assert stickslip.compare(block, load).certificate is None


@pytest.mark.parametrize("push, kind", [(Fraction(3, 10), "must hold"), (Fraction(51, 100), "must move")])
def test_classes_in_space(push, kind):
    crate = Grasp([[x, y, 0] for x in (-1, 1) for y in (-1, 1)], [[0, 0, 1]] * 4, HALF, preload=1)
    load, inertia = (push, 0, -1, 0, 0, 0), (0, 0, 1, 1, 1, 1)
    methods = ["weakly-stable-load", "strongly-stable-load"]
    comparison = stickslip.compare(crate, load, inertia=inertia, certificate=True, methods=methods)
    assert (comparison.load_class, len(comparison.methods)) == (kind, 2)
    result = stickslip.check(crate, comparison.certificate, wrench=load, inertia=inertia)
    assert (result.accepted, result.verdict) == (True, kind)
    other = stickslip.check(crate, comparison.certificate, wrench=load, inertia=(*inertia, 0, 0, "1/2"))
    assert (other.accepted, other.rule) == (False, "question-inertia")
    for words, place in (({"methods": ["three-state-compliance"]}, "methods"),
                         ({"methods": methods, "inertia": (0, 0, 1)}, "inertia"),
                         ({"methods": methods, "inertia": (0, 0, 1, 1, 1, -1)}, "inertia")):
        with pytest.raises(InputError) as caught:
            stickslip.compare(crate, load, **words)
        assert caught.value.place == place


def test_the_friction_that_a_load_needs(block):
    assert stickslip.friction_margin(block, (Fraction(1, 3), -1, 0), inertia=INERTIA) == (
        ClassRange("must move", Fraction(0), Fraction(2, 3), True, False),
        ClassRange("must hold", Fraction(2, 3), None, True, False))


def test_friction_whose_border_is_a_root_is_known_to_a_range():
    ladder = stickslip.Grasp([[0, 4], [2, 0]], [[1, 0], [0, 1]], friction=HALF)
    moves, between, *_ = stickslip.friction_margin(ladder, (0, -1, -1))
    # 2 (1 - mu^2) = 8 mu.
    mu = 5 ** 0.5 - 2
    assert (moves.load_class, between.load_class) == ("must move", None)
    assert between.low < Fraction(2 * mu) < between.high < between.low * Fraction(1000001, 1000000)


def test_errors(block):
    for call, place in ((lambda: stickslip.class_margin(block, (1, 0)), "direction"),
                        (lambda: stickslip.class_margin(block, (1, 0, 0), inertia=(0, 0, 0)), "inertia"),
                        (lambda: stickslip.friction_margin(block, (1, 0, 0), accuracy=0), "accuracy"),
                        (lambda: stickslip.check(block, "{}", wrench=(0, 0, 0), inertia=(0, 0)), "inertia")):
        with pytest.raises(InputError) as caught:
            call()
        assert caught.value.place == place


def test_all_methods_in_space():
    crate = Grasp([[x, y, 0] for x in (-1, 1) for y in (-1, 1)], [[0, 0, 1]] * 4, HALF)
    for push, verdict in ((Fraction(3, 10), "stable"), (Fraction(51, 100), "unstable")):
        comparison = stickslip.compare(crate, (push, 0, -1, 0, 0, 0))
        verdicts = {row.method: row.verdict for row in comparison.methods}
        assert len(verdicts) == 8
        for name in ("passive equilibrium", "weakly stable load", "friction cones alone"):
            assert verdicts[name] == verdict
        assert verdicts["form closure"] == verdicts["grasp wrench space, L1"] == "not closed"
