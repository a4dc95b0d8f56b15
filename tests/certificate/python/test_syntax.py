# SPDX-License-Identifier: MIT
"""What both checkers refuse to read, certificates and grasp files, and what they print of it."""

import json
import os
import re
import tempfile
import unittest

from support import (CHECK_NODE, FIG1, HERE, PROGRAMS, STICKSLIP_CHECK, STICKSLIP_NODE, UP, UP_TREE, Case, certificate, in_batch, start,
                     up)


class MalformedTest(Case):
    """§2 and §6, exit 2: the file, the place and the problem, on standard error."""

    def bad(self, needle, content):
        self.malformed(needle, FIG1, content, *UP)

    def test_json(self):
        text = json.dumps(up())
        self.accepts(FIG1, " \t\r\n" + text + "\n\n", *UP)
        escapes = text.replace("certificate/2", "certificate\\/2").replace("unstable", "unst\\u0061bl\\u0065")
        self.accepts(FIG1, escapes, *UP)
        self.bad("the file is empty", "")
        self.bad("the file is empty", " \t\r\n")
        self.bad("a comma after the last element", text.replace("]]}", "],]}"))
        self.bad("a comma after the last element", text[:-1] + " , }")
        self.bad("not JSON", text[:-1])
        self.bad("not JSON", text + "x")
        self.bad("not JSON", text + text)
        self.bad("not JSON", text.replace("3", "03", 1))
        self.bad("not JSON", text.replace("3", "+3", 1))
        self.bad("not JSON", text.replace("11/10", "11\n/10", 1))
        for constant in ("NaN", "Infinity", "-Infinity"):
            self.bad("not JSON", text.replace("[0, -1, 0]", constant, 1).replace("0, -1, 0", constant))
        self.bad("byte order mark", "\ufeff" + text)
        self.bad("half of a surrogate pair", text.replace("{", '{"producer": "\\udead", ', 1))
        self.bad("not UTF-8", text.encode().replace(b"11/10", b"11/\xff10"))
        self.bad("not UTF-8", text.encode("utf-16"))
        self.bad("not JSON", text + "\x00")

    def test_nesting(self):
        for text in ("[" * 9 + "]" * 9, "[" * 9, "{\"a\":" * 100_000, "[" * 1_000_000):
            self.bad("nesting deeper than 8", text)
        self.bad("must be an object", "[" * 8 + "]" * 8)
        # Brackets in strings do not count; neither does what seems to end one.
        self.accepts(FIG1, {**up(), "format": up()["format"]}, *UP)
        texts = json.dumps({"format": up()["format"], "producer": "\\\"[[[[[[[[[[{{\"[[[[\\",
                            **{k: v for k, v in up().items() if k != "format"}})
        self.accepts(FIG1, texts, *UP)
        self.bad("not JSON", '"' + '\\"' * 30_000)
        self.bad("a string of more than", '"' + '\\"' * 200_000)

    def test_members(self):
        def without(object_, key):
            return {k: v for k, v in object_.items() if k != key}

        base = up()
        for key in base:
            self.bad(f"'{key}' is missing", without(base, key))
        for key in ("contacts", "wrench", "normal_law"):
            self.bad(f"question: member '{key}' is missing",
                     {**base, "question": without(base["question"], key)})
        self.bad("unknown member 'extra'", {**base, "extra": 1})
        self.bad("question: unknown member 'name'",
                 {**base, "question": {**base["question"], "name": ""}})
        self.bad("out of order", dict(reversed(list(base.items()))))
        self.bad("question: members out of order",
                 {**base, "question": dict(reversed(list(base["question"].items())))})
        self.bad("out of order", {**base, "producer": "late"})
        text = json.dumps(base)
        self.bad("is repeated", text.replace('"verdict"', '"verdict": "unstable", "verdict"'))
        self.bad("is repeated", text.replace('"contacts": 3', '"contacts": 3, "contacts": 3'))
        self.bad("is repeated", text.replace('"verdict"', '"verdict": "stable", "verdict"'))
        self.bad("unknown member 'twist'", {**base, "twist": [0, 0, 0]})
        self.bad("unknown member 'tree'", {**certificate(3, [0, 0, 0], twist=[0, 0, 0]), "tree": []})
        for late in ("normals", "forces"):
            self.bad("unknown member", {**base, "question": {**base["question"], late: []}})

    def test_types(self):
        base = up()
        for version in ("stickslip-certificate/1", "stickslip-margin/1", "stickslip-certificate/2 ", 1, None,
                        ["x"]):
            self.bad("format: must be", {**base, "format": version})
        self.bad("producer", {"format": base["format"], "producer": 1,
                              **{k: base[k] for k in ("question", "verdict", "tree")}})
        for verdict in ("undecided", "Unstable", True, None, [], 1):
            self.bad("verdict: must be one of", {**base, "verdict": verdict})
        self.bad("missing", {**base, "verdict": "margin"})
        margin = {k: v for k, v in base.items() if k != "tree"}
        self.bad("verdict", {**margin, "verdict": "margin", "resisted": [], "segments": [],
                             "tree": []})
        for root in ([], "x", 1, True, None):
            self.bad("must be an object", json.dumps(root))
        question = base["question"]
        for key, value in (("contacts", -1), ("contacts", "3"), ("contacts", True),
                           ("contacts", 3.0), ("contacts", [3]), ("wrench", [0, 1]),
                           ("wrench", [0, 1, 0, 0]), ("wrench", [0, True, 0]),
                           ("wrench", {"x": 0}), ("wrench", [0, None, 0]), ("preload", None),
                           ("normal_law", "Unilateral"), ("normal_law", 1), ("normal_law", []),
                           ("direction", None), ("direction", [0, 1]), ("direction", "scale"),
                           ("preload_direction", None), ("preload_direction", 1),
                           ("preload_direction", "Scale"), ("preload_direction", [None]),
                           ("preload_direction", [0, 1, 0.5])):
            ordered = {**question, key: value}
            self.bad("question." + key, {**base, "question": ordered})
        self.bad("question: must be an object", {**base, "question": []})
        for tree in ({}, 1, "leaf", None):
            self.bad("tree: must be an array", {**base, "tree": tree})

    def test_stable_types(self):
        base = certificate(3, [0, -1, 0], twist=[0, -1, 0])
        for key, value in (("twist", [0, 0]), ("twist", [0, 0, 0.0]), ("twist", "0,0,0"),
                           ("shares", [[0, 0, 0]]), ("shares", [0]), ("shares", {}),
                           ("shares", [["0", 0]]), ("shares", [[-1, 0]]), ("shares", [[0, 0.5]]),
                           ("shares", [[0]]), ("shares", None)):
            self.malformed(key, FIG1, {**base, key: value})

    def test_margin_types(self):
        point = [0, [0, 0, 0], []]

        def bad(needle, **changes):
            base = certificate(3, [0, 0, 0], direction=[0, 1, 0], resisted=[], segments=[], tree=[])
            self.malformed(needle, FIG1, {**base, **changes}, "--direction", "0,1,0")

        for value in ({}, [0], [[0]], [[None, 1]], [[0, 1, 2]], [[0, "x"]]):
            bad("resisted", resisted=value)
        for value in ({}, [point], [[point]], [[point, point, point]], [[0, point]],
                      [[[None, *point[1:]], point]], [[point, point[:2]]], [[point, [*point, 0]]],
                      [[point, [0, [0, 0], []]]], [[point, [0, [0, 0, 0], [0]]]],
                      [[point, point], []], [[point, point], [point[:2]]],
                      [[point, [None, *point[1:]]], [point]]):
            bad("segments", segments=value)
        for node in (["plane", 0, 0, 0, 1], ["plane", 0, 0, 0, 1, 0, 0]):
            bad("tree[0]", tree=[node])
        for verdict in ("stable", "unstable"):
            bad("verdict", verdict=verdict)

    def test_nodes(self):
        for node in ([], ["slip"], ["slip", 0, 0], ["Slip", 0], ["slip", "0"], ["slip", -1],
                     ["slip", True], ["slip", 0.0], ["slip", None], ["separation"],
                     ["separation", [0]], ["plane", 1, 0, 0], ["plane", 1, 0, 0, 0, 0],
                     ["plane", 1, 0, 0, 0.5], ["leaf", 0, 0], ["leaf", 0, 0, 0, 0],
                     ["leaf", 0, 0, 0, []], ["leaf", 0, 0, False], ["void"], ["split", 0], [0],
                     [["slip", 0]],
                     [{"slip": 0}], "void", 0, None, {"void": 0}):
            self.bad("tree[5]", up(UP_TREE + [node]))

    def test_numbers(self):
        def number(text):
            return json.dumps(up(UP_TREE[:2] + [["leaf", 0, "HERE", 0]] + UP_TREE[3:])).replace(
                '"HERE"', text)

        for text in ("-1", '"-1"', '"-2/2"', '"-0007/7"', '"-\\u0031"', '"-3/9"'):
            self.accepts(FIG1, number(text), *UP)
        for text in ('"1"', '"-0"', "-0"):
            self.rejects("leaf-bound", FIG1, number(text), *UP, node=2,
                         path="separation 0 closed, separation 2 closed")
        for text in ("-1.0", "-1e0", "-1E+2", '"+1"', '"- 1"', '" -1"', '"-1 "', '"-1\\n"', '"-1.0"',
                     '"1e1"', '"-1/0"', '"-1/-1"', '"-1/+1"', '"1/"', '"/1"', '"-"', '""', '"1_0"',
                     '"0x1"', '"\u0661"', '"\u00b2"', '"inf"', '"nan"', "true", "null", "[]", "{}"):
            self.bad("tree[2]", number(text))

    def test_long_numbers(self):
        for make, longest in ((str, 4_000), (json.dumps, 65_536)):
            for length, code in ((longest, 0), (longest + 1, 2)):
                text = make("-" + "9" * (length - 1))
                file = json.dumps(up(UP_TREE[:2] + [["leaf", 0, "HERE", 0]] + UP_TREE[3:]))
                self.assertEqual(self.run_both(FIG1, file.replace('"HERE"', text), *UP)[0],
                                 code, length)
        for text, code in (("\u00fc" * 32_768, 0), ("\u00fc" * 32_768 + "x", 2)):  # bytes count
            file = json.dumps({"format": up()["format"], "producer": "HERE",
                               **{k: v for k, v in up().items() if k != "format"}})
            self.assertEqual(self.run_both(FIG1, file.replace("HERE", text), *UP)[0], code)
        half = "1" + "0" * 30_000
        self.accepts(FIG1, up(UP_TREE[:2] + [["leaf", 0, f"-{half}/{half}", 0]] + UP_TREE[3:]), *UP)
        code, _, out, _ = self.run_both(
            FIG1, up(UP_TREE[:2] + [["leaf", half, -1, 0]] + UP_TREE[3:]), *UP)
        self.assertEqual(code, 1)
        self.assertLess(len(out), 1000)

    def test_values_in_one_place(self):
        """2^22 of them, itself included, in one member, or one element of the tree."""
        many = "0," * ((1 << 22) - 2) + "0"
        text = json.dumps(up([["leaf", 0, 0, "HERE"], ["leaf", 0, 0, 0]]))
        self.bad("more than 4194304 values in one place", text.replace('"HERE"', many))
        self.bad("tree[0]", text.replace('"HERE"', "0,0"))


