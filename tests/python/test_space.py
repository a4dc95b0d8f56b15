# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps in space: arrays of three coordinates, and the answers, proofs and errors of the program."""

import json
import os
import pickle
import subprocess
from fractions import Fraction

import numpy as np
import pytest
import stickslip
from conftest import ROOT, check_py, program
from stickslip import Decision, Grasp, InputError, crosscheck, decide
from test_boxes import judged

EXAMPLES = ROOT / "examples" / "grasps"
FILES = [*sorted(EXAMPLES.glob("space-*.json")),
         *sorted((ROOT / "tests" / "corpus" / "near").glob("*4_*.json"))]
DOWN = (0, 0, -1, 0, 0, 0)


@pytest.fixture
def pinch():
    """Two fingers of 4 N; they hold up to 4 N."""
    return Grasp(np.array([[-2, 0, 0], [2, 0, 0]]), np.array([[1, 0, 0], [-1, 0, 0]]), "1/2",
                 preload=4, name="pinch")


def numbers(texts):
    return tuple(map(Fraction, texts))


def written(tmp_path, grasp):
    path = tmp_path / "g.json"
    path.write_text(grasp.to_text())
    return path


def balance(grasp, decision):
    total = list(decision.wrench)
    for p, f in zip(grasp.positions, decision.forces):
        total[:3] = [a + b for a, b in zip(total[:3], f)]
        turned = (p[1] * f[2] - p[2] * f[1], p[2] * f[0] - p[0] * f[2], p[0] * f[1] - p[1] * f[0])
        total[3:] = [a + b for a, b in zip(total[3:], turned)]
    return total


def assert_same_as_the_program(tmp_path, path, words, decision):
    """The answer, the bytes of the proof, and what both checkers say."""
    proof = tmp_path / "proof.json"
    expected = program("decide", path, "--certificate", proof, *words)
    assert decision.verdict == expected["verdict"] != "undecided"
    assert (decision.engine, decision.normal_law) == ("space", expected["normal_law"])
    assert decision.stats == expected["stats"]
    assert decision.certificate == proof.read_text()
    assert decision.twist == (numbers(expected["twist"]) if "twist" in expected else None)
    assert decision.near == (numbers(expected["near"]) if "near" in expected else None)
    assert (decision.slip, decision.coefficients) == (None, None)
    if decision.twist is not None:
        contacts = expected["contacts"]
        assert decision.forces == tuple(numbers(c["force"]) for c in contacts)
        assert decision.closed == tuple(c["closed"] for c in contacts)
        assert balance(decision.grasp, decision) == [0] * 6
    else:
        assert decision.forces is decision.closed is None
    assert decision.check().verdict == decision.verdict
    assert decision.check().wrench == decision.wrench


def test_same_answers_and_proofs_as_the_program(tmp_path):
    kinds = set()
    for path in FILES:
        grasp = Grasp.from_file(path)
        assert grasp.in_space
        for words, load in [(("--case", name), load) for name, load in grasp.cases.items()] or [((), None)]:
            decision = decide(grasp, load)
            # The case is named in the question of the program's proof, and no more.
            given = ("--wrench", ",".join(map(str, load))) if load else ()
            assert_same_as_the_program(tmp_path, path, given, decision)
            assert program("decide", path, *words)["verdict"] == decision.verdict
            assert check_py(tmp_path, grasp, decision.certificate, *given)
            kinds.add((decision.verdict, decision.twist is None))
    assert kinds == {("stable", False), ("stable", True), ("unstable", True)}


def test_export(tmp_path, pinch):
    words = [os.environ["STICKSLIP"], "export", written(tmp_path, pinch), "--smt2",
             "--wrench", "0,0,-1,0,0,0"]
    assert stickslip.export(pinch, DOWN) == subprocess.check_output(words, text=True)


