#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUTPUT_DIR/report.md (build/paper_report unless given): every table and figure of the
# paper, regenerated and compared with exact results. Exit code 1 if a comparison fails.
# Builds the programs first, unless STICKSLIP_BIN_DIR names a folder that holds them.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/common.sh"

[ $# -le 1 ] && [[ "${1:-}" != -* ]] || fail "usage: report.sh [OUTPUT_DIR]"
if [ -z "${STICKSLIP_BIN_DIR:-}" ]; then
  install_packages "${build_packages[@]}" python3
  build_programs stickslip stickslip-check paper_tables
  STICKSLIP_BIN_DIR=$build/bin
fi
exec python3 -B "$root/paper_examples/report" \
  --programs "$STICKSLIP_BIN_DIR" --grasps "$root/paper_examples/grasps" "${1:-$build/paper_report}"
