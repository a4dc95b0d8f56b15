# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 -m stickslip.batch: the bytes of `stickslip batch`, whatever happens to those who decide.

All processes are real; they are killed by their ids. Nothing here depends on how fast they are: where
a batch must not have ended before something happens, it waits at a gate.
"""

import glob
import importlib.util
import json
import os
import pty
import re
import resource
import select
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import pytest

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "support"))

from results import checked  # noqa: E402

pytestmark = pytest.mark.skipif(importlib.util.find_spec("distributed") is None,
                                reason="Dask is not installed (Debian: python3-distributed)")

DONE, BAD_INPUT, UNDECIDED = 0, 2, 3
NO_WORKER = "stickslip: there is no worker; waiting for one to join (Ctrl-C ends this)\n"
NO_SCHEDULER = "stickslip: the scheduler does not answer; waiting for it to come back (Ctrl-C ends this)\n"
DEADLINE = 600  # of one thing that is waited for, in seconds; only a hang reaches it

# What workers, and the processes in which they decide lines alone, do with a line that has this in it:
DEADLY = "kills whoever decides it"
GATED = "waits until the gate is open"
SITE = f"""
import os, signal, time
if "STICKSLIP_TEST" in os.environ:
    from stickslip import _core
    class LineDecider(_core.LineDecider):
        def decide(self, path, begin, end, lines_before):
            with open(path, "rb") as file:
                file.seek(begin)
                text = file.read(end - begin)
            if {DEADLY.encode()!r} in text:
                os.kill(os.getpid(), signal.SIGKILL)
            while {GATED.encode()!r} in text and not os.path.exists(path + ".open"):
                time.sleep(0.01)
            return super().decide(path, begin, end, lines_before)
    _core.LineDecider = LineDecider
