# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdicts about all grasps in a box, and how far numbers may be off; both checkers judge them."""

import pickle
import subprocess
import sys
from fractions import Fraction

import pytest
import stickslip
from conftest import CHECK_PY, ROOT, program
from stickslip import Grasp, InputError, decide, radius, stability_map

# More friction breaks it: stable up to 1/2 at contact 2, unstable above.
A = ROOT / "examples" / "grasps" / "more-friction-breaks.json"
LOAD = (0, "1/2", 0)


def judged(tmp_path, proof):
    """What both checkers say of it, once they say the same."""
    (tmp_path / "g.json").write_text(proof.grasp)
    (tmp_path / "c.json").write_text(proof.certificate)
    option = ["--uncertain", proof.uncertain] if proof.uncertain else []
    result = subprocess.run([sys.executable, "-B", CHECK_PY, tmp_path / "g.json", tmp_path / "c.json", *option],
                            capture_output=True, text=True, check=False, timeout=300)
    assert result.returncode == 0, result.stdout + result.stderr
    answer = proof.check()
    assert answer, answer
    assert f"verdict     {answer.verdict}" in result.stdout
    return answer.verdict


def test_decide(fig1, tmp_path):
    answer = decide(fig1, LOAD, uncertain={"friction": "5%", "wrench": "1%"})
    assert (answer.verdict, answer.uncertain) == ("stable", "friction=5%,wrench=1%")
    assert answer.wrench == (0, Fraction(1, 2), 0)
    assert judged(tmp_path, answer.proof) == "stable"
    assert answer.check() and answer.certificate == answer.proof.certificate
    assert answer.examples is None and answer.limit is None
    assert answer == pickle.loads(pickle.dumps(answer))
    assert "BoxDecision(verdict='stable'" in repr(answer)
    for same in ("friction=5%,wrench=1%", {"friction": "5%", "wrench": "1%"}):
        assert decide(fig1, LOAD, uncertain=same) == answer
    numbers = decide(fig1, LOAD, uncertain={"friction": Fraction(1, 40), "wrench": 0.0078125})
    assert numbers.uncertain == "friction=1/40,wrench=1/128"
    assert numbers.verdict == "stable"
    far = decide(fig1, (0, 5, 0), uncertain="friction=5%")
    assert judged(tmp_path, far.proof) == "unstable" == far.verdict


def test_irrational_lengths(fig1, tmp_path):
    turned = Grasp([[-1, -1], [1, -1], [0, 1]], [[1, 1], [-1, 1], [0, -1]], 1, preload=1,
                   wrench=(0, "1/10", 0))
    path = tmp_path / "turned.json"
    path.write_text(turned.to_text())
    answer = decide(turned, uncertain={})
    found = program("decide", path)
    assert (answer.verdict, answer.stats) == (found["verdict"], found["stats"])
    assert answer.uncertain == "" and judged(tmp_path, answer.proof) == "stable"
    for ask in (lambda: decide(fig1, LOAD, uncertain={}), lambda: radius(turned, uncertain={})):
        with pytest.raises(InputError) as error:
            ask()
        assert error.value.place == "uncertain"


def test_same_as_the_program(fig1, tmp_path):
    path = tmp_path / "fig1.json"
    path.write_text(fig1.to_text())
    found = program("decide", path, "--wrench", "0,1/2,0", "--uncertain", "friction=5%")
    answer = decide(fig1, LOAD, uncertain="friction=5%")
    assert (answer.verdict, answer.stats) == (found["verdict"], found["stats"])
    expected = program("radius", path, "--wrench", "0,1/2,0", "--uncertain", "friction=10%")
    found = radius(fig1, LOAD, uncertain="friction=10%")
    assert (found.verdict, found.proved, found.refuted, found.limit) == (
        expected["verdict"], *(Fraction(expected[name]) for name in ("proved", "refuted", "limit")))


def test_fragile(tmp_path):
    grasp = Grasp.from_file(A)
    answer = decide(grasp, uncertain={"friction": "10%"})
    assert (answer.verdict, answer.proof, answer.certificate) == ("fragile", None, None)
    for proof, verdict in zip(answer.examples, ("stable", "unstable")):
        assert judged(tmp_path, proof) == verdict
        example = Grasp.from_text(proof.grasp)
        assert decide(example).verdict == verdict
        for mu in example.friction:
            assert abs(mu - Fraction(2, 5)) <= Fraction(1, 25)
    assert answer.check().verdict == "unstable"


