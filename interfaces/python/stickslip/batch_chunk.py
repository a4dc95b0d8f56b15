# SPDX-License-Identifier: GPL-3.0-or-later
"""What a worker of ``python3 -m stickslip.batch`` does: a chunk of lines.

A chunk that has cost a worker its life is decided again *alone*: in a process of its own, a line at
a time, so that it is known which line ends the process, and nothing else is lost.
"""

from __future__ import annotations

import importlib
import os
import pickle
import signal
import socket
import subprocess
import sys
import threading
import time
import zlib
from typing import Any, BinaryIO, Iterator, NamedTuple, Optional, Tuple

from . import _core
from .errors import InputError

BLOCK = 1 << 20


class QualityAsked(NamedTuple):
    """What balls of loads are meant, as the command line spells it; empty where it says nothing."""

    length: str
    about: str
    body: str
    at_most: str
    accuracy: str


class StatesAsked(NamedTuple):
    """Which states are counted; 0 is as the command line has it."""

    modes: str
    lines: int
    snap: bool
    limit: int


class MeasuresAsked(NamedTuple):
    """Which methods of ``compare`` are asked, as the command line spells it; empty where it says nothing."""

    methods: Tuple[str, ...]
    length: str
    inertia: str
    max_force: str
    accuracy: str
    edges: int


class Asked(NamedTuple):
    """What is asked about each line, as the command line spells it; empty where it says nothing."""

    wrench: str
    case: str
    preload: str
    bilateral: bool
    node_limit: int
    asks_class: bool
    """Not the verdict."""
    inertia: str
    certificates: str
    """The folder, as results name it."""
    certificate_folder: str
    """The same folder, by its absolute path."""
    quality: Optional[QualityAsked] = None
    """Beside the verdict; not with a class."""
    states: Optional[StatesAsked] = None
    """In place of the verdict."""
    measures: Optional[MeasuresAsked] = None
    """In place of the verdict."""

    def decider(self) -> _core.LineDecider:
        return _core.LineDecider(*self)


class Chunk(NamedTuple):
    """The lines of a file that begin at its bytes from ``begin`` to before ``end``."""

    begin: int
    end: int
    lines_before: int
    checksum: int
    """Of these bytes."""


class Decided(NamedTuple):
    """What a worker answers. Errors are values: a worker would write a raised one to its log."""

    results: bytes
    tally: _core.BatchTally
    seconds: float
    error: Optional[Tuple[str, str, str, str]] = None
    """What ends the batch: the parts of an InputError."""
    out_of_memory: bool = False


class Tallied(NamedTuple):
    """The first lines of a chunk that is decided alone."""

    results: bytes
    tally: _core.BatchTally
    end: int
    """Where the next line begins."""
    lines: int
    """Of the file, up to there."""


def blocks(file: BinaryIO, begin: int, end: int) -> Iterator[bytes]:
    """The bytes of a part of a file."""
    file.seek(begin)
    while begin < end:
        block = file.read(min(BLOCK, end - begin))
        if not block:
            return
        begin += len(block)
        yield block


def line_end(file: BinaryIO, begin: int) -> int:
    """Where the line that begins there ends, its end included."""
    file.seek(begin)
    while True:
        block = file.readline(BLOCK)
        begin += len(block)
        if not block or block.endswith(b"\n"):
            return begin


def decide(asked: Asked, version: str, path: str, chunk: Chunk) -> Decided:
    """The results of a chunk, in its order."""
    return _decide(asked, version, path, chunk, None)


def decide_alone(asked: Asked, version: str, path: str, chunk: Chunk) -> Decided:
    """The same, whatever the lines do to the process that decides them."""
    return _decide(asked, version, path, chunk, _memory_limit())


def _decide(asked: Asked, version: str, path: str, chunk: Chunk,
            limit_alone: Optional[int]) -> Decided:
    start = time.monotonic()
    results, tally = b"", _core.BatchTally()
    try:
        _require_same(version, path, chunk)
        if limit_alone is None:
            results, tally = asked.decider().decide(path, *chunk[:3])
        else:
            results, tally = alone(asked, path, chunk, limit_alone)
    except InputError as error:
        return Decided(b"", tally, 0, (error.file, error.place, error.problem, error.remedy))
    except MemoryError:
        return Decided(b"", tally, 0, out_of_memory=True)
    return Decided(results, tally, time.monotonic() - start)


