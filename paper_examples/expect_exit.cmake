# SPDX-License-Identifier: GPL-3.0-or-later
# Runs PROGRAM with ARGUMENTS; it must exit with CODE and write OUTPUT somewhere. WILL_FAIL of
# ctest would take a crash for a disagreement.
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS}
  RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT result STREQUAL CODE)
  message(FATAL_ERROR "exit code ${result}, expected ${CODE}\n${text}")
endif()
string(FIND "${text}" "${OUTPUT}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the output does not contain \"${OUTPUT}\"\n${text}")
endif()
