# SPDX-License-Identifier: GPL-3.0-or-later
"""The notebook in examples/ runs, and shows what it says."""

import importlib.util
import json
import subprocess
import sys

import pytest
from conftest import ROOT


def missing(*modules):
    return [name for name in modules if importlib.util.find_spec(name) is None]


@pytest.mark.skipif(bool(missing("nbconvert", "ipykernel")), reason="nbconvert is not installed")
def test_bracket(tmp_path):
    result = subprocess.run(
        [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir",
         tmp_path, ROOT / "examples" / "bracket.ipynb"],
        capture_output=True, text=True, check=False, timeout=600)
    assert result.returncode == 0, result.stderr
    cells = json.loads((tmp_path / "bracket.ipynb").read_text())["cells"]
    outputs = [output for cell in cells for output in cell.get("outputs", [])]
    shown = [output["data"] for output in outputs if output["output_type"] == "execute_result"]
    pictures = [data for data in shown if "image/svg+xml" in data]
    assert len(pictures) == 2 and all("<table>" in "".join(d["text/html"]) for d in pictures)
    texts = ["".join(data["text/plain"]) for data in shown]
    assert texts[0] == "['0.020 mm', '0.010 mm', '0.030 mm']"
    assert "verdict='stable'" in texts[1]
    assert "accepted=True" in texts[-1]
    (printed,) = [output["text"] for output in outputs if output["output_type"] == "stream"]
    assert "500 questions" in "".join(printed)
