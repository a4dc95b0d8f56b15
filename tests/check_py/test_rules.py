# SPDX-License-Identifier: MIT
"""Every rule of certificate/FORMAT.md, made to fail alone, in both checkers: with its name, node
and path. And the paper's grasps.

"§" refers to certificate/FORMAT.md, "Table" to Haas-Heger et al., RSS 2018.
"""

import random
import unittest

import naive
from support import FIG1, FIG4, UP, UP_TREE, Case, certificate, check, grasp, up


class PaperTest(Case):
    """Tables I and III; motions as printed, misprints corrected."""

    TABLE1 = [([0, 0, 0], 0, [], [0, 0, 0]),
              ([0, 0, 0], 1, [[0, -1], [2, 1]], [0, 0, 0]),
              ([0, -1, 0], 0, [], [0, -1, 0]),
              ([0, -2, 0], 0, [], [0, -2, 0]),
              ([0, 1, 0], 1, [], [0, 1, 0])]
    TABLE3 = [([0, 0, 0], 0, [], [0, 0, 0]),
              ([0, 0, 0], 1, [], [0, 0, 0]),
              ([0, 2, 0], 1, [[0, -1], [1, -1], [2, 1], [3, 1]], [0, 0, 0]),
              ([0, -2, 0], 1, [[0, 1], [1, 1], [2, -1], [3, -1]], [0, 0, 0]),
              ([0, 0, 3], 0, [[2, 1]], [0, -1, 1]),
              ([0, 0, -3], 0, [[3, -1]], [0, 1, -1]),
              ([0, 0, 3], 1, [[2, 1], [3, 1]], [0, "-1/4", "1/4"]),
              ([0, 0, -3], 1, [], [0, "1/40", "-1/4"]),
              ([0, 0, -3], 1, [[2, -1], [3, -1]], [0, "1/4", "-1/4"])]

    def test_stable_rows(self):
        for file, m, table in ((FIG1, 3, self.TABLE1), (FIG4, 4, self.TABLE3)):
            for wrench, preload, shares, twist in table:
                options = ["--wrench", ",".join(map(str, wrench)), "--preload", str(preload)]
                witness = {"twist": twist, "shares": shares}
                text = self.accepts(file, certificate(m, wrench, preload, **witness), *options)
                self.assertIn("verdict     stable\n", text)
                # Under the bilateral law no contact may have opened (a = 0 > v).
                opened = preload == 0 and wrench[2] != 0
                code, _, _, _ = self.run_both(
                    file, certificate(m, wrench, preload, "bilateral", **witness), *options,
                    "--normal-law", "bilateral")
                self.assertEqual(code, 1 if opened else 0, (wrench, preload))

    def test_figure_1_beyond_its_threshold(self):
        text = self.accepts(FIG1, up(), *UP)
        self.assertEqual(text.split("\n")[1:], [
            "verdict     unstable", "contacts    3", "wrench      (0, 11/10, 0)",
            "preload     1 at all contacts", "normal law  unilateral",
            "proof       a tree of 5 nodes: 3 leaves", ""])
        # On the threshold it is stable, and the tree must fail; just beyond, not.
        at = certificate(3, [0, 1, 0], 1, tree=UP_TREE)
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
        text = self.accepts(file, certificate(3, [0, -1, 0], twist=[0, -1, 0]))
        self.assertIn("preload     as in the grasp file\n", text)


