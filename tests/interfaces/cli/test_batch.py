# SPDX-License-Identifier: GPL-3.0-or-later
"""stickslip batch: order, bad lines, resuming, certificates."""

import json
import os
import random
import unittest

from test_cli import BAD_INPUT, CHECK, DONE, HERE, SANITIZED, UNDECIDED, Case, checkers, read, run, stickslip

# Of tests/support, which test_cli adds to the path.
from results import checked


def grasp(seed):
    """Fig. 1 with another load each time; stable up to w_y = 1."""
    return {"format": "stickslip-grasp/1", "name": f"number {seed}",
            "defaults": {"friction": "1/2", "preload": 1},
            "contacts": [{"position": [-1, 0], "normal": [1, 0]},
                         {"position": [0, -1], "normal": [0, 1]},
                         {"position": [1, 0], "normal": [-1, 0]}],
            "wrench": [0, f"{seed}/10", 0]}


def expected(seed):
    return "stable" if seed <= 10 else "unstable"


class Batch(Case):
    def lines(self, seeds, bad=()):
        text = "".join(json.dumps(grasp(seed)) + "\n" for seed in seeds)
        return self.write("grasps.jsonl", text)

    def results(self, *words, code=DONE, stdin=None, said=""):
        found, out, err = stickslip("batch", *words, stdin=stdin)
        self.assertEqual((found, err), (code, said))
        return [json.loads(line) for line in out.splitlines()]

    def test_results_are_in_order_and_right(self):
        seeds = [random.Random(1).randint(0, 20) for _ in range(300)]
        path = self.lines(seeds)
        results = self.results(path)
        self.assertEqual([r["line"] for r in results], list(range(1, 301)))
        self.assertEqual([r["verdict"] for r in results], [expected(s) for s in seeds])
        self.assertEqual([r["name"] for r in results], [f"number {s}" for s in seeds])
        for threads in (1, 3, 8):
            self.assertEqual(self.results(path, "--threads", threads), results)
        with open(path, encoding="utf-8") as file:
            self.assertEqual(self.results("-", stdin=file.read()), results)

    def test_a_second_answer_is_that_of_decide(self):
        folder = os.path.join(HERE, "..", "..", "corpus", "everyday")
        files = [os.path.join(folder, name) for name in ("round_disc.json", "cylinder_too_heavy.json")]
        path = self.write("everyday.jsonl", "".join(json.dumps(json.loads(read(file))) + "\n" for file in files))
        _, out, _ = stickslip("batch", path)
        for file, line in zip(files, out.splitlines()):
            _, said, _ = stickslip("decide", file, "--json", "--no-warnings")
            within = json.loads(said)["within"]
            self.assertEqual(json.loads(line)["within"], {key: within[key] for key in ("verdict", "max_motion")})

    def test_options_apply_to_every_line(self):
        path = self.lines([0, 20])
        self.assertEqual([r["verdict"] for r in self.results(path, "--wrench", "0,1/2,0")],
                         ["stable", "stable"])
        self.assertEqual([r["verdict"] for r in
                          self.results(path, "--wrench", "0,1/2,0", "--preload", 0)],
                         ["unstable", "unstable"])

    def pinch(self, preload, load=0, in_space=False, **more):
        """Two fingers with friction 1/2. In the plane one slips where (force y +- torque) / 2 = (P - force x / 2) / 2."""
        zero = [0] if in_space else []
        return {"format": "stickslip-grasp/2", "defaults": {"friction": "1/2", "preload": preload},
                "contacts": [{"position": [side, 0, *zero], "normal": [-side, 0, *zero]} for side in (-1, 1)],
                "wrench": [0, load, *zero, *zero, *zero, 0], **more}

    def assert_proved(self, line, result, *options):
        """By each checker, about the line itself; of a larger ball the certificate is none."""
        file = self.write("one.json", line)
        ball = result.get("uncertain")
        said = result.get("verdict", result.get("class")) + (", for every grasp in the box" if ball or '"min"' in json.dumps(line) else "")
        words = (file, result["certificate"], *options)
        self.accepted(*words, *(("--uncertain", ball) if ball else ()), verdict=f"{said}\n")
        for checker in checkers(result["certificate"]) if ball else ():
            code, out, err = run(*checker, *words, "--uncertain", ball.replace("ball:", "ball:1"))
            self.assertNotEqual(code, DONE, out + err)

    def test_each_line_is_answered_as_by_its_command(self):
        """Whose answers have their closed forms in tests of their own."""
        around = {"min": "49/100", "max": "51/100"}
        foot = {**self.pinch(0), "contacts": [{"position": [0, 0], "normal": [0, 1]}]}  # a load that pulls is not resisted
        solid = self.pinch(1, in_space=True)
        solid["contacts"] += [{"position": [0, side, 0], "normal": [0, -side, 0]} for side in (-1, 1)]
        blocks = {"format": "stickslip-grasp/3", "bodies": [{"name": "lower"}, {"name": "upper"}],
                  "contacts": [{"position": [x, y], "normal": [0, 1], "friction": mu, "of": of, **by}
                               for x, y, mu, of, by in ((-4, 0, 9, "lower", {}), (4, 0, 9, "lower", {}),
                                                        (-1, 1, "1/3", "upper", {"by": "lower"}), (1, 1, "1/3", "upper", {"by": "lower"}))],
                  "loads": [{"body": "lower", "weight": 100, "at": [0, 0]}, {"body": "upper", "weight": 2, "at": [0, 1]}]}
        floors = [{"format": "stickslip-grasp/1", "defaults": {"friction": "1/2"}, "wrench": load,
                   "contacts": [{"position": [side, -1], "normal": [0, 1]} for side in (-1, 1)]}
                  for load in ([0, -1, 0], ["1/2", -1, 0], ["1/2", "-0.999", 0])]
        crate = {**solid, "contacts": [{"position": [x, y, -1], "normal": [0, 0, 1]} for x in (-1, 1) for y in (-1, 1)],
                 "wrench": [0, 0, -1, 0, 0, 0]}
        uncertain = [{**self.pinch(1, load, in_space), "defaults": {"friction": around, "preload": 1}}
                     for in_space in (False, True) for load in ("-97/100", -1, "-103/100")]
        for command, options, proved, lines in (
                ("decide", (), (), [self.pinch(1), self.pinch(1, "3/2"), *uncertain, solid, blocks]),
                ("quality", ("--length", "3/2", "--accuracy", "2%"), (), [self.pinch("1/3"), self.pinch(1, "3/2"), foot, *([] if SANITIZED else [solid])]),
                ("quality", ("--at-most", "1/4"), ("--preload", "2"), [self.pinch(1)]),
                ("quality", ("--body", "upper", "--about", "0,1", "--length", "1/2"), (), [blocks]),
                ("compare", (), ("--inertia", "0,1,2"), floors), ("compare", (), ("--inertia", "0,0,0,1,1,1"), [crate])):
            path = self.write("lines.jsonl", "".join(json.dumps(line) + "\n" for line in lines))
            way = {"decide": (), "quality": ("--quality",), "compare": ("--class",)}[command]
            results = self.results(path, *way, *options, *proved, "--certificates", self.path("proofs"))
            for line, result in zip(lines, results):
                one = self.json(command, self.write("one.json", line), *options, *proved)
                self.assertEqual(set(result) - {"certificate", "uncertain"} - set(one), {"line", "key", "check"})
                for member in set(result) & set(one) - {"uncertain"}:
                    self.assertEqual(result[member], one[member], (command, member, line))
                self.assertEqual("proved" in result, command == "quality" and one["verdict"] == "stable")
                for member in ("refuted", "scales", "not_resisted") if "proved" in result else ():
                    self.assertEqual(result.get(member), one.get(member), line)
                if "uncertain" in result:
                    self.assertEqual(result["uncertain"].split(":")[1], result["proved"])
                self.assertEqual("certificate" in result, result.get("verdict") != "fragile")
                if "certificate" in result:
                    self.assert_proved(line, result, *proved)
        path = self.write("lines.jsonl", json.dumps(floors[0]) + "\n" + json.dumps(crate) + "\n")
        results = self.results(path, "--class", "--certificates", self.path("proofs"))
        for line, result, inertia in zip((floors[0], crate), results, ("0,0,1", "0,0,0,1,1,1")):  # of the length 1
            self.assert_proved(line, result, "--inertia", inertia)

    def test_lines_that_have_no_such_answer(self):
        path = self.write("g.jsonl", json.dumps(self.pinch({"min": 1, "max": 2})) + "\n")
        said = f"stickslip: {path}: 1 of 1 line could not be read, the first is line 1; their results say why\n"
        [found] = self.results(path, "--quality", code=BAD_INPUT, said=said)
        self.assertIn("one grasp", found["error"]["remedy"])
        self.fails("batch", path, "--inertia", "0,0,1", naming=["--class"])
        self.fails("batch", path, "--class", "--inertia", "0,0,0", naming=["--inertia"])

    def test_a_grasp_on_many_lines(self):
        path = self.write("g.json", json.dumps(grasp(1), indent=1))
        self.fails("batch", path, "-o", self.path("out"), naming=["one grasp a line"])
        path = self.write("g.jsonl", json.dumps(grasp(1)) + "\n{\n")
        self.assertNotIn("one grasp a line", self.fails("batch", path, "-o", self.path("more")))

    def test_every_option_of_a_quality_is_in_the_key(self):
        path, out = self.write("g.jsonl", json.dumps(self.pinch(1)) + "\n"), self.path("out.jsonl")
        questions = [(), ("--class",), ("--class", "--inertia", "0,1,2"), ("--quality",), *(("--quality", *more) for more in (
            ("--length", 2), ("--about", "0,2"), ("--about", "2,0"), ("--at-most", 2), ("--at-most", "1/2"),
            ("--accuracy", "2%"), ("--accuracy", "1/2"), ("--node-limit", 10 ** 6)))]
        keys = {self.results(path, *words)[0]["key"] for words in questions}
        said = f"stickslip: {path}: 1 of 1 line could not be read, the first is line 1; their results say why\n"
        keys |= {self.results(path, "--quality", "--body", name, code=BAD_INPUT, said=said)[0]["key"] for name in ("cup", "lid")}
        self.assertEqual(len(keys), len(questions) + 2)
        self.assertEqual(self.results(path, "--quality", "--about", "0,0", "--length", "1.0", "--accuracy", "1/100"),
                         self.results(path, "--quality"))
        self.assertEqual(stickslip("batch", path, "--quality", "-o", out), (DONE, "", ""))
        self.assertEqual(stickslip("batch", path, "--quality", "-o", out, "--resume"), (DONE, "", ""))
        self.fails("batch", path, "-o", out, "--resume", naming=["options"])
        self.fails("batch", path, "--quality", "--length", 2, "-o", out, "--resume", naming=["options"])

    def test_states_are_counted_as_by_the_command(self):
        """Of a grasp in the plane, a cube, and two bodies, one of which is alone; under no load."""
        cube = {"format": "stickslip-grasp/2", "name": "cube", "defaults": {"friction": "1/2"}, "wrench": [0] * 6,
                "contacts": [{"position": [x, y, 0], "normal": [0, 0, 1]} for x in (-1, 1) for y in (-1, 1)]}
        blocks = {"format": "stickslip-grasp/3", "bodies": [{"name": "lower"}, {"name": "upper"}],
                  "contacts": [{"position": [x, 1], "normal": [0, 1], "friction": 1, "of": "upper", **by} for x, by in ((-1, {"by": "lower"}), (2, {}))]}
        alone = {**blocks, "bodies": [{"name": "upper"}], "contacts": [{"position": [0, 0], "normal": [0, 1], "friction": 1, "of": "upper"}]}
        lines = [grasp(1), cube, blocks, alone]
        path = self.write("lines.jsonl", "".join(json.dumps(line) + "\n" for line in lines))
        found = {}
        for options in ((), ("--modes", "full"), ("--modes", "closed", "--lines", "1"), ("--modes", "cs"), ("--modes", "ss")):
            results = found[options] = self.results(path, "--states", *options)
            for line, result in zip(lines, results):
                one = self.write("one.json", line)
                self.assertEqual(set(result), {"line", "key", "name", "by_dimension", "distinct_states", "distinct_planes", "rank", "check"})
                flat = not options and len(result["by_dimension"]) == 4  # by another enumerator, unless lines are named
                if flat:
                    self.assertEqual(result["distinct_states"], self.json("states", one)["distinct_states"])
                answer = self.json("states", one, *options, *(("--lines", "1") if flat else ()))
                self.assertEqual({field: result[field] for field in ("by_dimension", "distinct_states", "distinct_planes", "rank")},
                                 {field: answer[field] for field in ("by_dimension", "distinct_states", "distinct_planes", "rank")})
        self.assertEqual([result["distinct_states"] for result in found[("--modes", "ss")]][1], 196)
        keys = {results[0]["key"] for results in found.values()}
        keys |= {self.results(path, "--states", *more, code=code)[0]["key"]
                 for more, code in ((("--snap",), DONE), (("--limit", 5), UNDECIDED), (("--lines", 1), BAD_INPUT)) if code != BAD_INPUT}
        self.assertEqual(len(keys), len(found) + 2)

    def test_states_have_a_limit_of_each_grasp(self):
        path, out = self.lines([1, 2]), self.path("out.jsonl")
        [whole, _] = self.results(path, "--states")
        self.assertEqual(whole["distinct_states"], 27)
        self.assertEqual(self.results(path, "--states", "--limit", 27)[0]["by_dimension"], whole["by_dimension"])
        for result in self.results(path, "--states", "--limit", 26, code=UNDECIDED):
            self.assertEqual((sum(result["by_dimension"]), result["distinct_states"]), (26, 26))
            self.assertEqual(result["limit"], "there are more than 26 states")
        words = ("batch", path, "--states", "--limit", 26, "-o", out)
        self.assertEqual([stickslip(*words), stickslip(*words, "--resume")], [(UNDECIDED, "", "")] * 2)

    def test_states_that_nobody_can_count(self):
        """Errors of a line are its result, and a warning is that of the command."""
        contact = {"position": [0, 0, 1], "normal": [0, 0, 1]}
        solid = {"format": "stickslip-grasp/2", "defaults": {"friction": 1}, "contacts": [contact], "wrench": [0] * 6}
        tilted = {**solid, "contacts": [{"position": [x, y, 0], "normal": [0, tilt, 1]} for x, y, tilt in ((-1, -1, 0), (-1, 1, 0), (1, -1, 0), (1, 1, "1e-6"))]}
        path = self.write("lines.jsonl", "".join(json.dumps(line) + "\n" for line in (solid, tilted, {**solid, "contacts": [{**contact, "friction": [1, 2]}]})))
        said = f"stickslip: {path}: {{}} of 3 lines could not be read, the first is line {{}}; their results say why\n"
        all_of_them = said.format(3, 1)[:-1] + "; a batch has one grasp a line, while a file of one grasp is decided by itself\n"
        results = self.results(path, "--states", "--lines", "3", code=BAD_INPUT, said=all_of_them)
        self.assertEqual(results[0]["error"]["place"], "lines")
        results = self.results(path, "--states", "--lines", "3", "--snap", code=BAD_INPUT, said=said.format(1, 3))
        self.assertEqual(results[0]["distinct_states"], 13)
        results = self.results(path, "--states", "--modes", "cs", code=BAD_INPUT, said=said.format(1, 3))
        answer = self.json("states", self.write("one.json", tilted), "--modes", "cs")
        self.assertEqual((results[1]["distinct_states"], results[1]["warnings"]), (16, answer["warnings"]))
        for words in (("--modes", "cs"), ("--lines", "1"), ("--snap",), ("--limit", "1"), ("--class", "--states"), ("--quality", "--states"),
                      ("--certificates", self.path("no"), "--states"), ("--wrench", "0,0,0", "--states"), ("--case", "x", "--states"),
                      ("--preload", "1", "--states"), ("--normal-law", "bilateral", "--states")):
            self.fails("batch", path, *words, naming=[words[0], "--states"])

    def test_measures_are_the_rows_of_compare(self):
        """Of a grasp in the plane, a crate, and one body alone in a file of several."""
        crate = {"format": "stickslip-grasp/2", "name": "crate", "defaults": {"friction": "1/2"}, "wrench": [0, 0, -1, 0, 0, 0],
                 "contacts": [{"position": [x, y, -1], "normal": [0, 0, 1]} for x in (-1, 1) for y in (-1, 1)]}
        alone = {"format": "stickslip-grasp/3", "bodies": [{"name": "upper"}], "loads": [{"body": "upper", "weight": 1, "at": [0, 0]}],
                 "contacts": [{"position": [x, 0], "normal": [0, 1], "friction": 1, "of": "upper"} for x in (-1, 2)]}
        lines = [grasp(1), {**crate, "max_motion": [1] * 6}, alone, self.pinch(1, "1/2")]
        quick = ("--methods", "passive-equilibrium,PGR,least-normal-forces,distance-of-the-centroid")
        for options, about in (((), (0, 3)), (quick, (0, 1, 2, 3)), ((*quick, "--length", "3/2", "--max-force", 2, "--accuracy", "5%"), (0, 1, 2, 3)),
                               ((*quick, "--inertia", "1,2,3", "--wrench", "0,-2,0", "--preload", "1/3", "--normal-law", "bilateral"), (0, 2, 3)),
                               ((*quick, "--edges", 4, "--inertia", "1,2,3,4,5,6"), (1,))):
            some = self.write("some.jsonl", "".join(json.dumps(lines[i]) + "\n" for i in about))
            for i, result in zip(about, self.results(some, "--measures", *options)):
                answer = self.json("compare", self.write("one.json", lines[i]), *options)
                members = ("name", "length", "inertia", "class", "methods")
                self.assertEqual(set(result), {"line", "key", "check", *members})
                self.assertEqual({name: result[name] for name in members}, {name: answer[name] for name in members})
                self.assertEqual(len(result["methods"]) == 4, bool(options))
        one = self.lines([1])
        others = ((), ("--methods", "PCR"), ("--methods", "PCR,PGR"), ("--length", 1), ("--length", 2), ("--max-force", 2), ("--accuracy", "2%"),
                  ("--inertia", "0,0,1"), ("--inertia", "0,0,2"), ("--node-limit", 7), ("--preload", 7))
        keys = {self.results(one, "--measures", *options)[0]["key"] for options in others}
        self.assertEqual(len(keys | {self.results(one)[0]["key"]}), len(others) + 1)

    def test_measures_of_lines_that_have_none(self):
        blocks = {"format": "stickslip-grasp/3", "bodies": [{"name": "lower"}, {"name": "upper"}],
                  "contacts": [{"position": [x, 1], "normal": [0, 1], "friction": 1, "of": "upper", "by": "lower"} for x in (-1, 2)]}
        path = self.write("lines.jsonl", "".join(json.dumps(line) + "\n" for line in (grasp(1), blocks, self.pinch({"min": 1, "max": 2}))))
        said = f"stickslip: {path}: 2 of 3 lines could not be read, the first is line 2; their results say why\n"
        words = ("--measures", "--methods", "PCR")
        results = self.results(path, *words, code=BAD_INPUT, said=said)
        self.assertEqual([row["method"] for row in results[0]["methods"]], ["potential contact robustness"])
        self.assertEqual((results[1]["error"]["place"], "--class" in results[1]["error"]["remedy"]), ("--measures", True))
        self.assertIn("preload", results[2]["error"]["place"])
        one = self.lines([1])
        said = f"stickslip: {one}: 1 of 1 line could not be read, the first is line 1; their results say why\n"
        for option, value in (("--edges", "4"), ("--max-force", "1,2"), ("--inertia", "1,2,3,4,5,6")):
            [result] = self.results(one, *words, option, value, code=BAD_INPUT, said=said)
            self.assertEqual(result["error"]["place"], option)
        # At the limit of the search the bounds are those that are known.
        stiff = {"format": "stickslip-grasp/1", "defaults": {"friction": "1/2"}, "wrench": [0, "-1/8", 0],
                 "contacts": [{"position": p, "normal": n, "stiffness": k} for p, n, k in
                              (([-1, 0], [1, 0], 3), ([1, "1/2"], [-1, 0], 1), ([0, -1], [0, 1], 2), (["1/3", 1], [0, -1], 1))]}
        one = self.write("stiff.jsonl", json.dumps(stiff) + "\n")
        limited, whole = (self.results(one, "--measures", "--methods", "PGR", "--accuracy", "1/1000000", *limit)[0]["methods"][0]["evidence"]
                          for limit in (("--node-limit", 1), ()))
        self.assertEqual((limited["complete"], whole["complete"]), (False, True))
        for option, value in (("--methods", "PCR,nonsense"), ("--max-force", "0"), ("--accuracy", "0"), ("--length", "0"), ("--inertia", "0,0,0")):
            self.fails("batch", path, "--measures", option, value, naming=[option])
        for option, value, other in (("--methods", "PCR", "--measures"), ("--max-force", "1", "--measures"), ("--edges", "4", "--measures"),
                                     ("--length", "1", "--quality or --measures"), ("--accuracy", "1%", "--quality or --measures"),
                                     ("--inertia", "0,0,1", "--class or --measures")):
            self.fails("batch", path, option, value, naming=[option, *other.split(" or ")])
        for other in (("--class",), ("--quality",), ("--states",), ("--certificates", self.path("no"))):
            self.fails("batch", path, *other, "--measures", naming=[other[0], "--measures"])

    def test_an_undecided_line_has_no_quality(self):
        path, out = self.lines([20]), self.path("out.jsonl")
        words = ("batch", path, "--quality", "--node-limit", 1, "-o", out)
        self.assertEqual(stickslip(*words), (UNDECIDED, "", ""))
        with open(out, encoding="utf-8") as file:
            self.assertEqual(set(json.load(file)), {"line", "key", "name", "verdict", "limit", "check"})
        self.assertEqual(stickslip(*words, "--resume"), (UNDECIDED, "", ""))

    def test_options_of_a_quality_that_make_no_sense(self):
        path = self.lines([1])
        for words, naming in ((("--length", "0"), "--length"), (("--at-most", "-1"), "--at-most"), (("--accuracy", "2"), "--accuracy"),
                              (("--about", "x"), "--about")):
            self.fails("batch", path, "--quality", *words, naming=[naming])
        for words in (("--length", "1"), ("--about", "0,0"), ("--body", "cup"), ("--at-most", "1"), ("--accuracy", "1%"),
                      ("--class", "--quality")):
            self.fails("batch", path, *words, naming=[words[0], "--quality"])

    def test_bad_lines_are_reported_and_the_rest_goes_on(self):
        good = json.dumps(grasp(3))
        bad = ["{", "[]", json.dumps({**grasp(1), "wrench": [0, 0]}),
               json.dumps({**grasp(1), "colour": 1}), "\x00", good + good]
        text = "\n".join([good, *bad, "", good]) + "\n"
        results = self.results("-", code=BAD_INPUT, stdin=text, said=(
            "stickslip: <stdin>: 6 of 8 lines could not be read, the first is line 2; their "
            "results say why\n"))
        self.assertEqual([r["line"] for r in results], [1, 2, 3, 4, 5, 6, 7, 9])
        self.assertEqual([r.get("verdict") for r in results],
                         ["stable", *[None] * len(bad), "stable"])
        self.assertEqual(results[3]["error"]["place"], "wrench")
        self.assertIn("colour", results[4]["error"]["problem"])

    def test_undecided(self):
        results = self.results(self.lines([20, 0]), "--node-limit", 1, code=UNDECIDED)
        self.assertEqual(results[0]["verdict"], "undecided")
        self.assertIn("1 nodes", results[0]["limit"])

    def test_nothing(self):
        said = "stickslip: <stdin>: the file is empty, there is no grasp in it\n"
        self.assertEqual(self.results("-", stdin="\n \n", said=said), [])

    def test_resume_after_every_interruption(self):
        seeds = list(range(14))
        path = self.lines(seeds)
        out = self.path("out.jsonl")
        self.assertEqual(stickslip("batch", path, "-o", out), (DONE, "", ""))
        with open(out, "rb") as file:
            whole = file.read()
        for length in [0, 1, *range(7, len(whole), 97), len(whole) - 1, len(whole)]:
            with open(out, "wb") as file:
                file.write(whole[:length])
            self.assertEqual(stickslip("batch", path, "-o", out, "--resume"), (DONE, "", ""))
            with open(out, "rb") as file:
                self.assertEqual(file.read(), whole, length)

    def test_finished_lines_are_not_decided_again(self):
        path, out = self.lines([1, 2, 3]), self.path("out.jsonl")
        stickslip("batch", path, "-o", out)
        with open(out, encoding="utf-8") as file:
            marked = file.read().replace("number 1", "MARK")
        with open(out, "w", encoding="utf-8") as file:
            file.write("".join(checked(line) + "\n" for line in marked.splitlines()[:2]))
        stickslip("batch", path, "-o", out, "--resume")
        with open(out, encoding="utf-8") as file:
            results = [json.loads(line) for line in file]
        self.assertEqual([r["name"] for r in results], ["MARK", "number 2", "number 3"])

    def test_results_that_were_changed_are_decided_again(self):
        path, out = self.lines([1, 2, 20, 3]), self.path("out.jsonl")
        self.assertEqual(stickslip("batch", path, "-o", out), (DONE, "", ""))
        with open(out, encoding="utf-8") as file:
            whole = file.read()
        for line in whole.splitlines():
            self.assertEqual(checked(line), line)
        first = whole.splitlines()[0]
        for number, changed in ((3, whole.replace("unstable", "ununstable")), (3, whole.replace("unstable", "stable")),
                                (2, whole.replace("number 2", "number 4")), (1, whole.replace('"line":1', '"line":5')),
                                (1, whole.replace(first, first[:first.index(',"check"')] + "}"))):
            self.assertNotEqual(changed, whole)
            with open(out, "w", encoding="utf-8") as file:
                file.write(changed)
            note = (f"stickslip: {out}: line {number}: this result is not as a batch has written it; it is decided again, "
                    "and those behind it\n")
            self.assertEqual(stickslip("batch", path, "-o", out, "--resume"), (DONE, "", note))
            with open(out, encoding="utf-8") as file:
                self.assertEqual(file.read(), whole)
        # Of another question it is no result to go on from, changed or not: nothing is cut.
        other = whole.replace("unstable", "ununstable")
        with open(out, "w", encoding="utf-8") as file:
            file.write(other)
        self.fails("batch", self.lines([1, 2, 9, 3]), "-o", out, "--resume", naming=["result of line 3", "not that of this line"])
        with open(out, encoding="utf-8") as file:
            self.assertEqual(file.read(), other)

    def test_resumed_or_not_the_exit_code_is_that_of_all_lines(self):
        good, bad = json.dumps(grasp(20)), "{"
        for lines, options, code in (([good, bad, good], [], BAD_INPUT),
                                     ([good, good], ["--node-limit", 1], UNDECIDED)):
            path = self.write("mixed.jsonl", "\n".join(lines) + "\n")
            said = (f"stickslip: {path}: 1 of 3 lines could not be read, the first is line 2; "
                    "their results say why\n") if code == BAD_INPUT else ""
            out = self.path(f"out-{code}.jsonl")
            words = ["batch", path, "-o", out, *options]
            self.assertEqual(stickslip(*words), (code, "", said))
            self.assertEqual(stickslip(*words, "--resume"), (code, "", said))

    def test_other_questions_are_not_mixed(self):
        path, out = self.lines([1, 2, 3]), self.path("out.jsonl")
        stickslip("batch", path, "-o", out)
        with open(out, "rb") as file:
            before = file.read()
        self.fails("batch", path, "-o", out, naming=["exists", "--resume"])
        self.fails("batch", path, "-o", out, "--resume", "--preload", 2, naming=["options"])
        self.fails("batch", self.lines([1, 9, 3]), "-o", out, "--resume", naming=["line 2"])
        self.fails("batch", self.lines([1]), "-o", out, "--resume", naming=["not that of"])
        self.fails("batch", path, "-o", path, "--resume", naming=["the input"])
        other = self.write("other.jsonl", json.dumps(grasp(1)) + "\n")
        self.fails("batch", path, "-o", other, "--resume", naming=["not a result"])
        with open(out, "rb") as file:
            self.assertEqual(file.read(), before)

    def test_certificates_are_accepted(self):
        path, folder = self.lines([10, 11]), self.path("proofs")
        results = self.results(path, "--certificates", folder)
        for seed, result in zip((10, 11), results):
            file = self.write("g.json", grasp(seed))
            code, out, _ = run(CHECK, file, result["certificate"])
            self.assertEqual(code, DONE)
            self.assertIn(expected(seed), out)
        self.assertEqual(sorted(os.listdir(folder)), ["line-1.json", "line-2.json"])

    def test_a_certificate_that_cannot_be_written_ends_the_batch(self):
        path, folder, out = self.lines([1, 2]), self.path("proofs"), self.path("out.jsonl")
        os.makedirs(os.path.join(folder, "line-2.json"))  # a folder stands where the proof goes
        words = ["batch", path, "-o", out, "--certificates", folder]
        self.fails(*words, naming=["line-2.json"])
        os.rmdir(os.path.join(folder, "line-2.json"))
        self.assertEqual(stickslip(*words, "--resume"), (DONE, "", ""))
        with open(out, encoding="utf-8") as file:
            self.assertEqual([json.loads(line)["verdict"] for line in file], ["stable"] * 2)

    def test_usage(self):
        self.fails("batch", naming=["GRASPS"])
        self.fails("batch", self.path("none.jsonl"), naming=["none.jsonl", "cannot open"])
        self.fails("batch", self.folder, naming=["this is a directory"])
        self.fails("batch", self.lines([1]), "--resume", naming=["--output"])
        self.fails("batch", self.lines([1]), "-o", self.path("no/such/folder"),
                   naming=["cannot be written"])


if __name__ == "__main__":
    unittest.main()
