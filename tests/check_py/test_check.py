# SPDX-License-Identifier: MIT
"""Tests of certificate/check.py: the paper's grasps, each rule by name, malformed files, usage.

"§" refers to certificate/FORMAT.md, "Table" to Haas-Heger et al., RSS 2018.
"""

import contextlib
import io
import json
import os
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
CHECK = os.path.join(HERE, "..", "..", "certificate", "check.py")
sys.path[:0] = [os.path.dirname(CHECK), HERE]

import check  # noqa: E402
import naive  # noqa: E402


def grasp(points, normals, **members):
    return {"format": "stickslip-grasp/1", "defaults": {"friction": "1/2"},
            "contacts": [{"position": p, "normal": n} for p, n in zip(points, normals)],
            "wrench": [0, 0, 0], **members}


FIG1 = grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]])
FIG4 = grasp([[-1, 1], [-1, -1], [1, -1], [1, 1]], [[1, 0], [1, 0], [-1, 0], [-1, 0]])


def certificate(m, wrench, preload=None, law="unilateral", normals=None, **evidence):
    question = {"contacts": m, "wrench": wrench}
    if preload is not None:
        question["preload"] = preload
    question["normal_law"] = law
    if normals is not None:
        question["normals"] = normals
    return {"format": "stickslip-certificate/1", "question": question,
            "verdict": "unstable" if "tree" in evidence else "stable", **evidence}


# Fig. 1 under (0, 11/10, 0) with P = 1: unstable (Table I). v_0 = h - x, v_2 = h + x.
UP = ("--wrench", "0,11/10,0", "--preload", "1")
UP_TREE = [["separation", 0], ["separation", 2], ["leaf", 0, -1, 0], ["leaf", 0, -1, -1],
           ["leaf", 0, -1, 1]]


def up(tree=None, **changes):
    return {**certificate(3, [0, "11/10", 0], 1, tree=UP_TREE if tree is None else tree), **changes}


def run(grasp_file, certificate_file, *options):
    """Exit code, standard output and standard error; files are objects, texts or bytes."""
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2))
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for name, content in (("g.json", grasp_file), ("c.json", certificate_file)):
            paths.append(os.path.join(folder, name))
            if not isinstance(content, (str, bytes)):
                content = json.dumps(content)
            with open(paths[-1], "wb") as file:
                file.write(content if isinstance(content, bytes) else content.encode("utf-8"))
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            try:
                code = check.main([*paths, *options])
            except SystemExit as stop:
                code = stop.code
    for stream in (out, err):
        stream.flush()
    return code, out.buffer.getvalue().decode(), err.buffer.getvalue().decode()


class Case(unittest.TestCase):
    def accepts(self, grasp_file, certificate_file, *options):
        code, out, err = run(grasp_file, certificate_file, *options)
        self.assertEqual((code, out.split("\n")[0], err), (0, "accepted", ""), out)
        return out

    def rejects(self, rule, grasp_file, certificate_file, *options, node=None, path=None):
        code, out, err = run(grasp_file, certificate_file, "--json", *options)
        self.assertEqual((code, err), (1, ""))
        report = json.loads(out)
        self.assertEqual((report["result"], report["rule"]), ("rejected", rule), report)
        if rule.startswith(("node-", "tree-", "leaf-", "void-")):
            self.assertEqual((report["node"], report["path"]), (node, path), report)
        self.assertTrue(report["found"])

    def malformed(self, needle, grasp_file, certificate_file, *options):
        code, out, err = run(grasp_file, certificate_file, *options)
        self.assertEqual((code, out), (2, ""), err)
        self.assertIn(needle, err)


