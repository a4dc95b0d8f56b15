# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples run, and the documentation's own lines are true."""

import doctest
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
    rows = {line[:28].strip(): [int(n) for n in line[28:].split()]
            for line in output.splitlines() if line[28:].split()[:1] and
            line[28:].split()[0].isdigit()}
    assert set(rows) == {"random", "exactly on a threshold", "1e-12 below a threshold",
                         "1e-12 above a threshold"}
    for grasps, right, wrong, tie in rows.values():
        assert grasps == right + wrong + tie == 40
    # Away from thresholds the tolerance is harmless, and at them it decides.
    assert rows["random"][1] == 40
    assert rows["1e-12 above a threshold"][2] > 0
    assert rows["exactly on a threshold"][3] == 40


@pytest.mark.parametrize("module", [stickslip, stickslip.grasp])
def test_docstrings(module):
    result = doctest.testmod(module, extraglobs={"Grasp": stickslip.Grasp})
    assert result.attempted > 0 and result.failed == 0


def test_documentation():
    result = doctest.testfile(str(ROOT / "docs" / "python.md"), module_relative=False)
    assert result.attempted > 10 and result.failed == 0
