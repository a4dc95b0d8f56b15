# SPDX-License-Identifier: GPL-3.0-or-later
"""Boxes as Python takes and gives them; that verdicts and radii are those of the command is in test_program.py."""

import pickle
from fractions import Fraction

import pytest
import stickslip
from conftest import program
from stickslip import Grasp, InputError, decide, radius, stability_map

LOAD = (0, "1/2", 0)


def test_decide(fig1):
    answer = decide(fig1, LOAD, uncertain={"friction": "5%", "wrench": "1%"})
    assert (answer.verdict, answer.uncertain) == ("stable", "friction=5%,wrench=1%")
    assert answer.wrench == (0, Fraction(1, 2), 0)
    assert answer.check() and answer.certificate == answer.proof.certificate
    assert answer == pickle.loads(pickle.dumps(answer))
    assert "BoxDecision(verdict='stable'" in repr(answer)
    assert decide(fig1, LOAD, uncertain="friction=5%,wrench=1%") == answer
    numbers = decide(fig1, LOAD, uncertain={"friction": Fraction(1, 40), "wrench": 0.0078125})
    assert numbers.uncertain == "friction=1/40,wrench=1/128"
    assert decide(fig1, LOAD, uncertain="friction=5%", friction="1/3").grasp.friction == (Fraction(1, 3),) * 3
    with pytest.raises(InputError, match=r"contacts\[0\].friction: the number is uncertain"):
        Grasp.from_text(answer.proof.grasp)


def test_irrational_lengths(fig1, tmp_path):
    turned = Grasp([[-1, -1], [1, -1], [0, 1]], [[1, 1], [-1, 1], [0, -1]], 1, preload=1,
                   wrench=(0, "1/10", 0))
    path = tmp_path / "turned.json"
    path.write_text(turned.to_text())
    answer = decide(turned, uncertain={})
    found = program("decide", path)
    assert (answer.verdict, answer.stats) == (found["verdict"], found["stats"])
    assert answer.uncertain == "" and answer.check().verdict == "stable"
    for ask in (lambda: decide(fig1, LOAD, uncertain={}), lambda: radius(turned, uncertain={})):
        with pytest.raises(InputError) as error:
            ask()
        assert error.value.place == "uncertain"


def test_balls_of_loads(fig1, tmp_path):
    """Each proof says for which ball it is, which is part of the question."""
    answer = decide(fig1, LOAD, uncertain="wrench=ball:1/20:length=2")
    assert answer.proof.uncertain == "wrench=ball:1/20:length=2"
    path = tmp_path / "g.json"
    path.write_text(answer.proof.grasp)
    assert stickslip.check(path, answer.certificate, uncertain=answer.uncertain)
    other = stickslip.check(path, answer.certificate, uncertain="wrench=ball:1/10:length=2")
    assert other.rule == "question-uncertain"
    with pytest.raises(InputError, match="ball:"):
        stickslip.check(path, answer.certificate, uncertain="wrench=ball:1:width=2")


def test_samples(tmp_path):
    """A contact pressed with 10 holds a push of 5 iff its friction is 1/2 or more."""
    pressed = Grasp([[0, 0]], [[0, 1]], "1/2", wrench=(5, -10, 0))
    answer = decide(pressed, uncertain={"friction": "1/10"}, samples=30, seed=5)
    path = tmp_path / "g.json"
    path.write_text(pressed.to_text())
    found = program("decide", path, "--uncertain", "friction=1/10", "--samples", "30", "--seed", "5")["samples"]
    samples = answer.samples
    assert answer.verdict == "fragile"
    assert (samples.count, samples.seed, samples.undecided) == (30, 5, 0)
    assert all(found[name] == getattr(samples, name) for name in ("stable", "unstable", "undecided"))
    assert {name: Fraction(share) for name, share in found["share"].items()} == samples.share
    assert len(samples.failures) == samples.unstable and all(proof.check() for proof in samples.failures)
    assert all(Grasp.from_text(proof.grasp).friction[0] < Fraction(1, 2) for proof in samples.failures)
    assert decide(pressed, uncertain={"friction": "1/10"}).samples is None
    assert decide(pressed, (3, -10, 0), uncertain={"friction": "1/10"}, samples=3).samples is None
    with pytest.raises(InputError, match="samples: the question is about one grasp"):
        decide(pressed, samples=3)


