# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run, and the documentation's own lines are true."""

import doctest
import re
import subprocess
import sys

import pytest
import stickslip
from conftest import ROOT
from scenes import ContactResults, drake_pair, mujoco_scene


def test_crosscheck_numpy():
    example = ROOT / "examples" / "crosscheck_numpy.py"
    outputs = set()
    for _ in range(2):
        result = subprocess.run([sys.executable, example, "40"], capture_output=True, text=True,
                                check=False, timeout=600)
        assert (result.returncode, result.stderr) == (0, "")
        outputs.add(result.stdout)
    (output,) = outputs
    rows = {}
    for line in output.splitlines()[3:]:
        family, *numbers = re.fullmatch(r"(.*?)" + r"\s+(\d+)" * 4, line).groups()
        rows[family] = tuple(map(int, numbers))
    assert rows == {
        "random": (40, 40, 0, 0),
        "1e-6 above a threshold": (40, 40, 0, 0),
        "1e-12 above a threshold": (40, 0, 40, 0),  # within the tolerance of the NumPy solver
        "exactly on a threshold": (40, 0, 0, 40),
        "1e-12 below a threshold": (40, 40, 0, 0),
    }


@pytest.mark.parametrize("module", [stickslip, stickslip.grasp, stickslip.loads])
def test_docstrings(module):
    result = doctest.testmod(module, extraglobs={"Grasp": stickslip.Grasp, "Assembly": stickslip.Assembly})
    assert result.attempted > 0 and result.failed == 0


def scenes():
    """What docs/contacts.md has run before, under its names."""
    model, data = mujoco_scene("gripper")
    floor_model, floor_data = mujoco_scene("resting")
    points = [(0, 1, 2, -1, -1, (side * 0.03, 0.0, 0.0), (side * 0.031, 0.0, 0.0), (-side, 0.0, 0.0), -0.001, 4.0)
              for side in (-1.0, 1.0)]
    results, ball, ball_geometry = ContactResults(drake_pair()), 3, 30
    return locals()


@pytest.mark.parametrize("name, examples", [("docs/python.md", 20), ("docs/contacts.md", 15), ("docs/bodies.md", 8), ("README.md", 2)])
def test_documentation(name, examples, monkeypatch):
    monkeypatch.chdir(ROOT)
    ran_before = scenes() if name == "docs/contacts.md" else {}
    result = doctest.testfile(str(ROOT / name), module_relative=False,
                              globs={"stickslip": stickslip, **ran_before})
    assert result.attempted >= examples and result.failed == 0
