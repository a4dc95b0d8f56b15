# SPDX-License-Identifier: GPL-3.0-or-later
# The Python module (interfaces/python/) and its option. ON by default when all that it and its tests need
# is there: pybind11, Python's headers, NumPy and pytest.

find_package(Python3 COMPONENTS Interpreter Development.Module QUIET)
find_package(pybind11 2.10 CONFIG QUIET)

set(default OFF)
if(pybind11_FOUND AND Python3_Development.Module_FOUND AND STICKSLIP_BUILD_TESTS)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c "import numpy, pytest"
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(result EQUAL 0)
    set(default ON)
  endif()
endif()
option(STICKSLIP_BUILD_PYTHON "Build the Python module" ${default})

if(STICKSLIP_BUILD_PYTHON AND NOT (pybind11_FOUND AND Python3_Development.Module_FOUND))
  message(FATAL_ERROR "The Python module needs pybind11 and the headers of ${Python3_EXECUTABLE}. "
    "On Debian: apt-get install pybind11-dev python3-dev")
endif()
