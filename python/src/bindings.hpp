// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The parts of the module stickslip._core. Its functions take plain values and return dicts;
/// the package around it (python/stickslip/) gives them their types and documentation.
///
/// Long work is pure C++ and runs without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

#include "stickslip/equilibrium/question.hpp"

namespace stickslip::python {

void bind_grasp(pybind11::module_& module);      ///< grasp.cpp
void bind_questions(pybind11::module_& module);  ///< questions.cpp
void bind_check(pybind11::module_& module);      ///< check.cpp
// The place of crosscheck: bind_crosscheck, in a file of its own beside these, over the
// library's judge_claim; then python/stickslip/crosscheck.py, _core.pyi and docs/python.md.

/// What is asked about a grasp; None leaves the grasp's own value.
QuestionOptions question_options(const pybind11::object& wrench,
                                 const pybind11::object& preload, bool bilateral);

/// Runs `work`, which must not touch Python, while other Python threads run.
template <class Work>
auto without_gil(Work work) {
  const pybind11::gil_scoped_release released;
  return work();
}

}  // namespace stickslip::python
