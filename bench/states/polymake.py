#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slip states counted by `stickslip states` and by polymake, in one run.

    python3 bench/states/polymake.py [CONTACTS ...], default 3 4 5

The rows are those that `stickslip` prints for random contacts with two lines of slip each: 6, 8
and 10 planes in Q^6. polymake (https://polymake.org, Debian's package `polymake`) builds the
chamber decomposition of the arrangement, whose cones are the states but for all-stick. Its
seconds of the processor are those of the decomposition and its f-vector, without its start;
ours are those of the whole process, which takes about 5 ms to start.
"""

import json
import os
import random
import resource
import subprocess
import sys
import tempfile

STICKSLIP = os.environ.get("STICKSLIP", "stickslip")
SCRIPT = """use application "fan";
my $planes = new Matrix<Rational>(%s);
my $start = (times)[0] + (times)[1];
my $cones = (new HyperplaneArrangement(HYPERPLANES=>$planes))->CHAMBER_DECOMPOSITION->F_VECTOR;
print join(" ", @$cones), "\\n", (times)[0] + (times)[1] - $start, "\\n";
"""


def random_grasp(contacts):
    draw = random.Random(1)
    vector = lambda: [draw.randint(-100, 100) for _ in range(3)]  # noqa: E731
    return {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2"}, "wrench": [0] * 6,
            "contacts": [{"position": vector(), "normal": vector()} for _ in range(contacts)]}


def seconds_of(words, text=""):
    """What a process prints, and its seconds of the processor."""
    def spent():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime
    before = spent()
    said = subprocess.run(words, input=text, capture_output=True, text=True, check=True).stdout
    return said, spent() - before


def main():
    print("contacts  planes   states  stickslip s  polymake s  times")
    for contacts in [int(word) for word in sys.argv[1:]] or [3, 4, 5]:
        said, ours = seconds_of([STICKSLIP, "states", "-", "--json", "--threads", "1"], json.dumps(random_grasp(contacts)))
        answer = json.loads(said)
        rows = [row["row"] for row in answer["rows"]]
        script = SCRIPT % "[{}]".format(",".join("[{}]".format(",".join(map(str, row))) for row in rows))
        with tempfile.NamedTemporaryFile("w", suffix=".pl") as file:
            file.write(script)
            file.flush()
            said, _ = seconds_of(["polymake", "--script", file.name])
        cones, theirs = said.split("\n")[-3:-1]
        # Cones by dimension from 1, or from the dimension of the space that all planes share.
        found = [int(number) for number in cones.split()]
        expected = [number for number in answer["by_dimension"][1:] if number > 0]
        if found != expected:
            sys.exit(f"{contacts} contacts: polymake has {found}, stickslip {expected}")
        print(f"{contacts:8}  {len(rows):6}  {answer['distinct_states']:7}  {ours:11.3f}  {float(theirs):10.2f}"
              f"  {float(theirs) / ours:5.0f}", flush=True)


if __name__ == "__main__":
    main()
