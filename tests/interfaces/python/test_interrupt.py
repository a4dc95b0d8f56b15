# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C breaks off what would go on for hours, and the module works on."""

import signal
import subprocess
import sys

import pytest

PROGRAM = """
import sys, threading
import numpy as np
import stickslip

random = np.random.default_rng(4)
def crowd(m):
    points = random.integers(-10**6, 10**6, (m, 2))
    return stickslip.Grasp(points, -random.integers(-10**6, 10**6, (m, 2)), "1/3")

calls = {
    "decide by states": lambda: stickslip.decide(crowd(200), (1, 2, 3), engine="states"),
    "many": lambda: stickslip.decide([crowd(200)], np.ones((10**4, 3)), engine="states"),
    "margin": lambda: [stickslip.margin(crowd(400), (0, 1, 0)) for _ in range(10**6)],
    "region": lambda: [stickslip.region(crowd(200), pieces=True) for _ in range(10**6)],
    "states by cgal": lambda: stickslip.slip_states(crowd(2000), engine="cgal"),
    "states by sweep": lambda: stickslip.slip_states(crowd(60000), list_states=False),
}
call = calls[sys.argv[1]]
print("ready", flush=True)
try:
    call()
    print("it ended")
except KeyboardInterrupt:
    print("interrupted", stickslip.decide(crowd(3), (0, 1, 0)).verdict in ("stable", "unstable"))
"""


@pytest.mark.parametrize("call", ["decide by states", "many", "margin", "region",
                                  "states by cgal", "states by sweep"])
def test_interrupt(call):
    with subprocess.Popen([sys.executable, "-c", PROGRAM, call], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline() == "ready\n"
            with pytest.raises(subprocess.TimeoutExpired):
                process.wait(timeout=1.5)  # it is at work
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=120)
        finally:
            process.kill()
    assert (out, err, process.returncode) == ("interrupted True\n", "", 0)