"""


def workers_environment(folder):
    """The environment of workers to which the above applies."""
    (folder / "sitecustomize.py").write_text(SITE)
    return {**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), os.environ["PYTHONPATH"]]),
            "STICKSLIP_TEST": "yes", "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "3s"}


def grasp(number, name="grasp"):
    """Fig. 1 under a load; stable up to 10."""
    return {"format": "stickslip-grasp/1", "name": name,
            "defaults": {"friction": "1/2", "preload": 1},
            "contacts": [{"position": [-1, 0], "normal": [1, 0]},
                         {"position": [0, -1], "normal": [0, 1]},
                         {"position": [1, 0], "normal": [-1, 0]}],
            "wrench": [0, f"{number % 21}/10", 0]}


def grasp_in_space():
    return {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2", "preload": 1},
            "contacts": [{"position": [-1, 0, 0], "normal": [1, 0, 0]}, {"position": [1, 0, 0], "normal": [-1, 0, 0]}],
            "wrench": [0, 1, 0, 0, 0, 0]}


def lines_of(count):
    return [json.dumps(grasp(number)) + "\n" for number in range(count)]


def command(*words):
    return [sys.executable, "-m", "stickslip.batch", *map(str, words)]


def batch(*words, **more):
    """Exit code, standard output, standard error."""
    result = subprocess.run(command(*words), capture_output=True, text=True, check=False,
                            timeout=DEADLINE, **more)
    return result.returncode, result.stdout, result.stderr


def reference(*words):
    """Exit code and standard output of the program."""
    result = subprocess.run([os.environ["STICKSLIP"], "batch", *map(str, words)],
                            capture_output=True, text=True, check=False, timeout=DEADLINE)
    return result.returncode, result.stdout


def wait_until(condition):
    end = time.monotonic() + DEADLINE
    while not condition():
        assert time.monotonic() < end, "it does not happen"
        time.sleep(0.01)


def workers_of(pid):
    """The ids of worker processes that this process has started."""
    children = []
    for name in glob.glob(f"/proc/{pid}/task/*/children"):
        with open(name, encoding="ascii") as file:
            children += map(int, file.read().split())

    def command_of(child):
        with open(f"/proc/{child}/cmdline", "rb") as file:
            return file.read()
    return [child for child in children if b"spawn_main" in command_of(child)]


def kill(process):
    """Ends a process that may have ended."""
    if process.poll() is None:
        process.kill()
    process.wait(timeout=DEADLINE)


class Cluster:
    """A scheduler and workers, each started as its users start them."""

    def __init__(self, folder):
        self.folder = folder
        self._environment = workers_environment(folder)
        self.scheduler, self.workers = None, []
        self.address = ""
        self.start_scheduler()

    def _start(self, what, *words):
        with open(self.folder / f"{what}.log", "ab") as log:
            return subprocess.Popen(
                [sys.executable, "-m", f"distributed.cli.dask_{what}", *words], stdout=log,
                stderr=log, cwd=self.folder, env=self._environment)

    def start_scheduler(self):
        """At the same address as before."""
        port = self.address.rpartition(":")[2] or "0"
        file = self.folder / "scheduler.json"
        file.unlink(missing_ok=True)
        self.scheduler = self._start("scheduler", "--host", "127.0.0.1", "--port", port,
                                     "--no-dashboard", "--scheduler-file", str(file))

        def is_up():
            assert self.scheduler.poll() is None
            return file.exists() and file.read_text().endswith("}")
        wait_until(is_up)
        self.address = json.loads(file.read_text())["address"]

    def start_worker(self, *options):
        self.workers.append(self._start(
            "worker", self.address, "--nthreads", "1", "--no-dashboard", "--local-directory",
            str(self.folder), *options))
        return self.workers[-1]

    def close(self):
        for process in [*self.workers, self.scheduler]:
            workers = workers_of(process.pid) if process.poll() is None else []
            kill(process)  # the nanny first, which would start another worker
            for worker in workers:
                if os.path.exists(f"/proc/{worker}"):
                    os.kill(worker, signal.SIGKILL)


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    """Two workers with nannies."""
    made = Cluster(tmp_path_factory.mktemp("cluster"))
    made.start_worker()
    made.start_worker()
    from distributed import Client
    with Client(made.address, set_as_default=False) as client:
        client.wait_for_workers(2)
    yield made
    made.close()


@pytest.fixture
def own_cluster(tmp_path_factory):
    """Without workers; for tests that kill it."""
    made = Cluster(tmp_path_factory.mktemp("own"))
    yield made
    made.close()


@pytest.fixture
def grasps(tmp_path):
    path = tmp_path / "grasps.jsonl"
    path.write_text("".join(lines_of(400)))
    return path


@pytest.fixture
def gated(tmp_path):
    """A batch of them does not end before their gate is open."""
    path = tmp_path / "gated.jsonl"
    lines = lines_of(300)
    lines[200] = json.dumps(grasp(200, GATED)) + "\n"
    path.write_text("".join(lines))
    return path


def open_gate(path):
    path.with_name(path.name + ".open").touch()


MIXED = ("\n \n" + "".join(lines_of(90)) + "{\n[]\n\x00\n" + "\n" * 5000 + "".join(lines_of(50))
         + "x" * 70000 + "\r\n" + json.dumps({**grasp(1), "colour": 1}) + "\n" + "".join(lines_of(9))
         + json.dumps(grasp(3)))  # without an end


@pytest.mark.parametrize("options", [(), ("--wrench", "-1/7,2,0", "--preload", "2"),
                                     ("--class",), ("--class", "--inertia", "-1/7,2,3"),
                                     ("--measures", "--methods", "PGR,least-normal-forces", "--length", "2", "--max-force", "2",
                                      "--inertia", "-1,0,1"),
                                     ("--states",), ("--states", "--modes", "ss", "--lines", "1", "--snap"),
                                     ("--normal-law", "bilateral", "--node-limit", "1")])
def test_the_bytes_are_those_of_the_program(cluster, tmp_path, options):
    path = tmp_path / "mixed.jsonl"
    path.write_text(MIXED)
    code, out = reference(path, *options)
    found = batch(path, "--scheduler", cluster.address, *options)
    assert found == (code, out, f"stickslip: {path}: 5 of 155 lines could not be read, the first "
                                "is line 93; their results say why\n")


def test_exit_codes(cluster, tmp_path):
    path = tmp_path / "g.jsonl"
    at = ("--scheduler", cluster.address)
    for text in ("", "\n \n"):
        path.write_text(text)
        assert batch(path, *at) == (
            DONE, "", f"stickslip: {path}: the file is empty, there is no grasp in it\n")
    path.write_text(json.dumps(grasp(20)) + "\n")
    assert batch(path, *at) == (DONE, reference(path)[1], "")
    for limit in (("--node-limit", 1), ("--states", "--limit", 1)):
        assert batch(path, *at, *limit) == (UNDECIDED, reference(path, *limit)[1], "")
    # A load of a line of the plane and one of space; each says that the other's is not for it.
    path.write_text(json.dumps(grasp(20)) + "\n" + json.dumps(grasp_in_space()) + "\n")
    for wrench in ("0,1,0", "0,1,0,0,0,0"):
        code, out = reference(path, "--wrench", wrench)
        found = batch(path, *at, "--wrench", wrench)
        assert found[:2] == (code, out)
        assert [("verdict" in json.loads(line)) for line in out.splitlines()] == [wrench == "0,1,0", wrench != "0,1,0"]


@pytest.mark.parametrize("lines, options", [
    (lines_of(60), ()), (lines_of(13)[9:], ("--quality", "--about", "-1/7,2", "--length", "2", "--at-most", "1/4", "--accuracy", "1/2"))])
def test_certificates(cluster, tmp_path, lines, options):
    (tmp_path / "grasps.jsonl").write_text("".join(lines))
    words, proofs = ("grasps.jsonl", "--certificates", "proofs", *options), tmp_path / "proofs"
    program = subprocess.run([os.environ["STICKSLIP"], "batch", *words], cwd=tmp_path,
                             capture_output=True, check=True, text=True)
    before = {file.name: file.read_text() for file in proofs.iterdir()}
    for file in proofs.iterdir():
        file.unlink()
    # The workers are in another folder; results name the certificates as the command does.
    found = batch(*words, "--scheduler", cluster.address, cwd=tmp_path)
    assert found == (DONE, program.stdout, "")
    assert {file.name: file.read_text() for file in proofs.iterdir()} == before


def test_a_cluster_of_this_machine(grasps, tmp_path):
    out = tmp_path / "out.jsonl"
    before = set(os.listdir(tmp_path))
    assert batch(grasps, "-o", out, "--workers", 2, cwd=tmp_path) == (DONE, "", "")
    assert out.read_text() == reference(grasps)[1]
    assert set(os.listdir(tmp_path)) - before == {"out.jsonl"}


def test_resume(cluster, grasps, tmp_path):
    out = tmp_path / "out.jsonl"
    words = (grasps, "-o", out, "--scheduler", cluster.address)
    assert batch(*words) == (DONE, "", "")
    whole = out.read_bytes()
    assert whole.decode() == reference(grasps)[1]
    for length in (0, len(whole) // 2, len(whole) - 1):
        out.write_bytes(whole[:length])
        assert batch(*words, "--resume") == (DONE, "", "")
        assert out.read_bytes() == whole, length
    # What the program has begun goes on here, and the other way round.
    out.write_bytes(whole[:12345])
    assert reference(grasps, "-o", out, "--resume") == (DONE, "")
    assert out.read_bytes() == whole
    # Finished lines are not decided again, and other questions are not mixed.
    lines = whole.decode().splitlines()
    marked = "".join(line + "\n" for line in [checked(lines[0].replace('"stable"', '"MARK"')), *lines[1:]]).encode()
    assert marked != whole
    out.write_bytes(marked[:5000])
    assert batch(*words, "--resume") == (DONE, "", "")
    assert out.read_bytes() == marked
    # What was changed is decided again.
    out.write_bytes(whole.replace(b'"stable"', b'"ununstable"', 1))
    assert batch(*words, "--resume") == (DONE, "", (
        f"stickslip: {out}: line 1: this result is not as a batch has written it; it is decided again, and those behind it\n"))
    assert out.read_bytes() == whole
    for more, naming in (((), "exists"), (("--resume", "--preload", 2), "options")):
        code, _, err = batch(*words, *more)
        assert (code, len(err.splitlines())) == (BAD_INPUT, 1)
        assert naming in err


def test_exit_code_and_count_of_a_resumed_batch_are_those_of_all_lines(cluster, tmp_path):
    path, out = tmp_path / "g.jsonl", tmp_path / "out.jsonl"
    path.write_text("{\n" + "".join(lines_of(3)))
    words = (path, "-o", out, "--scheduler", cluster.address)
    first = batch(*words)
    assert first[0] == BAD_INPUT
    assert "1 of 4 lines could not be read, the first is line 1" in first[2]
    assert batch(*words, "--resume") == first


def without_waiting(err):
    """What was said but for what is waited for: how long that takes is the machine's affair."""
    return err.replace(NO_WORKER, "").replace(NO_SCHEDULER, "")


