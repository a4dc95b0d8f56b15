# SPDX-License-Identifier: GPL-3.0-or-later
"""Decide many grasps on many machines: ``python3 -m stickslip.batch``, docs/batch.md.

What ``stickslip batch`` writes, byte for byte and in the same order, by the workers of a Dask
cluster. This process cuts the file of grasps into chunks, which the workers read for themselves, and
writes the results.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import itertools
import os
import queue
import re
import signal
import stat
import sys
import threading
import time
from typing import Any, BinaryIO, Dict, List, NoReturn, Optional, Tuple, Union

from . import _core, batch_chunk
from .arguments import as_time_limit
from .batch_chunk import Asked, Chunk, Decided, MeasuresAsked, QualityAsked, StatesAsked
from .batch_cluster import Cluster
from .batch_files import Cutter, Interrupted, Interruption, Output
from .errors import InputError

DONE, BAD_INPUT, UNDECIDED = 0, 2, 3

SECONDS_OF_A_CHUNK = 1.0
FIRST_BYTES = 4096
"""Of chunks of which nothing is known yet."""
MOST_BYTES = 1 << 26
"""Of a chunk that goes on to a line's end behind them."""
GROWTH = 4
"""Of one chunk to those after it, at most."""
CHUNKS_OF_A_THREAD = 2
"""One that it decides, and the next."""
MOST_BYTES_HELD = 1 << 28
"""Of results whose turn has not come."""
MOST_LINES = 64
"""Of slip of a contact."""
FETCHERS = 8
"""Threads: an answer of a worker that has just died is waited for, beside the others."""
SECONDS_WITHOUT_WORKERS = 3
"""Before that is said: one that has died may be started again."""
MOST_LOSSES = 10
"""Of a chunk by workers that die, where no line can be the cause."""

EPILOG = """\
Each line gives one line of JSON, the same byte for byte as by stickslip batch, and in the same
order: line, key (of the question), name and verdict, or the error that it has, and check. A line that
ends the process of whoever decides it, as for want of memory, has that as its error; the rest
goes on. Certificates are checked with the line as grasp file, that of a ball of loads with the
result's uncertain as --uncertain.

FILE and DIR must be on a file system that all workers share. Without --scheduler the workers
are processes of this machine. Memory does not grow with the file. When a worker dies, others
decide what it had; when the scheduler is started again within half a minute, the batch goes on.
After anything worse, and after Ctrl-C, FILE ends in a whole line, and the same command with
--resume goes on.

Exit codes: 0 done, 2 some lines were unreadable (or bad usage, or the batch could not go on),
3 some undecided within a limit, or ended by --time-limit.

Examples:
  $ python3 -m stickslip.batch grasps.jsonl -o verdicts.jsonl --resume
  $ python3 -m stickslip.batch grasps.jsonl -o verdicts.jsonl --scheduler tcp://node1:8786
"""


QUESTIONS_OF: Dict[str, Tuple[str, ...]] = {
    **{name: ("states",) for name in StatesAsked._fields},
    **{name: ("quality",) for name in QualityAsked._fields},
    **{name: ("measures",) for name in MeasuresAsked._fields},
    "inertia": ("class", "measures"), "length": ("quality", "measures"), "accuracy": ("quality", "measures"),
}
"""Of an option the questions that depend on it."""
NOT_WITH: Dict[str, Tuple[str, ...]] = {
    "asks_quality": ("asks_class",),
    "asks_states": ("asks_class", "asks_quality", "certificates", "wrench", "case", "preload", "normal_law"),
    "asks_measures": ("asks_class", "asks_quality", "asks_states", "certificates"),
}
"""Of a question the options that do not go with it."""


def option_of(name: str) -> str:
    return "--" + name.replace("asks_", "").replace("_", "-")


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> NoReturn:
        raise InputError("", "", message, "--help says what there is")


def whole_number(text: str) -> int:
    if not re.fullmatch("[0-9]+", text):
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number; give one in digits")
    return int(text)


