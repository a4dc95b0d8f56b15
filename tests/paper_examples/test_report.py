# SPDX-License-Identifier: GPL-3.0-or-later
"""paper_examples/report.sh: it succeeds, is complete, and fails when something that it compares is wrong.

The programs are named by the environment variables STICKSLIP, STICKSLIP_CHECK and PAPER_TABLES.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
PAPER = os.path.join(HERE, "..", "..", "paper_examples")
PROGRAMS = {name: os.path.abspath(os.environ.get(variable, shutil.which(name) or name)) for name, variable in
            (("stickslip", "STICKSLIP"), ("stickslip-check", "STICKSLIP_CHECK"), ("paper_tables", "PAPER_TABLES"))}
REJECTS = """#!/bin/sh
echo '{"result": "rejected"}'
exit 1
"""
# The last row of Table III is judged wrong, and only there.
MISJUDGES = """#!/bin/sh
"{}" "$@" | sed '/(0, 0, -3), P = 1/s/solve it: agrees/solve it: DISAGREES/'
"""
EMPTY = """#!/bin/sh
printf 'Table I: x\\n\\nTable II: x\\n\\nTable III: x\\n\\n0 of 0 comparisons agree\\n'
"""


class ReportCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.binaries = os.path.join(self.folder, "bin")
        os.mkdir(self.binaries)
        for name, path in PROGRAMS.items():
            os.symlink(path, os.path.join(self.binaries, name))

    def run_words(self, *words):
        environment = {**os.environ, "STICKSLIP_BIN_DIR": self.binaries}
        result = subprocess.run(words, cwd=self.folder, env=environment, capture_output=True, text=True,
                                check=False, timeout=300)
        return result.returncode, result.stdout, result.stderr

    def report(self, *words):
        return self.run_words(os.path.join(PAPER, "report.sh"), *words)

    def report_on(self, grasps, output):
        return self.run_words(sys.executable, "-B", os.path.join(PAPER, "report"), "--programs", self.binaries,
                              "--grasps", grasps, output)

    def replace(self, program, script):
        path = os.path.join(self.binaries, program)
        os.remove(path)
        with open(path, "w", encoding="utf-8") as file:
            file.write(script)
        os.chmod(path, 0o755)

    def read(self, *names):
        with open(os.path.join(self.folder, *names), encoding="utf-8") as file:
            return file.read()


class Complete(ReportCase):
    def setUp(self):
        super().setUp()
        self.result = self.report("my report")
        self.page = self.read("my report", "report.md")

    def test_succeeds(self):
        code, out, err = self.result
        self.assertEqual((code, err), (0, ""))
        self.assertIn("none failed", out)
        self.assertNotIn("FAILED", self.page)
        self.assertEqual(sorted(os.listdir(self.folder)), ["bin", "my report"])
        self.assertNotIn("__pycache__", os.listdir(os.path.join(PAPER, "report")))

    def test_names_every_table_and_figure(self):
        headings = "\n".join(re.findall("^## .*", self.page, re.M))
        for name in ("Fig. 1:", "Fig. 3:", "Fig. 4:", "Figs. 5 and 6:", "Fig. 7:",
                     "Table I:", "Table II:", "Table III:"):
            self.assertIn(name, headings)
        for name in ("Fig. 2", "**(a)", "**(b), (c)", "Prattichizzo", "Misprints"):
            self.assertIn(name, self.page)

    def test_counts_what_it_says(self):
        rows = re.findall(r"^\| \[.*\| (\d+) \| (\d+) \| (\d+) \|$", self.page, re.M)
        agree, differ, failed = (sum(map(int, column)) for column in zip(*rows))
        self.assertIn(f"**{agree} comparisons agree with the paper, {differ} differ from it for a stated reason, "
                      "none failed.**", self.page)
        self.assertGreater(agree, 70)
        self.assertEqual((differ, failed), (10, 0))

    def test_links(self):
        anchors = {"#" + re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
                   for heading in re.findall("^## (.*)", self.page, re.M)}
        links = re.findall(r"\]\(([^)]*)\)", self.page)
        self.assertGreater(len(links), 30)
        for link in links:
            if link.startswith("#"):
                self.assertIn(link, anchors)
            else:
                self.assertTrue(self.read("my report", link), link)

    def picture(self, name):
        return ElementTree.fromstring(self.read("my report", name))

    def test_pictures(self):
        pictures = re.findall(r"!\[[^]]+\]\(([^)]*)\)", self.page)
        self.assertEqual(sorted(pictures), sorted(n for n in os.listdir(os.path.join(self.folder, "my report"))
                                                  if n.endswith(".svg")))
        for name in ("fig1_up.svg", "fig1_down.svg", "fig3.svg", "fig4.svg", "fig5.svg", "fig6.svg",
                     "fig7a.svg", "fig7b.svg", "fig7c.svg"):
            self.assertIn(name, pictures)
        for name in pictures:
            root = self.picture(name)
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
            self.assertTrue(root.find("{*}title").text)
            self.assertTrue(root.find("{*}style").text)
            width, height = (float(root.get(side)) for side in ("width", "height"))
            for text in root.iter("{http://www.w3.org/2000/svg}text"):
                self.assertTrue(0 <= float(text.get("x")) <= width and 0 <= float(text.get("y")) <= height, name)

    def test_dual_polyhedron(self):
        states = [e.get("data-state") for e in self.picture("fig6.svg").iter() if e.get("data-state")]
        self.assertEqual(len(states), len(set(states)))
        # 8 corners, 12 edges, and the 3 faces that are seen: never two opposite ones.
        self.assertEqual([sum(s.count("0") == k for s in states) for k in range(3)], [8, 12, 3])
        seen = [s for s in states if s.count("0") == 2]
        self.assertEqual(len({s.replace("-", "+") for s in seen}), 3)

    def test_grasp_wrench_space(self):
        shown = {tuple(map(Fraction, e.get("data-value").split(",")))
                 for e in self.picture("fig7a.svg").iter() if e.get("data-value")}
        # By hand, each the mean of two edges of cones with opposite torques: (1, 0) of both at contact 3,
        # (0, -1) of both at contact 2, (0, 1/2) of the lower ones at contacts 1 and 3, (3/4, -3/4) of the left one
        # at contact 2 and the upper one at contact 3; and the mirror images.
        half, most = Fraction(1, 2), Fraction(3, 4)
        self.assertEqual(shown, {(1, 0), (-1, 0), (0, half), (0, -1), (most, -most), (-most, -most)})

    def test_same_bytes(self):
        self.assertEqual(self.report("again")[0], 0)
        for folder, _, names in os.walk(os.path.join(self.folder, "my report")):
            for name in names:
                path = os.path.join(folder, name)
                self.assertEqual(self.read(path), self.read(path.replace("my report", "again")), name)


class Fails(ReportCase):
    def assert_fails(self, result, output, where):
        code, out, err = result
        self.assertEqual((code, err), (1, ""))
        page = self.read(output, "report.md")
        self.assertIn("FAILED", page)
        rows = dict(re.findall(r"^\| \[(.*?):.*\| (\d+) \|$", page, re.M))
        self.assertEqual(sorted(name for name, failed in rows.items() if failed != "0"), sorted(where))

    def test_wrong_friction(self):
        grasps = os.path.join(self.folder, "grasps")
        shutil.copytree(os.path.join(PAPER, "grasps"), grasps)
        shutil.copy(os.path.join(PAPER, "wrong_grasps", "fig1.json"), grasps)
        self.assert_fails(self.report_on(grasps, "out"), "out", ["Fig. 1", "Table I", "Fig. 7", "Section VI"])

    def test_proof_rejected(self):
        self.replace("stickslip-check", REJECTS)
        self.assert_fails(self.report("out"), "out", ["Fig. 1", "Fig. 3", "Fig. 4", "Section VI"])

    def test_row_of_a_table(self):
        self.replace("paper_tables", MISJUDGES.format(PROGRAMS["paper_tables"]))
        self.assert_fails(self.report("out"), "out", ["Table III"])


class BadUse(ReportCase):
    def test_usage(self):
        for words in (("a", "b"), ("--help-me",)):
            code, out, err = self.report(*words)
            self.assertEqual((code, out), (1, ""))
            self.assertIn("usage", err)

    def test_program_missing(self):
        os.remove(os.path.join(self.binaries, "stickslip"))
        code, out, err = self.report("out")
        self.assertEqual((code, out), (2, ""))
        self.assertIn("stickslip", err)

    def test_program_fails(self):
        self.replace("stickslip", "#!/bin/sh\necho no such thing >&2\nexit 2\n")
        code, out, err = self.report("out")
        self.assertEqual((code, out), (2, ""))
        self.assertIn("no such thing", err)

    def test_table_without_rows(self):
        self.replace("paper_tables", EMPTY)
        code, _, err = self.report("out")
        self.assertEqual(code, 2)
        self.assertIn("0 rows", err)


if __name__ == "__main__":
    unittest.main()