class PaperTest(Case):
    """Tables I and III; forces and motions as printed, misprints corrected."""

    TABLE1 = [([0, 0, 0], 0, [[0, 0]] * 3, [0, 0, 0]),
              ([0, 0, 0], 1, [[1, "-1/2"], [1, 0], [1, "1/2"]], [0, 0, 0]),
              ([0, -1, 0], 0, [[0, 0], [1, 0], [0, 0]], [0, -1, 0]),
              ([0, -2, 0], 0, [[0, 0], [2, 0], [0, 0]], [0, -2, 0]),
              ([0, 1, 0], 1, [[1, "-1/2"], [0, 0], [1, "1/2"]], [0, 1, 0])]
    TABLE3 = [([0, 0, 0], 0, [[0, 0]] * 4, [0, 0, 0]),
              ([0, 0, 0], 1, [[1, 0]] * 4, [0, 0, 0]),
              ([0, 2, 0], 1, [[1, "-1/2"]] * 2 + [[1, "1/2"]] * 2, [0, 0, 0]),
              ([0, -2, 0], 1, [[1, "1/2"]] * 2 + [[1, "-1/2"]] * 2, [0, 0, 0]),
              ([0, 0, 3], 0, [[1, "1/2"], [0, 0]] * 2, [0, -1, 1]),
              ([0, 0, -3], 0, [[0, 0], [1, "-1/2"]] * 2, [0, 1, -1]),
              ([0, 0, 3], 1, [["5/4", "5/8"], ["3/4", "3/8"]] * 2, [0, "-1/4", "1/4"]),
              ([0, 0, -3], 1, [["3/4", "-3/8"], ["5/4", "-5/8"]] * 2, [0, "1/40", "-1/4"]),
              ([0, 0, -3], 1, [["3/4", "-3/8"], ["5/4", "-5/8"]] * 2, [0, "1/4", "-1/4"])]

    def test_stable_rows(self):
        for file, table in ((FIG1, self.TABLE1), (FIG4, self.TABLE3)):
            for wrench, preload, forces, twist in table:
                options = ["--wrench", ",".join(map(str, wrench)), "--preload", str(preload)]
                witness = dict(twist=twist, forces=forces)
                m = len(forces)
                out = self.accepts(file, certificate(m, wrench, preload, **witness), *options)
                self.assertIn("verdict: stable", out)
                # Under the bilateral law no contact may have opened (a = 0 > v).
                code, _, _ = run(file, certificate(m, wrench, preload, "bilateral", **witness),
                                 *options, "--normal-law", "bilateral")
                opened = preload == 0 and wrench[2] != 0
                self.assertEqual(code, 1 if opened else 0, (wrench, preload))

    def test_printed_misprint_is_rejected(self):
        forces = [[0, "1/2"], [0, 0]] * 2
        self.rejects("witness-balance", FIG4, certificate(4, [0, 0, 3], 0, twist=[0, -1, 1],
                     forces=forces), "--wrench", "0,0,3", "--preload", "0")

    def test_figure_1_beyond_its_threshold(self):
        out = self.accepts(FIG1, up(), *UP)
        self.assertEqual(out.split("\n")[1:7], [
            "verdict: unstable", "contacts: 3", "wrench: 0, 11/10, 0", "preload: 1 at all contacts",
            "normal law: unilateral", "tree: 5 nodes, 3 leaves"])
        # On the threshold it is stable, and the tree must fail; just beyond, not.
        at = dict(certificate(3, [0, 1, 0], 1, tree=UP_TREE))
        self.rejects("leaf-bound", FIG1, at, "--wrench", "0,1,0", "--preload", "1",
                     node=2, path="separation 0 closed, separation 2 closed")
        beyond = "1" + "0" * 30 + "1/1" + "0" * 31
        self.accepts(FIG1, certificate(3, [0, beyond, 0], 1, tree=UP_TREE),
                     "--wrench", f"0,{beyond},0", "--preload", "1")

    def test_figure_1_without_preload(self):
        for split in (["separation", 0], ["plane", -1, 0, 0, 0], ["plane", "-3/7", 0, 0, 0]):
            tree = [split, ["leaf", 0, -1, -1], ["leaf", 0, -1, 1]]
            self.accepts(FIG1, certificate(3, [0, 1, 0], 0, tree=tree),
                         "--wrench=0,1,0", "--preload=0")

    def test_figure_4_without_preload(self):
        contacts = [(*c["position"], *c["normal"], "1/2", 1, 0) for c in FIG4["contacts"]]
        for wrench in ((0, 2, 0), (0, -2, 0)):
            for law in check.LAWS:
                model = naive.Model(contacts, wrench, law)
                evidence = naive.decide(model)
                self.assertIn("tree", evidence)
                self.accepts(model.grasp_file(), model.certificate(**evidence),
                             "--normal-law", law)

    def test_answer_names_the_file_s_own_question(self):
        file = {**FIG1, "wrench": [0, -1, 0]}
        out = self.accepts(file, certificate(3, [0, -1, 0], twist=[0, -1, 0],
                                             forces=[[0, 0], [1, 0], [0, 0]]))
        self.assertIn("preload: the grasp file's", out)


class QuestionTest(Case):
    """§3, `question-…`."""

    DOWN = dict(twist=[0, -1, 0], forces=[[0, 0], [1, 0], [0, 0]])

    def test_contacts(self):
        self.rejects("question-contacts", FIG4, up(), *UP)

    def test_wrench(self):
        self.rejects("question-wrench", FIG1, up(), "--wrench", "0,1.1001,0", "--preload", "1")
        self.rejects("question-wrench", FIG1, up(), "--preload", "1")
        self.accepts(FIG1, up(), "--wrench", "0,1.1,-0", "--preload", "1e0")

    def test_preload(self):
        self.rejects("question-preload", FIG1, up(), "--wrench", "0,1.1,0")
        self.rejects("question-preload", FIG1, up(), "--wrench", "0,1.1,0", "--preload", "2")
        absent = certificate(3, [0, "11/10", 0], tree=UP_TREE)
        self.rejects("question-preload", FIG1, absent, *UP)

    def test_law(self):
        self.rejects("question-law", FIG1, up(), *UP, "--normal-law", "bilateral")

    def test_normals(self):
        diagonal = grasp([[0, 0]], [[1, 1]], wrench=[-1, -1, 0])
        diagonal["defaults"]["preload"] = 1
        near = [0, "20/29", "21/29"]  # at distance 0.02438 from (1, 1)/sqrt 2

        def stated(*normals):
            return certificate(1, [-1, -1, 0], normals=list(normals), tree=[["leaf", -1, 1, 0]])

        self.malformed("irrational", diagonal, certificate(1, [-1, -1, 0], tree=[["void"]]))
        rule = "question-normals"
        self.rejects(rule, diagonal, stated(near))
        self.rejects(rule, {**diagonal, "normals": "exact"}, stated(near))
        self.rejects(rule, {**diagonal, "normals": "snap"}, stated(near))
        self.rejects(rule, diagonal, stated(near), "--snap-normals", "243/10000")
        self.rejects(rule, {**diagonal, "normals": {"snap": "1/10"}}, stated(near),
                     "--snap-normals", "1/1000")
        self.rejects(rule, diagonal, stated([0, "-20/29", "-21/29"]), "--snap-normals", "1/10")
        self.rejects(rule, diagonal, stated([0, "20/29", "20/29"]), "--snap-normals", "1/10")
        self.rejects(rule, diagonal, stated(near, near), "--snap-normals", "1/10")
        self.rejects(rule, diagonal, stated([1, 1, 0]), "--snap-normals", "1/10")
        # A normal of rational length is not to be touched, not even to no effect.
        for normal, u in (([1, 0], [0, 1, 0]), ([3, 4], [0, "3/5", "4/5"]),
                          ([1, 0], [0, "9999/10001", "200/10001"])):
            file = {**grasp([[0, 0]], [normal], wrench=[-1, -1, 0]), "normals": {"snap": "1/2"}}
            self.rejects(rule, file, stated(u))
        # A question that can be asked: the rule of the tree answers now.
        for options in (["--snap-normals", "244/10000"], ["--snap-normals=999/1000"]):
            code, out, _ = run(diagonal, stated(near), *options)
            self.assertEqual((code, out.split(":")[1]), (1, " leaf-bound at node 0 (root)"))
        # Pushed away from its only contact the body is lost; the answer states the normal.
        lost = {**diagonal, "wrench": [3, 3, 0], "normals": {"snap": 0.1}}
        out = self.accepts(lost, {**stated(near), "question": {**stated(near)["question"],
                           "wrench": [3, 3, 0]}, "tree": [["leaf", -1, -1, 0]]})
        self.assertIn("normal of contact 0: (20/29, 21/29), within 1/10", out)

    def test_the_question_comes_before_the_evidence(self):
        self.rejects("question-wrench", FIG1, up([["slip", 7]]), "--preload", "1")


