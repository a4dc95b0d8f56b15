# SPDX-License-Identifier: MIT
"""Every rule of certificate/FORMAT.md is made to fail, in each kind of proof where it can, and all checkers say so.

corpus.py says what an entry is. Checkers that the environment does not name are left out: STICKSLIP_CHECK for
stickslip-check, STICKSLIP_NODE for certificate/js/check.js, STICKSLIP_PROVED for stickslip-proved.
"""

import functools
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import corpus

ROOT = os.path.join(corpus.FOLDER, "..", "..")
sys.path.insert(0, os.path.join(ROOT, "tests", "support"))

import batch  # noqa: E402

STICKSLIP_CHECK = os.environ.get("STICKSLIP_CHECK")
CHECK_JS = [batch.NODE, os.path.join(ROOT, "certificate", "js", "check_node.js")]

# Where each rule can fail first.
ALL = set(corpus.KINDS)
PLANE = {"plane", "plane_box", "plane_margin", "plane_claims", "plane_region", "plane_class", "plane_statics"}
BODIES = {"bodies", "bodies_margin", "bodies_space", "bodies_soft"}
CLAIMS = {"plane_claims", "space_margin", "bodies_margin", "bodies_soft"}
BOXES = {"plane_box", "space_box", "plane_claims", "space_margin"} | BODIES  # normals of irrational length make a margin a box
LARGE = {"bodies_large"}
WITNESSES = {"plane", "plane_margin", "plane_claims", "plane_region", "space", "space_margin"} | BODIES | LARGE
CLASSES = {"plane_class", "space_class"}
STATICS = {"plane_statics", "space_statics", "bodies_statics"}
STATES = {"plane_states", "space_states", "bodies_states"}  # about positions and normals alone
ROBUST = {"plane_robustness", "space_robustness"}
LOADED = ALL - STATES - ROBUST
TREES = LOADED - STATICS - LARGE
CUT = {"plane", "plane_box", "space", "space_box", "bodies", "bodies_space", "bodies_soft"}
BY_DEGREE = TREES - CLASSES - {"plane_region"}
PARTS = BY_DEGREE - {"plane_margin"}
WHERE = {
    "question-contacts": ALL,
    "question-wrench": LOADED | ROBUST,
    **dict.fromkeys(["question-preload", "question-law", "question-direction",
                     "question-preload-direction", "question-uncertain", "question-max-motion"], LOADED),
    "question-plane": (PLANE | STATICS) - {"plane_margin", "plane_claims"},  # there question-direction fails before
    **dict.fromkeys(["witness-share", "witness-normal", "witness-balance"], WITNESSES),
    "witness-bound": WITNESSES - {"plane_margin", "plane_region"},  # where no question has a bound
    "witness-root": {"space", "space_margin", "bodies_space", "bodies_soft"} | LARGE,
    "witness-box": BOXES | LARGE,
    **dict.fromkeys(["node-depth", "node-contact"], TREES),
    **dict.fromkeys(["tree-short", "tree-long"], TREES | ROBUST),
    "leaf-bound": TREES - CLASSES,
    "node-certain": BOXES,
    **dict.fromkeys(["part-contact", "part-inside", "moving-list"], CUT),
    **dict.fromkeys(["rest-share", "rest-reach", "rest-cone"], PARTS),
    **dict.fromkeys(["degree-walls", "degree-direction", "degree-law", "leaf-direction"], BY_DEGREE),
    **dict.fromkeys(["degree-free", "degree-bound"], PARTS),
    "degree-open": PARTS,
    **dict.fromkeys(["sticking-share", "sticking-motion", "sticking-reach", "sticking-press", "sticking-energy", "sticking-bound"], PARTS),
    **dict.fromkeys(["resisted-order", "segment-chain"], {"plane_margin"}),
    "segment-mode": CLAIMS | {"plane_margin"},
    **dict.fromkeys(["interval-order", "interval-whole"], CLAIMS),
    "question-inertia": CLASSES | {"plane_statics", "space_statics"},
    **dict.fromkeys(["class-twist", "class-force", "class-balance", "class-motion", "class-leaf"], CLASSES),
    **dict.fromkeys(["static-point", "static-force", "static-balance"], STATICS),
    **dict.fromkeys(["question-statics", "static-motion"], STATICS | LARGE),
    "large-proof": LARGE,
    **dict.fromkeys(["question-states", "state-line", "state-sign", "state-half", "state-new", "state-complete", "state-dimension"], STATES),
    **dict.fromkeys(["question-robustness", "robust-forces", "robust-distance", "robust-balance", "robust-stiffness", "robust-lower",
                     "robust-split", "robust-leaf"], ROBUST),
    "class-slip": {"space_class"},
    **dict.fromkeys(["piece-mode", "held-piece", "held-inside"], {"plane_region"}),
}