def _require_same(version: str, path: str, chunk: Chunk) -> None:
    """This worker has the same program and the same file as whoever asks."""
    here = "the worker on " + socket.gethostname()
    if version != _core.version:
        raise InputError("", "", f"{here} has stickslip {_core.version}, and not {version}",
                         "install the same on all machines")
    checksum, count = 0, 0
    try:
        with open(path, "rb") as file:
            for block in blocks(file, chunk.begin, chunk.end):
                checksum, count = zlib.crc32(block, checksum), count + len(block)
    except OSError as error:
        raise InputError(path, "", f"{here} cannot read the file: {error.strerror}",
                         "put it on a file system that all workers share") from None
    if (checksum, count) != (chunk.checksum, chunk.end - chunk.begin):
        raise InputError(path, f"bytes {chunk.begin} to {chunk.end}",
                         f"{here} reads another text than whoever has started this batch",
                         "put the file on a file system that all workers share, and let it be")


def alone(asked: Asked, path: str, chunk: Chunk, memory_limit: int) -> Tuple[bytes, _core.BatchTally]:
    """Results and their tally. The process may take so many bytes of memory; 0 is no limit."""
    results, tally = [], _core.BatchTally()
    begin, lines = chunk.begin, chunk.lines_before
    while begin < chunk.end:
        rest = Chunk(begin, chunk.end, lines, 0)
        with _start() as process:
            assert process.stdin is not None and process.stdout is not None
            started, end = False, None
            try:
                pickle.dump((asked, path, rest, memory_limit), process.stdin)
                process.stdin.flush()
                started = pickle.load(process.stdout) == "started"
                while end is None:
                    found = pickle.load(process.stdout)
                    if isinstance(found, Tallied):
                        results.append(found.results)
                        tally.add(found.tally)
                        begin, lines = found.end, found.lines
                    else:
                        end = found
            except (EOFError, OSError, pickle.UnpicklingError):
                end = "killed"
            process.stdin.close()
        if end == "done":
            return b"".join(results), tally
        if isinstance(end, InputError):
            raise end
        if not started:
            raise InputError("", "", "the process that was to decide a line alone did not start",
                             "see whether the worker's machine has processes and memory left")
        problem = _why(end, process.returncode, memory_limit)
        results.append(asked.decider().failed(path, begin, lines + 1, problem, REMEDY))
        tally.count_unreadable(lines + 1)
        with open(path, "rb") as file:
            begin, lines = line_end(file, begin), lines + 1
    return b"".join(results), tally


REMEDY = "decide it by itself, with more memory or with a node limit"


def _why(end: str, code: int, memory_limit: int) -> str:
    if end == "out of memory":
        limit = f", and {memory_limit >> 20} MiB are allowed" if memory_limit else ""
        return "the line needs more memory than there is" + limit
    if code < 0:
        return f"the process that decided the line was ended by {signal.Signals(-code).name}"
    return f"the process that decided the line ended with exit code {code}"


def _start() -> subprocess.Popen[bytes]:
    return subprocess.Popen([sys.executable, "-c", f"from {__name__} import main; main()"],
                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)


def _memory_limit() -> int:
    """Of this worker, in bytes; 0 if it has none."""
    distributed: Any = importlib.import_module("distributed")
    try:
        return int(distributed.get_worker().memory_manager.memory_limit or 0)
    except (ValueError, AttributeError):  # in no worker, or in a later Dask
        return 0


def main() -> None:
    """Decides a chunk in this process, which is there for nothing else."""
    out = sys.stdout.buffer

    def say(what: Any) -> None:
        pickle.dump(what, out)
        out.flush()

    asked, path, chunk, memory_limit = pickle.load(sys.stdin.buffer)
    threading.Thread(target=_end_with_the_worker, daemon=True).start()
    if memory_limit:
        _limit_memory(memory_limit)
    decider, begin, lines = asked.decider(), chunk.begin, chunk.lines_before
    say("started")
    try:
        with open(path, "rb") as file:
            while begin < chunk.end:
                end = line_end(file, begin)
                results, tally = decider.decide(path, begin, end, lines)
                begin, lines = end, lines + 1
                say(Tallied(results, tally, begin, lines))
        say("done")
    except InputError as error:
        say(error)
    except MemoryError:
        say("out of memory")


def _end_with_the_worker() -> None:
    """Ends this process when the one that holds the other end of its standard input is no more."""
    while os.read(0, BLOCK):
        pass
    os._exit(1)


def _limit_memory(more: int) -> None:
    """What is mapped already, libraries for the most part, does not count."""
    import resource
    with open("/proc/self/statm", encoding="ascii") as file:
        mapped = int(file.read().split()[0]) * resource.getpagesize()
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    limit = mapped + more if hard == resource.RLIM_INFINITY else min(mapped + more, hard)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def dask_setup(worker: Any) -> None:
    """Called by Dask in each worker of a local cluster: Ctrl-C is for the one who shows results."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
