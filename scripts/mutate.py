#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks a program on purpose, one small change at a time, and says which test notices.

  scripts/mutate.py FILE... --build 'ninja -C build box_test' --test 'build/tests/bin/box_test' [--test ...]

Each mutant is one change of one line: a comparison made strict or not strict, or turned; a sign turned; a condition
left out or turned; a smaller for a larger; 0 for 1; a call left out. A test catches a mutant if it fails, or takes
longer than --seconds; the first one that does is counted. The files are changed in place and are put back at the end,
so run it in a checkout of its own. What survives is either the same program, or shows that a test is missing.
"""

import argparse
import collections
import os
import random
import re
import signal
import subprocess
import sys
import time

# What is changed in which way; of C++ and JavaScript with operators between blanks, as clang-format writes them.
TOKENS = [
    ("comparison", r"(?<= )(<|<=|>|>=)(?= )", {"<": ["<=", ">"], "<=": ["<"], ">": [">=", "<"], ">=": [">"]}),
    ("equality", r"(?<= )([=!]==?)(?= )", {"==": ["!="], "!=": ["=="], "===": ["!=="], "!==": ["==="]}),
    ("sign", r"(?<= )([-+]=?)(?= )", {"+": ["-"], "-": ["+"], "+=": ["-="], "-=": ["+="]}),
    ("sign", r"(?<=[(\[ ])(-)(?=[a-z(])", {"-": [""]}),
    ("logic", r"(?<= )(&&|\|\||and|or)(?= )", {"&&": ["||"], "||": ["&&"], "and": ["or"], "or": ["and"]}),
    ("negation", r"(?<=[( ])(!|not )(?=[A-Za-z(])", {"!": [""], "not ": [""]}),
    ("constant", r"(?<![\w.])(true|false|True|False)(?!\w)",
     {"true": ["false"], "false": ["true"], "True": ["False"], "False": ["True"]}),
    ("number", r"(?<![\w.\-])([01])(?![\w.])", {"0": ["1"], "1": ["0", "2"]}),
    ("extreme", r"(?<![\w_])(min|max)(?=\()", {"min": ["max"], "max": ["min"]}),
]
MASKED = {
    ".py": r"#[^\n]*|\"\"\".*?\"\"\"|[rbf]*\"(?:\\.|[^\"\\\n])*\"|[rbf]*'(?:\\.|[^'\\\n])*'",
    "": r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`|#include[^\n]*",
}

Mutant = collections.namedtuple("Mutant", "path start end new kind line")


def masked(text, path):
    """The text with blanks for what no program runs: comments, and words between quotation marks."""
    pattern = MASKED.get(os.path.splitext(path)[1], MASKED[""])
    return re.sub(pattern, lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.S)


def closing(code, start):
    """Where the bracket at `start` closes."""
    depth = 0
    for i in range(start, len(code)):
        depth += (code[i] in "([{") - (code[i] in ")]}")
        if depth == 0:
            return i
    return -1


def mutants_of(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    code = masked(text, path)
    python = path.endswith(".py")

    def mutant(start, end, new, kind):
        return Mutant(path, start, end, new, kind, text.count("\n", 0, start) + 1)

    for kind, pattern, changes in TOKENS:
        for found in re.finditer(pattern, code):
            line = code[code.rfind("\n", 0, found.start()) + 1:found.start()]
            if kind == "comparison" and not python and re.match(r" *for \(", line):
                continue  # beyond the end of what is walked
            for new in changes[found[1]]:
                yield mutant(found.start(1), found.end(1), new, kind)
    if python:
        for found in re.finditer(r"(?m)^ +(?:el)?if ([^\n]+):$", code):
            yield mutant(*found.span(1), "False", "condition")
    else:
        for found in re.finditer(r"\bif (?:constexpr )?\(", code):
            end = closing(code, found.end() - 1)
            if "=" not in re.sub(r"[<>=!]=+", "", code[found.end():end]):  # nothing is declared there
                yield mutant(found.end(), end, "false", "condition")
    for found in re.finditer(r"(?m)^ +((?!return\b|throw\b|raise\b|yield\b)[A-Za-z_][\w.:]*(?:->\w+)?\([^\n]*\))" + ("$" if python else ";$"), code):
        yield mutant(*found.span(1), "pass" if python else "", "call")


def apply(mutant):
    with open(mutant.path, encoding="utf-8") as file:
        text = file.read()
    changed = text[:mutant.start] + mutant.new + text[mutant.end:]
    with open(mutant.path, "w", encoding="utf-8") as file:
        file.write(changed)
    line = mutant.line - 1
    return text, text.split("\n")[line].strip(), changed.split("\n")[line].strip()


def fails(command, seconds):
    """"fails", "hangs", or None; whatever it started is gone afterwards."""
    with subprocess.Popen(command, shell=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          stdin=subprocess.DEVNULL, start_new_session=True) as process:
        try:
            return "fails" if process.wait(seconds) else None
        except subprocess.TimeoutExpired:
            return "hangs"
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", metavar="FILE")
    parser.add_argument("--build", default="true", help="makes the program; a mutant that it fails for is no program")
    parser.add_argument("--test", action="append", required=True, help="a command; several are run in their order, the quickest best first")
    parser.add_argument("--count", type=int, default=100, help="how many mutants are drawn (100)")
    parser.add_argument("--seed", type=int, default=1, help="which ones (1)")
    parser.add_argument("--lines", help="FROM-TO: none of other lines")
    parser.add_argument("--seconds", type=float, default=300, help="that a test may take (300)")
    parser.add_argument("--list", action="store_true", help="says which mutants there would be, and runs none")
    options = parser.parse_args()

    mutants = [mutant for path in options.files for mutant in mutants_of(path)]
    if options.lines:
        first, last = map(int, options.lines.split("-"))
        mutants = [mutant for mutant in mutants if first <= mutant.line <= last]
    print(f"{len(mutants)} mutants of {len(options.files)} files, seed {options.seed}", flush=True)
    drawn = random.Random(options.seed).sample(mutants, min(options.count, len(mutants)))
    drawn.sort(key=lambda mutant: mutant[:2])  # of one file together: what is put back is compiled with what comes next
    if not options.list and (fails(options.build, None) or any(fails(test, None) for test in options.test)):
        sys.exit("a command fails before anything is changed")
    caught = collections.Counter()
    for mutant in drawn:
        began = time.monotonic()
        text, was, new = apply(mutant)
        by = "listed"
        try:
            if not options.list:
                by = "no program" if fails(options.build, None) else next(
                    (test for test in options.test if fails(test, options.seconds)), None)
        finally:
            with open(mutant.path, "w", encoding="utf-8") as file:
                file.write(text)
        caught[by or "SURVIVES"] += 1
        print(f"{mutant.path}:{mutant.line}: {mutant.kind}: {by or 'SURVIVES'} ({time.monotonic() - began:.0f} s)\n"
              f"  - {was}\n  + {new}", flush=True)
    fails(options.build, None)
    for how, times in caught.most_common():
        print(f"{times:5}  {how}")


if __name__ == "__main__":
    main()
