# SPDX-License-Identifier: GPL-3.0-or-later
"""What stickslip-proved takes over stickslip-check, by kind of certificate: seconds of the processor for the same
question asked many times in one process (--batch), of files of grasps in the plane and in space.

    build/bin/verdict_bench --part targets --max-m 100 --save FOLDER
    python3 bench/space/grasps.py FOLDER --on sphere --contacts 8 --grasps 4 --at 1/4 1/2 1 2
    python3 bench/verdict/kinds.py --programs build/bin [--save QUESTIONS] FOLDER...
    python3 bench/verdict/kinds.py --programs build/bin QUESTIONS

The second form asks what --save kept, without deciding anew. Exit code 1 if a certificate is not accepted.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
from collections import defaultdict
from statistics import median

FRICTION = ["--uncertain", "friction=5%"]
SOME = ["--uncertain", "friction=5%,position=0.001,preload=2%"]


def timed(words, text):
    """Seconds of the processor, and what was printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, input=text, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime, done.stdout


def questions_about(path):
    """The kinds of proofs, and the words that ask for them and that check them."""
    with open(path, encoding="utf-8") as file:
        grasp = json.load(file)
    contacts, size = len(grasp["contacts"]), len(grasp["wrench"])
    law = ["--normal-law", "bilateral"] if "bilateral" in path else []
    yield "verdict", ["decide", *law], law
    if law or contacts > 10:
        return
    yield "verdict", ["decide", "--normal-law", "bilateral"], ["--normal-law", "bilateral"]
    for uncertain in (FRICTION, SOME):
        yield "box", ["decide", *uncertain], uncertain
    direction = ["--direction=" + ",".join(str(x) for x in grasp["wrench"])]
    yield "margin", ["margin", *direction], direction
    inertia = ["--inertia=0,0,1" if size == 3 else "--inertia=0,0,0,1,1,1"]
    yield "class", ["compare", "--methods", "weakly-stable-load", *inertia], inertia


def made(programs, path):
    """Questions about one grasp, each with its kind."""
    with tempfile.TemporaryDirectory() as folder:
        proof = os.path.join(folder, "proof.json")
        for kind, ask, check in questions_about(path):
            try:
                subprocess.run([os.path.join(programs, "stickslip"), ask[0], path, *ask[1:], "--certificate", proof],
                               capture_output=True, timeout=20, check=False)
            except subprocess.TimeoutExpired:
                continue
            if not os.path.exists(proof):
                continue
            with open(path, encoding="latin-1") as grasp, open(proof, encoding="latin-1") as certificate:
                question = {"grasp": grasp.read(), "certificate": certificate.read(), "options": check}
            os.remove(proof)
            yield kind_of(kind, question), os.path.basename(path), question


def kind_of(kind, question):
    said = json.loads(question["certificate"])
    where = "space" if len(said["question"]["wrench"]) == 6 else "plane"
    law = ", bilateral" if said["question"]["normal_law"] == "bilateral" else ""
    contacts = said["question"]["contacts"]
    size = f", {contacts} contacts" if where == "plane" and contacts >= 100 else ""
    return f"{where}: {kind}, {said['verdict']}{law}{size}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("inputs", nargs="+")
    parser.add_argument("--programs", required=True)
    parser.add_argument("--against", default="stickslip-check", help="a checker of that folder, or the path of one")
    parser.add_argument("--proved", default="stickslip-proved")
    parser.add_argument("--save")
    parser.add_argument("--seconds", type=float, default=0.05, help="for each question and checker")
    options = parser.parse_args()
    asked = []
    for name in options.inputs:
        if os.path.isdir(name):
            for file in sorted(os.listdir(name)):
                for it in made(options.programs, os.path.join(name, file)):
                    asked.append(it)
                    print(it[0], it[1], file=sys.stderr, flush=True)
        else:
            with open(name, encoding="utf-8") as file:
                asked += [json.loads(line) for line in file]
    if options.save:
        with open(options.save, "w", encoding="utf-8") as file:
            file.writelines(json.dumps(it) + "\n" for it in asked)
    checkers = [os.path.join(options.programs, name) for name in (options.against, options.proved)]
    ratios = defaultdict(list)
    for kind, name, question in asked:
        line = json.dumps(question) + "\n"
        once, said = timed([checkers[0], "--batch"], line)
        if json.loads(said)["result"] != "accepted":
            raise SystemExit(f"{kind}: {name}: {said}")
        times = max(3, min(1000, int(options.seconds / max(once - 0.002, 1e-4))))
        again = [timed([checker, "--batch"], line * times) for checker in checkers]
        answers = {json.loads(answer)["result"] for _, said in again for answer in said.splitlines()}
        if answers == {"accepted"}:
            ms = [1e3 * seconds / times for seconds, _ in again]
            ratios[kind].append((ms[1] / ms[0], *ms, name))
            print(f"{ms[1] / ms[0]:6.2f} {ms[0]:9.3f} {ms[1]:9.3f} {kind}: {name}", file=sys.stderr, flush=True)
        elif answers != {"accepted", "not judged"}:
            raise SystemExit(f"{kind}: {name}: {answers}")
    print("| kind | certificates | stickslip-check, ms | stickslip-proved, ms | ratio, median | most |")
    print("|---|--:|--:|--:|--:|--:|")
    for kind, found in sorted(ratios.items()):
        print(f"| {kind} | {len(found)} | {median(f[1] for f in found):.2f} | {median(f[2] for f in found):.2f} "
              f"| {median(f[0] for f in found):.1f} | {max(f[0] for f in found):.1f} |")


if __name__ == "__main__":
    main()