class QuestionTest(Case):
    """§1, and §3, `question-…`."""

    def test_contacts(self):
        self.rejects("question-contacts", FIG4, up(), *UP)
        many = up()
        many["question"]["contacts"] = 10**30
        self.rejects("question-contacts", FIG1, many, *UP)

    def test_wrench(self):
        self.rejects("question-wrench", FIG1, up(), "--wrench", "0,1.1001,0", "--preload", "1")
        self.rejects("question-wrench", FIG1, up(), "--preload", "1")
        self.accepts(FIG1, up(), "--wrench", "0,1.1,-0", "--preload", "1e0")

    def test_preload(self):
        self.rejects("question-preload", FIG1, up(), "--wrench", "0,1.1,0")
        self.rejects("question-preload", FIG1, up(), "--wrench", "0,1.1,0", "--preload", "2")
        absent = certificate(3, [0, "11/10", 0], tree=UP_TREE)
        self.rejects("question-preload", FIG1, absent, *UP)
        # The value is that of the file, but nobody replaced it.
        file = {**FIG1, "defaults": {"friction": "1/2", "preload": 1}}
        self.rejects("question-preload", file, up(), "--wrench", "0,1.1,0")

    def test_law(self):
        self.rejects("question-law", FIG1, up(), *UP, "--normal-law", "bilateral")
        self.rejects("question-law", FIG1, up(question={**up()["question"],
                                                        "normal_law": "bilateral"}), *UP)

    def test_directions(self):
        margin = MarginTest.margin
        self.rejects("question-direction", FIG1, margin(), "--preload", "1", "--wrench", "0,0,0")
        self.rejects("question-direction", FIG1, up(), *UP, "--direction", "0,1,0")
        self.rejects("question-direction", FIG1, margin(), "--preload", "1", "--direction", "0,2,0")
        rule, asked = "question-preload-direction", MarginTest.ASKED
        self.rejects(rule, FIG1, margin(), *asked, "--preload-direction", "0,0,0")
        self.rejects(rule, FIG1, margin(), *asked, "--preload-direction", "scale")
        for said in ("scale", [0, 0, 0], [1, 0, 0], []):
            self.rejects(rule, FIG1, margin(preload_direction=said), *asked)
            self.rejects(rule, FIG1, margin(preload_direction=said), *asked,
                         "--preload-direction", "0,0,1")

    def test_the_question_comes_before_the_evidence(self):
        self.rejects("question-wrench", FIG1, up([["slip", 7]]), "--preload", "1")
        worse = up(question={**up()["question"], "contacts": 4, "wrench": [0, 0, 0]})
        self.rejects("question-contacts", FIG1, worse)

    def test_questions_that_cannot_be_asked(self):
        for options, needle in ((("--preload", "-1"), "the question: preload: "),
                                (("--direction", "0,0,0/1"), "the question: direction: "),
                                (("--preload-direction", "0,0,0"), "the question: direction: "),
                                (("--preload-direction", "scale"), "the question: direction: "),
                                (("--preload-direction", "1,1"), "the question: preload dir"),
                                (("--preload-direction", "1,1,1,1"), "the question: preload dir"),
                                (("--preload-direction", "1,1,-1"), "the question: preload dir")):
            self.malformed(needle, FIG1, up(), *options)

    def test_normals_of_irrational_length(self):
        """In margins refused where the length is needed, with the remedy."""
        two = grasp([[0, 0], [1, 0]], [[0, 1], [1, 1]], wrench=[0, -1, 0])
        plain = certificate(2, [0, -1, 0], tree=[["leaf", 0, 0, 0]])
        self.rejects("leaf-bound", two, plain, node=0, path="root")
        remedy = "stickslip snap GRASP -o FILE"
        self.rejects("question-preload", two, plain, "--preload", "1")
        for options in (("--preload-direction", "0,1"),
                        ("--preload", "1", "--preload-direction", "scale")):
            self.malformed(remedy, two, plain, *options)
            self.malformed("contacts[1].normal", two, plain, *options)
        code, _, _, _ = self.run_both(two, plain, "--preload-direction", "1,0")
        self.assertEqual(code, 1)  # length 1, and no preload at the other: it can be asked
        for snap in ("snap", "exact", {"snap": "0.99"}):
            self.malformed(remedy, {**two, "normals": snap}, plain)

    def test_the_base_point(self):
        """§1, the table, in the words of the answer, for all combinations of the options."""
        file = {**FIG1, "wrench": [0, -7, 0], "defaults": {"friction": 0, "preload": 1}}
        never = {"resisted": [], "segments": [], "tree": []}
        own, ones = "as in the grasp file", "1 at all contacts"
        for u in (None, [0, 1, 0]):
            for growth in (None, "scale", ["1", "0", "2"]):
                for wrench in (None, [0, -3, 0]):
                    for preload in (None, "1"):
                        if not u and not growth:
                            continue
                        options = ["--direction", "0,1,0"] if u else []
                        options += ["--wrench", "0,-3,0"] if wrench else []
                        options += ["--preload", preload] if preload else []
                        options += ["--preload-direction", growth if growth == "scale" else
                                    "1,0,2"] if growth else []
                        w = wrench or ([0, 0, 0] if u else [0, -7, 0])
                        proof = certificate(3, w, preload, "unilateral", u, growth, **never)
                        self.rejects("tree-short", file, proof, *options, node=0, path="root")
                        text = self.accepts(file, self.proof(proof, w, u, growth), *options)
                        self.assertIn(f"\nwrench      ({', '.join(map(str, w))})\n", text)
                        self.assertEqual("\ndirection   (0, 1, 0)\n" in text, u is not None)
                        words = ones if preload else own
                        self.assertIn("\npreload     " + (
                            f"f times {words}" if growth == "scale" else
                            f"{words} + f (1, 0, 2)" if growth else words) + "\n", text)

    def proof(self, base, w, u, growth):
        """Frictionless Fig. 1, P = 1 at each contact: balance asks for a_0 = a_2 and
        a_1 = -w_y - λ u_y, which any P allows if that is >= 0: then d = (x, y, 0) with
        a_0 = P_0 - x = P_2 + x and a_1 = P_1 - y."""
        fixed = 0 if growth == "scale" else 1
        grown = (1, 1, 1) if growth == "scale" else (1, 0, 2) if growth else (0, 0, 0)

        def point(load, ray=False):
            p0, p1, p2 = ((0 if ray else fixed) + load * g for g in grown)
            a1 = -((0 if ray else w[1]) + load * (u[1] if u else 0))
            return [None if ray else load, [str(naive.Fraction(p0 - p2, 2)), p1 - a1, 0], []]

        if not u:
            return {**base, "resisted": [[0, None]], "segments": [[point(0), point(1, True)]]}
        return {**base, "resisted": [[0, -w[1]]], "segments": [[point(0), point(-w[1])]],
                "tree": [["leaf", 0, -1, 0]]}