def started(*words, **more):
    """The process, when its output has some lines."""
    process = subprocess.Popen(command(*words), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, **more)
    out = words[words.index("-o") + 1]

    def has_lines():
        assert process.poll() is None, process.communicate()
        return out.exists() and out.read_bytes().count(b"\n") >= 20
    wait_until(has_lines)
    return process


def test_what_is_written_as_a_signal_comes_is_counted(tmp_path):
    from stickslip.batch import Batch, Interrupted, Interruption, Output
    handlers = {number: signal.getsignal(number) for number in Interruption.SIGNALS}
    batch, counted = object.__new__(Batch), []
    try:
        batch._interruption = Interruption()
        output = Output(str(tmp_path / "out.jsonl"), batch._interruption)

        def write(text):
            output.write(text)
            signal.raise_signal(signal.SIGINT)

        batch._output, batch.tally = SimpleNamespace(write=write), SimpleNamespace(add=counted.append)
        batch._ready, batch._next_to_write = {0: (None, SimpleNamespace(results=b"{}\n", tally=1))}, 0
        with pytest.raises(Interrupted):
            batch._write_ready()
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    assert (tmp_path / "out.jsonl").read_bytes() == b"{}\n" and counted == [1]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
def test_interrupted_and_resumed(gated, tmp_path, cluster, number):
    out = tmp_path / "out.jsonl"
    words = (gated, "-o", out, "--scheduler", cluster.address)
    process = started(*words)
    os.kill(process.pid, number)
    said = process.communicate(timeout=DEADLINE)
    assert process.returncode == -number
    found, whole = out.read_text(), reference(gated)[1]
    assert whole.startswith(found) and len(found) < len(whole)
    if number != signal.SIGKILL:
        assert found.endswith("\n")
        assert said == ("", f"stickslip: interrupted with {len(found.splitlines())} results in {out}; "
                            "go on with the same command and --resume\n")
    open_gate(gated)
    assert batch(*words, "--resume") == (DONE, "", "")
    assert out.read_text() == whole


