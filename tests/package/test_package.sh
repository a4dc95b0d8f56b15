#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# test_package.sh BUILD SOURCE: makes the packages of the build as it is, unpacks the Debian package
# into an empty folder, and uses its programs, and its library by find_package and by pkg-config, from
# there alone; then the wheel, if the Python module is built, from a fresh environment.
set -euo pipefail
build=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/root/usr
export STICKSLIP_BUILD_DIR=$build
"$source/scripts/package.sh" --built "$work/made"
made=("$work"/made/stickslip_*.deb)
[[ ${#made[@]} == 1 ]]
dpkg-deb -x "${made[0]}" "$work/root"
[[ $(ls "$work/root") == usr ]]
grasp=$source/paper_examples/grasps/fig1.json

# It says whose libraries it needs, and speaks of no folder of the build.
needed=$(dpkg-deb -f "${made[0]}" Depends)
for library in libc6 libgmp10 libmpfr6 libtbb12 libcpp-httplib; do
  [[ $needed == *"$library"* ]]
done
[[ -z $(grep -rlIF -e "$build" -e "$source" "$work/root") ]]
[[ $("$prefix/bin/stickslip" example jaw | "$prefix/bin/stickslip" decide -) == *": stable"* ]]

cmake -S "$source/tests/package/consumer" -B "$work/build" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_PREFIX_PATH="$prefix" -DEXAMPLES="$source/examples" >/dev/null
cmake --build "$work/build" >/dev/null
[[ $("$work/build/decide" "$grasp" "$work/proof.json") == $'stable\naccepted' ]]
[[ $("$prefix/bin/stickslip-check" "$grasp" "$work/proof.json") == accepted* ]]
[[ $(python3 "$prefix/share/stickslip/check.py" "$grasp" "$work/proof.json") == accepted* ]]
if grep -q '^STICKSLIP_BUILD_PROVED:BOOL=ON' "$build/CMakeCache.txt"; then
  [[ $("$prefix/bin/stickslip-proved" "$grasp" "$work/proof.json") == accepted* ]]
fi
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
  for folder in site-functions vendor-completions; do
    [[ $(head -n 1 "$prefix/share/zsh/$folder/_$program") == "#compdef $program" ]]
  done
  grep -q "^complete -c $program " "$prefix/share/fish/vendor_completions.d/$program.fish"
done
cmp "$source/docs/grasp_file.md" "$prefix/share/doc/stickslip/grasp_file.md"

export PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name stickslip.pc)")
read -ra flags < <(pkg-config --cflags --libs stickslip)
g++ -std=c++17 "$source/examples/decide.cpp" -o "$work/by_pkg_config" "${flags[@]}"
[[ $("$work/by_pkg_config" "$grasp" "$work/proof.json") == $'stable\naccepted' ]]

# A version that is not this one's is not taken.
sed 's/stickslip 0.1/stickslip 99.0/' "$source/tests/package/consumer/CMakeLists.txt" >"$work/CMakeLists.txt"
other=$(cmake -S "$work" -B "$work/other" -DCMAKE_PREFIX_PATH="$prefix" \
  -DEXAMPLES="$source/examples" 2>&1) && { echo "version 99.0 is found" >&2; exit 1; }
[[ $other == *'"99.0"'* ]]

# The wheel, where no compiler can be called.
if grep -q '^STICKSLIP_BUILD_PYTHON:BOOL=ON' "$build/CMakeCache.txt"; then
  unset PYTHONPATH
  cd "$work"
  /usr/bin/python3 -m venv --system-site-packages venv
  CC=false CXX=false venv/bin/pip install -q --no-index --no-deps --disable-pip-version-check made/stickslip-*.whl
  [[ $(venv/bin/python -c 'import stickslip, sys
grasp = stickslip.Grasp([[-1, 0], [1, 0]], [[1, 0], [-1, 0]], "1/2", preload=1)
answer = stickslip.decide(grasp, (0, 1, 0))
print(stickslip.__file__.startswith(sys.prefix), answer.verdict, bool(answer.check()))') == "True stable True" ]]
  [[ $(venv/bin/pip show stickslip) == *"Version: $("$prefix/bin/stickslip" --version | sed 's/.* //')"* ]]
fi
echo "packaged, unpacked, found and used"