def parser() -> Parser:
    result = Parser(prog="python3 -m stickslip.batch", epilog=EPILOG, allow_abbrev=False,
                    description="Decide many grasps, one a line, on many machines by Dask.",
                    formatter_class=argparse.RawDescriptionHelpFormatter)
    add = result.add_argument
    add("file", metavar="GRASPS", help="JSON Lines, a grasp (docs/grasp_file.md) on each line")
    add("--wrench", metavar="WX,WY,T", default="",
        help="wrench applied to the object (replaces the file's); in space FX,FY,FZ,TX,TY,TZ")
    add("--case", metavar="NAME", default="", help="the case of the file whose load is applied")
    add("--preload", metavar="P", default="",
        help="preload of every contact (replaces the file's)")
    add("--normal-law", choices=("unilateral", "bilateral"),
        help="may contacts open? As of stickslip batch; default: unilateral")
    add("--output", "-o", metavar="FILE", default="-",
        help="file for the results, which is added to as they come; default: standard output")
    add("--resume", action="store_true",
        help="go on after an interruption: results in the output file are kept")
    add("--certificates", metavar="DIR", default="",
        help="folder for a proof of each verdict, line-N.json")
    add("--class", dest="asks_class", action="store_true",
        help="ask not for the verdict but for the class of rigid contacts: must move, must hold or "
        "open")
    add("--inertia", metavar="X,Y,G2", default="",
        help="of the objects, for --class and --measures: the centre of mass and the squared radius of gyration "
        "about it; default: 0,0,1, or of --measures 0,0 and the square of the length. Of grasps in space "
        "X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ]; default: 0,0,0,1,1,1, or that square thrice")
    add("--quality", dest="asks_quality", action="store_true",
        help="ask also for the quality of each grasp that is stable, as stickslip quality does: how large "
        "a ball of loads does it resist? The certificate is then that of the ball")
    add("--length", metavar="L", default="",
        help="for --quality and --measures: by which torques are divided; default: half the spread of the contacts")
    add("--about", metavar="X,Y", default="",
        help="for --quality: the point about which torques are; default: the origin")
    add("--body", metavar="NAME", default="",
        help="for --quality: of several bodies the one that the loads are on")
    add("--at-most", metavar="R", default="",
        help="for --quality: no larger ball is of interest; default: 64 times a typical force")
    add("--accuracy", metavar="A", default="",
        help="for --quality: stop when what is proved and what is refuted differ by this part of it, for "
        "--measures the bounds of the two robustnesses; default: 1%%")
    add("--states", dest="asks_states", action="store_true",
        help="ask not for the verdict but how many slip states or contact modes there are of each "
        "dimension, as stickslip states does")
    add("--modes", choices=("slip", "full", "closed", "cs", "ss"), help="for --states: which; default: slip")
    add("--lines", metavar="K", type=whole_number, default=0,
        help="for --states: lines of slip of each contact in space; 0 is 2")
    add("--snap", action="store_true",
        help="for --states: take rational directions near those of --lines that are irrational")
    add("--limit", metavar="N", type=whole_number, default=0,
        help="for --states: end after so many states of a grasp; 0 is no end")
    add("--measures", dest="asks_measures", action="store_true",
        help="ask not for the verdict but what other methods and measures say, as stickslip compare does: its rows")
    add("--methods", metavar="NAME,...", type=lambda text: tuple(text.split(",")), default=(),
        help="for --measures: these alone, as PCR,PGR or weakly-stable-load; default: all")
    add("--max-force", metavar="F,...", default="",
        help="for --measures: the largest normal force, one for all contacts, or one for each; default: 1")
    add("--edges", metavar="N", type=whole_number, default=0,
        help="for --measures: in space pyramids with so many edges in place of round cones; 0 is round")
    add("--node-limit", metavar="N", type=whole_number, default=0,
        help="of each grasp: undecided after N nodes of the search; 0 is no limit")
    add("--time-limit", metavar="SECONDS", default="0",
        help="end between two lines after so many seconds, with exit code 3; 0 is no limit")
    add("--scheduler", metavar="ADDRESS", default="",
        help="of a Dask scheduler, as tcp://node1:8786; default: a cluster on this machine")
    add("--workers", metavar="N", type=whole_number, default=0,
        help="of the cluster on this machine; 0 is one a core")
    return result


