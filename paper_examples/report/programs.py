# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the project's programs in the report's folder, so that a reader can repeat each command there."""

import json
import os
import shlex
import subprocess


class ProgramError(Exception):
    pass


def interval_text(intervals):
    """[["0", "1"], ["3", None]] as "[0, 1], [3, oo)"."""
    return ", ".join(f"[{low}, oo)" if high is None else f"[{low}, {high}]"
                     for low, high in intervals)


class Programs:
    def __init__(self, binaries, folder):
        self._binaries, self.folder = os.path.abspath(binaries), folder
        self._commands = []

    def run(self, program, *words, codes=(0,)):
        """Its standard output. Exit codes other than `codes` are errors of the report itself."""
        command = shlex.join((program, *words))
        self._commands.append(command)
        try:
            result = subprocess.run([os.path.join(self._binaries, program), *words], cwd=self.folder,
                                    capture_output=True, text=True, check=False)
        except OSError as error:
            raise ProgramError(f"{command}: {error}") from error
        if result.returncode not in codes:
            raise ProgramError(f"{command}: exit code {result.returncode}\n{result.stderr}")
        return result.stdout

    def json(self, *words):
        return json.loads(self.run("stickslip", *words, "--json"))

    def take_commands(self):
        commands, self._commands = self._commands, []
        return commands

    def keep_commands(self, commands):
        self._commands = commands

    def path(self, name):
        return os.path.join(self.folder, name)

    def _proved(self, command, grasp, option, value, preload):
        """The answer, its proof, and what stickslip-check says of it: a dictionary, empty if rejected."""
        name = os.path.basename(grasp).removesuffix(".json")
        proof = f"proofs/{name}_{command}_{value}_P_{preload}.json"
        question = (option, value, "--preload", preload)
        answer = self.json(command, grasp, *question, "--certificate", proof)
        text = self.run("stickslip-check", grasp, proof, *question, "--json", codes=(0, 1))
        checked = json.loads(text)
        return answer, proof, checked if checked["result"] == "accepted" else {}

    def verdict(self, grasp, wrench, preload):
        """The verdict that is proved, and its proof."""
        answer, proof, checked = self._proved("decide", grasp, "--wrench", wrench, preload)
        proved = checked.get("verdict") == answer["verdict"]
        return answer["verdict"] if proved else "proof rejected", proof

    def proved_margin(self, grasp, direction, preload):
        """The resisted multiples that are proved, and their proof."""
        answer, proof, checked = self._proved("margin", grasp, "--direction", direction, preload)
        proved = checked.get("resisted") == answer["resisted"]
        return interval_text(answer["resisted"]) if proved else "proof rejected", proof

    def method(self, name, grasp, wrench, preload, *options):
        """What `stickslip compare` says of one method: its entry."""
        found = self.json("compare", grasp, "--wrench", wrench, "--preload", preload, *options)
        entry, = (method for method in found["methods"] if method["method"] == name)
        return entry

    def margin(self, grasp, direction, preload):
        """The resisted multiples of a direction."""
        found = self.json("margin", grasp, "--direction", direction, "--preload", preload)
        return interval_text(found["resisted"])
