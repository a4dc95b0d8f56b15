# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of ``python3 -m stickslip.batch``: grasps cut into chunks, results in whole lines, and the
signals that must not come in the middle of one."""

from __future__ import annotations

import itertools
import os
import signal
import stat
import sys
import zlib
from typing import Any, BinaryIO, Iterator, NoReturn, Optional

from . import batch_chunk
from .batch_chunk import Chunk
from .errors import InputError


def cannot_write(path: str, error: OSError) -> InputError:
    return InputError(path, "", f"the file cannot be written: {error.strerror}",
                      "make room there, or name another file, and go on with --resume")


class Interrupted(BaseException):
    """By a signal."""


class Interruption:
    """From now on SIGINT, SIGTERM and SIGHUP raise Interrupted, but not within `with`."""

    SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

    def __init__(self) -> None:
        self.number: Optional[int] = None
        self._held = False
        for number in self.SIGNALS:
            if signal.getsignal(number) != signal.SIG_IGN:  # nohup
                signal.signal(number, self._come)

    def _come(self, number: int, _frame: Any) -> None:
        first = self.number is None
        self.number = self.number or number
        if first and not self._held:
            raise Interrupted

    def __enter__(self) -> None:
        self._held = True

    def __exit__(self, *_error: object) -> None:
        self._held = False
        if self.number is not None:
            raise Interrupted

    def is_over(self) -> None:
        """There is nothing left to interrupt: no signal raises from now on."""
        self._held = True

    def end(self) -> NoReturn:
        """By the same signal, so that whoever has started this knows."""
        assert self.number is not None
        sys.stdout.flush()
        sys.stderr.flush()
        signal.signal(self.number, signal.SIG_DFL)
        os.kill(os.getpid(), self.number)
        os._exit(1)  # not reached


class Output:
    """The results, whole lines at every moment that a signal or an error can choose."""

    def __init__(self, path: str, interruption: Interruption) -> None:
        self.name = "<stdout>" if path == "-" else path
        self._interruption = interruption
        try:
            self._file = 1 if path == "-" else os.open(
                path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o666)
            self._regular = stat.S_ISREG(os.fstat(self._file).st_mode)
        except OSError as error:
            raise cannot_write(self.name, error) from None

    def cut(self, length: int) -> None:
        """What an interruption left unfinished goes."""
        try:
            os.ftruncate(self._file, length)
        except OSError as error:
            raise cannot_write(self.name, error) from None

    def write(self, text: bytes) -> None:
        """Within the interruption, with what counts the results."""
        before = os.fstat(self._file).st_size
        rest = memoryview(text)
        try:
            while rest:
                rest = rest[os.write(self._file, rest):]
        except BrokenPipeError:  # as of `| head`, which has what it wants
            self._interruption.number = signal.SIGPIPE
        except OSError as error:
            if self._regular:
                os.ftruncate(self._file, before + text.rfind(b"\n", 0, len(text) - len(rest)) + 1)
            raise cannot_write(self.name, error) from None


class Cutter:
    """Cuts the file into chunks, each where a line ends."""

    def __init__(self, file: BinaryIO, begin: int, lines_before: int) -> None:
        self._file = file
        self.begin = begin
        self.lines_before = lines_before

    def cut(self, size: int) -> Optional[Chunk]:
        """The next lines, of so many bytes and up to the end of the last line; None at the end."""
        end, lines, checksum, ends_line = self.begin, 0, 0, True
        for block in itertools.chain(
                batch_chunk.blocks(self._file, self.begin, self.begin + size), self._rest_of_line()):
            end += len(block)
            lines += block.count(b"\n")
            checksum = zlib.crc32(block, checksum)
            ends_line = block.endswith(b"\n")
            if ends_line and end >= self.begin + size:
                break
        if end == self.begin:
            return None
        chunk = Chunk(self.begin, end, self.lines_before, checksum)
        self.begin, self.lines_before = end, self.lines_before + lines + (not ends_line)
        return chunk

    def _rest_of_line(self) -> Iterator[bytes]:
        while True:
            block = self._file.readline(batch_chunk.BLOCK)
            if not block:
                return
            yield block
