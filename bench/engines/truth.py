# SPDX-License-Identifier: GPL-3.0-or-later
"""What must happen, asked of the program `stickslip`: all that this folder knows of it."""

from __future__ import annotations

import json
import os
import subprocess
from fractions import Fraction
from functools import lru_cache
from pathlib import Path
from typing import Dict, List, Sequence, Tuple

import scene
import solid
from scene import read

PROGRAM = os.environ.get("STICKSLIP", str(Path(__file__).resolve().parents[2] / "build/bin/stickslip"))


def asked(grasp: Dict[str, object], inertia: str) -> Tuple[str, Dict[str, Dict[str, object]]]:
    """The class, and by method its evidence."""
    done = subprocess.run([PROGRAM, "compare", "-", "--json", "--inertia", inertia,
                           "--methods", "weakly-stable-load,strongly-stable-load"],
                          input=json.dumps(grasp), capture_output=True, text=True, check=True)
    answer = json.loads(done.stdout)
    return answer["class"], {m["method"]: m["evidence"] for m in answer["methods"]}


def inertia_of(case: Dict[str, object]) -> str:
    where = solid if "vertices" in case else scene
    return where.inertia(where.scene_of(case)[0])


def load_class(grasp: Dict[str, object], inertia: str) -> Tuple[str, List[object]]:
    """"must hold", "must move" or "open", and of "must move" the motion that nothing opposes."""
    kind, by_method = asked(grasp, inertia)
    return kind, by_method["weakly stable load"].get("motion", [])


def work(motion: List[object], wrench: Sequence[Fraction]) -> Fraction:
    return sum((read(c) * w for c, w in zip(motion, wrench)), Fraction(0))


@lru_cache(maxsize=None)
def evidence_of(text: str) -> str:
    """As evidence(), of the case as JSON."""
    return evidence(json.loads(text))


def evidence(case: Dict[str, object]) -> str:
    """Why a case has its class, in words and exact numbers."""
    kind, by_method = asked(case["grasp"], inertia_of(case))
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
