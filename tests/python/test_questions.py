# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers: against the paper, against the program on the same grasps, and against both checkers."""

import os
import pickle
import sys
import threading
import time
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import stickslip
from conftest import GOOD, ROOT, check_py, program
from stickslip import Grasp, InputError, check, crosscheck, decide, margin, slip_states

UP, DOWN = (0, 1, 0), (0, -1, 0)
PAPER = ROOT / "paper_examples" / "grasps"
LAWS = ("unilateral", "bilateral")


def numbers(texts):
    return tuple(map(Fraction, texts))


def balance(grasp, decision):
    """The applied wrench and the contact forces, summed."""
    total = list(decision.wrench)
    for (x, y), (fx, fy) in zip(grasp.positions, decision.forces):
        for j, part in enumerate((fx, fy, x * fy - y * fx)):
            total[j] += part
    return total


# --- decide


@pytest.mark.parametrize("engine", ["states", "branch-and-bound", "auto", "cone"])  # a name of old
@pytest.mark.parametrize("wrench, preload, verdict", [  # Table I
    (DOWN, 0, "stable"), ((0, -2, 0), 0, "stable"), (UP, 0, "unstable"), (UP, 1, "stable"),
    ((0, "11/10", 0), 1, "unstable"), ((0, Fraction(1) + Fraction(1, 10**30), 0), 1, "unstable"),
])
def test_the_paper(fig1, engine, wrench, preload, verdict):
    decision = decide(fig1, wrench, preload=preload, engine=engine)
    assert decision.verdict == verdict
    assert decision.engine == ("states" if engine == "states" else "branch-and-bound")
    if verdict == "stable":
        assert balance(fig1, decision) == [0, 0, 0]
        for (a, b), mu in zip(decision.coefficients, fig1.friction):
            assert abs(b) <= mu * a
    else:
        assert decision.twist is decision.forces is decision.slip is None
        assert decision.closed is decision.coefficients is None


@pytest.mark.parametrize("path", sorted(GOOD.iterdir()), ids=lambda path: path.stem)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("engine", ["states", "branch-and-bound"])
def test_same_answer_as_the_program(path, law, engine):
    grasp = Grasp.from_file(path)
    if grasp.cases:
        with pytest.raises(InputError, match="none is chosen"):
            decide(grasp)
        together = program("decide", path, "--normal-law", law, "--engine", engine)["cases"]
        answers = decide(grasp, list(grasp.cases.values()), normal_law=law, engine=engine)
        assert [answer["verdict"] for answer in together] == answers.verdict.tolist()
        return
    words = ("decide", path, "--normal-law", law, "--engine", engine)
    expected = program(*words)
    decision = decide(grasp, normal_law=law, engine=engine)
    assert decision.verdict == expected["verdict"]
    assert decision.engine == engine and decision.normal_law == law
    assert decision.wrench == numbers(expected["wrench"]) == grasp.wrench
    assert decision.stats == expected["stats"]
    if decision.verdict == "stable":
        contacts = expected["contacts"]
        assert decision.twist == numbers(expected["twist"])
        assert decision.forces == tuple(numbers(c["force"]) for c in contacts)
        assert decision.slip == "".join(c["slip"] for c in contacts)
        assert decision.closed == tuple(c["closed"] for c in contacts)
        assert balance(grasp, decision) == [0, 0, 0]


def test_same_certificate_as_the_program(fig1, tmp_path):
    path = tmp_path / "grasp.json"
    path.write_text(fig1.to_text())
    for load in ("0,1,0", "0,11/10,0"):
        program("decide", path, "--wrench", load, "--certificate", tmp_path / "c.json")
        assert (tmp_path / "c.json").read_text() == decide(fig1, load.split(",")).certificate
    program("margin", path, "--direction", "0,1,0", "--certificate", tmp_path / "m.json")
    assert (tmp_path / "m.json").read_text() == margin(fig1, UP).certificate


def test_forces_are_coefficients_of_the_normal():
    grasp = Grasp([[-1, 0]], [[1, 1]], 2, preload=1).snap().grasp
    decision = decide(grasp, (-1, -1, 1))
    assert decision.verdict == "stable"
    ((nx, ny),) = grasp.normals
    ((a, b),) = decision.coefficients
    assert decision.forces == ((a * nx - b * ny, a * ny + b * nx),)


