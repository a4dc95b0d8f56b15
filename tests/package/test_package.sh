#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# test_package.sh BUILD SOURCE: installs the build into a temporary prefix, and builds and runs a
# program against that alone, by find_package and by pkg-config.
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null
grasp=$source/paper_examples/grasps/fig1.json

cmake -S "$source/tests/package/consumer" -B "$work/build" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_PREFIX_PATH="$prefix" -DLIST_STATES="$source/examples/list_states.cpp" >/dev/null
cmake --build "$work/build" >/dev/null
[[ $("$work/build/consumer" "$grasp" "$work/proof.json") == "stable "* ]]
[[ $("$prefix/bin/stickslip-check" "$grasp" "$work/proof.json") == accepted* ]]
[[ $(python3 "$prefix/share/stickslip/check.py" "$grasp" "$work/proof.json") == accepted* ]]
[[ $("$work/build/list_states" 1 0 0 0 1 0 0 0 1 | tail -n 1) == *"27 states" ]]
[[ $("$prefix/bin/stickslip" --version) == "stickslip "* ]]

# The manual, and what completes command lines, where man and the shells look for them.
pages=(-check)
if grep -q '^STICKSLIP_HELP2MAN:FILEPATH=/' "$build/CMakeCache.txt"; then
  pages+=("" $("$prefix/bin/stickslip" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/-\1/p')
    -plot-grasp -plot-states -plot-region)
fi
for command in "${pages[@]}"; do
  [[ $(sed -n '/^.SH NAME/{n;s/\\//g;p}' "$prefix/share/man/man1/stickslip$command.1") == "stickslip$command - "* ]]
done
for program in stickslip stickslip-check; do
  grep -q "^complete -F .* $program\$" "$prefix/share/bash-completion/completions/$program"
  [[ $(head -n 1 "$prefix/share/zsh/site-functions/_$program") == "#compdef $program" ]]
  grep -q "^complete -c $program " "$prefix/share/fish/vendor_completions.d/$program.fish"
done
cmp "$source/docs/grasp_file.md" "$prefix/share/doc/stickslip/grasp_file.md"

# The prefix moved, so pkg-config is told where it is now.
export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name stickslip.pc)")
read -ra flags < <(pkg-config --define-variable=prefix="$prefix" --cflags --libs stickslip)
g++ -std=c++17 "$source/tests/package/consumer/consumer.cpp" -o "$work/by_pkg_config" "${flags[@]}"
[[ $("$work/by_pkg_config" "$grasp" "$work/proof.json") == "stable "* ]]

# A version that is not this one's is not taken.
sed 's/stickslip 0.1/stickslip 99.0/' "$source/tests/package/consumer/CMakeLists.txt" >"$work/CMakeLists.txt"
cp "$source/tests/package/consumer/consumer.cpp" "$work"
other=$(cmake -S "$work" -B "$work/other" -DCMAKE_PREFIX_PATH="$prefix" \
  -DLIST_STATES="$source/examples/list_states.cpp" 2>&1) && { echo "version 99.0 is found" >&2; exit 1; }
[[ $other == *'"99.0"'* ]]
echo "installed, found and used"
