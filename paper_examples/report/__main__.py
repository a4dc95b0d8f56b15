# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes report.md: the paper's tables and figures, regenerated and compared. Run by report.sh.

Exit codes: 0 everything is as expected, 1 a comparison failed, 2 the report could not be written.
"""

import argparse
import os
import shutil
import sys

import grasp_chapters
import other_chapters
import tables
from page import Report
from programs import ProgramError, Programs

PREFACE = """# The paper's examples, regenerated

Haas-Heger, Papadimitriou, Yannakakis, Iyengar, Ciocarlie: *Passive Static Equilibrium with Frictional Contacts
and Application to Grasp Stability Analysis*, RSS 2018. Every figure and table, what the paper says of it, and what
exact arithmetic says. The run that wrote this page made every comparison on it.

- μ = 1/2 and k = 1 unless said otherwise. P is the preload of every contact.
- w = (w_x, w_y, torque) is the load on the object, d = (x, y, r) its motion.
- Contacts are numbered from 1 in the text, as in the paper; from 0 in pictures and in what programs print.
- Contacts may open: c_n = max(0, P − k N·d).
- Commands run in the folder of this page, with the programs of `build/bin` on the path.
"""


def write_report(programs):
    report = Report(programs)
    output = programs.run("paper_tables", "grasps", codes=(0, 1))
    with open(programs.path("paper_tables.txt"), "w", encoding="utf-8") as file:
        file.write(output)
    programs.take_commands()
    sections = tables.read_sections(output)
    grasp_chapters.figure_1(report)
    grasp_chapters.figure_3(report)
    grasp_chapters.figure_4(report)
    other_chapters.figures_5_and_6(report)
    other_chapters.table_2(report, sections["Table II"])
    other_chapters.table_1(report, sections["Table I"], output.splitlines()[-1])
    other_chapters.figure_7(report)
    grasp_chapters.three_states(report)
    other_chapters.table_3(report, sections["Table III"])
    report.write(PREFACE)
    return report


def main():
    parser = argparse.ArgumentParser(prog="report", description="Regenerates the paper's tables and figures.")
    parser.add_argument("--programs", required=True, help="folder of stickslip, stickslip-check and paper_tables")
    parser.add_argument("--grasps", required=True, help="folder of fig1.json, fig3.json and fig4.json")
    parser.add_argument("output", help="folder to write report.md and its pictures to")
    arguments = parser.parse_args()
    try:
        for folder in ("grasps", "proofs"):
            os.makedirs(os.path.join(arguments.output, folder), exist_ok=True)
        for name in ("fig1.json", "fig3.json", "fig4.json"):
            shutil.copyfile(os.path.join(arguments.grasps, name), os.path.join(arguments.output, "grasps", name))
        report = write_report(Programs(arguments.programs, arguments.output))
    except (OSError, ProgramError) as error:
        print(f"report: {error}", file=sys.stderr)
        return 2
    print(f"{os.path.join(arguments.output, 'report.md')}: {report.result()}")
    return 1 if report.failed() else 0


sys.exit(main())