def arguments(words: List[str]) -> argparse.Namespace:
    joined: List[str] = []
    for word in words:  # a wrench may begin with a minus
        if joined and joined[-1] in ("--wrench", "--preload", "--inertia", "--about"):
            joined[-1] += "=" + word
        else:
            joined.append(word)
    given = parser().parse_args(joined)
    if given.wrench and given.case:
        raise InputError("", "--case", "there is a --wrench as well", "give one of the two")
    for name, questions in QUESTIONS_OF.items():
        if getattr(given, name) and not any(getattr(given, "asks_" + question) for question in questions):
            raise InputError("", option_of(name), "no answer depends on it",
                             "ask for " + " or ".join(map(option_of, questions)))
    if given.lines > MOST_LINES:
        raise InputError("", "--lines", f"{given.lines} is too large", f"give at most {MOST_LINES}")
    for question, others in NOT_WITH.items():
        for name in others:
            if getattr(given, question) and getattr(given, name):
                raise InputError("", option_of(question), f"there is {option_of(name)} as well", "give one of the two")
    try:
        given.seconds = as_time_limit(given.time_limit)
    except InputError as error:
        raise InputError("", "--time-limit", error.problem, error.remedy) from None
    if given.resume and given.output == "-":
        raise InputError("", "--resume", "there is no output file", "name it: --output FILE")
    if given.scheduler and given.workers:
        raise InputError("", "--workers", "the workers are those of --scheduler",
                         "give one of the two")
    if given.file == "-":
        raise InputError("<stdin>", "", "workers cannot read this",
                         "name a file; stickslip batch reads standard input")
    return given


class Pace:
    """How many bytes a chunk is to have, by how long the last ones took."""

    def __init__(self) -> None:
        self._seconds_a_byte = 0.0
        self._largest = FIRST_BYTES // GROWTH

    def took(self, chunk: Chunk, seconds: float) -> None:
        size = chunk.end - chunk.begin
        self._largest = max(self._largest, size)
        rate = seconds / size
        self._seconds_a_byte = (3 * self._seconds_a_byte + rate) / 4 if self._seconds_a_byte else rate

    def size(self, bytes_left: int, threads: int) -> int:
        """So that all threads end together, less at the end of the file."""
        size = min(self._largest * GROWTH, MOST_BYTES)
        if self._seconds_a_byte:
            a_second = SECONDS_OF_A_CHUNK / self._seconds_a_byte
            share = max(bytes_left / (2 * threads), a_second / 10)
            size = int(min(size, a_second, share))
        return max(size, 1)


class Progress:
    """On a terminal, a line about how far it has come; first after a second, then now and then."""

    def __init__(self, results: int, bytes_done: int, bytes_of_file: int) -> None:
        self._results_before = results
        self._shown = False
        self._next = time.monotonic() + 1
        self._start = time.monotonic()
        self._bytes_before, self._bytes = bytes_done, bytes_of_file

    def show(self, tally: _core.BatchTally, bytes_done: int, threads: int) -> None:
        now = time.monotonic()
        if now < self._next or not sys.stderr.isatty():
            return
        self._next = now + 0.5
        seconds = now - self._start
        results = tally.results - self._results_before
        words = [f"{results} grasps, {results / seconds:.0f}/s"]
        if tally.unreadable:
            words.append(f"{tally.unreadable} unreadable")
        words.append(f"{threads} {'worker' if threads == 1 else 'workers'}")
        if bytes_done > self._bytes_before:
            left = seconds * (self._bytes - bytes_done) / (bytes_done - self._bytes_before)
            words.append(f"about {max(left, 0):.0f} s left")
        self._shown = True
        print("\r\033[K" + ", ".join(words), end="", file=sys.stderr, flush=True)

    def clear(self) -> None:
        if self._shown:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
        self._shown = False

    def say(self, text: str) -> None:
        self.clear()
        print("stickslip: " + text, file=sys.stderr, flush=True)