def test_radius(fig1, tmp_path):
    answer = radius(fig1, LOAD, uncertain={"friction": "10%", "wrench": "5%"})
    assert answer.verdict == "stable"
    assert 0 < answer.proved < answer.refuted <= answer.limit
    assert judged(tmp_path, answer.proof) == "stable"
    assert judged(tmp_path, answer.counterexample) == "unstable"
    for mu in Grasp.from_text(answer.counterexample.grasp).friction:
        assert abs(mu - Fraction(1, 2)) <= answer.refuted / 20
    rough = radius(fig1, LOAD, uncertain="friction=10%,wrench=5%", accuracy=0.5)
    assert rough.proved <= answer.refuted
    assert rough.refuted > answer.proved


def test_balls_of_loads(fig1, tmp_path):
    """Each proof says for which ball it is, which is part of the question."""
    answer = decide(fig1, LOAD, uncertain="wrench=ball:1/20:length=2")
    assert judged(tmp_path, answer.proof) == answer.verdict == "stable"
    assert answer.proof.uncertain == "wrench=ball:1/20:length=2"
    assert stickslip.check(tmp_path / "g.json", answer.certificate, uncertain=answer.uncertain)
    other = stickslip.check(tmp_path / "g.json", answer.certificate, uncertain="wrench=ball:1/10:length=2")
    assert other.rule == "question-uncertain"
    with pytest.raises(InputError, match="ball:"):
        stickslip.check(tmp_path / "g.json", answer.certificate, uncertain="wrench=ball:1:width=2")
    far = radius(fig1, LOAD, uncertain="wrench=ball:1/20:length=2")
    assert judged(tmp_path, far.proof) == "stable"
    assert far.proof.uncertain == f"wrench=ball:{far.proved / 20}:length=2"
    assert far.counterexample.uncertain == "" and judged(tmp_path, far.counterexample) == "unstable"


def test_map_of_uncertain_numbers(fig1, tmp_path):
    path = tmp_path / "g.json"
    path.write_text(fig1.to_text())
    axes = "friction[0]=1/4:1", "preload=1/2:2"
    expected = program("map", path, "--wrench", "0,1/2,0", "--x", axes[0], "--y", axes[1],
                       "--depth", "2", "--uncertain", "wrench=ball:1/10")
    found = stability_map(fig1, *axes, LOAD, uncertain={"wrench": "ball:1/10"}, depth=2, proofs=True)
    assert found.uncertain == expected["uncertain"] == "wrench=ball:1/10"
    assert [c.verdict for c in found.cells] == [c["verdict"] for c in expected["cells"]]
    assert any(c.verdict == "stable" for c in found.cells)
    for cell in found.cells:
        if cell.proof is not None:
            assert judged(tmp_path, cell.proof) == cell.verdict
    with pytest.raises(InputError, match="the axis load varies the load"):
        stability_map(fig1, "load=0:1", axes[0], LOAD, uncertain="wrench=ball:1")


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


def test_map_is_that_of_the_program(fig1, tmp_path):
    path, svg = tmp_path / "g.json", tmp_path / "map.svg"
    path.write_text(fig1.to_text())
    axes = "friction[0]=0:1", "load=1/2:2"
    expected = program("map", path, "--wrench", "0,1/2,0", "--x", axes[0], "--y", axes[1],
                       "--depth", "3", "--svg", svg)
    found = stability_map(fig1, *axes, LOAD, depth=3, proofs=True)
    assert svg.read_text() == found.picture == found._repr_svg_()
    assert [(list(c.x), list(c.y), c.verdict) for c in found.cells] == [
        (list(map(Fraction, c["x"])), list(map(Fraction, c["y"])), c["verdict"])
        for c in expected["cells"]]
    for cell in found.cells:
        assert (cell.proof is None) == (cell.verdict == "undecided")
        if cell.proof is not None:
            assert cell.proof.check().verdict == cell.verdict
    assert stability_map(fig1, *axes, LOAD, depth=3).cells[0].proof is None
    with pytest.raises(InputError) as error:
        stability_map(fig1, "friction=1:0", "load=0:1", LOAD)
    assert error.value.place == "x"
