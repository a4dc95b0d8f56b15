# SPDX-License-Identifier: GPL-3.0-or-later
"""The module answers as the command does: both are given the same grasps and options, and their members, their proofs and what
they refuse are compared. That these are right is tested of the command (tests/interfaces/cli)."""

import dataclasses
import json
import os
import subprocess
from fractions import Fraction
from functools import partial

import pytest
import stickslip
from conftest import GOOD, ROOT
from stickslip import Assembly, Grasp, InputError

EXAMPLES = ROOT / "examples" / "grasps"
SPACE = [*sorted(EXAMPLES.glob("space-*.json")), *sorted((ROOT / "tests" / "corpus" / "near").glob("*4_*.json"))]

FIG1 = Grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]], "1/2", preload=1, name="fig1", wrench=(0, "1/2", 0))
FLOOR = Grasp([[-1, -1], [1, -1]], [[0, 1]] * 2, "1/2", wrench=("1/4", -1, 0))
TURNED = Grasp([[-1, -1], [1, -1], [0, 1]], [[1, 1], ["-1/3", 1], [0, -1]], 1, preload=1, wrench=(0, "1/10", 0))
UNBALANCED = Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], "1/2", preload=[1, 2], wrench=(0, 0, 0))
PINCH = Grasp([[-2, 0, 0], [2, 0, 0]], [[1, 0, 0], [-1, 0, 0]], "1/2", preload=4, wrench=(0, 0, -3, 0, 0, 0), name="pinch")
FEET = Grasp([[3, 2, 0], [3, -2, 0], [-3, 0, 0]], [[0, 0, 1]] * 3, "1/2", wrench=("2/5", 0, -1, 0, 0, 0))
SLANTED = Grasp([(0, 0, 0)] * 3, [(2, 1, -2), (1, 1, 0), (0, 0, -3)], 1, preload=1, wrench=(0, 0, -1, 0, 0, 0))
GRIPPED = Grasp([[-5, 0], [3, -4], [3, 4]], [[1, 0], ["-3/5", "4/5"], ["-3/5", "-4/5"]], "2/5", stiffness=50, wrench=(3, 0, 60))
JAW = Grasp.from_file(EXAMPLES / "jaw.json")
BREAKS = Grasp.from_file(EXAMPLES / "more-friction-breaks.json")
BLOCKS = Assembly({
    "name": "blocks", "bodies": [{"name": "low"}, {"name": "up"}], "defaults": {"friction": "1/2"},
    "contacts": [*({"of": "low", "position": [x, 0], "normal": [0, 1]} for x in (-1, 1)),
                 *({"of": "up", "by": "low", "position": [x, 1], "normal": [0, 1]} for x in ("-4/5", "4/5"))],
    "loads": [{"body": "low", "weight": 10, "at": [0, "1/2"]}, {"body": "up", "weight": 10, "at": [0, "3/2"]}]})
LEVER = Assembly({"bodies": [{"name": "arm", "hinge": [0, 0]}], "contacts": [],
                  "joints": [{"turns": {"arm": 1}, "stiffness": 2, "torque": 5}],
                  "loads": [{"body": "arm", "force": [0, -1], "at": [1, 0]}]})
AXES = {"x": "friction=0:1", "y": "preload=1/2:2", "depth": 3}


def of_files(name, paths, *options):
    """Each case is a question."""
    for path in paths:
        grasp = Grasp.from_file(path)
        for load in [{"wrench": load} for load in grasp.cases.values()] or [{}]:
            yield from ((name, grasp, {**load, **more}) for more in options)