class Batch:
    """A file of grasps, and what comes of its lines."""

    def __init__(self, given: argparse.Namespace, interruption: Interruption) -> None:
        self._given = given
        self._interruption = interruption
        self._end = None if given.seconds is None else time.monotonic() + float(given.seconds)
        self.path = os.path.abspath(given.file)
        quality = QualityAsked(*(getattr(given, name) for name in QualityAsked._fields))
        self.asked = Asked(given.wrench, given.case, given.preload, given.normal_law == "bilateral",
                           given.node_limit, given.asks_class, given.inertia,
                           given.certificates,
                           os.path.abspath(given.certificates) if given.certificates else "",
                           quality if given.asks_quality else None,
                           StatesAsked(given.modes or "slip", given.lines, given.snap, given.limit)
                           if given.asks_states else None,
                           MeasuresAsked(*(getattr(given, name) for name in MeasuresAsked._fields))
                           if given.asks_measures else None)
        self._decider = self.asked.decider()
        self.tally = _core.BatchTally()
        self._file = self._open_input()
        self._bytes = os.fstat(self._file.fileno()).st_size
        begin, lines_before = self._open_output()
        self._cutter = Cutter(self._file, begin, lines_before)
        self._bytes_written = begin
        self._open_certificates(given.resume)
        self._progress = Progress(self.tally.results, begin, self._bytes)
        self._pace = Pace()
        self._chunks = itertools.count()
        self._at_end = False
        self._waiting: Dict[Any, Tuple[int, Chunk, bool]] = {}  # by future
        self._losses: Dict[int, int] = {}
        self._ready: Dict[int, Tuple[Chunk, Decided]] = {}
        self._bytes_held = 0
        self._next_to_write = 0
        self._answers: queue.Queue[Tuple[Any, Union[Decided, BaseException]]] = queue.Queue()
        self._finished: queue.Queue[Any] = queue.Queue()  # futures
        for _ in range(FETCHERS):
            threading.Thread(target=self._fetch, daemon=True).start()

    def _open_input(self) -> BinaryIO:
        try:
            file = open(self.path, "rb")
            if stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                return file
            raise InputError(self._given.file, "", "this is not a file that workers can read",
                             "name a file; stickslip batch reads pipes")
        except IsADirectoryError:
            raise InputError(self._given.file, "", "this is a directory",
                             "name a file of grasps, one a line") from None
        except OSError as error:
            raise InputError(self._given.file, "", f"cannot open the file: {error.strerror}",
                             "name a file of grasps, one a line") from None

    def _open_output(self) -> Tuple[int, int]:
        """Where to go on in the input, after how many lines."""
        path = self._given.output
        begin, lines_before, length = 0, 0, 0
        exists = path != "-" and os.path.isfile(path)
        if exists and os.path.samefile(path, self.path):
            raise InputError(path, "", f"this would be written over the input {self._given.file}",
                             "name another file for what is written")
        if path == "-" and os.path.sameopenfile(1, self._file.fileno()):
            raise InputError(self._given.file, "", "the output goes into this very file",
                             "send standard output elsewhere")
        if exists and os.path.getsize(path) > 0:
            if not self._given.resume:
                raise InputError(path, "--output", "the file exists",
                                 "go on with --resume, or name another file")
            self.tally, length, begin, lines_before, note = self._decider.skip(self.path, path)
            if note:
                print(f"stickslip: {note}", file=sys.stderr)
        self._output = Output(path, self._interruption)
        if exists:
            self._output.cut(length)
        return begin, lines_before

    def _open_certificates(self, resume: bool) -> None:
        folder = self._given.certificates
        if not folder:
            return
        _core.open_certificate_folder(folder, resume)
        kept = [os.stat(path) for path in (self.path, self._given.output) if os.path.isfile(path)]
        for entry in os.scandir(folder):
            if re.fullmatch(r"line-[0-9]+\.json", entry.name) and entry.is_file() and any(
                    os.path.samestat(entry.stat(), file) for file in kept):
                raise InputError(entry.path, "--certificates", "this is the input or the output",
                                 "name another folder")

    def run(self, cluster: Cluster) -> int:
        """The exit code."""
        self._cluster = cluster
        try:
            is_done = self._decide_all()
        finally:
            self._progress.clear()
        if self._losses and self._given.certificates:
            _core.open_certificate_folder(self._given.certificates, True)  # what the dead left there
        if not is_done:
            self._progress.say(self.ended(f"ended by the time limit of {self._given.time_limit} s"))
        complaint = self.tally.complaint(self._given.file)
        if complaint and (is_done or self.tally.results):
            self._progress.say(complaint)
        if not is_done:
            return UNDECIDED
        return BAD_INPUT if self.tally.unreadable else UNDECIDED if self.tally.undecided else DONE

    def _decide_all(self) -> bool:
        """Whether there was the time."""
        next_look = 0.0
        threads, no_worker_since, said = 0, None, False
        while True:
            now = time.monotonic()
            if now >= next_look:
                threads, next_look = self._cluster.threads(), now + 1
                no_worker_since = (no_worker_since or now) if threads == 0 else None
                if no_worker_since is None:
                    said = False
                elif not said and now - no_worker_since > SECONDS_WITHOUT_WORKERS:
                    said = True
                    self._progress.say(f"{self._cluster.missing()} (Ctrl-C ends this)")
            self._submit_more(max(threads, 1))
            if not self._waiting:
                return True
            if self._end is not None and now >= self._end:
                return False
            self._collect()
            self._write_ready()
            self._progress.show(self.tally, self._bytes_written, threads)

    def _submit_more(self, threads: int) -> None:
        while (not self._at_end and len(self._waiting) < CHUNKS_OF_A_THREAD * threads
               and self._bytes_held < MOST_BYTES_HELD):
            left = max(self._bytes - self._cutter.begin, 0)
            chunk = self._cutter.cut(self._pace.size(left, threads))
            if chunk is None:
                self._at_end = True
            else:
                self._submit(next(self._chunks), chunk, False)

    def _submit(self, index: int, chunk: Chunk, alone: bool) -> None:
        future = self._cluster.client.submit(
            batch_chunk.decide_alone if alone else batch_chunk.decide, self.asked, _core.version,
            self.path, chunk, pure=False, priority=-index)
        self._waiting[future] = index, chunk, alone
        future.add_done_callback(self._finished.put)

    def _fetch(self) -> None:
        while True:
            future = self._finished.get()
            try:
                self._answers.put((future, future.result()))
            except BaseException as error:  # of whatever kind: the other thread looks at it
                self._answers.put((future, error))

    def _collect(self) -> None:
        """What has been decided is ready; what was lost is submitted again."""
        try:
            answers = [self._answers.get(timeout=0.5)]
        except queue.Empty:
            return
        while not self._answers.empty():
            answers.append(self._answers.get())
        for future, answer in answers:
            index, chunk, alone = self._waiting.pop(future)
            if isinstance(answer, BaseException):
                alone = self._lost(answer, index) or alone
            elif answer.error is not None:
                raise InputError(*answer.error)
            elif answer.out_of_memory:
                alone = True
            else:
                self._ready[index] = chunk, answer
                self._bytes_held += len(answer.results)
                if not alone:
                    self._pace.took(chunk, answer.seconds)
                continue
            self._submit(index, chunk, alone)

    def _lost(self, error: BaseException, index: int) -> bool:
        """Whether it is to be decided alone the next time."""
        self._losses[index] = self._losses.get(index, 0) + 1
        died = self._cluster.died(error)
        if not died and not isinstance(error, (concurrent.futures.CancelledError, OSError)):
            raise InputError("", "a worker", f"{type(error).__name__}: {error}",
                             "see whether all workers have this program (docs/batch.md)")
        if not self._cluster.is_connected():
            raise InputError(self._cluster.name, "--scheduler", "the scheduler is gone",
                             "start it again, and go on with --resume")
        if self._losses[index] > MOST_LOSSES:
            raise InputError("", "workers", "they die again and again, whatever they are given",
                             "see what ends them, and go on with --resume")
        return died

    def _write_ready(self) -> None:
        while self._next_to_write in self._ready:
            chunk, decided = self._ready.pop(self._next_to_write)
            with self._interruption:  # which says how many are written
                self._output.write(decided.results)
                self.tally.add(decided.tally)
            self._next_to_write += 1
            self._bytes_held -= len(decided.results)
            self._bytes_written = chunk.end

    def ended(self, how: str) -> str:
        if self._given.output == "-":
            return f"{how}; had the results gone to --output FILE, --resume would go on from there"
        return (f"{how} with {self.tally.results} results in {self._given.output}; go on with "
                "the same command and --resume")


def main(words: List[str]) -> int:
    """The exit code."""
    interruption = Interruption()
    cluster: Optional[Cluster] = None
    batch: Optional[Batch] = None
    try:
        given = arguments(words)
        batch = Batch(given, interruption)
        cluster = Cluster(given.scheduler, given.workers)
        code = batch.run(cluster)
    except InputError as error:
        print(f"stickslip: {error}", file=sys.stderr, flush=True)
        code = BAD_INPUT
    except Interrupted:
        text = batch.ended("interrupted") if batch else "interrupted"
        if interruption.number != signal.SIGPIPE:
            print(f"stickslip: {text}", file=sys.stderr, flush=True)
    interruption.is_over()
    if cluster is not None:
        cluster.close()
    if interruption.number is not None:
        interruption.end()
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
