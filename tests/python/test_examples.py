# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run, and the documentation's own lines are true."""

import doctest
import re
import subprocess
import sys

import pytest
import stickslip
from conftest import ROOT


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
    result = doctest.testmod(module, extraglobs={"Grasp": stickslip.Grasp})
    assert result.attempted > 0 and result.failed == 0


@pytest.mark.parametrize("name, examples", [("docs/python.md", 20), ("README.md", 2)])
def test_documentation(name, examples):
    result = doctest.testfile(str(ROOT / name), module_relative=False,
                              globs={"stickslip": stickslip})
    assert result.attempted >= examples and result.failed == 0