QUESTIONS = [
    *(("decide", FIG1, {"wrench": (0, up, 0), "preload": preload, "engine": engine})
      for up, preload in ((-1, 0), (1, 0), (1, 1), ("11/10", 1)) for engine in ("states", "auto", "cone")),
    ("decide", FIG1, {"wrench": (0, "11/10", 0), "node_limit": 1}),
    ("decide", FIG1, {"normal_law": "bilateral"}), ("decide", UNBALANCED, {}),
    ("decide", PINCH, {"preload": "7/2"}), ("decide", PINCH, {"preload": 2}), ("decide", PINCH, {"normal_law": "bilateral"}),
    ("decide", BLOCKS, {"wrench": (0, -10, 0, 4, -10, -4)}), ("decide", BLOCKS, {"wrench": (6, -10, 0, 5, -10, -5)}),
    ("decide", BLOCKS, {"preload": 3, "normal_law": "bilateral"}), ("decide", LEVER, {}),
    *(("decide", grasp, {"uncertain": uncertain}) for grasp, uncertain in (
        (FIG1, "friction=5%,wrench=1%"), (FIG1, "wrench=ball:1/20:length=2"), (BREAKS, "friction=10%"), (FEET, "friction=10%"),
        (PINCH, "friction=60%"), (BLOCKS, "friction=10%"))),
    ("decide", PINCH, {"uncertain": "friction=10%", "wrench": (0, 0, -9, 0, 0, 0)}),
    ("radius", FIG1, {"wrench": (0, "1/4", 0), "uncertain": "friction=10%,wrench=5%", "normal_law": "bilateral", "accuracy": "1/10"}),
    ("radius", FIG1, {"uncertain": "wrench=ball:1/20:length=2", "accuracy": "1/2"}),
    ("radius", BLOCKS, {"uncertain": "friction=10%", "accuracy": "1/2"}),
    ("quality", FIG1, {"length": 2, "about": (0, "1/3"), "at_most": "1/16"}),
    ("quality", FIG1, {"wrench": (0, "1/4", 0), "preload": 2, "normal_law": "bilateral", "accuracy": "1/2"}),
    ("quality", BLOCKS, {"body": "up", "accuracy": "1/2"}),
    ("preload", JAW, {}), ("preload", GRIPPED, {"balanced": True, "accuracy": "1/5"}),
    ("preload", JAW, {"wrench": (0, -2, 0), "uncertain": "wrench=ball:1/2:length=1/4", "accuracy": "1/2"}),
    ("preload", JAW, {"budget": 20, "length": 2, "about": (0, "1/3"), "accuracy": "1/5", "boxes": 50}),
    ("preload", FLOOR, {"wrench": (0, 1, 0)}), ("preload", PINCH, {"accuracy": "1/4"}),
    ("map", PINCH, {"x": "0,1,0,0,0,0=-5:5", "y": "0,0,1,0,0,0=-5:5", "depth": 2}),
    ("map", FIG1, AXES), ("map", FIG1, {**AXES, "wrench": (0, "3/4", 0), "uncertain": "wrench=ball:1/10"}),
    ("map", BLOCKS, {"x": "friction=0:1", "y": "0,0,0,1,0,-1=0:10", "depth": 2}),
    *(("states", Grasp.from_file(path), {"engine": engine}) for path in sorted(GOOD.iterdir())
      for engine in ("auto", "cgal", "sweep", "paper")),
    *(("region", FIG1, options) for options in (
        {}, {"preload": 0}, {"torque": -1}, {"normal_law": "bilateral"}, {"u": (1, 0, 1), "v": (0, 1, "1/3"), "origin": (1, 0, 0)})),
    ("region", Grasp.from_file(GOOD / "cases.json"), {"torque": -20}),
    *(("compare", FIG1, options) for options in (
        {}, {"wrench": (0, 1, 0), "preload": 0}, {"normal_law": "bilateral", "length": "1/3"},
        {"methods": ("form-closure", "strongly-stable-load"), "inertia": ("1/2", "1/4", 3)})),
    *(("compare", FEET, {"wrench": (push, 0, -1, 0, 0, 0), "inertia": (0, 0, 1, 1, 1, 1)}) for push in ("2/5", "3/5")),
    *(("margin", Grasp.from_file(path), {"direction": direction, "normal_law": law, "preload": 1})
      for path in sorted((ROOT / "paper_examples" / "grasps").iterdir()) for law in ("unilateral", "bilateral")
      for direction in ((1, 0, 0), (0, 0, "-1/3"), (2, 1, -1))),
    *(("margin", FIG1, {"wrench": (0, 1, 0), **options}) for options in (
        {"direction": (-1, 0, 1)}, {"preload_direction": "scale"}, {"preload": 0, "preload_direction": (1, 0, "1/2")},
        {"preload": 0, "preload_direction": (1, 0, 0), "direction": (0, 1, 0)})),
    *(("margin", FEET, {"wrench": (push, 0, -1, 0, 0, 0), "accuracy": "1/10", **options}) for push, options in (
        (0, {"direction": (1, 0, 0, 0, 0, 0)}), (0, {"direction": (1, 0, 0, 0, 0, 0), "normal_law": "bilateral"}),
        (1, {"preload": 1, "preload_direction": "scale"}), (1, {"preload_direction": (0, 1, 2)}))),
    ("margin", BLOCKS, {"direction": (0, 0, 0, 1, 0, -1), "accuracy": "1/10"}),
    *of_files("decide", sorted(GOOD.iterdir()), *({"normal_law": law, "engine": engine} for law in ("unilateral", "bilateral")
                                                  for engine in ("states", "branch-and-bound"))),
    *of_files("decide", [*SPACE, *sorted(EXAMPLES.glob("bodies-*.json"))], {}),
]

