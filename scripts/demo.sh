#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds stickslip in release and prints the paper's tables beside what exact arithmetic says.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_packages "${build_packages[@]}"
build_programs stickslip stickslip-check paper_tables
echo
"$build/bin/paper_tables" "$root/paper_examples/grasps"
cat <<MESSAGE

Try it yourself:
  $build/bin/stickslip decide $root/paper_examples/grasps/fig1.json
  $build/bin/stickslip states $root/paper_examples/grasps/fig4.json --list
  $build/bin/stickslip plot grasp $root/paper_examples/grasps/fig1.json -o fig1.svg
MESSAGE
