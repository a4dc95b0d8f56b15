#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks certificate/python/check.py many questions in one process.

  batch.py QUESTIONS REPLIES   answers a JSON Lines file, line by line
  batch.py --clear FOLDER      makes the folder, and empties it of *.jsonl
  batch.py --spool FOLDER      answers all *.jsonl in it; fails unless each answer is as expected

If the environment variable STICKSLIP_PROVED names stickslip-proved, it goes through the spool too.

A question is {"grasp": TEXT, "certificate": TEXT, "options": [WORD, ...]}, in a spool with
"expected": RESULT. Each character of a TEXT stands for the byte of its number, as files under test
need not be UTF-8. An answer is what `check.py --json` prints.

If the environment variable STICKSLIP_NODE names node, certificate/js/check.js goes through the spool, too. It is not asked about
statics, which it does not judge.
"""

import atexit
import concurrent.futures
import functools
import json
import os
import subprocess
import sys
import tempfile
import traceback

PROVED = os.environ.get("STICKSLIP_PROVED")
ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
NODE = os.environ.get("STICKSLIP_NODE")
sys.path.insert(0, os.path.join(ROOT, "certificate", "python"))

import check  # noqa: E402


class Asker:
    """Writes the texts of a question to files of a folder and has check.py read them."""

    def __init__(self, folder):
        self.paths = [os.path.join(folder, name) for name in ("grasp.json", "certificate.json")]
        self.parsed = {}

    def options(self, words):
        if words not in self.parsed:
            self.parsed[words] = check.parse_arguments([*self.paths, *words])
        return self.parsed[words]

    def answer(self, question):
        return self.judged(question)[0]

    def judged(self, question):
        """The report, the text that is printed, and the exit code."""
        for path, key in zip(self.paths, ("grasp", "certificate")):
            # Overwritten, not made anew: some file systems flush files that were cut to nothing.
            with open(path, "r+b" if os.path.exists(path) else "wb") as file:
                file.write(question[key].encode("latin-1"))
                file.truncate()
        try:
            return check.answer(self.options(tuple(question["options"])))
        except Exception:  # pylint: disable=broad-except
            # What check.py would report as an internal error, or wrong usage, is no answer.
            return {"result": "failed", "rule": None, "node": None, "path": None,
                    "found": traceback.format_exc()}, "", 2


def question_of(grasp, certificate, options):
    """Of the bytes of the two files."""
    return {"grasp": grasp.decode("latin-1"), "certificate": certificate.decode("latin-1"), "options": [str(word) for word in options]}


@functools.lru_cache(maxsize=None)
def batch_process(*program):
    """A checker in one process for all questions."""
    process = subprocess.Popen([*program, "--batch"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="ascii")
    atexit.register(lambda: (process.stdin.close(), process.stdout.close(), process.wait()))
    return process


def in_batch(program, question):
    """The report of a checker that answers line by line."""
    process = batch_process(*program)
    process.stdin.write(json.dumps(question) + "\n")
    process.stdin.flush()
    return json.loads(process.stdout.readline())


def spool_files(folder):
    return sorted(os.path.join(folder, name) for name in os.listdir(folder)
                  if name.endswith(".jsonl"))


def clear(folder):
    os.makedirs(folder, exist_ok=True)
    for path in spool_files(folder):
        os.remove(path)
    return 0


def check_js(lines):
    """The number of questions that check.js answers in another way than expected."""
    program = os.path.join(ROOT, "certificate", "js", "check_node.js")
    done = subprocess.run([NODE, program, "--batch"], input="".join(lines), capture_output=True,
                          text=True, check=True)
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(answers) == len(lines)
    wrong = [(answer, line) for answer, line in zip(answers, lines)
             if answer["result"] != json.loads(line)["expected"]]
    for answer, line in wrong:
        print(f"check.js: {json.dumps(answer)}\n{line}")
    print(f"check.js: {len(lines)} certificates, {len(wrong)} not answered as expected")
    return len(wrong)


def check_proved(lines):
    """The number of questions that stickslip-proved answers in another way than expected."""
    done = subprocess.run([PROVED, "--batch"], input="".join(lines), capture_output=True, text=True,
                          check=True)
    answers = [json.loads(line)["result"] for line in done.stdout.splitlines()]
    assert len(answers) == len(lines)
    wrong = [(answer, line) for answer, line in zip(answers, lines) if answer != json.loads(line)["expected"]]
    for answer, line in wrong:
        print(f"stickslip-proved: {answer}\n{line}")
    print(f"stickslip-proved: {len(lines)} certificates, {len(wrong)} not answered as expected")
    return len(wrong)


def is_about(word, line):
    """Of statics check.js knows nothing, of robustness stickslip-proved neither."""
    question = json.loads(line)
    return f'"{word}"' in question["certificate"] or any(option.startswith("--" + word) for option in question["options"])


def check_spool(folder, asker):
    """The programs go through it beside check.py: this is the last test, and other cores have nothing to do."""
    count = failures = 0
    lines = {}  # in order, each once
    for path in spool_files(folder):
        with open(path, encoding="ascii") as file:
            for line in file:
                count += 1
                lines[line] = None
    judged = [line for line in lines if not is_about("robustness", line)]
    with concurrent.futures.ThreadPoolExecutor() as pool:
        others = [pool.submit(check_js, [line for line in judged if not is_about("statics", line)])] if NODE else []
        others += [pool.submit(check_proved, judged)] if PROVED else []
        for line in lines:
            question = json.loads(line)
            answer = asker.answer(question)
            if answer["result"] != question["expected"]:
                failures += 1
                print(f"expected {question['expected']}, answered {json.dumps(answer)}\n"
                      f"{question['options']}\n{question['grasp']}\n{question['certificate']}")
        print(f"check.py: {count} certificates ({len(lines)} different), {failures} not answered as expected")
        failures += sum(other.result() for other in others)
    if count == 0:
        print("Nothing to check: run the tests that fill the folder (all of ctest) first.")
    return 1 if failures or not count else 0


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    if arguments[0] == "--clear":
        return clear(arguments[1])
    if hasattr(sys, "set_int_max_str_digits"):  # as check.main does
        sys.set_int_max_str_digits(0)
    with tempfile.TemporaryDirectory() as folder:
        asker = Asker(folder)
        if arguments[0] == "--spool":
            return check_spool(arguments[1], asker)
        with open(arguments[0], encoding="ascii") as questions, \
                open(arguments[1], "w", encoding="ascii") as replies:
            for line in questions:
                replies.write(json.dumps(asker.answer(json.loads(line))) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