ASK = {"decide": stickslip.decide, "margin": stickslip.margin, "radius": stickslip.radius, "quality": stickslip.quality,
       "preload": stickslip.best_preload, "map": partial(stickslip.stability_map, proofs=True), "states": stickslip.slip_states,
       "region": partial(stickslip.region, pieces=True, certificate=True), "compare": partial(stickslip.compare, certificate=True)}
WRITES = {"decide": ["--certificate=c.json", "--examples=proofs"], "margin": ["--certificate=c.json"], "states": ["--list"],
          "region": ["--certificate=c.json", "--list"], "compare": ["--certificate=c.json"],
          "map": ["--certificates=proofs", "--svg=map.svg"]}

# What JSON has, and Python in proofs or nowhere; what both have, each in its way; and what Python alone has.
IN_JSON = {"ball", "box", "boxes", "budget", "differences", "engine", "inertia", "length", "limit", "loads", "normal_law",
           "refutation", "unbounded", "wrench"}
OTHERWISE = {"counterexample", "examples", "proof", "uncertain", "x", "y"}
IN_PYTHON = {"certificate", "coefficients", "grasp", "length", "picture", "proofs", "scales", "wrench"}
RENAMED = {"class": "load_class", "force": "forces", "moment": "moments"}
OF_BUDGET = {"proved": "radius", "not_resisted_at": "refuted"}


def words_of(options):
    for name, value in options.items():
        value = ",".join(map(str, value)) if isinstance(value, tuple) else value
        yield f"--{name.replace('_', '-')}" + ("" if value is True else f"={value}")


def command(folder, name, grasp, *words):
    (folder / "g.json").write_text(grasp.to_text())
    return subprocess.run([os.environ["STICKSLIP"], *name.split(), "g.json", *words], cwd=folder, capture_output=True, text=True,
                          check=False, timeout=300)


def by_names_of_python(said, renamed):
    rows = {"areas": lambda area: [[o["vertices"], o.get("from"), o.get("to")] for o in area["outlines"]],
            "curves": lambda c: [c["vertices"], c["rays"]], "warnings": lambda w: [w["trap"], w["text"]],
            "pieces": lambda p: [p["slip"], p["closed"], [p["vertices"], p["rays"]]],
            "methods": lambda m: [m["method"], m["source"], m["about"] == "load", m["verdict"], m["agrees"], m["why"], m["evidence"]],
            "cells": lambda c: [c["x"], c["y"], c["verdict"]]}
    said = {renamed.get(key, key): [rows[key](value) for value in row] if key in rows and isinstance(row, list) else row
            for key, row in said.items()}
    if isinstance(said.get("contacts"), list):
        contacts = said.pop("contacts")
        for key in ("force", "moment", "closed", "slip"):
            if contacts and key in contacts[0]:
                said[renamed.get(key, key)] = [c[key] for c in contacts]
    said.update(said.pop("plane", {}))
    return said


def agree(said, found):
    if isinstance(found, Fraction):
        return Fraction(said) == found
    if isinstance(found, tuple):
        return len(said) == len(found) and all(map(agree, said, found))
    if isinstance(found, str) and isinstance(said, list):
        return found in ("".join(said), " ".join(said))
    return (said or None) == (found or None)


def proof_in(certificate):
    """Without who wrote it, and the question, of which a checker is asked."""
    return (certificate or "").partition('"verdict"')[2]


def proofs_of(name, answer):
    """By the names of the files that the command writes."""
    found = (answer.proofs if name == "preload" else
             {f"cell{k}": cell.proof for k, cell in enumerate(answer.cells)} if name == "map" else
             {"proved": answer.proof, "refuted": answer.counterexample} if name in ("radius", "quality") else
             dict(zip(("stable", "unstable"), getattr(answer, "examples", None) or ())))
    return {key: proof for key, proof in found.items() if proof is not None}