class WitnessTest(Case):
    """§3, `witness-…`."""

    def check(self, rule, twist, shares, wrench=(0, -1, 0), *options, file=FIG1):
        law = "bilateral" if "bilateral" in options else "unilateral"
        m = len(file["contacts"])
        one = certificate(m, list(map(str, wrench)), law=law, twist=twist, shares=shares)
        options = ("--wrench", ",".join(map(str, wrench)), *options)
        if rule:
            self.rejects(rule, file, one, *options)
        else:
            self.accepts(file, one, *options)

    def test_shares(self):
        # P = 1, at rest: contacts 0 and 2 carry (0, -1, 0) up to their friction 1/2 each.
        file = {**FIG1, "defaults": {"friction": "1/2", "preload": 1}}
        rest, load = [0, 0, 0], (0, 0, 0)
        self.check(None, rest, [[0, -1], [2, 1]], load, file=file)
        self.check(None, rest, [[0, "-2/2"], [1, 0], [2, "5/5"]], load, file=file)
        for shares in ([[2, 1], [0, -1]], [[0, -1], [0, -1], [2, 1]], [[0, -1], [2, 1], [3, 0]],
                       [[0, "-1000001/1000000"], [2, 1]], [[0, -1], [2, "3/2"]], [[10**30, 0]]):
            self.check("witness-share", rest, shares, load, file=file)
        self.check("witness-balance", rest, [[0, -1]], load, file=file)
        self.check("witness-balance", rest, [], load, file=file)

    def test_a_share_where_a_contact_slips(self):
        # Contact 1 slips: T_1·d = -x - r.
        wrench = ("-3/2", -1, 0)
        slide = ["-1/2", -1, 0]
        code, report, _, _ = self.run_both(
            FIG1, certificate(3, list(map(str, wrench)), twist=slide, shares=[[1, 0]]),
            "--wrench", "-3/2,-1,0")
        self.assertEqual((code, report["rule"]), (1, "witness-share"))
        self.assertIn("slips", report["found"])

    def test_a_share_without_effect(self):
        # No force at contacts 0 and 2; no friction.
        self.check(None, [0, -1, 0], [[1, 0]])
        smooth = grasp([[0, 0]], [[0, 1]])
        smooth["defaults"]["friction"] = 0
        for share in (-1, 0, 1):
            self.check(None, [0, -1, 0], [[0, share]], (0, -1, 0), file=smooth)
        apart = grasp([[0, 0]], [[0, 1]])
        for share in (-1, 0, 1):
            self.check(None, [0, 1, 0], [[0, share]], (0, 0, 0), file=apart)

    def test_balance(self):
        self.check(None, [0, -1, 0], [])
        for wrench in ((0, -1, 1), (0, -2, 0), ("1/1000", -1, 0)):
            self.check("witness-balance", [0, -1, 0], [], wrench)

    def test_slip_direction(self):
        # One contact under load, mu = 1/2, T = (-1, 0, 0): the force in x is -b.
        file = grasp([[0, 0]], [[0, 1]])
        for x, share, force, rule in ((-1, [], "-1/2", None), (-1, [], "1/2", "witness-balance"),
                                      (1, [], "1/2", None), (1, [], "-1/2", "witness-balance"),
                                      (0, [], 0, None), (0, [[0, 1]], "1/2", None),
                                      (0, [[0, -1]], "-1/2", None),
                                      (0, [[0, "1/3"]], "1/6", None),
                                      (1, [[0, 1]], "1/2", "witness-share")):
            self.check(rule, [x, -1, 0], share, (force, -1, 0), file=file)

    def test_bilateral_law(self):
        bilateral = ("--normal-law", "bilateral")
        self.check(None, [0, -1, 0], [], (0, -1, 0), *bilateral)
        self.check("witness-normal", [0, 1, 0], [], (0, 0, 0), *bilateral)
        self.check(None, [0, 1, 0], [], (0, 0, 0))
        # The order of the rules: shares, normal law, balance.
        self.check("witness-share", [0, 1, 0], [[0, 2]], (0, 0, 1), *bilateral)
        self.check("witness-normal", [0, 1, 0], [], (0, 0, 1), *bilateral)

    def test_normals_of_any_length(self):
        # n = (0, 2) and k = 1: L = 2, so N = (0, 2, 0), v = P/2 - (1/4) 2 y.
        file = {**grasp([[0, 0]], [[0, 2]]), "wrench": [0, -3, 0]}
        for p, y, rule in ((0, -3, None), (1, -2, None), (1, 1, "witness-balance")):
            one = certificate(1, [0, -3, 0], p, twist=[0, y, 0])
            if rule:
                self.rejects(rule, file, one, "--preload", str(p))
            else:
                self.accepts(file, one, "--preload", str(p))
        # n = (1, 1): irrational length, k' = 1/2; fine without preload.
        file = {**grasp([[0, 0]], [[1, 1]]), "wrench": [-1, -1, 0]}
        self.accepts(file, certificate(1, [-1, -1, 0], twist=[-1, -1, 0]))

    def test_no_contact(self):
        none = grasp([], [])
        self.accepts(none, certificate(0, [0, 0, 0], twist=[7, 0, "1/3"]))
        self.rejects("witness-balance", none, certificate(0, [0, 0, 1], twist=[0, 0, 0]),
                     "--wrench", "0,0,1")