def test_what_is_replaced(tmp_path, pinch):
    path = written(tmp_path, pinch)
    load = "0,0,-3,0,0,0"
    for options, words in (({}, []), ({"preload": "7/2"}, ["--preload", "7/2"]),
                           ({"preload": 2}, ["--preload", "2"]),
                           ({"normal_law": "bilateral"}, ["--normal-law", "bilateral"])):
        decision = decide(pinch, load.split(","), **options)
        assert_same_as_the_program(tmp_path, path, ["--wrench", load, *words], decision)
        assert decision.preload == options.get("preload") or decision.preload == Fraction(7, 2)
        assert check_py(tmp_path, pinch, decision.certificate, "--wrench", load, *words)
        assert stickslip.check(path, decision.certificate, wrench=load.split(","), **options)
    assert decide(pinch, load.split(",")).verdict == "stable"
    assert decide(pinch, load.split(","), friction="1/3").verdict == "unstable"
    rule = stickslip.check(pinch, decide(pinch, DOWN).certificate, wrench=(0, 0, -2, 0, 0, 0)).rule
    assert rule == "question-wrench"


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
        assert again.cases == grasp.cases == {name: numbers(w) for name, w in cases.items()}
        assert (again.name, again.units) == (grasp.name, grasp.units)
        assert (again.wrench, again.stiffness) == (grasp.wrench, (3, Fraction(1, 1000)))
    assert pickle.loads(pickle.dumps(decide(pinch, DOWN))) == decide(pinch, DOWN)
    assert Grasp(pinch.positions, pinch.normals, 1, preload=4) != pinch
    assert Grasp([[0, 0]], [[1, 0]], 1) != Grasp([[0, 0, 0]], [[1, 0, 0]], 1)
    with pytest.raises(InputError, match=r'none is chosen.*grasp.cases\["up"\]'):
        decide(grasp)


def said_by_the_program(path, *words):
    result = subprocess.run([os.environ["STICKSLIP"], *words[:1], str(path), *words[1:]],
                            capture_output=True, text=True, check=False, timeout=300)
    assert result.returncode == 2
    return result.stderr


@pytest.mark.parametrize("change", [
    {"position": [0, 0]}, {"normal": [0, 1]}, {"normal": [0, 0, 0]}, {"friction": -1},
    {"stiffness": 0}, {"preload": "-1/2"}, {"position": [0, 0, "x"]}, {"on": [0, 0]}], ids=str)
def test_errors_of_files_are_those_of_the_program(tmp_path, pinch, change):
    content = json.loads(pinch.to_text())
    content["contacts"][1].update(change)
    path = tmp_path / "bad.json"
    path.write_text(json.dumps(content))
    with pytest.raises(InputError) as caught:
        Grasp.from_file(path)
    assert caught.value.place.startswith("contacts[1]")
    assert str(caught.value) in said_by_the_program(path, "decide")


@pytest.mark.parametrize("replaced", [
    {"normals": [[1, 0, 0], [0, 0, 0]]}, {"friction": [1, -1]}, {"stiffness": [1, 0]},
    {"preload": [1, -1]}], ids=str)
def test_errors_of_arrays_name_the_contact_as_those_of_files(tmp_path, pinch, replaced):
    arguments = {"positions": pinch.positions, "normals": pinch.normals, "friction": 1, **replaced}
    with pytest.raises(InputError) as caught:
        Grasp(**arguments)
    (name, values), = replaced.items()
    content = json.loads(pinch.to_text())
    content["contacts"][1][name.removesuffix("s") if name == "normals" else name] = values[1]
    path = tmp_path / "bad.json"
    path.write_text(json.dumps(content))
    assert str(caught.value) in said_by_the_program(path, "decide")


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


def test_errors_of_questions(tmp_path, pinch):
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
            (lambda: decide(pinch, DOWN, uncertain={}), "uncertain")):
        with pytest.raises(InputError) as caught:
            call()
        assert caught.value.place == place
    path = written(tmp_path, pinch)
    for words, options in ((["--engine", "branch-and-bound"], {"engine": "branch-and-bound"}),
                           (["--uncertain", "normal=1%"], {"uncertain": "normal=1%"})):
        with pytest.raises(InputError) as caught:
            decide(pinch, DOWN, **options)
        assert caught.value.problem in said_by_the_program(path, "decide", *words)


def test_what_is_about_the_plane_says_so_as_the_program_does(tmp_path, pinch):
    said = said_by_the_program(written(tmp_path, pinch), "states")
    for ask in (lambda: stickslip.slip_states(pinch), lambda: stickslip.plot_states(pinch)):
        with pytest.raises(InputError, match="the grasp is in space; ") as caught:
            ask()
        assert f"{caught.value.problem}; {caught.value.remedy}" in said


def test_the_region_of_a_plane_is_a_map_over_two_wrenches(tmp_path, pinch):
    for ask in (stickslip.region, stickslip.plot_region):
        with pytest.raises(InputError, match="stability_map"):
            ask(pinch)
    found = stickslip.stability_map(pinch, "0,1,0,0,0,0=-5:5", "0,0,1,0,0,0=-5:5", (0,) * 6, depth=4)
    same = program("region", written(tmp_path, pinch), "--u", "0,1,0,0,0,0", "--v", "0,0,1,0,0,0",
                   "--within=-5:5,-5:5", "--depth", "4")
    assert [(cell.x, cell.y, cell.verdict) for cell in found.cells] == [
        (tuple(map(Fraction, cell["x"])), tuple(map(Fraction, cell["y"])), cell["verdict"])
        for cell in same["cells"]]


