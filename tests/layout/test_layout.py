# SPDX-License-Identifier: GPL-3.0-or-later
"""Dependencies between modules point one way, and what compiles slowly is in few files."""

import os
import re
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
CHECKER = os.path.join("certificate", "cpp")

# What each module may include of the others, by public headers: "stickslip/<module>/<name>.hpp".
ALLOWED = {
    "core": set(),
    "lp": {"core"},
    "arrangement": {"core", "lp"},
    "engine": {"core", "lp", "arrangement"},
    "measures": {"core", "lp", "engine"},
    "earlier": {"core", "lp", "arrangement", "engine"},
    "certificate": {"core", "engine", "measures", "earlier"},
    "interfaces": {"core", "arrangement", "engine", "measures", "earlier", "certificate"},
}

# The parts of a module, each a folder, in the order of the data: what each may include of the others. A public header is of
# the part that has the source of its name, or the one that is named here.
PARTS = {
    "engine": {
        "equilibrium": set(),
        "motion": {"equilibrium"},
        "search": {"equilibrium", "motion"},
        "planar": {"equilibrium", "motion", "search"},
        "degree": {"equilibrium", "motion", "search", "planar"},
        "statics": {"equilibrium"},
        "large": {"equilibrium", "motion", "search", "statics"},
        "box": {"equilibrium", "motion", "search", "planar", "degree", "large"},
        "decide": {"equilibrium", "motion", "search", "planar", "degree", "large", "box"},
    },
    "measures": {
        "margin": set(),
        "extent": {"margin"},
        "resistance": set(),
        "warnings": {"margin", "extent"},
        "crosscheck": {"margin"},
    },
    "interfaces": {
        "answers": set(),
        "batch": {"answers"},
        "plot": set(),
        "page": {"answers"},
        "cli": {"answers", "batch", "plot", "page"},
        "python": {"answers", "batch", "plot", "page"},
    },
}
HEADERS_ALONE = {"search_options": "equilibrium", "newton_equilibria": "planar", "near_equilibrium": "search", "reals": "motion",
                 "box_verdict": "search", "rigid_force": "statics", "preload": "extent", "decide_in_time": "decide"}

# Folders that may include the private headers of the engine's parts: "engine/<part>/<name>.hpp". Other modules have none that
# others include.
INSIDERS = ("engine/", "measures/", "earlier/")


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


def part_of(module, name):
    """The part that a public header is of."""
    for part in PARTS[module]:
        if os.path.exists(os.path.join(ROOT, module, part, name + ".cpp")):
            return part
    return HEADERS_ALONE[name]


class Layout(unittest.TestCase):
    def test_includes_follow_the_data(self):
        for module, allowed in ALLOWED.items():
            count = 0
            for path, text in sources(module):
                if path.startswith(CHECKER):
                    continue
                count += 1
                self.assertLessEqual(modules_included(text) - {module}, allowed, path)
                private = set(re.findall(r'#include "(engine|measures|interfaces)/', text)) - {module}
                self.assertLessEqual(private, {"engine"} if path.startswith(INSIDERS) else set(), path)
            self.assertGreater(count, 1, module)

    def test_parts_follow_the_data(self):
        for module, parts in PARTS.items():
            for path, text in sources(module):
                folder, name = os.path.split(path)
                if folder == f"{module}/include/stickslip/{module}":
                    part = part_of(module, name[:-4])
                else:
                    part = path.split("/")[1]
                found = set(re.findall(rf'#include "{module}/([a-z]+)/', text))
                found |= {part_of(module, header) for header in re.findall(rf'#include "stickslip/{module}/([a-z_]+).hpp"', text)}
                self.assertLessEqual(found - {part}, parts[part], path)

    def test_the_checker_stands_alone(self):
        found = dict(sources(CHECKER))
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
        # Those of the engine that others use as well stand in `stickslip`.
        folders = [(os.path.join(module, "src"), module) for module in ("core", "lp", "arrangement", "earlier")]
        folders.append(("earlier/robustness", "robustness"))
        folders += [(os.path.join(module, part), part) for module in PARTS for part in PARTS[module] if part not in ("cli", "python")]
        for folder, name in folders:
            for path, text in sources(folder):
                if not path.endswith(".hpp"):
                    continue
                namespaces = set(re.findall(r"^namespace ([a-z_:]+) {", text, re.M))
                own = f"stickslip::{name}_detail"
                if folder.startswith("engine"):
                    self.assertLessEqual(namespaces, {own, "stickslip", f"{name}_detail"}, path)
                else:
                    self.assertEqual(namespaces, {own}, path)

    def test_what_compiles_slowly_is_in_named_files_only(self):
        for included, files in {
                "<CGAL/": {"arrangement/src/cgal_enumerator.cpp", "measures/resistance/plane_overlay.cpp"},
                "<Eigen/(QR|SVD)>": {"engine/motion/dense.cpp"},
                "<Eigen/Sparse": {"lp/src/cone_program.cpp", "engine/large/sparse_newton.cpp"},
                "<nlohmann/": {"core/src/json.cpp"},
                "<CLI/": {"interfaces/cli/command_line.cpp"},
                "<httplib": {"interfaces/cli/page/page_server.cpp"},
                "<boost/multiprecision": set()}.items():
            users = {path for module in ALLOWED for path, text in sources(module)
                     if re.search("#include " + included, text)}
            self.assertEqual(users, files, included)

    def test_files_are_opened_where_inputs_are_protected(self):
        """Every other file is read by InputFile and written by write_whole_file, which know."""
        users = {path for module in ALLOWED for path, text in sources(module)
                 if not path.startswith(CHECKER)
                 and re.search(r"#include <fstream>|\b[io]?fstream\b|\bfopen\b", text)}
        self.assertEqual(users, {"core/include/stickslip/core/file.hpp", "interfaces/cli/many/batch.cpp"})

    def test_no_type_is_defined_twice(self):
        # Two definitions of one name in a program are undefined behaviour unless the same, and
        # two names of one idea are hard to read even where they are not.
        places = {}
        for module in ALLOWED:
            for path, text in sources(module):
                if path.startswith((CHECKER, "interfaces/python")):
                    continue
                for name in re.findall(r"^(?:class|struct|enum class) ([A-Z]\w*)[^;:]*(?: : [^;]*?)?\{", text, re.M):
                    places.setdefault(name, []).append(path)
        self.assertGreater(len(places), 100)
        twice = {name: paths for name, paths in places.items() if len(paths) > 1}
        self.assertEqual(twice, {})

    def test_every_source_names_its_licence(self):
        for folder in [*ALLOWED, "bench", "examples", "paper_examples", "tests"]:
            for path, text in sources(folder):
                self.assertTrue(text.startswith("// SPDX-License-Identifier: "), path)


if __name__ == "__main__":
    unittest.main()