class TreeTest(Case):
    """§4: each rule fires, with the node's number and path."""

    def rule(self, rule, tree, node, path):
        self.rejects(rule, FIG1, up(tree), *UP, node=node, path=path)

    def test_node_contact(self):
        self.rule("node-contact", [["slip", 3]], 0, "root")
        self.rule("node-contact", [["separation", 0], ["separation", 10**30]], 1,
                  "separation 0 closed")

    def test_node_depth(self):
        for split in (["slip", 1], ["separation", 0], ["plane", 1, 0, 0, 0], ["plane", 0, 0, 0, 0]):
            name = {"slip": "slip 1 +", "separation": "separation 0 closed",
                    "plane": "plane +"}[split[0]]
            most = 2 * 3 + 256
            self.rule("tree-short", [split] * most, most, ", ".join([name] * most))
            self.rule("tree-short", [split] * (most + 1), most + 1, ", ".join([name] * (most + 1)))
            self.rule("node-depth", [split] * (most + 2), most + 1, ", ".join([name] * (most + 1)))
            deep = [split] * most + [["leaf", 0, 0, 0]]
            self.rule("leaf-bound", deep, most, ", ".join([name] * most))

    def test_splits_may_repeat(self):
        """The second time, all children but one are barred; a = 0 splits off nothing."""
        void = ["leaf", 0, 0, 0]
        again = [["separation", 0], ["separation", 0], *UP_TREE[1:4], void, UP_TREE[4]]
        self.accepts(FIG1, up(again), *UP)
        below = [*UP_TREE[:4], ["separation", 0], void, UP_TREE[4]]
        self.accepts(FIG1, up(below), *UP)
        nothing = [["plane", 0, 0, 0, 0], *UP_TREE, void]
        self.accepts(FIG1, up(nothing), *UP)
        self.rule("leaf-bound", [["plane", 0, 0, 0, 0], void], 1, "plane +")
        leaf = ["leaf", 0, -1, 1]
        twice = [*UP_TREE[:4], ["slip", 1], ["slip", 1], leaf, void, void, ["slip", 1], void, leaf,
                 void, ["slip", 1], void, void, leaf]
        self.accepts(FIG1, up(twice), *UP)

    def test_separation_under_the_bilateral_law(self):
        """It is one more plane: the second child holds nothing, as v >= 0 on the root."""
        two = grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], wrench=[0, 1, 0])
        tree = [["separation", 1], ["leaf", 0, -1, 0], ["leaf", 0, 0, 0]]
        self.accepts(two, certificate(2, [0, 1, 0], law="bilateral", tree=tree),
                     "--normal-law", "bilateral")

    def test_slip_and_separation_of_a_contact_may_share_a_path(self):
        leaf = ["leaf", 0, -1, 1]
        tree = [["separation", 0], *UP_TREE[1:4], ["slip", 0], ["separation", 1], leaf, leaf, leaf,
                leaf]
        self.accepts(FIG1, up(tree), *UP)

    def test_tree_rules(self):
        self.rule("tree-short", [], 0, "root")
        self.rule("tree-short", UP_TREE[:-1], 4, "separation 0 open")
        self.rule("tree-short", UP_TREE[:3], 3, "separation 0 closed, separation 2 open")
        self.rule("tree-long", UP_TREE + [["leaf", 0, 0, 0]], 5, None)
        self.rule("tree-long", UP_TREE + [["slip", 10**30]], 5, None)

    def test_the_first_rule_in_order(self):
        self.rule("leaf-bound", [["slip", 0], ["leaf", 0, 0, 0], ["slip", 7]], 1, "slip 0 +")

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

    def test_a_mixed_contact_counts_nothing_against_the_load(self):
        # Normals (4, 3) and (-4, 3) at the origin, mu = 0. Where y <= -10 h the contacts push up by
        # 3 (a_0 + a_1) > 1, which y = (0, -1, 0) would see if either were closed everywhere.
        file = grasp([[0, 0], [0, 0]], [[4, 3], [-4, 3]], wrench=[0, -1, 1])
        file["defaults"]["friction"] = 0
        tree = [["plane", 0, -1, 0, -10], ["leaf", 0, -1, 0], ["leaf", 0, 0, -1]]
        self.rejects("leaf-bound", file, certificate(2, [0, -1, 1], tree=tree), node=1,
                     path="plane +")
        tree[1] = ["leaf", 0, 0, -1]
        self.accepts(file, certificate(2, [0, -1, 1], tree=tree))

    def test_signs(self):
        # One contact at the origin, N = (0, 1, 0), T = (-1, 0, 0), mu = 1/2, under (3/4, -1, 0):
        # unstable, as (-2, -1, 0) shows everywhere. (-1, 0, 0) shows it iff the contact has the
        # sign +, of τ = -x, so that its friction pushes along x.
        one = grasp([[0, 0]], [[0, 1]], wrench=["3/4", -1, 0])
        sure, plus = ["leaf", -2, -1, 0], ["leaf", -1, 0, 0]

        def tree(*nodes):
            return certificate(1, ["3/4", -1, 0], tree=list(nodes))

        self.accepts(one, tree(["slip", 0], plus, sure, sure))
        self.accepts(one, tree(["plane", 1, 0, 0, 0], sure, plus))  # τ >= 0, strictly
        self.accepts(one, tree(["plane", -1, 0, 0, -1], plus, sure))  # τ >= h, and h > 0
        for split, nodes, node, path in ((["slip", 0], [sure, plus, sure], 2, "slip 0 0"),
                                         (["slip", 0], [sure, sure, plus], 3, "slip 0 -"),
                                         (["plane", -1, 0, 0, 0], [plus, sure], 1, "plane +"),
                                         (["plane", 1, 0, 0, -1], [sure, plus], 2, "plane -"),
                                         (["plane", 1, 0, 0, 0], [plus, sure], 1, "plane +")):
            self.rejects("leaf-bound", one, tree(split, *nodes), node=node, path=path)

    def test_barred(self):
        # τ_0 = y - r.
        void = ["leaf", 0, 0, 0]
        self.rule("leaf-bound", [void], 0, "root")
        self.rule("leaf-bound", [["separation", 0], ["plane", 1, 0, 0, 0], void], 2,
                  "separation 0 closed, plane +")
        # The first child of a plane is covered by no other.
        self.rule("leaf-bound", [["plane", 0, 1, 0, 0], ["plane", 0, -1, 0, 0], void], 2,
                  "plane +, plane +")
        # After τ_0 >= 0 strictly, -τ_0 >= 0 leaves nothing.
        self.rule("leaf-bound", [["slip", 0], ["plane", 0, -1, 1, 0], void, void], 3,
                  "slip 0 +, plane -")
        self.rule("leaf-bound", [["plane", 0, 1, -1, 0], ["slip", 0], void], 2,
                  "plane +, slip 0 +")

    def test_barred_children(self):
        """A plane split where v or τ is zero already: only second, + and - children are barred."""
        one = grasp([[0, 0]], [[0, 1]], wrench=[0, 1, 0])  # τ = -x, v = -y; y = (0, -1, 0) refutes
        leaf, void = ["leaf", 0, -1, 0], ["leaf", 0, 0, 0]

        def tree(*nodes):
            return certificate(1, [0, 1, 0], tree=list(nodes))

        self.accepts(one, tree(leaf))
        self.accepts(one, tree(["slip", 0], leaf, ["plane", 1, 0, 0, 0], leaf, void, leaf))
        self.rejects("leaf-bound", one, tree(["slip", 0], leaf, ["plane", 1, 0, 0, 0], void, leaf,
                                             leaf), node=3, path="slip 0 0, plane +")
        self.accepts(one, tree(["plane", 1, 0, 0, 0], ["plane", -1, 0, 0, 0], ["slip", 0], void,
                               leaf, void, leaf, leaf))
        self.accepts(one, tree(["plane", 1, 0, 0, 0], ["slip", 0], void, leaf, leaf, leaf))
        self.rejects("leaf-bound", one, tree(["plane", 1, 0, 0, 0], ["slip", 0], void, void, leaf,
                                             leaf), node=3, path="plane +, slip 0 0")
        self.accepts(one, tree(["plane", 1, 0, 0, 0], leaf, ["slip", 0], leaf, void, leaf))
        self.accepts(one, tree(["plane", 0, 0, 0, -1], ["leaf", 5, 5, 5], leaf))  # -h >= 0: no motion
        self.accepts(one, tree(["plane", 0, 0, 0, 1], leaf, void))

    def test_one_leaf_at_the_root(self):
        for m in (0, 1, 5):
            file = grasp([[j, j] for j in range(m)], [[0, 1]] * m, wrench=[0, 1, 0])
            self.accepts(file, certificate(m, [0, 1, 0], tree=[["leaf", 0, -1, 0]]))

    def test_no_contact(self):
        none = grasp([], [])
        self.rejects("leaf-bound", none, certificate(0, [0, 0, 0], tree=[["leaf", 1, 2, 3]]),
                     node=0, path="root")
        self.accepts(none, certificate(0, [0, 0, 1], tree=[["leaf", 0, 0, -1]]), "--wrench", "0,0,1")

    def test_bilateral_root(self):
        # Two contacts that face each other: both v >= 0 only at x = 0 without preload. Pushed along
        # y with friction the body is lost.
        two = grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], wrench=[0, 1, 0])
        tree = [["leaf", 0, -1, 0]]
        self.accepts(two, certificate(2, [0, 1, 0], law="bilateral", tree=tree),
                     "--normal-law", "bilateral")
        self.rejects("leaf-bound", two, certificate(2, [0, 1, 0], tree=tree), node=0, path="root")

    def test_many_leaves(self):
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
        text = self.accepts(file, certificate(m, ["1/3", 40, "-1/7"], tree=tree))
        self.assertIn("a tree of 501 nodes: 301 leaves", text)


    def test_long_denominators(self):
        """Each contact with its own: bounds must not carry all of them."""
        rng = random.Random(4)
        m = 30

        def long(low, high):
            denominator = rng.randrange(10**800, 10**801)
            return f"{denominator * rng.randint(low, high) // 1000 + 1}/{denominator}"

        contacts = [{"position": [long(-2000, 2000), long(-2000, 2000)],
                     "normal": [long(-300, 300), long(800, 1000)], "friction": long(100, 500),
                     "stiffness": long(1000, 3000)} for _ in range(m)]
        file = {"format": "stickslip-grasp/1", "contacts": contacts, "wrench": [0, 1, 0]}
        leaf = ["leaf", 0, -1, 0]
        tree = []
        for j in range(m):
            tree += [["separation", j], leaf]
        self.accepts(file, certificate(m, [0, 1, 0], tree=[*tree, leaf]))
        self.rejects("leaf-bound", file, certificate(m, [0, 1, 0], tree=[["slip", 1],
                                                                      ["leaf", "1/3", 1, 0]]),
                     node=1, path="slip 1 +")
        self.rejects("witness-balance", file, certificate(m, [0, 1, 0], twist=[0, "-1/7", "1/9"]))