# The library says of six numbers in version 1 where the third coordinate would be.
LIKE_IN_SPACE = '{"format": "stickslip-grasp/1", "contacts": [], "wrench": [0, 0, 0, 0, 0, 0]}'


class GraspFileTest(Case):
    """§1 and docs/grasp_file.md."""

    CONTACT = {"position": [0, 0], "normal": [0, 1], "friction": 0}

    def file(self, **members):
        return {"format": "stickslip-grasp/1", "contacts": [self.CONTACT], "wrench": [0, 1, 0],
                **members}

    def bad(self, needle, content):
        self.malformed(needle, content, certificate(1, [0, 1, 0], tree=[["leaf", 0, -1, 0]]))

    def test_byte_order_mark_and_name(self):
        proof = certificate(1, [0, 1, 0], tree=[["leaf", 0, -1, 0]])
        self.accepts("\ufeff" + json.dumps(self.file()), proof)
        self.accepts(self.file(name="\U0001f916" + "x" * 100_000), proof)
        self.bad("not JSON", "\ufeff\ufeff" + json.dumps(self.file()))
        self.bad("surrogate", json.dumps(self.file(name="\udc80")))

    def test_places_are_those_of_the_library(self):
        """Or the value around them, or one inside."""
        with open(os.path.join(HERE, "..", "..", "corpus", "grasps", "refused.txt"), encoding="utf-8") as file:
            lines = [line.split(" |") for line in file if not line.startswith("#")]
        lines = [(text, place.strip()) for text, place, *_ in lines if place != " top level" and not text.startswith(LIKE_IN_SPACE)]
        self.assertGreater(len(lines), 100)
        proof = certificate(0, [0, 0, 0], tree=[])
        for text, place in lines:
            reports = [self.run_both(text, proof)[1]]
            reports += [in_batch(program, text, proof, ()) for program in ([STICKSLIP_CHECK], [STICKSLIP_NODE, CHECK_NODE]) if program[0]]
            for report in reports:  # of one checker with a line, or the file
                found = re.fullmatch(r"(?:line \d+, |grasp: )?([^,]+)(, vertex)?", report["path"])[1]
                self.assertTrue(found.startswith(place) or place.startswith(found), (text, place, report))

    def wrench(self, text):
        """What the checker takes a number of the file for, or None if it is malformed."""
        file = json.dumps(self.file()).replace("[0, 1, 0]", f"[0, 0, {text}]")
        code, report, _, _ = self.run_both(file, certificate(1, [0, 0, "1/7"], tree=[]))
        return report["found"].split(", ")[-1][:-1] if code == 1 else None

    def test_numbers(self):
        for text, value in (("1", "1"), ("-0", "0"), ("0.1", "1/10"), ("-1.50", "-3/2"),
                            ("1e-3", "1/1000"), ("12.5E+1", "125"), ("1e2", "100"), ('"3/5"', "3/5"),
                            ('"-6/4"', "-3/2"), ('"+6/4"', "3/2"), ('"-0.25"', "-1/4"),
                            ('"+1e-3"', "1/1000"), ('"010"', "10"), ('"007/010"', "7/10"),
                            ('"2.50E+01"', "25"), ('"1e4096"', None), ('"1e-00004096"', None)):
            found = self.wrench(text)
            if value:
                self.assertEqual(found, value, text)
            else:
                self.assertIsNotNone(found)
        for text in ('"1e4097"', "1e-4097", '"1/0"', '"1/2/3"', '"1/-2"', '"1.5/2"', '".5"', '"5."',
                     '"1e"', '"e1"', '"0x10"', '"1_0"', '" 1"', '"1 "', '"1\\n"', '""', '"+"',
                     '"--1"', '"\u0661"', "true", "null", "[1]", "NaN", "1e9999999999",
                     '"' + "1" * 16_385 + '"', "2" * 4933, "9" * 900 + "e4096"):
            self.assertIsNone(self.wrench(text), text[:20])
        # JSON numbers end earlier, where the solver's reader does.
        self.assertIsNotNone(self.wrench('"' + "1" * 16_384 + '"'))
        self.assertIsNotNone(self.wrench("1" * 4933))
        self.assertIsNotNone(self.wrench('"0.' + "1" * 16_382 + '"'))

    def test_defaults(self):
        """A contact's own value before defaults, and these before 1 and 0."""
        bare = {"position": [0, 0], "normal": [0, 1]}
        for defaults, own, y, a in (({}, {}, -1, 1), ({"stiffness": 2}, {}, "-1/2", 1),
                                    ({"stiffness": 2}, {"stiffness": 4}, "-1/4", 1),
                                    ({"preload": 3}, {}, 2, 1),
                                    ({"preload": 3}, {"preload": "1/2"}, "-1/2", 1)):
            file = self.file(defaults={"friction": 0, **defaults}, contacts=[{**bare, **own}],
                             wrench=[0, -1, 0])
            self.accepts(file, certificate(1, [0, -1, 0], twist=[0, y, 0]))

    def test_normals_are_not_snapped(self):
        for value in ("Snap", True, None, 1, [], "snap", "exact", {"snap": "1/2"}):
            self.bad("stickslip snap GRASP -o FILE", self.file(normals=value))

    def test_values_in_one_place(self):
        most = 1 << 16
        self.bad("wrench: must be an array of 3", self.file(wrench=[0] * (most - 1)))
        self.bad("more than 65536 values in one place", self.file(wrench=[0] * most))
        contact = {**self.CONTACT, "position": [0] * (most - 6)}
        self.bad("position: must be an array of 2", self.file(contacts=[contact]))
        contact["position"].append(0)
        self.bad("more than 65536 values in one place", self.file(contacts=[contact]))
        self.accepts(self.file(contacts=[self.CONTACT] * 300),
                     certificate(300, [0, 1, 0], tree=[["leaf", 0, -1, 0]]))