def test_wrench_of_the_grasp_or_another(fig1):
    grasp = Grasp(fig1.positions, fig1.normals, fig1.friction, preload=1, wrench=(0, 2, 0))
    assert decide(grasp).verdict == "unstable"
    assert decide(grasp, UP).verdict == "stable"
    assert decide(grasp, np.array([0.0, 1.0, 0.0])).wrench == (0, 1, 0)
    assert decide(Grasp.from_text(fig1.to_text())).wrench == (0, 0, 0)


def test_floats_on_a_threshold_are_what_they_are(fig1):
    # Ten times the double 0.1 is above 1, the threshold; ten times the decimal is 1.
    friction = Fraction(1, 2)
    tenth = Grasp(fig1.positions, fig1.normals, friction, preload="0.1")
    assert decide(tenth, (0, "0.1", 0)).verdict == "stable"
    assert decide(tenth, (0, 0.1, 0)).verdict == "unstable"  # 0.1 as a double is above 1/10
    assert decide(tenth, (0, np.nextafter(0.1, 0), 0)).verdict == "stable"


def test_undecided(fig1):
    decision = decide(fig1, (0, "11/10", 0), engine="branch-and-bound", node_limit=1)
    assert (decision.verdict, decision.certificate) == ("undecided", None)
    assert "1 node" in decision.limit
    with pytest.raises(stickslip.LimitReached, match="1 node"):
        margin(fig1, UP, node_limit=1)


def test_warnings_are_those_of_the_program(tmp_path):
    turned = Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], "1/2", preload=[1, 2], wrench=(0, 0, 0))
    file = tmp_path / "grasp.json"
    # Stiffness that nobody gave: the file of the program has none either.
    file.write_text('{"format": "stickslip-grasp/1", "contacts": ['
                    '{"position": [-1, 0], "normal": [1, 0], "friction": "1/2", "preload": 1},'
                    '{"position": [1, 0], "normal": [-1, 0], "friction": "1/2", "preload": 2}],'
                    '"wrench": [0, 0, 0]}')
    expected = program("decide", str(file))["warnings"]
    assert [w["trap"] for w in expected] == ["unbalanced-preload"]
    found = decide(turned, warnings=True).warnings
    assert [(w.trap, w.text) for w in found] == [(w["trap"], w["text"]) for w in expected]
    assert decide(Grasp.from_file(file), warnings=True).warnings == found
    assert decide(turned).warnings == ()


# --- slip_states


@pytest.mark.parametrize("path", sorted(GOOD.iterdir()), ids=lambda path: path.stem)
@pytest.mark.parametrize("engine", ["auto", "cgal", "sweep", "paper"])
def test_same_states_as_the_program(path, engine):
    expected = program("states", path, "--list", "--engine", engine)
    found = slip_states(Grasp.from_file(path), engine=engine)
    assert found.states == tuple(expected.pop("states"))
    assert {key: getattr(found, key) for key in expected} == expected
    counts = slip_states(Grasp.from_file(path), engine=engine, list_states=False)
    assert counts.states is None
    assert (counts.cells, counts.distinct_states) == (found.cells, found.distinct_states)


# --- crosscheck


def test_right_claims_with_their_solution(fig1):
    found = decide(fig1, UP)
    answer = crosscheck(fig1, "stable", twist=found.twist, forces=found.forces, wrench=UP)
    assert (answer.outcome, answer.inaccurate) == ("right", False)
    assert answer.balance == (0, 0, 0)
    assert answer.cone == answer.normal_law == answer.dissipation == (0, None)
    assert answer.claimed_slip == found.slip
    assert answer.nearby.force_distance == answer.nearby.twist_distance == 0
    assert answer.decision == decide(fig1, UP)
    assert answer.distance is None  # not asked for
    asked = crosscheck(fig1, "stable", wrench=(0, "1/2", 0), distances=True)
    assert asked.distance_along_load == 1
    assert asked.nearby is None  # no solution was claimed


