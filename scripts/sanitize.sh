#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The tests under AddressSanitizer and UndefinedBehaviorSanitizer, with assertions and validation
# on.
#   scripts/sanitize.sh         without the tests that take longest; CI runs this
#   scripts/sanitize.sh --all   all of them; then the share of the lines of core, lp, the engine and
#                               the checker that they ran
# Line by line: build-asan/coverage/index.html.
set -euo pipefail
STICKSLIP_BUILD_DIR=${STICKSLIP_BUILD_DIR:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build-asan}
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
# These run nothing that was compiled with sanitizers, or look at pages, which page_test writes too.
left_out=(--exclude-regex '^(check_js|check_py_spool|doxygen|layout|page_browser|page_live|page_node)$' --fixture-exclude-cleanup check_py_spool)
all=ON
case ${1-} in
  "") left_out+=(--label-exclude long) all=OFF ;;  # and their programs are not built
  --all) ;;
  *) fail "unknown argument '$1'; none, or --all" ;;
esac

install_packages "${build_packages[@]}" "${test_packages[@]}" python3-numpy
[ "$all" = OFF ] || install_packages gcovr
step "Configuring with sanitizers" configure cmake --preset asan -S "$root" -B "$build" $together \
  -DSTICKSLIP_BUILD_BENCH=OFF -DSTICKSLIP_COVERAGE=$all -DSTICKSLIP_LONG_TESTS=$all \
  -DPython3_EXECUTABLE=/usr/bin/python3
step "Building with sanitizers (several minutes the first time)" build \
  cmake --build "$build" -j "$(jobs_for_build)"
find "$build" -name '*.gcda' -delete
ctest --test-dir "$build" --output-on-failure -j "$(jobs_for_build)" "${left_out[@]}"
[ "$all" = ON ] || exit 0

lines=$build/coverage/lines.json
mkdir -p "$build/coverage"
step "Reading the lines that were run" coverage \
  gcovr --root "$root" "$build" --json "$lines" -j "$(jobs_for_build)"
step "Writing $build/coverage/index.html" coverage_html \
  gcovr --root "$root" --add-tracefile "$lines" --html-details "$build/coverage/index.html"
# Not --output /dev/null: gcovr 5.2 removes the file that it is to write.
printf '\nLines run by these tests:\n'
for module in core lp engine/{equilibrium,motion,search,planar,degree,box} measures/{margin,extent} certificate/cpp; do
  printf '  %-20s %s\n' "$module" "$(gcovr --root "$root" --add-tracefile "$lines" \
    --filter "$root/$module/" --print-summary --output "$build/coverage/summary.txt" | sed -n 's/^lines: //p')"
done
