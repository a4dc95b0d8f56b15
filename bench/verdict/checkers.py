# SPDX-License-Identifier: GPL-3.0-or-later
"""What the three checkers take for the certificates that `stickslip decide` writes about the grasps that
`verdict_bench --save` left: milliseconds of the processor of whole programs, the least of several runs.

    build/bin/verdict_bench --part targets --max-m 1000 --save FOLDER
    python3 bench/verdict/checkers.py --programs build/bin FOLDER

Exit code 1 if a certificate is not accepted.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
from collections import defaultdict
from statistics import median

CHECK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "certificate", "python", "check.py")


def timed(words, runs):
    """The least time of the processor, in ms."""
    times = []
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(words)}: {done.returncode}\n{done.stdout}{done.stderr}")
        times.append(1e3 * (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime))
    return min(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("folder")
    parser.add_argument("--programs", required=True)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    checkers = [[os.path.join(options.programs, "stickslip-check")],
                [os.path.join(options.programs, "stickslip-proved")], [sys.executable, "-B", CHECK]]
    rows = defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        proof = os.path.join(folder, "certificate.json")
        for name in sorted(os.listdir(options.folder)):
            contacts, verdict, _, law = name[:-len(".json")].split("_")
            question = [os.path.join(options.folder, name), "--normal-law", law]
            subprocess.run([os.path.join(options.programs, "stickslip"), "decide", *question,
                            "--certificate", proof], stdout=subprocess.DEVNULL, check=True)
            times = [timed([*checker, question[0], proof, *question[1:]],
                           1 if checker is checkers[2] else options.runs) for checker in checkers]
            rows[int(contacts), verdict].append(times)
            print(name, *(f"{ms:.1f}" for ms in times), flush=True)
    print("\n| m | verdict | grasps | stickslip-check, ms | stickslip-proved, ms | check.py, ms "
          "| proved / check, median | most |\n|--:|---|--:|--:|--:|--:|--:|--:|")
    for (contacts, verdict), found in sorted(rows.items()):
        middle = " | ".join(f"{median(times):.1f}" for times in zip(*found))
        ratios = [proved / check for check, proved, _ in found]
        print(f"| {contacts} | {verdict} | {len(found)} | {middle} | {median(ratios):.2f} | {max(ratios):.2f} |")


if __name__ == "__main__":
    main()
