# SPDX-License-Identifier: GPL-3.0-or-later
"""Throughput of python3 -m stickslip.batch with two workers beside that of stickslip batch with two
threads, and what the scheduler and the workers of a cluster take for files of growing length.

    PYTHONPATH=build/python python3 bench/batch/cluster_bench.py build/bin [--seconds N] [--most-lines N]

Exit code 1 if a run fails, or if the results of the two differ.
"""

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

CONTACTS = (4, 10, 100, 1000)
ROUNDS = 3


class Bench:
    def __init__(self, programs, folder):
        self.programs, self.folder = programs, folder
        self.grasps, self.results = self.path("grasps.jsonl"), self.path("results.jsonl")

    def path(self, name):
        return os.path.join(self.folder, name)

    def run(self, *words):
        """Seconds."""
        if os.path.exists(self.results):
            os.remove(self.results)
        start = time.monotonic()
        subprocess.run([*map(str, words), "-o", self.results], check=True)
        return time.monotonic() - start

    @staticmethod
    def measured(run):
        """Seconds, and seconds of the processor."""
        before = used_by_children()
        return run(), used_by_children() - before

    def program(self):
        return self.run(os.path.join(self.programs, "stickslip"), "batch", self.grasps, "--threads", 2)

    def cluster(self):
        return self.run(sys.executable, "-c", CLIENT, self.path("said"), self.grasps, "--workers", 2)

    def said(self):
        """By CLIENT."""
        with open(self.path("said"), encoding="utf-8") as file:
            return json.load(file)

    def content(self):
        with open(self.results, "rb") as file:
            return file.read()

    def write(self, contacts, lines):
        """So many different grasps, or 2000 of them again and again."""
        different = min(lines, 2000)
        program = os.path.join(self.programs, "stickslip")
        subprocess.run([os.path.join(self.programs, "batch_bench"), program, "--write", self.grasps,
                        "--contacts", str(contacts), "--lines", str(different)], check=True)
        with open(self.grasps, "rb") as file:
            text = file.read()
        with open(self.grasps, "wb") as file:
            for _ in range(lines // different):
                file.write(text)

    def efficiency(self, seconds):
        """A row a number of contacts."""
        print("| m | lines | batch, 1/s | workers, 1/s | workers / batch | without the start | "
              "workers busy | processor time, batch / all without the start |")
        print("|--:|--:|--:|--:|--:|--:|--:|--:|")
        self.write(4, 1)
        start, start_used = map(min, zip(*(self.measured(self.cluster) for _ in range(ROUNDS))))
        for contacts in CONTACTS:
            lines = 2000 if contacts <= 10 else 40 if contacts == 1000 else 400
            self.write(contacts, lines)
            once = max(self.program() - 0.05, 0.01)
            lines *= max(round(seconds / once), 1)
            self.write(contacts, lines)
            times, busy, processor = [], [], []
            for _ in range(ROUNDS):
                batch, used_by_batch = self.measured(self.program)
                expected = self.content()
                workers, used_by_all = self.measured(self.cluster)
                times.append((batch, workers))
                busy.append(self.said()["busy"] / 2)
                processor.append(used_by_batch / (used_by_all - start_used))
                if self.content() != expected:
                    sys.exit("cluster_bench: the results differ")
            ratio = statistics.median(batch / workers for batch, workers in times)
            running = statistics.median(batch / (workers - start) for batch, workers in times)
            rates = [lines / statistics.median(column) for column in zip(*times)]
            print(f"| {contacts} | {lines} | {rates[0]:.0f} | {rates[1]:.0f} | {ratio:.2f} | "
                  f"{running:.2f} | {statistics.median(busy):.3f} | {statistics.median(processor):.2f} |",
                  flush=True)
        print(f"\nstart and end of a cluster: {start:.1f} s, {start_used:.1f} s of the processor")

    def cost(self, most_lines):
        """A row a length of the file: a scheduler, two workers and a client, each a process."""
        print("\n| lines of 4 contacts | 1/s | chunks | scheduler, MB | worker, MB | client, MB | "
              "scheduler, ms a chunk | client, ms a chunk | network, bytes a line |")
        print("|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
        lines = max(most_lines // 100, 1)
        while lines <= most_lines:
            self.write(4, lines)
            if os.path.exists(self.results):
                os.remove(self.results)
            self._cost_of(lines)
            lines *= 10

    def _cost_of(self, lines):
        file = self.path("scheduler.json")
        if os.path.exists(file):
            os.remove(file)

        def start(module, *words):
            return subprocess.Popen([sys.executable, "-m", module, *words],
                                    stderr=subprocess.DEVNULL, cwd=self.folder)
        processes = [start("distributed.cli.dask_scheduler", "--port", "0", "--no-dashboard",
                           "--scheduler-file", file)]
        try:
            while not os.path.exists(file) or os.path.getsize(file) == 0:
                time.sleep(0.1)
            time.sleep(0.5)
            with open(file, encoding="utf-8") as text:
                address = json.load(text)["address"]
            processes += [start("distributed.cli.dask_worker", address, "--nthreads", "1", "--no-nanny",
                                "--no-dashboard") for _ in range(2)]
            time.sleep(5)
            before = [used(process.pid) for process in processes]
            network = network_bytes()
            seconds = time.monotonic()
            client = subprocess.Popen([sys.executable, "-c", CLIENT, self.path("said"), self.grasps, "-o", self.results,
                                       "--scheduler", address])
            if client.wait() != 0:
                sys.exit("cluster_bench: the batch failed")
            seconds = time.monotonic() - seconds
            network = network_bytes() - network
            said = self.said()
            chunks = said["chunks"]
            after = [used(process.pid) for process in processes]
            peaks = [peak(process.pid) for process in processes]
            scheduler = after[0] - before[0]
            print(f"| {lines} | {lines / seconds:.0f} | {chunks} | {peaks[0]:.0f} | "
                  f"{max(peaks[1:]):.0f} | {said['peak']:.0f} | {1000 * scheduler / chunks:.1f} | "
                  f"{1000 * said['processor'] / chunks:.1f} | {network / lines:.0f} |", flush=True)
        finally:
            for process in reversed(processes):
                process.kill()
                process.wait()


# A batch that says how many chunks there were, which share of the time after it was connected they
# kept workers busy (2: two workers, always), and what this process took.
CLIENT = """
import json, resource, sys, time
from stickslip import batch
said = {"chunks": 0, "busy": 0.0}
took, decide_all = batch.Pace.took, batch.Batch._decide_all
def counted(self, chunk, seconds):
    said["chunks"] += 1
    said["busy"] += seconds
    took(self, chunk, seconds)
def timed(self):
    start, used = time.monotonic(), time.process_time()
    decide_all(self)
    said["busy"] /= time.monotonic() - start
    said["processor"] = time.process_time() - used
    said["peak"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
batch.Pace.took, batch.Batch._decide_all = counted, timed
code = batch.main(sys.argv[2:])
with open(sys.argv[1], "w") as file:
    json.dump(said, file)
sys.exit(code)
"""


def used_by_children():
    """Seconds of the processor, by all that have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def used(pid):
    """Seconds of the processor."""
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def peak(pid):
    """Megabytes."""
    with open(f"/proc/{pid}/status", encoding="ascii") as file:
        return next(int(line.split()[1]) / 1024 for line in file if line.startswith("VmHWM"))


def network_bytes():
    """Through the loopback device."""
    with open("/proc/net/dev", encoding="ascii") as file:
        return next(int(line.split()[1]) for line in file if line.strip().startswith("lo:"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("programs", help="the folder of stickslip and batch_bench")
    parser.add_argument("--seconds", type=float, default=30, help="of a run of stickslip batch")
    parser.add_argument("--most-lines", type=int, default=10**6, help="of the longest file")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="stickslip-bench-") as folder:
        bench = Bench(given.programs, folder)
        bench.efficiency(given.seconds)
        bench.cost(given.most_lines)


if __name__ == "__main__":
    main()
