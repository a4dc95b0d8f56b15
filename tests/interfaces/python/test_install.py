# SPDX-License-Identifier: GPL-3.0-or-later
"""pip installs the package from the source tree, without network, and it works from there.

STICKSLIP_BUILD_DIR names the build folder whose objects are reused.
"""

import ast
import os
import shutil
import subprocess
import sys

import pytest
import stickslip
from conftest import ROOT
from stickslip import _core

PROGRAM = """
import importlib.metadata, os, stickslip
assert stickslip.__version__ == importlib.metadata.version("stickslip")
folder = os.path.dirname(stickslip.__file__)
assert {"py.typed", "_core.pyi"} <= set(os.listdir(folder))
grasp = stickslip.Grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]], "1/2", preload=1)
decision = stickslip.decide(grasp, (0, "11/10", 0))
print(folder, decision.verdict, bool(stickslip.check(grasp, decision.certificate,
                                                     wrench=(0, "11/10", 0))))
"""


@pytest.mark.skipif("STICKSLIP_BUILD_DIR" not in os.environ, reason="no build folder is named")
def test_pip_install(tmp_path):
    # A copy, so that pip leaves its build files there; the library is that of the build folder.
    source = tmp_path / "python"
    shutil.copytree(ROOT / "interfaces" / "python", source, ignore=shutil.ignore_patterns("build", "*.egg-info"))
    target = tmp_path / "site"
    result = subprocess.run(
        [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps",
         "--disable-pip-version-check", "--target", target, source],
        capture_output=True, text=True, check=False, timeout=1200)
    assert result.returncode == 0, result.stdout + result.stderr
    environment = {**os.environ, "PYTHONPATH": str(target)}
    result = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True,
                            check=False, timeout=300, env=environment, cwd=tmp_path)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.split() == [str(target / "stickslip"), "unstable", "True"]
    assert stickslip.__file__ != str(target / "stickslip" / "__init__.py")


def test_the_stub_names_what_is_compiled():
    def names(body):
        return {node.target.id if isinstance(node, ast.AnnAssign) else node.name
                for node in body if isinstance(node, (ast.AnnAssign, ast.FunctionDef, ast.ClassDef))}

    def public(thing):
        return {name for name in vars(thing) if not name.startswith("_")}

    stub = ast.parse((ROOT / "interfaces" / "python" / "stickslip" / "_core.pyi").read_text())
    assert names(stub.body) == public(_core)
    for node in stub.body:
        if isinstance(node, ast.ClassDef):
            assert names(node.body) - {"__init__"} == public(getattr(_core, node.name))
