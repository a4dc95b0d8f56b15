#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the engines that are judged, and builds their drivers: build/engines/drivers. Nothing
# else in this repository needs them.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/common.sh"

install_packages g++ cmake ninja-build pkg-config nlohmann-json3-dev python3 "${engine_packages[@]}"
command -v npm >/dev/null || install_packages nodejs npm
step "Installing engines from npm" engines-npm npm --prefix "$root/bench/engines" ci
step "Configuring drivers" engines-configure cmake -S "$root/bench/engines/drivers" \
  -B "$root/build/engines/drivers" -G Ninja -DCMAKE_BUILD_TYPE=Release
step "Building drivers" engines-build cmake --build "$root/build/engines/drivers" -j "$(jobs_for_build)"
