// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The parts of the module stickslip._core. Its functions take plain values and return dicts;
/// the package around it (python/stickslip/) gives them their types and documentation.
///
/// Long work is pure C++ and runs without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/certificate/proved_files.hpp"
#include "stickslip/core/cancellation.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/engine/question.hpp"
#include "stickslip/interfaces/verdict_answer.hpp"
#include "stickslip/measures/model_warnings.hpp"

namespace stickslip::python {

/// A grasp in space, which has a class of its own in Python.
struct SpatialGraspFile : GraspFile {};
/// A grasp of several bodies, in the plane or in space, which is a box as one in space is.
struct BodiesFile : SpatialGraspFile {};

void bind_grasp(pybind11::module_& module);       ///< grasp.cpp
void bind_questions(pybind11::module_& module);   ///< questions.cpp
void bind_check(pybind11::module_& module);       ///< check.cpp
void bind_crosscheck(pybind11::module_& module);  ///< crosscheck.cpp
void bind_many(pybind11::module_& module);        ///< many.cpp
void bind_batch(pybind11::module_& module);       ///< batch.cpp
void bind_compare(pybind11::module_& module);     ///< compare.cpp
void bind_pictures(pybind11::module_& module);    ///< pictures.cpp
void bind_space(pybind11::module_& module);       ///< space.cpp
void bind_boxes(pybind11::module_& module);       ///< boxes.cpp
void bind_preload(pybind11::module_& module);     ///< preload.cpp

/// Returns the options of a question about a grasp. None leaves the grasp's own value, or asks
/// for no direction. A preload direction is a list, or any other object to scale. `which` of
/// several follows the names in errors. `max_motion` is as on the command line; empty: the
/// grasp's own.
QuestionOptions question_options(const pybind11::object& wrench,
                                 const pybind11::object& preload, bool bilateral,
                                 const pybind11::object& direction = pybind11::none(),
                                 const pybind11::object& preload_direction = pybind11::none(),
                                 const std::string& which = "",
                                 const std::string& max_motion = "");

/// Returns the same options without directions, with a bound on motions.
inline QuestionOptions bounded_options(const pybind11::object& wrench,
                                       const pybind11::object& preload, bool bilateral,
                                       const std::string& max_motion) {
  return question_options(wrench, preload, bilateral, pybind11::none(), pybind11::none(), "",
                          max_motion);
}

/// Returns the engine named "states", "branch-and-bound" or "auto".
Engine engine_named(const std::string& name);

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

/// Adds the fields limit, reason, remedy and near of an answer.
void add_undecided(pybind11::dict& result, const Undecided& undecided);
/// Returns the arguments of results.ModelWarning.
pybind11::tuple warning_fields(const std::vector<ModelWarning>& warnings);

/// Returns a grasp in its class.
pybind11::object in_its_class(GraspFile grasp);

/// Returns the same grasp with the friction of each contact replaced.
GraspFile with_friction(const GraspFile& file, const std::vector<Rational>& friction);

/// Returns a preload direction as an answer repeats it.
pybind11::object preload_direction_of(const PreloadDirection& direction);

/// Returns the question about one grasp in the plane by ask(); the remedy for a preloaded
/// normal of irrational length is in Python's words.
Question question_of(const GraspFile& grasp, const QuestionOptions& options);

/// Returns the question about a grasp with the tolerances `uncertain`, spelled as in
/// --uncertain; empty: none. Throws InputError if the grasp has cases and none is chosen.
Question question_in_box(const GraspFile& grasp, QuestionOptions options,
                         const std::string& uncertain = "");

/// Returns the question about one grasp of any kind: by question_of() in the plane; in space
/// and of several bodies lengths may be irrational.
Question question_about(const GraspFile& grasp, const QuestionOptions& options);

/// Returns the fields of results.Margin, for a question whose margin is a list of claims.
pybind11::dict margin_by_claims(const Question& question, std::size_t node_limit, bool warnings,
                                const pybind11::object& accuracy);

/// Returns the fields of results.Decision but the warnings; with the certificate unless it is
/// empty.
pybind11::dict decision_fields(const Answer& answer, const std::string& certificate);

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

/// Returns the force vectors in the frame of the body.
pybind11::tuple force_vectors(const Grasp& grasp, const std::vector<ContactForce>& forces);

/// Returns convert(value) of each value.
template <class Values, class Convert>
pybind11::tuple tuple_of(const Values& values, Convert convert) {
  pybind11::tuple result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = convert(values[i]);
  return result;
}

/// Returns (contact, normal, moved at most) of each normal that moved.
template <class Snapped, class Convert>
pybind11::tuple moved_normals(const Snapped& snapped, Convert convert) {
  return tuple_of(snapped, [&convert](const auto& normal) {
    return pybind11::make_tuple(normal.contact.index(), convert(normal.after), normal.moved);
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

/// Returns a grasp file (of a box one with intervals), its certificate, and the options that a
/// checker needs beside.
inline pybind11::tuple files(const ProvedFiles& proved) {
  const auto& direction = proved.preload_direction;
  return pybind11::make_tuple(
      proved.grasp, proved.certificate, proved.uncertain,
      direction ? preload_direction_of(*direction) : pybind11::object(pybind11::none()));
}

/// Adds the files of a verdict about a box: the proof, or two examples, or neither.
inline void add_files(pybind11::dict& result, const std::vector<ProvedFiles>& found) {
  if (found.size() == 1) result["proof"] = files(found[0]);
  if (found.size() == 2) {
    result["examples"] = pybind11::make_tuple(files(found[0]), files(found[1]));
  }
}

/// Returns the work of an engine by name.
template <class Work>
pybind11::dict stats(const Work& work) {
  pybind11::dict result;
  for (const auto& [name, value] : counters(work)) result[name.c_str()] = value;
  return result;
}

}  // namespace stickslip::python
