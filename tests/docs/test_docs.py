# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command of the documentation is run, and prints what the page shows (pages.py).

STICKSLIP_BIN names the folder of the programs, STICKSLIP_PYTHON that of the Python module.
"""

import importlib.util
import os
import re
import subprocess
import tempfile
import unittest

import pages

PROGRAMS = os.path.abspath(os.environ.get("STICKSLIP_BIN",
                                          os.path.join(pages.ROOT, "build", "bin")))
PYTHON_MODULE = os.environ.get("STICKSLIP_PYTHON")
BENCHMARKS = "bench/README.md"  # minutes each; see test_benchmarks_exist

# Pages that need the Python module, and which others.
NEEDS_PYTHON = {"docs/python.md": [], "docs/batch.md": ["distributed"], "docs/verdicts.md": ["pandas"]}

# Commands that are not run here, by their first words: why, and what runs them instead.
NOT_RUN = {
    "scripts/demo.sh": ("builds, then runs paper_tables", "paper_examples/CMakeLists.txt"),
    "scripts/test.sh": ("is what runs this test", "scripts/test.sh"),
    "paper_examples/report.sh": ("builds, then writes the report",
                                 "tests/paper_examples/test_report.py"),
    "apt-get install": ("needs root", "scripts/common.sh"),
    "scripts/package.sh": ("builds, then makes packages", "tests/package/test_package.sh"),
    "pip install build/package/": ("is of a package", "tests/package/test_package.sh"),
    "stickslip serve": ("goes on until it is told to end", "tests/interfaces/cli/test_page.py"),
    "python3 -m venv": ("pip compiles the module", "tests/interfaces/python/test_install.py"),
    "~/stickslip-env/bin/": ("pip compiles the module", "tests/interfaces/python/test_install.py"),
    "cmake --build build ": ("builds everything", "scripts/test.sh"),
    "cmake --build build-dev": ("builds everything", "scripts/sanitize.sh"),
    "cmake --preset": ("builds everything", "scripts/sanitize.sh"),
    "scripts/sanitize.sh": ("builds everything with sanitizers; CI runs it", ".ci/run"),
    "certificate/proved/verify.sh": ("takes minutes", "tests/certificate/CMakeLists.txt"),
    "scripts/fuzz.sh": ("runs for minutes; the targets are replayed", "tests/fuzz/CMakeLists.txt"),
}


def setUpModule():
    if not os.access(os.path.join(PROGRAMS, "stickslip"), os.X_OK):
        raise FileNotFoundError(f"no stickslip in {PROGRAMS}: set STICKSLIP_BIN")


def reason_not_to_run(command):
    return next((words for words in NOT_RUN if command.text.startswith(words)), None)


def lacks_program(command):
    """Whether it is of the proved checker, which is built on demand (scripts/test.sh does)."""
    return "proved" in command.text and not os.path.exists(os.path.join(PROGRAMS, "stickslip-proved"))


class Documentation(unittest.TestCase):
    def run_page(self, name):
        commands = [c for c in pages.commands(pages.read(name))
                    if not reason_not_to_run(c) and not lacks_program(c)]
        if not commands:
            return
        with tempfile.TemporaryDirectory() as parent:
            folder = os.path.join(parent, "stickslip")
            os.mkdir(folder)
            pages.prepare(folder, PROGRAMS, PYTHON_MODULE)
            results = pages.run(commands, folder, os.path.join(parent, "tools"))
        for command, (status, output) in zip(commands, results):
            with self.subTest(place=f"{name}:{command.line}"):
                said = f"\n$ {command.text}\n{output}"
                self.assertEqual(status, command.status, said)
                self.assertTrue(command.prints(output),
                                f"{said}instead of, as the page shows,\n"
                                + "\n".join(command.shown))

    def test_pages_are_found(self):
        for name in ("README.md", "docs/prove.md", "docs/enumerate.md", "docs/crosscheck.md"):
            self.assertGreater(len(pages.commands(pages.read(name))), 3, name)

    def test_words_of_the_field_are_found(self):
        for name in ("README.md", "docs/model.md"):
            text = " ".join(pages.read(name).lower().split())
            for word in ("force closure", "form closure", "contact mode", "gravity",
                         "maximum dissipation", "detachment"):
                self.assertIn(word, text, name)

    def test_python_blocks_are_where_tests_python_runs_them(self):
        for name in pages.page_names():
            fenced, _ = pages.blocks(pages.read(name))
            if any(kind == "python" for kind, _, _ in fenced):
                self.assertIn(f'"{name}"', pages.read("tests/interfaces/python/test_examples.py"))

    def test_the_example_in_cpp_is_the_one_that_is_compiled(self):
        (example,) = [text for kind, _, text in pages.blocks(pages.read("README.md"))[0] if kind == "cpp"]
        self.assertEqual("\n".join(example).strip(), "\n".join(pages.read("examples/decide.cpp").split("\n")[2:]).strip())

    def test_list_of_commands_not_run(self):
        texts = [command for name in pages.page_names() if name != BENCHMARKS
                 for command in pages.commands(pages.read(name))]
        for words, (_, instead) in NOT_RUN.items():
            with self.subTest(words=words):
                self.assertTrue(any(reason_not_to_run(c) == words for c in texts), "of no page")
                self.assertTrue(os.path.exists(os.path.join(pages.ROOT, instead)))
        for command in texts:
            if reason_not_to_run(command):
                self.assertEqual(command.shown, [], f"nothing compares the output: {command.text}")

    def test_inline_commands_exist(self):
        """`stickslip SUBCOMMAND --option` within a sentence."""
        help_of = {}
        for name in pages.page_names():
            _, outside = pages.blocks(pages.read(name))
            text = "\n".join(line for _, line in outside)
            for words in re.findall(r"`(stickslip(?:-check)?\s[^`]*)`", text):
                program, *rest = words.split()
                asked = (program, *rest[:1]) if program == "stickslip" else (program,)
                if asked not in help_of:
                    help_of[asked] = help_text(os.path.join(PROGRAMS, program), *asked[1:])
                # An unknown subcommand gets the help of the program.
                self.assertIn(" ".join(asked) + " ", help_of[asked], f"{name}: {words}")
                for option in re.findall(r"--[a-z][a-z0-9-]*", words):
                    self.assertRegex(help_of[asked], rf"{option}\b", f"{name}: {words}")

    def test_links(self):
        for name in pages.page_names():
            for target in re.findall(r"\]\(([^)\s]+)\)", pages.read(name)):
                path, _, heading = target.partition("#")
                if re.match(r"\w+:", path):
                    continue
                path = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
                self.assertTrue(os.path.exists(os.path.join(pages.ROOT, path)), f"{name}: {target}")
                if heading:
                    titles = re.findall(r"^#+ (.*)$", pages.read(path), re.MULTILINE)
                    self.assertIn(heading, [re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
                                            for title in titles], f"{name}: {target}")

    @unittest.skipUnless(os.path.exists(os.path.join(PROGRAMS, "table2")),
                         "the benchmarks are not built")
    def test_benchmarks_exist(self):
        found = re.findall(r"^    build/bin/(\w+)(.*)$", pages.read(BENCHMARKS), re.MULTILINE)
        self.assertGreater(len(found), 4)
        for program, words in found:
            path = os.path.join(PROGRAMS, program)
            self.assertTrue(os.access(path, os.X_OK), path)
            options = re.findall(r"--[a-z][a-z0-9-]*", words)
            for option in options:
                self.assertRegex(help_text(path), rf"{option}\b", program)


class Notation(unittest.TestCase):
    """The test can fail."""

    def command(self, text):
        found, = pages.commands(text)
        return found

    def test_output_is_compared(self):
        command = self.command("```console\n$ x\none\n...\nthree, ... four\n```")
        self.assertEqual((command.text, command.line, command.status), ("x", 2, 0))
        for output in ("one\nthree, four\n", "one\n2\n2\nthree, and four\n"):
            self.assertEqual(command.prints(output), "and" in output, output)
        for output in ("", "one\n", "0\none\nthree, x four\n", "one\nthree, x four",
                       "one\nthree, x four\n5\n", "one\nthree, \n four\n"):
            self.assertFalse(command.prints(output), output)
        silent = self.command("```console\n$ x\n```")
        self.assertTrue(silent.prints(""))
        self.assertFalse(silent.prints("\n"))

    def test_status(self):
        self.assertEqual(self.command("```console\n$ x --y # exit 12\n```").status, 12)

    def test_commands_of_several_lines(self):
        found = pages.commands("```console\n$ cat >f <<'EOF'\n$ a\nEOF\n$ x \\\n  y\nz\n```")
        self.assertEqual([c.text for c in found], ["cat >f <<'EOF'\n$ a\nEOF", "x \\\n  y"])
        self.assertEqual([c.shown for c in found], [[], ["z"]])

    def test_nothing_escapes(self):
        for text in ("```\n$ x\n```", "```sh\nx\n```", "```text\n$ x\n```", "~~~console\n$ x\n~~~",
                     "```text\nstickslip decide g\n```", "```console\nx\n```", "```console\n$ x",
                     "  ```console\n$ x\n  ```", "```python\nf()\n```",
                     "```text\nA=b build/bin/stickslip-check g c\n```", "\n    python3 x.py\n",
                     "```console\n$ cat <<'EOF'\n```", "```console\n$ x \\\n```"):
            with self.subTest(text=text), self.assertRaises(pages.PageError):
                pages.commands(text)

    def test_running(self):
        with tempfile.TemporaryDirectory() as folder:
            commands = pages.commands("```console\n$ a=1; printf x\n$ echo $a; false\n"
                                      "$ no-such-program\n$ cd /; pwd >&2\n$ exit 4\n$ echo\n```")
            results = pages.run(commands, folder, os.path.join(folder, "tools"))
        self.assertEqual([status for status, _ in results], [0, 1, 127, 0, None, None])
        outputs = [output for _, output in results]
        self.assertEqual((outputs[:2], outputs[3]), (["x", "1\n"], "/\n"))
        self.assertIn("not found", outputs[2])


def help_text(program, *words):
    result = subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True,
                            timeout=60)
    return result.stdout


def add_page(name):
    def test(self):
        self.run_page(name)
    test.__doc__ = f"The commands of {name}."
    if name in NEEDS_PYTHON:
        test = unittest.skipUnless(PYTHON_MODULE, "the Python module is not built")(test)
        for module in NEEDS_PYTHON[name]:
            test = unittest.skipUnless(importlib.util.find_spec(module), f"no {module}")(test)
    setattr(Documentation, f"test_{name}", test)


for page in pages.page_names():
    if page != BENCHMARKS:
        add_page(page)


if __name__ == "__main__":
    unittest.main()
