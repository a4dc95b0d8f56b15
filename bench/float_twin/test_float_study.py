# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `float_study --quick` and puts its claims to `stickslip crosscheck`: the same counts, and
the method in doubles is right where nothing is close."""
import json
import os
import subprocess
import sys
import tempfile


def check(condition, what):
    if not condition:
        sys.exit(f"float_study: {what}")


def main(float_study, stickslip):
    with tempfile.TemporaryDirectory() as folder:
        claims = os.path.join(folder, "claims.jsonl")
        table = subprocess.run([float_study, "--quick", "--claims", claims], check=True,
                               capture_output=True, text=True).stdout
        rows = [[cell.strip() for cell in line.strip("|").split("|")]
                for line in table.splitlines()[2:]]
        check(len(rows) == 15, f"expected 15 rows:\n{table}")
        judged = subprocess.run([stickslip, "crosscheck", claims, "--json"], check=False,
                                capture_output=True, text=True)
        check(judged.returncode in (0, 1), judged.stdout[-300:] + judged.stderr)
        *reports, summary = [json.loads(line) for line in judged.stdout.splitlines()]
        check(len(reports) == sum(int(row[2]) for row in rows), "one claim for each answer")
        start = 0
        for family, tolerance, loads, stable, false_stable, false_unstable, ties, _, off in rows:
            part = reports[start:start + int(loads)]
            start += int(loads)
            wrong = [r for r in part if r["class"] in ("wrong", "tie")]
            found = [sum(r["verdict"] == "stable" for r in part),
                     sum(r["claimed"] == "stable" for r in wrong),
                     sum(r["claimed"] == "unstable" for r in wrong),
                     sum(r["class"] == "tie" for r in part),
                     sum(r["inaccurate"] for r in part)]
            check(found == [int(x) for x in (stable, false_stable, false_unstable, ties, off)],
                  f"{family}, {tolerance}: crosscheck counts {found}")
            check(0 < int(stable) < int(loads), f"{family}: both verdicts must occur")
            if family == "random":
                check(not wrong, f"{family}, {tolerance}: {wrong}")
        check(summary["summary"]["undecided"] == summary["summary"]["unreadable"] == 0, "summary")


if __name__ == "__main__":
    main(*sys.argv[1:])
