# SPDX-License-Identifier: GPL-3.0-or-later
"""What --help says that there is: the manual and the completion are held against it."""

import re

from test_cli import DONE, stickslip


class Command:
    """A command as --help shows it; its subcommands are read when asked for."""

    def __init__(self, *words):
        self.words = words
        code, self.help, err = stickslip(*words, "--help")
        assert (code, err) == (DONE, ""), (words, err)
        self.name = " ".join(("stickslip", *words))

    def section(self, heading):
        """Pairs of what stands on the left and on the right."""
        found = re.search(rf"^{heading}:\n((?:  .*\n)+)", self.help, re.M)
        text = re.sub(r"\n {20,}", "   ", found[1]) if found else ""
        return [tuple(re.split(r"\s{2,}", line.strip(), maxsplit=1)) for line in text.splitlines()]

    def options(self):
        """(names, the rest of the left, description) of each."""
        for left, description in self.section("Options"):
            names, _, rest = left.partition(" ")
            yield names.split(","), rest, description

    def option_names(self):
        return {name for names, _, _ in self.options() for name in names}

    def subcommands(self):
        return [Command(*self.words, name) for name, _ in self.section("Subcommands")]

    def examples(self):
        """The command lines below "Examples:"."""
        return re.findall(r"^ +\$ (stickslip.*)", self.help, re.M)


def all_commands(command=None):
    command = command or Command()
    yield command
    for subcommand in command.subcommands():
        yield from all_commands(subcommand)
