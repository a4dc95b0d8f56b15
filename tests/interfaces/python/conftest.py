# SPDX-License-Identifier: GPL-3.0-or-later
"""Shared by the tests of the Python module.

STICKSLIP names the program, and PYTHONPATH has the module.
"""

import json
import os
import signal
import subprocess
from pathlib import Path

import pytest
import stickslip

ROOT = Path(__file__).resolve().parents[3]
GOOD = ROOT / "tests" / "corpus" / "grasps" / "good"

# A shell starts with SIGINT ignored what is to run in the background, and so would all that tests start.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def fig1():
    """Fig. 1 of the paper, P = 1."""
    return stickslip.Grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]], "1/2",
                           preload=1, name="fig1")


def program(*words):
    """What the program prints with --json."""
    result = subprocess.run([os.environ["STICKSLIP"], *map(str, words), "--json"],
                            capture_output=True, text=True, check=False, timeout=300)
    assert result.stderr == ""
    return json.loads(result.stdout)