def test_the_reader_of_the_results_goes_away(gated, cluster):
    with subprocess.Popen(command(gated, "--scheduler", cluster.address), stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as process:
        process.stdout.readline()
        process.stdout.close()
        open_gate(gated)
        assert process.stderr.read() == b""
        assert process.wait(timeout=DEADLINE) == -signal.SIGPIPE


def test_ctrl_c_on_a_terminal_ends_a_local_cluster(gated, tmp_path):
    """Which gets the signal as well: all processes of the group do."""
    out = tmp_path / "out.jsonl"
    process = started(gated, "-o", out, "--workers", 1, start_new_session=True,
                      env=workers_environment(tmp_path))
    workers = workers_of(process.pid)
    assert len(workers) == 1
    os.killpg(process.pid, signal.SIGINT)
    said = process.communicate(timeout=DEADLINE)
    assert process.returncode == -signal.SIGINT
    assert re.fullmatch(r"stickslip: interrupted with \d+ results in .*--resume\n", said[1])
    wait_until(lambda: not os.path.exists(f"/proc/{workers[0]}"))


def test_a_worker_killed_in_the_middle(gated, tmp_path, own_cluster):
    out = tmp_path / "out.jsonl"
    worker = own_cluster.start_worker("--no-nanny")
    process = started(gated, "-o", out, "--scheduler", own_cluster.address)
    os.kill(worker.pid, signal.SIGKILL)
    assert process.stderr.readline() == NO_WORKER
    open_gate(gated)
    own_cluster.start_worker("--no-nanny")
    assert process.communicate(timeout=DEADLINE) == ("", "")
    assert process.returncode == DONE
    assert out.read_text() == reference(gated)[1]


def test_a_worker_of_a_local_cluster_killed_in_the_middle(gated, tmp_path):
    out = tmp_path / "out.jsonl"
    process = started(gated, "-o", out, "--workers", 1,
                      env=workers_environment(tmp_path))
    worker, = workers_of(process.pid)
    os.kill(worker, signal.SIGKILL)
    open_gate(gated)
    printed, said = process.communicate(timeout=DEADLINE)
    assert (printed, without_waiting(said)) == ("", "")
    assert process.returncode == DONE
    assert out.read_text() == reference(gated)[1]


def test_lines_that_kill_whoever_decides_them(cluster, tmp_path):
    path = tmp_path / "g.jsonl"
    lines = lines_of(150)
    path.write_text("".join(lines))
    expected = reference(path)[1].splitlines()
    deadly = (1, 77, 78, 150)
    for number in deadly:
        lines[number - 1] = json.dumps(grasp(number, DEADLY)) + "\n"
    path.write_text("".join(lines))
    code, out, err = batch(path, "--scheduler", cluster.address)
    assert code == BAD_INPUT
    assert without_waiting(err) == (
        f"stickslip: {path}: 4 of 150 lines could not be read, the first is line 1; their results say why\n")
    keys = [json.loads(line)["key"] for line in reference(path)[1].splitlines()]
    results = out.splitlines()
    for number in deadly:
        result = json.loads(results[number - 1])
        assert list(result) == ["line", "key", "error", "check"]
        assert (result["line"], result["key"]) == (number, keys[number - 1])
        assert list(result["error"]) == ["place", "problem", "remedy"]
        assert "SIGKILL" in result["error"]["problem"]
        results[number - 1] = expected[number - 1]
    assert results == expected


def test_a_line_that_needs_more_memory_than_there_is(tmp_path):
    """Alone, in a process with a limit; the others are decided."""
    from stickslip import batch_chunk
    lines = lines_of(5)
    lines[2] = '{"' + "x" * 60000000 + '": 0}\n'
    path = tmp_path / "g.jsonl"
    path.write_text("".join(lines))
    whole = reference(path)[1].splitlines()
    asked = batch_chunk.Asked("", "", "", False, 0, False, "", "", "")
    chunk = batch_chunk.Chunk(0, path.stat().st_size, 0, 0)
    unlimited, _ = batch_chunk.alone(asked, str(path), chunk, 0)
    assert unlimited.decode().splitlines() == whole
    limited, tally = batch_chunk.alone(asked, str(path), chunk, 100 << 20)
    found = limited.decode().splitlines()
    assert "memory" in json.loads(found[2])["error"]["problem"]
    assert [*found[:2], *found[3:]] == [*whole[:2], *whole[3:]]
    assert (tally.results, tally.unreadable) == (5, 1)


def test_the_scheduler_is_restarted(gated, tmp_path, own_cluster):
    out = tmp_path / "out.jsonl"
    own_cluster.start_worker()
    process = started(gated, "-o", out, "--scheduler", own_cluster.address)
    kill(own_cluster.scheduler)
    open_gate(gated)
    own_cluster.start_scheduler()
    own_cluster.start_worker()
    _, err = process.communicate(timeout=DEADLINE)
    assert (process.returncode, without_waiting(err)) == (DONE, "")
    assert out.read_text() == reference(gated)[1]


def test_the_scheduler_does_not_come_back(gated, tmp_path, own_cluster, cluster):
    out = tmp_path / "out.jsonl"
    own_cluster.start_worker()
    process = started(gated, "-o", out, "--scheduler", own_cluster.address,
                      env={**os.environ, "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s"})
    kill(own_cluster.scheduler)
    _, err = process.communicate(timeout=DEADLINE)
    assert process.returncode == BAD_INPUT
    assert without_waiting(err) == (
        f"stickslip: {own_cluster.address}: --scheduler: the scheduler is gone; start it again, and go "
        "on with --resume\n")
    assert out.read_bytes().endswith(b"\n")
    open_gate(gated)
    assert batch(gated, "-o", out, "--resume", "--scheduler", cluster.address) == (DONE, "", "")
    assert out.read_text() == reference(gated)[1]


def test_a_full_disk(cluster, grasps, tmp_path):
    at = ("--scheduler", cluster.address)
    if os.path.exists("/dev/full"):
        code, _, err = batch(grasps, "-o", "/dev/full", *at)
        assert code == BAD_INPUT
        assert err == ("stickslip: /dev/full: the file cannot be written: No space left on device; "
                       "make room there, or name another file, and go on with --resume\n")
        with open("/dev/full", "wb") as full:
            found = subprocess.run(command(grasps, *at), stdout=full, stderr=subprocess.PIPE,
                                   text=True, check=False, timeout=DEADLINE)
        assert found.returncode == BAD_INPUT
        assert found.stderr.startswith("stickslip: <stdout>: the file cannot be written: No space")
    # A file that must not grow longer: what fits of a chunk is cut where a line ends.
    out, whole = tmp_path / "out.jsonl", reference(grasps)[1]
    for limit in (1, 20001):
        out.unlink(missing_ok=True)
        code, _, err = batch(grasps, "-o", out, *at, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (limit, limit)))
        assert (code, len(err.splitlines())) == (BAD_INPUT, 1)
        assert f"{out}: the file cannot be written: File too large" in err
        found = out.read_text()
        assert whole.startswith(found) and len(found) <= limit
        assert found == "" or found.endswith("\n")
        assert limit - len(found) < 200
        assert batch(grasps, "-o", out, *at, "--resume") == (DONE, "", "")
        assert out.read_text() == whole