@pytest.mark.parametrize("name, grasp, options", QUESTIONS, ids=lambda x: x if isinstance(x, str) else "")
def test_members_and_proofs(tmp_path, name, grasp, options):
    grasp = Grasp.from_text(grasp.to_text())  # every stiffness is given, as in the file that the command reads
    words = [*words_of(options), *WRITES.get(name, ["--certificates=proofs"])]
    words += ["--hold"] if name == "preload" and "budget" not in options else []
    said = json.loads(command(tmp_path, name, grasp, *words, "--json").stdout)
    said = by_names_of_python(said, {**RENAMED, **(OF_BUDGET if "budget" in options else {})})
    warned = {"warnings": True} if name in ("decide", "margin") and "box" not in said else {}
    answer = ASK[name](grasp, **options, **warned)
    members = {field.name: getattr(answer, field.name) for field in dataclasses.fields(answer)}
    if answer_within := getattr(answer, "within", None):
        members["within"] = answer_within[:3]
        said["within"] = [said["within"].get(key) for key in ("verdict", "max_motion", "wrench")]
    if "preload" in members:
        said["preload"] = options.get("preload")
    if name == "map":
        members["cells"] = tuple(cell[:3] for cell in answer.cells)
        assert answer.picture == (tmp_path / "map.svg").read_text()
    for key in said.keys() - OTHERWISE - (IN_JSON - members.keys()) - ({"near", "wrench"} if "box" in said else set()):
        assert agree(said[key], members.get(key, getattr(answer, key, getattr(grasp, key, None)))), key
    for key in members.keys() - said.keys() - IN_PYTHON - OTHERWISE:
        assert not members[key], key
    proofs = proofs_of(name, answer)
    assert all(proof.check() for proof in proofs.values())
    texts = {f"{key}.json": proof.grasp for key, proof in proofs.items()}
    texts.update((f"{key}.certificate.json", proof_in(proof.certificate)) for key, proof in proofs.items())
    assert texts == {path.name: proof_in(path.read_text()) if "certificate" in path.name else path.read_text()
                     for path in tmp_path.glob("proofs/*")}
    proof = tmp_path / "c.json"
    if proof.exists():
        assert proof_in(proof.read_text()) == proof_in(answer.certificate)
        assert name == "compare" or answer.check()  # who is asked what was asked
    for (a, b), (x, y), force in zip(members.get("coefficients") or (), grasp.normals, members.get("forces") or ()):
        assert force == (a * x - b * y, a * y + b * x)


TEXTS = {"plot grasp": stickslip.plot_grasp, "plot states": stickslip.plot_states, "plot region": stickslip.plot_region,
         "export": stickslip.export}


@pytest.mark.parametrize("name, grasp, options", [
    ("plot grasp", FIG1, {"wrench": (0, 3, 0), "preload": 2, "normal_law": "bilateral"}), ("plot grasp", FIG1, {}),
    ("plot grasp", PINCH, {}), ("plot grasp", PINCH, {"wrench": (0, 0, -6, 0, 0, 0)}),
    ("plot grasp", Grasp.from_file(EXAMPLES / "space-corner.json"), {}), ("plot grasp", BLOCKS, {}),
    ("plot grasp", Grasp.from_file(EXAMPLES / "bodies-hand.json"), {}), ("plot states", FIG1, {}), ("plot states", FIG1, {"modes": "cs"}),
    ("plot states", BLOCKS, {"modes": "cs"}), ("plot region", FIG1, {}),
    ("plot region", FIG1, {"torque": "1/2"}), ("plot region", FIG1, {"u": (0, 0, 1), "origin": (1, 0, 0)}),
    ("export", FIG1, {"preload": "1/2", "normal_law": "bilateral"}), ("export", PINCH, {})])
def test_pictures_and_exports(tmp_path, name, grasp, options):
    done = command(tmp_path, name, grasp, *words_of(options), *(["--smt2"] if name == "export" else []))
    text = TEXTS[name](grasp, **options)
    assert text == done.stdout != ""
    if name == "plot grasp":
        assert stickslip.decide(grasp, **options).plot() == text


@pytest.mark.parametrize("grasp", [FIG1, TURNED, SLANTED])
@pytest.mark.parametrize("within", ["1/1000", "1e-12", 0.25])
def test_snapping(tmp_path, grasp, within):
    report = json.loads(command(tmp_path, "snap", grasp, "-o", "s.json", f"--within={within}", "--json").stdout)
    snapped, moved = grasp.snap(within)
    assert (tmp_path / "s.json").read_text() == snapped.to_text()
    assert report["moved"] == [{"contact": i, "normal": list(map(str, normal)), "moved_at_most": far} for i, normal, far in moved]


@pytest.mark.parametrize("name, grasp, options", [
    ("decide", PINCH, {"engine": "branch-and-bound"}), ("decide", PINCH, {"uncertain": "normal=1%"}),
    ("decide", FIG1, {"uncertain": "friction=101%"}), ("margin", FIG1, {"preload": 0, "preload_direction": "scale"}),
    ("compare", BLOCKS, {"methods": ("form-closure",)}), ("region", BLOCKS, {}),
    ("map", FIG1, {"x": "friction=1:0", "y": "load=0:1"}),
    ("map", FIG1, {"x": "load=0:1", "y": "friction=0:1", "uncertain": "wrench=ball:1"})])
def test_refusals(tmp_path, name, grasp, options):
    with pytest.raises(InputError) as caught:
        ASK[name](grasp, **options)
    done = command(tmp_path, name, grasp, *words_of(options))
    assert (done.returncode, done.stdout) == (2, "") and caught.value.problem in done.stderr