def test_crosscheck(tmp_path, pinch):
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
    assert check_py(tmp_path, pinch, wrong.decision.certificate, "--wrench", "0,0,-5,0,0,0")
    # The same as the program.
    path = tmp_path / "claims.jsonl"
    path.write_text(json.dumps({"grasp": json.loads(pinch.to_text()), "claim": {"verdict": "stable"},
                                "options": {"wrench": [0, 0, -5, 0, 0, 0]}}))
    printed = subprocess.run([os.environ["STICKSLIP"], "crosscheck", path, "--json"],
                             capture_output=True, text=True, check=False, timeout=300).stdout
    distance = json.loads(printed.splitlines()[0])["distance"]
    assert wrong.distance_along_load == numbers(distance["along_load"])


@pytest.mark.parametrize("place, solution", [
    ("twist", {"twist": [0] * 3}), ("twist[4]", {"twist": [0, 0, 0, 0, np.nan, 0]}),
    ("forces", {"forces": [[0, 0, 0]]}), ("forces[1]", {"forces": [[0, 0, 0], [0, 0]]}),
    ("forces[1, 2]", {"forces": [[0, 0, 0], [0, 0, np.inf]]})])
def test_crosscheck_errors(pinch, place, solution):
    with pytest.raises(InputError) as error:
        crosscheck(pinch, "stable", wrench=DOWN, **solution)
    assert error.value.place == place


def test_boxes(tmp_path):
    table = Grasp([[3, 2, "-1/2"], [3, -2, "-1/2"], [-3, 0, "-1/2"]], [[0, 0, 1]] * 3, 1,
                  wrench=("2/5", 0, -1, 0, 0, 0))
    path = tmp_path / "g.json"
    uncertain = {"friction": "10%", "wrench": "1%"}
    for friction, verdict in (("3/5", "stable"), ("1/4", "unstable"), ("2/5", "fragile")):
        feet = Grasp(table.positions, table.normals, friction, wrench=table.wrench)
        path.write_text(feet.to_text())
        expected = program("decide", path, "--uncertain", "friction=10%,wrench=1%")
        answer = decide(table, uncertain=uncertain, friction=friction)
        assert answer.verdict == expected["verdict"] == verdict
        assert answer.stats == expected["stats"]
        assert (answer.wrench, answer.grasp) == (table.wrench, feet)
        assert answer == pickle.loads(pickle.dumps(answer))
        if verdict == "fragile":
            assert answer.proof is None and answer.check()
            for proof, expected_verdict in zip(answer.examples, ("stable", "unstable")):
                assert judged(tmp_path, proof) == expected_verdict
                assert '{"min": ' not in proof.grasp
        else:
            assert answer.examples is None
            assert judged(tmp_path, answer.proof) == verdict and answer.check()
            assert '{"min": ' in answer.proof.grasp
    interval = feet.to_text().replace('"friction": "2/5"', '"friction": {"min": 0, "max": 1}')
    with pytest.raises(InputError, match=r"contacts\[0\].friction: the number is uncertain"):
        Grasp.from_text(interval)


def test_normals_of_irrational_length_need_nothing(tmp_path):
    # As in tests/cli/test_space.py: sqrt 6 w is 24/5 at the threshold.
    sides = [(side, t) for side in (-1, 1) for t in (-1, 1)]
    hands = Grasp([(2 * s + t, 2 * s - t, 2 * s) for s, t in sides], [(-s, -s, -s) for s, _ in sides],
                  "3/10", preload=4, wrench=("19/10", "19/10", "-19/5", 0, 0, 0))
    answer = decide(hands)
    assert answer.snapped == ()
    assert_same_as_the_program(tmp_path, written(tmp_path, hands), (), answer)
    assert check_py(tmp_path, hands, answer.certificate)
    enclosed = decide(hands, uncertain={})
    assert judged(tmp_path, enclosed.proof) == enclosed.verdict == answer.verdict == "stable"
    floats = Grasp(np.array(hands.positions, float), np.array(hands.normals, float) / np.sqrt(3), 0.3,
                   preload=4, wrench=np.array(hands.wrench, float))
    assert decide(floats).verdict == "stable" and decide(floats).grasp == floats


