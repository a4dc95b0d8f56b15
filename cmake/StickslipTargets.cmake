# SPDX-License-Identifier: GPL-3.0-or-later
# One function per kind of target, so that every module is declared the same way.

function(stickslip_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
  if(STICKSLIP_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# stickslip_library(core SOURCES a.cpp ... PUBLIC_LIBS lib ... PRIVATE_LIBS lib ... [COLD])
# makes stickslip_core (alias stickslip::core) with public headers in <module>/include. Sources may
# be those of its parts instead: see stickslip_part().
# COLD: no command spends its time there, as it writes text, or asks other modules: a release
# optimises it little, and takes a third less time to compile it.
function(stickslip_library module)
  cmake_parse_arguments(ARG "COLD" "" "SOURCES;PUBLIC_LIBS;PRIVATE_LIBS" ${ARGN})
  add_library(stickslip_${module} STATIC ${ARG_SOURCES})
  add_library(stickslip::${module} ALIAS stickslip_${module})
  set_target_properties(stickslip_${module} PROPERTIES EXPORT_NAME ${module} LINKER_LANGUAGE CXX)
  target_include_directories(stickslip_${module}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
           $<INSTALL_INTERFACE:include>)
  target_link_libraries(stickslip_${module}
    PUBLIC ${ARG_PUBLIC_LIBS} PRIVATE ${ARG_PRIVATE_LIBS})
  target_compile_features(stickslip_${module} PUBLIC cxx_std_17)
  if(STICKSLIP_VALIDATE)
    target_compile_definitions(stickslip_${module} PUBLIC STICKSLIP_VALIDATE)
  endif()
  set_target_properties(stickslip_${module} PROPERTIES
    STICKSLIP_PART_LIBS "${ARG_PUBLIC_LIBS};${ARG_PRIVATE_LIBS}")
  if(ARG_SOURCES)
    stickslip_compile(stickslip_${module} ${ARG_COLD})
  endif()
endfunction()

# stickslip_part(engine search SOURCES a.cpp ... [COLD]): sources of stickslip_engine in a folder of
# their own, compiled together. A part may use what its module may, and headers of parts by their
# path from the root, such as "engine/search/law_forces.hpp"; tests/layout says which.
function(stickslip_part module part)
  cmake_parse_arguments(ARG "COLD" "" "SOURCES" ${ARGN})
  set(target stickslip_${module}_${part})
  add_library(${target} OBJECT ${ARG_SOURCES})
  get_target_property(libs stickslip_${module} STICKSLIP_PART_LIBS)
  target_link_libraries(${target} PRIVATE ${libs})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/${module}/include)
  if(STICKSLIP_VALIDATE)
    target_compile_definitions(${target} PRIVATE STICKSLIP_VALIDATE)
  endif()
  stickslip_compile(${target} ${ARG_COLD})
  target_sources(stickslip_${module} PRIVATE $<TARGET_OBJECTS:${target}>)
endfunction()

# How sources of the library are compiled.
function(stickslip_compile target is_cold)
  # The Python module is a shared library that takes it in; always, so that all builds are alike.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  if(is_cold)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  stickslip_set_warnings(${target})
  stickslip_reuse_headers(${target} ${is_cold})
endfunction()

# What nearly all of the library includes takes three quarters of the time that a file takes to
# compile: it is compiled once. What a release optimises little has its own: headers of intrinsics,
# which Eigen includes, restore the flags with which the precompiled header was made.
function(stickslip_reuse_headers name is_cold)
  if(STICKSLIP_COVERAGE)  # its flags differ from module to module
    return()
  endif()
  set(headers stickslip_headers)
  if(is_cold AND CMAKE_BUILD_TYPE STREQUAL Release)
    set(headers stickslip_cold_headers)
  endif()
  if(NOT TARGET ${headers})
    file(WRITE ${PROJECT_BINARY_DIR}/headers/${headers}.cpp "")
    add_library(${headers} OBJECT ${PROJECT_BINARY_DIR}/headers/${headers}.cpp)
    target_link_libraries(${headers} PRIVATE stickslip_gmp)
    set_target_properties(${headers} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    stickslip_set_warnings(${headers})
    if(headers STREQUAL stickslip_cold_headers)
      target_compile_options(${headers} PRIVATE -O1)
    endif()
    target_precompile_headers(${headers} PRIVATE
      <gmp.h> <algorithm> <array> <cmath> <functional> <memory> <map> <optional> <set> <string>
      <variant> <vector>)
  endif()
  target_precompile_headers(${name} REUSE_FROM ${headers})
endfunction()

# stickslip_program(name SOURCES ... LIBS ...): an executable in build/bin.
function(stickslip_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBS})
  stickslip_set_warnings(${name})
endfunction()

# stickslip_test(name SOURCES ... LIBS ... [TIMEOUT s] [ARGS ...] [OWN_FLAGS] [LONG]): a GoogleTest
# executable, registered with ctest as one test of that name. OWN_FLAGS: its sources are compiled
# with other flags than those of stickslip::core. LONG: labelled so, and not there at all without
# STICKSLIP_LONG_TESTS.
function(stickslip_test name)
  cmake_parse_arguments(ARG "OWN_FLAGS;LONG" "TIMEOUT" "SOURCES;LIBS;ARGS" ${ARGN})
  if(ARG_LONG AND NOT STICKSLIP_LONG_TESTS)
    return()
  endif()
  stickslip_program(${name} SOURCES ${ARG_SOURCES} LIBS ${ARG_LIBS} GTest::gtest_main GTest::gmock)
  set_target_properties(${name} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/bin)
  if(NOT ARG_OWN_FLAGS)
    stickslip_reuse_test_headers(${name})
  endif()
  add_test(NAME ${name} COMMAND ${name} ${ARG_ARGS})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 1200)
  endif()
  set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  if(ARG_LONG)
    set_tests_properties(${name} PROPERTIES LABELS long)
  endif()