def names(entry, members):
    """Whether its question or its options have one of them."""
    return bool(members & set(entry.certificate["question"])) or any(
        word.startswith(tuple("--" + member for member in members)) for word in entry.options)


def judged_by_js(entry):
    """check.js judges no planes of loads, rigid contacts, verdicts of many coordinates, statics, states and robustness, and does not know
    the last three."""
    return entry.kind not in LARGE | STATES | ROBUST and not names(entry, {"plane", "inertia", "statics"})


def judged_by_proved(entry):
    """stickslip-proved judges no states, robustness and verdicts of many coordinates, and knows no limits of forces."""
    return entry.kind not in STATES | ROBUST | LARGE and not re.search('"max_(force|torque)"', json.dumps(entry.grasp))


def ball_of(content):
    """Of a certificate or a report; None if it states none."""
    uncertain = content["question"].get("uncertain")
    ball = uncertain.get("wrench") if isinstance(uncertain, dict) else None
    return ball if isinstance(ball, dict) else None


def question_of(entry):
    return {"grasp": json.dumps(entry.grasp), "certificate": json.dumps(entry.certificate), "options": entry.options}


def loads_of(content, body):
    """`wrench` or `loads` of a file or a case, as loads of a body; None if there is neither."""
    if "wrench" in content:
        return [{"body": body, "wrench": content["wrench"]}]
    return [{"body": body, **load} for load in content["loads"]] if "loads" in content else None


def as_several(entry):
    """The same question about a body that is the only one of several; None if version 3 has no such question."""
    grasp = entry.grasp
    contacts, cases = grasp["contacts"], grasp.get("cases", [])
    margin = "resisted" in entry.certificate or any(word.startswith(("--direction", "--preload-direction")) for word in entry.options)
    statics = any(word.startswith("--statics") for word in entry.options)
    if names(entry, {"inertia"}) or (names(entry, {"plane"}) and not statics) or {"outline", "body"} & set(grasp) or any("on" in contact for contact in contacts) or not contacts or (
            cases and "--case" not in " ".join(entry.options)):
        return None
    # A margin in the plane is by segments there alone, and so malformed in other places.
    if margin and not statics and entry.kind.startswith("plane") and (entry.kind != "plane_claims" or entry.rule == "malformed"):
        return None
    several = {"bodies": [{"name": "it"}], **{key: grasp[key] for key in ("name", "units", "defaults", "max_motion") if key in grasp},
               "contacts": [{"of": "it", **contact} for contact in contacts]}
    certificate, ball = entry.certificate, ball_of(entry.certificate)
    if ball is not None:
        if "body" in ball:  # malformed there, and another body here
            return None
        question = certificate["question"]
        certificate = {**certificate, "question": {**question, "uncertain": {**question["uncertain"], "wrench": {**ball, "body": "it"}}}}
    options = [re.sub("wrench=ball:[^,]*", r"\g<0>:body=it", word) for word in entry.options]
    loads = loads_of(grasp, "it")
    if loads is not None:
        several["loads"] = loads
    if "cases" in grasp:
        several["cases"] = [{"name": case["name"], "loads": loads_of(case, "it")} for case in cases]
    return entry._replace(grasp={"format": "stickslip-grasp/3", **several}, certificate=certificate, options=options)


