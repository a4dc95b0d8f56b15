# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs `table2 --quick` and checks its counts, in all three forms. Never its times."""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

# Haas-Heger et al., RSS 2018, Table II.
PUBLISHED = {2: 10, 3: 26, 4: 50, 5: 82, 6: 122, 7: 170, 8: 226, 9: 290}
PRINTED_SECONDS = {2: 0.006, 3: 0.02, 4: 0.09, 5: 0.42, 6: 1.5, 7: 4.8, 8: 13.8, 9: 35.7}


def states(m):
    """Distinct sign vectors of m planes in general position, all-stick included."""
    return 9 if m == 2 else 4 * m * (m - 1) + 3


def check(condition, what):
    if not condition:
        sys.exit(f"table2: {what}")


def check_json(report):
    table = report["table"]
    check([row["m"] for row in table] == sorted(PUBLISHED), "the table must have m = 2 .. 9")
    for row in table:
        m = row["m"]
        check(row["cells"] == row["cells_published"] == PUBLISHED[m], f"cells at m = {m}")
        check(row["distinct_states"] == states(m), f"states at m = {m}")
        missing = 0 if m == 2 else 1  # all-stick
        check(row["states_of_paper_steps"] == states(m) - missing, f"paper's states at m = {m}")
        check(row["seconds"]["printed"] == PRINTED_SECONDS[m], f"printed seconds at m = {m}")
        regions = m * (m - 1) + 2
        check(row["paper_work"]["pairs_compared"] == regions * (regions - 1) // 2,
              f"pairs at m = {m}")
    check([row["m"] for row in report["scaling"]] == [10, 20, 50], "sizes of the scaling section")
    for row in report["scaling"]:
        m = row["m"]
        check(row["cells"] == 4 * m * (m - 1) + 2, f"cells at m = {m}")
        check(row["distinct_states"] == states(m), f"states at m = {m}")
        for task in ("count", "visit", "structure", "cgal"):
            check(row[task]["seconds"] >= 0 and row[task]["peak_bytes"] >= 0, f"{task} at m = {m}")


def check_csv(rows):
    kinds = {}
    for row in rows:
        m = int(row["m"])
        check(int(row["cells"]) == 4 * m * (m - 1) + 2, f"CSV: cells at m = {m}")
        check(float(row["seconds"]) >= 0, f"CSV: seconds at m = {m}")
        kinds.setdefault((row["section"], m), []).append(row["enumerator"])
    for m in PUBLISHED:
        check(kinds[("table", m)] == ["printed", "paper", "cgal", "sweep"], f"CSV: rows at m = {m}")
    for m in (10, 20, 50):
        check(kinds[("scaling", m)] == ["sweep"] * 3 + ["cgal"], f"CSV: rows at m = {m}")


def check_text(text):
    rows = [line.split() for line in text.splitlines()]
    first = next(i for i, row in enumerate(rows) if row[:2] == ["m", "cells"])
    for row, m in zip(rows[first + 1:], sorted(PUBLISHED)):
        check(row[:4] == [str(m), str(PUBLISHED[m]), str(PUBLISHED[m]), str(states(m))],
              f"the printed row of m = {m}")


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        json_file = pathlib.Path(folder) / "table2.json"
        csv_file = pathlib.Path(folder) / "table2.csv"
        done = subprocess.run([program, "--quick", "--json", json_file, "--csv", csv_file],
                              check=True, capture_output=True, text=True)
        check_json(json.loads(json_file.read_text()))
        with csv_file.open(newline="") as file:
            check_csv(list(csv.DictReader(file)))
        check_text(done.stdout)
        unwritable = subprocess.run(
            [program, "--quick", "--max-paper-m", "2", "--max-m", "0", "--json",
             pathlib.Path(folder) / "missing" / "x.json"], capture_output=True, text=True)
        check(unwritable.returncode == 1 and "cannot be written" in unwritable.stderr,
              "an unwritable file must be an error")


main()