class LoadsTest(Case):
    """§1: loads and cases of version 2, as the checkers sum them."""

    LOADS = [{"weight": 10, "at": [1, 2]}, {"weight": 5, "at": [0, 1], "direction": [3, -4]},
             {"force": [1, "-2"], "at": [3, "4/3"]}, {"torque": "1/3"}]  # (4, -16, -20)

    def wrench(self, members, *options):
        """What is asked about, by its certificate; or None if that is malformed."""
        file = {"format": "stickslip-grasp/2", "contacts": [], **members}
        code, report, _, _ = self.run_both(file, certificate(1, [0, 0, 0], tree=[]), *options)
        if code == 2:
            return None
        self.assertEqual(report["rule"], "question-contacts")
        # No contact and no load is stable, and that of no other wrench.
        for guess in ([0, 0, 0], [4, -16, -20], [0, -10, -20], ["3/2", -10, "-49/2"]):
            _, report, _, _ = self.run_both(file, certificate(0, guess, twist=[0, 0, 0]), *options)
            if report["rule"] != "question-wrench":
                return guess
        return report["found"]

    def test_sums(self):
        self.assertEqual(self.wrench({"loads": []}), [0, 0, 0])
        self.assertEqual(self.wrench({"loads": self.LOADS}), [4, -16, -20])
        self.assertEqual(self.wrench({"loads": self.LOADS}, "--direction", "1,0,0"), [0, 0, 0])

    def test_cases(self):
        members = {"loads": [{"weight": 10, "at": [2, 1]}],
                   "cases": [{"name": "-", "loads": []},
                             {"name": "p u", "loads": [{"force": ["3/2", 0], "at": [2, 3]}]},
                             {"name": "up", "wrench": [0, 10, "20"]}]}
        for name, wrench in (("-", [0, -10, -20]), ("p u", ["3/2", -10, "-49/2"]),
                             ("up", [0, 0, 0])):
            self.assertEqual(self.wrench(members, "--case", name), wrench)
            self.assertEqual(self.wrench(members, "--case=" + name, "--direction", "1,0,0"), wrench)
        self.assertEqual(self.wrench(members, "--wrench", "0,0,0"), [0, 0, 0])
        self.assertEqual(self.wrench(members, "--direction", "1,0,0"), [0, 0, 0])
        for options in ((), ("--case", "down"), ("--case", ""), ("--case", "up", "--wrench", "0,0,0"),
                        ("--preload-direction", "scale")):
            self.assertIsNone(self.wrench(members, *options), options)
        self.assertIsNone(self.wrench({"wrench": [0, 0, 0]}, "--case", "up"))
        del members["loads"]
        self.assertEqual(self.wrench(members, "--case", "-"), [0, 0, 0])

    def test_only_in_version_2(self):
        for members in ({"loads": []}, {"wrench": [0, 0, 0], "cases": [{"name": "a", "loads": []}]}):
            self.assertIsNotNone(self.wrench(members, "--wrench", "0,0,0"))
            file = {"format": "stickslip-grasp/1", "contacts": [], **members}
            self.malformed("needs \"format\": \"stickslip-grasp/2\"", file, up())


