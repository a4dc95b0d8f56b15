#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs most benchmarks, one after the other, for the tables of bench/README.md:
# build/bench_report/<program>.txt. Let nothing else run beside it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/common.sh"
install_packages "${build_packages[@]}" "${test_packages[@]}" "${python_packages[@]}"
configure_release -DSTICKSLIP_BUILD_TESTS=ON -DSTICKSLIP_BUILD_BENCH=ON -DSTICKSLIP_BUILD_PYTHON=ON -DSTICKSLIP_BUILD_PROVED=ON \
  -DPython3_EXECUTABLE=/usr/bin/python3
build_targets "Building (several minutes the first time)" build

report=$build/bench_report
mkdir -p "$report"
measure() {
  local name=$1
  shift
  step "$name" "bench_$name" bash -c '"${@:2}" >"$1.part" && mv "$1.part" "$1"' \
    measure "$report/$name.txt" "$@"
}
export PATH=$build/bin:$PATH PYTHONPATH=$build/python
measure lp lp_bench 400
measure sweep sweep_bench
measure states states_bench 3
measure states_programs /usr/bin/python3 "$root/bench/states/programs.py"
measure table2 table2
measure margin margin_bench 1000
measure region region_bench --pieces 32
measure box box_bench --grasps 60
measure box_tolerances /usr/bin/python3 "$root/bench/box/tolerances_bench.py" --programs "$build/bin"
measure space space_bench --contacts 8
measure space_grasps /usr/bin/python3 "$root/bench/space/grasps.py" "$build/space_grasps"
measure space_targets /usr/bin/python3 "$root/bench/space/targets.py" --programs "$build/bin" "$build"/space_grasps/*.json
measure space_peer /usr/bin/python3 "$root/bench/space/polygonal_peer.py" --program "$build/bin/stickslip" "$build"/space_grasps/*.json
measure bodies /usr/bin/python3 "$root/bench/bodies/bodies_bench.py"
measure everyday /usr/bin/python3 "$root/bench/everyday/everyday_bench.py"
small_bodies=(stack2 stack3 stack4 row2 row4 arch3 grip2 grip4 box2 box3)
measure bodies_saved /usr/bin/python3 "$root/bench/bodies/bodies_bench.py" --save "$build/bodies" "${small_bodies[@]}"
measure bodies_peer /usr/bin/python3 "$root/bench/space/polygonal_peer.py" --program "$build/bin/stickslip" --bound 400 "$build"/bodies/*_0.01?.json
measure bodies_starts /usr/bin/python3 "$root/bench/bodies/random_starts.py" "${small_bodies[@]}" plane space
measure batch batch_bench "$build/bin/stickslip"
measure one_call /usr/bin/python3 "$root/bench/batch/one_call_bench.py" "$build/bin"
measure cluster /usr/bin/python3 "$root/bench/batch/cluster_bench.py" "$build/bin"
measure float float_study --instances 960
mkdir -p "$build/checked_grasps"
measure checked_grasps verdict_bench --part targets --max-m 1000 --save "$build/checked_grasps"
measure default_options /usr/bin/python3 "$root/bench/verdict/default_options.py" "$build/bin/stickslip"
measure checkers /usr/bin/python3 "$root/bench/verdict/checkers.py" --programs "$build/bin" "$build/checked_grasps"
for part in targets side-by-side engines growth; do
  measure "verdict_$part" verdict_bench --part "$part"
done
printf 'The tables are in %s.\n' "$report"
