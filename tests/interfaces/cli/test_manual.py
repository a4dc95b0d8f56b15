# SPDX-License-Identifier: GPL-3.0-or-later
"""Each command has a page of the manual, made by help2man, that names its options and is well formed."""

import os
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

from commands import all_commands
from test_cli import CHECK, DONE, FIG1, HERE, STICKSLIP, Case, read, run, stickslip

MANUAL = os.path.join(HERE, "..", "..", "..", "interfaces", "cli", "manual.sh")
CHECKER_PAGE = os.path.join(HERE, "..", "..", "..", "certificate", "cpp", "stickslip-check.1")
OPTION = r"(?<![\w-])--?[a-z][a-z0-9-]*"


def plain(page):
    """A page's source without its markup; blanks are not told apart."""
    text = re.sub(r"\\f[BIR]|\\&|\\,|\\/", "", page)
    for escape, character in ((r"\-", "-"), (r"\(lq", '"'), (r"\(rq", '"'), ("\\ ", " "), (r"\e", "\\")):
        text = text.replace(escape, character)
    return " ".join(text.split())


def section(page, heading):
    found = re.search(rf"^\.SH {heading}\n(.*?)(?=^\.SH |\Z)", page, re.M | re.S)
    return found[1] if found else ""


def documented_options(page):
    """The names on the lines that begin the entries of OPTIONS."""
    heads = re.findall(r"^\.TP\n(.*)", section(page, "OPTIONS"), re.M)
    return {name for head in heads for name in re.findall(OPTION, plain(head))}


@unittest.skipIf(shutil.which("help2man") is None, "no help2man (Debian: help2man)")
class Manual(Case):
    @classmethod
    def setUpClass(cls):
        """The pages are made once for all tests."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        assert run(MANUAL, STICKSLIP, folder.name) == (DONE, "", "")
        cls.paths = {name: os.path.join(folder.name, name) for name in os.listdir(folder.name)}
        cls.pages = {name: read(path) for name, path in cls.paths.items()}
        cls.commands = list(all_commands())

    def test_a_page_for_each_command_names_its_options(self):
        self.assertGreater(len(self.commands), 10)
        self.assertEqual(len(self.pages), len(self.commands))
        for command in self.commands:
            name = command.name.replace(" ", "-")
            page = self.pages[name + ".1"]
            self.assertEqual(plain(section(page, "NAME")), f"{name} - {command.help.splitlines()[0]}")
            self.assertTrue(plain(section(page, "SYNOPSIS")).startswith(".B stickslip"))
            self.assertEqual(documented_options(page), command.option_names(), name)
            self.assertIn(command.examples()[0], plain(section(page, "EXAMPLES")))
            self.assertTrue(command.examples()[0].startswith(command.name), name)
            self.assertIn("stickslip-check (1)", plain(section(page, '"SEE ALSO"')))
            self.assertIn(stickslip("--version")[1].strip(), page)

    def test_the_examples_work(self):
        crosscheck = next(c.help for c in self.commands if c.words == ("crosscheck",))
        claim = re.search(r'^ *\{"grasp".*?\}\}$', crosscheck, re.M | re.S)[0]  # shown broken
        environment = {**os.environ, "PATH": os.pathsep.join(
            (os.path.dirname(STICKSLIP), os.path.dirname(CHECK), os.environ["PATH"]))}
        examples = [example for command in self.commands for example in command.examples()]
        examples += [line for line in section(read(CHECKER_PAGE), "EXAMPLES").replace("\\-", "-")
                     .splitlines() if line.startswith("stickslip")]
        for name in ("fig1.json", "grasp.json"):
            shutil.copy(FIG1, self.path(name))
        self.write("grasps.jsonl", read(FIG1).replace("\n", " ") + "\n")
        self.write("claims.jsonl", claim.replace("\n", " ") + "\n")
        for example in examples:
            if example.startswith("stickslip serve"):
                self.serves(example, environment)
                continue
            result = subprocess.run(["bash", "-c", example], cwd=self.folder, env=environment,
                                    capture_output=True, text=True, check=False, timeout=300)
            self.assertEqual((result.returncode, result.stderr), (DONE, ""), example)

    def serves(self, example, environment):
        """It goes on until it is told to end."""
        with subprocess.Popen(example.split(), cwd=self.folder, env=environment, stdout=subprocess.PIPE, text=True,
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as server:
            self.assertIn("http://127.0.0.1:", server.stdout.readline())
            server.send_signal(signal.SIGINT)
            self.assertEqual(server.wait(timeout=300), DONE)

    def lint(self, *tool):
        if shutil.which(tool[0]) is None:
            self.skipTest(f"no {tool[0]} (Debian: mandoc, man-db)")
        for page in [*self.paths.values(), CHECKER_PAGE]:
            code, out, err = run(*tool, page)
            self.assertEqual((code, err), (0, ""), page)
            yield out

    def test_mandoc_has_no_warning(self):
        self.assertEqual(set(self.lint("mandoc", "-T", "lint", "-W", "warning")), {""})
        bad = self.write("bad.1", self.pages["stickslip.1"].replace(".SH NAME", ".XX"))
        self.assertNotEqual(run("mandoc", "-T", "lint", "-W", "warning", bad)[0], 0)

    def test_man_has_no_warning(self):
        self.assertTrue(all(self.lint("man", "--warnings", "-E", "ascii", "-l")))
        bad = self.write("bad.1", self.pages["stickslip.1"].replace(".SH NAME", ".XX"))
        self.assertNotEqual(run("man", "--warnings", "-E", "ascii", "-l", bad)[2], "")


class CheckersPage(unittest.TestCase):
    def test_options_are_those_of_the_help(self):
        page = read(CHECKER_PAGE)
        code, text, err = run(CHECK, "--help")
        self.assertEqual((code, err), (0, ""))
        described = {name for line in re.findall(r"^  (-.*?)(?:  |\n)", text, re.M)
                     for name in re.findall(OPTION, line)}
        self.assertIn("--preload-direction", described)
        self.assertEqual(documented_options(page), described)
        self.assertLessEqual(described - {"-h"}, set(re.findall(OPTION, plain(section(page, "SYNOPSIS")))))


if __name__ == "__main__":
    unittest.main()
