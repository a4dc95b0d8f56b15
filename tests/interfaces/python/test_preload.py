# SPDX-License-Identifier: GPL-3.0-or-later
"""The best preloads as Python takes and gives them; that they are those of the command is in test_program.py."""

import pickle

import pytest
from conftest import ROOT
from stickslip import Grasp, InputError, best_preload

JAW = ROOT / "examples" / "grasps" / "jaw.json"


def test_an_answer():
    answer = best_preload(Grasp.from_file(JAW))
    assert answer.preloads == (8, 8) and answer.sum == 16
    assert answer == pickle.loads(pickle.dumps(answer))
    assert "BestPreload(preloads=" in repr(answer)


def test_several_loads():
    jaw = Grasp.from_file(JAW)
    assert best_preload(jaw, [(0, -8, 0), (0, 9, 0)]).sum == 18
    assert best_preload(jaw, (0, -5, 0), friction=1).sum == 5
    assert best_preload(jaw, (0, 0, 0)).sum == 0


@pytest.mark.parametrize("arguments, place", [
    ({"budget": 0}, "budget"),
    ({"accuracy": 1}, "accuracy"),
    ({"wrench": [(0, 1, 0)] * 2, "budget": 1}, "wrench"),
    ({"wrench": (0, 1)}, "wrench"),
    ({"uncertain": "friction=10%"}, ""),
    ({"budget": 1, "about": (1, 2, 3)}, "uncertain"),
])
def test_errors(arguments, place):
    with pytest.raises(InputError) as error:
        best_preload(Grasp.from_file(JAW), **arguments)
    assert error.value.place == place