class MarginTest(Case):
    """§5."""

    REST = [0, [0, 0, 0], [[0, -1], [2, 1]]]
    LIMIT = [1, [0, 1, 0], []]
    ASKED = ("--direction", "0,1,0", "--preload", "1")

    @staticmethod
    def margin(preload_direction=None, **changes):
        base = certificate(3, [0, 0, 0], 1, "unilateral", [0, 1, 0], preload_direction,
                           resisted=[[0, 1]], segments=[[MarginTest.REST, MarginTest.LIMIT]],
                           tree=UP_TREE)
        return {**base, **changes}

    def rule(self, rule, path, node=None, **changes):
        self.rejects(rule, FIG1, self.margin(**changes), *self.ASKED, node=node, path=path)

    def test_accepted(self):
        text = self.accepts(FIG1, self.margin(), *self.ASKED)
        self.assertEqual(text.split("\n")[1:-1], [
            "resisted    [0, 1]", "contacts    3", "wrench      (0, 0, 0)",
            "direction   (0, 1, 0)", "preload     1 at all contacts", "normal law  unilateral",
            "proof       segments: 1; trees: 1, of 5 nodes: 3 leaves"])
        _, report, _, _ = self.run_both(FIG1, self.margin(), *self.ASKED)
        self.assertEqual((report["verdict"], report["resisted"], report["question"]["direction"]),
                         ("margin", [["0", "1"]], ["0", "1", "0"]))

    def test_resisted_order(self):
        for resisted, k in (([[-1, 1]], 0), ([[1, 0]], 0), ([[0, 1], [1, 2]], 1),
                            ([[0, 2], [1, 3]], 1), ([[0, None], [1, 2]], 1), ([[0, 1], [3, 2]], 1)):
            self.rule("resisted-order", f"interval {k}", resisted=resisted)

    def test_segment_chain(self):
        rest, limit = self.REST, self.LIMIT
        half = ["1/2", [0, 0, 0], [[0, -1], [1, 0], [2, 1]]]
        for segments, resisted, k in (
                ([], [[0, 1]], 0), ([[rest, limit], [rest, limit]], [[0, 1]], 1),
                ([[limit, limit]], [[0, 1]], 0), ([[rest, limit]], [[0, 2]], 1),
                ([[rest, limit]], [[0, "1/2"]], 0), ([[limit, rest]], [[1, 2]], 0),
                ([[rest, [None, [0, 0, 0], []]]], [[0, 1]], 0), ([[half, limit]], [[0, 1]], 0),
                ([[rest, limit]], [], 0), ([[rest, limit]], [[0, None]], 1)):
            self.rule("segment-chain", f"segment {k}", segments=segments, resisted=resisted)

    def test_points(self):
        rest, limit = self.REST, self.LIMIT
        for segment, rule, which in (
                ([[0, [0, 0, 0], [[0, -2], [2, 1]]], limit], "witness-share", "first"),
                ([rest, [1, [0, 1, 0], [[0, 0]]]], "witness-share", "second"),
                ([[0, [0, 0, 0], []], limit], "witness-balance", "first"),
                ([rest, [1, [0, "1/2", 0], []]], "witness-balance", "second")):
            self.rule(rule, f"segment 0, {which} point", segments=[segment])
        # Where a segment begins with the last point, and where it only seems to.
        for shares, rule in (([[0, -1], [2, "999/1000"]], "witness-balance"),
                             ([[0, -1], [2, 1], [2, 1]], "witness-share"), ([], "witness-balance")):
            self.rule(rule, "segment 1, first point",
                      segments=[[rest, rest], [[*rest[:2], shares], limit]])
        self.accepts(FIG1, self.margin(segments=[[rest, rest], [rest, limit]]), *self.ASKED)
        # With one point they begin with the last.
        self.accepts(FIG1, self.margin(segments=[[rest, rest], [limit]]), *self.ASKED)
        self.accepts(FIG1, self.margin(segments=[[rest, rest], [rest], [limit]]), *self.ASKED)
        self.rule("segment-chain", "segment 1", segments=[[rest, limit], [limit]])
        self.rule("witness-balance", "segment 1, second point",
                  segments=[[rest, rest], [[1, [0, "1/2", 0], []]]])
        bilateral = self.margin(segments=[[rest, [1, [0, 2, 0], []]]])
        bilateral["question"]["normal_law"] = "bilateral"
        self.rejects("witness-normal", FIG1, bilateral, *self.ASKED, "--normal-law", "bilateral",
                     path="segment 0, second point")

    # One contact below the body, N = (0, 1, 0), T = (-1, 0, 0), mu = 1/2, P = 0: b pushes by -b.
    ONE = grasp([[0, 0]], [[0, 1]])

    def mode(self, rule, base, u, first, second, end=1):
        proof = certificate(1, base, None, "unilateral", u, resisted=[[0, end]],
                            segments=[[[0, *first], [end, *second]]], tree=[])
        options = ("--wrench", ",".join(map(str, base)), "--direction", ",".join(map(str, u)))
        code, report, _, _ = self.run_both(self.ONE, proof, *options)
        self.assertEqual(code, 1)
        self.assertEqual((report["rule"], report["path"]),
                         (rule, "segment 0" if rule == "segment-mode" else "root"
                          if end is not None else None), report)

    def test_segment_mode(self):
        good, bad = "tree-short", "segment-mode"
        still, left, right = [0, -1, 0], [-1, -1, 0], [1, -1, 0]
        # v of opposite signs: from apart to pressed.
        self.mode(bad, [0, 0, 0], [0, -1, 0], ([0, 1, 0], []), ([0, -1, 0], []))
        self.mode(good, [0, 0, 0], [0, -1, 0], ([0, 0, 0], []), ([0, -1, 0], []))
        # Slip of opposite signs; from full friction to full friction the force is the wrong one.
        self.mode(bad, ["-1/2", -1, 0], [1, 0, 0], (left, []), (right, []))
        # Sticking with full friction, then slipping: the same share at both ends, or not.
        self.mode(good, ["-1/2", -1, 0], [0, -1, 0], (still, [[0, -1]]),
                  ([0, -2, 0], [[0, "-1/2"]]))
        self.mode(bad, ["1/4", -1, 0], ["1/4", 0, 0], (still, [[0, "1/2"]]), (right, []))
        self.mode(good, ["1/2", -1, 0], ["1/2", -1, 0], (still, [[0, 1]]), ([1, -2, 0], []))
        self.mode(bad, ["-1/2", -1, 0], ["1", 0, 0], (still, [[0, -1]]), (right, []))
        # Forces interpolate, not shares: sticking at both ends, any shares.
        self.mode(good, ["-1/2", -1, 0], [1, -2, 0], (still, [[0, -1]]),
                  ([0, -3, 0], [[0, "1/3"]]))
        # Where there is no force at an end, its slip may be any of the same sign, or none.
        self.mode(good, [0, 0, 0], ["1/2", -1, 0], ([0, 0, 0], []), (right, []))
        self.mode(good, [0, 0, 0], ["1/2", -1, 0], ([0, 0, 0], [[0, -1]]), (right, []))
        self.mode(good, [0, 0, 0], ["1/2", -1, 0], ([5, 0, 0], []), (right, []))
        self.mode(bad, [0, 0, 0], ["1/2", -1, 0], ([-5, 0, 0], []), (right, []))

    def test_segment_mode_of_a_ray(self):
        down, slide = [None, [0, -1, 0], []], [None, [1, -1, 0], []]
        for u, first, ray, rule in (([0, -1, 0], [0, [0, 0, 0], []], down, None),
                                    ([0, -1, 0], [0, [0, 1, 0], []], down, "segment-mode"),
                                    (["1/2", -1, 0], [0, [0, 0, 0], []], slide, None),
                                    (["1/2", -1, 0], [0, [-1, 0, 0], []], slide, "segment-mode")):
            proof = certificate(1, [0, 0, 0], None, "unilateral", u, resisted=[[0, None]],
                                segments=[[first, ray]], tree=[])
            options = ("--direction", ",".join(map(str, u)))
            if rule:
                self.rejects(rule, self.ONE, proof, *options, path="segment 0")
            else:
                self.accepts(self.ONE, proof, *options)

    def test_trees(self):
        self.rule("tree-short", "separation 0 open", 4, tree=UP_TREE[:-1])
        self.rule("tree-long", None, 5, tree=UP_TREE + UP_TREE)
        self.rule("tree-short", "root", 0, tree=[])
        self.rule("leaf-bound", "root", 0, tree=[["leaf", 0, 1, 0]])

    def test_gaps(self):
        """Without contacts exactly λ = 1 is resisted: two gaps, one tree each."""
        none = grasp([], [])

        def proof(tree, resisted=((1, 1),)):
            point = [1, [0, 0, 0], []]
            return certificate(0, [-1, 0, 0], None, "unilateral", [1, 0, 0],
                               resisted=[list(i) for i in resisted],
                               segments=[[point, point]] * len(resisted), tree=tree)

        options = ("--wrench", "-1,0,0", "--direction", "1,0,0")
        below, above = ["leaf", 1, 0, 0], ["leaf", -1, 0, 0]
        self.accepts(none, proof([below, above]), *options)
        for tree, rule, node, path in (([below], "tree-short", 1, "root"),
                                       ([below, above, above], "tree-long", 2, None),
                                       ([above, above], "leaf-bound", 0, "root"),
                                       ([below, below], "leaf-bound", 1, "root"),
                                       ([below, ["leaf", 0, 0, 0]], "leaf-bound", 1, "root")):
            self.rejects(rule, none, proof(tree), *options, node=node, path=path)
        # All of [0, oo) is claimed not to be resisted.
        self.rejects("leaf-bound", none, proof([below], ()), *options, node=0, path="root")
        # A plane at λ = 1 splits it from the rest, but it belongs to the first child.
        plane = ["plane", 0, 0, 0, -1, 1]
        self.rejects("leaf-bound", none, proof([plane, above, below], ()), *options, node=1,
                     path="plane +")
        # Not the zero: after [0, 0] the gap does not contain 0; before [1, 1] it does.
        at_zero = certificate(0, [0, 0, 0], None, "unilateral", [1, 0, 0], resisted=[[0, 0]],
                              segments=[[[0, [0, 0, 0], []]] * 2], tree=[above])
        self.accepts(none, at_zero, "--direction", "1,0,0")
        never = {**at_zero, "resisted": [], "segments": []}
        self.rejects("leaf-bound", none, never, "--direction", "1,0,0", node=0, path="root")

    def test_preloads(self):
        """Fig. 1 holds (0, 1, 0) by the friction of contacts 0 and 2: 2 (λ/2) >= 1, from λ = 1 on."""
        wrench, tree = [0, 1, 0], [
            ["separation", 0], ["separation", 2], ["leaf", 0, -1, 0], ["leaf", 0, -1, -1],
            ["leaf", 0, -1, 1]]
        # At λ = 1 contact 1 just opens; on the ray its spring grows as well: y = 1.
        start, ray = [1, [0, 1, 0], []], [None, [0, 0, 0], [[0, -1], [2, 1]]]
        for growth, option, preload in (("scale", "scale", 1), ([1, 1, 1], "1,1,1", 0),
                                        (["1", 1, "2/2"], "1,1.0,1", 0)):
            proof = certificate(3, wrench, preload, "unilateral", None, growth,
                                resisted=[[1, None]], segments=[[start, ray]], tree=tree)
            options = ("--wrench", "0,1,0", "--preload", str(preload), "--preload-direction", option)
            text = self.accepts(FIG1, proof, *options)
            self.assertIn("resisted    [1, oo)\n", text)
            # On this ray contact 1 opens as its preload grows, and nothing balances the friction.
            self.rejects("witness-balance", FIG1,
                         {**proof, "segments": [[start, [None, [0, 1, 0], []]]]}, *options,
                         path="segment 0, second point")
            for low in ("999/1000", 0):
                self.rejects("witness-balance", FIG1,
                             {**proof, "resisted": [[low, None]],
                              "segments": [[[low, *start[1:]], ray]]}, *options,
                             path="segment 0, first point")
            self.rejects("leaf-bound", FIG1, {**proof, "resisted": [], "segments": []}, *options,
                         node=2, path="separation 0 closed, separation 2 closed")


if __name__ == "__main__":
    unittest.main()
