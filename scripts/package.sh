#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# package.sh [--built] [FOLDER]: a Debian package of programs, library, manual and completion, and a
# wheel of the Python module, which need no compiler where they are installed. They are put into
# FOLDER, by default build/package. --built: from what is built.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

built=
if [ "${1-}" = --built ]; then
  built=1
  shift
fi
folder=${1:-$build/package}

if [ -z "$built" ]; then
  install_packages "${build_packages[@]}" "${package_packages[@]}"
  configure_release -DSTICKSLIP_BUILD_TESTS=OFF -DSTICKSLIP_BUILD_BENCH=OFF -DSTICKSLIP_BUILD_PROVED=ON \
    -DSTICKSLIP_BUILD_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
  build_targets "Building (several minutes the first time)" build
fi

mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
step "Debian package" cpack cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/deb"
mv "$work"/deb/*.deb "$folder"

if compgen -G "$build/python/stickslip/_core.*.so" >/dev/null; then
  # Of a copy, so that what pip writes beside the sources stays away from them.
  cp -r "$root/interfaces/python" "$work/python"
  python=$(sed -n 's/^_\?Python3_EXECUTABLE:[^=]*=//p' "$build/CMakeCache.txt" | head -n 1)
  export STICKSLIP_BUILD_DIR=$build
  step "Wheel of the Python module" wheel "$python" -m pip wheel --no-build-isolation --no-index --no-deps \
    --disable-pip-version-check --wheel-dir "$folder" "$work/python"
fi
ls "$folder"
