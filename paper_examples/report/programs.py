# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the project's programs in the report's folder, so that a reader can repeat each command there."""

import json
import os
import shlex
import subprocess


class ProgramError(Exception):
    pass


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

    def verdict(self, grasp, wrench, preload):
        """The verdict, and the same with a link to its proof, which stickslip-check must accept."""
        name = os.path.basename(grasp).removesuffix(".json")
        proof = f"proofs/{name}_w_{wrench.replace('/', ':')}_P_{preload}.json"
        question = ("--wrench", wrench, "--preload", preload)
        verdict = json.loads(self.run("stickslip", "decide", grasp, *question,
                                      "--certificate", proof, "--json"))["verdict"]
        checked = self.run("stickslip-check", grasp, proof, *question, codes=(0, 1)).split()
        if checked[:3] != ["accepted", "verdict", verdict]:
            return "proof rejected", None
        return verdict, f"{verdict} ([proof]({proof}))"

    def method(self, name, grasp, wrench, preload, *options):
        """What `stickslip compare` says of one method: its entry."""
        found = self.json("compare", grasp, "--wrench", wrench, "--preload", preload, *options)
        entry, = (method for method in found["methods"] if method["method"] == name)
        return entry

    def margin(self, grasp, direction, preload):
        """The resisted multiples of a direction, "[0, 1]" or "[0, oo)"."""
        found = self.json("margin", grasp, "--direction", direction, "--preload", preload)
        return ", ".join(f"[{low}, oo)" if high is None else f"[{low}, {high}]"
                         for low, high in found["resisted"])
