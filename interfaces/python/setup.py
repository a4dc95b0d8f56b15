# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets pip build the compiled part with CMake. See docs/python.md for the command.

STICKSLIP_BUILD_DIR names a build folder to use, or to reuse, instead of a new one.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        build = Path(os.environ.get("STICKSLIP_BUILD_DIR") or self.build_temp).resolve()
        if not (build / "CMakeCache.txt").exists():
            generator = ["-G", "Ninja"] if shutil.which("ninja") else []
            subprocess.run(
                ["cmake", "-S", SOURCE, "-B", build, *generator, "-DCMAKE_BUILD_TYPE=Release",
                 "-DSTICKSLIP_BUILD_PYTHON=ON", "-DSTICKSLIP_BUILD_TESTS=OFF",
                 "-DSTICKSLIP_BUILD_BENCH=OFF", f"-DPython3_EXECUTABLE={sys.executable}"],
                check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(
            ["cmake", "--build", build, "--target", "stickslip_python", "-j", jobs], check=True)
        name = Path(self.get_ext_fullpath(ext.name))
        name.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(build / "python" / "stickslip" / name.name), str(name))


setup(ext_modules=[Extension("stickslip._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
