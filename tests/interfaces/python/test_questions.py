# SPDX-License-Identifier: GPL-3.0-or-later
"""What is asked and answered as Python has it; that answers are those of the program is in test_program.py."""

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
from stickslip import Grasp, InputError, check, crosscheck, decide, margin, plot_grasp, quality, region, slip_states

UP, DOWN = (0, 1, 0), (0, -1, 0)


# --- decide


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


# --- check


def test_proofs_of_margins_are_about_what_was_asked(fig1):
    held = margin(fig1, preload_direction="scale", wrench=UP)
    assert held.resisted == ((1, None),) and held.least == 1 and type(held.least) is Fraction
    both = margin(fig1, UP, preload=0, preload_direction=np.array([1.0, 0, 1.0]))
    assert (both.direction, both.preload_direction) == (UP, (1, 0, 1)) and both.warnings == ()
    for found, asked in ((held, {"preload_direction": "scale", "wrench": UP}), (margin(fig1, DOWN), {"direction": DOWN}),
                         (both, {"direction": UP, "preload": 0, "preload_direction": [1, 0, 1]})):
        answer = check(fig1, found.certificate, **asked)
        assert answer and answer.verdict == "margin" and answer.resisted == found.resisted
        assert (answer.direction, answer.preload_direction) == (found.direction, found.preload_direction)
        for name, other in (("direction", (0, 7, 0)), ("preload_direction", [7, 0, 0])):
            if name in asked:
                assert check(fig1, found.certificate, **{**asked, name: other}).rule == f"question-{name.replace('_', '-')}"


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
    with pytest.raises(InputError) as error:
        region(grasp)
    assert error.value.place == "contacts[0].normal"
    assert error.value.remedy == "ask about grasp.snap().grasp"
    decided = decide(grasp)
    assert (decided.verdict, decided.engine, decided.twist) == ("stable", "intervals", None)
    assert check(grasp, decided.certificate)
    assert [crosscheck(grasp, claimed).outcome for claimed in ("stable", "unstable")] == ["right", "wrong"]
    assert decide(grasp, [(0, "1/10", 0), (0, 0, 100)]).verdict.tolist() == ["stable", "unstable"]
    assert quality(grasp).proved > 0 and "sticks" in plot_grasp(grasp)
    near, nearer = grasp.snap("1/1000").grasp, grasp.snap().grasp
    decision = decide(near)
    assert check(near, decision.certificate)
    assert check(nearer, decide(nearer).certificate)
    assert not check(grasp, decision.certificate)  # of the grasp before it is a proof about a box


def test_margins_of_irrational_lengths():
    # Along a diagonal they press with 1 each, and hold 2 across it.
    jaws, across = Grasp([[-1, -1], [1, 1]], [[1, 1], [-1, -1]], 1, preload=1), (1, -1, 0)
    found, exact = margin(jaws, across), margin(jaws.snap().grasp, across)
    [(low, high)], [(above, end)] = found.resisted, found.refuted
    assert (low, end) == (0, None) and high ** 2 < 2 < above ** 2 < Fraction(102, 100) * high ** 2
    assert exact.refuted is None and high < exact.resisted[0][1] < above
    assert found.check() and check(jaws, found.certificate, direction=across).resisted == found.resisted
    with pytest.raises(InputError):
        check(jaws.snap().grasp, found.certificate, direction=across)  # where a proof has exact ends
    with pytest.raises(InputError, match="accuracy"):
        margin(jaws, across, accuracy=0)


def test_margins_within_a_bound():
    # One contact presses 1 for each unit that it gives.
    foot = Grasp([[0, 0]], [[0, 1]], 1)
    bounded = margin(foot, DOWN, max_motion=(3, 1), warnings=True)
    [(low, high)], [(above, end)] = bounded.resisted, bounded.refuted
    assert (low, end) == (0, None) and 2.99 < high <= 3 <= above < 3.01
    assert bounded.max_motion == (3, 3, 1) and bounded.within is None and bounded.check()
    with pytest.raises(InputError):
        check(foot, bounded.certificate, direction=DOWN)  # where a proof has exact ends
    assert margin(foot, DOWN, max_motion="none").resisted == ((0, None),)


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
