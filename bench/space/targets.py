# SPDX-License-Identifier: GPL-3.0-or-later
"""What `stickslip decide --certificate` and `stickslip-check` take for the files of grasps.py, in seconds
of the processor, starting the programs included.

    python3 bench/space/targets.py --programs build/bin [--uncertain LIST] FILE...

Exit code 1 if a certificate is rejected.
"""

import argparse
import os
import re
import tempfile
from collections import defaultdict
from statistics import median

from grasps import decided, timed


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("files", nargs="+")
    parser.add_argument("--programs", required=True)
    parser.add_argument("--uncertain", help="ask about boxes: as that option of both programs")
    options = parser.parse_args()
    words = ["--uncertain", options.uncertain] if options.uncertain else []
    groups = defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        proof = os.path.join(folder, "certificate.json")
        for file in options.files:
            verdict, seconds, answer = decided(os.path.join(options.programs, "stickslip"), file,
                                               "--certificate", proof, *words)
            check, size = 0, 0
            if verdict not in ("undecided", "fragile"):
                check, _ = timed(os.path.join(options.programs, "stickslip-check"), file, proof, *words)
                size = os.path.getsize(proof)
            as_expected = file.endswith({"stable": "s.json", "unstable": "u.json"}.get(verdict, " "))
            print(f"{file}: {verdict} in {seconds:.3f} s, checked in {check:.3f} s, {size} bytes, {answer['stats']}",
                  flush=True)
            group = re.sub(r".*/|_\d+(?=_)|[su][.]json$", "", file)
            groups[group].append((seconds, check, check / max(seconds, 1e-3), answer["stats"]["nodes"], size,
                                  verdict, as_expected))
    print("\n| grasps, gap | verdicts | undecided | unexpected | s, median | slowest | check, s: median | slowest "
          "| check / decide, median | most | nodes, median | most | bytes, median | most |\n"
          "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    for group, found in groups.items():
        *numbers, verdicts, expected = zip(*found)
        undecided = verdicts.count("undecided")
        cells = " | ".join(f"{median(n):.3g} | {max(n):.3g}" if n[0] < 100 else f"{median(n):.0f} | {max(n)}"
                           for n in numbers)
        print(f"| {group} | {len(found)} | {undecided} | {expected.count(False) - undecided} | {cells} |")


if __name__ == "__main__":
    main()
