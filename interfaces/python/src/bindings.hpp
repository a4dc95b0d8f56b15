// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The parts of the module stickslip._core. Questions go through one function, ask(), which
/// answers in what JSON has, and with Fractions; the package around it (python/stickslip/)
/// gives them their types and documentation.
///
/// Long work is pure C++ and runs without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact.hpp"
#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/core/snap.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/states_answer.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/model_warnings.hpp"

namespace stickslip::python {

/// A grasp in space, which has a class of its own in Python.
struct SpatialGraspFile : GraspFile {};
/// A grasp of several bodies, in the plane or in space, which is a box as one in space is.
struct BodiesFile : SpatialGraspFile {};

void bind_grasp(pybind11::module_& module);   ///< grasp.cpp
void bind_ask(pybind11::module_& module);     ///< ask.cpp
void bind_check(pybind11::module_& module);   ///< check.cpp
void bind_many(pybind11::module_& module);    ///< many.cpp
void bind_batch(pybind11::module_& module);   ///< batch.cpp
void bind_space(pybind11::module_& module);   ///< space.cpp
void bind_states(pybind11::module_& module);  ///< states.cpp

/// The error that an answer is not known within a limit.
struct LimitError : std::runtime_error {
  explicit LimitError(const Undecided& undecided) : std::runtime_error(undecided.limit) {}
};

/// Returns the options of a question about a grasp. None leaves the grasp's own value. `which`
/// of several follows the names in errors.
QuestionOptions question_options(const pybind11::object& wrench,
                                 const pybind11::object& preload, bool bilateral,
                                 const std::string& which = "");

/// Returns the options of these names that are given. A preload direction is a list, or any
/// other object to scale. Bounds on motions and tolerances are spelled as on the command line;
/// empty ones are the grasp's own.
QuestionOptions question_options(const pybind11::dict& given);

/// Returns the engine named "states", "branch-and-bound" or "auto".
Engine engine_named(const std::string& name);
/// Returns the same engine. Throws InputError for another than "auto" if the grasp has but one.
Engine engine_for(const GraspFile& grasp, const std::string& name);

/// Returns a number for each contact, from a list, or one for all of them.
std::vector<Rational> numbers(const pybind11::object& values, std::size_t contacts,
                              const std::string& name);

/// \{ Read units from a list of a length and a force, or an empty one; return units as a dict.
std::optional<Units> units_from(const pybind11::list& units);
pybind11::dict units_of(const std::optional<Units>& units);
/// \}

/// Throws InputError: the grasp has cases, of which this is the first, and none is chosen.
[[noreturn]] void refuse_without_case(const std::string& first);
/// Throws InputError: a box was asked about, and no number is uncertain.
[[noreturn]] void refuse_certain();

/// Returns a grasp in its class.
pybind11::object in_its_class(GraspFile grasp);

/// Returns the same grasp with the friction of each contact replaced.
GraspFile with_friction(const GraspFile& file, const std::vector<Rational>& friction);

/// Returns the question about one grasp in the plane by ask(); the remedy for a preloaded
/// normal of irrational length is in Python's words.
Question question_of(const GraspFile& grasp, const QuestionOptions& options);

/// Returns the question about a grasp. Throws InputError if the grasp has cases and none is
/// chosen.
Question question_about(const GraspFile& grasp, const QuestionOptions& options);

/// Returns the question about states in space that these options give.
StatesQuestion states_question_of(const GraspFile& file, const pybind11::dict& options);

/// Returns the texts of a proof, and what a checker needs beside them.
Json files_json(const ProvedFiles& files);

/// Returns the answer as the command prints it, with what Python has besides: the certificate,
/// what proves the second answer, and forces by normals and tangents as they are given, in
/// place of those of unit length.
Json decision_json(const Answer& answer, const Warnings& warnings = {});

/// One of many answers, whose whole becomes a Python value only when it is looked at.
struct ManyAnswer {
  std::string verdict;
  std::string engine;
  std::string limit;           ///< why there is no answer; empty if there is one
  std::vector<double> wrench;  ///< the wrench that was asked about
  std::vector<double> twist;   ///< the motion of an equilibrium; empty if there is none
  std::vector<double> forces;  ///< the forces of that equilibrium, contact by contact
  /// Returns the grasp that was asked about, with the friction of the question, and the fields
  /// of results.Decision.
  std::function<pybind11::tuple()> whole;
};

/// One of many questions; None, or no friction, leaves the grasp's own.
struct OneOfMany {
  pybind11::object wrench;
  pybind11::object preload;
  const std::vector<Rational>* friction;  ///< by contact
  std::string which;                      ///< follows the names in errors
};

/// Returns a function that decides one question of many, without Python.
std::function<ManyAnswer()> one_question(const pybind11::handle& grasp, const OneOfMany& asked,
                                         bool bilateral, const std::string& engine,
                                         std::size_t node_limit);

/// Returns convert(value) of each value.
template <class Values, class Convert>
pybind11::tuple tuple_of(const Values& values, Convert convert) {
  pybind11::tuple result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = convert(values[i]);
  return result;
}

/// Returns (contact, normal, moved at most) of each normal that moved.
inline pybind11::tuple moved_normals(const std::vector<SnappedNormal>& snapped) {
  return tuple_of(snapped, [](const SnappedNormal& normal) {
    return pybind11::make_tuple(normal.contact.index(), tuple_of(normal.after, &fraction),
                                normal.moved);
  });
}

/// Runs `work`, which must not touch Python, while other Python threads run. On the main thread
/// a signal whose handler raises, as that of Ctrl-C does, breaks it off.
template <class Work>
auto without_gil(Work work) {
  try {
    const pybind11::gil_scoped_release released;
    const Cancellation cancellation([] {
      const pybind11::gil_scoped_acquire acquired;
      return PyErr_CheckSignals() != 0;
    });
    return work();
  } catch (const Cancelled&) {
    throw pybind11::error_already_set();
  }
}

}  // namespace stickslip::python