def test_snapping(tmp_path):
    circle = [(np.cos(t), np.sin(t), z) for t, z in ((0.1, 0.3), (2.2, -0.2), (4.3, 0))]
    fingers = Grasp(circle, [(-x, -y, -z) for x, y, z in circle], 0.5, preload=1,
                    cases={"held": (0, 0, "-1/10", 0, 0, 0)})
    flat = Grasp([(0, 0, 0)] * 3, [(2, 1, -2), (1, 1, 0), (0, 0, -3)], 1, preload=1, wrench=DOWN)
    for grasp, contacts in ((fingers, (0, 1, 2)), (flat, (1,))):
        for within in ("1e-9", "1e-12", 0.25):
            snapped, moved = grasp.snap(within)
            assert tuple(one.contact for one in moved) == contacts
            for i, normal, far in moved:
                assert sum(x * x for x in normal) == 1 and snapped.normals[i] == normal
                unit = grasp.normals_float[i] / np.linalg.norm(grasp.normals_float[i])
                assert np.linalg.norm(snapped.normals_float[i] - unit) <= float(far) + 1e-15
                assert 0 < float(far) <= float(within)
            assert snapped.snap(within) == (snapped, ())
            report = program("snap", written(tmp_path, grasp), "-o", tmp_path / "s.json", "--within",
                             within)
            assert (tmp_path / "s.json").read_text() == snapped.to_text()
            assert report == {"name": grasp.name, "moved": [
                {"contact": i, "normal": list(map(str, normal)), "moved_at_most": far}
                for i, normal, far in moved]}
            assert (snapped.positions, snapped.preload, snapped.cases, snapped.wrench) == (
                grasp.positions, grasp.preload, grasp.cases, grasp.wrench)
    assert flat.snap().grasp.normals[1][2] == 0 and flat.snap() == flat.snap("1e-9")
    assert decide(flat.snap().grasp).check()
    for within in (0, 1, "x"):
        with pytest.raises(InputError) as caught:
            fingers.snap(within)
        assert caught.value.place == "within"


@pytest.mark.parametrize("words, options", [
    (["--direction", "1,0,0,0,0,0"], {"direction": (1, 0, 0, 0, 0, 0)}),
    (["--direction", "1,0,0,0,0,0", "--normal-law", "bilateral"],
     {"direction": (1, 0, 0, 0, 0, 0), "normal_law": "bilateral"}),
    (["--preload", "1", "--preload-direction", "scale"], {"preload": 1, "preload_direction": "scale"}),
    (["--preload-direction", "0,1,2"], {"preload_direction": [0, 1, 2]})], ids=str)
def test_margins_are_those_of_the_program(tmp_path, words, options):
    load = (0 if "direction" in options else 1, 0, -1, 0, 0, 0)  # else it slides
    feet = Grasp([[3, 2, 0], [3, -2, 0], [-3, 0, 0]], [[0, 0, 1]] * 3, "1/2")
    proof = tmp_path / "proof.json"
    expected = program("margin", written(tmp_path, feet), "--certificate", proof,
                       "--wrench", ",".join(map(str, load)), "--accuracy", "1/10", *words)
    margin = stickslip.margin(feet, wrench=load, accuracy="1/10", **options)

    def intervals(name):
        return tuple((Fraction(low), None if high is None else Fraction(high))
                     for low, high in expected[name])

    assert (margin.resisted, margin.refuted) == (intervals("resisted"), intervals("refuted"))
    assert margin.resisted or margin.refuted
    assert margin.certificate == proof.read_text() and margin.check()
    assert margin.stats == expected["stats"]
    assert margin.wrench == numbers(expected["wrench"])
    assert margin.direction == options.get("direction") and margin.grasp == feet
    assert pickle.loads(pickle.dumps(margin)) == margin
    assert margin.resisted_float.shape == (len(margin.resisted), 2)


def test_pictures_are_those_of_the_program(tmp_path, pinch):
    for grasp, load in ((pinch, (0, 0, -3, 0, 0, 0)), (pinch, (0, 0, -6, 0, 0, 0)),
                        (Grasp.from_file(EXAMPLES / "space-corner.json"), None)):
        words = ["--wrench", ",".join(map(str, load))] if load else []
        drawn = subprocess.run([os.environ["STICKSLIP"], "plot", "grasp", written(tmp_path, grasp), *words],
                               capture_output=True, text=True, check=False, timeout=300)
        assert (drawn.returncode, drawn.stderr) == (0, "")
        assert stickslip.plot_grasp(grasp, load) == drawn.stdout == decide(grasp, load).plot()
