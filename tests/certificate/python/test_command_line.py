# SPDX-License-Identifier: MIT
"""The command lines of all checkers: check.py, where STICKSLIP_CHECK and STICKSLIP_PROVED name them
stickslip-check and stickslip-proved, and where STICKSLIP_NODE names node certificate/js/check_node.js."""

import json
import os
import re
import resource
import subprocess
import sys
import tempfile
import unittest

from support import (CHECK, FIG1, HERE, NOT_JUDGED, PROGRAMS, STICKSLIP_CHECK, STICKSLIP_NODE, STICKSLIP_PROVED, UP, UP_TREE,
                     Case, certificate, check, grasp, in_process, start, up)


class CommandLineTest(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.g, self.c = self.write("g.json", FIG1), self.write("c.json", up())

    def write(self, name, content):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content if isinstance(content, str) else json.dumps(content))
        return path

    def here(self, arguments):
        """check.py in this process, and in the folder: a start takes longer than its answer."""
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        return in_process(arguments)

    def both(self, arguments, code, needle="", stdin=None):
        """All programs end with this code, and with this text on either stream; returns outputs."""
        outputs = []
        for program in PROGRAMS:
            here = program is PROGRAMS[0] and stdin is None
            found, out, err = self.here(arguments) if here else start(program, arguments, stdin, self.folder)
            self.assertEqual(found, code, (program, arguments, out, err))
            self.assertIn(needle, out + err, (program, arguments))
            if code == 2 and "--json" not in arguments:
                self.assertEqual(out, "")
                self.assertRegex(err, r"\A(check\.py|stickslip-check|stickslip-proved|check_node\.js): ")
            outputs.append(out)
        return outputs

    def test_as_programs(self):
        outputs = self.both([*UP, self.g, self.c], 0, "accepted\nverdict     unstable\n")
        self.assertEqual(start([sys.executable, "-B", CHECK], [*UP, self.g, self.c]), (0, outputs[0], ""))
        for files, text in ((("-", self.c), FIG1), ((self.g, "-"), up())):
            self.both([files[0], *UP, files[1]], 0, "accepted", json.dumps(text).encode())
        self.both([self.g, self.c], 1, "rejected\nrule   question-wrench\n")
        self.both([self.g, "-"], 2, "<stdin>: ", b"{}")

    def test_files_that_are_none(self):
        self.both([self.g, os.path.join(self.folder, "absent")], 2, "No such file")
        for files in ((self.g, self.folder), (self.folder, self.c), (".", self.c)):
            self.both(files, 2, "it is a directory")
        empty = self.write("empty", "")
        for files in ((self.g, empty), (empty, self.c), (self.g, "/dev/null")):
            self.both(files, 2, "the file is empty")
        comma = self.write("comma", json.dumps(FIG1).replace("]}]", "]},]"))
        self.both([comma, self.c], 2, "a comma after the last element; remove it")

    def test_states_of_many_coordinates(self):
        bodies = [{"name": str(k)} for k in range(11)]
        grasp = {"format": "stickslip-grasp/3", "bodies": bodies, "contacts": []}
        files = self.write("many", json.dumps(grasp)), self.c
        for program in [program for program in PROGRAMS if "check_node" not in program[-1] and "proved" not in program[-1]]:
            found, out, err = start(program, ["--states", "slip", *files], None, self.folder)
            self.assertEqual((found, out), (2, ""))
            self.assertRegex(err, "33 coordinates.* 30")

    def test_more_work_than_the_files_allow(self):
        # On the moment curve: so many planes bound a region of many more rays.
        planes = [["plane", *(t ** k for k in range(7))] for t in range(1, 49)]
        wrench = [0] * 6
        g = self.write("no_contacts.json", {"format": "stickslip-grasp/2", "wrench": wrench, "contacts": []})
        c = self.write("planes.json", certificate(0, wrench, verdict="unstable", tree=planes))

        def limit():  # a hang is a failure: it must not take all of the machine
            resource.setrlimit(resource.RLIMIT_CPU, (60, 60))

        for program in PROGRAMS:  # as text, this answer is in test_long_numbers
            done = subprocess.run([*program, g, c, "--json"], capture_output=True, check=False, preexec_fn=limit, encoding="utf-8")
            self.assertEqual((done.returncode, done.stderr), (NOT_JUDGED, ""), program)
            report = json.loads(done.stdout)
            self.assertEqual(report["result"], "not judged", program)
            self.assertRegex(report["found"], "it takes more than [0-9]+ .*, the most for (the )?[0-9]+ bytes")
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.assertLess(usage.ru_maxrss, 1_000_000, program)

    def test_long_numbers(self):
        """Inputs of most_work.py and of attacks: numbers of thousands of words, which cost what short ones never do. An answer
        may be any but a long wait, and all that count products of words have the same limit."""
        def limit():  # a hang is a failure: it must not take all of the machine
            resource.setrlimit(resource.RLIMIT_CPU, (60, 60))

        work = os.path.join(HERE, "..", "..", "corpus", "work")
        for name in sorted({name.split(".")[0] for name in os.listdir(work)}):
            files = [os.path.join(work, f"{name}.{kind}.json") for kind in ("grasp", "certificate")]
            length = sum(os.path.getsize(file) for file in files)
            for program in PROGRAMS:
                done = subprocess.run([*program, *files], capture_output=True, check=False, preexec_fn=limit, encoding="utf-8")
                self.assertEqual(done.stderr, "", (name, program))
                if done.returncode == NOT_JUDGED:
                    found = re.fullmatch("not judged\nwhy    it takes more than ([0-9]+) products of words, the most for "
                                         "(?:the )?([0-9]+) bytes(?: read)?\n", done.stdout)
                    self.assertIsNotNone(found, (name, program, done.stdout))
                    most, read = map(int, found.groups())
                    self.assertEqual(most, 5 * (10 ** 8 + read ** 2), (name, program))
                    self.assertLessEqual(read, length, (name, program))
                else:
                    self.assertEqual(done.stdout.split("\n")[:2], ["rejected", "rule   tree-short"], (name, program))
            if name == "long_exponents":
                self.assertEqual(done.returncode, NOT_JUDGED)

    def test_planes_of_loads(self):
        # FORMAT.md §9: the page's checker says that it does not judge them.
        text = certificate(0, [0, 0, 0], verdict="region", pieces=[], tree=[])
        text["question"]["plane"] = [[1, 0, 0], [0, 1, 0]]
        c = self.write("plane.json", text)
        for program in PROGRAMS:
            knows = os.path.basename(program[-1]) != "check_node.js"
            found, out, err = start(program, [self.g, c, "--plane", "1,0,0,0,1,0"])
            self.assertEqual((found, err), (1 if knows else NOT_JUDGED, ""), (program, out))
            if not knows:
                self.assertEqual(out, "not judged\nwhy    regions of a plane: stickslip-check judges them\n")
            found, _, err = start(program, [self.g, c])  # nobody asked about the plane
            self.assertEqual((found, "plane" in err), (1, False) if knows else (2, True), program)
        self.both([self.g, c, "--plane", "1,0,0"], 2, "is not UX,UY,UT,VX,VY,VT, two wrenches")

    def test_classes(self):
        # FORMAT.md §9: the page's checker says that it does not judge them.
        text = certificate(0, [0, 0, 0], verdict="must hold", rest=[], tree=[["leaf", 1, [0, 0, 0], [], []]])
        text["question"]["inertia"] = [0, 0, 1]
        c = self.write("class.json", text)
        for program in PROGRAMS:
            knows = os.path.basename(program[-1]) != "check_node.js"
            found, out, err = start(program, [self.g, c, "--wrench", "0,0,0", "--inertia", "0,0,1"])
            self.assertEqual((found, err), (1 if knows else NOT_JUDGED, ""), (program, out))
            if not knows:
                self.assertEqual(out, "not judged\nwhy    classes of rigid contacts: stickslip-check judges them\n")
            found, _, err = start(program, [self.g, c])  # nobody asked about the class
            self.assertEqual((found, "inertia" in err), (1, False) if knows else (2, True), program)
        self.both([self.g, c, "--inertia", "1,0"], 2, "is not X,Y,G2")

    @unittest.skipUnless(STICKSLIP_PROVED, "the others do not go through lists by recursion")
    def test_a_small_stack(self):
        """Nothing that goes through what a file lists may call itself for each element."""
        count = 5_000
        program = ["/bin/sh", "-c", 'ulimit -s 128; exec "$0" "$@"', STICKSLIP_PROVED]  # 26 bytes for each

        def accepts(grasp_file, options, proof):
            code, out, err = start(program, [self.write("g.json", grasp_file), self.write("c.json", proof), *options])
            self.assertEqual((code, err), (0, ""))
            self.assertRegex(out, "^accepted\n")

        def jaws(size, pairs):
            """Frictionless, and pressed together along y."""
            places = ([0] * size, [0, 1] + [0] * (size - 2))
            up, down = [0, 1] + [0] * (size - 2), [0, -1] + [0] * (size - 2)
            return {**grasp([*places] * pairs, [up, down] * pairs), "format": f"stickslip-grasp/{size - 1}",
                    "defaults": {"friction": 0, "preload": 1}, "wrench": [0] * (3 * size - 3)}

        for size, share in ((2, 0), (3, [0, 0, 0])):
            still = [0] * (3 * size - 3)
            many = jaws(size, count // 2)
            accepts(many, [], certificate(count, still, twist=still, shares=[[i, share] for i in range(count)]))
            load, leaf = [1] + still[1:], ["leaf", -1] + still[1:]
            for law in ("unilateral", "bilateral"):
                options = ["--wrench", ",".join(map(str, load)), "--normal-law", law]
                accepts(many, options, certificate(count, load, law=law, tree=[["separation", count - 1], leaf, leaf]))
                nodes = [["plane", 0, 1] + still[1:]] * 250
                accepts(many, options, certificate(count, load, law=law, tree=nodes + [leaf] * 251))
            # At rest, and by degree: along y the jaws push back, and all other motions are free.
            along_y = [[int(j == k == 1) for k in range(len(still))] for j in range(len(still))]
            rest = {"rest": [[i, share] for i in range(count)],
                    "answers": [[i, [share] * len(still)] for i in range(count)], "reach": still}
            degree = {"twist": still, "walls": [[0, 2] + still[2:]], "direction": along_y,
                      "tree": [["leaf", 0, 1] + still[2:], ["leaf", 0, -1] + still[2:]]}
            for part in (rest, degree):
                accepts(many, [], certificate(count, still, parts=[part]))
            accepts(many, ["--normal-law", "bilateral"],
                    certificate(count, still, law="bilateral", parts=[degree]))
        few, still = jaws(2, 1), [0, 0, 0]
        ends = [[k, still, []] for k in range(count)] + [[None, still, []]]
        accepts(few, ["--preload-direction", "scale"],
                certificate(2, still, preload_direction="scale", resisted=[[0, None]],
                            segments=[ends[:2], *([end] for end in ends[2:])], tree=[]))

    def test_usage(self):
        for arguments in ([], ["g"], ["g", "c", "d"], ["-", "-"], ["g", "c", "--bogus"],
                          ["g", "c", "--wrench"],
                          ["g", "c", "--wrench", "1,2,x"], ["g", "c", "--wrench", ""],
                          ["g", "c", "--preload", "nan"], ["g", "c", "--normal-law", "none"],
                          ["g", "c", "--preload-direction", "Scale"],
                          ["g", "c", "--preload-direction", ""],
                          ["g", "c", "--snap-normals", "1e-9"], ["g", "c", "--js"], ["g", "c", "-x"],
                          ["g", "c", "--json=1"], ["g", "c", "--help=1"], ["g", "c", "--=1"]):
            self.both(arguments, 2, "; try ")

    def test_as_many_numbers_as_the_grasp_has(self):
        for numbers in ("1", "1,2", "1,2,3,4", "1,2,3,4,5,6"):
            for option in ("--wrench", "--direction"):
                self.both([self.g, self.c, option, numbers], 2, option[2:])

    def test_help_is_asked_for_before_the_files(self):
        for arguments in (["-h"], ["--help"], ["--json", "--help", "g"], [*UP, "-h", "g", "c"]):
            self.both(arguments, 0, "--preload-direction")
        # A file's name must not make an exit code 0.
        for name in ("-h", "--help"):
            self.both([self.g, name], 2, "No such file")
            self.both([self.g, name, *UP], 2, "No such file")
            self.both(["--", name, name], 2, "No such file")
            self.write(name, up())
            self.both([self.g, name, *UP], 0, "accepted\n")
            self.both([*UP, "--", self.g, name], 0, "accepted\n")
            self.both([self.g, name], 1, "question-wrench")

    def test_no_options_after_two_dashes(self):
        self.write("--json", up())
        self.both([*UP, "--", self.g, "--json"], 0, "accepted\n")
        self.both([*UP, self.g, "--", "--json"], 0, "accepted\n")
        self.both([*UP, "--", self.g, self.c, "--json"], 2, "found 3")
        self.both(["--", self.g, self.c, "--"], 2, "found 3")
        self.both([*UP, "--json", "--", self.g, self.c], 0, '{"result": "accepted"')

    def test_torque_is_short_for_a_wrench(self):
        c = self.write("turned.json", certificate(3, [0, 0, 3], tree=[["leaf", 0, 0, 1]]))
        found = [self.both([self.g, c, *words], 1, "leaf-bound")
                 for words in (["--wrench", "0,0,3"], ["--torque", "3"], ["--torque=3"])]
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0], found[2])
        self.both([self.g, c, "--torque", "1,2"], 2, "--torque: ")

    def test_json_reports(self):
        keys = ["result", "rule", "node", "path", "found", "verdict", "box", "nodes", "leaves",
                "resisted", "refuted", "question"]
        question = {"contacts": 3, "wrench": ["0", "11/10", "0"], "preload": "1",
                    "normal_law": "unilateral", "direction": None, "preload_direction": None,
                    "uncertain": None}
        for out in self.both([self.g, self.c, *UP, "--json"], 0):
            self.assertEqual(list(json.loads(out).items()), list(zip(
                keys, ["accepted", None, None, None, None, "unstable", False, 5, 3, None,
                       None, question])))
        short = self.write("short.json", up(UP_TREE[:-1]))
        for out in self.both([self.g, short, *UP, "--json"], 1):
            report = json.loads(out)
            self.assertTrue(report.pop("found"))
            del report["node"], report["path"]  # stickslip-proved says neither
            self.assertEqual(list(report.values()), ["rejected", "tree-short", *[None] * 7])
        bad = self.write("bad.json", up([["slip", "0"]]))
        for out in self.both([self.g, bad, *UP, "--json"], 2):
            report = json.loads(out)
            self.assertIn("tree[0]", report.pop("path"))
            self.assertTrue(report.pop("found"))
            self.assertEqual(list(report.values()), ["malformed", *[None] * 9])

    @unittest.skipUnless(STICKSLIP_CHECK, "STICKSLIP_CHECK names no program")
    def test_batch(self):
        program = [STICKSLIP_CHECK, "--batch"]
        question = {"options": list(UP), "certificate": json.dumps(up()), "grasp": json.dumps(FIG1)}
        self.assertEqual(start(program, [], b""), (0, "", ""))
        one = start([STICKSLIP_CHECK], [self.g, self.c, *UP, "--json"])[1]
        line = json.dumps(question) + "\n"
        code, out, err = start(program, [], (line + json.dumps({**question, "options": []}) + "\n" + line).encode())
        self.assertEqual((code, out[:len(one)], out[-len(one):], err), (0, one, one, ""))
        self.assertEqual([json.loads(answer)["rule"] for answer in out.splitlines()], [None, "question-wrench", None])
        # A character is a byte: of a name in UTF-8 two, and half of one is no text.
        for name, result in (("\xc3\xa9", "accepted"), ("\xe9", "malformed")):
            named = json.dumps(FIG1).replace("{", '{"name": "%s", ' % name, 1)
            out = start(program, [], json.dumps({**question, "grasp": named}).encode())[1]
            self.assertEqual(json.loads(out)["result"], result)
        # Where a line is no question, the batch ends.
        for bad, says in (("[]", "question 2: line 1, column 1: expected an object"),
                          (json.dumps({"grasp": ""}), "expected the members grasp, certificate and options"),
                          (json.dumps({**question, "grasp": 1}), 'grasp: found the number "1", expected a string'),
                          (json.dumps({**question, "grasp": "\u0100"}), "expected characters that each stand for a byte"),
                          (json.dumps({**question, "law": "x"}), "expected the members grasp, certificate and options"),
                          (json.dumps({**question, "options": ["--wrench"]}), "question 2: --wrench needs a value; try "),
                          (json.dumps({**question, "options": ["third"]}), "found 3"),
                          (json.dumps({**question, "options": ["--batch"]}), "--batch takes no other words")):
            code, out, err = start(program, [], (line + bad + "\n" + line).encode())
            self.assertEqual((code, out), (2, one), bad)
            self.assertIn(says, err)
        for words in (["g", "c"], ["--json"], ["--", "g"]):
            self.assertEqual(start(program, words, b"")[::2], (
                2, "stickslip-check: --batch takes no other words; try stickslip-check --help\n"))

    def test_answers_that_cannot_be_written(self):
        for program in PROGRAMS:
            for arguments in ([self.g, self.c, *UP], [self.g, self.c, *UP, "--json"], ["--help"]):
                with open("/dev/full", "wb") as full:
                    done = subprocess.run([*program, *arguments], stdout=full, check=False,
                                          stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 2, (program, arguments))
                self.assertIn(b"No space left on device", done.stderr)

    def test_closed_and_full_streams(self):
        """An answer that cannot be written is 2, said once, and so is one of which nobody can be told."""
        def run(program, words, redirections):
            return subprocess.run(["/bin/sh", "-c", f'exec "$0" "$@" {redirections}', *program, *words],
                                  capture_output=True, check=False, encoding="utf-8")

        for program in PROGRAMS:
            for words in ([self.g, self.c, *UP], [self.g, self.c, *UP, "--json"], [self.g, "absent"], ["--help"], ["--unknown"]):
                fails = words[-1] in ("absent", "--unknown")
                for redirections in (">&-", ">/dev/full", ">/dev/full 2>&-", ">/dev/full 2>/dev/full", ">&- 2>&-", "2>/dev/full", "2>&-"):
                    stdout_fails = redirections.startswith(">")
                    if program[0] == STICKSLIP_NODE and redirections.startswith(">&-"):
                        stdout_fails = False  # node opens /dev/null there before anything of ours runs
                    done = run(program, words, redirections)
                    self.assertEqual(done.returncode, 2 if fails or stdout_fails else 0, (program, words, redirections, done))
                    if "2>" not in redirections and (fails or stdout_fails):
                        self.assertEqual(done.stderr.count("\n"), 1, (program, words, redirections, done.stderr))

    def test_a_closed_pipe_is_no_answer_and_no_noise(self):
        with subprocess.Popen([*PROGRAMS[0], self.g, self.c, *UP], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            process.stdout.close()
            self.assertEqual(process.stderr.read(), b"")
        self.assertEqual(process.returncode, 2)

    def test_an_unforeseen_error_is_no_rejection(self):
        original = check.check_tree
        check.check_tree = lambda *_: {}["missing"]
        try:
            code, out, err = in_process([self.g, self.c, *UP])
        finally:
            check.check_tree = original
        self.assertEqual((code, out), (2, ""))
        self.assertIn("internal error", err)


if __name__ == "__main__":
    unittest.main()