class WitnessTest(Case):
    """§3, `witness-…`."""

    def check(self, rule, twist, forces, wrench=(0, -1, 0), *options):
        text = ",".join(map(str, wrench))
        law = "bilateral" if "bilateral" in options else "unilateral"
        file = certificate(3, list(wrench), law=law, twist=twist, forces=forces)
        if rule:
            self.rejects(rule, FIG1, file, "--wrench", text, *options)
        else:
            self.accepts(FIG1, file, "--wrench", text, *options)

    def test_rules(self):
        good = [0, -1, 0], [[0, 0], [1, 0], [0, 0]]
        self.check(None, *good)
        self.check("witness-count", good[0], good[1][:2])
        self.check("witness-count", good[0], good[1] + [[0, 0]])
        self.check("witness-balance", *good, (0, -1, 1))
        self.check("witness-balance", good[0], [[0, 0], [1, "1/1000"], [0, 0]])
        self.check("witness-normal", [0, -2, 0], good[1])
        self.check("witness-normal", [0, -1, 0], [["1/2", 0], [1, 0], ["1/2", 0]])
        self.check("witness-normal", [0, 0, 0], [[-1, 0], [0, 0], [-1, 0]], (0, 0, 0))
        # b = 1 at contacts 0 and 2, with no normal force there.
        self.check("witness-cone", [0, 0, 0], [[0, 1], [0, 0], [0, -1]], (0, -2, 0))
        # Contact 1 slides: T_1·d = -x - r > 0 asks for b = -mu a, and w_x = -1/2.
        self.check("witness-dissipation", ["-1/2", -1, 0], [["1/2", 0], [1, 0], [0, 0]],
                   ("-1/2", -1, 0))
        self.check("witness-dissipation", ["1/2", -1, 0], [[0, 0], [1, 0], ["1/2", 0]],
                   ("1/2", -1, 0))

    def test_slip_direction(self):
        # One contact under load, mu = 1/2: T·d > 0 and b of either sign; only -mu a is right.
        file = grasp([[0, 0]], [[0, 1]])
        for b, x, rule in (("-1/2", -1, None), ("1/2", -1, "witness-dissipation"),
                           ("1/2", 1, None), ("-1/2", 1, "witness-dissipation"),
                           ("0", 0, None), ("1/2", 0, None), ("-1/2", 0, None),
                           ("51/100", 0, "witness-cone")):
            side = naive.Fraction(b)  # T = (-1, 0, 0): the force in x is -b
            one = certificate(1, [str(side), -1, 0], twist=[x, -1, 0], forces=[[1, b]])
            options = ("--wrench", f"{side},-1,0")
            if rule:
                self.rejects(rule, file, one, *options)
            else:
                self.accepts(file, one, *options)

    def test_bilateral_law(self):
        self.check(None, [0, -1, 0], [[0, 0], [1, 0], [0, 0]], (0, -1, 0),
                   "--normal-law", "bilateral")
        self.check("witness-normal", [1, -1, 0], [[0, 0], [1, "1/2"], [1, 0]],
                   ("3/2", -1, "1/2"), "--normal-law", "bilateral")

    def test_normals_of_any_length(self):
        # n = (0, 2) and k = 1: L = 2, so N = (0, 2, 0), v = P/2 - (1/4) 2 y.
        file = {**grasp([[0, 0]], [[0, 2]]), "wrench": [0, -3, 0]}
        for p, y, a in ((0, -3, "3/2"), (1, -2, "3/2"), (1, 1, 0)):
            options = ("--preload", str(p))
            one = certificate(1, [0, -3, 0], p, twist=[0, y, 0], forces=[[a, 0]])
            if a:
                self.accepts(file, one, *options)
            else:
                self.rejects("witness-balance", file, one, *options)
        # n = (1, 1): irrational length, k' = 1/2; fine without preload.
        file = {**grasp([[0, 0]], [[1, 1]]), "wrench": [-1, -1, 0]}
        self.accepts(file, certificate(1, [-1, -1, 0], twist=[-1, -1, 0], forces=[[1, 0]]))
        self.malformed("irrational", file,
                       certificate(1, [-1, -1, 0], 1, twist=[-1, -1, 0], forces=[[1, 0]]),
                       "--preload", "1")


