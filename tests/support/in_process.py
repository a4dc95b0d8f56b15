# SPDX-License-Identifier: GPL-3.0-or-later
"""check.py in this process, which need not read and compile it each time."""

import contextlib
import io
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "certificate", "python"))

import check  # noqa: E402


def in_process(arguments):
    """Exit code, standard output and standard error of check.py."""
    out, err = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2))
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = check.main(arguments)
    for stream in (out, err):
        stream.flush()
    return code, out.buffer.getvalue().decode(), err.buffer.getvalue().decode()