def by_coordinates(entry):
    """With a length and an angle of max motion put into a number for each coordinate, as joints need it."""
    space = len(entry.grasp["contacts"][0]["position"]) == 3

    def spread(length, angle):
        return [length] * (3 if space else 2) + [angle] * (3 if space else 1)

    def spelled(word):
        option, numbers = re.fullmatch(r"(--max-motion=|)(.*)", word, re.DOTALL).groups()
        pair = numbers.split(",")
        return option + ",".join(spread(*pair)) if len(pair) == 2 else word

    options = [spelled(word) if word.startswith("--max-motion=") or before == "--max-motion" else word
               for before, word in zip([""] + entry.options, entry.options)]
    bound = entry.grasp.get("max_motion")
    grasp = {**entry.grasp, "max_motion": spread(bound["length"], bound["angle"])} if isinstance(bound, dict) and set(bound) == {
        "length", "angle"} else entry.grasp
    return entry._replace(grasp=grasp, options=options)


def on_joints(entry):
    """Of what as_several gives: the body as the last of links whose joints move it by the coordinates of one that is no link. None if
    a wrench is uncertain, which is not of a link."""
    entry = by_coordinates(entry)
    grasp = entry.grasp
    space = len(grasp["contacts"][0]["position"]) == 3
    unit = [[int(j == k) for k in range(3)] for j in range(3)]
    turns = [{"slide": unit[j][:3 if space else 2]} for j in range(3 if space else 2)]
    turns += [{"hinge": {"at": [0, 0, 0], "axis": axis}} for axis in unit] if space else [{"hinge": [0, 0]}]
    bodies = [{"name": str(j), **turn, **({"on": str(j - 1)} if j else {})} for j, turn in enumerate(turns)]
    last = bodies[-1]["name"] = "it"  # as the body of a ball of loads is named
    at = [0] * (3 if space else 2)

    def moved(loads):
        for load in loads:
            if "wrench" in load:
                force, torque = load["wrench"][:len(at)], load["wrench"][len(at):]
                yield {"body": last, "force": force, "at": at}
                yield {"body": last, "torque": torque if space else torque[0]}
            else:
                yield {**load, "body": last}

    changed = {**grasp, "bodies": bodies, "joints": [{"turns": {body["name"]: 1}} for body in bodies],
               "contacts": [{**contact, "of": last} for contact in grasp["contacts"]], "loads": list(moved(grasp.get("loads", [])))}
    if "cases" in grasp:
        changed["cases"] = [{**case, "loads": list(moved(case["loads"]))} for case in grasp["cases"]]
    return None if '"wrench": [{' in json.dumps(grasp) or '"min"' in json.dumps([grasp.get("loads"), grasp.get("cases")]) else \
        entry._replace(grasp=changed)


def beside_an_arm(entry):
    """Of an equilibrium of one grasp of several bodies: the same with more than 30 coordinates, those of an arm that nothing touches.
    None of other proofs, and of what is malformed."""
    certificate, grasp = entry.certificate, json.dumps(entry.grasp)
    question = certificate["question"]
    bound = entry.grasp.get("max_motion", [])
    by_length = any(re.fullmatch("--max-motion=[^,]*,[^,]*", word) for word in entry.options)  # and an angle: joints have no such bound
    if by_length or entry.kind not in BODIES or entry.rule == "malformed" or "shares" not in certificate or "segments" in certificate or '"min"' in grasp or '"slope"' in grasp or names(
            entry, {"direction", "preload_direction", "preload-direction", "uncertain"}) or not isinstance(bound, list):
        return None
    space = bool(entry.grasp["contacts"]) and len(entry.grasp["contacts"][0]["position"]) == 3
    idle, ones = [0] * 31, [1] * 31

    def longer(content, **more):
        return {**content, **{key: content[key] + added for key, added in more.items() if key in content}}

    arm = {"name": "an arm", "hinge": {"at": [0, 0, 0], "axis": [0, 0, 1]} if space else [0, 0]}
    changed = longer({"joints": [], **entry.grasp}, bodies=[arm], joints=[{"turns": {"an arm": 1}}] * 31, wrench=idle, max_motion=ones)
    if "cases" in changed:
        changed["cases"] = [longer(case, wrench=idle) for case in changed["cases"]]
    options = [re.sub("^--max-motion=[^n].*", lambda word: ",".join(map(str, [word.group(), *ones])), word) for word in entry.options]
    options = [re.sub("^--wrench=.*", lambda word: ",".join(map(str, [word.group(), *idle])), word) for word in options]
    return entry._replace(grasp=changed, options=options, certificate={
        **longer(certificate, twist=idle), "question": longer(question, wrench=idle, max_motion=ones)})


