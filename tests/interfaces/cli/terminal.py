# SPDX-License-Identifier: GPL-3.0-or-later
"""An interactive shell on a terminal of its own, to press keys in."""

import os
import pty
import select
import shutil
import signal
import time

DUMP = b"\x18\x14"  # Ctrl-X Ctrl-T, to be bound to: append the line to $LINES_TYPED, and clear it
DEADLINE = 60  # of one answer, in seconds; only a shell that hangs reaches it


class Terminal:
    def __init__(self, words, environment, folder):
        """Starts the shell; its prompt must be "ready>"."""
        self.lines = os.path.join(folder, "lines_typed")
        with open(self.lines, "wb"):
            pass
        self.screen = b""
        environment = {**environment, "TERM": "dumb", "LINES_TYPED": self.lines}
        program = shutil.which(words[0])
        self.process, self.master = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execve(program, words, environment)
        self._wait(lambda: b"ready>" in self.screen)

    def _wait(self, condition):
        end = time.monotonic() + DEADLINE
        while not condition():
            if time.monotonic() > end:
                raise TimeoutError(self.screen.decode(errors="replace"))
            if select.select([self.master], [], [], 0.01)[0]:
                self.screen += os.read(self.master, 65536)

    def typed(self, keys):
        """The line after these keys."""
        before = self._lines()
        os.write(self.master, keys.encode() + DUMP)
        self._wait(lambda: len(self._lines()) > len(before))
        return self._lines()[-1]

    def _lines(self):
        with open(self.lines, encoding="utf-8") as file:
            return [line[:-1] for line in file if line.endswith("\n")]

    def close(self):
        os.kill(self.process, signal.SIGKILL)
        os.waitpid(self.process, 0)
        os.close(self.master)