def test_a_certificate_that_cannot_be_written_ends_the_batch(cluster, grasps, tmp_path):
    proofs, out = tmp_path / "proofs", tmp_path / "out.jsonl"
    (proofs / "line-77.json").mkdir(parents=True)
    (proofs / "line-5.json.1-2.tmp").write_text("as a killed worker leaves it")
    words = (grasps, "-o", out, "--certificates", proofs, "--scheduler", cluster.address)
    code, _, err = batch(*words)
    assert (code, len(err.splitlines())) == (BAD_INPUT, 1)
    assert f"{proofs}/line-77.json: the file cannot be written" in err
    (proofs / "line-77.json").rmdir()
    assert batch(*words, "--resume") == (DONE, "", "")
    assert {p.name for p in proofs.iterdir()} == {f"line-{i}.json" for i in range(1, 401)}
    assert out.read_text() == reference(grasps, "--certificates", proofs)[1]


def test_progress_on_a_terminal(gated, tmp_path, cluster):
    master, slave = pty.openpty()
    with subprocess.Popen(command(gated, "-o", tmp_path / "out.jsonl", "--scheduler", cluster.address),
                          stderr=slave, stdout=slave) as process:
        os.close(slave)
        screen = b""

        def shown():
            nonlocal screen
            if select.select([master], [], [], 0.01)[0]:
                screen += os.read(master, 65536)
            return re.search(rb"\r\x1b\[K\d+ grasps, \d+/s, 2 workers, about \d+ s left", screen)
        wait_until(shown)
        process.kill()
    open_gate(gated)
    os.close(master)


