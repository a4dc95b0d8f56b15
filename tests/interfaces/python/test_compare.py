# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes of loads on rigid contacts, with certificates; comparisons as a whole are in test_program.py."""

from fractions import Fraction

import pytest
import stickslip
from conftest import program
from stickslip import Grasp, InputError

HALF = Fraction(1, 2)
INERTIA = (0, 0, "2/3")


@pytest.fixture(name="block")
def a_block():
    """Of width 2 and height 2 on a floor; the preload plays no part in what is asked here."""
    return Grasp([[-1, -1], [1, -1]], [[0, 1], [0, 1]], HALF, preload=1, wrench=(0, -1, 0))


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


@pytest.mark.parametrize("grasp, load", [([[-1, -1], [1, -1]], (0, -1, 0)), ([[0, 4], [2, 0]], (0, -1, -1))])
def test_ranges_are_those_of_the_program(tmp_path, grasp, load):
    """Of a block on a floor, and of a ladder, where the border of friction is a root."""
    grasp = Grasp(grasp, [[1, 0] if y > 0 else [0, 1] for _, y in grasp], HALF, wrench=load)
    path = tmp_path / "g.json"
    path.write_text(grasp.to_text())
    for found, words in ((stickslip.class_margin(grasp, (1, 0, 0), load, inertia=INERTIA), ("--direction", "1,0,0", "--wrench",
                                                                                        ",".join(map(str, load)))),
                         (stickslip.class_margin(grasp, (0, 1, 0), inertia=INERTIA), ("--direction", "0,1,0")),
                         (stickslip.friction_margin(grasp, inertia=INERTIA, accuracy="1/10"), ("--friction", "--accuracy", "1/10"))):
        said = program("margin", path, "--class", "--inertia", "0,0,2/3", *words)["classes"]
        assert [(row.load_class, row.low, row.high, row.has_low, row.has_high) for row in found] == [
            (row["class"], Fraction(row["low"]), None if row["high"] is None else Fraction(row["high"]), row["has_low"], row["has_high"])
            for row in said]


def test_robustness_has_evidence():
    """A pinch has the distance 3 f / 8 for friction 3/4, and M = diag(2, 2, 2)."""
    pinch = Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], "3/4", wrench=(0, 0, 0))
    for force, least in ((1, 1), (3, 3), ((3, 4), 3)):
        found = stickslip.compare(pinch, max_force=force, accuracy="1/1000")
        for method in ("potential contact robustness", "potential grasp robustness"):
            evidence = found[method].evidence
            assert Fraction(evidence["distance"]) == Fraction(3 * least, 8)
            lower, upper = Fraction(evidence["lower"]), Fraction(evidence["upper"])
            proved = stickslip.compare(pinch, max_force=force, accuracy="1/1000", certificate=True,
                                       methods=["PCR" if "contact" in method else "potential-grasp-robustness"])
            result = stickslip.check(pinch, proved.certificate, robustness=method.split()[1], max_force=force)
            assert (result.accepted, result.verdict, result.bounds) == (True, "bounds", (lower, upper))
            assert stickslip.check(pinch, proved.certificate, robustness=method.split()[1], max_force=7).rule == "question-robustness"
            assert lower ** 2 <= 2 * Fraction(3 * least, 8) ** 2 <= upper ** 2 and upper <= lower * Fraction(1001, 1000)
    for words, place in (({"max_force": 0}, "max_force"), ({"max_force": (1, 2, 3)}, "max_force"), ({"accuracy": 0}, "accuracy")):
        with pytest.raises(InputError) as caught:
            stickslip.compare(pinch, **words)
        assert caught.value.place == place


def test_edges():
    """Friction of a pinch at 45 degrees between the edges of a pyramid is 1/sqrt(2) of that along them."""
    pinch = Grasp([[-1, 0, 0], [1, 0, 0]], [[1, 0, 0], [-1, 0, 0]], "3/4", wrench=(0, "-3/2", "-3/2", 0, 0, 0))
    methods = ["margin-of-internal-forces", "least-normal-forces"]
    pyramid, cone = (stickslip.compare(pinch, max_force=4, methods=methods, edges=edges) for edges in (4, 0))
    assert pyramid["least normal forces"].verdict == "4"
    assert pyramid["margin of internal forces"].evidence["edges"] == 4
    assert pyramid["margin of internal forces"].verdict == "3/4"
    low, high = map(float, cone["least normal forces"].verdict.split(" to "))
    assert low <= 2 * 2 ** 0.5 <= high
    flat = Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], "3/4", wrench=(0, -1, 0))
    for grasp, edges in ((flat, 4), (pinch, 2), (pinch, 65), (pinch, -1)):
        with pytest.raises(InputError) as caught:
            stickslip.compare(grasp, edges=edges)
        assert caught.value.place == "edges"


def test_errors(block):
    for call, place in ((lambda: stickslip.class_margin(block, (1, 0)), "direction"),
                        (lambda: stickslip.class_margin(block, (1, 0, 0), inertia=(0, 0, 0)), "inertia"),
                        (lambda: stickslip.friction_margin(block, (1, 0, 0), accuracy=0), "accuracy"),
                        (lambda: stickslip.check(block, "{}", wrench=(0, 0, 0), inertia=(0, 0)), "inertia")):
        with pytest.raises(InputError) as caught:
            call()
        assert caught.value.place == place
    crate = Grasp([[x, y, 0] for x in (-1, 1) for y in (-1, 1)], [[0, 0, 1]] * 4, HALF, wrench=(0, 0, -1, 0, 0, 0))
    for words, place in (({"methods": ["three-state-compliance"]}, "methods"), ({"inertia": (0, 0, 1)}, "inertia"),
                         ({"inertia": (0, 0, 1, 1, 1, -1)}, "inertia")):
        with pytest.raises(InputError) as caught:
            stickslip.compare(crate, **words)
        assert caught.value.place == place