def test_arguments(fig1):
    for value, message in [(1, "uncertain: "), ({"mu": 1}, "no kind of number"), ("", "uncertain"),
                           ({"friction": None}, "friction"), ({"friction": "x"}, "friction"),
                           ({"friction": 0}, "nothing is uncertain")]:
        for ask in (decide, radius):
            with pytest.raises(InputError, match=message):
                ask(fig1, LOAD, uncertain=value)
    with pytest.raises(InputError, match="engine"):
        decide(fig1, LOAD, uncertain="friction=1%", engine="states")
    with pytest.raises(InputError, match="warnings: the question is about a box"):
        decide(fig1, LOAD, uncertain="friction=1%", warnings=True)
    for accuracy in (0, 1, -1, "x"):
        with pytest.raises(InputError, match="accuracy"):
            radius(fig1, LOAD, uncertain="friction=1%", accuracy=accuracy)
    with pytest.raises(InputError, match=r"contacts\[0\].friction"):
        decide(fig1, LOAD, uncertain="friction=101%")
    with pytest.raises(InputError, match="wrench"):
        decide(fig1, [LOAD, LOAD], uncertain="friction=1%")
    with pytest.raises(InputError) as error:
        stability_map(fig1, "friction=1:0", "load=0:1", LOAD)
    assert error.value.place == "x"
    [cell] = stability_map(fig1, "friction=1/4:1/2", "load=1/4:1/2", LOAD, depth=0).cells
    assert cell.proof is None  # unasked


def test_bounds_of_motions():
    # One contact presses 1 for each unit that it gives, and two jaws less what they are preloaded with.
    foot = Grasp([[0, 0]], [[0, 1]], 1)
    down = (0, -1, 0)
    close, far = (("1/2", 1), ("2", 1))
    assert radius(foot, down, uncertain="friction=10%", max_motion=close).verdict == "unstable"
    assert radius(foot, down, uncertain="friction=10%", max_motion=far).verdict == "stable"
    assert stickslip.quality(foot, (0, -2, 0), max_motion=close).verdict == "unstable"
    held = stickslip.quality(foot, (0, -2, 0), max_motion=(3, 1), accuracy="1/10")
    assert held.verdict in ("stable", "undecided") and held.proved <= 1
    plane = stability_map(foot, "1,0,0=-7:7", "0,1,0=-7:7", (0, 0, 0), max_motion=(3, 1), depth=4, proofs=True)
    assert {"stable", "unstable"} <= {cell.verdict for cell in plane.cells}
    for cell in plane.cells:
        if cell.verdict == "stable":
            assert -3 <= cell.y[0] and cell.y[1] <= 0
    assert next(cell for cell in plane.cells if cell.verdict == "stable").proof.check()
    jaws = Grasp([[-1, 0, 0], [1, 0, 0]], [[1, 0, 0], [-1, 0, 0]], "1/2")
    best = stickslip.best_preload(jaws, (4, 0, 0, 0, 0, 0), max_motion=(3, 1), accuracy="1/10")
    assert 1 <= best.sum < Fraction(11, 10)
    assert stickslip.best_preload(jaws, (4, 0, 0, 0, 0, 0), max_motion="none").sum == 0
    passive, *others = stickslip.compare(foot, down, max_motion=close).methods
    assert passive.verdict == "unstable" and any(method.agrees is False for method in others)
    proof = stickslip.compare(foot, down, max_motion=close, certificate=True).certificate
    assert stickslip.check(foot, proof, wrench=down, inertia=(0, 0, 1)).verdict == "must hold"
    assert stickslip.region(foot, max_motion="none").areas
    with pytest.raises(InputError, match="stability_map"):
        stickslip.region(foot, max_motion=close)
    for ask in (lambda bound: radius(foot, down, uncertain="friction=10%", max_motion=bound),
                lambda bound: stability_map(foot, "friction=0:1", "load=0:1", down, max_motion=bound),
                lambda bound: stickslip.best_preload(foot, down, max_motion=bound),
                lambda bound: stickslip.compare(foot, down, max_motion=bound)):
        for wrong in ((1, 2, 3, 4), "fast", (-1, 1)):
            with pytest.raises(InputError, match="max_motion"):
                ask(wrong)
