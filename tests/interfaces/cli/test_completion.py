# SPDX-License-Identifier: GPL-3.0-or-later
"""What shells complete: all that --help says, in the shells themselves."""

import os
import re
import shutil
import unittest

from commands import all_commands
from terminal import Terminal
from test_cli import CHECK, DONE, HERE, STICKSLIP, Case, read, run, stickslip

BY_HAND = os.path.join(HERE, "..", "..", "..", "certificate", "cpp", "completion")
SCRIPTS = {"bash": "stickslip", "zsh": "_stickslip", "fish": "stickslip.fish"}
FILES = ("my grasp.json", "other's.json")


def choices(rest):
    found = re.search(r"\{(.*)\}", rest)
    return set(found[1].split(",")) if found else set()


class Shell(Case):
    name = ""

    def setUp(self):
        super().setUp()
        if shutil.which(self.name) is None:
            self.skipTest(f"no {self.name}")
        for file in FILES:
            self.write(file, "")
        os.mkdir(self.path("sub folder"))
        os.mkdir(self.path("scripts"))
        self.script = self.path(f"scripts/{SCRIPTS[self.name]}")
        self.assertEqual(stickslip("completion", self.name, "-o", self.script), (DONE, "", ""))
        self.by_hand = os.path.join(BY_HAND, SCRIPTS[self.name].replace("stickslip", "stickslip-check"))
        path = os.pathsep.join((os.path.dirname(STICKSLIP), os.environ["PATH"]))
        self.environment = {"PATH": path, "HOME": self.folder, "LC_ALL": "C.UTF-8"}

    def values(self):
        """(words before it, its choices) of each option and argument that has some."""
        for command in all_commands():
            for names, rest, _ in command.options():
                if choices(rest):
                    yield [*command.words, names[-1]], choices(rest)
            for left, _ in command.section("Positionals"):
                if choices(left):
                    yield list(command.words), choices(left)

    def parses(self, *check):
        for script in (self.script, self.by_hand):
            self.assertEqual(run(*check, script), (0, "", ""))

    def terminal(self, *words):
        terminal = Terminal(words, self.environment, self.folder)
        self.addCleanup(terminal.close)
        return terminal

    KEYS = (("stickslip dec\t", "stickslip decide "),
            ("stickslip plot gr\t", "stickslip plot grasp "),
            ("stickslip decide --exi\t", "stickslip decide --exit-code "),
            ("stickslip completion fi\t", "stickslip completion fish "),
            ("stickslip decide --engine st\t", "stickslip decide --engine states "),
            ("stickslip decide --engine=st\t", "stickslip decide --engine=states "),
            ("stickslip decide --engine states --normal-law b\t",
             "stickslip decide --engine states --normal-law bilateral "),
            ("stickslip plot region --u 1,0,0 --normal-law=b\t",
             "stickslip plot region --u 1,0,0 --normal-law=bilateral "),
            ("stickslip decide my\t", "stickslip decide my\\ grasp.json "),
            ("stickslip decide --engine states my\t",
             "stickslip decide --engine states my\\ grasp.json "),
            ("stickslip decide \"my\t", "stickslip decide \"my grasp.json\" "),
            ("stickslip decide --certificate my\t", "stickslip decide --certificate my\\ grasp.json "),
            ("stickslip export -o my\t", "stickslip export -o my\\ grasp.json "),
            ("stickslip batch --certificates su\t", "stickslip batch --certificates sub\\ folder/"),
            ("stickslip batch --certificates my\t", "stickslip batch --certificates my"),
            ("stickslip decide --preload my\t", "stickslip decide --preload my"),
            ("stickslip my\t", "stickslip my"),
            ("stickslip-check --dir\t", "stickslip-check --direction"),
            ("stickslip-check --normal-law=b\t", "stickslip-check --normal-law=bilateral "),
            ("stickslip-check --preload 1 my\t", "stickslip-check --preload 1 my\\ grasp.json "))

    def press_keys(self, *shell):
        terminal = self.terminal(*shell)
        for keys, line in self.KEYS:
            found = terminal.typed(keys)
            # What ends a word ("", " ", "=" or "/") is each shell's own way.
            self.assertEqual(found.rstrip(" =/"), line.rstrip(" =/"), keys)
        for trouble in ("not found", "error", f"{self.name}:", "unbound"):
            self.assertNotIn(trouble, terminal.screen.decode())


