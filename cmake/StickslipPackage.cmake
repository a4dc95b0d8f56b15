# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian package that `cpack -G DEB` makes of what `cmake --install` installs
# (scripts/package.sh). The shared libraries that it needs are found by dpkg-shlibdeps.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME stickslip)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact passive stability of frictional grasps, with proofs")
set(CPACK_PACKAGE_DESCRIPTION
  "The programs stickslip, stickslip-check and stickslip-proved, the checker check.py, manual pages
and completion; and the C++ library as static archives with headers, for CMake's find_package and
for pkg-config. To compile against it, the packages that are suggested are needed as well.")
set(CPACK_PACKAGE_CONTACT "the stickslip developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS python3)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, pkg-config, libgmp-dev, libmpfr-dev, \
libeigen3-dev, libtbb-dev")
include(CPack)
