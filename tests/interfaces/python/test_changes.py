# SPDX-License-Identifier: GPL-3.0-or-later
"""Verdicts of the module and of a batch on a cluster do not change with the frame, the units and the order of what is listed: the
changes that tests/interfaces/cli/test_metamorphic.py asks the command about, on other grasps."""

import importlib.util
import json
import random
import subprocess
import sys
from fractions import Fraction as F

import pytest
import stickslip
from conftest import ROOT

# A test of its own (CMakeLists.txt): modules of tests/interfaces/cli have names that modules here have.
sys.path[:0] = [str(ROOT / "tests" / "interfaces" / "cli"), str(ROOT / "tests" / "support")]

import test_bodies  # noqa: E402
import test_metamorphic as changes  # noqa: E402
import test_space  # noqa: E402


def grasps():
    rng = random.Random(101)
    yield from (changes.random_in_the_plane(rng) for _ in range(10))
    yield from (test_space.written(*test_space.random_grasp(rng, 3 + k % 2, F(1, 2))) for k in range(4))
    yield from (test_bodies.random_assembly(rng, dimension) for dimension in (2, 2, 2, 3) for _ in range(2))


def verdict_of(content):
    several = content["format"].endswith("/3")
    if several:
        members = {key: value for key, value in content.items() if key != "format"}
        return str(stickslip.decide(stickslip.Assembly(members)).verdict)
    contacts = content["contacts"]
    grasp = stickslip.Grasp([c["position"] for c in contacts], [c["normal"] for c in contacts], [c["friction"] for c in contacts],
                            stiffness=[c["stiffness"] for c in contacts], preload=[c["preload"] for c in contacts], wrench=content["wrench"])
    return str(stickslip.decide(grasp).verdict)


@pytest.fixture(scope="module")
def families():
    """Of each grasp three changes, one of them in all things at once; the first is itself."""
    rng, result = random.Random(102), []
    for content in grasps():
        changed = list(changes.exact_changes(content, rng))
        result.append([content, *(change(content, rng) for change in [*rng.sample(changed[:-1], 2), changed[-1]])])
    return result


def assert_unchanged(answers, families):
    """An exact change may lose a verdict, which is counted, but not turn it round."""
    lost = 0
    for verdicts, family in zip(answers, families):
        known = set(verdicts) - {"undecided"}
        assert len(known) <= 1, (verdicts, json.dumps(family))
        lost += len(set(verdicts)) > 1
    assert lost <= 1
    assert {v for verdicts in answers for v in verdicts} >= {"stable", "unstable"}


def test_the_module(families):
    assert_unchanged([[verdict_of(content) for content in family] for family in families], families)


@pytest.mark.skipif(importlib.util.find_spec("distributed") is None, reason="Dask is not installed (Debian: python3-distributed)")
def test_a_batch_on_a_cluster(families, tmp_path):
    path = tmp_path / "grasps.jsonl"
    path.write_text("".join(json.dumps(content) + "\n" for family in families for content in family))
    done = subprocess.run([sys.executable, "-m", "stickslip.batch", path, "--workers", "2"], capture_output=True, text=True,
                          check=False, timeout=600)
    assert done.returncode in (0, 3) and done.stderr == "", done.stderr
    verdicts = [json.loads(line)["verdict"] for line in done.stdout.splitlines()]
    assert len(verdicts) == 4 * len(families)
    answers = [verdicts[4 * k:4 * k + 4] for k in range(len(families))]
    assert_unchanged(answers, families)
    assert answers == [[verdict_of(content) for content in family] for family in families]