endfunction()

# What nearly all tests include takes most of the time that they take to compile: it is
# compiled once.
function(stickslip_reuse_test_headers name)
  if(NOT TARGET stickslip_test_headers)
    file(WRITE ${PROJECT_BINARY_DIR}/tests/headers.cpp "")
    add_library(stickslip_test_headers OBJECT ${PROJECT_BINARY_DIR}/tests/headers.cpp)
    target_link_libraries(stickslip_test_headers PRIVATE stickslip::core GTest::gtest GTest::gmock)
    stickslip_set_warnings(stickslip_test_headers)
    target_precompile_headers(stickslip_test_headers PRIVATE <gtest/gtest.h> <gmock/gmock.h>
      <gmp.h> <map> <set> <functional> <variant>)
  endif()
  target_precompile_headers(${name} REUSE_FROM stickslip_test_headers)
endfunction()

# stickslip_uses_cgal(module file ...): these files of this folder, which is that of the module or of
# a part of it, include CGAL, and no others do.
# Interval arithmetic in CGAL changes the rounding mode; -frounding-math keeps the compiler from
# folding across it (CGAL manual, "Compiler flags"). GCC 12 sees uninitialised and freed values in CGAL's
# and Boost's headers when it optimises little. The tests have a twin of each file, the object
# library stickslip_cgal_checked, with all of CGAL's assertions: linked into a program, it stands
# in for the file of the library.
function(stickslip_uses_cgal module)
  set(options -frounding-math -Wno-maybe-uninitialized -Wno-free-nonheap-object)
  set_source_files_properties(${ARGN} PROPERTIES
    COMPILE_DEFINITIONS "CGAL_USE_GMP;CGAL_USE_MPFR" COMPILE_OPTIONS "${options}"
    SKIP_PRECOMPILE_HEADERS ON)
  if(STICKSLIP_BUILD_TESTS)
    if(NOT TARGET stickslip_cgal_checked)
      add_library(stickslip_cgal_checked OBJECT EXCLUDE_FROM_ALL)
      target_include_directories(stickslip_cgal_checked PRIVATE ${PROJECT_SOURCE_DIR})
      target_compile_options(stickslip_cgal_checked PRIVATE ${options} -UNDEBUG -UCGAL_NDEBUG
        $<$<CONFIG:Release>:-O1>)  # as the tests
      target_compile_definitions(stickslip_cgal_checked PRIVATE CGAL_USE_GMP CGAL_USE_MPFR
        STICKSLIP_CHECKED CGAL_CHECK_EXPENSIVE CGAL_CHECK_EXACTNESS)
      stickslip_set_warnings(stickslip_cgal_checked)
    endif()
    list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    target_sources(stickslip_cgal_checked PRIVATE ${ARGN})
    target_link_libraries(stickslip_cgal_checked PUBLIC stickslip::${module})
  endif()
endfunction()
