# SPDX-License-Identifier: GPL-3.0-or-later
"""The best preloads: what the program says, and proofs that the checkers accept."""

import pickle
import subprocess
import sys
from fractions import Fraction

import pytest
import stickslip
from conftest import CHECK_PY, ROOT, program
from stickslip import Grasp, InputError, best_preload

JAW = ROOT / "examples" / "grasps" / "jaw.json"


def judged(tmp_path, proof, *words):
    (tmp_path / "g.json").write_text(proof.grasp)
    (tmp_path / "c.json").write_text(proof.certificate)
    result = subprocess.run(
        [sys.executable, "-B", CHECK_PY, tmp_path / "g.json", tmp_path / "c.json", *words],
        capture_output=True, text=True, check=False, timeout=300)
    assert result.returncode == 0, result.stdout + result.stderr
    return result.stdout


def test_least_sum(tmp_path):
    jaw = Grasp.from_file(JAW)
    answer = best_preload(jaw)
    found = program("preload", JAW, "--hold")
    assert answer.preloads == (8, 8) and answer.sum == 16 == Fraction(found["sum"])
    assert answer.bound == Fraction(found["bound"])
    assert answer.multiples == ((1, None),) and not answer.each_for_itself and not answer.warnings
    assert "verdict     stable" in judged(tmp_path, answer.proofs["held0"])
    assert "resisted    [1, oo)" in judged(tmp_path, answer.proofs["range0"], "--preload-direction", "8,8")
    boxes = [proof for name, proof in answer.proofs.items() if name.startswith("bound")]
    assert len(boxes) == found["boxes"]
    assert all(proof.check().verdict == "unstable" for proof in boxes)
    assert answer == pickle.loads(pickle.dumps(answer))
    assert "BestPreload(preloads=" in repr(answer)


def test_several_loads():
    jaw = Grasp.from_file(JAW)
    assert best_preload(jaw, [(0, -8, 0), (0, 9, 0)]).sum == 18
    assert best_preload(jaw, (0, -5, 0), friction=1).sum == 5
    assert best_preload(jaw, (0, 0, 0)).sum == 0


def test_balanced():
    gripped = Grasp([[-5, 0], [3, -4], [3, 4]], [[1, 0], ["-3/5", "4/5"], ["-3/5", "-4/5"]], "2/5", stiffness=50)
    one = best_preload(gripped, (3, 0, 60), accuracy="1/5")
    assert [warning.trap for warning in one.warnings] == ["unbalanced-preload"]
    all_three = best_preload(gripped, (3, 0, 60), accuracy="1/5", balanced=True)
    assert all_three.warnings == () and min(all_three.preloads) > 0 and all_three.sum > one.bound


def test_balls(tmp_path):
    jaw = Grasp.from_file(JAW)
    answer = best_preload(jaw, (0, -2, 0), uncertain="wrench=ball:1/2:length=1/4", accuracy="1/5")
    assert answer.each_for_itself and answer.bound < answer.sum < 6
    assert "verdict     stable" in judged(
        tmp_path, answer.proofs["held0"], "--uncertain", "wrench=ball:1/2:length=1/4")
    assert answer.proofs["held0"].check().verdict == answer.proofs["range0"].check().verdict == "stable"
    answer = best_preload(jaw, budget=20, length=2, accuracy="1/5", boxes=50)
    found = program("preload", JAW, "--budget", "20", "--length", "2", "--accuracy", "20%", "--boxes", "50")
    assert (answer.radius, answer.refuted) == (Fraction(found["proved"]), Fraction(found["not_resisted_at"]))
    assert answer.preloads == tuple(map(Fraction, found["preloads"]))
    assert "unstable" in judged(tmp_path, answer.proofs["refuted"])


def test_nothing_holds():
    feet = Grasp([[-1, 0], [1, 0]], [[0, 1], [0, 1]], "1/2")
    answer = best_preload(feet, (0, 1, 0))
    assert answer.preloads is None and answer.sum is None and answer.bound > 0
    answer = best_preload(feet, (0, 1, 0), budget=3)
    assert answer.radius is None and answer.bound == 0


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


def test_in_space_and_of_bodies():
    pinch = Grasp([[-2, 0, 0], [2, 0, 0]], [[1, 0, 0], [-1, 0, 0]], "1/2", stiffness=10)
    answer = best_preload(pinch, (0, 0, -2, 0, 0, 0), accuracy="1/4")
    assert 4 <= answer.sum < 5 and answer.bound > 2
    block = stickslip.Assembly({
        "format": "stickslip-grasp/3", "bodies": [{"name": "block"}], "contacts": [
            {"of": "block", "position": [x, 0], "normal": [-x, 0], "friction": "1/2", "stiffness": 100} for x in (-1, 1)]})
    assert 16 <= best_preload(block, (0, -8, 0), accuracy="1/4").sum < 20
