#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs all engines that are installed (install.sh) on all cases, and writes a page:
# build/engines/engines.html.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/common.sh"

[ -x "$build/bin/stickslip" ] || fail "stickslip is not built: scripts/demo.sh builds it"
export STICKSLIP=$build/bin/stickslip
python3 "$root/bench/engines/run.py" "$build/engines/results"
python3 "$root/bench/engines/report.py" "$build/engines/results" "$build/engines/engines.html"
echo "$build/engines/engines.html"