def test_ties_are_as_near_as_they_are_said_to_be(fig1):
    load = (0, 1 + Fraction(1, 10**12), 0)
    assert crosscheck(fig1, "stable", wrench=load).outcome == "tie"
    assert crosscheck(fig1, "stable", wrench=load, tie="1e-15").outcome == "wrong"


def test_crosscheck_errors(fig1):
    for place, call in (
        ("verdict", lambda: crosscheck(fig1, "perhaps", wrench=UP)),
        ("forces", lambda: crosscheck(fig1, "stable", wrench=UP, forces=[[0, 0]])),
        ("twist", lambda: crosscheck(fig1, "stable", wrench=UP, twist=[0, 0])),
        ("twist[2]", lambda: crosscheck(fig1, "stable", wrench=UP, twist=[0, 0, float("nan")])),
    ):
        with pytest.raises(InputError) as error:
            call()
        assert error.value.place == place


# --- margin


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("direction", [(1, 0, 0), (0, 0, "-1/3"), (2, 1, -1)])
def test_same_margin_as_the_program(law, direction):
    for path in sorted(PAPER.iterdir()):
        text = ",".join(map(str, direction))
        expected = program("margin", path, "--direction", text, "--normal-law", law, "--preload",
                           1)
        found = margin(Grasp.from_file(path), direction, preload=1, normal_law=law)
        assert [[str(low), None if high is None else str(high)]
                for low, high in found.resisted] == expected["resisted"]
        assert found.stats == expected["stats"]
        assert found.wrench == (0, 0, 0)  # whatever the file's


def test_margin_certificates_are_accepted(fig1):
    for direction, wrench in ((UP, None), (DOWN, None), (UP, DOWN), ((-1, 0, 1), UP)):
        found = margin(fig1, direction, **({} if wrench is None else {"wrench": wrench}))
        answer = check(fig1, found.certificate, direction=direction, wrench=wrench)
        assert answer and answer.verdict == "margin"
        assert answer.resisted == found.resisted
        assert answer.direction == direction
        other = check(fig1, found.certificate, direction=(0, 7, 0), wrench=wrench)
        assert not other and other.rule == "question-direction"
    assert check(fig1, margin(fig1, UP).certificate, wrench=(0, 0, 0)).rule == "question-direction"


def test_preloads_that_hold_a_load(fig1):
    held = margin(fig1, preload_direction="scale", wrench=UP)
    assert held.resisted == ((1, None),) and held.least == 1 and type(held.least) is Fraction
    assert held.direction is None and held.preload_direction == "scale"
    lifted = Grasp(fig1.positions, fig1.normals, "1/2", preload=1, wrench=UP)
    own = margin(lifted, preload_direction="scale")
    assert (own.wrench, own.resisted) == (UP, held.resisted)
    one_side = margin(fig1, preload=0, preload_direction=(1, 0, "1/2"), wrench=UP)
    assert one_side.resisted == ((Fraction(4, 3), None),) and one_side.least == Fraction(4, 3)
    both = margin(fig1, UP, preload=0, preload_direction=np.array([1.0, 0, 1.0]))
    assert both.resisted == ((0, None),) and both.preload_direction == (1, 0, 1)
    for found, asked in ((held, {"preload_direction": "scale", "wrench": UP}),
                         (one_side, {"preload": 0, "preload_direction": [1, 0, "1/2"],
                                     "wrench": UP}),
                         (both, {"direction": UP, "preload": 0, "preload_direction": [1, 0, 1]})):
        answer = check(fig1, found.certificate, **asked)
        assert answer and answer.verdict == "margin" and answer.resisted == found.resisted
        assert answer.preload_direction == found.preload_direction
        assert check(fig1, found.certificate, **{**asked, "preload_direction": [7, 0, 0]}).rule \
            == "question-preload-direction"


def test_margins_warn_as_verdicts_do(fig1):
    assert margin(fig1, UP).warnings == ()
    found = margin(fig1, UP, preload=0, preload_direction=[1, 0, 0], warnings=True).warnings
    assert [w.trap for w in found] == ["unbalanced-preload"]


# --- check