class Bash(Shell):
    name = "bash"

    def replies(self, *words, script=None, function="_stickslip"):
        """What is offered for the last word; ["default"] stands for readline's file names."""
        program = r"""set -u
compopt() { COMPREPLY+=("$2"); }  # keeps it in mind: the true one only works below readline
source "$1" || exit 1
function=$2
shift 2
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
"$function" "$1" "${!#}" "${COMP_WORDS[COMP_CWORD - 1]}"
(( ${#COMPREPLY[@]} == 0 )) || printf '%s\n' "${COMPREPLY[@]}"
"""
        environment = [f"{k}={v}" for k, v in self.environment.items()]
        code, out, err = run("env", "-i", *environment, "bash", "--norc", "-c", program, "bash",
                             script or self.script, function, *words)
        self.assertEqual((code, err), (0, ""), words)
        return out.splitlines()

    def test_it_parses(self):
        self.parses("bash", "-n")

    def test_everything_in_the_help(self):
        for command in all_commands():
            words = ("stickslip", *command.words)
            self.assertEqual(set(self.replies(*words, "-")), command.option_names())
            subcommands = [name for name, _ in command.section("Subcommands")]
            if subcommands:
                self.assertEqual(self.replies(*words, ""), subcommands)
            elif "FILE" in command.section("Positionals")[0][0]:
                self.assertEqual(self.replies(*words, ""), ["default"])
                self.assertEqual(set(self.replies(*words, "g.json", "")), command.option_names())
            for names, rest, _ in command.options():
                value = re.match(r"[A-Z,]*(?![a-z:])", rest.replace("REQUIRED", ""))[0]
                kinds = {"FILE": {"default"}, "DIR": {"dirnames"},
                         "": set(self.replies(*words, ""))}  # after a flag, as without it
                for name in names:
                    self.assertEqual(set(self.replies(*words, name, "")),
                                     choices(rest) or kinds.get(value, set()), (words, name))

    def test_choices(self):
        found = 0
        for words, expected in self.values():
            found += 1
            first = min(expected)
            self.assertEqual(self.replies("stickslip", *words, first), [first])
            if words[-1].startswith("--"):
                for split in ((words[-1], "="), (words[-1], "=", "")):
                    self.assertEqual(set(self.replies("stickslip", *words[:-1], *split)), expected)
                self.assertEqual(self.replies("stickslip", *words[:-1], f"{words[-1]}={first}"),
                                 [f"{words[-1]}={first}"])
        self.assertGreater(found, 5)

    def test_values_are_no_commands(self):
        self.assertEqual(self.replies("stickslip", "decide", "--engine", "states", "--engine", "b"),
                         ["branch-and-bound"])
        self.assertEqual(self.replies("stickslip", "decide", "--engine", "=", "states", "--engine",
                                      "b"), ["branch-and-bound"])
        self.assertEqual(self.replies("stickslip", "decide", "states", "--engine", "b"), ["branch-and-bound"])
        self.assertEqual(self.replies("stickslip", "margin", "--wrench", "-1,0,0", "-", "--dir"),
                         ["--direction"])

    def test_the_checker(self):
        text = run(CHECK, "--help")[1]
        names = set(re.findall(r"^  (?:-h, )?(--[a-z-]+)", text, re.M)) | {"-h"}
        found = self.replies("stickslip-check", "-", script=self.by_hand, function="_stickslip_check")
        self.assertEqual(set(found), names)
        for script in ("_stickslip-check", "stickslip-check.fish"):
            text = read(os.path.join(BY_HAND, script))
            listed = re.findall(r"-l ([a-z-]+)" if "fish" in script else r"'(?:\(.*?\))?--([a-z-]+)",
                                text)
            self.assertEqual({f"--{name}" for name in listed}, names - {"-h"})

    def test_at_a_terminal(self):
        rc = self.write("rc", f"""PS1='ready>'
set -u
bind 'set enable-bracketed-paste off'
bind 'set bell-style none'
source "$HOME/scripts/stickslip"
source '{self.by_hand}'
dump() {{ printf '%s\\n' "$READLINE_LINE" >>"$LINES_TYPED"; READLINE_LINE=; }}
bind -x '"\\C-x\\C-t": dump'
""")
        self.press_keys("bash", "--noprofile", "--rcfile", rc, "-i")


