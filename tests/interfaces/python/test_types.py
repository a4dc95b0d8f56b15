# SPDX-License-Identifier: GPL-3.0-or-later
"""The annotations are complete and right, as mypy sees them."""

import importlib.util
import subprocess
import sys

import pytest
from conftest import ROOT

USER = '''
from fractions import Fraction
from typing import Any, Sequence, Tuple, Union

import numpy as np
import stickslip
from stickslip import Decision, Decisions, Grasp, Picture

grasp = Grasp([[-1, 0], [1, 0]], np.array([[1, 0], [-1, 0]]), "1/2", preload=Fraction(1, 2))
one: Decision = stickslip.decide(grasp, (0, 1, 0), friction=0.5, preload="1/3")
many: Union[Decision, Decisions] = stickslip.decide(grasp, np.zeros((5, 3)))
assert isinstance(many, Decisions)
rows: Sequence[Decision] = many
picture: Picture = rows[0].plot()
text: str = stickslip.export(grasp)
held: bool = bool(one.check()) and bool(many.stable.all())
corners = stickslip.region(grasp).areas[0][0].vertices
x: Fraction = corners[0][0]
placed, moved = Grasp.from_outline([[0, 0], [1, 0], [0, 1]], [["1/2", 0]], 1, tolerance=0)
distance: float = moved[0]
box: stickslip.BoxDecision = stickslip.decide(grasp, (0, 1, 0), uncertain={"friction": "10%"})
cells: Tuple[stickslip.MapCell, ...] = stickslip.stability_map(
    grasp, "load=0:1", "friction=0:1", (0, 1, 0), depth=1).cells
pinch = Grasp(np.zeros((1, 3)), [[0, 0, 1]], 1)
in_space: Decision = stickslip.decide(pinch, (0, 0, -1, 0, 0, 0))
load: Tuple[Fraction, ...] = stickslip.wrench_of([{"weight": 1.5, "at": (0, "1/2")}])
loaded: Decision = stickslip.decide(grasp, load)
pushes: np.ndarray[Any, np.dtype[np.float64]] = many.forces_float + many.twist_float[0, 0]
corner: float = float(grasp.positions_float[0, 0])
box.plot().save("box.svg")
normal: Tuple[Fraction, ...] = pinch.snap().grasp.normals[0]
held_box: Grasp = Grasp.from_contacts([[0, 0, 0]], None, 1, into="other", frames=np.eye(3)[None], forces=[1])
settled: Grasp = Grasp.from_mujoco(object(), object(), "box", fixed=("left",), gravity=True, grid=0.001)
pushed: Grasp = Grasp.from_drake([], 3, lambda pair: 0.5, stiffness=1)
on: stickslip.MeshGrasp = Grasp.from_mesh((np.zeros((4, 3)), [[0, 1, 2]]), [[0, 0, 0]], 1, tolerance="1e-3")
face: int = on.faces[0]
blocks: stickslip.Assembly = stickslip.Assembly.from_file("blocks.json")
names: Tuple[str, ...] = blocks.coordinates
leaning: Decision = stickslip.decide(blocks, (0, 0, 0, 0.5, -10, 0))
pull: Union[Tuple[Fraction, ...], None] = leaning.springs
either: Grasp = stickslip.Assembly({"bodies": [{"name": "a"}], "contacts": []})
factor: Fraction = stickslip.radius(grasp, (0, 1, 0), uncertain="friction=10%").proved
'''


@pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="mypy is not installed")
def test_types(tmp_path):
    (tmp_path / "user.py").write_text(USER)

    def mypy(*what):
        return subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", *what],
            capture_output=True, text=True, check=False, timeout=600, cwd=ROOT / "interfaces" / "python")

    good = mypy("stickslip", tmp_path / "user.py")
    assert good.returncode == 0, good.stdout + good.stderr
    (tmp_path / "wrong.py").write_text(USER.replace("x: Fraction", "x: str"))
    assert "wrong.py:18: error" in mypy(tmp_path / "wrong.py").stdout