@pytest.mark.parametrize("wrench", [UP, (0, "11/10", 0)])
@pytest.mark.parametrize("law", LAWS)
def test_certificates(fig1, tmp_path, wrench, law):
    for engine in ("states", "branch-and-bound"):
        decision = decide(fig1, wrench, normal_law=law, engine=engine)
        result = check(fig1, decision.certificate, wrench=wrench, normal_law=law)
        assert result and result.verdict == decision.verdict and result.rule is None
        assert (result.contacts, result.wrench) == (3, decision.wrench)
        assert result.normal_law == law
        options = ("--wrench", ",".join(map(str, wrench)), "--normal-law", law)
        assert check_py(tmp_path, fig1, decision.certificate, *options)
        assert not check_py(tmp_path, fig1, decision.certificate)


def test_files_are_read_by_the_checker(fig1, tmp_path):
    grasp, proof = tmp_path / "g.json", tmp_path / "p.json"
    grasp.write_text(fig1.to_text())
    proof.write_text(decide(fig1, DOWN, preload=2).certificate)
    result = check(grasp, proof, wrench=DOWN, preload=2)
    assert result and result.preload == 2
    with pytest.raises(InputError) as error:
        check(grasp, grasp)
    assert error.value.file == str(grasp)


def test_preloads_along_irrational_normals():
    grasp = Grasp([[-1, -1], [1, -1], [0, 1]], [[1, 1], [-1, 1], [0, -1]], 1, preload=1,
                  wrench=(0, "1/10", 0))
    for ask in (decide, lambda g: margin(g, UP), lambda g: crosscheck(g, "stable")):
        with pytest.raises(InputError) as error:
            ask(grasp)
        assert error.value.place == "contacts[0].normal"
        assert error.value.remedy == "ask about grasp.snap().grasp"
    near, nearer = grasp.snap("1/1000").grasp, grasp.snap().grasp
    decision = decide(near)
    assert check(near, decision.certificate)
    assert check(nearer, decide(nearer).certificate)
    assert not check(grasp, decision.certificate)  # of the grasp before it is a proof about a box


def test_same_snapped_grasp_as_the_program(tmp_path):
    grasp = Grasp([[-1, -1], [1, -1], [0, 1]], [[1, 1], ["-1/3", 1], [0, -1]], 1, 2, preload=1)
    given, written = tmp_path / "grasp.json", tmp_path / "snapped.json"
    given.write_text(grasp.to_text())
    report = program("snap", given, "-o", written, "--within", "1/1000")
    snapped, moved = grasp.snap("1/1000")
    assert written.read_text() == snapped.to_text()
    assert [{"contact": s.contact, "normal": list(map(str, s.normal)),
             "moved_at_most": s.moved_at_most} for s in moved] == report["moved"]


# --- arguments and values


