#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Searches for the short question that costs a checker most.

  most_work.py SECONDS PROGRAM [WORD ...]     such as 600 build/bin/stickslip-proved, or 600 node certificate/js/check_node.js

FORMAT.md section 8 promises that files of 10 kB are answered within 10 s of the processor and 1 GB. A question is made of
a few numbers (a genome): how many bodies and contacts, how long the numbers are, what nodes the tree has. Its leaves hold
whatever the tree is, as y goes away from all contacts and the load does work against it, so nothing ends a check early. The best genome
so far is changed at random, and what takes longer replaces it. The worst input is written to most_work.grasp.json and
most_work.certificate.json; more than 10 s or 1 GB ends the search with exit 1.
"""

import json
import os
import random
import resource
import subprocess
import sys
import time

BYTES, SECONDS, MEMORY = 10_000, 10, 10 ** 9
LIMIT = 120  # of the processor, for one question

# What each gene may be.
GENES = {
    "bodies": [0, 0, 0, 1, 2, 3, 5],  # 0: a file about one body
    "space": [False, True, True],
    "contacts": [1, 2, 3, 4, 6, 8, 12, 16, 24],
    "exponent": [0, 20, 100, 300, 1000, 2000, 4000],
    "spread": [0, 1, 10, 96],  # exponents differ by so much: powers of ten have nothing in common then
    "digits": [1, 1, 2, 10, 50, 300],  # of numbers without an exponent, and of fractions
    "long_share": [0, 10, 30, 60, 100],  # of a hundred numbers
    "fractions": [False, False, True],
    "friction": ["0", "1/1000", "long"],
    "normals": ["any", "up"],  # of irrational length, for the most part, or not
    "torsion": [False, False, True],
    "stiffness": ["1", "long"],
    "preload": ["0", "1", "long"],
    "law": ["unilateral", "bilateral"],
    "uncertain": [None, None, None, "friction", "stiffness", "wrench"],
    "slip": [0, 1, 4],  # weights of kinds of nodes
    "separation": [0, 1, 4],
    "plane": [0, 1, 4],
    "long_planes": [False, False, True],
    "moving": [False, False, True],  # leaves whose twist moves
    "moment_curve": [False, True],
    "chain": [0, 50, 100],  # of a hundred nodes: those whose second child is a leaf
    "nodes": [4, 16, 64, 200],
}


class Maker:
    """A grasp and its certificate of a genome; the same for the same genome."""

    def __init__(self, genome):
        self.gene = genome
        self.random = random.Random(json.dumps(genome, sort_keys=True))

    def integer(self, digits):
        return self.random.choice("123456789") + "".join(self.random.choices("0123456789", k=digits - 1))

    def long(self):
        gene = self.gene
        if gene["fractions"]:
            return self.integer(gene["digits"]) + "/" + self.integer(gene["digits"])
        exponent = min(4096, gene["exponent"] + self.random.randrange(gene["spread"] + 1))
        return f"{self.integer(min(gene['digits'], 20))}e-{exponent}"

    def number(self, short):
        if self.random.randrange(100) >= self.gene["long_share"]:
            return self.random.choice(short)
        return self.random.choice(["", "-"]) + self.long()

    def one_of(self, gene):
        return self.long() if self.gene[gene] == "long" else self.gene[gene]

    def contact(self):
        gene, small = self.gene, ["0", "1", "-1", "1/2"]
        up = gene["normals"] == "up"
        size = 3 if gene["space"] else 2
        result = {"position": [self.number(["0", "1", "-1", "2", "-3"]) for _ in range(size)],
                  "normal": ["0"] * (size - 1) + [self.number(["1"]).lstrip("-")] if up else
                            [self.number(small) for _ in range(size - 1)] + ["1"],
                  "friction": f"{self.integer(3)}e-{max(6, gene['exponent'])}" if gene["friction"] == "long" else gene["friction"],
                  "stiffness": self.one_of("stiffness"), "preload": self.one_of("preload")}
        if gene["bodies"]:
            result["of"] = f"b{self.random.randrange(gene['bodies'])}"
            if gene["torsion"] and gene["space"]:
                result["torsion"] = self.long()
        return result

    def tree(self, leaf, functions):
        gene, most = self.gene, self.gene["contacts"]
        certain = gene["uncertain"] not in ("stiffness", "wrench") and (
            gene["normals"] == "up" or gene["preload"] == gene["friction"] == "0")
        kinds = [kind for kind in ("slip", "separation", "plane") for _ in range(gene[kind])
                 if certain or kind == "plane"] or ["plane"]

        def node(k):
            kind = self.random.choice(kinds)
            if kind != "plane":
                return [kind, self.random.randrange(most)]
            if gene["moment_curve"]:
                return ["plane", *(k ** power for power in range(functions))]
            if gene["long_planes"]:
                return ["plane", *(self.integer(gene["digits"]) for _ in range(functions))]
            return ["plane", *(self.random.randrange(-3, 4) for _ in range(functions - 1)), 1]

        result, count = [], 0

        def below(nodes):
            """Nodes of a tree with about so many inner ones."""
            nonlocal count
            stack = [nodes]
            while stack:
                nodes = stack.pop()
                if nodes <= 0:
                    result.append(leaf)
                    continue
                count += 1
                one = node(count)
                result.append(one)
                children = 3 if one[0] == "slip" and not gene["space"] else 2
                shares = [0] * children
                if self.random.randrange(100) < gene["chain"]:
                    shares[0] = nodes - 1
                else:
                    for child in range(children):
                        shares[child] = (nodes - 1) // children
                stack += reversed(shares)

        below(gene["nodes"])
        return result

    def files(self):
        """Their texts, as long as they may be: nodes are left out until they are."""
        gene = self.gene
        size = 6 if gene["space"] else 3
        dimension = size * max(1, gene["bodies"])
        up = 2 if gene["space"] else 1
        load = ["0"] * dimension
        leaf = ["0"] * dimension
        for body in range(max(1, gene["bodies"])):
            load[body * size + up], leaf[body * size + up] = "1", "-1"
        version = 3 if gene["bodies"] else 2 if gene["space"] else 1
        grasp = {"format": f"stickslip-grasp/{version}", "contacts": [self.contact() for _ in range(gene["contacts"])],
                 "wrench": load}
        if gene["bodies"]:
            grasp["bodies"] = [{"name": f"b{k}"} for k in range(gene["bodies"])]
            if not gene["space"]:
                grasp["contacts"] = [{k: v for k, v in c.items() if k != "torsion"} for c in grasp["contacts"]]
        question = {"contacts": gene["contacts"], "wrench": load, "normal_law": gene["law"]}
        words = ["--normal-law", gene["law"]]
        if gene["uncertain"]:
            question["uncertain"] = {gene["uncertain"]: "1%"}
            words += ["--uncertain", f"{gene['uncertain']}=1%"]
        moving = ["moving", *leaf, self.number(["0"]), [[0, "0", ["0"] * (3 + ("torsion" in grasp["contacts"][0])) if gene["space"] else "0"]]]
        nodes = self.tree(moving if gene["moving"] else ["leaf", *leaf], dimension + 1)
        text = json.dumps({"format": "stickslip-certificate/2", "question": question, "verdict": "unstable", "tree": nodes},
                          separators=(",", ":"))
        return json.dumps(grasp, separators=(",", ":")), text, words


def changed(genome, how):
    result = dict(genome)
    for _ in range(how.choice([1, 1, 2, 3])):
        gene = how.choice(sorted(GENES))
        result[gene] = how.choice(GENES[gene])
    result["seed"] = how.randrange(1000)
    return result


def fits(genome):
    grasp, text, words = Maker(genome).files()
    return len(grasp) + len(text) <= BYTES


def cost(program, genome, folder):
    """Seconds of the processor, as those of 10 kB, the answer and the memory that one run takes."""
    grasp, text, words = Maker(genome).files()
    paths = [os.path.join(folder, f"most_work.{kind}.json") for kind in ("grasp", "certificate")]
    for path, content in zip(paths, (grasp, text)):
        with open(path, "w", encoding="ascii") as file:
            file.write(content)
    with subprocess.Popen([*program, *paths, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT))) as process:
        answer = process.stdout.read()
        _, _, used = os.wait4(process.pid, 0)
        process.returncode = 0
    # What may take 10 s in 10 kB may take so much in fewer.
    share = (1 + ((len(grasp) + len(text)) / BYTES) ** 2) / 2
    return (used.ru_utime + used.ru_stime) / share, answer, used.ru_maxrss * 1024


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    end, program = time.monotonic() + float(arguments[0]), arguments[1:]
    how = random.Random(arguments[1])
    best, most = None, 0.0
    tried = 0
    while time.monotonic() < end:
        if best is None or how.randrange(4) == 0:
            genome = {gene: how.choice(values) for gene, values in GENES.items()}
        else:
            genome = changed(best, how)
        if not fits(genome):
            continue
        tried += 1
        seconds, answer, memory = cost(program, genome, ".")
        if seconds > most or memory > MEMORY:
            best, most = genome, seconds
            print(f"{seconds:6.2f} s  {memory >> 20} MB  {answer.splitlines()[:2]}  {json.dumps(genome)}", flush=True)
            if seconds > SECONDS or memory > MEMORY:
                return 1
            for kind in ("grasp", "certificate"):
                os.replace(f"most_work.{kind}.json", f"worst.{kind}.json")
    print(f"{tried} questions; the most was {most:.2f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
