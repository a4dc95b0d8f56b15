# SPDX-License-Identifier: GPL-3.0-or-later
# The target `doc`: the reference of the library, in build/doc/html.

find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  file(WRITE ${PROJECT_BINARY_DIR}/Doxyfile
    "@INCLUDE = docs/doxygen/Doxyfile\nOUTPUT_DIRECTORY = \"${PROJECT_BINARY_DIR}/doc\"\n"
    "PROJECT_NUMBER = ${PROJECT_VERSION}\n")
  add_custom_target(doc
    COMMAND Doxygen::doxygen ${PROJECT_BINARY_DIR}/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()
