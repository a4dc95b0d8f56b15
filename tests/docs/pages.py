# SPDX-License-Identifier: GPL-3.0-or-later
"""The notation of the documentation's pages, and how their commands are run.

Code stands in fenced blocks, each marked by its kind. A `console` block holds command lines,
`$ command`, each followed by what it prints (standard output and error together). `...` stands for
what is left out: on a line of its own for any number of lines, within a line for any text. A
command with an exit status N other than 0 ends in ` # exit N`. It goes on after a backslash at the
end of a line, and through the end of a here document. The commands of a page run in their order, in
one shell, in a folder that has the repository's files under their names.
"""

import os
import re
import secrets
import shutil
import subprocess
import sys
from dataclasses import dataclass, field

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
COPIED = ("certificate", "examples", "paper_examples", "tests/corpus")

# Kinds of blocks that hold no shell commands. Those of Python are run by tests/interfaces/python.
OTHER_KINDS = ("text", "cmake", "cpp", "python")
# What begins a command; a block or a paragraph that has such a line must be a console block.
COMMAND = re.compile(r"\s*(\$ |(\S+=\S+ )*(\S*/)?"
                     r"(stickslip|stickslip-check|python3?|pip|cmake|ctest|apt-get|export|cd|cat|"
                     r"z3|cvc5|paper_tables|\w+\.sh)( |$))")


class PageError(Exception):
    """A page that does not keep to the notation: its text is the place and the reason."""


@dataclass
class Command:
    line: int
    text: str
    shown: list = field(default_factory=list)

    @property
    def status(self):
        found = re.search(r" # exit (\d+)$", self.text, re.MULTILINE)
        return int(found[1]) if found else 0

    def prints(self, output):
        """Is the output what the page shows?"""
        pattern = "".join(
            r"(?:.*\n)*" if line == "..." else
            ".*".join(re.escape(part) for part in line.split("...")) + r"\n"
            for line in self.shown)
        return re.fullmatch(pattern, output) is not None


def page_names():
    """All pages of the repository; relative names."""
    found = []
    for folder, folders, files in os.walk(ROOT):
        folders[:] = sorted(name for name in folders
                            if not name.startswith((".", "build")) and name != "node_modules")
        found += [os.path.relpath(os.path.join(folder, name), ROOT)
                  for name in files if name.endswith(".md")]
    return sorted(found)


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def blocks(text):
    """(kind, number of its first line, lines) of each fenced block, and the lines outside."""
    found, outside, kind, content = [], [], None, []
    for number, line in enumerate(text.splitlines(), 1):
        if not re.match(r"\s*(```|~~~)", line):
            (outside if kind is None else content).append((number, line))
        elif kind is None:
            kind, content = line, []
        else:
            if line != "```" or not re.fullmatch(r"```\w+", kind):
                raise PageError(f"line {number}: a block is to begin with ``` and its kind and to "
                                f"end with ```, both at the margin; found {kind!r} and {line!r}")
            found.append((kind[3:], number - len(content), [line for _, line in content]))
            kind = None
    if kind is not None:
        raise PageError("a block does not end")
    return found, outside


def commands_of_block(first, lines):
    """The commands of a console block whose first line has this number."""
    found, here, joined = [], None, False
    for number, line in enumerate(lines, first):
        if here is not None or joined:
            found[-1].text += "\n" + line
        elif line.startswith("$ "):
            found.append(Command(number, line[2:]))
        elif found:
            found[-1].shown.append(line)
            continue
        else:
            raise PageError(f"line {number}: a console block is to begin with '$ command'")
        begin = re.search(r"<<\s*'?(\w+)'?", line) if here is None else None
        here = begin[1] if begin else None if line == here else here
        joined = here is None and line.endswith("\\")
    if here is not None or joined:
        raise PageError(f"line {first}: the last command of the block does not end")
    return found


def commands(text):
    """All commands of a page. A command that stands anywhere but in a console block is an error."""
    fenced, outside = blocks(text)
    found = []
    for kind, first, lines in fenced:
        if kind == "console":
            found += commands_of_block(first, lines)
        elif kind not in OTHER_KINDS:
            raise PageError(f"line {first}: a block of unknown kind {kind!r}")
        elif kind == "python" and not lines[0].startswith(">>> "):
            raise PageError(f"line {first}: nothing runs a Python block that has no >>>")
        else:
            for number, line in enumerate(lines, first):
                if COMMAND.match(line):
                    raise PageError(f"line {number}: a command outside of a console block")
    for number, line in outside:
        if line.startswith("    ") and COMMAND.match(line):
            raise PageError(f"line {number}: a command outside of a console block")
    return found


def prepare(folder, programs, python_module=None):
    """Makes the folder what a reader has: the files of the repository and the built programs."""
    for name in COPIED:
        shutil.copytree(os.path.join(ROOT, name), os.path.join(folder, name),
                        ignore=shutil.ignore_patterns("__pycache__"))
    os.makedirs(os.path.join(folder, "build"))
    os.symlink(programs, os.path.join(folder, "build", "bin"))
    if python_module:
        os.symlink(python_module, os.path.join(folder, "build", "python"))


def run(page_commands, folder, tools):
    """(exit status, output) of each command; status None if the shell did not get that far.

    The folder `tools` is made, for a python3 that is this one.
    """
    os.makedirs(tools)
    os.symlink(sys.executable, os.path.join(tools, "python3"))
    environment = {**os.environ, "PATH": tools + os.pathsep + os.environ["PATH"],
                   "LC_ALL": "C.UTF-8", "PYTHONDONTWRITEBYTECODE": "1",
                   # So that the checker, which a page builds, is built soon: no type that CMake knows, so without any flags.
                   "CMAKE_BUILD_TYPE": "Quick", "CMAKE_BUILD_PARALLEL_LEVEL": "2"}
    if shutil.which("ccache"):
        environment.update(CMAKE_CXX_COMPILER_LAUNCHER="ccache", CCACHE_BASEDIR=folder,
                           CCACHE_NOHASHDIR="1")
    mark = secrets.token_hex(16)
    script = "".join(f"{command.text}\nprintf '\\n{mark} %d\\n' $?\n" for command in page_commands)
    # What a command starts and leaves running would keep the pipe open: a file cannot block.
    output_file = os.path.join(tools, "output")
    with open(output_file, "w", encoding="utf-8") as output:
        subprocess.run(["bash", "-c", script], cwd=folder, env=environment, check=False,
                       timeout=500, stdin=subprocess.DEVNULL, stdout=output,
                       stderr=subprocess.STDOUT)
    with open(output_file, encoding="utf-8") as output:
        pieces = re.split(rf"\n{mark} (\d+)\n", output.read())
    results = list(zip(map(int, pieces[1::2]), pieces[0::2]))
    return results + [(None, pieces[-1])] * (len(page_commands) - len(results))
