# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by the scripts: packages, quiet steps, messages.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${STICKSLIP_BUILD_DIR:-$root/build}
# What ccache keeps of one clone serves another.
export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$root} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}

# Debian packages: what the programs need, and what only their tests need.
build_packages=(g++ cmake ninja-build libcgal-dev libgmp-dev libmpfr-dev libboost-dev
  libboost-graph-dev libeigen3-dev nlohmann-json3-dev libcli11-dev libcpp-httplib-dev libtbb-dev)
test_packages=(libgtest-dev libgmock-dev libglpk-dev pkg-config z3 cvc5 python3 ccache doxygen
  help2man mandoc man-db zsh fish parallel nodejs libbox2d-dev libode-dev ocaml ocaml-findlib libzarith-ocaml-dev coq dpkg-dev)
# The Python module (interfaces/python/), its installation by pip, and its tests.
python_packages=(pybind11-dev python3-dev python3-pybind11 python3-numpy python3-scipy python3-pytest python3-pip
  python3-setuptools python3-wheel python3-venv mypy python3-nbconvert python3-ipykernel python3-shapely
  python3-distributed python3-pandas)
# What scripts/package.sh needs besides.
package_packages=(dpkg-dev help2man ocaml ocaml-findlib libzarith-ocaml-dev pybind11-dev python3-dev
  python3-numpy python3-pip python3-setuptools python3-wheel)
# Physics engines in C++, which bench/engines judges; Box2D and ODE among them are tested, with one from npm.
engine_packages=(libbox2d-dev libchipmunk-dev libode-dev libbullet-dev)
# A browser, in which pages are tested.
browser_packages=(chromium chromium-driver python3-selenium)

fail() {
  printf '\n%s: %s\n' "$(basename "$0")" "$1" >&2
  exit 1
}

# step MESSAGE LOGNAME COMMAND...: runs quietly; on failure shows the end of the log.
step() {
  local message=$1 log=$build/log/$2.log
  shift 2
  mkdir -p "$build/log"
  printf '%s ... ' "$message"
  local start=$SECONDS
  if "$@" >"$log" 2>&1 </dev/null; then
    printf 'done (%d s)\n' $((SECONDS - start))
  else
    printf 'failed\n\n' >&2
    grep -nE 'error|Error|FAILED' "$log" | head -n 20 >&2 || true
    printf '%s\n' '-- the end of the log:' >&2
    tail -n 15 "$log" >&2
    fail "this step failed: $message. The whole log: $log"
  fi
}

# install_packages PACKAGE...: those that are missing, by apt-get, as root or with sudo.
install_packages() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  command -v apt-get >/dev/null || fail "missing packages: ${missing[*]} (Debian names). Install them and run again."
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "missing packages: ${missing[*]}. As root: apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  step "Updating the list of Debian packages" apt-update "${as_root[@]}" apt-get update
  step "Installing ${missing[*]}" apt-install "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# Up to twenty files of a module are compiled as one: most of the time goes to headers that they share.
# One file alone is compiled by the presets of CMakePresets.json, for those who edit it.
together="-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=20"

jobs_for_build() { nproc 2>/dev/null || echo 2; }

# configure_release OPTION...: what all scripts build in release is compiled with the same flags, so that none compiles
# again what another has compiled. That holds whether or not tests, benchmarks or the Python module are asked for.
configure_release() {
  step "Configuring" configure cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release $together \
    -DSTICKSLIP_WERROR=ON "$@"
}

# build_targets MESSAGE LOGNAME [TARGET...]: these, or all.
build_targets() {
  local message=$1 log=$2
  shift 2
  step "$message" "$log" cmake --build "$build" -j "$(jobs_for_build)" ${1:+--target "$@"}
}