class Zsh(Shell):
    name = "zsh"

    RC = """PS1='ready>'
setopt no_beep
fpath=($HOME/scripts $fpath)
autoload -Uz compinit && compinit -u -D
dump() { print -r -- "$BUFFER" >>$LINES_TYPED; BUFFER= }
zle -N dump
bindkey -e
bindkey '^X^T' dump
"""

    def test_it_parses(self):
        self.parses("zsh", "-n")

    def press(self, rc):
        shutil.copy(self.by_hand, self.path("scripts"))
        self.write(".zshrc", rc)
        self.press_keys("zsh", "-d", "-i")

    def test_at_a_terminal(self):
        self.press(self.RC)

    def test_at_a_terminal_sourced(self):
        os.rename(self.script, self.path("sourced"))
        self.press(self.RC + "source $HOME/sourced\n")


class Fish(Shell):
    name = "fish"

    def completed(self, line):
        """What is offered, without the descriptions."""
        code, out, err = run("env", "-i", *(f"{k}={v}" for k, v in self.environment.items()), "fish",
                             "-N", "-c", f"cd '{self.folder}'; source '{self.script}'; "
                             f"source '{self.by_hand}'; complete -C \"{line}\"")
        self.assertEqual((code, err), (0, ""), line)
        return [found.split("\t")[0] for found in out.splitlines()]

    def test_it_parses(self):
        self.parses("fish", "-N", "-n")

    def test_everything_in_the_help(self):
        for command in all_commands():
            self.assertEqual({name for name in self.completed(command.name + " -")},
                             command.option_names(), command.name)
            subcommands = [name for name, _ in command.section("Subcommands")]
            if subcommands:
                self.assertEqual(self.completed(command.name + " "), sorted(subcommands))

    def test_choices(self):
        for words, expected in self.values():
            line = " ".join(["stickslip", *words])
            self.assertEqual(set(self.completed(line + " ")), expected)
            if words[-1].startswith("--"):
                self.assertEqual(set(self.completed(line + "=")),
                                 {f"{words[-1]}={choice}" for choice in expected})

    def test_words_and_files(self):
        for line, expected in (
                ("stickslip de", ["decide"]), ("stickslip plot gr", ["grasp"]),
                ("stickslip decide --engine states --engine b", ["branch-and-bound"]),
                ("stickslip decide states --normal-law b", ["bilateral"]),
                ("stickslip decide my", ["my grasp.json"]),
                ("stickslip decide --certificate my", ["my grasp.json"]),
                ("stickslip decide --certificate=my", ["--certificate=my grasp.json"]),
                ("stickslip export -o my", ["my grasp.json"]),
                ("stickslip batch --certificates su", ["sub folder/"]),
                ("stickslip batch --certificates my", []), ("stickslip decide --preload my", []),
                ("stickslip my", []), ("stickslip-check --normal-law b", ["bilateral"]),
                ("stickslip-check --preload 1 my", ["my grasp.json"])):
            self.assertEqual(self.completed(line), expected, line)


class Command(Case):
    def test_usage(self):
        self.fails("completion")
        self.fails("completion", "tcsh", naming=["bash"])
        for shell in SCRIPTS:
            code, out, err = stickslip("completion", shell)
            self.assertEqual((code, err), (DONE, ""))
            self.assertEqual(out, stickslip("completion", shell)[1])

    def test_the_command_that_the_scripts_call(self):
        self.assertNotIn("complete", [words for c in all_commands() for words in c.words])
        code, out, err = stickslip("complete", "--", "plot", "")
        self.assertEqual((code, err), (DONE, ""))
        self.assertIn("states\tThe slip states: the sphere of motions, cut by one great circle a contact\n",
                      out)
        for words, lines in (((), None), (("",), None), (("bogus", ""), None), (("decide", ""), "FILE\n"),
                             (("batch", "--certificates="), "DIR\n"), (("decide", "--bogus=a"), ""),
                             (("decide", "--normal-law=b"), "--normal-law=bilateral\t\n"),
                             (("decide", "--json=b"), ""), (("decide", "--preload", ""), ""),
                             (("plot", "--", "-1", "x"), ""), (("decide", "--help=", "--he"),
                             "--help\tPrint this help message and exit\n")):
            code, out, err = stickslip("complete", "--", *words)
            self.assertEqual((code, err), (DONE, ""), words)
            self.assertEqual(out, stickslip("complete", "--", "")[1] if lines is None else lines, words)


del Shell  # the cases of a shell, not of none

if __name__ == "__main__":
    unittest.main()
