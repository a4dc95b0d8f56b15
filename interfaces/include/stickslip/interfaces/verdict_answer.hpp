// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Questions of any kind with their verdicts, as `decide --json` prints them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "stickslip/core/number_text.hpp"
#include "stickslip/engine/box_verdict.hpp"
#include "stickslip/engine/contact_mode.hpp"
#include "stickslip/engine/decide.hpp"
#include "stickslip/interfaces/uncertain_numbers.hpp"
#include "stickslip/measures/model_warnings.hpp"
#include "stickslip/measures/spatial_warnings.hpp"

namespace stickslip {

/// The warnings; nothing if they were not asked for.
using Warnings = std::optional<std::vector<ModelWarning>>;

/// \{ The names of the engine for numbers that may be intervals: in the plane, in space, and of
/// several bodies.
inline constexpr const char* kIntervalsEngine = "intervals";
inline constexpr const char* kSpaceEngine = "space";
inline constexpr const char* kBodiesEngine = "bodies";
inline const char* box_engine(const Question& question) {
  return question.mechanism() != nullptr ? kBodiesEngine
         : question.in_space()           ? kSpaceEngine
                                         : kIntervalsEngine;
}
/// \}

/// The answer to one question. A question about one grasp in the plane becomes one about a box
/// of one point in two cases: some lengths are irrational and known as intervals, or it is
/// stable and an exact equilibrium would be too long (has_long_equilibria).
struct Answer {
  Question question;   ///< the question as asked, or about a box of one point, see above
  Verdict verdict;     ///< with its evidence
  std::string engine;  ///< "states", "branch-and-bound", "intervals", "space" or "bodies"
  Json stats;          ///< the work that it took, by name
  unsigned bits = kDefaultBits;      ///< the precision, as of BoxDecision
  std::optional<Problem> problem{};  ///< the problem, unless the question is about a box
  Warnings warnings{};               ///< the warnings about one grasp
  /// The answer to a second question, if rounding of the data alone may decide the first. If
  /// the grasp is undecided, or holds only by motions beyond natural_bound(), the second
  /// question bounds motions by that. If the grasp does not hold because of a part of the load
  /// that is smaller than 1e-12 of it, the second question leaves that part out.
  std::shared_ptr<const Answer> within{};
};

/// The warnings to look for: known ways in which the model can mislead.
enum class WarningsAsked {
  kNone,
  kOfMotion,  ///< only those that the answer's motion shows: quick
  kAll        ///< all, which take as long as the verdict
};

/// The options of an answer.
struct AnswerOptions {
  Engine engine = Engine::kAuto;  ///< the engine for one grasp in the plane
  std::size_t node_limit = 0;     ///< the most nodes of a search; 0: the engine's own limit
  WarningsAsked warnings = WarningsAsked::kAll;  ///< the warnings about one grasp
  bool within = true;                            ///< whether to look for Answer::within
};

/// Returns the verdict of the engine about one grasp. With kAuto, if an exact equilibrium would
/// be too long (has_long_equilibria), the answer may instead be a proof by degree that it is
/// stable.
std::variant<Decision, BoxDecision> judge(const Problem& problem, Engine engine,
                                          std::size_t node_limit);

/// Decides the question, looks for warnings, and for a second answer, as the options say.
Answer answer_to(Question question, const AnswerOptions& options);

/// Adds the reason, as "limit" in words and as "reason" in one; "remedy" and "near" if there
/// are any.
void add_undecided(Json& json, const Undecided& undecided);

/// Adds the contacts as "enclosed", and "bits"; adds nothing if there are none.
void add_enclosed(Json& json, const std::vector<std::size_t>& contacts, unsigned bits);

/// Returns by how much the loads of two questions differ: the square of the length of the
/// difference of forces, and of torques over a typical length of the grasp.
Rational squared_distance(const Question& a, const Question& b);

/// Returns the second answer in short: the verdict, with the bound on motions or the load.
Json within_json(const Answer& within);

/// Returns the output of `decide --json`, before finished() writes its numbers as fractions or
/// doubles.
Json to_json(const Answer& answer);

/// Returns the certificate; nothing if the verdict has none: undecided or fragile.
std::optional<std::string> certificate_of(const Answer& answer);

/// Returns the producer of a certificate: "stickslip 0.1.0, engine space".
std::string producer_of(const std::string& engine);

/// Returns a list of the warnings, "trap" and "text" each.
Json warnings_json(const std::vector<ModelWarning>& warnings);

/// Returns the work of an engine by name.
template <class Work>
Json work_json(const Work& work) {
  Json json = Json::object();
  for (const auto& [name, value] : counters(work)) json[name] = value;
  return json;
}

/// One contact of a stable verdict.
struct ContactReport {
  Rational length_squared;  ///< the square of the length of the contact's normal
  ContactForce force;       ///< the force along the contact's own normal and tangent
  Vector2 vector;           ///< the force in the object frame
  ContactMode mode;         ///< its mode in the motion of the witness
};

/// Returns the contacts of an exact equilibrium in the plane, by ContactId.
std::vector<ContactReport> report_contacts(const Answer& answer, const Witness& witness);

/// Returns a motion near that of an equilibrium, for one grasp that is stable by a proof that
/// states none; else nothing.
std::optional<RationalRow> motion_near(const Answer& answer);

/// Returns the contacts whose P / |n| is irrational, and so known as an interval.
std::vector<std::size_t> enclosed_contacts(const GraspBox& box);

}  // namespace stickslip
