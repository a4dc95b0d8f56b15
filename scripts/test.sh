#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds everything with warnings as errors and runs every test. CI runs this script.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_packages "${build_packages[@]}" "${test_packages[@]}" "${python_packages[@]}" \
  "${browser_packages[@]}"
# One physics engine from npm is tested where it can be had, and always in CI.
if [ -n "${CI-}" ]; then
  command -v npm >/dev/null || install_packages npm
  step "Installing an engine from npm" engines-npm npm --prefix "$root/bench/engines" ci --omit=optional
elif ! npm --prefix "$root/bench/engines" ci --omit=optional >/dev/null 2>&1; then
  echo "No engine from npm: its tests are left out"
fi
configure_release -DSTICKSLIP_BUILD_TESTS=ON -DSTICKSLIP_BUILD_BENCH=ON -DSTICKSLIP_BUILD_PROVED=ON \
  -DSTICKSLIP_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
build_targets "Building (several minutes the first time)" build
# One more than there are cores: browsers, servers and clusters wait a part of their time.
ctest --test-dir "$build" --output-on-failure -j "$(($(jobs_for_build) + 1))" "$@"