class TreeTest(Case):
    """§4: each rule fires, with the node's number and path."""

    def rule(self, rule, tree, node, path):
        self.rejects(rule, FIG1, up(tree), *UP, node=node, path=path)

    def test_node_rules(self):
        self.rule("node-contact", [["slip", 3]], 0, "root")
        self.rule("node-contact", [["separation", 0], ["separation", 10**30]], 1,
                  "separation 0 closed")
        self.rule("node-repeated", [["slip", 1], ["slip", 0], ["slip", 1]], 2, "slip 1 +, slip 0 +")
        self.rule("node-repeated", [["separation", 1], ["separation", 1]], 1, "separation 1 closed")
        self.rule("node-plane", [["plane", 0, "0/5", "-0", 0]], 0, "root")
        self.rejects("node-law", FIG1, certificate(3, [0, 1, 0], 0, "bilateral",
                     tree=[["slip", 0], ["separation", 0]]), "--wrench", "0,1,0", "--preload", "0",
                     "--normal-law", "bilateral", node=1, path="slip 0 +")

    def test_slip_and_separation_of_a_contact_may_share_a_path(self):
        leaf = ["leaf", 0, -1, 1]
        tree = [["separation", 0], *UP_TREE[1:4], ["slip", 0], ["separation", 1], leaf, leaf, leaf,
                leaf]
        self.accepts(FIG1, up(tree), *UP)

    def test_planes_on_a_path(self):
        for count in (64, 65):
            tree = [["plane", 1, 0, 0, k] for k in range(count)]
            path = ", ".join(["plane +"] * 64)
            if count == 64:
                self.rule("tree-short", tree, 64, path)
            else:
                self.rule("node-repeated", tree, 64, path)

    def test_tree_rules(self):
        self.rule("tree-short", [], 0, "root")
        self.rule("tree-short", UP_TREE[:-1], 4, "separation 0 open")
        self.rule("tree-short", UP_TREE[:3], 3, "separation 0 closed, separation 2 open")
        self.rule("tree-long", UP_TREE + [["void"]], 5, None)
        self.rule("tree-long", UP_TREE + [["leaf", 0, 0, 0]], 5, None)

    def test_leaf_bound(self):
        for k, path in ((2, "separation 0 closed, separation 2 closed"),
                        (3, "separation 0 closed, separation 2 open"), (4, "separation 0 open")):
            for y in ([0, 0, 0], [0, 1, 0], [0, -1, 3], [0, "-1/10", 1]):
                tree = list(UP_TREE)
                tree[k] = ["leaf", *y]
                self.rule("leaf-bound", tree, k, path)
        swapped = UP_TREE[:3] + UP_TREE[:2:-1]
        self.rule("leaf-bound", swapped, 3, "separation 0 closed, separation 2 open")

    def test_leaf_scale(self):
        tree = [[node[0], *(f"{7 * c}/3" for c in node[1:])] if node[0] == "leaf" else node
                for node in UP_TREE]
        self.accepts(FIG1, up(tree), *UP)

    def test_leaf_theta(self):
        path = "separation 0 open"
        for thetas in ([[3, 0]], [[0, "-1/9"]], [[0, "10/9"]], [[1, 0], [1, 0]], [[2, 1], [0, 1]]):
            self.rule("leaf-theta", UP_TREE[:4] + [["leaf", 0, -1, 1, thetas]], 4, path)
        for thetas in ([], [[0, "1/2"]], [[0, 1], [2, 0]]):  # of no effect here
            self.accepts(FIG1, up(UP_TREE[:4] + [["leaf", 0, -1, 1, thetas]]), *UP)

    def test_theta_is_needed_and_used(self):
        # Normals (4, 3) and (-4, 3) at the origin, mu = 0; w has a torque that no contact balances.
        # Where y <= -10 h the contacts push up by 3 (a_0 + a_1) > 1: y = (0, -1, 0) sees that if
        # both a are bounded by v, and not by 0.
        file = grasp([[0, 0], [0, 0]], [[4, 3], [-4, 3]], wrench=[0, -1, 1])
        file["defaults"]["friction"] = 0

        def tree(*thetas):
            return certificate(2, [0, -1, 1], tree=[
                ["plane", 0, -1, 0, -10], ["leaf", 0, -1, 0, [*thetas]], ["leaf", 0, 0, -1]])

        self.accepts(file, tree([0, 1], [1, 1]))
        self.accepts(file, tree([0, "3/4"], [1, "9/12"]))
        for thetas in ([], [[0, 1]], [[1, 1]], [[0, 1], [1, "99/100"]], [[0, "1/9"], [1, "1/9"]]):
            self.rejects("leaf-bound", file, tree(*thetas), node=1, path="plane +")
        # One contact, v = h P - x on the whole line: only θ = 0 bounds it.
        one = grasp([[-1, 0]], [[1, 0]], wrench=[1, 0, 0])
        for theta, code in ((0, 0), ("1/1000", 1), (1, 1)):
            leaf = ["leaf", -1, 0, 0, [[0, theta]]]
            self.assertEqual(run(one, certificate(1, [1, 0, 0], tree=[leaf]))[0], code)

    def test_void(self):
        # τ_0 = y - r.
        leaf = ["leaf", 0, 0, 0]
        self.rule("void-region", [["void"]], 0, "root")
        self.rule("void-region", [["separation", 0], ["void"]], 1, "separation 0 closed")
        self.rule("void-region", [["separation", 0], ["plane", 1, 0, 0, 0], ["void"]], 2,
                  "separation 0 closed, plane +")
        # The first child of a plane is covered by no other.
        self.rule("void-region", [["plane", 0, 1, 0, 0], ["plane", 0, -1, 0, 0], ["void"]], 2,
                  "plane +, plane +")
        # After τ_0 >= 0 strictly, -τ_0 >= 0 leaves nothing; the strict function is the label's.
        self.rule("leaf-bound", [["slip", 0], ["plane", 0, -1, 1, 0], ["void"], leaf], 3,
                  "slip 0 +, plane -")
        self.rule("void-region", [["plane", 0, 1, -1, 0], ["slip", 0], ["void"]], 2,
                  "plane +, slip 0 +")

    def test_void_children(self):
        """A plane split where v or τ is zero already: only second, + and - children are void."""
        one = grasp([[0, 0]], [[0, 1]], wrench=[0, 1, 0])  # τ = -x, v = -y; y = (0, -1, 0) refutes
        leaf, void = ["leaf", 0, -1, 0], ["void"]

        def tree(*nodes):
            return certificate(1, [0, 1, 0], tree=list(nodes))

        self.accepts(one, tree(leaf))
        self.accepts(one, tree(["slip", 0], leaf, ["plane", 1, 0, 0, 0], leaf, void, leaf))
        self.rejects("void-region", one, tree(["slip", 0], leaf, ["plane", 1, 0, 0, 0], void, leaf,
                                              leaf), node=3, path="slip 0 0, plane +")
        self.accepts(one, tree(["plane", 1, 0, 0, 0], ["plane", -1, 0, 0, 0], ["slip", 0], void,
                               leaf, void, leaf, leaf))
        self.accepts(one, tree(["plane", 1, 0, 0, 0], ["slip", 0], void, leaf, leaf, leaf))
        self.rejects("void-region", one, tree(["plane", 1, 0, 0, 0], ["slip", 0], void, void, leaf,
                                              leaf), node=3, path="plane +, slip 0 0")
        self.accepts(one, tree(["plane", 1, 0, 0, 0], leaf, ["slip", 0], leaf, void, leaf))
        self.accepts(one, tree(["plane", 0, 0, 0, -1], ["leaf", 5, 5, 5], leaf))  # -h >= 0: no motion
        self.accepts(one, tree(["plane", 0, 0, 0, -1], void, leaf))
        self.accepts(one, tree(["plane", 0, 0, 0, 1], leaf, void))

    def test_one_leaf_at_the_root(self):
        for m in (0, 1, 5):
            file = grasp([[j, j] for j in range(m)], [[0, 1]] * m, wrench=[0, 1, 0])
            self.accepts(file, certificate(m, [0, 1, 0], tree=[["leaf", 0, -1, 0]]))

    def test_no_contact(self):
        none = grasp([], [])
        self.accepts(none, certificate(0, [0, 0, 0], twist=[7, 0, "1/3"], forces=[]))
        self.rejects("leaf-bound", none, certificate(0, [0, 0, 0], tree=[["leaf", 1, 2, 3]]),
                     node=0, path="root")
        self.rejects("witness-balance", none, certificate(0, [0, 0, 1], twist=[0, 0, 0], forces=[]),
                     "--wrench", "0,0,1")
        self.accepts(none, certificate(0, [0, 0, 1], tree=[["leaf", 0, 0, -1]]), "--wrench", "0,0,1")

    def test_bilateral_root(self):
        # Two contacts that face each other: both v >= 0 only at x = 0 without preload. Pushed along
        # y with friction the body is lost.
        two = grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], wrench=[0, 1, 0])
        tree = [["leaf", 0, -1, 0]]
        self.accepts(two, certificate(2, [0, 1, 0], law="bilateral", tree=tree),
                     "--normal-law", "bilateral")
        self.rejects("leaf-bound", two, certificate(2, [0, 1, 0], tree=tree), node=0, path="root")

    def test_trees_of_many_leaves_take_seconds(self):
        m = 100
        points = [[f"{(37 * j) % 101 - 50}/10", f"{(53 * j) % 97 - 48}/7"] for j in range(m)]
        normals = [[(5 * j) % 7 - 3, (3 * j) % 5 + 1] for j in range(m)]
        file = grasp(points, normals, wrench=["1/3", 40, "-1/7"])
        file["defaults"] = {"friction": "1/10"}
        tree = []
        for j in range(m):  # every leaf refutes all motions: all contacts push up
            tree += [["separation", j], ["leaf", 0, -1, 0], ["slip", (j + 50) % m],
                     ["leaf", 0, -1, 0], ["leaf", 0, -1, 0]]
        tree += [["leaf", 0, -1, 0]]
        start = time.perf_counter()
        code, out, _ = run(file, certificate(m, ["1/3", 40, "-1/7"], tree=tree))
        self.assertEqual((code, out.split("\n")[-2]), (0, "tree: 501 nodes, 301 leaves"), out[:300])
        self.assertLess(time.perf_counter() - start, 20)


