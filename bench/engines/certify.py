#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a proof of the class of each case: FAMILY.jsonl, a line a case. Without folders, of the plane, beside the cases.

    certify.py [CASES PROOFS]
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from engines import HERE
from truth import PROGRAM, inertia_of


def certificate(case) -> str:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "certificate.json"
        subprocess.run([PROGRAM, "compare", "-", "--inertia", inertia_of(case),
                        "--methods", "weakly-stable-load", "--certificate", str(path)],
                       input=json.dumps(case["grasp"]), capture_output=True, text=True, check=True)
        return json.dumps(json.loads(path.read_text(encoding="utf-8")), separators=(",", ":"))


def main(cases_in: Path = HERE / "cases", proofs_in: Path = HERE / "certificates") -> None:
    proofs_in.mkdir(parents=True, exist_ok=True)
    for path in sorted(cases_in.glob("*.jsonl")):
        with open(path, encoding="utf-8") as cases, open(proofs_in / path.name, "w", encoding="utf-8") as out:
            for case in map(json.loads, cases):
                out.write(certificate(case) + "\n")


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
