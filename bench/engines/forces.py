# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges the contact forces that an engine itself reports: `stickslip crosscheck` says exactly by how
much they leave the cones, miss the load, or do not oppose the slip."""

from __future__ import annotations

import json
import math
import subprocess
from statistics import median
from typing import Dict, List, NamedTuple, Optional

from judge import MOVED, Judged
from truth import PROGRAM

LEAST = 1e-3  # of the largest force: what is less is no finding, as engines iterate


class Found(NamedTuple):
    """Shares of the largest force; of dissipation, of that times the largest velocity."""

    judged: Judged
    sample: Dict[str, object]
    cone: float
    balance: Optional[float]  # None of a body that moves: what is missing accelerates it
    dissipation: Optional[float]  # None of a body at rest


def at_rest(judged: Judged) -> bool:
    return judged.most <= MOVED


def chosen(judged: Judged) -> Dict[str, object]:
    """The end, or the first sample at which the body has moved."""
    return next((s for s, m in zip(judged.samples, judged.moved) if m > MOVED), judged.samples[-1])


def claim(judged: Judged, sample: Dict[str, object]) -> Optional[Dict[str, object]]:
    """That these forces hold the body, in the place where the engine has it."""
    x, y, _ = sample["pose"]
    touching = [c for c in sample["contacts"] if math.hypot(c[4], c[5]) > 0 and math.hypot(c[2], c[3]) > 0]
    if not touching or not all(math.isfinite(v) for c in touching for v in c):
        return None
    grasp = {"format": "stickslip-grasp/1", "name": judged.case["grasp"]["name"], "contacts": [
        {"position": [c[0] - x, c[1] - y], "normal": [c[2], c[3]], "friction": c[6]} for c in touching],
        "wrench": judged.case["grasp"]["wrench"]}
    said: Dict[str, object] = {"verdict": "stable", "force_vectors": [[c[4], c[5]] for c in touching]}
    if not at_rest(judged):
        said["twist"] = sample["velocity"]
    return {"grasp": grasp, "claim": said}


def largest(value: object) -> float:
    """Of what is stated exactly or by two decimals that enclose it."""
    values = value if isinstance(value, list) else [value]
    return max(abs(float(v)) for v in values)


def judge_forces(of: List[Judged]) -> List[Found]:
    asked = [(j, s, c) for j in of for s in [chosen(j)] for c in [claim(j, s)] if c]
    done = subprocess.run([PROGRAM, "crosscheck", "-", "--json", "--floats"], capture_output=True, text=True,
                          input="".join(json.dumps(c) + "\n" for _, _, c in asked))
    found = []
    for line in map(json.loads, done.stdout.splitlines()):
        if "residuals" not in line:
            continue
        judged, sample, said = asked[line["line"] - 1]
        r, scale = line["residuals"], line["residual_scale"]
        force, length = scale["force_float"], scale["length_float"]
        balance = dissipation = None
        if at_rest(judged):
            balance = max(largest(r["force_float"]) / force, abs(r["torque_float"]) / (force * length))
        else:
            vx, vy, spin = sample["velocity"]
            dissipation = largest(r["dissipation"]["value_float"]) / (force * max(abs(vx), abs(vy), abs(spin) * length))
        found.append(Found(judged, sample, largest(r["cone"]["value_float"]) / force, balance, dissipation))
    return found


def summary(found: List[Found]) -> Dict[str, Dict[str, float]]:
    """Of each condition how many forces break it by more than LEAST, of how many, the median and the most."""
    table = {}
    for name in ("cone", "balance", "dissipation"):
        values = [v for v in (getattr(f, name) for f in found) if v is not None]
        if values:
            table[name] = {"broken": sum(v > LEAST for v in values), "of": len(values),
                           "median": median(values), "most": max(values)}
    return table