def in_batch(command, entries):
    """Answers of one process to all questions."""
    lines = "".join(json.dumps(question_of(entry)) + "\n" for entry in entries)
    done = subprocess.run(command, input=lines, capture_output=True, encoding="ascii", check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def run(command, folder, entry):
    """A checker's own command line."""
    paths = [os.path.join(folder, name) for name in ("grasp.json", "certificate.json")]
    for path, content in zip(paths, (entry.grasp, entry.certificate)):
        with open(path, "w", encoding="ascii") as file:
            json.dump(content, file)
    return subprocess.run([*command, *paths, *entry.options], capture_output=True, encoding="ascii", check=False)


class RulesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.entries = corpus.all_entries()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.asker, cls.answers = batch.Asker(folder.name), {}

    @classmethod
    def check_py(cls, entry):
        """The report of check.py, the text that is printed, and the exit code. Each entry is judged once, when it is first asked about."""
        if entry[:2] not in cls.answers:
            cls.answers[entry[:2]] = cls.asker.judged(question_of(entry))
        return cls.answers[entry[:2]]

    def expect(self, entries, answers, says=("result", "rule", "node", "path")):
        """And that reports of what is accepted are those of check.py."""
        self.assertEqual(len(entries), len(answers))
        for entry, answer in zip(entries, answers):
            with self.subTest(entry.name, kind=entry.kind):
                expected = {"result": "rejected", "rule": entry.rule, "node": entry.node, "path": entry.path}
                if entry.rule is None:
                    report, _, _ = self.check_py(entry)
                    self.assertEqual(answer, {**report, "result": "accepted", **entry.says})
                elif entry.rule == "malformed":
                    self.assertEqual((answer["result"], answer["rule"]), ("malformed", None), answer)
                else:
                    self.assertEqual({key: answer[key] for key in says}, {key: expected[key] for key in says}, answer)
                self.assertEqual(bool(answer["found"]), entry.rule is not None)

    def expect_texts(self, command, entries):
        """Of those that are accepted, those of check.py."""
        with tempfile.TemporaryDirectory() as folder:
            for entry in entries:
                if entry.rule is None:
                    done = run([command], folder, entry)
                    self.assertEqual((done.returncode, done.stdout), (0, self.check_py(entry)[1]), entry.name)

    def expect_ignorance(self, command, member, kinds):
        """Of a checker that does not judge them: the member is malformed to it, and the option is none of its own."""
        entries = [entry for entry in self.entries if entry.kind in kinds and member in entry.certificate["question"]]
        without = [entry._replace(options=[]) for entry in entries]
        for entry, answer in zip(without, in_batch([*command, "--batch"], without)):
            self.assertEqual((answer["result"], answer["rule"]), ("malformed", None), (entry.name, answer))
        # Each of these is a process, so there are three.
        for entry in [next(entry for entry in entries if entry.kind == kind) for kind in sorted(kinds)]:
            done = self.run_one(command, entry)
            self.assertEqual((done.returncode, done.stdout), (2, ""), entry.name)
            self.assertIn("--" + member, done.stderr)

    def expect_ignorance_of_many_coordinates(self, command):
        """Of a checker that does not judge verdicts about them: the grasp file is malformed to it. (What it says
        of options with so many numbers, and of those that check.js does not judge, comes before.)"""
        entries = [entry for entry in self.entries
                   if entry.kind in LARGE and not re.search("--(direction|max-motion|plane|inertia)", " ".join(entry.options))]
        self.assertGreater(len(entries), 200)
        for entry, answer in zip(entries, in_batch([*command, "--batch"], entries)):
            self.assertEqual((answer["result"], answer["rule"]), ("malformed", None), (entry.name, answer))
        done = self.run_one(command, entries[0])
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, "30 coordinates|at most 30")

    def run_one(self, command, entry):
        with tempfile.TemporaryDirectory() as folder:
            return run(command, folder, entry)

    def test_every_rule_is_broken(self):
        with open(os.path.join(ROOT, "certificate", "FORMAT.md"), encoding="utf-8") as file:
            named = set(re.findall(r"`([a-z]+(?:-[a-z]+)+)`", file.read())) - {"like-this"}
        self.assertEqual(set(WHERE), named)
        broken = {(entry.rule, entry.kind) for entry in self.entries} - {(rule, kind) for rule in (None, "malformed")
                                                                        for kind in ALL}
        self.assertEqual(broken, {(rule, kind) for rule, kinds in WHERE.items() for kind in kinds})

    def test_files_hold_their_kind(self):
        for entry in self.entries:
            if entry.rule is None:
                contacts, several = entry.grasp["contacts"], "bodies" in entry.grasp
                in_space = bool(contacts) and len(contacts[0]["position"]) == 3 if several or entry.kind in STATES and contacts else (
                    len(entry.grasp["wrench"] if entry.kind in STATES else entry.certificate["question"]["wrench"]) == 6)
                kind = ["bodies" if several else None, "space" if in_space else None if several else "plane", {
                    "margin": "claims" if "intervals" in entry.certificate and not several and not in_space else "margin", "region": "region", "must move": "class", "must hold": "class", "open": "class"}.get(
                        entry.certificate["verdict"])]
                soft = '"torsion"' in json.dumps(entry.grasp)
                for word in ("statics", "states", "robustness"):
                    if word in entry.certificate["question"]:
                        kind, soft = ["bodies" if several else kind[1], word], False
                if len(entry.certificate["question"].get("wrench", [])) > 30 and "statics" not in entry.certificate["question"]:
                    kind, soft = ["bodies", "large"], False
                self.assertEqual("bodies_soft" if soft else "_".join(filter(None, kind)), entry.kind.replace("_box", ""), entry.name)

    def test_check_py(self):
        self.expect(self.entries, [self.check_py(entry)[0] for entry in self.entries])
        for entry in self.entries:
            lines = self.check_py(entry)[1].split("\n")
            self.assertEqual([line for line in entry.prints if line not in lines], [], (entry.name, lines))

    @classmethod
    @functools.lru_cache(maxsize=None)
    def pairs(cls):
        """Entries, each with the same of several bodies."""
        pairs = [(entry, as_several(entry)) for entry in cls.entries
                 if entry.kind in ("plane", "plane_box", "plane_claims", "space", "space_box", "space_margin", "plane_statics", "space_statics")]
        return [(entry, other) for entry, several in pairs if several is not None
                for other in (several, on_joints(several)) if other is not None]

    def same_of_several(self, answers_to, says=None, half=False, judged=lambda entry: True):
        """What is true of one body is answered alike where it is one of several, and where links and joints move it. Half: either is
        asked of every other entry."""
        pairs = [pair for pair in self.pairs() if judged(pair[0])]
        self.assertGreater(len(pairs), 1000)
        if half:
            pairs = [pair for k, pair in enumerate(pairs) if k % 4 in (0, 3)]
        for (entry, other), report in zip(pairs, answers_to([other for _, other in pairs])):
            expected = self.check_py(entry)[0]
            if report["question"] is not None and ball_of(report) is not None:
                self.assertEqual(ball_of(report).pop("body"), "it")
            same = set(expected) - ({"path", "found"} if expected["result"] == "malformed" else {"found"})
            if says is not None and expected["result"] != "accepted":
                same &= set(says)
            self.assertEqual({key: report[key] for key in same}, {key: expected[key] for key in same}, (entry.name, other.grasp, report))

    def same_beside_an_arm(self, answers_to):
        """Equilibria are judged alike by the rules of section 3 and by those of many coordinates."""
        pairs = [(entry, other) for entry in self.entries for other in [beside_an_arm(entry)] if other is not None]
        self.assertGreater(len(pairs), 100)
        self.assertEqual({entry.rule for entry, _ in pairs if str(entry.rule).startswith("witness-")},
                         {rule for rule in WHERE if rule.startswith("witness-")})
        for (entry, other), report in zip(pairs, answers_to([other for _, other in pairs])):
            expected = self.check_py(entry)[0]
            self.assertEqual({key: report[key] for key in ("result", "rule", "node", "path", "verdict", "box")},
                             {key: expected[key] for key in ("result", "rule", "node", "path", "verdict", "box")}, (entry.name, other.grasp, report))

    def test_check_py_beside_an_arm(self):
        with tempfile.TemporaryDirectory() as folder:
            asker = batch.Asker(folder)
            self.same_beside_an_arm(lambda entries: [asker.answer(question_of(entry)) for entry in entries])

    @unittest.skipUnless(STICKSLIP_CHECK, "STICKSLIP_CHECK names no program")
    def test_stickslip_check_beside_an_arm(self):
        self.same_beside_an_arm(lambda entries: in_batch([STICKSLIP_CHECK, "--batch"], entries))

    def test_check_py_on_several(self):
        with tempfile.TemporaryDirectory() as folder:
            asker = batch.Asker(folder)
            self.same_of_several(lambda entries: [asker.answer(question_of(entry)) for entry in entries], half=True)

    @unittest.skipUnless(batch.NODE, "STICKSLIP_NODE names no program")
    def test_check_js_on_several(self):
        self.same_of_several(lambda entries: in_batch([*CHECK_JS, "--batch"], entries), judged=judged_by_js)

    @unittest.skipUnless(STICKSLIP_CHECK, "STICKSLIP_CHECK names no program")
    def test_stickslip_check_on_several(self):
        self.same_of_several(lambda entries: in_batch([STICKSLIP_CHECK, "--batch"], entries))

    @unittest.skipUnless(STICKSLIP_CHECK, "STICKSLIP_CHECK names no program")
    def test_stickslip_check(self):
        self.expect(self.entries, in_batch([STICKSLIP_CHECK, "--batch"], self.entries))
        self.expect_texts(STICKSLIP_CHECK, self.entries)

    @unittest.skipUnless(batch.NODE, "STICKSLIP_NODE names no program")
    def test_check_js(self):
        entries = list(filter(judged_by_js, self.entries))
        self.expect(entries, in_batch([*CHECK_JS, "--batch"], entries))
        self.expect_ignorance(CHECK_JS, "statics", STATICS)
        self.expect_ignorance(CHECK_JS, "states", STATES)
        self.expect_ignorance(CHECK_JS, "robustness", ROBUST)
        self.expect_ignorance_of_many_coordinates(CHECK_JS)

    @unittest.skipUnless(batch.PROVED, "STICKSLIP_PROVED names no program")
    def test_stickslip_proved(self):
        """It says nothing of paths in trees."""
        entries = list(filter(judged_by_proved, self.entries))
        answers = in_batch([batch.PROVED, "--batch"], entries)
        self.expect(entries, answers, says=("result", "rule"))
        statics = [(entry, answer) for entry, answer in zip(entries, answers) if str(entry.rule).startswith("static-")]
        self.assertGreater(len(statics), 100)
        self.expect(*zip(*statics))
        self.expect_texts(batch.PROVED, entries)
        self.expect_ignorance([batch.PROVED], "states", STATES)
        self.expect_ignorance([batch.PROVED], "robustness", ROBUST)
        self.expect_ignorance_of_many_coordinates([batch.PROVED])

    @unittest.skipUnless(batch.PROVED, "STICKSLIP_PROVED names no program")
    def test_stickslip_proved_on_several(self):
        self.same_of_several(lambda entries: in_batch([batch.PROVED, "--batch"], entries), ("result", "rule"),
                             judged=judged_by_proved)


if __name__ == "__main__":
    unittest.main()
