#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a proof of the class of each case, and has stickslip-check judge it: FOLDER/FAMILY.jsonl, a line a case in the order
of the cases, and those of space in FOLDER/space. A file is written when all of its proofs are made. Exit code 1 if a proof
is not accepted."""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Dict, List, Tuple

from engines import HERE
from truth import PROGRAM, inertia_of

CHECKER = str(Path(PROGRAM).with_name("stickslip-check"))


def certificate(case: Dict[str, object]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "certificate.json"
        done = subprocess.run([PROGRAM, "compare", "-", "--inertia", inertia_of(case),
                               "--methods", "weakly-stable-load", "--certificate", str(path)],
                              input=json.dumps(case["grasp"]), capture_output=True, text=True)
        if done.returncode:
            raise SystemExit(f"{case['grasp']['name']}: {done.stderr}")
        return json.dumps(json.loads(path.read_text(encoding="utf-8")), separators=(",", ":"))


def judgement(checker: List[str], case: Dict[str, object], proof: str) -> str:
    """The first two lines of what a checker says."""
    with tempfile.TemporaryDirectory() as folder:
        grasp, path = Path(folder) / "grasp.json", Path(folder) / "certificate.json"
        grasp.write_text(json.dumps(case["grasp"]), encoding="utf-8")
        path.write_text(proof, encoding="utf-8")
        done = subprocess.run([*checker, str(grasp), str(path), "--inertia", inertia_of(case)], capture_output=True, text=True)
        return "\n".join((done.stdout + done.stderr).splitlines()[:2])


def accepted(case: Dict[str, object]) -> str:
    """What a checker says of a proof of the class that the case states."""
    return f"accepted\nverdict     {case['class']}"


def certify(families: List[Path], proofs_in: Path, every: int = 1) -> Tuple[int, int]:
    """How many proofs were made and accepted, of one in `every` cases of each family."""
    chosen = {path: [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()[::every]] for path in families}
    of_all, made, good = sum(map(len, chosen.values())), 0, 0

    def judged(case: Dict[str, object]) -> Tuple[str, str]:
        proof = certificate(case)
        return proof, judgement([CHECKER], case, proof)

    # The programs that are asked run beside; threads wait for them.
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, cases in chosen.items():
            proofs = []
            for case, (proof, said) in zip(cases, pool.map(judged, cases)):
                proofs.append(proof + "\n")
                made += 1
                good += said == accepted(case)
                if said != accepted(case):
                    print(f"{case['grasp']['name']}, which {case['class']}: {said}", file=sys.stderr)
                if sys.stderr.isatty():
                    print(f"\r{made} of {of_all} proofs", end="\n" if made == of_all else "", file=sys.stderr, flush=True)
            whole = proofs_in / ("space" if path.parent.name == "space" else "") / path.name
            whole.parent.mkdir(parents=True, exist_ok=True)
            part = whole.with_suffix(".part")
            part.write_text("".join(proofs), encoding="utf-8")
            os.replace(part, whole)
    return made, good


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="of one in N cases of each family alone")
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    asked = parser.parse_args()
    if asked.every < 1:
        parser.error("--every takes a number from 1")
    for program in (PROGRAM, CHECKER):
        if not shutil.which(program):
            parser.error(f"{program} is not built: scripts/demo.sh builds it; or STICKSLIP names stickslip, by its checker")
    made, good = certify(sorted(HERE.glob("cases/*.jsonl")) + sorted(HERE.glob("cases/space/*.jsonl")), asked.folder, asked.every)
    print(f"{made} proofs made, {good} accepted")
    return made != good


if __name__ == "__main__":
    sys.exit(main())