@pytest.mark.parametrize("place, ask", [
    ("engine", lambda g: decide(g, engine="guess")),
    ("engine", lambda g: slip_states(g, engine="states")),
    ("normal_law", lambda g: decide(g, normal_law="both")),
    ("normal_law", lambda g: check(g, "{}", normal_law=None)),
    ("node_limit", lambda g: decide(g, node_limit=-1)),
    ("threads", lambda g: slip_states(g, threads=1.5)),
    ("threads", lambda g: slip_states(g, threads=2**40)),
    ("preload", lambda g: decide(g, preload=-1)),
    ("preload", lambda g: check(g, "{}", preload=-1)),
    ("wrench", lambda g: decide(g, (1, 2))),
    ("wrench[1]", lambda g: decide(g, (1, float("nan"), 2))),
    ("direction", lambda g: margin(g, (0, 0, 0))),
    ("direction", lambda g: margin(g, [[0, 1, 0]])),
    ("direction", lambda g: margin(g)),
    ("preload_direction", lambda g: margin(g, preload_direction=[0, 0, 0])),
    ("preload_direction", lambda g: margin(g, preload_direction=[1, 1])),
    ("preload_direction", lambda g: margin(g, preload_direction=[1, 1, -1])),
    ("preload_direction", lambda g: margin(g, preload_direction="all")),
    ("preload_direction", lambda g: margin(g, preload_direction=1)),
    ("preload_direction", lambda g: margin(g, preload=0, preload_direction="scale")),
    ("preload_direction[1]", lambda g: margin(g, preload_direction=[1, "x", 1])),
    ("grasp", lambda g: decide("fig1.json")),
    ("grasp", lambda g: check(3, "{}")),
    ("certificate", lambda g: check(g, None)),
    ("certificate", lambda g: check(g, "proof.json")),
    ("certificate", lambda g: check(g, decide(g))),
    ("certificate", lambda g: check(g, Path(decide(g).certificate))),
    ("grasp", lambda g: check(g.to_text(), decide(g).certificate)),
    ("engine", lambda g: decide(g, engine=np.array(["branch-and-bound", "states"]))),
    ("preload[0]", lambda g: decide(g, preload=[[1, 2, 3]])),
    ("preload", lambda g: margin(g, UP, preload=np.ma.masked)),
    ("preload", lambda g: decide(g, preload=10**20000)),
    ("wrench", lambda g: decide(g, "0,1,0")),
    ("wrench[0]", lambda g: decide(g, np.ma.array([1, 2, 3], mask=[1, 0, 0]))),
    ("wrench[2]", lambda g: check(g, "{}", wrench=(0, 0, 10**20000))),
    ("direction[1]", lambda g: check(g, "{}", direction=(0, np.inf, 0))),
    ("direction[1]", lambda g: margin(g, (0, Fraction(1, 10**20000), 0))),
    ("within", lambda g: g.snap("a")),
    ("forces[1]", lambda g: crosscheck(g, "stable", forces=[[0, 0], [1], [0, 0]])),
    ("forces[2, 0]", lambda g: crosscheck(g, "stable", forces=np.ma.array(
        np.zeros((3, 2)), mask=[[0, 0], [0, 0], [1, 0]]))),
    ("tie", lambda g: crosscheck(g, "stable", tie=-1)),
    ("tolerance", lambda g: crosscheck(g, "stable", tolerance=np.nan)),
])
def test_arguments(fig1, place, ask):
    with pytest.raises(InputError) as error:
        ask(Grasp.from_text(fig1.to_text()))  # with a load, as of all files
    assert error.value.place == place
    assert error.value.problem and len(str(error.value)) < 400


def test_a_call_leaves_files_alone(fig1, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    grasp_path, proof_path = Path("g.json"), Path("p.json")
    grasp_path.write_text(fig1.to_text())
    proof_path.write_text(decide(fig1, UP).certificate)
    contents = {path: path.read_bytes() for path in tmp_path.iterdir()}
    opened_to_write = []
    watching = True

    def watch(event, details):
        if watching and event == "open" and details[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
            opened_to_write.append(details[0])

    sys.addaudithook(watch)
    grasp = Grasp.from_file(grasp_path)
    assert check(grasp_path, proof_path, wrench=UP)
    for answer in (decide(grasp, UP), margin(grasp, UP), slip_states(grasp),
                   crosscheck(grasp, "stable", wrench=UP)):
        assert str(answer)
    watching = False
    assert opened_to_write == []
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == contents


def test_answers_are_values(fig1):
    for ask in (lambda: decide(fig1, UP), lambda: slip_states(fig1), lambda: margin(fig1, UP),
                lambda: check(fig1, decide(fig1, UP).certificate, wrench=UP)):
        answer = ask()
        assert ask() == answer and hash(ask()) == hash(answer)
        assert pickle.loads(pickle.dumps(answer)) == answer
        with pytest.raises(AttributeError):
            answer.verdict = "stable"
    assert decide(fig1, UP) != decide(fig1, DOWN)


def test_other_threads_run_during_a_call():
    random = np.random.default_rng(2)
    m = 60
    grasp = Grasp(random.integers(-99, 100, (m, 2)), random.integers(1, 99, (m, 2)), "1/2")
    ticks = 0
    stop = threading.Event()

    def tick():
        nonlocal ticks
        while not stop.is_set():
            ticks += 1
            time.sleep(0)  # lets go of the lock

    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)  # no thread loses the lock, it can only let go of it
    ticker = threading.Thread(target=tick)
    try:
        ticker.start()
        for _ in range(1000):  # until the ticker happens to be scheduled within a call
            before = ticks
            slip_states(grasp)
            if ticks > before:
                break
        else:
            pytest.fail("no other thread ran during a thousand calls")
    finally:
        sys.setswitchinterval(interval)
        stop.set()
        ticker.join()
