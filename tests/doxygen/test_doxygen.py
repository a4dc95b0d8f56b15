# SPDX-License-Identifier: GPL-3.0-or-later
"""Doxygen documents every public entity, without a warning and without a broken link."""

import glob
import html
import os
import re
import subprocess
import unittest
import urllib.parse

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
SCRATCH = os.environ["SCRATCH"]


def doxygen(name, settings=""):
    """The exit status, the messages, and the folder of the pages."""
    output = os.path.join(SCRATCH, name)
    os.makedirs(output, exist_ok=True)
    for page in glob.glob(os.path.join(output, "html", "*.html")):
        os.remove(page)
    run = subprocess.run(
        [os.environ["DOXYGEN"], "-"], cwd=ROOT, capture_output=True, text=True, check=False,
        input=f'@INCLUDE = docs/doxygen/Doxyfile\nOUTPUT_DIRECTORY = "{output}"\n' + settings)
    return run.returncode, run.stdout + run.stderr, os.path.join(output, "html")


def read(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read()


class Reference(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.status, cls.messages, cls.pages = doxygen("reference")

    def test_no_warnings(self):
        self.assertEqual((self.status, self.messages), (0, ""))

    def test_every_public_header_is_in_it(self):
        files = read(self.pages, "files.html")
        headers = glob.glob(os.path.join(ROOT, "*", "include", "stickslip", "**", "*.hpp"),
                            recursive=True)
        self.assertGreater(len(headers), 40)
        for header in headers:
            self.assertIn(f">{os.path.basename(header)}</a>", files)

    def test_the_main_page_leads_to_the_entry_points(self):
        targets = re.findall(r'href="([^"]+)">(\w+)</a>', read(self.pages, "index.html"))
        names = {name for _, name in targets}
        for name in ("read_grasp_file", "Question", "Problem", "decide", "certificate_text"):
            self.assertIn(name, names)

    def test_every_link_leads_somewhere(self):
        pages = {os.path.basename(page): read(page)
                 for page in glob.glob(os.path.join(self.pages, "*.html"))}
        anchors = {name: set(re.findall(r'\b(?:id|name)="([^"]+)"', text))
                   for name, text in pages.items()}
        count = 0
        for name, text in pages.items():
            for link in re.findall(r'\b(?:href|src)="([^"]+)"', text):
                url = urllib.parse.urlsplit(html.unescape(link))
                target = url.path or name
                if url.scheme or not url.path and not url.fragment:
                    continue
                count += 1
                self.assertTrue(os.path.exists(os.path.join(self.pages, target)), f"{name}: {link}")
                if url.fragment:
                    self.assertIn(url.fragment, anchors[target], f"{name}: {link}")
        self.assertGreater(count, 1000)


class CanFail(unittest.TestCase):
    """What the test above relies on."""

    def warned(self, name, content):
        path = os.path.join(SCRATCH, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)
        status, messages, _ = doxygen("can_fail", f'INPUT = "{path}"\n')
        self.assertEqual(status != 0, messages != "", messages)
        return messages

    def test_an_entity_without_a_comment(self):
        header = "/// \\file\n/// F.\nnamespace stickslip {\n%sint f();\n}\n"
        self.assertEqual(self.warned("good.hpp", header % "/// Is 1.\n"), "")
        self.assertIn("f() (function) of namespace stickslip is not documented",
                      self.warned("bad.hpp", header % ""))

    def test_a_link_to_no_heading(self):
        page = "# Page\n\n## One part\n\n[here](#%s)\n"
        self.assertEqual(self.warned("good.md", page % "one-part"), "")
        self.assertIn("unable to resolve reference", self.warned("bad.md", page % "no-part"))


if __name__ == "__main__":
    unittest.main()
