# SPDX-License-Identifier: GPL-3.0-or-later
# Every third-party package, by its Debian name. Each missing one ends with a
# message that says which package to install.

function(stickslip_require_header variable header package)
  find_path(${variable} ${header})
  mark_as_advanced(${variable})
  if(NOT ${variable})
    message(FATAL_ERROR "stickslip needs <${header}>. On Debian: apt-get install ${package}")
  endif()
endfunction()

function(stickslip_require_library variable library package)
  find_library(${variable} ${library})
  mark_as_advanced(${variable})
  if(NOT ${variable})
    message(FATAL_ERROR "stickslip needs lib${library}. On Debian: apt-get install ${package}")
  endif()
endfunction()

macro(stickslip_require_package name package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "stickslip needs ${name}. On Debian: apt-get install ${package}")
  endif()
endmacro()

stickslip_require_header(GMP_INCLUDE_DIR gmp.h libgmp-dev)
stickslip_require_library(GMP_LIBRARY gmp libgmp-dev)
add_library(stickslip_gmp INTERFACE)
target_include_directories(stickslip_gmp SYSTEM INTERFACE ${GMP_INCLUDE_DIR})
target_link_libraries(stickslip_gmp INTERFACE ${GMP_LIBRARY})

stickslip_require_header(MPFR_INCLUDE_DIR mpfr.h libmpfr-dev)
stickslip_require_library(MPFR_LIBRARY mpfr libmpfr-dev)
add_library(stickslip_mpfr INTERFACE)
target_include_directories(stickslip_mpfr SYSTEM INTERFACE ${MPFR_INCLUDE_DIR})
target_link_libraries(stickslip_mpfr INTERFACE ${MPFR_LIBRARY} stickslip_gmp)

stickslip_require_package(Boost libboost-dev 1.74)
stickslip_require_package(Eigen3 libeigen3-dev 3.4)
stickslip_require_package(nlohmann_json nlohmann-json3-dev 3.10)
stickslip_require_package(CLI11 libcli11-dev)
stickslip_require_package(TBB libtbb-dev)
stickslip_require_package(Threads libc6-dev)
# Debian builds it with all of its options, and these are a part of its interface.
stickslip_require_header(HTTPLIB_INCLUDE_DIR httplib.h libcpp-httplib-dev)
stickslip_require_library(HTTPLIB_LIBRARY cpp-httplib libcpp-httplib-dev)
add_library(stickslip_httplib INTERFACE)
target_include_directories(stickslip_httplib SYSTEM INTERFACE ${HTTPLIB_INCLUDE_DIR})
target_compile_definitions(stickslip_httplib INTERFACE CPPHTTPLIB_OPENSSL_SUPPORT
  CPPHTTPLIB_ZLIB_SUPPORT CPPHTTPLIB_BROTLI_SUPPORT)
target_link_libraries(stickslip_httplib INTERFACE ${HTTPLIB_LIBRARY} Threads::Threads)

# CGAL's own configuration is verbose and adds flags; only arrangement/ and the
# test oracles use it, header-only.
stickslip_require_header(CGAL_INCLUDE_DIR CGAL/version.h libcgal-dev)
stickslip_require_header(BOOST_GRAPH_INCLUDE_DIR boost/graph/adjacency_list.hpp libboost-graph-dev)
add_library(stickslip_cgal INTERFACE)
target_include_directories(stickslip_cgal SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
target_compile_definitions(stickslip_cgal INTERFACE CGAL_USE_GMP CGAL_USE_MPFR)
# Interval arithmetic in CGAL changes the rounding mode; -frounding-math keeps
# the compiler from folding across it (CGAL manual, "Compiler flags").
target_compile_options(stickslip_cgal INTERFACE -frounding-math)
target_link_libraries(stickslip_cgal INTERFACE stickslip_mpfr stickslip_gmp Boost::headers)

if(STICKSLIP_BUILD_TESTS)
  stickslip_require_package(GTest libgtest-dev)
endif()