class MarginTest(Case):
    """§10. The rules are made to fail in tests/certificate; here are the program's own words."""

    REST = [0, [0, 0, 0], [[1, "-1/2"], [1, 0], [1, "1/2"]]]
    LIMIT = [1, [0, 1, 0], [[1, "-1/2"], [0, 0], [1, "1/2"]]]
    ASKED = ("--direction", "0,1,0", "--preload", "1")

    def margin(self, **changes):
        return {"format": "stickslip-margin/1",
                "question": {"contacts": 3, "wrench": [0, 0, 0], "preload": 1,
                             "normal_law": "unilateral"},
                "direction": [0, 1, 0], "resisted": [[0, 1]], "segments": [[self.REST, self.LIMIT]],
                "tree": UP_TREE, **changes}

    def test_accepted(self):
        out = self.accepts(FIG1, self.margin(), *self.ASKED)
        self.assertEqual(out.split("\n")[1:-1], [
            "resisted: [0, 1]", "contacts: 3", "wrench: 0, 0, 0", "direction: 0, 1, 0",
            "preload: 1 at all contacts", "normal law: unilateral", "segments: 1",
            "trees: 5 nodes, 3 leaves"])
        code, out, _ = run(FIG1, self.margin(), *self.ASKED, "--json")
        report = json.loads(out)
        self.assertEqual((code, report["verdict"], report["resisted"]), (0, "margin", [["0", "1"]]))

    def test_places(self):
        for changes, rule, path in (({"resisted": [[0, 1], [1, 2]]}, "resisted-order", "interval 1"),
                                    ({"resisted": [[0, 2]]}, "segment-chain", "segment 1"),
                                    ({"segments": [[self.REST, [*self.LIMIT[:2], []]]]},
                                     "witness-count", "segment 0, second point"),
                                    ({"tree": UP_TREE[:-1]}, "tree-short", "separation 0 open"),
                                    ({"direction": [0, 2, 0]}, "question-direction", None)):
            code, out, _ = run(FIG1, self.margin(**changes), *self.ASKED, "--json")
            report = json.loads(out)
            self.assertEqual((code, report["rule"], report["path"]), (1, rule, path))

    def test_with_and_without_a_direction(self):
        self.malformed("asked for with --direction", FIG1, self.margin(), "--preload", "1")
        self.malformed("asked for without --direction", FIG1, up(), *UP, "--direction", "0,1,0")