def test_workers_that_read_something_else(cluster, grasps):
    """As where the file is on no file system that they share."""
    from distributed import Client
    from stickslip import _core, batch_chunk
    asked = batch_chunk.Asked("", "", "", False, 0, False, "", "", "")
    with Client(cluster.address, set_as_default=False) as client:
        for version, path, chunk, problem in (
                (_core.version, "/nowhere/g.jsonl", (0, 10, 0, 0), "cannot read the file: No such"),
                (_core.version, str(grasps), (0, 10, 0, 12345), "reads another text"),
                (_core.version, str(grasps), (0, 10 ** 9, 0, 0), "reads another text"),
                ("0.0.0", str(grasps), (0, 10, 0, 0), "and not 0.0.0")):
            found = client.submit(batch_chunk.decide, asked, version, path,
                                  batch_chunk.Chunk(*chunk), pure=False).result()
            assert problem in found.error[2] and found.error[3], found


def in_process(capfd, *words):
    """As batch(), without a start of Python; of what ends before any line is decided."""
    from stickslip.batch import Interruption, main
    handlers = {number: signal.getsignal(number) for number in Interruption.SIGNALS}
    try:
        code = main(list(map(str, words)))
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
    return code, *capfd.readouterr()


def test_usage(tmp_path, grasps, capfd):
    def fails(*words, naming, **more):
        code, out, err = batch(*words, **more) if more else in_process(capfd, *words)
        assert (code, out) == (BAD_INPUT, "")
        assert len(err.splitlines()) == 1 and err.startswith("stickslip: "), err
        for part in naming:
            assert part in err

    fails(naming=["GRASPS", "--help"])
    assert batch() == in_process(capfd)  # as a program
    fails("-", naming=["stickslip batch reads standard input"])
    fails(tmp_path / "none.jsonl", naming=["none.jsonl", "cannot open"])
    fails(tmp_path, naming=["this is a directory"])
    fails("/dev/null", naming=["not a file that workers can read"])
    fails(grasps, "--colour", naming=["--colour"])
    fails(grasps, "--node-limit=-1", naming=["--node-limit", "whole number"])
    fails(grasps, "--normal-law", "x", naming=["--normal-law", "unilateral"])
    fails(grasps, "--wrench", "0,x", naming=["--wrench", "x"])
    fails(grasps, "--preload", "x", naming=["--preload", "3/5"])
    fails(grasps, "--wrench", "0,1,0", "--case", "x", naming=["--wrench", "--case"])
    fails(grasps, "--quality", "--class", naming=["--quality", "--class"])
    fails(grasps, "--quality", "--length", 0, naming=["--length", "above 0"])
    for option in ("--length", "--about", "--body", "--at-most", "--accuracy"):
        fails(grasps, option, 1, naming=[option, "--quality"])
    for option in ("--methods", "--max-force", "--edges", "--length", "--accuracy", "--inertia"):
        fails(grasps, option, 1, naming=[option, "--measures"])
    for option, value in (("--methods", "nonsense"), ("--max-force", 0), ("--inertia", "0,0,0"), ("--length", 0), ("--accuracy", 0)):
        fails(grasps, "--measures", option, value, naming=[option])
    for option, *value in (("--class",), ("--quality",), ("--states",), ("--certificates", "x")):
        fails(grasps, "--measures", option, *value, naming=[option, "--measures"])
    for option, *value in (("--modes", "cs"), ("--lines", 1), ("--snap",), ("--limit", 1)):
        fails(grasps, option, *value, naming=[option, "--states"])
    fails(grasps, "--states", "--lines", 65, naming=["--lines", "64"])
    for option, *value in (("--class",), ("--quality",), ("--certificates", "x"), ("--wrench", "0,0,0"), ("--case", "x"), ("--preload", 1),
                           ("--normal-law", "bilateral")):
        fails(grasps, "--states", option, *value, naming=[option, "--states"])
    fails(grasps, "--resume", naming=["--resume", "--output"])
    fails(grasps, "--workers", 2, "--scheduler", "x", naming=["--workers", "--scheduler"])
    fails(grasps, "-o", grasps, naming=["written over the input"])
    fails(grasps, "-o", tmp_path / "no" / "folder", naming=["cannot be written"])
    (tmp_path / "proofs").mkdir()
    os.link(grasps, tmp_path / "proofs" / "line-3.json")
    fails(grasps, "--certificates", tmp_path / "proofs", naming=["line-3.json", "the input"])
    quick = {**os.environ, "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "1s"}
    fails(grasps, "--scheduler", "tcp://127.0.0.1:9", env=quick, naming=["127.0.0.1:9", "no scheduler"])
    fails(grasps, "--scheduler", "nonsense://x", env=quick, naming=["nonsense", "tcp://node1:8786"])
    (tmp_path / "distributed.py").write_text("raise ImportError('there is none')")
    fails(grasps, naming=["Dask distributed", "python3-distributed"],
          env={**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{os.environ['PYTHONPATH']}"})


def test_a_time_limit_ends_between_two_lines(tmp_path):
    grasps, output = tmp_path / "g.jsonl", tmp_path / "v.jsonl"
    grasps.write_text("".join(lines_of(50)))
    code, _, err = batch(grasps, "-o", output, "--workers", 1, "--time-limit", "0.000001")
    assert (code, err) == (UNDECIDED, f"stickslip: ended by the time limit of 0.000001 s with 0 results in {output}; "
                                      "go on with the same command and --resume\n")
    code, _, err = batch(grasps, "-o", output, "--workers", 1, "--time-limit", "1000", "--resume")
    assert (code, err) == (DONE, "")
    assert output.read_text() == reference(grasps)[1]
    code, _, err = batch(grasps, "--time-limit", "soon")
    assert code == BAD_INPUT and "--time-limit" in err


def test_help_names_every_option_of_the_program():
    code, out, err = batch("--help")
    assert (code, err) == (DONE, "")
    program = subprocess.run([os.environ["STICKSLIP"], "batch", "--help"], capture_output=True,
                             text=True, check=True).stdout
    options = set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", program, re.M))
    assert len(options) > 8
    # Shards need no Dask; the number of threads is that of workers here.
    assert options - set(re.findall(r"--[a-z-]+", out)) == {"--shard", "--merge", "--threads"}
