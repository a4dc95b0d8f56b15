#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Prints the paper's tables beside what exact arithmetic says, as soon as the part of the library that they need is built in
# release; then builds stickslip and stickslip-check.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_packages "${build_packages[@]}"
configure_release -DSTICKSLIP_BUILD_TESTS=OFF -DSTICKSLIP_BUILD_BENCH=OFF
build_targets "Building the paper's tables (a minute or two the first time)" build-tables paper_tables
echo
"$build/bin/paper_tables" "$root/paper_examples/grasps"
echo
build_targets "Building stickslip (a few minutes the first time)" build stickslip stickslip-check
cat <<MESSAGE

Try it yourself:
  $build/bin/stickslip decide $root/paper_examples/grasps/fig1.json
  $build/bin/stickslip states $root/paper_examples/grasps/fig4.json --list
  $build/bin/stickslip plot grasp $root/paper_examples/grasps/fig1.json -o fig1.svg
MESSAGE
