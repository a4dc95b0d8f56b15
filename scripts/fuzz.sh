#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes all that reads outside input with libFuzzer, ASan and UBSan:
#   scripts/fuzz.sh [SECONDS]     for each target (tests/fuzz/CMakeLists.txt); 60 when absent
# No input of 10 kB may take more than 10 s or 1 GB; the sanitizers make that 50 s and 4 GB.
# Inputs that break something are left in build-fuzz/findings; put into the folder
# tests/corpus/fuzz_<target>, they are replayed by ctest from then on.
set -euo pipefail
STICKSLIP_BUILD_DIR=${STICKSLIP_BUILD_DIR:-$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/build-fuzz}
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
seconds=${1:-60}
[[ $seconds =~ ^[0-9]+$ ]] || fail "SECONDS must be a number, found '$seconds'"

install_packages "${build_packages[@]}" "${test_packages[@]}" clang libclang-rt-dev
sanitizers="-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
step "Configuring" configure cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS="$sanitizers -fsanitize=fuzzer-no-link" \
  -DSTICKSLIP_BUILD_FUZZERS=ON -DSTICKSLIP_BUILD_BENCH=OFF
step "Building" build cmake --build "$build" -j "$(jobs_for_build)" --target fuzzers
mkdir -p "$build/findings"
for replay in "$build"/tests/bin/fuzz_replay_*; do
  target=${replay##*/fuzz_replay_}
  seeds=$build/seeds/$target
  grown=$build/grown/$target  # what libFuzzer finds of interest; kept for the next run
  mkdir -p "$seeds" "$grown"
  "$replay" "$root/tests/corpus" --seeds "$seeds"
  step "Fuzzing $target for $seconds s" "fuzz_$target" "$build/bin/fuzz_$target" \
    -max_total_time="$seconds" -max_len=10000 -timeout=50 -rss_limit_mb=4096 -print_final_stats=1 \
    -artifact_prefix="$build/findings/$target-" "$grown" "$seeds"
  grep -E 'stat::(number_of_executed_units|average_exec_per_sec)' "$build/log/fuzz_$target.log"
done
