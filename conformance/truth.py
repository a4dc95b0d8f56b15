# SPDX-License-Identifier: GPL-3.0-or-later
"""What must happen, asked of the program `stickslip`: all that this folder knows of it."""

from __future__ import annotations

import json
import os
import subprocess
from fractions import Fraction
from pathlib import Path
from typing import Dict, List, Tuple

from scene import Wrench, read

PROGRAM = os.environ.get("STICKSLIP", str(Path(__file__).resolve().parent.parent / "build/bin/stickslip"))


def asked(grasp: Dict[str, object], gyration: Fraction) -> Tuple[str, Dict[str, Dict[str, object]]]:
    """The class, and by method its evidence."""
    done = subprocess.run([PROGRAM, "compare", "-", "--json", "--inertia", f"0,0,{gyration ** 2}",
                           "--methods", "weakly-stable-load,strongly-stable-load"],
                          input=json.dumps(grasp), capture_output=True, text=True, check=True)
    answer = json.loads(done.stdout)
    return answer["class"], {m["method"]: m["evidence"] for m in answer["methods"]}


def load_class(grasp: Dict[str, object], gyration: Fraction) -> Tuple[str, List[object]]:
    """"must hold", "must move" or "open", and of "must move" the motion that nothing opposes."""
    kind, by_method = asked(grasp, gyration)
    return kind, by_method["weakly stable load"].get("motion", [])


def work(motion: List[object], wrench: Wrench) -> Fraction:
    return sum((read(c) * w for c, w in zip(motion, wrench)), Fraction(0))


def evidence(case: Dict[str, object]) -> str:
    """Why a case has its class, in words and exact numbers."""
    kind, by_method = asked(case["grasp"], read(case["gyration"]))
    assert kind == case["class"], case["grasp"]["name"]
    if kind == "must move":
        motion = by_method["weakly stable load"]["motion"]
        return (f"Proof: along the twist ({', '.join(map(str, motion))}) the load does work "
                f"{work(motion, tuple(map(read, case['grasp']['wrench'])))}, and no force in the friction cones "
                "does any against it.")
    strong = by_method["strongly stable load"]
    forces = "; ".join(f"({', '.join(map(str, f))})" for f in strong["forces"])
    return (f"Proof: the contact forces {forces} balance the load, and in none of {strong['cases']} regions of "
            "accelerations do the laws leave another answer.")
