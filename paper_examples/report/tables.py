# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables I-III, from the output of paper_tables, which compares them number by number."""

import re

from programs import ProgramError

MISPRINTED = "no solution: misprinted"

def read_sections(output):
    """The paragraphs of the output by the words before their first colon."""
    paragraphs = output.strip().split("\n\n")
    return {paragraph.split(":")[0]: paragraph.splitlines() for paragraph in paragraphs}


def expect(size, rows):
    if len(rows) != size:
        raise ProgramError(f"paper_tables: {len(rows)} rows of a table were read, not {size}")
    return rows


def tuples(line):
    return re.findall(r"\([^)]*\)", line)


def force_rows(lines):
    """Table I or III. Of each row: w, P, the paper's Stable, our verdict, whether it agrees, the printed
    d and f, and what is said of them."""
    rows = []
    for line in lines:
        head = re.fullmatch(r"w = (\(.*?\)), P = (\S+): verdict (.*?)(?:; printed d and f solve it: (.*))?",
                            line)
        if head:
            wrench, preload, verdict, solved = head.groups()
            solved = {"agrees": "a solution", None: ""}.get(solved, solved)
            rows.append([wrench, preload, "", "", verdict, [], solved])
        elif line.startswith("  exact "):
            rows[-1][3] = line.split()[1]
        elif line.startswith("  paper "):
            rows[-1][2], rows[-1][5] = line.split()[1], tuples(line)
        elif line.startswith("        printed d and f do not solve it: agrees"):
            rows[-1][6] = MISPRINTED
    return rows


def show_force_table(chapter, lines, contacts, size):
    rows = expect(size, force_rows(lines))
    headings = ["w", "P", "paper: stable", "exact", "printed d",
                *(f"f<sub>{i}</sub>" for i in range(1, contacts + 1)), "printed d and f are"]
    cells = []
    for wrench, preload, stable, exact, verdict, printed, solved in rows:
        outcomes = [chapter.claims.outcome(verdict, "agrees")]
        if solved == MISPRINTED:
            outcomes.append(chapter.claims.outcome(solved, MISPRINTED,
                                                   f"row w = {wrench}, P = {preload} is misprinted"))
        elif printed:
            outcomes.append(chapter.claims.outcome(solved, "a solution"))
        failed = [outcome for outcome in outcomes if "FAILED" in outcome]
        cells.append([wrench, preload, stable, exact, *(printed or ["-"] * (contacts + 1)),
                      " ".join([solved, *failed])])
    chapter.table(headings, cells)


def show_counts(chapter, lines):
    rows = expect(8, [line.split() for line in lines
                      if re.match(r"\s+\d+(\s+\d+){6}\s", line)])
    cells = []
    for m, v, e, f, count, printed, states, *_ in rows:
        cells.append((m, v, e, f, count, printed, states, chapter.claims.outcome(count, printed)))
    chapter.table(("m", "V", "E", "F", "cells V + E + F", "paper: #(S)", "distinct states", ""), cells)