class MalformedTest(Case):
    """§2 and §6, exit 2: the file, the place and the problem, on standard error."""

    def bad(self, needle, content):
        self.malformed("c.json: ", FIG1, content, *UP)
        self.malformed(needle, FIG1, content, *UP)

    def test_json(self):
        text = json.dumps(up())
        self.accepts(FIG1, " \t\r\n" + text + "\n\n", *UP)
        self.bad("not JSON", "")
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
        self.bad("unknown member 'tree'", {**certificate(3, [0, 0, 0], twist=[0, 0, 0], forces=[]),
                                           "tree": []})

    def test_types(self):
        base = up()
        for version in ("stickslip-certificate/2", "stickslip-certificate/1 ", 1, None, ["x"]):
            self.bad("format: must be", {**base, "format": version})
        self.bad("producer", {"format": base["format"], "producer": 1,
                              **{k: base[k] for k in ("question", "verdict", "tree")}})
        for verdict in ("undecided", "Unstable", True, None, [], 1):
            self.bad("verdict: must be one of", {**base, "verdict": verdict})
        for root in ([], "x", 1, True, None):
            self.bad("must be an object", json.dumps(root))
        question = base["question"]
        for key, value in (("contacts", -1), ("contacts", "3"), ("contacts", True),
                           ("contacts", 3.0), ("contacts", [3]), ("wrench", [0, 1]),
                           ("wrench", [0, 1, 0, 0]), ("wrench", [0, True, 0]),
                           ("wrench", {"x": 0}), ("wrench", [0, None, 0]), ("preload", None),
                           ("normal_law", "Unilateral"), ("normal_law", 1), ("normal_law", []),
                           ("normals", None), ("normals", [[0, 1]]), ("normals", [["0", 1, 0]]),
                           ("normals", [[-1, 1, 0]]), ("normals", {})):
            ordered = {**question, key: value}
            self.bad("question." + key, {**base, "question": ordered})
        self.bad("question: must be an object", {**base, "question": []})
        for tree in ({}, 1, "leaf", None):
            self.bad("tree: must be an array", {**base, "tree": tree})

    def test_stable_types(self):
        base = certificate(3, [0, -1, 0], twist=[0, -1, 0], forces=[[0, 0], [1, 0], [0, 0]])
        for key, value in (("twist", [0, 0]), ("twist", [0, 0, 0.0]), ("twist", "0,0,0"),
                           ("forces", [[0, 0, 0]]), ("forces", [0]), ("forces", {})):
            self.malformed(key, FIG1, {**base, key: value})

    def test_nodes(self):
        for node in ([], ["slip"], ["slip", 0, 0], ["Slip", 0], ["slip", "0"], ["slip", -1],
                     ["slip", True], ["slip", 0.0], ["slip", None], ["separation"],
                     ["separation", [0]], ["plane", 1, 0, 0], ["plane", 1, 0, 0, 0, 0],
                     ["plane", 1, 0, 0, 0.5], ["leaf", 0, 0], ["leaf", 0, 0, 0, 0],
                     ["leaf", 0, 0, 0, [], []], ["leaf", 0, 0, 0, [0, 1]], ["leaf", 0, 0, 0, [[0]]],
                     ["leaf", 0, 0, 0, [[0, 1, 2]]], ["leaf", 0, 0, 0, [["0", 1]]],
                     ["leaf", 0, 0, False], ["void", 0], ["split", 0], [0], [["slip", 0]],
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
                self.assertEqual(run(FIG1, file.replace('"HERE"', text), *UP)[0], code, length)
        for text, code in (("\u00fc" * 32_768, 0), ("\u00fc" * 32_768 + "x", 2)):  # bytes count
            file = json.dumps({"format": up()["format"], "producer": "HERE",
                               **{k: v for k, v in up().items() if k != "format"}})
            self.assertEqual(run(FIG1, file.replace("HERE", text), *UP)[0], code)
        half = "1" + "0" * 30_000
        self.accepts(FIG1, up(UP_TREE[:2] + [["leaf", 0, f"-{half}/{half}", 0]] + UP_TREE[3:]), *UP)
        code, out, _ = run(FIG1, up(UP_TREE[:2] + [["leaf", half, -1, 0]] + UP_TREE[3:]), *UP)
        self.assertEqual(code, 1)
        self.assertLess(len(out), 1000)


class GraspFileTest(Case):
    """§1 and docs/grasp_file.md."""

    CONTACT = {"position": [0, 0], "normal": [0, 1], "friction": 0}

    def file(self, **members):
        return {"format": "stickslip-grasp/1", "contacts": [self.CONTACT], "wrench": [0, 1, 0],
                **members}

    def bad(self, needle, content):
        self.malformed("g.json: ", content, certificate(1, [0, 1, 0], tree=[["leaf", 0, -1, 0]]))
        self.malformed(needle, content, certificate(1, [0, 1, 0], tree=[["leaf", 0, -1, 0]]))

    def test_byte_order_mark_and_name(self):
        proof = certificate(1, [0, 1, 0], tree=[["leaf", 0, -1, 0]])
        self.accepts("\ufeff" + json.dumps(self.file()), proof)
        self.accepts(self.file(name="\U0001f916" + "x" * 100_000), proof)
        self.bad("not JSON", "\ufeff\ufeff" + json.dumps(self.file()))
        self.bad("surrogate", json.dumps(self.file(name="\udc80")))

    def wrench(self, text):
        """What the checker takes a number of the file for, or None if it is malformed."""
        file = json.dumps(self.file()).replace("[0, 1, 0]", f"[0, 0, {text}]")
        code, out, _ = run(file, certificate(1, [0, 0, "1/7"], tree=[["void"]]), "--json")
        return json.loads(out)["found"].split(", ")[-1][:-1] if code == 1 else None

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
                     '"' + "1" * 16_385 + '"', "1" * 16_385):
            self.assertIsNone(self.wrench(text), text[:20])
        self.assertIsNotNone(self.wrench("1" * 16_384))
        self.assertIsNotNone(self.wrench('"0.' + "1" * 16_382 + '"'))

    def test_structure(self):
        self.bad("format", self.file(format="stickslip-grasp/2"))
        self.bad("'wrench' is missing", {k: v for k, v in self.file().items() if k != "wrench"})
        self.bad("'contacts' is missing", {k: v for k, v in self.file().items() if k != "contacts"})
        self.bad("unknown member 'frictoin'", self.file(frictoin=1))
        self.bad("contacts[0]: unknown member", self.file(contacts=[{**self.CONTACT, "mu": 1}]))
        self.bad("defaults: unknown member", self.file(defaults={"normal": [0, 1]}))
        self.bad("is repeated", json.dumps(self.file()).replace('"friction"',
                                                                '"friction": 1, "friction"'))
        self.bad("name: must be a string", self.file(name=1))
        self.bad("defaults: must be an object", self.file(defaults=[]))
        self.bad("contacts: must be an array", self.file(contacts={}))
        self.bad("contacts[0]: must be an object", self.file(contacts=[[]]))
        self.bad("wrench: must be an array of 3", self.file(wrench=[0, 1]))
        self.bad("not JSON", "{")
        self.bad("nesting", "[" * 33)
        self.bad("must be an object", "[" * 32 + "]" * 32)

    def test_contacts(self):
        def bad(needle, **members):
            self.bad("contacts[0]" + needle, self.file(contacts=[{**self.CONTACT, **members}]))

        bad(".normal: must not be zero", normal=[0, "0/7"])
        bad(".normal: must be an array of 2", normal=[1])
        bad(".position", position=[0, 0, 0])
        bad(".friction: -1 is out of range", friction=-1)
        bad(".stiffness: 0 is out of range", stiffness=0)
        bad(".preload: -1 is out of range", preload=-1)
        bare = {k: v for k, v in self.CONTACT.items() if k != "friction"}
        self.bad("contacts[0]: 'friction' is missing", self.file(contacts=[bare]))

    def test_defaults(self):
        """A contact's own value before defaults, and these before 1 and 0."""
        bare = {"position": [0, 0], "normal": [0, 1]}
        for defaults, own, y, a in (({}, {}, -1, 1), ({"stiffness": 2}, {}, "-1/2", 1),
                                    ({"stiffness": 2}, {"stiffness": 4}, "-1/4", 1),
                                    ({"preload": 3}, {}, 2, 1),
                                    ({"preload": 3}, {"preload": "1/2"}, "-1/2", 1)):
            file = self.file(defaults={"friction": 0, **defaults}, contacts=[{**bare, **own}],
                             wrench=[0, -1, 0])
            self.accepts(file, certificate(1, [0, -1, 0], twist=[0, y, 0], forces=[[a, 0]]))

    def test_snapping_members(self):
        for value in ("Snap", True, None, 1, [], {"snap": 0}, {"snap": 1}, {"snap": -1}, {},
                      {"snap": "1/2", "x": 1}):
            self.bad("normals", self.file(normals=value))
        for value in ("snap", "exact", {"snap": "1/2"}, {"snap": 1e-12}):
            self.accepts(self.file(normals=value), certificate(1, [0, 1, 0],
                                                               tree=[["leaf", 0, -1, 0]]))


