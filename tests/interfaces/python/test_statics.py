# SPDX-License-Identifier: GPL-3.0-or-later
"""Statics in Python: the answers of the command, and certificates that the checker accepts."""

import json
import os
import pathlib
import subprocess
from fractions import Fraction

import pytest
import stickslip

ROOT = pathlib.Path(__file__).resolve().parents[3]
BLOCKS = stickslip.Assembly.from_file(ROOT / "examples" / "grasps" / "bodies-stack.json")
WEIGHTS = (0, -10, 0, 0, -10, 0)
ARCH = stickslip.Assembly.from_file(ROOT / "examples" / "grasps" / "bodies-arch.json")
FEET = stickslip.Grasp([[-1, 0], [1, 0]], [[0, 1], [0, 1]], "1/3")
DOWN = (0, -6, 0)


def command(tmp_path, grasp, *words):
    (tmp_path / "g.json").write_text(grasp.to_text())
    said = subprocess.run([os.environ["STICKSLIP"], "statics", "g.json", "--json", *words], cwd=tmp_path, capture_output=True, text=True,
                          check=True)
    return json.loads(said.stdout)


@pytest.mark.parametrize("grasp, options, words", [
    (FEET, {"wrench": DOWN}, ["--wrench=0,-6,0"]), (ARCH, {}, []), (FEET, {"friction_factor": "1/7", "wrench": (1, -6, 0)}, ["--friction-factor=1/7", "--wrench=1,-6,0"]),
    (BLOCKS, {"wrench": WEIGHTS}, ["--wrench=0,-10,0,0,-10,0"]),
])
def test_one_load(tmp_path, grasp, options, words):
    said, found = command(tmp_path, grasp, *words), stickslip.statics(grasp, **options, certificate=True)
    assert found.load_class == said["class"] == repr(found)
    assert [[f.contact, str(f.normal)] for f in found.forces] == [[f["contact"], f["normal"]] for f in said.get("forces", [])]
    proof = found.certificates["statics"]
    factor = options.get("friction_factor", 1)
    assert stickslip.check(grasp, proof, statics=factor, wrench=options.get("wrench")).accepted
    assert not stickslip.check(grasp, proof, statics=Fraction(factor) + 1, wrench=options.get("wrench")).accepted


def test_the_least_friction(tmp_path):
    found = stickslip.statics(ARCH, least_friction=True, certificate=True)
    low, high = found.least_friction
    said = command(tmp_path, ARCH, "--least-friction")["least_friction"]
    assert (str(low), str(high)) == (said["low"], said["high"])
    assert high - low <= high / 10**6
    for name, factor in (("moves", low), ("stands", high)):
        assert stickslip.check(ARCH, found.certificates[name], statics=factor).accepted


def test_lines_and_planes_of_loads():
    found = stickslip.statics(FEET, (0, -6, 0), directions=[(1, 0, 0)], certificate=True)
    assert found.multiples.stand == (-2, 2) and (found.multiples.below, found.multiples.above) == (-2, 2) and found.exact
    assert stickslip.check(FEET, found.certificates["statics"], statics=1, wrench=(0, -6, 0), direction=(1, 0, 0)).accepted
    plane = [[1, 0, 0], [0, 1, 0]]
    found = stickslip.statics(FEET, directions=plane, certificate=True)
    assert found.exact and found.complete and found.move
    assert stickslip.check(FEET, found.certificates["statics"], statics=1, plane=plane).accepted
    assert stickslip.statics(FEET, (0, 0, 0), place=(0, -1)).multiples.stand == (-1, 1)
    assert stickslip.statics(BLOCKS, WEIGHTS, place=(0, -5), body="up").multiples.stand == (Fraction(-12, 5), Fraction(12, 5))


def test_compare_gives_the_class_of_several_bodies():
    found = stickslip.compare(BLOCKS, WEIGHTS, certificate=True)
    assert (found.load_class, found.methods) == ("may stand", ())
    assert stickslip.check(BLOCKS, found.certificate, statics=1, wrench=WEIGHTS).accepted


def test_what_cannot_be_asked():
    for options in ({"friction_factor": -1}, {"directions": [(1, 0)]}, {"place": (1,)}, {"body": "up", "place": (0, 1)}):
        with pytest.raises(stickslip.InputError):
            stickslip.statics(FEET, **{"wrench": DOWN, **options})
