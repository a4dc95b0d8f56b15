# SPDX-License-Identifier: GPL-3.0-or-later
"""States in space as arrays: those of the command, lazily."""

import threading

import numpy as np
import pytest

import stickslip
from conftest import program
from stickslip import NO_SIGN, Grasp, InputError, find_states

CUBE = Grasp([[-1, -1, 0], [-1, 1, 0], [1, -1, 0], [1, 1, 0]], [[0, 0, 1]] * 4, "1/2", name="cube")


def listed(grasp, tmp_path, *options):
    file = tmp_path / "g.json"
    file.write_text(grasp.to_text(), encoding="utf-8")
    return program("states", file, "--list", *options)


@pytest.mark.parametrize("modes", ["slip", "full", "closed", "cs", "ss"])
def test_the_states_are_those_of_the_command(modes, tmp_path):
    answer = listed(CUBE, tmp_path, "--modes", modes)
    states = find_states(CUBE, modes=modes, chunk=7)
    assert states.coordinates == 6
    assert [(row["contact"], row["line"]) for row in answer["rows"]] == list(states.planes)
    assert [[int(x) for x in row["row"]] for row in answer["rows"]] == [list(row) for row in states.rows]
    counts = states.count()
    assert list(counts.by_dimension) == answer["by_dimension"]
    chunks = list(states)
    assert [len(chunk) for chunk in chunks[:-1]] == [7] * (len(chunks) - 1)
    signs = np.concatenate([chunk.signs for chunk in chunks])
    motions = np.concatenate([chunk.motions for chunk in chunks])
    assert len(signs) == answer["distinct_states"] == counts.distinct_states
    assert [list(map(str, motion)) for motion in motions] == [state["motion"] for state in answer["states"]]
    assert np.concatenate([chunk.dimensions for chunk in chunks]).tolist() == [s["dimension"] for s in answer["states"]]
    for name, sign in (("zero", 0), ("positive", 1), ("negative", -1)):
        assert [np.flatnonzero(row == sign).tolist() for row in signs] == [state[name] for state in answer["states"]]
    # A sign is that of a . motion, and there is none only for slips of contacts that open.
    values = motions @ np.array(states.rows, dtype=np.int64).T
    assert ((np.sign(values) == signs) | (signs == NO_SIGN)).all()
    assert (signs == NO_SIGN).any() == (modes == "ss")


@pytest.mark.parametrize("modes", ["slip", "full", "closed"])
def test_the_certificate_is_that_of_the_command(modes, tmp_path):
    listed(CUBE, tmp_path, "--modes", modes, "--certificate", tmp_path / "command.json")
    find_states(CUBE, modes=modes).write_certificate(tmp_path / "python.json", threads=2)
    assert (tmp_path / "python.json").read_text() == (tmp_path / "command.json").read_text()
    result = stickslip.check(CUBE, tmp_path / "python.json", states=modes)
    assert result and result.by_dimension == find_states(CUBE, modes=modes).count().by_dimension
    other = stickslip.check(CUBE, tmp_path / "python.json", states="slip" if modes == "full" else "full")
    assert (other.accepted, other.rule) == (False, "question-states")


def test_modes_have_no_certificate_of_their_own(tmp_path):
    for options in ({"modes": "cs"}, {"dimension": 3}):
        with pytest.raises(InputError, match="full|all dimensions"):
            find_states(CUBE, **options).write_certificate(tmp_path / "none.json")
    assert not (tmp_path / "none.json").exists()


def test_an_equilibrium_in_space_has_a_state():
    found = stickslip.decide(CUBE, (0, 0, -4, 0, 0, 0))
    assert found.slip == "00 00 00 00"


def test_options():
    assert find_states(CUBE, modes="ss", at_least_closed=4).count().distinct_states == 51
    assert find_states(CUBE, modes="cs", dimension=5).count().by_dimension == (0, 0, 0, 0, 0, 4, 0)
    ball = Grasp([[0, 0, 0]], [[1, 1, 1]], "1/2")
    assert find_states(ball, lines=3, snap=True).count().distinct_states == 13
    assert find_states(ball, directions=[np.array([[1, -1, 0]])]).count().distinct_states == 3
    with pytest.raises(InputError, match="irrational"):
        find_states(ball, lines=3)
    with pytest.raises(InputError, match="not across the normal"):
        find_states(ball, directions=[[[1, 0, 0]]])
    with pytest.raises(InputError, match="modes"):
        find_states(ball, modes="sc")
    with pytest.raises(InputError, match="cs or ss"):
        find_states(ball, at_least_closed=1)
    with pytest.raises(InputError, match="grasp"):
        find_states(None)
    tilted = Grasp(CUBE.positions, [["1e-6", 0, 1]] + [[0, 0, 1]] * 3, "1/2")
    assert "nearly coincide" in find_states(tilted, modes="cs").count().warnings[0]


def test_a_walk_that_is_left_ends_its_thread():
    rng = np.random.default_rng(1)
    many = Grasp(rng.integers(-99, 99, (14, 3)), rng.integers(1, 99, (14, 3)), "1/2")
    before = threading.active_count()
    for chunk in find_states(many, chunk=100):
        assert len(chunk) == 100
        break
    assert threading.active_count() == before


def test_long_motions_are_ints():
    large = 10**15
    rng = np.random.default_rng(2)
    grasp = Grasp(rng.integers(-9, 9, (3, 3)).astype(object) * large + 1, rng.integers(1, 99, (3, 3)), "1/2")
    states = find_states(grasp)
    rows = np.array([[int(x) for x in row] for row in states.rows], dtype=object)
    for chunk in states:
        assert chunk.motions.dtype == object
        assert (np.sign((chunk.motions @ rows.T)) == chunk.signs).all()


def test_in_the_plane():
    grasp = Grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]], "1/2")
    found = {"".join("0+-"[sign] for sign in row) for chunk in find_states(grasp) for row in chunk.signs}
    assert found == set(stickslip.slip_states(grasp).states)