class CommandLineTest(Case):
    def start(self, *arguments, stdin=None):
        return subprocess.run([sys.executable, "-B", CHECK, *arguments], input=stdin,
                              capture_output=True, timeout=60, check=False)

    def test_as_a_program(self):
        with tempfile.TemporaryDirectory() as folder:
            g, c = os.path.join(folder, "g.json"), os.path.join(folder, "c.json")
            for path, content in ((g, FIG1), (c, up())):
                with open(path, "w", encoding="utf-8") as file:
                    json.dump(content, file)
            done = self.start(*UP, g, c)
            self.assertEqual((done.returncode, done.stdout.split(b"\n")[0], done.stderr),
                             (0, b"accepted", b""))
            for files, text in ((("-", c), FIG1), ((g, "-"), up())):
                done = self.start(files[0], *UP, files[1], stdin=json.dumps(text).encode())
                self.assertEqual((done.returncode, done.stderr), (0, b""))
            done = self.start(g, c)
            self.assertEqual(done.returncode, 1)
            self.assertTrue(done.stdout.startswith(b"rejected: question-wrench"))
            done = self.start(g, "-", stdin=b"{}")
            self.assertEqual((done.returncode, done.stdout), (2, b""))
            self.assertTrue(done.stderr.startswith(b"standard input: "))
            done = self.start(g, os.path.join(folder, "absent"))
            self.assertEqual(done.returncode, 2)
            self.assertEqual(self.start(g, folder).returncode, 2)

    def test_usage(self):
        for arguments in ([], ["g"], ["g", "c", "d"], ["-", "-"], ["g", "c", "--bogus"],
                          ["g", "c", "--wrench"], ["g", "c", "--wrench", "1,2"],
                          ["g", "c", "--wrench", "1,2,x"], ["g", "c", "--direction", "0,0,0"],
                          ["g", "c", "--direction", "1"], ["g", "c", "--preload", "-1"],
                          ["g", "c", "--preload", "nan"], ["g", "c", "--normal-law", "none"],
                          ["g", "c", "--snap-normals", "0"], ["g", "c", "--snap-normals", "1"],
                          ["g", "c", "--js"], ["g", "c", "--json=1"]):
            err = io.TextIOWrapper(io.BytesIO())
            with contextlib.redirect_stderr(err), self.assertRaises(SystemExit) as stop:
                check.main(arguments)
            self.assertEqual(stop.exception.code, 2, arguments)

    def test_json_reports(self):
        keys = ["result", "rule", "node", "path", "found", "verdict", "nodes", "leaves", "resisted"]
        code, out, err = run(FIG1, up(), *UP, "--json")
        self.assertEqual((code, err, list(json.loads(out).items())), (0, "", list(zip(
            keys, ["accepted", None, None, None, None, "unstable", 5, 3, None]))))
        code, out, err = run(FIG1, up(UP_TREE[:-1]), *UP, "--json")
        self.assertEqual((code, err, list(json.loads(out).items())), (1, "", list(zip(
            keys, ["rejected", "tree-short", 4, "separation 0 open", "1 children are missing",
                   "unstable", 4, 2, None]))))
        code, out, err = run(FIG1, up([["slip", "0"]]), *UP, "--json")
        report = json.loads(out)
        self.assertEqual((code, report["result"], report["path"], report["verdict"]),
                         (2, "malformed", "tree[0]", None))
        self.assertIn("tree[0]: must be an integer", err)

    def test_a_closed_pipe_is_no_answer_and_no_noise(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for name, content in (("g.json", FIG1), ("c.json", up())):
                paths.append(os.path.join(folder, name))
                with open(paths[-1], "w", encoding="utf-8") as file:
                    json.dump(content, file)
            with subprocess.Popen([sys.executable, "-B", CHECK, *paths, *UP],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
                process.stdout.close()
                self.assertEqual(process.stderr.read(), b"")
            self.assertEqual(process.returncode, 2)

    def test_an_unforeseen_error_is_no_rejection(self):
        original = check.check_tree
        check.check_tree = lambda *_: {}["missing"]
        try:
            code, out, err = run(FIG1, up(), *UP)
        finally:
            check.check_tree = original
        self.assertEqual((code, out), (2, ""))
        self.assertIn("internal error", err)


if __name__ == "__main__":
    unittest.main()
