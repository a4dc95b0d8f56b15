# SPDX-License-Identifier: MIT
"""The corpus of rules: proofs that all checkers accept, and how each of them is broken.

A file KIND.json holds one kind of proof:

  {"about": ..., "let": {NAME: VALUE, ...}, "proofs": [PROOF, ...]}

PROOF is {"name", "options", "grasp", "certificate", "breaks"} with the options of the checkers' command lines, or
{"name", "of", "change", "breaks"}: the proof named `of`, changed. (The files' `format` is left out.) All of them are accepted;
where there is `says`, with these members of the report, and where there is `prints`, with these lines. BREAK, one of `breaks`, is

  [RULE, what is wrong, CHANGE]   or   [RULE, what is wrong, CHANGE, WHERE]

and is rejected by RULE of certificate/FORMAT.md, or "malformed", although the proof that it breaks is accepted: so it is the
change that makes the difference. WHERE is "NODE: PATH" (or "NODE:", or "PATH"), as checkers report them; "STEP *3" in it
stands for three such steps. CHANGE is {PLACE: VALUE, ...}, carried out in this order: a PLACE is a path of members and indices,
in the certificate unless it begins with one of grasp, options and certificate, and

  PLACE    is set to VALUE,
  +PLACE   gets VALUE inserted before it,
  -PLACE   is removed, VALUE times,
  *PLACE   is there VALUE times.

(The members of `question` are in the order of the document, wherever they were inserted.) "$NAME" stands for what `let` says,
and "*$NAME" for its elements, one by one.
"""

import collections
import copy
import json
import os
import re

FOLDER = os.path.dirname(os.path.abspath(__file__))
KINDS = ("plane", "plane_box", "plane_margin", "plane_claims", "plane_region", "plane_class", "space", "space_box", "space_margin", "space_class",
         "bodies", "bodies_margin", "bodies_space", "bodies_soft",  # of several bodies: boxes too; bodies_soft: margins too
         "plane_states", "space_states", "bodies_states",
         "plane_robustness", "space_robustness",
         "bodies_large",  # verdicts of more than 30 coordinates, of the plane, of space and soft
         "plane_statics", "space_statics", "bodies_statics")  # margins and regions too; bodies_statics: of the plane, of space and soft
QUESTION = ("contacts", "wrench", "preload", "normal_law", "direction", "preload_direction", "plane", "inertia", "statics",
            "states", "robustness", "length", "max_force", "uncertain", "max_motion")

# `rule` is None of a proof; `node` and `path` as checkers report them; `says` and `prints` are of proofs.
Entry = collections.namedtuple("Entry", "kind name rule node path says prints options grasp certificate")


def meant(value, let):
    """With names of `let` replaced."""
    if isinstance(value, str) and value.startswith("$"):
        return meant(let[value[1:]], let)
    if isinstance(value, dict):
        return {key: meant(one, let) for key, one in value.items()}
    if isinstance(value, list):
        return [one for item in value for one in (
            meant(let[item[2:]], let) if isinstance(item, str) and item.startswith("*$") else [meant(item, let)])]
    return value


def changed(files, change):
    files = copy.deepcopy(files)
    for place, value in change.items():
        verb, place = re.fullmatch(r"([-+*]?)(.*)", place).groups()
        *keys, last = place.split("/")
        inside = files if place.split("/")[0] in files else files["certificate"]
        for key in keys:
            inside = inside[int(key) if isinstance(inside, list) else key]
        last = int(last) if isinstance(inside, list) else last
        if verb == "+":
            if last > len(inside):
                raise IndexError(place)
            inside.insert(last, copy.deepcopy(value))
        elif verb == "*":
            inside[last:last + 1] = [copy.deepcopy(inside[last]) for _ in range(value)]
        elif verb == "-":
            for _ in range(value):
                del inside[last]
        else:
            inside[last] = copy.deepcopy(value)
    question = files["certificate"]["question"]
    files["certificate"]["question"] = {key: question[key] for key in QUESTION if key in question}
    return files


def where(text):
    """(node, path)"""
    if text is None:
        return None, None
    node, path = re.fullmatch(r"(?:([0-9]+):)? ?(.*)", text).groups()
    steps = [re.fullmatch(r"(.*?)(?: \*([0-9]+))?", step).groups() for step in path.split(", ")]
    return node and int(node), ", ".join(step for step, times in steps for _ in range(int(times or 1))) or None


def entry(kind, name, files, rule=None, place=None, says=None, prints=()):
    grasp = {"format": "stickslip-grasp/" + ("3" if kind.startswith("bodies") else "2"), **files["grasp"]}
    certificate = {"format": "stickslip-certificate/2", **files["certificate"]}
    return Entry(kind, name, rule, *where(place), says or {}, prints, files["options"], grasp, certificate)


def entries(kind):
    """All proofs and breaks of a file; each break after its proof."""
    with open(os.path.join(FOLDER, kind + ".json"), encoding="utf-8") as file:
        content = json.load(file)
    proofs = {}
    for proof in content["proofs"]:
        proof = meant(proof, content.get("let", {}))
        name = proof["name"]
        if name in proofs:
            raise KeyError(f"{kind}: {name} is there twice")
        files, says = ({"options": [], **proof}, {}) if "of" not in proof else proofs[proof["of"]]
        files = changed({key: files[key] for key in ("options", "grasp", "certificate")}, proof.get("change", {}))
        proofs[name] = files, proof.get("says", says)
        yield entry(kind, name, files, says=proofs[name][1], prints=proof.get("prints", ()))
        for rule, what, change, *place in proof.get("breaks", []):
            yield entry(kind, f"{name}, but {what}", changed(files, change), rule, *place)


def deep_parts():
    """What is too long to be stated: as many parts as may be, each of which cuts the low one of that above it, and one more."""
    (plate,) = (one for one in entries("plane_box") if one.name == "a plate, in parts")
    most = 2 * len(plate.grasp["contacts"]) + 256
    for depth in (most, most + 1):
        cuts = [["part", "preload", 1, f"{10150 - k}/10000"] for k in range(depth)]
        certificate = {**plate.certificate, "parts": cuts + [plate.certificate["parts"][-1]] * (depth + 1)}
        bad = depth > most
        yield plate._replace(name="a plate, in parts " + ("deeper than may be" if bad else "as deep as may be"), certificate=certificate,
                             rule="node-depth" if bad else None, path=f"part {depth}" + ", preload 1 low" * depth if bad else None)


def all_entries():
    return [one for kind in KINDS for one in entries(kind)] + list(deep_parts())