class SpoofTest(Case):
    """No text of a file, or of its name, reaches a terminal as anything but plain letters."""

    EVIL = "\x1b[2J\x1b[Haccepted\nverdict\r\x9b\u202e\u00fc\x7f"

    def test_texts_of_certificates(self):
        """Case.run_both asserts that what is printed is printable ASCII."""
        evil = self.EVIL
        for content in ({**up(), evil: 1}, up(format=evil), up(verdict=evil), up([[evil, 0]]),
                        up([["leaf", 0, 0, evil]]), up(question={**up()["question"], evil: 1}),
                        up(question={**up()["question"], "normal_law": evil}), {evil: 1}, evil):
            code, _, _, _ = self.run_both(FIG1, content, *UP)
            self.assertEqual(code, 2)
        text = json.dumps({"format": up()["format"], "producer": evil,
                           **{k: v for k, v in up().items() if k != "format"}})
        self.assertNotIn("verdict\\r", self.accepts(FIG1, text, *UP))

    def test_texts_of_grasps(self):
        evil = self.EVIL
        for content in ({**FIG1, evil: 1}, {**FIG1, "format": evil}, {**FIG1, "wrench": [evil, 0, 0]},
                        {**FIG1, "defaults": {evil: 1}}, {**FIG1, "contacts": [{evil: 1}]},
                        {"format": "stickslip-grasp/3", "bodies": [{"name": evil, "slide": [0, 1]}], "contacts": []},
                        {"format": "stickslip-grasp/3", "bodies": [{"name": "a"}], "joints": [{"turns": {evil: 1}}], "contacts": []}):
            code, _, _, _ = self.run_both(content, up(), *UP)
            self.assertEqual(code, 2)
        self.accepts({**FIG1, "name": evil}, up(), *UP)

    def test_names_of_files_and_options(self):
        with tempfile.TemporaryDirectory() as folder:
            evil = os.path.join(folder, self.EVIL)
            for program in PROGRAMS:
                for arguments in ([evil, "c"], ["g", evil], ["--" + self.EVIL, "g", "c"],
                                  ["g", "c", "--wrench", self.EVIL], ["g", "c", "--normal-law=" + evil],
                                  ["g", "c", "--preload", self.EVIL]):
                    for json_option in ([], ["--json"]):
                        code, out, err = start(program, [*arguments, *json_option], cwd=folder)
                        self.assertEqual(code, 2, (program, arguments))
                        shown = (out + err).replace("\n", "")
                        self.assertTrue(shown.isascii() and shown.isprintable(), (program, arguments))
                        self.assertFalse(any(line.startswith(("accepted", "verdict"))
                                             for line in (out + err).split("\n")))


if __name__ == "__main__":
    unittest.main()
