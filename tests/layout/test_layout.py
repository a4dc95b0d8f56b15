# SPDX-License-Identifier: GPL-3.0-or-later
"""Dependencies between modules point one way, and what compiles slowly is in few files."""

import os
import re
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")

# What each module may include of the others.
ALLOWED = {
    "core": set(),
    "lp": {"core"},
    "arrangement": {"core", "lp"},
    "equilibrium": {"core"},
    "motion": {"core", "equilibrium"},
    "search": {"core", "equilibrium", "motion"},
    "planar": {"core", "lp", "arrangement", "equilibrium", "motion", "search"},
    "degree": {"core", "lp", "equilibrium", "motion", "planar", "search"},
    "margin": {"core", "equilibrium", "motion", "planar", "search", "degree"},
    "box": {"core", "lp", "equilibrium", "motion", "planar", "search", "degree", "margin"},
    "warnings": {"core", "equilibrium", "motion", "planar", "degree", "margin", "box"},
    "resistance": {"core", "equilibrium", "planar", "search"},
    "earlier": {"core", "lp", "equilibrium", "motion", "planar", "box"},
    "certificate": {"core", "equilibrium", "planar", "margin", "box", "resistance", "earlier"},
    "answers": {"core", "equilibrium", "planar", "search", "margin", "box", "warnings", "resistance", "certificate"},
    "batch": {"core", "equilibrium", "earlier", "certificate", "answers"},
    "crosscheck": {"core", "equilibrium", "planar", "degree", "margin", "box", "answers"},
    "plot": {"core", "arrangement", "equilibrium", "planar", "degree", "box", "resistance"},
    "page": {"core", "arrangement", "equilibrium", "degree", "margin", "box", "answers"},
}


def sources(folder):
    for place, folders, files in os.walk(os.path.join(ROOT, folder)):
        folders.sort()
        for name in sorted(files):
            if name.endswith((".hpp", ".cpp")):
                path = os.path.join(place, name)
                with open(path, encoding="utf-8") as file:
                    yield os.path.relpath(path, ROOT), file.read()


def modules_included(text):
    return set(re.findall(r'#include "stickslip/([a-z]+)/', text))


class Layout(unittest.TestCase):
    def test_includes_follow_the_data(self):
        for module, allowed in ALLOWED.items():
            count = 0
            for path, text in sources(module):
                if path.startswith(os.path.join("certificate", "checker")):
                    continue
                count += 1
                self.assertLessEqual(modules_included(text) - {module}, allowed, path)
            self.assertGreater(count, 1, module)

    def test_the_checker_stands_alone(self):
        found = dict(sources(os.path.join("certificate", "checker")))
        self.assertGreater(len(found), 10)
        for path, text in found.items():
            self.assertEqual(modules_included(text), set(), path)
            self.assertNotRegex(text, r"namespace stickslip\b(?!_check)", path)
            self.assertIn("SPDX-License-Identifier: MIT", text, path)

    def test_no_public_header_includes_a_private_one(self):
        for module in ALLOWED:
            for path, text in sources(os.path.join(module, "include")):
                local = re.findall(r'#include "(?!stickslip/)([^"]+)"', text)
                self.assertEqual(local, [], path)

    def test_private_headers_declare_in_a_namespace_of_their_own(self):
        for module in ("core", "lp", "arrangement", "planar", "search", "degree", "margin", "box", "resistance", "earlier", "batch", "crosscheck", "plot", "page"):
            private = {path: text for path, text in sources(os.path.join(module, "src"))
                       if path.endswith(".hpp")}
            self.assertGreater(len(private), 0, module)
            for path, text in private.items():
                self.assertEqual(set(re.findall(r"^namespace ([a-z_:]+) {", text, re.M)),
                                 {f"stickslip::{module}_detail"}, path)

    def test_what_compiles_slowly_is_in_named_files_only(self):
        for included, files in {
                "<CGAL/": {"arrangement/src/cgal_enumerator.cpp", "resistance/src/plane_overlay.cpp"},
                "<Eigen/(QR|SVD)>": {"motion/src/dense.cpp"},
                "<nlohmann/": {"core/src/json.cpp"},
                "<CLI/": {"cli/command_line.cpp"},
                "<httplib": {"cli/page/page_server.cpp"},
                "<boost/multiprecision": set()}.items():
            users = {path for module in [*ALLOWED, "cli", "python"] for path, text in sources(module)
                     if re.search("#include " + included, text)}
            self.assertEqual(users, files, included)

    def test_files_are_opened_where_inputs_are_protected(self):
        """Every other file is read by InputFile and written by write_whole_file, which know."""
        users = {path for module in [*ALLOWED, "cli"] for path, text in sources(module)
                 if not path.startswith(os.path.join("certificate", "checker"))
                 and re.search(r"#include <fstream>|\b[io]?fstream\b|\bfopen\b", text)}
        self.assertEqual(users, {"core/include/stickslip/core/file.hpp", "cli/many/batch.cpp"})

    def test_no_type_is_defined_twice(self):
        # Two definitions of one name in a program are undefined behaviour unless the same, and
        # two names of one idea are hard to read even where they are not.
        places = {}
        for module in [*ALLOWED, "cli"]:
            for path, text in sources(module):
                if path.startswith(os.path.join("certificate", "checker")):
                    continue
                for name in re.findall(r"^(?:class|struct|enum class) ([A-Z]\w*)[^;:]*(?: : [^;]*?)?\{", text, re.M):
                    places.setdefault(name, []).append(path)
        self.assertGreater(len(places), 100)
        twice = {name: paths for name, paths in places.items() if len(paths) > 1}
        self.assertEqual(twice, {})

    def test_every_source_names_its_licence(self):
        for folder in [*ALLOWED, "cli", "python", "bench", "examples", "paper_examples", "tests", "conformance"]:
            for path, text in sources(folder):
                self.assertTrue(text.startswith("// SPDX-License-Identifier: "), path)


if __name__ == "__main__":
    unittest.main()
