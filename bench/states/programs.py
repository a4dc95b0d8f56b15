#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""States in space as whole programs find, prove and check them, in seconds of the processor.

    python3 bench/states/programs.py [PART ...], default modes proof polymake

The programs are `stickslip` and `stickslip-check` on the PATH, with one thread.

modes: `stickslip states --modes cs` and `ss` of a round body that lies in a bowl, with the
default lines of slip and with two in random directions: the least of 20 runs, start included,
beside that of one contact, which is nearly all start.
proof: a certificate that a list of a million slip states of ten contacts is complete, by
`stickslip-check` and by `check.py`, which check the motion of each state as well.
polymake: slip states of three to five random contacts, 6, 8 and 10 planes in Q^6, also by
polymake (https://polymake.org, Debian's package `polymake`). It builds the chamber decomposition
of the arrangement, whose cones are the states but for all-stick; its time is that of the
decomposition and its f-vector, without its start, and ours that of the whole process.
"""

import json
import os
import random
import resource
import subprocess
import sys
import tempfile

STICKSLIP = os.environ.get("STICKSLIP", "stickslip")
STICKSLIP_CHECK = os.environ.get("STICKSLIP_CHECK", "stickslip-check")
CHECK_PY = os.path.join(os.path.dirname(__file__), "..", "..", "certificate", "python", "check.py")
ONE_THREAD = ["--threads", "1"]
SCRIPT = """use application "fan";
my $planes = new Matrix<Rational>(%s);
my $start = (times)[0] + (times)[1];
my $cones = (new HyperplaneArrangement(HYPERPLANES=>$planes))->CHAMBER_DECOMPOSITION->F_VECTOR;
print join(" ", @$cones), "\\n", (times)[0] + (times)[1] - $start, "\\n";
"""


def random_vector(draw):
    return [draw.randint(-100, 100) for _ in range(3)]


def cross(a, b):
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


def grasp(contacts):
    return {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2"}, "wrench": [0] * 6,
            "contacts": [{"position": position, "normal": normal} for position, normal in contacts]}


def random_grasp(contacts):
    draw = random.Random(1)
    return grasp([(random_vector(draw), random_vector(draw)) for _ in range(contacts)])


def bowl(contacts):
    """Contacts of a round body that lies in a bowl: normals lean towards the middle."""
    draw = random.Random(1)
    found = []
    for _ in range(contacts):
        x, y, _ = random_vector(draw)
        found.append(([x, y, (x * x + y * y) // 100 + draw.randint(-10, 10)], [-x, -y, 120 + draw.randint(0, 20)]))
    return grasp(found)


def random_directions(of):
    draw = random.Random(2)
    return [[cross(contact["normal"], random_vector(draw)) for _ in range(2)] for contact in of["contacts"]]


def seconds_of(words, text=""):
    """What a process prints, and its seconds of the processor, user and system."""
    def spent():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime
    before = spent()
    said = subprocess.run(words, input=text, capture_output=True, text=True, check=True).stdout
    return said, spent() - before


def written(folder, name, value):
    path = os.path.join(folder, name)
    with open(path, "w") as file:
        json.dump(value, file)
    return path


def number_of_states(said):
    return next(line.split()[-1] for line in said.split("\n") if line.strip().startswith("states"))


def modes(folder):
    print("contacts  modes  lines    states  least ms")
    for contacts in (1, 10, 30):
        scene = bowl(contacts)
        file = written(folder, "bowl.json", scene)
        directions = written(folder, "directions.json", random_directions(scene))
        for kind, lines, options in (("cs", "", []), ("ss", "default", []),
                                     ("ss", "random", ["--directions", directions])):
            runs = [seconds_of([STICKSLIP, "states", file, "--modes", kind, *options, *ONE_THREAD])
                    for _ in range(20)]
            states = number_of_states(runs[0][0])
            print(f"{contacts:8}  {kind:5}  {lines:7}  {states:>6}  {1000 * min(ms for _, ms in runs):8.1f}", flush=True)


def proof(folder):
    scene = random_grasp(10)
    file = written(folder, "ten.json", scene)
    certificate = os.path.join(folder, "proof.json")
    directions = written(folder, "directions.json", random_directions(scene))
    print("a million states      seconds")
    for name, words in (
            ("counted", [STICKSLIP, "states", file, *ONE_THREAD, "--directions", directions]),
            ("certificate", [STICKSLIP, "states", file, *ONE_THREAD, "--directions", directions, "--certificate", certificate]),
            ("stickslip-check", [STICKSLIP_CHECK, file, certificate, "--states", "slip"]),
            ("check.py", [sys.executable, CHECK_PY, file, certificate, "--states", "slip"])):
        said, seconds = seconds_of(words)
        answer = number_of_states(said) if words[0] == STICKSLIP else ", ".join(said.split("\n")[:2])
        print(f"{name:20}  {seconds:7.2f}  {answer}", flush=True)


def polymake(folder):
    print("contacts  planes   states  stickslip s  polymake s  times")
    for contacts in (3, 4, 5):
        file = written(folder, "few.json", random_grasp(contacts))
        said, ours = seconds_of([STICKSLIP, "states", file, "--json", *ONE_THREAD])
        answer = json.loads(said)
        rows = [row["row"] for row in answer["rows"]]
        script = os.path.join(folder, "chambers.pl")
        with open(script, "w") as to:
            to.write(SCRIPT % "[{}]".format(",".join("[{}]".format(",".join(map(str, row))) for row in rows)))
        said, _ = seconds_of(["polymake", "--script", script])
        cones, theirs = said.split("\n")[-3:-1]
        # Cones by dimension from 1, or from the dimension of the space that all planes share.
        found = [int(number) for number in cones.split()]
        expected = [number for number in answer["by_dimension"][1:] if number > 0]
        if found != expected:
            sys.exit(f"{contacts} contacts: polymake has {found}, stickslip {expected}")
        print(f"{contacts:8}  {len(rows):6}  {answer['distinct_states']:7}  {ours:11.3f}  {float(theirs):10.2f}"
              f"  {float(theirs) / ours:5.0f}", flush=True)


def main():
    parts = {"modes": modes, "proof": proof, "polymake": polymake}
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[1:] or parts:
            parts[name](folder)


if __name__ == "__main__":
    main()
